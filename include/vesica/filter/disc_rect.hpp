// SPDX-License-Identifier: Apache-2.0
/// Contact of a circle with a rectangle, in integers: exact for stored numbers of any length, unless the exponents of
/// coordinates, of an axis or of sizes are far apart. For what the filter leaves open, one pair at a time.
///
/// With U = u.u and k = (|u.D|, |u x D|) the circle meets the rectangle iff x^2 + y^2 <= r^2 U, where x = max(k0 - hx U,
/// 0) and y = max(k1 - hy U, 0), as in exact/disc.hpp.
#pragma once

#include <vesica/filter/axes.hpp>

namespace vesica::filter {

/// How far the centre is beyond the half side along one axis, over 2^64, or 0.
struct Beyond {
  Residue128 leading;   // rounded down
  std::uint64_t trailing;  // its last limb's opposite: 0 where nothing was rounded

  /// between, times 2^64, less size times uu.
  VESICA_INLINE constexpr Beyond(const Residue128& between, Integer64 size, const Residue128& uu) noexcept {
    const auto h = static_cast<std::uint64_t>(size.n);
    const Residue128 low = product(h, uu.low);
    const Residue128 room = product(h, uu.high) + Residue128{low.high, 0} + Residue128{low.low != 0, 0};
    const Residue128 beyond = between - room;
    const std::uint64_t kept = (beyond.high >> 63) - 1;
    leading = {beyond.low & kept, beyond.high & kept};
    trailing = low.low & kept;
  }
};

VESICA_INLINE constexpr Verdict<bool> by_squares(const Circle<double>& c, const Rect<double>& r) noexcept {
  AxisUnit axes(r.ux, r.uy);
  SizeUnit sizes(r.hx, r.hy);
  PlaceUnit places(c.cx, c.cy, r.cx, r.cy);
  NearUnit reaches(c.cx - r.cx, c.cy - r.cy, c.r);
  reaches.raise(axes.exponent() + sizes.exponent() + 64);
  sizes.raise(reaches.exponent() - axes.exponent() - 64);
  places.raise(reaches.exponent());
  const int places_off = places.exponent() - reaches.exponent();
  if (!both(both(places.is_ordinary(), axes.is_ordinary()),
            both(both(sizes.is_ordinary(), reaches.is_ordinary()), places_off <= 62))) {
    return {false, false};
  }
  Shift shift(places_off);
  const VectorInUnits u{axes.number(r.ux), axes.number(r.uy)};
  const VectorInUnits d = shift(VectorInUnits{places.number(c.cx) - places.number(r.cx),
                                              places.number(c.cy) - places.number(r.cy)});
  const Integer64 hx = sizes.number(r.hx), hy = sizes.number(r.hy), radius = reaches.number(c.r);
  const Residue128 uu = dot(u, u);
  const Beyond x(dot(u, d).magnitude(), hx, uu), y(cross(u, d).magnitude(), hy, uu);
  const auto reach = static_cast<std::uint64_t>(radius.n);
  const Residue256 reached = product(product(reach, reach), uu);
  const Residue256 room = reached - (square(x.leading) + square(y.leading));
  const bool held = both(places.holds_with(axes, sizes, reaches), shift.held());
  const bool valid = both(held, both((hx.n | hy.n | radius.n) >= 0, (u.x.n | u.y.n) != 0));
  const Residue128 sum = x.leading + y.leading + Residue128{1, 0};
  const Residue256 least = room - Residue256{{sum.low << 1, sum.high << 1 | sum.low >> 63}, {0, 0}};
  const bool whole = (x.trailing | y.trailing) == 0;
  const bool disjoint = room.is_negative(), overlap = either(both(whole, !disjoint), !least.is_negative());
  return guarded(valid, overlap, disjoint);
}

/// Pairs that by_squares() knows.
template <class A, class B>
concept HasSquares = has_wide_products && requires(const A& a, const B& b) {
  by_squares(a, b);
};

}  // namespace vesica::filter
