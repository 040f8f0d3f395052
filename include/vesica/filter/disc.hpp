// SPDX-License-Identifier: Apache-2.0
/// Discs: against points, discs, boxes along the coordinate axes, and boxes of any direction.
#pragma once

#include <vesica/filter/box_box.hpp>
#include <vesica/filter/comparison.hpp>

namespace vesica::filter {

/// |D|^2 - R^2 for coordinates of D and a reach R with a relative error of u each.
///
/// Proved: it is off by at most 5u (|D|^2 + R^2); 8u is taken. A square errs by 2u for its factor and u for its
/// rounding, the sum of two by u more, the difference by u of either.
template <class V>
VESICA_INLINE constexpr Estimate<V> beyond_reach(const Centre<V>& d, V reach) noexcept {
  const V distance = d.x * d.x + d.y * d.y, reached = reach * reach;
  return {distance - reached, roundoffs<V>(8) * (distance + reached) + underflow_allowance<V>()};
}

/// Were anything beyond the range, the error would be 2^105 (double: 2^970) or more.
template <class V>
VESICA_INLINE constexpr auto is_finite(const Estimate<V>& e) noexcept {
  return e.error <= guard_power < V, sizeof(typename Element<V>::Type) == 4 ? 104 : 120 > ();
}

template <class V>
VESICA_INLINE constexpr auto point_disc(const Centre<V>& d, V radius) noexcept {
  const Estimate<V> gap = beyond_reach(d, radius);
  return guarded(both(radius >= V(0.0f), is_finite(gap)), gap);
}

template <class V>
VESICA_INLINE constexpr auto disc_disc(const Centre<V>& d, V radius_a, V radius_b) noexcept {
  const Estimate<V> gap = beyond_reach(d, radius_a + radius_b);
  return guarded(both(at_least(V(0.0f), radius_a, radius_b), is_finite(gap)), gap);
}

/// One disc contains the other iff the centres are at most as far apart as the radii differ, and its radius is the
/// greater.
template <class V>
VESICA_INLINE constexpr auto disc_disc_certain_facts(const Centre<V>& d, V radius_a, V radius_b) noexcept {
  const Estimate<V> gap = beyond_reach(d, radius_a + radius_b), out = beyond_reach(d, radius_a - radius_b);
  const auto usable = at_least(V(0.0f), radius_a, radius_b);
  return guarded(usable, certain_facts(guarded(usable, gap), certainly_negative(out), certainly_positive(out),
                                       radius_a > radius_b));
}

/// From the centre to the nearest point of an AABB each coordinate is one rounded difference, or 0.
template <class V>
VESICA_INLINE constexpr Centre<V> nearest_offset(const Circle<V>& disc, const Aabb<V>& box) noexcept {
  return {positive_part(max(box.min_x - disc.cx, disc.cx - box.max_x)),
          positive_part(max(box.min_y - disc.cy, disc.cy - box.max_y))};
}

template <class V>
VESICA_INLINE constexpr auto disc_aabb(const Circle<V>& disc, const Aabb<V>& box) noexcept {
  // max() above may drop a NaN: the widths' zero-or-NaN difference brings it back into the bound.
  const V width = box.max_x - box.min_x, height = box.max_y - box.min_y;
  Estimate<V> gap = beyond_reach(nearest_offset(disc, box), disc.r);
  gap.error = gap.error + ((width - width) + (height - height)) + ((disc.cx - disc.cx) + (disc.cy - disc.cy));
  return guarded(both(at_least(V(0.0f), width, height, disc.r), is_finite(gap)), gap);
}

#if VESICA_HAS_TWO_DOUBLES
/// The same for one pair, both coordinates at once.
VESICA_INLINE auto disc_aabb(const Circle<double>& disc, const Aabb<double>& box) noexcept {
  using V = TwoDoubles;
  const V c(disc.cx, disc.cy), min(box.min_x, box.min_y), max(box.max_x, box.max_y), width = max - min;
  const V out = positive_part(lane::max(min - c, c - max)), zero(0.0);
  const auto finite = (width - width) + (c - c) == zero;
  const Estimate<double> gap = beyond_reach<double>({out.first(), out.second()}, disc.r);
  return guarded(both(in_both(both(finite, zero <= width)), both(disc.r >= 0, is_finite(gap))), gap);
}
#endif

/// The farthest corner of an AABB, as the nearest point.
template <class V>
VESICA_INLINE constexpr Centre<V> farthest_offset(const Circle<V>& disc, const Aabb<V>& box) noexcept {
  return {max(disc.cx - box.min_x, box.max_x - disc.cx), max(disc.cy - box.min_y, box.max_y - disc.cy)};
}

/// How far the disc reaches out of the box: r less the least room at one of four sides. Rounding keeps order, so the
/// greatest of four rounded differences is the greatest difference rounded; two roundings.
template <class V>
VESICA_INLINE constexpr Estimate<V> disc_out_of_aabb(const Circle<V>& disc, const Aabb<V>& box) noexcept {
  const V x = max(box.min_x - disc.cx, disc.cx - box.max_x), y = max(box.min_y - disc.cy, disc.cy - box.max_y);
  const V out = max(x, y);
  return {out + disc.r, roundoffs<V>(4) * (abs(out) + disc.r)};
}

template <class V>
VESICA_INLINE constexpr auto disc_aabb_certain_facts(const Circle<V>& disc, const Aabb<V>& box) noexcept {
  // max() may drop a NaN.
  const V width = box.max_x - box.min_x, height = box.max_y - box.min_y;
  const auto usable = both(at_least(V(0.0f), width, height, disc.r), all_finite(width, height, disc.cx, disc.cy));
  return guarded(usable, certain_facts(beyond_reach(nearest_offset(disc, box), disc.r), disc_out_of_aabb(disc, box),
                                       beyond_reach(farthest_offset(disc, box), disc.r)));
}

/// (distance from the disc's centre to the box)^2 - r^2, times U = u.u; d from the box's centre to the disc's.
///
/// Proved: it is off by at most 2e (x + y) + 2e^2 + 8u r^2 U, where e = 12u T and T = |k0| + |k1| + (hx + hy) U.
///
///   - k = (u.D, u x D) errs by 6u T (widest_gap()), h U by 6u of itself.
///   - So x = max(|k0| - hx U, 0) and y err by at most 10u T each. e has 2u T to spare, which cover what follows.
///   - Squares and their sum err by 2e (x + y) + 2e^2, and by 2u of x^2 + y^2 <= T (x + y).
///   - r^2 U errs by 6u of itself, the difference by u of either.
template <class V>
VESICA_INLINE constexpr Estimate<V> disc_beyond_box(const Box<V>& b, const Centre<V>& d, V radius, V uu) noexcept {
  const V k0 = abs(b.ux * d.x + b.uy * d.y), k1 = abs(b.ux * d.y - b.uy * d.x);
  const V e0 = b.hx * uu, e1 = b.hy * uu;
  const V x = positive_part(k0 - e0), y = positive_part(k1 - e1);
  const V reached = radius * radius * uu;
  const V e = roundoffs<V>(12) * ((k0 + k1) + (e0 + e1));
  return {(x * x + y * y) - reached, (e + e) * ((x + y) + e) + (roundoffs<V>(8) * reached + guard_power<V, -60>())};
}

/// Axes between 2^-10 and 2^10 (double: 2^-80 and 2^80) long. What underflows then errs by less than 2^-139 in k,
/// that is by far less than e or by less than 2^-90 in x, and by less than 2^-128 in r^2 U: beneath the 2^-60 above.
template <class V>
VESICA_INLINE constexpr auto disc_box(const Box<V>& b, const Centre<V>& d, V radius) noexcept {
  const V uu = b.ux * b.ux + b.uy * b.uy;
  const Estimate<V> gap = disc_beyond_box(b, d, radius, uu);
  const auto usable = both(in_range(uu, guard_power<V, -20>(), guard_power<V, 20>()),
                           both(at_least(V(0.0f), b.hx, b.hy, radius), gap.error <= guard_power<V, 100>()));
  return guarded(usable, gap);
}

/// (distance from the disc's centre to the box's farthest corner)^2 - r^2, times U. Sums of |k| and h U err as x and y
/// above do, so the bound is of the same form.
template <class V>
VESICA_INLINE constexpr Estimate<V> box_out_of_disc(const Box<V>& b, const Centre<V>& d, V radius, V uu) noexcept {
  const V k0 = abs(b.ux * d.x + b.uy * d.y), k1 = abs(b.ux * d.y - b.uy * d.x);
  const V e0 = b.hx * uu, e1 = b.hy * uu, x = k0 + e0, y = k1 + e1, reached = radius * radius * uu;
  const V e = roundoffs<V>(12) * (x + y);
  return {(x * x + y * y) - reached, (e + e) * ((x + y) + e) + (roundoffs<V>(8) * reached + guard_power<V, -60>())};
}

/// r^2 U less the square of the least room, hx U - |k0| or hy U - |k1|, between the disc's centre and the box's sides;
/// where there is none, the disc reaches out. The room errs as x and y above do.
template <class V>
VESICA_INLINE constexpr Estimate<V> disc_out_of_box(const Box<V>& b, const Centre<V>& d, V radius, V uu) noexcept {
  const V k0 = abs(b.ux * d.x + b.uy * d.y), k1 = abs(b.ux * d.y - b.uy * d.x);
  const V e0 = b.hx * uu, e1 = b.hy * uu, reached = radius * radius * uu;
  const V room = min(positive_part(e0 - k0), positive_part(e1 - k1));
  const V e = roundoffs<V>(12) * ((k0 + e0) + (k1 + e1));
  return {reached - room * room, (e + e) * (room + e) + (roundoffs<V>(8) * reached + guard_power<V, -60>())};
}

/// The guard of disc_box(), where the farthest corner's bound is the greatest of three.
template <class V>
VESICA_INLINE constexpr auto disc_box_certain_facts(const Box<V>& b, const Centre<V>& d, V radius) noexcept {
  const V uu = b.ux * b.ux + b.uy * b.uy;
  const Estimate<V> box_out = box_out_of_disc(b, d, radius, uu);
  const auto usable = both(in_range(uu, guard_power<V, -20>(), guard_power<V, 20>()),
                           both(at_least(V(0.0f), b.hx, b.hy, radius), box_out.error <= guard_power<V, 100>()));
  return guarded(usable, certain_facts(disc_beyond_box(b, d, radius, uu), disc_out_of_box(b, d, radius, uu), box_out));
}

}  // namespace vesica::filter
