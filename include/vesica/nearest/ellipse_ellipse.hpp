// SPDX-License-Identifier: Apache-2.0
/// Two disjoint ellipses: the distance along the normal in which they are farthest apart.
#pragma once

#include <vesica/nearest/direction.hpp>

namespace vesica::detail::nearest {

template <class V>
VESICA_INLINE TwoEllipses<V> two_ellipses(const Axes<V>& a, const Axes<V>& b) noexcept {
  return {a, b, semi_axes(a), semi_axes(b)};
}

/// d from a's centre to b's. Half lengths must be positive. steps: how many the search took, which tests look at.
template <class V>
VESICA_INLINE ClosestOffsets<V> ellipse_ellipse(const Axes<V>& a, const Axes<V>& b, const Vector<V>& d, V size,
                                                int& steps) noexcept {
  const FoundDirection<V> best = farthest_direction(two_ellipses(a, b), Direction<V>{d.x.high, d.y.high}, size);
  const auto n = normal(factor(best.n.x, best.n.y));
  steps = best.steps;
  ClosestOffsets<V> result = separation(d, n, support(a, n), support(b, n), size);
  result.settled = both(result.settled, best.found);
  return result;
}

}  // namespace vesica::detail::nearest
