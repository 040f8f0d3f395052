/*
 * Vesica: the classic algorithms by name, beside the exact answer.
 *
 * SPDX-License-Identifier: Apache-2.0
 *
 * For teaching, for comparison, and for approximate work with a known bound. They are a separate library,
 * libvesica-methods. To know whether two shapes overlap, call vesica_overlap_f64 of vesica.h: it is exact, and mostly
 * faster.
 *
 * Exact methods evaluate an exact formula in the rounded arithmetic of the given scalar. Near contact they may err;
 * docs/methods.md counts how often. Approximate methods answer VESICA_YES, VESICA_NO or VESICA_UNCERTAIN, never a
 * guess. A roundoff is 2^-53 in double and 2^-24 in float.
 *
 * The rules of vesica.h hold, but arguments are checked after shapes. Comments have the same parts: Requires, Returns,
 * Errors, Accuracy, Cost, Since.
 */
#ifndef VESICA_METHODS_H
#define VESICA_METHODS_H

#include "vesica.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Constants ---- */

/* Answers. */
#define VESICA_NO 0        /**< certainly disjoint */
#define VESICA_YES 1       /**< certainly overlapping */
#define VESICA_UNCERTAIN 2 /**< the method cannot tell; its bound says how near to contact the shapes are */

/* Schedules of the gradient descent. */
#define VESICA_SCHEDULE_SCALE_AWARE 0 /**< steps in proportion to the pair: the same at any scale, and never uphill */
#define VESICA_SCHEDULE_LITERAL 1     /**< steps as published, which fit shapes of size about 5 */

/* Limits of arguments. */
#define VESICA_MOST_SAMPLE_POINTS 1000         /**< the largest k of vesica_method_rect_rect_sample_points_f64, _f32 */
#define VESICA_MOST_SANDWICH_ITERATIONS 30     /**< the largest n of the approximate methods for ellipses */
#define VESICA_MOST_DESCENT_ITERATIONS 1000000 /**< the most iterations of a gradient descent */

/* ---- Structs, double. They have no padding, and their layout is frozen. ---- */

/** A point of a rectangle, and its level for an ellipse: -1 at the ellipse's centre, 0 on its outline. */
typedef struct {
    double x, y, c_min;
} vesica_metric_closest_f64;

/**
 * A rectangle as centre, angle and size: width along the angle, height across it.
 *
 * The angle is in radians, counter-clockwise from +x if y points up. Valid if all are finite and width, height >= 0.
 */
typedef struct {
    double cx, cy, angle, width, height;
} vesica_turned_rect_f64;

/**
 * How far an approximate method went: its iterations, and the bound on the error of the outline after them.
 *
 * outline_error is 2^(0.303 - 2 iterations) times the longer half axis, a length. No point of the inner or the outer
 * polygon is farther from the outline. It is 0 if the exact overlap answered, and may be infinite if the half axis
 * overflows. reserved is 0.
 */
typedef struct {
    double outline_error;
    int32_t iterations, reserved;
} vesica_approximation_f64;

/**
 * An ellipse as centre, radius vector (wx, wy), which is half an axis, and the ratio of the other radius to it.
 *
 * Valid if all are finite and ratio >= 0. A zero vector makes it a point.
 */
typedef struct {
    double cx, cy, wx, wy, ratio;
} vesica_radius_vector_ellipse_f64;

/**
 * How to descend: step i = 0, 1 ... changes the two angles by rate * exp(-decay i) times a gradient.
 *
 * The error of a step is the larger component of that gradient. Descent stops when it is below the tolerance. With the
 * literal schedule it is the gradient of the squared distance, in squared units of length. With the scale-aware
 * schedule it is half of that, each component divided by R (R + R' + d), in radians: R is the larger half length of its
 * ellipse, R' the other's, and d the distance.
 * Valid if all are finite, tolerance > 0, rate > 0 (scale-aware: < 2 too), decay >= 0, iterations from 1 to
 * VESICA_MOST_DESCENT_ITERATIONS, and schedule is one of VESICA_SCHEDULE_...
 */
typedef struct {
    double tolerance, rate, decay;
    int32_t iterations, schedule;
} vesica_descent_settings_f64;

