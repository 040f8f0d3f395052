// SPDX-License-Identifier: Apache-2.0
#include <vesica/crossings.hpp>

#include "query.hpp"
#include "vesica.h"

using Places = vesica::CrossingPoints<double>;

int32_t vesica_crossings_f64(int32_t kind_a, const double* numbers_a, int32_t kind_b, const double* numbers_b,
                             vesica_crossing_points_f64* out) {
  static_assert(sizeof(*out) == sizeof(Places));
  if (out == nullptr) return VESICA_E_NULL;
  return vesica::ask(vesica::queries::crossings, kind_a, numbers_a, kind_b, numbers_b, out);
}

int32_t vesica_crossings_f32(int32_t kind_a, const float* numbers_a, int32_t kind_b, const float* numbers_b,
                             vesica_crossing_points_f32* out) {
  if (out == nullptr) return VESICA_E_NULL;
  Places places;
  const int32_t error = vesica::ask_widened(vesica::queries::crossings, kind_a, numbers_a, kind_b, numbers_b, &places);
  if (error < 0) return error;
  vesica::CrossingPoints<float> rounded;
  const int32_t count = vesica::detail::crossings::store(places, rounded);
  static_assert(sizeof(*out) == sizeof rounded);
  if (count >= 0) std::memcpy(out, &rounded, sizeof rounded);
  return count;
}
