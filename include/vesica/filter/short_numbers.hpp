// SPDX-License-Identifier: Apache-2.0
/// Ties among numbers of few digits: there the filter's own value is exact, and its sign is the answer. One look at the
/// numbers tells. error_free.hpp looks at each operation, decides more, and takes twice as long. For boxes,
/// with another or a disc, one pair at a time.
#pragma once

#include <vesica/filter/box_box.hpp>
#include <vesica/filter/error_free.hpp>
#include <vesica/filter/reach.hpp>

namespace vesica::filter {

/// Numbers that are to be multiples of one power of two, G, so large that their sum is below 2^digits G.
///
/// Proof that holds() tells it. Let M = m 2^(54 - digits) for m, the sum of absolute values, and 2^e <= M < 2^(e + 1).
/// Of a number x with |x| <= M / 4 the sum s = x + M is rounded to a multiple of G = 2^(e - 53), since s >= 3 M / 4 >
/// 2^(e - 1). M is one too, and s - M is not rounded, since it is at most 2^(e - 1) = 2^52 G. So if that is x, x is a
/// multiple of G. And m < 2^(e + 1 - 54 + digits) = 2^digits G, up to the five roundings of m itself. Contraction
/// changes nothing, as M is exact; a NaN or an infinite number is no multiple.
class Multiples {
 public:
  VESICA_INLINE constexpr Multiples(int digits, double sum) noexcept
      : sum_(sum), large_(sum * static_cast<double>(1ull << (54 - digits))) {}

  template <class... X>
  VESICA_INLINE constexpr void add(X... x) noexcept {
    ((lost_ = or_bits(lost_, ((x + large_) - large_) - x)), ...);
  }
  /// A coordinate, which may be far larger than the differences that are summed.
  VESICA_INLINE VESICA_DEVICE void add_coordinate(double x) noexcept {
    farthest_ = farthest_ + abs(x);
    add(x);
  }
  /// A number that must be 0.
  VESICA_INLINE constexpr void add_loss(double x) noexcept { lost_ = or_bits(lost_, x); }

  /// No product of six such numbers underflows or overflows.
  VESICA_INLINE constexpr bool holds() const noexcept {
    return both(both(lost_ == 0, farthest_ <= 0.25 * large_), in_range(sum_, 0x1p-100, 0x1p100));
  }

 private:
  double sum_, large_, lost_ = 0, farthest_ = 0;
};

/// Differences of stored points are exact where both are multiples of G and at most 2^52 G together, and so are their
/// sums and halves. Between two centres each difference tells of itself: centres need not be short.
VESICA_INLINE VESICA_DEVICE void add_places(const Centre<double>& a, const Centre<double>& b,
                                            Multiples& lengths) noexcept {
  lengths.add_loss(detail::arithmetic::two_difference(b.x, a.x).low);
  lengths.add_loss(detail::arithmetic::two_difference(b.y, a.y).low);
}
VESICA_INLINE VESICA_DEVICE void add_place(const Centre<double>& p, Multiples& lengths) noexcept {
  lengths.add_coordinate(p.x);
  lengths.add_coordinate(p.y);
}
VESICA_INLINE VESICA_DEVICE void add_place(const Corners<double>& p, Multiples& lengths) noexcept {
  lengths.add_coordinate(p.x0);
  lengths.add_coordinate(p.y0);
  lengths.add_coordinate(p.x1);
  lengths.add_coordinate(p.y1);
}
template <class PlaceA, class PlaceB>
VESICA_INLINE VESICA_DEVICE void add_places(const PlaceA& a, const PlaceB& b, Multiples& lengths) noexcept {
  add_place(a, lengths);
  add_place(b, lengths);
}

/// Directions have no more digits than this, lengths 52 less twice as many. Segments have lengths for directions.
template <class A, class B>
inline constexpr int most_digits =
    detail::form::FormOf<A>::axis_may_vanish || detail::form::FormOf<B>::axis_may_vanish ? 15 : 12;

/// Whether two boxes overlap, or neither for numbers that are not short.
///
/// With directions that sum up to less than 2^m H and lengths, offset among them, to less than 2^n G, and 2 m + n = 52:
/// squares, dot and cross products of directions are multiples of H^2 below 2^(2m) H^2, extents multiples of H^2 G
/// below 2^52 H^2 G, with a factor of 1 + 20u for roundings of the sums, and projections of the offset multiples of H G
/// / 2 below 2^(m + n) H G. None is rounded. Their difference is, but not to another sign.
template <class A, class B>
requires(is_straight<A>&& is_straight<B>) VESICA_INLINE
    constexpr Verdict<bool> short_numbers(const A& shape_a, const B& shape_b) noexcept {
  const Box<double> a = box(shape_a), b = box(shape_b);
  const auto place_a = place(shape_a);
  const auto place_b = place(shape_b);
  const Centre<double> d = offset(place_a, place_b);
  constexpr int digits = most_digits<A, B>;
  Multiples directions(digits, (abs(a.ux) + abs(a.uy)) + (abs(b.ux) + abs(b.uy)));
  Multiples lengths(52 - 2 * digits, (abs(d.x) + abs(d.y)) + ((a.hx + a.hy) + (b.hx + b.hy)));
  directions.add(a.ux, a.uy, b.ux, b.uy);
  lengths.add(d.x, d.y, a.hx, a.hy, b.hx, b.hy);
  add_places(place_a, place_b, lengths);
  const BoxBox<double> axes = separating_axes(a, b, d);
  const auto valid = both(has_extent(a, axes.uu), has_extent(b, axes.ww));
  return compared(both(both(directions.holds(), lengths.holds()), valid), max(axes.gap_a.value, axes.gap_b.value) <= 0);
}

/// The same for a box and a disc: what comes before squares.
template <class A>
requires is_straight<A> VESICA_INLINE constexpr Verdict<bool> short_numbers(const A& shape,
                                                                            const Circle<double>& disc) noexcept {
  const Box<double> a = box(shape);
  const auto place_a = place(shape);
  const auto place_b = place(disc);
  const Centre<double> d = offset(place_a, place_b);
  constexpr int digits = most_digits<A, A>;
  Multiples directions(digits, abs(a.ux) + abs(a.uy));
  Multiples lengths(52 - 2 * digits, (abs(d.x) + abs(d.y)) + (a.hx + a.hy));
  directions.add(a.ux, a.uy);
  lengths.add(d.x, d.y, a.hx, a.hy);
  add_places(place_a, place_b, lengths);
  const double uu = a.ux * a.ux + a.uy * a.uy;
  const double kx = abs(a.ux * d.x + a.uy * d.y), ky = abs(a.ux * d.y - a.uy * d.x);
  ErrorFree<double> exactly(disc.r);
  const Verdict<bool> verdict = box_disc(a, uu, kx, ky, disc.r, exactly);
  return guarded(both(directions.holds(), lengths.holds()), verdict.overlap, verdict.disjoint);
}
template <class B>
requires is_straight<B> VESICA_INLINE constexpr Verdict<bool> short_numbers(const Circle<double>& disc,
                                                                            const B& shape) noexcept {
  return short_numbers(shape, disc);
}

/// Pairs for which this is quicker than error_free().
template <class A, class B>
concept HasShortNumbers = HasErrorFree<A, B> && !HasResidues<A, B>;

}  // namespace vesica::filter
