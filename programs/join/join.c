// SPDX-License-Identifier: Apache-2.0
#include "join.h"

#include <math.h>
#include <stdlib.h>

#include "work.h"

// Parts take about equal work, so the number of those that have begun measures progress.
enum { part_count = 64, room = 4096, rows_of_part = 16384 };

// The memory of one part.
struct part {
  int64_t first[room], second[room];
  struct bytes bytes;
};

static int has_order(int32_t query) { return query == VESICA_JOIN_CONTAINS || query == VESICA_JOIN_INSIDE; }

// The library gives pairs a < b of one index: which of them holds the other is two questions.
static int both_ways(const struct join* join) { return join->a == join->b && has_order(join->question.query); }

static void add(struct join* join, int64_t found, int short_of_memory) {
  pthread_mutex_lock(&join->lock);
  if (found > 0) join->pairs += found;
  if (found < 0) join->error = (int32_t)found;
  if (short_of_memory) join->short_of_memory = 1;
  pthread_mutex_unlock(&join->lock);
}

// ---- Pairs ----

static int64_t call(const struct join* join, int32_t query, int64_t number, void* scratch, struct part* part,
                    int64_t* state) {
  const struct operand *const a = join->a, *const b = join->b;
  int64_t* const first = join->output ? part->first : NULL;
  int64_t* const second = join->output ? part->second : NULL;
  const int64_t capacity = join->output ? room : 0;
  if (join->question.has_distance) {
    return vesica_join_within_f64(a->index, a->sets, a->set_count, b->index, b->sets, b->set_count,
                                  join->question.distance, number, part_count, first, second, capacity, state);
  }
  return vesica_join_f64(query, a->index, a->sets, a->set_count, b->index, b->sets, b->set_count, number, part_count,
                         scratch, vesica_join_scratch(), first, second, capacity, state);
}

static int put_pair(const struct join* join, int64_t number, int backwards, struct part* part, int64_t i) {
  const int64_t a = join->a->places[part->first[i]], b = join->b->places[part->second[i]];
  // Items are numbered kind by kind, so the lower item may have the higher number in the file.
  const int ordered = join->a != join->b || has_order(join->question.query);
  const int swaps = ordered ? backwards : a > b;
  return put_row(join->output, number, &part->bytes, swaps ? b : a, swaps ? a : b, NULL);
}

static int64_t find_pairs(const struct join* join, int64_t number, void* scratch, struct part* part) {
  const int backwards = number >= part_count;
  const int32_t query =
      backwards ? VESICA_JOIN_CONTAINS + VESICA_JOIN_INSIDE - join->question.query : join->question.query;
  int64_t state[4] = {0, 0, 0, 0}, pairs = 0;
  if (!join->output) return call(join, query, number % part_count, scratch, part, NULL);
  while (state[0] != -1) {
    const int64_t found = call(join, query, number % part_count, scratch, part, state);
    if (found < 0) return found;
    pairs += found;
    for (int64_t i = 0; i < found; i++) {
      if (!put_pair(join, number, backwards, part, i)) return pairs;
    }
  }
  return pairs;
}

static void run_part(void* context, int64_t number) {
  struct join* const join = context;
  struct bytes bytes = {NULL, 0, 0, 0};
  struct part* const part = malloc(sizeof *part);
  void* const scratch = aligned_memory(vesica_join_scratch());
  if (part) part->bytes = bytes;
  add(join, part && scratch ? find_pairs(join, number, scratch, part) : 0, !part || !scratch);
  if (part) bytes = part->bytes;
  if (join->output) end_part(join->output, number, &bytes);
  free(part);
  free(scratch);
}

static int run_pairs(struct join* join) {
  const int64_t parts = both_ways(join) ? 2 * part_count : part_count;
  if (join->output && !begin_parts(join->output, parts)) return 0;
  run_parts(join->threads, "joining", parts, run_part, join);
  return 1;
}

// ---- Neighbours ----

struct neighbours {
  struct join* join;
  int64_t each;  // of them; one more than are asked for, where each shape finds itself
  int64_t* items;
  double* distances;
};

static void find_neighbours(void* context, int64_t number) {
  const struct neighbours* const n = context;
  const struct operand *const a = n->join->a, *const b = n->join->b;
  const double most = n->join->question.has_distance ? n->join->question.distance : HUGE_VAL;
  const int64_t found = vesica_join_nearest_f64(a->sets, a->set_count, b->index, b->sets, b->set_count, n->each, most,
                                                number, part_count, n->items, n->distances);
  if (found < 0) add(n->join, found, 0);
}

// Takes a shape out of its own neighbours; where so many others overlap it that it is none, the last is one too many.
static int64_t put_neighbours(const struct neighbours* n, int64_t number, struct bytes* bytes, int64_t item) {
  const struct join* const join = n->join;
  int64_t count = 0;
  for (int64_t i = item * n->each; i < (item + 1) * n->each && count < join->question.neighbours; i++) {
    if (n->items[i] < 0 || (join->a == join->b && n->items[i] == item)) continue;
    count++;
    if (join->output &&
        !put_row(join->output, number, bytes, join->a->places[item], join->b->places[n->items[i]], &n->distances[i]))
      break;
  }
  return count;
}

static void put_all_neighbours(void* context, int64_t number) {
  const struct neighbours* const n = context;
  const int64_t items = n->join->a->items, begin = number * rows_of_part;
  const int64_t end = begin + rows_of_part < items ? begin + rows_of_part : items;
  struct bytes bytes = {NULL, 0, 0, 0};
  int64_t count = 0;
  for (int64_t item = begin; item < end; item++) count += put_neighbours(n, number, &bytes, item);
  add(n->join, count, 0);
  if (n->join->output) end_part(n->join->output, number, &bytes);
}

static int run_neighbours(struct join* join) {
  const int64_t items = join->a->items, parts = (items + rows_of_part - 1) / rows_of_part;
  const int64_t all = join->b->items > 1 ? join->b->items : 1;
  const int64_t wanted = join->question.neighbours < all ? join->question.neighbours : all;
  struct neighbours n = {join, wanted + (join->a == join->b), NULL, NULL};
  const size_t rows = (size_t)items * (size_t)n.each;
  int good = items == 0 || (uint64_t)n.each <= SIZE_MAX / 16 / (uint64_t)items;
  if (good) {
    n.items = malloc(rows * sizeof *n.items + 1);
    n.distances = malloc(rows * sizeof *n.distances + 1);
    good = n.items && n.distances && (!join->output || begin_parts(join->output, parts + 1));
  }
  if (good) {
    run_parts(join->threads, "joining", part_count, find_neighbours, &n);
    if (join->error == 0) run_parts(join->threads, "writing", parts, put_all_neighbours, &n);
  }
  free(n.items);
  free(n.distances);
  return good;
}

int run_join(struct join* join) {
  int good = pthread_mutex_init(&join->lock, NULL) == 0;
  join->pairs = 0;
  good = good && (join->question.neighbours > 0 ? run_neighbours(join) : run_pairs(join));
  if (!good) join->short_of_memory = 1;
  return join->error == 0 && !join->short_of_memory && !(join->output && join->output->failed);
}
