/*
 * Vesica: how the parts of two shapes meet. Nine-intersection matrices, and shared regions as vertices.
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

#define VESICA_DE9IM_SIZE 10   /**< characters of a nine-intersection matrix with its final NUL */
#define VESICA_MOST_VERTICES 8 /**< vertices of a shared region, at most */

/* ---- Topology, double ----
 * Since: 0.1.
 */

/**
 * The nine-intersection matrix of two shapes (DE-9IM), as geographic systems have it.
 *
 * Every shape has an inside, an outline and an outside. The nine characters say of a's inside with b's inside, outline
 * and outside, then of a's outline with those three, then of a's outside, what they share: F for nothing, else the
 * dimension: 0 for single points, 1 for lines, 2 for an area. The outline of a segment is its two end points; a point
 * has none; that of a shape with area is the curve around it. A segment without length is a point; a shape with one
 * size 0 is a segment, with both a point. So a box that shares a side with another gives "FF2F11212". Exchanging the
 * shapes exchanges rows and columns.
 * Requires: matrix with room for VESICA_DE9IM_SIZE characters.
 * Returns: 0, and nine characters and a final NUL in matrix.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
 * Accuracy: exact.
 * Cost: that of vesica_relation_f64; 0.1 to 1 us more for a segment, 2 us for rectangles whose sides are parallel.
 */
VESICA_API int32_t vesica_de9im_f64(int32_t kind_a, const double *numbers_a, int32_t kind_b, const double *numbers_b,
                                    char *matrix);

/**
 * Does a nine-intersection matrix fit a pattern, such as "T*F**F***" for "a is within b"?
 *
 * Each character of the pattern is one of F, 0, 1 and 2, which is meant literally; T, any of 0, 1 and 2; and *, which
 * fits all.
 * Requires: matrix and pattern, nine such characters and a final NUL each; no T or * in the matrix.
 * Returns: 1 if it fits, 0 if not.
 * Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (another length or another character).
 * Accuracy: exact.
 */
VESICA_API int32_t vesica_de9im_match(const char *matrix, const char *pattern);

/**
 * The region that two shapes share, as its vertices: of two with straight outlines, or of a segment and any shape.
 *
 * The kinds are points, segments, boxes and rectangles; a point or a segment may also go with a circle or an ellipse.
 * The region is convex. Its vertices x0 y0 x1 y1 ... come counter-clockwise where y points up, from the one that is
 * lowest, of two equally low ones the left one, as their numbers have it. One vertex is a point, two are a segment's
 * ends. Of the same two shapes in either order they are the same numbers, and the same bits: a zero is +0.
 * Vertices that are not used become 0.
 * Returns: the number of vertices, 1 to 8, or 0 where vesica_overlap_f64 says that nothing is shared.
 * Errors: VESICA_E_NULL, VESICA_E_KIND (also for two kinds that are not as above), VESICA_E_SHAPE, VESICA_E_RANGE (a
 * vertex, or the length of a side that makes one, exceeds the finite numbers).
 * Accuracy: the number of vertices is exact: a true vertex each, before they are rounded. A shape's own corner has the
 * numbers that are stored, of a rectangle those of vesica_corners_of_shapes_f64. Others are right to 4 u times the
 * largest coordinate or size of either shape.
 * Cost: that of vesica_overlap_f64 for disjoint shapes; 0.2 to 1 us with a segment, 2 to 6 us for areas; at worst
 * 300 us, where exponents are wildly unlike.
 */
VESICA_API int32_t vesica_intersection_f64(int32_t kind_a, const double *numbers_a, int32_t kind_b,
                                           const double *numbers_b, double vertices[16]);

/* ---- The same functions with float in place of double ---- */

/** As vesica_de9im_f64. */
VESICA_API int32_t vesica_de9im_f32(int32_t kind_a, const float *numbers_a, int32_t kind_b, const float *numbers_b,
                                    char *matrix);
/** As vesica_intersection_f64, rounded to float. */
VESICA_API int32_t vesica_intersection_f32(int32_t kind_a, const float *numbers_a, int32_t kind_b,
                                           const float *numbers_b, float vertices[16]);

#ifdef __cplusplus
}
#endif

#endif /* VESICA_TOPOLOGY_H */
