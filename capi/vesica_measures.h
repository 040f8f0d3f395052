/*
 * Vesica: measures beside those of vesica.h. Ratios of shared area, suppression by them, matrices of distances.
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

/* What a shared area is compared with. The hull of two shapes is the smallest box along the axes about both. */
#define VESICA_RATIO_OVER_UNION 0   /**< shared area / area of a and b together (IoU) */
#define VESICA_RATIO_OVER_FIRST 1   /**< shared area / area of a (IoF) */
#define VESICA_RATIO_OVER_SECOND 2  /**< shared area / area of b (IoA) */
#define VESICA_RATIO_OVER_SMALLER 3 /**< shared area / the smaller of the areas (IoS) */
#define VESICA_RATIO_GENERALIZED 4  /**< IoU - the part of the hull that neither covers (GIoU) */
#define VESICA_RATIO_DISTANCE 5     /**< IoU - (distance of the centres / diagonal of the hull)^2 (DIoU) */
#define VESICA_RATIO_COMPLETE 6     /**< DIoU - v^2 / (1 - IoU + v), v = (difference of angles / 90 degrees)^2 (CIoU) */

/* ---- Ratios of shared area, double ----
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.
 * Since: 0.1.
 */

/**
 * What share of a's area does b cover, or of b's area a? And other ratios by which detections are compared.
 *
 * The first four are from 0 to 1. One over a shape is 0 if no area is shared, and 1 if the other shape contains it. The
 * last three are at most the IoU, and at least -1, for CIoU -2. The angle of a shape in CIoU is that of the vector
 * (half length across its axis, half length along it); v is 0 if a shape has no size. Exchanging the shapes exchanges
 * OVER_FIRST and OVER_SECOND, and changes no bit of the others.
 * Requires: ratio, one of VESICA_RATIO_OVER_UNION to VESICA_RATIO_COMPLETE.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (ratio is no such constant; the shape whose
 * area divides has none; for the others, neither shape has one).
 * Accuracy: within 8 u of what follows from the shared area or the IoU, which are right as vesica_area_f64 and
 * vesica_iou_f64 tell, for half lengths from 2^-200 to 2^200.
 * Cost: that of vesica_area_f64 or vesica_iou_f64, and 100 to 150 ns more; 40 to 100 in arrays.
 */
VESICA_API int32_t vesica_ratio_f64(int32_t ratio, int32_t kind_a, const double *numbers_a, int32_t kind_b,
                                    const double *numbers_b, double *out);

/**
 * A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f64.
 *
 * Arrays and errors are those of vesica_iou_many_f64. If a pair has no ratio since an area is 0, out[i] is NaN, and the
 * call returns VESICA_E_ARGUMENT unless a shape is invalid.
 * Returns: how many are > 0.
 * Accuracy: every result has the bits of vesica_ratio_f64, on every instruction set and in every layout.
 */
VESICA_API int64_t vesica_ratio_many_f64(int32_t ratio, const vesica_shapes_f64 *a, const vesica_shapes_f64 *b,
                                         double *out);

/**
 * A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f64.
 *
 * Arrays, row_stride and errors are those of vesica_iou_matrix_f64. If a pair has no ratio since an area is 0, it gets
 * NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
 * Returns: how many are > 0.
 * Accuracy: every result has the bits of vesica_ratio_f64, on every instruction set and in every layout.
 */
VESICA_API int64_t vesica_ratio_matrix_f64(int32_t ratio, const vesica_shapes_f64 *a, const vesica_shapes_f64 *b,
                                           double *out, ptrdiff_t row_stride);

/* ---- Every a with every b, double: distances and depths alone, without their points or directions ----
 * Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f64.
 * Errors: as vesica_iou_matrix_f64.
 * Accuracy: every result has the bits of the function for two shapes, on every instruction set and in every layout.
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

/* ---- Choices among many shapes, double ----
 * Since: 0.1.
 */

/**
 * Greedy non-maximum suppression as vesica_nms_f64, by any ratio and among like labels.
 *
 * Takes shapes in the order of their scores, highest first. Keeps each one whose ratio with every shape kept before, of
 * the same label, is at most the threshold. Shapes whose score is below least_score are not looked at.
 * Requires: shapes, scores, threshold, scratch and keep as vesica_nms_f64; labels, one for each, or NULL if all are
 * alike; ratio, any but VESICA_RATIO_OVER_FIRST and _OVER_SECOND; least_score, which may be -infinity; most, how many
 * are kept at most: keep needs room for no more.
 * Returns: 0, and keep and *kept as vesica_nms_f64.
 * Errors: as vesica_nms_f64; VESICA_E_ARGUMENT also for ratio, a least_score that is NaN, and a negative most.
 * Cost: that of vesica_nms_f64; ratios other than IoU cost 0.1 us more a comparison.
 */
VESICA_API int32_t vesica_suppress_f64(const vesica_shapes_f64 *shapes, const double *scores, const int32_t *labels,
                                       int32_t ratio, double threshold, double least_score, int64_t most,
                                       void *scratch, int64_t scratch_size, int64_t *keep, int64_t *kept);

/* ---- The same functions with float in place of double ---- */

/** As vesica_ratio_f64, rounded to float. */
VESICA_API int32_t vesica_ratio_f32(int32_t ratio, int32_t kind_a, const float *numbers_a, int32_t kind_b,
                                    const float *numbers_b, float *out);
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

#ifdef __cplusplus
}
#endif

#endif /* VESICA_MEASURES_H */
