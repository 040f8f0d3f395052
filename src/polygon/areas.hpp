// SPDX-License-Identifier: Apache-2.0
// Areas and ratios with a polygon or a polyline, as answers.hpp has the other queries. Apart from it, since few need
// these.
#pragma once

#include <vesica/polygon/ratio.hpp>

#include "polygon/answers.hpp"

namespace vesica::polygon {

std::int32_t area(const Operand& a, const Operand& b, void* out) noexcept;
/// A double for either scalar. Returns 0, error_shape or error_argument.
std::int32_t ratio_of_paths(Ratio which, const Operand& a, const Operand& b, double& out) noexcept;

/// The same from the areas of two polygons.
std::int32_t area_of_shares(const detail::polygon::PathShares& shares, bool is_float, void* out) noexcept;
std::int32_t ratio_of_shares(Ratio which, const detail::polygon::PathShares& shares, double& out) noexcept;

inline void store_ratio(double ratio, bool is_float, void* out) noexcept {
  if (is_float) {
    *static_cast<float*>(out) = static_cast<float>(ratio);
  } else {
    *static_cast<double*>(out) = ratio;
  }
}
template <Ratio which>
std::int32_t ratio(const Operand& a, const Operand& b, void* out) noexcept {
  double ratio;
  const std::int32_t error = ratio_of_paths(which, a, b, ratio);
  if (error == 0) store_ratio(ratio, a.is_float, out);
  return error;
}
template <Ratio which>
std::int32_t ratio_of_shares(const detail::polygon::PathShares& shares, bool is_float, void* out) noexcept {
  double ratio;
  const std::int32_t error = ratio_of_shares(which, shares, ratio);
  if (error == 0) store_ratio(ratio, is_float, out);
  return error;
}

/// The box of a polygon and its own area. Returns false if it is invalid, has none, or is of unusual magnitude.
bool own_area(const Operand& polygon, detail::polygon::Box& box, double& area) noexcept;

}  // namespace vesica::polygon
