/*
 * Vesica: exact overlap queries between plain 2D shapes.
 *
 * SPDX-License-Identifier: Apache-2.0
 *
 * In C11 a call needs no kinds: vesica_overlap(&a, &b) takes them from the types (vesica_generic.h).
 * The functions that most programs need come first. The rules here hold for every function.
 *
 * Shapes:
 *  - A shape is exactly the set of points that its stored numbers describe. Shapes are closed and solid: touching is
 *    overlap, and a shape inside another overlaps it.
 *  - The axis u = (ux, uy) of a rectangle or an ellipse is a direction and a unit of length. It is never normalised:
 *    axis (2, 0) with half extent 1 is the same shape as axis (1, 0) with half extent 2. If the axis is the cosine and
 *    sine of an angle, lengths are in the unit of the coordinates. perp(u) is (-uy, ux); u.v is the scalar product.
 *  - Zero sizes are legal. A rectangle with half height 0 is a segment, and a circle with radius 0 is a point.
 *  - All coordinates and sizes share one unit, which may be any. Tiny, huge and mixed magnitudes are all legal.
 *  - A shape is invalid if a number is NaN or infinite, a size is negative, the axis is (0, 0), or min exceeds max. An
 *    invalid shape gives an error, never a guess.
 *
 * Arguments:
 *  - A shape of any kind is passed as its kind (VESICA_POINT ...) and a pointer to its struct: the one in double for
 *    functions that end in _f64, the one in float for _f32. Two such shapes may be of any two kinds. A function named
 *    after two kinds takes its shapes in that order.
 *  - Input is only read. The same memory may be passed as several inputs.
 *  - An output must not overlap an input or another output.
 *  - A pointer is aligned for its type, as always in C. The numbers behind vesica_shapes need no alignment.
 *
 * Results:
 *  - An int32_t or int64_t result is an answer >= 0 or an error < 0 (VESICA_E_...). Errors are checked in this order:
 *    NULL pointers, unknown kinds, arguments out of range, invalid shapes, results out of range. The pointers inside a
 *    vesica_shapes are looked at after its kind and its counts.
 *  - On error nothing is written. Batches are the exception: an invalid element affects only its own results.
 *  - VESICA_E_RANGE may also be returned for a finite result if the area of a shape, or an axis times a half length,
 *    overflows.
 *  - If several answers are equally right, a function returns one of them, always the same for the same input.
 *
 * Accuracy:
 *  - Answers that are yes or no, a relation or a count are exact for all valid shapes.
 *  - In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx|
 *    and |dy| between their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times
 *    the scale. An aspect ratio is longer over shorter size.
 *  - A float function computes in double, within the bounds stated, and then rounds each number of the result to float
 *    once. A distance or a depth above 0 stays above 0.
 *
 * Behaviour:
 *  - No function allocates, locks, prints, sets errno or keeps state. All are thread-safe and reentrant.
 *  - Results are the same bits in every floating-point environment (any rounding mode, flush-to-zero,
 *    denormals-are-zero), and a call leaves the environment as it was. Calls may raise floating-point flags. Overlap of
 *    two shapes needs floating-point exceptions masked, as they are by default; other calls mask them themselves.
 *  - A call about two shapes uses at most 64 KiB of stack, one about arrays or an index at most 176 KiB.
 *  - A call about two shapes takes from a few ns to a few us (docs/benchmarks.md). Contact to the last digit takes
 *    longer. Magnitudes as far apart as 2^1000 and 2^-1000 may take up to 1 ms, and casts of them 5 ms.
 *
 * Comments have up to six parts, in this order: Requires, Returns, Errors, Accuracy, Cost, Since. A part in the heading
 * of a group holds for each function of the group that does not have that part itself.
 */
#ifndef VESICA_H
#define VESICA_H

#include <stddef.h>
#include <stdint.h>

#if defined(VESICA_BUILDING) && defined(__GNUC__) && !defined(_WIN32)
#define VESICA_API __attribute__((visibility("default")))
#else
#define VESICA_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Constants. Hosts without a C compiler find them in vesica.json and vesica.cdef. ---- */

#define VESICA_VERSION_MAJOR 0
#define VESICA_VERSION_MINOR 1
#define VESICA_VERSION_PATCH 0
#define VESICA_VERSION 100 /**< of this header: major * 10000 + minor * 100 + patch */

/*
 * Kinds of shapes, and the order of their numbers. Capsules and rounded rectangles are taken as the kinds before them.
 * Polygons and polylines are taken by:
 *   check, bounds
 *   overlap, interiors_overlap, relation, contains
 *   crossings, de9im
 *   intersection (with a segment or a point; polygons that are convex with one another, boxes and rectangles)
 *   nearest, boundary_distance
 *   signed_distance, within (where they overlap and their depth is asked for: if they are convex)
 *   cast, cast_first, sweep_bounds
 *   depth, impact_time, if they are convex
 *   shape_area, area, iou, ratio, suppression (polygons only)
 * the arrays of these, indexes, index_select, index_nearest, index_cast, join_nearest, and joins.
 */
#define VESICA_POINT 0   /**< x y */
#define VESICA_SEGMENT 1 /**< x0 y0 x1 y1 */
#define VESICA_CIRCLE 2  /**< cx cy r */
#define VESICA_AABB 3    /**< min_x min_y max_x max_y */
#define VESICA_RECT 4    /**< cx cy ux uy hx hy */
#define VESICA_ELLIPSE 5 /**< cx cy ux uy a b */
#define VESICA_CAPSULE 6 /**< x0 y0 x1 y1 r */
#define VESICA_ROUND_RECT 7 /**< cx cy ux uy hx hy r */
#define VESICA_POLYGON 8 /**< vertices of one or more rings */
#define VESICA_POLYLINE 9 /**< vertices of one or more chains */

/* Relations of a shape a to a shape b. */
#define VESICA_DISJOINT 0       /**< a and b have no common point */
#define VESICA_TOUCH 1          /**< they have common points, but their insides have none */
#define VESICA_CROSS 2          /**< their insides meet, and neither shape contains the other */
#define VESICA_INSIDE 3         /**< b contains a, and a has no point of b's outline */
#define VESICA_INSIDE_TOUCH 4   /**< b contains a, and a has points of b's outline */
#define VESICA_CONTAINS 5       /**< a contains b, and b has no point of a's outline */
#define VESICA_CONTAINS_TOUCH 6 /**< a contains b, and b has points of a's outline */
#define VESICA_EQUAL 7          /**< a and b are the same set of points */

/* Errors. */
#define VESICA_E_NULL (-1)          /**< a pointer is NULL */
#define VESICA_E_SHAPE (-2)         /**< a shape is invalid; vesica_check_f64 or _f32 says why */
#define VESICA_E_KIND (-3)          /**< a number is no kind, or the function does not take the kind */
#define VESICA_E_ARGUMENT (-4)      /**< another argument is out of its documented range */
#define VESICA_E_NOT_FINITE (-5)    /**< a number is NaN or infinite */
#define VESICA_E_NEGATIVE_SIZE (-6) /**< a radius, half extent or half length is negative */
#define VESICA_E_ZERO_AXIS (-7)     /**< the axis (ux, uy) is (0, 0) */
#define VESICA_E_INVERTED (-8)      /**< an AABB's min exceeds its max */
#define VESICA_E_RANGE (-9)         /**< a number of the result would overflow its type */
#define VESICA_E_INDEX (-10)        /**< bytes are not an index of this version, or are damaged */
#define VESICA_E_RINGS (-11)        /**< a polygon has no vertex, or its offsets are negative or decrease */
#define VESICA_E_NOT_SIMPLE (-12)   /**< edges of a polygon cross, or overlap along a stretch */
#define VESICA_E_NOT_CONVEX (-13)   /**< a polygon is not convex, as the function requires */

