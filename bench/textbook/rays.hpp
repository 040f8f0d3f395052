// SPDX-License-Identifier: Apache-2.0
/// Rays as textbooks have them: quadratics and slabs in double, nothing checked, nothing exact. Each returns the first
/// t in [0, end] at which p + t v is in the shape, or infinity.
#pragma once

#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vesica::bench::textbook {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// |p + t v| <= r.
inline double ray_at_disc(double px, double py, double vx, double vy, double r, double end) {
  const double a = vx * vx + vy * vy, b = px * vx + py * vy, c = px * px + py * py - r * r;
  if (c <= 0) return 0;
  const double discriminant = b * b - a * c;
  if (b >= 0 || discriminant < 0) return never;
  const double t = (-b - std::sqrt(discriminant)) / a;
  return t <= end ? t : never;
}

inline double ray(const vesica_circle_f64& s, const vesica_point_f64& p, double vx, double vy, double end) {
  return ray_at_disc(p.x - s.cx, p.y - s.cy, vx, vy, s.r, end);
}

inline double ray(const vesica_circle_f64& s, const vesica_circle_f64& p, double vx, double vy, double end) {
  return ray_at_disc(p.cx - s.cx, p.cy - s.cy, vx, vy, s.r + p.r, end);
}

inline double ray_at_slabs(double px, double py, double vx, double vy, double hx, double hy, double end) {
  const double ix = 1 / vx, iy = 1 / vy;
  const double x0 = (-hx - px) * ix, x1 = (hx - px) * ix, y0 = (-hy - py) * iy, y1 = (hy - py) * iy;
  const double in = std::max({std::min(x0, x1), std::min(y0, y1), 0.0});
  const double out = std::min({std::max(x0, x1), std::max(y0, y1), end});
  return in <= out ? in : never;
}

inline double ray(const vesica_aabb_f64& s, const vesica_point_f64& p, double vx, double vy, double end) {
  return ray_at_slabs(p.x - 0.5 * (s.min_x + s.max_x), p.y - 0.5 * (s.min_y + s.max_y), vx, vy,
                      0.5 * (s.max_x - s.min_x), 0.5 * (s.max_y - s.min_y), end);
}

inline double ray(const vesica_rect_f64& s, const vesica_point_f64& p, double vx, double vy, double end) {
  const double x = p.x - s.cx, y = p.y - s.cy;
  return ray_at_slabs(s.ux * x + s.uy * y, s.ux * y - s.uy * x, s.ux * vx + s.uy * vy, s.ux * vy - s.uy * vx, s.hx,
                      s.hy, end);
}

/// In the frame where the ellipse is the unit disc.
inline double ray(const vesica_ellipse_f64& s, const vesica_point_f64& p, double vx, double vy, double end) {
  const double x = p.x - s.cx, y = p.y - s.cy, ia = 1 / s.a, ib = 1 / s.b;
  return ray_at_disc((s.ux * x + s.uy * y) * ia, (s.ux * y - s.uy * x) * ib, (s.ux * vx + s.uy * vy) * ia,
                     (s.ux * vy - s.uy * vx) * ib, 1, end);
}

}  // namespace vesica::bench::textbook
