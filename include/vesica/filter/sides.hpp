// SPDX-License-Identifier: Apache-2.0
/// Contact of points, segments and AABBs with segments, by the sides of a segment's line that points are on: exact for
/// stored numbers of any length, unless their exponents are far apart. For what the filters leave open, one pair at a time.
#pragma once

#include <vesica/filter/comparison.hpp>
#include <vesica/filter/error_free.hpp>
#include <vesica/filter/residues.hpp>

namespace vesica::filter {

/// The way from one stored point to another: rounded, and in units.
template <class Number>
struct Way {
  double x, y;
  Number in_units_x, in_units_y;
};

/// A stored point.
template <class Number>
struct Spot {
  double x, y;
  Number in_units_x, in_units_y;

  template <class Unit>
  VESICA_INLINE constexpr Spot(double x_, double y_, Unit& unit) noexcept
      : x(x_), y(y_), in_units_x(unit.number(x_)), in_units_y(unit.number(y_)) {}
  VESICA_INLINE constexpr Way<Number> to(const Spot& p) const noexcept {
    return {p.x - x, p.y - y, p.in_units_x - in_units_x, p.in_units_y - in_units_y};
  }
};

/// A cross product of two ways, or a sum of two of these. As `magnitude` is the sum M of the magnitudes of its terms.
template <class Number>
struct Cross {
  double value, magnitude;
  Residue128 in_units;
};

template <class Number>
VESICA_INLINE constexpr Cross<Number> cross(const Way<Number>& a, const Way<Number>& b) noexcept {
  const double left = a.x * b.y, right = a.y * b.x;
  return {left - right, abs(left) + abs(right), a.in_units_x * b.in_units_y - a.in_units_y * b.in_units_x};
}
template <class Number>
VESICA_INLINE constexpr Cross<Number> operator+(const Cross<Number>& a, const Cross<Number>& b) noexcept {
  return {a.value + b.value, a.magnitude + b.magnitude, a.in_units + b.in_units};
}
template <class Number>
VESICA_INLINE constexpr Cross<Number> operator-(const Cross<Number>& a, const Cross<Number>& b) noexcept {
  return {a.value - b.value, a.magnitude + b.magnitude, a.in_units - b.in_units};
}

/// A number with the sign of a cross product D of two differences, which may have been computed as the sum of two such.
///
/// In near units differences are below 2^63, so that |D| < 2^127, and its residue has its sign.
///
/// In far units, G, differences are below 2^87. As G >= 2^-400 no product underflows: terms err by 3u of themselves, their
/// difference by u more, and a sum of two by u again, in all by less than 6u M, with room for what is of second order
/// (u = 2^-53). So beyond 8u M the rounded value has the sign of D. Elsewhere |D| <= 14u M, where M has four terms at most, below
/// 2^176 G^2 together: |D| < 2^127 G^2, and its residue has its sign.
template <class Number>
VESICA_INLINE constexpr std::int64_t sign(const Cross<Number>& d) noexcept {
  if constexpr (std::is_same_v<Number, Integer64>) return d.in_units.sign();
  const double residue = std::bit_cast<double>(d.in_units.sign());
  return std::bit_cast<std::int64_t>(select(abs(d.value) > 0x1p-50 * d.magnitude, d.value, residue));
}

VESICA_INLINE constexpr bool on_one_side(std::int64_t a, std::int64_t b) noexcept {
  return either(both(a > 0, b > 0), both(a < 0, b < 0));
}

/// Whether the intervals from a0 to a1 and from b0 to b1, in either order, share a number.
VESICA_INLINE constexpr bool intervals_meet(double a0, double a1, double b0, double b1) noexcept {
  return both(max(a0, a1) >= min(b0, b1), max(b0, b1) >= min(a0, a1));
}

// Whether two shapes overlap; undecided where exponents are too far apart for the unit, or a shape is invalid.

/// On the line, and where the segment is along both coordinates. Of a segment of no length every point is on the line.
template <class Unit>
VESICA_INLINE constexpr Verdict<bool> by_sides(const Point<double>& p, const Segment<double>& s) noexcept {
  using Number = typename Unit::Number;
  Unit unit(p.x, p.y, s.x0, s.y0, s.x1, s.y1);
  if (!unit.is_ordinary()) return {false, false};
  const Spot<Number> a(s.x0, s.y0, unit);
  const bool on_line = sign(cross(a.to({s.x1, s.y1, unit}), a.to({p.x, p.y, unit}))) == 0;
  const bool in_bounds = both(intervals_meet(p.x, p.x, s.x0, s.x1), intervals_meet(p.y, p.y, s.y0, s.y1));
  return compared(unit.holds(), both(on_line, in_bounds));
}

/// Neither segment is on one side of the other's line, and both are at one place along either coordinate. The latter tells
/// of segments on one line, and of those of no length, for which every point is on the line.
template <class Unit>
VESICA_INLINE constexpr Verdict<bool> by_sides(const Segment<double>& s, const Segment<double>& t) noexcept {
  using Number = typename Unit::Number;
  Unit unit(s.x0, s.y0, s.x1, s.y1, t.x0, t.y0, t.x1, t.y1);
  if (!unit.is_ordinary()) return {false, false};
  const Spot<Number> a(s.x0, s.y0, unit), c(t.x0, t.y0, unit);
  const Way<Number> along_s = a.to({s.x1, s.y1, unit}), along_t = c.to({t.x1, t.y1, unit}), across = a.to(c);
  const Cross<Number> of_c = cross(along_s, across), of_a = cross(across, along_t), turn = cross(along_s, along_t);
  const bool apart = either(on_one_side(sign(of_c), sign(of_c + turn)), on_one_side(sign(of_a), sign(of_a - turn)));
  const bool in_bounds = both(intervals_meet(s.x0, s.x1, t.x0, t.x1), intervals_meet(s.y0, s.y1, t.y0, t.y1));
  return compared(unit.holds(), and_not(in_bounds, apart));
}

/// The separating axes are the coordinates and the segment's normal, along which two opposite corners of the box are extreme.
template <class Unit>
VESICA_INLINE constexpr Verdict<bool> by_sides(const Segment<double>& s, const Aabb<double>& box) noexcept {
  using Number = typename Unit::Number;
  Unit unit(s.x0, s.y0, s.x1, s.y1, box.min_x, box.min_y, box.max_x, box.max_y);
  if (!unit.is_ordinary()) return {false, false};
  const bool rightwards = s.x1 > s.x0, upwards = s.y1 > s.y0;
  const Spot<Number> a(s.x0, s.y0, unit);
  const Spot<Number> left(select(upwards, box.min_x, box.max_x), select(rightwards, box.max_y, box.min_y), unit);
  const Spot<Number> right(select(upwards, box.max_x, box.min_x), select(rightwards, box.min_y, box.max_y), unit);
  const Way<Number> along = a.to({s.x1, s.y1, unit});
  const bool line_meets = both(sign(cross(along, a.to(left))) >= 0, sign(cross(along, a.to(right))) <= 0);
  const bool in_bounds =
      both(intervals_meet(s.x0, s.x1, box.min_x, box.max_x), intervals_meet(s.y0, s.y1, box.min_y, box.max_y));
  const bool valid = both(box.min_x <= box.max_x, box.min_y <= box.max_y);
  return compared(both(unit.holds(), valid), both(in_bounds, line_meets));
}

/// Pairs that by_sides() knows.
template <class A, class B>
concept HasSides = requires(const A& a, const B& b) {
  by_sides<NearUnit>(a, b);
};

}  // namespace vesica::filter
