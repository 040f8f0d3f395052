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
 *    rounding mode of the caller's that is to-nearest. The exact stage uses at most 128 KiB of stack.
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
 * Name of the instruction set that batches run on: "sse2", "avx2", "avx512", "neon" or "portable", the best this processor
 * has. VESICA_ISA in the environment, read once when the library is loaded, forces one; a name that is unknown or of a
 * set the processor lacks is ignored. Answers never depend on it. Static storage. Since 0.1.
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
 * records, sizeof(double) for columns, 0 to repeat one shape, negative to run backwards. Fields beyond the kind's are not
 * looked at. Numbers need no alignment. reserved must be 0.
 */
typedef struct {
    int32_t kind;
    int32_t reserved;
    int64_t count;
    ptrdiff_t stride;
    const double *field[6];
} vesica_shapes_f64;

/**
 * Fills *out for `count` records that start at base, each a vesica_<kind>_f64 followed by whatever else the record holds.
 *
 * stride: bytes from one record to the next; base: the first record's shape. Returns 0. Errors: VESICA_E_NULL (base may be
 * NULL where count is 0), VESICA_E_KIND, VESICA_E_ARGUMENT (negative count). Since 0.1.
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
 * row_stride: bytes from one row of answers to the next, at least b's count unless a's count is at most 1 (negative: the
 * rows run backwards in memory). Returns how many are 1. Everything else, errors included, as vesica_overlap_many_f64;
 * VESICA_E_ARGUMENT also when rows would overlap or lie beyond the address space. Cost: as one shape against many,
 * however large the arrays are. Since 0.1.
 */
VESICA_API int64_t vesica_overlap_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, uint8_t *out,
                                             ptrdiff_t row_stride);

/**
 * Which of many does one shape overlap? Writes their indices, ascending, to out[0], out[1] ...
 *
 * one: an array of count 1. capacity: room in out, in indices; it may be 0, and out NULL with it. Returns how many there
 * are, also beyond the capacity; where room is left after the last index, the next entry is -1.
 * An invalid element is not selected, the indices of valid ones are written, and the call returns VESICA_E_SHAPE: then
 * -1 or the capacity ends them. Other errors as vesica_overlap_many_f64; VESICA_E_ARGUMENT also when one's count is not 1
 * or the capacity is negative. Since 0.1.
 */
VESICA_API int64_t vesica_overlap_select_f64(const vesica_shapes_f64 *one, const vesica_shapes_f64 *many, int64_t *out,
                                             int64_t capacity);

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
 * records, sizeof(float) for columns, 0 to repeat one shape, negative to run backwards. Fields beyond the kind's are not
 * looked at. Numbers need no alignment. reserved must be 0.
 */
typedef struct {
    int32_t kind;
    int32_t reserved;
    int64_t count;
    ptrdiff_t stride;
    const float *field[6];
} vesica_shapes_f32;

/**
 * Fills *out for `count` records that start at base, each a vesica_<kind>_f32 followed by whatever else the record holds.
 *
 * stride: bytes from one record to the next; base: the first record's shape. Returns 0. Errors: VESICA_E_NULL (base may be
 * NULL where count is 0), VESICA_E_KIND, VESICA_E_ARGUMENT (negative count). Since 0.1.
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
 * row_stride: bytes from one row of answers to the next, at least b's count unless a's count is at most 1 (negative: the
 * rows run backwards in memory). Returns how many are 1. Everything else, errors included, as vesica_overlap_many_f32;
 * VESICA_E_ARGUMENT also when rows would overlap or lie beyond the address space. Cost: as one shape against many,
 * however large the arrays are. Since 0.1.
 */
VESICA_API int64_t vesica_overlap_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, uint8_t *out,
                                             ptrdiff_t row_stride);

/**
 * Which of many does one shape overlap? Writes their indices, ascending, to out[0], out[1] ...
 *
 * one: an array of count 1. capacity: room in out, in indices; it may be 0, and out NULL with it. Returns how many there
 * are, also beyond the capacity; where room is left after the last index, the next entry is -1.
 * An invalid element is not selected, the indices of valid ones are written, and the call returns VESICA_E_SHAPE: then
 * -1 or the capacity ends them. Other errors as vesica_overlap_many_f32; VESICA_E_ARGUMENT also when one's count is not 1
 * or the capacity is negative. Since 0.1.
 */
VESICA_API int64_t vesica_overlap_select_f32(const vesica_shapes_f32 *one, const vesica_shapes_f32 *many, int64_t *out,
                                             int64_t capacity);

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
