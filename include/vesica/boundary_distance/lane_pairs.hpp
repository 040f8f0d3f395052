// SPDX-License-Identifier: Apache-2.0
/// The distance of nested outlines for the pairs that batches run in lanes, apart from two rectangles: one template
/// over double and lanes of double, as nearest/lane_pairs.hpp. What is not settled takes the general way.
#pragma once

#include <vesica/support_minimum/lane_pairs.hpp>

namespace vesica::detail::boundary_distance {

using namespace support_minimum;

template <class A, class B, class V>
VESICA_INLINE LaneAnswer<V> located_inside(const A& outer, const B& inner, const Vector<V>& d, V size,
                                           const ClosestOffsets<V>& f) noexcept {
  const V distance = -rounded(f.distance);
  const auto settled = both(f.settled, distance > V(least_settled) * size);
  return {distance,        outer.cx + f.ax, outer.cy + f.ay,
          inner.cx + f.bx, inner.cy + f.by, both(settled, moderate_pair(outer, inner, d))};
}

/// The second shape strictly inside the first; the first point is the outer one's.
template <class V>
VESICA_INLINE LaneAnswer<V> lane_inside(const Ellipse<V>& outer, const Ellipse<V>& inner, MaskOf<V> idle) noexcept {
  const Vector<V> d = offset(outer.cx, outer.cy, inner.cx, inner.cy);
  const V size = size_of(outer, inner, d);
  return located_inside(outer, inner, d, size, closest_inside(axes(outer), axes(inner), d, size, idle));
}
template <class V>
VESICA_INLINE LaneAnswer<V> lane_inside(const Rect<V>& outer, const Ellipse<V>& inner, MaskOf<V>) noexcept {
  const Vector<V> d = offset(outer.cx, outer.cy, inner.cx, inner.cy);
  return located_inside(outer, inner, d, size_of(outer, inner, d), closest_inside(box(outer), axes(inner), d));
}
template <class V>
VESICA_INLINE LaneAnswer<V> lane_inside(const Ellipse<V>& outer, const Rect<V>& inner, MaskOf<V> idle) noexcept {
  const Vector<V> d = offset(outer.cx, outer.cy, inner.cx, inner.cy);
  const V size = size_of(outer, inner, d);
  return located_inside(outer, inner, d, size, closest_inside(axes(outer), box(inner), d, size, idle));
}

template <class V>
VESICA_INLINE LaneAnswer<V> points_exchanged(const LaneAnswer<V>& c) noexcept {
  return {c.distance, c.bx, c.by, c.ax, c.ay, c.settled};
}

/// The outlines of a and b, one strictly inside the other. For each lane a_inside says if the inner one is a.
template <class V>
VESICA_INLINE LaneAnswer<V> lane_nested(const Ellipse<V>& a, const Ellipse<V>& b, MaskOf<V> a_inside,
                                        MaskOf<V> idle) noexcept {
  const LaneAnswer<V> found = lane_inside(choose(a_inside, b, a), choose(a_inside, a, b), idle);
  return choose(a_inside, points_exchanged(found), found);
}
template <class V>
VESICA_INLINE LaneAnswer<V> lane_nested(const Rect<V>& a, const Ellipse<V>& b, MaskOf<V> a_inside,
                                        MaskOf<V> idle) noexcept {
  const auto b_inside = negated<V>(a_inside), not_a = either(idle, b_inside), not_b = either(idle, a_inside);
  if (all(not_a)) return lane_inside(a, b, idle);
  const LaneAnswer<V> rect_inside = points_exchanged(lane_inside(b, a, not_a));
  return all(not_b) ? rect_inside : choose(a_inside, rect_inside, lane_inside(a, b, not_b));
}

}  // namespace vesica::detail::boundary_distance
