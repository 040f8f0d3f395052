// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
// The constants, records and functions of libvesica. Arrays may be nil where the header says so.
unit vesica_c;

{$mode objfpc}{$H+}{$packrecords c}

interface

const
  vesica_library = 'vesica';
  vesica_declared_version_major = 0;
  vesica_declared_version_minor = 1;
  vesica_declared_version_patch = 0;
  vesica_declared_version = 100;
  vesica_point = 0;
  vesica_segment = 1;
  vesica_circle = 2;
  vesica_aabb = 3;
  vesica_rect = 4;
  vesica_ellipse = 5;
  vesica_capsule = 6;
  vesica_round_rect = 7;
  vesica_polygon = 8;
  vesica_polyline = 9;
  vesica_disjoint = 0;
  vesica_touch = 1;
  vesica_cross = 2;
  vesica_inside = 3;
  vesica_inside_touch = 4;
  vesica_contains = 5;
  vesica_contains_touch = 6;
  vesica_equal = 7;
  vesica_e_null = -1;
  vesica_e_shape = -2;
  vesica_e_kind = -3;
  vesica_e_argument = -4;
  vesica_e_not_finite = -5;
  vesica_e_negative_size = -6;
  vesica_e_zero_axis = -7;
  vesica_e_inverted = -8;
  vesica_e_range = -9;
  vesica_e_index = -10;
  vesica_e_rings = -11;
  vesica_e_not_simple = -12;
  vesica_e_not_convex = -13;
  vesica_angle_radians = 0;
  vesica_angle_degrees = 1;
  vesica_angle_quarters = 2;
  vesica_angle_reversed = 4;
  vesica_fused_mean = 0;
  vesica_fused_max = 1;
  vesica_match_voc = 0;
  vesica_match_coco = 1;
  vesica_truth_counts = 0;
  vesica_truth_crowd = 1;
  vesica_truth_ignored = 2;
  vesica_outcome_miss = 0;
  vesica_outcome_hit = 1;
  vesica_outcome_ignored = 2;
  vesica_precision_voc_2007 = 0;
  vesica_precision_voc_2010 = 1;
  vesica_precision_coco = 2;
  vesica_gaussian_bhattacharyya = 0;
  vesica_gaussian_hellinger = 1;
  vesica_gaussian_kullback_leibler = 2;
  vesica_gaussian_wasserstein = 3;
  vesica_join_overlap = 0;
  vesica_join_bounds = 1;
  vesica_join_contains = 2;
  vesica_join_inside = 3;
  vesica_join_interiors = 4;
  vesica_ratio_over_union = 0;
  vesica_ratio_over_first = 1;
  vesica_ratio_over_second = 2;
  vesica_ratio_over_smaller = 3;
  vesica_ratio_generalized = 4;
  vesica_ratio_distance = 5;
  vesica_ratio_complete = 6;
  vesica_within_no = 0;
  vesica_within_yes = 1;
  vesica_within_nearly = 2;
  vesica_decay_linear = 0;
  vesica_decay_gaussian = 1;
  vesica_cast_miss = 0;
  vesica_cast_hit = 1;
  vesica_cast_start = 2;
  vesica_cast_near = 3;
  vesica_de9im_size = 10;

type
  // A location.
  TVesicaPointF64 = record
    x: Double;
    y: Double;
  end;
  PVesicaPointF64 = ^TVesicaPointF64;
  // All points between two end points.
  TVesicaSegmentF64 = record
    x0: Double;
    y0: Double;
    x1: Double;
    y1: Double;
  end;
  PVesicaSegmentF64 = ^TVesicaSegmentF64;
  // A disc: centre and radius, r >= 0.
  TVesicaCircleF64 = record
    cx: Double;
    cy: Double;
    r: Double;
  end;
  PVesicaCircleF64 = ^TVesicaCircleF64;
  // A box along the coordinate axes, min_x <= max_x and min_y <= max_y.
  TVesicaAabbF64 = record
    min_x: Double;
    min_y: Double;
    max_x: Double;
    max_y: Double;
  end;
  PVesicaAabbF64 = ^TVesicaAabbF64;
  // All points C + s u + t perp(u) with |s| <= hx and |t| <= hy, where C is (cx, cy); hx, hy >= 0 and u != (0, 0).
  TVesicaRectF64 = record
    cx: Double;
    cy: Double;
    ux: Double;
    uy: Double;
    hx: Double;
    hy: Double;
  end;
  PVesicaRectF64 = ^TVesicaRectF64;
  // All points C + s u + t perp(u) with (s/a)^2 + (t/b)^2 <= 1, where C is (cx, cy); a, b >= 0 and u != (0, 0).
  TVesicaEllipseF64 = record
    cx: Double;
    cy: Double;
    ux: Double;
    uy: Double;
    a: Double;
    b: Double;
  end;
  PVesicaEllipseF64 = ^TVesicaEllipseF64;
  // All points at most r from the segment from (x0, y0) to (x1, y1), r >= 0.
  TVesicaCapsuleF64 = record
    x0: Double;
    y0: Double;
    x1: Double;
    y1: Double;
    r: Double;
  end;
  PVesicaCapsuleF64 = ^TVesicaCapsuleF64;
  // All points at most r >= 0 from the rectangle (cx, cy, ux, uy, hx, hy): one with round corners. hx and hy are the
  // rectangle's, in units of the axis, without the radius; r is in units of the coordinates.
  TVesicaRoundRectF64 = record
    cx: Double;
    cy: Double;
    ux: Double;
    uy: Double;
    hx: Double;
    hy: Double;
    r: Double;
  end;
  PVesicaRoundRectF64 = ^TVesicaRoundRectF64;
  // A polygon, or a polyline: vertices in the caller's memory, which are read and not kept.
  TVesicaPolygonF64 = record
    x: PDouble;
    y: PDouble;
    stride: PtrInt;
    rings: PInt32;
    count: Int64;
  end;
  PVesicaPolygonF64 = ^TVesicaPolygonF64;
  // A polyline.
  TVesicaPolylineF64 = record
    x: PDouble;
    y: PDouble;
    stride: PtrInt;
    rings: PInt32;
    count: Int64;
  end;
  PVesicaPolylineF64 = ^TVesicaPolylineF64;
  // Facts about a polygon, from vesica_polygon_facts_f64.
  TVesicaFactsF64 = record
    vertices: Int64;
    first_crossing: Int64;
    second_crossing: Int64;
    area: Double;
    orientation: Int32;
    convex: Int32;
    simple: Int32;
    rings: Int32;
  end;
  PVesicaFactsF64 = ^TVesicaFactsF64;
  // A distance, and two points that are that far apart: (ax, ay) of shape a and (bx, by) of shape b.
  TVesicaClosestPointsF64 = record
    distance: Double;
    ax: Double;
    ay: Double;
    bx: Double;
    by: Double;
  end;
  PVesicaClosestPointsF64 = ^TVesicaClosestPointsF64;
  // The shortest move of b that ends its overlap with a: its length, and its unit direction (x, y).
  TVesicaPenetrationF64 = record
    depth: Double;
    x: Double;
    y: Double;
  end;
  PVesicaPenetrationF64 = ^TVesicaPenetrationF64;
  // An array of shapes of one kind in any memory layout: records, packed or padded, or one column per number.
  TVesicaShapesF64 = record
    kind: Int32;
    reserved: Int32;
    count: Int64;
    stride: PtrInt;
    field: array[0..7] of PDouble;
    rings: PInt32;
    polygons: PInt32;
    each: Int64;
  end;
  PVesicaShapesF64 = ^TVesicaShapesF64;
  // A location.
  TVesicaPointF32 = record
    x: Single;
    y: Single;
  end;
  PVesicaPointF32 = ^TVesicaPointF32;
  // All points between two end points.
  TVesicaSegmentF32 = record
    x0: Single;
    y0: Single;
    x1: Single;
    y1: Single;
  end;
  PVesicaSegmentF32 = ^TVesicaSegmentF32;
  // A disc: centre and radius, r >= 0.
  TVesicaCircleF32 = record
    cx: Single;
    cy: Single;
    r: Single;
  end;
  PVesicaCircleF32 = ^TVesicaCircleF32;
  // A box along the coordinate axes, min_x <= max_x and min_y <= max_y.
  TVesicaAabbF32 = record
    min_x: Single;
    min_y: Single;
    max_x: Single;
    max_y: Single;
  end;
  PVesicaAabbF32 = ^TVesicaAabbF32;
  // All points C + s u + t perp(u) with |s| <= hx and |t| <= hy, where C is (cx, cy); hx, hy >= 0 and u != (0, 0).
  TVesicaRectF32 = record
    cx: Single;
    cy: Single;
    ux: Single;
    uy: Single;
    hx: Single;
    hy: Single;
  end;
  PVesicaRectF32 = ^TVesicaRectF32;
  // All points C + s u + t perp(u) with (s/a)^2 + (t/b)^2 <= 1, where C is (cx, cy); a, b >= 0 and u != (0, 0).
  TVesicaEllipseF32 = record
    cx: Single;
    cy: Single;
    ux: Single;
    uy: Single;
    a: Single;
    b: Single;
  end;
  PVesicaEllipseF32 = ^TVesicaEllipseF32;
  // All points at most r from the segment from (x0, y0) to (x1, y1), r >= 0.
  TVesicaCapsuleF32 = record
    x0: Single;
    y0: Single;
    x1: Single;
    y1: Single;
    r: Single;
  end;
  PVesicaCapsuleF32 = ^TVesicaCapsuleF32;
  // All points at most r >= 0 from the rectangle (cx, cy, ux, uy, hx, hy): one with round corners. hx and hy are the
  // rectangle's, in units of the axis, without the radius; r is in units of the coordinates.
  TVesicaRoundRectF32 = record
    cx: Single;
    cy: Single;
    ux: Single;
    uy: Single;
    hx: Single;
    hy: Single;
    r: Single;
  end;
  PVesicaRoundRectF32 = ^TVesicaRoundRectF32;
  // A polygon, or a polyline: vertices in the caller's memory, which are read and not kept.
  TVesicaPolygonF32 = record
    x: PSingle;
    y: PSingle;
    stride: PtrInt;
    rings: PInt32;
    count: Int64;
  end;
  PVesicaPolygonF32 = ^TVesicaPolygonF32;
  // A polyline.
  TVesicaPolylineF32 = record
    x: PSingle;
    y: PSingle;
    stride: PtrInt;
    rings: PInt32;
    count: Int64;
  end;
  PVesicaPolylineF32 = ^TVesicaPolylineF32;
  // Facts about a polygon, from vesica_polygon_facts_f32.
  TVesicaFactsF32 = record
    vertices: Int64;
    first_crossing: Int64;
    second_crossing: Int64;
    area: Single;
    orientation: Int32;
    convex: Int32;
    simple: Int32;
    rings: Int32;
  end;
  PVesicaFactsF32 = ^TVesicaFactsF32;
  // A distance, and two points that are that far apart: (ax, ay) of shape a and (bx, by) of shape b.
  TVesicaClosestPointsF32 = record
    distance: Single;
    ax: Single;
    ay: Single;
    bx: Single;
    by: Single;
  end;
  PVesicaClosestPointsF32 = ^TVesicaClosestPointsF32;
  // The shortest move of b that ends its overlap with a: its length, and its unit direction (x, y).
  TVesicaPenetrationF32 = record
    depth: Single;
    x: Single;
    y: Single;
  end;
  PVesicaPenetrationF32 = ^TVesicaPenetrationF32;
  // An array of shapes of one kind in any memory layout: records, packed or padded, or one column per number.
  TVesicaShapesF32 = record
    kind: Int32;
    reserved: Int32;
    count: Int64;
    stride: PtrInt;
    field: array[0..7] of PSingle;
    rings: PInt32;
    polygons: PInt32;
    each: Int64;
  end;
  PVesicaShapesF32 = ^TVesicaShapesF32;
  // All heights from low to high; low <= high, both finite.
  TVesicaSpanF64 = record
    low: Double;
    high: Double;
  end;
  PVesicaSpanF64 = ^TVesicaSpanF64;
  // All heights from low to high; low <= high, both finite.
  TVesicaSpanF32 = record
    low: Single;
    high: Single;
  end;
  PVesicaSpanF32 = ^TVesicaSpanF32;
  // A grid of cells, such as the pixels of a picture.
  TVesicaGridF64 = record
    x: Double;
    y: Double;
    dx: Double;
    dy: Double;
    columns: Int64;
    rows: Int64;
  end;
  PVesicaGridF64 = ^TVesicaGridF64;
  // A grid of cells, such as the pixels of a picture.
  TVesicaGridF32 = record
    x: Single;
    y: Single;
    dx: Single;
    dy: Single;
    columns: Int64;
    rows: Int64;
  end;
  PVesicaGridF32 = ^TVesicaGridF32;
  // A first contact: its time t, its point (x, y), and the unit normal (nx, ny) there, from a to b.
  TVesicaImpactF64 = record
    t: Double;
    x: Double;
    y: Double;
    nx: Double;
    ny: Double;
  end;
  PVesicaImpactF64 = ^TVesicaImpactF64;
  // How a shape moves while t runs from 0 to 1: the way (vx, vy) of its centre, and the angle in radians by which it
  // turns about its centre.
  TVesicaTurnF64 = record
    vx: Double;
    vy: Double;
    angle: Double;
  end;
  PVesicaTurnF64 = ^TVesicaTurnF64;
  // The contacts of two overlapping convex shapes: their count, 0 to 2, and one unit normal (nx, ny) from a to b.
  TVesicaContactsF64 = record
    nx: Double;
    ny: Double;
    x0: Double;
    y0: Double;
    depth0: Double;
    x1: Double;
    y1: Double;
    depth1: Double;
    a0: Int64;
    b0: Int64;
    a1: Int64;
    b1: Int64;
    count: Int64;
  end;
  PVesicaContactsF64 = ^TVesicaContactsF64;
  // A first contact: its time t, its point (x, y), and the unit normal (nx, ny) there, from a to b.
  TVesicaImpactF32 = record
    t: Single;
    x: Single;
    y: Single;
    nx: Single;
    ny: Single;
  end;
  PVesicaImpactF32 = ^TVesicaImpactF32;
  // How a shape moves while t runs from 0 to 1: the way (vx, vy) of its centre, and the angle in radians by which it
  // turns about its centre.
  TVesicaTurnF32 = record
    vx: Single;
    vy: Single;
    angle: Single;
  end;
  PVesicaTurnF32 = ^TVesicaTurnF32;
  // The contacts of two overlapping convex shapes: their count, 0 to 2, and one unit normal (nx, ny) from a to b.
  TVesicaContactsF32 = record
    nx: Single;
    ny: Single;
    x0: Single;
    y0: Single;
    depth0: Single;
    x1: Single;
    y1: Single;
    depth1: Single;
    a0: Int64;
    b0: Int64;
    a1: Int64;
    b1: Int64;
    count: Int64;
  end;
  PVesicaContactsF32 = ^TVesicaContactsF32;

