;; SPDX-License-Identifier: Apache-2.0
;; Exact overlap queries between plain 2D shapes. Touching counts. An error of the library is thrown as
;; ('vesica-error FUNCTION MESSAGE () (CODE)), the form that Guile itself reports errors in.
(define-module (vesica)
  #:use-module (rnrs bytevectors)
  #:use-module (srfi srfi-4)
  #:use-module (srfi srfi-11)
  #:use-module (system foreign)
  #:use-module (vesica-c)
  #:export (point segment circle aabb rect ellipse overlap overlap-float nearest overlap-many))

(define-values (point segment circle aabb rect ellipse)
  (values VESICA_POINT VESICA_SEGMENT VESICA_CIRCLE VESICA_AABB VESICA_RECT VESICA_ELLIPSE))

(define (checked who answer)
  (when (negative? answer)
    (throw 'vesica-error who (pointer->string (vesica_strerror answer)) '() (list answer)))
  answer)

(define (need who kind numbers size)
  (when (< (quotient (bytevector-length numbers) size) (checked who (vesica_field_count kind)))
    (scm-error 'wrong-type-arg who "too few numbers for a shape: ~s" (list numbers) #f)))

;; Do two shapes, f64vectors of their numbers, share a point?
(define (overlap kind-a a kind-b b)
  (need 'overlap kind-a a 8)
  (need 'overlap kind-b b 8)
  (= 1 (checked 'overlap (vesica_overlap_f64 kind-a (bytevector->pointer a) kind-b (bytevector->pointer b)))))

;; The same of f32vectors.
(define (overlap-float kind-a a kind-b b)
  (need 'overlap-float kind-a a 4)
  (need 'overlap-float kind-b b 4)
  (= 1 (checked 'overlap-float (vesica_overlap_f32 kind-a (bytevector->pointer a) kind-b (bytevector->pointer b)))))

;; How far apart are two shapes, and which of their points are closest? Five values: the distance, x and y of a's point,
;; x and y of b's.
(define (nearest kind-a a kind-b b)
  (need 'nearest kind-a a 8)
  (need 'nearest kind-b b 8)
  (let ((out (make-f64vector 5)))
    (checked 'nearest
             (vesica_nearest_f64 kind-a (bytevector->pointer a) kind-b (bytevector->pointer b)
                                 (bytevector->pointer out)))
    (apply values (f64vector->list out))))

;; A view only points to its numbers: so they live as long.
(define numbers-of (make-weak-key-hash-table))

;; The count of shapes in an f64vector, and a vesica_shapes_f64 of them, which the library alone fills in and reads.
(define (view kind numbers)
  (let* ((size (* 8 (checked 'overlap-many (vesica_field_count kind))))
         (count (quotient (bytevector-length numbers) size))
         (bytes (make-bytevector 112)))
    (hashq-set! numbers-of bytes numbers)
    (checked 'overlap-many
             (vesica_shapes_from_records_f64 kind count (bytevector->pointer numbers) size
                                             (bytevector->pointer bytes)))
    (values count bytes)))

;; Two arrays of shapes in step, f64vectors of their numbers one after the other, which are not copied; an array of one
;; shape is repeated. out, a u8vector, gets 1 where they overlap, else 0; returns how many do. Where a shape is invalid,
;; out has 0 for it and every other answer, and the error is thrown.
(define (overlap-many kind-a a kind-b b out)
  (let-values (((count-a view-a) (view kind-a a))
               ((count-b view-b) (view kind-b b)))
    (when (< (u8vector-length out) (if (zero? (min count-a count-b)) 0 (max count-a count-b)))
      (scm-error 'wrong-type-arg 'overlap-many "out is too short" '() #f))
    (checked 'overlap-many
             (vesica_overlap_many_f64 (bytevector->pointer view-a) (bytevector->pointer view-b)
                                      (bytevector->pointer out)))))
