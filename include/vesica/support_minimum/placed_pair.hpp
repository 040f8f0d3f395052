// SPDX-License-Identifier: Apache-2.0
/// Two shapes as boxes and ellipses of moderate size, seen from each other (form/placement.hpp).
///
/// Lengths are measured in the power of two just above the largest of them. A number smaller than that by more than the
/// range of double underflows to 0; this is far below the error bound.
#pragma once

#include <vesica/form/placement.hpp>
#include <vesica/support_minimum/box_faces.hpp>
#include <vesica/support_minimum/support.hpp>

namespace vesica::detail::support_minimum {

/// A shape as a box or an ellipse: { C + s u + t perp(u) } as in shapes.hpp. C is the mean of two stored points, which
/// need not be a double.
struct Form {
  PlaneVector from, to;
  PlaneVector u;
  double a, b;
  bool curved;
};

/// The parts of a form with lengths halved and ratios doubled, which is the same shape, for differences that overflow.
struct LengthsHalved {
  double operator()(const form::Difference<double>& d) const noexcept { return 0.5 * d.to - 0.5 * d.from; }
  double operator()(const form::HalfWidth<double>& w) const noexcept { return 0.5 * w.to - 0.5 * w.from; }
  double operator()(form::Constant c) const noexcept { return 2 * static_cast<double>(c.x); }
  double operator()(form::WidthAxis) const noexcept { return 1; }
};

template <class Parts, class Numbers>
Form form_of(const Parts& f, const Numbers& number) noexcept {
  const form::Corners<double> p = form::corners(f.place);
  const double a = number(f.hx), b = number(f.hy);
  const bool round = f.outline != form::Outline::straight;
  return {{p.x0, p.y0}, {p.x1, p.y1}, {number(f.ux), number(f.uy)}, a, b, round && a > 0 && b > 0};
}

inline bool difference_overflows(const form::Corners<double>& p) noexcept {
  return !(lane::abs(p.x1 - p.x0) + lane::abs(p.y1 - p.y0) <= 0x1p1023);
}

template <class Shape>
Form form(const Shape& s) noexcept {
  const auto f = form::of(s);
  Form g = form_of(f, form::AsStored<double>{});
  if constexpr (f.axis_may_vanish) {
    if (g.u.x == 0 && g.u.y == 0) return {g.from, g.to, {1, 0}, 0, 0, false};
  }
  if constexpr (f.has_corners) {
    if (difference_overflows(f.place)) g = form_of(f, LengthsHalved{});
  }
  return g;
}

/// Without an inside: a point or a segment. Its outline is all of it.
inline bool flat(const Form& f) noexcept { return f.a == 0 || f.b == 0; }

/// A centred shape in a pair's unit: as stored, up to powers of two (the larger component of u in [1/2, 1)), and with
/// a unit vector as axis.
struct PlacedShape {
  PlaneVector u;
  double a, b;
  CentredShape centred;
};

/// The offset d leads from the first centre to the second. Lengths are in units of 2^exponent; the largest is in
/// [1/2, 1), or all are 0.
struct PlacedPair {
  PlacedShape first, second;
  DoubleDoubleVector<double> d;
  PlaneVector lead;  ///< d's signs, as numbers: d itself may underflow in the pair's unit
  int exponent;
};

/// The offset of centres times 2^-exponent.
struct Offset {
  FastDoubleDouble<double> x, y;
  int exponent;
};

inline Offset offset_of_centres(const Form& a, const Form& b, double k, int exponent) noexcept {
  const auto x = form::twice_offset(b.from.x, b.to.x, a.from.x, a.to.x, k);
  const auto y = form::twice_offset(b.from.y, b.to.y, a.from.y, a.to.y, k);
  return {{x.high, x.low}, {y.high, y.low}, exponent};
}

/// Nothing is halved where it might be subnormal; differences that overflow are formed at an eighth.
inline Offset offset_of_centres(const Form& a, const Form& b) noexcept {
  const Offset twice = offset_of_centres(a, b, 1, -1);
  const double all = (twice.x.high + twice.x.low) + (twice.y.high + twice.y.low);
  return all - all == 0 ? twice : offset_of_centres(a, b, 0.125, 2);
}

inline double sign(double x) noexcept { return x < 0 ? -1 : x > 0 ? 1 : 0; }

inline PlacedShape placed_shape(const Form& f, int k, int unit) noexcept {
  const PlaneVector u{scale(f.u.x, -k), scale(f.u.y, -k)};
  const double length = lane::sqrt(u.x * u.x + u.y * u.y);
  const double a = scale(f.a, k - unit), b = scale(f.b, k - unit);
  // Far thinner than an answer's rounding, and the squares of a search do not underflow.
  const double thinnest = f.curved ? 0x1p-250 : 0.0;
  return {u,
          a,
          b,
          {{u.x / length, u.y / length}, lane::max(a * length, thinnest), lane::max(b * length, thinnest), f.curved}};
}

inline PlacedPair place(const Form& first, const Form& second) noexcept {
  const Offset d = offset_of_centres(first, second);
  const int k1 = form::axis_exponent(first.u.x, first.u.y), k2 = form::axis_exponent(second.u.x, second.u.y);
  using form::length_exponent;
  const int unit = form::common_exponent({length_exponent(d.x.high, d.exponent), length_exponent(d.y.high, d.exponent),
                                          length_exponent(first.a, k1), length_exponent(first.b, k1),
                                          length_exponent(second.a, k2), length_exponent(second.b, k2)});
  const auto in_unit = [&](const FastDoubleDouble<double>& t) {
    return FastDoubleDouble<double>{scale(t.high, d.exponent - unit), scale(t.low, d.exponent - unit)};
  };
  return {placed_shape(first, k1, unit),
          placed_shape(second, k2, unit),
          {in_unit(d.x), in_unit(d.y)},
          {sign(d.x.high), sign(d.y.high)},
          unit};
}

/// Two boxes as they are; for rectangles the same as their box_pair().
inline BoxPair<double> box_pair(const Form& a, const Form& b) noexcept {
  const Offset twice = offset_of_centres(a, b, 1, -1);
  return {{a.u.x, a.u.y, a.a, a.b},
          {b.u.x, b.u.y, b.a, b.b},
          {{0.5 * twice.x.high, 0.5 * twice.x.low}, {0.5 * twice.y.high, 0.5 * twice.y.low}}};
}

/// Two boxes in the pair's unit.
inline BoxPair<double> box_pair(const PlacedPair& p) noexcept {
  const auto axes_of = [](const PlacedShape& s) { return Axes<double>{s.u.x, s.u.y, s.a, s.b}; };
  return {axes_of(p.first), axes_of(p.second), p.d};
}

/// (from + to) / 2 + offset, rounded once; what is halved last may be subnormal, first where it might overflow.
inline double located_coordinate(double from, double to, double offset) noexcept {
  const bool large = lane::abs(from) + lane::abs(to) + lane::abs(offset) >= 0x1p1020;
  const double first = large ? 0.5 : 1, last = large ? 1 : 0.5;
  const FastDoubleDouble<double> twice = sum(first * from, first * to), all = sum(twice.high, 2 * first * offset);
  return last * (all.high + (all.low + twice.low));
}

/// The point at an offset from a shape's centre, in units of 2^exponent, where it is.
inline PlaneVector located(const Form& f, const PlaneVector& offset, int exponent) noexcept {
  return {located_coordinate(f.from.x, f.to.x, arithmetic::scale(offset.x, exponent)),
          located_coordinate(f.from.y, f.to.y, arithmetic::scale(offset.y, exponent))};
}

/// The same with the roles exchanged.
inline PlacedPair exchanged(const PlacedPair& p) noexcept {
  return {p.second, p.first, {-p.d.x, -p.d.y}, -p.lead, p.exponent};
}

}  // namespace vesica::detail::support_minimum