// Do two shapes share a point?
function vesica_overlap_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer): Int32; cdecl; external
  vesica_library;
// Do the insides of two shapes share a point?
function vesica_interiors_overlap_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer): Int32; cdecl; external
  vesica_library;
// Does a contain all of b?
function vesica_contains_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer): Int32; cdecl; external
  vesica_library;
// How does a relate to b?
function vesica_relation_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer): Int32; cdecl; external
  vesica_library;
// How far apart are two solid shapes, and which of their points are closest?
function vesica_nearest_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PVesicaClosestPointsF64):
  Int32; cdecl; external vesica_library;
// Penetration depth: how far and which way must b be moved until the two shapes only touch?
function vesica_depth_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PVesicaPenetrationF64):
  Int32; cdecl; external vesica_library;
// Area of the intersection of two shapes.
function vesica_area_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PDouble): Int32; cdecl;
  external vesica_library;
// Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
function vesica_iou_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PDouble): Int32; cdecl;
  external vesica_library;
// Smallest box of representable numbers that contains a shape.
function vesica_bounds_f64(kind: Int32; shape: Pointer; output: PVesicaAabbF64): Int32; cdecl; external
  vesica_library;
// Is a shape valid, and if not, which rule does it break?
function vesica_check_f64(kind: Int32; shape: Pointer): Int32; cdecl; external vesica_library;
// The meaning of an error code, as one English phrase without a full stop.
function vesica_strerror(code: Int32): PChar; cdecl; external vesica_library;
// Where do the outlines of two shapes meet?
function vesica_crossings_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PVesicaPointF64;
  capacity: Int64; shared: PInt32): Int64; cdecl; external vesica_library;
// How far apart are the outlines of two shapes, and where do they come closest?
function vesica_boundary_distance_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output:
  PVesicaClosestPointsF64): Int32; cdecl; external vesica_library;
// Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment.
function vesica_shape_area_f64(kind: Int32; shape: Pointer; output: PDouble): Int32; cdecl; external vesica_library;
// States facts of a polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
function vesica_polygon_facts_f64(polygon: PVesicaPolygonF64; output: PVesicaFactsF64): Int32; cdecl; external
  vesica_library;
// Are the two points the same?
function vesica_overlap_point_point_f64(a: PVesicaPointF64; b: PVesicaPointF64): Int32; cdecl; external
  vesica_library;
// Does the point lie on the segment?
function vesica_overlap_point_segment_f64(a: PVesicaPointF64; b: PVesicaSegmentF64): Int32; cdecl; external
  vesica_library;
// Does the point lie in the disc or on its rim?
function vesica_overlap_point_circle_f64(a: PVesicaPointF64; b: PVesicaCircleF64): Int32; cdecl; external
  vesica_library;
// Does the point lie in the box or on its outline?
function vesica_overlap_point_aabb_f64(a: PVesicaPointF64; b: PVesicaAabbF64): Int32; cdecl; external
  vesica_library;
// Does the point lie in the rectangle or on its outline?
function vesica_overlap_point_rect_f64(a: PVesicaPointF64; b: PVesicaRectF64): Int32; cdecl; external
  vesica_library;
// Does the point lie in the ellipse or on its outline?
function vesica_overlap_point_ellipse_f64(a: PVesicaPointF64; b: PVesicaEllipseF64): Int32; cdecl; external
  vesica_library;
// Do the segments share a point?
function vesica_overlap_segment_segment_f64(a: PVesicaSegmentF64; b: PVesicaSegmentF64): Int32; cdecl; external
  vesica_library;
// Does the segment meet the disc?
function vesica_overlap_segment_circle_f64(a: PVesicaSegmentF64; b: PVesicaCircleF64): Int32; cdecl; external
  vesica_library;
// Does the segment meet the box?
function vesica_overlap_segment_aabb_f64(a: PVesicaSegmentF64; b: PVesicaAabbF64): Int32; cdecl; external
  vesica_library;
// Does the segment meet the rectangle?
function vesica_overlap_segment_rect_f64(a: PVesicaSegmentF64; b: PVesicaRectF64): Int32; cdecl; external
  vesica_library;
// Does the segment meet the ellipse?
function vesica_overlap_segment_ellipse_f64(a: PVesicaSegmentF64; b: PVesicaEllipseF64): Int32; cdecl; external
  vesica_library;
// Do the discs share a point?
function vesica_overlap_circle_circle_f64(a: PVesicaCircleF64; b: PVesicaCircleF64): Int32; cdecl; external
  vesica_library;
// Do the disc and the box share a point?
function vesica_overlap_circle_aabb_f64(a: PVesicaCircleF64; b: PVesicaAabbF64): Int32; cdecl; external
  vesica_library;
// Do the disc and the rectangle share a point?
function vesica_overlap_circle_rect_f64(a: PVesicaCircleF64; b: PVesicaRectF64): Int32; cdecl; external
  vesica_library;