/* ---- Shapes and results, double. Structs have no padding, and their layout is frozen. ---- */

/** A location. */
typedef struct {
    double x, y;
} vesica_point_f64;

/** All points between two end points. If the two are the same, the segment is a point. */
typedef struct {
    double x0, y0, x1, y1;
} vesica_segment_f64;

/** A disc: centre and radius, r >= 0. */
typedef struct {
    double cx, cy, r;
} vesica_circle_f64;

/** A box along the coordinate axes, min_x <= max_x and min_y <= max_y. */
typedef struct {
    double min_x, min_y, max_x, max_y;
} vesica_aabb_f64;

/** All points C + s u + t perp(u) with |s| <= hx and |t| <= hy, where C is (cx, cy); hx, hy >= 0 and u != (0, 0). */
typedef struct {
    double cx, cy, ux, uy, hx, hy;
} vesica_rect_f64;

/** All points C + s u + t perp(u) with (s/a)^2 + (t/b)^2 <= 1, where C is (cx, cy); a, b >= 0 and u != (0, 0). */
typedef struct {
    double cx, cy, ux, uy, a, b;
} vesica_ellipse_f64;

/** All points at most r from the segment from (x0, y0) to (x1, y1), r >= 0. If its ends are the same, it is a disc. */
typedef struct {
    double x0, y0, x1, y1, r;
} vesica_capsule_f64;

/**
 * All points at most r >= 0 from the rectangle (cx, cy, ux, uy, hx, hy): one with round corners.
 * hx and hy are the rectangle's, in units of the axis, without the radius; r is in units of the coordinates.
 */
typedef struct {
    double cx, cy, ux, uy, hx, hy, r;
} vesica_round_rect_f64;

/**
 * A polygon, or a polyline: vertices in the caller's memory, which are read and not kept.
 *
 * A polygon is the points on an edge, and those around which its rings cross an odd number of times. So a ring inside
 * another one is a hole, and rings need no order and no direction. Each ring's last vertex is joined to its first,
 * which may also be repeated at the end. A ring of one vertex is a point, one of two a segment.
 * A polyline is the points on an edge of its chains, which are not closed. It has no inside.
 * Vertex i is at x + i * stride bytes and y + i * stride bytes. stride is 16 for x y x y ..., 8 for two columns.
 * rings has count + 1 offsets: ring j has the vertices rings[j] to rings[j + 1] - 1. If rings is NULL there is one ring
 * of `count` vertices. At least one vertex is needed; empty rings are allowed.
 */
typedef struct {
    const double *x, *y;
    ptrdiff_t stride;
    const int32_t *rings;
    int64_t count;
} vesica_polygon_f64;

/** A polyline. Its members are laid out as those of vesica_polygon_f64, with chains for rings. */
typedef struct {
    const double *x, *y;
    ptrdiff_t stride;
    const int32_t *rings;
    int64_t count;
} vesica_polyline_f64;

/**
 * Facts about a polygon, from vesica_polygon_facts_f64.
 *
 * vertices leaves out those that repeat the one before on their ring, which closes. Two edges that cross or overlap
 * begin at the vertices first_crossing and second_crossing, which are -1 if there are none, and simple is then 1.
 * orientation is 1 if the inside is on the left of the first ring's edges, -1 on the right, 0 of a polygon without
 * area. area is that of vesica_shape_area_f64 with the sign of the orientation. convex is 1 if vesica_depth_f64 takes
 * the polygon. rings are those with a vertex.
 */
typedef struct {
    int64_t vertices, first_crossing, second_crossing;
    double area;
    int32_t orientation, convex, simple, rings;
} vesica_facts_f64;

/** A distance, and two points that are that far apart: (ax, ay) of shape a and (bx, by) of shape b. */
typedef struct {
    double distance, ax, ay, bx, by;
} vesica_closest_points_f64;

/** The shortest move of b that ends its overlap with a: its length, and its unit direction (x, y). */
typedef struct {
    double depth, x, y;
} vesica_penetration_f64;

/* ---- The functions that most programs need, double ----
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
 * Since: 0.1.
 */

/**
 * Do two shapes share a point? Touching counts.
 * Returns: 1 if they do, 0 if not.
 * Accuracy: exact.
 * Cost: as the function named after the two kinds, and a dispatch.
 */
VESICA_API int32_t vesica_overlap_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b);

/**
 * Do the insides of two shapes share a point? Touching does not count.
 *
 * The inside is the shape without its outline, as vesica_relation_f64 says. So two rectangles side by side get 0, and
 * so does a point on the rim of a disc or a segment along an edge. Two segments that cross get 1, and two equal points.
 * If both shapes have an area, the answer is 1 where vesica_relation_f64 is VESICA_CROSS or more.
 * Returns: 1 if they do, 0 if not.
 * Accuracy: exact.
 * Cost: as vesica_overlap_f64.
 */
VESICA_API int32_t vesica_interiors_overlap_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b);

/**
 * Does a contain all of b? A shape contains itself, and whatever touches its outline from inside.
 * Returns: 1 if vesica_relation_f64 is VESICA_CONTAINS, VESICA_CONTAINS_TOUCH or VESICA_EQUAL, else 0.
 * Accuracy: exact.
 * Cost: as vesica_relation_f64.
 */
VESICA_API int32_t vesica_contains_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b);

/**
 * How does a relate to b? The answer is one of the eight relations of the region connection calculus (RCC-8).
 *
 * The outline of a shape with area is the curve around it. The outline of a segment, or of a shape with one size zero,
 * is its two end points. A point, or a shape without any size, has no outline. The inside is the shape without its
 * outline. If several relations fit, VESICA_EQUAL comes first, then those of containment, then VESICA_CROSS. So a
 * segment that ends on the middle of another touches it; two segments on one line that overlap in part cross; a point
 * on the rim of a disc is VESICA_INSIDE_TOUCH. Exchanging the shapes always gives the converse relation.
 *
 * The outline of a polygon is its edges, but a polygon whose vertices are on one line is a segment. The outline of a
 * polyline is the points where an odd number of its chains end.
 * Requires: simple polygons, as vesica_check_f64 says. Others get one of the eight relations, without a meaning. The
 * same holds for vesica_contains_f64 and vesica_interiors_overlap_f64.
 * Returns: VESICA_DISJOINT ... VESICA_EQUAL. Equal sets are VESICA_EQUAL, whatever kinds and numbers describe them.
 * Accuracy: exact.
 * Cost: up to twice vesica_overlap_f64; more if shapes touch or are equal.
 */
VESICA_API int32_t vesica_relation_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b);

/**
 * How far apart are two solid shapes, and which of their points are closest?
 *
 * If the shapes overlap (as vesica_overlap_f64 says), the distance is 0 and both points are one common point. If not,
 * the distance is > 0. Exchanging the shapes exchanges the points and changes no bit. Moving both shapes alike changes
 * no bit of the distance if no coordinate is rounded.
 * The distance of a polygon or a polyline is the least over its edges, each asked as a segment.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
 * Accuracy: the distance is right to 4 u scale at any aspect ratio; the largest error seen was 1 u scale, and 3.3 u
 * beside the ends of the thinnest ellipses. Its relative error is at most 2 u above 1e-10 scale (aspect ratios up to
 * 1e6) or 1e-14 scale (up to 1000). Closest points are right to 4 u scale, and a common point to 8 u scale, before they
 * are rounded. Points of capsules and rounded rectangles are rounded twice. For polygons and polylines the scale is the
 * largest over pairs of an edge and the other shape or its edge.
 * Cost: ten to thirty times vesica_overlap_f64; more for shapes that cross and near-ties.
 */
VESICA_API int32_t vesica_nearest_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b,
                                      vesica_closest_points_f64 *out);

