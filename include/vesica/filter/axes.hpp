// SPDX-License-Identifier: Apache-2.0
/// Contact of rectangles with points, segments, AABBs and rectangles, by separating axes in integers: exact for stored
/// numbers of any length, unless the exponents of coordinates, of axes or of sizes are far apart. For what the filters
/// leave open, one pair at a time.
///
/// Stored numbers are multiples of units: coordinates of P, axes of U, sizes of H, with P = 2^(64 + s) U H and s >= 0.
/// Along an axis, a vector that is not normalised, half sides reach multiples of U^2 H, and centres are multiples of
/// 2^64 U^2 H apart: the lowest limb of what is reached has no counterpart in the distance.
///
/// Proved: no number overflows.
///
///   - Up to the roundings of these sums, the magnitudes of all axes' numbers sum up to less than 2^63 U, those of
///     sizes to less than 2^63 H, and those of coordinates to less than 2^62 P; of shapes with corners to less than
///     2^61 P, and there twice a way between centres is below 2^62 P.
///   - |a.b| is at most the sum of a's magnitudes times the greater of b's. So dot and cross products are below 2^126,
///     and less another they are below 2^127.
///   - What Shift held is below 2^126.
///   - Sizes times products without their last limb are together below 2^63 2^62, and sizes times last limbs 2^127.
#pragma once

#include <cstddef>
#include <vesica/filter/box.hpp>
#include <vesica/filter/comparison.hpp>
#include <vesica/filter/residues.hpp>

namespace vesica::filter {

using AxisUnit = UnitOfAll<63>;
using SizeUnit = UnitOfAll<63>;
template <bool has_corners>
using PlaceUnit = UnitOfAll<has_corners ? 61 : 62>;

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

/// The units of a pair. Of shapes with corners twice the coordinates are taken: there P = 2^(65 + s) U H.
template <bool has_corners>
struct BoxUnits {
  PlaceUnit<has_corners> places;
  AxisUnit axes;
  SizeUnit sizes;
  int shift;  // s
  bool fit;   // all numbers are multiples

  static constexpr int most_shift = 48;

  /// Sizes may be small, or 0, beside coordinates: then their unit is coarser than they themselves would have it.
  template <std::size_t m, std::size_t n>
  VESICA_INLINE constexpr BoxUnits(const Numbers<m>& of_places, const Numbers<n>& of_axes,
                                   const Numbers<n>& of_sizes) noexcept
      : places(of_places), axes(of_axes), sizes(of_sizes) {
    constexpr int limb = has_corners ? 65 : 64;
    sizes.raise(places.exponent() - axes.exponent() - limb - most_shift);
    const int least = axes.exponent() + sizes.exponent() + limb;
    places.raise(least);
    shift = places.exponent() - least;
    fit = both(places.is_ordinary(), both(axes.is_ordinary(), sizes.is_ordinary())) && places.divides(of_places) &&
          axes.divides(of_axes) && sizes.divides(of_sizes);
  }
  VESICA_INLINE constexpr VectorInUnits place(double x, double y) const noexcept {
    return {places.number(x), places.number(y)};
  }
};

/// Sizes are multiples of H, the axis of U.
struct RectInUnits {
  VectorInUnits axis;
  Integer64 hx, hy;

  template <class Units>
  VESICA_INLINE constexpr RectInUnits(const Rect<double>& r, const Units& units) noexcept
      : axis{units.axes.number(r.ux), units.axes.number(r.uy)},
        hx(units.sizes.number(r.hx)),
        hy(units.sizes.number(r.hy)) {}
  VESICA_INLINE constexpr bool is_valid() const noexcept {
    return both((hx.n | hy.n) >= 0, (axis.x.n | axis.y.n) != 0);
  }
};

/// A half size, and what an axis is along the half side: a dot or cross product.
struct Reach {
  Integer64 size;
  Residue128 along;
};

/// Along an axis: how far centres are apart, over 2^64, and how far half sides reach.
template <std::size_t count>
struct OnAxis {
  Residue128 between;
  Reach reach[count];

  /// By how much half sides reach farther, over 2^64. Without the last limb of products it is too small, by less than
  /// 2^63.
  VESICA_INLINE constexpr Residue128 slack() const noexcept {
    return sum([](const Residue128& along) { return along.high; }) - between;
  }
  VESICA_INLINE constexpr bool has_gap() const noexcept {
    const Residue128 last = sum([](const Residue128& along) { return along.low; });
    return (slack() + Residue128{last.high, 0}).is_negative();
  }