// Do the disc and the ellipse share a point?
function vesica_overlap_circle_ellipse_f64(a: PVesicaCircleF64; b: PVesicaEllipseF64): Int32; cdecl; external
  vesica_library;
// Do the boxes share a point?
function vesica_overlap_aabb_aabb_f64(a: PVesicaAabbF64; b: PVesicaAabbF64): Int32; cdecl; external vesica_library;
// Do the box and the rectangle share a point?
function vesica_overlap_aabb_rect_f64(a: PVesicaAabbF64; b: PVesicaRectF64): Int32; cdecl; external vesica_library;
// Do the box and the ellipse share a point?
function vesica_overlap_aabb_ellipse_f64(a: PVesicaAabbF64; b: PVesicaEllipseF64): Int32; cdecl; external
  vesica_library;
// Do the rectangles share a point?
function vesica_overlap_rect_rect_f64(a: PVesicaRectF64; b: PVesicaRectF64): Int32; cdecl; external vesica_library;
// Do the rectangle and the ellipse share a point?
function vesica_overlap_rect_ellipse_f64(a: PVesicaRectF64; b: PVesicaEllipseF64): Int32; cdecl; external
  vesica_library;
// Do the ellipses share a point?
function vesica_overlap_ellipse_ellipse_f64(a: PVesicaEllipseF64; b: PVesicaEllipseF64): Int32; cdecl; external
  vesica_library;
// Box with two opposite corners, in any order.
function vesica_aabb_from_corners_f64(x0: Double; y0: Double; x1: Double; y1: Double; output: PVesicaAabbF64):
  Int32; cdecl; external vesica_library;
// Rectangle from centre, angle and full size: width along the angle, height across it.
function vesica_rect_from_angle_f64(cx: Double; cy: Double; angle: Double; width: Double; height: Double; output:
  PVesicaRectF64): Int32; cdecl; external vesica_library;
// Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
function vesica_rect_from_corners_f64(corners: PDouble; output: PVesicaRectF64): Int32; cdecl; external
  vesica_library;
// The largest distance from a given corner to the rectangle's corner that corresponds to it.
function vesica_rect_corners_misfit_f64(corners: PDouble; r: PVesicaRectF64; misfit: PDouble): Int32; cdecl;
  external vesica_library;
// Rounded rectangle from centre, angle and full size, its round corners included: width along the angle, height
// across.
function vesica_round_rect_from_angle_f64(cx: Double; cy: Double; angle: Double; width: Double; height: Double;
  radius: Double; output: PVesicaRoundRectF64): Int32; cdecl; external vesica_library;
// Capsule from centre, angle, the length between the ends of its segment, and radius.
function vesica_capsule_from_angle_f64(cx: Double; cy: Double; angle: Double; length: Double; radius: Double;
  output: PVesicaCapsuleF64): Int32; cdecl; external vesica_library;
// Capsule from the ends of its segment and its full width, twice the radius: a line of that width with round ends.
function vesica_capsule_from_width_f64(x0: Double; y0: Double; x1: Double; y1: Double; width: Double; output:
  PVesicaCapsuleF64): Int32; cdecl; external vesica_library;
// Ellipse from centre, angle and half lengths: a along the angle, b across it.
function vesica_ellipse_from_angle_f64(cx: Double; cy: Double; angle: Double; a: Double; b: Double; output:
  PVesicaEllipseF64): Int32; cdecl; external vesica_library;
// Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx, wy).
function vesica_ellipse_from_radius_vector_f64(cx: Double; cy: Double; wx: Double; wy: Double; ratio: Double;
  output: PVesicaEllipseF64): Int32; cdecl; external vesica_library;
// Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
function vesica_ellipse_from_covariance_f64(mean_x: Double; mean_y: Double; cxx: Double; cxy: Double; cyy: Double;
  k: Double; output: PVesicaEllipseF64): Int32; cdecl; external vesica_library;
// Ellipse of the points X with (X - C) .
function vesica_ellipse_from_matrix_f64(cx: Double; cy: Double; mxx: Double; mxy: Double; myy: Double; output:
  PVesicaEllipseF64): Int32; cdecl; external vesica_library;
// Describes an array of `count` records.
function vesica_shapes_from_records_f64(kind: Int32; count: Int64; base: Pointer; stride: PtrInt; output:
  PVesicaShapesF64): Int32; cdecl; external vesica_library;
// Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f64.
function vesica_overlap_many_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PByte): Int64; cdecl; external
  vesica_library;
// Do the insides of a[i] and b[i] share a point? out[i] is the answer of vesica_interiors_overlap_f64.
function vesica_interiors_overlap_many_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PByte): Int64; cdecl;
  external vesica_library;
// How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f64.
function vesica_relation_many_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PByte): Int64; cdecl; external
  vesica_library;
// Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f64.
function vesica_contains_many_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PByte): Int64; cdecl; external
  vesica_library;
// How far apart are a[i] and b[i], and where?
function vesica_nearest_many_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; distance: PDouble; ax: PDouble; ay:
  PDouble; bx: PDouble; by: PDouble): Int64; cdecl; external vesica_library;
// How far apart are the outlines of a[i] and b[i]?
function vesica_boundary_distance_many_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; distance: PDouble; ax: PDouble;
  ay: PDouble; bx: PDouble; by: PDouble): Int64; cdecl; external vesica_library;
// How deep do a[i] and b[i] overlap?
function vesica_depth_many_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; depth: PDouble; x: PDouble; y: PDouble):
  Int64; cdecl; external vesica_library;
// The area that a[i] and b[i] share: out[i] is the result of vesica_area_f64.
function vesica_area_many_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PDouble): Int64; cdecl; external
  vesica_library;
// Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f64.
function vesica_iou_many_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PDouble): Int64; cdecl; external
  vesica_library;
// Do a[i] and b[j] share a point?
function vesica_overlap_matrix_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PByte; row_stride: PtrInt):
  Int64; cdecl; external vesica_library;
// Do the insides of a[i] and b[j] share a point?
function vesica_interiors_overlap_matrix_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PByte; row_stride:
  PtrInt): Int64; cdecl; external vesica_library;
// How does a[i] relate to b[j]?
function vesica_relation_matrix_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PByte; row_stride: PtrInt):
  Int64; cdecl; external vesica_library;
// Does a[i] contain all of b[j]?
function vesica_contains_matrix_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PByte; row_stride: PtrInt):
  Int64; cdecl; external vesica_library;
// The area that a[i] and b[j] share.
function vesica_area_matrix_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PDouble; row_stride: PtrInt):
  Int64; cdecl; external vesica_library;
// Intersection over union of a[i] and b[j].
function vesica_iou_matrix_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PDouble; row_stride: PtrInt):
  Int64; cdecl; external vesica_library;
// Which of many shapes overlap one?
function vesica_overlap_select_f64(one: PVesicaShapesF64; many: PVesicaShapesF64; output: PInt64; capacity: Int64):
  Int64; cdecl; external vesica_library;
// Which of many shapes share a point of their insides with that of one?
function vesica_interiors_overlap_select_f64(one: PVesicaShapesF64; many: PVesicaShapesF64; output: PInt64;
  capacity: Int64): Int64; cdecl; external vesica_library;
// How many bytes of scratch do vesica_nms_f64, vesica_suppress_f64 and their float forms need for `count` shapes?
function vesica_nms_scratch(count: Int64): Int64; cdecl; external vesica_library;
// Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one whose
// vesica_iou_f64 with every shape kept before is at most the threshold.
function vesica_nms_f64(shapes: PVesicaShapesF64; scores: PDouble; threshold: Double; scratch: Pointer;
  scratch_size: Int64; keep: PInt64; kept: PInt64): Int32; cdecl; external vesica_library;
// Version of the loaded library.
function vesica_version: Int32; cdecl; external vesica_library;
// VESICA_VERSION_MAJOR of the loaded library.
function vesica_version_major: Int32; cdecl; external vesica_library;
// VESICA_VERSION_MINOR of the loaded library.
function vesica_version_minor: Int32; cdecl; external vesica_library;
// VESICA_VERSION_PATCH of the loaded library.
function vesica_version_patch: Int32; cdecl; external vesica_library;
// How many numbers does a shape of this kind have?
function vesica_field_count(kind: Int32): Int32; cdecl; external vesica_library;
// Name of a kind.
function vesica_kind_name(kind: Int32): PChar; cdecl; external vesica_library;
// Name of the instruction set that batches use: the best one of this processor.
function vesica_isa_name: PChar; cdecl; external vesica_library;
// Is a shape valid, and if not, which rule does it break?
function vesica_check_f32(kind: Int32; shape: Pointer): Int32; cdecl; external vesica_library;
// Do two shapes share a point?
function vesica_overlap_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer): Int32; cdecl; external
  vesica_library;
// Do the insides of two shapes share a point?
function vesica_interiors_overlap_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer): Int32; cdecl; external
  vesica_library;
// How does a relate to b?
function vesica_relation_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer): Int32; cdecl; external
  vesica_library;
// Does a contain all of b?
function vesica_contains_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer): Int32; cdecl; external
  vesica_library;
// Where do the outlines of two shapes meet?
function vesica_crossings_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PVesicaPointF32;
  capacity: Int64; shared: PInt32): Int64; cdecl; external vesica_library;
// How far apart are two solid shapes, and which of their points are closest?
function vesica_nearest_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PVesicaClosestPointsF32):
  Int32; cdecl; external vesica_library;
// How far apart are the outlines of two shapes, and where do they come closest?
function vesica_boundary_distance_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output:
  PVesicaClosestPointsF32): Int32; cdecl; external vesica_library;
// Penetration depth: how far and which way must b be moved until the two shapes only touch?
function vesica_depth_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PVesicaPenetrationF32):
  Int32; cdecl; external vesica_library;
// Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment.
function vesica_shape_area_f32(kind: Int32; shape: Pointer; output: PSingle): Int32; cdecl; external vesica_library;
// States facts of a polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
function vesica_polygon_facts_f32(polygon: PVesicaPolygonF32; output: PVesicaFactsF32): Int32; cdecl; external
  vesica_library;