/**
 * Penetration depth: how far and which way must b be moved until the two shapes only touch?
 *
 * Moving b by out->depth along the unit vector (x, y) is the shortest translation after which a line separates the
 * shapes: a on one side, b on the other, where both may touch the line. For disjoint shapes all three numbers are 0.
 * Overlapping shapes always get a direction. Their depth is 0 if such a line exists without a move: if they touch from
 * outside, if a point lies on an outline, or if points and segments lie along one line. Otherwise the depth is > 0.
 * Exchanging the shapes reverses the direction and changes no other bit, except for two equal shapes in one place.
 * Moving both shapes alike changes no bit if no coordinate is rounded.
 * Polygons must be convex: one ring that turns one way only and winds once, collinear vertices allowed. A polygon or
 * polyline whose vertices are on one line is a segment or a point.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_NOT_CONVEX, VESICA_E_RANGE.
 * Accuracy: at aspect ratios up to 1e6 the depth is right to 4 u scale; for circles and points, to its last place. The
 * length of (x, y) is 1 to 3 u. After the move at most 8 u scale of overlap is left. Whether the depth is 0 is exact at
 * any ratio; beyond 1e6 no bound on its error is stated.
 * Cost: about as vesica_nearest_f64; three times as much with an ellipse.
 */
VESICA_API int32_t vesica_depth_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b,
                                    vesica_penetration_f64 *out);

/**
 * Area of the intersection of two shapes.
 *
 * It is exactly 0 if shapes are disjoint, if they only touch, or if one has no area. If one contains the other, it is
 * the vesica_shape_area_f64 of the inner one. It is never more than the area of either, and more than 0 if the insides
 * of shapes with area meet, unless that underflows. Exchanging the shapes changes no bit. Scaling both by a power of
 * two scales the area by its square.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
 * Accuracy: right to 64 u times the smaller shape's area times the larger aspect ratio, at aspect ratios up to 10^4,
 * even if the outlines nearly touch or coincide and whatever the sizes are. Beyond 10^4 no bound is stated; what is
 * said above holds at any ratio. With a capsule or a rounded rectangle the bound holds if neither shape is more than
 * 10^12 times as long as the other.
 * Polygons: their edges must not cross. Rings have any order and direction. An area within its error bound of 0 is 0,
 * and one within it of the smaller shape's area is that area; if both hold, the exact relation decides. So it is
 * exactly 0 if shapes only touch, and exactly the inner one's area if one contains the other; but insides that share
 * less than the bound share 0, too. Of two polygons the bound is 192 u g w: g is the greatest height above or below the
 * middle of the box that their boxes share, and w the sum of the widths that pairs of their edges share, for convex
 * polygons 4 times the width of that box. With another shape it is 192 u t l: t is that shape's half width and half
 * height and the polygon's greatest distance from its centre, and l the length of the outline in it and the same half
 * lengths; in units of its half lengths if it is an ellipse. A polyline has no area.
 * Cost: six times vesica_overlap_f64 for boxes, fifty times for two ellipses; more if outlines nearly touch or
 * coincide, or if one shape is far larger.
 */
VESICA_API int32_t vesica_area_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b, double *out);

/**
 * Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
 *
 * It is exactly 1 for equal shapes and exactly 0 for shapes that share no area. Intermediate results never overflow or
 * underflow. Exchanging the shapes, or scaling both by a power of two, changes no bit.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (neither shape has an area).
 * Accuracy: the bound of vesica_area_f64, divided by the area of the union; for polygons up to three times as much.
 * Cost: vesica_area_f64 and twice vesica_shape_area_f64.
 */
VESICA_API int32_t vesica_iou_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b, double *out);

/**
 * Smallest box of representable numbers that contains a shape.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
 * Accuracy: each side is the true extreme of the shape, rounded outward once. So a representable box is exact.
 * Cost: up to ten times vesica_overlap_f64; more for magnitudes above 2^400 or below 2^-400.
 */
VESICA_API int32_t vesica_bounds_f64(int32_t kind, const void *shape, vesica_aabb_f64 *out);

/**
 * Is a shape valid, and if not, which rule does it break?
 *
 * A polygon is simple if its edges neither cross nor overlap along a stretch; they may touch. A ring of two places is
 * allowed. Functions that need this say so; they do not check it, and vesica_overlap_f64 and others take any polygon.
 * Returns: 0 for a valid shape, else the first rule broken: VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE,
 * VESICA_E_ZERO_AXIS, VESICA_E_INVERTED, VESICA_E_RINGS or VESICA_E_NOT_SIMPLE.
 * Errors: VESICA_E_NULL, VESICA_E_KIND.
 */
VESICA_API int32_t vesica_check_f64(int32_t kind, const void *shape);

/**
 * The meaning of an error code, as one English phrase without a full stop.
 * Returns: static text, never NULL: "success" for answers (>= 0), "unknown error" for unknown codes.
 * Errors: none.
 */
VESICA_API const char *vesica_strerror(int32_t code);

/* ---- More about two shapes and about one, double ----
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
 * Since: 0.1.
 */

/**
 * Where do the outlines of two shapes meet? Touching counts.
 *
 * The outline of a shape with area is the curve around it. A segment, a point and a shape without area are their own
 * outlines. A contact is one place, however closely the curves touch there. If straight parts of outlines share a
 * stretch, or arcs about one corner do, its two end points are places, and *shared is 1. So equal boxes meet at their
 * four corners, and equal capsules where their sides begin and end. Equal circles and ellipses meet everywhere: then
 * the count is 0 and *shared is 1.
 * Places come in order along a's outline, counter-clockwise in the frame of its axis. The start is a box's corner
 * C - hx u - hy perp(u), an ellipse's point C + a u (one without area begins as a box), a circle's point C + (r, 0),
 * or a segment's first end. With a radius the start is where the side from that corner or end begins: for a capsule,
 * its right side, seen from the first end.
 * With a polygon or a polyline, places come in order along that, or along a if both are: from the first vertex of the
 * first ring on. A vertex on an edge is a place. Within a stretch that is shared, vertices where both outlines go
 * straight on are none. A polygon whose vertices are on one line is a segment that begins at its least x, then least y.
 * Where edges of a polygon or a polyline cross one another on the other outline, a place may count for each of them.
 * Requires: capacity, how many places out has room for. It may be 0, and out then NULL. shared may be NULL.
 * Returns: how many places there are, even if that exceeds the capacity: at most 8, or 12 of an ellipse with a rounded
 * rectangle, unless a shape is a polygon or a polyline. The first `capacity` are written, and *shared is set to 1 or 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a negative capacity), VESICA_E_SHAPE, VESICA_E_RANGE.
 * Accuracy: the number is exact. A place is right to 4 u times the largest coordinate or size of either shape, even
 * where the outlines nearly coincide. Places closer to one another than that may come in either order or be equal.
 * Cost: several times vesica_nearest_f64.
 */
VESICA_API int64_t vesica_crossings_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b,
                                        vesica_point_f64 *out, int64_t capacity, int32_t *shared);

/**
 * How far apart are the outlines of two shapes, and where do they come closest?
 *
 * The outline of a shape with area is the curve around it. A point, a segment and a shape with a zero size are their
 * own outlines. The outline of a polygon or a polyline is its edges. If outlines meet, the distance is 0 and
 * (ax, ay) = (bx, by) is a point of both. If shapes are disjoint, the result is as of vesica_nearest_f64. If one is
 * strictly inside the other, the distance is the least over the whole outline, never a local minimum. Which case holds
 * is decided exactly. Exchanging the shapes exchanges the points and changes no bit. Moving both shapes alike changes
 * no bit of the distance if no coordinate is rounded.
 * Returns: 0.
 * Accuracy: at aspect ratios up to 1e6 the distance is right to 4 u scale, and the points are that far apart to 16 u
 * scale. At any ratio it is above 0 unless outlines meet, and points are on them to 12 u scale before they are rounded.
 * Cost: as vesica_nearest_f64 for disjoint shapes; up to three times as much if outlines meet or are nested, with a
 * capsule or a rounded rectangle up to twenty times.
 */
