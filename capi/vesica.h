/*
 * Vesica: exact overlap queries between plain 2D shapes.
 *
 * SPDX-License-Identifier: Apache-2.0
 *
 * Rules that hold for every function:
 *  - A shape is exactly what its stored numbers say. The axis (ux, uy) of a rectangle or an ellipse is a direction
 *    and a unit of length: it is never renormalised, and (2, 0) with half extent 1 means the same as (1, 0) with 2.
 *    Pass the cosine and sine of an angle and this needs no thought. perp(u) is (-uy, ux).
 *  - Shapes are closed and solid: touching is overlap, a shape inside another overlaps it. Zero sizes are legal: a
 *    rectangle of half height 0 is a segment, a circle of radius 0 a point.
 *  - Coordinates and sizes share one unit, any unit. Subnormal, huge and mixed magnitudes are all answered exactly.
 *  - int32_t results are an answer >= 0 or a negative VESICA_E_ error. Nothing is written through an output pointer
 *    on error. NULL for a pointer is VESICA_E_NULL; it is looked at first, then the kind, then the numbers.
 *  - Input is only read and may be shared, the same shape twice included. Arrays of shapes (vesica_shapes) need no
 *    alignment; other pointers have that of their types, as always in C.
 *  - No function allocates, locks, prints, sets errno or keeps state: all are thread-safe and reentrant, at any
 *    rounding mode of the caller's that is to-nearest. Calls may raise floating-point flags; traps must be masked, as C
 *    has them. The exact stage uses at most 128 KiB of stack.
 *
 * The order of the shapes, point segment circle aabb rect ellipse, is the order of arguments in typed functions.
 */
#ifndef VESICA_H
#define VESICA_H

#include <stddef.h>
#include <stdint.h>

#if defined(VESICA_BUILDING) && defined(__GNUC__)
#define VESICA_API __attribute__((visibility("default")))
#else
#define VESICA_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Constants. Each is also a function of the same name in lower case, for hosts without a C compiler. ---- */

#define VESICA_VERSION_MAJOR 0
#define VESICA_VERSION_MINOR 1
#define VESICA_VERSION_PATCH 0
/** Version of this header: major * 10000 + minor * 100 + patch. */
#define VESICA_VERSION 100

#define VESICA_POINT 0   /**< x y */
#define VESICA_SEGMENT 1 /**< x0 y0 x1 y1 */
#define VESICA_CIRCLE 2  /**< cx cy r */
#define VESICA_AABB 3    /**< min_x min_y max_x max_y */
#define VESICA_RECT 4    /**< cx cy ux uy hx hy */
#define VESICA_ELLIPSE 5 /**< cx cy ux uy a b */

/* The relation of a to b, by vesica_relation. */
#define VESICA_DISJOINT 0       /**< no common point */
#define VESICA_TOUCH 1          /**< common points, none of them inside both */
#define VESICA_CROSS 2          /**< the insides meet, and neither contains the other */
#define VESICA_INSIDE 3         /**< b contains a, and a stays clear of b's outline */
#define VESICA_INSIDE_TOUCH 4   /**< b contains a, and a reaches b's outline */
#define VESICA_CONTAINS 5       /**< a contains b, and b stays clear of a's outline */
#define VESICA_CONTAINS_TOUCH 6 /**< a contains b, and b reaches a's outline */
#define VESICA_EQUAL 7          /**< the same set of points */

#define VESICA_E_NULL (-1)          /**< a pointer is NULL */
#define VESICA_E_SHAPE (-2)         /**< a shape is invalid; vesica_check says why */
#define VESICA_E_KIND (-3)          /**< a kind is not one of the six */
#define VESICA_E_ARGUMENT (-4)      /**< another argument is out of its documented range */
#define VESICA_E_NOT_FINITE (-5)    /**< a number is NaN or infinite */
#define VESICA_E_NEGATIVE_SIZE (-6) /**< a radius, half extent or half length is negative */
#define VESICA_E_ZERO_AXIS (-7)     /**< the axis (ux, uy) is (0, 0) */
#define VESICA_E_INVERTED (-8)      /**< an AABB's min exceeds its max */
#define VESICA_E_RANGE (-9)         /**< the result would leave the finite range of its type */

/** Version of the loaded library, as VESICA_VERSION. Compare the two to find a library older than the header. Since 0.1. */
VESICA_API int32_t vesica_version(void);
/** VESICA_VERSION_MAJOR of the loaded library. Since 0.1. */
VESICA_API int32_t vesica_version_major(void);
/** VESICA_VERSION_MINOR of the loaded library. Since 0.1. */
VESICA_API int32_t vesica_version_minor(void);
/** VESICA_VERSION_PATCH of the loaded library. Since 0.1. */
VESICA_API int32_t vesica_version_patch(void);
/** VESICA_POINT. Since 0.1. */
VESICA_API int32_t vesica_point(void);
/** VESICA_SEGMENT. Since 0.1. */
VESICA_API int32_t vesica_segment(void);
/** VESICA_CIRCLE. Since 0.1. */
VESICA_API int32_t vesica_circle(void);
/** VESICA_AABB. Since 0.1. */
VESICA_API int32_t vesica_aabb(void);
/** VESICA_RECT. Since 0.1. */
VESICA_API int32_t vesica_rect(void);
/** VESICA_ELLIPSE. Since 0.1. */
VESICA_API int32_t vesica_ellipse(void);
/** VESICA_DISJOINT. Since 0.1. */
VESICA_API int32_t vesica_disjoint(void);
/** VESICA_TOUCH. Since 0.1. */
VESICA_API int32_t vesica_touch(void);
/** VESICA_CROSS. Since 0.1. */
VESICA_API int32_t vesica_cross(void);
/** VESICA_INSIDE. Since 0.1. */
VESICA_API int32_t vesica_inside(void);
/** VESICA_INSIDE_TOUCH. Since 0.1. */
VESICA_API int32_t vesica_inside_touch(void);
/** VESICA_CONTAINS. Since 0.1. */
VESICA_API int32_t vesica_contains(void);
/** VESICA_CONTAINS_TOUCH. Since 0.1. */
VESICA_API int32_t vesica_contains_touch(void);
/** VESICA_EQUAL. Since 0.1. */
VESICA_API int32_t vesica_equal(void);
/** VESICA_E_NULL. Since 0.1. */
VESICA_API int32_t vesica_e_null(void);
/** VESICA_E_SHAPE. Since 0.1. */
VESICA_API int32_t vesica_e_shape(void);
/** VESICA_E_KIND. Since 0.1. */
VESICA_API int32_t vesica_e_kind(void);
/** VESICA_E_ARGUMENT. Since 0.1. */
VESICA_API int32_t vesica_e_argument(void);
/** VESICA_E_NOT_FINITE. Since 0.1. */
VESICA_API int32_t vesica_e_not_finite(void);
/** VESICA_E_NEGATIVE_SIZE. Since 0.1. */
VESICA_API int32_t vesica_e_negative_size(void);
/** VESICA_E_ZERO_AXIS. Since 0.1. */
VESICA_API int32_t vesica_e_zero_axis(void);
/** VESICA_E_INVERTED. Since 0.1. */
VESICA_API int32_t vesica_e_inverted(void);
/** VESICA_E_RANGE. Since 0.1. */
VESICA_API int32_t vesica_e_range(void);

/**
 * What a result code means, in one English phrase without a final stop.
 *
 * Answers (>= 0) give "success", unknown codes "unknown error". Never NULL; static storage, not to be freed. Since 0.1.
 */
VESICA_API const char *vesica_strerror(int32_t code);

/**
 * How many numbers a shape of this kind has: 2, 4, 3, 4, 6, 6. Errors: VESICA_E_KIND. Since 0.1.
 */
VESICA_API int32_t vesica_field_count(int32_t kind);

/**
 * Name of a kind: "point" ... "ellipse"; NULL for an unknown kind. Static storage. Since 0.1.
 */
VESICA_API const char *vesica_kind_name(int32_t kind);

/**
 * Name of the instruction set that batches run on: "sse2", "avx2", "avx512", "neon" or "portable", the best this
 * processor has. VESICA_ISA in the environment, read once when the library is loaded, forces one; a name that is
 * unknown or of a set the processor lacks is ignored. Answers never depend on it. Static storage. Since 0.1.
 */
VESICA_API const char *vesica_isa_name(void);

/* ---- double: shapes as plain structs without padding; their layout is frozen. ---- */

/** A location. */
typedef struct {
    double x, y;
} vesica_point_f64;

/** All points between two end points; the same end point twice is a point. */
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

/** All C + s u + t perp(u) with |s| <= hx and |t| <= hy; hx, hy >= 0, u != 0. */
typedef struct {
    double cx, cy, ux, uy, hx, hy;
} vesica_rect_f64;

/** All C + s u + t perp(u) with (s/a)^2 + (t/b)^2 <= 1; a, b >= 0, u != 0. */
typedef struct {
    double cx, cy, ux, uy, a, b;
} vesica_ellipse_f64;

/** A distance, and the points of two shapes a and b that are that far apart. */
typedef struct {
    double distance, ax, ay, bx, by;
} vesica_closest_points_f64;

/** Where two outlines meet: `count` places (x[i], y[i]), the rest 0; shared: 1 where they have a stretch in common. */
typedef struct {
    int32_t count, shared;
    double x[8], y[8];
} vesica_crossing_points_f64;

/** How far to move the second of two overlapping shapes: its unit direction, and the distance. */
typedef struct {
    double depth, x, y;
} vesica_penetration_f64;

/* ---- double: functions. Typed pairs return 1 (share a point, touching counts) or 0; errors: VESICA_E_NULL,
        VESICA_E_SHAPE. Cost: a few to 20 ns; on the rare near-ties the filter cannot decide, 0.1 to 3 us. ---- */

/**
 * Is a shape valid, and if not, which rule does it break?
 *
 * kind: VESICA_POINT ... VESICA_ELLIPSE. numbers: the shape's numbers in its order.
 * Returns 0 for a valid shape, else the first rule broken: VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE,
 * VESICA_E_ZERO_AXIS or VESICA_E_INVERTED. Errors: VESICA_E_NULL, VESICA_E_KIND. Cost: a few ns. Since 0.1.
 */
VESICA_API int32_t vesica_check_f64(int32_t kind, const double *numbers);

/**
 * Do two shapes of any kinds share a point? Either order of kinds.
 *
 * numbers_a, numbers_b: each shape's numbers in its order; they may be the same memory.
 * Returns 1 when they share a point (touching counts), 0 when not. Errors: VESICA_E_NULL, VESICA_E_KIND,
 * VESICA_E_SHAPE. Exact for every valid shape. Cost: that of the typed function plus about 2 ns. Since 0.1.
 */
