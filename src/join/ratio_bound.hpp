// SPDX-License-Identifier: Apache-2.0
// Pairs of shapes ruled out by their bounds and areas: their ratio is surely below a threshold.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vesica/shapes.hpp>

namespace vesica::index {

/// A ratio of two shapes, and the threshold it is compared with. It does not depend on their order, and exceeds a
/// threshold >= 0 only where the shared area over the union does, or over the smaller shape.
struct Measured {
  std::int32_t ratio;  // the caller's own
  bool over_smaller;
  double threshold;
};

/// A shape's bounds and area; NaN for an area that must not be used.
struct Extent {
  double box[4];
  double area;
};

/// The area of a shape of moderate size and aspect, with a relative error of 2^-40; else NaN.
inline double moderate_area(double size_0, double size_1, double unit) noexcept {
  const double area = size_0 * size_1 * unit;
  const bool moderate = size_0 <= 0x1p10 * size_1 && size_1 <= 0x1p10 * size_0 && area >= 0x1p-500 && area <= 0x1p500;
  return moderate ? area : __builtin_nan("");
}

inline constexpr double pi = 3.14159265358979;

inline double moderate_area(const Circle<double>& s) noexcept { return moderate_area(s.r, s.r, pi); }
inline double moderate_area(const Aabb<double>& s) noexcept {
  return moderate_area(s.max_x - s.min_x, s.max_y - s.min_y, 1);
}
inline double moderate_area(double size_0, double size_1, double ux, double uy, double unit) noexcept {
  const double uu = ux * ux + uy * uy;
  return uu >= 0x1p-200 && uu <= 0x1p200 ? moderate_area(size_0, size_1, unit * uu) : __builtin_nan("");
}
inline double moderate_area(const Rect<double>& s) noexcept { return moderate_area(s.hx, s.hy, s.ux, s.uy, 4); }
inline double moderate_area(const Ellipse<double>& s) noexcept { return moderate_area(s.a, s.b, s.ux, s.uy, pi); }
/// A shape with a radius: the box around it less the four corners outside the arcs.
inline double rounded_area(double hx, double hy, double r) noexcept {
  return moderate_area(hx + r, hy + r, 4) - (4 - pi) * (r * r);
}
inline double moderate_area(const Capsule<double>& s) noexcept {
  const double x = s.x1 - s.x0, y = s.y1 - s.y0;
  return rounded_area(0.5 * std::sqrt(x * x + y * y), 0, s.r);
}
inline double moderate_area(const RoundRect<double>& s) noexcept {
  const double length = std::sqrt(s.ux * s.ux + s.uy * s.uy);
  return rounded_area(s.hx * length, s.hy * length, s.r);
}

/// The extents of boxes, their bounds widened by what rounding may take away.
inline Extent extent_of(const Aabb<double>& s) noexcept {
  return {{s.min_x, s.min_y, s.max_x, s.max_y}, moderate_area(s)};
}
inline Extent extent_of(const Rect<double>& s) noexcept {
  const double ux = std::fabs(s.ux), uy = std::fabs(s.uy), x = ux * s.hx + uy * s.hy, y = uy * s.hx + ux * s.hy;
  const double wide = x + 0x1p-48 * (std::fabs(s.cx) + x), tall = y + 0x1p-48 * (std::fabs(s.cy) + y);
  return {{s.cx - wide, s.cy - tall, s.cx + wide, s.cy + tall}, moderate_area(s)};
}

/// Leaves out most pairs whose ratio is far below a threshold t. With areas A and B the IoU of a shared area S exceeds
/// t only if S (1 + t) > t (A + B), and S is at most the bounds' shared area. The ratio errs by up to 2^-37 at aspects
/// up to 2^10; from t = 2^-10 on that is less than the 2^-20 taken off here. Ratios below the IoU exceed t no more
/// often. Over the smaller area the least that is asked of S is t min(A, B).
class RatioBound {
 public:
  explicit RatioBound(const Measured& m) noexcept
      : over_smaller_(m.over_smaller),
        shared_(over_smaller_ ? 1 : 1 + m.threshold),
        needed_(m.threshold >= 0x1p-10 ? m.threshold * (1 - 0x1p-20) : 0) {}
  bool may_exceed(const Extent& a, const Extent& b) const noexcept {
    const double width = std::min(a.box[2], b.box[2]) - std::max(a.box[0], b.box[0]);
    const double height = std::min(a.box[3], b.box[3]) - std::max(a.box[1], b.box[1]);
    const double areas = over_smaller_ ? smaller(a.area, b.area) : a.area + b.area;
    const bool apart = (width < 0) | (height < 0), little = width * height * shared_ < areas * needed_;
    return !(apart | little);
  }

 private:
  /// NaN where either is.
  static double smaller(double a, double b) noexcept { return a < b ? a : b + 0 * a; }

  bool over_smaller_;
  double shared_, needed_;
};

}  // namespace vesica::index