VESICA_API int32_t vesica_boundary_distance_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b,
                                                vesica_closest_points_f64 *out);

/**
 * Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment. A radius r
 * adds r times the core's perimeter, and pi r r; the perimeter of a segment is twice its length.
 * Returns: 0.
 * Accuracy: the double nearest to the true area; a tiny area becomes subnormal or 0. So a shape inside another never
 * has the greater area, and equal shapes have equal areas, whatever kinds and numbers describe them. Capsules and
 * rounded rectangles that have both a size and a radius are excepted: their area is computed with a relative error of
 * 2^-96 and rounded once, so it may rarely be the double beside the nearest. A polygon's edges must not cross; its area
 * is right to 8 u times the height of its box times the sum of its edges' widths, and 0 only if each ring is flat.
 */
VESICA_API int32_t vesica_shape_area_f64(int32_t kind, const void *shape, double *out);

/**
 * States facts of a polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
 *
 * The first ring is the first one that is neither a point nor a segment. If y points up, a shell whose inside is on the
 * left of its edges is counter-clockwise. Where several pairs of edges cross, any one of them is named. Then area and
 * orientation mean nothing.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_RANGE (the area).
 * Accuracy: exact, but the area, which is as vesica_shape_area_f64 says.
 * Cost: as vesica_check_f64, and a few ns for each vertex.
 */
VESICA_API int32_t vesica_polygon_facts_f64(const vesica_polygon_f64 *polygon, vesica_facts_f64 *out);

/* ---- Overlap of two given kinds, double ----
 * Returns: 1 if the shapes share a point (touching counts), 0 if not.
 * Errors: VESICA_E_NULL, VESICA_E_SHAPE.
 * Accuracy: exact.
 * Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times that.
 * Since: 0.1.
 */

/** Are the two points the same? */
VESICA_API int32_t vesica_overlap_point_point_f64(const vesica_point_f64 *a, const vesica_point_f64 *b);
/** Does the point lie on the segment? End points count. */
VESICA_API int32_t vesica_overlap_point_segment_f64(const vesica_point_f64 *a, const vesica_segment_f64 *b);
/** Does the point lie in the disc or on its rim? */
VESICA_API int32_t vesica_overlap_point_circle_f64(const vesica_point_f64 *a, const vesica_circle_f64 *b);
/** Does the point lie in the box or on its outline? */
VESICA_API int32_t vesica_overlap_point_aabb_f64(const vesica_point_f64 *a, const vesica_aabb_f64 *b);
/** Does the point lie in the rectangle or on its outline? */
VESICA_API int32_t vesica_overlap_point_rect_f64(const vesica_point_f64 *a, const vesica_rect_f64 *b);
/** Does the point lie in the ellipse or on its outline? */
VESICA_API int32_t vesica_overlap_point_ellipse_f64(const vesica_point_f64 *a, const vesica_ellipse_f64 *b);
/** Do the segments share a point? End points count, and so do stretches along one line. */
VESICA_API int32_t vesica_overlap_segment_segment_f64(const vesica_segment_f64 *a, const vesica_segment_f64 *b);
/** Does the segment meet the disc? A tangent segment does. */
VESICA_API int32_t vesica_overlap_segment_circle_f64(const vesica_segment_f64 *a, const vesica_circle_f64 *b);
/** Does the segment meet the box? A segment inside it does. */
VESICA_API int32_t vesica_overlap_segment_aabb_f64(const vesica_segment_f64 *a, const vesica_aabb_f64 *b);
/** Does the segment meet the rectangle? A segment inside it does. */
VESICA_API int32_t vesica_overlap_segment_rect_f64(const vesica_segment_f64 *a, const vesica_rect_f64 *b);
/** Does the segment meet the ellipse? A tangent segment does. */
VESICA_API int32_t vesica_overlap_segment_ellipse_f64(const vesica_segment_f64 *a, const vesica_ellipse_f64 *b);
/** Do the discs share a point? Discs that touch from outside do. */
VESICA_API int32_t vesica_overlap_circle_circle_f64(const vesica_circle_f64 *a, const vesica_circle_f64 *b);
/** Do the disc and the box share a point? */
VESICA_API int32_t vesica_overlap_circle_aabb_f64(const vesica_circle_f64 *a, const vesica_aabb_f64 *b);
/** Do the disc and the rectangle share a point? */
VESICA_API int32_t vesica_overlap_circle_rect_f64(const vesica_circle_f64 *a, const vesica_rect_f64 *b);
/** Do the disc and the ellipse share a point? */
VESICA_API int32_t vesica_overlap_circle_ellipse_f64(const vesica_circle_f64 *a, const vesica_ellipse_f64 *b);
/** Do the boxes share a point? Boxes that share an edge or a corner do. */
VESICA_API int32_t vesica_overlap_aabb_aabb_f64(const vesica_aabb_f64 *a, const vesica_aabb_f64 *b);
/** Do the box and the rectangle share a point? */
VESICA_API int32_t vesica_overlap_aabb_rect_f64(const vesica_aabb_f64 *a, const vesica_rect_f64 *b);
/** Do the box and the ellipse share a point? */
VESICA_API int32_t vesica_overlap_aabb_ellipse_f64(const vesica_aabb_f64 *a, const vesica_ellipse_f64 *b);
/** Do the rectangles share a point? Rectangles that share an edge or a corner do. */
VESICA_API int32_t vesica_overlap_rect_rect_f64(const vesica_rect_f64 *a, const vesica_rect_f64 *b);
/** Do the rectangle and the ellipse share a point? They do if one is inside the other. */
VESICA_API int32_t vesica_overlap_rect_ellipse_f64(const vesica_rect_f64 *a, const vesica_ellipse_f64 *b);
/** Do the ellipses share a point? They do if one is inside the other. */
VESICA_API int32_t vesica_overlap_ellipse_ellipse_f64(const vesica_ellipse_f64 *a, const vesica_ellipse_f64 *b);

/* ---- Shapes from other descriptions, double ----
 * Returns: 0; the shape is valid.
 * Since: 0.1.
 */

/**
 * Box with two opposite corners, in any order.
 * Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE.
 * Accuracy: exact.
 */
VESICA_API int32_t vesica_aabb_from_corners_f64(double x0, double y0, double x1, double y1, vesica_aabb_f64 *out);

/**
 * Rectangle from centre, angle and full size: width along the angle, height across it.
 * Requires: the angle in radians, counter-clockwise from +x if y points up; width, height >= 0.
 * Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
 * Accuracy: the axis is (cos, sin), each right to 1.1 units in the last place, and of equal components at the doubles
 * nearest to +-pi/4 and +-3pi/4. No double is exactly pi/2, so a quarter turn has an exact axis only by
 * vesica_rects_from_boxes_f64, which takes degrees too. Sizes are exact: if halving one would round (an odd multiple of
 * the smallest subnormal number), the axis is halved instead.
 */
VESICA_API int32_t vesica_rect_from_angle_f64(double cx, double cy, double angle, double width, double height,
                                              vesica_rect_f64 *out);

