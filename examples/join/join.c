// SPDX-License-Identifier: Apache-2.0
#include "join.h"

#include <stdlib.h>

#include "progress.h"

// Parts take about equal work, so the number of finished parts measures progress.
enum { part_count = 64, room = 4096 };

struct step {
  int32_t query;
  int backwards;  // first and second change places
  int64_t part;
  void* scratch;
};

static int64_t call(struct join* join, const struct step* step, int64_t* first, int64_t* second, int64_t* state) {
  const double begin = seconds();
  const int64_t found = vesica_join_f64(step->query, join->a->index, join->a->sets, join->a->set_count, join->b->index,
                                        join->b->sets, join->b->set_count, step->part, part_count, step->scratch,
                                        vesica_join_scratch(), first, second, first ? room : 0, state);
  join->seconds += seconds() - begin;
  if (found > 0) join->pairs += found;
  if (found < 0) join->error = (int32_t)found;
  return found;
}

static void write_pair(const struct join* join, int backwards, int64_t a, int64_t b) {
  long long first = join->a->places[a], second = join->b->places[b];
  // Items are numbered kind by kind, so the lower item may have the higher number in the file.
  const int ordered = join->a != join->b || join->query == VESICA_JOIN_CONTAINS || join->query == VESICA_JOIN_INSIDE;
  if (ordered ? backwards : first > second) {
    const long long kept = first;
    first = second;
    second = kept;
  }
  fprintf(join->out, "%lld,%lld\n", first, second);
}

static int run_part(struct join* join, const struct step* step) {
  static int64_t first[room], second[room];
  int64_t state[4] = {0, 0, 0, 0};
  if (!join->out) return call(join, step, NULL, NULL, NULL) >= 0;
  while (state[0] != -1) {
    const int64_t found = call(join, step, first, second, state);
    if (found < 0 || ferror(join->out)) return 0;
    for (int64_t i = 0; i < found; i++) write_pair(join, step->backwards, first[i], second[i]);
  }
  return 1;
}

static int run_parts(struct join* join, int32_t query, int backwards) {
  struct step step = {query, backwards, 0, aligned_memory(vesica_join_scratch())};
  int good = step.scratch != NULL;
  for (; good && step.part < part_count; step.part++) {
    show_progress("joining", (double)step.part / part_count);
    good = run_part(join, &step);
  }
  free(step.scratch);
  return good;
}

int run_join(struct join* join) {
  const int both_ways =
      join->a == join->b && (join->query == VESICA_JOIN_CONTAINS || join->query == VESICA_JOIN_INSIDE);
  join->pairs = 0;
  join->seconds = 0;
  if (!run_parts(join, join->query, 0)) return 0;
  // The library gives pairs a < b of one index: which of them holds the other is two questions.
  return !both_ways || run_parts(join, VESICA_JOIN_CONTAINS + VESICA_JOIN_INSIDE - join->query, 1);
}
