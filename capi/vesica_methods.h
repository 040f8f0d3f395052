/*
 * Vesica: the classic algorithms by name, beside the exact answer.
 *
 * SPDX-License-Identifier: Apache-2.0
 *
 * For teaching, for comparison, and for approximate work with a known bound. To know whether two shapes overlap, call
 * vesica_overlap: it is exact, and mostly faster. Methods called exact here evaluate an exact formula in the given
 * scalar's rounded arithmetic: near contact they may err, and README's table counts how often. Approximate methods
 * answer VESICA_YES, VESICA_NO or VESICA_UNCERTAIN, never a guess.
 *
 * The rules of vesica.h hold: negative VESICA_E_ errors, nothing written on error, no state, no allocation.
 */
#ifndef VESICA_METHODS_H
#define VESICA_METHODS_H

#include "vesica.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Answers. Each is also a function of the same name in lower case, for hosts without a C compiler. ---- */

#define VESICA_NO 0        /**< certainly disjoint */
#define VESICA_YES 1       /**< certainly overlapping */
#define VESICA_UNCERTAIN 2 /**< the method cannot tell; its bound says how near contact the shapes are */

/** VESICA_NO. Since 0.1. */
VESICA_API int32_t vesica_no(void);
/** VESICA_YES. Since 0.1. */
VESICA_API int32_t vesica_yes(void);
/** VESICA_UNCERTAIN. Since 0.1. */
VESICA_API int32_t vesica_uncertain(void);

/* ---- Rectangle and ellipse ---- */

/**
 * A point of a rectangle and its level in an ellipse's own measure: c_min is -1 at the ellipse's centre, 0 on its
 * outline.
 */
typedef struct {
    double x, y, c_min;
} vesica_metric_closest_f64;

/**
 * Rectangle against ellipse by all features: four vertices in the ellipse, four edges against it, its centre in the
 * rectangle (Eberly 2015, section 2).
 *
 * Returns 1 when they overlap (touching counts), 0 when not. Errors: VESICA_E_NULL, VESICA_E_SHAPE. May err within a
 * few roundings of contact; an ellipse of half length 0, or at most about 2^-176 of the largest length, is answered
 * exactly. Cost: about 25 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_ellipse_all_features_f64(const vesica_rect_f64 *rect,
                                                               const vesica_ellipse_f64 *ellipse);

/**
 * Rectangle against ellipse by closest features: which of the nine regions about the rectangle holds the ellipse's
 * centre names at most two edges and three vertices (Eberly 2015, section 3).
 *
 * Returns 1 when they overlap (touching counts), 0 when not. Errors: VESICA_E_NULL, VESICA_E_SHAPE. May err within a
 * few roundings of contact; an ellipse of half length 0, or at most about 2^-176 of the largest length, is answered
 * exactly. Cost: about 25 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_ellipse_closest_features_f64(const vesica_rect_f64 *rect,
                                                                   const vesica_ellipse_f64 *ellipse);

/**
 * Rectangle against ellipse by their Minkowski sum: does the rectangle grown by the ellipse hold its centre? (Eberly
 * 2015, section 5, corrected: the extreme points, not the signs of the centre's coordinates, tell which corner's arc
 * applies.)
 *
 * Returns 1 when they overlap (touching counts), 0 when not. Errors: VESICA_E_NULL, VESICA_E_SHAPE. May err within a
 * few roundings of contact; an ellipse of half length 0, or at most about 2^-176 of the largest length, is answered
 * exactly. Cost: about 20 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_ellipse_minkowski_sum_f64(const vesica_rect_f64 *rect,
                                                                const vesica_ellipse_f64 *ellipse);

/**
 * Rectangle against ellipse by distance of a point to a parallelogram: the rectangle's point of least level
 * Q(X) = |X - K|^2 - 1, lengths measured so that the ellipse's outline has |X - K| = 1 (Eberly 2015, section 4).
 *
 * out: that point, in the rectangle (rounded), and its level c_min. With the ellipse's centre in the rectangle it is
 * that centre and -1. Off the line of a segment (a or b = 0) every level is infinite: c_min may be, and the point is
 * then the limit of ever thinner ellipses. out may not overlap the shapes.
 * Returns 1 when they overlap, which is c_min <= 0, else 0. Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_RANGE (a
 * coordinate of the point is beyond the finite numbers). May err within a few roundings of contact, but not for the
 * ellipses that the methods before answer exactly. Cost: about 50 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_ellipse_point_parallelogram_distance_f64(const vesica_rect_f64 *rect,
                                                                               const vesica_ellipse_f64 *ellipse,
                                                                               vesica_metric_closest_f64 *out);

/**
 * A point of a rectangle and its level in an ellipse's own measure: c_min is -1 at the ellipse's centre, 0 on its
 * outline.
 */
