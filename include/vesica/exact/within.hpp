// SPDX-License-Identifier: Apache-2.0
/// Boxes at most a distance apart, exactly. Disjoint boxes are closest at a corner of one of them, as an edge is straight.
#pragma once

#include <vesica/exact/box_box.hpp>

namespace vesica::exact {

/// A corner of a box or an end of a segment.
struct Corner {
  Number<2> x, y;
};

/// C + along hx u + across hy perp(u), where each of `along` and `across` is 1 or -1.
inline Corner corner(const Box& box, int along, int across) noexcept {
  auto hx = box.hx, hy = box.hy;
  hx.sign *= along;
  hy.sign *= across;
  return {box.cx + (hx * box.ux - hy * box.uy), box.cy + (hx * box.uy + hy * box.ux)};
}

/// Whether a point is at most `reach` from a box. Degree 6.
inline bool within(const Corner& p, const Box& box, const Length& reach) noexcept {
  const auto dx = p.x - box.cx, dy = p.y - box.cy;
  const auto uu = dot(box.ux, box.uy, box.ux, box.uy);
  auto x = abs(dot(box.ux, box.uy, dx, dy)) - box.hx * uu, y = abs(cross(box.ux, box.uy, dx, dy)) - box.hy * uu;
  if (x.sign < 0) x = {};
  if (y.sign < 0) y = {};
  return compare(square(x) + square(y), square(reach) * uu) <= 0;
}

/// Whether any corner of a is at most `reach` from b. A box without a size has fewer corners.
inline bool corner_within(const Box& a, const Box& b, const Length& reach) noexcept {
  for (int along = a.hx.sign == 0 ? 1 : -1; along <= 1; along += 2) {
    for (int across = a.hy.sign == 0 ? 1 : -1; across <= 1; across += 2) {
      if (within(corner(a, along, across), b, reach)) return true;
    }
  }
  return false;
}

/// Whether two boxes are at most `reach` >= 0 apart.
inline bool within(const Box& a, const Box& b, const Length& reach) noexcept {
  return corner_within(a, b, reach) || corner_within(b, a, reach) || overlap(a, b);
}

}  // namespace vesica::exact
