// SPDX-License-Identifier: Apache-2.0
/// Point against point: the same location. Comparisons alone are exact.
#pragma once

#include <vesica/contact.hpp>
#include <vesica/filter/comparison.hpp>

namespace vesica::detail::overlap {

using namespace lane;

template <class V>
VESICA_INLINE constexpr auto filter(const Point<V>& a, const Point<V>& b) noexcept {
  return filter::compared(filter::all_finite(a.x, a.y, b.x, b.y), both(a.x == b.x, a.y == b.y));
}

#if VESICA_HAS_TWO_DOUBLES
VESICA_INLINE auto filter(const Point<double>& a, const Point<double>& b) noexcept {
  const TwoDoubles p(a.x, a.y), q(b.x, b.y);
  return filter::DecidedVerdict<bool>{in_both(p == q), in_both((p - p) + (q - q) == TwoDoubles(0.0))};
}
#endif

constexpr int contact(const Point<double>& a, const Point<double>& b, Common) noexcept {
  return filter<double>(a, b).overlap ? -1 : 1;
}

}  // namespace vesica::detail::overlap