typedef struct {
    float x, y, c_min;
} vesica_metric_closest_f32;

/**
 * Rectangle against ellipse by all features: four vertices in the ellipse, four edges against it, its centre in the
 * rectangle (Eberly 2015, section 2).
 *
 * Returns 1 when they overlap (touching counts), 0 when not. Errors: VESICA_E_NULL, VESICA_E_SHAPE. May err within a
 * few roundings of contact; an ellipse of half length 0, or at most about 2^-22 of the largest length, is answered
 * exactly. Cost: about 25 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_ellipse_all_features_f32(const vesica_rect_f32 *rect,
                                                               const vesica_ellipse_f32 *ellipse);

/**
 * Rectangle against ellipse by closest features: which of the nine regions about the rectangle holds the ellipse's
 * centre names at most two edges and three vertices (Eberly 2015, section 3).
 *
 * Returns 1 when they overlap (touching counts), 0 when not. Errors: VESICA_E_NULL, VESICA_E_SHAPE. May err within a
 * few roundings of contact; an ellipse of half length 0, or at most about 2^-22 of the largest length, is answered
 * exactly. Cost: about 25 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_ellipse_closest_features_f32(const vesica_rect_f32 *rect,
                                                                   const vesica_ellipse_f32 *ellipse);

/**
 * Rectangle against ellipse by their Minkowski sum: does the rectangle grown by the ellipse hold its centre? (Eberly
 * 2015, section 5, corrected: the extreme points, not the signs of the centre's coordinates, tell which corner's arc
 * applies.)
 *
 * Returns 1 when they overlap (touching counts), 0 when not. Errors: VESICA_E_NULL, VESICA_E_SHAPE. May err within a
 * few roundings of contact; an ellipse of half length 0, or at most about 2^-22 of the largest length, is answered
 * exactly. Cost: about 20 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_ellipse_minkowski_sum_f32(const vesica_rect_f32 *rect,
                                                                const vesica_ellipse_f32 *ellipse);

/**
 * Rectangle against ellipse by distance of a point to a parallelogram: the rectangle's point of least level
 * Q(X) = |X - K|^2 - 1, lengths measured so that the ellipse's outline has |X - K| = 1 (Eberly 2015, section 4).
 *
 * out: that point, in the rectangle (rounded), and its level c_min. With the ellipse's centre in the rectangle it is
 * that centre and -1. Off the line of a segment (a or b = 0) every level is infinite: c_min may be, and the point is
 * then the limit of ever thinner ellipses. out may not overlap the shapes.
 * Returns 1 when they overlap, which is c_min <= 0, else 0. Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_RANGE (a
 * coordinate of the point is beyond the finite numbers). May err within a few roundings of contact, but not for the
 * ellipses that the methods before answer exactly. Cost: about 50 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_ellipse_point_parallelogram_distance_f32(const vesica_rect_f32 *rect,
                                                                               const vesica_ellipse_f32 *ellipse,
                                                                               vesica_metric_closest_f32 *out);

/* ---- Rectangle and rectangle ---- */

#define VESICA_MOST_SAMPLE_POINTS 1000 /**< the largest k of vesica_method_rect_rect_sample_points */

/** VESICA_MOST_SAMPLE_POINTS. Since 0.1. */
VESICA_API int32_t vesica_most_sample_points(void);

/**
 * A rectangle as centre, angle and size: width along the angle, height across it. angle: radians, counter-clockwise
 * from +x where y points up. Valid when all are finite and width, height >= 0.
 */
typedef struct {
    double cx, cy, angle, width, height;
} vesica_turned_rect_f64;