// Area of the intersection of two shapes.
function vesica_area_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PSingle): Int32; cdecl;
  external vesica_library;
// Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
function vesica_iou_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PSingle): Int32; cdecl;
  external vesica_library;
// Smallest box of representable numbers that contains a shape.
function vesica_bounds_f32(kind: Int32; shape: Pointer; output: PVesicaAabbF32): Int32; cdecl; external
  vesica_library;
// Are the two points the same?
function vesica_overlap_point_point_f32(a: PVesicaPointF32; b: PVesicaPointF32): Int32; cdecl; external
  vesica_library;
// Does the point lie on the segment?
function vesica_overlap_point_segment_f32(a: PVesicaPointF32; b: PVesicaSegmentF32): Int32; cdecl; external
  vesica_library;
// Does the point lie in the disc or on its rim?
function vesica_overlap_point_circle_f32(a: PVesicaPointF32; b: PVesicaCircleF32): Int32; cdecl; external
  vesica_library;
// Does the point lie in the box or on its outline?
function vesica_overlap_point_aabb_f32(a: PVesicaPointF32; b: PVesicaAabbF32): Int32; cdecl; external
  vesica_library;
// Does the point lie in the rectangle or on its outline?
function vesica_overlap_point_rect_f32(a: PVesicaPointF32; b: PVesicaRectF32): Int32; cdecl; external
  vesica_library;
// Does the point lie in the ellipse or on its outline?
function vesica_overlap_point_ellipse_f32(a: PVesicaPointF32; b: PVesicaEllipseF32): Int32; cdecl; external
  vesica_library;
// Do the segments share a point?
function vesica_overlap_segment_segment_f32(a: PVesicaSegmentF32; b: PVesicaSegmentF32): Int32; cdecl; external
  vesica_library;
// Does the segment meet the disc?
function vesica_overlap_segment_circle_f32(a: PVesicaSegmentF32; b: PVesicaCircleF32): Int32; cdecl; external
  vesica_library;
// Does the segment meet the box?
function vesica_overlap_segment_aabb_f32(a: PVesicaSegmentF32; b: PVesicaAabbF32): Int32; cdecl; external
  vesica_library;
// Does the segment meet the rectangle?
function vesica_overlap_segment_rect_f32(a: PVesicaSegmentF32; b: PVesicaRectF32): Int32; cdecl; external
  vesica_library;
// Does the segment meet the ellipse?
function vesica_overlap_segment_ellipse_f32(a: PVesicaSegmentF32; b: PVesicaEllipseF32): Int32; cdecl; external
  vesica_library;
// Do the discs share a point?
function vesica_overlap_circle_circle_f32(a: PVesicaCircleF32; b: PVesicaCircleF32): Int32; cdecl; external
  vesica_library;
// Do the disc and the box share a point?
function vesica_overlap_circle_aabb_f32(a: PVesicaCircleF32; b: PVesicaAabbF32): Int32; cdecl; external
  vesica_library;
// Do the disc and the rectangle share a point?
function vesica_overlap_circle_rect_f32(a: PVesicaCircleF32; b: PVesicaRectF32): Int32; cdecl; external
  vesica_library;
// Do the disc and the ellipse share a point?
function vesica_overlap_circle_ellipse_f32(a: PVesicaCircleF32; b: PVesicaEllipseF32): Int32; cdecl; external
  vesica_library;
// Do the boxes share a point?
function vesica_overlap_aabb_aabb_f32(a: PVesicaAabbF32; b: PVesicaAabbF32): Int32; cdecl; external vesica_library;
// Do the box and the rectangle share a point?
function vesica_overlap_aabb_rect_f32(a: PVesicaAabbF32; b: PVesicaRectF32): Int32; cdecl; external vesica_library;
// Do the box and the ellipse share a point?
function vesica_overlap_aabb_ellipse_f32(a: PVesicaAabbF32; b: PVesicaEllipseF32): Int32; cdecl; external
  vesica_library;
// Do the rectangles share a point?
function vesica_overlap_rect_rect_f32(a: PVesicaRectF32; b: PVesicaRectF32): Int32; cdecl; external vesica_library;
// Do the rectangle and the ellipse share a point?
function vesica_overlap_rect_ellipse_f32(a: PVesicaRectF32; b: PVesicaEllipseF32): Int32; cdecl; external
  vesica_library;
// Do the ellipses share a point?
function vesica_overlap_ellipse_ellipse_f32(a: PVesicaEllipseF32; b: PVesicaEllipseF32): Int32; cdecl; external
  vesica_library;
// Box with two opposite corners, in any order.
function vesica_aabb_from_corners_f32(x0: Single; y0: Single; x1: Single; y1: Single; output: PVesicaAabbF32):
  Int32; cdecl; external vesica_library;
// Rectangle from centre, angle and full size: width along the angle, height across it.
function vesica_rect_from_angle_f32(cx: Single; cy: Single; angle: Single; width: Single; height: Single; output:
  PVesicaRectF32): Int32; cdecl; external vesica_library;
// Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
function vesica_rect_from_corners_f32(corners: PSingle; output: PVesicaRectF32): Int32; cdecl; external
  vesica_library;
// The largest distance from a given corner to the rectangle's corner that corresponds to it.
function vesica_rect_corners_misfit_f32(corners: PSingle; r: PVesicaRectF32; misfit: PSingle): Int32; cdecl;
  external vesica_library;
// Rounded rectangle from centre, angle and full size, its round corners included: width along the angle, height
// across.
function vesica_round_rect_from_angle_f32(cx: Single; cy: Single; angle: Single; width: Single; height: Single;
  radius: Single; output: PVesicaRoundRectF32): Int32; cdecl; external vesica_library;
// Capsule from centre, angle, the length between the ends of its segment, and radius.
function vesica_capsule_from_angle_f32(cx: Single; cy: Single; angle: Single; length: Single; radius: Single;
  output: PVesicaCapsuleF32): Int32; cdecl; external vesica_library;
// Capsule from the ends of its segment and its full width, twice the radius: a line of that width with round ends.
function vesica_capsule_from_width_f32(x0: Single; y0: Single; x1: Single; y1: Single; width: Single; output:
  PVesicaCapsuleF32): Int32; cdecl; external vesica_library;
// Ellipse from centre, angle and half lengths: a along the angle, b across it.
function vesica_ellipse_from_angle_f32(cx: Single; cy: Single; angle: Single; a: Single; b: Single; output:
  PVesicaEllipseF32): Int32; cdecl; external vesica_library;
// Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx, wy).
function vesica_ellipse_from_radius_vector_f32(cx: Single; cy: Single; wx: Single; wy: Single; ratio: Single;
  output: PVesicaEllipseF32): Int32; cdecl; external vesica_library;
// Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
function vesica_ellipse_from_covariance_f32(mean_x: Single; mean_y: Single; cxx: Single; cxy: Single; cyy: Single;
  k: Single; output: PVesicaEllipseF32): Int32; cdecl; external vesica_library;
// Ellipse of the points X with (X - C) .
function vesica_ellipse_from_matrix_f32(cx: Single; cy: Single; mxx: Single; mxy: Single; myy: Single; output:
  PVesicaEllipseF32): Int32; cdecl; external vesica_library;
// Describes an array of `count` records.
function vesica_shapes_from_records_f32(kind: Int32; count: Int64; base: Pointer; stride: PtrInt; output:
  PVesicaShapesF32): Int32; cdecl; external vesica_library;
// Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f32.
function vesica_overlap_many_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PByte): Int64; cdecl; external
  vesica_library;
// Do the insides of a[i] and b[i] share a point? out[i] is the answer of vesica_interiors_overlap_f32.
function vesica_interiors_overlap_many_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PByte): Int64; cdecl;
  external vesica_library;
// How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f32.
function vesica_relation_many_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PByte): Int64; cdecl; external
  vesica_library;
// Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f32.
function vesica_contains_many_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PByte): Int64; cdecl; external
  vesica_library;
// How far apart are a[i] and b[i], and where?
function vesica_nearest_many_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; distance: PSingle; ax: PSingle; ay:
  PSingle; bx: PSingle; by: PSingle): Int64; cdecl; external vesica_library;
// How far apart are the outlines of a[i] and b[i]?
function vesica_boundary_distance_many_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; distance: PSingle; ax: PSingle;
  ay: PSingle; bx: PSingle; by: PSingle): Int64; cdecl; external vesica_library;
// How deep do a[i] and b[i] overlap?
function vesica_depth_many_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; depth: PSingle; x: PSingle; y: PSingle):
  Int64; cdecl; external vesica_library;
// The area that a[i] and b[i] share: out[i] is the result of vesica_area_f32.
function vesica_area_many_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PSingle): Int64; cdecl; external
  vesica_library;
// Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f32.
function vesica_iou_many_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PSingle): Int64; cdecl; external
  vesica_library;
// Do a[i] and b[j] share a point?
function vesica_overlap_matrix_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PByte; row_stride: PtrInt):
  Int64; cdecl; external vesica_library;
// Do the insides of a[i] and b[j] share a point?
function vesica_interiors_overlap_matrix_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PByte; row_stride:
  PtrInt): Int64; cdecl; external vesica_library;
// How does a[i] relate to b[j]?
function vesica_relation_matrix_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PByte; row_stride: PtrInt):
  Int64; cdecl; external vesica_library;
// Does a[i] contain all of b[j]?
function vesica_contains_matrix_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PByte; row_stride: PtrInt):
  Int64; cdecl; external vesica_library;
// The area that a[i] and b[j] share.
function vesica_area_matrix_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PSingle; row_stride: PtrInt):
  Int64; cdecl; external vesica_library;
// Intersection over union of a[i] and b[j].
function vesica_iou_matrix_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PSingle; row_stride: PtrInt):
  Int64; cdecl; external vesica_library;
// Which of many shapes overlap one?
function vesica_overlap_select_f32(one: PVesicaShapesF32; many: PVesicaShapesF32; output: PInt64; capacity: Int64):
  Int64; cdecl; external vesica_library;
