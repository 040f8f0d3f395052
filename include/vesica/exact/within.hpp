// SPDX-License-Identifier: Apache-2.0
/// Boxes at most a distance apart, or at least a depth deep in one another, exactly. Disjoint boxes are closest at a
/// corner of one of them, as an edge is straight. The depth is least along the normal of a side (contact()).
#pragma once

#include <vesica/exact/box_box.hpp>

namespace vesica::exact {

namespace detail {

/// How far a corner is beyond the sides of a box, along its axis and across it; 0 between them.
struct CornerGap {
  Number<3> x, y;

  /// True if it is no closer than another corner.
  constexpr bool is_behind(const CornerGap& other) const noexcept {
    return compare(other.x, x) <= 0 && compare(other.y, y) <= 0;
  }
};

/// The least squared distance of a corner of a from b, compared with the square of `reach` > 0: -1, 0 or 1, or what
/// counts already. (dx, dy) leads from b's centre to a's. In b's frame, in units of |u|, the corners are p +- g +- h. A
/// box without a size has fewer. One that is behind another needs no test; nor does one that a corner of b is closest
/// to, where the corners of b were tested. Degree 6.
constexpr int compare_corners(const Box& a, const Box& b, const Length& dx, const Length& dy, const Length& reach,
                              bool corners_of_b_are_known, Common common) noexcept {
  const auto uu = dot(b.ux, b.uy, b.ux, b.uy), c = dot(b.ux, b.uy, a.ux, a.uy), s = cross(b.ux, b.uy, a.ux, a.uy);
  const auto p0 = dot(b.ux, b.uy, dx, dy), p1 = cross(b.ux, b.uy, dx, dy);
  const auto g0 = a.hx * c, g1 = a.hx * s, h0 = a.hy * s, h1 = a.hy * c, ex = b.hx * uu, ey = b.hy * uu;
  const Number<4> squared_reach = square(reach) * uu;
  CornerGap gap[4];
  int count = 0;
  for (int along = a.hx.sign == 0 ? 1 : -1; along <= 1; along += 2) {
    for (int across = a.hy.sign == 0 ? 1 : -1; across <= 1; across += 2) {
      const auto k0 = along > 0 ? p0 + g0 : p0 - g0, k1 = along > 0 ? p1 + g1 : p1 - g1;
      auto x = abs(across > 0 ? k0 - h0 : k0 + h0) - ex, y = abs(across > 0 ? k1 + h1 : k1 - h1) - ey;
      if (x.sign < 0) x = {};
      if (y.sign < 0) y = {};
      if (!(corners_of_b_are_known && x.sign > 0 && y.sign > 0)) gap[count++] = {x, y};
    }
  }
  int least = 1;
  for (int i = 0; i < count; ++i) {
    bool is_first = true;
    for (int j = 0; j < count && is_first; ++j) {
      is_first = j == i || !gap[i].is_behind(gap[j]) || (i < j && gap[j].is_behind(gap[i]));
    }
    if (!is_first) continue;
    const int compared = compare(square(gap[i].x) + square(gap[i].y), squared_reach);
    if (counts(compared, common)) return compared;
    least = compared < least ? compared : least;
  }
  return least;
}

/// True if two intervals, as for gap(), share at least `depth` > 0, given its square.
constexpr bool share(const Number<2>& p, const Number<3>& r, const Number<4>& squared_depth) noexcept {
  const auto shared = r - abs(p);
  return shared.sign > 0 && compare(square(shared), squared_depth) >= 0;
}

/// True if two boxes share at least `depth` > 0 along each of four normals. Degree 6.
constexpr bool deep(const Box& a, const Box& b, const Length& depth) noexcept {
  const BoxPair seen(a, b);
  const auto along_axes = [&](const Box& box, const Box& other) {
    const FrameOfBox f(seen, box, other);
    const auto squared = square(depth) * dot(box.ux, box.uy, box.ux, box.uy);
    return share(f.x, f.hx + f.other_x, squared) && share(f.y, f.hy + f.other_y, squared);
  };
  return along_axes(a, b) && along_axes(b, a);
}

}  // namespace detail

/// The contact of two boxes if one reaches `reach` >= 0 farther each way, or one that counts already.
constexpr int contact(const Box& a, const Box& b, const Length& reach, Common common) noexcept {
  if (reach.sign == 0) return contact(a, b);
  const Length dx = a.cx - b.cx, dy = a.cy - b.cy;
  const int of_a = detail::compare_corners(a, b, dx, dy, reach, false, common);
  if (counts(of_a, common)) return of_a;
  const int of_b = detail::compare_corners(b, a, integer(-1) * dx, integer(-1) * dy, reach, true, common);
  if (counts(of_b, common)) return of_b;
  return overlap(a, b) ? -1 : of_a < of_b ? of_a : of_b;
}

/// True if two boxes are at most `reach` apart; with reach < 0, if they overlap at least -reach deep.
constexpr bool within(const Box& a, const Box& b, const Length& reach) noexcept {
  if (reach.sign < 0) return detail::deep(a, b, -reach);
  return contact(a, b, reach, Common::any) <= 0;
}

}  // namespace vesica::exact
