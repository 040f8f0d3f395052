// SPDX-License-Identifier: Apache-2.0
/// Two shapes as boxes and ellipses of moderate size, seen from each other.
///
/// Only differences of stored coordinates are formed, exactly as far as two numbers hold them, so moving both shapes by
/// the same exact amount changes nothing. Lengths come in the power of two just above the largest of them: what is
/// smaller by more than the range of double is lost, and nothing that the queries' accuracy speaks of.
#pragma once

#include <vesica/arithmetic/scaled.hpp>
#include <vesica/shapes.hpp>
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

inline Form form(const Point<double>& s) noexcept { return {{s.x, s.y}, {s.x, s.y}, {1, 0}, 0, 0, false}; }

inline Form form(const Segment<double>& s) noexcept {
  const PlaneVector from{s.x0, s.y0}, to{s.x1, s.y1}, u{s.x1 - s.x0, s.y1 - s.y0};
  if (u.x == 0 && u.y == 0) return {from, to, {1, 0}, 0, 0, false};
  if (lane::abs(u.x) + lane::abs(u.y) <= 0x1p1023) return {from, to, u, 0.5, 0, false};
  return {from, to, 0.5 * to + -(0.5 * from), 1, 0, false};
}

inline Form form(const Aabb<double>& s) noexcept {
  const PlaneVector from{s.min_x, s.min_y}, to{s.max_x, s.max_y}, size{s.max_x - s.min_x, s.max_y - s.min_y};
  if (size.x + size.y <= 0x1p1023) return {from, to, {0.5, 0}, size.x, size.y, false};
  const PlaneVector half = 0.5 * to + -(0.5 * from);
  return {from, to, {1, 0}, half.x, half.y, false};
}

inline Form form(const Rect<double>& s) noexcept {
  return {{s.cx, s.cy}, {s.cx, s.cy}, {s.ux, s.uy}, s.hx, s.hy, false};
}

inline Form form(const Circle<double>& s) noexcept { return {{s.cx, s.cy}, {s.cx, s.cy}, {1, 0}, s.r, s.r, s.r > 0}; }

inline Form form(const Ellipse<double>& s) noexcept {
  return {{s.cx, s.cy}, {s.cx, s.cy}, {s.ux, s.uy}, s.a, s.b, s.a > 0 && s.b > 0};
}

/// Without an inside: a point or a segment. Its outline is all of it.
inline bool flat(const Form& f) noexcept { return f.a == 0 || f.b == 0; }

/// A centred shape in a pair's unit: as stored, but for powers of two (the larger component of u in [1/2, 1)), and with
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

/// The sum of two differences, k times.
inline FastDoubleDouble<double> differences(double to0, double to1, double from0, double from1, double k) noexcept {
  return sum(k * to0, -(k * from0)) + sum(k * to1, -(k * from1));
}

/// The offset of centres times 2^-exponent.
struct Offset {
  FastDoubleDouble<double> x, y;
  int exponent;
};

inline Offset offset_of_centres(const Form& a, const Form& b, double k, int exponent) noexcept {
  return {differences(b.from.x, b.to.x, a.from.x, a.to.x, k), differences(b.from.y, b.to.y, a.from.y, a.to.y, k),
          exponent};
}

/// Nothing is halved where it might be subnormal; differences that overflow are formed at an eighth.
inline Offset offset_of_centres(const Form& a, const Form& b) noexcept {
  const Offset twice = offset_of_centres(a, b, 1, -1);
  const double all = (twice.x.high + twice.x.low) + (twice.y.high + twice.y.low);
  return all - all == 0 ? twice : offset_of_centres(a, b, 0.125, 2);
}

inline double sign(double x) noexcept { return x < 0 ? -1 : x > 0 ? 1 : 0; }

/// Exponent of a size whose axis has the exponent k; very small for 0.
inline int length_exponent(double size, int k) noexcept { return size == 0 ? -5000 : exponent_of(size) + k; }

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
  const int k1 = exponent_of(lane::max(lane::abs(first.u.x), lane::abs(first.u.y)));
  const int k2 = exponent_of(lane::max(lane::abs(second.u.x), lane::abs(second.u.y)));
  const int exponents[6] = {length_exponent(d.x.high, d.exponent), length_exponent(d.y.high, d.exponent),
                            length_exponent(first.a, k1),          length_exponent(first.b, k1),
                            length_exponent(second.a, k2),         length_exponent(second.b, k2)};
  int unit = -5000;
  for (const int e : exponents) unit = e > unit ? e : unit;
  if (unit == -5000) unit = 0;
  const auto in_unit = [&](const FastDoubleDouble<double>& t) {
    return FastDoubleDouble<double>{scale(t.high, d.exponent - unit), scale(t.low, d.exponent - unit)};
  };
  return {placed_shape(first, k1, unit),
          placed_shape(second, k2, unit),
          {in_unit(d.x), in_unit(d.y)},
          {sign(d.x.high), sign(d.y.high)},
          unit};
}

/// Two boxes as they are; for rectangles the same as box_pair() of these.
inline BoxPair<double> box_pair(const Form& a, const Form& b) noexcept {
  const Offset twice = offset_of_centres(a, b, 1, -1);
  return {{a.u.x, a.u.y, a.a, a.b},
          {b.u.x, b.u.y, b.a, b.b},
          {{0.5 * twice.x.high, 0.5 * twice.x.low}, {0.5 * twice.y.high, 0.5 * twice.y.low}}};
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
