// SPDX-License-Identifier: Apache-2.0
#define _POSIX_C_SOURCE 200809L
#include "operand.h"

#include <stdlib.h>

void* aligned_memory(int64_t bytes) {
  void* memory;
  return bytes >= 0 && posix_memalign(&memory, 64, (size_t)bytes) == 0 ? memory : NULL;
}

int build_operand(const struct shapes* shapes, struct operand* operand) {
  int64_t index_size, scratch_size, built = -1;
  void* scratch;
  operand->items = good_shapes(shapes);
  index_size = vesica_index_size(operand->items);
  scratch_size = vesica_index_scratch(operand->items);
  operand->places = malloc((size_t)operand->items * sizeof(int64_t) + 1);
  operand->index = aligned_memory(index_size);
  scratch = aligned_memory(scratch_size);
  if (operand->places && operand->index && scratch) {
    operand->set_count = view_shapes(shapes, operand->sets, operand->places);
    built =
        vesica_index_build_f64(operand->sets, operand->set_count, operand->index, index_size, scratch, scratch_size);
  }
  free(scratch);
  return built >= 0;
}

void free_operand(struct operand* operand) {
  free(operand->index);
  free(operand->places);
}
