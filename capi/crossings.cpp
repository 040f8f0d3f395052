// SPDX-License-Identifier: Apache-2.0
#include <vesica/polygon/crossings.hpp>

#include "query_calls.hpp"

namespace {

using namespace vesica::capi;

template <class T, class CPoint>
int64_t crossings(int32_t kind_a, const void* a, int32_t kind_b, const void* b, CPoint* out, int64_t capacity,
                  int32_t* shared) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((crossings<T, CPoint>), kind_a, a, kind_b, b, out, capacity, shared);
  const int32_t error = check_room(vesica::queries::crossings, kind_a, a, kind_b, b, out, capacity);
  if (error != 0) return error;
  if (!vesica::is_row(kind_a) || !vesica::is_row(kind_b)) {
    vesica::detail::polygon::Room room{out, std::is_same_v<T, float>, capacity};
    const int32_t code = vesica::ask<T>(vesica::queries::crossings, kind_a, a, kind_b, b, &room);
    if (code >= 0 && shared != nullptr) *shared = room.shared ? 1 : 0;
    return code < 0 ? code : room.count;
  }
  vesica::CrossingPoints<T> places;
  const int32_t count = vesica::ask<T>(vesica::queries::crossings, kind_a, a, kind_b, b, &places);
  if (count < 0) return count;
  for (int32_t i = 0; i < count && i < capacity; ++i) out[i] = {places.x[i], places.y[i]};
  if (shared != nullptr) *shared = places.shared;
  return count;
}

}  // namespace

int64_t vesica_crossings_f64(int32_t kind_a, const void* a, int32_t kind_b, const void* b, vesica_point_f64* out,
                             int64_t capacity, int32_t* shared) {
  return crossings<double>(kind_a, a, kind_b, b, out, capacity, shared);
}
int64_t vesica_crossings_f32(int32_t kind_a, const void* a, int32_t kind_b, const void* b, vesica_point_f32* out,
                             int64_t capacity, int32_t* shared) {
  return crossings<float>(kind_a, a, kind_b, b, out, capacity, shared);
}
