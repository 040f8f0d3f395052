/*
 * Vesica: index and join, for the pairs that overlap among millions of shapes.
 *
 * SPDX-License-Identifier: Apache-2.0
 *
 * vesica.h includes this header, and both belong to one library.
 *
 * An index is a flat block of memory that the caller provides, without pointers. It may be saved, sent, mapped, and
 * read by any number of threads at once. It holds the bounds of shapes and not the shapes: functions that need the
 * shapes take both.
 *
 * An index is built from one or more sets, each an array of shapes of one kind; kinds may differ between sets. Items
 * are numbered through all sets: those of the first set come first, in their order, then those of the next. An index
 * holds at most 64 sets that are not empty, and 2^31 - 1 items. Its bytes depend on the shapes alone, not on the
 * processor, the layout of the arrays or the number of threads. Only the byte order of numbers is the machine's.
 *
 * An index and its scratch memory must be aligned to 64 bytes.
 *
 * A function whose output may exceed the room for it takes a state of four numbers. Set all to 0 before the first call.
 * After a call state[0] is -1 if nothing is left; otherwise the same call continues. A state may be saved or sent.
 *
 * The rules of vesica.h hold. Bytes that are not an index are an error that is checked after NULL pointers and before
 * unknown kinds. Comments have the same parts: Requires, Returns, Errors, Accuracy, Cost, Since.
 */
#ifndef VESICA_INDEX_H
#define VESICA_INDEX_H

#include "vesica.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Constants ---- */

/* Which pairs a join finds: those of item a of one index and item b of another for which this holds. */
#define VESICA_JOIN_OVERLAP 0   /**< a and b overlap, as by vesica_overlap_f64 */
#define VESICA_JOIN_BOUNDS 1    /**< their bounds in the indexes do: all pairs that overlap, and some that do not */
#define VESICA_JOIN_CONTAINS 2  /**< a contains b, as by vesica_contains_f64 */
#define VESICA_JOIN_INSIDE 3    /**< b contains a */
#define VESICA_JOIN_INTERIORS 4 /**< their insides share a point, as by vesica_interiors_overlap_f64 */

/* ---- Memory ----
 * Since: 0.1.
 */

/**
 * How many bytes suffice for an index of `count` shapes, of any kinds?
 * Returns: 17 bytes a shape and 64 KiB. A built index takes fewer, mostly 13 a shape: see vesica_index_bytes.
 * Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).
 */
VESICA_API int64_t vesica_index_size(int64_t count);

/**
 * How many bytes of scratch does building an index of `count` shapes need?
 * Returns: about 17 bytes a shape and 0.3 MiB.
 * Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).
 */
VESICA_API int64_t vesica_index_scratch(int64_t count);

/**
 * How many bytes of scratch does a join need, whatever its indexes?
 * Returns: at most 1 MiB.
 */
VESICA_API int64_t vesica_join_scratch(void);

/* ---- Reading an index. All functions but vesica_index_check verify only its header, and trust the rest. ----
 * Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (not an index's header).
 * Since: 0.1.
 */

/**
 * Are these bytes an index that is safe to read?
 *
 * Call it once for bytes that you did not just build: they may be cut off, damaged, something else, or from a machine
 * of the other byte order. What passes is safe to read; damage of single shapes' places may pass and change answers.
 * Requires: size, the number of readable bytes. The index may be shorter.
 * Returns: 0 if they are.
 * Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (they are not).
 * Cost: it reads all bytes once.
 */
VESICA_API int32_t vesica_index_check(const void *index, int64_t size);

/**
 * How many bytes does a built index take? Save that many.
 * Returns: the bytes, a multiple of 64.
 */
VESICA_API int64_t vesica_index_bytes(const void *index);

/**
 * How many shapes was an index built from?
 * Returns: the number of its items, including invalid shapes.
 */
VESICA_API int64_t vesica_index_count(const void *index);

/**
 * A box around all valid shapes of an index.
 *
 * Two indexes whose boxes are disjoint have no overlapping pairs.
 * Returns: 0.
 * Accuracy: the box is a little larger than the smallest one; a side that overflows is infinite. Without valid shapes
 * min is infinity and max is -infinity.
 */
VESICA_API int32_t vesica_index_bounds(const void *index, vesica_aabb_f64 *out);