VESICA_API int32_t vesica_overlap_f64(int32_t kind_a, const double *numbers_a,
                                       int32_t kind_b, const double *numbers_b);

/** 1 when the two points are the same. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_point_point_f64(const vesica_point_f64 *a, const vesica_point_f64 *b);
/** 1 when the point lies on the segment, end points included. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_point_segment_f64(const vesica_point_f64 *a, const vesica_segment_f64 *b);
/** 1 when the point lies in the disc or on its rim. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_point_circle_f64(const vesica_point_f64 *a, const vesica_circle_f64 *b);
/** 1 when the point lies in the box or on its outline. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_point_aabb_f64(const vesica_point_f64 *a, const vesica_aabb_f64 *b);
/** 1 when the point lies in the rectangle or on its outline. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_point_rect_f64(const vesica_point_f64 *a, const vesica_rect_f64 *b);
/** 1 when the point lies in the ellipse or on its outline. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_point_ellipse_f64(const vesica_point_f64 *a, const vesica_ellipse_f64 *b);
/** 1 when the segments share a point, end points and collinear overlaps included. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_segment_segment_f64(const vesica_segment_f64 *a, const vesica_segment_f64 *b);
/** 1 when the segment meets the disc; a tangent segment does. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_segment_circle_f64(const vesica_segment_f64 *a, const vesica_circle_f64 *b);
/** 1 when the segment meets the box; one wholly inside does. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_segment_aabb_f64(const vesica_segment_f64 *a, const vesica_aabb_f64 *b);
/** 1 when the segment meets the rectangle; one wholly inside does. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_segment_rect_f64(const vesica_segment_f64 *a, const vesica_rect_f64 *b);
/** 1 when the segment meets the ellipse; a tangent segment does. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_segment_ellipse_f64(const vesica_segment_f64 *a, const vesica_ellipse_f64 *b);
/** 1 when the discs share a point; discs touching from outside do. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_circle_circle_f64(const vesica_circle_f64 *a, const vesica_circle_f64 *b);
/** 1 when the disc and the box share a point. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_circle_aabb_f64(const vesica_circle_f64 *a, const vesica_aabb_f64 *b);
/** 1 when the disc and the rectangle share a point. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_circle_rect_f64(const vesica_circle_f64 *a, const vesica_rect_f64 *b);
/** 1 when the disc and the ellipse share a point. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_circle_ellipse_f64(const vesica_circle_f64 *a, const vesica_ellipse_f64 *b);
/** 1 when the boxes share a point; boxes sharing an edge or a corner do. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_aabb_aabb_f64(const vesica_aabb_f64 *a, const vesica_aabb_f64 *b);
/** 1 when the box and the rectangle share a point. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_aabb_rect_f64(const vesica_aabb_f64 *a, const vesica_rect_f64 *b);
/** 1 when the box and the ellipse share a point. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_aabb_ellipse_f64(const vesica_aabb_f64 *a, const vesica_ellipse_f64 *b);
/** 1 when the rectangles share a point; rectangles sharing an edge or a corner do. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_rect_rect_f64(const vesica_rect_f64 *a, const vesica_rect_f64 *b);
/** 1 when the rectangle and the ellipse share a point; one inside the other does. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_rect_ellipse_f64(const vesica_rect_f64 *a, const vesica_ellipse_f64 *b);
/** 1 when the ellipses share a point; one inside the other does. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_ellipse_ellipse_f64(const vesica_ellipse_f64 *a, const vesica_ellipse_f64 *b);

/**
 * How do two shapes of any kinds relate? One of RCC-8's eight: VESICA_DISJOINT ... VESICA_EQUAL, of a to b.
 *
 * The outline of a shape with area is the curve around it; that of a segment, or of any shape with one size zero, its
 * two end points; a point, or a shape with no size, has none. The inside is the rest. The first that holds:
 * VESICA_EQUAL, the same set of points, whatever kinds and numbers describe it; VESICA_INSIDE, b contains a, and a has
 * no point of b's outline; VESICA_INSIDE_TOUCH, b contains a, and a has points of b's outline; VESICA_CONTAINS and
 * VESICA_CONTAINS_TOUCH, the same with a and b exchanged; VESICA_CROSS, the two insides have a common point;
 * VESICA_TOUCH, the shapes have one; VESICA_DISJOINT. So a segment's end on another's middle is touch, two segments
 * along one line that overlap in part cross, and a point on a rim is inside with touch.
 *
 * numbers_a, numbers_b: each shape's numbers in its order; they may be the same memory. Returns the relation;
 * exchanging the shapes gives the converse, always. Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE. Exact for
 * every valid shape. Cost: up to twice that of vesica_overlap_f64; where shapes touch or are equal, 0.1 to 8 us.
 * Since 0.1.
 */
VESICA_API int32_t vesica_relation_f64(int32_t kind_a, const double *numbers_a,
                                       int32_t kind_b, const double *numbers_b);

/**
 * Does shape a contain all of shape b? Either order of kinds; a shape contains itself, and all it touches from inside.
 *
 * Returns 1 where vesica_relation_f64 is VESICA_CONTAINS, VESICA_CONTAINS_TOUCH or VESICA_EQUAL, else 0. Everything
 * else as there. Since 0.1.
 */
VESICA_API int32_t vesica_contains_f64(int32_t kind_a, const double *numbers_a,
                                       int32_t kind_b, const double *numbers_b);

/**
 * The places where the outlines of two shapes of any kinds meet, touching included. Either order of kinds.
 *
 * The outline of a shape with area is the curve around it; a segment, a point, and a shape without area are their own
 * outlines. How many places there are, up to 8, is exact: where outlines touch, to whatever order, is one. A stretch
 * that straight outlines have in common counts as its two end points and sets out->shared; equal boxes have their
 * corners. Equal curves have no single places: the count is 0 and out->shared 1.
 * Places are in order along a's outline: counter-clockwise about its axis from a box's corner C - hx u - hy perp(u),
 * from an ellipse's end C + a u of its axis (a circle's C + (r, 0)); from a segment's first end.
 * Accuracy: within 16 u of the greatest coordinate and size met, u = 2^-53; for two ellipses where they cross. Two that
 * nearly touch, or touch to order k: within 2^(-90/k) of the lesser one's size, along both outlines; differ by a part
 * e of it all round: within 2^-90 / e.
 * out: untouched on error; may not overlap the numbers. Returns the count. Errors: VESICA_E_NULL, VESICA_E_KIND,
 * VESICA_E_SHAPE, VESICA_E_RANGE (a place is beyond the finite numbers). Cost: 5 to 20 us; disjoint shapes as
 * vesica_overlap_f64. Since 0.1.
 */
VESICA_API int32_t vesica_crossings_f64(int32_t kind_a, const double *numbers_a,
                                        int32_t kind_b, const double *numbers_b, vesica_crossing_points_f64 *out);

/**
 * How far apart are two solid shapes of any kinds, in either order, and which points of them are closest?
 *
 * Disjoint shapes (as vesica_overlap_f64 says, exactly): out->distance > 0, the closest point of a (ax, ay), and that
 * of b (bx, by). Shapes that share a point: distance 0, and both points are one common point. Where several answers are
 * equally right it is one of them. Exchanging the shapes exchanges the points and changes no bit; moving both by the
 * same exact amounts changes no bit of the distance.
 * Accuracy, u = 2^-53 and scale the largest coordinate of the offset of centres or half length: the distance is right
 * to 4 u scale at any aspect ratio (longer over shorter size), 1 u scale having been seen; to 2 u of itself where it is
 * above 1e-10 scale at aspects up to 1e6, above 1e-14 scale at aspects up to 1000; and never 0 for disjoint shapes.
 * Closest points lie within 4 u scale of their shapes' outlines, common points within 8 u scale of both shapes, before
 * the rounding of their coordinates.
 * out: untouched on error; may not overlap the numbers. Returns 0. Errors: VESICA_E_NULL, VESICA_E_KIND,
 * VESICA_E_SHAPE, VESICA_E_RANGE (the distance or a coordinate would leave the finite range). Cost: 100 to 200 ns for
 * disjoint shapes, the thinnest ellipses 300 ns; 50 ns where a centre lies in the other shape; 0.3 to 3 us for shapes
 * that cross, for ties within rounding and for magnitudes beyond 2^+-40. Since 0.1.
 */
VESICA_API int32_t vesica_nearest_f64(int32_t kind_a, const double *numbers_a, int32_t kind_b, const double *numbers_b,
                                      vesica_closest_points_f64 *out);

/**
 * Distance between the outlines of two shapes of any kinds, in either order, and where they come closest.
 *
 * The outline of a shape with area is the curve around it; of a point, a segment or any shape with a zero size it is
 * all of the shape. Outlines that share a point: distance 0, and (ax, ay) = (bx, by) is a point of both, rounded.
 * Disjoint shapes: as vesica_nearest_f64. One shape strictly inside the other: the least distance over the whole
 * outline, never a local minimum, and the closest point on each. Where several pairs of points are equally close it is
 * one of them. Which case it is, is decided exactly (vesica_relation_f64). Exchanging the shapes exchanges the points
 * and changes no bit; moving both by the same exact amounts leaves every bit of the distance.
 * Accuracy, u = 2^-53 and scale the largest coordinate of the offset of centres or half length: the distance is right
 * to 4 u scale at aspect ratios up to 1e6, and never rounded to 0 where outlines are apart; each point is within 4 u
 * scale times the greater aspect ratio of its outline, before the rounding of its coordinates.
 * out: untouched on error; may not overlap the numbers. Returns 0. Errors: VESICA_E_NULL, VESICA_E_KIND,
 * VESICA_E_SHAPE, VESICA_E_RANGE (a number would leave the finite range). Cost: that of
 * vesica_nearest_f64 for disjoint shapes, 0.1 to 0.5 us for nested ones, 1 us more for few of them; 0.5 to 2 us for a
 * common point; up to 5 us more where it takes exact arithmetic to tell how the shapes relate. Since 0.1.
 */
VESICA_API int32_t vesica_boundary_distance_f64(int32_t kind_a, const double *numbers_a,
                                                int32_t kind_b, const double *numbers_b,
                                                vesica_closest_points_f64 *out);

