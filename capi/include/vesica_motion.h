/*
 * Vesica: shapes that move. Rays, casts, the first of many shapes that is hit, and contacts.
 *
 * SPDX-License-Identifier: Apache-2.0
 *
 * vesica.h includes this header, and both belong to one library.
 *
 * Shape a is at rest, and b is moved by t (vx, vy) while t runs from 0 to t_end, which may be infinite. A ray is a
 * point that moves. Velocity and t_end are taken as exactly the numbers given, and their product is not rounded. If you
 * move b by time and velocity in floating point, the place may differ by a rounding.
 *
 * Contact is decided exactly for all valid shapes; touching counts. The time is the time of first contact, rounded
 * down: the greatest number of its type with no contact before it.
 *
 * The rules of vesica.h hold. Comments have the same parts: Requires, Returns, Errors, Accuracy, Cost, Since.
 */
#ifndef VESICA_MOTION_H
#define VESICA_MOTION_H

#include "vesica_index.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Constants ---- */

/* Results of a cast. */
#define VESICA_CAST_MISS 0  /**< no contact from 0 to t_end */
#define VESICA_CAST_HIT 1   /**< contact, the first after t = 0 */
#define VESICA_CAST_START 2 /**< the shapes overlap at t = 0, as vesica_overlap_f64 says */
#define VESICA_CAST_NEAR 3  /**< only from vesica_impact_time_f64: none before t, and perhaps none later */

/* ---- Motion, double ----
 * Requires: vx and vy finite; both may be 0. t_end >= 0, or infinity.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a velocity that is not finite, a t_end that is negative or
 * NaN), VESICA_E_SHAPE, VESICA_E_RANGE (the time, or a coordinate of the point, would overflow; or an exact position
 * would take more than 2000 bits, as with magnitudes of both 2^1000 and 2^-1000).
 * Since: 0.1.
 */

/**
 * A first contact: its time t, its point (x, y), and the unit normal (nx, ny) there, from a to b.
 *
 * After a miss t is infinity and all other numbers are NaN.
 */
typedef struct {
    double t, x, y, nx, ny;
} vesica_impact_f64;

/**
 * Does b touch a while it moves, when first, and where?
 *
 * The normal belongs to the face or the round outline that is hit. If a corner hits a corner, it belongs to an edge
 * there. If b only slides along a, it is perpendicular to the velocity. At an angle below 2^-80 to a face, the normal
 * may belong to the face beside it, and the point their corner. If two faces meet, the point is the middle of what
 * they share.
 * Shapes that overlap at the start have t = 0, the direction of vesica_depth_f64 and the point of vesica_nearest_f64.
 * Shapes that only touch at the start move apart or slide if (nx, ny).(vx, vy) >= 0. Otherwise they approach, but where
 * corners meet, or a shape has no area, they may also separate.
 * Exchanging the shapes and reversing the velocity changes neither the answer nor the time. It reverses the normal, up
 * to rounding.
 * A polygon or polyline is hit as the first of its edges is. Of several edges hit at one time, one hit from the front
 * counts before one that b slides along. If it overlaps at the start and both shapes are convex, the normal is as said
 * above. Otherwise it is that of the overlapping edge that b moves into most directly, or (0, 0) if no edge overlaps.
 * Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
 * Accuracy: the answer is exact, and the time is rounded down. The point is within 8 u scale of a's outline
 * before it is rounded; along the outline it may be off by (8 u scale + 4 u R) / |n.v|, n and v of unit length, R the
 * greatest radius of curvature of a: of an ellipse its long half length squared over the short one, far more than its
 * size if it is thin. The normal has length 1 to 4 u.
 * Cost: a small multiple of vesica_overlap_f64 for a miss, ten times that for a hit. Rays (b a point), two circles and
 * two ellipses take less. For polygons, a few comparisons an edge, and a cast for each edge in the swept box.
 */
VESICA_API int32_t vesica_cast_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b, double vx, double vy,
                                   double t_end, vesica_impact_f64 *out);