// Which of many shapes share a point of their insides with that of one?
function vesica_interiors_overlap_select_f32(one: PVesicaShapesF32; many: PVesicaShapesF32; output: PInt64;
  capacity: Int64): Int64; cdecl; external vesica_library;
// Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one whose
// vesica_iou_f32 with every shape kept before is at most the threshold.
function vesica_nms_f32(shapes: PVesicaShapesF32; scores: PSingle; threshold: Single; scratch: Pointer;
  scratch_size: Int64; keep: PInt64; kept: PInt64): Int32; cdecl; external vesica_library;
// Rectangles from boxes.
function vesica_rects_from_boxes_f64(boxes: PDouble; count: Int64; stride: PtrInt; angle: Int32; output:
  PVesicaRectF64): Int64; cdecl; external vesica_library;
// Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
function vesica_ellipses_from_boxes_f64(boxes: PDouble; count: Int64; stride: PtrInt; angle: Int32; output:
  PVesicaEllipseF64): Int64; cdecl; external vesica_library;
// Rectangles from four corners each: out[i] is the result of vesica_rect_from_corners_f64.
function vesica_rects_from_corners_f64(corners: PDouble; count: Int64; stride: PtrInt; output: PVesicaRectF64):
  Int64; cdecl; external vesica_library;
// How far corners are from those of rectangles: misfit[i] is the result of vesica_rect_corners_misfit_f64.
function vesica_rect_corners_misfit_many_f64(corners: PDouble; stride: PtrInt; rects: PVesicaShapesF64; misfit:
  PDouble): Int64; cdecl; external vesica_library;
// Boxes from rectangles or from ellipses: the inverse of the first two functions.
function vesica_boxes_from_shapes_f64(shapes: PVesicaShapesF64; angle: Int32; boxes: PDouble): Int64; cdecl;
  external vesica_library;
// The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
function vesica_corners_of_shapes_f64(shapes: PVesicaShapesF64; corners: PDouble): Int64; cdecl; external
  vesica_library;
// Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f64.
function vesica_bounds_many_f64(shapes: PVesicaShapesF64; output: PVesicaAabbF64): Int64; cdecl; external
  vesica_library;
// Areas of an array of any kind: out[i] is the result of vesica_shape_area_f64.
function vesica_shape_area_many_f64(shapes: PVesicaShapesF64; output: PDouble): Int64; cdecl; external
  vesica_library;
// The convex hull of points: the smallest convex polygon that contains them.
function vesica_convex_hull_f64(points: PVesicaPolygonF64; output: PVesicaPointF64; capacity: Int64): Int64; cdecl;
  external vesica_library;
// The rectangle of the least area that contains points.
function vesica_min_area_rect_f64(points: PVesicaPolygonF64; output: PVesicaRectF64): Int32; cdecl; external
  vesica_library;
// The rectangle of the least perimeter that contains points, else as vesica_min_area_rect_f64.
function vesica_min_perimeter_rect_f64(points: PVesicaPolygonF64; output: PVesicaRectF64): Int32; cdecl; external
  vesica_library;
// The rectangles of the least area about each polygon or polyline of an array.
function vesica_min_area_rect_many_f64(points: PVesicaShapesF64; output: PVesicaRectF64): Int64; cdecl; external
  vesica_library;
// The rectangles of the least perimeter about each polygon or polyline of an array.
function vesica_min_perimeter_rect_many_f64(points: PVesicaShapesF64; output: PVesicaRectF64): Int64; cdecl;
  external vesica_library;
// Rectangles from boxes.
function vesica_rects_from_boxes_f32(boxes: PSingle; count: Int64; stride: PtrInt; angle: Int32; output:
  PVesicaRectF32): Int64; cdecl; external vesica_library;
// Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
function vesica_ellipses_from_boxes_f32(boxes: PSingle; count: Int64; stride: PtrInt; angle: Int32; output:
  PVesicaEllipseF32): Int64; cdecl; external vesica_library;
// Rectangles from four corners each: out[i] is the result of vesica_rect_from_corners_f32.
function vesica_rects_from_corners_f32(corners: PSingle; count: Int64; stride: PtrInt; output: PVesicaRectF32):
  Int64; cdecl; external vesica_library;
// How far corners are from those of rectangles: misfit[i] is the result of vesica_rect_corners_misfit_f32.
function vesica_rect_corners_misfit_many_f32(corners: PSingle; stride: PtrInt; rects: PVesicaShapesF32; misfit:
  PSingle): Int64; cdecl; external vesica_library;
// Boxes from rectangles or from ellipses: the inverse of the first two functions.
function vesica_boxes_from_shapes_f32(shapes: PVesicaShapesF32; angle: Int32; boxes: PSingle): Int64; cdecl;
  external vesica_library;
// The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
function vesica_corners_of_shapes_f32(shapes: PVesicaShapesF32; corners: PSingle): Int64; cdecl; external
  vesica_library;
// Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f32.
function vesica_bounds_many_f32(shapes: PVesicaShapesF32; output: PVesicaAabbF32): Int64; cdecl; external
  vesica_library;
// Areas of an array of any kind: out[i] is the result of vesica_shape_area_f32.
function vesica_shape_area_many_f32(shapes: PVesicaShapesF32; output: PSingle): Int64; cdecl; external
  vesica_library;
// The convex hull of points: the smallest convex polygon that contains them.
function vesica_convex_hull_f32(points: PVesicaPolygonF32; output: PVesicaPointF32; capacity: Int64): Int64; cdecl;
  external vesica_library;
// The rectangle of the least area that contains points.
function vesica_min_area_rect_f32(points: PVesicaPolygonF32; output: PVesicaRectF32): Int32; cdecl; external
  vesica_library;
// The rectangle of the least perimeter that contains points, else as vesica_min_area_rect_f32.
function vesica_min_perimeter_rect_f32(points: PVesicaPolygonF32; output: PVesicaRectF32): Int32; cdecl; external
  vesica_library;
// The rectangles of the least area about each polygon or polyline of an array.
function vesica_min_area_rect_many_f32(points: PVesicaShapesF32; output: PVesicaRectF32): Int64; cdecl; external
  vesica_library;
// The rectangles of the least perimeter about each polygon or polyline of an array.
function vesica_min_perimeter_rect_many_f32(points: PVesicaShapesF32; output: PVesicaRectF32): Int64; cdecl;
  external vesica_library;
// All pairs that overlap and whose ratio is at least `threshold`, with the ratio: a sparse matrix of IoU and the
// like.
function vesica_join_ratio_f64(ratio: Int32; threshold: Double; index_a: Pointer; sets_a: PVesicaShapesF64;
  set_count_a: Int32; index_b: Pointer; sets_b: PVesicaShapesF64; set_count_b: Int32; part: Int64; parts: Int64;
  scratch: Pointer; scratch_size: Int64; out_a: PInt64; out_b: PInt64; values: PDouble; capacity: Int64; state:
  PInt64): Int64; cdecl; external vesica_library;
// How many bytes of scratch does greedy assignment of `count` pairs need?
function vesica_assign_greedy_scratch(count: Int64; count_a: Int64; count_b: Int64): Int64; cdecl; external
  vesica_library;
// Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both
// free, until there is none.
function vesica_assign_greedy_f64(a: PInt64; b: PInt64; values: PDouble; count: Int64; count_a: Int64; count_b:
  Int64; scratch: Pointer; scratch_size: Int64; chosen: PInt64): Int64; cdecl; external vesica_library;
// How many bytes of scratch does the fusion of `count` boxes need?
function vesica_fuse_scratch(count: Int64): Int64; cdecl; external vesica_library;
// Weighted boxes fusion: boxes of one object, as several detectors or views find them, become their weighted mean.
function vesica_fuse_f64(shapes: PVesicaShapesF64; scores: PDouble; weights: PDouble; labels: PInt32; threshold:
  Double; fused_score: Int32; scratch: Pointer; scratch_size: Int64; fused: Pointer; fused_scores: PDouble;
  clusters: PInt64; count: PInt64): Int32; cdecl; external vesica_library;
// A ratio of shared volume: IoU and its relatives of two upright prisms.
function vesica_volume_ratio_f64(ratio: Int32; kind_a: Int32; a: Pointer; span_a: PVesicaSpanF64; kind_b: Int32; b:
  Pointer; span_b: PVesicaSpanF64; output: PDouble): Int32; cdecl; external vesica_library;
// A ratio of shared volume of the prisms a[i] from spans_a[i] and b[i] from spans_b[i].
function vesica_volume_ratio_many_f64(ratio: Int32; a: PVesicaShapesF64; spans_a: PVesicaSpanF64; b:
  PVesicaShapesF64; spans_b: PVesicaSpanF64; output: PDouble): Int64; cdecl; external vesica_library;
// A ratio of shared volume of every a[i] and b[j], in out[i * row_stride + j].
function vesica_volume_ratio_matrix_f64(ratio: Int32; a: PVesicaShapesF64; spans_a: PVesicaSpanF64; b:
  PVesicaShapesF64; spans_b: PVesicaSpanF64; output: PDouble; row_stride: PtrInt): Int64; cdecl; external
  vesica_library;
// How many bytes of scratch does matching by `count` pairs need?
function vesica_match_truths_scratch(count: Int64; detections: Int64; truths: Int64): Int64; cdecl; external
  vesica_library;
// Which detections hit a truth, at each of some thresholds?
function vesica_match_truths_f64(rule: Int32; a: PInt64; b: PInt64; values: PDouble; count: Int64; scores: PDouble;
  detections: Int64; flags: PByte; truths: Int64; thresholds: PDouble; threshold_count: Int64; scratch: Pointer;
  scratch_size: Int64; outcomes: PByte; taken: PInt64): Int32; cdecl; external vesica_library;
// How many bytes of scratch does the average precision of `count` detections need?
function vesica_average_precision_scratch(count: Int64): Int64; cdecl; external vesica_library;
// Average precision (AP) of detections of one class.
function vesica_average_precision_f64(rule: Int32; scores: PDouble; outcomes: PByte; count: Int64; truths: Int64;
  scratch: Pointer; scratch_size: Int64; output: PDouble): Int32; cdecl; external vesica_library;
