// SPDX-License-Identifier: Apache-2.0
#include <vesica/boundary_distance.hpp>

#include "pair_output.hpp"
#include "vesica.h"
#include "widened.hpp"

namespace {

using Points = vesica::ClosestPoints<double>;

struct BoundaryDistanceQuery {
  template <class A, class B>
  static int32_t answer(const A& a, const B& b, Points& out) noexcept {
    return vesica::boundary_distance_or_error(a, b, out);
  }
};

}  // namespace

int32_t vesica_boundary_distance_f64(int32_t kind_a, const double* numbers_a, int32_t kind_b, const double* numbers_b,
                                     vesica_closest_points_f64* out) {
  if (out == nullptr) return VESICA_E_NULL;
  Points found;
  const int32_t error =
      vesica::capi::output_by_kind<BoundaryDistanceQuery>(kind_a, numbers_a, kind_b, numbers_b, &found);
  if (error == 0) *out = {found.distance, found.ax, found.ay, found.bx, found.by};
  return error;
}

int32_t vesica_boundary_distance_f32(int32_t kind_a, const float* numbers_a, int32_t kind_b, const float* numbers_b,
                                     vesica_closest_points_f32* out) {
  return vesica::capi::answer_widened(
      kind_a, numbers_a, kind_b, numbers_b, out, [&](const double* a, const double* b) noexcept {
        Points found;
        const int32_t error = vesica::capi::output_by_kind<BoundaryDistanceQuery>(kind_a, a, kind_b, b, &found);
        if (error != 0) return error;
        vesica::ClosestPoints<float> r;
        if (!vesica::detail::nearest::rounded_to(found, found.distance == 0, r)) return VESICA_E_RANGE;
        *out = {r.distance, r.ax, r.ay, r.bx, r.by};
        return 0;
      });
}
