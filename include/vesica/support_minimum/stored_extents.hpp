// SPDX-License-Identifier: Apache-2.0
/// Points, segments and AABBs store how far they reach along the coordinate axes. So a depth along an axis, and the
/// distance of an AABB from what is inside it, is one difference of stored numbers, right to its last place.
#pragma once

#include <vesica/support_minimum/placed_pair.hpp>

namespace vesica::detail::support_minimum {

template <class Shape>
inline constexpr bool stores_extents = false;
template <>
inline constexpr bool stores_extents<Point<double>> = true;
template <>
inline constexpr bool stores_extents<Segment<double>> = true;
template <>
inline constexpr bool stores_extents<Aabb<double>> = true;

struct Extents {
  PlaneVector low, high;
  explicit Extents(const Form& f) noexcept
      : low{lane::min(f.from.x, f.to.x), lane::min(f.from.y, f.to.y)},
        high{lane::max(f.from.x, f.to.x), lane::max(f.from.y, f.to.y)} {}
};

/// How far b must move along a coordinate axis, (x, y) being its unit vector, to be beyond a.
inline double depth_along_axis(const Form& a, const Form& b, double x, double y) noexcept {
  const Extents p(a), q(b);
  if (y == 0) return x > 0 ? p.high.x - q.low.x : q.high.x - p.low.x;
  return y > 0 ? p.high.y - q.low.y : q.high.y - p.low.y;
}

/// How far b, inside of the AABB a, stays behind a's nearest side.
inline double distance_from_sides(const Form& a, const Form& b) noexcept {
  const Extents p(a), q(b);
  const double left = q.low.x - p.low.x, right = p.high.x - q.high.x;
  const double below = q.low.y - p.low.y, above = p.high.y - q.high.y;
  return lane::min(lane::min(left, right), lane::min(below, above));
}

}  // namespace vesica::detail::support_minimum