/**
 * Penetration depth of two shapes of any kinds, in either order: how far must b be moved so that they only touch?
 *
 * out->depth is the least length of a translation of b after which a line has a on its one side and b on its other,
 * both up to the line itself; moving b by depth along the unit vector (x, y) does it. Disjoint shapes: all three are 0.
 * Overlapping shapes always get a direction, and depth 0 exactly where they have such a line already: shapes that touch
 * from outside, a point on an outline, and points or segments along one line. Otherwise depth > 0, however small.
 * Where several directions do equally well it is one of them. Exchanging the shapes turns the direction round and
 * changes no other bit (two equal shapes in one place excepted); moving both by the same exact amounts changes no bit
 * at all.
 * Accuracy, u = 2^-53 and scale the largest coordinate of the offset of centres or half length: depth is right to
 * 4 u scale at aspect ratios up to 1e6, (x, y) is of length 1 to 3 u and moves b clear but for 4 u scale.
 * out: untouched on error; may not overlap the numbers. Returns 0. Errors: VESICA_E_NULL, VESICA_E_KIND,
 * VESICA_E_SHAPE, VESICA_E_RANGE (the depth would leave the finite range). Cost: about 150 ns for two boxes (points and
 * segments are boxes), 0.5 us with an ellipse, 1 us more for few of these; up to 5 us where it takes exact arithmetic
 * to tell a depth from 0. Since 0.1.
 */
VESICA_API int32_t vesica_depth_f64(int32_t kind_a, const double *numbers_a, int32_t kind_b, const double *numbers_b,
                                    vesica_penetration_f64 *out);

/**
 * Area of one shape: 4 hx hy u.u of a rectangle, pi a b u.u of an ellipse, 0 of a point or a segment.
 *
 * The nearest number to the true area, so a shape inside another never has the greater one,
 * and equal shapes have the same whatever kinds and numbers describe them. out: untouched on error; may not overlap
 * numbers. Returns 0. Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE (beyond the finite numbers;
 * one too small becomes subnormal or 0). Cost: about 20 ns. Since 0.1.
 */
VESICA_API int32_t vesica_shape_area_f64(int32_t kind, const double *numbers, double *out);

/**
 * Area of the intersection of two shapes of any kinds, in either order.
 *
 * Shapes that are disjoint, that touch (as vesica_relation_f64 says) or of which one has no area share exactly 0; where
 * one contains the other, exactly the vesica_shape_area_f64 of the inner one. Never more than the area of either, and
 * more than 0 wherever insides meet, unless that underflows. Exchanging the shapes changes no bit, nor does scaling
 * both by a power of two, but for its square.
 * Accuracy: within 64 u of the lesser shape's area times the larger of the two aspects (longer size over shorter; for
 * aspects up to 10^4), u = 2^-53, however near the outlines are to touching or coinciding and however different the
 * sizes are.
 * out: untouched on error; may not overlap the numbers. Returns 0. Errors: VESICA_E_NULL, VESICA_E_KIND,
 * VESICA_E_SHAPE, VESICA_E_RANGE (beyond the finite numbers). Cost: two boxes about 50 ns, an ellipse and a box 150 ns,
 * two ellipses 0.6 us; up to 10 us where outlines nearly touch or coincide, or one shape is far larger. Since 0.1.
 */
VESICA_API int32_t vesica_area_f64(int32_t kind_a, const double *numbers_a,
                                   int32_t kind_b, const double *numbers_b, double *out);

/**
 * Intersection over union (Jaccard index) of two shapes: their vesica_area_f64 over the area of both together.
 *
 * From 0 to 1: exactly 1 for equal shapes, exactly 0 for shapes that share no area. Nothing overflows or underflows on
 * the way, whatever the sizes. Accuracy: that of the area, over the area of the union. Exchanging the shapes, or
 * scaling both by a power of two, changes no bit.
 * out: untouched on error; may not overlap the numbers. Returns 0. Errors: VESICA_E_NULL, VESICA_E_KIND,
 * VESICA_E_SHAPE, VESICA_E_ARGUMENT (neither shape has an area; with one that has, the ratio is 0). Cost: that of
 * vesica_area_f64 and two of vesica_shape_area_f64. Since 0.1.
 */
VESICA_API int32_t vesica_iou_f64(int32_t kind_a, const double *numbers_a,
                                  int32_t kind_b, const double *numbers_b, double *out);

/**
 * Smallest box of representable numbers that contains a shape: each side is the shape's true extreme rounded
 * outward once, so a box that is representable is exact.
 *
 * out: untouched on error; may not overlap numbers. Returns 0. Errors: VESICA_E_NULL, VESICA_E_KIND,
 * VESICA_E_SHAPE, VESICA_E_RANGE (the box would leave the finite range). Cost: up to 80 ns; 1 to 3 us for an
 * ellipse with an oblique axis and representable sides, or with magnitudes beyond 2^+-400. Since 0.1.
 */
VESICA_API int32_t vesica_bounds_f64(int32_t kind, const double *numbers, vesica_aabb_f64 *out);

/**
 * Box with two opposite corners, in any order. Exact. Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE. Since 0.1.
 */
VESICA_API int32_t vesica_aabb_from_corners_f64(double x0, double y0, double x1, double y1,
                                                vesica_aabb_f64 *out);

/**
 * Rectangle from centre, angle and full size: width along the angle, height across it.
 *
 * angle: radians, counter-clockwise from +x where y points up. The axis is (cos, sin), each right to 1 unit in the
 * last place; multiples of a quarter turn given as the nearest number to k pi/2 are axis-parallel only to that
 * rounding. Sizes are exact: where halving one would round (an odd multiple of the smallest subnormal number), the
 * axis is halved in their place.
 * Returns 0. Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE. Cost: about 40 ns. Since 0.1.
 */
VESICA_API int32_t vesica_rect_from_angle_f64(double cx, double cy, double angle, double width, double height,
                                              vesica_rect_f64 *out);

/**
 * Rectangle from its four corners in order round the outline (either turning sense).
 *
 * corners: x0 y0 ... x3 y3. The corners are averaged: a parallelogram or worse becomes a rectangle near it, so
 * the result need not contain corners that were not a rectangle's. The centre is the mean of the corners. The axis is
 * a unit vector along the first edge, from corner 0 to 1, and hx belongs to that edge; opposite edges are averaged,
 * the longer pair gives the direction, and the shorter counts by its part across the longer. Two or four equal
 * corners are legal: a segment, or a point with axis (1, 0).
 * Accuracy: half extents, and the axis times the longer one, are right to 8 units in the last place of the longer,
 * the centre to 1 in its own, both plus 2^-98 times the largest coordinate. The corners of an axis-parallel rectangle
 * give it exactly when its centre and half extents are representable.
 * Returns 0. Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_RANGE (a half extent overflows).
 * Cost: about 110 ns. Since 0.1.
 */
VESICA_API int32_t vesica_rect_from_corners_f64(const double corners[8], vesica_rect_f64 *out);

/**
 * Ellipse from centre, angle (as vesica_rect_from_angle) and half lengths: a along the angle, b across it.
 *
 * Returns 0. Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE. Cost: about 40 ns. Since 0.1.
 */
VESICA_API int32_t vesica_ellipse_from_angle_f64(double cx, double cy, double angle, double a, double b,
                                                 vesica_ellipse_f64 *out);

/**
 * Ellipse from centre, radius vector and ratio: one half axis is the vector (wx, wy), the other is
 * perp(wx, wy) times ratio. Exact: nothing is rounded. A zero vector gives the point (cx, cy).
 *
 * Returns 0. Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE. Since 0.1.
 */
VESICA_API int32_t vesica_ellipse_from_radius_vector_f64(double cx, double cy, double wx, double wy, double ratio,
                                                         vesica_ellipse_f64 *out);

/**
 * Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
 *
 * cxx, cxy, cyy: the covariance matrix, units squared; it must be positive semidefinite, cxy^2 <= cxx cyy, as stored.
 * A singular one, or k = 0, gives a segment or a point. a >= b; the axis is a unit vector with x >= 0, (1, 0) for
 * equal variances without correlation. Half lengths and both components of the axis are each right to
 * 8 units in their own last place, however near to singular or to a circle.
 * Returns 0. Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE (k < 0), VESICA_E_ARGUMENT (not a
 * covariance), VESICA_E_RANGE (a half length overflows). Cost: about 90 ns. Since 0.1.
 */
VESICA_API int32_t vesica_ellipse_from_covariance_f64(double mean_x, double mean_y, double cxx, double cxy, double cyy,
                                                      double k, vesica_ellipse_f64 *out);

/**
 * Ellipse of the points X with (X - C) . M (X - C) <= 1, M symmetric with entries mxx, mxy, myy.
 *
 * M must be positive definite as stored. Lengths, axis and accuracy as vesica_ellipse_from_covariance of the inverse
 * matrix and k = 1. No half length can overflow.
 * Returns 0. Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_ARGUMENT (not positive definite).
 * Cost: about 90 ns. Since 0.1.
 */
VESICA_API int32_t vesica_ellipse_from_matrix_f64(double cx, double cy, double mxx, double mxy, double myy,
                                                  vesica_ellipse_f64 *out);

/**
 * An array of shapes of one kind, however it lies in memory: records, packed or padded, or a column a number.
 *
 * Element i has its number k at field[k] + i * stride bytes, k in the order of the shape. stride is a record's size for
 * records, sizeof(double) for columns, 0 to repeat one shape, negative to run backwards. Fields beyond the kind's are
 * not looked at. Numbers need no alignment. reserved must be 0.
 */
typedef struct {
    int32_t kind;
    int32_t reserved;
    int64_t count;
    ptrdiff_t stride;
    const double *field[6];
} vesica_shapes_f64;

/**
 * Fills *out for `count` records that start at base, each a vesica_<kind>_f64 followed by whatever else the record
 * holds.
 *
 * stride: bytes from one record to the next; base: the first record's shape. Returns 0. Errors: VESICA_E_NULL (base may
 * be NULL where count is 0), VESICA_E_KIND, VESICA_E_ARGUMENT (negative count). Since 0.1.
 */
VESICA_API int32_t vesica_shapes_from_records_f64(int32_t kind, int64_t count, const void *base, ptrdiff_t stride,
                                                  vesica_shapes_f64 *out);

/**
 * Overlap of two arrays in step: out[i] = 1 where a[i] and b[i] share a point, else 0.
 *
 * Kinds in either order. Counts agree, or one of them is 1 and that shape is repeated. out: as many bytes as the larger
 * count (0 when either count is 0); it may not overlap the input. Returns how many are 1.
 * An invalid element gets 0, every valid one its right answer, and the call returns VESICA_E_SHAPE. Before anything is
 * written: VESICA_E_NULL (with nothing to answer, fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts
 * that are negative or do not agree, reserved not 0, count times stride beyond the address space).
 * Answers equal vesica_overlap_f64's, on every instruction set and in every layout. Cost, in cache, columns: about
 * 1 to 3 ns a pair with AVX-512; near-ties as scalar calls. Uses at most 256 KiB of stack. Since 0.1.
 */
VESICA_API int64_t vesica_overlap_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, uint8_t *out);