/**
 * The end of a descent: two points of outlines, as angles t in [-pi, pi] of C + a cos(t) u + b sin(t) perp(u).
 *
 * distance is the points' distance, error the last step's. iterations counts gradients. success is 1 if the
 * error came below the tolerance, else 0.
 */
typedef struct {
    double angle_a, angle_b, distance, error;
    int32_t iterations, success;
} vesica_descent_result_f64;

/* ---- Rectangle and ellipse, double. Eberly: Intersection of Rectangle and Ellipse, 2015. ----
 * Returns: 1 if the shapes overlap (touching counts), 0 if not.
 * Errors: VESICA_E_NULL, VESICA_E_SHAPE.
 * Accuracy: may err within a few roundings of contact. An ellipse with a half length of at most about 2^-176 (float:
 * 2^-22) of the largest length, such as 0, is answered exactly.
 * Since: 0.1.
 */

/**
 * Rectangle and ellipse by all features (Eberly, section 2): is a vertex of the rectangle in the ellipse, does one of
 * its edges meet the ellipse, or is the ellipse's centre in the rectangle?
 */
VESICA_API int32_t vesica_method_rect_ellipse_all_features_f64(const vesica_rect_f64 *rect,
                                                               const vesica_ellipse_f64 *ellipse);

/**
 * Rectangle and ellipse by closest features (Eberly, section 3): which of the nine regions about the rectangle holds
 * the ellipse's centre? The region leaves at most two edges and three vertices to try.
 */
VESICA_API int32_t vesica_method_rect_ellipse_closest_features_f64(const vesica_rect_f64 *rect,
                                                                   const vesica_ellipse_f64 *ellipse);

/**
 * Rectangle and ellipse by their Minkowski sum (Eberly, section 5): is the ellipse's centre in the rectangle grown by
 * the ellipse?
 *
 * Corrected: the extreme points decide which corner's arc applies, not the signs of the centre's coordinates.
 */
VESICA_API int32_t vesica_method_rect_ellipse_minkowski_sum_f64(const vesica_rect_f64 *rect,
                                                                const vesica_ellipse_f64 *ellipse);

/**
 * Rectangle and ellipse by the distance of a point to a parallelogram (Eberly, section 4): which point of the rectangle
 * has the least level for the ellipse?
 *
 * The level is Q(X) = |X - K|^2 - 1, where K is the centre and lengths are measured so that |X - K| is 1 on the
 * outline. The result is that point, in the rectangle up to rounding, and its level c_min. If the rectangle holds the
 * ellipse's centre, it is that centre and -1. If the ellipse is a segment (a or b is 0), levels off its line are
 * infinite: then c_min may be infinite, and the point is the limit for ever thinner ellipses.
 * Returns: 1 if they overlap, which is c_min <= 0, else 0.
 * Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_RANGE (a coordinate of the point is beyond the finite numbers).
 */
VESICA_API int32_t vesica_method_rect_ellipse_point_parallelogram_distance_f64(const vesica_rect_f64 *rect,
                                                                               const vesica_ellipse_f64 *ellipse,
                                                                               vesica_metric_closest_f64 *out);

/* ---- Rectangle and rectangle, points and boxes, double. Most are from "Rectangle intersection at 60fps". ----
 * Returns: 1 if the shapes overlap (touching counts), 0 if not.
 * Errors: VESICA_E_NULL, VESICA_E_SHAPE.
 * Since: 0.1.
 */

/**
 * First pass for two rectangles: are their boxes along the coordinate axes apart?
 * Returns: VESICA_NO, which is certain, or VESICA_UNCERTAIN.
 * Accuracy: uncertain means that the boxes meet, or are apart by less than 22 roundoffs of their half widths.
 */
VESICA_API int32_t vesica_method_rect_rect_bounds_f64(const vesica_rect_f64 *a, const vesica_rect_f64 *b);

