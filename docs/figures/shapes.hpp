// SPDX-License-Identifier: Apache-2.0
/// Shapes as outlines of points.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>
#include <vesica/vesica.hpp>

#include "svg.hpp"

namespace figures {

using Ellipse = vesica::Ellipse<double>;
using Rect = vesica::Rect<double>;
using Circle = vesica::Circle<double>;

/// The point at C + x u + y perp(u).
template <class Shape>
Point in_frame(const Shape& shape, double x, double y) {
  return {shape.cx + x * shape.ux - y * shape.uy, shape.cy + x * shape.uy + y * shape.ux};
}

inline Point at_angle(const Ellipse& e, double t) { return in_frame(e, e.a * std::cos(t), e.b * std::sin(t)); }

/// `sides` points from one angle to another, both included.
inline std::vector<Point> arc(const Ellipse& e, double from, double to, int sides) {
  std::vector<Point> points;
  for (int i = 0; i <= sides; ++i) points.push_back(at_angle(e, from + (to - from) * i / sides));
  return points;
}

inline std::vector<Point> outline(const Ellipse& e) { return arc(e, 0, 2 * std::numbers::pi, 120); }

inline std::vector<Point> outline(const Circle& c) { return outline(Ellipse{c.cx, c.cy, 1, 0, c.r, c.r}); }

/// Corners with signs (-, -), (+, -), (+, +), (-, +).
inline std::vector<Point> corners(const Rect& r) {
  return {in_frame(r, -r.hx, -r.hy), in_frame(r, r.hx, -r.hy), in_frame(r, r.hx, r.hy), in_frame(r, -r.hx, r.hy)};
}

}  // namespace figures
