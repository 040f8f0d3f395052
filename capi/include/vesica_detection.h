/*
 * Vesica: what is done around detectors: pairs by ratio, assignment, fusion of boxes, average precision.
 *
 * SPDX-License-Identifier: Apache-2.0
 *
 * vesica.h includes this header, and both belong to one library. Suppression is in vesica_measures.h and vesica.h.
 *
 * The rules of vesica.h hold, and those of vesica_index.h for indexes, parts and states. Comments have the same parts:
 * Requires, Returns, Errors, Accuracy, Cost, Since.
 */
#ifndef VESICA_DETECTION_H
#define VESICA_DETECTION_H

#include "vesica_index.h"
#include "vesica_measures.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Pairs and their ratios, double ----
 * Since: 0.1.
 */

/**
 * All pairs that overlap and whose ratio is at least `threshold`, with the ratio: a sparse matrix of IoU and the like.
 *
 * Pair i is out_a[i] and out_b[i], and values[i] is the result of vesica_ratio_f64 for them, the item of index_a first.
 * Threshold 0 finds every pair that overlaps and has a ratio; GIoU, DIoU and CIoU may be below 0, so there -infinity
 * does. A pair without a ratio, as two shapes without area have no IoU, is left out. Order, parts, states, and pairs of
 * an index with itself are as for vesica_join_f64.
 * Requires: ratio, one of VESICA_RATIO_OVER_UNION to VESICA_RATIO_COMPLETE; threshold, not NaN; values with room for
 * `capacity` numbers. The rest is as for vesica_join_f64 with VESICA_JOIN_OVERLAP. With capacity 0, out_a, out_b,
 * values and state may be NULL.
 * Returns: the number of pairs written; with capacity 0, how many the whole part has.
 * Errors: those of vesica_join_f64; VESICA_E_ARGUMENT also for ratio and threshold.
 * Accuracy: as vesica_ratio_f64, bit for bit; in float, the ratio rounded to float is compared.
 * Cost: vesica_join_f64, and vesica_ratio_f64 for each pair whose bounds meet.
 */
VESICA_API int64_t vesica_join_ratio_f64(int32_t ratio, double threshold, const void *index_a,
                                         const vesica_shapes_f64 *sets_a, int32_t set_count_a, const void *index_b,
                                         const vesica_shapes_f64 *sets_b, int32_t set_count_b, int64_t part,
                                         int64_t parts, void *scratch, int64_t scratch_size, int64_t *out_a,
                                         int64_t *out_b, double *values, int64_t capacity, int64_t *state);

/* ---- The same functions with float in place of double ---- */

/** As vesica_join_ratio_f64. */
VESICA_API int64_t vesica_join_ratio_f32(int32_t ratio, float threshold, const void *index_a,
                                         const vesica_shapes_f32 *sets_a, int32_t set_count_a, const void *index_b,
                                         const vesica_shapes_f32 *sets_b, int32_t set_count_b, int64_t part,
                                         int64_t parts, void *scratch, int64_t scratch_size, int64_t *out_a,
                                         int64_t *out_b, float *values, int64_t capacity, int64_t *state);

#ifdef __cplusplus
}
#endif

#endif /* VESICA_DETECTION_H */