/**
 * Two rectangles by sample points: does one hold a corner of the other, or one of k evenly spaced points on the other's
 * middle line along its long side? Tried both ways round.
 * Requires: k from 0 to VESICA_MOST_SAMPLE_POINTS.
 * Returns: VESICA_YES, which is certain, or VESICA_UNCERTAIN: no k makes the method exact.
 * Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_ARGUMENT (k).
 * Accuracy: with k >= 1 uncertain means, both ways round: no stretch of length l / (k + 1) of one's middle line, of
 * length l, lies in the other one when that is made smaller by 50 roundoffs of the size of the pair.
 */
VESICA_API int32_t vesica_method_rect_rect_sample_points_f64(const vesica_rect_f64 *a, const vesica_rect_f64 *b,
                                                             int32_t k);

/**
 * Two rectangles by separating lines: do all corners of one lie beyond the line of one edge of the other? Tried both
 * ways round, each time in the frame of the second rectangle.
 * Accuracy: may err within a few roundings of contact.
 */
VESICA_API int32_t vesica_method_rect_rect_separating_lines_f64(const vesica_rect_f64 *a, const vesica_rect_f64 *b);

/**
 * Two rectangles by separating lines, from centre, angle and size, as vesica_rect_from_angle_f64 takes them.
 * Accuracy: may err within a few roundings of contact.
 */
VESICA_API int32_t vesica_method_turned_rects_separating_lines_f64(const vesica_turned_rect_f64 *a,
                                                                   const vesica_turned_rect_f64 *b);

/**
 * The four corners of a rectangle, x0 y0 ... x3 y3, as vesica_rect_from_corners_f64 reads them.
 *
 * Their signs along and across the axis are (-, -), (+, -), (+, +), (-, +), in this order.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_RANGE (a corner is beyond the finite numbers).
 * Accuracy: each coordinate is right to 3 roundoffs of |c| + |hx u| + |hy u| plus twice the smallest positive number.
 */
VESICA_API int32_t vesica_method_rect_corners_f64(const vesica_rect_f64 *rect, double out[8]);

/**
 * Point in rectangle: is the point, in the frame of the rectangle, within the half extents?
 * Accuracy: may err within a few roundings of the outline.
 */
VESICA_API int32_t vesica_method_point_rect_frame_f64(const vesica_point_f64 *point, const vesica_rect_f64 *rect);

/**
 * Point in box: is each coordinate within the box's interval?
 * Accuracy: exact.
 */
VESICA_API int32_t vesica_method_point_aabb_intervals_f64(const vesica_point_f64 *point, const vesica_aabb_f64 *box);

/**
 * Two boxes: do their intervals meet along x and along y?
 * Accuracy: exact.
 */
VESICA_API int32_t vesica_method_aabb_aabb_intervals_f64(const vesica_aabb_f64 *a, const vesica_aabb_f64 *b);

/* ---- Circles, segments and ellipses by a formula, double. Niemitalo, 2012. ----
 * Returns: 1 if the shapes overlap (touching counts), 0 if not.
 * Errors: VESICA_E_NULL, VESICA_E_SHAPE.
 * Since: 0.1.
 */

/**
 * Circle and ellipse in closed form: the point of the ellipse nearest to the circle's centre follows from a root of a
 * quartic. The form used takes no root of a negative number and has no cancellation.
 * Accuracy: may err within a few roundings of contact. An ellipse whose smaller half axis is less than about 2^-144
 * (float: 2^-18) of the largest length, such as 0, is answered exactly.
 */
VESICA_API int32_t vesica_method_circle_ellipse_closed_form_f64(const vesica_circle_f64 *circle,
                                                                const vesica_ellipse_f64 *ellipse);

/**
 * Segment and circle without a division or a square root: a complex product turns and scales the segment onto an axis.
 * Accuracy: may err within a few roundings of contact. If numbers below about 2^-320 (float: 2^-40) of the largest
 * length matter, the answer is exact.
 */
VESICA_API int32_t vesica_method_segment_circle_division_free_f64(const vesica_segment_f64 *segment,
                                                                  const vesica_circle_f64 *circle);

/* ---- Ellipses by polygons, double. Niemitalo, 2012. ----
 * Requires: n, the most iterations, from 0 to VESICA_MOST_SANDWICH_ITERATIONS. Beyond 22 (float: 8) rounding leaves
 * nothing to gain.
 * Returns: VESICA_YES or VESICA_NO, which are certain, or VESICA_UNCERTAIN.
 * Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_ARGUMENT (n).
 * Since: 0.1.
 */

