// SPDX-License-Identifier: Apache-2.0
#include <vesica/boundary_distance.hpp>

#include "pair_output.hpp"
#include "vesica.h"

namespace {

struct BoundaryDistanceQuery {
  template <class A, class B, class Out>
  static int32_t answer(const A& a, const B& b, Out& out) noexcept {
    vesica::ClosestPoints<decltype(out.distance)> found;
    const int32_t error = vesica::boundary_distance_or_error(a, b, found);
    if (error == 0) out = {found.distance, found.ax, found.ay, found.bx, found.by};
    return error;
  }
};

}  // namespace

int32_t vesica_boundary_distance_f64(int32_t kind_a, const double* numbers_a, int32_t kind_b, const double* numbers_b,
                                     vesica_closest_points_f64* out) {
  return vesica::capi::output_by_kind<BoundaryDistanceQuery>(kind_a, numbers_a, kind_b, numbers_b, out);
}
int32_t vesica_boundary_distance_f32(int32_t kind_a, const float* numbers_a, int32_t kind_b, const float* numbers_b,
                                     vesica_closest_points_f32* out) {
  return vesica::capi::output_by_kind<BoundaryDistanceQuery>(kind_a, numbers_a, kind_b, numbers_b, out);
}
