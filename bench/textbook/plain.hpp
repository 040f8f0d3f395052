// SPDX-License-Identifier: Apache-2.0
/// Code that a good programmer would inline for pairs of simple shapes: no error bound, no validity check, axes taken
/// to be of unit length, early exits where they come naturally. Over the structs of vesica.h.
#pragma once

#include <vesica.h>

#include <algorithm>
#include <cmath>

#include "textbook/ellipse_ellipse.hpp"
#include "textbook/rect_ellipse.hpp"
#include "textbook/rect_rect.hpp"

namespace vesica::textbook {

/// The functions for one scalar, by the structs of its shapes.
template <class T, class Point, class Segment, class Circle, class Aabb, class Rect, class Ellipse>
struct Plain {
  static T squared(T x, T y) { return x * x + y * y; }
  static T cross(T ax, T ay, T bx, T by) { return ax * by - ay * bx; }

  /// A point in the frame of a turned shape.
  template <class Turned>
  static Point local(const Turned& s, T x, T y) {
    const T dx = x - s.cx, dy = y - s.cy;
    return {s.ux * dx + s.uy * dy, s.ux * dy - s.uy * dx};
  }
  static Rect as_rect(const Aabb& s) {
    const T half = T(0.5);
    return {half * (s.min_x + s.max_x), half * (s.min_y + s.max_y), 1, 0,
            half * (s.max_x - s.min_x), half * (s.max_y - s.min_y)};
  }

  static bool test(const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; }
  static bool test(const Point& p, const Segment& s) {
    if (cross(s.x1 - s.x0, s.y1 - s.y0, p.x - s.x0, p.y - s.y0) != 0) return false;
    return (p.x - s.x0) * (p.x - s.x1) + (p.y - s.y0) * (p.y - s.y1) <= 0;
  }
  static bool test(const Point& p, const Circle& c) { return squared(p.x - c.cx, p.y - c.cy) <= c.r * c.r; }
  static bool test(const Point& p, const Aabb& s) {
    return p.x >= s.min_x && p.x <= s.max_x && p.y >= s.min_y && p.y <= s.max_y;
  }
  static bool test(const Point& p, const Rect& s) {
    const Point q = local(s, p.x, p.y);
    return std::fabs(q.x) <= s.hx && std::fabs(q.y) <= s.hy;
  }
  static bool test(const Point& p, const Ellipse& s) {
    const Point q = local(s, p.x, p.y);
    return squared(q.x / s.a, q.y / s.b) <= 1;
  }

  /// Each segment's ends on unlike sides of the other.
  static bool test(const Segment& s, const Segment& t) {
    const T sx = s.x1 - s.x0, sy = s.y1 - s.y0, tx = t.x1 - t.x0, ty = t.y1 - t.y0;
    if (cross(sx, sy, t.x0 - s.x0, t.y0 - s.y0) * cross(sx, sy, t.x1 - s.x0, t.y1 - s.y0) > 0) return false;
    return cross(tx, ty, s.x0 - t.x0, s.y0 - t.y0) * cross(tx, ty, s.x1 - t.x0, s.y1 - t.y0) <= 0;
  }
  /// The distance of the origin to a segment, squared.
  static T squared_distance(T x0, T y0, T x1, T y1) {
    const T dx = x1 - x0, dy = y1 - y0;
    const T t = std::clamp(-(x0 * dx + y0 * dy) / squared(dx, dy), T(0), T(1));
    return squared(x0 + t * dx, y0 + t * dy);
  }
  static bool test(const Segment& s, const Circle& c) {
    return squared_distance(s.x0 - c.cx, s.y0 - c.cy, s.x1 - c.cx, s.y1 - c.cy) <= c.r * c.r;
  }
  /// Separating axes of a box about the origin and a segment.
  static bool meets_box(T hx, T hy, T x0, T y0, T x1, T y1) {
    const T half = T(0.5), mx = half * (x0 + x1), my = half * (y0 + y1), ex = half * (x1 - x0), ey = half * (y1 - y0);
    if (std::fabs(mx) > hx + std::fabs(ex)) return false;
    if (std::fabs(my) > hy + std::fabs(ey)) return false;
    return std::fabs(cross(mx, my, ex, ey)) <= hx * std::fabs(ey) + hy * std::fabs(ex);
  }
  static bool test(const Segment& s, const Aabb& box) {
    const Rect r = as_rect(box);
    return meets_box(r.hx, r.hy, s.x0 - r.cx, s.y0 - r.cy, s.x1 - r.cx, s.y1 - r.cy);
  }
  static bool test(const Segment& s, const Rect& r) {
    const Point p = local(r, s.x0, s.y0), q = local(r, s.x1, s.y1);
    return meets_box(r.hx, r.hy, p.x, p.y, q.x, q.y);
  }
  static bool test(const Segment& s, const Ellipse& e) {
    const Point p = local(e, s.x0, s.y0), q = local(e, s.x1, s.y1);
    return squared_distance(p.x / e.a, p.y / e.b, q.x / e.a, q.y / e.b) <= 1;
  }

  static bool test(const Circle& c, const Circle& d) {
    const T reach = c.r + d.r;
    return squared(c.cx - d.cx, c.cy - d.cy) <= reach * reach;
  }
  static bool test(const Circle& c, const Aabb& s) {
    const T x = std::clamp(c.cx, s.min_x, s.max_x), y = std::clamp(c.cy, s.min_y, s.max_y);
    return squared(c.cx - x, c.cy - y) <= c.r * c.r;
  }
  static bool test(const Circle& c, const Rect& s) {
    const Point q = local(s, c.cx, c.cy);
    const T x = std::max(std::fabs(q.x) - s.hx, T(0)), y = std::max(std::fabs(q.y) - s.hy, T(0));
    return squared(x, y) <= c.r * c.r;
  }
  static bool test(const Circle& c, const Ellipse& e) {
    return ellipse_ellipse(Ellipse{c.cx, c.cy, 1, 0, c.r, c.r}, e);
  }

  static bool test(const Aabb& s, const Aabb& t) {
    return s.min_x <= t.max_x && t.min_x <= s.max_x && s.min_y <= t.max_y && t.min_y <= s.max_y;
  }
  static bool test(const Aabb& s, const Rect& r) { return rect_rect(as_rect(s), r); }
  static bool test(const Aabb& s, const Ellipse& e) { return rect_ellipse(as_rect(s), e); }
};

using PlainF64 = Plain<double, vesica_point_f64, vesica_segment_f64, vesica_circle_f64, vesica_aabb_f64,
                       vesica_rect_f64, vesica_ellipse_f64>;
using PlainF32 = Plain<float, vesica_point_f32, vesica_segment_f32, vesica_circle_f32, vesica_aabb_f32, vesica_rect_f32,
                       vesica_ellipse_f32>;

inline bool overlap(const auto& a, const auto& b) {
  if constexpr (requires { PlainF64::test(a, b); }) {
    return PlainF64::test(a, b);
  } else {
    return PlainF32::test(a, b);
  }
}

}  // namespace vesica::textbook
