// SPDX-License-Identifier: Apache-2.0
/// A pair in the frame of its first shape, and combinations of support functions there: in plain arithmetic for the
/// search, and once in double-doubles for the value at the direction it found. At a minimum an error e of the direction
/// changes the value by e^2 only. So the double-double value keeps its relative accuracy even where its terms cancel.
#pragma once

#include <vesica/support_minimum/arc_search.hpp>
#include <vesica/support_minimum/placed_pair.hpp>

namespace vesica::detail::support_minimum {

/// F(n) = h1(n) + sign h2(n) - n.D, D the offset of centres. With sign 1 that is how far the second shape must move
/// along n until n separates the two; with sign -1 how far the second stays behind the first along n.
class Frame {
 public:
  explicit Frame(const PlacedPair& pair) noexcept : pair_(pair) {
    const PlaneVector &u = pair.first.u, &w = pair.second.u;
    uu_ = support_minimum::dot(u.x, u.y, u.x, u.y);
    axis_ = {support_minimum::dot(u.x, u.y, w.x, w.y), support_minimum::cross(u.x, u.y, w.x, w.y)};
    offset_ = {support_minimum::dot(u.x, u.y, pair.d), support_minimum::cross(u.x, u.y, pair.d)};
  }

  /// F for minimise(). All lengths are below 4.
  Objective objective(double sign) const noexcept {
    CentredShape first = pair_.first.centred, second = pair_.second.centred;
    first.axis = {1, 0};
    second.axis = unit({axis_.x.high, axis_.y.high});
    return {first, second, sign, -offset(), 0x1p-54};
  }

  /// F(n) for a direction of about unit length. Right to 2^-98; its terms may cancel.
  FastDoubleDouble<double> value(const PlaneVector& n, double sign) const noexcept {
    const FastDoubleDouble<double> first = uu_ * height(pair_.first, {{n.x, 0}, {n.y, 0}});
    const FastDoubleDouble<double> second =
        height(pair_.second, {support_minimum::dot(n.x, n.y, axis_), -support_minimum::cross(n.x, n.y, axis_)});
    const FastDoubleDouble<double> all =
        (first + (sign < 0 ? -second : second)) - support_minimum::dot(n.x, n.y, offset_);
    return quotient_by_root(all, uu_ * support_minimum::dot(n.x, n.y, n.x, n.y));
  }

  /// The length of the first shape's axis in the pair's unit.
  double axis_length() const noexcept { return lane::sqrt(uu_.high); }
  /// The first shape where the frame's unit is the length of its own axis.
  CentredShape first_by_axis() const noexcept {
    const PlacedShape& s = pair_.first;
    const double thinnest = s.centred.curved ? 0x1p-250 : 0.0;
    return {{1, 0}, lane::max(s.a * uu_.high, thinnest), lane::max(s.b * uu_.high, thinnest), s.centred.curved};
  }
  /// There, from the first centre: the point (s, t) of the second shape in the frame in which that reaches from -1 to
  /// 1.
  PlaneVector second_by_axis(double s, double t) const noexcept {
    const double along = s * pair_.second.a, across = t * pair_.second.b;
    const DoubleDoubleVector<double> p{offset_.x + (axis_.x * along - axis_.y * across),
                                       offset_.y + (axis_.y * along + axis_.x * across)};
    return {rounded(p.x), rounded(p.y)};
  }
  /// The second shape's half axes, and its centre.
  PlaneVector second_along() const noexcept { return pair_.second.a * PlaneVector{axis_.x.high, axis_.y.high}; }
  PlaneVector second_across() const noexcept { return pair_.second.b * PlaneVector{-axis_.y.high, axis_.x.high}; }
  PlaneVector offset_by_axis() const noexcept { return {offset_.x.high, offset_.y.high}; }

  /// Out of the frame.
  PlaneVector world(const PlaneVector& n) const noexcept { return out_of_frame(pair_.first.centred.axis, n); }
  /// The second centre, from the first, in the frame.
  PlaneVector offset() const noexcept {
    const double length = axis_length();
    return {offset_.x.high / length, offset_.y.high / length};
  }

 private:
  /// The support function for the normal v, in the shape's frame and in the unit of its axis.
  static FastDoubleDouble<double> height(const PlacedShape& s, const DoubleDoubleVector<double>& v) noexcept {
    const FastDoubleDouble<double> p = v.x * s.a, q = v.y * s.b;
    if (!s.centred.curved) return magnitude(p) + magnitude(q);
    // The squares of a very thin shape's numbers would underflow.
    const bool thin = lane::max(lane::abs(p.high), lane::abs(q.high)) < 0x1p-400;
    const double lift = thin ? 0x1p600 : 1;
    const FastDoubleDouble<double> x = p * lift, y = q * lift;
    return root(x * x + y * y) * (1 / lift);
  }

  const PlacedPair& pair_;
  FastDoubleDouble<double> uu_;
  DoubleDoubleVector<double> axis_, offset_;  // times |u|: the second shape's axis, and D
};

}  // namespace vesica::detail::support_minimum
