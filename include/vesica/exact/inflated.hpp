// SPDX-License-Identifier: Apache-2.0
/// Relation and containment of shapes that are a core with a radius (form/inflated.hpp), exactly. A core is a box,
/// which may be a segment or a point.
#pragma once

#include <vesica/exact/relation.hpp>
#include <vesica/exact/within.hpp>
#include <vesica/form/inflated.hpp>

namespace vesica::exact {

/// The points at most `radius` from the core.
struct InflatedBox {
  Box core;
  Length radius;
};

template <class Shape>
constexpr InflatedBox inflated_box(const Shape& s) noexcept {
  const auto f = vesica::detail::form::inflated(s);
  return {form(f.core), from_double(f.radius)};
}

namespace detail {

/// The greatest signed distance of a corner of `a` from the box b, compared with a length of any sign: 1, 0 or -1. The
/// signed distance is negative inside b: then it is minus the distance to the closest side. Degree 6.
constexpr int compare_farthest_corner(const Box& a, const Box& b, const Length& length) noexcept {
  const Length dx = a.cx - b.cx, dy = a.cy - b.cy;
  const auto uu = dot(b.ux, b.uy, b.ux, b.uy), c = dot(b.ux, b.uy, a.ux, a.uy), s = cross(b.ux, b.uy, a.ux, a.uy);
  const auto p0 = dot(b.ux, b.uy, dx, dy), p1 = cross(b.ux, b.uy, dx, dy);
  const auto g0 = a.hx * c, g1 = a.hx * s, h0 = a.hy * s, h1 = a.hy * c, ex = b.hx * uu, ey = b.hy * uu;
  const auto squared_length = square(length) * uu;
  int farthest = -1;
  for (int along = a.hx.sign == 0 ? 1 : -1; along <= 1; along += 2) {
    for (int across = a.hy.sign == 0 ? 1 : -1; across <= 1; across += 2) {
      const auto k0 = along > 0 ? p0 + g0 : p0 - g0, k1 = along > 0 ? p1 + g1 : p1 - g1;
      auto x = abs(across > 0 ? k0 - h0 : k0 + h0) - ex, y = abs(across > 0 ? k1 + h1 : k1 - h1) - ey;
      int found;
      if (x.sign > 0 || y.sign > 0) {
        if (length.sign <= 0) return 1;
        if (x.sign < 0) x = {};
        if (y.sign < 0) y = {};
        found = compare(square(x) + square(y), squared_length);
      } else {
        // Minus the room, against the length.
        found = length.sign > 0 ? -1 : compare(squared_length, square(compare(x, y) > 0 ? x : y));
      }
      farthest = found > farthest ? found : farthest;
    }
  }
  return farthest;
}

}  // namespace detail

/// How far a stays in b: 1 inside, 0 if it has points of b's outline, -1 if it reaches out.
///
/// Proved, with cores K of a and L of b and radii r and s: K with r is in L with s iff every corner of K has a signed
/// distance of at most s - r from L.
///
///   - If r <= s, K must be in L with s - r: adding a disc of radius r to both changes nothing for convex sets. The
///     distance from a convex set is a convex function, so it is greatest at a corner.
///   - If r > s, K with r - s must be in L, for the same reason: every point of K is at least r - s inside each side.
constexpr int clearance(const InflatedBox& a, const InflatedBox& b) noexcept {
  return -detail::compare_farthest_corner(a.core, b.core, b.radius - a.radius);
}

constexpr Relation relate(const InflatedBox& a, const InflatedBox& b) noexcept {
  if (a.radius.sign == 0 && b.radius.sign == 0) return relate(a.core, b.core);
  const int touching = contact(a.core, b.core, a.radius + b.radius, Common::insides);
  if (touching > 0) return Relation::disjoint;
  return detail::relation_of(touching, clearance(a, b), clearance(b, a));
}

}  // namespace vesica::exact
