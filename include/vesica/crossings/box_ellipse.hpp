// SPDX-License-Identifier: Apache-2.0
/// Where the outlines of a box and an ellipse meet. Along an edge P + t E the ellipse's quadratic form less 1 is a
/// quadratic in t, whose signs at the corners, slopes and discriminant are exact; and so accurate are its roots.
#pragma once

#include <vesica/crossings/box_box.hpp>

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

/// The roots of square t^2 + 2 slope t + value strictly between 0 and 1, ascending, for exact coefficients; and by which
/// multiple of the square root of the discriminant, 0 of a double root, each is off the extreme between them.
struct Roots {
  double t[2];
  int off[2];
  int count = 0;
  Scaled discriminant{0, 0};
  void add(double root, int side) noexcept {
    t[count] = root < 0 ? 0 : root > 1 ? 1 : root;
    off[count++] = side;
  }
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
    roots.add(-quotient(b, a), 0);
    return roots;
  }
  // Everything over the square's coefficient: t^2 + 2 b t + c, with c and the discriminant each rounded once.
  const double half = quotient(b, a), product = quotient(c, a);
  const Scaled d = exact::rounded(discriminant);
  roots.discriminant = d;
  const double squared = vesica::detail::scale(d.value / (a.value * a.value), d.exponent - 2 * a.exponent);
  const double root = std::sqrt(squared);
  const double low = half > 0 ? -(half + root) : product / (root - half);
  const double high = half > 0 ? product / -(half + root) : root - half;
  if (start > 0) roots.add(low, -1);
  if (end > 0) roots.add(high, 1);
  return roots;
}

/// Where the line through `from` along e meets the ellipse's outline: about the point of it that is nearest to the
/// origin, which a long edge's ends would not tell well.
class Chord {
 public:
  Chord(const DiscCorner& from, const exact::Number<4>& e0, const exact::Number<4>& e1, const Roots& roots) noexcept {
    const Scaled x = exact::rounded(e0), y = exact::rounded(e1);
    const auto edge = vesica::detail::direction(x.value, vesica::detail::scale(y.value, y.exponent - x.exponent));
    const bool steep = x.value == 0 || y.exponent - x.exponent > 1000;
    ux_ = steep ? 0 : edge.x;
    uy_ = steep ? (y.value < 0 ? -1 : 1) : edge.y;
    const Scaled off = exact::rounded(from.m1 * e0 - from.m0 * e1), d = roots.discriminant;
    // The discriminant over the squared length is the squared half of the chord; so is `off` its distance, to a scale.
    const bool odd = (d.exponent & 1) != 0;
    const Scaled half{std::sqrt(odd ? 2 * d.value : d.value), (d.exponent - (odd ? 1 : 0)) / 2};
    const int unit = off.value == 0 || (half.value != 0 && half.exponent > off.exponent) ? half.exponent : off.exponent;
    off_ = vesica::detail::scale(off.value, off.exponent - unit);
    half_ = vesica::detail::scale(half.value, half.exponent - unit);
  }
  Real turn(int side) const noexcept {
    const Real half(side * half_);
    return crossings::turn(Real(ux_) * half - Real(uy_) * Real(off_), Real(uy_) * half + Real(ux_) * Real(off_));
  }

 private:
  double ux_, uy_, off_, half_;
};

/// The place at which the ellipse's outline begins, if it is one of them, is the first along it.
inline void mend_start(const Corners& box, const exact::Ellipse& e, Found& found) noexcept {
  Place* place = found.next_to_start_of_b();
  if (place == nullptr) return;
  const Position x = e.cx + e.a * e.ux, y = e.cy + e.a * e.uy;
  if (place_along(box, x, y) >= 0) *place = {nearest(x), nearest(y), place->along_a, Real(0.0)};
}

inline Found crossings(const exact::Box& box, const exact::Ellipse& ellipse) noexcept {
  const Corners corners(box);
  const DiscFrame frame(ellipse);
  DiscCorner corner[4];
  Found found;
  const int unit = exact::rounded(frame.radius).exponent;
  for (int i = 0; i < corners.count; ++i) {
    corner[i].set(frame, corners.x[i], corners.y[i]);
    if (corner[i].value.sign != 0) continue;
    const Real at = turn(two_doubles(corner[i].m0, unit), two_doubles(corner[i].m1, unit));
    found.add({nearest(corners.x[i]), nearest(corners.y[i]), Real(i), at});
  }
  for (int i = 0; i < corners.edges; ++i) {
    const DiscCorner &from = corner[i], &to = corner[corners.next(i)];
    const auto e0 = to.m0 - from.m0, e1 = to.m1 - from.m1;
    const Roots roots =
        roots_inside(exact::square(e0) + exact::square(e1), from.m0 * e0 + from.m1 * e1, from.value, to.value);
    if (roots.count == 0) continue;
    const Edge edge(corners, i);
    const Chord chord(from, e0, e1, roots);
    for (int k = 0; k < roots.count; ++k) {
      const double t = roots.t[k];
      found.add({edge.at_x(t), edge.at_y(t), Real(on_edge(i, t)), chord.turn(roots.off[k])});
    }
  }
  mend_start(corners, ellipse, found);
  return found;
}

}  // namespace vesica::detail::crossings
