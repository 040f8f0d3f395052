// SPDX-License-Identifier: Apache-2.0
/// Boxes at most a distance apart, with a bound on the error: the corners of each in the frame of the other. Boxes at
/// least a depth deep in one another, by their gaps.
#pragma once

#include <vesica/filter/box_box.hpp>

namespace vesica::filter {

/// The least of some squared distances, times U = u.u: it lies between `low` and `high`.
template <class V>
struct LeastSquare {
  V low, high;
};

/// From the corners p +- g +- h of one box to another with half sizes e0, e1; total is T, the sum of all magnitudes.
///
/// Proved: a squared distance is off by at most 2e (x + y) + 2e^2, with e = 14u T, so that it lies between `low` and
/// `high`.
///
///   - A coordinate of p errs by at most 5u (|p0| + |p1|) + 2u (the rest), as in widest_gap(); one of g or h by 6u of
///     its magnitude (c, s: 4u; size u; product u). Two sums add 2u T.
///   - e0 and e1 err by 6u of themselves, the difference by u T.
///   - So x and y err by at most 11u T.
///   - Squares and their sum err by 2e (x + y) + 2e^2, and by 2u (x^2 + y^2) <= 2u T (x + y), which the 3u to spare
///     cover.
template <class V>
VESICA_INLINE constexpr LeastSquare<V> least_square(V p0, V p1, V g0, V g1, V h0, V h1, V e0, V e1, V total) noexcept {
  const V e = roundoffs<V>(14) * total;
  const auto of_corner = [&](V k0, V k1) -> LeastSquare<V> {
    const V x = positive_part(abs(k0) - e0), y = positive_part(abs(k1) - e1);
    const V square = x * x + y * y, error = (e + e) * ((x + y) + e);
    return {square - error, square + error};
  };
  const LeastSquare<V> c0 = of_corner(p0 + g0 + h0, p1 + g1 + h1), c1 = of_corner(p0 + g0 - h0, p1 + g1 - h1);
  const LeastSquare<V> c2 = of_corner(p0 - g0 + h0, p1 - g1 + h1), c3 = of_corner(p0 - g0 - h0, p1 - g1 - h1);
  return {min(min(c0.low, c1.low), min(c2.low, c3.low)), min(min(c0.high, c1.high), min(c2.high, c3.high))};
}

/// A single point.
template <class V>
VESICA_INLINE constexpr LeastSquare<V> least_square(V p0, V p1, V e0, V e1) noexcept {
  const V x = positive_part(abs(p0) - e0), y = positive_part(abs(p1) - e1);
  const V e = roundoffs<V>(14) * ((abs(p0) + abs(p1)) + (e0 + e1));
  const V square = x * x + y * y, error = (e + e) * ((x + y) + e);
  return {square - error, square + error};
}

/// Against a reach with a relative error of at most 2u: its square 5u, U 4u, the product u, the comparison u.
template <class V>
struct Reached {
  V low, high;

  VESICA_INLINE constexpr Reached(V reach, V uu) noexcept {
    const V square = reach * reach * uu, error = roundoffs<V>(14) * square + guard_power<V, -60>();
    low = square - error;
    high = square + error;
  }
};

/// Axes as those of disc_box, whose words on underflow hold here too.
template <class V>
VESICA_INLINE constexpr auto within_usable(V uu, V high, V reached) noexcept {
  const auto moderate = both(high <= guard_power<V, 100>(), reached <= guard_power<V, 100>());
  return both(in_range(uu, guard_power<V, -20>(), guard_power<V, 20>()), moderate);
}

/// A box and a point, d from the box's centre. `overlap` stands for at most `reach` apart, `disjoint` for farther.
template <class V>
VESICA_INLINE constexpr auto point_box_within(const Box<V>& b, const Centre<V>& d, V reach) noexcept {
  const V uu = b.ux * b.ux + b.uy * b.uy;
  const LeastSquare<V> least = least_square(b.ux * d.x + b.uy * d.y, b.ux * d.y - b.uy * d.x, b.hx * uu, b.hy * uu);
  const Reached<V> reached(reach, uu);
  const auto usable = both(within_usable(uu, least.high, reached.high), at_least(V(0.0f), b.hx, b.hy, reach));
  return guarded(usable, least.high<reached.low, least.low> reached.high);
}

/// Two boxes. d: from the centre of a to the centre of b.
template <class V>
VESICA_INLINE constexpr auto box_box_within(const Box<V>& a, const Box<V>& b, const Centre<V>& d, V reach) noexcept {
  const BoxBox<V> axes = separating_axes(a, b, d);
  const V c = a.ux * b.ux + a.uy * b.uy, s = a.ux * b.uy - a.uy * b.ux;
  const V h0 = a.hx * axes.uu, h1 = a.hy * axes.uu, k0 = b.hx * axes.ww, k1 = b.hy * axes.ww;
  const V p0 = a.ux * d.x + a.uy * d.y, p1 = a.ux * d.y - a.uy * d.x;
  const V q0 = b.ux * d.x + b.uy * d.y, q1 = b.ux * d.y - b.uy * d.x;
  const V turned = abs(c) + abs(s);
  const V total_a = (abs(p0) + abs(p1)) + ((h0 + h1) + (b.hx + b.hy) * turned);
  const V total_b = (abs(q0) + abs(q1)) + ((k0 + k1) + (a.hx + a.hy) * turned);
  const LeastSquare<V> of_b = least_square(p0, p1, b.hx * c, b.hx * s, -(b.hy * s), b.hy * c, h0, h1, total_a);
  const LeastSquare<V> of_a = least_square(q0, q1, a.hx * c, -(a.hx * s), a.hy * s, a.hy * c, k0, k1, total_b);
  const Reached<V> in_a(reach, axes.uu), in_b(reach, axes.ww);
  const auto meet = both(certainly_negative(axes.gap_a), certainly_negative(axes.gap_b));
  const auto apart = either(certainly_positive(axes.gap_a), certainly_positive(axes.gap_b));
  const auto close = either(of_b.high < in_a.low, of_a.high < in_b.low);
  const auto distant = both(of_b.low > in_a.high, of_a.low > in_b.high);
  const auto usable =
      both(both(within_usable(axes.uu, of_b.high, in_a.high), within_usable(axes.ww, of_a.high, in_b.high)),
           at_least(V(0.0f), a.hx, a.hy, b.hx, b.hy, reach));
  return guarded(usable, either(meet, close), both(apart, distant));
}

/// Do two boxes share at least `depth` > 0 along each of four normals? `overlap` if so, `disjoint` if not. The depth
/// has a relative error of at most 2u; d leads from the centre of a to that of b. Not inlined: many pairs ask.
VESICA_CALLED constexpr auto box_box_deep(const Box<double>& a, const Box<double>& b, const Centre<double>& d,
                                          double depth) noexcept {
  const BoxBox<double> axes = separating_axes(a, b, d);
  const auto along = [&](const Estimate<double>& gap, double uu) -> Verdict<bool> {
    const double least = positive_part(-gap.value - gap.error), most = positive_part(-gap.value + gap.error);
    const Reached<double> reached(depth, uu);
    return {least * least * (1 - roundoffs<double>(4)) > reached.high,
            certainly_positive(gap) || most * most * (1 + roundoffs<double>(4)) < reached.low};
  };
  const auto of_a = along(axes.gap_a, axes.uu), of_b = along(axes.gap_b, axes.ww);
  return guarded(both(box_box_usable(axes, a, b), depth > 0), of_a.overlap && of_b.overlap,
                 of_a.disjoint || of_b.disjoint);
}

}  // namespace vesica::filter