/**
 * Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
 *
 * Corners that are not exactly a rectangle's give a rectangle near them, which need not contain them. The centre is the
 * mean of the corners. The axis is a unit vector along the edge from corner 0 to corner 1, and hx belongs to that edge.
 * Opposite edges are averaged; the longer pair gives the direction, and the shorter pair counts by its part across it.
 * Two or four equal corners are legal: they give a segment, or a point with axis (1, 0).
 * vesica_rect_corners_misfit_f64 says how far the corners are off.
 * Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_ARGUMENT (opposite edges are more than 90 degrees apart, as with
 * corners in another order), VESICA_E_RANGE (a half extent overflows). Edges that are no longer along x and y than 8
 * epsilon times the largest coordinate may be rounding, and are not an error. Epsilon is 2^-52, or 2^-23 in float.
 * Accuracy: half extents, and the axis times the longer one, are right to 8 units in the last place of the longer one;
 * the centre is right to 1 unit in its own. Both errors may grow by 2^-98 times the largest coordinate. A rectangle
 * along the coordinate axes is found exactly if its centre and half extents are representable.
 */
VESICA_API int32_t vesica_rect_from_corners_f64(const double corners[8], vesica_rect_f64 *out);

/**
 * The largest distance from a given corner to the rectangle's corner that corresponds to it.
 *
 * The four corners may start at any corner of the rectangle and run in either sense: the least result of the eight
 * ways counts. So 0 means that they are exactly the rectangle's corners, in order round the outline. The rectangle may
 * come from vesica_rect_from_corners_f64, or be any other.
 * Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, errors of the rectangle as vesica_check_f64, VESICA_E_RANGE (the result
 * overflows).
 * Accuracy: 3 units in the last place, plus 2^-96 times the largest coordinate of corners, centre and half axes.
 */
VESICA_API int32_t vesica_rect_corners_misfit_f64(const double corners[8], const vesica_rect_f64 *r, double *misfit);

/**
 * Rounded rectangle from centre, angle and full size, its round corners included: width along the angle, height across.
 * Requires: the angle in radians, counter-clockwise from +x if y points up; width, height, radius >= 0.
 * Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE, VESICA_E_ARGUMENT (the radius is more than half
 * the width or height).
 * Accuracy: the axis as vesica_rect_from_angle_f64; the radius is exact. The sizes of the rectangle inside, width - 2
 * radius and height - 2 radius, are each rounded once. With radius 0 it is that function's rectangle.
 */
VESICA_API int32_t vesica_round_rect_from_angle_f64(double cx, double cy, double angle, double width, double height,
                                                    double radius, vesica_round_rect_f64 *out);

/**
 * Capsule from centre, angle, the length between the ends of its segment, and radius.
 *
 * The angle points from (x0, y0) to (x1, y1). The whole capsule is length + 2 radius long.
 * Requires: the angle in radians, counter-clockwise from +x if y points up; length, radius >= 0.
 * Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE, VESICA_E_RANGE (an end overflows).
 * Accuracy: the ends are those of the segment that vesica_rect_from_angle_f64 makes of this length and height 0, each
 * coordinate right to 0.51 units in its last place. With centre (0, 0) they are opposite. The radius is exact.
 */
VESICA_API int32_t vesica_capsule_from_angle_f64(double cx, double cy, double angle, double length, double radius,
                                                 vesica_capsule_f64 *out);

/**
 * Capsule from the ends of its segment and its full width, twice the radius: a line of that width with round ends.
 * Requires: width >= 0.
 * Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
 * Accuracy: exact. Only half an odd multiple of the smallest subnormal number is rounded, to an even multiple.
 */
VESICA_API int32_t vesica_capsule_from_width_f64(double x0, double y0, double x1, double y1, double width,
                                                 vesica_capsule_f64 *out);

/**
 * Ellipse from centre, angle and half lengths: a along the angle, b across it.
 * Requires: the angle in radians, counter-clockwise from +x if y points up; a, b >= 0.
 * Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
 * Accuracy: the axis as vesica_rect_from_angle_f64; half lengths are exact.
 */
VESICA_API int32_t vesica_ellipse_from_angle_f64(double cx, double cy, double angle, double a, double b,
                                                 vesica_ellipse_f64 *out);

/**
 * Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx, wy).
 *
 * A zero vector gives the point (cx, cy).
 * Requires: ratio >= 0.
 * Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
 * Accuracy: exact.
 */
VESICA_API int32_t vesica_ellipse_from_radius_vector_f64(double cx, double cy, double wx, double wy, double ratio,
                                                         vesica_ellipse_f64 *out);

/**
 * Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
 *
 * A singular covariance, or k = 0, gives a segment or a point. The result has a >= b. Its axis is a unit vector with
 * x >= 0, or (1, 0) for equal variances without correlation.
 * Requires: the covariance cxx, cxy, cyy (units squared) positive semidefinite: cxy^2 <= cxx cyy as stored; k >= 0.
 * Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE (k < 0), VESICA_E_ARGUMENT (not a covariance),
 * VESICA_E_RANGE (a half length overflows).
 * Accuracy: half lengths and both components of the axis are right to 8 units in their own last place, even if the
 * matrix is nearly singular or nearly a circle's. Exchanging cxx and cyy exchanges the components, up to signs.
 */
VESICA_API int32_t vesica_ellipse_from_covariance_f64(double mean_x, double mean_y, double cxx, double cxy, double cyy,
                                                      double k, vesica_ellipse_f64 *out);

/**
 * Ellipse of the points X with (X - C) . M (X - C) <= 1, where M is symmetric with entries mxx, mxy, myy.
 *
 * The result is as of vesica_ellipse_from_covariance_f64 for the inverse of M and k = 1.
 * Requires: M positive definite as stored.
 * Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_ARGUMENT (not positive definite).
 * Accuracy: as vesica_ellipse_from_covariance_f64. No half length overflows.
 */
VESICA_API int32_t vesica_ellipse_from_matrix_f64(double cx, double cy, double mxx, double mxy, double myy,
                                                  vesica_ellipse_f64 *out);

/**
 * An array of shapes of one kind in any memory layout: records, packed or padded, or one column per number.
 *
 * Number k of element i is at field[k] + i * stride bytes, with k in the order of the shape's struct. stride is the
 * size of a record for records, sizeof(double) for columns, 0 to repeat one shape, and negative to run backwards.
 * Fields beyond those of the kind are ignored. Numbers need no alignment.
 * reserved must be 0, and of these kinds each 0 and rings and polygons NULL. vesica_shapes_from_records_f64 sets them;
 * if you fill the struct yourself, start from {0}.
 *
 * For polygons and polylines, field[0] and field[1] are x and y of vertex 0, and stride leads from vertex to vertex.
 * Which vertices element i has is said in one of four ways:
 *  - each > 0, rings NULL: vertices i * each to (i + 1) * each - 1. So 4 describes quads, and 3 triangles.
 *  - rings, and polygons NULL: the one ring rings[i] to rings[i + 1] - 1.
 *  - rings and polygons: the rings polygons[i] to polygons[i + 1] - 1. These are the offsets of GeoArrow's polygons.
 *  - each 0, rings NULL: field[0] is the first of structs vesica_polygon_f64, stride bytes apart. field[1] is ignored.
 * With rings, each may be the number of vertices in the columns, or 0. If it is given, an element whose offsets exceed
 * it is invalid, and nothing beyond is read. Offsets must be aligned.
 */
typedef struct {
    int32_t kind;
    int32_t reserved;
    int64_t count;
    ptrdiff_t stride;
    const double *field[8];
    const int32_t *rings;
    const int32_t *polygons;
    int64_t each;
} vesica_shapes_f64;

/**
 * Describes an array of `count` records. Each starts with a shape's struct.
 * Requires: base, the first record's shape, which may be NULL if count is 0; stride, the bytes from one record to the
 * next; count >= 0.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (negative count).
 */
VESICA_API int32_t vesica_shapes_from_records_f64(int32_t kind, int64_t count, const void *base, ptrdiff_t stride,
                                                  vesica_shapes_f64 *out);

/* ---- Arrays in step, double: a[0] with b[0], a[1] with b[1] ... ----
 * Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers as
 * the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
 * Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
 * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
 * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
 * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, an unused member that is not 0 or NULL,
 * an array that exceeds the address space).
 * Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every layout.
 * Cost: a pair takes from a fifth of the time of the function for two shapes to about as much (docs/benchmarks.md).
 * Since: 0.1.
 */