 private:
  /// Of sizes times a limb of what the axis is along half sides.
  template <class Limb>
  VESICA_INLINE constexpr Residue128 sum(Limb limb) const noexcept {
    const auto term = [&](int i) { return product(static_cast<std::uint64_t>(reach[i].size.n), limb(reach[i].along)); };
    if constexpr (count == 1) return term(0);
    if constexpr (count == 2) return term(0) + term(1);
    if constexpr (count == 3) return term(0) + term(1) + term(2);
  }
};

/// The same along a coordinate axis, where an AABB's sides have no factor U: all of it, not over 2^64.
struct OnUprightAxis {
  Residue128 all;

  VESICA_INLINE constexpr Residue128 slack() const noexcept { return all; }
  VESICA_INLINE constexpr bool has_gap() const noexcept { return all.is_negative(); }
};

/// How much of products is looked at.
enum class Limbs { leading, all };

/// Whether there is no gap along any axis. By leading limbs slack's sign is certain unless it is from -2^64 to 0: only
/// numbers of all digits that touch, exactly or nearly so, are left undecided.
template <Limbs limbs, class... Axis>
VESICA_INLINE constexpr Verdict<bool> no_gap(bool valid, const Axis&... axis) noexcept {
  if constexpr (limbs == Limbs::all) {
    return compared(valid, !(axis.has_gap() || ...));
  } else {
    bool possible = false, certain = false;
    const auto look = [&](const Residue128& slack) {
      possible = either(possible, slack.is_negative());
      certain = either(certain, (slack + Residue128{0, 1}).is_negative());
    };
    (look(axis.slack()), ...);
    return guarded(valid, !possible, certain);
  }
}

/// Shifts by a pair's s, and remembers whether anything was too large for that.
class Shift {
 public:
  VESICA_INLINE constexpr explicit Shift(int places) noexcept : places_(places) {}
  VESICA_INLINE constexpr bool is_possible() const noexcept { return places_ <= 62; }

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

// Whether two shapes overlap; undecided where exponents are too far apart for the units, or a shape is invalid.

template <Limbs limbs>
VESICA_INLINE constexpr Verdict<bool> by_axes(const Point<double>& p, const Rect<double>& r) noexcept {
  const BoxUnits<false> units(Numbers{p.x, p.y, r.cx, r.cy}, Numbers{r.ux, r.uy}, Numbers{r.hx, r.hy});
  if (!units.fit) return {false, false};
  Shift shift(units.shift);
  const RectInUnits b(r, units);
  const VectorInUnits d = shift(units.place(p.x, p.y) - units.place(r.cx, r.cy));
  const Residue128 uu = dot(b.axis, b.axis);
  return no_gap<limbs>(both(shift.held(), b.is_valid()),  //
                       OnAxis<1>{dot(b.axis, d).magnitude(), {{b.hx, uu}}},
                       OnAxis<1>{cross(b.axis, d).magnitude(), {{b.hy, uu}}});
}

template <Limbs limbs>
VESICA_INLINE constexpr Verdict<bool> by_axes(const Rect<double>& r, const Rect<double>& t) noexcept {
  const BoxUnits<false> units(Numbers{r.cx, r.cy, t.cx, t.cy}, Numbers{r.ux, r.uy, t.ux, t.uy},
                              Numbers{r.hx, r.hy, t.hx, t.hy});
  if (!units.fit) return {false, false};
  Shift shift(units.shift);
  const RectInUnits a(r, units), b(t, units);
  const VectorInUnits d = shift(units.place(t.cx, t.cy) - units.place(r.cx, r.cy));
  const Residue128 uu = dot(a.axis, a.axis), ww = dot(b.axis, b.axis);
  const Residue128 c = dot(a.axis, b.axis).magnitude(), s = cross(a.axis, b.axis).magnitude();
  return no_gap<limbs>(both(shift.held(), both(a.is_valid(), b.is_valid())),
                       OnAxis<3>{dot(a.axis, d).magnitude(), {{a.hx, uu}, {b.hx, c}, {b.hy, s}}},
                       OnAxis<3>{cross(a.axis, d).magnitude(), {{a.hy, uu}, {b.hx, s}, {b.hy, c}}},
                       OnAxis<3>{dot(b.axis, d).magnitude(), {{b.hx, ww}, {a.hx, c}, {a.hy, s}}},
                       OnAxis<3>{cross(b.axis, d).magnitude(), {{b.hy, ww}, {a.hx, s}, {a.hy, c}}});
}

/// The axes of the rectangle and the segment's normal; where it has no length nothing parts the shapes along that.
template <Limbs limbs>
VESICA_INLINE constexpr Verdict<bool> by_axes(const Segment<double>& s, const Rect<double>& r) noexcept {
  const BoxUnits<true> units(Numbers{s.x0, s.y0, s.x1, s.y1, r.cx, r.cy}, Numbers{r.ux, r.uy}, Numbers{r.hx, r.hy});
  if (!units.fit) return {false, false};
  Shift shift(units.shift);
  const RectInUnits b(r, units);
  const VectorInUnits centre = units.place(r.cx, r.cy), start = units.place(s.x0, s.y0), end = units.place(s.x1, s.y1);
  const VectorInUnits d = (centre - start) + (centre - end), way = end - start;
  const Residue128 uu = dot(b.axis, b.axis);
  const Residue128 along = dot(b.axis, way).magnitude(), across = cross(b.axis, way).magnitude();
  const OnAxis<1> along_b{shift(dot(b.axis, d).magnitude() - along), {{b.hx, uu}}};
  const OnAxis<1> across_b{shift(cross(b.axis, d).magnitude() - across), {{b.hy, uu}}};
  const OnAxis<2> across_s{shift(cross(way, d).magnitude()), {{b.hx, across}, {b.hy, along}}};
  return no_gap<limbs>(both(shift.held(), b.is_valid()), along_b, across_b, across_s);
}

/// By how much the half sides of an AABB and a rectangle reach farther along a coordinate axis than d.
VESICA_INLINE constexpr OnUprightAxis upright(Integer64 d, Integer64 width, Integer64 hx, Integer64 ux, Integer64 hy,
                                              Integer64 uy, Shift& shift) noexcept {
  const Integer64 between = shift(d.magnitude() - width);
  return {(hx * ux + hy * uy) - Residue128{0, static_cast<std::uint64_t>(between.n)}};
}

template <Limbs limbs>
VESICA_INLINE constexpr Verdict<bool> by_axes(const Aabb<double>& box, const Rect<double>& r) noexcept {
  const BoxUnits<true> units(Numbers{box.min_x, box.min_y, box.max_x, box.max_y, r.cx, r.cy}, Numbers{r.ux, r.uy},
                             Numbers{r.hx, r.hy});
  if (!units.fit) return {false, false};
  Shift shift(units.shift);
  const RectInUnits b(r, units);
  const VectorInUnits centre = units.place(r.cx, r.cy), min = units.place(box.min_x, box.min_y),
                      max = units.place(box.max_x, box.max_y);
  const VectorInUnits d = (centre - min) + (centre - max), size = max - min;
  const Integer64 ux = b.axis.x.magnitude(), uy = b.axis.y.magnitude();
  const Residue128 uu = dot(b.axis, b.axis), along = ux * size.x + uy * size.y, across = uy * size.x + ux * size.y;
  const OnAxis<1> along_b{shift(dot(b.axis, d).magnitude() - along), {{b.hx, uu}}};
  const OnAxis<1> across_b{shift(cross(b.axis, d).magnitude() - across), {{b.hy, uu}}};
  const OnUprightAxis x = upright(d.x, size.x, b.hx, ux, b.hy, uy, shift);
  const OnUprightAxis y = upright(d.y, size.y, b.hx, uy, b.hy, ux, shift);
  const bool valid = both(b.is_valid(), (size.x.n | size.y.n) >= 0);
  return no_gap<limbs>(both(shift.held(), valid), along_b, across_b, x, y);
}

/// Has one of an axis's two numbers more digits than these?
VESICA_INLINE constexpr bool has_long_axis(const Rect<double>& r, int digits) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(r.ux) | std::bit_cast<std::uint64_t>(r.uy);
  return bits << (11 + digits) != 0;
}

/// Pairs that by_axes() knows.
template <class A, class B>
concept HasAxes = has_wide_products && requires(const A& a, const B& b) {
  by_axes<Limbs::all>(a, b);
};

}  // namespace vesica::filter