/**
 * When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]? The columns are the fields of vesica_cast_f64's
 * result.
 *
 * Velocity i is `i * stride` bytes after vx and vy; stride 0 repeats one velocity.
 * Requires: velocities and t_end as vesica_cast_f64; equal counts, or one count of 1, whose shape is used for all. Each
 * output has room for as many numbers as the larger count. Some, but not all, may be NULL. vx and vy need no alignment;
 * without pairs they may be NULL.
 * Returns: how many touch, including those that overlap at the start.
 * Errors: those of vesica_cast_f64. An element with an invalid shape, a velocity that is not finite or a result out of
 * range gets NaN for all its numbers, and all others are written as usual. The call then returns VESICA_E_SHAPE if a
 * shape is invalid, else the error of the last such element.
 * Accuracy: every result has the same bits as vesica_cast_f64.
 * Cost: as vesica_cast_f64 for each pair; with AVX2 or AVX-512 a half to an eighth of it, except for pairs that
 * overlap at the start.
 */
VESICA_API int64_t vesica_cast_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, const double *vx,
                                        const double *vy, ptrdiff_t stride, double t_end, double *t, double *x,
                                        double *y, double *nx, double *ny);

/**
 * Which of many shapes at rest does one moving shape touch first? If several are touched at that time, the one with the
 * lowest index.
 * Requires: one, the shape that moves, an array of count 1; vx, vy and t_end as vesica_cast_f64.
 * Returns: its index, or the count of `many` if none is touched. *out is its contact, the normal pointing to `one`.
 * Errors: those of vesica_cast_f64. VESICA_E_SHAPE if any shape is invalid. VESICA_E_RANGE only if vesica_cast_f64
 * returns it for a shape that might be touched first.
 * Cost: less than vesica_cast_f64 for each shape that is missed.
 */
VESICA_API int64_t vesica_cast_first_f64(const vesica_shapes_f64 *one, const vesica_shapes_f64 *many, double vx,
                                         double vy, double t_end, vesica_impact_f64 *out);

/**
 * A box that holds a shape throughout its motion, t from 0 to t_end. The shape touches nothing outside it.
 * Returns: 0.
 * Errors: those of vesica_cast_f64; VESICA_E_RANGE if a side would overflow.
 * Accuracy: a side that does not move is as of vesica_bounds_f64. One that moves is too far out by less than 5.5
 * units in the last place of the largest of three numbers: the side at rest, the way it moves, and where it ends.
 */
VESICA_API int32_t vesica_sweep_bounds_f64(int32_t kind, const void *shape, double vx, double vy, double t_end,
                                           vesica_aabb_f64 *out);

/**
 * Which items of an index does one moving shape touch? They come in the index's order.
 * Requires: sets are those of the index. one, an array of count 1; vx, vy and t_end as vesica_cast_f64. out has room
 * for `capacity` items. With capacity 0, out and state may be NULL.
 * Returns: the number of items written; with capacity 0, how many there are. If state[0] is not -1 then, there are
 * more, and the same call continues (vesica_index.h).
 * Errors: those of vesica_cast_f64, and VESICA_E_INDEX; VESICA_E_ARGUMENT also for sets of another number of items
 * than the index, a pointer that is not aligned, or a state from another function (vesica_index.h). VESICA_E_RANGE only
 * if an item is undecided, because its exact position at t_end would take more than 2000 bits. Then nothing is written,
 * the state is behind that item, and the same call continues; with capacity 0 there is no count.
 * Invalid items are never touched.
 * Accuracy: exact.
 * Cost: a search, and vesica_cast_f64 for each item whose box the swept box meets.
 */
VESICA_API int64_t vesica_index_cast_f64(const void *index, const vesica_shapes_f64 *sets, int32_t set_count,
                                         const vesica_shapes_f64 *one, double vx, double vy, double t_end, int64_t *out,
                                         int64_t capacity, int64_t *state);

/**
 * Which item of an index does one moving shape touch first? If several are touched at that time, the lowest item.
 * Requires: sets are those of the index. one, an array of count 1; vx, vy and t_end as vesica_cast_f64.
 * Returns: the item, or the index's count if none is touched. *out is its contact, the normal pointing to `one`.
 * Errors: those of vesica_index_cast_f64; VESICA_E_RANGE only as for vesica_cast_first_f64.
 * Cost: a search, and vesica_cast_f64 for the few items near the ray.
 */