/**
 * Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f64.
 * Returns: how many are 1.
 * Cost: a fifth to a tenth of vesica_overlap_f64 a pair; about half of that if one array is a single shape.
 */
VESICA_API int64_t vesica_overlap_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, uint8_t *out);

/**
 * Do the insides of a[i] and b[i] share a point? out[i] is the answer of vesica_interiors_overlap_f64.
 * Returns: how many are 1.
 * Cost: as vesica_overlap_many_f64.
 */
VESICA_API int64_t vesica_interiors_overlap_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b,
                                                     uint8_t *out);

/**
 * How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f64.
 * Returns: how many are not VESICA_DISJOINT.
 */
VESICA_API int64_t vesica_relation_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, uint8_t *out);

/**
 * Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f64.
 * Returns: how many are 1.
 */
VESICA_API int64_t vesica_contains_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, uint8_t *out);

/**
 * How far apart are a[i] and b[i], and where? The columns are the fields of vesica_nearest_f64's result.
 * Returns: how many pairs overlap (distance 0).
 */
VESICA_API int64_t vesica_nearest_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *distance,
                                           double *ax, double *ay, double *bx, double *by);

/**
 * How far apart are the outlines of a[i] and b[i]? The columns are the fields of vesica_boundary_distance_f64's result.
 * Returns: how many pairs of outlines meet (distance 0).
 */
VESICA_API int64_t vesica_boundary_distance_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b,
                                                     double *distance, double *ax, double *ay, double *bx, double *by);

/**
 * How deep do a[i] and b[i] overlap? The columns are the fields of vesica_depth_f64's result.
 * Returns: how many depths are > 0.
 */
VESICA_API int64_t vesica_depth_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *depth,
                                         double *x, double *y);

/**
 * The area that a[i] and b[i] share: out[i] is the result of vesica_area_f64.
 * Returns: how many areas are > 0.
 */
VESICA_API int64_t vesica_area_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *out);

/**
 * Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f64.
 *
 * If neither of a pair has an area, out[i] is NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
 * Returns: how many are > 0.
 */
VESICA_API int64_t vesica_iou_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *out);

/* ---- Every a with every b, double ----
 * Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride counts elements of
 * out. With two or more rows its magnitude is at least b's count; if it is negative, rows run backwards in memory.
 * Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
 * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
 * written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL),
 * VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an unused member that is not 0 or NULL, rows that overlap, or an
 * array or rows that exceed the address space).
 * Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every layout.
 * Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
 * Since: 0.1.
 */

/**
 * Do a[i] and b[j] share a point? The elements of out are answers of vesica_overlap_f64. Arrays in spatial order are
 * much faster.
 * Returns: how many are 1.
 */
VESICA_API int64_t vesica_overlap_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, uint8_t *out,
                                             ptrdiff_t row_stride);

/**
 * Do the insides of a[i] and b[j] share a point? The elements of out are answers of vesica_interiors_overlap_f64.
 * Returns: how many are 1.
 */
VESICA_API int64_t vesica_interiors_overlap_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b,
                                                       uint8_t *out, ptrdiff_t row_stride);

/**
 * How does a[i] relate to b[j]? The elements of out are answers of vesica_relation_f64.
 * Returns: how many are not VESICA_DISJOINT.
 */
VESICA_API int64_t vesica_relation_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, uint8_t *out,
                                              ptrdiff_t row_stride);

/**
 * Does a[i] contain all of b[j]? The elements of out are answers of vesica_contains_f64.
 * Returns: how many are 1.
 */
VESICA_API int64_t vesica_contains_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, uint8_t *out,
                                              ptrdiff_t row_stride);

/**
 * The area that a[i] and b[j] share. The elements of out are results of vesica_area_f64.
 * Returns: how many are > 0.
 */
VESICA_API int64_t vesica_area_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *out,
                                          ptrdiff_t row_stride);

/**
 * Intersection over union of a[i] and b[j]. The elements of out are results of vesica_iou_f64.
 *
 * If neither of a pair has an area, it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
 * Returns: how many are > 0.
 */
VESICA_API int64_t vesica_iou_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *out,
                                         ptrdiff_t row_stride);

/* ---- Choices among many shapes, double ----
 * Since: 0.1.
 */

/**
 * Which of many shapes overlap one? Their indices are written to out[0], out[1] ..., in ascending order.
 * Requires: one, an array of count 1, which is looked at unless many is empty; capacity, how many indices out has room
 * for. It may be 0, and out then NULL.
 * Returns: how many there are, even if that exceeds the capacity. If room is left, the entry after the last is -1.
 * Errors: VESICA_E_SHAPE if a shape is invalid: it is not selected, and the others are written as usual, up to the -1
 * or the capacity. Before anything is written: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (one's count is not 1, a
 * negative capacity, and as vesica_overlap_many_f64).
 * Accuracy: every answer is as of vesica_overlap_f64.
 * Cost: as vesica_overlap_many_f64.
 */
VESICA_API int64_t vesica_overlap_select_f64(const vesica_shapes_f64 *one, const vesica_shapes_f64 *many, int64_t *out,
                                             int64_t capacity);

/**
 * Which of many shapes share a point of their insides with that of one? As vesica_overlap_select_f64, with the answers
 * of vesica_interiors_overlap_f64.
 */
VESICA_API int64_t vesica_interiors_overlap_select_f64(const vesica_shapes_f64 *one, const vesica_shapes_f64 *many,
                                                       int64_t *out, int64_t capacity);

/**
 * How many bytes of scratch do vesica_nms_f64, vesica_suppress_f64 and their float forms need for `count` shapes?
 * Returns: 0.4 MB, and for each shape at most 140 bytes, about 97 from 10,000 shapes on.
 * Errors: VESICA_E_ARGUMENT (a negative count, or one above 2147483647).
 */
VESICA_API int64_t vesica_nms_scratch(int64_t count);

/**
 * Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one whose
 * vesica_iou_f64 with every shape kept before is at most the threshold.
 *
 * The lower index of equal scores comes first. Infinite scores are legal. At threshold 1 all shapes are kept.
 * Shapes without an area suppress none and are not suppressed.
 * Requires: shapes, of a kind with an area; scores, one for each; threshold from 0 to
 * 1; scratch, of vesica_nms_scratch bytes or more, with any alignment and content; keep, with room for all indices.
 * Returns: 0, with *kept set to how many are kept. keep has their indices in the order of their scores; the rest of
 * keep is not written.
 * Errors: VESICA_E_SHAPE if a shape is invalid or its score is NaN: it is left out, and the result of the others is
 * written. Before anything is written: VESICA_E_NULL (with count 0 all but shapes and kept may be NULL), VESICA_E_KIND
 * (points, segments and polylines too), VESICA_E_ARGUMENT (the array as vesica_overlap_many_f64, threshold, too little
 * scratch).
 * Accuracy: the ratio that is compared is as of vesica_iou_f64; in float, the ratio rounded to float.
 * Cost: as vesica_iou_many_f64 for each pair of a shape and one that is kept near it.
 */
VESICA_API int32_t vesica_nms_f64(const vesica_shapes_f64 *shapes, const double *scores, double threshold,
                                  void *scratch, int64_t scratch_size, int64_t *keep, int64_t *kept);

/* ---- Version and names. Texts are static: do not free them. ----
 * Since: 0.1.
 */

/** Version of the loaded library. If it is below VESICA_VERSION, the library is older than the header. */
VESICA_API int32_t vesica_version(void);
/** VESICA_VERSION_MAJOR of the loaded library. */
VESICA_API int32_t vesica_version_major(void);
/** VESICA_VERSION_MINOR of the loaded library. */
VESICA_API int32_t vesica_version_minor(void);
/** VESICA_VERSION_PATCH of the loaded library. */
VESICA_API int32_t vesica_version_patch(void);

