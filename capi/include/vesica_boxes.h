/*
 * Vesica: arrays of boxes as detectors write them, with centre, width, height and angle; corners and bounds of arrays;
 * convex hulls of points and the smallest rectangles about them.
 *
 * SPDX-License-Identifier: Apache-2.0
 *
 * vesica.h includes this header, and both belong to one library. The rules of vesica.h hold. Comments have the same
 * parts: Requires, Returns, Errors, Accuracy, Cost, Since.
 *
 * A box is five adjacent numbers: centre x, centre y, width along the angle, height across it, angle.
 */
#ifndef VESICA_BOXES_H
#define VESICA_BOXES_H

#include "vesica.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Constants ---- */

/* Units of angles. Angles turn from +x towards +y: counter-clockwise if y points up, clockwise on a screen. */
#define VESICA_ANGLE_RADIANS 0
#define VESICA_ANGLE_DEGREES 1
#define VESICA_ANGLE_QUARTERS 2 /**< quarter turns */
#define VESICA_ANGLE_REVERSED 4 /**< added to a unit: angles turn the other way, from +x towards -y */

/* ---- Arrays, double ----
 * Returns: 0.
 * Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
 * numbers of that result are NaN, and all other results are written as usual. Before anything is written: VESICA_E_NULL
 * (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array that exceeds the
 * address space, an unknown unit of angles).
 * Since: 0.1.
 */

/**
 * Rectangles from boxes.
 * Requires: boxes, `count` rows of five numbers with any alignment, `stride` bytes apart; angle, a unit of angles, or
 * its sum with VESICA_ANGLE_REVERSED; out, room for `count`.
 * Accuracy: the axis is (cos, sin), each right to 1.1 units in the last place. Degrees that are multiples of 90, and
 * whole quarter turns, give exact axes. In both units an angle and its complement have the same components, exchanged:
 * a rectangle and the same one turned by a quarter, its width and height exchanged, are VESICA_EQUAL. In radians, as
 * in vesica_rect_from_angle_f64. Sizes are those of vesica_rect_from_angle_f64.
 */
VESICA_API int64_t vesica_rects_from_boxes_f64(const double *boxes, int64_t count, ptrdiff_t stride, int32_t angle,
                                               vesica_rect_f64 *out);

/**
 * Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
 * Requires: as vesica_rects_from_boxes_f64.
 * Accuracy: as vesica_rects_from_boxes_f64. Half lengths are halves of width and height.
 */
VESICA_API int64_t vesica_ellipses_from_boxes_f64(const double *boxes, int64_t count, ptrdiff_t stride, int32_t angle,
                                                  vesica_ellipse_f64 *out);

/**
 * Rectangles from four corners each: out[i] is the result of vesica_rect_from_corners_f64.
 *
 * Crossed corners, in another order than round the outline, make their element invalid.
 * Requires: corners, `count` rows of eight numbers x0 y0 ... x3 y3 with any alignment, `stride` bytes apart; out, room
 * for `count`.
 * Accuracy: as vesica_rect_from_corners_f64.
 */
VESICA_API int64_t vesica_rects_from_corners_f64(const double *corners, int64_t count, ptrdiff_t stride,
                                                 vesica_rect_f64 *out);

/**
 * How far corners are from those of rectangles: misfit[i] is the result of vesica_rect_corners_misfit_f64.
 * Requires: corners, a row for each rectangle, as vesica_rects_from_corners_f64; rects, of kind VESICA_RECT; misfit,
 * room for `count`.
 * Accuracy: as vesica_rect_corners_misfit_f64.
 */
VESICA_API int64_t vesica_rect_corners_misfit_many_f64(const double *corners, ptrdiff_t stride,
                                                       const vesica_shapes_f64 *rects, double *misfit);

