// SPDX-License-Identifier: Apache-2.0
/// Contact of rectangles with points, segments, AABBs and rectangles, by separating axes in integers: exact for stored
/// numbers of any length, unless the exponents of coordinates, of axes or of sizes are far apart. For what the filters
/// leave open, one pair at a time.
///
/// A coordinate is a multiple of a unit P, an axis of U, a size of H. P = 2^(64 + s) U H, with s >= 0: lengths that are
/// coordinates and lengths that are sizes times axes differ by s places and a limb.
#pragma once

#include <vesica/filter/box.hpp>
#include <vesica/filter/comparison.hpp>
#include <vesica/filter/residues.hpp>

namespace vesica::filter {

using AxisUnit = UnitOf64<63>;
using SizeUnit = UnitOf64<63>;
using PlaceUnit = NearUnit;

/// The units of a pair. Of shapes with corners twice the coordinates count, and P = 2^(65 + s) U H.
template <bool has_corners>
struct BoxUnits {
  PlaceUnit places;
  AxisUnit axes;
  SizeUnit sizes;
  int shift;  // s

  static constexpr int most = 48;

  VESICA_INLINE constexpr BoxUnits(const PlaceUnit& places_, const AxisUnit& axes_, const SizeUnit& sizes_) noexcept
      : places(places_), axes(axes_), sizes(sizes_) {
    constexpr int limb = has_corners ? 65 : 64;
    sizes.raise(places.exponent() - axes.exponent() - limb - most);
    const int least = axes.exponent() + sizes.exponent() + limb;
    places.raise(least);
    shift = places.exponent() - least;
  }
  VESICA_INLINE constexpr bool are_ordinary() const noexcept {
    return both(places.is_ordinary(), both(axes.is_ordinary(), sizes.is_ordinary()));
  }
};

/// A vector in units.
struct VectorInUnits {
  Integer64 x, y;

  VESICA_INLINE constexpr VectorInUnits operator+(const VectorInUnits& v) const noexcept { return {x + v.x, y + v.y}; }
  VESICA_INLINE constexpr VectorInUnits operator-(const VectorInUnits& v) const noexcept { return {x - v.x, y - v.y}; }
};
VESICA_INLINE constexpr Residue128 dot(const VectorInUnits& a, const VectorInUnits& b) noexcept {
  return a.x * b.x + a.y * b.y;
}
VESICA_INLINE constexpr Residue128 cross(const VectorInUnits& a, const VectorInUnits& b) noexcept {
  return a.x * b.y - a.y * b.x;
}

struct RectInUnits {
  VectorInUnits axis;
  Integer64 hx, hy;

  template <class Units>
  VESICA_INLINE constexpr RectInUnits(const Rect<double>& r, Units& units) noexcept
      : axis{units.axes.number(r.ux), units.axes.number(r.uy)},
        hx(units.sizes.number(r.hx)),
        hy(units.sizes.number(r.hy)) {}
  VESICA_INLINE constexpr bool is_valid() const noexcept {
    return both((hx.n | hy.n) >= 0, (axis.x.n | axis.y.n) != 0);
  }
};

/// A half side, and what an axis is along it.
struct Reach {
  Integer64 size;
  Residue128 along;
};

/// Along an axis: how far centres are apart, a multiple of 2^64, and how far half sides reach.
template <int count>
struct OnAxis {
  Residue128 between;
  Reach reach[count];

  /// By how much half sides reach farther, over 2^64, without the last limb of what the axis is along them: less than
  /// 2^63 more would be right.
  VESICA_INLINE constexpr Residue128 slack() const noexcept {
    Residue128 sum{0, 0};
    for (const auto& [size, along] : reach) sum = sum + product(static_cast<std::uint64_t>(size.n), along.high);
    return sum - between;
  }
  VESICA_INLINE constexpr bool has_gap() const noexcept {
    Residue128 sum{0, 0};
    for (const auto& [size, along] : reach) sum = sum + product(static_cast<std::uint64_t>(size.n), along.low);
    return (slack() + Residue128{sum.high, 0}).is_negative();
  }
};

/// The same along a coordinate axis, where all digits are at hand.
struct OnUprightAxis {
  Residue128 all;

