/*
 * Vesica: index and join, for the pairs that overlap among millions of shapes.
 *
 * SPDX-License-Identifier: Apache-2.0
 *
 * vesica.h includes this header, and both belong to one library.
 *
 * An index is flat memory of the caller's, without pointers. It may be saved, sent, mapped and read by any number of
 * threads. It holds bounds of shapes and not the shapes themselves: functions that look at shapes take both.
 *
 * The shapes of an index are some sets, laid end to end: item i of the index is shape i of the first set, and the items
 * of the next set follow. An index holds at most 64 sets that are not empty, and 2^31 - 1 items. sets[s] may be of any
 * kind. The index's bytes depend on the shapes alone, whatever the processor, the layout of the arrays or the number of
 * threads. Only the order of the bytes within a number is the machine's.
 *
 * An index and its scratch memory are aligned to 64 bytes.
 *
 * A function that may have more to say than there is room for takes a state of four numbers. All are 0 at the first
 * call. After each call state[0] is -1 if that was all. If not, the same call gives more. A state may be saved or sent.
 *
 * The rules of vesica.h hold. Comments have the same parts: Requires, Returns, Errors, Accuracy, Cost, Since.
 */
#ifndef VESICA_INDEX_H
#define VESICA_INDEX_H

#include "vesica.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Constants ---- */

/* What makes item a of one index and item b of another a pair of a join. */
#define VESICA_JOIN_OVERLAP 0  /**< a and b share a point, as vesica_overlap_f64 tells */
#define VESICA_JOIN_BOUNDS 1   /**< their bounds in the indexes do: all pairs that overlap, and some that do not */
#define VESICA_JOIN_CONTAINS 2 /**< a contains b, as vesica_contains_f64 tells */
#define VESICA_JOIN_INSIDE 3   /**< b contains a */

/* ---- Memory ----
 * Since: 0.1.
 */

/**
 * How many bytes suffice for an index of `count` shapes, of any kinds?
 * Returns: 17 bytes a shape and 64 KiB. A built index takes fewer, mostly 13 a shape: vesica_index_bytes tells.
 * Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).
 */
VESICA_API int64_t vesica_index_size(int64_t count);

/**
 * How many bytes of scratch does building an index of `count` shapes need?
 * Returns: about 18 bytes a shape, and a constant.
 * Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).
 */
VESICA_API int64_t vesica_index_scratch(int64_t count);

/**
 * How many bytes of scratch does a join need, whatever its indexes?
 * Returns: at most 1 MiB.
 */
VESICA_API int64_t vesica_join_scratch(void);

/* ---- Reading an index. All but vesica_index_check trust it beyond its header. ----
 * Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (its header is none).
 * Since: 0.1.
 */

/**
 * Are these bytes an index that queries can read?
 *
 * Ask it once of bytes that come from elsewhere. They may be short, foreign or damaged, or from a machine of the other
 * byte order. What passes is safe to read.
 * Requires: size is the number of bytes there. The index may be shorter.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (it is none).
 * Cost: it reads all bytes once.
 */
VESICA_API int32_t vesica_index_check(const void *index, int64_t size);

/**
 * How many bytes does a built index take? So many are to be saved.
 * Returns: the bytes, a multiple of 64.
 */
VESICA_API int64_t vesica_index_bytes(const void *index);

/**
 * How many shapes was an index built from?
 * Returns: the number of its items, invalid shapes included.
 */
VESICA_API int64_t vesica_index_count(const void *index);

/**
 * A box around all valid shapes of an index.
 *
 * Indexes whose boxes are disjoint have no pairs.
 * Returns: 0.
 * Accuracy: the box is a little larger than the smallest one. It is infinite where that exceeds the finite numbers.
 * Without valid shapes min is infinity and max is -infinity.
 */
VESICA_API int32_t vesica_index_bounds(const void *index, vesica_aabb_f64 *out);

/**
 * The items of an index in spatial order: shapes that are near to each other stand near to each other.
 *
 * A join is faster if the arrays of shapes have this order, for then it reads them from near to near.
 * Requires: out has room for `capacity` items. It may be NULL if that is 0.
 * Returns: how many items there are, without the invalid shapes. The first `capacity` of them are written.
 * Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned, capacity < 0), VESICA_E_INDEX.
 */
VESICA_API int64_t vesica_index_order(const void *index, int64_t *out, int64_t capacity);

/* ---- Building an index, double ----
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a count, a size or an alignment), VESICA_E_SHAPE.
 * Since: 0.1.
 */

/**
 * Builds the index of some sets of shapes.
 *
 * Invalid shapes are left out. The call then returns VESICA_E_SHAPE, and the index of all others is complete. After any
 * other error nothing is written. Shapes that moved need a new index.
 * Requires: index_size >= vesica_index_size(items) and scratch_size >= vesica_index_scratch(items). The scratch is free
 * again after the call.
 * Returns: the bytes of the index that are used.
 * Cost: 30 to 50 ns a shape.
 */