/**
 * The items of an index in spatial order: shapes near each other have nearby places in it.
 *
 * A join is faster if the arrays of shapes have this order, as it then reads nearby memory.
 * Requires: out has room for `capacity` items. It may be NULL if that is 0.
 * Returns: how many items there are, without the invalid shapes. The first `capacity` of them are written.
 * Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned, capacity < 0), VESICA_E_INDEX.
 */
VESICA_API int64_t vesica_index_order(const void *index, int64_t *out, int64_t capacity);

/* ---- Building an index, double ----
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a wrong count, size or alignment), VESICA_E_SHAPE.
 * Since: 0.1.
 */

/**
 * Builds the index of some sets of shapes. There may be none; sets may then be NULL.
 *
 * If shapes are invalid, the call returns VESICA_E_SHAPE, and the index is complete without them. When shapes have
 * moved, build it again.
 * Requires: index_size >= vesica_index_size(items) and scratch_size >= vesica_index_scratch(items). The scratch may be
 * reused after the call.
 * Returns: how many bytes of the index are used.
 * Cost: a few times vesica_bounds_many_f64.
 */
VESICA_API int64_t vesica_index_build_f64(const vesica_shapes_f64 *sets, int32_t set_count, void *index,
                                          int64_t index_size, void *scratch, int64_t scratch_size);

/**
 * One part of a build by several threads, in five steps. The bytes are those of vesica_index_build_f64.
 *
 * Steps 0 and 4 have one part. Steps 1, 2 and 3 have as many parts as the caller likes, and these may run at the same
 * time. All parts of a step must end before the next step begins. All other arguments are the same in all calls.
 * Requires: 0 <= step <= 4 and 0 <= part < parts; parts is 1 in steps 0 and 4. The rest is as for the build.
 * Returns: 0; at step 4 what vesica_index_build_f64 returns.
 * Errors: those of vesica_index_build_f64. VESICA_E_ARGUMENT also, with nothing done, if step, part or parts is out of
 * range, if the scratch is not from step 0 of a build that has not ended, if a part of the step before is missing,
 * or if some of this part was done before. A part without shapes (there may be more parts than shapes) has nothing to
 * do: a missing or repeated one is not noticed.
 * Cost: in all as the build: three fifths in step 1; a tenth in step 0, which cannot be divided.
 */
VESICA_API int64_t vesica_index_step_f64(int32_t step, int64_t part, int64_t parts, const vesica_shapes_f64 *sets,
                                         int32_t set_count, void *index, int64_t index_size, void *scratch,
                                         int64_t scratch_size);

/* ---- Questions about one or two indexes, double ----
 * Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid), VESICA_E_ARGUMENT (a number
 * or a size is out of range, a pointer is not aligned, the sets have another number of items than the index, the state
 * is from another function, part, parts or query). Other sets, and states of calls with other shapes or distances, are
 * not noticed: answers are then meaningless.
 * Since: 0.1.
 */

/**
 * Which items of an index does one shape overlap? They come in the index's order.
 *
 * To ask for many shapes, index them too and call vesica_join_f64.
 * Requires: sets are those of the index; or NULL, with set_count 0, to find the items whose bounds meet the shape's.
 * Bounds are those in the index, up to about 2^-15 of the extent of nearby shapes larger than vesica_bounds_f64's.
 * one, an array of count 1. out has room for `capacity` items. With capacity 0, out and state may be NULL.
 * Returns: the number of items written; with capacity 0, how many there are.
 * Accuracy: exact, if there are sets.
 * Cost: a search, and vesica_overlap_f64 for each item whose bounds meet those of the shape.
 */
VESICA_API int64_t vesica_index_select_f64(const void *index, const vesica_shapes_f64 *sets, int32_t set_count,
                                           const vesica_shapes_f64 *one, int64_t *out, int64_t capacity,
                                           int64_t *state);

