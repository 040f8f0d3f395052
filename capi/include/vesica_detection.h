/*
 * Vesica: what is done around detectors: pairs by ratio, assignment, fusion of boxes, average precision;
 * distances of shapes as Gaussian distributions; ratios of volumes.
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

/* ---- Constants ---- */

/* The score of a cluster of boxes that were fused. */
#define VESICA_FUSED_MEAN 0 /**< the mean of its scores s with weights w: sum(w s) / sum(w) */
#define VESICA_FUSED_MAX 1  /**< its highest score */

/* Distances of two shapes as Gaussian distributions. They are not IoU, and have no such meaning as a shared area. */
#define VESICA_GAUSSIAN_BHATTACHARYYA 0    /**< Bhattacharyya's distance, from 0 to infinity */
#define VESICA_GAUSSIAN_HELLINGER 1        /**< Hellinger's distance, from 0 to 1; ProbIoU is 1 - this */
#define VESICA_GAUSSIAN_KULLBACK_LEIBLER 2 /**< Kullback-Leibler divergence of a from b (KLD), from 0 to infinity */
#define VESICA_GAUSSIAN_WASSERSTEIN 3      /**< squared Wasserstein distance (GWD), an area from 0 to infinity */

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

/**
 * How many bytes of scratch does greedy assignment of `count` pairs need?
 * Returns: 32 bytes a pair, and a bit for each of count_a and of count_b.
 * Errors: VESICA_E_ARGUMENT (a number is negative or above 2^31 - 1).
 */
VESICA_API int64_t vesica_assign_greedy_scratch(int64_t count, int64_t count_a, int64_t count_b);

/**
 * Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both free,
 * until there is none.
 *
 * Pair k is item a[k] of one side and item b[k] of the other, with values[k], as vesica_join_ratio_f64 writes them. Of
 * equal values the pair with the lower item of a comes first, then the lower item of b, then the lower k. A pair whose
 * value is NaN is not taken. chosen[0], chosen[1] ... are the numbers k of the pairs taken, the best first.
 * The sum of values may be less than the largest possible one; that is the answer of a solver for sparse assignment.
 * Requires: 0 <= a[k] < count_a and 0 <= b[k] < count_b. scratch of at least vesica_assign_greedy_scratch(count,
 * count_a, count_b) bytes, aligned to 8. chosen, room for the least of count, count_a and count_b. With count 0 all
 * pointers may be NULL.
 * Returns: how many pairs are taken.
 * Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (a number, an item or a size is out of range, the scratch is not aligned).
 * Nothing is written.
 * Cost: a sort of the values: 50 to 80 ns a pair.
 */
VESICA_API int64_t vesica_assign_greedy_f64(const int64_t *a, const int64_t *b, const double *values, int64_t count,
                                            int64_t count_a, int64_t count_b, void *scratch, int64_t scratch_size,
                                            int64_t *chosen);

/* ---- Fusion of boxes, double ----
 * Since: 0.1.
 */

/**
 * How many bytes of scratch does the fusion of `count` boxes need?
 * Returns: about 350 bytes a box, and 0.4 MiB.
 * Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).
 */
VESICA_API int64_t vesica_fuse_scratch(int64_t count);

