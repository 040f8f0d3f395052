// SPDX-License-Identifier: Apache-2.0
/// Exact contact of points, segments, AABBs, rectangles and circles in integers of 256 bits (squares: 512). This
/// decides what a filter leaves undecided, unless exponents of a pair are too far apart: then the exact stage does.
///
/// Coordinates are multiples of one power of two, components of axes of another, sizes and radii of a third. Doubled,
/// centres and half sizes are whole numbers. What is compared is shifted to one unit.
///
/// Proved: nothing overflows. Magnitudes of each of the three sorts sum up to less than 2^61 units, but for rounding.
///
///   - Doubled offsets of centres, segments and an AABB's sides are below 2^62. A dot or cross product of two vectors
///     is at most the sum of one's magnitudes times the greater of the other's: below 2^123.
///   - Half sides reach less than 2^(62 + 123) along an axis. Shifts are limited to 62 places for these, to 126 for
///     offsets: all is below 2^250.
///   - For circles squares of that are below 2^501. A radius squared times a squared axis is below 2^(124 + 123), and
///     shifted by at most 252 places.
#pragma once

#include <type_traits>
#include <vesica/contact.hpp>
#include <vesica/filter/box.hpp>
#include <vesica/filter/comparison.hpp>
#include <vesica/filter/wide_integer.hpp>

namespace vesica::filter {

/// Stored numbers of a shape: sums of their magnitudes, or the units that these give.
template <class T>
struct OfNumbers {
  T places, axes, sizes, radii;
};
using Magnitudes = OfNumbers<double>;

VESICA_INLINE constexpr Magnitudes magnitudes(const Point<double>& s) noexcept {
  return {abs(s.x) + abs(s.y), 0, 0, 0};
}
VESICA_INLINE constexpr Magnitudes magnitudes(const Segment<double>& s) noexcept {
  return {(abs(s.x0) + abs(s.y0)) + (abs(s.x1) + abs(s.y1)), 0, 0, 0};
}
VESICA_INLINE constexpr Magnitudes magnitudes(const Circle<double>& s) noexcept {
  return {abs(s.cx) + abs(s.cy), 0, 0, abs(s.r)};
}
VESICA_INLINE constexpr Magnitudes magnitudes(const Aabb<double>& s) noexcept {
  return {(abs(s.min_x) + abs(s.min_y)) + (abs(s.max_x) + abs(s.max_y)), 0, 0, 0};
}
VESICA_INLINE constexpr Magnitudes magnitudes(const Rect<double>& s) noexcept {
  return {abs(s.cx) + abs(s.cy), abs(s.ux) + abs(s.uy), abs(s.hx) + abs(s.hy), 0};
}

/// The units of a pair, and by how many places lengths in each are shifted to the least of three.
struct Units : OfNumbers<Unit> {
  int shift_places, shift_rects, shift_radii;

