// SPDX-License-Identifier: Apache-2.0
#define _POSIX_C_SOURCE 200809L
#include "operand.h"

#include <stdlib.h>

#include "work.h"

enum { first_step = 0, last_step = 4, step_parts = 64 };

void* aligned_memory(int64_t bytes) {
  void* memory;
  return bytes >= 0 && posix_memalign(&memory, 64, (size_t)bytes) == 0 ? memory : NULL;
}

struct build {
  struct operand* operand;
  int32_t step;
  int64_t parts;
  void* scratch;
  int64_t index_size, scratch_size;
  int64_t result;  // of the only part
};

static void run_step(void* context, int64_t part) {
  struct build* const b = context;
  const int64_t result = vesica_index_step_f64(b->step, part, b->parts, b->operand->sets, b->operand->set_count,
                                               b->operand->index, b->index_size, b->scratch, b->scratch_size);
  if (b->parts == 1) b->result = result;
}

// Returns as vesica_index_build_f64, which makes the same bytes.
static int64_t run_steps(struct build* b, int threads) {
  for (b->step = first_step; b->step <= last_step; b->step++) {
    b->parts = b->step == first_step || b->step == last_step ? 1 : step_parts;
    run_parts(threads, "indexing", b->parts, run_step, b);
  }
  return b->result;
}

int build_operand(const struct shapes* shapes, int threads, struct operand* operand) {
  struct build build = {operand, 0, 0, NULL, 0, 0, -1};
  int64_t built = -1;
  operand->items = good_shapes(shapes);
  build.index_size = vesica_index_size(operand->items);
  build.scratch_size = vesica_index_scratch(operand->items);
  operand->places = malloc((size_t)operand->items * sizeof(int64_t) + 1);
  operand->index = aligned_memory(build.index_size);
  build.scratch = aligned_memory(build.scratch_size);
  if (operand->places && operand->index && build.scratch) {
    operand->set_count = view_shapes(shapes, operand->sets, operand->places);
    built = run_steps(&build, threads);
  }
  free(build.scratch);
  return built >= 0;
}

void free_operand(struct operand* operand) {
  free(operand->index);
  free(operand->places);
}
