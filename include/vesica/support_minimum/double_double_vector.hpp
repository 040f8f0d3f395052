// SPDX-License-Identifier: Apache-2.0
/// Vectors of double-doubles, and their products: for the few sums of support functions whose terms cancel.
#pragma once

#include <vesica/arithmetic/double_double.hpp>

namespace vesica::detail::support_minimum {

using namespace arithmetic;

template <class V>
struct DoubleDoubleVector {
  FastDoubleDouble<V> x, y;
};

/// Products of exact vectors, and of an exact one with another.
template <class V>
VESICA_INLINE FastDoubleDouble<V> dot(V ux, V uy, V vx, V vy) noexcept {
  return arithmetic::product(ux, vx) + arithmetic::product(uy, vy);
}
template <class V>
VESICA_INLINE FastDoubleDouble<V> cross(V ux, V uy, V vx, V vy) noexcept {
  return arithmetic::product(ux, vy) - arithmetic::product(uy, vx);
}
template <class V>
VESICA_INLINE FastDoubleDouble<V> dot(V ux, V uy, const DoubleDoubleVector<V>& v) noexcept {
  return v.x * ux + v.y * uy;
}
template <class V>
VESICA_INLINE FastDoubleDouble<V> cross(V ux, V uy, const DoubleDoubleVector<V>& v) noexcept {
  return v.y * ux - v.x * uy;
}

}  // namespace vesica::detail::support_minimum
