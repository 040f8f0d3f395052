// SPDX-License-Identifier: Apache-2.0
/// Contact of points, segments and AABBs with segments, by the sides of a segment's line that points are on: exact for
/// stored numbers of any length, unless their exponents are far apart. For what the filters leave open, one pair at a
/// time.
#pragma once

#include <vesica/filter/comparison.hpp>
#include <vesica/filter/ways.hpp>

namespace vesica::filter {

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
VESICA_INLINE constexpr Verdict<bool> by_residues(const Point<double>& p, const Segment<double>& s) noexcept {
  using Number = typename Unit::Number;
  Unit unit(p.x, p.y, s.x0, s.y0, s.x1, s.y1);
  if (!unit.is_ordinary()) return {false, false};
  const Spot<Number> a(s.x0, s.y0, unit);
  const bool on_line = sign(cross(a.to({s.x1, s.y1, unit}), a.to({p.x, p.y, unit}))) == 0;
  const bool in_bounds = both(intervals_meet(p.x, p.x, s.x0, s.x1), intervals_meet(p.y, p.y, s.y0, s.y1));
  return compared(unit.holds(), both(on_line, in_bounds));
}

/// Neither segment is on one side of the other's line, and both are at one place along either coordinate. The latter
/// tells of segments on one line, and of those of no length, for which every point is on the line.
template <class Unit>
VESICA_INLINE constexpr Verdict<bool> by_residues(const Segment<double>& s, const Segment<double>& t) noexcept {
  using Number = typename Unit::Number;
  Unit unit(s.x0, s.y0, s.x1, s.y1, t.x0, t.y0, t.x1, t.y1);
  if (!unit.is_ordinary()) return {false, false};
  const Spot<Number> a(s.x0, s.y0, unit), c(t.x0, t.y0, unit);
  const Way<Number> along_s = a.to({s.x1, s.y1, unit}), along_t = c.to({t.x1, t.y1, unit}), across = a.to(c);
  const Quadratic<Number> of_c = cross(along_s, across), of_a = cross(across, along_t), turn = cross(along_s, along_t);
  const bool apart = either(on_one_side(sign(of_c), sign(of_c + turn)), on_one_side(sign(of_a), sign(of_a - turn)));
  const bool in_bounds = both(intervals_meet(s.x0, s.x1, t.x0, t.x1), intervals_meet(s.y0, s.y1, t.y0, t.y1));
  return compared(unit.holds(), and_not(in_bounds, apart));
}

/// The separating axes are the coordinates and the segment's normal, along which two opposite corners of the box are
/// extreme.
template <class Unit>
VESICA_INLINE constexpr Verdict<bool> by_residues(const Segment<double>& s, const Aabb<double>& box) noexcept {
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

}  // namespace vesica::filter