VESICA_API int64_t vesica_index_build_f64(const vesica_shapes_f64 *sets, int32_t set_count, void *index,
                                          int64_t index_size, void *scratch, int64_t scratch_size);

/**
 * One part of a build in five steps, for several threads. The bytes are those of vesica_index_build_f64.
 *
 * Steps 0 and 4 have one part. Steps 1, 2 and 3 have as many parts as the caller likes, and these may run at the same
 * time. All parts of a step must be done before the next step begins. All other arguments are the same in all calls.
 * Requires: 0 <= step <= 4 and 0 <= part < parts; parts is 1 in steps 0 and 4. The rest is as for the build.
 * Returns: 0; at step 4 what vesica_index_build_f64 returns.
 * Errors: those of vesica_index_build_f64. VESICA_E_ARGUMENT also if step, part or parts is out of range, or if the
 * scratch is not that of step 0.
 */
VESICA_API int64_t vesica_index_step_f64(int32_t step, int64_t part, int64_t parts, const vesica_shapes_f64 *sets,
                                         int32_t set_count, void *index, int64_t index_size, void *scratch,
                                         int64_t scratch_size);

/* ---- Questions about one or two indexes, double ----
 * Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (one is invalid), VESICA_E_ARGUMENT (a number or
 * a size is out of range, a pointer is not aligned, sets are not the index's, the state is not of this call).
 * Since: 0.1.
 */

/**
 * Which items of an index does one shape overlap? They come in the index's order.
 *
 * Many shapes are better joined: index them too.
 * Requires: sets are those of the index. NULL with set_count 0 asks for the items whose bounds meet those of the shape.
 * one is a single shape (count 1). out has room for `capacity` items. With capacity 0, out and state may be NULL.
 * Returns: the number of items written; with capacity 0, how many there are.
 * Accuracy: exact, if there are sets.
 */
VESICA_API int64_t vesica_index_select_f64(const void *index, const vesica_shapes_f64 *sets, int32_t set_count,
                                           const vesica_shapes_f64 *one, int64_t *out, int64_t capacity,
                                           int64_t *state);

/**
 * All pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
 *
 * If both indexes are the same pointer, pairs are those of two different items a < b. Pair i is out_a[i] and out_b[i].
 * The order of pairs depends on the bytes of the indexes and the query alone.
 * Work may be shared out: each part of `parts` is about as much work as any other, and may run at the same time with a
 * scratch of its own. The pairs of all parts, one part after the other, are the pairs of part 0 of 1.
 * Requires: query is VESICA_JOIN_OVERLAP ... VESICA_JOIN_INSIDE. sets_a and sets_b are those of the indexes; with
 * VESICA_JOIN_BOUNDS they are not looked at. 0 <= part < parts. scratch_size >= vesica_join_scratch(); the scratch is
 * free between calls. out_a and out_b have room for `capacity` items. With capacity 0, they and state may be NULL.
 * Returns: the number of pairs written; with capacity 0, how many the whole part has.
 * Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_ARGUMENT (as above, and for an unknown query).
 * Accuracy: exact for all queries but VESICA_JOIN_BOUNDS.
 * Cost: 10 to 15 ns a shape to find candidates, and 15 to 25 ns a candidate to decide.
 */
VESICA_API int64_t vesica_join_f64(int32_t query, const void *index_a, const vesica_shapes_f64 *sets_a,
                                   int32_t set_count_a, const void *index_b, const vesica_shapes_f64 *sets_b,
                                   int32_t set_count_b, int64_t part, int64_t parts, void *scratch,
                                   int64_t scratch_size, int64_t *out_a, int64_t *out_b, int64_t capacity,
                                   int64_t *state);

/**
 * All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once: those whose
 * answer from vesica_within_f64 is > 0.
 *
 * If both indexes are the same pointer, pairs are those of two different items a < b. They come in index_a's order.
 * Parts are runs of about as many items of index_a as any other; all else is as with vesica_join_f64.
 * Requires: distance >= 0, or infinity, which asks for all pairs of valid shapes; sets, part, outputs, capacity and
 * state as vesica_join_f64.
 * Returns: the number of pairs written; with capacity 0, how many the whole part has.
 * Errors: those of vesica_join_f64; VESICA_E_ARGUMENT also for a distance that is negative or NaN.
 * Accuracy: that of vesica_within_f64; a pair that is VESICA_WITHIN_NEARLY is among them.
 * Cost: about 1 us a shape of index_a and that of vesica_within_f64 a candidate: seven times that of vesica_join_f64.
 */