/**
 * Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
 *
 * If both indexes are the same pointer, pairs are two different items a < b: VESICA_JOIN_CONTAINS then finds
 * pairs whose lower item contains the higher one, _INSIDE the others. Pair i is out_a[i] and out_b[i].
 * The order of pairs depends on the bytes of the indexes and the query alone.
 * The work may be divided into `parts` of about equal work, which may run at the same time, each with its own scratch.
 * The pairs of all parts, one part after the other, are those of a call with part 0 and parts 1.
 * Requires: query is VESICA_JOIN_OVERLAP ... VESICA_JOIN_INTERIORS. sets_a and sets_b are those of the indexes; with
 * VESICA_JOIN_BOUNDS they are ignored. 0 <= part < parts. scratch_size >= vesica_join_scratch(); nothing is kept in the
 * scratch between calls. out_a and out_b have room for `capacity` items. With capacity 0, they and state may be NULL.
 * Returns: the number of pairs written; with capacity 0, how many the whole part has.
 * Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND (also for VESICA_JOIN_CONTAINS and _INSIDE where a set of either
 * side has kinds that vesica_contains_f64 does not take together), VESICA_E_ARGUMENT (an unknown query, a number or a
 * size out of range, a pointer that is not aligned, sets of another number of items, a state from another function).
 * Accuracy: exact for all queries but VESICA_JOIN_BOUNDS.
 * Cost: about twice vesica_overlap_f64 for each shape, and the same for each pair whose bounds meet.
 */
VESICA_API int64_t vesica_join_f64(int32_t query, const void *index_a, const vesica_shapes_f64 *sets_a,
                                   int32_t set_count_a, const void *index_b, const vesica_shapes_f64 *sets_b,
                                   int32_t set_count_b, int64_t part, int64_t parts, void *scratch,
                                   int64_t scratch_size, int64_t *out_a, int64_t *out_b, int64_t capacity,
                                   int64_t *state);

/**
 * All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once: those for
 * which vesica_within_f64 is > 0.
 *
 * If both indexes are the same pointer, pairs are those of two different items a < b. They come in index_a's order.
 * Each part takes about the same number of items of index_a; all else is as for vesica_join_f64.
 * Requires: distance, infinity for all pairs of valid shapes, < 0 for those that overlap at least -distance deep; sets,
 * part, outputs, capacity and state as vesica_join_f64.
 * Returns: the number of pairs written; with capacity 0, how many the whole part has.
 * Errors: those of vesica_join_f64; VESICA_E_ARGUMENT also for a distance that is NaN.
 * Accuracy: as vesica_within_f64; pairs that are VESICA_WITHIN_NEARLY are included.
 * Cost: seven times vesica_join_f64.
 */
VESICA_API int64_t vesica_join_within_f64(const void *index_a, const vesica_shapes_f64 *sets_a, int32_t set_count_a,
                                          const void *index_b, const vesica_shapes_f64 *sets_b, int32_t set_count_b,
                                          double distance, int64_t part, int64_t parts, int64_t *out_a,
                                          int64_t *out_b, int64_t capacity, int64_t *state);

/**
 * Which items of an index are nearest to one shape? The nearest comes first, of equally near ones the lower item.
 *
 * An item that overlaps the shape has distance 0. An item whose distance overflows is not found.
 * Requires: sets are those of the index. one, an array of count 1. k >= 0, and out and distance have room for k each.
 * With k = 0 they may be NULL. within, the largest distance to look for, >= 0 or infinity.
 * Returns: how many items were found and written; with k = 0, how many there are within the distance.
 * Accuracy: distances are those of vesica_nearest_f64, bit for bit.
 * Cost: a search, and vesica_nearest_f64 for a few items more than k, and for all items that overlap the shape, as the
 * lowest come first. Of points and boxes along the axes about k are measured.
 */
VESICA_API int64_t vesica_index_nearest_f64(const void *index, const vesica_shapes_f64 *sets, int32_t set_count,
                                            const vesica_shapes_f64 *one, int64_t k, double within, int64_t *out,
                                            double *distance);

/**
 * Which items of index_b are nearest to each item of sets_a? Row i is out[i * k] ... out[i * k + k - 1].
 *
 * A row is the result of vesica_index_nearest_f64 for item i. If it has fewer than k items, the rest are -1 with
 * distance infinity. If a set is asked for its own neighbours, each item finds itself too, at distance 0, unless k
 * lower items overlap it. If an item of sets_a is invalid, its row holds -1, all other rows are right, and the call
 * returns VESICA_E_SHAPE. Each part takes about the same number of items, and writes only their rows.
 * Requires: sets_b are those of index_b. k >= 1, and out and distance have room for k items a row. If sets_a have no
 * items, they may be NULL. 0 <= part < parts. within, the largest distance to look for, >= 0 or infinity.
 * Returns: how many items were found in all rows of the part.
 * Accuracy: distances are those of vesica_nearest_f64, bit for bit.
 * Cost: vesica_index_nearest_f64 for each item.
 */