/**
 * Weighted boxes fusion: boxes of one object, as several detectors or views find them, become their weighted mean.
 *
 * Takes boxes in the order of score times weight, the highest first, of equal ones by number. Each joins the cluster of
 * its label whose mean it has the highest IoU with, of equal ones the first, if that IoU exceeds the threshold;
 * otherwise it begins a cluster. A box counts in its cluster's mean by score times weight: with p = s w,
 *
 *     mean = sum(p x) / sum(p)
 *
 * for each coordinate x of a box along the axes, and for the centre and each half length of a rectangle.
 * A rectangle is the same when it is turned by 180 degrees, or by 90 with its half lengths exchanged. Of these four
 * forms each member has the one whose corners are nearest to those of the cluster's first member, by the sum of the
 * squares of their distances, both about one centre. The direction of the mean is that of the sum of p times their unit
 * directions, and is written as a unit vector. If all p of a cluster are 0, its mean is its first box; if all its
 * weights are 0, its mean score is the first one. A cluster of one box is that box, bit for bit.
 * Record c of fused, of the shapes' kind, and fused_scores[c] are those of cluster c; clusters[i] is that of box i. The
 * paper then multiplies a score by min(n, m) / m, for n boxes in the cluster and m models: clusters gives n.
 * Requires: shapes of kind VESICA_AABB or VESICA_RECT; scores from 0 to 2^480, one for each; weights in the same range,
 * such as that of a box's model, or NULL for 1; labels, or NULL if all are the same; threshold from 0 to 1; fused_score
 * VESICA_FUSED_MEAN or _MAX; scratch of at least vesica_fuse_scratch(count) bytes; fused with room for
 * `count` records of vesica_aabb_f64 or vesica_rect_f64, fused_scores and clusters for as many numbers.
 * Returns: 0, with *count set to the number of clusters.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (the threshold, fused_score, or a size is out of range).
 * VESICA_E_SHAPE: boxes are left out, and have cluster -1, that are invalid, whose coordinates
 * or half lengths exceed 2^1020, or whose score or weight is out of range; the result of all others is written.
 * Accuracy: IoU is that of vesica_iou_f64 and the mean before it is rounded to the output's type. With n boxes in the
 * cluster, a coordinate x of the mean is right to 4 u (n d + |x|) + n 2^-1074, d the largest difference from that of
 * the first box; a score to 4 u n times the highest; a direction to 4 u n, if all are within 45 degrees of the first.
 * The float function computes in double and rounds its results.
 * Cost: an index of the boxes; then about 1 us a box, and vesica_iou_f64 for each mean that its bounds meet.
 */
VESICA_API int32_t vesica_fuse_f64(const vesica_shapes_f64 *shapes, const double *scores, const double *weights,
                                   const int32_t *labels, double threshold, int32_t fused_score, void *scratch,
                                   int64_t scratch_size, void *fused, double *fused_scores, int64_t *clusters,
                                   int64_t *count);

/* ---- Upright prisms: a shape from one height to another, such as the boxes of vehicles, double ----
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT, VESICA_E_RANGE.
 * Since: 0.1.
 */

/** All heights from low to high; low <= high, both finite. */
typedef struct {
    double low, high;
} vesica_span_f64;

/**
 * A ratio of shared volume: IoU and its relatives of two upright prisms.
 *
 * A prism is what lies above a shape, its base, from span's low to its high. The shared volume is the shared area of
 * the bases times the shared height. Ratios are from 0 to 1; prisms that only touch share nothing.
 * Requires: ratio, one of VESICA_RATIO_OVER_UNION, _OVER_FIRST, _OVER_SECOND, _OVER_SMALLER.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE (or low above high, or a height that is not finite),
 * VESICA_E_ARGUMENT (another ratio, or the volume to divide by is 0), VESICA_E_RANGE (an area overflows).
 * Accuracy: computed from the result of vesica_ratio_f64 for the bases, over the first or the second, and from
 * vesica_shape_area_f64, with at most 8 u of further error, for areas and heights from 2^-500 to 2^500.
 * The float function takes both as floats.
 * Cost: as vesica_ratio_f64, and the two areas.
 */
VESICA_API int32_t vesica_volume_ratio_f64(int32_t ratio, int32_t kind_a, const void *a, const vesica_span_f64 *span_a,
                                           int32_t kind_b, const void *b, const vesica_span_f64 *span_b, double *out);

/**
 * A ratio of shared volume of the prisms a[i] from spans_a[i] and b[i] from spans_b[i].
 *
 * Arrays are those of vesica_iou_many_f64. If a pair has an error, out[i] is NaN, and the call returns VESICA_E_SHAPE
 * if a shape or a span is invalid, else VESICA_E_ARGUMENT if a volume is 0, else VESICA_E_RANGE.
 * Requires: spans, as many as there are shapes beside them.
 * Returns: how many are > 0.
 * Accuracy: every result has the same bits as vesica_volume_ratio_f64.
 */
