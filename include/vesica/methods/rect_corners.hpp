// SPDX-License-Identifier: Apache-2.0
/// Corner points of a rectangle.
///
/// Idea: plus and minus the half extents, turned and moved to the centre. Source: "Rectangle intersection at 60fps"
/// (blitcurve), which derives them from centre, angle and size; vesica::rect_from_angle() makes a Rect of those.
/// Cost: about 10 ns.
#pragma once

#include <cmath>
#include <vesica/check.hpp>

namespace vesica::methods {

namespace detail {

/// c + s x + t y; the sum may pass through numbers beyond the range of T.
template <class T>
T coordinate(T c, T s, T x, T t, T y) noexcept {
  const T sum = c + (s * x + t * y);
  return std::isfinite(sum) ? sum : 4 * (c / 4 + (s / 4 * x + t / 4 * y));
}

/// The point s along the axis from the centre and t across it.
template <class T>
Point<T> point_of(const Rect<T>& r, T s, T t) noexcept {
  return {coordinate(r.cx, s, r.ux, -t, r.uy), coordinate(r.cy, s, r.uy, t, r.ux)};
}

}  // namespace detail

/// Writes x0 y0 ... x3 y3, counter-clockwise where y points up: the corners with signs (-, -), (+, -), (+, +), (-, +)
/// along and across the axis, the order that rect_from_corners() reads.
///
/// Each coordinate is right to 3 roundoffs of |c| + |hx u| + |hy u|. Returns 0, error_shape, or error_range when a
/// corner is beyond the finite numbers; on error `out` is untouched.
template <class T>
std::int32_t rect_corners(const Rect<T>& rect, T (&out)[8]) noexcept {
  if (check(rect) != 0) return error_shape;
  T corners[8];
  for (int i = 0; i < 4; ++i) {
    const T s = i == 1 || i == 2 ? rect.hx : -rect.hx, t = i >= 2 ? rect.hy : -rect.hy;
    const Point<T> corner = detail::point_of(rect, s, t);
    if (check(corner) != 0) return error_range;
    corners[2 * i] = corner.x;
    corners[2 * i + 1] = corner.y;
  }
  for (int i = 0; i < 8; ++i) out[i] = corners[i];
  return 0;
}

}  // namespace vesica::methods
