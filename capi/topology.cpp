// SPDX-License-Identifier: Apache-2.0
// How the parts of two shapes meet.
#include "queries/topology.hpp"

#include <vesica/de9im/matrix.hpp>
#include <vesica/polygon/intersection.hpp>

#include "query_calls.hpp"
#include "vesica_topology.h"

namespace {

using namespace vesica::capi;
namespace queries = vesica::queries;

static_assert(sizeof(vesica::NineIntersections) == VESICA_DE9IM_SIZE && alignof(vesica::NineIntersections) == 1);

template <class T, class CPoint>
int64_t intersection(int32_t kind_a, const void* a, int32_t kind_b, const void* b, CPoint* out,
                     int64_t capacity) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((intersection<T, CPoint>), kind_a, a, kind_b, b, out, capacity);
  const int32_t error = check_room(queries::intersection, kind_a, a, kind_b, b, out, capacity);
  if (error != 0) return error;
  if (!vesica::is_row(kind_a) || !vesica::is_row(kind_b)) {
    vesica::detail::polygon::RegionRoom room{out, std::is_same_v<T, float>, capacity};
    const int32_t code = vesica::ask<T>(queries::intersection, kind_a, a, kind_b, b, &room);
    return code < 0 ? code : room.count;
  }
  vesica::SharedRegion<T> region;
  const int32_t count = vesica::ask<T>(queries::intersection, kind_a, a, kind_b, b, &region);
  for (int32_t i = 0; i < count && i < capacity; ++i) out[i] = {region.at[2 * i], region.at[2 * i + 1]};
  return count;
}

}  // namespace

int32_t vesica_de9im_match(const char* matrix, const char* pattern) {
  return matrix == nullptr || pattern == nullptr ? VESICA_E_NULL : vesica::de9im_match(matrix, pattern);
}

#define VESICA_TOPOLOGY(scalar, T)                                                                            \
  int32_t vesica_de9im_##scalar(int32_t kind_a, const void* a, int32_t kind_b, const void* b, char* matrix) { \
    VESICA_DEFAULT_ENVIRONMENT(vesica_de9im_##scalar, kind_a, a, kind_b, b, matrix);                          \
    return answer<T>(queries::de9im, kind_a, a, kind_b, b, matrix);                                           \
  }                                                                                                           \
  int64_t vesica_intersection_##scalar(int32_t kind_a, const void* a, int32_t kind_b, const void* b,          \
                                       vesica_point_##scalar* out, int64_t capacity) {                        \
    return intersection<T>(kind_a, a, kind_b, b, out, capacity);                                              \
  }

VESICA_TOPOLOGY(f64, double)
VESICA_TOPOLOGY(f32, float)
