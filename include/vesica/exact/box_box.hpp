// SPDX-License-Identifier: Apache-2.0
/// Box against box, exactly: the four separating axes. Degree 3.
#pragma once

#include <vesica/exact/form.hpp>

namespace vesica::exact {

namespace detail {

/// Sign of the gap between two intervals on an axis, where p is the distance of their midpoints and r the sum of their
/// half lengths: 1 apart, 0 end to end, -1 overlapping. Two equal points count as overlapping, as any equal intervals.
template <int P, int R>
constexpr int gap(const Number<P>& p, const Number<R>& r) noexcept {
  const int sign = compare(abs(p), r);
  return sign == 0 && p.sign == 0 ? -1 : sign;
}

/// The greater gap along the two axes of `a` (u and perp u), in units of |u|^2.
constexpr int widest_gap_along_axes_of(const Box& a, const Box& b, const Length& dx, const Length& dy) noexcept {
  const auto uu = dot(a.ux, a.uy, a.ux, a.uy);
  const auto c = abs(dot(a.ux, a.uy, b.ux, b.uy));
  const auto s = abs(cross(a.ux, a.uy, b.ux, b.uy));
  const int along = gap(dot(a.ux, a.uy, dx, dy), a.hx * uu + b.hx * c + b.hy * s);
  if (along > 0) return 1;
  const int across = gap(cross(a.ux, a.uy, dx, dy), a.hy * uu + b.hx * s + b.hy * c);
  return along > across ? along : across;
}

/// How far an interval of half length `extent` stays within one of half length `size`, p between their midpoints:
/// 1 clear of its ends, 0 up to an end, -1 not within. A single point has no ends to reach.
template <int P, int E, int S>
constexpr int clearance(const Number<P>& p, const Number<E>& extent, const Number<S>& size) noexcept {
  const int sign = compare(size, abs(p) + extent);
  return sign == 0 && size.sign == 0 ? 1 : sign;
}

}  // namespace detail

/// -1 when the relative insides of two boxes meet, 0 when only their outlines do, 1 when the boxes are disjoint. The
/// Minkowski sum of two boxes, flat ones included, is bounded by lines across the four axes, so no other direction need
/// be tried; the insides meet iff the offset of centres is in the relative inside of that sum.
constexpr int contact(const Box& a, const Box& b) noexcept {
  const Length dx = b.cx - a.cx, dy = b.cy - a.cy;
  const int first = detail::widest_gap_along_axes_of(a, b, dx, dy);
  if (first > 0) return 1;
  const int second = detail::widest_gap_along_axes_of(b, a, dx, dy);
  return first > second ? first : second;
}

/// Whether the boxes share a point.
constexpr bool overlap(const Box& a, const Box& b) noexcept { return contact(a, b) <= 0; }

/// How far box a stays within box b: 1 clear of b's outline, 0 up to it, -1 not within. b is bounded by its own axes.
constexpr int clearance(const Box& a, const Box& b) noexcept {
  const Length dx = b.cx - a.cx, dy = b.cy - a.cy;
  const auto ww = dot(b.ux, b.uy, b.ux, b.uy);
  const auto c = abs(dot(b.ux, b.uy, a.ux, a.uy));
  const auto s = abs(cross(b.ux, b.uy, a.ux, a.uy));
  const int along = detail::clearance(dot(b.ux, b.uy, dx, dy), a.hx * c + a.hy * s, b.hx * ww);
  if (along < 0) return -1;
  const int across = detail::clearance(cross(b.ux, b.uy, dx, dy), a.hx * s + a.hy * c, b.hy * ww);
  return along < across ? along : across;
}

}  // namespace vesica::exact