VESICA_API int64_t vesica_join_nearest_f64(const vesica_shapes_f64 *sets_a, int32_t set_count_a, const void *index_b,
                                           const vesica_shapes_f64 *sets_b, int32_t set_count_b, int64_t k,
                                           double within, int64_t part, int64_t parts, int64_t *out, double *distance);

/* ---- Boxes about the edges of one large polygon or polyline, double ----
 * Since: 0.1.
 */

/**
 * How many bytes do the boxes of a polygon or a polyline take?
 * Returns: 64 bytes, and about 1.07 for each vertex.
 * Errors: VESICA_E_ARGUMENT (vertices is below 1 or above 2^58).
 */
VESICA_API int64_t vesica_polygon_boxes_size(int64_t vertices);

/**
 * Makes boxes about the edges of a polygon or a polyline that is asked again and again, such as a coast or a zone.
 *
 * They lie in memory of the caller, and may be saved, sent or mapped. Answers are the same bits as without them. The
 * path must be as it was when they were made. Functions of arrays need no such boxes: where one path is asked about
 * many shapes, they are made within the call.
 * Requires: boxes are aligned to 8 bytes. size is at least vesica_polygon_boxes_size of the number of vertices.
 * Returns: 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND (not a polygon or a polyline), VESICA_E_SHAPE, VESICA_E_ARGUMENT (size is less,
 * or the boxes are not aligned).
 * Cost: one pass over the vertices.
 */
VESICA_API int32_t vesica_polygon_boxes_f64(int32_t kind, const void *path, void *boxes, int64_t size);

/**
 * Does a path with boxes overlap another shape? As vesica_overlap_f64, for any kind b.
 * Requires: the boxes are of this path, by a function of the same scalar type.
 * Returns: 1 or 0.
 * Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_INDEX (no boxes of a path with these vertices), VESICA_E_SHAPE.
 */
VESICA_API int32_t vesica_polygon_boxes_overlap_f64(int32_t kind, const void *path, const void *boxes, int64_t size,
                                                    int32_t kind_b, const void *b);

/**
 * The distance of a path with boxes and another shape, and where it is. As vesica_nearest_f64.
 * Requires, Errors: those of vesica_polygon_boxes_overlap_f64; also VESICA_E_RANGE.
 * Returns: 0.
 * Cost: with another polygon or polyline as vesica_nearest_f64, since boxes do not help there.
 */
VESICA_API int32_t vesica_polygon_boxes_nearest_f64(int32_t kind, const void *path, const void *boxes, int64_t size,
                                                    int32_t kind_b, const void *b, vesica_closest_points_f64 *out);

/**
 * Are a path with boxes and another shape at most a distance apart? As vesica_within_f64.
 * Requires, Errors: those of vesica_polygon_boxes_overlap_f64; also VESICA_E_ARGUMENT (distance is NaN) and
 * VESICA_E_NOT_CONVEX.
 * Returns: VESICA_WITHIN_YES, VESICA_WITHIN_NO or VESICA_WITHIN_NEARLY.
 */
VESICA_API int32_t vesica_polygon_boxes_within_f64(int32_t kind, const void *path, const void *boxes, int64_t size,
                                                   int32_t kind_b, const void *b, double distance);

/* ---- The same functions with float in place of double ---- */

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
/** As vesica_polygon_boxes_f64. */
VESICA_API int32_t vesica_polygon_boxes_f32(int32_t kind, const void *path, void *boxes, int64_t size);
/** As vesica_polygon_boxes_overlap_f64. */
VESICA_API int32_t vesica_polygon_boxes_overlap_f32(int32_t kind, const void *path, const void *boxes, int64_t size,
                                                    int32_t kind_b, const void *b);
/** As vesica_polygon_boxes_nearest_f64. */
VESICA_API int32_t vesica_polygon_boxes_nearest_f32(int32_t kind, const void *path, const void *boxes, int64_t size,
                                                    int32_t kind_b, const void *b, vesica_closest_points_f32 *out);
/** As vesica_polygon_boxes_within_f64. */
VESICA_API int32_t vesica_polygon_boxes_within_f32(int32_t kind, const void *path, const void *boxes, int64_t size,
                                                   int32_t kind_b, const void *b, float distance);

#ifdef __cplusplus
}
#endif

#endif /* VESICA_INDEX_H */
