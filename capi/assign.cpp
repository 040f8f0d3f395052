// SPDX-License-Identifier: Apache-2.0
// Greedy assignment.
#include "detection/assign.hpp"

#include "index_arguments.hpp"
#include "vesica_detection.h"

namespace {

using namespace vesica::capi;
namespace detection = vesica::detection;

template <class T>
int64_t assign(const detection::Entries<T>& entries, void* scratch, int64_t scratch_size, int64_t* chosen) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(assign<T>, entries, scratch, scratch_size, chosen);
  const bool has_all = entries.row != nullptr && entries.column != nullptr && entries.value != nullptr &&
                       scratch != nullptr && chosen != nullptr;
  if (entries.count != 0 && !has_all) return VESICA_E_NULL;
  const int64_t needed = vesica_assign_greedy_scratch(entries.count, entries.rows, entries.columns);
  if (needed < 0 || !are_inside(entries)) return VESICA_E_ARGUMENT;
  if (entries.count == 0) return 0;
  if (scratch_size < needed || !aligned(scratch, 8)) return VESICA_E_ARGUMENT;
  return detection::assign_greedily(entries, scratch, chosen);
}

}  // namespace

int64_t vesica_assign_greedy_scratch(int64_t count, int64_t count_a, int64_t count_b) {
  for (const int64_t n : {count, count_a, count_b}) {
    if (n < 0 || n > vesica::index::most_items) return VESICA_E_ARGUMENT;
  }
  return detection::assignment_bytes(count, count_a, count_b);
}

#define VESICA_ASSIGN(scalar, T)                                                                               \
  int64_t vesica_assign_greedy_##scalar(const int64_t* a, const int64_t* b, const T* values, int64_t count,    \
                                        int64_t count_a, int64_t count_b, void* scratch, int64_t scratch_size, \
                                        int64_t* chosen) {                                                     \
    return assign<T>({a, b, values, count, count_a, count_b}, scratch, scratch_size, chosen);                  \
  }

VESICA_ASSIGN(f64, double)
VESICA_ASSIGN(f32, float)
