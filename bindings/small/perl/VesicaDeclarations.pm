# SPDX-License-Identifier: Apache-2.0
# Written by bindings/declare from capi/vesica.json: not to be edited.
package VesicaDeclarations;

# The constants and functions of libvesica, for FFI::Platypus: an
# opaque is an address. ptrdiff_t is taken to have 64 bits.
use strict;
use warnings;

our %CONSTANTS = (
    VERSION_MAJOR => 0,
    VERSION_MINOR => 1,
    VERSION_PATCH => 0,
    VERSION => 100,
    POINT => 0,
    SEGMENT => 1,
    CIRCLE => 2,
    AABB => 3,
    RECT => 4,
    ELLIPSE => 5,
    CAPSULE => 6,
    ROUND_RECT => 7,
    POLYGON => 8,
    POLYLINE => 9,
    DISJOINT => 0,
    TOUCH => 1,
    CROSS => 2,
    INSIDE => 3,
    INSIDE_TOUCH => 4,
    CONTAINS => 5,
    CONTAINS_TOUCH => 6,
    EQUAL => 7,
    E_NULL => -1,
    E_SHAPE => -2,
    E_KIND => -3,
    E_ARGUMENT => -4,
    E_NOT_FINITE => -5,
    E_NEGATIVE_SIZE => -6,
    E_ZERO_AXIS => -7,
    E_INVERTED => -8,
    E_RANGE => -9,
    E_INDEX => -10,
    E_RINGS => -11,
    E_NOT_SIMPLE => -12,
    E_NOT_CONVEX => -13,
    ANGLE_RADIANS => 0,
    ANGLE_DEGREES => 1,
    ANGLE_QUARTERS => 2,
    ANGLE_REVERSED => 4,
    FUSED_MEAN => 0,
    FUSED_MAX => 1,
    MATCH_VOC => 0,
    MATCH_COCO => 1,
    TRUTH_COUNTS => 0,
    TRUTH_CROWD => 1,
    TRUTH_IGNORED => 2,
    OUTCOME_MISS => 0,
    OUTCOME_HIT => 1,
    OUTCOME_IGNORED => 2,
    PRECISION_VOC_2007 => 0,
    PRECISION_VOC_2010 => 1,
    PRECISION_COCO => 2,
    GAUSSIAN_BHATTACHARYYA => 0,
    GAUSSIAN_HELLINGER => 1,
    GAUSSIAN_KULLBACK_LEIBLER => 2,
    GAUSSIAN_WASSERSTEIN => 3,
    JOIN_OVERLAP => 0,
    JOIN_BOUNDS => 1,
    JOIN_CONTAINS => 2,
    JOIN_INSIDE => 3,
    JOIN_INTERIORS => 4,
    RATIO_OVER_UNION => 0,
    RATIO_OVER_FIRST => 1,
    RATIO_OVER_SECOND => 2,
    RATIO_OVER_SMALLER => 3,
    RATIO_GENERALIZED => 4,
    RATIO_DISTANCE => 5,
    RATIO_COMPLETE => 6,
    WITHIN_NO => 0,
    WITHIN_YES => 1,
    WITHIN_NEARLY => 2,
    DECAY_LINEAR => 0,
    DECAY_GAUSSIAN => 1,
    CAST_MISS => 0,
    CAST_HIT => 1,
    CAST_START => 2,
    CAST_NEAR => 3,
    DE9IM_SIZE => 10,
);