VESICA_API int64_t vesica_index_cast_first_f64(const void *index, const vesica_shapes_f64 *sets, int32_t set_count,
                                               const vesica_shapes_f64 *one, double vx, double vy, double t_end,
                                               vesica_impact_f64 *out);

/**
 * How a shape moves while t runs from 0 to 1: the way (vx, vy) of its centre, and the angle in radians by which it
 * turns about its centre. Positive angles turn counter-clockwise if y points up.
 */
typedef struct {
    double vx, vy, angle;
} vesica_turn_f64;

/**
 * When do two shapes that move and turn touch first? It is proved that there is no contact before t, however thin the
 * shapes are and however fast they turn.
 *
 * At t, from 0 to 1, a centre has moved by t (vx, vy) and an axis has turned by t times the angle, without rounding.
 * *out describes that moment: the point of a that is nearest to b, and the normal that separates them. They are then at
 * most *gap apart. A polygon must be convex, and its centre is the middle of its bounds, each coordinate rounded to a
 * double; a path on one line is a segment.
 * Requires: numbers of turn_a and turn_b finite, angles at most 2^20 in magnitude; tolerance, a length > 0. No pointer
 * may be NULL.
 * Returns: VESICA_CAST_MISS: it is proved that there is no contact from 0 to 1; t is infinity, and all other numbers
 * and the gap are NaN. VESICA_CAST_HIT: it is proved that there is contact after t. VESICA_CAST_NEAR: there may be
 * contact after t; contact of a point with a segment or a point, where there is no depth, is never proved.
 * VESICA_CAST_START: the shapes overlap at t = 0, which is exact; *out is as of vesica_cast_f64, and the gap is 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_NOT_CONVEX, VESICA_E_RANGE (a
 * coordinate of the point, or the gap, would overflow).
 * Accuracy: what is said to be proved is certain. The gap is at most the tolerance, except in two cases: the tolerance
 * is below (300 + 10 |angles|) u times the sum of all lengths, the motion's included, u = 2^-53; or the search stopped
 * after 256 directions or 4096 poses. Angles above 10^5 often stop it: then only the gap says that it exceeds the
 * tolerance, so compare them.
 * Cost: a small multiple of vesica_cast_f64; a thousand times that at angles of 10^6 radians. For two polygons it grows
 * with the product of their numbers of vertices.
 * Since: 0.1.
 */
VESICA_API int32_t vesica_impact_time_f64(int32_t kind_a, const void *a, const vesica_turn_f64 *turn_a, int32_t kind_b,
                                          const void *b, const vesica_turn_f64 *turn_b, double tolerance,
                                          vesica_impact_f64 *out, double *gap);

/**
 * Which item of an index does a shape that moves and turns touch first? It is proved that there is no contact with any
 * item before t.
 *
 * The items are at rest. Each is asked as by vesica_impact_time_f64, the item as a and `one` as b; the one with the
 * least t counts, and of several the lowest. *out, *gap and *answer are its results. Items are not asked if they stay
 * farther than the tolerance from all places of `one`, nor if they are first that near after t.
 * Requires: sets are those of the index. one, an array of count 1; turn and tolerance as for vesica_impact_time_f64.
 * Returns: the item, with *answer VESICA_CAST_HIT, _NEAR or _START; or the index's count, with VESICA_CAST_MISS.
 * Errors: those of vesica_index_cast_f64; VESICA_E_RANGE, and VESICA_E_NOT_CONVEX of a polygon in the index, only for
 * an item that might be touched first.
 * Cost: a search, and vesica_impact_time_f64 for the items near the way.
 * Since: 0.1.
 */
VESICA_API int64_t vesica_index_impact_time_f64(const void *index, const vesica_shapes_f64 *sets, int32_t set_count,
                                                const vesica_shapes_f64 *one, const vesica_turn_f64 *turn,
                                                double tolerance, vesica_impact_f64 *out, double *gap, int32_t *answer);

