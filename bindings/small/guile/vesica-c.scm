;; SPDX-License-Identifier: Apache-2.0
;; Written by bindings/declare from capi/vesica.json: not to be edited.
;; The constants and functions of libvesica. A pointer is what bytevector->pointer makes.
(define-module (vesica-c)
  #:use-module (system foreign)
  #:use-module (system foreign-library))

(define-public VESICA_VERSION_MAJOR 0)
(define-public VESICA_VERSION_MINOR 1)
(define-public VESICA_VERSION_PATCH 0)
(define-public VESICA_VERSION 100)
(define-public VESICA_POINT 0)
(define-public VESICA_SEGMENT 1)
(define-public VESICA_CIRCLE 2)
(define-public VESICA_AABB 3)
(define-public VESICA_RECT 4)
(define-public VESICA_ELLIPSE 5)
(define-public VESICA_CAPSULE 6)
(define-public VESICA_ROUND_RECT 7)
(define-public VESICA_POLYGON 8)
(define-public VESICA_POLYLINE 9)
(define-public VESICA_DISJOINT 0)
(define-public VESICA_TOUCH 1)
(define-public VESICA_CROSS 2)
(define-public VESICA_INSIDE 3)
(define-public VESICA_INSIDE_TOUCH 4)
(define-public VESICA_CONTAINS 5)
(define-public VESICA_CONTAINS_TOUCH 6)
(define-public VESICA_EQUAL 7)
(define-public VESICA_E_NULL -1)
(define-public VESICA_E_SHAPE -2)
(define-public VESICA_E_KIND -3)
(define-public VESICA_E_ARGUMENT -4)
(define-public VESICA_E_NOT_FINITE -5)
(define-public VESICA_E_NEGATIVE_SIZE -6)
(define-public VESICA_E_ZERO_AXIS -7)
(define-public VESICA_E_INVERTED -8)
(define-public VESICA_E_RANGE -9)
(define-public VESICA_E_INDEX -10)
(define-public VESICA_E_RINGS -11)
(define-public VESICA_E_NOT_SIMPLE -12)
(define-public VESICA_E_NOT_CONVEX -13)
(define-public VESICA_ANGLE_RADIANS 0)
(define-public VESICA_ANGLE_DEGREES 1)
(define-public VESICA_ANGLE_QUARTERS 2)
(define-public VESICA_ANGLE_REVERSED 4)
(define-public VESICA_FUSED_MEAN 0)
(define-public VESICA_FUSED_MAX 1)
(define-public VESICA_MATCH_VOC 0)
(define-public VESICA_MATCH_COCO 1)
(define-public VESICA_TRUTH_COUNTS 0)
(define-public VESICA_TRUTH_CROWD 1)
(define-public VESICA_TRUTH_IGNORED 2)
(define-public VESICA_OUTCOME_MISS 0)
(define-public VESICA_OUTCOME_HIT 1)
(define-public VESICA_OUTCOME_IGNORED 2)
(define-public VESICA_PRECISION_VOC_2007 0)
(define-public VESICA_PRECISION_VOC_2010 1)
(define-public VESICA_PRECISION_COCO 2)
(define-public VESICA_GAUSSIAN_BHATTACHARYYA 0)
(define-public VESICA_GAUSSIAN_HELLINGER 1)
(define-public VESICA_GAUSSIAN_KULLBACK_LEIBLER 2)
(define-public VESICA_GAUSSIAN_WASSERSTEIN 3)
(define-public VESICA_JOIN_OVERLAP 0)
(define-public VESICA_JOIN_BOUNDS 1)
(define-public VESICA_JOIN_CONTAINS 2)
(define-public VESICA_JOIN_INSIDE 3)
(define-public VESICA_JOIN_INTERIORS 4)
(define-public VESICA_RATIO_OVER_UNION 0)
(define-public VESICA_RATIO_OVER_FIRST 1)
(define-public VESICA_RATIO_OVER_SECOND 2)
(define-public VESICA_RATIO_OVER_SMALLER 3)
(define-public VESICA_RATIO_GENERALIZED 4)
(define-public VESICA_RATIO_DISTANCE 5)
(define-public VESICA_RATIO_COMPLETE 6)
(define-public VESICA_WITHIN_NO 0)
(define-public VESICA_WITHIN_YES 1)
(define-public VESICA_WITHIN_NEARLY 2)
(define-public VESICA_DECAY_LINEAR 0)
(define-public VESICA_DECAY_GAUSSIAN 1)
(define-public VESICA_CAST_MISS 0)
(define-public VESICA_CAST_HIT 1)
(define-public VESICA_CAST_START 2)
(define-public VESICA_CAST_NEAR 3)
(define-public VESICA_DE9IM_SIZE 10)

(define library (load-foreign-library "libvesica.so.0"))

(define (function name result arguments)
  (foreign-library-function library name #:return-type result #:arg-types arguments))

(let ((found ((function "vesica_version" int32 '()))))
  (when (< found VESICA_VERSION)
    (error (format #f "vesica ~a is older than ~a" found VESICA_VERSION))))

(define-syntax-rule (c name result argument ...)
  (define-public name (function (symbol->string 'name) result (list argument ...))))

;; Do two shapes share a point?
(c vesica_overlap_f64 int32 int32 '* int32 '*)
;; Do the insides of two shapes share a point?
(c vesica_interiors_overlap_f64 int32 int32 '* int32 '*)
;; Does a contain all of b?
(c vesica_contains_f64 int32 int32 '* int32 '*)
;; How does a relate to b?
(c vesica_relation_f64 int32 int32 '* int32 '*)
;; How far apart are two solid shapes, and which of their points are closest?
(c vesica_nearest_f64 int32 int32 '* int32 '* '*)
;; Penetration depth: how far and which way must b be moved until the two shapes only touch?
(c vesica_depth_f64 int32 int32 '* int32 '* '*)
;; Area of the intersection of two shapes.
(c vesica_area_f64 int32 int32 '* int32 '* '*)
;; Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
(c vesica_iou_f64 int32 int32 '* int32 '* '*)
;; Smallest box of representable numbers that contains a shape.
(c vesica_bounds_f64 int32 int32 '* '*)
;; Is a shape valid, and if not, which rule does it break?
(c vesica_check_f64 int32 int32 '*)
;; The meaning of an error code, as one English phrase without a full stop.
(c vesica_strerror '* int32)
;; Where do the outlines of two shapes meet?
(c vesica_crossings_f64 int64 int32 '* int32 '* '* int64 '*)
;; How far apart are the outlines of two shapes, and where do they come closest?
(c vesica_boundary_distance_f64 int32 int32 '* int32 '* '*)
;; Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment.
(c vesica_shape_area_f64 int32 int32 '* '*)
;; States facts of a polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
(c vesica_polygon_facts_f64 int32 '* '*)
;; Are the two points the same?
(c vesica_overlap_point_point_f64 int32 '* '*)
;; Does the point lie on the segment?
(c vesica_overlap_point_segment_f64 int32 '* '*)
;; Does the point lie in the disc or on its rim?
(c vesica_overlap_point_circle_f64 int32 '* '*)
;; Does the point lie in the box or on its outline?
(c vesica_overlap_point_aabb_f64 int32 '* '*)
;; Does the point lie in the rectangle or on its outline?
(c vesica_overlap_point_rect_f64 int32 '* '*)
;; Does the point lie in the ellipse or on its outline?
(c vesica_overlap_point_ellipse_f64 int32 '* '*)
;; Do the segments share a point?
(c vesica_overlap_segment_segment_f64 int32 '* '*)
;; Does the segment meet the disc?
(c vesica_overlap_segment_circle_f64 int32 '* '*)
;; Does the segment meet the box?
(c vesica_overlap_segment_aabb_f64 int32 '* '*)
;; Does the segment meet the rectangle?
(c vesica_overlap_segment_rect_f64 int32 '* '*)
;; Does the segment meet the ellipse?
(c vesica_overlap_segment_ellipse_f64 int32 '* '*)
;; Do the discs share a point?
(c vesica_overlap_circle_circle_f64 int32 '* '*)
;; Do the disc and the box share a point?
(c vesica_overlap_circle_aabb_f64 int32 '* '*)
;; Do the disc and the rectangle share a point?
(c vesica_overlap_circle_rect_f64 int32 '* '*)
;; Do the disc and the ellipse share a point?
(c vesica_overlap_circle_ellipse_f64 int32 '* '*)
;; Do the boxes share a point?
(c vesica_overlap_aabb_aabb_f64 int32 '* '*)
;; Do the box and the rectangle share a point?
(c vesica_overlap_aabb_rect_f64 int32 '* '*)
;; Do the box and the ellipse share a point?
(c vesica_overlap_aabb_ellipse_f64 int32 '* '*)
;; Do the rectangles share a point?
(c vesica_overlap_rect_rect_f64 int32 '* '*)
;; Do the rectangle and the ellipse share a point?
(c vesica_overlap_rect_ellipse_f64 int32 '* '*)
;; Do the ellipses share a point?
(c vesica_overlap_ellipse_ellipse_f64 int32 '* '*)
;; Box with two opposite corners, in any order.
(c vesica_aabb_from_corners_f64 int32 double double double double '*)
;; Rectangle from centre, angle and full size: width along the angle, height across it.
(c vesica_rect_from_angle_f64 int32 double double double double double '*)
;; Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
(c vesica_rect_from_corners_f64 int32 '* '*)
;; The largest distance from a given corner to the rectangle's corner that corresponds to it.
(c vesica_rect_corners_misfit_f64 int32 '* '* '*)
;; Rounded rectangle from centre, angle and full size, its round corners included: width along the angle, height
;; across.
(c vesica_round_rect_from_angle_f64 int32 double double double double double double '*)
;; Capsule from centre, angle, the length between the ends of its segment, and radius.
(c vesica_capsule_from_angle_f64 int32 double double double double double '*)
;; Capsule from the ends of its segment and its full width, twice the radius: a line of that width with round ends.
(c vesica_capsule_from_width_f64 int32 double double double double double '*)
;; Ellipse from centre, angle and half lengths: a along the angle, b across it.
(c vesica_ellipse_from_angle_f64 int32 double double double double double '*)
;; Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx, wy).
(c vesica_ellipse_from_radius_vector_f64 int32 double double double double double '*)
;; Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
(c vesica_ellipse_from_covariance_f64 int32 double double double double double double '*)
;; Ellipse of the points X with (X - C) .
(c vesica_ellipse_from_matrix_f64 int32 double double double double double '*)
;; Describes an array of `count` records.
(c vesica_shapes_from_records_f64 int32 int32 int64 '* ptrdiff_t '*)
;; Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f64.
(c vesica_overlap_many_f64 int64 '* '* '*)
;; Do the insides of a[i] and b[i] share a point? out[i] is the answer of vesica_interiors_overlap_f64.
(c vesica_interiors_overlap_many_f64 int64 '* '* '*)
;; How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f64.
(c vesica_relation_many_f64 int64 '* '* '*)
;; Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f64.
(c vesica_contains_many_f64 int64 '* '* '*)
;; How far apart are a[i] and b[i], and where?
(c vesica_nearest_many_f64 int64 '* '* '* '* '* '* '*)
;; How far apart are the outlines of a[i] and b[i]?
(c vesica_boundary_distance_many_f64 int64 '* '* '* '* '* '* '*)
;; How deep do a[i] and b[i] overlap?
(c vesica_depth_many_f64 int64 '* '* '* '* '*)
;; The area that a[i] and b[i] share: out[i] is the result of vesica_area_f64.
(c vesica_area_many_f64 int64 '* '* '*)
;; Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f64.
(c vesica_iou_many_f64 int64 '* '* '*)
;; Do a[i] and b[j] share a point?
(c vesica_overlap_matrix_f64 int64 '* '* '* ptrdiff_t)
;; Do the insides of a[i] and b[j] share a point?
(c vesica_interiors_overlap_matrix_f64 int64 '* '* '* ptrdiff_t)
;; How does a[i] relate to b[j]?
(c vesica_relation_matrix_f64 int64 '* '* '* ptrdiff_t)
;; Does a[i] contain all of b[j]?
(c vesica_contains_matrix_f64 int64 '* '* '* ptrdiff_t)
;; The area that a[i] and b[j] share.
(c vesica_area_matrix_f64 int64 '* '* '* ptrdiff_t)
;; Intersection over union of a[i] and b[j].
(c vesica_iou_matrix_f64 int64 '* '* '* ptrdiff_t)
;; Which of many shapes overlap one?
(c vesica_overlap_select_f64 int64 '* '* '* int64)
;; Which of many shapes share a point of their insides with that of one?
(c vesica_interiors_overlap_select_f64 int64 '* '* '* int64)
;; How many bytes of scratch do vesica_nms_f64, vesica_suppress_f64 and their float forms need for `count` shapes?
(c vesica_nms_scratch int64 int64)
;; Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one whose
;; vesica_iou_f64 with every shape kept before is at most the threshold.
(c vesica_nms_f64 int32 '* '* double '* int64 '* '*)
;; Version of the loaded library.
(c vesica_version int32)
;; VESICA_VERSION_MAJOR of the loaded library.
(c vesica_version_major int32)
;; VESICA_VERSION_MINOR of the loaded library.
(c vesica_version_minor int32)
;; VESICA_VERSION_PATCH of the loaded library.
(c vesica_version_patch int32)
;; How many numbers does a shape of this kind have?
(c vesica_field_count int32 int32)
;; Name of a kind.
(c vesica_kind_name '* int32)
;; Name of the instruction set that batches use: the best one of this processor.
(c vesica_isa_name '*)
;; Is a shape valid, and if not, which rule does it break?
(c vesica_check_f32 int32 int32 '*)
;; Do two shapes share a point?
(c vesica_overlap_f32 int32 int32 '* int32 '*)
;; Do the insides of two shapes share a point?
(c vesica_interiors_overlap_f32 int32 int32 '* int32 '*)
;; How does a relate to b?
(c vesica_relation_f32 int32 int32 '* int32 '*)
;; Does a contain all of b?
(c vesica_contains_f32 int32 int32 '* int32 '*)
;; Where do the outlines of two shapes meet?
(c vesica_crossings_f32 int64 int32 '* int32 '* '* int64 '*)
;; How far apart are two solid shapes, and which of their points are closest?
(c vesica_nearest_f32 int32 int32 '* int32 '* '*)
;; How far apart are the outlines of two shapes, and where do they come closest?
(c vesica_boundary_distance_f32 int32 int32 '* int32 '* '*)
;; Penetration depth: how far and which way must b be moved until the two shapes only touch?
(c vesica_depth_f32 int32 int32 '* int32 '* '*)
;; Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment.
(c vesica_shape_area_f32 int32 int32 '* '*)
;; States facts of a polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
(c vesica_polygon_facts_f32 int32 '* '*)
;; Area of the intersection of two shapes.
(c vesica_area_f32 int32 int32 '* int32 '* '*)
;; Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
(c vesica_iou_f32 int32 int32 '* int32 '* '*)
;; Smallest box of representable numbers that contains a shape.
(c vesica_bounds_f32 int32 int32 '* '*)
;; Are the two points the same?
(c vesica_overlap_point_point_f32 int32 '* '*)
;; Does the point lie on the segment?
(c vesica_overlap_point_segment_f32 int32 '* '*)
;; Does the point lie in the disc or on its rim?
(c vesica_overlap_point_circle_f32 int32 '* '*)
;; Does the point lie in the box or on its outline?
(c vesica_overlap_point_aabb_f32 int32 '* '*)
;; Does the point lie in the rectangle or on its outline?
(c vesica_overlap_point_rect_f32 int32 '* '*)
;; Does the point lie in the ellipse or on its outline?
(c vesica_overlap_point_ellipse_f32 int32 '* '*)
;; Do the segments share a point?
(c vesica_overlap_segment_segment_f32 int32 '* '*)
;; Does the segment meet the disc?
(c vesica_overlap_segment_circle_f32 int32 '* '*)
;; Does the segment meet the box?
(c vesica_overlap_segment_aabb_f32 int32 '* '*)
;; Does the segment meet the rectangle?
(c vesica_overlap_segment_rect_f32 int32 '* '*)
;; Does the segment meet the ellipse?
(c vesica_overlap_segment_ellipse_f32 int32 '* '*)
;; Do the discs share a point?
(c vesica_overlap_circle_circle_f32 int32 '* '*)
;; Do the disc and the box share a point?
(c vesica_overlap_circle_aabb_f32 int32 '* '*)
;; Do the disc and the rectangle share a point?
(c vesica_overlap_circle_rect_f32 int32 '* '*)
;; Do the disc and the ellipse share a point?
(c vesica_overlap_circle_ellipse_f32 int32 '* '*)
;; Do the boxes share a point?
(c vesica_overlap_aabb_aabb_f32 int32 '* '*)
;; Do the box and the rectangle share a point?
(c vesica_overlap_aabb_rect_f32 int32 '* '*)
;; Do the box and the ellipse share a point?
(c vesica_overlap_aabb_ellipse_f32 int32 '* '*)
;; Do the rectangles share a point?
(c vesica_overlap_rect_rect_f32 int32 '* '*)
;; Do the rectangle and the ellipse share a point?
(c vesica_overlap_rect_ellipse_f32 int32 '* '*)
;; Do the ellipses share a point?
(c vesica_overlap_ellipse_ellipse_f32 int32 '* '*)
;; Box with two opposite corners, in any order.
(c vesica_aabb_from_corners_f32 int32 float float float float '*)
;; Rectangle from centre, angle and full size: width along the angle, height across it.
(c vesica_rect_from_angle_f32 int32 float float float float float '*)
;; Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
(c vesica_rect_from_corners_f32 int32 '* '*)
;; The largest distance from a given corner to the rectangle's corner that corresponds to it.
(c vesica_rect_corners_misfit_f32 int32 '* '* '*)
;; Rounded rectangle from centre, angle and full size, its round corners included: width along the angle, height
;; across.
(c vesica_round_rect_from_angle_f32 int32 float float float float float float '*)
;; Capsule from centre, angle, the length between the ends of its segment, and radius.
(c vesica_capsule_from_angle_f32 int32 float float float float float '*)
;; Capsule from the ends of its segment and its full width, twice the radius: a line of that width with round ends.
(c vesica_capsule_from_width_f32 int32 float float float float float '*)
;; Ellipse from centre, angle and half lengths: a along the angle, b across it.
(c vesica_ellipse_from_angle_f32 int32 float float float float float '*)
;; Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx, wy).
(c vesica_ellipse_from_radius_vector_f32 int32 float float float float float '*)
;; Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
(c vesica_ellipse_from_covariance_f32 int32 float float float float float float '*)
;; Ellipse of the points X with (X - C) .
(c vesica_ellipse_from_matrix_f32 int32 float float float float float '*)
;; Describes an array of `count` records.
(c vesica_shapes_from_records_f32 int32 int32 int64 '* ptrdiff_t '*)
;; Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f32.
(c vesica_overlap_many_f32 int64 '* '* '*)
;; Do the insides of a[i] and b[i] share a point? out[i] is the answer of vesica_interiors_overlap_f32.
(c vesica_interiors_overlap_many_f32 int64 '* '* '*)
;; How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f32.
(c vesica_relation_many_f32 int64 '* '* '*)
;; Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f32.
(c vesica_contains_many_f32 int64 '* '* '*)
;; How far apart are a[i] and b[i], and where?
(c vesica_nearest_many_f32 int64 '* '* '* '* '* '* '*)
;; How far apart are the outlines of a[i] and b[i]?
(c vesica_boundary_distance_many_f32 int64 '* '* '* '* '* '* '*)
;; How deep do a[i] and b[i] overlap?
(c vesica_depth_many_f32 int64 '* '* '* '* '*)
;; The area that a[i] and b[i] share: out[i] is the result of vesica_area_f32.
(c vesica_area_many_f32 int64 '* '* '*)
;; Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f32.
(c vesica_iou_many_f32 int64 '* '* '*)
;; Do a[i] and b[j] share a point?
(c vesica_overlap_matrix_f32 int64 '* '* '* ptrdiff_t)
;; Do the insides of a[i] and b[j] share a point?
(c vesica_interiors_overlap_matrix_f32 int64 '* '* '* ptrdiff_t)
;; How does a[i] relate to b[j]?
(c vesica_relation_matrix_f32 int64 '* '* '* ptrdiff_t)
;; Does a[i] contain all of b[j]?
(c vesica_contains_matrix_f32 int64 '* '* '* ptrdiff_t)
;; The area that a[i] and b[j] share.
(c vesica_area_matrix_f32 int64 '* '* '* ptrdiff_t)
;; Intersection over union of a[i] and b[j].
(c vesica_iou_matrix_f32 int64 '* '* '* ptrdiff_t)
;; Which of many shapes overlap one?
(c vesica_overlap_select_f32 int64 '* '* '* int64)
;; Which of many shapes share a point of their insides with that of one?
(c vesica_interiors_overlap_select_f32 int64 '* '* '* int64)
;; Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one whose
;; vesica_iou_f32 with every shape kept before is at most the threshold.
(c vesica_nms_f32 int32 '* '* float '* int64 '* '*)
;; Rectangles from boxes.
(c vesica_rects_from_boxes_f64 int64 '* int64 ptrdiff_t int32 '*)
;; Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
(c vesica_ellipses_from_boxes_f64 int64 '* int64 ptrdiff_t int32 '*)
;; Rectangles from four corners each: out[i] is the result of vesica_rect_from_corners_f64.
(c vesica_rects_from_corners_f64 int64 '* int64 ptrdiff_t '*)
;; How far corners are from those of rectangles: misfit[i] is the result of vesica_rect_corners_misfit_f64.
(c vesica_rect_corners_misfit_many_f64 int64 '* ptrdiff_t '* '*)
;; Boxes from rectangles or from ellipses: the inverse of the first two functions.
(c vesica_boxes_from_shapes_f64 int64 '* int32 '*)
;; The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
(c vesica_corners_of_shapes_f64 int64 '* '*)
;; Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f64.
(c vesica_bounds_many_f64 int64 '* '*)
;; Areas of an array of any kind: out[i] is the result of vesica_shape_area_f64.
(c vesica_shape_area_many_f64 int64 '* '*)
;; The convex hull of points: the smallest convex polygon that contains them.
(c vesica_convex_hull_f64 int64 '* '* int64)
;; The rectangle of the least area that contains points.
(c vesica_min_area_rect_f64 int32 '* '*)
;; The rectangle of the least perimeter that contains points, else as vesica_min_area_rect_f64.
(c vesica_min_perimeter_rect_f64 int32 '* '*)
;; The rectangles of the least area about each polygon or polyline of an array.
(c vesica_min_area_rect_many_f64 int64 '* '*)
;; The rectangles of the least perimeter about each polygon or polyline of an array.
(c vesica_min_perimeter_rect_many_f64 int64 '* '*)
;; Rectangles from boxes.
(c vesica_rects_from_boxes_f32 int64 '* int64 ptrdiff_t int32 '*)
;; Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
(c vesica_ellipses_from_boxes_f32 int64 '* int64 ptrdiff_t int32 '*)
;; Rectangles from four corners each: out[i] is the result of vesica_rect_from_corners_f32.
(c vesica_rects_from_corners_f32 int64 '* int64 ptrdiff_t '*)
;; How far corners are from those of rectangles: misfit[i] is the result of vesica_rect_corners_misfit_f32.
(c vesica_rect_corners_misfit_many_f32 int64 '* ptrdiff_t '* '*)
;; Boxes from rectangles or from ellipses: the inverse of the first two functions.
(c vesica_boxes_from_shapes_f32 int64 '* int32 '*)
;; The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
(c vesica_corners_of_shapes_f32 int64 '* '*)
;; Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f32.
(c vesica_bounds_many_f32 int64 '* '*)
;; Areas of an array of any kind: out[i] is the result of vesica_shape_area_f32.
(c vesica_shape_area_many_f32 int64 '* '*)
;; The convex hull of points: the smallest convex polygon that contains them.
(c vesica_convex_hull_f32 int64 '* '* int64)
;; The rectangle of the least area that contains points.
(c vesica_min_area_rect_f32 int32 '* '*)
;; The rectangle of the least perimeter that contains points, else as vesica_min_area_rect_f32.
(c vesica_min_perimeter_rect_f32 int32 '* '*)
;; The rectangles of the least area about each polygon or polyline of an array.
(c vesica_min_area_rect_many_f32 int64 '* '*)
;; The rectangles of the least perimeter about each polygon or polyline of an array.
(c vesica_min_perimeter_rect_many_f32 int64 '* '*)
;; All pairs that overlap and whose ratio is at least `threshold`, with the ratio: a sparse matrix of IoU and the
;; like.
(c vesica_join_ratio_f64 int64 int32 double '* '* int32 '* '* int32 int64 int64 '* int64 '* '* '* int64 '*)
;; How many bytes of scratch does greedy assignment of `count` pairs need?
(c vesica_assign_greedy_scratch int64 int64 int64 int64)
;; Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both
;; free, until there is none.
(c vesica_assign_greedy_f64 int64 '* '* '* int64 int64 int64 '* int64 '*)
;; How many bytes of scratch does the fusion of `count` boxes need?
(c vesica_fuse_scratch int64 int64)
;; Weighted boxes fusion: boxes of one object, as several detectors or views find them, become their weighted mean.
(c vesica_fuse_f64 int32 '* '* '* '* double int32 '* int64 '* '* '* '*)
;; A ratio of shared volume: IoU and its relatives of two upright prisms.
(c vesica_volume_ratio_f64 int32 int32 int32 '* '* int32 '* '* '*)
;; A ratio of shared volume of the prisms a[i] from spans_a[i] and b[i] from spans_b[i].
(c vesica_volume_ratio_many_f64 int64 int32 '* '* '* '* '*)
;; A ratio of shared volume of every a[i] and b[j], in out[i * row_stride + j].
(c vesica_volume_ratio_matrix_f64 int64 int32 '* '* '* '* '* ptrdiff_t)
;; How many bytes of scratch does matching by `count` pairs need?
(c vesica_match_truths_scratch int64 int64 int64 int64)
;; Which detections hit a truth, at each of some thresholds?
(c vesica_match_truths_f64 int32 int32 '* '* '* int64 '* int64 '* int64 '* int64 '* int64 '* '*)
;; How many bytes of scratch does the average precision of `count` detections need?
(c vesica_average_precision_scratch int64 int64)
;; Average precision (AP) of detections of one class.
(c vesica_average_precision_f64 int32 int32 '* '* int64 int64 '* int64 '*)
;; The distance of two circles, boxes, rectangles or ellipses as Gaussian distributions.
(c vesica_gaussian_distance_f64 int32 int32 int32 '* int32 '* '*)
;; The distance of a[i] and b[i]: out[i] is the result of vesica_gaussian_distance_f64.
(c vesica_gaussian_distance_many_f64 int64 int32 '* '* '*)
;; The distance of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_gaussian_distance_f64.
(c vesica_gaussian_distance_matrix_f64 int64 int32 '* '* '* ptrdiff_t)
;; All pairs that overlap and whose ratio is at least `threshold`, with the ratio: a sparse matrix of IoU and the
;; like.
(c vesica_join_ratio_f32 int64 int32 float '* '* int32 '* '* int32 int64 int64 '* int64 '* '* '* int64 '*)
;; Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both
;; free, until there is none.
(c vesica_assign_greedy_f32 int64 '* '* '* int64 int64 int64 '* int64 '*)
;; Weighted boxes fusion: boxes of one object, as several detectors or views find them, become their weighted mean.
(c vesica_fuse_f32 int32 '* '* '* '* float int32 '* int64 '* '* '* '*)
;; Which detections hit a truth, at each of some thresholds?
(c vesica_match_truths_f32 int32 int32 '* '* '* int64 '* int64 '* int64 '* int64 '* int64 '* '*)
;; Average precision (AP) of detections of one class.
(c vesica_average_precision_f32 int32 int32 '* '* int64 int64 '* int64 '*)
;; A ratio of shared volume: IoU and its relatives of two upright prisms.
(c vesica_volume_ratio_f32 int32 int32 int32 '* '* int32 '* '* '*)
;; A ratio of shared volume of the prisms a[i] from spans_a[i] and b[i] from spans_b[i].
(c vesica_volume_ratio_many_f32 int64 int32 '* '* '* '* '*)
;; A ratio of shared volume of every a[i] and b[j], in out[i * row_stride + j].
(c vesica_volume_ratio_matrix_f32 int64 int32 '* '* '* '* '* ptrdiff_t)
;; The distance of two circles, boxes, rectangles or ellipses as Gaussian distributions.
(c vesica_gaussian_distance_f32 int32 int32 int32 '* int32 '* '*)
;; The distance of a[i] and b[i]: out[i] is the result of vesica_gaussian_distance_f32.
(c vesica_gaussian_distance_many_f32 int64 int32 '* '* '*)
;; The distance of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_gaussian_distance_f32.
(c vesica_gaussian_distance_matrix_f32 int64 int32 '* '* '* ptrdiff_t)
;; How many bytes suffice for an index of `count` shapes, of any kinds?
(c vesica_index_size int64 int64)
;; How many bytes of scratch does building an index of `count` shapes need?
(c vesica_index_scratch int64 int64)
;; How many bytes of scratch does a join need, whatever its indexes?
(c vesica_join_scratch int64)
;; Are these bytes an index that is safe to read?
(c vesica_index_check int32 '* int64)
;; How many bytes does a built index take?
(c vesica_index_bytes int64 '*)
;; How many shapes was an index built from?
(c vesica_index_count int64 '*)
;; A box around all valid shapes of an index.
(c vesica_index_bounds int32 '* '*)
;; The items of an index in spatial order: shapes near each other have nearby places in it.
(c vesica_index_order int64 '* '* int64)
;; Builds the index of some sets of shapes.
(c vesica_index_build_f64 int64 '* int32 '* int64 '* int64)
;; One part of a build by several threads, in five steps.
(c vesica_index_step_f64 int64 int32 int64 int64 '* int32 '* int64 '* int64)
;; Which items of an index does one shape overlap?
(c vesica_index_select_f64 int64 '* '* int32 '* '* int64 '*)
;; Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
(c vesica_join_f64 int64 int32 '* '* int32 '* '* int32 int64 int64 '* int64 '* '* int64 '*)
;; All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once: those
;; for which vesica_within_f64 is > 0.
(c vesica_join_within_f64 int64 '* '* int32 '* '* int32 double int64 int64 '* '* int64 '*)
;; Which items of an index are nearest to one shape?
(c vesica_index_nearest_f64 int64 '* '* int32 '* int64 double '* '*)
;; Which items of index_b are nearest to each item of sets_a?
(c vesica_join_nearest_f64 int64 '* int32 '* '* int32 int64 double int64 int64 '* '*)
;; How many bytes do the boxes of a polygon or a polyline take?
(c vesica_polygon_boxes_size int64 int64)
;; Makes boxes about the edges of a polygon or a polyline that is asked again and again, such as a coast or a zone.
(c vesica_polygon_boxes_f64 int32 int32 '* '* int64)
;; Does a path with boxes overlap another shape?
(c vesica_polygon_boxes_overlap_f64 int32 int32 '* '* int64 int32 '*)
;; The distance of a path with boxes and another shape, and where it is.
(c vesica_polygon_boxes_nearest_f64 int32 int32 '* '* int64 int32 '* '*)
;; Are a path with boxes and another shape at most a distance apart?
(c vesica_polygon_boxes_within_f64 int32 int32 '* '* int64 int32 '* double)
;; Builds the index of some sets of shapes.
(c vesica_index_build_f32 int64 '* int32 '* int64 '* int64)
;; One part of a build by several threads, in five steps.
(c vesica_index_step_f32 int64 int32 int64 int64 '* int32 '* int64 '* int64)
;; Which items of an index does one shape overlap?
(c vesica_index_select_f32 int64 '* '* int32 '* '* int64 '*)
;; Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
(c vesica_join_f32 int64 int32 '* '* int32 '* '* int32 int64 int64 '* int64 '* '* int64 '*)
;; All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once: those
;; for which vesica_within_f32 is > 0.
(c vesica_join_within_f32 int64 '* '* int32 '* '* int32 float int64 int64 '* '* int64 '*)
;; Which items of an index are nearest to one shape?
(c vesica_index_nearest_f32 int64 '* '* int32 '* int64 float '* '*)
;; Which items of index_b are nearest to each item of sets_a?
(c vesica_join_nearest_f32 int64 '* int32 '* '* int32 int64 float int64 int64 '* '*)
;; Makes boxes about the edges of a polygon or a polyline that is asked again and again, such as a coast or a zone.
(c vesica_polygon_boxes_f32 int32 int32 '* '* int64)
;; Does a path with boxes overlap another shape?
(c vesica_polygon_boxes_overlap_f32 int32 int32 '* '* int64 int32 '*)
;; The distance of a path with boxes and another shape, and where it is.
(c vesica_polygon_boxes_nearest_f32 int32 int32 '* '* int64 int32 '* '*)
;; Are a path with boxes and another shape at most a distance apart?
(c vesica_polygon_boxes_within_f32 int32 int32 '* '* int64 int32 '* float)
;; A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
(c vesica_ratio_f64 int32 int32 int32 '* int32 '* '*)
;; A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f64.
(c vesica_ratio_many_f64 int64 int32 '* '* '*)
;; A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f64.
(c vesica_ratio_matrix_f64 int64 int32 '* '* '* ptrdiff_t)
;; How far apart are a[i] and b[j]?
(c vesica_nearest_matrix_f64 int64 '* '* '* ptrdiff_t)
;; How far apart are the outlines of a[i] and b[j]?
(c vesica_boundary_distance_matrix_f64 int64 '* '* '* ptrdiff_t)
;; How deep do a[i] and b[j] overlap?
(c vesica_depth_matrix_f64 int64 '* '* '* ptrdiff_t)
;; Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
(c vesica_signed_distance_f64 int32 int32 '* int32 '* '*)
;; Signed distances of a[i] and b[i].
(c vesica_signed_distance_many_f64 int64 '* '* '*)
;; Signed distances of a[i] and b[j].
(c vesica_signed_distance_matrix_f64 int64 '* '* '* ptrdiff_t)
;; Are two shapes at most `distance` apart?
(c vesica_within_f64 int32 int32 '* int32 '* double)
;; Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f64.
(c vesica_within_many_f64 int64 '* '* double '*)
;; Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of vesica_within_f64.
(c vesica_within_matrix_f64 int64 '* '* double '* ptrdiff_t)
;; Greedy non-maximum suppression as vesica_nms_f64, by any ratio, each label on its own.
(c vesica_suppress_f64 int32 '* '* '* int32 double double int64 '* int64 '* '*)
;; How many bytes of scratch does soft suppression of `count` shapes need?
(c vesica_suppress_soft_scratch int64 int64)
;; Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
(c vesica_suppress_soft_f64 int32 '* '* '* int32 int32 double double int64 '* int64 '* '* '*)
;; The share of each cell that a shape covers: out[j * row_stride + i] is area covered / area of cell (i, j).
(c vesica_coverage_f64 int32 int32 '* '* '* ptrdiff_t)
;; The cells of which a shape covers more than nothing, and their shares, as vesica_coverage_f64 has them.
(c vesica_coverage_cells_f64 int64 int32 '* '* '* '* int64)
;; A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
(c vesica_ratio_f32 int32 int32 int32 '* int32 '* '*)
;; A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f32.
(c vesica_ratio_many_f32 int64 int32 '* '* '*)
;; A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f32.
(c vesica_ratio_matrix_f32 int64 int32 '* '* '* ptrdiff_t)
;; How far apart are a[i] and b[j]?
(c vesica_nearest_matrix_f32 int64 '* '* '* ptrdiff_t)
;; How far apart are the outlines of a[i] and b[j]?
(c vesica_boundary_distance_matrix_f32 int64 '* '* '* ptrdiff_t)
;; How deep do a[i] and b[j] overlap?
(c vesica_depth_matrix_f32 int64 '* '* '* ptrdiff_t)
;; Greedy non-maximum suppression as vesica_nms_f32, by any ratio, each label on its own.
(c vesica_suppress_f32 int32 '* '* '* int32 float float int64 '* int64 '* '*)
;; Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
(c vesica_signed_distance_f32 int32 int32 '* int32 '* '*)
;; Signed distances of a[i] and b[i].
(c vesica_signed_distance_many_f32 int64 '* '* '*)
;; Signed distances of a[i] and b[j].
(c vesica_signed_distance_matrix_f32 int64 '* '* '* ptrdiff_t)
;; Are two shapes at most `distance` apart?
(c vesica_within_f32 int32 int32 '* int32 '* float)
;; Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f32.
(c vesica_within_many_f32 int64 '* '* float '*)
;; Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of vesica_within_f32.
(c vesica_within_matrix_f32 int64 '* '* float '* ptrdiff_t)
;; Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
(c vesica_suppress_soft_f32 int32 '* '* '* int32 int32 float float int64 '* int64 '* '* '*)
;; The share of each cell that a shape covers: out[j * row_stride + i] is area covered / area of cell (i, j).
(c vesica_coverage_f32 int32 int32 '* '* '* ptrdiff_t)
;; The cells of which a shape covers more than nothing, and their shares, as vesica_coverage_f32 has them.
(c vesica_coverage_cells_f32 int64 int32 '* '* '* '* int64)
;; Does b touch a while it moves, when first, and where?
(c vesica_cast_f64 int32 int32 '* int32 '* double double double '*)
;; When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]?
(c vesica_cast_many_f64 int64 '* '* '* '* ptrdiff_t double '* '* '* '* '*)
;; Which of many shapes at rest does one moving shape touch first?
(c vesica_cast_first_f64 int64 '* '* double double double '*)
;; A box that holds a shape throughout its motion, t from 0 to t_end.
(c vesica_sweep_bounds_f64 int32 int32 '* double double double '*)
;; Which items of an index does one moving shape touch?
(c vesica_index_cast_f64 int64 '* '* int32 '* double double double '* int64 '*)
;; Which item of an index does one moving shape touch first?
(c vesica_index_cast_first_f64 int64 '* '* int32 '* double double double '*)
;; When do two shapes that move and turn touch first?
(c vesica_impact_time_f64 int32 int32 '* '* int32 '* '* double '* '*)
;; Which item of an index does a shape that moves and turns touch first?
(c vesica_index_impact_time_f64 int64 '* '* int32 '* '* double '* '* '*)
;; Contact manifold: where do two convex shapes press on each other, how deep, and along which normal?
(c vesica_manifold_f64 int32 int32 '* int32 '* '*)
;; The contacts of a[i] and b[i].
(c vesica_manifold_many_f64 int64 '* '* '*)
;; A ray at a point.
(c vesica_cast_point_point_f64 int32 '* '* double double double '*)
;; A ray at a segment.
(c vesica_cast_segment_point_f64 int32 '* '* double double double '*)
;; A ray at a disc.
(c vesica_cast_circle_point_f64 int32 '* '* double double double '*)
;; A ray at an axis-aligned box.
(c vesica_cast_aabb_point_f64 int32 '* '* double double double '*)
;; A ray at a rectangle.
(c vesica_cast_rect_point_f64 int32 '* '* double double double '*)
;; A ray at an ellipse.
(c vesica_cast_ellipse_point_f64 int32 '* '* double double double '*)
;; Two discs.
(c vesica_cast_circle_circle_f64 int32 '* '* double double double '*)
;; Two rectangles.
(c vesica_cast_rect_rect_f64 int32 '* '* double double double '*)
;; Does b touch a while it moves, when first, and where?
(c vesica_cast_f32 int32 int32 '* int32 '* float float float '*)
;; When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]?
(c vesica_cast_many_f32 int64 '* '* '* '* ptrdiff_t float '* '* '* '* '*)
;; Which of many shapes at rest does one moving shape touch first?
(c vesica_cast_first_f32 int64 '* '* float float float '*)
;; A box that holds a shape throughout its motion, t from 0 to t_end.
(c vesica_sweep_bounds_f32 int32 int32 '* float float float '*)
;; Which items of an index does one moving shape touch?
(c vesica_index_cast_f32 int64 '* '* int32 '* float float float '* int64 '*)
;; Which item of an index does one moving shape touch first?
(c vesica_index_cast_first_f32 int64 '* '* int32 '* float float float '*)
;; As vesica_impact_time_f64.
(c vesica_impact_time_f32 int32 int32 '* '* int32 '* '* float '* '*)
;; Which item of an index does a shape that moves and turns touch first?
(c vesica_index_impact_time_f32 int64 '* '* int32 '* '* float '* '* '*)
;; Contact manifold: where do two convex shapes press on each other, how deep, and along which normal?
(c vesica_manifold_f32 int32 int32 '* int32 '* '*)
;; The contacts of a[i] and b[i].
(c vesica_manifold_many_f32 int64 '* '* '*)
;; A ray at a point.
(c vesica_cast_point_point_f32 int32 '* '* float float float '*)
;; A ray at a segment.
(c vesica_cast_segment_point_f32 int32 '* '* float float float '*)
;; A ray at a disc.
(c vesica_cast_circle_point_f32 int32 '* '* float float float '*)
;; A ray at an axis-aligned box.
(c vesica_cast_aabb_point_f32 int32 '* '* float float float '*)
;; A ray at a rectangle.
(c vesica_cast_rect_point_f32 int32 '* '* float float float '*)
;; A ray at an ellipse.
(c vesica_cast_ellipse_point_f32 int32 '* '* float float float '*)
;; Two discs.
(c vesica_cast_circle_circle_f32 int32 '* '* float float float '*)
;; Two rectangles.
(c vesica_cast_rect_rect_f32 int32 '* '* float float float '*)
;; The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
(c vesica_de9im_f64 int32 int32 '* int32 '* '*)
;; Does a nine-intersection matrix match a pattern, such as "T*F**F***" for "a is within b"?
(c vesica_de9im_match int32 '* '*)
;; The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
(c vesica_intersection_f64 int64 int32 '* int32 '* '* int64)
;; The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
(c vesica_de9im_f32 int32 int32 '* int32 '* '*)
;; The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
(c vesica_intersection_f32 int64 int32 '* int32 '* '* int64)
