// SPDX-License-Identifier: Apache-2.0
/// One side of a join: shapes of a file, and the index over them.
#ifndef OPERAND_H
#define OPERAND_H

#include "shapes.h"

struct operand {
  vesica_shapes_f64 sets[kind_count];
  int32_t set_count;
  int64_t items;
  int64_t* places;  ///< the number in the file of each item
  void* index;
};

/// Memory aligned as an index and scratch must be, or NULL. `bytes` may be a negative error of the library's.
void* aligned_memory(int64_t bytes);

/// Builds the index of the shapes, which must outlive it. Returns 1, or 0 where memory is short or shapes are too many.
int build_operand(const struct shapes* shapes, int threads, struct operand* operand);

void free_operand(struct operand* operand);

#endif
