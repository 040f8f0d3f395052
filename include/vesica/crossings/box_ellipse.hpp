// SPDX-License-Identifier: Apache-2.0
/// Where the outlines of a box and an ellipse meet. Along an edge P + t E the ellipse's quadratic form less 1 is a
/// quadratic in t. Its signs at the corners, its slopes and its discriminant are computed exactly, so the number of
/// roots is exact and the roots are accurate.
#pragma once

#include <vesica/crossings/points.hpp>

namespace vesica::detail::crossings {

/// The frame in which the ellipse is the disc of radius a b V about the origin: lengths along its axis times b, across
/// it times a.
struct DiscFrame {
  const exact::Ellipse& e;
  exact::Number<4> radius;
  explicit DiscFrame(const exact::Ellipse& ellipse) noexcept
      : e(ellipse), radius(ellipse.a * ellipse.b * exact::dot(ellipse.ux, ellipse.uy, ellipse.ux, ellipse.uy)) {}
  exact::Number<4> along(const Position& x, const Position& y) const noexcept {
    return e.b * exact::dot(e.ux, e.uy, x, y);
  }
  exact::Number<4> across(const Position& x, const Position& y) const noexcept {
    return e.a * exact::cross(e.ux, e.uy, x, y);
  }
};

/// A corner there, and the sign and size of its squared distance from the origin less the squared radius.
struct DiscCorner {
  exact::Number<4> m0, m1;
  exact::Number<8> value;
  void set(const DiscFrame& frame, const Position& x, const Position& y) noexcept {
    const Position dx = x - frame.e.cx, dy = y - frame.e.cy;
    m0 = frame.along(dx, dy);
    m1 = frame.across(dx, dy);
    value = exact::square(m0) + exact::square(m1) - exact::square(frame.radius);
  }
};

/// The roots of square t^2 + 2 slope t + value strictly between 0 and 1, ascending, for exact coefficients.
struct Roots {
  double t[2];
  int count = 0;
  void add(double root) noexcept { t[count++] = root < 0 ? 0 : root > 1 ? 1 : root; }
};

inline Roots roots_inside(const exact::Number<8>& square, const exact::Number<8>& slope, const exact::Number<8>& value,
                          const exact::Number<8>& end_value) noexcept {
  Roots roots;
  const int start = value.sign, end = end_value.sign;
  const auto end_slope = slope + square;
  const bool dips = slope.sign < 0 && end_slope.sign > 0;
  if (start < 0 && end <= 0) return roots;
  if (start == 0 && (end <= 0 || slope.sign >= 0)) return roots;
  if (end == 0 && end_slope.sign <= 0) return roots;
  const bool both_outside = start > 0 && end > 0;
  if (both_outside && !dips) return roots;
  const auto discriminant = exact::square(slope) - square * value;
  if (discriminant.sign < 0 || (discriminant.sign == 0 && !both_outside)) return roots;
  const Scaled a = exact::rounded(square), b = exact::rounded(slope), c = exact::rounded(value);
  if (discriminant.sign == 0) {
    roots.add(-quotient(b, a));
    return roots;
  }
  // Everything over the square's coefficient: t^2 + 2 b t + c, with c and the discriminant each rounded once.
  const double half = quotient(b, a), product = quotient(c, a);
  const Scaled d = exact::rounded(discriminant);
  const double squared = arithmetic::scale(d.value / (a.value * a.value), d.exponent - 2 * a.exponent);
  const double root = std::sqrt(squared);
  const double low = half > 0 ? -(half + root) : product / (root - half);
  const double high = half > 0 ? product / -(half + root) : root - half;
  if (start > 0) roots.add(low);
  if (end > 0) roots.add(high);
  return roots;
}

inline Found crossings(const exact::Box& box, const exact::Ellipse& ellipse) noexcept {
  const Corners corners(box);
  const DiscFrame frame(ellipse);
  DiscCorner corner[4];
  Found found;
  const int unit = exact::rounded(frame.radius).exponent;
  const auto part = [unit](const exact::Number<4>& x) {
    const Scaled s = exact::rounded(x);
    return arithmetic::scale(s.value, s.exponent - unit);
  };
  for (int i = 0; i < corners.count; ++i) {
    corner[i].set(frame, corners.x[i], corners.y[i]);
    if (corner[i].value.sign != 0) continue;
    const double at = turn(part(corner[i].m0), part(corner[i].m1));
    found.add({nearest(corners.x[i]), nearest(corners.y[i]), static_cast<double>(i), at});
  }
  for (int i = 0; i < corners.edges; ++i) {
    const Edge edge(corners, i);
    const DiscCorner &from = corner[i], &to = corner[corners.next(i)];
    const auto e0 = to.m0 - from.m0, e1 = to.m1 - from.m1;
    const Roots roots =
        roots_inside(exact::square(e0) + exact::square(e1), from.m0 * e0 + from.m1 * e1, from.value, to.value);
    for (int k = 0; k < roots.count; ++k) {
      const double t = roots.t[k], at = turn(part(from.m0) + t * part(e0), part(from.m1) + t * part(e1));
      found.add({edge.at_x(t), edge.at_y(t), i + t, at});
    }
  }
  return found;
}

}  // namespace vesica::detail::crossings