// The distance of two circles, boxes, rectangles or ellipses as Gaussian distributions.
function vesica_gaussian_distance_f64(which: Int32; kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output:
  PDouble): Int32; cdecl; external vesica_library;
// The distance of a[i] and b[i]: out[i] is the result of vesica_gaussian_distance_f64.
function vesica_gaussian_distance_many_f64(which: Int32; a: PVesicaShapesF64; b: PVesicaShapesF64; output: PDouble):
  Int64; cdecl; external vesica_library;
// The distance of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_gaussian_distance_f64.
function vesica_gaussian_distance_matrix_f64(which: Int32; a: PVesicaShapesF64; b: PVesicaShapesF64; output:
  PDouble; row_stride: PtrInt): Int64; cdecl; external vesica_library;
// All pairs that overlap and whose ratio is at least `threshold`, with the ratio: a sparse matrix of IoU and the
// like.
function vesica_join_ratio_f32(ratio: Int32; threshold: Single; index_a: Pointer; sets_a: PVesicaShapesF32;
  set_count_a: Int32; index_b: Pointer; sets_b: PVesicaShapesF32; set_count_b: Int32; part: Int64; parts: Int64;
  scratch: Pointer; scratch_size: Int64; out_a: PInt64; out_b: PInt64; values: PSingle; capacity: Int64; state:
  PInt64): Int64; cdecl; external vesica_library;
// Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both
// free, until there is none.
function vesica_assign_greedy_f32(a: PInt64; b: PInt64; values: PSingle; count: Int64; count_a: Int64; count_b:
  Int64; scratch: Pointer; scratch_size: Int64; chosen: PInt64): Int64; cdecl; external vesica_library;
// Weighted boxes fusion: boxes of one object, as several detectors or views find them, become their weighted mean.
function vesica_fuse_f32(shapes: PVesicaShapesF32; scores: PSingle; weights: PSingle; labels: PInt32; threshold:
  Single; fused_score: Int32; scratch: Pointer; scratch_size: Int64; fused: Pointer; fused_scores: PSingle;
  clusters: PInt64; count: PInt64): Int32; cdecl; external vesica_library;
// Which detections hit a truth, at each of some thresholds?
function vesica_match_truths_f32(rule: Int32; a: PInt64; b: PInt64; values: PSingle; count: Int64; scores: PSingle;
  detections: Int64; flags: PByte; truths: Int64; thresholds: PSingle; threshold_count: Int64; scratch: Pointer;
  scratch_size: Int64; outcomes: PByte; taken: PInt64): Int32; cdecl; external vesica_library;
// Average precision (AP) of detections of one class.
function vesica_average_precision_f32(rule: Int32; scores: PSingle; outcomes: PByte; count: Int64; truths: Int64;
  scratch: Pointer; scratch_size: Int64; output: PSingle): Int32; cdecl; external vesica_library;
// A ratio of shared volume: IoU and its relatives of two upright prisms.
function vesica_volume_ratio_f32(ratio: Int32; kind_a: Int32; a: Pointer; span_a: PVesicaSpanF32; kind_b: Int32; b:
  Pointer; span_b: PVesicaSpanF32; output: PSingle): Int32; cdecl; external vesica_library;
// A ratio of shared volume of the prisms a[i] from spans_a[i] and b[i] from spans_b[i].
function vesica_volume_ratio_many_f32(ratio: Int32; a: PVesicaShapesF32; spans_a: PVesicaSpanF32; b:
  PVesicaShapesF32; spans_b: PVesicaSpanF32; output: PSingle): Int64; cdecl; external vesica_library;
// A ratio of shared volume of every a[i] and b[j], in out[i * row_stride + j].
function vesica_volume_ratio_matrix_f32(ratio: Int32; a: PVesicaShapesF32; spans_a: PVesicaSpanF32; b:
  PVesicaShapesF32; spans_b: PVesicaSpanF32; output: PSingle; row_stride: PtrInt): Int64; cdecl; external
  vesica_library;
// The distance of two circles, boxes, rectangles or ellipses as Gaussian distributions.
function vesica_gaussian_distance_f32(which: Int32; kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output:
  PSingle): Int32; cdecl; external vesica_library;
// The distance of a[i] and b[i]: out[i] is the result of vesica_gaussian_distance_f32.
function vesica_gaussian_distance_many_f32(which: Int32; a: PVesicaShapesF32; b: PVesicaShapesF32; output: PSingle):
  Int64; cdecl; external vesica_library;
// The distance of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_gaussian_distance_f32.
function vesica_gaussian_distance_matrix_f32(which: Int32; a: PVesicaShapesF32; b: PVesicaShapesF32; output:
  PSingle; row_stride: PtrInt): Int64; cdecl; external vesica_library;
// How many bytes suffice for an index of `count` shapes, of any kinds?
function vesica_index_size(count: Int64): Int64; cdecl; external vesica_library;
// How many bytes of scratch does building an index of `count` shapes need?
function vesica_index_scratch(count: Int64): Int64; cdecl; external vesica_library;
// How many bytes of scratch does a join need, whatever its indexes?
function vesica_join_scratch: Int64; cdecl; external vesica_library;
// Are these bytes an index that is safe to read?
function vesica_index_check(index: Pointer; size: Int64): Int32; cdecl; external vesica_library;
// How many bytes does a built index take?
function vesica_index_bytes(index: Pointer): Int64; cdecl; external vesica_library;
// How many shapes was an index built from?
function vesica_index_count(index: Pointer): Int64; cdecl; external vesica_library;
// A box around all valid shapes of an index.
function vesica_index_bounds(index: Pointer; output: PVesicaAabbF64): Int32; cdecl; external vesica_library;
// The items of an index in spatial order: shapes near each other have nearby places in it.
function vesica_index_order(index: Pointer; output: PInt64; capacity: Int64): Int64; cdecl; external vesica_library;
// Builds the index of some sets of shapes.
function vesica_index_build_f64(sets: PVesicaShapesF64; set_count: Int32; index: Pointer; index_size: Int64;
  scratch: Pointer; scratch_size: Int64): Int64; cdecl; external vesica_library;
// One part of a build by several threads, in five steps.
function vesica_index_step_f64(step: Int32; part: Int64; parts: Int64; sets: PVesicaShapesF64; set_count: Int32;
  index: Pointer; index_size: Int64; scratch: Pointer; scratch_size: Int64): Int64; cdecl; external vesica_library;
// Which items of an index does one shape overlap?
function vesica_index_select_f64(index: Pointer; sets: PVesicaShapesF64; set_count: Int32; one: PVesicaShapesF64;
  output: PInt64; capacity: Int64; state: PInt64): Int64; cdecl; external vesica_library;
// Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
function vesica_join_f64(query: Int32; index_a: Pointer; sets_a: PVesicaShapesF64; set_count_a: Int32; index_b:
  Pointer; sets_b: PVesicaShapesF64; set_count_b: Int32; part: Int64; parts: Int64; scratch: Pointer; scratch_size:
  Int64; out_a: PInt64; out_b: PInt64; capacity: Int64; state: PInt64): Int64; cdecl; external vesica_library;
// All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once: those
// for which vesica_within_f64 is > 0.
function vesica_join_within_f64(index_a: Pointer; sets_a: PVesicaShapesF64; set_count_a: Int32; index_b: Pointer;
  sets_b: PVesicaShapesF64; set_count_b: Int32; distance: Double; part: Int64; parts: Int64; out_a: PInt64; out_b:
  PInt64; capacity: Int64; state: PInt64): Int64; cdecl; external vesica_library;
// Which items of an index are nearest to one shape?
function vesica_index_nearest_f64(index: Pointer; sets: PVesicaShapesF64; set_count: Int32; one: PVesicaShapesF64;
  k: Int64; within: Double; output: PInt64; distance: PDouble): Int64; cdecl; external vesica_library;
// Which items of index_b are nearest to each item of sets_a?
function vesica_join_nearest_f64(sets_a: PVesicaShapesF64; set_count_a: Int32; index_b: Pointer; sets_b:
  PVesicaShapesF64; set_count_b: Int32; k: Int64; within: Double; part: Int64; parts: Int64; output: PInt64;
  distance: PDouble): Int64; cdecl; external vesica_library;
// How many bytes do the boxes of a polygon or a polyline take?
function vesica_polygon_boxes_size(vertices: Int64): Int64; cdecl; external vesica_library;
// Makes boxes about the edges of a polygon or a polyline that is asked again and again, such as a coast or a zone.
function vesica_polygon_boxes_f64(kind: Int32; path: Pointer; boxes: Pointer; size: Int64): Int32; cdecl; external
  vesica_library;
// Does a path with boxes overlap another shape?
function vesica_polygon_boxes_overlap_f64(kind: Int32; path: Pointer; boxes: Pointer; size: Int64; kind_b: Int32; b:
  Pointer): Int32; cdecl; external vesica_library;
// The distance of a path with boxes and another shape, and where it is.
function vesica_polygon_boxes_nearest_f64(kind: Int32; path: Pointer; boxes: Pointer; size: Int64; kind_b: Int32; b:
  Pointer; output: PVesicaClosestPointsF64): Int32; cdecl; external vesica_library;
// Are a path with boxes and another shape at most a distance apart?
function vesica_polygon_boxes_within_f64(kind: Int32; path: Pointer; boxes: Pointer; size: Int64; kind_b: Int32; b:
  Pointer; distance: Double): Int32; cdecl; external vesica_library;
// Builds the index of some sets of shapes.
function vesica_index_build_f32(sets: PVesicaShapesF32; set_count: Int32; index: Pointer; index_size: Int64;
  scratch: Pointer; scratch_size: Int64): Int64; cdecl; external vesica_library;
// One part of a build by several threads, in five steps.
function vesica_index_step_f32(step: Int32; part: Int64; parts: Int64; sets: PVesicaShapesF32; set_count: Int32;
  index: Pointer; index_size: Int64; scratch: Pointer; scratch_size: Int64): Int64; cdecl; external vesica_library;