/* ---- Contacts of overlapping shapes, double: what a physics solver needs ----
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_NOT_CONVEX, VESICA_E_RANGE (a depth or a coordinate
 * would overflow).
 * Since: 0.1.
 */

/**
 * The contacts of two overlapping convex shapes: their count, 0 to 2, and one unit normal (nx, ny) from a to b.
 *
 * Contact 0 is at (x0, y0) with depth0, and numbers a0 of shape a and b0 of shape b name it; likewise contact 1. All
 * numbers of a contact that is missing are 0, and so is the normal if there is none.
 */
typedef struct {
    double nx, ny, x0, y0, depth0, x1, y1, depth1;
    int64_t a0, b0, a1, b1, count;
} vesica_contacts_f64;

/**
 * Contact manifold: where do two convex shapes press on each other, how deep, and along which normal?
 *
 * The normal is the direction of vesica_depth_f64, and the greatest depth is its depth. The facing edge of a is the
 * edge whose outward normal is nearest to (nx, ny), and that of b the one whose outward normal is nearest to the
 * opposite. Edges of capsules and rounded rectangles are those of the core, moved along the normal by the radius. Seen
 * along the normal, both edges are intervals. The contacts are at both ends of what the intervals share, in the order
 * of the normal turned counter-clockwise by a right angle. The depth there is how far a's edge is beyond b's along the
 * normal, and the point is midway. If a depth is below 0, that contact is left out.
 * There is one contact if one shape has no edge (a point, a circle, an ellipse, a shape without a size), if the
 * intervals share no more than e, or if a depth is below -e; between that and 0 it is 0. Otherwise there are two. e is
 * about 2^-47 scale, which is rounding.
 * As a box tilts, its second depth falls to 0 before its contact is left out; as it slides off an edge, both contacts
 * become one place. So no threshold decides what is parallel. Where another edge, or another normal, becomes the
 * nearest, the normal, the numbers and the lesser contact may jump; the greatest depth never does.
 * a0 and b0 are the numbers of the vertices at which the facing edges end on contact 0's side. So they stay while the
 * same edges face each other, whichever is the longer. An edge beside a shape without one has the number of its first
 * vertex counter-clockwise, and a shape without an edge 0. Vertices of polygons count as stored. Edges on one line, to
 * e, are one edge, and a vertex that is repeated has one of its numbers. Vertices of an AABB, a rectangle and a rounded
 * one count from (-hx, -hy) in its frame: (hx, -hy) is 1, (hx, hy) 2, as in vesica_corners_of_shapes_f64. A segment and
 * a capsule begin at vertex 0. So does a polygon or polyline on one line, at its leftmost vertex. An ellipse with a
 * half length of 0 counts as a rectangle.
 * Exchanging the shapes reverses the normal, the numbers and the order, and changes no other bit, except for two equal
 * shapes in one place. Moving both alike changes no depth if no coordinate is rounded.
 * For contacts before the shapes touch, give them a radius: round_rect in place of rect. Then subtract both radii.
 * Returns: the count; 0 for disjoint shapes.
 * Accuracy: the normal and the greatest depth have the bits of vesica_depth_f64. The lesser depth and the points are
 * right to 16 u scale (1 + s), where s is the slope of the steeper edge against the line across the normal, at most 1
 * where corners have 90 degrees or more; the points also to 16 u of their coordinates and the radii. To that comes
 * 4 e where edges were joined, or where a depth below 0 has become 0.
 * Cost: one and a half to three times vesica_depth_f64.
 */
VESICA_API int32_t vesica_manifold_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b,
                                       vesica_contacts_f64 *out);

/**
 * The contacts of a[i] and b[i].
 * Requires: equal counts, or one count of 1, whose shape is used for all. out has room for as many manifolds as the
 * larger count.
 * Returns: how many pairs have a contact.
 * Errors: also VESICA_E_ARGUMENT, as vesica_depth_many_f64. A pair with an error has that error for its count, and 0
 * for all else; the others are written as usual. The call then returns VESICA_E_SHAPE if a shape is invalid, else the
 * error of the last such pair.
 * Accuracy: every result has the same bits as vesica_manifold_f64.
 * Cost: as vesica_manifold_f64 for each pair.
 */