/**
 * Circle and ellipse by a polygonal sandwich: one polygon inside the ellipse and one around it.
 *
 * Each iteration refines the corner that matters, until one of the polygons decides. n iterations are as good as
 * polygons of 2^(2 + n) sides.
 * Accuracy: uncertain means that the outlines touch if the circle's radius is changed by less than out->outline_error
 * and 50 + 64 iterations roundoffs of the size of the pair.
 */
VESICA_API int32_t vesica_method_circle_ellipse_polygonal_sandwich_f64(const vesica_circle_f64 *circle,
                                                                       const vesica_ellipse_f64 *ellipse, int32_t n,
                                                                       vesica_approximation_f64 *out);

/**
 * Circle and ellipse by circle approximation: as the polygonal sandwich, with arcs of circles in place of sides.
 *
 * In the end each iteration makes the error of the outline 8 times smaller, not 4.
 * Accuracy: uncertain means that the outlines touch if the circle's radius is changed by less than out->outline_error
 * and 3 times 50 + 64 iterations roundoffs of the size of the pair.
 */
VESICA_API int32_t vesica_method_circle_ellipse_circle_approximation_f64(const vesica_circle_f64 *circle,
                                                                         const vesica_ellipse_f64 *ellipse, int32_t n,
                                                                         vesica_approximation_f64 *out);

/**
 * Two ellipses with parallel axes: b is scaled to a circle, then the polygonal sandwich answers.
 *
 * If b has a half length of at most about 2^-176 (float: 2^-22) of the largest length, a and b change places. If both
 * have, the answer is exact.
 * Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_ARGUMENT (n, or axes that as stored are neither parallel nor at right
 * angles).
 * Accuracy: out->outline_error is a's. Let e be it over b's shorter half axis, and rounding. Uncertain means that
 * b with half lengths times 1 + e overlaps a, and that b with half lengths times 1 - e, if that is > 0, does not. Here
 * a and b are the ellipses after the change of places, if there was one.
 */
VESICA_API int32_t vesica_method_ellipse_ellipse_parallel_axes_f64(const vesica_ellipse_f64 *a,
                                                                   const vesica_ellipse_f64 *b, int32_t n,
                                                                   vesica_approximation_f64 *out);

/**
 * Two ellipses with any axes: both are turned and stretched until b is a circle, then the polygonal sandwich answers.
 *
 * It starts from the images of a's radius vectors. If b has a half length of at most about 2^-176 (float: 2^-22) of the
 * largest length, a and b change places. If both have, the answer is exact.
 * Accuracy: as vesica_method_ellipse_ellipse_parallel_axes_f64, and the rounding of the images: if both are thin,
 * up to as many roundoffs of the product of the longer half axes over b's shorter one.
 */
VESICA_API int32_t vesica_method_ellipse_ellipse_any_axes_f64(const vesica_ellipse_f64 *a,
                                                              const vesica_ellipse_f64 *b, int32_t n,
                                                              vesica_approximation_f64 *out);

/**
 * Two ellipses with any axes, from centre, radius vector and ratio, as vesica_ellipse_from_radius_vector_f64 takes
 * them.
 * Accuracy: as vesica_method_ellipse_ellipse_any_axes_f64.
 */
VESICA_API int32_t vesica_method_radius_vector_ellipses_any_axes_f64(const vesica_radius_vector_ellipse_f64 *a,
                                                                     const vesica_radius_vector_ellipse_f64 *b,
                                                                     int32_t n, vesica_approximation_f64 *out);

/* ---- Distance of outlines by gradient descent, double. "Minimum Distance Between Ellipses", 2021. ----
 * Since: 0.1.
 */

/**
 * The settings that a schedule starts with.
 *
 * tolerance is 1e-8, iterations 10000. rate and decay are 1 and 0 (scale-aware), or 0.04 and 0.002 (literal).
 * Requires: schedule, one of VESICA_SCHEDULE_...
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (schedule).
 */
