// SPDX-License-Identifier: Apache-2.0
/// A point outside an ellipse, or a circle: the distance along the normal in which they are farthest apart.
#pragma once

#include <vesica/nearest/closest_offsets.hpp>

namespace vesica::detail::nearest {

/// The distance from a point to an ellipse that it lies outside of, d from the point to the ellipse's centre. Half
/// lengths must be positive. steps: how many the search took, which tests look at.
template <class V>
VESICA_INLINE ClosestOffsets<V> point_ellipse(const Axes<V>& e, const Vector<V>& d, V size, int& steps) noexcept {
  return closest_offsets(one_ellipse(e), d, size, steps);
}

/// A circle is a point that reaches r farther.
template <class V>
VESICA_INLINE ClosestOffsets<V> circle_ellipse(V r, const Axes<V>& e, const Vector<V>& d, V size, int& steps) noexcept {
  ClosestOffsets<V> result = point_ellipse(e, d, size, steps);
  result.ax = r * result.nx;
  result.ay = r * result.ny;
  result.distance = result.distance - Twofold<V>{r, V(0.0)};
  return result;
}

}  // namespace vesica::detail::nearest
