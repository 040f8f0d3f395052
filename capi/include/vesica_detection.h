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

/* Which truth a detection takes, of those whose value, such as IoU, is at least the threshold. */
#define VESICA_MATCH_VOC 0  /**< the one of the highest value, taken or not: if it is taken, the detection is a miss */
#define VESICA_MATCH_COCO 1 /**< the one of the highest value among those that are free */

/* The part of a truth in the result. */
#define VESICA_TRUTH_COUNTS 0  /**< it counts, and one detection may take it */
#define VESICA_TRUTH_CROWD 1   /**< it does not count, any number may take it: "difficult" (VOC), "iscrowd" (COCO) */
#define VESICA_TRUTH_IGNORED 2 /**< it does not count, and one may take it: COCO's truths outside a range of areas */

/* The outcome of a detection. */
#define VESICA_OUTCOME_MISS 0    /**< it took no truth: a false positive */
#define VESICA_OUTCOME_HIT 1     /**< it took one that counts: a true positive */
#define VESICA_OUTCOME_IGNORED 2 /**< it took one that does not count, and is neither */

/* How precision is averaged over recall. */
#define VESICA_PRECISION_VOC_2007 0 /**< at 11 recalls, 0, 0.1 ... 1 */
#define VESICA_PRECISION_VOC_2010 1 /**< at every truth: the area under the curve, of VOC from 2010 on */
#define VESICA_PRECISION_COCO 2     /**< at 101 recalls, 0, 0.01 ... 1 */

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
 * Cost: vesica_join_f64, and vesica_ratio_f64 for each pair whose bounds meet; for boxes and rectangles and a threshold
 * above 0 only for those whose bounds and areas allow such a ratio, unless it is over the first or the second.
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
 * Cost: a sort of the values.
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
 * Cost: an index of the boxes, and vesica_iou_f64 for each mean that the bounds of a box meet.
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
 * the bases times the shared height. Ratios are from 0 to 1; prisms that only touch share nothing. Exchanging the
 * prisms exchanges OVER_FIRST and OVER_SECOND, and changes no bit of the others.
 * Requires: ratio, one of VESICA_RATIO_OVER_UNION, _OVER_FIRST, _OVER_SECOND, _OVER_SMALLER.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE (or low above high, or a height that is not finite),
 * VESICA_E_ARGUMENT (another ratio, or the volume to divide by is 0), VESICA_E_RANGE (an area overflows).
 * Accuracy: computed from vesica_iou_f64 of the bases and vesica_shape_area_f64 with at most 12 u of further error, for
 * areas from 2^-400 to 2^400. The float function takes both as floats.
 * Cost: as vesica_iou_f64, and the two areas.
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

/* ---- Average precision, double ----
 * Since: 0.1.
 */

/**
 * How many bytes of scratch does matching by `count` pairs need?
 * Returns: 32 bytes a pair, 36 a detection, 1 a truth, and 4.
 * Errors: VESICA_E_ARGUMENT (a number is negative or above 2^31 - 1).
 */
VESICA_API int64_t vesica_match_truths_scratch(int64_t count, int64_t detections, int64_t truths);

/**
 * Which detections hit a truth, at each of some thresholds?
 *
 * Pair k is detection a[k] and truth b[k] with values[k], as vesica_join_ratio_f64 writes them at the lowest threshold
 * or below; detections and truths of many pictures are numbered through. A pair whose value is NaN is none. COCO takes
 * the shared area over the detection's (VESICA_RATIO_OVER_FIRST) for crowds in place of IoU.
 * At each threshold detections take truths in the order of their scores, the highest first, of equal ones by number:
 *
 *   - VESICA_MATCH_VOC: the truth with the highest value, of equal ones the first. If it counts and is taken, or its
 *     value is below the threshold, the detection is a miss.
 *   - VESICA_MATCH_COCO: of the free truths with at least the threshold, or 1 - 1e-10 if that is less, the one with the
 *     highest value, of equal ones the last. Those that do not count are asked only if there is none that does.
 *
 * outcomes[t * detections + i] is VESICA_OUTCOME_... of detection i at threshold t, and taken[...] the truth it takes,
 * or -1. As COCO, leave out all but the 100 best detections of a picture beforehand; and as for its ranges of areas,
 * call a miss whose own area is out of the range VESICA_OUTCOME_IGNORED afterwards.
 * Requires: rule, VESICA_MATCH_VOC or _COCO; 0 <= a[k] < detections and 0 <= b[k] < truths; scores, one for each
 * detection; flags, VESICA_TRUTH_... of each truth, or NULL if all count; scratch of at least
 * vesica_match_truths_scratch(count, detections, truths) bytes, aligned to 8; outcomes, and taken if it is not NULL,
 * with room for detections times threshold_count numbers. Pointers to nothing may be NULL.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (an unknown rule or flag, an item or a size out of range, a score or a
 * threshold that is NaN, a scratch that is not aligned). Nothing is written.
 * Accuracy: exact.
 * Cost: a sort; then for each threshold a walk over all pairs.
 */