VESICA_API int64_t vesica_manifold_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b,
                                            vesica_contacts_f64 *out);

/* ---- Casts of two given kinds, double: the same bits as vesica_cast_f64, without its dispatch by kind ----
 * Requires: vx and vy finite; both may be 0. t_end >= 0, or infinity.
 * Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
 * Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
 * Accuracy: as vesica_cast_f64.
 * Cost: as vesica_overlap_f64 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f64.
 * Since: 0.1.
 */

/** A ray at a point. */
VESICA_API int32_t vesica_cast_point_point_f64(const vesica_point_f64 *a, const vesica_point_f64 *b, double vx,
                                               double vy, double t_end, vesica_impact_f64 *out);
/** A ray at a segment. */
VESICA_API int32_t vesica_cast_segment_point_f64(const vesica_segment_f64 *a, const vesica_point_f64 *b, double vx,
                                                 double vy, double t_end, vesica_impact_f64 *out);
/** A ray at a disc. */
VESICA_API int32_t vesica_cast_circle_point_f64(const vesica_circle_f64 *a, const vesica_point_f64 *b, double vx,
                                                double vy, double t_end, vesica_impact_f64 *out);
/** A ray at an axis-aligned box. */
VESICA_API int32_t vesica_cast_aabb_point_f64(const vesica_aabb_f64 *a, const vesica_point_f64 *b, double vx, double vy,
                                              double t_end, vesica_impact_f64 *out);
/** A ray at a rectangle. */
VESICA_API int32_t vesica_cast_rect_point_f64(const vesica_rect_f64 *a, const vesica_point_f64 *b, double vx, double vy,
                                              double t_end, vesica_impact_f64 *out);
/** A ray at an ellipse. */
VESICA_API int32_t vesica_cast_ellipse_point_f64(const vesica_ellipse_f64 *a, const vesica_point_f64 *b, double vx,
                                                 double vy, double t_end, vesica_impact_f64 *out);
/** Two discs. */
VESICA_API int32_t vesica_cast_circle_circle_f64(const vesica_circle_f64 *a, const vesica_circle_f64 *b, double vx,
                                                 double vy, double t_end, vesica_impact_f64 *out);
/** Two rectangles. */
VESICA_API int32_t vesica_cast_rect_rect_f64(const vesica_rect_f64 *a, const vesica_rect_f64 *b, double vx, double vy,
                                             double t_end, vesica_impact_f64 *out);

/* ---- Motion, float: the same functions. The time is rounded down to a float, so no contact is before it. ----
 * Errors: those of the double functions.
 * Since: 0.1.
 */

/** As vesica_impact_f64. */
typedef struct {
    float t, x, y, nx, ny;
} vesica_impact_f32;

/** As vesica_cast_f64. */
VESICA_API int32_t vesica_cast_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b, float vx, float vy,
                                   float t_end, vesica_impact_f32 *out);
/** As vesica_cast_many_f64. */
VESICA_API int64_t vesica_cast_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, const float *vx,
                                        const float *vy, ptrdiff_t stride, float t_end, float *t, float *x, float *y,
                                        float *nx, float *ny);
/** As vesica_cast_first_f64. */
VESICA_API int64_t vesica_cast_first_f32(const vesica_shapes_f32 *one, const vesica_shapes_f32 *many, float vx,
                                         float vy, float t_end, vesica_impact_f32 *out);
/** As vesica_sweep_bounds_f64. */
VESICA_API int32_t vesica_sweep_bounds_f32(int32_t kind, const void *shape, float vx, float vy, float t_end,
                                           vesica_aabb_f32 *out);
/** As vesica_index_cast_f64. */
VESICA_API int64_t vesica_index_cast_f32(const void *index, const vesica_shapes_f32 *sets, int32_t set_count,
                                         const vesica_shapes_f32 *one, float vx, float vy, float t_end, int64_t *out,
                                         int64_t capacity, int64_t *state);
/** As vesica_index_cast_first_f64. */
VESICA_API int64_t vesica_index_cast_first_f32(const void *index, const vesica_shapes_f32 *sets, int32_t set_count,
                                               const vesica_shapes_f32 *one, float vx, float vy, float t_end,
                                               vesica_impact_f32 *out);

