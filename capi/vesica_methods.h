/*
 * Vesica: the classic algorithms by name, beside the exact answer.
 *
 * SPDX-License-Identifier: Apache-2.0
 *
 * For teaching, for comparison, and for approximate work with a known bound. To know whether two shapes overlap, call
 * vesica_overlap: it is exact, and mostly faster. Methods called exact here evaluate an exact formula in the given
 * scalar's rounded arithmetic: near contact they may err, and README's table counts how often. Approximate methods answer
 * VESICA_YES, VESICA_NO or VESICA_UNCERTAIN, never a guess.
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

/* ---- Distance between outlines by gradient descent ---- */

#ifdef __cplusplus
}
#endif

#endif /* VESICA_METHODS_H */