VESICA_API int32_t vesica_match_truths_f64(int32_t rule, const int64_t *a, const int64_t *b, const double *values,
                                           int64_t count, const double *scores, int64_t detections,
                                           const uint8_t *flags, int64_t truths, const double *thresholds,
                                           int64_t threshold_count, void *scratch, int64_t scratch_size,
                                           uint8_t *outcomes, int64_t *taken);

/**
 * How many bytes of scratch does the average precision of `count` detections need?
 * Returns: 32 bytes a detection.
 * Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).
 */
VESICA_API int64_t vesica_average_precision_scratch(int64_t count);

/**
 * Average precision (AP) of detections of one class.
 *
 * With the detections in the order of their scores, the highest first, of equal ones by number, and without those that
 * are ignored: after each, precision is hits / detections so far, and recall hits so far / truths. The best precision
 * at a recall is the highest one after any detection whose recall is at least that, or 0 if there is none. AP is the
 * mean of the best precision at the recalls of `rule`.
 * Recalls are compared in double, as the programs of the challenges do: 0.1 i and 0.01 i are rounded, and so are hits /
 * truths. COCO's mean AP is the mean over its thresholds, 0.50, 0.55 ... 0.95, and classes.
 * Requires: rule, one of VESICA_PRECISION_VOC_2007 to _COCO; scores and outcomes (VESICA_OUTCOME_...), one for each
 * detection; truths, how many of them count; scratch of at least vesica_average_precision_scratch(count) bytes, aligned
 * to 8.
 * Returns: 0; *out is from 0 to 1, or NaN without truths.
 * Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (an unknown rule or outcome, a score that is NaN, more hits than truths, a
 * size out of range, a scratch that is not aligned).
 * Accuracy: u times the number of hits plus 2, for VESICA_PRECISION_COCO 103 u at most. COCO's own program has up to
 * 2 u less, since it adds 2 u to each divisor.
 * Cost: a sort.
 */
VESICA_API int32_t vesica_average_precision_f64(int32_t rule, const double *scores, const uint8_t *outcomes,
                                                int64_t count, int64_t truths, void *scratch, int64_t scratch_size,
                                                double *out);

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
 *     BHATTACHARYYA     d^T S^-1 d / 8 + log(det S / sqrt(det S_a det S_b)) / 2
 *     HELLINGER         sqrt(1 - exp(-BHATTACHARYYA))
 *     KULLBACK_LEIBLER  (trace(S_b^-1 S_a) - 2 + d^T S_b^-1 d + log(det S_b / det S_a)) / 2
 *     WASSERSTEIN       d^T d + trace(S_a + S_b - 2 (S_a^1/2 S_b S_a^1/2)^1/2)
 *
 * Equal Gaussians have exactly 0. Exchanging the shapes changes no bit, except of KULLBACK_LEIBLER. Losses are made of
 * these numbers in many ways, such as 1 - 1 / (1 + log(1 + x)).
 * Requires: which, one of VESICA_GAUSSIAN_BHATTACHARYYA to VESICA_GAUSSIAN_WASSERSTEIN.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND (also points, segments and shapes with round corners or vertices),
 * VESICA_E_SHAPE, VESICA_E_ARGUMENT (no such distance; or a size is 0, which only WASSERSTEIN takes), VESICA_E_RANGE
 * (the distance would overflow; or, except for WASSERSTEIN, one size is more than 2^400 times another).
 * Accuracy: a relative error of at most 24 u, and 2^-1074; also if the Gaussians are nearly equal, thin, or far apart.
 * Cost: a few roots and logarithms; in a matrix about a third of a call or less a pair.
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
/** As vesica_match_truths_f64. */
VESICA_API int32_t vesica_match_truths_f32(int32_t rule, const int64_t *a, const int64_t *b, const float *values,
                                           int64_t count, const float *scores, int64_t detections,
                                           const uint8_t *flags, int64_t truths, const float *thresholds,
                                           int64_t threshold_count, void *scratch, int64_t scratch_size,
                                           uint8_t *outcomes, int64_t *taken);
/** As vesica_average_precision_f64, rounded to float. */
VESICA_API int32_t vesica_average_precision_f32(int32_t rule, const float *scores, const uint8_t *outcomes,
                                                int64_t count, int64_t truths, void *scratch, int64_t scratch_size,
                                                float *out);

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