VESICA_API int32_t vesica_method_descent_settings_f64(int32_t schedule, vesica_descent_settings_f64 *out);

/**
 * Distance between the outlines of two ellipses by gradient descent over the angles of a point on each.
 *
 * Overlapping ellipses start from the nearest two of 24 vertices on each, disjoint ones on the line of centres. Descent
 * is in double for both scalars. The errors of the first `capacity` iterations are written to errors; what lies beyond
 * out->iterations is not written.
 * Requires: settings, or NULL for those of the scale-aware schedule; errors, with room for `capacity` numbers, or NULL
 * with capacity 0.
 * Returns: 1 if it converged, else 0, which is out->success.
 * Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_ARGUMENT (a setting, or capacity < 0), VESICA_E_RANGE (the distance
 * is beyond the finite numbers; errors may then be written).
 * Accuracy: with the scale-aware defaults the distance is never below the true one, up to rounding. Let d be the
 * distance, and s the sum of d and the larger half length of each ellipse. For disjoint ellipses the distance is right
 * to about 1e-16 s^3 / d^2; with a thin one, of aspect ratio up to 10^6, errors up to 60 times that were seen. The
 * iterations may run out if they are nearer than about s / 1000, and rarely, with a thin one, at s / 2. Outlines of
 * overlapping ellipses have several local minima: 0.4% to 3% of pairs end in one that is not the least.
 * Cost: about 18 s / d iterations; with a thin ellipse up to all.
 */
VESICA_API int32_t vesica_method_ellipse_ellipse_distance_gradient_descent_f64(
    const vesica_ellipse_f64 *a, const vesica_ellipse_f64 *b, const vesica_descent_settings_f64 *settings,
    vesica_descent_result_f64 *out, double *errors, int32_t capacity);

/* ---- The same structs and functions with float in place of double ---- */

/** As vesica_metric_closest_f64. */
typedef struct { float x, y, c_min; } vesica_metric_closest_f32;
/** As vesica_turned_rect_f64. */
typedef struct { float cx, cy, angle, width, height; } vesica_turned_rect_f32;

/** As vesica_approximation_f64, without reserved. */
typedef struct {
    float outline_error;
    int32_t iterations;
} vesica_approximation_f32;

/** As vesica_radius_vector_ellipse_f64. */
typedef struct { float cx, cy, wx, wy, ratio; } vesica_radius_vector_ellipse_f32;

/** As vesica_descent_settings_f64. */
typedef struct {
    float tolerance, rate, decay;
    int32_t iterations, schedule;
} vesica_descent_settings_f32;

/** As vesica_descent_result_f64. */
typedef struct {
    float angle_a, angle_b, distance, error;
    int32_t iterations, success;
} vesica_descent_result_f32;

/** As vesica_method_rect_ellipse_all_features_f64. */
VESICA_API int32_t vesica_method_rect_ellipse_all_features_f32(const vesica_rect_f32 *rect,
                                                               const vesica_ellipse_f32 *ellipse);
/** As vesica_method_rect_ellipse_closest_features_f64. */
VESICA_API int32_t vesica_method_rect_ellipse_closest_features_f32(const vesica_rect_f32 *rect,
                                                                   const vesica_ellipse_f32 *ellipse);
/** As vesica_method_rect_ellipse_minkowski_sum_f64. */
VESICA_API int32_t vesica_method_rect_ellipse_minkowski_sum_f32(const vesica_rect_f32 *rect,
                                                                const vesica_ellipse_f32 *ellipse);
/** As vesica_method_rect_ellipse_point_parallelogram_distance_f64. */
VESICA_API int32_t vesica_method_rect_ellipse_point_parallelogram_distance_f32(const vesica_rect_f32 *rect,
                                                                               const vesica_ellipse_f32 *ellipse,
                                                                               vesica_metric_closest_f32 *out);
/** As vesica_method_rect_rect_bounds_f64. */
VESICA_API int32_t vesica_method_rect_rect_bounds_f32(const vesica_rect_f32 *a, const vesica_rect_f32 *b);
/** As vesica_method_rect_rect_sample_points_f64. */
VESICA_API int32_t vesica_method_rect_rect_sample_points_f32(const vesica_rect_f32 *a, const vesica_rect_f32 *b,
                                                             int32_t k);
