// SPDX-License-Identifier: Apache-2.0
/// OpenMP: `dynamic`, as some parts take longer than others.
#include "each_part.h"

void each_part(int threads, int64_t parts, void (*task)(int64_t part, void* user), void* user) {
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
  for (int64_t part = 0; part < parts; part++) task(part, user);
}
