// SPDX-License-Identifier: Apache-2.0
/// Ties. Where shapes touch exactly no bound on an error decides, yet on pixels, grids and halves nothing is rounded:
/// the predicate's own value is then exact, and so is its sign, zero included.
///
/// This stage evaluates the predicates of exact/ in floating point, and looks at the error of each operation. It
/// decides only where all errors are zero, so it needs no bound. For points, segments, AABBs, rectangles and circles,
/// in double.
#pragma once

#include <bit>
#include <limits>
#include <vesica/arithmetic/error_free.hpp>
#include <vesica/filter/box.hpp>
#include <vesica/filter/comparison.hpp>

namespace vesica::filter {

/// The digits of many numbers: how many the longest has.
class Digits {
 public:
  VESICA_INLINE static constexpr std::uint64_t fraction(double x) noexcept {
    return std::bit_cast<std::uint64_t>(x) & 0xfffffffffffffu;
  }
  VESICA_INLINE constexpr void add(std::uint64_t fraction) noexcept { bits_ |= fraction; }
  /// From a number's first 1 to its last there are as many places as the lowest bit of its fraction says, or fewer.
  /// Powers of two, 0 and infinity have no fraction: 1 or less.
  constexpr int most() const noexcept { return 53 - std::countr_zero(bits_); }

 private:
  std::uint64_t bits_ = 0;
};

/// Sums and products that must not be rounded: held() where none was. Contraction changes nothing here, so lanes that
/// may fuse and callers' own compiler options are harmless.
///
/// The error of a sum is worked out. So is that of a product in lanes, and where the hardware fuses. Other scalars
/// would pay 17 operations for it, and count digits instead: a product of numbers with m and n digits has m + n at
/// most, and no more than n if m is 1. All first factors' m, all second factors' n. So first factors are those of few
/// digits, directions.
///
/// Numbers that are not multiples of 2^-152 count as rounded. So a sum of products of up to six, halves of offsets
/// among them, is a multiple of 2^-918, and so is the error of an operation, which therefore does not underflow. Beyond
/// the range it is infinite or NaN.
template <class V>
class ErrorFree {
 public:
  template <class... X>
  VESICA_INLINE constexpr explicit ErrorFree(X... stored) noexcept {
    ((lost_ = or_bits(lost_, rounded(stored))), ...);
  }

  VESICA_INLINE constexpr V sum(V a, V b) noexcept { return high_of(detail::arithmetic::two_sum(a, b)); }
  VESICA_INLINE constexpr V difference(V a, V b) noexcept { return high_of(detail::arithmetic::two_difference(a, b)); }
  VESICA_INLINE constexpr V product(V a, V b) noexcept {
    if constexpr (counts_digits) {
      // A power of two, 0 and infinity have no fraction, and round no product.
      const std::uint64_t of_a = Digits::fraction(a), of_b = Digits::fraction(b);
      first_.add(of_b == 0 ? 0 : of_a);
      second_.add(of_a == 0 ? 0 : of_b);
      return a * b;
    } else {
      return high_of(detail::arithmetic::two_product_uncontracted(a, b));
    }
  }
  VESICA_INLINE constexpr V dot(V ux, V uy, V wx, V wy) noexcept { return sum(product(ux, wx), product(uy, wy)); }
  VESICA_INLINE constexpr V cross(V ux, V uy, V wx, V wy) noexcept {
    return difference(product(ux, wy), product(uy, wx));
  }
  /// How far c is outside of [low, high]: one of two differences, or 0 inside, where neither counts.
  VESICA_INLINE constexpr V outside(V low, V high, V c) noexcept {
    const auto left = detail::arithmetic::two_difference(low, c), right = detail::arithmetic::two_difference(c, high);
    const V out = max(left.high, right.high), zero(0.0);
    const V loss = select(left.high > right.high, left.low, right.low);
    lost_ = or_bits(lost_, select(out > zero, loss, zero));
    return positive_part(out);
  }
  VESICA_INLINE constexpr auto held() const noexcept {
    if constexpr (counts_digits) {
      const int m = first_.most(), n = second_.most();
      return both(lost_ == V(0.0), either(m + n <= 53, either(m <= 1, n <= 1)));
    } else {
      return lost_ == V(0.0);
    }
  }

