// SPDX-License-Identifier: Apache-2.0
/// Box against box, and point against box: separating axes with an error bound.
#pragma once

#include <vesica/filter/box.hpp>
#include <vesica/filter/certain_facts.hpp>

namespace vesica::filter {

/// Axes between 2^-25 and 2^25 long (double: 2^-200 and 2^200): what their products lose by underflow is then
/// negligible beside them.
template <class V>
VESICA_INLINE constexpr auto box_axis_in_range(V squared_length) noexcept {
  return in_range(squared_length, guard_power<V, -50>(), guard_power<V, 50>());
}

/// Widest gap between the shapes' projections on the two axes of a box, times |u|; negative when both overlap.
///
/// Proved: the gap is off by at most 12u (|p0| + |p1| + r0 + r1), where p0 = u.D, p1 = u x D, and r0, r1 are the sums
/// of half extents along them. A gap beyond that has the right sign.
///
///   - A coordinate of D errs by 2u of itself and u times the corners' extents e (offset()), one of the axis u by u of
///     itself. Two roundings follow. As |u||e| <= |c| + |s| for a segment, and sums to r for an AABB,
///     |error p_i| <= 5u |u||D| + 2u (r0 + r1).
///   - U errs by 4u, c and s by 4u |u||w| <= 4u (|c| + |s|), sizes by u, and there are three roundings:
///     |error r_i| <= 8u (r0 + r1).
///   - |u||D| <= |p0| + |p1|, and the subtraction adds u. In all 6u (|p0| + |p1|) + 11u (r0 + r1).
template <class V>
VESICA_INLINE constexpr Estimate<V> widest_gap(V p0, V p1, V r0, V r1) noexcept {
  return {max(p0 - r0, p1 - r1), roundoffs<V>(12) * ((p0 + p1) + (r0 + r1)) + underflow_allowance<V>()};
}

/// Farthest that a box reaches out of another along the other's two axes, times |u|; negative when it stays within. h0,
/// h1 are the other's half extents along them, e0, e1 the box's own.
///
/// Proved: it is off by at most 14u of the sum of all magnitudes. The bounds of widest_gap() are sums over h and e, and
/// there is one addition more, of p + e: 7u (|p0| + |p1|) + 12u (h0 + h1 + e0 + e1).
template <class V>
VESICA_INLINE constexpr Estimate<V> farthest_out(V p0, V p1, V h0, V h1, V e0, V e1) noexcept {
  return {max((p0 + e0) - h0, (p1 + e1) - h1),
          roundoffs<V>(14) * ((p0 + p1) + ((h0 + e0) + (h1 + e1))) + underflow_allowance<V>()};
}

/// The separating axes along one box's own axes: squared length, gap, and how far the other box reaches out.
template <class V>
struct OwnAxes {
  V uu;
  Estimate<V> gap, out;
};

/// c, s: the magnitudes of the two axes' products. d: from one box's centre to the other's, either way.
template <class V>
VESICA_INLINE constexpr OwnAxes<V> own_axes(const Box<V>& own, const Box<V>& other, V c, V s,
                                            const Centre<V>& d) noexcept {
  const V uu = own.ux * own.ux + own.uy * own.uy;
  const V p0 = abs(own.ux * d.x + own.uy * d.y), p1 = abs(own.ux * d.y - own.uy * d.x);
  const V h0 = own.hx * uu, h1 = own.hy * uu, e0 = other.hx * c + other.hy * s, e1 = other.hx * s + other.hy * c;
  return {uu, widest_gap(p0, p1, h0 + e0, h1 + e1), farthest_out(p0, p1, h0, h1, e0, e1)};
}

template <class V>
struct BoxBox {
  Estimate<V> gap_a, gap_b;            // along the axes of a and of b
  V uu, ww;                            // squared lengths of the two axes
  Estimate<V> a_out_of_b, b_out_of_a;  // along the axes of b and of a
};

template <class V>
VESICA_INLINE constexpr BoxBox<V> separating_axes(const Box<V>& a, const Box<V>& b, const Centre<V>& d) noexcept {
  const V c = abs(a.ux * b.ux + a.uy * b.uy), s = abs(a.ux * b.uy - a.uy * b.ux);
  const OwnAxes<V> of_a = own_axes(a, b, c, s, d), of_b = own_axes(b, a, c, s, d);
  return {of_a.gap, of_b.gap, of_a.uu, of_b.uu, of_b.out, of_a.out};
}

/// Where sums of products with opposite signs saturate in p0, those in p1 have like signs and are as great. So the
/// error is beyond its limit whenever an operation is beyond the range.
template <class V>
VESICA_INLINE constexpr auto box_box_usable(const BoxBox<V>& axes, const Box<V>& a, const Box<V>& b) noexcept {
  const auto finite = axes.gap_a.error + axes.gap_b.error <= greatest_error<V>();
  return both(both(both(box_axis_in_range(axes.uu), box_axis_in_range(axes.ww)), finite),
              at_least(V(0.0f), a.hx, a.hy, b.hx, b.hy));
}

template <class V>
VESICA_INLINE constexpr auto box_box(const Box<V>& a, const Box<V>& b, const Centre<V>& d) noexcept {
  const BoxBox<V> axes = separating_axes(a, b, d);
  return guarded(box_box_usable(axes, a, b), both(certainly_negative(axes.gap_a), certainly_negative(axes.gap_b)),
                 either(certainly_positive(axes.gap_a), certainly_positive(axes.gap_b)));
}

#if VESICA_HAS_TWO_DOUBLES
/// The same for one pair, the axes of both boxes at once. A size that is -0 is left undecided.
VESICA_INLINE auto box_box(const Box<double>& a, const Box<double>& b, const Centre<double>& d) noexcept {
  using V = TwoDoubles;
  const V axis_a(a.ux, a.uy), axis_b(b.ux, b.uy), half_a(a.hx, a.hy), half_b(b.hx, b.hy);
  const Box<V> own{firsts(axis_a, axis_b), seconds(axis_a, axis_b), firsts(half_a, half_b), seconds(half_a, half_b)};
  const Box<V> other{firsts(axis_b, axis_a), seconds(axis_b, axis_a), firsts(half_b, half_a), seconds(half_b, half_a)};
  const V c = abs(own.ux * other.ux + own.uy * other.uy), s = abs(own.ux * other.uy - own.uy * other.ux);
  const OwnAxes<V> axes = own_axes<V>(own, other, c, s, {V(d.x), V(d.y)});
  const auto usable = both(box_axis_in_range(axes.uu), axes.gap.error <= greatest_error<V>());
  return guarded(in_both_and_positive(usable, or_bits(half_a, half_b)), axes.gap);
}
#endif

/// The gap says whether the boxes cross or are disjoint; each box's own axes say how far the other reaches out of it.
template <class V>
VESICA_INLINE constexpr auto box_box_certain_facts(const Box<V>& a, const Box<V>& b, const Centre<V>& d) noexcept {
  const BoxBox<V> axes = separating_axes(a, b, d);
  auto s = certain_facts(axes.gap_a, axes.a_out_of_b, axes.b_out_of_a);
  s.disjoint = either(s.disjoint, certainly_positive(axes.gap_b));
  s.crossing = both(s.crossing, certainly_negative(axes.gap_b));
  return guarded(box_box_usable(axes, a, b), s);
}

/// d: from the box's centre to the point.
template <class V>
VESICA_INLINE constexpr Estimate<V> point_gap(const Box<V>& b, const Centre<V>& d, V uu) noexcept {
  const V p0 = abs(b.ux * d.x + b.uy * d.y), p1 = abs(b.ux * d.y - b.uy * d.x);
  return widest_gap<V>(p0, p1, b.hx * uu, b.hy * uu);
}

template <class V>
VESICA_INLINE constexpr auto point_box(const Box<V>& b, const Centre<V>& d) noexcept {
  const V uu = b.ux * b.ux + b.uy * b.uy;
  const Estimate<V> gap = point_gap(b, d, uu);
  const auto finite = gap.error <= greatest_error<V>();
  return guarded(both(both(box_axis_in_range(uu), finite), at_least(V(0.0f), b.hx, b.hy)), gap);
}

}  // namespace vesica::filter
