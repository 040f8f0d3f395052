// SPDX-License-Identifier: Apache-2.0
/// Two indexes and their join, divided among threads. The library starts none: it answers a part of a question, and
/// each_part() hands the parts out. The bytes and the pairs, in their order, are those of one thread.
#include <stdio.h>
#include <stdlib.h>
#include <vesica.h>

#include "each_part.h"

static void require(int holds, const char* what) {
  if (holds) return;
  fprintf(stderr, "%s\n", what);
  exit(1);
}

static void* memory(int64_t bytes) {
  void* const block = aligned_alloc(64, (size_t)(bytes + 63) / 64 * 64);
  require(block != NULL, "no memory");
  return block;
}

/* More parts than threads, as some take longer than others. */
static int64_t parts_for(int threads) { return threads == 1 ? 1 : 8 * threads; }

/* ---- A build: five steps, one after the other. The parts of a step may run at the same time. ---- */

struct build {
  const vesica_shapes_f64* shapes;
  void *index, *scratch;
  int64_t index_size, scratch_size;
  int32_t step;
  int64_t parts;
  int64_t* codes; /* by each part */
};

static void build_part(int64_t part, void* user) {
  struct build* const b = user;
  b->codes[part] = vesica_index_step_f64(b->step, part, b->parts, b->shapes, 1, b->index, b->index_size, b->scratch,
                                         b->scratch_size);
}

/* The index of some shapes, to be freed. */
static void* build(const vesica_shapes_f64* shapes, int threads) {
  struct build b = {.shapes = shapes,
                    .index_size = vesica_index_size(shapes->count),
                    .scratch_size = vesica_index_scratch(shapes->count)};
  b.index = memory(b.index_size);
  b.scratch = memory(b.scratch_size);
  b.codes = memory(parts_for(threads) * (int64_t)sizeof *b.codes);
  for (b.step = 0; b.step <= 4; b.step++) {
    b.parts = b.step == 0 || b.step == 4 ? 1 : parts_for(threads);
    each_part(threads, b.parts, build_part, &b);
    for (int64_t part = 0; part < b.parts; part++) require(b.codes[part] >= 0, vesica_strerror((int32_t)b.codes[part]));
  }
  free(b.scratch);
  free(b.codes);
  return b.index;
}

/* ---- A join: its parts one after the other are the whole. ---- */

struct pairs {
  int64_t *a, *b, count, room;
};

struct join {
  const vesica_shapes_f64 *shapes_a, *shapes_b;
  const void *index_a, *index_b;
  int64_t parts;
  struct pairs* found; /* by each part */
};

static void join_part(int64_t part, void* user) {
  const struct join* const j = user;
  struct pairs* const out = &j->found[part];
  const int64_t scratch_size = vesica_join_scratch();
  void* const scratch = memory(scratch_size);
  int64_t state[4] = {0, 0, 0, 0};
  while (state[0] != -1) {
    if (out->count == out->room) {
      out->room = out->room ? 2 * out->room : 1024;
      out->a = realloc(out->a, (size_t)out->room * sizeof *out->a);
      out->b = realloc(out->b, (size_t)out->room * sizeof *out->b);
      require(out->a && out->b, "no memory");
    }
    const int64_t n =
        vesica_join_f64(VESICA_JOIN_OVERLAP, j->index_a, j->shapes_a, 1, j->index_b, j->shapes_b, 1, part, j->parts,
                        scratch, scratch_size, out->a + out->count, out->b + out->count, out->room - out->count, state);
    require(n >= 0, vesica_strerror((int32_t)n));
    out->count += n;
  }
  free(scratch);
}

static struct pairs* join(struct join j, int threads) {
  j.parts = parts_for(threads);
  j.found = calloc((size_t)j.parts, sizeof *j.found);
  require(j.found != NULL, "no memory");
  each_part(threads, j.parts, join_part, &j);
  return j.found;
}

/* ---- Turned rectangles and circles, by any number of threads. ---- */

enum { count = 10000 };
static vesica_rect_f64 cars[count];
static vesica_circle_f64 posts[count];

static double next_number(void) {
  static uint64_t state = 1;
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (double)(state >> 40) / 0x1p24;
}

static uint64_t hash(uint64_t seen, int64_t number) { return (seen ^ (uint64_t)number) * 1099511628211u; }

int main(int argc, char** argv) {
  const int threads = argc > 1 ? atoi(argv[1]) : 1;
  require(threads >= 1, "usage: join [THREADS]");
  for (int i = 0; i < count; i++) {
    cars[i] = (vesica_rect_f64){140 * next_number(), 140 * next_number(), 1, next_number(), 0.8, 0.5};
    posts[i] = (vesica_circle_f64){140 * next_number(), 140 * next_number(), 0.4};
  }
  vesica_shapes_f64 a, b;
  vesica_shapes_from_records_f64(VESICA_RECT, count, cars, sizeof *cars, &a);
  vesica_shapes_from_records_f64(VESICA_CIRCLE, count, posts, sizeof *posts, &b);

  void* const index_a = build(&a, threads);
  void* const index_b = build(&b, threads);
  struct pairs* const found = join((struct join){&a, &b, index_a, index_b, 0, NULL}, threads);

  uint64_t bytes = 14695981039346656037u, order = bytes;
  for (int64_t i = 0; i < vesica_index_bytes(index_a); i++) bytes = hash(bytes, ((const unsigned char*)index_a)[i]);
  int64_t pairs = 0;
  for (int64_t part = 0; part < parts_for(threads); part++) {
    for (int64_t i = 0; i < found[part].count; i++) order = hash(hash(order, found[part].a[i]), found[part].b[i]);
    pairs += found[part].count;
    free(found[part].a);
    free(found[part].b);
  }
  printf("%lld pairs, order %016llx, index %016llx\n", (long long)pairs, (unsigned long long)order,
         (unsigned long long)bytes);
  free(found);
  free(index_a);
  free(index_b);
  return 0;
}