/**
 * Overlap of every a with every b: out[i * row_stride + j] = 1 where a[i] and b[j] share a point, else 0.
 *
 * row_stride: bytes from one row of answers to the next, at least b's count unless a's count is at most 1 (negative:
 * the rows run backwards in memory). Returns how many are 1. Everything else, errors included, as
 * vesica_overlap_many_f64; VESICA_E_ARGUMENT also when rows would overlap or lie beyond the address space. Cost: as one
 * shape against many, however large the arrays are. Since 0.1.
 */
VESICA_API int64_t vesica_overlap_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, uint8_t *out,
                                             ptrdiff_t row_stride);

/**
 * Which of many does one shape overlap? Writes their indices, ascending, to out[0], out[1] ...
 *
 * one: an array of count 1. capacity: room in out, in indices; it may be 0, and out NULL with it. Returns how many
 * there are, also beyond the capacity; where room is left after the last index, the next entry is -1.
 * An invalid element is not selected, the indices of valid ones are written, and the call returns VESICA_E_SHAPE: then
 * -1 or the capacity ends them. Other errors as vesica_overlap_many_f64; VESICA_E_ARGUMENT also when one's count is not
 * 1 or the capacity is negative. Since 0.1.
 */
VESICA_API int64_t vesica_overlap_select_f64(const vesica_shapes_f64 *one, const vesica_shapes_f64 *many, int64_t *out,
                                             int64_t capacity);

/**
 * Bytes of scratch that vesica_nms_f64 and vesica_nms_f32 need for that many shapes: about 56 each. Errors:
 * VESICA_E_ARGUMENT (negative count, or one whose scratch has no size). Since 0.1.
 */
VESICA_API int64_t vesica_nms_scratch(int64_t count);

/**
 * Greedy non-maximum suppression: in the order of their scores, highest first, each shape is kept unless its
 * vesica_iou_f64 with one kept before is greater than the threshold.
 *
 * shapes: one kind, VESICA_CIRCLE to VESICA_ELLIPSE. scores: one each; equal ones go by index, infinite ones are legal.
 * threshold: 0 to 1, and not itself suppressing: at 1 all are kept. scratch: vesica_nms_scratch bytes or more, of any
 * alignment and content. keep: room for as many indices as there are shapes; the kept ones, in the order of their
 * scores; what follows them is not written. *kept: how many. No output may overlap another or the input.
 * Returns 0. A shape that is invalid, or whose score is NaN, is left out as if it were not there, keep and *kept are
 * written, and the call returns VESICA_E_SHAPE. Before anything is written: VESICA_E_NULL (with no shapes, only shapes
 * and kept are looked at), VESICA_E_KIND (also for points and segments), VESICA_E_ARGUMENT (as vesica_overlap_many_f64
 * of the array; the threshold; too little scratch). Cost: sorting, and an IoU for each pair of a kept shape and one
 * whose bounds meet its own: 10,000 scattered rectangles about 15 ms. Since 0.1.
 */
VESICA_API int32_t vesica_nms_f64(const vesica_shapes_f64 *shapes, const double *scores, double threshold,
                                  void *scratch, int64_t scratch_size, int64_t *keep, int64_t *kept);

/**
 * Relation of two arrays in step: out[i] = the code of vesica_relation_f64 for a[i] and b[i].
 *
 * Returns how many are not VESICA_DISJOINT. Everything else, errors included, as vesica_overlap_many_f64; an invalid
 * element gets 0. Answers equal vesica_relation_f64's. Since 0.1.
 */
VESICA_API int64_t vesica_relation_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, uint8_t *out);

/**
 * Relation of every a to every b: out[i * row_stride + j] = the code for a[i] and b[j].
 *
 * Returns how many are not VESICA_DISJOINT. Everything else as vesica_overlap_matrix_f64. Since 0.1.
 */
VESICA_API int64_t vesica_relation_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, uint8_t *out,
                                              ptrdiff_t row_stride);

/**
 * Containment of two arrays in step: out[i] = 1 where a[i] contains all of b[i], else 0.
 *
 * Returns how many are 1. Everything else, errors included, as vesica_overlap_many_f64. Since 0.1.
 */
VESICA_API int64_t vesica_contains_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, uint8_t *out);

/**
 * Containment of every b in every a: out[i * row_stride + j] = 1 where a[i] contains all of b[j], else 0.
 *
 * Returns how many are 1. Everything else as vesica_overlap_matrix_f64. Since 0.1.
 */
VESICA_API int64_t vesica_contains_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, uint8_t *out,
                                              ptrdiff_t row_stride);

/**
 * Distance and closest points of two arrays in step: vesica_closest_points_f64 as columns.
 *
 * Kinds, counts and errors as vesica_overlap_many_f64; each column holds as many numbers as the larger count, and any
 * but not all of them may be NULL. An invalid element gets NaN in each, every other one the numbers of
 * vesica_nearest_f64, to the bit, and the call returns VESICA_E_SHAPE. Returns how many overlap (distance 0).
 * Since 0.1.
 */
VESICA_API int64_t vesica_nearest_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *distance, double *ax, double *ay, double *bx, double *by);

/**
 * Distance of outlines of two arrays in step: vesica_closest_points_f64 as columns.
 *
 * Kinds, counts and errors as vesica_overlap_many_f64; each column holds as many numbers as the larger count, and any
 * but not all of them may be NULL. An invalid element gets NaN in each, every other one the numbers of
 * vesica_boundary_distance_f64, to the bit, and the call returns VESICA_E_SHAPE. Returns how many outlines meet
 * (distance 0). Since 0.1.
 */
VESICA_API int64_t vesica_boundary_distance_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *distance, double *ax, double *ay, double *bx, double *by);

/**
 * Penetration depth of two arrays in step: vesica_penetration_f64 as columns.
 *
 * Kinds, counts and errors as vesica_overlap_many_f64; each column holds as many numbers as the larger count, and any
 * but not all of them may be NULL. An invalid element gets NaN in each, every other one the numbers of
 * vesica_depth_f64, to the bit, and the call returns VESICA_E_SHAPE. Returns how many depths are positive. Since 0.1.
 */
VESICA_API int64_t vesica_depth_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *depth, double *x, double *y);

/**
 * Area shared of two arrays in step: out[i] = that of a[i] and b[i].
 *
 * Kinds, counts and errors as vesica_overlap_many_f64. An invalid element gets NaN, every other one the number of
 * vesica_area_f64, to the bit, and the call returns VESICA_E_SHAPE.
 * Returns how many are positive. Since 0.1.
 */
VESICA_API int64_t vesica_area_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *out);

/**
 * Area shared of every a with every b: out[i * row_stride + j] = that of a[i] and b[j]. row_stride counts numbers.
 *
 * Everything else as vesica_area_many_f64 and vesica_overlap_matrix_f64. Since 0.1.
 */
VESICA_API int64_t vesica_area_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *out,
                                              ptrdiff_t row_stride);

/**
 * Intersection over union of two arrays in step: out[i] = that of a[i] and b[i].
 *
 * Kinds, counts and errors as vesica_overlap_many_f64. An invalid element gets NaN, every other one the number of
 * vesica_iou_f64, to the bit, and the call returns VESICA_E_SHAPE. A pair without any area gets NaN, and the call
 * returns VESICA_E_ARGUMENT if nothing is invalid. Returns how many are positive. Since 0.1.
 */
VESICA_API int64_t vesica_iou_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *out);

/**
 * Intersection over union of every a with every b: out[i * row_stride + j] = that of a[i] and b[j]. row_stride counts
 * numbers.
 *
 * Everything else as vesica_iou_many_f64 and vesica_overlap_matrix_f64. Since 0.1.
 */
VESICA_API int64_t vesica_iou_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *out,
                                              ptrdiff_t row_stride);

/* ---- float: shapes as plain structs without padding; their layout is frozen. ---- */

/** A location. */
typedef struct {
    float x, y;
} vesica_point_f32;

/** All points between two end points; the same end point twice is a point. */
typedef struct {
    float x0, y0, x1, y1;
} vesica_segment_f32;

/** A disc: centre and radius, r >= 0. */
typedef struct {
    float cx, cy, r;
} vesica_circle_f32;

/** A box along the coordinate axes, min_x <= max_x and min_y <= max_y. */
typedef struct {
    float min_x, min_y, max_x, max_y;
} vesica_aabb_f32;

/** All C + s u + t perp(u) with |s| <= hx and |t| <= hy; hx, hy >= 0, u != 0. */
typedef struct {
    float cx, cy, ux, uy, hx, hy;
} vesica_rect_f32;

/** All C + s u + t perp(u) with (s/a)^2 + (t/b)^2 <= 1; a, b >= 0, u != 0. */
typedef struct {
    float cx, cy, ux, uy, a, b;
} vesica_ellipse_f32;

/** A distance, and the points of two shapes a and b that are that far apart. */
typedef struct {
    float distance, ax, ay, bx, by;
} vesica_closest_points_f32;

/** Where two outlines meet: `count` places (x[i], y[i]), the rest 0; shared: 1 where they have a stretch in common. */
typedef struct {
    int32_t count, shared;
    float x[8], y[8];
} vesica_crossing_points_f32;

/** How far to move the second of two overlapping shapes: its unit direction, and the distance. */
typedef struct {
    float depth, x, y;
} vesica_penetration_f32;

/* ---- float: functions. Typed pairs return 1 (share a point, touching counts) or 0; errors: VESICA_E_NULL,
        VESICA_E_SHAPE. Cost: a few to 20 ns; on the rare near-ties the filter cannot decide, 0.1 to 3 us. ---- */

/**
 * Is a shape valid, and if not, which rule does it break?
 *
 * kind: VESICA_POINT ... VESICA_ELLIPSE. numbers: the shape's numbers in its order.
 * Returns 0 for a valid shape, else the first rule broken: VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE,
 * VESICA_E_ZERO_AXIS or VESICA_E_INVERTED. Errors: VESICA_E_NULL, VESICA_E_KIND. Cost: a few ns. Since 0.1.
 */
VESICA_API int32_t vesica_check_f32(int32_t kind, const float *numbers);

/**
 * Do two shapes of any kinds share a point? Either order of kinds.
 *
 * numbers_a, numbers_b: each shape's numbers in its order; they may be the same memory.
 * Returns 1 when they share a point (touching counts), 0 when not. Errors: VESICA_E_NULL, VESICA_E_KIND,
 * VESICA_E_SHAPE. Exact for every valid shape. Cost: that of the typed function plus about 2 ns. Since 0.1.
 */
VESICA_API int32_t vesica_overlap_f32(int32_t kind_a, const float *numbers_a,
                                       int32_t kind_b, const float *numbers_b);

