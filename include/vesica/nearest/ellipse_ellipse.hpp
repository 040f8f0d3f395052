// SPDX-License-Identifier: Apache-2.0
/// Two disjoint ellipses: the distance along the normal in which they are farthest apart.
#pragma once

#include <vesica/nearest/closest_offsets.hpp>

namespace vesica::detail::nearest {

/// d from a's centre to b's. Half lengths must be positive. steps: how many the search took, which tests look at.
template <class V>
VESICA_INLINE ClosestOffsets<V> ellipse_ellipse(const Axes<V>& a, const Axes<V>& b, const Vector<V>& d, V size,
                                                int& steps) noexcept {
  return closest_offsets(two_ellipses(a, b), d, size, steps);
}

}  // namespace vesica::detail::nearest