// Which items of an index does one shape overlap?
function vesica_index_select_f32(index: Pointer; sets: PVesicaShapesF32; set_count: Int32; one: PVesicaShapesF32;
  output: PInt64; capacity: Int64; state: PInt64): Int64; cdecl; external vesica_library;
// Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
function vesica_join_f32(query: Int32; index_a: Pointer; sets_a: PVesicaShapesF32; set_count_a: Int32; index_b:
  Pointer; sets_b: PVesicaShapesF32; set_count_b: Int32; part: Int64; parts: Int64; scratch: Pointer; scratch_size:
  Int64; out_a: PInt64; out_b: PInt64; capacity: Int64; state: PInt64): Int64; cdecl; external vesica_library;
// All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once: those
// for which vesica_within_f32 is > 0.
function vesica_join_within_f32(index_a: Pointer; sets_a: PVesicaShapesF32; set_count_a: Int32; index_b: Pointer;
  sets_b: PVesicaShapesF32; set_count_b: Int32; distance: Single; part: Int64; parts: Int64; out_a: PInt64; out_b:
  PInt64; capacity: Int64; state: PInt64): Int64; cdecl; external vesica_library;
// Which items of an index are nearest to one shape?
function vesica_index_nearest_f32(index: Pointer; sets: PVesicaShapesF32; set_count: Int32; one: PVesicaShapesF32;
  k: Int64; within: Single; output: PInt64; distance: PSingle): Int64; cdecl; external vesica_library;
// Which items of index_b are nearest to each item of sets_a?
function vesica_join_nearest_f32(sets_a: PVesicaShapesF32; set_count_a: Int32; index_b: Pointer; sets_b:
  PVesicaShapesF32; set_count_b: Int32; k: Int64; within: Single; part: Int64; parts: Int64; output: PInt64;
  distance: PSingle): Int64; cdecl; external vesica_library;
// Makes boxes about the edges of a polygon or a polyline that is asked again and again, such as a coast or a zone.
function vesica_polygon_boxes_f32(kind: Int32; path: Pointer; boxes: Pointer; size: Int64): Int32; cdecl; external
  vesica_library;
// Does a path with boxes overlap another shape?
function vesica_polygon_boxes_overlap_f32(kind: Int32; path: Pointer; boxes: Pointer; size: Int64; kind_b: Int32; b:
  Pointer): Int32; cdecl; external vesica_library;
// The distance of a path with boxes and another shape, and where it is.
function vesica_polygon_boxes_nearest_f32(kind: Int32; path: Pointer; boxes: Pointer; size: Int64; kind_b: Int32; b:
  Pointer; output: PVesicaClosestPointsF32): Int32; cdecl; external vesica_library;
// Are a path with boxes and another shape at most a distance apart?
function vesica_polygon_boxes_within_f32(kind: Int32; path: Pointer; boxes: Pointer; size: Int64; kind_b: Int32; b:
  Pointer; distance: Single): Int32; cdecl; external vesica_library;
// A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
function vesica_ratio_f64(ratio: Int32; kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PDouble):
  Int32; cdecl; external vesica_library;
// A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f64.
function vesica_ratio_many_f64(ratio: Int32; a: PVesicaShapesF64; b: PVesicaShapesF64; output: PDouble): Int64;
  cdecl; external vesica_library;
// A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f64.
function vesica_ratio_matrix_f64(ratio: Int32; a: PVesicaShapesF64; b: PVesicaShapesF64; output: PDouble;
  row_stride: PtrInt): Int64; cdecl; external vesica_library;
// How far apart are a[i] and b[j]?
function vesica_nearest_matrix_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PDouble; row_stride: PtrInt):
  Int64; cdecl; external vesica_library;
// How far apart are the outlines of a[i] and b[j]?
function vesica_boundary_distance_matrix_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PDouble; row_stride:
  PtrInt): Int64; cdecl; external vesica_library;
// How deep do a[i] and b[j] overlap?
function vesica_depth_matrix_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PDouble; row_stride: PtrInt):
  Int64; cdecl; external vesica_library;
// Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
function vesica_signed_distance_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PDouble): Int32;
  cdecl; external vesica_library;
// Signed distances of a[i] and b[i].
function vesica_signed_distance_many_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PDouble): Int64; cdecl;
  external vesica_library;
// Signed distances of a[i] and b[j].
function vesica_signed_distance_matrix_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PDouble; row_stride:
  PtrInt): Int64; cdecl; external vesica_library;
// Are two shapes at most `distance` apart?
function vesica_within_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; distance: Double): Int32; cdecl;
  external vesica_library;
// Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f64.
function vesica_within_many_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; distance: Double; output: PByte): Int64;
  cdecl; external vesica_library;
// Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of vesica_within_f64.
function vesica_within_matrix_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; distance: Double; output: PByte;
  row_stride: PtrInt): Int64; cdecl; external vesica_library;
// Greedy non-maximum suppression as vesica_nms_f64, by any ratio, each label on its own.
function vesica_suppress_f64(shapes: PVesicaShapesF64; scores: PDouble; labels: PInt32; ratio: Int32; threshold:
  Double; least_score: Double; most: Int64; scratch: Pointer; scratch_size: Int64; keep: PInt64; kept: PInt64):
  Int32; cdecl; external vesica_library;
// How many bytes of scratch does soft suppression of `count` shapes need?
function vesica_suppress_soft_scratch(count: Int64): Int64; cdecl; external vesica_library;
// Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
function vesica_suppress_soft_f64(shapes: PVesicaShapesF64; scores: PDouble; labels: PInt32; ratio: Int32; decay:
  Int32; parameter: Double; least_score: Double; most: Int64; scratch: Pointer; scratch_size: Int64; keep: PInt64;
  decayed: PDouble; kept: PInt64): Int32; cdecl; external vesica_library;
// The share of each cell that a shape covers: out[j * row_stride + i] is area covered / area of cell (i, j).
function vesica_coverage_f64(kind: Int32; shape: Pointer; grid: PVesicaGridF64; output: PDouble; row_stride:
  PtrInt): Int32; cdecl; external vesica_library;
// The cells of which a shape covers more than nothing, and their shares, as vesica_coverage_f64 has them.
function vesica_coverage_cells_f64(kind: Int32; shape: Pointer; grid: PVesicaGridF64; cells: PInt64; shares:
  PDouble; capacity: Int64): Int64; cdecl; external vesica_library;
// A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
function vesica_ratio_f32(ratio: Int32; kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PSingle):
  Int32; cdecl; external vesica_library;
// A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f32.
function vesica_ratio_many_f32(ratio: Int32; a: PVesicaShapesF32; b: PVesicaShapesF32; output: PSingle): Int64;
  cdecl; external vesica_library;
// A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f32.
function vesica_ratio_matrix_f32(ratio: Int32; a: PVesicaShapesF32; b: PVesicaShapesF32; output: PSingle;
  row_stride: PtrInt): Int64; cdecl; external vesica_library;
// How far apart are a[i] and b[j]?
function vesica_nearest_matrix_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PSingle; row_stride: PtrInt):
  Int64; cdecl; external vesica_library;
// How far apart are the outlines of a[i] and b[j]?
function vesica_boundary_distance_matrix_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PSingle; row_stride:
  PtrInt): Int64; cdecl; external vesica_library;
// How deep do a[i] and b[j] overlap?
function vesica_depth_matrix_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PSingle; row_stride: PtrInt):
  Int64; cdecl; external vesica_library;
// Greedy non-maximum suppression as vesica_nms_f32, by any ratio, each label on its own.
function vesica_suppress_f32(shapes: PVesicaShapesF32; scores: PSingle; labels: PInt32; ratio: Int32; threshold:
  Single; least_score: Single; most: Int64; scratch: Pointer; scratch_size: Int64; keep: PInt64; kept: PInt64):
  Int32; cdecl; external vesica_library;
// Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
function vesica_signed_distance_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PSingle): Int32;
  cdecl; external vesica_library;
// Signed distances of a[i] and b[i].
function vesica_signed_distance_many_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PSingle): Int64; cdecl;
  external vesica_library;
// Signed distances of a[i] and b[j].
function vesica_signed_distance_matrix_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PSingle; row_stride:
  PtrInt): Int64; cdecl; external vesica_library;
// Are two shapes at most `distance` apart?
function vesica_within_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; distance: Single): Int32; cdecl;
  external vesica_library;
// Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f32.
function vesica_within_many_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; distance: Single; output: PByte): Int64;
  cdecl; external vesica_library;
// Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of vesica_within_f32.
function vesica_within_matrix_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; distance: Single; output: PByte;
  row_stride: PtrInt): Int64; cdecl; external vesica_library;
// Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
function vesica_suppress_soft_f32(shapes: PVesicaShapesF32; scores: PSingle; labels: PInt32; ratio: Int32; decay:
  Int32; parameter: Single; least_score: Single; most: Int64; scratch: Pointer; scratch_size: Int64; keep: PInt64;
  decayed: PSingle; kept: PInt64): Int32; cdecl; external vesica_library;
// The share of each cell that a shape covers: out[j * row_stride + i] is area covered / area of cell (i, j).
function vesica_coverage_f32(kind: Int32; shape: Pointer; grid: PVesicaGridF32; output: PSingle; row_stride:
  PtrInt): Int32; cdecl; external vesica_library;
// The cells of which a shape covers more than nothing, and their shares, as vesica_coverage_f32 has them.
function vesica_coverage_cells_f32(kind: Int32; shape: Pointer; grid: PVesicaGridF32; cells: PInt64; shares:
  PSingle; capacity: Int64): Int64; cdecl; external vesica_library;
// Does b touch a while it moves, when first, and where?
function vesica_cast_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; vx: Double; vy: Double; t_end:
  Double; output: PVesicaImpactF64): Int32; cdecl; external vesica_library;
// When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]?
function vesica_cast_many_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; vx: PDouble; vy: PDouble; stride: PtrInt;
  t_end: Double; t: PDouble; x: PDouble; y: PDouble; nx: PDouble; ny: PDouble): Int64; cdecl; external
  vesica_library;