 private:
  static constexpr bool counts_digits = std::is_same_v<V, double> && !detail::arithmetic::HasFused<V>;

  /// What x loses below 2^-152.
  VESICA_INLINE static constexpr V rounded(V x) noexcept {
    constexpr int e = 1074 - 152;
    return (x * V(ScalarTraits<double>::power(-e))) * V(ScalarTraits<double>::power(e)) - x;
  }
  VESICA_INLINE constexpr V high_of(const detail::arithmetic::Pair<V>& pair) noexcept {
    lost_ = or_bits(lost_, pair.low);
    return pair.high;
  }
  V lost_{0.0};            // the bits of all errors
  Digits first_, second_;  // of factors
};

/// The parts of a form as numbers; differences must not be rounded.
template <class V>
struct ErrorFreeNumber : detail::form::AsStored<V> {
  using detail::form::AsStored<V>::operator();
  ErrorFree<V>* exactly;

  VESICA_INLINE constexpr explicit ErrorFreeNumber(ErrorFree<V>& arithmetic) noexcept : exactly(&arithmetic) {}
  VESICA_INLINE constexpr V operator()(const detail::form::Difference<V>& d) const noexcept {
    return exactly->difference(d.to, d.from);
  }
  VESICA_INLINE constexpr V operator()(const detail::form::HalfWidth<V>& w) const noexcept {
    return exactly->difference(w.to, w.from);
  }
};

template <template <class> class Shape, class V>
VESICA_INLINE constexpr Box<V> box(const Shape<V>& s, ErrorFree<V>& exactly) noexcept {
  const ErrorFreeNumber<V> number(exactly);
  const auto f = detail::form::of(s);
  return {number(f.ux), number(f.uy), number(f.hx), number(f.hy)};
}

/// Centre of b minus centre of a, as high + low: between coordinates in tenths or hundredths `low` is seldom 0.
template <class V>
struct WholeOffset {
  Centre<V> high, low;
};

template <class V>
VESICA_INLINE constexpr WholeOffset<V> offset(const Centre<V>& a, const Centre<V>& b, ErrorFree<V>&) noexcept {
  const auto x = detail::arithmetic::two_difference(b.x, a.x), y = detail::arithmetic::two_difference(b.y, a.y);
  return {{x.high, y.high}, {x.low, y.low}};
}

/// Half the sum of two differences.
template <class V>
VESICA_INLINE constexpr detail::arithmetic::Pair<V> mean_difference(V to0, V from0, V to1, V from1,
                                                                    ErrorFree<V>& exactly) noexcept {
  const auto first = detail::arithmetic::two_difference(to0, from0),
             second = detail::arithmetic::two_difference(to1, from1),
             sum = detail::arithmetic::two_sum(first.high, second.high);
  const V half(0.5), low = exactly.sum(exactly.sum(first.low, second.low), sum.low);
  return {half * sum.high, half * low};
}
template <class PlaceA, class PlaceB, class V>
VESICA_INLINE constexpr WholeOffset<V> offset(const PlaceA& place_a, const PlaceB& place_b,
                                              ErrorFree<V>& exactly) noexcept {
  const Corners<V> a = detail::form::corners(place_a), b = detail::form::corners(place_b);
  const auto x = mean_difference(b.x0, a.x0, b.x1, a.x1, exactly), y = mean_difference(b.y0, a.y0, b.y1, a.y1, exactly);
  return {{x.high, y.high}, {x.low, y.low}};
}

/// |p + low| - reach, rounded once at the end, where that cannot change a sign.
template <class V>
VESICA_INLINE constexpr V gap_beyond(V p, V low, V reach, ErrorFree<V>& exactly) noexcept {
  const auto distance = detail::arithmetic::two_sum(p, low);
  return exactly.difference(abs(distance.high), reach) + flip_sign(distance.low, distance.high);
}

/// A guard that fails for an invalid box, and for the segment of no length, which has no axis.
template <class V>
VESICA_INLINE constexpr auto has_extent(const Box<V>& b, V uu) noexcept {
  return both(uu > V(0.0), at_least(V(0.0), b.hx, b.hy));
}

/// The greater gap along the axes of a; uu, c and s as in separating_axes().
template <class V>
VESICA_INLINE constexpr V widest_gap_along(const Box<V>& a, const Box<V>& b, const WholeOffset<V>& d, V uu, V c, V s,
                                           ErrorFree<V>& exactly) noexcept {
  const auto reach = [&](V h, V along, V across) {
    return exactly.sum(exactly.product(uu, h), exactly.dot(along, across, b.hx, b.hy));
  };
  const V along = gap_beyond(exactly.dot(a.ux, a.uy, d.high.x, d.high.y), exactly.dot(a.ux, a.uy, d.low.x, d.low.y),
                             reach(a.hx, c, s), exactly);
  const V across = gap_beyond(exactly.cross(a.ux, a.uy, d.high.x, d.high.y),
                              exactly.cross(a.ux, a.uy, d.low.x, d.low.y), reach(a.hy, s, c), exactly);
  return max(along, across);
}

/// Separating axes, as exact/box_box.hpp. Degree 3.
template <class V>
VESICA_INLINE constexpr auto box_box(const Box<V>& a, const Box<V>& b, const WholeOffset<V>& d,
                                     ErrorFree<V>& exactly) noexcept {
  const V uu = exactly.dot(a.ux, a.uy, a.ux, a.uy), ww = exactly.dot(b.ux, b.uy, b.ux, b.uy);
  const V c = abs(exactly.dot(a.ux, a.uy, b.ux, b.uy)), s = abs(exactly.cross(a.ux, a.uy, b.ux, b.uy));
  const V gap = max(widest_gap_along(a, b, d, uu, c, s, exactly), widest_gap_along(b, a, d, ww, c, s, exactly));
  return compared(both(exactly.held(), both(has_extent(a, uu), has_extent(b, ww))), gap <= V(0.0));
}

/// Is (x, y) within a reach whose square this is? A product that no sum follows may be infinite, and no error tells.
template <class V, class Mask>
VESICA_INLINE constexpr auto within_reach(V x, V y, V reached, Mask valid, ErrorFree<V>& exactly) noexcept {
  const V distance = exactly.dot(x, y, x, y);
  const auto finite = reached <= V(std::numeric_limits<double>::max());
  return compared(both(valid, both(exactly.held(), finite)), distance <= reached);
}

/// Is the disc's centre at most a radius from the box? As exact/disc.hpp, kx and ky the offset along its axes. Degree
/// 6.
template <class V>
VESICA_INLINE constexpr auto box_disc(const Box<V>& box, V uu, V kx, V ky, V radius, ErrorFree<V>& exactly) noexcept {
  const V x = positive_part(exactly.difference(kx, exactly.product(uu, box.hx)));
  const V y = positive_part(exactly.difference(ky, exactly.product(uu, box.hy)));
  const V reached = exactly.product(exactly.product(uu, radius), radius);
  return within_reach(x, y, reached, both(has_extent(box, uu), radius >= V(0.0)), exactly);
}
template <class V>
VESICA_INLINE constexpr auto box_disc(const Box<V>& box, const WholeOffset<V>& d, V radius,
                                      ErrorFree<V>& exactly) noexcept {
  const V dx = exactly.sum(d.high.x, d.low.x), dy = exactly.sum(d.high.y, d.low.y);
  const V uu = exactly.dot(box.ux, box.uy, box.ux, box.uy);
  const V kx = abs(exactly.dot(box.ux, box.uy, dx, dy)), ky = abs(exactly.cross(box.ux, box.uy, dx, dy));
  return box_disc(box, uu, kx, ky, radius, exactly);
}

/// The same for an AABB, whose nearest point is found by one difference along each axis.
template <class V>
VESICA_INLINE constexpr auto aabb_disc(const Aabb<V>& box, const Circle<V>& disc, ErrorFree<V>& exactly) noexcept {
  const V x = exactly.outside(box.min_x, box.max_x, disc.cx), y = exactly.outside(box.min_y, box.max_y, disc.cy);
  const V reached = exactly.product(disc.r, disc.r);
  const auto valid = both(disc.r >= V(0.0), both(box.min_x <= box.max_x, box.min_y <= box.max_y));
  return within_reach(x, y, reached, valid, exactly);
}

template <class V>
VESICA_INLINE constexpr auto disc_disc(const WholeOffset<V>& d, V radius_a, V radius_b,
                                       ErrorFree<V>& exactly) noexcept {
  const V dx = exactly.sum(d.high.x, d.low.x), dy = exactly.sum(d.high.y, d.low.y);
  const V reach = exactly.sum(radius_a, radius_b);
  const V reached = exactly.product(reach, reach);
  return within_reach(dx, dy, reached, at_least(V(0.0), radius_a, radius_b), exactly);
}

namespace parts = detail::form;

template <class Shape>
inline constexpr bool is_disc = parts::FormOf<Shape>::outline == parts::Outline::disc;
template <class Shape>
inline constexpr bool is_straight = parts::FormOf<Shape>::outline == parts::Outline::straight;
template <class Shape>
inline constexpr bool is_point = parts::FormOf<Shape>::is_upright && !parts::FormOf<Shape>::has_corners;
template <class Shape>
inline constexpr bool is_aabb = parts::FormOf<Shape>::is_upright&& parts::FormOf<Shape>::has_corners;

/// Pairs that error_free() knows. Two AABBs or points are not among them: comparisons leave nothing open.
template <class A, class B>
concept HasErrorFree = parts::HasForm<A>&& parts::HasForm<B> && (is_straight<A> || is_disc<A>)&&(is_straight<B> || is_disc<B>)&&!(parts::FormOf<A>::is_upright &&
                                                                                         parts::FormOf<B>::is_upright);

/// Whether two shapes overlap, where nothing is rounded in finding out.
template <template <class> class A, template <class> class B, class V>
requires HasErrorFree<A<V>, B<V>> VESICA_INLINE constexpr auto error_free(const A<V>& a, const B<V>& b) noexcept {
  ErrorFree<V> exactly = detail::with_numbers(a, [&](auto... of_a) {
    return detail::with_numbers(b, [&](auto... of_b) { return ErrorFree<V>(of_a..., of_b...); });
  });
  if constexpr (is_disc<A<V>> && is_disc<B<V>>) {
    return disc_disc(offset(place(a), place(b), exactly), a.r, b.r, exactly);
  } else if constexpr (is_point<A<V>> && is_disc<B<V>>) {
    return disc_disc(offset(place(a), place(b), exactly), V(0.0), b.r, exactly);
  } else if constexpr (is_disc<A<V>> && is_aabb<B<V>>) {
    return aabb_disc(b, a, exactly);
  } else if constexpr (is_disc<A<V>>) {
    return box_disc(box(b, exactly), offset(place(b), place(a), exactly), a.r, exactly);
  } else if constexpr (is_disc<B<V>>) {
    return box_disc(box(a, exactly), offset(place(a), place(b), exactly), b.r, exactly);
  } else {
    return box_box(box(a, exactly), box(b, exactly), offset(place(a), place(b), exactly), exactly);
  }
}

}  // namespace vesica::filter