/**
 * First pass for two rectangles: are their boxes along the coordinate axes apart? ("Rectangle intersection at 60fps")
 *
 * Returns VESICA_NO, which is certain, or VESICA_UNCERTAIN: the boxes meet, or are apart by less than 22 roundoffs of
 * their half widths. Errors: VESICA_E_NULL, VESICA_E_SHAPE. Cost: about 6 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_rect_bounds_f64(const vesica_rect_f64 *a, const vesica_rect_f64 *b);

/**
 * Two rectangles by sample points: does a corner of one, or one of k points spaced evenly along the middle of its
 * long side, lie in the other? Both ways round. ("Rectangle intersection at 60fps")
 *
 * k: 0 to VESICA_MOST_SAMPLE_POINTS. Returns VESICA_YES, which is certain, or VESICA_UNCERTAIN: no k makes the method
 * exact. With k >= 1 uncertain means that of neither one's middle line, of length l, a stretch of l / (k + 1) lies in
 * the other rectangle, once that is made smaller by 50 roundoffs of the pair's size. Errors: VESICA_E_NULL,
 * VESICA_E_SHAPE, VESICA_E_ARGUMENT (k). Cost: about 30 ns, and at worst 2 ns more for each k. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_rect_sample_points_f64(const vesica_rect_f64 *a, const vesica_rect_f64 *b,
                                                             int32_t k);

/**
 * Two rectangles by separating lines: with one of them at the origin along the axes, do all corners of the other lie
 * beyond one of its four edges' lines? Then the other way round. ("Rectangle intersection at 60fps")
 *
 * Returns 1 when they overlap (touching counts), 0 when not. Errors: VESICA_E_NULL, VESICA_E_SHAPE. May err within a
 * few roundings of contact. Cost: about 20 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_rect_separating_lines_f64(const vesica_rect_f64 *a, const vesica_rect_f64 *b);

/**
 * The same from centre, angle and size: the rectangles that vesica_rect_from_angle makes of the numbers.
 *
 * Returns and errors as vesica_method_rect_rect_separating_lines. Cost: about 60 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_turned_rects_separating_lines_f64(const vesica_turned_rect_f64 *a,
                                                                   const vesica_turned_rect_f64 *b);

/**
 * Corner points of a rectangle, x0 y0 ... x3 y3: with signs (-, -), (+, -), (+, +), (-, +) along and across its axis,
 * the order in which vesica_rect_from_corners reads them.
 *
 * Each coordinate is right to 3 roundoffs of |c| + |hx u| + |hy u|, and 2 of the smallest numbers. out: untouched on
 * error; may not overlap rect. Returns 0. Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_RANGE (a corner is beyond
 * the finite numbers). Cost: about 10 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_corners_f64(const vesica_rect_f64 *rect, double out[8]);

/**
 * Point in rectangle: the point in the rectangle's frame against its half extents.
 *
 * Returns 1 when it lies in the rectangle or on its outline, 0 when not. Errors: VESICA_E_NULL, VESICA_E_SHAPE. May
 * err within a few roundings of the outline. Cost: about 10 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_point_rect_frame_f64(const vesica_point_f64 *point, const vesica_rect_f64 *rect);

/**
 * Point in box, by comparing with the ends of its intervals; never errs. Returns and errors as the function before.
 * Since 0.1.
 */
VESICA_API int32_t vesica_method_point_aabb_intervals_f64(const vesica_point_f64 *point, const vesica_aabb_f64 *box);

/**
 * Two boxes, by their intervals along x and along y; never errs. 1 when they share a point. Returns and errors as the
 * function before. Since 0.1.
 */
VESICA_API int32_t vesica_method_aabb_aabb_intervals_f64(const vesica_aabb_f64 *a, const vesica_aabb_f64 *b);

/**
 * A rectangle as centre, angle and size: width along the angle, height across it. angle: radians, counter-clockwise
 * from +x where y points up. Valid when all are finite and width, height >= 0.
 */
typedef struct {
    float cx, cy, angle, width, height;
} vesica_turned_rect_f32;