/**
 * Boxes from rectangles or from ellipses: the inverse of the first two functions.
 *
 * Angles are from -180 to 180 degrees, in the unit asked for.
 * Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; angle as vesica_rects_from_boxes_f64; boxes, room for
 * `count` rows of five numbers, without gaps.
 * Accuracy: width and height are right to 4 units in the last place, and the angle to 2 units in the last place of a
 * quarter turn. If an axis lies exactly along a coordinate axis, degrees and quarter turns are exact.
 */
VESICA_API int64_t vesica_boxes_from_shapes_f64(const vesica_shapes_f64 *shapes, int32_t angle, double *boxes);

/**
 * The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
 *
 * The first corner is C - hx u - hy perp(u), the next C + hx u - hy perp(u), and so on round the outline.
 * Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; corners, room for `count` rows of eight numbers.
 * Accuracy: a coordinate is right to 1 unit in its last place plus 2^-98 times the largest of its three terms.
 */
VESICA_API int64_t vesica_corners_of_shapes_f64(const vesica_shapes_f64 *shapes, double *corners);

/**
 * Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f64.
 * Requires: out, room for `count`.
 * Accuracy: as vesica_bounds_f64.
 * Cost: as vesica_bounds_f64; up to eight times less with AVX2 or AVX-512.
 */
VESICA_API int64_t vesica_bounds_many_f64(const vesica_shapes_f64 *shapes, vesica_aabb_f64 *out);

/**
 * Areas of an array of any kind: out[i] is the result of vesica_shape_area_f64.
 * Requires: out, room for `count`.
 * Accuracy: as vesica_shape_area_f64.
 */
VESICA_API int64_t vesica_shape_area_many_f64(const vesica_shapes_f64 *shapes, double *out);

/* ---- Hulls of points, double ----
 * Errors: VESICA_E_NULL, VESICA_E_SHAPE.
 * Since: 0.1.
 */

/**
 * The convex hull of points: the smallest convex polygon that contains them.
 *
 * Points are the vertices of a polygon; their order and its rings do not matter. Corners of the hull run counter-
 * clockwise where y points up, from the lowest of the leftmost points on. None of them is on the line between its
 * neighbours. Equal points have one corner; points on one line have two.
 * Requires: out, room for `capacity` points: as many as there are, because they are sorted there.
 * Returns: the number of corners.
 * Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_ARGUMENT (less room). Nothing is written.
 * Accuracy: exact.
 * Cost: that of sorting the points.
 */
VESICA_API int64_t vesica_convex_hull_f64(const vesica_polygon_f64 *points, vesica_point_f64 *out, int64_t capacity);

/**
 * The rectangle of the least area that contains points.
 *
 * Points are as in vesica_convex_hull_f64. The rectangle has a side along an edge of their hull. Its axis is the
 * direction of that edge, counter-clockwise round the hull where y points up, and hx is half the length along it. Of
 * equal rectangles it is the first, from the lowest of the leftmost points on; areas are compared as they are computed.
 * Points on one line give a rectangle without height. vesica_rect_corners_misfit_f64 says how far four corners are from
 * it.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_RANGE (a number would overflow), VESICA_E_NOT_CONVEX (the points
 * are no convex ring, and the hull of all or of the first ones has more than 768 corners: find it by
 * vesica_convex_hull_f64 first).
 * Accuracy: no point is outside by more than 8 u times the sum of the points' extent and the largest coordinate, and
 * each side is that near to a point. The same number of smallest subnormal numbers adds to that.
 * Cost: that of vesica_convex_hull_f64, and for each corner of the hull about as much again as for a point.
 */
VESICA_API int32_t vesica_min_area_rect_f64(const vesica_polygon_f64 *points, vesica_rect_f64 *out);

/**
 * The rectangle of the least perimeter that contains points, else as vesica_min_area_rect_f64.
 * Returns: 0.
 * Errors: as vesica_min_area_rect_f64.
 * Accuracy: as vesica_min_area_rect_f64.
 */
VESICA_API int32_t vesica_min_perimeter_rect_f64(const vesica_polygon_f64 *points, vesica_rect_f64 *out);

