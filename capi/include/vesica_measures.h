/*
 * Vesica: more measures of two shapes. Ratios of shared area, and suppression by them; signed distances, tests whether
 * shapes are within a distance, matrices of distances; shares of the cells of a grid.
 *
 * SPDX-License-Identifier: Apache-2.0
 *
 * vesica.h includes this header, and both belong to one library. The rules of vesica.h hold. Comments have the same
 * parts: Requires, Returns, Errors, Accuracy, Cost, Since.
 */
#ifndef VESICA_MEASURES_H
#define VESICA_MEASURES_H

#include "vesica.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Constants ---- */

/* Measures to compare a shared area with. The hull of two shapes is the smallest box along the axes about both. */
#define VESICA_RATIO_OVER_UNION 0   /**< shared area / area of the union of a and b (IoU) */
#define VESICA_RATIO_OVER_FIRST 1   /**< shared area / area of a (IoF) */
#define VESICA_RATIO_OVER_SECOND 2  /**< shared area / area of b (IoA) */
#define VESICA_RATIO_OVER_SMALLER 3 /**< shared area / the smaller of the areas (IoS) */
#define VESICA_RATIO_GENERALIZED 4  /**< IoU - (area of the hull that neither covers / area of the hull) (GIoU) */
#define VESICA_RATIO_DISTANCE 5     /**< IoU - (distance of the centres / diagonal of the hull)^2 (DIoU) */
#define VESICA_RATIO_COMPLETE 6     /**< DIoU - v^2 / (1 - IoU + v), v = (difference of angles / 90 degrees)^2 (CIoU) */

/* Are two shapes within a distance of each other? */
#define VESICA_WITHIN_NO 0     /**< they are farther apart */
#define VESICA_WITHIN_YES 1    /**< they are at most that far apart */
#define VESICA_WITHIN_NEARLY 2 /**< only with ellipses: the distance is too close to the one asked for to decide */

/* How soft suppression lowers the score of a shape that has ratio r with a kept one. */
#define VESICA_DECAY_LINEAR 0   /**< score * (1 - r) if r exceeds the parameter, a threshold from 0 to 1 */
#define VESICA_DECAY_GAUSSIAN 1 /**< score * exp(-r^2 / parameter) if r > 0; parameter from 2^-100, finite */

/* ---- Ratios of shared area, double ----
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.
 * Since: 0.1.
 */

/**
 * A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
 *
 * The first four ratios are from 0 to 1. Shared area over one shape's is 0 if no area is shared, and 1 if the other
 * shape contains it. The last three are at most the IoU, and at least -1 (CIoU: -2). The angle of a shape in CIoU is
 * the vector's (half length across its axis, half length along it); v is 0 if a shape has no size. Exchanging the
 * shapes exchanges OVER_FIRST and OVER_SECOND, and changes no bit of the others. The centre, the width and the height
 * of a polygon are those of its box.
 * Requires: ratio, one of VESICA_RATIO_OVER_UNION to VESICA_RATIO_COMPLETE.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (ratio is no such constant; the area to
 * divide by is 0; or, for GIoU, DIoU and CIoU, neither shape has an area).
 * Accuracy: computed from the result of vesica_area_f64 or vesica_iou_f64 with at most 8 u of further error, for half
 * lengths from 2^-200 to 2^200.
 * Cost: up to four times vesica_area_f64 or vesica_iou_f64 for boxes; little more than these for ellipses.
 */
VESICA_API int32_t vesica_ratio_f64(int32_t ratio, int32_t kind_a, const void *a, int32_t kind_b, const void *b,
                                    double *out);

/**
 * A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f64.
 *
 * Arrays and errors are those of vesica_iou_many_f64. If a pair has no ratio because an area is 0, out[i] is NaN, and
 * the call returns VESICA_E_ARGUMENT unless a shape is invalid.
 * Returns: how many are > 0.
 * Accuracy: every result has the same bits as vesica_ratio_f64, on every instruction set and in every layout.
 */
VESICA_API int64_t vesica_ratio_many_f64(int32_t ratio, const vesica_shapes_f64 *a, const vesica_shapes_f64 *b,
                                         double *out);

/**
 * A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f64.
 *
 * Arrays, row_stride and errors are those of vesica_iou_matrix_f64. If a pair has no ratio because an area is 0, it
 * gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
 * Returns: how many are > 0.
 * Accuracy: every result has the same bits as vesica_ratio_f64, on every instruction set and in every layout.
 */
VESICA_API int64_t vesica_ratio_matrix_f64(int32_t ratio, const vesica_shapes_f64 *a, const vesica_shapes_f64 *b,
                                           double *out, ptrdiff_t row_stride);

