// SPDX-License-Identifier: Apache-2.0
/// Contact of rectangles with points, segments, AABBs and rectangles, by separating axes in integers: exact for stored
/// numbers of any length, unless the exponents of coordinates, of axes or of sizes are far apart. For what the filters
/// leave open, one pair at a time.
///
/// Twice a coordinate is a multiple of a unit C, an axis of U, a size of H. So twice a rectangle's half side, size
/// times axis, is one of 2 U H. Lengths are of a like magnitude, so that this is finer: C = 2^e U H with e >= 1.
#pragma once

#include <vesica/filter/box.hpp>
#include <vesica/filter/comparison.hpp>
#include <vesica/filter/residues.hpp>

namespace vesica::filter {

/// A vector: what is a multiple of C, in units of C, and the rest in units of 2 U H.
struct SplitVector {
  Integer64 x, y;
  Residue128 fine_x, fine_y;

  VESICA_INLINE constexpr SplitVector operator-(const SplitVector& v) const noexcept {
    return {x - v.x, y - v.y, fine_x - v.fine_x, fine_y - v.fine_y};
  }
  /// Its opposite where the mask is of ones, itself where it is 0.
  VESICA_INLINE constexpr SplitVector flipped(std::uint64_t mask) const noexcept {
    return {x.flipped(mask), y.flipped(mask), fine_x.flipped(mask), fine_y.flipped(mask)};
  }
};

/// A box in units: its axis in any, and twice its half sides, along the axis and across it.
struct BoxInUnits {
  Integer64 ux, uy;
  SplitVector along, across;
};

/// What separates two boxes along an axis n: |n.D| less |n.s| for all half sides s. It is n.V, where V is the sum of D
/// and all s, each with the sign by which it counts. All are whole numbers, and none is rounded.
///
/// In the part of V in units of C each coordinate counts twice at most: it is below 2^63. Where held(), it is below
/// 2^126 U H, too; else boxes are far apart. The other part is at most all sizes' sum times all axes' sum, below 2^125.
/// So V is below 2^127, and n.V below 2^190, as |n_x| + |n_y| is at most 2^62, but for a last place.
class AxisGaps {
 public:
  /// D twice, in units of C = 2^e (2 U H).
  VESICA_INLINE constexpr AxisGaps(Integer64 dx, Integer64 dy, int e) noexcept
      : offset_{dx, dy, {0, 0}, {0, 0}}, e_(e) {}

  /// Whether a gap parts the boxes along the axis of `a` or across it.
  VESICA_INLINE constexpr bool part(const BoxInUnits& a, const BoxInUnits& b) noexcept {
    const bool along = part(a.ux, a.uy, a.along, b), across = part(-a.uy, a.ux, a.across, b);
    return either(along, across);
  }
  VESICA_INLINE constexpr bool held() const noexcept { return !lost_; }

 private:
  VESICA_INLINE constexpr bool part(Integer64 nx, Integer64 ny, const SplitVector& own,
                                    const BoxInUnits& other) noexcept {
    const auto sign = [&](Integer64 x, Integer64 y) { return std::uint64_t{0} - ((nx * x + ny * y).high >> 63); };
    const SplitVector v = offset_.flipped(sign(offset_.x, offset_.y)) - own -
                          other.along.flipped(sign(other.ux, other.uy)) -
                          other.across.flipped(sign(-other.uy, other.ux));
    const int room = 126 - e_ < 63 ? 126 - e_ : 63;
    lost_ = either(lost_, either(v.x.n >> room != v.x.n >> 63, v.y.n >> room != v.y.n >> 63));
    return (nx * (v.x.shifted(e_) + v.fine_x) + ny * (v.y.shifted(e_) + v.fine_y)).is_positive();
  }

