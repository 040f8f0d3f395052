// SPDX-License-Identifier: Apache-2.0
/// Depth for the pairs that batches run in lanes, apart from two rectangles: one template over double and lanes of
/// double, as nearest/lane_pairs.hpp. What is not settled takes the general way.
#pragma once

#include <vesica/support_minimum/lane_pairs.hpp>

namespace vesica::detail::depth {

using namespace support_minimum;

/// How far b is to be moved and along which unit vector, where settled.
template <class V>
struct LaneDepth {
  V depth, x, y;
  MaskOf<V> settled;
};

/// True if the pair is to be exchanged, so that (a, b) and (b, a) do the same work: by the ellipses' numbers, equal
/// ones by the sign of their offset.
template <class V>
VESICA_INLINE MaskOf<V> out_of_order(const Ellipse<V>& a, const Ellipse<V>& b, const Vector<V>& d) noexcept {
  const V first[] = {a.a, a.b, a.ux, a.uy, V(0.0), V(0.0)}, second[] = {b.a, b.b, b.ux, b.uy, d.x.high, d.y.high};
  auto greater = first[5] > second[5];
  for (int i = 4; i >= 0; --i) greater = either(first[i] > second[i], and_not(greater, first[i] < second[i]));
  return greater;
}

/// An offset of 0 has no sign: the sign of a stored 0 must not choose the direction.
template <class V>
VESICA_INLINE Vector<V> without_signs_of_zero(const Vector<V>& d) noexcept {
  const V zero(0.0);
  return {{zero + d.x.high, d.x.low}, {zero + d.y.high, d.y.low}};
}

/// idle: lanes that are not asked for, whatever they then answer.
template <class V>
VESICA_INLINE LaneDepth<V> lane_depth(const Ellipse<V>& a, const Ellipse<V>& b, MaskOf<V> idle) noexcept {
  const V zero(0.0), one(1.0);
  const auto exchange = out_of_order(a, b, offset(a.cx, a.cy, b.cx, b.cy));
  const Ellipse<V> first = choose(exchange, b, a), second = choose(exchange, a, b);
  const Vector<V> d = without_signs_of_zero(offset(first.cx, first.cy, second.cx, second.cy));
  const V size = size_of(first, second, d);
  const ClosestOffsets<V> f = deepest(axes(first), axes(second), d, size, idle);
  const V depth = -rounded(f.distance), sign = select(exchange, -one, one);
  const auto settled = both(f.settled, depth > V(least_settled) * size);
  return {depth, zero + sign * f.nx, zero + sign * f.ny, both(settled, moderate_pair(first, second, d))};
}
template <class V>
VESICA_INLINE LaneDepth<V> lane_depth(const Rect<V>& a, const Ellipse<V>& b, MaskOf<V> idle) noexcept {
  const V zero(0.0);
  const Vector<V> d = without_signs_of_zero(offset(a.cx, a.cy, b.cx, b.cy));
  const V size = size_of(a, b, d);
  const BoxEllipse<V> f = deepest(box(a), axes(b), d, size, idle);
  const V depth = -rounded(f.distance);
  const auto settled = both(f.settled, depth > V(least_settled) * size);
  return {depth, zero + f.nx, zero + f.ny, both(settled, moderate_pair(a, b, d))};
}

}  // namespace vesica::detail::depth