/**
 * First pass for two rectangles: are their boxes along the coordinate axes apart? ("Rectangle intersection at 60fps")
 *
 * Returns VESICA_NO, which is certain, or VESICA_UNCERTAIN: the boxes meet, or are apart by less than 22 roundoffs of
 * their half widths. Errors: VESICA_E_NULL, VESICA_E_SHAPE. Cost: about 6 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_rect_bounds_f32(const vesica_rect_f32 *a, const vesica_rect_f32 *b);

/**
 * Two rectangles by sample points: does a corner of one, or one of k points spaced evenly along the middle of its
 * long side, lie in the other? Both ways round. ("Rectangle intersection at 60fps")
 *
 * k: 0 to VESICA_MOST_SAMPLE_POINTS. Returns VESICA_YES, which is certain, or VESICA_UNCERTAIN: no k makes the method
 * exact. With k >= 1 uncertain means that of neither one's middle line, of length l, a stretch of l / (k + 1) lies in
 * the other rectangle, once that is made smaller by 50 roundoffs of the pair's size. Errors: VESICA_E_NULL,
 * VESICA_E_SHAPE, VESICA_E_ARGUMENT (k). Cost: about 30 ns, and at worst 2 ns more for each k. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_rect_sample_points_f32(const vesica_rect_f32 *a, const vesica_rect_f32 *b,
                                                             int32_t k);

/**
 * Two rectangles by separating lines: with one of them at the origin along the axes, do all corners of the other lie
 * beyond one of its four edges' lines? Then the other way round. ("Rectangle intersection at 60fps")
 *
 * Returns 1 when they overlap (touching counts), 0 when not. Errors: VESICA_E_NULL, VESICA_E_SHAPE. May err within a
 * few roundings of contact. Cost: about 20 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_rect_separating_lines_f32(const vesica_rect_f32 *a, const vesica_rect_f32 *b);

/**
 * The same from centre, angle and size: the rectangles that vesica_rect_from_angle makes of the numbers.
 *
 * Returns and errors as vesica_method_rect_rect_separating_lines. Cost: about 60 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_turned_rects_separating_lines_f32(const vesica_turned_rect_f32 *a,
                                                                   const vesica_turned_rect_f32 *b);

/**
 * Corner points of a rectangle, x0 y0 ... x3 y3: with signs (-, -), (+, -), (+, +), (-, +) along and across its axis,
 * the order in which vesica_rect_from_corners reads them.
 *
 * Each coordinate is right to 3 roundoffs of |c| + |hx u| + |hy u|, and 2 of the smallest numbers. out: untouched on
 * error; may not overlap rect. Returns 0. Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_RANGE (a corner is beyond
 * the finite numbers). Cost: about 10 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_rect_corners_f32(const vesica_rect_f32 *rect, float out[8]);

/**
 * Point in rectangle: the point in the rectangle's frame against its half extents.
 *
 * Returns 1 when it lies in the rectangle or on its outline, 0 when not. Errors: VESICA_E_NULL, VESICA_E_SHAPE. May
 * err within a few roundings of the outline. Cost: about 10 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_point_rect_frame_f32(const vesica_point_f32 *point, const vesica_rect_f32 *rect);

/**
 * Point in box, by comparing with the ends of its intervals; never errs. Returns and errors as the function before.
 * Since 0.1.
 */
VESICA_API int32_t vesica_method_point_aabb_intervals_f32(const vesica_point_f32 *point, const vesica_aabb_f32 *box);

/**
 * Two boxes, by their intervals along x and along y; never errs. 1 when they share a point. Returns and errors as the
 * function before. Since 0.1.
 */
VESICA_API int32_t vesica_method_aabb_aabb_intervals_f32(const vesica_aabb_f32 *a, const vesica_aabb_f32 *b);

/* ---- Ellipses and circles ---- */

#define VESICA_MOST_SANDWICH_ITERATIONS 30 /**< the largest n of the methods on ellipses that halve */

/** VESICA_MOST_SANDWICH_ITERATIONS. Since 0.1. */
VESICA_API int32_t vesica_most_sandwich_iterations(void);

/**
 * How far an approximate method went: the bound on the outline's error that it reached, and the halvings it did.
 *
 * outline_error: 2^(0.303 - 2 iterations) times the longer half axis, in units of length; may be infinite where that
 * is. No point of the inner or outer polygon is farther from the outline. 0 when the exact vesica_overlap answered.
 * reserved: 0.
 */
typedef struct {
    double outline_error;
    int32_t iterations, reserved;
} vesica_approximation_f64;

/**
 * An ellipse as centre, radius vector w (half an axis) and ratio of the other radius to it. Valid when finite, with
 * ratio >= 0. A zero vector makes it a point.
 */
typedef struct {
    double cx, cy, wx, wy, ratio;
} vesica_radius_vector_ellipse_f64;