/**
 * How many numbers does a shape of this kind have?
 * Returns: 2, 4, 3, 4, 6, 6, 5, 7 for VESICA_POINT ... VESICA_ROUND_RECT.
 * Errors: VESICA_E_KIND, also for polygons and polylines, which have any number of vertices.
 */
VESICA_API int32_t vesica_field_count(int32_t kind);

/**
 * Name of a kind.
 * Returns: static text: "point", "segment", "circle", "aabb", "rect", "ellipse", "capsule" or "round_rect"; NULL for an
 * unknown kind.
 */
VESICA_API const char *vesica_kind_name(int32_t kind);

/**
 * Name of the instruction set that batches use: the best one of this processor. Answers never depend on it.
 *
 * The environment variable VESICA_ISA selects another one. It is read once, when the library is loaded. Unknown names
 * are ignored, and so are sets that this processor or this build does not have.
 * Returns: static text: "sse2", "avx2", "avx512", "neon", "simd128" or "portable".
 */
VESICA_API const char *vesica_isa_name(void);

/* ---- The same shapes, results and functions with float in place of double ---- */

/** As vesica_point_f64. */
typedef struct { float x, y; } vesica_point_f32;
/** As vesica_segment_f64. */
typedef struct { float x0, y0, x1, y1; } vesica_segment_f32;
/** As vesica_circle_f64. */
typedef struct { float cx, cy, r; } vesica_circle_f32;
/** As vesica_aabb_f64. */
typedef struct { float min_x, min_y, max_x, max_y; } vesica_aabb_f32;
/** As vesica_rect_f64. */
typedef struct { float cx, cy, ux, uy, hx, hy; } vesica_rect_f32;
/** As vesica_ellipse_f64. */
typedef struct { float cx, cy, ux, uy, a, b; } vesica_ellipse_f32;
/** As vesica_capsule_f64. */
typedef struct { float x0, y0, x1, y1, r; } vesica_capsule_f32;
/** As vesica_round_rect_f64. */
typedef struct { float cx, cy, ux, uy, hx, hy, r; } vesica_round_rect_f32;
/** As vesica_polygon_f64. */
typedef struct { const float *x, *y; ptrdiff_t stride; const int32_t *rings; int64_t count; } vesica_polygon_f32;
/** As vesica_polyline_f64. */
typedef struct { const float *x, *y; ptrdiff_t stride; const int32_t *rings; int64_t count; } vesica_polyline_f32;
/** As vesica_facts_f64. */
typedef struct {
    int64_t vertices, first_crossing, second_crossing;
    float area;
    int32_t orientation, convex, simple, rings;
} vesica_facts_f32;
/** As vesica_closest_points_f64. */
typedef struct { float distance, ax, ay, bx, by; } vesica_closest_points_f32;
/** As vesica_penetration_f64. */
typedef struct { float depth, x, y; } vesica_penetration_f32;

/** As vesica_check_f64. */
VESICA_API int32_t vesica_check_f32(int32_t kind, const void *shape);
/** As vesica_overlap_f64. */
VESICA_API int32_t vesica_overlap_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b);
/** As vesica_interiors_overlap_f64. */
VESICA_API int32_t vesica_interiors_overlap_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b);
/** As vesica_relation_f64. */
VESICA_API int32_t vesica_relation_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b);
/** As vesica_contains_f64. */
VESICA_API int32_t vesica_contains_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b);
/** As vesica_crossings_f64, rounded to float. */
VESICA_API int64_t vesica_crossings_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b,
                                        vesica_point_f32 *out, int64_t capacity, int32_t *shared);
/** As vesica_nearest_f64, rounded to float. */
VESICA_API int32_t vesica_nearest_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b,
                                      vesica_closest_points_f32 *out);
/** As vesica_boundary_distance_f64, rounded to float. */
VESICA_API int32_t vesica_boundary_distance_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b,
                                                vesica_closest_points_f32 *out);
/** As vesica_depth_f64, rounded to float. */
VESICA_API int32_t vesica_depth_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b,
                                    vesica_penetration_f32 *out);
/** As vesica_shape_area_f64, rounded to float. */
VESICA_API int32_t vesica_shape_area_f32(int32_t kind, const void *shape, float *out);
/** As vesica_polygon_facts_f64, rounded to float. */
VESICA_API int32_t vesica_polygon_facts_f32(const vesica_polygon_f32 *polygon, vesica_facts_f32 *out);
/** As vesica_area_f64, rounded to float. */
VESICA_API int32_t vesica_area_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b, float *out);
/** As vesica_iou_f64, rounded to float. */
VESICA_API int32_t vesica_iou_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b, float *out);
/** As vesica_bounds_f64. */
VESICA_API int32_t vesica_bounds_f32(int32_t kind, const void *shape, vesica_aabb_f32 *out);
/** As vesica_overlap_point_point_f64. */
VESICA_API int32_t vesica_overlap_point_point_f32(const vesica_point_f32 *a, const vesica_point_f32 *b);
/** As vesica_overlap_point_segment_f64. */
VESICA_API int32_t vesica_overlap_point_segment_f32(const vesica_point_f32 *a, const vesica_segment_f32 *b);
/** As vesica_overlap_point_circle_f64. */
VESICA_API int32_t vesica_overlap_point_circle_f32(const vesica_point_f32 *a, const vesica_circle_f32 *b);
/** As vesica_overlap_point_aabb_f64. */
VESICA_API int32_t vesica_overlap_point_aabb_f32(const vesica_point_f32 *a, const vesica_aabb_f32 *b);
/** As vesica_overlap_point_rect_f64. */
VESICA_API int32_t vesica_overlap_point_rect_f32(const vesica_point_f32 *a, const vesica_rect_f32 *b);
/** As vesica_overlap_point_ellipse_f64. */
VESICA_API int32_t vesica_overlap_point_ellipse_f32(const vesica_point_f32 *a, const vesica_ellipse_f32 *b);
/** As vesica_overlap_segment_segment_f64. */
VESICA_API int32_t vesica_overlap_segment_segment_f32(const vesica_segment_f32 *a, const vesica_segment_f32 *b);
/** As vesica_overlap_segment_circle_f64. */
VESICA_API int32_t vesica_overlap_segment_circle_f32(const vesica_segment_f32 *a, const vesica_circle_f32 *b);
/** As vesica_overlap_segment_aabb_f64. */
VESICA_API int32_t vesica_overlap_segment_aabb_f32(const vesica_segment_f32 *a, const vesica_aabb_f32 *b);
/** As vesica_overlap_segment_rect_f64. */
VESICA_API int32_t vesica_overlap_segment_rect_f32(const vesica_segment_f32 *a, const vesica_rect_f32 *b);
/** As vesica_overlap_segment_ellipse_f64. */
VESICA_API int32_t vesica_overlap_segment_ellipse_f32(const vesica_segment_f32 *a, const vesica_ellipse_f32 *b);
/** As vesica_overlap_circle_circle_f64. */
VESICA_API int32_t vesica_overlap_circle_circle_f32(const vesica_circle_f32 *a, const vesica_circle_f32 *b);
/** As vesica_overlap_circle_aabb_f64. */
VESICA_API int32_t vesica_overlap_circle_aabb_f32(const vesica_circle_f32 *a, const vesica_aabb_f32 *b);
/** As vesica_overlap_circle_rect_f64. */
VESICA_API int32_t vesica_overlap_circle_rect_f32(const vesica_circle_f32 *a, const vesica_rect_f32 *b);
/** As vesica_overlap_circle_ellipse_f64. */
VESICA_API int32_t vesica_overlap_circle_ellipse_f32(const vesica_circle_f32 *a, const vesica_ellipse_f32 *b);
/** As vesica_overlap_aabb_aabb_f64. */
VESICA_API int32_t vesica_overlap_aabb_aabb_f32(const vesica_aabb_f32 *a, const vesica_aabb_f32 *b);
/** As vesica_overlap_aabb_rect_f64. */
VESICA_API int32_t vesica_overlap_aabb_rect_f32(const vesica_aabb_f32 *a, const vesica_rect_f32 *b);
/** As vesica_overlap_aabb_ellipse_f64. */
VESICA_API int32_t vesica_overlap_aabb_ellipse_f32(const vesica_aabb_f32 *a, const vesica_ellipse_f32 *b);
/** As vesica_overlap_rect_rect_f64. */
VESICA_API int32_t vesica_overlap_rect_rect_f32(const vesica_rect_f32 *a, const vesica_rect_f32 *b);
/** As vesica_overlap_rect_ellipse_f64. */
VESICA_API int32_t vesica_overlap_rect_ellipse_f32(const vesica_rect_f32 *a, const vesica_ellipse_f32 *b);
/** As vesica_overlap_ellipse_ellipse_f64. */
VESICA_API int32_t vesica_overlap_ellipse_ellipse_f32(const vesica_ellipse_f32 *a, const vesica_ellipse_f32 *b);
/** As vesica_aabb_from_corners_f64. */
VESICA_API int32_t vesica_aabb_from_corners_f32(float x0, float y0, float x1, float y1, vesica_aabb_f32 *out);
/** As vesica_rect_from_angle_f64. */
VESICA_API int32_t vesica_rect_from_angle_f32(float cx, float cy, float angle, float width, float height,
                                              vesica_rect_f32 *out);