/* ---- Every a with every b, double: distances and depths alone, without their points or directions ----
 * Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f64.
 * Errors: as vesica_iou_matrix_f64.
 * Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every layout.
 * Since: 0.1.
 */

/**
 * How far apart are a[i] and b[j]? The elements of out are distances of vesica_nearest_f64.
 * Returns: how many pairs overlap (distance 0).
 */
VESICA_API int64_t vesica_nearest_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *out,
                                             ptrdiff_t row_stride);

/**
 * How far apart are the outlines of a[i] and b[j]? The elements of out are distances of vesica_boundary_distance_f64.
 * Returns: how many pairs of outlines meet (distance 0).
 */
VESICA_API int64_t vesica_boundary_distance_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b,
                                                       double *out, ptrdiff_t row_stride);

/**
 * How deep do a[i] and b[j] overlap? The elements of out are depths of vesica_depth_f64.
 * Returns: how many depths are > 0.
 */
VESICA_API int64_t vesica_depth_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *out,
                                           ptrdiff_t row_stride);

/* ---- Signed distance, double ----
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
 * Accuracy: the same bits as vesica_nearest_f64 or, negated, vesica_depth_f64. The sign is exact.
 * Since: 0.1.
 */

/**
 * Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
 *
 * It is the distance of vesica_nearest_f64 if they are disjoint, else minus the depth of vesica_depth_f64: 0 if they
 * only touch. Exchanging the shapes changes no bit.
 * Polygons that overlap the other shape must be convex, else the error is VESICA_E_NOT_CONVEX.
 * Returns: 0.
 * Cost: as vesica_nearest_f64 or vesica_depth_f64.
 */
VESICA_API int32_t vesica_signed_distance_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b,
                                              double *out);

/**
 * Signed distances of a[i] and b[i]. Arrays and errors are those of vesica_iou_many_f64.
 * Returns: how many pairs overlap (signed distance <= 0).
 */
VESICA_API int64_t vesica_signed_distance_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double *out);

/**
 * Signed distances of a[i] and b[j]. Arrays, row_stride and errors are those of vesica_iou_matrix_f64.
 * Returns: how many pairs overlap (signed distance <= 0).
 */
VESICA_API int64_t vesica_signed_distance_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b,
                                                     double *out, ptrdiff_t row_stride);

/* ---- Within a distance, double ----
 * Requires: distance, any number. With infinity the answer is yes for any two valid shapes, with -infinity no.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is NaN), VESICA_E_SHAPE.
 * Accuracy: yes and no are always right. Only an ellipse without a half length of 0 may get another answer,
 * VESICA_WITHIN_NEARLY. With distance > 0: if the other shape is such an ellipse too, and the distance of
 * vesica_nearest_f64 differs from the one asked for by at most 5 u scale + 2^-1074. With distance < 0: if the other
 * shape is neither a point nor a circle, and the depth differs from -distance by at most 10 u (scale + |distance|) +
 * 2^-1073, and by the shorter size of each shape whose aspect ratio exceeds 1e6.
 * Since: 0.1.
 */

/**
 * Are two shapes at most `distance` apart? A distance of exactly that counts, as touching does.
 *
 * With distance 0 the answer is as of vesica_overlap_f64, exact for all kinds. With distance < 0 the question is
 * whether they overlap at least -distance deep, as defined for vesica_depth_f64. So a tolerance of either sign is one
 * call. With ellipses, test for > 0 to miss no pair, and for VESICA_WITHIN_YES to accept only what is certain.
 * Exchanging the shapes changes nothing.
 * A polygon or a polyline is within a distance >= 0 if one of its edges is, as a segment, or if the shapes overlap. It
 * is nearly so if no edge is, but one is nearly. For a distance < 0 polygons that overlap the other shape must be
 * convex, else the error is VESICA_E_NOT_CONVEX. Their depth is compared as vesica_depth_f64 rounds it.
 * Returns: VESICA_WITHIN_NO, VESICA_WITHIN_YES or VESICA_WITHIN_NEARLY.
 * Cost: one to six times vesica_overlap_f64; as vesica_nearest_f64 or vesica_depth_f64 for ellipses.
 */
VESICA_API int32_t vesica_within_f64(int32_t kind_a, const void *a, int32_t kind_b, const void *b, double distance);

/**
 * Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f64.
 *
 * Arrays and errors are those of vesica_overlap_many_f64.
 * Returns: how many answers are > 0.
 */
VESICA_API int64_t vesica_within_many_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double distance,
                                          uint8_t *out);

/**
 * Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of vesica_within_f64.
 *
 * Arrays, row_stride and errors are those of vesica_overlap_matrix_f64.
 * Returns: how many answers are > 0.
 */
VESICA_API int64_t vesica_within_matrix_f64(const vesica_shapes_f64 *a, const vesica_shapes_f64 *b, double distance,
                                            uint8_t *out, ptrdiff_t row_stride);

