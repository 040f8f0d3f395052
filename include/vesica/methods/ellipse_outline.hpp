// SPDX-License-Identifier: Apache-2.0
/// Outlines of two ellipses as functions of an angle each, at a scale at which nothing overflows.
#pragma once

#include <cmath>
#include <vesica/arithmetic/length.hpp>
#include <vesica/methods/rescaled_pair.hpp>

namespace vesica::methods::detail {

/// An ellipse about the origin. The point at an angle is cos * p + sin * q, p and q its half axes as vectors.
struct Outline {
  double ux, uy;  ///< the axis, which p and q of length 0 do not tell
  double px, py, qx, qy;
  double largest;  ///< half length: no point is farther from the centre
};

inline Outline outline(double ux, double uy, double a, double b) noexcept {
  return {ux, uy, a * ux, a * uy, -b * uy, b * ux, larger(a, b) * vesica::detail::arithmetic::length(ux, uy)};
}

/// The largest length is about 1 here; the true ones are 2^exponent times as long.
struct OutlinePair {
  Outline a, b;
  double dx, dy;  ///< from the centre of a to that of b
  int exponent;
};

/// Both ellipses must be valid.
inline OutlinePair outline_pair(const Ellipse<double>& a, const Ellipse<double>& b) noexcept {
  const auto r =
      rescale<double>(Rect<double>{a.cx, a.cy, a.ux, a.uy, a.a, a.b}, Rect<double>{b.cx, b.cy, b.ux, b.uy, b.a, b.b});
  const int axis_exponent = vesica::detail::arithmetic::exponent_of(larger(std::fabs(a.ux), std::fabs(a.uy)));
  return {outline(r.ux, r.uy, r.h0, r.h1), outline(r.wx, r.wy, r.g0, r.g1), r.dx, r.dy, r.exponent + axis_exponent};
}

/// A point of an outline seen from its centre, and its derivative by the angle.
struct OutlinePoint {
  double cosine, sine, x, y, tangent_x, tangent_y;
};

inline OutlinePoint point_at(const Outline& e, double angle) noexcept {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c, s, c * e.px + s * e.qx, c * e.py + s * e.qy, c * e.qx - s * e.px, c * e.qy - s * e.py};
}

/// An angle for each outline, or a change of them.
struct Angles {
  double a, b;
};

/// Half the squared distance of two outline points as a function of their angles: where it is, and its gradient.
struct Slope {
  OutlinePoint a, b;
  double dx, dy;  ///< from the point of b to that of a
  double distance;
  Angles gradient;
};

inline Slope slope(const OutlinePair& p, Angles at) noexcept {
  const OutlinePoint a = point_at(p.a, at.a), b = point_at(p.b, at.b);
  const double dx = a.x - b.x - p.dx, dy = a.y - b.y - p.dy;
  return {a,
          b,
          dx,
          dy,
          vesica::detail::arithmetic::length(dx, dy),
          {a.tangent_x * dx + a.tangent_y * dy, -(b.tangent_x * dx + b.tangent_y * dy)}};
}

}  // namespace vesica::methods::detail
