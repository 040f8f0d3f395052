// SPDX-License-Identifier: Apache-2.0
/// Places where the outlines of two ellipses meet, in the frame in which the first is the unit disc.
#pragma once

#include <vesica/support_minimum/arc_bound.hpp>
#include <vesica/support_minimum/frame.hpp>

namespace vesica::detail::boundary_distance {

using namespace support_minimum;

/// The outline of the second ellipse: centre + x p + y q for w = (x, y) on the unit circle. Its excess at w is its
/// squared distance from the first centre, less 1. It is negative at the closest point if anywhere, and positive at the
/// furthest: in the quadrants, between the axes of this ellipse, towards the first centre and away from it the distance
/// has one extreme each (D. Eberly, "Distance from a Point to an Ellipse, an Ellipsoid, or a Hyperellipsoid"). A common
/// point of the outlines lies between the two.
class EllipseInDisc {
 public:
  explicit EllipseInDisc(const Frame& frame) noexcept {
    const CentredShape first = frame.first_by_axis();
    const auto mapped = [&](const PlaneVector& v) { return PlaneVector{v.x / first.a, v.y / first.b}; };
    centre_ = mapped(frame.offset_by_axis());
    p_ = mapped(frame.second_along());
    q_ = mapped(frame.second_across());
  }

  /// One of the common points. If rounding leaves none, the extreme point that is closest to the first outline.
  PlaneVector common() const noexcept {
    const PlaneVector axis = principal();
    const PlaneVector a = towards_centre(axis), b = towards_centre(perp(axis));
    // Round the circle: the closest point lies between the first two corners, the furthest between their opposites.
    const bool turned = cross(a, b) < 0;
    const PlaneVector first = turned ? b : a, second = turned ? a : b;
    const PlaneVector inner = extreme(first, second, 1);
    if (!(excess_at(inner) < 0)) return inner;
    const PlaneVector outer = extreme(-first, -second, -1);
    if (!(excess_at(outer) > 0)) return outer;
    const PlaneVector way[4] = {inner, second, -first, outer};
    int i = 0;
    while (i < 2 && excess_at(way[i + 1]) < 0) ++i;
    return zero_between(way[i], way[i + 1]);
  }

 private:
  PlaneVector at(const PlaneVector& w) const noexcept { return centre_ + (w.x * p_ + w.y * q_); }
  double excess_at(const PlaneVector& w) const noexcept {
    const PlaneVector x = at(w);
    return dot(x, x) - 1;
  }
  /// Derivative of at(w) by the angle of w.
  PlaneVector slope_at(const PlaneVector& w) const noexcept { return w.x * q_ + -(w.y * p_); }

  /// The w of an end of an axis of the mapped ellipse: where at(w) - centre is longest or shortest.
  PlaneVector principal() const noexcept {
    const double difference = dot(p_, p_) - dot(q_, q_), product = 2 * dot(p_, q_);
    if (difference == 0 && product == 0) return {1, 0};
    const PlaneVector twice = unit_of_any({difference, product});
    // Half the angle of `twice`, from the sum with whichever of (1, 0) and (-1, 0) does not cancel.
    return twice.x >= 0 ? unit({1 + twice.x, twice.y}) : unit({twice.y, 1 - twice.x});
  }

  /// w or -w, whichever leads towards the first centre.
  PlaneVector towards_centre(const PlaneVector& w) const noexcept {
    return dot(w.x * p_ + w.y * q_, centre_) > 0 ? -w : w;
  }

  /// The excess, and half its first and half its second derivative by the angle of w.
  struct Derivatives {
    double excess, first, second;
  };
  Derivatives derivatives(const PlaneVector& w) const noexcept {
    const PlaneVector x = at(w), slope = slope_at(w);
    return {dot(x, x) - 1, dot(x, slope), dot(slope, slope) + dot(x, centre_ + -x)};
  }

  /// The one minimum of side * excess on a quadrant between the ellipse's axes, or a place on the way there where it
  /// is negative: Newton's method on the derivative, halving the arc where that fails. It falls at a and rises at b,
  /// unless the first centre lies on an axis; then the end of that axis is a minimum itself, or a maximum between two.
  PlaneVector extreme(PlaneVector a, PlaneVector b, double side) const noexcept {
    const Derivatives at_a = derivatives(a), at_b = derivatives(b);
    if (side * at_a.first >= 0 && side * at_a.second >= 0) return a;
    if (side * at_b.first <= 0 && side * at_b.second >= 0) return b;
    PlaneVector w = unit(a + b);
    for (int i = 0; i < step_limit && cross(a, b) > shortest_arc; ++i) {
      const Derivatives d = derivatives(w);
      // Less than rounding is to be gained on the arc that is left.
      if (side * d.excess < 0 || lane::abs(d.first) * cross(a, b) < 0x1p-56) break;
      (side * d.first < 0 ? a : b) = w;
      const double turn = -d.first / d.second;
      const PlaneVector next = unit(w + turn * perp(w));
      const bool useful = side * d.second > 0 && inside(a, next, b);
      w = useful ? next : unit(a + b);
      if (useful && lane::abs(turn) < shortest_arc) break;
    }
    return w;
  }

  /// A zero of the excess on an arc of at most a quarter turn, negative at a and positive at b: Newton's method,
  /// halving the arc where that leaves it or fails to halve the excess.
  PlaneVector zero_between(PlaneVector a, PlaneVector b) const noexcept {
    PlaneVector w = unit(a + b);
    double before = 0x1p1000;
    for (int i = 0; i < step_limit && cross(a, b) > shortest_arc; ++i) {
      const PlaneVector x = at(w);
      const double excess = dot(x, x) - 1, turn = -excess / (2 * dot(x, slope_at(w)));
      if (excess == 0) break;
      (excess < 0 ? a : b) = w;
      const PlaneVector next = unit(w + turn * perp(w));
      const bool useful = inside(a, next, b) && lane::abs(excess) <= before / 2;
      before = lane::abs(excess);
      w = useful ? next : unit(a + b);
      if (useful && lane::abs(turn) < shortest_arc) break;
    }
    return w;
  }

  static bool inside(const PlaneVector& a, const PlaneVector& w, const PlaneVector& b) noexcept {
    return cross(a, w) >= 0 && cross(w, b) >= 0;
  }

  static constexpr int step_limit = 100;

  PlaneVector centre_, p_, q_;
};

}  // namespace vesica::detail::boundary_distance
