// SPDX-License-Identifier: Apache-2.0
#include <vesica/crossings.hpp>

#include "pair_output.hpp"
#include "vesica.h"

namespace {

struct CrossingsQuery {
  template <class A, class B, class T>
  static int32_t answer(const A& a, const B& b, vesica::CrossingPoints<T>& out) noexcept {
    return vesica::crossings_or_error(a, b, out);
  }
};

/// The C struct is the core's, byte for byte; it is copied, for the two are not one type.
template <class T, class Out>
int32_t crossings_by_kind(int32_t kind_a, const T* a, int32_t kind_b, const T* b, Out* out) noexcept {
  static_assert(sizeof(Out) == sizeof(vesica::CrossingPoints<T>));
  vesica::CrossingPoints<T> found;
  const int32_t count =
      vesica::capi::output_by_kind<CrossingsQuery>(kind_a, a, kind_b, b, out == nullptr ? nullptr : &found);
  if (count >= 0) std::memcpy(out, &found, sizeof found);
  return count;
}

}  // namespace

int32_t vesica_crossings_f64(int32_t kind_a, const double* numbers_a, int32_t kind_b, const double* numbers_b,
                             vesica_crossing_points_f64* out) {
  return crossings_by_kind(kind_a, numbers_a, kind_b, numbers_b, out);
}
int32_t vesica_crossings_f32(int32_t kind_a, const float* numbers_a, int32_t kind_b, const float* numbers_b,
                             vesica_crossing_points_f32* out) {
  return crossings_by_kind(kind_a, numbers_a, kind_b, numbers_b, out);
}