  VESICA_INLINE constexpr Units(const Magnitudes& a, const Magnitudes& b) noexcept
      : OfNumbers<Unit>{Unit(a.places + b.places), Unit(a.axes + b.axes), Unit(a.sizes + b.sizes),
                        Unit(a.radii + b.radii)} {
    constexpr int none = 1 << 20;
    const int of_places = places.is_zero() ? none : places.exponent();
    const int of_rects = sizes.is_zero() ? none : axes.exponent() + sizes.exponent() + 1;
    const int of_radii = radii.is_zero() ? none : radii.exponent() + 1;
    int least = of_places < of_rects ? of_places : of_rects;
    least = least < of_radii ? least : of_radii;
    shift_places = of_places == none ? 0 : of_places - least;
    shift_rects = of_rects == none ? 0 : of_rects - least;
    shift_radii = of_radii == none ? 0 : of_radii - least;
  }
  VESICA_INLINE constexpr bool are_usable() const noexcept {
    return both(both(both(places.is_usable(), axes.is_usable()), both(sizes.is_usable(), radii.is_usable())),
                both(shift_places <= 126, both(shift_rects <= 62, shift_radii <= 126)));
  }
  VESICA_INLINE constexpr bool divide() const noexcept {
    return both(both(places.divides(), axes.divides()), both(sizes.divides(), radii.divides()));
  }
};

/// A shape in integers: its centre and half sizes, doubled.
struct IntegerBox {
  WideVector centre, axis;
  std::int64_t hx, hy;
  bool valid;
};

VESICA_INLINE constexpr IntegerBox integers(const Point<double>& s, Units& units) noexcept {
  return {{2 * units.places.number(s.x), 2 * units.places.number(s.y)}, {1, 0}, 0, 0, true};
}
VESICA_INLINE constexpr IntegerBox integers(const Circle<double>& s, Units& units) noexcept {
  return integers(Point<double>{s.cx, s.cy}, units);
}
/// With ends in one point: that point.
VESICA_INLINE constexpr IntegerBox integers(const Segment<double>& s, Units& units) noexcept {
  const std::int64_t x0 = units.places.number(s.x0), y0 = units.places.number(s.y0);
  const std::int64_t x1 = units.places.number(s.x1), y1 = units.places.number(s.y1);
  const bool is_point = both(x0 == x1, y0 == y1);
  return {{x0 + x1, y0 + y1}, {x1 - x0 + is_point, y1 - y0}, !is_point, 0, true};
}
VESICA_INLINE constexpr IntegerBox integers(const Aabb<double>& s, Units& units) noexcept {
  const std::int64_t x0 = units.places.number(s.min_x), y0 = units.places.number(s.min_y);
  const std::int64_t x1 = units.places.number(s.max_x), y1 = units.places.number(s.max_y);
  return {{x0 + x1, y0 + y1}, {1, 0}, x1 - x0, y1 - y0, both(x0 <= x1, y0 <= y1)};
}
VESICA_INLINE constexpr IntegerBox integers(const Rect<double>& s, Units& units) noexcept {
  const WideVector axis{units.axes.number(s.ux), units.axes.number(s.uy)};
  const std::int64_t hx = units.sizes.number(s.hx), hy = units.sizes.number(s.hy);
  return {{2 * units.places.number(s.cx), 2 * units.places.number(s.cy)},
          axis,
          hx,
          hy,
          both((hx | hy) >= 0, (axis.x | axis.y) != 0)};
}

template <class Shape>
inline constexpr bool is_rect = std::is_same_v<Shape, Rect<double>>;
template <class Shape>
inline constexpr bool is_circle = std::is_same_v<Shape, Circle<double>>;

/// How far half sides reach along an axis: a half size times what that axis is along the side.
VESICA_INLINE constexpr Wide<3> reach(std::int64_t half_size, const Wide<2>& along) noexcept {
  return product(Wide<1>{{static_cast<std::uint64_t>(half_size)}}, along);
}

/// Do offset and half sides leave a gap, after shifts to one unit? Only rectangles' and places' units differ. If only
/// insides count, sides that just touch have a gap too; two equal points have none.
template <class A, class B>
VESICA_INLINE constexpr bool is_gap(const Wide<2>& offset, const Wide<3>& of_a, const Wide<3>& of_b, const Units& units,
                                    Common common) noexcept {
  const bool less = both(common == Common::insides, (offset.limb[0] | offset.limb[1]) != 0);
  if constexpr (!is_rect<A> && !is_rect<B>) {
    return difference(of_a + of_b, shifted<3>(offset, 0), less).is_negative();
  } else if constexpr (is_rect<A> && is_rect<B>) {
    return difference(shifted<4>(of_a + of_b, units.shift_rects), shifted<4>(offset, units.shift_places), less)
        .is_negative();
  } else {
    const Wide<3>& of_rect = is_rect<A> ? of_a : of_b;
    const Wide<3> between = shifted<3>(offset, 0) - (is_rect<A> ? of_b : of_a);
    if (between.is_negative()) return false;
    return difference(shifted<4>(of_rect, units.shift_rects), shifted<4>(between, units.shift_places), less)
        .is_negative();
  }
}

/// Is there a gap along an axis of a? Separating axes, as exact/box_box.hpp.
template <class A, class B>
VESICA_INLINE constexpr bool has_gap(const IntegerBox& a, const IntegerBox& b, const WideVector& d, const Units& units,
                                     Common common) noexcept {
  const Wide<2> uu = dot(a.axis, a.axis), c = dot(a.axis, b.axis), s = cross(a.axis, b.axis);
  return either(is_gap<A, B>(dot(a.axis, d), reach(a.hx, uu), reach(b.hx, c) + reach(b.hy, s), units, common),
                is_gap<A, B>(cross(a.axis, d), reach(a.hy, uu), reach(b.hx, s) + reach(b.hy, c), units, common));
}

/// How far a point is beyond a half side along an axis, or 0.
template <class Shape>
VESICA_INLINE constexpr Wide<4> beyond(const Wide<2>& offset, const Wide<3>& half_side, const Units& units) noexcept {
  const Wide<4> gap = shifted<4>(offset, units.shift_places) -
                      shifted<4>(half_side, is_rect<Shape> ? units.shift_rects : units.shift_places);
  return gap.is_negative() ? Wide<4>{} : gap;
}

/// Is a centre within a radius, or the sum of two, of a shape? As exact/disc.hpp. If only insides count, the radius is
/// not 0.
template <class Shape>
VESICA_INLINE constexpr bool is_within(const IntegerBox& a, const WideVector& d, std::int64_t radius,
                                       const Units& units, Common common) noexcept {
  const Wide<2> uu = dot(a.axis, a.axis);
  const Wide<4> x = beyond<Shape>(dot(a.axis, d), reach(a.hx, uu), units);
  const Wide<4> y = beyond<Shape>(cross(a.axis, d), reach(a.hy, uu), units);
  const Wide<1> r{{static_cast<std::uint64_t>(radius)}};
  const Wide<8> reached = shifted<8>(product(product(r, r), uu), 2 * units.shift_radii);
  return !difference(reached, product(x, x) + product(y, y), common == Common::insides).is_negative();
}

/// Pairs that by_integers() decides: of shapes that have magnitudes(). Comparisons decide points and AABBs.
template <class A, class B>
concept HasIntegers = requires(const A& a, const B& b) {
  magnitudes(a);
  magnitudes(b);
}
&&!(detail::form::FormOf<A>::is_upright && detail::form::FormOf<B>::is_upright);

/// Decides if two shapes overlap. Undecided where numbers do not fit their units, or a shape is invalid; for insides
/// also where a disc's radius is 0.
template <class A, class B>
requires HasIntegers<A, B>
constexpr Verdict<bool> by_integers(const A& a, const B& b, Common common = Common::any) noexcept {
  Units units(magnitudes(a), magnitudes(b));
  if (!units.are_usable()) return {false, false};
  const IntegerBox p = integers(a, units), q = integers(b, units);
  const WideVector d{q.centre.x - p.centre.x, q.centre.y - p.centre.y};
  bool overlap = false, valid = both(p.valid, q.valid);
  if constexpr (is_circle<A> || is_circle<B>) {
    std::int64_t radius = 0;
    if constexpr (is_circle<A>) radius = radius + units.radii.number(a.r), valid = both(valid, a.r >= 0);
    if constexpr (is_circle<B>) radius = radius + units.radii.number(b.r), valid = both(valid, b.r >= 0);
    valid = both(valid, either(common == Common::any, radius > 0));
    overlap = is_circle<A> ? is_within<B>(q, d, radius, units, common) : is_within<A>(p, d, radius, units, common);
  } else {
    overlap = !either(has_gap<A, B>(p, q, d, units, common), has_gap<B, A>(q, p, d, units, common));
  }
  return compared(both(valid, units.divide()), overlap);
}

}  // namespace vesica::filter