our @FUNCTIONS = (
    # Do two shapes share a point?
    [vesica_overlap_f64 => ['sint32', 'double[]', 'sint32', 'double[]'] => 'sint32'],
    # Do the insides of two shapes share a point?
    [vesica_interiors_overlap_f64 => ['sint32', 'double[]', 'sint32', 'double[]'] => 'sint32'],
    # Does a contain all of b?
    [vesica_contains_f64 => ['sint32', 'double[]', 'sint32', 'double[]'] => 'sint32'],
    # How does a relate to b?
    [vesica_relation_f64 => ['sint32', 'double[]', 'sint32', 'double[]'] => 'sint32'],
    # How far apart are two solid shapes, and which of their points are closest?
    [vesica_nearest_f64 => ['sint32', 'double[]', 'sint32', 'double[]', 'opaque'] => 'sint32'],
    # Penetration depth: how far and which way must b be moved until the two shapes only touch?
    [vesica_depth_f64 => ['sint32', 'double[]', 'sint32', 'double[]', 'opaque'] => 'sint32'],
    # Area of the intersection of two shapes.
    [vesica_area_f64 => ['sint32', 'double[]', 'sint32', 'double[]', 'opaque'] => 'sint32'],
    # Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
    [vesica_iou_f64 => ['sint32', 'double[]', 'sint32', 'double[]', 'opaque'] => 'sint32'],
    # Smallest box of representable numbers that contains a shape.
    [vesica_bounds_f64 => ['sint32', 'double[]', 'opaque'] => 'sint32'],
    # Is a shape valid, and if not, which rule does it break?
    [vesica_check_f64 => ['sint32', 'double[]'] => 'sint32'],
    # The meaning of an error code, as one English phrase without a full stop.
    [vesica_strerror => ['sint32'] => 'string'],
    # Where do the outlines of two shapes meet?
    [vesica_crossings_f64 => ['sint32', 'double[]', 'sint32', 'double[]', 'opaque', 'sint64', 'opaque'] => 'sint64'],
    # How far apart are the outlines of two shapes, and where do they come closest?
    [vesica_boundary_distance_f64 => ['sint32', 'double[]', 'sint32', 'double[]', 'opaque'] => 'sint32'],
    # Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment.
    [vesica_shape_area_f64 => ['sint32', 'double[]', 'opaque'] => 'sint32'],
    # States facts of a polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
    [vesica_polygon_facts_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Are the two points the same?
    [vesica_overlap_point_point_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Does the point lie on the segment?
    [vesica_overlap_point_segment_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Does the point lie in the disc or on its rim?
    [vesica_overlap_point_circle_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Does the point lie in the box or on its outline?
    [vesica_overlap_point_aabb_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Does the point lie in the rectangle or on its outline?
    [vesica_overlap_point_rect_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Does the point lie in the ellipse or on its outline?
    [vesica_overlap_point_ellipse_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Do the segments share a point?
    [vesica_overlap_segment_segment_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Does the segment meet the disc?
    [vesica_overlap_segment_circle_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Does the segment meet the box?
    [vesica_overlap_segment_aabb_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Does the segment meet the rectangle?
    [vesica_overlap_segment_rect_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Does the segment meet the ellipse?
    [vesica_overlap_segment_ellipse_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Do the discs share a point?
    [vesica_overlap_circle_circle_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Do the disc and the box share a point?
    [vesica_overlap_circle_aabb_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Do the disc and the rectangle share a point?
    [vesica_overlap_circle_rect_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Do the disc and the ellipse share a point?
    [vesica_overlap_circle_ellipse_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Do the boxes share a point?
    [vesica_overlap_aabb_aabb_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Do the box and the rectangle share a point?
    [vesica_overlap_aabb_rect_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Do the box and the ellipse share a point?
    [vesica_overlap_aabb_ellipse_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Do the rectangles share a point?
    [vesica_overlap_rect_rect_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Do the rectangle and the ellipse share a point?
    [vesica_overlap_rect_ellipse_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Do the ellipses share a point?
    [vesica_overlap_ellipse_ellipse_f64 => ['opaque', 'opaque'] => 'sint32'],
    # Box with two opposite corners, in any order.
    [vesica_aabb_from_corners_f64 => ['double', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # Rectangle from centre, angle and full size: width along the angle, height across it.
    [vesica_rect_from_angle_f64 => ['double', 'double', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
    [vesica_rect_from_corners_f64 => ['double[]', 'opaque'] => 'sint32'],
    # The largest distance from a given corner to the rectangle's corner that corresponds to it.
    [vesica_rect_corners_misfit_f64 => ['double[]', 'opaque', 'opaque'] => 'sint32'],
    # Rounded rectangle from centre, angle and full size, its round corners included: width along the angle, height
    # across.
    [vesica_round_rect_from_angle_f64 => ['double', 'double', 'double', 'double', 'double', 'double',
        'opaque'] => 'sint32'],
    # Capsule from centre, angle, the length between the ends of its segment, and radius.
    [vesica_capsule_from_angle_f64 => ['double', 'double', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # Capsule from the ends of its segment and its full width, twice the radius: a line of that width with round
    # ends.
    [vesica_capsule_from_width_f64 => ['double', 'double', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # Ellipse from centre, angle and half lengths: a along the angle, b across it.
    [vesica_ellipse_from_angle_f64 => ['double', 'double', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx, wy).
    [vesica_ellipse_from_radius_vector_f64 => ['double', 'double', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
    [vesica_ellipse_from_covariance_f64 => ['double', 'double', 'double', 'double', 'double', 'double',
        'opaque'] => 'sint32'],
    # Ellipse of the points X with (X - C) .
    [vesica_ellipse_from_matrix_f64 => ['double', 'double', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # Describes an array of `count` records.
    [vesica_shapes_from_records_f64 => ['sint32', 'sint64', 'opaque', 'sint64', 'opaque'] => 'sint32'],
    # Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f64.
    [vesica_overlap_many_f64 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # Do the insides of a[i] and b[i] share a point? out[i] is the answer of vesica_interiors_overlap_f64.
    [vesica_interiors_overlap_many_f64 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f64.
    [vesica_relation_many_f64 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f64.
    [vesica_contains_many_f64 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # How far apart are a[i] and b[i], and where?
    [vesica_nearest_many_f64 => ['opaque', 'opaque', 'opaque', 'opaque', 'opaque', 'opaque', 'opaque'] => 'sint64'],
    # How far apart are the outlines of a[i] and b[i]?
    [vesica_boundary_distance_many_f64 => ['opaque', 'opaque', 'opaque', 'opaque', 'opaque', 'opaque',
        'opaque'] => 'sint64'],
    # How deep do a[i] and b[i] overlap?
    [vesica_depth_many_f64 => ['opaque', 'opaque', 'opaque', 'opaque', 'opaque'] => 'sint64'],
    # The area that a[i] and b[i] share: out[i] is the result of vesica_area_f64.
    [vesica_area_many_f64 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f64.
    [vesica_iou_many_f64 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # Do a[i] and b[j] share a point?
    [vesica_overlap_matrix_f64 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Do the insides of a[i] and b[j] share a point?
    [vesica_interiors_overlap_matrix_f64 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # How does a[i] relate to b[j]?
    [vesica_relation_matrix_f64 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Does a[i] contain all of b[j]?
    [vesica_contains_matrix_f64 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # The area that a[i] and b[j] share.
    [vesica_area_matrix_f64 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Intersection over union of a[i] and b[j].
    [vesica_iou_matrix_f64 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Which of many shapes overlap one?
    [vesica_overlap_select_f64 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Which of many shapes share a point of their insides with that of one?
    [vesica_interiors_overlap_select_f64 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # How many bytes of scratch do vesica_nms_f64, vesica_suppress_f64 and their float forms need for `count` shapes?
    [vesica_nms_scratch => ['sint64'] => 'sint64'],
    # Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one
    # whose vesica_iou_f64 with every shape kept before is at most the threshold.
    [vesica_nms_f64 => ['opaque', 'opaque', 'double', 'opaque', 'sint64', 'opaque', 'opaque'] => 'sint32'],
    # Version of the loaded library.
    [vesica_version => [] => 'sint32'],
    # VESICA_VERSION_MAJOR of the loaded library.
    [vesica_version_major => [] => 'sint32'],
    # VESICA_VERSION_MINOR of the loaded library.
    [vesica_version_minor => [] => 'sint32'],
    # VESICA_VERSION_PATCH of the loaded library.
    [vesica_version_patch => [] => 'sint32'],
    # How many numbers does a shape of this kind have?
    [vesica_field_count => ['sint32'] => 'sint32'],
    # Name of a kind.
    [vesica_kind_name => ['sint32'] => 'string'],
    # Name of the instruction set that batches use: the best one of this processor.
    [vesica_isa_name => [] => 'string'],
    # Is a shape valid, and if not, which rule does it break?
    [vesica_check_f32 => ['sint32', 'float[]'] => 'sint32'],
    # Do two shapes share a point?
    [vesica_overlap_f32 => ['sint32', 'float[]', 'sint32', 'float[]'] => 'sint32'],
    # Do the insides of two shapes share a point?
    [vesica_interiors_overlap_f32 => ['sint32', 'float[]', 'sint32', 'float[]'] => 'sint32'],
    # How does a relate to b?
    [vesica_relation_f32 => ['sint32', 'float[]', 'sint32', 'float[]'] => 'sint32'],
    # Does a contain all of b?
    [vesica_contains_f32 => ['sint32', 'float[]', 'sint32', 'float[]'] => 'sint32'],
    # Where do the outlines of two shapes meet?
    [vesica_crossings_f32 => ['sint32', 'float[]', 'sint32', 'float[]', 'opaque', 'sint64', 'opaque'] => 'sint64'],
    # How far apart are two solid shapes, and which of their points are closest?
    [vesica_nearest_f32 => ['sint32', 'float[]', 'sint32', 'float[]', 'opaque'] => 'sint32'],
    # How far apart are the outlines of two shapes, and where do they come closest?
    [vesica_boundary_distance_f32 => ['sint32', 'float[]', 'sint32', 'float[]', 'opaque'] => 'sint32'],
    # Penetration depth: how far and which way must b be moved until the two shapes only touch?
    [vesica_depth_f32 => ['sint32', 'float[]', 'sint32', 'float[]', 'opaque'] => 'sint32'],
    # Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment.
    [vesica_shape_area_f32 => ['sint32', 'float[]', 'opaque'] => 'sint32'],
    # States facts of a polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
    [vesica_polygon_facts_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Area of the intersection of two shapes.
    [vesica_area_f32 => ['sint32', 'float[]', 'sint32', 'float[]', 'opaque'] => 'sint32'],
    # Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
    [vesica_iou_f32 => ['sint32', 'float[]', 'sint32', 'float[]', 'opaque'] => 'sint32'],
    # Smallest box of representable numbers that contains a shape.
    [vesica_bounds_f32 => ['sint32', 'float[]', 'opaque'] => 'sint32'],
    # Are the two points the same?
    [vesica_overlap_point_point_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Does the point lie on the segment?
    [vesica_overlap_point_segment_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Does the point lie in the disc or on its rim?
    [vesica_overlap_point_circle_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Does the point lie in the box or on its outline?
    [vesica_overlap_point_aabb_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Does the point lie in the rectangle or on its outline?
    [vesica_overlap_point_rect_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Does the point lie in the ellipse or on its outline?
    [vesica_overlap_point_ellipse_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Do the segments share a point?
    [vesica_overlap_segment_segment_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Does the segment meet the disc?
    [vesica_overlap_segment_circle_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Does the segment meet the box?
    [vesica_overlap_segment_aabb_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Does the segment meet the rectangle?
    [vesica_overlap_segment_rect_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Does the segment meet the ellipse?
    [vesica_overlap_segment_ellipse_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Do the discs share a point?
    [vesica_overlap_circle_circle_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Do the disc and the box share a point?
    [vesica_overlap_circle_aabb_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Do the disc and the rectangle share a point?
    [vesica_overlap_circle_rect_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Do the disc and the ellipse share a point?
    [vesica_overlap_circle_ellipse_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Do the boxes share a point?
    [vesica_overlap_aabb_aabb_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Do the box and the rectangle share a point?
    [vesica_overlap_aabb_rect_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Do the box and the ellipse share a point?
    [vesica_overlap_aabb_ellipse_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Do the rectangles share a point?
    [vesica_overlap_rect_rect_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Do the rectangle and the ellipse share a point?
    [vesica_overlap_rect_ellipse_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Do the ellipses share a point?
    [vesica_overlap_ellipse_ellipse_f32 => ['opaque', 'opaque'] => 'sint32'],
    # Box with two opposite corners, in any order.
    [vesica_aabb_from_corners_f32 => ['float', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # Rectangle from centre, angle and full size: width along the angle, height across it.
    [vesica_rect_from_angle_f32 => ['float', 'float', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
    [vesica_rect_from_corners_f32 => ['float[]', 'opaque'] => 'sint32'],
    # The largest distance from a given corner to the rectangle's corner that corresponds to it.
    [vesica_rect_corners_misfit_f32 => ['float[]', 'opaque', 'opaque'] => 'sint32'],
    # Rounded rectangle from centre, angle and full size, its round corners included: width along the angle, height
    # across.
    [vesica_round_rect_from_angle_f32 => ['float', 'float', 'float', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # Capsule from centre, angle, the length between the ends of its segment, and radius.
    [vesica_capsule_from_angle_f32 => ['float', 'float', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # Capsule from the ends of its segment and its full width, twice the radius: a line of that width with round
    # ends.
    [vesica_capsule_from_width_f32 => ['float', 'float', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # Ellipse from centre, angle and half lengths: a along the angle, b across it.
    [vesica_ellipse_from_angle_f32 => ['float', 'float', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx, wy).
    [vesica_ellipse_from_radius_vector_f32 => ['float', 'float', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
    [vesica_ellipse_from_covariance_f32 => ['float', 'float', 'float', 'float', 'float', 'float',
        'opaque'] => 'sint32'],
    # Ellipse of the points X with (X - C) .
    [vesica_ellipse_from_matrix_f32 => ['float', 'float', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # Describes an array of `count` records.
    [vesica_shapes_from_records_f32 => ['sint32', 'sint64', 'opaque', 'sint64', 'opaque'] => 'sint32'],
    # Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f32.
    [vesica_overlap_many_f32 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # Do the insides of a[i] and b[i] share a point? out[i] is the answer of vesica_interiors_overlap_f32.
    [vesica_interiors_overlap_many_f32 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f32.
    [vesica_relation_many_f32 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f32.
    [vesica_contains_many_f32 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # How far apart are a[i] and b[i], and where?
    [vesica_nearest_many_f32 => ['opaque', 'opaque', 'opaque', 'opaque', 'opaque', 'opaque', 'opaque'] => 'sint64'],
    # How far apart are the outlines of a[i] and b[i]?
    [vesica_boundary_distance_many_f32 => ['opaque', 'opaque', 'opaque', 'opaque', 'opaque', 'opaque',
        'opaque'] => 'sint64'],
    # How deep do a[i] and b[i] overlap?
    [vesica_depth_many_f32 => ['opaque', 'opaque', 'opaque', 'opaque', 'opaque'] => 'sint64'],
    # The area that a[i] and b[i] share: out[i] is the result of vesica_area_f32.
    [vesica_area_many_f32 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f32.
    [vesica_iou_many_f32 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # Do a[i] and b[j] share a point?
    [vesica_overlap_matrix_f32 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Do the insides of a[i] and b[j] share a point?
    [vesica_interiors_overlap_matrix_f32 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # How does a[i] relate to b[j]?
    [vesica_relation_matrix_f32 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Does a[i] contain all of b[j]?
    [vesica_contains_matrix_f32 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # The area that a[i] and b[j] share.
    [vesica_area_matrix_f32 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Intersection over union of a[i] and b[j].
    [vesica_iou_matrix_f32 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Which of many shapes overlap one?
    [vesica_overlap_select_f32 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Which of many shapes share a point of their insides with that of one?
    [vesica_interiors_overlap_select_f32 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one
    # whose vesica_iou_f32 with every shape kept before is at most the threshold.
    [vesica_nms_f32 => ['opaque', 'opaque', 'float', 'opaque', 'sint64', 'opaque', 'opaque'] => 'sint32'],
    # Rectangles from boxes.
    [vesica_rects_from_boxes_f64 => ['opaque', 'sint64', 'sint64', 'sint32', 'opaque'] => 'sint64'],
    # Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
    [vesica_ellipses_from_boxes_f64 => ['opaque', 'sint64', 'sint64', 'sint32', 'opaque'] => 'sint64'],
    # Rectangles from four corners each: out[i] is the result of vesica_rect_from_corners_f64.
    [vesica_rects_from_corners_f64 => ['opaque', 'sint64', 'sint64', 'opaque'] => 'sint64'],
    # How far corners are from those of rectangles: misfit[i] is the result of vesica_rect_corners_misfit_f64.
    [vesica_rect_corners_misfit_many_f64 => ['opaque', 'sint64', 'opaque', 'opaque'] => 'sint64'],
    # Boxes from rectangles or from ellipses: the inverse of the first two functions.
    [vesica_boxes_from_shapes_f64 => ['opaque', 'sint32', 'opaque'] => 'sint64'],
    # The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
    [vesica_corners_of_shapes_f64 => ['opaque', 'opaque'] => 'sint64'],
    # Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f64.
    [vesica_bounds_many_f64 => ['opaque', 'opaque'] => 'sint64'],
    # Areas of an array of any kind: out[i] is the result of vesica_shape_area_f64.
    [vesica_shape_area_many_f64 => ['opaque', 'opaque'] => 'sint64'],
    # The convex hull of points: the smallest convex polygon that contains them.
    [vesica_convex_hull_f64 => ['opaque', 'opaque', 'sint64'] => 'sint64'],
    # The rectangle of the least area that contains points.
    [vesica_min_area_rect_f64 => ['opaque', 'opaque'] => 'sint32'],
    # The rectangle of the least perimeter that contains points, else as vesica_min_area_rect_f64.
    [vesica_min_perimeter_rect_f64 => ['opaque', 'opaque'] => 'sint32'],
    # The rectangles of the least area about each polygon or polyline of an array.
    [vesica_min_area_rect_many_f64 => ['opaque', 'opaque'] => 'sint64'],
    # The rectangles of the least perimeter about each polygon or polyline of an array.
    [vesica_min_perimeter_rect_many_f64 => ['opaque', 'opaque'] => 'sint64'],
    # Rectangles from boxes.
    [vesica_rects_from_boxes_f32 => ['opaque', 'sint64', 'sint64', 'sint32', 'opaque'] => 'sint64'],
    # Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
    [vesica_ellipses_from_boxes_f32 => ['opaque', 'sint64', 'sint64', 'sint32', 'opaque'] => 'sint64'],
    # Rectangles from four corners each: out[i] is the result of vesica_rect_from_corners_f32.
    [vesica_rects_from_corners_f32 => ['opaque', 'sint64', 'sint64', 'opaque'] => 'sint64'],
    # How far corners are from those of rectangles: misfit[i] is the result of vesica_rect_corners_misfit_f32.
    [vesica_rect_corners_misfit_many_f32 => ['opaque', 'sint64', 'opaque', 'opaque'] => 'sint64'],
    # Boxes from rectangles or from ellipses: the inverse of the first two functions.
    [vesica_boxes_from_shapes_f32 => ['opaque', 'sint32', 'opaque'] => 'sint64'],
    # The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
    [vesica_corners_of_shapes_f32 => ['opaque', 'opaque'] => 'sint64'],
    # Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f32.
    [vesica_bounds_many_f32 => ['opaque', 'opaque'] => 'sint64'],
    # Areas of an array of any kind: out[i] is the result of vesica_shape_area_f32.
    [vesica_shape_area_many_f32 => ['opaque', 'opaque'] => 'sint64'],
    # The convex hull of points: the smallest convex polygon that contains them.
    [vesica_convex_hull_f32 => ['opaque', 'opaque', 'sint64'] => 'sint64'],
    # The rectangle of the least area that contains points.
    [vesica_min_area_rect_f32 => ['opaque', 'opaque'] => 'sint32'],
    # The rectangle of the least perimeter that contains points, else as vesica_min_area_rect_f32.
    [vesica_min_perimeter_rect_f32 => ['opaque', 'opaque'] => 'sint32'],
    # The rectangles of the least area about each polygon or polyline of an array.
    [vesica_min_area_rect_many_f32 => ['opaque', 'opaque'] => 'sint64'],
    # The rectangles of the least perimeter about each polygon or polyline of an array.
    [vesica_min_perimeter_rect_many_f32 => ['opaque', 'opaque'] => 'sint64'],
    # All pairs that overlap and whose ratio is at least `threshold`, with the ratio: a sparse matrix of IoU and the
    # like.
    [vesica_join_ratio_f64 => ['sint32', 'double', 'opaque', 'opaque', 'sint32', 'opaque', 'opaque', 'sint32', 'sint64',
        'sint64', 'opaque', 'sint64', 'opaque', 'opaque', 'opaque', 'sint64', 'opaque'] => 'sint64'],
    # How many bytes of scratch does greedy assignment of `count` pairs need?
    [vesica_assign_greedy_scratch => ['sint64', 'sint64', 'sint64'] => 'sint64'],
    # Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both
    # free, until there is none.
    [vesica_assign_greedy_f64 => ['opaque', 'opaque', 'opaque', 'sint64', 'sint64', 'sint64', 'opaque', 'sint64',
        'opaque'] => 'sint64'],
    # How many bytes of scratch does the fusion of `count` boxes need?
    [vesica_fuse_scratch => ['sint64'] => 'sint64'],
    # Weighted boxes fusion: boxes of one object, as several detectors or views find them, become their weighted
    # mean.
    [vesica_fuse_f64 => ['opaque', 'opaque', 'opaque', 'opaque', 'double', 'sint32', 'opaque', 'sint64', 'opaque',
        'opaque', 'opaque', 'opaque'] => 'sint32'],
    # A ratio of shared volume: IoU and its relatives of two upright prisms.
    [vesica_volume_ratio_f64 => ['sint32', 'sint32', 'double[]', 'opaque', 'sint32', 'double[]', 'opaque',
        'opaque'] => 'sint32'],
    # A ratio of shared volume of the prisms a[i] from spans_a[i] and b[i] from spans_b[i].
    [vesica_volume_ratio_many_f64 => ['sint32', 'opaque', 'opaque', 'opaque', 'opaque', 'opaque'] => 'sint64'],
    # A ratio of shared volume of every a[i] and b[j], in out[i * row_stride + j].
    [vesica_volume_ratio_matrix_f64 => ['sint32', 'opaque', 'opaque', 'opaque', 'opaque', 'opaque',
        'sint64'] => 'sint64'],
    # How many bytes of scratch does matching by `count` pairs need?
    [vesica_match_truths_scratch => ['sint64', 'sint64', 'sint64'] => 'sint64'],
    # Which detections hit a truth, at each of some thresholds?
    [vesica_match_truths_f64 => ['sint32', 'opaque', 'opaque', 'opaque', 'sint64', 'opaque', 'sint64', 'opaque',
        'sint64', 'opaque', 'sint64', 'opaque', 'sint64', 'opaque', 'opaque'] => 'sint32'],
    # How many bytes of scratch does the average precision of `count` detections need?
    [vesica_average_precision_scratch => ['sint64'] => 'sint64'],
    # Average precision (AP) of detections of one class.
    [vesica_average_precision_f64 => ['sint32', 'opaque', 'opaque', 'sint64', 'sint64', 'opaque', 'sint64',
        'opaque'] => 'sint32'],
    # The distance of two circles, boxes, rectangles or ellipses as Gaussian distributions.
    [vesica_gaussian_distance_f64 => ['sint32', 'sint32', 'double[]', 'sint32', 'double[]', 'opaque'] => 'sint32'],
    # The distance of a[i] and b[i]: out[i] is the result of vesica_gaussian_distance_f64.
    [vesica_gaussian_distance_many_f64 => ['sint32', 'opaque', 'opaque', 'opaque'] => 'sint64'],
    # The distance of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_gaussian_distance_f64.
    [vesica_gaussian_distance_matrix_f64 => ['sint32', 'opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # All pairs that overlap and whose ratio is at least `threshold`, with the ratio: a sparse matrix of IoU and the
    # like.
    [vesica_join_ratio_f32 => ['sint32', 'float', 'opaque', 'opaque', 'sint32', 'opaque', 'opaque', 'sint32', 'sint64',
        'sint64', 'opaque', 'sint64', 'opaque', 'opaque', 'opaque', 'sint64', 'opaque'] => 'sint64'],
    # Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both
    # free, until there is none.
    [vesica_assign_greedy_f32 => ['opaque', 'opaque', 'opaque', 'sint64', 'sint64', 'sint64', 'opaque', 'sint64',
        'opaque'] => 'sint64'],
    # Weighted boxes fusion: boxes of one object, as several detectors or views find them, become their weighted
    # mean.
    [vesica_fuse_f32 => ['opaque', 'opaque', 'opaque', 'opaque', 'float', 'sint32', 'opaque', 'sint64', 'opaque',
        'opaque', 'opaque', 'opaque'] => 'sint32'],
    # Which detections hit a truth, at each of some thresholds?
    [vesica_match_truths_f32 => ['sint32', 'opaque', 'opaque', 'opaque', 'sint64', 'opaque', 'sint64', 'opaque',
        'sint64', 'opaque', 'sint64', 'opaque', 'sint64', 'opaque', 'opaque'] => 'sint32'],
    # Average precision (AP) of detections of one class.
    [vesica_average_precision_f32 => ['sint32', 'opaque', 'opaque', 'sint64', 'sint64', 'opaque', 'sint64',
        'opaque'] => 'sint32'],
    # A ratio of shared volume: IoU and its relatives of two upright prisms.
    [vesica_volume_ratio_f32 => ['sint32', 'sint32', 'float[]', 'opaque', 'sint32', 'float[]', 'opaque',
        'opaque'] => 'sint32'],
    # A ratio of shared volume of the prisms a[i] from spans_a[i] and b[i] from spans_b[i].
    [vesica_volume_ratio_many_f32 => ['sint32', 'opaque', 'opaque', 'opaque', 'opaque', 'opaque'] => 'sint64'],
    # A ratio of shared volume of every a[i] and b[j], in out[i * row_stride + j].
    [vesica_volume_ratio_matrix_f32 => ['sint32', 'opaque', 'opaque', 'opaque', 'opaque', 'opaque',
        'sint64'] => 'sint64'],
    # The distance of two circles, boxes, rectangles or ellipses as Gaussian distributions.
    [vesica_gaussian_distance_f32 => ['sint32', 'sint32', 'float[]', 'sint32', 'float[]', 'opaque'] => 'sint32'],
    # The distance of a[i] and b[i]: out[i] is the result of vesica_gaussian_distance_f32.
    [vesica_gaussian_distance_many_f32 => ['sint32', 'opaque', 'opaque', 'opaque'] => 'sint64'],
    # The distance of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_gaussian_distance_f32.
    [vesica_gaussian_distance_matrix_f32 => ['sint32', 'opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # How many bytes suffice for an index of `count` shapes, of any kinds?
    [vesica_index_size => ['sint64'] => 'sint64'],
    # How many bytes of scratch does building an index of `count` shapes need?
    [vesica_index_scratch => ['sint64'] => 'sint64'],
    # How many bytes of scratch does a join need, whatever its indexes?
    [vesica_join_scratch => [] => 'sint64'],
    # Are these bytes an index that is safe to read?
    [vesica_index_check => ['opaque', 'sint64'] => 'sint32'],
    # How many bytes does a built index take?
    [vesica_index_bytes => ['opaque'] => 'sint64'],
    # How many shapes was an index built from?
    [vesica_index_count => ['opaque'] => 'sint64'],
    # A box around all valid shapes of an index.
    [vesica_index_bounds => ['opaque', 'opaque'] => 'sint32'],
    # The items of an index in spatial order: shapes near each other have nearby places in it.
    [vesica_index_order => ['opaque', 'opaque', 'sint64'] => 'sint64'],
    # Builds the index of some sets of shapes.
    [vesica_index_build_f64 => ['opaque', 'sint32', 'opaque', 'sint64', 'opaque', 'sint64'] => 'sint64'],
    # One part of a build by several threads, in five steps.
    [vesica_index_step_f64 => ['sint32', 'sint64', 'sint64', 'opaque', 'sint32', 'opaque', 'sint64', 'opaque',
        'sint64'] => 'sint64'],
    # Which items of an index does one shape overlap?
    [vesica_index_select_f64 => ['opaque', 'opaque', 'sint32', 'opaque', 'opaque', 'sint64', 'opaque'] => 'sint64'],
    # Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
    [vesica_join_f64 => ['sint32', 'opaque', 'opaque', 'sint32', 'opaque', 'opaque', 'sint32', 'sint64', 'sint64',
        'opaque', 'sint64', 'opaque', 'opaque', 'sint64', 'opaque'] => 'sint64'],
    # All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once: those
    # for which vesica_within_f64 is > 0.
    [vesica_join_within_f64 => ['opaque', 'opaque', 'sint32', 'opaque', 'opaque', 'sint32', 'double', 'sint64',
        'sint64', 'opaque', 'opaque', 'sint64', 'opaque'] => 'sint64'],
    # Which items of an index are nearest to one shape?
    [vesica_index_nearest_f64 => ['opaque', 'opaque', 'sint32', 'opaque', 'sint64', 'double', 'opaque',
        'opaque'] => 'sint64'],
    # Which items of index_b are nearest to each item of sets_a?
    [vesica_join_nearest_f64 => ['opaque', 'sint32', 'opaque', 'opaque', 'sint32', 'sint64', 'double', 'sint64',
        'sint64', 'opaque', 'opaque'] => 'sint64'],
    # How many bytes do the boxes of a polygon or a polyline take?
    [vesica_polygon_boxes_size => ['sint64'] => 'sint64'],
    # Makes boxes about the edges of a polygon or a polyline that is asked again and again, such as a coast or a
    # zone.
    [vesica_polygon_boxes_f64 => ['sint32', 'opaque', 'opaque', 'sint64'] => 'sint32'],
    # Does a path with boxes overlap another shape?
    [vesica_polygon_boxes_overlap_f64 => ['sint32', 'opaque', 'opaque', 'sint64', 'sint32', 'double[]'] => 'sint32'],
    # The distance of a path with boxes and another shape, and where it is.
    [vesica_polygon_boxes_nearest_f64 => ['sint32', 'opaque', 'opaque', 'sint64', 'sint32', 'double[]',
        'opaque'] => 'sint32'],
    # Are a path with boxes and another shape at most a distance apart?
    [vesica_polygon_boxes_within_f64 => ['sint32', 'opaque', 'opaque', 'sint64', 'sint32', 'double[]',
        'double'] => 'sint32'],
    # Builds the index of some sets of shapes.
    [vesica_index_build_f32 => ['opaque', 'sint32', 'opaque', 'sint64', 'opaque', 'sint64'] => 'sint64'],
    # One part of a build by several threads, in five steps.
    [vesica_index_step_f32 => ['sint32', 'sint64', 'sint64', 'opaque', 'sint32', 'opaque', 'sint64', 'opaque',
        'sint64'] => 'sint64'],
    # Which items of an index does one shape overlap?
    [vesica_index_select_f32 => ['opaque', 'opaque', 'sint32', 'opaque', 'opaque', 'sint64', 'opaque'] => 'sint64'],
    # Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
    [vesica_join_f32 => ['sint32', 'opaque', 'opaque', 'sint32', 'opaque', 'opaque', 'sint32', 'sint64', 'sint64',
        'opaque', 'sint64', 'opaque', 'opaque', 'sint64', 'opaque'] => 'sint64'],
    # All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once: those
    # for which vesica_within_f32 is > 0.
    [vesica_join_within_f32 => ['opaque', 'opaque', 'sint32', 'opaque', 'opaque', 'sint32', 'float', 'sint64', 'sint64',
        'opaque', 'opaque', 'sint64', 'opaque'] => 'sint64'],
    # Which items of an index are nearest to one shape?
    [vesica_index_nearest_f32 => ['opaque', 'opaque', 'sint32', 'opaque', 'sint64', 'float', 'opaque',
        'opaque'] => 'sint64'],
    # Which items of index_b are nearest to each item of sets_a?
    [vesica_join_nearest_f32 => ['opaque', 'sint32', 'opaque', 'opaque', 'sint32', 'sint64', 'float', 'sint64',
        'sint64', 'opaque', 'opaque'] => 'sint64'],
    # Makes boxes about the edges of a polygon or a polyline that is asked again and again, such as a coast or a
    # zone.
    [vesica_polygon_boxes_f32 => ['sint32', 'opaque', 'opaque', 'sint64'] => 'sint32'],
    # Does a path with boxes overlap another shape?
    [vesica_polygon_boxes_overlap_f32 => ['sint32', 'opaque', 'opaque', 'sint64', 'sint32', 'float[]'] => 'sint32'],
    # The distance of a path with boxes and another shape, and where it is.
    [vesica_polygon_boxes_nearest_f32 => ['sint32', 'opaque', 'opaque', 'sint64', 'sint32', 'float[]',
        'opaque'] => 'sint32'],
    # Are a path with boxes and another shape at most a distance apart?
    [vesica_polygon_boxes_within_f32 => ['sint32', 'opaque', 'opaque', 'sint64', 'sint32', 'float[]',
        'float'] => 'sint32'],
    # A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
    [vesica_ratio_f64 => ['sint32', 'sint32', 'double[]', 'sint32', 'double[]', 'opaque'] => 'sint32'],
    # A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f64.
    [vesica_ratio_many_f64 => ['sint32', 'opaque', 'opaque', 'opaque'] => 'sint64'],
    # A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f64.
    [vesica_ratio_matrix_f64 => ['sint32', 'opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # How far apart are a[i] and b[j]?
    [vesica_nearest_matrix_f64 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # How far apart are the outlines of a[i] and b[j]?
    [vesica_boundary_distance_matrix_f64 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # How deep do a[i] and b[j] overlap?
    [vesica_depth_matrix_f64 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
    [vesica_signed_distance_f64 => ['sint32', 'double[]', 'sint32', 'double[]', 'opaque'] => 'sint32'],
    # Signed distances of a[i] and b[i].
    [vesica_signed_distance_many_f64 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # Signed distances of a[i] and b[j].
    [vesica_signed_distance_matrix_f64 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Are two shapes at most `distance` apart?
    [vesica_within_f64 => ['sint32', 'double[]', 'sint32', 'double[]', 'double'] => 'sint32'],
    # Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f64.
    [vesica_within_many_f64 => ['opaque', 'opaque', 'double', 'opaque'] => 'sint64'],
    # Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of vesica_within_f64.
    [vesica_within_matrix_f64 => ['opaque', 'opaque', 'double', 'opaque', 'sint64'] => 'sint64'],
    # Greedy non-maximum suppression as vesica_nms_f64, by any ratio, each label on its own.
    [vesica_suppress_f64 => ['opaque', 'opaque', 'opaque', 'sint32', 'double', 'double', 'sint64', 'opaque', 'sint64',
        'opaque', 'opaque'] => 'sint32'],
    # How many bytes of scratch does soft suppression of `count` shapes need?
    [vesica_suppress_soft_scratch => ['sint64'] => 'sint64'],
    # Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
    [vesica_suppress_soft_f64 => ['opaque', 'opaque', 'opaque', 'sint32', 'sint32', 'double', 'double', 'sint64',
        'opaque', 'sint64', 'opaque', 'opaque', 'opaque'] => 'sint32'],
    # The share of each cell that a shape covers: out[j * row_stride + i] is area covered / area of cell (i, j).
    [vesica_coverage_f64 => ['sint32', 'double[]', 'opaque', 'opaque', 'sint64'] => 'sint32'],
    # The cells of which a shape covers more than nothing, and their shares, as vesica_coverage_f64 has them.
    [vesica_coverage_cells_f64 => ['sint32', 'double[]', 'opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
    [vesica_ratio_f32 => ['sint32', 'sint32', 'float[]', 'sint32', 'float[]', 'opaque'] => 'sint32'],
    # A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f32.
    [vesica_ratio_many_f32 => ['sint32', 'opaque', 'opaque', 'opaque'] => 'sint64'],
    # A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f32.
    [vesica_ratio_matrix_f32 => ['sint32', 'opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # How far apart are a[i] and b[j]?
    [vesica_nearest_matrix_f32 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # How far apart are the outlines of a[i] and b[j]?
    [vesica_boundary_distance_matrix_f32 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # How deep do a[i] and b[j] overlap?
    [vesica_depth_matrix_f32 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Greedy non-maximum suppression as vesica_nms_f32, by any ratio, each label on its own.
    [vesica_suppress_f32 => ['opaque', 'opaque', 'opaque', 'sint32', 'float', 'float', 'sint64', 'opaque', 'sint64',
        'opaque', 'opaque'] => 'sint32'],
    # Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
    [vesica_signed_distance_f32 => ['sint32', 'float[]', 'sint32', 'float[]', 'opaque'] => 'sint32'],
    # Signed distances of a[i] and b[i].
    [vesica_signed_distance_many_f32 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # Signed distances of a[i] and b[j].
    [vesica_signed_distance_matrix_f32 => ['opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Are two shapes at most `distance` apart?
    [vesica_within_f32 => ['sint32', 'float[]', 'sint32', 'float[]', 'float'] => 'sint32'],
    # Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f32.
    [vesica_within_many_f32 => ['opaque', 'opaque', 'float', 'opaque'] => 'sint64'],
    # Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of vesica_within_f32.
    [vesica_within_matrix_f32 => ['opaque', 'opaque', 'float', 'opaque', 'sint64'] => 'sint64'],
    # Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
    [vesica_suppress_soft_f32 => ['opaque', 'opaque', 'opaque', 'sint32', 'sint32', 'float', 'float', 'sint64',
        'opaque', 'sint64', 'opaque', 'opaque', 'opaque'] => 'sint32'],
    # The share of each cell that a shape covers: out[j * row_stride + i] is area covered / area of cell (i, j).
    [vesica_coverage_f32 => ['sint32', 'float[]', 'opaque', 'opaque', 'sint64'] => 'sint32'],
    # The cells of which a shape covers more than nothing, and their shares, as vesica_coverage_f32 has them.
    [vesica_coverage_cells_f32 => ['sint32', 'float[]', 'opaque', 'opaque', 'opaque', 'sint64'] => 'sint64'],
    # Does b touch a while it moves, when first, and where?
    [vesica_cast_f64 => ['sint32', 'double[]', 'sint32', 'double[]', 'double', 'double', 'double',
        'opaque'] => 'sint32'],
    # When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]?
    [vesica_cast_many_f64 => ['opaque', 'opaque', 'opaque', 'opaque', 'sint64', 'double', 'opaque', 'opaque', 'opaque',
        'opaque', 'opaque'] => 'sint64'],
    # Which of many shapes at rest does one moving shape touch first?
    [vesica_cast_first_f64 => ['opaque', 'opaque', 'double', 'double', 'double', 'opaque'] => 'sint64'],
    # A box that holds a shape throughout its motion, t from 0 to t_end.
    [vesica_sweep_bounds_f64 => ['sint32', 'double[]', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # Which items of an index does one moving shape touch?
    [vesica_index_cast_f64 => ['opaque', 'opaque', 'sint32', 'opaque', 'double', 'double', 'double', 'opaque', 'sint64',
        'opaque'] => 'sint64'],
    # Which item of an index does one moving shape touch first?
    [vesica_index_cast_first_f64 => ['opaque', 'opaque', 'sint32', 'opaque', 'double', 'double', 'double',
        'opaque'] => 'sint64'],
    # When do two shapes that move and turn touch first?
    [vesica_impact_time_f64 => ['sint32', 'double[]', 'opaque', 'sint32', 'double[]', 'opaque', 'double', 'opaque',
        'opaque'] => 'sint32'],
    # Which item of an index does a shape that moves and turns touch first?
    [vesica_index_impact_time_f64 => ['opaque', 'opaque', 'sint32', 'opaque', 'opaque', 'double', 'opaque', 'opaque',
        'opaque'] => 'sint64'],
    # Contact manifold: where do two convex shapes press on each other, how deep, and along which normal?
    [vesica_manifold_f64 => ['sint32', 'double[]', 'sint32', 'double[]', 'opaque'] => 'sint32'],
    # The contacts of a[i] and b[i].
    [vesica_manifold_many_f64 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # A ray at a point.
    [vesica_cast_point_point_f64 => ['opaque', 'opaque', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # A ray at a segment.
    [vesica_cast_segment_point_f64 => ['opaque', 'opaque', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # A ray at a disc.
    [vesica_cast_circle_point_f64 => ['opaque', 'opaque', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # A ray at an axis-aligned box.
    [vesica_cast_aabb_point_f64 => ['opaque', 'opaque', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # A ray at a rectangle.
    [vesica_cast_rect_point_f64 => ['opaque', 'opaque', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # A ray at an ellipse.
    [vesica_cast_ellipse_point_f64 => ['opaque', 'opaque', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # Two discs.
    [vesica_cast_circle_circle_f64 => ['opaque', 'opaque', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # Two rectangles.
    [vesica_cast_rect_rect_f64 => ['opaque', 'opaque', 'double', 'double', 'double', 'opaque'] => 'sint32'],
    # Does b touch a while it moves, when first, and where?
    [vesica_cast_f32 => ['sint32', 'float[]', 'sint32', 'float[]', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]?
    [vesica_cast_many_f32 => ['opaque', 'opaque', 'opaque', 'opaque', 'sint64', 'float', 'opaque', 'opaque', 'opaque',
        'opaque', 'opaque'] => 'sint64'],
    # Which of many shapes at rest does one moving shape touch first?
    [vesica_cast_first_f32 => ['opaque', 'opaque', 'float', 'float', 'float', 'opaque'] => 'sint64'],
    # A box that holds a shape throughout its motion, t from 0 to t_end.
    [vesica_sweep_bounds_f32 => ['sint32', 'float[]', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # Which items of an index does one moving shape touch?
    [vesica_index_cast_f32 => ['opaque', 'opaque', 'sint32', 'opaque', 'float', 'float', 'float', 'opaque', 'sint64',
        'opaque'] => 'sint64'],
    # Which item of an index does one moving shape touch first?
    [vesica_index_cast_first_f32 => ['opaque', 'opaque', 'sint32', 'opaque', 'float', 'float', 'float',
        'opaque'] => 'sint64'],
    # As vesica_impact_time_f64.
    [vesica_impact_time_f32 => ['sint32', 'float[]', 'opaque', 'sint32', 'float[]', 'opaque', 'float', 'opaque',
        'opaque'] => 'sint32'],
    # Which item of an index does a shape that moves and turns touch first?
    [vesica_index_impact_time_f32 => ['opaque', 'opaque', 'sint32', 'opaque', 'opaque', 'float', 'opaque', 'opaque',
        'opaque'] => 'sint64'],
    # Contact manifold: where do two convex shapes press on each other, how deep, and along which normal?
    [vesica_manifold_f32 => ['sint32', 'float[]', 'sint32', 'float[]', 'opaque'] => 'sint32'],
    # The contacts of a[i] and b[i].
    [vesica_manifold_many_f32 => ['opaque', 'opaque', 'opaque'] => 'sint64'],
    # A ray at a point.
    [vesica_cast_point_point_f32 => ['opaque', 'opaque', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # A ray at a segment.
    [vesica_cast_segment_point_f32 => ['opaque', 'opaque', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # A ray at a disc.
    [vesica_cast_circle_point_f32 => ['opaque', 'opaque', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # A ray at an axis-aligned box.
    [vesica_cast_aabb_point_f32 => ['opaque', 'opaque', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # A ray at a rectangle.
    [vesica_cast_rect_point_f32 => ['opaque', 'opaque', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # A ray at an ellipse.
    [vesica_cast_ellipse_point_f32 => ['opaque', 'opaque', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # Two discs.
    [vesica_cast_circle_circle_f32 => ['opaque', 'opaque', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # Two rectangles.
    [vesica_cast_rect_rect_f32 => ['opaque', 'opaque', 'float', 'float', 'float', 'opaque'] => 'sint32'],
    # The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
    [vesica_de9im_f64 => ['sint32', 'double[]', 'sint32', 'double[]', 'opaque'] => 'sint32'],
    # Does a nine-intersection matrix match a pattern, such as "T*F**F***" for "a is within b"?
    [vesica_de9im_match => ['string', 'string'] => 'sint32'],
    # The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
    [vesica_intersection_f64 => ['sint32', 'double[]', 'sint32', 'double[]', 'opaque', 'sint64'] => 'sint64'],
    # The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
    [vesica_de9im_f32 => ['sint32', 'float[]', 'sint32', 'float[]', 'opaque'] => 'sint32'],
    # The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
    [vesica_intersection_f32 => ['sint32', 'float[]', 'sint32', 'float[]', 'opaque', 'sint64'] => 'sint64'],
);

1;