// Which of many shapes at rest does one moving shape touch first?
function vesica_cast_first_f64(one: PVesicaShapesF64; many: PVesicaShapesF64; vx: Double; vy: Double; t_end: Double;
  output: PVesicaImpactF64): Int64; cdecl; external vesica_library;
// A box that holds a shape throughout its motion, t from 0 to t_end.
function vesica_sweep_bounds_f64(kind: Int32; shape: Pointer; vx: Double; vy: Double; t_end: Double; output:
  PVesicaAabbF64): Int32; cdecl; external vesica_library;
// Which items of an index does one moving shape touch?
function vesica_index_cast_f64(index: Pointer; sets: PVesicaShapesF64; set_count: Int32; one: PVesicaShapesF64; vx:
  Double; vy: Double; t_end: Double; output: PInt64; capacity: Int64; state: PInt64): Int64; cdecl; external
  vesica_library;
// Which item of an index does one moving shape touch first?
function vesica_index_cast_first_f64(index: Pointer; sets: PVesicaShapesF64; set_count: Int32; one:
  PVesicaShapesF64; vx: Double; vy: Double; t_end: Double; output: PVesicaImpactF64): Int64; cdecl; external
  vesica_library;
// When do two shapes that move and turn touch first?
function vesica_impact_time_f64(kind_a: Int32; a: Pointer; turn_a: PVesicaTurnF64; kind_b: Int32; b: Pointer;
  turn_b: PVesicaTurnF64; tolerance: Double; output: PVesicaImpactF64; gap: PDouble): Int32; cdecl; external
  vesica_library;
// Which item of an index does a shape that moves and turns touch first?
function vesica_index_impact_time_f64(index: Pointer; sets: PVesicaShapesF64; set_count: Int32; one:
  PVesicaShapesF64; turn: PVesicaTurnF64; tolerance: Double; output: PVesicaImpactF64; gap: PDouble; answer:
  PInt32): Int64; cdecl; external vesica_library;
// Contact manifold: where do two convex shapes press on each other, how deep, and along which normal?
function vesica_manifold_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PVesicaContactsF64):
  Int32; cdecl; external vesica_library;
// The contacts of a[i] and b[i].
function vesica_manifold_many_f64(a: PVesicaShapesF64; b: PVesicaShapesF64; output: PVesicaContactsF64): Int64;
  cdecl; external vesica_library;
// A ray at a point.
function vesica_cast_point_point_f64(a: PVesicaPointF64; b: PVesicaPointF64; vx: Double; vy: Double; t_end: Double;
  output: PVesicaImpactF64): Int32; cdecl; external vesica_library;
// A ray at a segment.
function vesica_cast_segment_point_f64(a: PVesicaSegmentF64; b: PVesicaPointF64; vx: Double; vy: Double; t_end:
  Double; output: PVesicaImpactF64): Int32; cdecl; external vesica_library;
// A ray at a disc.
function vesica_cast_circle_point_f64(a: PVesicaCircleF64; b: PVesicaPointF64; vx: Double; vy: Double; t_end:
  Double; output: PVesicaImpactF64): Int32; cdecl; external vesica_library;
// A ray at an axis-aligned box.
function vesica_cast_aabb_point_f64(a: PVesicaAabbF64; b: PVesicaPointF64; vx: Double; vy: Double; t_end: Double;
  output: PVesicaImpactF64): Int32; cdecl; external vesica_library;
// A ray at a rectangle.
function vesica_cast_rect_point_f64(a: PVesicaRectF64; b: PVesicaPointF64; vx: Double; vy: Double; t_end: Double;
  output: PVesicaImpactF64): Int32; cdecl; external vesica_library;
// A ray at an ellipse.
function vesica_cast_ellipse_point_f64(a: PVesicaEllipseF64; b: PVesicaPointF64; vx: Double; vy: Double; t_end:
  Double; output: PVesicaImpactF64): Int32; cdecl; external vesica_library;
// Two discs.
function vesica_cast_circle_circle_f64(a: PVesicaCircleF64; b: PVesicaCircleF64; vx: Double; vy: Double; t_end:
  Double; output: PVesicaImpactF64): Int32; cdecl; external vesica_library;
// Two rectangles.
function vesica_cast_rect_rect_f64(a: PVesicaRectF64; b: PVesicaRectF64; vx: Double; vy: Double; t_end: Double;
  output: PVesicaImpactF64): Int32; cdecl; external vesica_library;
// Does b touch a while it moves, when first, and where?
function vesica_cast_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; vx: Single; vy: Single; t_end:
  Single; output: PVesicaImpactF32): Int32; cdecl; external vesica_library;
// When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]?
function vesica_cast_many_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; vx: PSingle; vy: PSingle; stride: PtrInt;
  t_end: Single; t: PSingle; x: PSingle; y: PSingle; nx: PSingle; ny: PSingle): Int64; cdecl; external
  vesica_library;
// Which of many shapes at rest does one moving shape touch first?
function vesica_cast_first_f32(one: PVesicaShapesF32; many: PVesicaShapesF32; vx: Single; vy: Single; t_end: Single;
  output: PVesicaImpactF32): Int64; cdecl; external vesica_library;
// A box that holds a shape throughout its motion, t from 0 to t_end.
function vesica_sweep_bounds_f32(kind: Int32; shape: Pointer; vx: Single; vy: Single; t_end: Single; output:
  PVesicaAabbF32): Int32; cdecl; external vesica_library;
// Which items of an index does one moving shape touch?
function vesica_index_cast_f32(index: Pointer; sets: PVesicaShapesF32; set_count: Int32; one: PVesicaShapesF32; vx:
  Single; vy: Single; t_end: Single; output: PInt64; capacity: Int64; state: PInt64): Int64; cdecl; external
  vesica_library;
// Which item of an index does one moving shape touch first?
function vesica_index_cast_first_f32(index: Pointer; sets: PVesicaShapesF32; set_count: Int32; one:
  PVesicaShapesF32; vx: Single; vy: Single; t_end: Single; output: PVesicaImpactF32): Int64; cdecl; external
  vesica_library;
// As vesica_impact_time_f64.
function vesica_impact_time_f32(kind_a: Int32; a: Pointer; turn_a: PVesicaTurnF32; kind_b: Int32; b: Pointer;
  turn_b: PVesicaTurnF32; tolerance: Single; output: PVesicaImpactF32; gap: PSingle): Int32; cdecl; external
  vesica_library;
// Which item of an index does a shape that moves and turns touch first?
function vesica_index_impact_time_f32(index: Pointer; sets: PVesicaShapesF32; set_count: Int32; one:
  PVesicaShapesF32; turn: PVesicaTurnF32; tolerance: Single; output: PVesicaImpactF32; gap: PSingle; answer:
  PInt32): Int64; cdecl; external vesica_library;
// Contact manifold: where do two convex shapes press on each other, how deep, and along which normal?
function vesica_manifold_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PVesicaContactsF32):
  Int32; cdecl; external vesica_library;
// The contacts of a[i] and b[i].
function vesica_manifold_many_f32(a: PVesicaShapesF32; b: PVesicaShapesF32; output: PVesicaContactsF32): Int64;
  cdecl; external vesica_library;
// A ray at a point.
function vesica_cast_point_point_f32(a: PVesicaPointF32; b: PVesicaPointF32; vx: Single; vy: Single; t_end: Single;
  output: PVesicaImpactF32): Int32; cdecl; external vesica_library;
// A ray at a segment.
function vesica_cast_segment_point_f32(a: PVesicaSegmentF32; b: PVesicaPointF32; vx: Single; vy: Single; t_end:
  Single; output: PVesicaImpactF32): Int32; cdecl; external vesica_library;
// A ray at a disc.
function vesica_cast_circle_point_f32(a: PVesicaCircleF32; b: PVesicaPointF32; vx: Single; vy: Single; t_end:
  Single; output: PVesicaImpactF32): Int32; cdecl; external vesica_library;
// A ray at an axis-aligned box.
function vesica_cast_aabb_point_f32(a: PVesicaAabbF32; b: PVesicaPointF32; vx: Single; vy: Single; t_end: Single;
  output: PVesicaImpactF32): Int32; cdecl; external vesica_library;
// A ray at a rectangle.
function vesica_cast_rect_point_f32(a: PVesicaRectF32; b: PVesicaPointF32; vx: Single; vy: Single; t_end: Single;
  output: PVesicaImpactF32): Int32; cdecl; external vesica_library;
// A ray at an ellipse.
function vesica_cast_ellipse_point_f32(a: PVesicaEllipseF32; b: PVesicaPointF32; vx: Single; vy: Single; t_end:
  Single; output: PVesicaImpactF32): Int32; cdecl; external vesica_library;
// Two discs.
function vesica_cast_circle_circle_f32(a: PVesicaCircleF32; b: PVesicaCircleF32; vx: Single; vy: Single; t_end:
  Single; output: PVesicaImpactF32): Int32; cdecl; external vesica_library;
// Two rectangles.
function vesica_cast_rect_rect_f32(a: PVesicaRectF32; b: PVesicaRectF32; vx: Single; vy: Single; t_end: Single;
  output: PVesicaImpactF32): Int32; cdecl; external vesica_library;
// The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
function vesica_de9im_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; matrix: PChar): Int32; cdecl;
  external vesica_library;
// Does a nine-intersection matrix match a pattern, such as "T*F**F***" for "a is within b"?
function vesica_de9im_match(matrix: PChar; pattern: PChar): Int32; cdecl; external vesica_library;
// The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
function vesica_intersection_f64(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PVesicaPointF64;
  capacity: Int64): Int64; cdecl; external vesica_library;
// The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
function vesica_de9im_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; matrix: PChar): Int32; cdecl;
  external vesica_library;
// The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
function vesica_intersection_f32(kind_a: Int32; a: Pointer; kind_b: Int32; b: Pointer; output: PVesicaPointF32;
  capacity: Int64): Int64; cdecl; external vesica_library;

implementation

end.
