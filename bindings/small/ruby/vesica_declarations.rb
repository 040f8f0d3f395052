# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0
# Written by bindings/declare from capi/vesica.json: not to be edited.

# The constants and functions of libvesica.
module Vesica
  VERSION_MAJOR = 0
  VERSION_MINOR = 1
  VERSION_PATCH = 0
  VERSION = 100
  POINT = 0
  SEGMENT = 1
  CIRCLE = 2
  AABB = 3
  RECT = 4
  ELLIPSE = 5
  CAPSULE = 6
  ROUND_RECT = 7
  POLYGON = 8
  POLYLINE = 9
  DISJOINT = 0
  TOUCH = 1
  CROSS = 2
  INSIDE = 3
  INSIDE_TOUCH = 4
  CONTAINS = 5
  CONTAINS_TOUCH = 6
  EQUAL = 7
  E_NULL = -1
  E_SHAPE = -2
  E_KIND = -3
  E_ARGUMENT = -4
  E_NOT_FINITE = -5
  E_NEGATIVE_SIZE = -6
  E_ZERO_AXIS = -7
  E_INVERTED = -8
  E_RANGE = -9
  E_INDEX = -10
  E_RINGS = -11
  E_NOT_SIMPLE = -12
  E_NOT_CONVEX = -13
  ANGLE_RADIANS = 0
  ANGLE_DEGREES = 1
  ANGLE_QUARTERS = 2
  ANGLE_REVERSED = 4
  FUSED_MEAN = 0
  FUSED_MAX = 1
  MATCH_VOC = 0
  MATCH_COCO = 1
  TRUTH_COUNTS = 0
  TRUTH_CROWD = 1
  TRUTH_IGNORED = 2
  OUTCOME_MISS = 0
  OUTCOME_HIT = 1
  OUTCOME_IGNORED = 2
  PRECISION_VOC_2007 = 0
  PRECISION_VOC_2010 = 1
  PRECISION_COCO = 2
  GAUSSIAN_BHATTACHARYYA = 0
  GAUSSIAN_HELLINGER = 1
  GAUSSIAN_KULLBACK_LEIBLER = 2
  GAUSSIAN_WASSERSTEIN = 3
  JOIN_OVERLAP = 0
  JOIN_BOUNDS = 1
  JOIN_CONTAINS = 2
  JOIN_INSIDE = 3
  JOIN_INTERIORS = 4
  RATIO_OVER_UNION = 0
  RATIO_OVER_FIRST = 1
  RATIO_OVER_SECOND = 2
  RATIO_OVER_SMALLER = 3
  RATIO_GENERALIZED = 4
  RATIO_DISTANCE = 5
  RATIO_COMPLETE = 6
  WITHIN_NO = 0
  WITHIN_YES = 1
  WITHIN_NEARLY = 2
  DECAY_LINEAR = 0
  DECAY_GAUSSIAN = 1
  CAST_MISS = 0
  CAST_HIT = 1
  CAST_START = 2
  CAST_NEAR = 3
  DE9IM_SIZE = 10

  # For Fiddle::Importer#extern. A pointer is a string, or what Fiddle makes.
  DECLARATIONS = [
    # Do two shapes share a point?
    'int vesica_overlap_f64(int, void *, int, void *)',
    # Do the insides of two shapes share a point?
    'int vesica_interiors_overlap_f64(int, void *, int, void *)',
    # Does a contain all of b?
    'int vesica_contains_f64(int, void *, int, void *)',
    # How does a relate to b?
    'int vesica_relation_f64(int, void *, int, void *)',
    # How far apart are two solid shapes, and which of their points are closest?
    'int vesica_nearest_f64(int, void *, int, void *, void *)',
    # Penetration depth: how far and which way must b be moved until the two shapes only touch?
    'int vesica_depth_f64(int, void *, int, void *, void *)',
    # Area of the intersection of two shapes.
    'int vesica_area_f64(int, void *, int, void *, void *)',
    # Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
    'int vesica_iou_f64(int, void *, int, void *, void *)',
    # Smallest box of representable numbers that contains a shape.
    'int vesica_bounds_f64(int, void *, void *)',
    # Is a shape valid, and if not, which rule does it break?
    'int vesica_check_f64(int, void *)',
    # The meaning of an error code, as one English phrase without a full stop.
    'const char * vesica_strerror(int)',
    # Where do the outlines of two shapes meet?
    'int64_t vesica_crossings_f64(int, void *, int, void *, void *, int64_t, void *)',
    # How far apart are the outlines of two shapes, and where do they come closest?
    'int vesica_boundary_distance_f64(int, void *, int, void *, void *)',
    # Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment.
    'int vesica_shape_area_f64(int, void *, void *)',
    # States facts of a polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
    'int vesica_polygon_facts_f64(void *, void *)',
    # Are the two points the same?
    'int vesica_overlap_point_point_f64(void *, void *)',
    # Does the point lie on the segment?
    'int vesica_overlap_point_segment_f64(void *, void *)',
    # Does the point lie in the disc or on its rim?
    'int vesica_overlap_point_circle_f64(void *, void *)',
    # Does the point lie in the box or on its outline?
    'int vesica_overlap_point_aabb_f64(void *, void *)',
    # Does the point lie in the rectangle or on its outline?
    'int vesica_overlap_point_rect_f64(void *, void *)',
    # Does the point lie in the ellipse or on its outline?
    'int vesica_overlap_point_ellipse_f64(void *, void *)',
    # Do the segments share a point?
    'int vesica_overlap_segment_segment_f64(void *, void *)',
    # Does the segment meet the disc?
    'int vesica_overlap_segment_circle_f64(void *, void *)',
    # Does the segment meet the box?
    'int vesica_overlap_segment_aabb_f64(void *, void *)',
    # Does the segment meet the rectangle?
    'int vesica_overlap_segment_rect_f64(void *, void *)',
    # Does the segment meet the ellipse?
    'int vesica_overlap_segment_ellipse_f64(void *, void *)',
    # Do the discs share a point?
    'int vesica_overlap_circle_circle_f64(void *, void *)',
    # Do the disc and the box share a point?
    'int vesica_overlap_circle_aabb_f64(void *, void *)',
    # Do the disc and the rectangle share a point?
    'int vesica_overlap_circle_rect_f64(void *, void *)',
    # Do the disc and the ellipse share a point?
    'int vesica_overlap_circle_ellipse_f64(void *, void *)',
    # Do the boxes share a point?
    'int vesica_overlap_aabb_aabb_f64(void *, void *)',
    # Do the box and the rectangle share a point?
    'int vesica_overlap_aabb_rect_f64(void *, void *)',
    # Do the box and the ellipse share a point?
    'int vesica_overlap_aabb_ellipse_f64(void *, void *)',
    # Do the rectangles share a point?
    'int vesica_overlap_rect_rect_f64(void *, void *)',
    # Do the rectangle and the ellipse share a point?
    'int vesica_overlap_rect_ellipse_f64(void *, void *)',
    # Do the ellipses share a point?
    'int vesica_overlap_ellipse_ellipse_f64(void *, void *)',
    # Box with two opposite corners, in any order.
    'int vesica_aabb_from_corners_f64(double, double, double, double, void *)',
    # Rectangle from centre, angle and full size: width along the angle, height across it.
    'int vesica_rect_from_angle_f64(double, double, double, double, double, void *)',
    # Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
    'int vesica_rect_from_corners_f64(void *, void *)',
    # The largest distance from a given corner to the rectangle's corner that corresponds to it.
    'int vesica_rect_corners_misfit_f64(void *, void *, void *)',
    # Rounded rectangle from centre, angle and full size, its round corners included: width along the angle, height
    # across.
    'int vesica_round_rect_from_angle_f64(double, double, double, double, double, double, void *)',
    # Capsule from centre, angle, the length between the ends of its segment, and radius.
    'int vesica_capsule_from_angle_f64(double, double, double, double, double, void *)',
    # Capsule from the ends of its segment and its full width, twice the radius: a line of that width with round
    # ends.
    'int vesica_capsule_from_width_f64(double, double, double, double, double, void *)',
    # Ellipse from centre, angle and half lengths: a along the angle, b across it.
    'int vesica_ellipse_from_angle_f64(double, double, double, double, double, void *)',
    # Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx, wy).
    'int vesica_ellipse_from_radius_vector_f64(double, double, double, double, double, void *)',
    # Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
    'int vesica_ellipse_from_covariance_f64(double, double, double, double, double, double, void *)',
    # Ellipse of the points X with (X - C) .
    'int vesica_ellipse_from_matrix_f64(double, double, double, double, double, void *)',
    # Describes an array of `count` records.
    'int vesica_shapes_from_records_f64(int, int64_t, void *, ptrdiff_t, void *)',
    # Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f64.
    'int64_t vesica_overlap_many_f64(void *, void *, void *)',
    # Do the insides of a[i] and b[i] share a point? out[i] is the answer of vesica_interiors_overlap_f64.
    'int64_t vesica_interiors_overlap_many_f64(void *, void *, void *)',
    # How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f64.
    'int64_t vesica_relation_many_f64(void *, void *, void *)',
    # Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f64.
    'int64_t vesica_contains_many_f64(void *, void *, void *)',
    # How far apart are a[i] and b[i], and where?
    'int64_t vesica_nearest_many_f64(void *, void *, void *, void *, void *, void *, void *)',
    # How far apart are the outlines of a[i] and b[i]?
    'int64_t vesica_boundary_distance_many_f64(void *, void *, void *, void *, void *, void *, void *)',
    # How deep do a[i] and b[i] overlap?
    'int64_t vesica_depth_many_f64(void *, void *, void *, void *, void *)',
    # The area that a[i] and b[i] share: out[i] is the result of vesica_area_f64.
    'int64_t vesica_area_many_f64(void *, void *, void *)',
    # Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f64.
    'int64_t vesica_iou_many_f64(void *, void *, void *)',
    # Do a[i] and b[j] share a point?
    'int64_t vesica_overlap_matrix_f64(void *, void *, void *, ptrdiff_t)',
    # Do the insides of a[i] and b[j] share a point?
    'int64_t vesica_interiors_overlap_matrix_f64(void *, void *, void *, ptrdiff_t)',
    # How does a[i] relate to b[j]?
    'int64_t vesica_relation_matrix_f64(void *, void *, void *, ptrdiff_t)',
    # Does a[i] contain all of b[j]?
    'int64_t vesica_contains_matrix_f64(void *, void *, void *, ptrdiff_t)',
    # The area that a[i] and b[j] share.
    'int64_t vesica_area_matrix_f64(void *, void *, void *, ptrdiff_t)',
    # Intersection over union of a[i] and b[j].
    'int64_t vesica_iou_matrix_f64(void *, void *, void *, ptrdiff_t)',
    # Which of many shapes overlap one?
    'int64_t vesica_overlap_select_f64(void *, void *, void *, int64_t)',
    # Which of many shapes share a point of their insides with that of one?
    'int64_t vesica_interiors_overlap_select_f64(void *, void *, void *, int64_t)',
    # How many bytes of scratch do vesica_nms_f64, vesica_suppress_f64 and their float forms need for `count` shapes?
    'int64_t vesica_nms_scratch(int64_t)',
    # Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one
    # whose vesica_iou_f64 with every shape kept before is at most the threshold.
    'int vesica_nms_f64(void *, void *, double, void *, int64_t, void *, void *)',
    # Version of the loaded library.
    'int vesica_version()',
    # VESICA_VERSION_MAJOR of the loaded library.
    'int vesica_version_major()',
    # VESICA_VERSION_MINOR of the loaded library.
    'int vesica_version_minor()',
    # VESICA_VERSION_PATCH of the loaded library.
    'int vesica_version_patch()',
    # How many numbers does a shape of this kind have?
    'int vesica_field_count(int)',
    # Name of a kind.
    'const char * vesica_kind_name(int)',
    # Name of the instruction set that batches use: the best one of this processor.
    'const char * vesica_isa_name()',
    # Is a shape valid, and if not, which rule does it break?
    'int vesica_check_f32(int, void *)',
    # Do two shapes share a point?
    'int vesica_overlap_f32(int, void *, int, void *)',
    # Do the insides of two shapes share a point?
    'int vesica_interiors_overlap_f32(int, void *, int, void *)',
    # How does a relate to b?
    'int vesica_relation_f32(int, void *, int, void *)',
    # Does a contain all of b?
    'int vesica_contains_f32(int, void *, int, void *)',
    # Where do the outlines of two shapes meet?
    'int64_t vesica_crossings_f32(int, void *, int, void *, void *, int64_t, void *)',
    # How far apart are two solid shapes, and which of their points are closest?
    'int vesica_nearest_f32(int, void *, int, void *, void *)',
    # How far apart are the outlines of two shapes, and where do they come closest?
    'int vesica_boundary_distance_f32(int, void *, int, void *, void *)',
    # Penetration depth: how far and which way must b be moved until the two shapes only touch?
    'int vesica_depth_f32(int, void *, int, void *, void *)',
    # Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment.
    'int vesica_shape_area_f32(int, void *, void *)',
    # States facts of a polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
    'int vesica_polygon_facts_f32(void *, void *)',
    # Area of the intersection of two shapes.
    'int vesica_area_f32(int, void *, int, void *, void *)',
    # Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
    'int vesica_iou_f32(int, void *, int, void *, void *)',
    # Smallest box of representable numbers that contains a shape.
    'int vesica_bounds_f32(int, void *, void *)',
    # Are the two points the same?
    'int vesica_overlap_point_point_f32(void *, void *)',
    # Does the point lie on the segment?
    'int vesica_overlap_point_segment_f32(void *, void *)',
    # Does the point lie in the disc or on its rim?
    'int vesica_overlap_point_circle_f32(void *, void *)',
    # Does the point lie in the box or on its outline?
    'int vesica_overlap_point_aabb_f32(void *, void *)',
    # Does the point lie in the rectangle or on its outline?
    'int vesica_overlap_point_rect_f32(void *, void *)',
    # Does the point lie in the ellipse or on its outline?
    'int vesica_overlap_point_ellipse_f32(void *, void *)',
    # Do the segments share a point?
    'int vesica_overlap_segment_segment_f32(void *, void *)',
    # Does the segment meet the disc?
    'int vesica_overlap_segment_circle_f32(void *, void *)',
    # Does the segment meet the box?
    'int vesica_overlap_segment_aabb_f32(void *, void *)',
    # Does the segment meet the rectangle?
    'int vesica_overlap_segment_rect_f32(void *, void *)',
    # Does the segment meet the ellipse?
    'int vesica_overlap_segment_ellipse_f32(void *, void *)',
    # Do the discs share a point?
    'int vesica_overlap_circle_circle_f32(void *, void *)',
    # Do the disc and the box share a point?
    'int vesica_overlap_circle_aabb_f32(void *, void *)',
    # Do the disc and the rectangle share a point?
    'int vesica_overlap_circle_rect_f32(void *, void *)',
    # Do the disc and the ellipse share a point?
    'int vesica_overlap_circle_ellipse_f32(void *, void *)',
    # Do the boxes share a point?
    'int vesica_overlap_aabb_aabb_f32(void *, void *)',
    # Do the box and the rectangle share a point?
    'int vesica_overlap_aabb_rect_f32(void *, void *)',
    # Do the box and the ellipse share a point?
    'int vesica_overlap_aabb_ellipse_f32(void *, void *)',
    # Do the rectangles share a point?
    'int vesica_overlap_rect_rect_f32(void *, void *)',
    # Do the rectangle and the ellipse share a point?
    'int vesica_overlap_rect_ellipse_f32(void *, void *)',
    # Do the ellipses share a point?
    'int vesica_overlap_ellipse_ellipse_f32(void *, void *)',
    # Box with two opposite corners, in any order.
    'int vesica_aabb_from_corners_f32(float, float, float, float, void *)',
    # Rectangle from centre, angle and full size: width along the angle, height across it.
    'int vesica_rect_from_angle_f32(float, float, float, float, float, void *)',
    # Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
    'int vesica_rect_from_corners_f32(void *, void *)',
    # The largest distance from a given corner to the rectangle's corner that corresponds to it.
    'int vesica_rect_corners_misfit_f32(void *, void *, void *)',
    # Rounded rectangle from centre, angle and full size, its round corners included: width along the angle, height
    # across.
    'int vesica_round_rect_from_angle_f32(float, float, float, float, float, float, void *)',
    # Capsule from centre, angle, the length between the ends of its segment, and radius.
    'int vesica_capsule_from_angle_f32(float, float, float, float, float, void *)',
    # Capsule from the ends of its segment and its full width, twice the radius: a line of that width with round
    # ends.
    'int vesica_capsule_from_width_f32(float, float, float, float, float, void *)',
    # Ellipse from centre, angle and half lengths: a along the angle, b across it.
    'int vesica_ellipse_from_angle_f32(float, float, float, float, float, void *)',
    # Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx, wy).
    'int vesica_ellipse_from_radius_vector_f32(float, float, float, float, float, void *)',
    # Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
    'int vesica_ellipse_from_covariance_f32(float, float, float, float, float, float, void *)',
    # Ellipse of the points X with (X - C) .
    'int vesica_ellipse_from_matrix_f32(float, float, float, float, float, void *)',
    # Describes an array of `count` records.
    'int vesica_shapes_from_records_f32(int, int64_t, void *, ptrdiff_t, void *)',
    # Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f32.
    'int64_t vesica_overlap_many_f32(void *, void *, void *)',
    # Do the insides of a[i] and b[i] share a point? out[i] is the answer of vesica_interiors_overlap_f32.
    'int64_t vesica_interiors_overlap_many_f32(void *, void *, void *)',
    # How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f32.
    'int64_t vesica_relation_many_f32(void *, void *, void *)',
    # Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f32.
    'int64_t vesica_contains_many_f32(void *, void *, void *)',
    # How far apart are a[i] and b[i], and where?
    'int64_t vesica_nearest_many_f32(void *, void *, void *, void *, void *, void *, void *)',
    # How far apart are the outlines of a[i] and b[i]?
    'int64_t vesica_boundary_distance_many_f32(void *, void *, void *, void *, void *, void *, void *)',
    # How deep do a[i] and b[i] overlap?
    'int64_t vesica_depth_many_f32(void *, void *, void *, void *, void *)',
    # The area that a[i] and b[i] share: out[i] is the result of vesica_area_f32.
    'int64_t vesica_area_many_f32(void *, void *, void *)',
    # Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f32.
    'int64_t vesica_iou_many_f32(void *, void *, void *)',
    # Do a[i] and b[j] share a point?
    'int64_t vesica_overlap_matrix_f32(void *, void *, void *, ptrdiff_t)',
    # Do the insides of a[i] and b[j] share a point?
    'int64_t vesica_interiors_overlap_matrix_f32(void *, void *, void *, ptrdiff_t)',
    # How does a[i] relate to b[j]?
    'int64_t vesica_relation_matrix_f32(void *, void *, void *, ptrdiff_t)',
    # Does a[i] contain all of b[j]?
    'int64_t vesica_contains_matrix_f32(void *, void *, void *, ptrdiff_t)',
    # The area that a[i] and b[j] share.
    'int64_t vesica_area_matrix_f32(void *, void *, void *, ptrdiff_t)',
    # Intersection over union of a[i] and b[j].
    'int64_t vesica_iou_matrix_f32(void *, void *, void *, ptrdiff_t)',
    # Which of many shapes overlap one?
    'int64_t vesica_overlap_select_f32(void *, void *, void *, int64_t)',
    # Which of many shapes share a point of their insides with that of one?
    'int64_t vesica_interiors_overlap_select_f32(void *, void *, void *, int64_t)',
    # Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one
    # whose vesica_iou_f32 with every shape kept before is at most the threshold.
    'int vesica_nms_f32(void *, void *, float, void *, int64_t, void *, void *)',
    # Rectangles from boxes.
    'int64_t vesica_rects_from_boxes_f64(void *, int64_t, ptrdiff_t, int, void *)',
    # Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
    'int64_t vesica_ellipses_from_boxes_f64(void *, int64_t, ptrdiff_t, int, void *)',
    # Rectangles from four corners each: out[i] is the result of vesica_rect_from_corners_f64.
    'int64_t vesica_rects_from_corners_f64(void *, int64_t, ptrdiff_t, void *)',
    # How far corners are from those of rectangles: misfit[i] is the result of vesica_rect_corners_misfit_f64.
    'int64_t vesica_rect_corners_misfit_many_f64(void *, ptrdiff_t, void *, void *)',
    # Boxes from rectangles or from ellipses: the inverse of the first two functions.
    'int64_t vesica_boxes_from_shapes_f64(void *, int, void *)',
    # The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
    'int64_t vesica_corners_of_shapes_f64(void *, void *)',
    # Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f64.
    'int64_t vesica_bounds_many_f64(void *, void *)',
    # Areas of an array of any kind: out[i] is the result of vesica_shape_area_f64.
    'int64_t vesica_shape_area_many_f64(void *, void *)',
    # The convex hull of points: the smallest convex polygon that contains them.
    'int64_t vesica_convex_hull_f64(void *, void *, int64_t)',
    # The rectangle of the least area that contains points.
    'int vesica_min_area_rect_f64(void *, void *)',
    # The rectangle of the least perimeter that contains points, else as vesica_min_area_rect_f64.
    'int vesica_min_perimeter_rect_f64(void *, void *)',
    # The rectangles of the least area about each polygon or polyline of an array.
    'int64_t vesica_min_area_rect_many_f64(void *, void *)',
    # The rectangles of the least perimeter about each polygon or polyline of an array.
    'int64_t vesica_min_perimeter_rect_many_f64(void *, void *)',
    # Rectangles from boxes.
    'int64_t vesica_rects_from_boxes_f32(void *, int64_t, ptrdiff_t, int, void *)',
    # Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
    'int64_t vesica_ellipses_from_boxes_f32(void *, int64_t, ptrdiff_t, int, void *)',
    # Rectangles from four corners each: out[i] is the result of vesica_rect_from_corners_f32.
    'int64_t vesica_rects_from_corners_f32(void *, int64_t, ptrdiff_t, void *)',
    # How far corners are from those of rectangles: misfit[i] is the result of vesica_rect_corners_misfit_f32.
    'int64_t vesica_rect_corners_misfit_many_f32(void *, ptrdiff_t, void *, void *)',
    # Boxes from rectangles or from ellipses: the inverse of the first two functions.
    'int64_t vesica_boxes_from_shapes_f32(void *, int, void *)',
    # The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
    'int64_t vesica_corners_of_shapes_f32(void *, void *)',
    # Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f32.
    'int64_t vesica_bounds_many_f32(void *, void *)',
    # Areas of an array of any kind: out[i] is the result of vesica_shape_area_f32.
    'int64_t vesica_shape_area_many_f32(void *, void *)',
    # The convex hull of points: the smallest convex polygon that contains them.
    'int64_t vesica_convex_hull_f32(void *, void *, int64_t)',
    # The rectangle of the least area that contains points.
    'int vesica_min_area_rect_f32(void *, void *)',
    # The rectangle of the least perimeter that contains points, else as vesica_min_area_rect_f32.
    'int vesica_min_perimeter_rect_f32(void *, void *)',
    # The rectangles of the least area about each polygon or polyline of an array.
    'int64_t vesica_min_area_rect_many_f32(void *, void *)',
    # The rectangles of the least perimeter about each polygon or polyline of an array.
    'int64_t vesica_min_perimeter_rect_many_f32(void *, void *)',
    # All pairs that overlap and whose ratio is at least `threshold`, with the ratio: a sparse matrix of IoU and the
    # like.
    'int64_t vesica_join_ratio_f64(int, double, void *, void *, int, void *, void *, int, int64_t, int64_t, void *,
        int64_t, void *, void *, void *, int64_t, void *)',
    # How many bytes of scratch does greedy assignment of `count` pairs need?
    'int64_t vesica_assign_greedy_scratch(int64_t, int64_t, int64_t)',
    # Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both
    # free, until there is none.
    'int64_t vesica_assign_greedy_f64(void *, void *, void *, int64_t, int64_t, int64_t, void *, int64_t, void *)',
    # How many bytes of scratch does the fusion of `count` boxes need?
    'int64_t vesica_fuse_scratch(int64_t)',
    # Weighted boxes fusion: boxes of one object, as several detectors or views find them, become their weighted
    # mean.
    'int vesica_fuse_f64(void *, void *, void *, void *, double, int, void *, int64_t, void *, void *, void *, void *)',
    # A ratio of shared volume: IoU and its relatives of two upright prisms.
    'int vesica_volume_ratio_f64(int, int, void *, void *, int, void *, void *, void *)',
    # A ratio of shared volume of the prisms a[i] from spans_a[i] and b[i] from spans_b[i].
    'int64_t vesica_volume_ratio_many_f64(int, void *, void *, void *, void *, void *)',
    # A ratio of shared volume of every a[i] and b[j], in out[i * row_stride + j].
    'int64_t vesica_volume_ratio_matrix_f64(int, void *, void *, void *, void *, void *, ptrdiff_t)',
    # How many bytes of scratch does matching by `count` pairs need?
    'int64_t vesica_match_truths_scratch(int64_t, int64_t, int64_t)',
    # Which detections hit a truth, at each of some thresholds?
    'int vesica_match_truths_f64(int, void *, void *, void *, int64_t, void *, int64_t, void *, int64_t, void *,
        int64_t, void *, int64_t, void *, void *)',
    # How many bytes of scratch does the average precision of `count` detections need?
    'int64_t vesica_average_precision_scratch(int64_t)',
    # Average precision (AP) of detections of one class.
    'int vesica_average_precision_f64(int, void *, void *, int64_t, int64_t, void *, int64_t, void *)',
    # The distance of two circles, boxes, rectangles or ellipses as Gaussian distributions.
    'int vesica_gaussian_distance_f64(int, int, void *, int, void *, void *)',
    # The distance of a[i] and b[i]: out[i] is the result of vesica_gaussian_distance_f64.
    'int64_t vesica_gaussian_distance_many_f64(int, void *, void *, void *)',
    # The distance of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_gaussian_distance_f64.
    'int64_t vesica_gaussian_distance_matrix_f64(int, void *, void *, void *, ptrdiff_t)',
    # All pairs that overlap and whose ratio is at least `threshold`, with the ratio: a sparse matrix of IoU and the
    # like.
    'int64_t vesica_join_ratio_f32(int, float, void *, void *, int, void *, void *, int, int64_t, int64_t, void *,
        int64_t, void *, void *, void *, int64_t, void *)',
    # Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both
    # free, until there is none.
    'int64_t vesica_assign_greedy_f32(void *, void *, void *, int64_t, int64_t, int64_t, void *, int64_t, void *)',
    # Weighted boxes fusion: boxes of one object, as several detectors or views find them, become their weighted
    # mean.
    'int vesica_fuse_f32(void *, void *, void *, void *, float, int, void *, int64_t, void *, void *, void *, void *)',
    # Which detections hit a truth, at each of some thresholds?
    'int vesica_match_truths_f32(int, void *, void *, void *, int64_t, void *, int64_t, void *, int64_t, void *,
        int64_t, void *, int64_t, void *, void *)',
    # Average precision (AP) of detections of one class.
    'int vesica_average_precision_f32(int, void *, void *, int64_t, int64_t, void *, int64_t, void *)',
    # A ratio of shared volume: IoU and its relatives of two upright prisms.
    'int vesica_volume_ratio_f32(int, int, void *, void *, int, void *, void *, void *)',
    # A ratio of shared volume of the prisms a[i] from spans_a[i] and b[i] from spans_b[i].
    'int64_t vesica_volume_ratio_many_f32(int, void *, void *, void *, void *, void *)',
    # A ratio of shared volume of every a[i] and b[j], in out[i * row_stride + j].
    'int64_t vesica_volume_ratio_matrix_f32(int, void *, void *, void *, void *, void *, ptrdiff_t)',
    # The distance of two circles, boxes, rectangles or ellipses as Gaussian distributions.
    'int vesica_gaussian_distance_f32(int, int, void *, int, void *, void *)',
    # The distance of a[i] and b[i]: out[i] is the result of vesica_gaussian_distance_f32.
    'int64_t vesica_gaussian_distance_many_f32(int, void *, void *, void *)',
    # The distance of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_gaussian_distance_f32.
    'int64_t vesica_gaussian_distance_matrix_f32(int, void *, void *, void *, ptrdiff_t)',
    # How many bytes suffice for an index of `count` shapes, of any kinds?
    'int64_t vesica_index_size(int64_t)',
    # How many bytes of scratch does building an index of `count` shapes need?
    'int64_t vesica_index_scratch(int64_t)',
    # How many bytes of scratch does a join need, whatever its indexes?
    'int64_t vesica_join_scratch()',
    # Are these bytes an index that is safe to read?
    'int vesica_index_check(void *, int64_t)',
    # How many bytes does a built index take?
    'int64_t vesica_index_bytes(void *)',
    # How many shapes was an index built from?
    'int64_t vesica_index_count(void *)',
    # A box around all valid shapes of an index.
    'int vesica_index_bounds(void *, void *)',
    # The items of an index in spatial order: shapes near each other have nearby places in it.
    'int64_t vesica_index_order(void *, void *, int64_t)',
    # Builds the index of some sets of shapes.
    'int64_t vesica_index_build_f64(void *, int, void *, int64_t, void *, int64_t)',
    # One part of a build by several threads, in five steps.
    'int64_t vesica_index_step_f64(int, int64_t, int64_t, void *, int, void *, int64_t, void *, int64_t)',
    # Which items of an index does one shape overlap?
    'int64_t vesica_index_select_f64(void *, void *, int, void *, void *, int64_t, void *)',
    # Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
    'int64_t vesica_join_f64(int, void *, void *, int, void *, void *, int, int64_t, int64_t, void *, int64_t, void *,
        void *, int64_t, void *)',
    # All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once: those
    # for which vesica_within_f64 is > 0.
    'int64_t vesica_join_within_f64(void *, void *, int, void *, void *, int, double, int64_t, int64_t, void *, void *,
        int64_t, void *)',
    # Which items of an index are nearest to one shape?
    'int64_t vesica_index_nearest_f64(void *, void *, int, void *, int64_t, double, void *, void *)',
    # Which items of index_b are nearest to each item of sets_a?
    'int64_t vesica_join_nearest_f64(void *, int, void *, void *, int, int64_t, double, int64_t, int64_t, void *,
        void *)',
    # How many bytes do the boxes of a polygon or a polyline take?
    'int64_t vesica_polygon_boxes_size(int64_t)',
    # Makes boxes about the edges of a polygon or a polyline that is asked again and again, such as a coast or a
    # zone.
    'int vesica_polygon_boxes_f64(int, void *, void *, int64_t)',
    # Does a path with boxes overlap another shape?
    'int vesica_polygon_boxes_overlap_f64(int, void *, void *, int64_t, int, void *)',
    # The distance of a path with boxes and another shape, and where it is.
    'int vesica_polygon_boxes_nearest_f64(int, void *, void *, int64_t, int, void *, void *)',
    # Are a path with boxes and another shape at most a distance apart?
    'int vesica_polygon_boxes_within_f64(int, void *, void *, int64_t, int, void *, double)',
    # Builds the index of some sets of shapes.
    'int64_t vesica_index_build_f32(void *, int, void *, int64_t, void *, int64_t)',
    # One part of a build by several threads, in five steps.
    'int64_t vesica_index_step_f32(int, int64_t, int64_t, void *, int, void *, int64_t, void *, int64_t)',
    # Which items of an index does one shape overlap?
    'int64_t vesica_index_select_f32(void *, void *, int, void *, void *, int64_t, void *)',
    # Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
    'int64_t vesica_join_f32(int, void *, void *, int, void *, void *, int, int64_t, int64_t, void *, int64_t, void *,
        void *, int64_t, void *)',
    # All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once: those
    # for which vesica_within_f32 is > 0.
    'int64_t vesica_join_within_f32(void *, void *, int, void *, void *, int, float, int64_t, int64_t, void *, void *,
        int64_t, void *)',
    # Which items of an index are nearest to one shape?
    'int64_t vesica_index_nearest_f32(void *, void *, int, void *, int64_t, float, void *, void *)',
    # Which items of index_b are nearest to each item of sets_a?
    'int64_t vesica_join_nearest_f32(void *, int, void *, void *, int, int64_t, float, int64_t, int64_t, void *,
        void *)',
    # Makes boxes about the edges of a polygon or a polyline that is asked again and again, such as a coast or a
    # zone.
    'int vesica_polygon_boxes_f32(int, void *, void *, int64_t)',
    # Does a path with boxes overlap another shape?
    'int vesica_polygon_boxes_overlap_f32(int, void *, void *, int64_t, int, void *)',
    # The distance of a path with boxes and another shape, and where it is.
    'int vesica_polygon_boxes_nearest_f32(int, void *, void *, int64_t, int, void *, void *)',
    # Are a path with boxes and another shape at most a distance apart?
    'int vesica_polygon_boxes_within_f32(int, void *, void *, int64_t, int, void *, float)',
    # A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
    'int vesica_ratio_f64(int, int, void *, int, void *, void *)',
    # A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f64.
    'int64_t vesica_ratio_many_f64(int, void *, void *, void *)',
    # A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f64.
    'int64_t vesica_ratio_matrix_f64(int, void *, void *, void *, ptrdiff_t)',
    # How far apart are a[i] and b[j]?
    'int64_t vesica_nearest_matrix_f64(void *, void *, void *, ptrdiff_t)',
    # How far apart are the outlines of a[i] and b[j]?
    'int64_t vesica_boundary_distance_matrix_f64(void *, void *, void *, ptrdiff_t)',
    # How deep do a[i] and b[j] overlap?
    'int64_t vesica_depth_matrix_f64(void *, void *, void *, ptrdiff_t)',
    # Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
    'int vesica_signed_distance_f64(int, void *, int, void *, void *)',
    # Signed distances of a[i] and b[i].
    'int64_t vesica_signed_distance_many_f64(void *, void *, void *)',
    # Signed distances of a[i] and b[j].
    'int64_t vesica_signed_distance_matrix_f64(void *, void *, void *, ptrdiff_t)',
    # Are two shapes at most `distance` apart?
    'int vesica_within_f64(int, void *, int, void *, double)',
    # Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f64.
    'int64_t vesica_within_many_f64(void *, void *, double, void *)',
    # Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of vesica_within_f64.
    'int64_t vesica_within_matrix_f64(void *, void *, double, void *, ptrdiff_t)',
    # Greedy non-maximum suppression as vesica_nms_f64, by any ratio, each label on its own.
    'int vesica_suppress_f64(void *, void *, void *, int, double, double, int64_t, void *, int64_t, void *, void *)',
    # How many bytes of scratch does soft suppression of `count` shapes need?
    'int64_t vesica_suppress_soft_scratch(int64_t)',
    # Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
    'int vesica_suppress_soft_f64(void *, void *, void *, int, int, double, double, int64_t, void *, int64_t, void *,
        void *, void *)',
    # The share of each cell that a shape covers: out[j * row_stride + i] is area covered / area of cell (i, j).
    'int vesica_coverage_f64(int, void *, void *, void *, ptrdiff_t)',
    # The cells of which a shape covers more than nothing, and their shares, as vesica_coverage_f64 has them.
    'int64_t vesica_coverage_cells_f64(int, void *, void *, void *, void *, int64_t)',
    # A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
    'int vesica_ratio_f32(int, int, void *, int, void *, void *)',
    # A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f32.
    'int64_t vesica_ratio_many_f32(int, void *, void *, void *)',
    # A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f32.
    'int64_t vesica_ratio_matrix_f32(int, void *, void *, void *, ptrdiff_t)',
    # How far apart are a[i] and b[j]?
    'int64_t vesica_nearest_matrix_f32(void *, void *, void *, ptrdiff_t)',
    # How far apart are the outlines of a[i] and b[j]?
    'int64_t vesica_boundary_distance_matrix_f32(void *, void *, void *, ptrdiff_t)',
    # How deep do a[i] and b[j] overlap?
    'int64_t vesica_depth_matrix_f32(void *, void *, void *, ptrdiff_t)',
    # Greedy non-maximum suppression as vesica_nms_f32, by any ratio, each label on its own.
    'int vesica_suppress_f32(void *, void *, void *, int, float, float, int64_t, void *, int64_t, void *, void *)',
    # Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
    'int vesica_signed_distance_f32(int, void *, int, void *, void *)',
    # Signed distances of a[i] and b[i].
    'int64_t vesica_signed_distance_many_f32(void *, void *, void *)',
    # Signed distances of a[i] and b[j].
    'int64_t vesica_signed_distance_matrix_f32(void *, void *, void *, ptrdiff_t)',
    # Are two shapes at most `distance` apart?
    'int vesica_within_f32(int, void *, int, void *, float)',
    # Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f32.
    'int64_t vesica_within_many_f32(void *, void *, float, void *)',
    # Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of vesica_within_f32.
    'int64_t vesica_within_matrix_f32(void *, void *, float, void *, ptrdiff_t)',
    # Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
    'int vesica_suppress_soft_f32(void *, void *, void *, int, int, float, float, int64_t, void *, int64_t, void *,
        void *, void *)',
    # The share of each cell that a shape covers: out[j * row_stride + i] is area covered / area of cell (i, j).
    'int vesica_coverage_f32(int, void *, void *, void *, ptrdiff_t)',
    # The cells of which a shape covers more than nothing, and their shares, as vesica_coverage_f32 has them.
    'int64_t vesica_coverage_cells_f32(int, void *, void *, void *, void *, int64_t)',
    # Does b touch a while it moves, when first, and where?
    'int vesica_cast_f64(int, void *, int, void *, double, double, double, void *)',
    # When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]?
    'int64_t vesica_cast_many_f64(void *, void *, void *, void *, ptrdiff_t, double, void *, void *, void *, void *,
        void *)',
    # Which of many shapes at rest does one moving shape touch first?
    'int64_t vesica_cast_first_f64(void *, void *, double, double, double, void *)',
    # A box that holds a shape throughout its motion, t from 0 to t_end.
    'int vesica_sweep_bounds_f64(int, void *, double, double, double, void *)',
    # Which items of an index does one moving shape touch?
    'int64_t vesica_index_cast_f64(void *, void *, int, void *, double, double, double, void *, int64_t, void *)',
    # Which item of an index does one moving shape touch first?
    'int64_t vesica_index_cast_first_f64(void *, void *, int, void *, double, double, double, void *)',
    # When do two shapes that move and turn touch first?
    'int vesica_impact_time_f64(int, void *, void *, int, void *, void *, double, void *, void *)',
    # Which item of an index does a shape that moves and turns touch first?
    'int64_t vesica_index_impact_time_f64(void *, void *, int, void *, void *, double, void *, void *, void *)',
    # Contact manifold: where do two convex shapes press on each other, how deep, and along which normal?
    'int vesica_manifold_f64(int, void *, int, void *, void *)',
    # The contacts of a[i] and b[i].
    'int64_t vesica_manifold_many_f64(void *, void *, void *)',
    # A ray at a point.
    'int vesica_cast_point_point_f64(void *, void *, double, double, double, void *)',
    # A ray at a segment.
    'int vesica_cast_segment_point_f64(void *, void *, double, double, double, void *)',
    # A ray at a disc.
    'int vesica_cast_circle_point_f64(void *, void *, double, double, double, void *)',
    # A ray at an axis-aligned box.
    'int vesica_cast_aabb_point_f64(void *, void *, double, double, double, void *)',
    # A ray at a rectangle.
    'int vesica_cast_rect_point_f64(void *, void *, double, double, double, void *)',
    # A ray at an ellipse.
    'int vesica_cast_ellipse_point_f64(void *, void *, double, double, double, void *)',
    # Two discs.
    'int vesica_cast_circle_circle_f64(void *, void *, double, double, double, void *)',
    # Two rectangles.
    'int vesica_cast_rect_rect_f64(void *, void *, double, double, double, void *)',
    # Does b touch a while it moves, when first, and where?
    'int vesica_cast_f32(int, void *, int, void *, float, float, float, void *)',
    # When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]?
    'int64_t vesica_cast_many_f32(void *, void *, void *, void *, ptrdiff_t, float, void *, void *, void *, void *,
        void *)',
    # Which of many shapes at rest does one moving shape touch first?
    'int64_t vesica_cast_first_f32(void *, void *, float, float, float, void *)',
    # A box that holds a shape throughout its motion, t from 0 to t_end.
    'int vesica_sweep_bounds_f32(int, void *, float, float, float, void *)',
    # Which items of an index does one moving shape touch?
    'int64_t vesica_index_cast_f32(void *, void *, int, void *, float, float, float, void *, int64_t, void *)',
    # Which item of an index does one moving shape touch first?
    'int64_t vesica_index_cast_first_f32(void *, void *, int, void *, float, float, float, void *)',
    # As vesica_impact_time_f64.
    'int vesica_impact_time_f32(int, void *, void *, int, void *, void *, float, void *, void *)',
    # Which item of an index does a shape that moves and turns touch first?
    'int64_t vesica_index_impact_time_f32(void *, void *, int, void *, void *, float, void *, void *, void *)',
    # Contact manifold: where do two convex shapes press on each other, how deep, and along which normal?
    'int vesica_manifold_f32(int, void *, int, void *, void *)',
    # The contacts of a[i] and b[i].
    'int64_t vesica_manifold_many_f32(void *, void *, void *)',
    # A ray at a point.
    'int vesica_cast_point_point_f32(void *, void *, float, float, float, void *)',
    # A ray at a segment.
    'int vesica_cast_segment_point_f32(void *, void *, float, float, float, void *)',
    # A ray at a disc.
    'int vesica_cast_circle_point_f32(void *, void *, float, float, float, void *)',
    # A ray at an axis-aligned box.
    'int vesica_cast_aabb_point_f32(void *, void *, float, float, float, void *)',
    # A ray at a rectangle.
    'int vesica_cast_rect_point_f32(void *, void *, float, float, float, void *)',
    # A ray at an ellipse.
    'int vesica_cast_ellipse_point_f32(void *, void *, float, float, float, void *)',
    # Two discs.
    'int vesica_cast_circle_circle_f32(void *, void *, float, float, float, void *)',
    # Two rectangles.
    'int vesica_cast_rect_rect_f32(void *, void *, float, float, float, void *)',
    # The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
    'int vesica_de9im_f64(int, void *, int, void *, void *)',
    # Does a nine-intersection matrix match a pattern, such as "T*F**F***" for "a is within b"?
    'int vesica_de9im_match(const char *, const char *)',
    # The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
    'int64_t vesica_intersection_f64(int, void *, int, void *, void *, int64_t)',
    # The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
    'int vesica_de9im_f32(int, void *, int, void *, void *)',
    # The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
    'int64_t vesica_intersection_f32(int, void *, int, void *, void *, int64_t)',
  ].freeze
end
