/*
 * Vesica: how the parts of two shapes meet. Nine-intersection matrices, and the vertices of shared regions.
 *
 * SPDX-License-Identifier: Apache-2.0
 *
 * vesica.h includes this header, and both belong to one library. The rules of vesica.h hold. Comments have the same
 * parts: Requires, Returns, Errors, Accuracy, Cost, Since.
 */
#ifndef VESICA_TOPOLOGY_H
#define VESICA_TOPOLOGY_H

#include "vesica.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Constants ---- */

#define VESICA_DE9IM_SIZE 10 /**< characters of a nine-intersection matrix with its final NUL */

/* ---- Topology, double ----
 * Since: 0.1.
 */

/**
 * The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
 *
 * Every shape has an inside, an outline and an outside. The first three characters say what a's inside shares with b's
 * inside, outline and outside; the next three say it of a's outline, the last three of a's outside. F means nothing, 0
 * single points, 1 lines, 2 an area. The outline of a shape with area is the curve around it, a segment's its two
 * end points; a point has none. A segment without length is a point; a shape with one size 0 is a segment, with both 0
 * a point; a capsule or rounded rectangle without a radius is its core. Two boxes side by side that share a side give
 * "FF2F11212". Exchanging the shapes exchanges rows and columns. Polygons and polylines have insides and outlines as
 * vesica_relation_f64 says.
 * Requires: matrix with room for VESICA_DE9IM_SIZE characters; simple polygons. Others get a matrix without a meaning.
 * Returns: 0, and nine characters and a final NUL in matrix.
 * Errors: VESICA_E_NULL, VESICA_E_KIND (also for kinds that vesica_relation_f64 does not take together),
 * VESICA_E_SHAPE.
 * Accuracy: exact.
 * Cost: as vesica_relation_f64; more for a segment, for shapes whose sides are parallel, and for equal radii.
 */
VESICA_API int32_t vesica_de9im_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b, char *matrix);

/**
 * Does a nine-intersection matrix match a pattern, such as "T*F**F***" for "a is within b"?
 *
 * In a pattern F, 0, 1 and 2 match themselves, T matches 0, 1 and 2, and * matches all four.
 * Requires: matrix and pattern, nine such characters and a final NUL each; no T or * in the matrix.
 * Returns: 1 if it matches, 0 if not.
 * Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (another length or another character).
 * Accuracy: exact.
 */
VESICA_API int32_t vesica_de9im_match(const char *matrix, const char *pattern);

/**
 * The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
 *
 * The kinds are points, segments, boxes and rectangles. A point or a segment may also meet a circle, an ellipse, a
 * capsule or a rounded rectangle, and a polygon that is convex a box, a rectangle or another one. A polygon on one line
 * is a segment.
 * The region is convex. Its vertices x0 y0 x1 y1 ... come counter-clockwise if y points up. The first is the one with
 * the least y, of equal ones that with the least x, by the numbers written. One vertex is a point, two are the ends of
 * a segment. A vertex in the middle of a straight side is none. Exchanging the shapes changes no bit; a zero is +0.
 *
 * A segment and a polygon of any rings, or a polyline, may share several pieces. Then two vertices are written for each
 * piece, where it begins and where it ends, in order along the segment; of a single point, twice the same. A point has
 * one vertex.
 * Requires: capacity, how many vertices out has room for. It may be 0, and out then NULL.
 * Returns: how many vertices there are, even if that exceeds the capacity, and 0 if the shapes share nothing: at most
 * 8, of two polygons as many as both have, of a segment and a path twice its vertices and two more. The first
 * `capacity` are written.
 * Errors: VESICA_E_NULL, VESICA_E_KIND (also for other pairs of kinds than these), VESICA_E_ARGUMENT (a negative
 * capacity), VESICA_E_SHAPE, VESICA_E_NOT_CONVEX (a polygon, unless the other shape is a point or a segment),
 * VESICA_E_RANGE (a vertex, or the length of a side that makes one, overflows).
 * Accuracy: the number of vertices is exact: it is the true region's. A corner of a shape that lies in the other
 * keeps the stored numbers, or the numbers of vesica_corners_of_shapes_f64 for a rectangle. Others are right to 4 u
 * times the largest coordinate or size of either shape.
 * Cost: as vesica_overlap_f64 for disjoint shapes, else about as vesica_crossings_f64. For two polygons it grows with
 * the product of their numbers of vertices, for a segment and a path with the number of vertices.
 */
VESICA_API int64_t vesica_intersection_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b,
                                           vesica_point_f64 *out, int64_t capacity);

/* ---- The same functions with float in place of double ---- */

/** As vesica_de9im_f64. */
VESICA_API int32_t vesica_de9im_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b, char *matrix);
/** As vesica_intersection_f64, rounded to float. */
VESICA_API int64_t vesica_intersection_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b,
                                           vesica_point_f32 *out, int64_t capacity);

#ifdef __cplusplus
}
#endif

#endif /* VESICA_TOPOLOGY_H */
