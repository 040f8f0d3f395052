// SPDX-License-Identifier: Apache-2.0
/// Contact of a circle with a rectangle, by squares of lengths in integers: exact for stored numbers of any length,
/// unless the exponents of coordinates and radius, of an axis or of sizes are far apart. For what the filter leaves
/// open, one pair at a time.
///
/// They overlap iff x^2 + y^2 <= r^2 U, where U = u.u, x = max(|u.D| - hx U, 0) and y = max(|u x D| - hy U, 0), as in
/// exact/disc.hpp. The axis is a multiple of a unit A, sizes of H, the radius and the way D between centres of R = 2^64
/// A H, coordinates of 2^s R with s >= 0. Then x is a multiple of A^2 H, and r^2 U is one of 2^128 A^4 H^2.
///
/// Proved: no number overflows.
///
///   - Up to the roundings of these sums, the magnitudes of the axis' numbers sum up to less than 2^63 A, sizes to less
///     than 2^63 H, and radius and way, rounded, to less than 2^62 R. What Shift held is below 2^62.
///   - So U is below 2^126 A^2, products of axis and way 2^125 A R, sizes times U 2^189 A^2 H.
///   - Over 2^64 x and y are below 2^125 A^2 H, their squares' sum is below 2^251, and r^2 U below 2^250.
#pragma once

#include <vesica/filter/axes.hpp>

namespace vesica::filter {

/// How far the centre is beyond a half side, over 2^64, or 0 if it is not.
struct Beyond {
  Residue128 whole;    // rounded down
  std::uint64_t rest;  // not 0 where it was

  /// between, over 2^64, less size times uu.
  VESICA_INLINE constexpr Beyond(const Residue128& between, Integer64 size, const Residue128& uu) noexcept {
    const auto h = static_cast<std::uint64_t>(size.n);
    const Residue128 low = product(h, uu.low), reach = product(h, uu.high) + Residue128{low.high, 0};
    const Residue128 beyond = between - reach - Residue128{low.low != 0, 0};
    const std::uint64_t kept = (beyond.high >> 63) - 1;
    whole = {beyond.low & kept, beyond.high & kept};
    rest = low.low & kept;
  }
};

/// What was rounded down is less than 1 in x and in y, so their squares' sum is too small by less than 2 (x + y + 1),
/// and that is below 2^128: only numbers of all digits that touch exactly, or nearly so, are left undecided.
VESICA_INLINE constexpr Verdict<bool> compare_squares(const Beyond& x, const Beyond& y, const Residue256& reached,
                                                      bool valid) noexcept {
  const Residue256 room = reached - (square(x.whole) + square(y.whole));
  const bool disjoint = room.is_negative(), is_whole = (x.rest | y.rest) == 0;
  const bool is_far = (room.high.low | room.high.high) != 0;
  return guarded(valid, and_not(either(is_whole, is_far), disjoint), disjoint);
}

/// Whether they overlap; undecided where exponents are too far apart for the units, or a shape is invalid.
VESICA_INLINE constexpr Verdict<bool> by_squares(const Circle<double>& c, const Rect<double>& r) noexcept {
  const Numbers of_axis{r.ux, r.uy}, of_sizes{r.hx, r.hy};
  const Numbers of_places{c.cx, c.cy, r.cx, r.cy};
  AxisUnit axes(of_axis);
  SizeUnit sizes(of_sizes);
  UnitOfAll<62> lengths(Numbers{c.cx - r.cx, c.cy - r.cy, c.r}), places(of_places);
  lengths.raise(axes.exponent() + sizes.exponent() + 64);
  sizes.raise(lengths.exponent() - axes.exponent() - 64);
  places.raise(lengths.exponent());
  Shift shift(places.exponent() - lengths.exponent());
  const bool ordinary = both(both(axes.is_ordinary(), sizes.is_ordinary()),
                             both(lengths.is_ordinary(), both(places.is_ordinary(), shift.is_possible())));
  if (!(ordinary && axes.divides(of_axis) && sizes.divides(of_sizes) && lengths.divides(Numbers{c.r}) &&
        places.divides(of_places))) {
    return {false, false};
  }
  const VectorInUnits u{axes.number(r.ux), axes.number(r.uy)};
  const VectorInUnits d = shift(VectorInUnits{places.number(c.cx) - places.number(r.cx),  //
                                              places.number(c.cy) - places.number(r.cy)});
  const Integer64 hx = sizes.number(r.hx), hy = sizes.number(r.hy), radius = lengths.number(c.r);
  const Residue128 uu = dot(u, u);
  const bool valid = both(shift.held(), both((hx.n | hy.n | radius.n) >= 0, (u.x.n | u.y.n) != 0));
  const Beyond x(dot(u, d).magnitude(), hx, uu), y(cross(u, d).magnitude(), hy, uu);
  const auto reach = static_cast<std::uint64_t>(radius.n);
  return compare_squares(x, y, product(product(reach, reach), uu), valid);
}

/// Pairs that by_squares() knows.
template <class A, class B>
concept HasSquares = has_wide_products && requires(const A& a, const B& b) {
  by_squares(a, b);
};

}  // namespace vesica::filter
