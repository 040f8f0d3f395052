// SPDX-License-Identifier: Apache-2.0
/// Boxes at most a distance apart, exactly. Disjoint boxes are closest at a corner of one of them, as an edge is
/// straight.
#pragma once

#include <vesica/exact/box_box.hpp>

namespace vesica::exact {

namespace detail {

/// Whether any corner of a is at most `reach` from b; (dx, dy) leads from b's centre to a's. In b's frame, in units of
/// |u|, the corners are p +- g +- h. A box without a size has fewer. Degree 6.
inline bool corner_within(const Box& a, const Box& b, const Length& dx, const Length& dy,
                          const Length& reach) noexcept {
  const auto uu = dot(b.ux, b.uy, b.ux, b.uy), c = dot(b.ux, b.uy, a.ux, a.uy), s = cross(b.ux, b.uy, a.ux, a.uy);
  const auto p0 = dot(b.ux, b.uy, dx, dy), p1 = cross(b.ux, b.uy, dx, dy);
  const auto g0 = a.hx * c, g1 = a.hx * s, h0 = a.hy * s, h1 = a.hy * c, ex = b.hx * uu, ey = b.hy * uu;
  const auto beyond = [](const auto& x, const auto& y, const auto& r, const auto& unit) {
    return square(x) + square(y) - square(r) * unit;
  };
  for (int along = a.hx.sign == 0 ? 1 : -1; along <= 1; along += 2) {
    for (int across = a.hy.sign == 0 ? 1 : -1; across <= 1; across += 2) {
      const auto k0 = along > 0 ? p0 + g0 : p0 - g0, k1 = along > 0 ? p1 + g1 : p1 - g1;
      auto x = abs(across > 0 ? k0 - h0 : k0 + h0) - ex, y = abs(across > 0 ? k1 + h1 : k1 - h1) - ey;
      if (x.sign < 0) x = {};
      if (y.sign < 0) y = {};
      if (sign_of(beyond, x, y, reach, uu) <= 0) return true;
    }
  }
  return false;
}

}  // namespace detail

/// Whether two boxes are at most `reach` >= 0 apart.
inline bool within(const Box& a, const Box& b, const Length& reach) noexcept {
  const Length dx = a.cx - b.cx, dy = a.cy - b.cy;
  return detail::corner_within(a, b, dx, dy, reach) ||
         detail::corner_within(b, a, integer(-1) * dx, integer(-1) * dy, reach) || overlap(a, b);
}

}  // namespace vesica::exact
