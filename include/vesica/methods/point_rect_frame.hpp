// SPDX-License-Identifier: Apache-2.0
/// Point in rectangle.
///
/// Idea: turn the system so that the rectangle lies along the axes; the point is then compared with its half extents.
/// Source: "Rectangle intersection at 60fps" (blitcurve). Differs: nothing is turned by an angle; the axis as stored
/// gives the two coordinates, in its own unit of length. Touching counts.
/// Cost: about 10 ns. May err within a few roundings of the outline.
#pragma once

#include <vesica/methods/rescaled_pair.hpp>

namespace vesica::methods {

/// 1 when the point is in the rectangle or on its outline, 0 when not, error_shape when either is invalid.
template <class T>
std::int32_t point_in_rect(const Point<T>& point, const Rect<T>& rect) noexcept {
  if (check(point) != 0 || check(rect) != 0) return error_shape;
  const auto p = detail::rescaled_pair(rect, Rect<T>{point.x, point.y, 1, 0, 0, 0});
  const T uu = p.ux * p.ux + p.uy * p.uy;
  const bool inside =
      std::fabs(p.ux * p.dx + p.uy * p.dy) <= p.h0 * uu && std::fabs(p.ux * p.dy - p.uy * p.dx) <= p.h1 * uu;
  return inside ? 1 : 0;
}

}  // namespace vesica::methods
