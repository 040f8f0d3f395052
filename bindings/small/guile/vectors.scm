;; SPDX-License-Identifier: Apache-2.0
;; vectors.scm FILE: the shared vectors (bindings/vectors) by vesica.scm. Exit status 0 when all answers are right.
(use-modules (ice-9 match) (ice-9 rdelim) (rnrs bytevectors) (srfi srfi-1) (srfi srfi-4) (srfi srfi-11) (vesica))

(define all-right #t)

(define (check line answer expected)
  (unless (= answer expected)
    (format #t "line ~a: ~a, not ~a\n" line answer expected)
    (set! all-right #f)))

;; What the call returns, or the code of its error.
(define (answer call . arguments)
  (catch 'vesica-error
    (lambda ()
      (match (apply call arguments) (#t 1) (#f 0) (count count)))
    (lambda (key who message arguments code) (car code))))

(define (number word)
  (let ((bits (make-bytevector 8)))
    (bytevector-u64-set! bits 0 (string->number word 16) (endianness big))
    (bytevector-ieee-double-ref bits 0 (endianness big))))

;; line, what, expected, first kind and its numbers, second kind and its numbers
(define (vectors-of path)
  (call-with-input-file path
    (lambda (port)
      (let next ((line 1) (vectors '()))
        (match (read-line port)
          ((? eof-object?) (reverse vectors))
          ((? (lambda (text) (string-prefix? "#" text))) (next (+ line 1) vectors))
          (text
           (match (string-split text #\space)
             ((what expected kind-a . words)
              (let-values (((a rest) (split-at words 6)))
                (next (+ line 1)
                      (cons (list line what (string->number expected)
                                  (string->number kind-a) (map number a)
                                  (string->number (car rest)) (map number (cdr rest)))
                            vectors)))))))))))

(define-values (batch calls)
  (partition (lambda (v) (string=? (second v) "many")) (vectors-of (second (command-line)))))

(for-each
 (match-lambda
   ((line "f64" expected kind-a a kind-b b)
    (check line (answer overlap kind-a (list->f64vector a) kind-b (list->f64vector b)) expected))
   ((line "f32" expected kind-a a kind-b b)
    (check line (answer overlap-float kind-a (list->f32vector a) kind-b (list->f32vector b)) expected)))
 calls)

(define out (make-u8vector (length batch) 0))
(define (many rows)
  (overlap-many rect (list->f64vector (append-map fifth rows))
                ellipse (list->f64vector (append-map seventh rows)) out))
(define valid (take-while (lambda (v) (>= (third v) 0)) batch))
(check "count" (many valid) (apply + (map third valid)))
;; With an invalid element, an error: and yet every valid one has its answer.
(check "error" (answer many batch) -2)
(for-each (lambda (v hit) (check (first v) hit (max (third v) 0))) batch (u8vector->list out))

(catch 'vesica-error
  (lambda () (overlap point (f64vector +nan.0 0) circle (f64vector 0 0 1)))
  (lambda (key who message . rest) (format #t "NaN: ~a\n" message)))
(call-with-values
  (lambda () (nearest aabb (f64vector 0 0 2 2) circle (f64vector 6 1 1)))
  (lambda found (when (equal? found '(3.0 2.0 1.0 5.0 1.0)) (format #t "nearest: as in C\n"))))
(format #t "~a calls, ~a in a batch\n" (length calls) (length batch))
(exit all-right)