/** As vesica_rect_from_corners_f64. */
VESICA_API int32_t vesica_rect_from_corners_f32(const float corners[8], vesica_rect_f32 *out);
/** As vesica_rect_corners_misfit_f64. */
VESICA_API int32_t vesica_rect_corners_misfit_f32(const float corners[8], const vesica_rect_f32 *r, float *misfit);
/** As vesica_round_rect_from_angle_f64. */
VESICA_API int32_t vesica_round_rect_from_angle_f32(float cx, float cy, float angle, float width, float height,
                                                    float radius, vesica_round_rect_f32 *out);
/** As vesica_capsule_from_angle_f64. */
VESICA_API int32_t vesica_capsule_from_angle_f32(float cx, float cy, float angle, float length, float radius,
                                                 vesica_capsule_f32 *out);
/** As vesica_capsule_from_width_f64. */
VESICA_API int32_t vesica_capsule_from_width_f32(float x0, float y0, float x1, float y1, float width,
                                                 vesica_capsule_f32 *out);
/** As vesica_ellipse_from_angle_f64. */
VESICA_API int32_t vesica_ellipse_from_angle_f32(float cx, float cy, float angle, float a, float b,
                                                 vesica_ellipse_f32 *out);
/** As vesica_ellipse_from_radius_vector_f64. */
VESICA_API int32_t vesica_ellipse_from_radius_vector_f32(float cx, float cy, float wx, float wy, float ratio,
                                                         vesica_ellipse_f32 *out);
/** As vesica_ellipse_from_covariance_f64. */
VESICA_API int32_t vesica_ellipse_from_covariance_f32(float mean_x, float mean_y, float cxx, float cxy, float cyy,
                                                      float k, vesica_ellipse_f32 *out);
/** As vesica_ellipse_from_matrix_f64. */
VESICA_API int32_t vesica_ellipse_from_matrix_f32(float cx, float cy, float mxx, float mxy, float myy,
                                                  vesica_ellipse_f32 *out);

/** As vesica_shapes_f64. */
typedef struct {
    int32_t kind;
    int32_t reserved;
    int64_t count;
    ptrdiff_t stride;
    const float *field[8];
    const int32_t *rings;
    const int32_t *polygons;
    int64_t each;
} vesica_shapes_f32;

/** As vesica_shapes_from_records_f64. */
VESICA_API int32_t vesica_shapes_from_records_f32(int32_t kind, int64_t count, const void *base, ptrdiff_t stride,
                                                  vesica_shapes_f32 *out);
/** As vesica_overlap_many_f64. */
VESICA_API int64_t vesica_overlap_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, uint8_t *out);
/** As vesica_interiors_overlap_many_f64. */
VESICA_API int64_t vesica_interiors_overlap_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b,
                                                     uint8_t *out);
/** As vesica_relation_many_f64. */
VESICA_API int64_t vesica_relation_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, uint8_t *out);
/** As vesica_contains_many_f64. */
VESICA_API int64_t vesica_contains_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, uint8_t *out);
/** As vesica_nearest_many_f64. */
VESICA_API int64_t vesica_nearest_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *distance,
                                           float *ax, float *ay, float *bx, float *by);
/** As vesica_boundary_distance_many_f64. */
VESICA_API int64_t vesica_boundary_distance_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b,
                                                     float *distance, float *ax, float *ay, float *bx, float *by);
/** As vesica_depth_many_f64. */
VESICA_API int64_t vesica_depth_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *depth,
                                         float *x, float *y);
/** As vesica_area_many_f64. */
VESICA_API int64_t vesica_area_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *out);
/** As vesica_iou_many_f64. */
VESICA_API int64_t vesica_iou_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *out);
/** As vesica_overlap_matrix_f64. */
VESICA_API int64_t vesica_overlap_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, uint8_t *out,
                                             ptrdiff_t row_stride);
/** As vesica_interiors_overlap_matrix_f64. */
VESICA_API int64_t vesica_interiors_overlap_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b,
                                                       uint8_t *out, ptrdiff_t row_stride);
/** As vesica_relation_matrix_f64. */
VESICA_API int64_t vesica_relation_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, uint8_t *out,
                                              ptrdiff_t row_stride);
/** As vesica_contains_matrix_f64. */
VESICA_API int64_t vesica_contains_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, uint8_t *out,
                                              ptrdiff_t row_stride);
/** As vesica_area_matrix_f64. */
VESICA_API int64_t vesica_area_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *out,
                                          ptrdiff_t row_stride);
/** As vesica_iou_matrix_f64. */
VESICA_API int64_t vesica_iou_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *out,
                                         ptrdiff_t row_stride);
/** As vesica_overlap_select_f64. */
VESICA_API int64_t vesica_overlap_select_f32(const vesica_shapes_f32 *one, const vesica_shapes_f32 *many, int64_t *out,
                                             int64_t capacity);
/** As vesica_interiors_overlap_select_f64. */
VESICA_API int64_t vesica_interiors_overlap_select_f32(const vesica_shapes_f32 *one, const vesica_shapes_f32 *many,
                                                       int64_t *out, int64_t capacity);
/** As vesica_nms_f64. */
VESICA_API int32_t vesica_nms_f32(const vesica_shapes_f32 *shapes, const float *scores, float threshold, void *scratch,
                                  int64_t scratch_size, int64_t *keep, int64_t *kept);

#ifdef __cplusplus
}
#endif

#include "vesica_boxes.h"     /* arrays of boxes by centre, size and angle; corners and bounds of arrays */
#include "vesica_detection.h" /* pairs by ratio, assignment, fusion of boxes, average precision */
#include "vesica_generic.h"   /* C11 only: vesica_overlap(&a, &b) and the like take kinds and scalar from the types */
#include "vesica_index.h"     /* index and join, for the pairs among millions of shapes */
#include "vesica_measures.h"  /* ratios of shared area, suppression, signed distance, within a distance */
#include "vesica_motion.h"    /* casts of moving shapes, rays */
#include "vesica_topology.h"  /* nine-intersection matrices, shared regions */
#endif /* VESICA_H */
