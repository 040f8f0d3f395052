// SPDX-License-Identifier: Apache-2.0
/// A pair in the frame of its first shape, and combinations of support functions there: quickly, for a search, and once
/// more where it ended, to 106 bits. A normal found with an error of e costs an error of e^2 only, so a small answer
/// keeps its relative accuracy where its terms cancel.
#pragma once

#include <vesica/outline/arc_search.hpp>
#include <vesica/outline/placed_pair.hpp>

namespace vesica::outline {

/// F(n) = h1(n) + sign h2(n) - n.D, D the offset of centres. With sign 1 that is how far the second shape must move
/// along n until n separates the two; with sign -1 how far the second stays behind the first along n.
class Frame {
 public:
  explicit Frame(const PlacedPair& pair) noexcept : pair_(pair) {
    const Vector &u = pair.first.u, &w = pair.second.u;
    uu_ = outline::dot(u.x, u.y, u.x, u.y);
    axis_ = {outline::dot(u.x, u.y, w.x, w.y), outline::cross(u.x, u.y, w.x, w.y)};
    offset_ = {outline::dot(u.x, u.y, pair.d), outline::cross(u.x, u.y, pair.d)};
  }

  /// F for minimise(). All lengths are below 4.
  Objective objective(double sign) const noexcept {
    CentredShape first = pair_.first.centred, second = pair_.second.centred;
    first.axis = {1, 0};
    second.axis = unit({axis_.x.high, axis_.y.high});
    return {first, second, sign, -offset(), 0x1p-54};
  }

  /// F(n) for a direction of about unit length. Right to 2u of itself and 2^-100.
  double value(const Vector& n, double sign) const noexcept {
    const Twofold<double> first = uu_ * height(pair_.first, {{n.x, 0}, {n.y, 0}});
    const Twofold<double> second =
        height(pair_.second, {outline::dot(n.x, n.y, axis_), -outline::cross(n.x, n.y, axis_)});
    const Twofold<double> all = (first + (sign < 0 ? -second : second)) - outline::dot(n.x, n.y, offset_);
    return rounded(all) / lane::sqrt(rounded(uu_ * outline::dot(n.x, n.y, n.x, n.y)));
  }

  /// The first shape where the frame's unit is the length of its own axis.
  CentredShape first_by_axis() const noexcept {
    const PlacedShape& s = pair_.first;
    const double thinnest = s.centred.curved ? 0x1p-250 : 0.0;
    return {{1, 0}, lane::max(s.a * uu_.high, thinnest), lane::max(s.b * uu_.high, thinnest), s.centred.curved};
  }
  /// There, from the first centre: the point (s, t) of the second shape in the frame in which that reaches from -1 to
  /// 1.
  Vector second_by_axis(double s, double t) const noexcept {
    const double along = s * pair_.second.a, across = t * pair_.second.b;
    const TwofoldVector<double> p{offset_.x + (axis_.x * along - axis_.y * across),
                                  offset_.y + (axis_.y * along + axis_.x * across)};
    return {rounded(p.x), rounded(p.y)};
  }
  /// The second shape's half axes, and its centre.
  Vector second_along() const noexcept { return pair_.second.a * Vector{axis_.x.high, axis_.y.high}; }
  Vector second_across() const noexcept { return pair_.second.b * Vector{-axis_.y.high, axis_.x.high}; }
  Vector offset_by_axis() const noexcept { return {offset_.x.high, offset_.y.high}; }

  /// Out of the frame.
  Vector world(const Vector& n) const noexcept { return out_of_frame(pair_.first.centred.axis, n); }
  /// The second centre, from the first, in the frame.
  Vector offset() const noexcept {
    const double length = lane::sqrt(uu_.high);
    return {offset_.x.high / length, offset_.y.high / length};
  }

 private:
  /// The support function for the normal v, in the shape's frame and in the unit of its axis.
  static Twofold<double> height(const PlacedShape& s, const TwofoldVector<double>& v) noexcept {
    const Twofold<double> p = v.x * s.a, q = v.y * s.b;
    if (!s.centred.curved) return magnitude(p) + magnitude(q);
    // The squares of a very thin shape's numbers would underflow.
    const bool thin = lane::max(lane::abs(p.high), lane::abs(q.high)) < 0x1p-400;
    const double lift = thin ? 0x1p600 : 1;
    const Twofold<double> x = p * lift, y = q * lift;
    return root(x * x + y * y) * (1 / lift);
  }

  const PlacedPair& pair_;
  Twofold<double> uu_;
  TwofoldVector<double> axis_, offset_;  // times |u|: the second shape's axis, and D
};

}  // namespace vesica::outline
