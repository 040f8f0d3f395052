// SPDX-License-Identifier: Apache-2.0
// All pairs of two indexes that are within a distance.
#include <cmath>

#include "index_arguments.hpp"
#include "join/within.hpp"
#include "queries/within.hpp"

namespace {

using namespace vesica::capi;
namespace index = vesica::index;

index::Near near(int32_t kind_a, int32_t kind_b) noexcept { return vesica::queries::within(kind_a, kind_b); }

template <class T>
int64_t join_within(const void* index_a, const CShapesOf<T>* sets_a, int32_t set_count_a, const void* index_b,
                    const CShapesOf<T>* sets_b, int32_t set_count_b, T distance, int64_t part, int64_t parts,
                    int64_t* out_a, int64_t* out_b, int64_t capacity, int64_t* state) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(join_within<T>, index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, distance, part,
                             parts, out_a, out_b, capacity, state);
  if (index_a == nullptr || index_b == nullptr) return VESICA_E_NULL;
  if (capacity > 0 && (out_a == nullptr || out_b == nullptr || state == nullptr)) return VESICA_E_NULL;
  index::Sets a, b;
  const int32_t error =
      first_error(check_indexed<T>(index_a, sets_a, set_count_a, a), check_indexed<T>(index_b, sets_b, set_count_b, b));
  if (error != 0) return error;
  if (std::isnan(distance) || parts < 1 || part < 0 || part >= parts || capacity < 0) return VESICA_E_ARGUMENT;
  const index::JoinWithin join{index_kernels(),         index_a, index_b, a, b, static_cast<double>(distance), near,
                               vesica::polygon::within, part,    parts};
  if (capacity == 0) return index::count_within(join);
  if (!index::within_state_is_sound(join, state)) return VESICA_E_ARGUMENT;
  return index::write_within(join, out_a, out_b, capacity, state);
}

}  // namespace

int64_t vesica_join_within_f64(const void* index_a, const vesica_shapes_f64* sets_a, int32_t set_count_a,
                               const void* index_b, const vesica_shapes_f64* sets_b, int32_t set_count_b,
                               double distance, int64_t part, int64_t parts, int64_t* out_a, int64_t* out_b,
                               int64_t capacity, int64_t* state) {
  return join_within<double>(index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, distance, part, parts, out_a,
                             out_b, capacity, state);
}
int64_t vesica_join_within_f32(const void* index_a, const vesica_shapes_f32* sets_a, int32_t set_count_a,
                               const void* index_b, const vesica_shapes_f32* sets_b, int32_t set_count_b,
                               float distance, int64_t part, int64_t parts, int64_t* out_a, int64_t* out_b,
                               int64_t capacity, int64_t* state) {
  return join_within<float>(index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, distance, part, parts, out_a,
                            out_b, capacity, state);
}
