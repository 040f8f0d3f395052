// SPDX-License-Identifier: Apache-2.0
// Areas and ratios with a polygon or a polyline, as answers.hpp has the other queries. Apart from it, since few need
// these.
#pragma once

#include <vesica/ratio.hpp>

#include "polygon/answers.hpp"

namespace vesica::polygon {

std::int32_t area(const Operand& a, const Operand& b, void* out) noexcept;
/// A double for either scalar. Returns 0, error_shape or error_argument.
std::int32_t ratio_of_paths(Ratio which, const Operand& a, const Operand& b, double& out) noexcept;
template <Ratio which>
std::int32_t ratio(const Operand& a, const Operand& b, void* out) noexcept {
  double result;
  const std::int32_t error = ratio_of_paths(which, a, b, result);
  if (error == 0 && a.is_float) *static_cast<float*>(out) = static_cast<float>(result);
  if (error == 0 && !a.is_float) *static_cast<double*>(out) = result;
  return error;
}

}  // namespace vesica::polygon
