// SPDX-License-Identifier: Apache-2.0
// How the parts of two shapes meet.
#include "queries/topology.hpp"

#include <vesica/de9im/matrix.hpp>
#include <vesica/intersection.hpp>

#include "query_calls.hpp"
#include "vesica_topology.h"

namespace {

using vesica::capi::answer;
namespace queries = vesica::queries;

static_assert(sizeof(vesica::NineIntersections) == VESICA_DE9IM_SIZE && alignof(vesica::NineIntersections) == 1);
static_assert(sizeof(vesica::SharedRegion<double>) == 2 * VESICA_MOST_VERTICES * sizeof(double));

}  // namespace

int32_t vesica_de9im_match(const char* matrix, const char* pattern) {
  return matrix == nullptr || pattern == nullptr ? VESICA_E_NULL : vesica::de9im_match(matrix, pattern);
}

#define VESICA_TOPOLOGY(scalar, T)                                                                                     \
  int32_t vesica_de9im_##scalar(int32_t kind_a, const void* a, int32_t kind_b, const void* b, char* matrix) {          \
    VESICA_DEFAULT_ENVIRONMENT(vesica_de9im_##scalar, kind_a, a, kind_b, b, matrix);                                   \
    return answer<T>(queries::de9im, kind_a, a, kind_b, b, matrix);                                                    \
  }                                                                                                                    \
  int32_t vesica_intersection_##scalar(int32_t kind_a, const void* a, int32_t kind_b, const void* b, T vertices[16]) { \
    VESICA_DEFAULT_ENVIRONMENT(vesica_intersection_##scalar, kind_a, a, kind_b, b, vertices);                          \
    return answer<T>(queries::intersection, kind_a, a, kind_b, b, vertices);                                           \
  }

VESICA_TOPOLOGY(f64, double)
VESICA_TOPOLOGY(f32, float)
