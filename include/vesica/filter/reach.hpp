// SPDX-License-Identifier: Apache-2.0
/// Contact of circles with points, circles, AABBs and segments, by squares of lengths: exact for stored numbers of any
/// length, unless their exponents are far apart. For what the filters leave open, one pair at a time.
#pragma once

#include <vesica/filter/comparison.hpp>
#include <vesica/filter/sides.hpp>
#include <vesica/filter/ways.hpp>

namespace vesica::filter {

/// Is a point, (x, y), in a circle?
template <class Unit>
VESICA_INLINE constexpr Verdict<bool> in_circle(double x, double y, const Circle<double>& c) noexcept {
  using Number = typename Unit::Number;
  Unit unit(x, y, c.cx, c.cy, c.r);
  if (!unit.is_ordinary()) return {false, false};
  const Spot<Number> centre(c.cx, c.cy, unit);
  const Way<Number> way = centre.to({x, y, unit});
  const Quadratic<Number> gap = dot(way, way) - square(Span<Number>(c.r, unit));
  return compared(both(unit.holds(), c.r >= 0), sign(gap) <= 0);
}

// Whether two shapes overlap; undecided where exponents are too far apart for the unit, or a shape is invalid.

template <class Unit>
VESICA_INLINE constexpr Verdict<bool> by_residues(const Point<double>& p, const Circle<double>& c) noexcept {
  return in_circle<Unit>(p.x, p.y, c);
}

/// By the box's point that is nearest to the centre: its coordinates are stored numbers.
template <class Unit>
VESICA_INLINE constexpr Verdict<bool> by_residues(const Circle<double>& c, const Aabb<double>& box) noexcept {
  const double x = min(max(c.cx, box.min_x), box.max_x), y = min(max(c.cy, box.min_y), box.max_y);
  const Verdict<bool> verdict = in_circle<Unit>(x, y, c);
  return guarded(valid_aabb(box), verdict.overlap, verdict.disjoint);
}

template <class Unit>
VESICA_INLINE constexpr Verdict<bool> by_residues(const Circle<double>& a, const Circle<double>& b) noexcept {
  using Number = typename Unit::Number;
  Unit unit(a.cx, a.cy, a.r, b.cx, b.cy, b.r);
  if (!unit.is_ordinary()) return {false, false};
  const Spot<Number> centre(a.cx, a.cy, unit);
  const Way<Number> way = centre.to({b.cx, b.cy, unit});
  const Quadratic<Number> gap = dot(way, way) - square(Span<Number>(a.r, unit) + Span<Number>(b.r, unit));
  return compared(both(unit.holds(), both(a.r >= 0, b.r >= 0)), sign(gap) <= 0);
}

/// At one of the ends if the centre is beyond it along the segment, else by the distance from the line:
/// (along x to_centre)^2 <= r^2 |along|^2, below 2^254 and 2^251 units. For near units alone.
template <class Unit>
requires std::is_same_v<Unit, NearUnit> VESICA_INLINE constexpr Verdict<bool> by_residues(
    const Segment<double>& s, const Circle<double>& c) noexcept {
  Unit unit(s.x0, s.y0, s.x1, s.y1, c.cx, c.cy, c.r);
  if (!unit.is_ordinary()) return {false, false};
  using Number = typename Unit::Number;
  const Spot<Number> start(s.x0, s.y0, unit), end(s.x1, s.y1, unit), centre(c.cx, c.cy, unit);
  const Way<Number> along = start.to(end), from_start = start.to(centre), from_end = end.to(centre);
  const Quadratic<Number> reached = square(Span<Number>(c.r, unit));
  const bool valid = both(unit.holds(), c.r >= 0);
  if (sign(dot(along, from_start)) <= 0) return compared(valid, sign(dot(from_start, from_start) - reached) <= 0);
  if (sign(dot(along, from_end)) >= 0) return compared(valid, sign(dot(from_end, from_end) - reached) <= 0);
  const Residue128 aside = cross(along, from_start).in_units.magnitude();
  return compared(valid, product(aside, aside) <= product(reached.in_units, dot(along, along).in_units));
}

/// Pairs that by_residues() knows in such units.
template <class A, class B, class Unit = NearUnit>
concept HasResidues = requires(const A& a, const B& b) {
  by_residues<Unit>(a, b);
};

}  // namespace vesica::filter
