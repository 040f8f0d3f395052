/*
 * Vesica: arrays of boxes as detectors write them, with centre, width, height and angle; corners and bounds of arrays.
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
 * Boxes from rectangles or from ellipses: the inverse of the two functions above.
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

/* ---- The same functions with float in place of double ---- */

/** As vesica_rects_from_boxes_f64, rounded to float. */
VESICA_API int64_t vesica_rects_from_boxes_f32(const float *boxes, int64_t count, ptrdiff_t stride, int32_t angle,
                                               vesica_rect_f32 *out);
/** As vesica_ellipses_from_boxes_f64, rounded to float. */
VESICA_API int64_t vesica_ellipses_from_boxes_f32(const float *boxes, int64_t count, ptrdiff_t stride, int32_t angle,
                                                  vesica_ellipse_f32 *out);
/** As vesica_boxes_from_shapes_f64, rounded to float. */
VESICA_API int64_t vesica_boxes_from_shapes_f32(const vesica_shapes_f32 *shapes, int32_t angle, float *boxes);
/** As vesica_corners_of_shapes_f64, rounded to float. */
VESICA_API int64_t vesica_corners_of_shapes_f32(const vesica_shapes_f32 *shapes, float *corners);
/** As vesica_bounds_many_f64. */
VESICA_API int64_t vesica_bounds_many_f32(const vesica_shapes_f32 *shapes, vesica_aabb_f32 *out);

#ifdef __cplusplus
}
#endif

#endif /* VESICA_BOXES_H */