  SplitVector offset_;
  int e_;
  bool lost_ = false;
};

using AxisUnit = NearUnit;
using SizeUnit = NearUnit;
using PlaceUnit = UnitOf64<61>;

VESICA_INLINE constexpr BoxInUnits in_units(const Rect<double>& r, PlaceUnit&, AxisUnit& axes,
                                            SizeUnit& sizes) noexcept {
  const Integer64 ux = axes.number(r.ux), uy = axes.number(r.uy), hx = sizes.number(r.hx), hy = sizes.number(r.hy);
  return {ux, uy, {{0}, {0}, hx * ux, hx * uy}, {{0}, {0}, hy * -uy, hy * ux}};
}
VESICA_INLINE constexpr BoxInUnits in_units(const Segment<double>& s, PlaceUnit& places, AxisUnit&,
                                            SizeUnit&) noexcept {
  const Integer64 x = places.number(s.x1) - places.number(s.x0), y = places.number(s.y1) - places.number(s.y0);
  return {x, y, {x, y, {0, 0}, {0, 0}}, {}};
}
VESICA_INLINE constexpr BoxInUnits in_units(const Aabb<double>& box, PlaceUnit& places, AxisUnit&, SizeUnit&) noexcept {
  const Integer64 width = places.number(box.max_x) - places.number(box.min_x);
  const Integer64 height = places.number(box.max_y) - places.number(box.min_y);
  return {{1}, {0}, {width, {0}, {0, 0}, {0, 0}}, {{0}, height, {0, 0}, {0, 0}}};
}
VESICA_INLINE constexpr BoxInUnits in_units(const Point<double>&, PlaceUnit&, AxisUnit&, SizeUnit&) noexcept {
  return {{1}, {0}, {}, {}};
}

VESICA_INLINE constexpr bool valid_if_finite(const Point<double>&) noexcept { return true; }
VESICA_INLINE constexpr bool valid_if_finite(const Segment<double>&) noexcept { return true; }
VESICA_INLINE constexpr bool valid_if_finite(const Aabb<double>& box) noexcept {
  return both(box.min_x <= box.max_x, box.min_y <= box.max_y);
}
VESICA_INLINE constexpr bool valid_if_finite(const Rect<double>& r) noexcept {
  return both(both(r.hx >= 0, r.hy >= 0), either(r.ux != 0, r.uy != 0));
}

/// By the units of a pair. A segment of no length has no axis, along which nothing then parts the boxes.
template <class A>
VESICA_INLINE constexpr Verdict<bool> by_axes(const A& a, const Rect<double>& b, PlaceUnit places, AxisUnit axes,
                                              SizeUnit sizes) noexcept {
  const int e = places.exponent() - axes.exponent() - sizes.exponent() - 1;
  if (!(both(both(places.is_ordinary(), axes.is_ordinary()), both(sizes.is_ordinary(), in_range(e, 0, 125))))) {
    return {false, false};
  }
  const BoxInUnits box_a = in_units(a, places, axes, sizes), box_b = in_units(b, places, axes, sizes);
  const Corners<double> from = detail::form::corners(place(a));
  const Integer64 x = places.number(b.cx), y = places.number(b.cy);
  AxisGaps gaps((x - places.number(from.x0)) + (x - places.number(from.x1)),
                (y - places.number(from.y0)) + (y - places.number(from.y1)), e);
  bool apart = gaps.part(box_b, box_a);
  if constexpr (!std::is_same_v<A, Point<double>>) apart = either(apart, gaps.part(box_a, box_b));
  const bool held = both(both(places.holds(), axes.holds()), both(sizes.holds(), gaps.held()));
  return compared(both(held, both(valid_if_finite(a), valid_if_finite(b))), !apart);
}

// Whether two shapes overlap; undecided where exponents are too far apart for the units, or a shape is invalid.

VESICA_INLINE constexpr Verdict<bool> by_axes(const Point<double>& a, const Rect<double>& b) noexcept {
  return by_axes(a, b, PlaceUnit(a.x, a.y, b.cx, b.cy), AxisUnit(b.ux, b.uy), SizeUnit(b.hx, b.hy));
}
VESICA_INLINE constexpr Verdict<bool> by_axes(const Segment<double>& a, const Rect<double>& b) noexcept {
  return by_axes(a, b, PlaceUnit(a.x0, a.y0, a.x1, a.y1, b.cx, b.cy), AxisUnit(b.ux, b.uy), SizeUnit(b.hx, b.hy));
}
VESICA_INLINE constexpr Verdict<bool> by_axes(const Aabb<double>& a, const Rect<double>& b) noexcept {
  return by_axes(a, b, PlaceUnit(a.min_x, a.min_y, a.max_x, a.max_y, b.cx, b.cy), AxisUnit(b.ux, b.uy),
                 SizeUnit(b.hx, b.hy));
}
VESICA_INLINE constexpr Verdict<bool> by_axes(const Rect<double>& a, const Rect<double>& b) noexcept {
  return by_axes(a, b, PlaceUnit(a.cx, a.cy, b.cx, b.cy), AxisUnit(a.ux, a.uy, b.ux, b.uy),
                 SizeUnit(a.hx, a.hy, b.hx, b.hy));
}

/// Where this is so, error_free() cannot hold: the square of a number of 29 digits or more has at least 57.
VESICA_INLINE constexpr bool has_long_axis(const Rect<double>& r) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(r.ux) | std::bit_cast<std::uint64_t>(r.uy);
  return (bits & 0x1ffffff) != 0;
}

/// Pairs that by_axes() knows.
template <class A, class B>
concept HasAxes = has_wide_products && requires(const A& a, const B& b) {
  by_axes(a, b);
};

}  // namespace vesica::filter