/**
 * Circle against ellipse in closed form: the ellipse's point nearest to the circle's centre is the root of a quartic
 * (Niemitalo 2012, in a form that takes no root of a negative number and cancels nowhere).
 *
 * Returns 1 when they overlap (touching counts), 0 when not. Errors: VESICA_E_NULL, VESICA_E_SHAPE. May err within a
 * few roundings of contact; an ellipse whose smaller half axis is 0, or less than about 2^-144 of the largest length,
 * is answered exactly. Cost: about 40 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_circle_ellipse_closed_form_f64(const vesica_circle_f64 *circle,
                                                                const vesica_ellipse_f64 *ellipse);

/**
 * Circle against ellipse by a polygonal sandwich: inscribed and circumscribed polygons, of which the corner that
 * matters is halved until one of them decides (Niemitalo 2012). n iterations amount to 2^(2 + n) sides.
 *
 * n: 0 to VESICA_MOST_SANDWICH_ITERATIONS; beyond 22 rounding leaves nothing to be gained. out: untouched on error; may
 * not overlap the shapes. Returns VESICA_YES or VESICA_NO, which are certain, or VESICA_UNCERTAIN: outlines touch when
 * the circle's radius changes by less than outline_error, and 50 + 64 iterations roundoffs of the pair's size. Errors:
 * VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_ARGUMENT (n). Cost: about 35 ns, and 10 ns for each iteration done.
 * Since 0.1.
 */
VESICA_API int32_t vesica_method_circle_ellipse_polygonal_sandwich_f64(const vesica_circle_f64 *circle,
                                                                       const vesica_ellipse_f64 *ellipse, int32_t n,
                                                                       vesica_approximation_f64 *out);

/**
 * Circle against ellipse by circle approximation: as the polygonal sandwich, with circle segments in place of the
 * polygons' sides. In the end each iteration makes the outline's error 8 times smaller, not 4.
 *
 * n, out, returns and errors as there, and the bound too, with three times the rounding. Cost: about 45 ns, and 8
 * ns for each iteration done. Since 0.1.
 */
VESICA_API int32_t vesica_method_circle_ellipse_circle_approximation_f64(const vesica_circle_f64 *circle,
                                                                         const vesica_ellipse_f64 *ellipse, int32_t n,
                                                                         vesica_approximation_f64 *out);

/**
 * Segment against circle without a division or a square root: turned and scaled as a complex product does, the segment
 * lies on an axis (Niemitalo 2012).
 *
 * Returns 1 when they overlap (touching counts), 0 when not. Errors: VESICA_E_NULL, VESICA_E_SHAPE. May err within a
 * few roundings of contact; numbers below about 2^-320 of the largest length, where they matter, are answered exactly.
 * Cost: about 15 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_segment_circle_division_free_f64(const vesica_segment_f64 *segment,
                                                                  const vesica_circle_f64 *circle);

/**
 * Two ellipses with parallel axes, by scaling the second to a circle; then the polygonal sandwich (Niemitalo 2012).
 *
 * n, out and returns as there; outline_error is a's. VESICA_UNCERTAIN: b with half lengths times 1 + e overlaps a, and
 * with 1 - e, when that is positive, does not; e is outline_error over b's shorter half axis, and rounding. If b has a
 * half length of 0 (or below about 2^-176, float 2^-22, of the largest length), a and b change places; if both have,
 * the answer is exact. Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_ARGUMENT (n, or axes that as stored are neither
 * parallel nor at right angles). Cost: about 45 ns, and 10 ns for each iteration done. Since 0.1.
 */
VESICA_API int32_t vesica_method_ellipse_ellipse_parallel_axes_f64(const vesica_ellipse_f64 *a,
                                                                   const vesica_ellipse_f64 *b, int32_t n,
                                                                   vesica_approximation_f64 *out);

/**
 * Two ellipses with any axes, by turning and stretching until the second is a circle; then the polygonal sandwich, from
 * the images of the first one's radius vectors (Niemitalo 2012).
 *
 * As the function before, but axes may have any directions. Rounding is that of the images: where both are thin it is
 * up to so many roundoffs of the product of the longer half axes over b's shorter one. Errors: VESICA_E_NULL,
 * VESICA_E_SHAPE, VESICA_E_ARGUMENT (n). Cost: about 65 ns, and 10 ns for each iteration done. Since 0.1.
 */
VESICA_API int32_t vesica_method_ellipse_ellipse_any_axes_f64(const vesica_ellipse_f64 *a,
                                                              const vesica_ellipse_f64 *b, int32_t n,
                                                              vesica_approximation_f64 *out);

/**
 * The same from centre, radius vector and ratio: the ellipses that vesica_ellipse_from_radius_vector makes of the
 * numbers.
 *
 * Returns and errors as the function before. Cost: as there. Since 0.1.
 */