/** 1 when the two points are the same. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_point_point_f32(const vesica_point_f32 *a, const vesica_point_f32 *b);
/** 1 when the point lies on the segment, end points included. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_point_segment_f32(const vesica_point_f32 *a, const vesica_segment_f32 *b);
/** 1 when the point lies in the disc or on its rim. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_point_circle_f32(const vesica_point_f32 *a, const vesica_circle_f32 *b);
/** 1 when the point lies in the box or on its outline. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_point_aabb_f32(const vesica_point_f32 *a, const vesica_aabb_f32 *b);
/** 1 when the point lies in the rectangle or on its outline. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_point_rect_f32(const vesica_point_f32 *a, const vesica_rect_f32 *b);
/** 1 when the point lies in the ellipse or on its outline. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_point_ellipse_f32(const vesica_point_f32 *a, const vesica_ellipse_f32 *b);
/** 1 when the segments share a point, end points and collinear overlaps included. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_segment_segment_f32(const vesica_segment_f32 *a, const vesica_segment_f32 *b);
/** 1 when the segment meets the disc; a tangent segment does. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_segment_circle_f32(const vesica_segment_f32 *a, const vesica_circle_f32 *b);
/** 1 when the segment meets the box; one wholly inside does. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_segment_aabb_f32(const vesica_segment_f32 *a, const vesica_aabb_f32 *b);
/** 1 when the segment meets the rectangle; one wholly inside does. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_segment_rect_f32(const vesica_segment_f32 *a, const vesica_rect_f32 *b);
/** 1 when the segment meets the ellipse; a tangent segment does. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_segment_ellipse_f32(const vesica_segment_f32 *a, const vesica_ellipse_f32 *b);
/** 1 when the discs share a point; discs touching from outside do. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_circle_circle_f32(const vesica_circle_f32 *a, const vesica_circle_f32 *b);
/** 1 when the disc and the box share a point. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_circle_aabb_f32(const vesica_circle_f32 *a, const vesica_aabb_f32 *b);
/** 1 when the disc and the rectangle share a point. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_circle_rect_f32(const vesica_circle_f32 *a, const vesica_rect_f32 *b);
/** 1 when the disc and the ellipse share a point. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_circle_ellipse_f32(const vesica_circle_f32 *a, const vesica_ellipse_f32 *b);
/** 1 when the boxes share a point; boxes sharing an edge or a corner do. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_aabb_aabb_f32(const vesica_aabb_f32 *a, const vesica_aabb_f32 *b);
/** 1 when the box and the rectangle share a point. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_aabb_rect_f32(const vesica_aabb_f32 *a, const vesica_rect_f32 *b);
/** 1 when the box and the ellipse share a point. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_aabb_ellipse_f32(const vesica_aabb_f32 *a, const vesica_ellipse_f32 *b);
/** 1 when the rectangles share a point; rectangles sharing an edge or a corner do. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_rect_rect_f32(const vesica_rect_f32 *a, const vesica_rect_f32 *b);
/** 1 when the rectangle and the ellipse share a point; one inside the other does. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_rect_ellipse_f32(const vesica_rect_f32 *a, const vesica_ellipse_f32 *b);
/** 1 when the ellipses share a point; one inside the other does. Returns and errors as all typed pairs. Since 0.1. */
VESICA_API int32_t vesica_overlap_ellipse_ellipse_f32(const vesica_ellipse_f32 *a, const vesica_ellipse_f32 *b);

/**
 * How do two shapes of any kinds relate? One of RCC-8's eight: VESICA_DISJOINT ... VESICA_EQUAL, of a to b.
 *
 * The outline of a shape with area is the curve around it; that of a segment, or of any shape with one size zero, its
 * two end points; a point, or a shape with no size, has none. The inside is the rest. The first that holds:
 * VESICA_EQUAL, the same set of points, whatever kinds and numbers describe it; VESICA_INSIDE, b contains a, and a has
 * no point of b's outline; VESICA_INSIDE_TOUCH, b contains a, and a has points of b's outline; VESICA_CONTAINS and
 * VESICA_CONTAINS_TOUCH, the same with a and b exchanged; VESICA_CROSS, the two insides have a common point;
 * VESICA_TOUCH, the shapes have one; VESICA_DISJOINT. So a segment's end on another's middle is touch, two segments
 * along one line that overlap in part cross, and a point on a rim is inside with touch.
 *
 * numbers_a, numbers_b: each shape's numbers in its order; they may be the same memory. Returns the relation;
 * exchanging the shapes gives the converse, always. Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE. Exact for
 * every valid shape. Cost: up to twice that of vesica_overlap_f32; where shapes touch or are equal, 0.1 to 8 us.
 * Since 0.1.
 */
VESICA_API int32_t vesica_relation_f32(int32_t kind_a, const float *numbers_a,
                                       int32_t kind_b, const float *numbers_b);

/**
 * Does shape a contain all of shape b? Either order of kinds; a shape contains itself, and all it touches from inside.
 *
 * Returns 1 where vesica_relation_f32 is VESICA_CONTAINS, VESICA_CONTAINS_TOUCH or VESICA_EQUAL, else 0. Everything
 * else as there. Since 0.1.
 */
VESICA_API int32_t vesica_contains_f32(int32_t kind_a, const float *numbers_a,
                                       int32_t kind_b, const float *numbers_b);

/**
 * The places where the outlines of two shapes of any kinds meet, touching included. Either order of kinds.
 *
 * The outline of a shape with area is the curve around it; a segment, a point, and a shape without area are their own
 * outlines. How many places there are, up to 8, is exact: where outlines touch, to whatever order, is one. A stretch
 * that straight outlines have in common counts as its two end points and sets out->shared; equal boxes have their
 * corners. Equal curves have no single places: the count is 0 and out->shared 1.
 * Places are in order along a's outline: counter-clockwise about its axis from a box's corner C - hx u - hy perp(u),
 * from an ellipse's end C + a u of its axis (a circle's C + (r, 0)); from a segment's first end.
 * Accuracy: within 16 u of the greatest coordinate and size met, u = 2^-53; for two ellipses where they cross. Two that
 * nearly touch, or touch to order k: within 2^(-90/k) of the lesser one's size, along both outlines; differ by a part
 * e of it all round: within 2^-90 / e.
 * out: untouched on error; may not overlap the numbers. Returns the count. Errors: VESICA_E_NULL, VESICA_E_KIND,
 * VESICA_E_SHAPE, VESICA_E_RANGE (a place is beyond the finite numbers). Cost: 5 to 20 us; disjoint shapes as
 * vesica_overlap_f32. Since 0.1.
 */
VESICA_API int32_t vesica_crossings_f32(int32_t kind_a, const float *numbers_a,
                                        int32_t kind_b, const float *numbers_b, vesica_crossing_points_f32 *out);

/**
 * Distance of two solid shapes of any kinds, in either order, and their closest points. Everything as
 * vesica_nearest_f64, which computes it; each number is then rounded to float once, and a distance above 0 stays above
 * 0. Since 0.1.
 */
VESICA_API int32_t vesica_nearest_f32(int32_t kind_a, const float *numbers_a, int32_t kind_b, const float *numbers_b,
                                      vesica_closest_points_f32 *out);

/**
 * Distance between the outlines of two shapes of any kinds, in either order, and where they come closest. Everything as
 * vesica_boundary_distance_f64, which computes it; each number is then rounded to float once, and a distance above 0
 * stays above 0. Since 0.1.
 */
VESICA_API int32_t vesica_boundary_distance_f32(int32_t kind_a, const float *numbers_a,
                                                int32_t kind_b, const float *numbers_b,
                                                vesica_closest_points_f32 *out);

/**
 * Penetration depth of two shapes of any kinds, in either order. Everything as vesica_depth_f64, which computes it;
 * each number is then rounded to float once, and a depth above 0 stays above 0. Since 0.1.
 */
VESICA_API int32_t vesica_depth_f32(int32_t kind_a, const float *numbers_a, int32_t kind_b, const float *numbers_b,
                                    vesica_penetration_f32 *out);

/**
 * Area of one shape: 4 hx hy u.u of a rectangle, pi a b u.u of an ellipse, 0 of a point or a segment.
 *
 * The double nearest to the true area, rounded to float, so a shape inside another never has the greater one,
 * and equal shapes have the same whatever kinds and numbers describe them. out: untouched on error; may not overlap
 * numbers. Returns 0. Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE (beyond the finite numbers;
 * one too small becomes subnormal or 0). Cost: about 20 ns. Since 0.1.
 */
VESICA_API int32_t vesica_shape_area_f32(int32_t kind, const float *numbers, float *out);

/**
 * Area of the intersection of two shapes of any kinds, in either order.
 *
 * Shapes that are disjoint, that touch (as vesica_relation_f32 says) or of which one has no area share exactly 0; where
 * one contains the other, exactly the vesica_shape_area_f32 of the inner one. Never more than the area of either, and
 * more than 0 wherever insides meet, unless that underflows. Exchanging the shapes changes no bit, nor does scaling
 * both by a power of two, but for its square.
 * Accuracy: within 64 u of the lesser shape's area times the larger of the two aspects (longer size over shorter; for
 * aspects up to 10^4), u = 2^-53, however near the outlines are to touching or coinciding and however different the
 * sizes are; then rounded to float.
 * out: untouched on error; may not overlap the numbers. Returns 0. Errors: VESICA_E_NULL, VESICA_E_KIND,
 * VESICA_E_SHAPE, VESICA_E_RANGE (beyond the finite numbers). Cost: two boxes about 50 ns, an ellipse and a box 150 ns,
 * two ellipses 0.6 us; up to 10 us where outlines nearly touch or coincide, or one shape is far larger. Since 0.1.
 */
VESICA_API int32_t vesica_area_f32(int32_t kind_a, const float *numbers_a,
                                   int32_t kind_b, const float *numbers_b, float *out);

/**
 * Intersection over union (Jaccard index) of two shapes: their vesica_area_f32 over the area of both together.
 *
 * From 0 to 1: exactly 1 for equal shapes, exactly 0 for shapes that share no area. Nothing overflows or underflows on
 * the way, whatever the sizes. Accuracy: that of the area, over the area of the union. Exchanging the shapes, or
 * scaling both by a power of two, changes no bit.
 * out: untouched on error; may not overlap the numbers. Returns 0. Errors: VESICA_E_NULL, VESICA_E_KIND,
 * VESICA_E_SHAPE, VESICA_E_ARGUMENT (neither shape has an area; with one that has, the ratio is 0). Cost: that of
 * vesica_area_f32 and two of vesica_shape_area_f32. Since 0.1.
 */
VESICA_API int32_t vesica_iou_f32(int32_t kind_a, const float *numbers_a,
                                  int32_t kind_b, const float *numbers_b, float *out);