  VESICA_INLINE constexpr Residue128 slack() const noexcept { return all; }
  VESICA_INLINE constexpr bool has_gap() const noexcept { return all.is_negative(); }
};

/// Whether there is a gap along any axis: mostly the leading digits tell.
template <class... Axis>
VESICA_INLINE constexpr bool any_gap(const Axis&... axis) noexcept {
  const Residue128 slack[] = {axis.slack()...};
  bool possible = false, certain = false;
  for (const Residue128& s : slack) {
    possible = either(possible, s.is_negative());
    certain = either(certain, (s + Residue128{0, 1}).is_negative());
  }
  if (certain == possible) return certain;
  return (axis.has_gap() || ...);
}

/// Shifts by a pair's s, and remembers what was lost.
class Shift {
 public:
  VESICA_INLINE constexpr explicit Shift(int places) noexcept : places_(places) {}

  VESICA_INLINE constexpr Integer64 operator()(Integer64 a) noexcept {
    lost_ |= beyond(a.n);
    return {static_cast<std::int64_t>(static_cast<std::uint64_t>(a.n) << places_)};
  }
  VESICA_INLINE constexpr VectorInUnits operator()(const VectorInUnits& v) noexcept {
    return {(*this)(v.x), (*this)(v.y)};
  }
  VESICA_INLINE constexpr Residue128 operator()(const Residue128& a) noexcept {
    lost_ |= beyond(static_cast<std::int64_t>(a.high));
    return a.shifted(places_);
  }
  VESICA_INLINE constexpr bool held() const noexcept { return lost_ == 0; }

