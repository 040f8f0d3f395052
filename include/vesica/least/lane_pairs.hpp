// SPDX-License-Identifier: Apache-2.0
/// Depth and the distance of nested outlines for the pairs that batches run in lanes, apart from two rectangles: one
/// template over double and lanes of double, as nearest/lane_pairs.hpp. What is not settled takes the general way.
#pragma once

#include <vesica/least/box_ellipse.hpp>
#include <vesica/nearest/lane_pairs.hpp>

namespace vesica::least {

/// Below this share of the sizes a depth or a distance may be 0, or its direction is of few digits.
inline constexpr double least_settled = 0x1p-46;

template <class V>
VESICA_INLINE Ellipse<V> as_ellipse(const Circle<V>& c) noexcept {
  return {c.cx, c.cy, V(1.0), V(0.0), c.r, c.r};
}
template <class V>
VESICA_INLINE const Ellipse<V>& as_ellipse(const Ellipse<V>& e) noexcept {
  return e;
}

template <class V>
VESICA_INLINE V extent(V ux, V uy, V a, V b) noexcept {
  return (abs(ux) + abs(uy)) * (a + b);
}
template <class V>
VESICA_INLINE V extent(const Ellipse<V>& e) noexcept {
  return extent(e.ux, e.uy, e.a, e.b);
}
template <class V>
VESICA_INLINE V extent(const Rect<V>& r) noexcept {
  return extent(r.ux, r.uy, r.hx, r.hy);
}

/// At least the scale that error bounds speak of, at most some ten times that.
template <class A, class B, class V>
VESICA_INLINE V size_of(const A& a, const B& b, const Vector<V>& d) noexcept {
  return (extent(a) + extent(b)) + (abs(d.x.high) + abs(d.y.high));
}
template <class A, class B, class V>
VESICA_INLINE MaskOf<V> moderate_pair(const A& a, const B& b, const Vector<V>& d) noexcept {
  return both(moderate(d), both(moderate(a), moderate(b)));
}

/// How far b is to be moved and along which unit vector, where settled.
template <class V>
struct LaneDepth {
  V depth, x, y;
  MaskOf<V> settled;
};

/// Whether the pair is to be exchanged, so that (a, b) and (b, a) do the same work: by the ellipses' numbers, equal
/// ones by the sign of their offset.
template <class V>
VESICA_INLINE MaskOf<V> out_of_order(const Ellipse<V>& a, const Ellipse<V>& b, const Vector<V>& d) noexcept {
  const V first[] = {a.a, a.b, a.ux, a.uy, V(0.0), V(0.0)}, second[] = {b.a, b.b, b.ux, b.uy, d.x.high, d.y.high};
  auto greater = first[5] > second[5];
  for (int i = 4; i >= 0; --i) greater = either(first[i] > second[i], and_not(greater, first[i] < second[i]));
  return greater;
}

template <class V>
VESICA_INLINE Ellipse<V> choose(MaskOf<V> m, const Ellipse<V>& yes, const Ellipse<V>& no) noexcept {
  return {select(m, yes.cx, no.cx), select(m, yes.cy, no.cy), select(m, yes.ux, no.ux),
          select(m, yes.uy, no.uy), select(m, yes.a, no.a),   select(m, yes.b, no.b)};
}

/// idle: lanes that are not asked for, whatever they then answer.
template <class V>
VESICA_INLINE LaneDepth<V> lane_depth(const Ellipse<V>& a, const Ellipse<V>& b, MaskOf<V> idle) noexcept {
  const V zero(0.0), one(1.0);
  const auto exchange = out_of_order(a, b, offset(a.cx, a.cy, b.cx, b.cy));
  const Ellipse<V> first = choose(exchange, b, a), second = choose(exchange, a, b);
  const Vector<V> d = offset(first.cx, first.cy, second.cx, second.cy);
  const V size = size_of(first, second, d);
  const ClosestOffsets<V> f = deepest(axes(first), axes(second), d, size, idle);
  const V depth = -rounded(f.distance), sign = select(exchange, -one, one);
  const auto settled = both(f.settled, depth > V(least_settled) * size);
  return {depth, zero + sign * f.nx, zero + sign * f.ny, both(settled, moderate_pair(first, second, d))};
}
template <class V>
VESICA_INLINE LaneDepth<V> lane_depth(const Circle<V>& a, const Ellipse<V>& b, MaskOf<V> idle) noexcept {
  return lane_depth(as_ellipse(a), b, idle);
}
template <class V>
VESICA_INLINE LaneDepth<V> lane_depth(const Rect<V>& a, const Ellipse<V>& b, MaskOf<V> idle) noexcept {
  const V zero(0.0);
  const Vector<V> d = offset(a.cx, a.cy, b.cx, b.cy);
  const V size = size_of(a, b, d);
  const BoxEllipse<V> f = deepest(box(a), axes(b), d, size, idle);
  const V depth = -rounded(f.distance);
  const auto settled = both(f.settled, depth > V(least_settled) * size);
  return {depth, zero + f.nx, zero + f.ny, both(settled, moderate_pair(a, b, d))};
}

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

/// The outlines of a and b, of which one is strictly inside the other: which one a mask tells, for each lane.
template <template <class> class A, class V>
VESICA_INLINE LaneAnswer<V> lane_nested(const A<V>& a, const Ellipse<V>& b, MaskOf<V> a_inside, MaskOf<V> idle) noexcept {
  const Ellipse<V> e = as_ellipse(a);
  const LaneAnswer<V> found = lane_inside(choose(a_inside, b, e), choose(a_inside, e, b), idle);
  return vesica::detail::nearest::choose(a_inside, points_exchanged(found), found);
}
template <class V>
VESICA_INLINE LaneAnswer<V> lane_nested(const Rect<V>& a, const Ellipse<V>& b, MaskOf<V> a_inside,
                                      MaskOf<V> idle) noexcept {
  const auto b_inside = negated<V>(a_inside), not_a = either(idle, b_inside), not_b = either(idle, a_inside);
  if (all(not_a)) return lane_inside(a, b, idle);
  const LaneAnswer<V> rect_inside = points_exchanged(lane_inside(b, a, not_a));
  return all(not_b) ? rect_inside : vesica::detail::nearest::choose(a_inside, rect_inside, lane_inside(a, b, not_b));
}

}  // namespace vesica::least