/**
 * The rectangles of the least area about each polygon or polyline of an array.
 * Requires: points, of kind VESICA_POLYGON or VESICA_POLYLINE; out, room for `count`.
 * Returns: 0.
 * Errors: as the arrays above. If the hull of an element has too many corners, that is VESICA_E_SHAPE.
 * Accuracy: as vesica_min_area_rect_f64.
 */
VESICA_API int64_t vesica_min_area_rect_many_f64(const vesica_shapes_f64 *points, vesica_rect_f64 *out);

/**
 * The rectangles of the least perimeter about each polygon or polyline of an array.
 * Requires: as vesica_min_area_rect_many_f64.
 * Errors: as vesica_min_area_rect_many_f64.
 * Accuracy: as vesica_min_area_rect_f64.
 */
VESICA_API int64_t vesica_min_perimeter_rect_many_f64(const vesica_shapes_f64 *points, vesica_rect_f64 *out);

/* ---- The same functions with float in place of double ---- */

/** As vesica_rects_from_boxes_f64, rounded to float. */
VESICA_API int64_t vesica_rects_from_boxes_f32(const float *boxes, int64_t count, ptrdiff_t stride, int32_t angle,
                                               vesica_rect_f32 *out);
/** As vesica_ellipses_from_boxes_f64, rounded to float. */
VESICA_API int64_t vesica_ellipses_from_boxes_f32(const float *boxes, int64_t count, ptrdiff_t stride, int32_t angle,
                                                  vesica_ellipse_f32 *out);
/** As vesica_rects_from_corners_f64, rounded to float. */
VESICA_API int64_t vesica_rects_from_corners_f32(const float *corners, int64_t count, ptrdiff_t stride,
                                                 vesica_rect_f32 *out);
/** As vesica_rect_corners_misfit_many_f64, rounded to float. */
VESICA_API int64_t vesica_rect_corners_misfit_many_f32(const float *corners, ptrdiff_t stride,
                                                       const vesica_shapes_f32 *rects, float *misfit);
/** As vesica_boxes_from_shapes_f64, rounded to float. */
VESICA_API int64_t vesica_boxes_from_shapes_f32(const vesica_shapes_f32 *shapes, int32_t angle, float *boxes);
/** As vesica_corners_of_shapes_f64, rounded to float. */
VESICA_API int64_t vesica_corners_of_shapes_f32(const vesica_shapes_f32 *shapes, float *corners);
/** As vesica_bounds_many_f64. */
VESICA_API int64_t vesica_bounds_many_f32(const vesica_shapes_f32 *shapes, vesica_aabb_f32 *out);
/** As vesica_shape_area_many_f64, rounded to float. */
VESICA_API int64_t vesica_shape_area_many_f32(const vesica_shapes_f32 *shapes, float *out);
/** As vesica_convex_hull_f64. */
VESICA_API int64_t vesica_convex_hull_f32(const vesica_polygon_f32 *points, vesica_point_f32 *out, int64_t capacity);
/** As vesica_min_area_rect_f64, rounded to float. */
VESICA_API int32_t vesica_min_area_rect_f32(const vesica_polygon_f32 *points, vesica_rect_f32 *out);
/** As vesica_min_perimeter_rect_f64, rounded to float. */
VESICA_API int32_t vesica_min_perimeter_rect_f32(const vesica_polygon_f32 *points, vesica_rect_f32 *out);
/** As vesica_min_area_rect_many_f64, rounded to float. */
VESICA_API int64_t vesica_min_area_rect_many_f32(const vesica_shapes_f32 *points, vesica_rect_f32 *out);
/** As vesica_min_perimeter_rect_many_f64, rounded to float. */
VESICA_API int64_t vesica_min_perimeter_rect_many_f32(const vesica_shapes_f32 *points, vesica_rect_f32 *out);

#ifdef __cplusplus
}
#endif

#endif /* VESICA_BOXES_H */