/* ---- Choices among many shapes, double ----
 * Since: 0.1.
 */

/**
 * Greedy non-maximum suppression as vesica_nms_f64, by any ratio, each label on its own.
 *
 * Takes shapes in the order of their scores, highest first. Keeps each one whose ratio with every shape kept before, of
 * the same label, is at most the threshold. Shapes whose score is below least_score are left out.
 * Requires: shapes, scores, threshold and scratch as vesica_nms_f64; labels, one for each shape, or NULL if all are the
 * same; ratio, any but VESICA_RATIO_OVER_FIRST and _OVER_SECOND; least_score, which may be -infinity; most, the largest
 * number to keep; keep, with room for that number or for all shapes, whichever is less.
 * Returns: 0, and keep and *kept as vesica_nms_f64.
 * Errors: as vesica_nms_f64; VESICA_E_ARGUMENT also for ratio, a least_score that is NaN, and a negative most.
 * Accuracy: the ratio that is compared is as of vesica_ratio_f64; in float, the ratio rounded to float.
 * Cost: as vesica_nms_f64; ratios other than IoU take longer for each comparison.
 */
VESICA_API int32_t vesica_suppress_f64(const vesica_shapes_f64 *shapes, const double *scores, const int32_t *labels,
                                       int32_t ratio, double threshold, double least_score, int64_t most,
                                       void *scratch, int64_t scratch_size, int64_t *keep, int64_t *kept);

/**
 * How many bytes of scratch does soft suppression of `count` shapes need?
 * Returns: 72 bytes a shape.
 * Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).
 */
VESICA_API int64_t vesica_suppress_soft_scratch(int64_t count);

/**
 * Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
 *
 * Repeats these steps: take the shape with the highest score, of equal ones the first; keep it; lower the score of each
 * shape not yet kept, of the same label, by `decay` of their ratio. Ends when `most` are kept or every score left is
 * below least_score. So a shape whose own score is below least_score, such as -infinity, is never kept. keep[k] is the
 * shape kept in step k, and decayed[k] the score that it had then.
 * Requires: shapes, scores and labels as vesica_suppress_f64; ratio, any but VESICA_RATIO_OVER_FIRST and _OVER_SECOND;
 * decay, VESICA_DECAY_LINEAR or _GAUSSIAN, with its parameter; least_score >= 0; scratch of at least
 * vesica_suppress_soft_scratch(count) bytes, aligned to 8; keep and decayed with room for `most` numbers or for
 * all shapes, whichever is less.
 * Returns: 0, with *kept set to how many are kept.
 * Errors: as vesica_suppress_f64. VESICA_E_SHAPE: an invalid shape, or one whose score is NaN, is left out, and the
 * result of the others is written.
 * Accuracy: in every step a score is multiplied once, in double, by 1 - r, rounded once, or by the exponential, right
 * to 1 unit in the last place; times 0 an infinite score is 0. So the same shapes are kept, with the same bits, on
 * every machine. The float function computes in double and rounds only the final scores.
 * Cost: for each kept shape, as vesica_ratio_matrix_f64 with the shapes of its label that are left.
 */
VESICA_API int32_t vesica_suppress_soft_f64(const vesica_shapes_f64 *shapes, const double *scores,
                                            const int32_t *labels, int32_t ratio, int32_t decay, double parameter,
                                            double least_score, int64_t most, void *scratch, int64_t scratch_size,
                                            int64_t *keep, double *decayed, int64_t *kept);

/* ---- Cells of a grid, double ----
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT, VESICA_E_RANGE.
 * Since: 0.1.
 */

/**
 * A grid of cells, such as the pixels of a picture.
 *
 * Cell (i, j) of column i and row j is the box from (x + i dx, y + j dy) to (x + (i + 1) dx, y + (j + 1) dy).
 */
typedef struct {
    double x, y, dx, dy;
    int64_t columns, rows;
} vesica_grid_f64;

/**
 * The share of each cell that a shape covers: out[j * row_stride + i] is area covered / area of cell (i, j).
 *
 * Shares are from 0 to 1. Points, segments and polylines cover nothing. A ring is the difference of two discs' shares.
 * Requires: grid with dx > 0 and dy > 0; out, room for the rows, row_stride elements apart, at least `columns`.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (the grid, or rows that overlap),
 * VESICA_E_RANGE (a part of the shape is more than 2^44 cells from the corner of the grid). Nothing is written.
 * Accuracy: cells inside have 1 and cells outside 0, exactly, unless the outline is within 4 u times the largest
 * coordinate of the shape and of the grid's corner. Other shares are right to 16 u, and what such a displacement of the
 * outline adds.
 * Polygons must be simple, and the error is for each edge in the cell.
 * Cost: a small multiple of writing the cells, and about that of an overlap for each cell on the outline.
 */
