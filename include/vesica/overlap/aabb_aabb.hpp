// SPDX-License-Identifier: Apache-2.0
/// AABB against AABB: intervals that meet in both coordinates. Comparisons alone are exact.
#pragma once

#include <vesica/filter/comparison.hpp>

namespace vesica::detail::overlap {

using namespace lane;

template <class V>
VESICA_INLINE constexpr auto filter(const Aabb<V>& a, const Aabb<V>& b) noexcept {
  const auto in_x = both(a.min_x <= b.max_x, b.min_x <= a.max_x);
  const auto in_y = both(a.min_y <= b.max_y, b.min_y <= a.max_y);
  return filter::compared(both(filter::valid_aabb(a), filter::valid_aabb(b)), both(in_x, in_y));
}

constexpr bool exact(const Aabb<double>& a, const Aabb<double>& b) noexcept { return filter(a, b).overlap; }

}  // namespace vesica::detail::overlap
