// SPDX-License-Identifier: Apache-2.0
#include <vesica/depth.hpp>

#include "pair_output.hpp"
#include "vesica.h"
#include "widened.hpp"

namespace {

using Penetration = vesica::Penetration<double>;

struct DepthQuery {
  template <class A, class B>
  static int32_t answer(const A& a, const B& b, Penetration& out) noexcept {
    return vesica::depth_or_error(a, b, out);
  }
};

}  // namespace

int32_t vesica_depth_f64(int32_t kind_a, const double* numbers_a, int32_t kind_b, const double* numbers_b,
                         vesica_penetration_f64* out) {
  if (out == nullptr) return VESICA_E_NULL;
  Penetration found;
  const int32_t error = vesica::capi::output_by_kind<DepthQuery>(kind_a, numbers_a, kind_b, numbers_b, &found);
  if (error == 0) *out = {found.depth, found.x, found.y};
  return error;
}

int32_t vesica_depth_f32(int32_t kind_a, const float* numbers_a, int32_t kind_b, const float* numbers_b,
                         vesica_penetration_f32* out) {
  return vesica::capi::answer_widened(
      kind_a, numbers_a, kind_b, numbers_b, out, [&](const double* a, const double* b) noexcept {
        Penetration found;
        const int32_t error = vesica::capi::output_by_kind<DepthQuery>(kind_a, a, kind_b, b, &found);
        if (error != 0) return error;
        vesica::Penetration<float> r;
        if (!vesica::detail::depth::rounded_to(found, r)) return VESICA_E_RANGE;
        *out = {r.depth, r.x, r.y};
        return 0;
      });
}