/** As vesica_method_rect_rect_separating_lines_f64. */
VESICA_API int32_t vesica_method_rect_rect_separating_lines_f32(const vesica_rect_f32 *a, const vesica_rect_f32 *b);
/** As vesica_method_turned_rects_separating_lines_f64. */
VESICA_API int32_t vesica_method_turned_rects_separating_lines_f32(const vesica_turned_rect_f32 *a,
                                                                   const vesica_turned_rect_f32 *b);
/** As vesica_method_rect_corners_f64. */
VESICA_API int32_t vesica_method_rect_corners_f32(const vesica_rect_f32 *rect, float out[8]);
/** As vesica_method_point_rect_frame_f64. */
VESICA_API int32_t vesica_method_point_rect_frame_f32(const vesica_point_f32 *point, const vesica_rect_f32 *rect);
/** As vesica_method_point_aabb_intervals_f64. */
VESICA_API int32_t vesica_method_point_aabb_intervals_f32(const vesica_point_f32 *point, const vesica_aabb_f32 *box);
/** As vesica_method_aabb_aabb_intervals_f64. */
VESICA_API int32_t vesica_method_aabb_aabb_intervals_f32(const vesica_aabb_f32 *a, const vesica_aabb_f32 *b);
/** As vesica_method_circle_ellipse_closed_form_f64. */
VESICA_API int32_t vesica_method_circle_ellipse_closed_form_f32(const vesica_circle_f32 *circle,
                                                                const vesica_ellipse_f32 *ellipse);
/** As vesica_method_segment_circle_division_free_f64. */
VESICA_API int32_t vesica_method_segment_circle_division_free_f32(const vesica_segment_f32 *segment,
                                                                  const vesica_circle_f32 *circle);
/** As vesica_method_circle_ellipse_polygonal_sandwich_f64. */
VESICA_API int32_t vesica_method_circle_ellipse_polygonal_sandwich_f32(const vesica_circle_f32 *circle,
                                                                       const vesica_ellipse_f32 *ellipse, int32_t n,
                                                                       vesica_approximation_f32 *out);
/** As vesica_method_circle_ellipse_circle_approximation_f64. */
VESICA_API int32_t vesica_method_circle_ellipse_circle_approximation_f32(const vesica_circle_f32 *circle,
                                                                         const vesica_ellipse_f32 *ellipse, int32_t n,
                                                                         vesica_approximation_f32 *out);
/** As vesica_method_ellipse_ellipse_parallel_axes_f64. */
VESICA_API int32_t vesica_method_ellipse_ellipse_parallel_axes_f32(const vesica_ellipse_f32 *a,
                                                                   const vesica_ellipse_f32 *b, int32_t n,
                                                                   vesica_approximation_f32 *out);
/** As vesica_method_ellipse_ellipse_any_axes_f64. */
VESICA_API int32_t vesica_method_ellipse_ellipse_any_axes_f32(const vesica_ellipse_f32 *a, const vesica_ellipse_f32 *b,
                                                              int32_t n, vesica_approximation_f32 *out);
/** As vesica_method_radius_vector_ellipses_any_axes_f64. */
VESICA_API int32_t vesica_method_radius_vector_ellipses_any_axes_f32(const vesica_radius_vector_ellipse_f32 *a,
                                                                     const vesica_radius_vector_ellipse_f32 *b,
                                                                     int32_t n, vesica_approximation_f32 *out);
/** As vesica_method_descent_settings_f64. */
VESICA_API int32_t vesica_method_descent_settings_f32(int32_t schedule, vesica_descent_settings_f32 *out);
/** As vesica_method_ellipse_ellipse_distance_gradient_descent_f64. */
VESICA_API int32_t vesica_method_ellipse_ellipse_distance_gradient_descent_f32(
    const vesica_ellipse_f32 *a, const vesica_ellipse_f32 *b, const vesica_descent_settings_f32 *settings,
    vesica_descent_result_f32 *out, float *errors, int32_t capacity);

#ifdef __cplusplus
}
#endif

#endif /* VESICA_METHODS_H */