VESICA_API int32_t vesica_method_radius_vector_ellipses_any_axes_f64(const vesica_radius_vector_ellipse_f64 *a,
                                                                     const vesica_radius_vector_ellipse_f64 *b,
                                                                     int32_t n, vesica_approximation_f64 *out);

/**
 * How far an approximate method went: the bound on the outline's error that it reached, and the halvings it did.
 *
 * outline_error: 2^(0.303 - 2 iterations) times the longer half axis, in units of length; may be infinite where that
 * is. No point of the inner or outer polygon is farther from the outline. 0 when the exact vesica_overlap answered.
 */
typedef struct {
    float outline_error;
    int32_t iterations;
} vesica_approximation_f32;

/**
 * An ellipse as centre, radius vector w (half an axis) and ratio of the other radius to it. Valid when finite, with
 * ratio >= 0. A zero vector makes it a point.
 */
typedef struct {
    float cx, cy, wx, wy, ratio;
} vesica_radius_vector_ellipse_f32;

/**
 * Circle against ellipse in closed form: the ellipse's point nearest to the circle's centre is the root of a quartic
 * (Niemitalo 2012, in a form that takes no root of a negative number and cancels nowhere).
 *
 * Returns 1 when they overlap (touching counts), 0 when not. Errors: VESICA_E_NULL, VESICA_E_SHAPE. May err within a
 * few roundings of contact; an ellipse whose smaller half axis is 0, or less than about 2^-18 of the largest length, is
 * answered exactly. Cost: about 40 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_circle_ellipse_closed_form_f32(const vesica_circle_f32 *circle,
                                                                const vesica_ellipse_f32 *ellipse);

/**
 * Circle against ellipse by a polygonal sandwich: inscribed and circumscribed polygons, of which the corner that
 * matters is halved until one of them decides (Niemitalo 2012). n iterations amount to 2^(2 + n) sides.
 *
 * n: 0 to VESICA_MOST_SANDWICH_ITERATIONS; beyond 8 rounding leaves nothing to be gained. out: untouched on error; may
 * not overlap the shapes. Returns VESICA_YES or VESICA_NO, which are certain, or VESICA_UNCERTAIN: outlines touch when
 * the circle's radius changes by less than outline_error, and 50 + 64 iterations roundoffs of the pair's size. Errors:
 * VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_ARGUMENT (n). Cost: about 35 ns, and 10 ns for each iteration done.
 * Since 0.1.
 */
VESICA_API int32_t vesica_method_circle_ellipse_polygonal_sandwich_f32(const vesica_circle_f32 *circle,
                                                                       const vesica_ellipse_f32 *ellipse, int32_t n,
                                                                       vesica_approximation_f32 *out);

/**
 * Circle against ellipse by circle approximation: as the polygonal sandwich, with circle segments in place of the
 * polygons' sides. In the end each iteration makes the outline's error 8 times smaller, not 4.
 *
 * n, out, returns and errors as there, and the bound too, with three times the rounding. Cost: about 45 ns, and 8
 * ns for each iteration done. Since 0.1.
 */
VESICA_API int32_t vesica_method_circle_ellipse_circle_approximation_f32(const vesica_circle_f32 *circle,
                                                                         const vesica_ellipse_f32 *ellipse, int32_t n,
                                                                         vesica_approximation_f32 *out);

/**
 * Segment against circle without a division or a square root: turned and scaled as a complex product does, the segment
 * lies on an axis (Niemitalo 2012).
 *
 * Returns 1 when they overlap (touching counts), 0 when not. Errors: VESICA_E_NULL, VESICA_E_SHAPE. May err within a
 * few roundings of contact; numbers below about 2^-40 of the largest length, where they matter, are answered exactly.
 * Cost: about 15 ns. Since 0.1.
 */
VESICA_API int32_t vesica_method_segment_circle_division_free_f32(const vesica_segment_f32 *segment,
                                                                  const vesica_circle_f32 *circle);

/**
 * Two ellipses with parallel axes, by scaling the second to a circle; then the polygonal sandwich (Niemitalo 2012).
 *
 * n, out and returns as there; outline_error is a's. VESICA_UNCERTAIN: b with half lengths times 1 + e overlaps a, and
 * with 1 - e, when that is positive, does not; e is outline_error over b's shorter half axis, and rounding. If b has a
 * half length of 0 (or below about 2^-176, float 2^-22, of the largest length), a and b change places; if both have,
 * the answer is exact. Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_ARGUMENT (n, or axes that as stored are neither
 * parallel nor at right angles). Cost: about 45 ns, and 10 ns for each iteration done. Since 0.1.
 */