/**
 * Smallest box of representable numbers that contains a shape: each side is the shape's true extreme rounded
 * outward once, so a box that is representable is exact.
 *
 * out: untouched on error; may not overlap numbers. Returns 0. Errors: VESICA_E_NULL, VESICA_E_KIND,
 * VESICA_E_SHAPE, VESICA_E_RANGE (the box would leave the finite range). Cost: up to 80 ns; 1 to 3 us for an
 * ellipse with an oblique axis and representable sides, or with magnitudes beyond 2^+-400. Since 0.1.
 */
VESICA_API int32_t vesica_bounds_f32(int32_t kind, const float *numbers, vesica_aabb_f32 *out);

/**
 * Box with two opposite corners, in any order. Exact. Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE. Since 0.1.
 */
VESICA_API int32_t vesica_aabb_from_corners_f32(float x0, float y0, float x1, float y1,
                                                vesica_aabb_f32 *out);

/**
 * Rectangle from centre, angle and full size: width along the angle, height across it.
 *
 * angle: radians, counter-clockwise from +x where y points up. The axis is (cos, sin), each right to 1 unit in the
 * last place; multiples of a quarter turn given as the nearest number to k pi/2 are axis-parallel only to that
 * rounding. Sizes are exact: where halving one would round (an odd multiple of the smallest subnormal number), the
 * axis is halved in their place.
 * Returns 0. Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE. Cost: about 40 ns. Since 0.1.
 */
VESICA_API int32_t vesica_rect_from_angle_f32(float cx, float cy, float angle, float width, float height,
                                              vesica_rect_f32 *out);

/**
 * Rectangle from its four corners in order round the outline (either turning sense).
 *
 * corners: x0 y0 ... x3 y3. The corners are averaged: a parallelogram or worse becomes a rectangle near it, so
 * the result need not contain corners that were not a rectangle's. The centre is the mean of the corners. The axis is
 * a unit vector along the first edge, from corner 0 to 1, and hx belongs to that edge; opposite edges are averaged,
 * the longer pair gives the direction, and the shorter counts by its part across the longer. Two or four equal
 * corners are legal: a segment, or a point with axis (1, 0).
 * Accuracy: half extents, and the axis times the longer one, are right to 8 units in the last place of the longer,
 * the centre to 1 in its own, both plus 2^-98 times the largest coordinate. The corners of an axis-parallel rectangle
 * give it exactly when its centre and half extents are representable.
 * Returns 0. Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_RANGE (a half extent overflows).
 * Cost: about 110 ns. Since 0.1.
 */
VESICA_API int32_t vesica_rect_from_corners_f32(const float corners[8], vesica_rect_f32 *out);

/**
 * Ellipse from centre, angle (as vesica_rect_from_angle) and half lengths: a along the angle, b across it.
 *
 * Returns 0. Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE. Cost: about 40 ns. Since 0.1.
 */
VESICA_API int32_t vesica_ellipse_from_angle_f32(float cx, float cy, float angle, float a, float b,
                                                 vesica_ellipse_f32 *out);

/**
 * Ellipse from centre, radius vector and ratio: one half axis is the vector (wx, wy), the other is
 * perp(wx, wy) times ratio. Exact: nothing is rounded. A zero vector gives the point (cx, cy).
 *
 * Returns 0. Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE. Since 0.1.
 */
VESICA_API int32_t vesica_ellipse_from_radius_vector_f32(float cx, float cy, float wx, float wy, float ratio,
                                                         vesica_ellipse_f32 *out);

/**
 * Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
 *
 * cxx, cxy, cyy: the covariance matrix, units squared; it must be positive semidefinite, cxy^2 <= cxx cyy, as stored.
 * A singular one, or k = 0, gives a segment or a point. a >= b; the axis is a unit vector with x >= 0, (1, 0) for
 * equal variances without correlation. Half lengths and both components of the axis are each right to
 * 8 units in their own last place, however near to singular or to a circle.
 * Returns 0. Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE (k < 0), VESICA_E_ARGUMENT (not a
 * covariance), VESICA_E_RANGE (a half length overflows). Cost: about 90 ns. Since 0.1.
 */
VESICA_API int32_t vesica_ellipse_from_covariance_f32(float mean_x, float mean_y, float cxx, float cxy, float cyy,
                                                      float k, vesica_ellipse_f32 *out);

/**
 * Ellipse of the points X with (X - C) . M (X - C) <= 1, M symmetric with entries mxx, mxy, myy.
 *
 * M must be positive definite as stored. Lengths, axis and accuracy as vesica_ellipse_from_covariance of the inverse
 * matrix and k = 1. No half length can overflow.
 * Returns 0. Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_ARGUMENT (not positive definite).
 * Cost: about 90 ns. Since 0.1.
 */
VESICA_API int32_t vesica_ellipse_from_matrix_f32(float cx, float cy, float mxx, float mxy, float myy,
                                                  vesica_ellipse_f32 *out);

/**
 * An array of shapes of one kind, however it lies in memory: records, packed or padded, or a column a number.
 *
 * Element i has its number k at field[k] + i * stride bytes, k in the order of the shape. stride is a record's size for
 * records, sizeof(float) for columns, 0 to repeat one shape, negative to run backwards. Fields beyond the kind's are
 * not looked at. Numbers need no alignment. reserved must be 0.
 */
typedef struct {
    int32_t kind;
    int32_t reserved;
    int64_t count;
    ptrdiff_t stride;
    const float *field[6];
} vesica_shapes_f32;

/**
 * Fills *out for `count` records that start at base, each a vesica_<kind>_f32 followed by whatever else the record
 * holds.
 *
 * stride: bytes from one record to the next; base: the first record's shape. Returns 0. Errors: VESICA_E_NULL (base may
 * be NULL where count is 0), VESICA_E_KIND, VESICA_E_ARGUMENT (negative count). Since 0.1.
 */
VESICA_API int32_t vesica_shapes_from_records_f32(int32_t kind, int64_t count, const void *base, ptrdiff_t stride,
                                                  vesica_shapes_f32 *out);

/**
 * Overlap of two arrays in step: out[i] = 1 where a[i] and b[i] share a point, else 0.
 *
 * Kinds in either order. Counts agree, or one of them is 1 and that shape is repeated. out: as many bytes as the larger
 * count (0 when either count is 0); it may not overlap the input. Returns how many are 1.
 * An invalid element gets 0, every valid one its right answer, and the call returns VESICA_E_SHAPE. Before anything is
 * written: VESICA_E_NULL (with nothing to answer, fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts
 * that are negative or do not agree, reserved not 0, count times stride beyond the address space).
 * Answers equal vesica_overlap_f32's, on every instruction set and in every layout. Cost, in cache, columns: about
 * 0.5 to 1 ns a pair with AVX-512; near-ties as scalar calls. Uses at most 256 KiB of stack. Since 0.1.
 */
VESICA_API int64_t vesica_overlap_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, uint8_t *out);

/**
 * Overlap of every a with every b: out[i * row_stride + j] = 1 where a[i] and b[j] share a point, else 0.
 *
 * row_stride: bytes from one row of answers to the next, at least b's count unless a's count is at most 1 (negative:
 * the rows run backwards in memory). Returns how many are 1. Everything else, errors included, as
 * vesica_overlap_many_f32; VESICA_E_ARGUMENT also when rows would overlap or lie beyond the address space. Cost: as one
 * shape against many, however large the arrays are. Since 0.1.
 */
VESICA_API int64_t vesica_overlap_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, uint8_t *out,
                                             ptrdiff_t row_stride);

/**
 * Which of many does one shape overlap? Writes their indices, ascending, to out[0], out[1] ...
 *
 * one: an array of count 1. capacity: room in out, in indices; it may be 0, and out NULL with it. Returns how many
 * there are, also beyond the capacity; where room is left after the last index, the next entry is -1.
 * An invalid element is not selected, the indices of valid ones are written, and the call returns VESICA_E_SHAPE: then
 * -1 or the capacity ends them. Other errors as vesica_overlap_many_f32; VESICA_E_ARGUMENT also when one's count is not
 * 1 or the capacity is negative. Since 0.1.
 */
VESICA_API int64_t vesica_overlap_select_f32(const vesica_shapes_f32 *one, const vesica_shapes_f32 *many, int64_t *out,
                                             int64_t capacity);

/**
 * Greedy non-maximum suppression: in the order of their scores, highest first, each shape is kept unless its
 * vesica_iou_f32 with one kept before is greater than the threshold.
 *
 * shapes: one kind, VESICA_CIRCLE to VESICA_ELLIPSE. scores: one each; equal ones go by index, infinite ones are legal.
 * threshold: 0 to 1, and not itself suppressing: at 1 all are kept. scratch: vesica_nms_scratch bytes or more, of any
 * alignment and content. keep: room for as many indices as there are shapes; the kept ones, in the order of their
 * scores; what follows them is not written. *kept: how many. No output may overlap another or the input.
 * Returns 0. A shape that is invalid, or whose score is NaN, is left out as if it were not there, keep and *kept are
 * written, and the call returns VESICA_E_SHAPE. Before anything is written: VESICA_E_NULL (with no shapes, only shapes
 * and kept are looked at), VESICA_E_KIND (also for points and segments), VESICA_E_ARGUMENT (as vesica_overlap_many_f32
 * of the array; the threshold; too little scratch). Cost: sorting, and an IoU for each pair of a kept shape and one
 * whose bounds meet its own: 10,000 scattered rectangles about 15 ms. Since 0.1.
 */
VESICA_API int32_t vesica_nms_f32(const vesica_shapes_f32 *shapes, const float *scores, float threshold,
                                  void *scratch, int64_t scratch_size, int64_t *keep, int64_t *kept);

/**
 * Relation of two arrays in step: out[i] = the code of vesica_relation_f32 for a[i] and b[i].
 *
 * Returns how many are not VESICA_DISJOINT. Everything else, errors included, as vesica_overlap_many_f32; an invalid
 * element gets 0. Answers equal vesica_relation_f32's. Since 0.1.
 */
VESICA_API int64_t vesica_relation_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, uint8_t *out);

/**
 * Relation of every a to every b: out[i * row_stride + j] = the code for a[i] and b[j].
 *
 * Returns how many are not VESICA_DISJOINT. Everything else as vesica_overlap_matrix_f32. Since 0.1.
 */
VESICA_API int64_t vesica_relation_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, uint8_t *out,
                                              ptrdiff_t row_stride);

/**
 * Containment of two arrays in step: out[i] = 1 where a[i] contains all of b[i], else 0.
 *
 * Returns how many are 1. Everything else, errors included, as vesica_overlap_many_f32. Since 0.1.
 */
VESICA_API int64_t vesica_contains_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, uint8_t *out);

/**
 * Containment of every b in every a: out[i * row_stride + j] = 1 where a[i] contains all of b[j], else 0.
 *
 * Returns how many are 1. Everything else as vesica_overlap_matrix_f32. Since 0.1.
 */