VESICA_API int64_t vesica_join_within_f64(const void *index_a, const vesica_shapes_f64 *sets_a, int32_t set_count_a,
                                          const void *index_b, const vesica_shapes_f64 *sets_b, int32_t set_count_b,
                                          double distance, int64_t part, int64_t parts, int64_t *out_a,
                                          int64_t *out_b, int64_t capacity, int64_t *state);

/**
 * Which items of an index are nearest to one shape? They come with the nearest first; at equal distances by number.
 *
 * An item that overlaps the shape has distance 0. An item whose distance exceeds the finite numbers is not found.
 * Requires: sets are those of the index. one is a single shape (count 1). k >= 0, and out and distance have room for k
 * each. With k = 0 they may be NULL. within >= 0 is the largest distance asked for; infinity asks for any.
 * Returns: how many items were found and written; with k = 0, how many there are within the distance.
 * Accuracy: distances are those of vesica_nearest_f64, bit for bit.
 */
VESICA_API int64_t vesica_index_nearest_f64(const void *index, const vesica_shapes_f64 *sets, int32_t set_count,
                                            const vesica_shapes_f64 *one, int64_t k, double within, int64_t *out,
                                            double *distance);

/**
 * Which items of index_b are nearest to each item of sets_a? Row i is out[i * k] ... out[i * k + k - 1].
 *
 * A row is what vesica_index_nearest_f64 says of item i, followed by -1, with distance infinity, up to k. Of one set
 * with itself each item finds itself too, at distance 0. If an item of sets_a is invalid, its row holds -1, all other
 * rows are right, and the call returns VESICA_E_SHAPE.
 * Each of `parts` is a run of about as many items as any other, and only its rows are written.
 * Requires: sets_b are those of index_b. k >= 1, and out and distance have room for k items a row. 0 <= part < parts.
 * within >= 0 is the largest distance asked for; infinity asks for any.
 * Returns: how many items were found in all rows of the part.
 * Accuracy: distances are those of vesica_nearest_f64, bit for bit.
 */
VESICA_API int64_t vesica_join_nearest_f64(const vesica_shapes_f64 *sets_a, int32_t set_count_a, const void *index_b,
                                           const vesica_shapes_f64 *sets_b, int32_t set_count_b, int64_t k,
                                           double within, int64_t part, int64_t parts, int64_t *out, double *distance);

/* ---- float ---- */

/** As vesica_index_build_f64. */
VESICA_API int64_t vesica_index_build_f32(const vesica_shapes_f32 *sets, int32_t set_count, void *index,
                                          int64_t index_size, void *scratch, int64_t scratch_size);
/** As vesica_index_step_f64. */
VESICA_API int64_t vesica_index_step_f32(int32_t step, int64_t part, int64_t parts, const vesica_shapes_f32 *sets,
                                         int32_t set_count, void *index, int64_t index_size, void *scratch,
                                         int64_t scratch_size);
/** As vesica_index_select_f64. */
VESICA_API int64_t vesica_index_select_f32(const void *index, const vesica_shapes_f32 *sets, int32_t set_count,
                                           const vesica_shapes_f32 *one, int64_t *out, int64_t capacity,
                                           int64_t *state);
/** As vesica_join_f64. */
VESICA_API int64_t vesica_join_f32(int32_t query, const void *index_a, const vesica_shapes_f32 *sets_a,
                                   int32_t set_count_a, const void *index_b, const vesica_shapes_f32 *sets_b,
                                   int32_t set_count_b, int64_t part, int64_t parts, void *scratch,
                                   int64_t scratch_size, int64_t *out_a, int64_t *out_b, int64_t capacity,
                                   int64_t *state);
/** As vesica_join_within_f64. */
VESICA_API int64_t vesica_join_within_f32(const void *index_a, const vesica_shapes_f32 *sets_a, int32_t set_count_a,
                                          const void *index_b, const vesica_shapes_f32 *sets_b, int32_t set_count_b,
                                          float distance, int64_t part, int64_t parts, int64_t *out_a,
                                          int64_t *out_b, int64_t capacity, int64_t *state);
/** As vesica_index_nearest_f64. */
VESICA_API int64_t vesica_index_nearest_f32(const void *index, const vesica_shapes_f32 *sets, int32_t set_count,
                                            const vesica_shapes_f32 *one, int64_t k, float within, int64_t *out,
                                            float *distance);
/** As vesica_join_nearest_f64. */
VESICA_API int64_t vesica_join_nearest_f32(const vesica_shapes_f32 *sets_a, int32_t set_count_a, const void *index_b,
                                           const vesica_shapes_f32 *sets_b, int32_t set_count_b, int64_t k,
                                           float within, int64_t part, int64_t parts, int64_t *out, float *distance);

#ifdef __cplusplus
}
#endif

#endif /* VESICA_INDEX_H */
