// SPDX-License-Identifier: Apache-2.0
/// Box against box, exactly: the four separating axes. Degree 3.
#pragma once

#include <vesica/exact/form.hpp>

namespace vesica::exact {

namespace detail {

/// Whether an axis of `a` (u or perp u) separates: the centres' distance along it exceeds the sum of the boxes'
/// half extents along it. All in units of |u|^2.
inline bool separated_along_axes_of(const Box& a, const Box& b, const Length& dx, const Length& dy) noexcept {
  const auto uu = dot(a.ux, a.uy, a.ux, a.uy);
  const auto c = abs(dot(a.ux, a.uy, b.ux, b.uy));
  const auto s = abs(cross(a.ux, a.uy, b.ux, b.uy));
  const auto along = abs(dot(a.ux, a.uy, dx, dy));
  if (compare(along, a.hx * uu + b.hx * c + b.hy * s) > 0) return true;
  const auto across = abs(cross(a.ux, a.uy, dx, dy));
  return compare(across, a.hy * uu + b.hx * s + b.hy * c) > 0;
}

}  // namespace detail

/// Whether the boxes share a point. The Minkowski sum of two boxes, flat ones included, is bounded by lines across the
/// four axes, so no other direction need be tried.
inline bool overlap(const Box& a, const Box& b) noexcept {
  const Length dx = b.cx - a.cx, dy = b.cy - a.cy;
  return !detail::separated_along_axes_of(a, b, dx, dy) && !detail::separated_along_axes_of(b, a, dx, dy);
}

}  // namespace vesica::exact