VESICA_API int64_t vesica_contains_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, uint8_t *out,
                                              ptrdiff_t row_stride);

/**
 * Distance and closest points of two arrays in step: vesica_closest_points_f32 as columns.
 *
 * Kinds, counts and errors as vesica_overlap_many_f32; each column holds as many numbers as the larger count, and any
 * but not all of them may be NULL. An invalid element gets NaN in each, every other one the numbers of
 * vesica_nearest_f32, to the bit, and the call returns VESICA_E_SHAPE. Returns how many overlap (distance 0).
 * Since 0.1.
 */
VESICA_API int64_t vesica_nearest_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *distance, float *ax, float *ay, float *bx, float *by);

/**
 * Distance of outlines of two arrays in step: vesica_closest_points_f32 as columns.
 *
 * Kinds, counts and errors as vesica_overlap_many_f32; each column holds as many numbers as the larger count, and any
 * but not all of them may be NULL. An invalid element gets NaN in each, every other one the numbers of
 * vesica_boundary_distance_f32, to the bit, and the call returns VESICA_E_SHAPE. Returns how many outlines meet
 * (distance 0). Since 0.1.
 */
VESICA_API int64_t vesica_boundary_distance_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *distance, float *ax, float *ay, float *bx, float *by);

/**
 * Penetration depth of two arrays in step: vesica_penetration_f32 as columns.
 *
 * Kinds, counts and errors as vesica_overlap_many_f32; each column holds as many numbers as the larger count, and any
 * but not all of them may be NULL. An invalid element gets NaN in each, every other one the numbers of
 * vesica_depth_f32, to the bit, and the call returns VESICA_E_SHAPE. Returns how many depths are positive. Since 0.1.
 */
VESICA_API int64_t vesica_depth_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *depth, float *x, float *y);

/**
 * Area shared of two arrays in step: out[i] = that of a[i] and b[i].
 *
 * Kinds, counts and errors as vesica_overlap_many_f32. An invalid element gets NaN, every other one the number of
 * vesica_area_f32, to the bit, and the call returns VESICA_E_SHAPE.
 * Returns how many are positive. Since 0.1.
 */
VESICA_API int64_t vesica_area_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *out);

/**
 * Area shared of every a with every b: out[i * row_stride + j] = that of a[i] and b[j]. row_stride counts numbers.
 *
 * Everything else as vesica_area_many_f32 and vesica_overlap_matrix_f32. Since 0.1.
 */
VESICA_API int64_t vesica_area_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *out,
                                              ptrdiff_t row_stride);

/**
 * Intersection over union of two arrays in step: out[i] = that of a[i] and b[i].
 *
 * Kinds, counts and errors as vesica_overlap_many_f32. An invalid element gets NaN, every other one the number of
 * vesica_iou_f32, to the bit, and the call returns VESICA_E_SHAPE. A pair without any area gets NaN, and the call
 * returns VESICA_E_ARGUMENT if nothing is invalid. Returns how many are positive. Since 0.1.
 */
VESICA_API int64_t vesica_iou_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *out);

/**
 * Intersection over union of every a with every b: out[i * row_stride + j] = that of a[i] and b[j]. row_stride counts
 * numbers.
 *
 * Everything else as vesica_iou_many_f32 and vesica_overlap_matrix_f32. Since 0.1.
 */
VESICA_API int64_t vesica_iou_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *out,
                                              ptrdiff_t row_stride);

/* ---- Index and join: which of millions of shapes share a point. An index is the caller's memory, flat and without
        pointers: it may be saved, sent, mapped, and read by any number of threads. It holds bounds, not shapes. ---- */

/* What makes a pair of a join. */
#define VESICA_JOIN_OVERLAP 0  /**< a and b share a point, as by vesica_overlap */
#define VESICA_JOIN_BOUNDS 1   /**< their bounds in the indexes do: candidates, a little more than the pairs */
#define VESICA_JOIN_CONTAINS 2 /**< a contains b, as by vesica_contains */
#define VESICA_JOIN_INSIDE 3   /**< b contains a */

#define VESICA_E_INDEX (-10) /**< bytes are no index of this version, or damaged */

/** VESICA_JOIN_OVERLAP. Since 0.1. */
VESICA_API int32_t vesica_join_overlap(void);
/** VESICA_JOIN_BOUNDS. Since 0.1. */
VESICA_API int32_t vesica_join_bounds(void);
/** VESICA_JOIN_CONTAINS. Since 0.1. */
VESICA_API int32_t vesica_join_contains(void);
/** VESICA_JOIN_INSIDE. Since 0.1. */
VESICA_API int32_t vesica_join_inside(void);
/** VESICA_E_INDEX. Since 0.1. */
VESICA_API int32_t vesica_e_index(void);

/**
 * Bytes that suffice for an index of `count` shapes of any kinds: 17 a shape and 64 KiB. About 13 a shape are used:
 * vesica_index_bytes tells. Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1). Since 0.1.
 */
VESICA_API int64_t vesica_index_size(int64_t count);

/**
 * Bytes of scratch that building an index of `count` shapes needs: about 18 a shape, and a constant. Errors as
 * vesica_index_size. Since 0.1.
 */
VESICA_API int64_t vesica_index_scratch(int64_t count);

/** Bytes of scratch that a join needs, whatever the indexes. Since 0.1. */
VESICA_API int64_t vesica_join_scratch(void);

/**
 * Are these bytes an index that queries can read?
 *
 * To be asked once of bytes that come from elsewhere: a file that is short, foreign, damaged, or of a machine of the
 * other byte order. The other functions look at the header alone. size: the bytes there are, at least the index's.
 * Returns 0. Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (index is not aligned to 64), VESICA_E_INDEX. Cost: reads all of
 * it once. Since 0.1.
 */
VESICA_API int32_t vesica_index_check(const void *index, int64_t size);

/** Bytes of a built index: what to save. Errors as vesica_index_check, by its header alone. Since 0.1. */
VESICA_API int64_t vesica_index_bytes(const void *index);

/** Shapes an index was built from, invalid ones included. Errors as vesica_index_bytes. Since 0.1. */
VESICA_API int64_t vesica_index_count(const void *index);

/**
 * Bounds of everything in an index, a little outside of the exact ones; infinite where a shape's overflow. Those of
 * two indexes that do not meet have no pairs. An index without valid shapes has min infinity and max -infinity.
 *
 * Returns 0. Errors as vesica_index_bytes. Since 0.1.
 */
VESICA_API int32_t vesica_index_bounds(const void *index, vesica_aabb_f64 *out);

/**
 * Items in spatial order: arrays laid in that order are joined 1.4 to 1.7 times as fast from then on.
 *
 * out: room for `capacity` items; may be NULL where that is 0. Returns how many items there are: all but the invalid
 * ones. Errors: VESICA_E_ARGUMENT (capacity < 0) and as vesica_index_bytes. Since 0.1.
 */
VESICA_API int64_t vesica_index_order(const void *index, int64_t *out, int64_t capacity);

/**
 * Builds the index of some sets of shapes, laid end to end: shape i of sets[s] is item i plus the counts before.
 *
 * At most 64 sets that are not empty, of any kinds, and 2^31 - 1 items. index: index_size >= vesica_index_size(items)
 * bytes; scratch: scratch_size >= vesica_index_scratch(items) bytes, free again afterwards; both aligned to 64. The
 * index's bytes depend on the shapes alone: not on the processor, their layout or the memory. Shapes that move need a
 * new index: a build costs less than a join.
 * Returns the bytes used. Invalid shapes are left out: the index of the others is complete, and the call returns
 * VESICA_E_SHAPE. Other errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a count, size or alignment); then
 * nothing is written. Cost: 30 to 50 ns a shape. Since 0.1.
 */
VESICA_API int64_t vesica_index_build_f64(const vesica_shapes_f64 *sets, int32_t set_count, void *index,
                                          int64_t index_size, void *scratch, int64_t scratch_size);

/**
 * The same build in five steps, for several threads: steps 0 and 4 by one caller with part 0 of 1, steps 1, 2 and 3 by
 * any number of callers, part = 0 ... parts - 1 of their own choice of parts. Every part of a step must be done before
 * the next step begins; other arguments are the same throughout. Step 4 takes in what fits no cell, and the tree.
 *
 * The bytes are those of vesica_index_build_f64. Returns 0, and at step 4 what vesica_index_build_f64 returns. Errors
 * as there, and VESICA_E_ARGUMENT (step, part or parts; the scratch is not that of step 0). Since 0.1.
 */
VESICA_API int64_t vesica_index_step_f64(int32_t step, int64_t part, int64_t parts, const vesica_shapes_f64 *sets,
                                         int32_t set_count, void *index, int64_t index_size, void *scratch,
                                         int64_t scratch_size);

/**
 * Which items of an index does one shape overlap? In the index's order, which depends on its bytes alone.
 *
 * sets: those the index was built from; NULL with set_count 0 asks for items whose bounds meet the shape's. one: a
 * single shape (count 1). out: room for `capacity` items. state: four numbers, all 0 to begin; where state[0] is -1
 * after a call, that was all, else call again with the same arguments for more. Returns the items written; with
 * capacity 0, when out and state may be NULL, how many there are. Many windows at once are better joined: index them.
 * Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (one is invalid), VESICA_E_ARGUMENT (a count, the
 * sets are not the index's, the state is of no such call). Since 0.1.
 */
VESICA_API int64_t vesica_index_select_f64(const void *index, const vesica_shapes_f64 *sets, int32_t set_count,
                                           const vesica_shapes_f64 *one, int64_t *out, int64_t capacity,
                                           int64_t *state);

/**
 * All pairs of an item of one index and one of another for which a query holds; each pair once.
 *
 * query: VESICA_JOIN_OVERLAP ... VESICA_JOIN_INSIDE. The same index twice (the same pointer): pairs of two different
 * items a < b of one set. sets_a, sets_b: those the indexes were built from; not looked at with VESICA_JOIN_BOUNDS.
 * part of parts: a run of index_a's blocks, about equal work each; the pairs of all parts in order are the pairs of part
 * 0 of 1. Parts may run at the same time, each with a scratch of its own.
 * scratch: vesica_join_scratch() bytes, aligned to 64; need not survive between calls. out_a[i], out_b[i]: a pair; room
 * for `capacity` each. state: four numbers, all 0 to begin a part; where state[0] is -1 after a call, the part is done,
 * else call again with the same arguments for more. A state may be saved or sent.
 * The order of pairs depends on the indexes' bytes and the query alone. Returns the pairs written; with capacity 0,
 * when out_a, out_b and state may be NULL, how many the whole part has.
 * Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_ARGUMENT (query, parts, capacity or a size; sets that
 * are not the index's; a state of no such join). Cost: 10 to 15 ns a shape to find candidates, 15 to 25 ns a candidate
 * to decide. Since 0.1.
 */
