// SPDX-License-Identifier: Apache-2.0
#include <vesica/crossings.hpp>

#include "environment.hpp"
#include "query.hpp"
#include "vesica.h"

namespace {

template <class T, class Out>
int32_t crossings(int32_t kind_a, const void* a, int32_t kind_b, const void* b, Out* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((crossings<T, Out>), kind_a, a, kind_b, b, out);
  static_assert(sizeof(Out) == sizeof(vesica::CrossingPoints<T>));
  if (out == nullptr) return VESICA_E_NULL;
  return vesica::ask<T>(vesica::queries::crossings, kind_a, a, kind_b, b, out);
}

}  // namespace

int32_t vesica_crossings_f64(int32_t kind_a, const void* a, int32_t kind_b, const void* b,
                             vesica_crossing_points_f64* out) {
  return crossings<double>(kind_a, a, kind_b, b, out);
}
int32_t vesica_crossings_f32(int32_t kind_a, const void* a, int32_t kind_b, const void* b,
                             vesica_crossing_points_f32* out) {
  return crossings<float>(kind_a, a, kind_b, b, out);
}