VESICA_API int32_t vesica_method_ellipse_ellipse_parallel_axes_f32(const vesica_ellipse_f32 *a,
                                                                   const vesica_ellipse_f32 *b, int32_t n,
                                                                   vesica_approximation_f32 *out);

/**
 * Two ellipses with any axes, by turning and stretching until the second is a circle; then the polygonal sandwich, from
 * the images of the first one's radius vectors (Niemitalo 2012).
 *
 * As the function before, but axes may have any directions. Rounding is that of the images: where both are thin it is
 * up to so many roundoffs of the product of the longer half axes over b's shorter one. Errors: VESICA_E_NULL,
 * VESICA_E_SHAPE, VESICA_E_ARGUMENT (n). Cost: about 65 ns, and 10 ns for each iteration done. Since 0.1.
 */
VESICA_API int32_t vesica_method_ellipse_ellipse_any_axes_f32(const vesica_ellipse_f32 *a,
                                                              const vesica_ellipse_f32 *b, int32_t n,
                                                              vesica_approximation_f32 *out);

/**
 * The same from centre, radius vector and ratio: the ellipses that vesica_ellipse_from_radius_vector makes of the
 * numbers.
 *
 * Returns and errors as the function before. Cost: as there. Since 0.1.
 */
VESICA_API int32_t vesica_method_radius_vector_ellipses_any_axes_f32(const vesica_radius_vector_ellipse_f32 *a,
                                                                     const vesica_radius_vector_ellipse_f32 *b,
                                                                     int32_t n, vesica_approximation_f32 *out);

/* ---- Distance between outlines by gradient descent ---- */

#define VESICA_SCHEDULE_SCALE_AWARE 0          /**< steps in proportion to the pair: the same at any scale, never up */
#define VESICA_SCHEDULE_LITERAL 1              /**< steps as printed, which fit shapes of size about 5 */
#define VESICA_MOST_DESCENT_ITERATIONS 1000000 /**< the most iterations that may be asked for */

/** VESICA_SCHEDULE_SCALE_AWARE. Since 0.1. */
VESICA_API int32_t vesica_schedule_scale_aware(void);
/** VESICA_SCHEDULE_LITERAL. Since 0.1. */
VESICA_API int32_t vesica_schedule_literal(void);
/** VESICA_MOST_DESCENT_ITERATIONS. Since 0.1. */
VESICA_API int32_t vesica_most_descent_iterations(void);

/**
 * How to descend. Step i = 0, 1 ... changes the two angles by rate * exp(-decay i) times a gradient; the error is that
 * gradient's larger component, and descent stops when it is below the tolerance.
 *
 * Literal: the gradient of the squared distance, in squared units of length. Scale-aware: half of it, each component
 * divided by R (R + R' + d), R the larger half length of its ellipse, R' of the other one, d the distance; in radians.
 * Valid when finite, with tolerance > 0, rate > 0 (scale-aware: < 2), decay >= 0, and iterations from 1 to
 * VESICA_MOST_DESCENT_ITERATIONS. schedule: VESICA_SCHEDULE_...
 */
typedef struct {
    double tolerance, rate, decay;
    int32_t iterations, schedule;
} vesica_descent_settings_f64;

/**
 * The two outline points as angles t of C + a cos(t) u + b sin(t) perp(u), in radians of [-pi, pi]; their distance; the
 * error there; how often the gradient was evaluated; 1 when the error came below the tolerance, else 0.
 */
typedef struct {
    double angle_a, angle_b, distance, error;
    int32_t iterations, success;
} vesica_descent_result_f64;

/**
 * The settings that a schedule starts with: tolerance 1e-8, 10000 iterations, and rate and decay of 1 and 0
 * (scale-aware) or 0.04 and 0.002 (literal).
 *
 * out: untouched on error. Returns 0. Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (schedule). Since 0.1.
 */
VESICA_API int32_t vesica_method_descent_settings_f64(int32_t schedule, vesica_descent_settings_f64 *out);