VESICA_API int64_t vesica_join_f64(int32_t query, const void *index_a, const vesica_shapes_f64 *sets_a,
                                   int32_t set_count_a, const void *index_b, const vesica_shapes_f64 *sets_b,
                                   int32_t set_count_b, int64_t part, int64_t parts, void *scratch,
                                   int64_t scratch_size, int64_t *out_a, int64_t *out_b, int64_t capacity,
                                   int64_t *state);

/**
 * The items of an index nearest to one shape, nearest first, by the distances of vesica_nearest; equal ones by number.
 *
 * sets: those the index was built from. one: a single shape. k: at most so many; out and distance: room for k each.
 * within: at most so far, INFINITY for any distance: so k = the index's count and a distance gives all within it. What
 * overlaps has distance exactly 0. An item whose distance is beyond the finite numbers is not found.
 * Returns how many were found; with k = 0, when out and distance may be NULL, how many there are within the distance.
 * Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (one is invalid), VESICA_E_ARGUMENT (a count,
 * within is negative or NaN, the sets are not the index's). Since 0.1.
 */
VESICA_API int64_t vesica_index_nearest_f64(const void *index, const vesica_shapes_f64 *sets, int32_t set_count,
                                            const vesica_shapes_f64 *one, int64_t k, double within, int64_t *out,
                                            double *distance);

/**
 * The same for each item of sets_a: row i, out[i * k] ... out[i * k + k - 1], holds the items of index_b nearest to item
 * i, and then -1; distance the distances, and then infinity. k >= 1.
 *
 * part of parts: a run of items about equal in number; only its rows are written. Of one set with itself each item finds
 * itself too, at distance 0: ask for one more.
 * Returns how many were found. Rows of invalid items hold -1, every other one its right answer, and the call returns
 * VESICA_E_SHAPE. Other errors as vesica_index_nearest_f64; then nothing is written. Since 0.1.
 */
VESICA_API int64_t vesica_join_nearest_f64(const vesica_shapes_f64 *sets_a, int32_t set_count_a, const void *index_b,
                                           const vesica_shapes_f64 *sets_b, int32_t set_count_b, int64_t k,
                                           double within, int64_t part, int64_t parts, int64_t *out,
                                           double *distance);

/* ---- float. ---- */

/**
 * Builds the index of some sets of shapes, laid end to end: shape i of sets[s] is item i plus the counts before.
 *
 * At most 64 sets that are not empty, of any kinds, and 2^31 - 1 items. index: index_size >= vesica_index_size(items)
 * bytes; scratch: scratch_size >= vesica_index_scratch(items) bytes, free again afterwards; both aligned to 64. The
 * index's bytes depend on the shapes alone: not on the processor, their layout or the memory. Shapes that move need a
 * new index: a build costs less than a join.
 * Returns the bytes used. Invalid shapes are left out: the index of the others is complete, and the call returns
 * VESICA_E_SHAPE. Other errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a count, size or alignment); then
 * nothing is written. Cost: 30 to 50 ns a shape. Since 0.1.
 */
VESICA_API int64_t vesica_index_build_f32(const vesica_shapes_f32 *sets, int32_t set_count, void *index,
                                          int64_t index_size, void *scratch, int64_t scratch_size);

/**
 * The same build in five steps, for several threads: steps 0 and 4 by one caller with part 0 of 1, steps 1, 2 and 3 by
 * any number of callers, part = 0 ... parts - 1 of their own choice of parts. Every part of a step must be done before
 * the next step begins; other arguments are the same throughout. Step 4 takes in what fits no cell, and the tree.
 *
 * The bytes are those of vesica_index_build_f32. Returns 0, and at step 4 what vesica_index_build_f32 returns. Errors
 * as there, and VESICA_E_ARGUMENT (step, part or parts; the scratch is not that of step 0). Since 0.1.
 */
VESICA_API int64_t vesica_index_step_f32(int32_t step, int64_t part, int64_t parts, const vesica_shapes_f32 *sets,
                                         int32_t set_count, void *index, int64_t index_size, void *scratch,
                                         int64_t scratch_size);

/**
 * Which items of an index does one shape overlap? In the index's order, which depends on its bytes alone.
 *
 * sets: those the index was built from; NULL with set_count 0 asks for items whose bounds meet the shape's. one: a
 * single shape (count 1). out: room for `capacity` items. state: four numbers, all 0 to begin; where state[0] is -1
 * after a call, that was all, else call again with the same arguments for more. Returns the items written; with
 * capacity 0, when out and state may be NULL, how many there are. Many windows at once are better joined: index them.
 * Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (one is invalid), VESICA_E_ARGUMENT (a count, the
 * sets are not the index's, the state is of no such call). Since 0.1.
 */
VESICA_API int64_t vesica_index_select_f32(const void *index, const vesica_shapes_f32 *sets, int32_t set_count,
                                           const vesica_shapes_f32 *one, int64_t *out, int64_t capacity,
                                           int64_t *state);

/**
 * All pairs of an item of one index and one of another for which a query holds; each pair once.
 *
 * query: VESICA_JOIN_OVERLAP ... VESICA_JOIN_INSIDE. The same index twice (the same pointer): pairs of two different
 * items a < b of one set. sets_a, sets_b: those the indexes were built from; not looked at with VESICA_JOIN_BOUNDS.
 * part of parts: a run of index_a's blocks, about equal work each; the pairs of all parts in order are the pairs of part
 * 0 of 1. Parts may run at the same time, each with a scratch of its own.
 * scratch: vesica_join_scratch() bytes, aligned to 64; need not survive between calls. out_a[i], out_b[i]: a pair; room
 * for `capacity` each. state: four numbers, all 0 to begin a part; where state[0] is -1 after a call, the part is done,
 * else call again with the same arguments for more. A state may be saved or sent.
 * The order of pairs depends on the indexes' bytes and the query alone. Returns the pairs written; with capacity 0,
 * when out_a, out_b and state may be NULL, how many the whole part has.
 * Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_ARGUMENT (query, parts, capacity or a size; sets that
 * are not the index's; a state of no such join). Cost: 10 to 15 ns a shape to find candidates, 15 to 25 ns a candidate
 * to decide. Since 0.1.
 */
VESICA_API int64_t vesica_join_f32(int32_t query, const void *index_a, const vesica_shapes_f32 *sets_a,
                                   int32_t set_count_a, const void *index_b, const vesica_shapes_f32 *sets_b,
                                   int32_t set_count_b, int64_t part, int64_t parts, void *scratch,
                                   int64_t scratch_size, int64_t *out_a, int64_t *out_b, int64_t capacity,
                                   int64_t *state);

/**
 * The items of an index nearest to one shape, nearest first, by the distances of vesica_nearest; equal ones by number.
 *
 * sets: those the index was built from. one: a single shape. k: at most so many; out and distance: room for k each.
 * within: at most so far, INFINITY for any distance: so k = the index's count and a distance gives all within it. What
 * overlaps has distance exactly 0. An item whose distance is beyond the finite numbers is not found.
 * Returns how many were found; with k = 0, when out and distance may be NULL, how many there are within the distance.
 * Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (one is invalid), VESICA_E_ARGUMENT (a count,
 * within is negative or NaN, the sets are not the index's). Since 0.1.
 */
VESICA_API int64_t vesica_index_nearest_f32(const void *index, const vesica_shapes_f32 *sets, int32_t set_count,
                                            const vesica_shapes_f32 *one, int64_t k, float within, int64_t *out,
                                            float *distance);

/**
 * The same for each item of sets_a: row i, out[i * k] ... out[i * k + k - 1], holds the items of index_b nearest to item
 * i, and then -1; distance the distances, and then infinity. k >= 1.
 *
 * part of parts: a run of items about equal in number; only its rows are written. Of one set with itself each item finds
 * itself too, at distance 0: ask for one more.
 * Returns how many were found. Rows of invalid items hold -1, every other one its right answer, and the call returns
 * VESICA_E_SHAPE. Other errors as vesica_index_nearest_f32; then nothing is written. Since 0.1.
 */
VESICA_API int64_t vesica_join_nearest_f32(const vesica_shapes_f32 *sets_a, int32_t set_count_a, const void *index_b,
                                           const vesica_shapes_f32 *sets_b, int32_t set_count_b, int64_t k,
                                           float within, int64_t part, int64_t parts, int64_t *out,
                                           float *distance);

#ifdef __cplusplus
}
#endif

/* ---- C11: vesica_overlap(a, b) picks kinds and scalar from the types of two shape pointers. ---- */
#if !defined(__cplusplus) && defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L
#define VESICA_KIND_OF(shape) \
    _Generic(*(shape), \
        vesica_point_f64: VESICA_POINT, vesica_point_f32: VESICA_POINT, \
        vesica_segment_f64: VESICA_SEGMENT, vesica_segment_f32: VESICA_SEGMENT, \
        vesica_circle_f64: VESICA_CIRCLE, vesica_circle_f32: VESICA_CIRCLE, \
        vesica_aabb_f64: VESICA_AABB, vesica_aabb_f32: VESICA_AABB, \
        vesica_rect_f64: VESICA_RECT, vesica_rect_f32: VESICA_RECT, \
        vesica_ellipse_f64: VESICA_ELLIPSE, vesica_ellipse_f32: VESICA_ELLIPSE)
/* Both shapes must have one scalar type: a mixed call selects 0, which is not a function, and does not compile. */
#define vesica_overlap(a, b) \
    _Generic(*VESICA_FIRST_(a), \
        double: _Generic(*VESICA_FIRST_(b), double: vesica_overlap_f64, default: 0), \
        float: _Generic(*VESICA_FIRST_(b), float: vesica_overlap_f32, default: 0))( \
        VESICA_KIND_OF(a), VESICA_FIRST_(a), VESICA_KIND_OF(b), VESICA_FIRST_(b))
#define VESICA_FIRST_(shape) \
    _Generic(*(shape), \
        vesica_point_f64: (const double *)(const void *)(shape), vesica_point_f32: (const float *)(const void *)(shape), \
        vesica_segment_f64: (const double *)(const void *)(shape), vesica_segment_f32: (const float *)(const void *)(shape), \
        vesica_circle_f64: (const double *)(const void *)(shape), vesica_circle_f32: (const float *)(const void *)(shape), \
        vesica_aabb_f64: (const double *)(const void *)(shape), vesica_aabb_f32: (const float *)(const void *)(shape), \
        vesica_rect_f64: (const double *)(const void *)(shape), vesica_rect_f32: (const float *)(const void *)(shape), \
        vesica_ellipse_f64: (const double *)(const void *)(shape), vesica_ellipse_f32: (const float *)(const void *)(shape))
#endif

#endif /* VESICA_H */