VESICA_API int64_t vesica_volume_ratio_many_f64(int32_t ratio, const vesica_shapes_f64 *a,
                                                const vesica_span_f64 *spans_a, const vesica_shapes_f64 *b,
                                                const vesica_span_f64 *spans_b, double *out);

/**
 * A ratio of shared volume of every a[i] and b[j], in out[i * row_stride + j].
 *
 * Arrays and row_stride are those of vesica_iou_matrix_f64, errors those of vesica_volume_ratio_many_f64.
 * Requires: spans, as many as there are shapes beside them.
 * Returns: how many are > 0.
 * Accuracy: every result has the same bits as vesica_volume_ratio_f64.
 */
VESICA_API int64_t vesica_volume_ratio_matrix_f64(int32_t ratio, const vesica_shapes_f64 *a,
                                                  const vesica_span_f64 *spans_a, const vesica_shapes_f64 *b,
                                                  const vesica_span_f64 *spans_b, double *out, ptrdiff_t row_stride);

/* ---- Shapes as Gaussian distributions, double ----
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT, VESICA_E_RANGE.
 * Since: 0.1.
 */

/**
 * The distance of two circles, boxes, rectangles or ellipses as Gaussian distributions.
 *
 * A shape's Gaussian has the mean m and the covariance S of its points: the variance along a side of a rectangle is
 * width^2 / 12, as in ProbIoU; along an axis of an ellipse it is a^2 / 4, a the half length. Papers on GWD and KLD
 * take width^2 / 4: to have theirs, multiply the half sizes of rectangles by sqrt(3). The four distances are, with
 * d = m_a - m_b and S = (S_a + S_b) / 2:
 *
 *     BHATTACHARYYA     d'S^-1 d / 8 + log(det S / sqrt(det S_a det S_b)) / 2
 *     HELLINGER         sqrt(1 - exp(-BHATTACHARYYA))
 *     KULLBACK_LEIBLER  (trace(S_b^-1 S_a) - 2 + d'S_b^-1 d + log(det S_b / det S_a)) / 2
 *     WASSERSTEIN       d'd + trace(S_a + S_b - 2 (S_a^1/2 S_b S_a^1/2)^1/2)
 *
 * Equal Gaussians have exactly 0. Exchanging the shapes changes no bit, except of KULLBACK_LEIBLER. Losses are made of
 * these numbers in many ways, such as 1 - 1 / (1 + log(1 + x)).
 * Requires: which, one of VESICA_GAUSSIAN_BHATTACHARYYA to VESICA_GAUSSIAN_WASSERSTEIN.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND (also points, segments and shapes with round corners or vertices),
 * VESICA_E_SHAPE, VESICA_E_ARGUMENT (no such distance; or a size is 0, which only WASSERSTEIN takes), VESICA_E_RANGE
 * (the distance would overflow; or, except for WASSERSTEIN, one size is more than 2^400 times another).
 * Accuracy: a relative error of at most 24 u, and 2^-1074; also if the Gaussians are nearly equal, thin, or far apart.
 * Cost: 0.3 us; in a matrix 0.07 to 0.12 us a pair.
 */
VESICA_API int32_t vesica_gaussian_distance_f64(int32_t which, int32_t kind_a, const void *a, int32_t kind_b,
                                                const void *b, double *out);

/**
 * The distance of a[i] and b[i]: out[i] is the result of vesica_gaussian_distance_f64.
 *
 * Arrays are those of vesica_iou_many_f64. If a pair has an error, out[i] is NaN, and the call returns VESICA_E_SHAPE
 * if a shape is invalid, else VESICA_E_ARGUMENT if a size is 0, else VESICA_E_RANGE.
 * Returns: how many are 0.
 * Accuracy: every result has the same bits as vesica_gaussian_distance_f64.
 */