 private:
  VESICA_INLINE constexpr std::int64_t beyond(std::int64_t a) const noexcept { return (a ^ a >> 63) >> (62 - places_); }
  int places_;
  std::int64_t lost_ = 0;
};

/// Where nothing was lost: whether any gap along an axis is positive.
template <bool has_corners, class... Axis>
VESICA_INLINE constexpr Verdict<bool> by_slack(const BoxUnits<has_corners>& units, const Shift& shift, bool valid,
                                              const Axis&... axis) noexcept {
  const bool held = both(units.places.holds_with(units.axes, units.sizes), shift.held());
  return compared(both(held, valid), !any_gap(axis...));
}

template <bool has_corners>
VESICA_INLINE constexpr VectorInUnits in_places(double x, double y, BoxUnits<has_corners>& units) noexcept {
  return {units.places.number(x), units.places.number(y)};
}

// Whether two shapes overlap; undecided where exponents are too far apart for the units, or a shape is invalid.

VESICA_INLINE constexpr Verdict<bool> by_axes(const Point<double>& p, const Rect<double>& r) noexcept {
  BoxUnits<false> units(PlaceUnit(p.x, p.y, r.cx, r.cy), AxisUnit(r.ux, r.uy), SizeUnit(r.hx, r.hy));
  if (!units.are_ordinary()) return {false, false};
  Shift shift(units.shift);
  const RectInUnits b(r, units);
  const VectorInUnits d = shift(in_places(p.x, p.y, units) - in_places(r.cx, r.cy, units));
  const Residue128 uu = dot(b.axis, b.axis);
  return by_slack(units, shift, b.is_valid(), OnAxis<1>{dot(b.axis, d).magnitude(), {{b.hx, uu}}},
                 OnAxis<1>{cross(b.axis, d).magnitude(), {{b.hy, uu}}});
}

VESICA_INLINE constexpr Verdict<bool> by_axes(const Rect<double>& first, const Rect<double>& second) noexcept {
  BoxUnits<false> units(PlaceUnit(first.cx, first.cy, second.cx, second.cy), AxisUnit(first.ux, first.uy, second.ux, second.uy), SizeUnit(first.hx, first.hy, second.hx, second.hy));
  if (!units.are_ordinary()) return {false, false};
  Shift shift(units.shift);
  const RectInUnits a(first, units), b(second, units);
  const VectorInUnits d = shift(in_places(second.cx, second.cy, units) - in_places(first.cx, first.cy, units));
  const Residue128 uu = dot(a.axis, a.axis), ww = dot(b.axis, b.axis), c = dot(a.axis, b.axis).magnitude(),
                   s = cross(a.axis, b.axis).magnitude();
  return by_slack(units, shift, both(a.is_valid(), b.is_valid()),
                 OnAxis<3>{dot(a.axis, d).magnitude(), {{a.hx, uu}, {b.hx, c}, {b.hy, s}}},
                 OnAxis<3>{cross(a.axis, d).magnitude(), {{a.hy, uu}, {b.hx, s}, {b.hy, c}}},
                 OnAxis<3>{dot(b.axis, d).magnitude(), {{b.hx, ww}, {a.hx, c}, {a.hy, s}}},
                 OnAxis<3>{cross(b.axis, d).magnitude(), {{b.hy, ww}, {a.hx, s}, {a.hy, c}}});
}

/// The axes of the rectangle and the segment's normal; where it has no length nothing parts the shapes along that.
VESICA_INLINE constexpr Verdict<bool> by_axes(const Segment<double>& segment, const Rect<double>& r) noexcept {
  BoxUnits<true> units(PlaceUnit(segment.x0, segment.y0, segment.x1, segment.y1, r.cx, r.cy), AxisUnit(r.ux, r.uy), SizeUnit(r.hx, r.hy));
  if (!units.are_ordinary()) return {false, false};
  Shift shift(units.shift);
  const RectInUnits b(r, units);
  const VectorInUnits centre = in_places(r.cx, r.cy, units), start = in_places(segment.x0, segment.y0, units),
                      end = in_places(segment.x1, segment.y1, units);
  const VectorInUnits d = (centre - start) + (centre - end), along = end - start;
  const Residue128 uu = dot(b.axis, b.axis), c = dot(b.axis, along).magnitude(), s = cross(b.axis, along).magnitude();
  return by_slack(units, shift, b.is_valid(), OnAxis<1>{shift(dot(b.axis, d).magnitude() - c), {{b.hx, uu}}},
                 OnAxis<1>{shift(cross(b.axis, d).magnitude() - s), {{b.hy, uu}}},
                 OnAxis<2>{shift(cross(along, d).magnitude()), {{b.hx, s}, {b.hy, c}}});
}

/// By how much the half sides of an AABB and a rectangle reach farther along a coordinate axis than d.
VESICA_INLINE constexpr OnUprightAxis upright(Integer64 d, Integer64 width, Integer64 hx, Integer64 ux, Integer64 hy,
                                              Integer64 uy, Shift& shift) noexcept {
  const Integer64 between = shift(d.magnitude() - width);
  return {(hx * ux + hy * uy) - Residue128{0, static_cast<std::uint64_t>(between.n)}};
}
VESICA_INLINE constexpr Verdict<bool> by_axes(const Aabb<double>& box, const Rect<double>& r) noexcept {
  BoxUnits<true> units(PlaceUnit(box.min_x, box.min_y, box.max_x, box.max_y, r.cx, r.cy), AxisUnit(r.ux, r.uy), SizeUnit(r.hx, r.hy));
  if (!units.are_ordinary()) return {false, false};
  Shift shift(units.shift);
  const RectInUnits b(r, units);
  const VectorInUnits centre = in_places(r.cx, r.cy, units), min = in_places(box.min_x, box.min_y, units),
                      max = in_places(box.max_x, box.max_y, units);
  const VectorInUnits d = (centre - min) + (centre - max), size = max - min;
  const Integer64 ux = b.axis.x.magnitude(), uy = b.axis.y.magnitude();
  const Residue128 uu = dot(b.axis, b.axis);
  const bool valid = both(b.is_valid(), (size.x.n | size.y.n) >= 0);
  return by_slack(units, shift, valid,
                 OnAxis<1>{shift(dot(b.axis, d).magnitude() - (ux * size.x + uy * size.y)), {{b.hx, uu}}},
                 OnAxis<1>{shift(cross(b.axis, d).magnitude() - (uy * size.x + ux * size.y)), {{b.hy, uu}}},
                 upright(d.x, size.x, b.hx, ux, b.hy, uy, shift),
                 upright(d.y, size.y, b.hx, uy, b.hy, ux, shift));
}

/// Has one of an axis's two numbers more digits than these?
VESICA_INLINE constexpr bool has_long_axis(const Rect<double>& r, int digits) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(r.ux) | std::bit_cast<std::uint64_t>(r.uy);
  return bits << (11 + digits) != 0;
}

/// Pairs that by_axes() knows.
template <class A, class B>
concept HasAxes = has_wide_products && requires(const A& a, const B& b) {
  by_axes(a, b);
};

}  // namespace vesica::filter