/** As vesica_turn_f64. */
typedef struct {
    float vx, vy, angle;
} vesica_turn_f32;

/**
 * As vesica_impact_time_f64. The gap is that at the rounded time, and rounded up: it may exceed the tolerance by 2^-24
 * of the way that the shapes move relative to each other. Where the double function returns VESICA_CAST_HIT, this one
 * may return VESICA_CAST_NEAR.
 */
VESICA_API int32_t vesica_impact_time_f32(int32_t kind_a, const void *a, const vesica_turn_f32 *turn_a, int32_t kind_b,
                                          const void *b, const vesica_turn_f32 *turn_b, float tolerance,
                                          vesica_impact_f32 *out, float *gap);
/** As vesica_index_impact_time_f64. */
VESICA_API int64_t vesica_index_impact_time_f32(const void *index, const vesica_shapes_f32 *sets, int32_t set_count,
                                                const vesica_shapes_f32 *one, const vesica_turn_f32 *turn,
                                                float tolerance, vesica_impact_f32 *out, float *gap, int32_t *answer);

/* ---- Contacts of overlapping shapes, float ----
 * Errors: those of the double functions.
 * Since: 0.1.
 */

/** As vesica_contacts_f64. */
typedef struct {
    float nx, ny, x0, y0, depth0, x1, y1, depth1;
    int64_t a0, b0, a1, b1, count;
} vesica_contacts_f32;

/** As vesica_manifold_f64, rounded to float. */
VESICA_API int32_t vesica_manifold_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b,
                                       vesica_contacts_f32 *out);
/** As vesica_manifold_many_f64. */
VESICA_API int64_t vesica_manifold_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b,
                                            vesica_contacts_f32 *out);

/* ---- Casts of two given kinds, float ----
 * Errors: those of the double functions.
 * Since: 0.1.
 */

/** As vesica_cast_point_point_f64. */
VESICA_API int32_t vesica_cast_point_point_f32(const vesica_point_f32 *a, const vesica_point_f32 *b, float vx, float vy,
                                               float t_end, vesica_impact_f32 *out);
/** As vesica_cast_segment_point_f64. */
VESICA_API int32_t vesica_cast_segment_point_f32(const vesica_segment_f32 *a, const vesica_point_f32 *b, float vx,
                                                 float vy, float t_end, vesica_impact_f32 *out);
/** As vesica_cast_circle_point_f64. */
VESICA_API int32_t vesica_cast_circle_point_f32(const vesica_circle_f32 *a, const vesica_point_f32 *b, float vx,
                                                float vy, float t_end, vesica_impact_f32 *out);
/** As vesica_cast_aabb_point_f64. */
VESICA_API int32_t vesica_cast_aabb_point_f32(const vesica_aabb_f32 *a, const vesica_point_f32 *b, float vx, float vy,
                                              float t_end, vesica_impact_f32 *out);
/** As vesica_cast_rect_point_f64. */
VESICA_API int32_t vesica_cast_rect_point_f32(const vesica_rect_f32 *a, const vesica_point_f32 *b, float vx, float vy,
                                              float t_end, vesica_impact_f32 *out);
/** As vesica_cast_ellipse_point_f64. */
VESICA_API int32_t vesica_cast_ellipse_point_f32(const vesica_ellipse_f32 *a, const vesica_point_f32 *b, float vx,
                                                 float vy, float t_end, vesica_impact_f32 *out);
/** As vesica_cast_circle_circle_f64. */
VESICA_API int32_t vesica_cast_circle_circle_f32(const vesica_circle_f32 *a, const vesica_circle_f32 *b, float vx,
                                                 float vy, float t_end, vesica_impact_f32 *out);
/** As vesica_cast_rect_rect_f64. */
VESICA_API int32_t vesica_cast_rect_rect_f32(const vesica_rect_f32 *a, const vesica_rect_f32 *b, float vx, float vy,
                                             float t_end, vesica_impact_f32 *out);

#ifdef __cplusplus
}
#endif

#endif /* VESICA_MOTION_H */
