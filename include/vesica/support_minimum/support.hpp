// SPDX-License-Identifier: Apache-2.0
/// Support functions of boxes and ellipses about the origin, the two forms that every shape has.
#pragma once

#include <vesica/support_minimum/plane_vector.hpp>

namespace vesica::detail::support_minimum {

/// { s axis + t perp(axis) : |s| <= a, |t| <= b }, or where curved (s/a)^2 + (t/b)^2 <= 1 with a, b > 0. The axis is a
/// unit vector. Points and segments are boxes.
struct CentredShape {
  PlaneVector axis;
  double a, b;
  bool curved;
};

/// For a unit normal: the support function h, its derivative by the normal's angle, and the radius of curvature of the
/// outline where that is its normal.
struct SupportValues {
  double height, slope, radius;
};

/// h = |(a x, b y)| for a normal (x, y) in the ellipse's frame, and the radius is (a b)^2 / h^3.
inline SupportValues ellipse_support(const CentredShape& s, const PlaneVector& normal) noexcept {
  const PlaneVector n = into_frame(s.axis, normal);
  const double p = s.a * n.x, q = s.b * n.y, height = lane::sqrt(p * p + q * q), inverse = 1 / height;
  const double width = s.a * s.b * inverse;  // not above either half length: nothing here overflows
  return {height, (s.b - s.a) * (s.b + s.a) * (n.x * n.y) * inverse, width * width * inverse};
}

/// The corner of a box furthest along a direction. Along a face's normal, the corner where x or y counts as positive.
inline PlaneVector corner(const CentredShape& s, const PlaneVector& direction) noexcept {
  const PlaneVector d = into_frame(s.axis, direction);
  return out_of_frame(s.axis, {d.x < 0 ? -s.a : s.a, d.y < 0 ? -s.b : s.b});
}

/// The point furthest along a direction.
inline PlaneVector furthest(const CentredShape& s, const PlaneVector& direction) noexcept {
  if (!s.curved) return corner(s, direction);
  const PlaneVector d = into_frame(s.axis, direction);
  const PlaneVector w = unit_of_any({s.a * d.x, s.b * d.y});
  return out_of_frame(s.axis, {s.a * w.x, s.b * w.y});
}

}  // namespace vesica::detail::support_minimum