VESICA_API int64_t vesica_gaussian_distance_many_f64(int32_t which, const vesica_shapes_f64 *a,
                                                     const vesica_shapes_f64 *b, double *out);

/**
 * The distance of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_gaussian_distance_f64.
 *
 * Arrays and row_stride are those of vesica_iou_matrix_f64, errors those of vesica_gaussian_distance_many_f64.
 * Returns: how many are 0.
 * Accuracy: every result has the same bits as vesica_gaussian_distance_f64.
 */
VESICA_API int64_t vesica_gaussian_distance_matrix_f64(int32_t which, const vesica_shapes_f64 *a,
                                                       const vesica_shapes_f64 *b, double *out, ptrdiff_t row_stride);

/* ---- The same functions with float in place of double ---- */

/** As vesica_join_ratio_f64. */
VESICA_API int64_t vesica_join_ratio_f32(int32_t ratio, float threshold, const void *index_a,
                                         const vesica_shapes_f32 *sets_a, int32_t set_count_a, const void *index_b,
                                         const vesica_shapes_f32 *sets_b, int32_t set_count_b, int64_t part,
                                         int64_t parts, void *scratch, int64_t scratch_size, int64_t *out_a,
                                         int64_t *out_b, float *values, int64_t capacity, int64_t *state);
/** As vesica_assign_greedy_f64. */
VESICA_API int64_t vesica_assign_greedy_f32(const int64_t *a, const int64_t *b, const float *values, int64_t count,
                                            int64_t count_a, int64_t count_b, void *scratch, int64_t scratch_size,
                                            int64_t *chosen);
/** As vesica_fuse_f64. */
VESICA_API int32_t vesica_fuse_f32(const vesica_shapes_f32 *shapes, const float *scores, const float *weights,
                                   const int32_t *labels, float threshold, int32_t fused_score, void *scratch,
                                   int64_t scratch_size, void *fused, float *fused_scores, int64_t *clusters,
                                   int64_t *count);

/** As vesica_span_f64. */
typedef struct {
    float low, high;
} vesica_span_f32;
/** As vesica_volume_ratio_f64, rounded to float. */
VESICA_API int32_t vesica_volume_ratio_f32(int32_t ratio, int32_t kind_a, const void *a, const vesica_span_f32 *span_a,
                                           int32_t kind_b, const void *b, const vesica_span_f32 *span_b, float *out);
/** As vesica_volume_ratio_many_f64, rounded to float. */
VESICA_API int64_t vesica_volume_ratio_many_f32(int32_t ratio, const vesica_shapes_f32 *a,
                                                const vesica_span_f32 *spans_a, const vesica_shapes_f32 *b,
                                                const vesica_span_f32 *spans_b, float *out);
/** As vesica_volume_ratio_matrix_f64, rounded to float. */
VESICA_API int64_t vesica_volume_ratio_matrix_f32(int32_t ratio, const vesica_shapes_f32 *a,
                                                  const vesica_span_f32 *spans_a, const vesica_shapes_f32 *b,
                                                  const vesica_span_f32 *spans_b, float *out, ptrdiff_t row_stride);
/** As vesica_gaussian_distance_f64, rounded to float. */
VESICA_API int32_t vesica_gaussian_distance_f32(int32_t which, int32_t kind_a, const void *a, int32_t kind_b,
                                                const void *b, float *out);
/** As vesica_gaussian_distance_many_f64, rounded to float. */
VESICA_API int64_t vesica_gaussian_distance_many_f32(int32_t which, const vesica_shapes_f32 *a,
                                                     const vesica_shapes_f32 *b, float *out);
/** As vesica_gaussian_distance_matrix_f64, rounded to float. */
VESICA_API int64_t vesica_gaussian_distance_matrix_f32(int32_t which, const vesica_shapes_f32 *a,
                                                       const vesica_shapes_f32 *b, float *out, ptrdiff_t row_stride);

#ifdef __cplusplus
}
#endif

#endif /* VESICA_DETECTION_H */
