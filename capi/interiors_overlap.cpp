// SPDX-License-Identifier: Apache-2.0
// Apart from overlap, which needs less of the library: with a polygon, insides ask for relations.
#include "overlap_calls.hpp"

int32_t vesica_interiors_overlap_f64(int32_t kind_a, const void* a, int32_t kind_b, const void* b) {
  return vesica::capi::overlap_by_kind<double, vesica::Common::insides>(kind_a, a, kind_b, b);
}

int32_t vesica_interiors_overlap_f32(int32_t kind_a, const void* a, int32_t kind_b, const void* b) {
  return vesica::capi::overlap_by_kind<float, vesica::Common::insides>(kind_a, a, kind_b, b);
}