VESICA_API int32_t vesica_coverage_f64(int32_t kind, const void *shape, const vesica_grid_f64 *grid, double *out,
                                       ptrdiff_t row_stride);

/**
 * The cells of which a shape covers more than nothing, and their shares, as vesica_coverage_f64 has them.
 *
 * cells[k] is the number of a cell, j * columns + i. Each cell is named once, in no particular order.
 * Requires: grid as vesica_coverage_f64; cells and shares, room for `capacity` each.
 * Returns: the number of such cells. If it exceeds capacity, only the first `capacity` are written.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (the grid, or capacity < 0), VESICA_E_RANGE.
 * Accuracy: as vesica_coverage_f64.
 * Cost: as vesica_coverage_f64.
 */
VESICA_API int64_t vesica_coverage_cells_f64(int32_t kind, const void *shape, const vesica_grid_f64 *grid,
                                             int64_t *cells, double *shares, int64_t capacity);

/* ---- The same functions with float in place of double ---- */

/** As vesica_ratio_f64, rounded to float. */
VESICA_API int32_t vesica_ratio_f32(int32_t ratio, int32_t kind_a, const void *a, int32_t kind_b, const void *b,
                                    float *out);
/** As vesica_ratio_many_f64, rounded to float. */
VESICA_API int64_t vesica_ratio_many_f32(int32_t ratio, const vesica_shapes_f32 *a, const vesica_shapes_f32 *b,
                                         float *out);
/** As vesica_ratio_matrix_f64, rounded to float. */
VESICA_API int64_t vesica_ratio_matrix_f32(int32_t ratio, const vesica_shapes_f32 *a, const vesica_shapes_f32 *b,
                                           float *out, ptrdiff_t row_stride);
/** As vesica_nearest_matrix_f64, rounded to float. */
VESICA_API int64_t vesica_nearest_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *out,
                                             ptrdiff_t row_stride);
/** As vesica_boundary_distance_matrix_f64, rounded to float. */
VESICA_API int64_t vesica_boundary_distance_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b,
                                                       float *out, ptrdiff_t row_stride);
/** As vesica_depth_matrix_f64, rounded to float. */
VESICA_API int64_t vesica_depth_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *out,
                                           ptrdiff_t row_stride);
/** As vesica_suppress_f64. */
VESICA_API int32_t vesica_suppress_f32(const vesica_shapes_f32 *shapes, const float *scores, const int32_t *labels,
                                       int32_t ratio, float threshold, float least_score, int64_t most,
                                       void *scratch, int64_t scratch_size, int64_t *keep, int64_t *kept);
/** As vesica_signed_distance_f64, rounded to float. */
VESICA_API int32_t vesica_signed_distance_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b, float *out);
/** As vesica_signed_distance_many_f64, rounded to float. */
VESICA_API int64_t vesica_signed_distance_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *out);
/** As vesica_signed_distance_matrix_f64, rounded to float. */
VESICA_API int64_t vesica_signed_distance_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float *out,
                                                     ptrdiff_t row_stride);
/** As vesica_within_f64. */
VESICA_API int32_t vesica_within_f32(int32_t kind_a, const void *a, int32_t kind_b, const void *b, float distance);
/** As vesica_within_many_f64. */
VESICA_API int64_t vesica_within_many_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float distance,
                                          uint8_t *out);
/** As vesica_within_matrix_f64. */
VESICA_API int64_t vesica_within_matrix_f32(const vesica_shapes_f32 *a, const vesica_shapes_f32 *b, float distance,
                                            uint8_t *out, ptrdiff_t row_stride);
/** As vesica_suppress_soft_f64. */
VESICA_API int32_t vesica_suppress_soft_f32(const vesica_shapes_f32 *shapes, const float *scores, const int32_t *labels,
                                            int32_t ratio, int32_t decay, float parameter, float least_score,
                                            int64_t most, void *scratch, int64_t scratch_size, int64_t *keep,
                                            float *decayed, int64_t *kept);

/** As vesica_grid_f64. */
typedef struct {
    float x, y, dx, dy;
    int64_t columns, rows;
} vesica_grid_f32;
/** As vesica_coverage_f64, rounded to float. */
VESICA_API int32_t vesica_coverage_f32(int32_t kind, const void *shape, const vesica_grid_f32 *grid, float *out,
                                       ptrdiff_t row_stride);
/** As vesica_coverage_cells_f64, rounded to float. */
VESICA_API int64_t vesica_coverage_cells_f32(int32_t kind, const void *shape, const vesica_grid_f32 *grid,
                                             int64_t *cells, float *shares, int64_t capacity);

#ifdef __cplusplus
}
#endif

#endif /* VESICA_MEASURES_H */
