// SPDX-License-Identifier: Apache-2.0
/// Capsules as a good programmer would write them: distances of segments, without an error bound.
#pragma once

#include <vesica.h>

#include <algorithm>

namespace vesica::textbook {

/// The squared distance of (x, y) from the segment from the origin along (dx, dy).
template <class T>
T squared_distance(T x, T y, T dx, T dy) {
  const T length = dx * dx + dy * dy;
  const T share = length > 0 ? std::clamp((x * dx + y * dy) / length, T(0), T(1)) : T(0);
  const T rx = x - share * dx, ry = y - share * dy;
  return rx * rx + ry * ry;
}

template <class Circle, class Capsule>
bool circle_capsule(const Circle& a, const Capsule& b) {
  const auto reach = a.r + b.r;
  return squared_distance(a.cx - b.x0, a.cy - b.y0, b.x1 - b.x0, b.y1 - b.y0) <= reach * reach;
}

/// Segments that do not cross are closest at an end of one of them.
template <class Capsule>
bool capsule_capsule(const Capsule& a, const Capsule& b) {
  const auto ax = a.x1 - a.x0, ay = a.y1 - a.y0, bx = b.x1 - b.x0, by = b.y1 - b.y0;
  const auto dx = b.x0 - a.x0, dy = b.y0 - a.y0, reach = a.r + b.r;
  const auto least = std::min(std::min(squared_distance(dx, dy, ax, ay), squared_distance(dx + bx, dy + by, ax, ay)),
                              std::min(squared_distance(-dx, -dy, bx, by), squared_distance(ax - dx, ay - dy, bx, by)));
  if (least <= reach * reach) return true;
  const auto side = [](auto ux, auto uy, auto vx, auto vy) { return ux * vy - uy * vx > 0; };
  return side(ax, ay, dx, dy) != side(ax, ay, dx + bx, dy + by) &&
         side(bx, by, -dx, -dy) != side(bx, by, ax - dx, ay - dy);
}

}  // namespace vesica::textbook
