// SPDX-License-Identifier: Apache-2.0
/// The smallest box of representable numbers that contains a shape: each side is the shape's true extreme rounded
/// outward once. A double-double estimate decides nearly every side; the exact stage decides the rest, and all
/// constants.
#pragma once

#include <cmath>
#include <limits>
#include <vesica/arithmetic/rounding.hpp>
#include <vesica/check.hpp>
#include <vesica/exact/rounded.hpp>
#include <vesica/shapes.hpp>

namespace vesica {

namespace detail::bounds {

/// Along one coordinate a shape reaches from c - extent to c + extent, where the extent is |p0 q0| + |p1 q1| + radius
/// for a rectangle and sqrt((p0 q0)^2 + (p1 q1)^2) for an ellipse.
struct Reach {
  double c, p0, q0, p1, q1, radius = 0;
};

/// No estimate: the exact stage must decide.
inline constexpr arithmetic::Estimate<double> unknown{0, 0, std::numeric_limits<double>::infinity()};

/// True if the product of p and q is 0 exactly, or lies where its square and the remainders have full precision.
template <class V>
VESICA_INLINE auto in_range(V p, V q, V product) noexcept {
  using lane::both, lane::either;
  const V zero(0.0);
  return either(either(p == zero, q == zero), both(product >= V(0x1p-400), product <= V(0x1p400)));
}

/// |p0 q0| + |p1 q1|. The error is 0 when high + low is all of it, as it is for numbers of few digits.
template <class V>
VESICA_INLINE arithmetic::Estimate<V> estimate_sum(const arithmetic::Pair<V>& x,
                                                   const arithmetic::Pair<V>& y) noexcept {
  using lane::abs;
  const auto [high, a] = arithmetic::two_sum(x.high, y.high);
  const auto [b, c] = arithmetic::two_sum(x.low, y.low);
  const auto [low, d] = arithmetic::two_sum(a, b);
  return {high, low, (abs(c) + abs(d)) * V(1 + 0x1p-50)};
}

/// sqrt(x^2 + y^2): a rounded root and one Newton step. The root h is off by at most 2u h (u = 2^-53), so the residual
/// x^2 + y^2 - h^2 is a sum of seven terms of together at most 11u h^2; their rounding and the two squares left out
/// cost 82u^2 h^2, the division and Newton's own error 21u^2 h more: below 64u^2 h altogether, and 128u^2 is claimed.
template <class V>
VESICA_INLINE arithmetic::Estimate<V> estimate_root(const arithmetic::Pair<V>& x,
                                                    const arithmetic::Pair<V>& y) noexcept {
  using arithmetic::two_product_fused, lane::sqrt;
  const auto xx = two_product_fused(x.high, x.high), yy = two_product_fused(y.high, y.high);
  const auto squares = arithmetic::two_sum(xx.high, yy.high);
  const V root = sqrt(squares.high), two(2.0);
  const auto rr = two_product_fused(root, root);
  const V lows = ((xx.low + yy.low) - rr.low) + squares.low;
  const V residual = (squares.high - rr.high) + (lows + two * (x.high * x.low + y.high * y.low));
  return {root, residual / (two * root), root * V(0x1p-99)};
}

VESICA_INLINE arithmetic::Estimate<double> estimate(const Rect<double>&, const arithmetic::Pair<double>& x,
                                                    const arithmetic::Pair<double>& y) noexcept {
  return estimate_sum(x, y);
}
VESICA_INLINE arithmetic::Estimate<double> estimate(const Ellipse<double>&, const arithmetic::Pair<double>& x,
                                                    const arithmetic::Pair<double>& y) noexcept {
  return x.high == 0 || y.high == 0 ? estimate_sum(x, y) : estimate_root(x, y);
}

/// A number that exact::rounded() gave; the largest one instead of one beyond. None is below the least: they are sums
/// of a double and what is not negative.
constexpr double to_finite(const arithmetic::Scaled& s) noexcept {
  return s.exponent <= 1024 ? arithmetic::scale(s.value, s.exponent) : std::numeric_limits<double>::max();
}

/// The smallest double at or above c + extent, in exact arithmetic; false when it is beyond the finite ones. The search
/// starts within a few last places of it, and so is short.
VESICA_COLD constexpr bool exact_upper(const Rect<double>&, const Reach& r, double& out) noexcept {
  using namespace exact;
  const auto value = from_double(r.c) + from_double(r.radius) + abs(from_double(r.p0) * from_double(r.q0)) +
                     abs(from_double(r.p1) * from_double(r.q1));
  return arithmetic::search_up(
      to_finite(rounded(value)), [&](double m) { return compare(from_double(m), value) >= 0; }, out);
}
/// c + sqrt(squared), with one step of Newton's for the root: c may cancel all digits that a double has of it.
constexpr double start_of_search(const exact::Number<1>& c, const exact::Number<4>& squared) noexcept {
  if (squared.sign == 0) return to_finite(exact::rounded(c));
  const arithmetic::Scaled s = exact::rounded(squared);
  const int odd = s.exponent & 1, exponent = (s.exponent - odd) / 2;
  const double value = lane::sqrt(s.value * (1 + odd));
  if (exponent > 1024 || (exponent == 1024 && value >= 1)) return std::numeric_limits<double>::max();
  const auto root = exact::from_double(arithmetic::scale(value, exponent));
  const arithmetic::Scaled sum = exact::rounded(c + root), rest = exact::rounded(squared - exact::square(root));
  if (sum.exponent >= 1024) return to_finite(sum);  // the step might lead beyond the numbers
  return to_finite(sum) + arithmetic::scale(rest.value / (2 * value), rest.exponent - exponent);
}
VESICA_COLD constexpr bool exact_upper(const Ellipse<double>&, const Reach& r, double& out) noexcept {
  using namespace exact;
  const auto c = from_double(r.c);
  const auto extent_squared =
      square(from_double(r.p0) * from_double(r.q0)) + square(from_double(r.p1) * from_double(r.q1));
  const auto start = start_of_search(c, extent_squared);
  const auto reaches = [&](double m) {
    const auto distance = from_double(m) - c;
    return distance.sign >= 0 && compare(square(distance), extent_squared) >= 0;
  };
  return arithmetic::search_up(start, reaches, out);
}

/// The shape's extent along one coordinate as far as double-doubles go.
template <class Shape>
VESICA_INLINE arithmetic::Estimate<double> extent_estimate(const Shape& s, const Reach& r) noexcept {
  const auto x = arithmetic::two_product_fused(std::fabs(r.p0), r.q0),
             y = arithmetic::two_product_fused(std::fabs(r.p1), r.q1);
  const bool usable =
      in_range(r.p0, r.q0, x.high) && in_range(r.p1, r.q1, y.high) && std::fabs(r.c) <= 0x1p400 && r.radius <= 0x1p400;
  return usable ? arithmetic::add(r.radius, estimate(s, x, y)) : unknown;
}

/// The shape's interval along one coordinate: false where a side is beyond the finite numbers.
template <class Shape>
VESICA_INLINE constexpr bool interval(const Shape& s, const Reach& r, double& low, double& high) noexcept {
  bool has_high = false, has_low = false;
  double minus_low = 0;
  if (!std::is_constant_evaluated()) {
    const auto extent = extent_estimate(s, r);
    has_high = arithmetic::round_up(arithmetic::add(r.c, extent), high);
    has_low = arithmetic::round_up(arithmetic::add(-r.c, extent), minus_low);
  }
  if (!arithmetic::both(has_high, has_low)) [[unlikely]] {
    if (!has_high && !exact_upper(s, r, high)) return false;
    if (!has_low && !exact_upper(s, {-r.c, r.p0, r.q0, r.p1, r.q1, r.radius}, minus_low)) return false;
  }
  low = 0 - minus_low;
  return true;
}

/// Bounds of a rectangle, with a radius or without, or an ellipse with half lengths h0 along the axis and h1 across it.
template <class Shape>
constexpr int oblique_bounds(const Shape& s, double h0, double h1, Aabb<double>& out, double radius = 0) noexcept {
  Aabb<double> box;
  if (!interval(s, {s.cx, s.ux, h0, s.uy, h1, radius}, box.min_x, box.max_x)) return error_range;
  if (!interval(s, {s.cy, s.uy, h0, s.ux, h1, radius}, box.min_y, box.max_y)) return error_range;
  out = box;
  return 0;
}

constexpr int bounds_of_valid(const Point<double>& s, Aabb<double>& out) noexcept {
  out = {s.x, s.y, s.x, s.y};
  return 0;
}
constexpr int bounds_of_valid(const Segment<double>& s, Aabb<double>& out) noexcept {
  using vesica::detail::lesser, vesica::detail::greater;
  out = {lesser(s.x0, s.x1), lesser(s.y0, s.y1), greater(s.x0, s.x1), greater(s.y0, s.y1)};
  return 0;
}
constexpr int bounds_of_valid(const Aabb<double>& s, Aabb<double>& out) noexcept {
  out = s;
  return 0;
}
constexpr int bounds_of_valid(const Rect<double>& s, Aabb<double>& out) noexcept {
  return oblique_bounds(s, s.hx, s.hy, out);
}
constexpr int bounds_of_valid(const Circle<double>& s, Aabb<double>& out) noexcept {
  return bounds_of_valid(Rect<double>{s.cx, s.cy, 1, 0, s.r, s.r}, out);
}
constexpr int bounds_of_valid(const Ellipse<double>& s, Aabb<double>& out) noexcept {
  return oblique_bounds(s, s.a, s.b, out);
}
constexpr int bounds_of_valid(const Capsule<double>& s, Aabb<double>& out) noexcept {
  Aabb<double> at_start, at_end;
  const int error = bounds_of_valid(Circle<double>{s.x0, s.y0, s.r}, at_start);
  if (error != 0 || bounds_of_valid(Circle<double>{s.x1, s.y1, s.r}, at_end) != 0) return error_range;
  using vesica::detail::lesser, vesica::detail::greater;
  out = {lesser(at_start.min_x, at_end.min_x), lesser(at_start.min_y, at_end.min_y),
         greater(at_start.max_x, at_end.max_x), greater(at_start.max_y, at_end.max_y)};
  return 0;
}
constexpr int bounds_of_valid(const RoundRect<double>& s, Aabb<double>& out) noexcept {
  return oblique_bounds(Rect<double>{s.cx, s.cy, s.ux, s.uy, s.hx, s.hy}, s.hx, s.hy, out, s.r);
}

}  // namespace detail::bounds

/// Smallest box of doubles that contains the shape. Returns 0, error_shape, or error_range when a side would be
/// beyond the finite doubles; on error `out` is untouched.
template <template <class> class Shape>
constexpr int bounds(const Shape<double>& s, Aabb<double>& out) noexcept {
  if (check(s) != 0) return error_shape;
  return detail::bounds::bounds_of_valid(s, out);
}

/// The same among floats, of bounds among doubles: the smallest double at or above a number, rounded up to a float, is
/// the smallest float.
constexpr int narrow_bounds(const Aabb<double>& wide, Aabb<float>& out) noexcept {
  Aabb<float> box;
  if (!detail::arithmetic::round_up_to(-wide.min_x, box.min_x) ||
      !detail::arithmetic::round_up_to(-wide.min_y, box.min_y) ||
      !detail::arithmetic::round_up_to(wide.max_x, box.max_x) ||
      !detail::arithmetic::round_up_to(wide.max_y, box.max_y)) {
    return error_range;
  }
  out = {0 - box.min_x, 0 - box.min_y, box.max_x, box.max_y};
  return 0;
}

/// Smallest box of floats that contains the shape.
template <template <class> class Shape>
constexpr int bounds(const Shape<float>& s, Aabb<float>& out) noexcept {
  Aabb<double> wide;
  const int error = bounds(widen(s), wide);
  return error != 0 ? error : narrow_bounds(wide, out);
}

}  // namespace vesica
