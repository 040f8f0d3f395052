// SPDX-License-Identifier: Apache-2.0
/// Contact of points, segments and AABBs with segments, by the sides of a segment's line that points are on: exact for
/// stored numbers of any length, unless their exponents are far apart. For what the filters leave open, one pair at a time.
#pragma once

#include <vesica/filter/comparison.hpp>
#include <vesica/filter/error_free.hpp>
#include <vesica/filter/residues.hpp>

namespace vesica::filter {

/// A point, and the same in units.
struct Spot {
  double x, y;
  Residue in_units_x, in_units_y;

  VESICA_INLINE constexpr Spot(double x_, double y_, const Unit& unit) noexcept
      : x(x_), y(y_), in_units_x(unit(x_)), in_units_y(unit(y_)) {}
  /// Where the vertical line through one point and the horizontal line through another cross.
  VESICA_INLINE constexpr Spot(const Spot& of_x, const Spot& of_y) noexcept
      : x(of_x.x), y(of_y.y), in_units_x(of_x.in_units_x), in_units_y(of_y.in_units_y) {}
};

/// Which side of a line a point is on; known() where every answer so far was certain.
///
/// Let D = L - R be the cross product of b - a and p - a, and M = |L| + |R| as computed. All numbers are multiples of
/// G >= 2^-400, so that no product underflows: L and R err by 3u of themselves, and d = L - R by u |d| more, in all by less
/// than 2^-50 M. Where |d| is beyond that, its sign is D's. Elsewhere |D| <= 2^-49 M, and D is a multiple of G^2. So where
/// M <= 2^175 G^2, D / G^2 is an integer of at most 2^126, and its residue modulo 2^128 has its sign. A number that is NaN or
/// infinite makes M NaN or infinite, and M is looked at always.
class Sides {
 public:
  VESICA_INLINE constexpr explicit Sides(const Unit& unit) noexcept
      : known_(unit.is_ordinary()), most_(known_ ? unit.of_degree_2(175) : 0) {}

  /// 1 to the left of the way from a to b, -1 to the right, 0 on the line, or where a is b.
  VESICA_INLINE constexpr int operator()(const Spot& a, const Spot& b, const Spot& p) noexcept {
    const double left = (b.x - a.x) * (p.y - a.y), right = (b.y - a.y) * (p.x - a.x);
    const double value = left - right, magnitude = abs(left) + abs(right);
    known_ = both(known_, magnitude <= most_);
    if (abs(value) > 0x1p-50 * magnitude) return value > 0 ? 1 : -1;
    const Residue of_left = (b.in_units_x - a.in_units_x) * (p.in_units_y - a.in_units_y);
    const Residue of_right = (b.in_units_y - a.in_units_y) * (p.in_units_x - a.in_units_x);
    return (of_left - of_right).sign();
  }
  VESICA_INLINE constexpr bool known() const noexcept { return known_; }

 private:
  bool known_;
  double most_;
};

/// Whether the intervals from a0 to a1 and from b0 to b1, in either order, share a number.
VESICA_INLINE constexpr bool intervals_meet(double a0, double a1, double b0, double b1) noexcept {
  return both(max(a0, a1) >= min(b0, b1), max(b0, b1) >= min(a0, a1));
}

/// On the line, and where the segment is along both coordinates. Of a segment of no length every point is on the line.
VESICA_INLINE constexpr Verdict<bool> by_sides(const Point<double>& p, const Segment<double>& s) noexcept {
  const Unit unit(p.x, p.y, s.x0, s.y0, s.x1, s.y1);
  Sides side(unit);
  const bool on_line = side({s.x0, s.y0, unit}, {s.x1, s.y1, unit}, {p.x, p.y, unit}) == 0;
  const bool in_bounds = both(intervals_meet(p.x, p.x, s.x0, s.x1), intervals_meet(p.y, p.y, s.y0, s.y1));
  return compared(side.known(), both(on_line, in_bounds));
}

/// Neither segment is on one side of the other's line, and both are at one place along either coordinate. The latter tells
/// of segments on one line, and of those of no length, for which every point is on the line.
VESICA_INLINE constexpr Verdict<bool> by_sides(const Segment<double>& s, const Segment<double>& t) noexcept {
  const Unit unit(s.x0, s.y0, s.x1, s.y1, t.x0, t.y0, t.x1, t.y1);
  Sides side(unit);
  const Spot a(s.x0, s.y0, unit), b(s.x1, s.y1, unit), c(t.x0, t.y0, unit), d(t.x1, t.y1, unit);
  const bool t_meets = side(a, b, c) * side(a, b, d) <= 0, s_meets = side(c, d, a) * side(c, d, b) <= 0;
  const bool in_bounds = both(intervals_meet(s.x0, s.x1, t.x0, t.x1), intervals_meet(s.y0, s.y1, t.y0, t.y1));
  return compared(side.known(), both(in_bounds, both(t_meets, s_meets)));
}

/// The separating axes are the coordinates and the segment's normal, along which two corners of the box are extreme.
VESICA_INLINE constexpr Verdict<bool> by_sides(const Segment<double>& s, const Aabb<double>& box) noexcept {
  const Unit unit(s.x0, s.y0, s.x1, s.y1, box.min_x, box.min_y, box.max_x, box.max_y);
  Sides side(unit);
  const Spot a(s.x0, s.y0, unit), b(s.x1, s.y1, unit), low(box.min_x, box.min_y, unit), high(box.max_x, box.max_y, unit);
  const bool rightwards = s.x1 > s.x0, upwards = s.y1 > s.y0;
  const Spot left(upwards ? low : high, rightwards ? high : low);
  const Spot right(upwards ? high : low, rightwards ? low : high);
  const bool line_meets = both(side(a, b, left) >= 0, side(a, b, right) <= 0);
  const bool in_bounds =
      both(intervals_meet(s.x0, s.x1, box.min_x, box.max_x), intervals_meet(s.y0, s.y1, box.min_y, box.max_y));
  const bool valid = both(box.min_x <= box.max_x, box.min_y <= box.max_y);
  return compared(both(side.known(), valid), both(in_bounds, line_meets));
}

/// Pairs that by_sides() knows.
template <class A, class B>
concept HasSides = requires(const A& a, const B& b) { by_sides(a, b); };

}  // namespace vesica::filter