/**
 * Distance between the outlines of two ellipses by gradient descent over the angles of a point on each ("Minimum
 * Distance Between Ellipses", 2021). Overlapping ones start from the nearest of 24 x 24 vertices, others on the line of
 * centres. Descent is in double for both scalars.
 *
 * settings: NULL for the scale-aware defaults. errors: the first `capacity` iterations' errors, or NULL with capacity
 * 0; what lies beyond out->iterations is untouched. Nothing written may overlap anything else.
 * Returns 1 when it converged, else 0, which is out->success. Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_ARGUMENT
 * (a setting, or capacity < 0), VESICA_E_RANGE (the distance is beyond the finite numbers; errors may then be written).
 *
 * Accuracy (scale-aware, defaults): never below the true distance but by rounding; with s the two larger half lengths
 * and the distance d, within about 1e-16 s^3 / d^2 of it for disjoint ellipses. Nearer contact than about s / 1000 the
 * iterations may run out. Of overlapping ones, whose outlines have several local minima, 0.4% to 3% end in one that is
 * not the least. Cost: 60 ns an iteration, about 18 s / d iterations. Since 0.1.
 */
VESICA_API int32_t vesica_method_ellipse_ellipse_distance_gradient_descent_f64(
    const vesica_ellipse_f64 *a, const vesica_ellipse_f64 *b, const vesica_descent_settings_f64 *settings,
    vesica_descent_result_f64 *out, double *errors, int32_t capacity);

/**
 * How to descend. Step i = 0, 1 ... changes the two angles by rate * exp(-decay i) times a gradient; the error is that
 * gradient's larger component, and descent stops when it is below the tolerance.
 *
 * Literal: the gradient of the squared distance, in squared units of length. Scale-aware: half of it, each component
 * divided by R (R + R' + d), R the larger half length of its ellipse, R' of the other one, d the distance; in radians.
 * Valid when finite, with tolerance > 0, rate > 0 (scale-aware: < 2), decay >= 0, and iterations from 1 to
 * VESICA_MOST_DESCENT_ITERATIONS. schedule: VESICA_SCHEDULE_...
 */
typedef struct {
    float tolerance, rate, decay;
    int32_t iterations, schedule;
} vesica_descent_settings_f32;

/**
 * The two outline points as angles t of C + a cos(t) u + b sin(t) perp(u), in radians of [-pi, pi]; their distance; the
 * error there; how often the gradient was evaluated; 1 when the error came below the tolerance, else 0.
 */
typedef struct {
    float angle_a, angle_b, distance, error;
    int32_t iterations, success;
} vesica_descent_result_f32;

/**
 * The settings that a schedule starts with: tolerance 1e-8, 10000 iterations, and rate and decay of 1 and 0
 * (scale-aware) or 0.04 and 0.002 (literal).
 *
 * out: untouched on error. Returns 0. Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (schedule). Since 0.1.
 */
VESICA_API int32_t vesica_method_descent_settings_f32(int32_t schedule, vesica_descent_settings_f32 *out);

/**
 * Distance between the outlines of two ellipses by gradient descent over the angles of a point on each ("Minimum
 * Distance Between Ellipses", 2021). Overlapping ones start from the nearest of 24 x 24 vertices, others on the line of
 * centres. Descent is in double for both scalars.
 *
 * settings: NULL for the scale-aware defaults. errors: the first `capacity` iterations' errors, or NULL with capacity
 * 0; what lies beyond out->iterations is untouched. Nothing written may overlap anything else.
 * Returns 1 when it converged, else 0, which is out->success. Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_ARGUMENT
 * (a setting, or capacity < 0), VESICA_E_RANGE (the distance is beyond the finite numbers; errors may then be written).
 *
 * Accuracy (scale-aware, defaults): never below the true distance but by rounding; with s the two larger half lengths
 * and the distance d, within about 1e-16 s^3 / d^2 of it for disjoint ellipses. Nearer contact than about s / 1000 the
 * iterations may run out. Of overlapping ones, whose outlines have several local minima, 0.4% to 3% end in one that is
 * not the least. Cost: 60 ns an iteration, about 18 s / d iterations. Since 0.1.
 */
VESICA_API int32_t vesica_method_ellipse_ellipse_distance_gradient_descent_f32(
    const vesica_ellipse_f32 *a, const vesica_ellipse_f32 *b, const vesica_descent_settings_f32 *settings,
    vesica_descent_result_f32 *out, float *errors, int32_t capacity);

#ifdef __cplusplus
}
#endif

#endif /* VESICA_METHODS_H */
