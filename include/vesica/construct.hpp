// SPDX-License-Identifier: Apache-2.0
/// Shapes from other descriptions: corners, angles, radius vectors, covariances, matrices. Each function returns 0 and
/// writes a valid shape, or returns an error and writes nothing. Floats are computed in double and rounded once, at the
/// end.
#pragma once

#include <cmath>
#include <limits>
#include <vesica/arithmetic/length.hpp>
#include <vesica/arithmetic/rounding.hpp>
#include <vesica/arithmetic/spectrum.hpp>
#include <vesica/arithmetic/turn.hpp>
#include <vesica/check.hpp>
#include <vesica/shapes.hpp>

namespace vesica {

namespace detail {

/// A computed shape can be invalid in one way only: a number may have overflowed.
template <class Shape>
int store(const Shape& s, Shape& out) noexcept {
  if (check(s) != 0) return error_range;
  out = s;
  return 0;
}

/// A product rounded once; 0 or infinite where it leaves the range.
template <class T>
T multiply(const arithmetic::Scaled& a, const arithmetic::Scaled& b) noexcept {
  return static_cast<T>(arithmetic::scale(a.value * b.value, a.exponent + b.exponent));
}
/// 1 / a.
template <class T>
T invert(const arithmetic::Scaled& a) noexcept {
  return static_cast<T>(arithmetic::scale(1 / a.value, -a.exponent));
}

inline arithmetic::Scaled take_apart(double x) noexcept {
  const int exponent = arithmetic::exponent_of(x);
  return {arithmetic::scale(x, -exponent), exponent};
}

/// a + b + c + d, right to 1 roundoff of the sum plus 2^-100 of the largest term.
template <class V>
VESICA_INLINE V sum_of_four(V a, V b, V c, V d) noexcept {
  const auto ab = arithmetic::two_sum(a, b), cd = arithmetic::two_sum(c, d),
             all = arithmetic::two_sum(ab.high, cd.high);
  return all.high + (all.low + (ab.low + cd.low));
}

/// A quarter of a length.
inline arithmetic::Scaled quarter(const arithmetic::Scaled& length) noexcept {
  return {length.value / 4, length.exponent};
}

/// A rectangle whose sizes still carry their power of two.
struct MeanRect {
  double cx, cy, ux, uy;
  arithmetic::Scaled hx, hy;
};

/// The mean rectangle of four corners x0 y0 ... x3 y3 in order, all of magnitude at most 2^1021.
inline MeanRect mean_rect(const double (&p)[8]) noexcept {
  const double cx = sum_of_four(p[0], p[2], p[4], p[6]) / 4, cy = sum_of_four(p[1], p[3], p[5], p[7]) / 4;
  // Twice the mean edge from corner 0 to 1 and 3 to 2, and from 0 to 3 and 1 to 2.
  const auto first =
      arithmetic::unit_and_length(sum_of_four(p[2], -p[0], p[4], -p[6]), sum_of_four(p[3], -p[1], p[5], -p[7]));
  const auto second =
      arithmetic::unit_and_length(sum_of_four(p[6], -p[0], p[4], -p[2]), sum_of_four(p[7], -p[1], p[5], -p[3]));
  // The longer pair gives the direction, because rounding of corners turns it least. The shorter pair gives only its
  // extent across that direction.
  const arithmetic::Scaled hx = quarter(first.length), hy = quarter(second.length);
  const double across = std::fabs(first.x * second.y - first.y * second.x);
  if (arithmetic::scale(hy.value, hy.exponent - hx.exponent) <= hx.value) {
    return {cx, cy, first.x, first.y, hx, {hy.value * across, hy.exponent}};
  }
  const double turn = first.x * second.y < first.y * second.x ? -1 : 1;
  return {cx, cy, 0 + turn * second.y, 0 - turn * second.x, {hx.value * across, hx.exponent}, hy};
}

/// True if the edges from p to q and from r to s are more than 90 degrees apart, and both are longer than `noise` along
/// x or y. The differences are rounded once, which keeps their signs.
inline bool are_opposed(const double* p, const double* q, const double* r, const double* s, double noise) noexcept {
  const double ax = q[0] - p[0], ay = q[1] - p[1], bx = s[0] - r[0], by = s[1] - r[1];
  const double a = std::fmax(std::fabs(ax), std::fabs(ay)), b = std::fmax(std::fabs(bx), std::fabs(by));
  if (a <= noise || b <= noise) return false;
  const int i = -arithmetic::exponent_of(a), j = -arithmetic::exponent_of(b);
  const double x = arithmetic::scale_far(ax, i), y = arithmetic::scale_far(ay, i);
  const double z = arithmetic::scale_far(bx, j), w = arithmetic::scale_far(by, j);
  // The sign of x z + y w: Kahan's sum of two products is right to 2 roundoffs.
  const double product = x * z;
  return std::fma(y, w, product) + std::fma(x, z, -product) < 0;
}

/// True if corners x0 y0 ... x3 y3 are in another order than the outline's: then two opposite edges, both walked from
/// the same side, are opposed.
///
/// Rounding the corners of a rectangle never does that: it keeps the order of coordinates, so that opposite edges have
/// no components of opposite signs. Formulas that round more than once may do it to edges of a few roundoffs of the
/// largest coordinate: edges of up to `noise` are not looked at.
inline bool are_crossed(const double (&p)[8], double noise) noexcept {
  return are_opposed(p, p + 2, p + 6, p + 4, noise) || are_opposed(p + 2, p + 4, p, p + 6, noise);
}

/// c + s x + t y - p, right to 2 roundoffs of the sum plus 2^-98 of its largest term.
inline double offset(double c, double s, double x, double t, double y, double p) noexcept {
  const auto d = arithmetic::two_sum(c, -p);
  const auto along = arithmetic::two_product_fused(s, x), across = arithmetic::two_product_fused(t, y);
  return sum_of_four(d.high, along.high, across.high, d.low + (along.low + across.low));
}

/// The misfit of corners and a rectangle whose terms are below 2^1020: see rect_corners_misfit().
inline double misfit(const double (&p)[8], const Rect<double>& r) noexcept {
  double distance[4][4];  // from given corner i to the rectangle's corner k
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      const double s = k == 1 || k == 2 ? r.hx : -r.hx, t = k >= 2 ? r.hy : -r.hy;
      distance[i][k] =
          arithmetic::length(offset(r.cx, s, r.ux, -t, r.uy, p[2 * i]), offset(r.cy, s, r.uy, t, r.ux, p[2 * i + 1]));
    }
  }
  double least = std::numeric_limits<double>::infinity();
  for (int start = 0; start < 4; ++start) {
    for (int step = 1; step <= 3; step += 2) {
      double most = 0;
      for (int i = 0; i < 4; ++i) most = std::fmax(most, distance[i][(start + step * i) % 4]);
      least = std::fmin(least, most);
    }
  }
  return least;
}

}  // namespace detail

/// Box with two opposite corners, in any order. Exact. Errors: error_not_finite.
template <class T>
constexpr int aabb_from_corners(T x0, T y0, T x1, T y1, Aabb<T>& out) noexcept {
  if (!detail::all_finite(x0, y0, x1, y1)) return error_not_finite;
  using detail::lesser, detail::greater;
  out = {lesser(x0, x1), lesser(y0, y1), greater(x0, x1), greater(y0, y1)};
  return 0;
}

namespace detail {

/// The rectangle of valid full sizes along and across the unit axis (ux, uy).
template <class T>
Rect<T> rect_along(T cx, T cy, T ux, T uy, T width, T height) noexcept {
  constexpr T half = T{1} / 2;
  // An odd multiple of the smallest number cannot be halved; the axis, a unit of length, can.
  const bool halves = 2 * (half * width) == width && 2 * (half * height) == height;
  return halves ? Rect<T>{cx, cy, ux, uy, half * width, half * height}
                : Rect<T>{cx, cy, half * ux, half * uy, width, height};
}

}  // namespace detail

/// Rectangle from centre, angle in radians (counter-clockwise from +x where y points up), width along the angle and
/// height across it. Sizes are exact. Errors: error_not_finite, error_negative_size.
template <class T>
int rect_from_angle(T cx, T cy, T angle, T width, T height, Rect<T>& out) noexcept {
  if (!detail::all_finite(cx, cy, angle, width, height)) return error_not_finite;
  if (width < 0 || height < 0) return error_negative_size;
  const auto u = detail::arithmetic::direction(static_cast<double>(angle));
  out = detail::rect_along(cx, cy, static_cast<T>(u.x), static_cast<T>(u.y), width, height);
  return 0;
}

/// Rounded rectangle from centre and angle as rect_from_angle, outer width and height, and the radius of its corners.
///
/// The core's sizes are width - 2 radius and height - 2 radius, each rounded once; with radius 0 it is the rectangle of
/// rect_from_angle. Errors: error_not_finite, error_negative_size, error_argument (the radius is more than half the
/// width or height).
template <class T>
int round_rect_from_angle(T cx, T cy, T angle, T width, T height, T radius, RoundRect<T>& out) noexcept {
  if (!detail::all_finite(cx, cy, angle, width, height, radius)) return error_not_finite;
  if (width < 0 || height < 0 || radius < 0) return error_negative_size;
  // Doubling is exact, or overflows and exceeds any size.
  const T twice = 2 * radius;
  if (twice > width || twice > height) return error_argument;
  const auto u = detail::arithmetic::direction(static_cast<double>(angle));
  const Rect<T> core =
      detail::rect_along(cx, cy, static_cast<T>(u.x), static_cast<T>(u.y), width - twice, height - twice);
  out = {cx, cy, core.ux, core.uy, core.hx, core.hy, radius};
  return 0;
}

/// Capsule from centre, angle as rect_from_angle, the length between the ends of its core, and radius. The angle points
/// from the first end to the second.
///
/// The core is that of rect_from_angle with height 0: C - hx u to C + hx u, each coordinate rounded once, or in float
/// twice, to double first. Errors: error_not_finite, error_negative_size, error_range (an end overflows).
template <class T>
int capsule_from_angle(T cx, T cy, T angle, T length, T radius, Capsule<T>& out) noexcept {
  if (!detail::all_finite(cx, cy, angle, length, radius)) return error_not_finite;
  if (length < 0 || radius < 0) return error_negative_size;
  const auto u = detail::arithmetic::direction(static_cast<double>(angle));
  // If the axis is halved and one of its components is rounded, length and component are subnormal. Their product is
  // below half the smallest number, so that the rounding changes nothing.
  const Rect<double> r = widen(detail::rect_along(cx, cy, static_cast<T>(u.x), static_cast<T>(u.y), length, T{0}));
  return detail::store(
      Capsule<T>{static_cast<T>(std::fma(-r.hx, r.ux, r.cx)), static_cast<T>(std::fma(-r.hx, r.uy, r.cy)),
                 static_cast<T>(std::fma(r.hx, r.ux, r.cx)), static_cast<T>(std::fma(r.hx, r.uy, r.cy)), radius},
      out);
}

/// Capsule from the ends of its core and its full width, twice the radius. Exact, but half an odd multiple of the
/// smallest subnormal number is rounded to even. Errors: error_not_finite, error_negative_size.
template <class T>
constexpr int capsule_from_width(T x0, T y0, T x1, T y1, T width, Capsule<T>& out) noexcept {
  if (!detail::all_finite(x0, y0, x1, y1, width)) return error_not_finite;
  if (width < 0) return error_negative_size;
  out = {x0, y0, x1, y1, width / 2};
  return 0;
}

/// Rectangle from four corners x0 y0 ... x3 y3 in order round the outline, either turning sense.
///
/// The centre is the mean of the corners. The unit axis runs from corner 0 towards corner 1 and hx belongs to that
/// edge; opposite edges are averaged, the longer pair gives the direction, and the shorter pair's extent is measured
/// across it. Equal corners: a segment; four times the same: a point with axis (1, 0).
/// Errors: error_not_finite, error_argument (opposite edges more than 90 degrees apart, both longer along x or y than 8
/// epsilon of T times the largest coordinate: corners in another order), error_range (a half extent overflows).
template <class T>
int rect_from_corners(const T (&corners)[8], Rect<T>& out) noexcept {
  double p[8], largest = 0;
  for (int i = 0; i < 8; ++i) {
    if (!detail::all_finite(corners[i])) return error_not_finite;
    p[i] = static_cast<double>(corners[i]);
    largest = std::fmax(largest, std::fabs(p[i]));
  }
  const int lift = largest > 0x1p1020 ? 3 : 0;  // room for sums of four
  for (double& number : p) number = detail::arithmetic::scale(number, -lift);
  constexpr auto epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
  if (detail::are_crossed(p, 8 * epsilon * detail::arithmetic::scale(largest, -lift))) return error_argument;
  const detail::MeanRect r = detail::mean_rect(p);
  const detail::arithmetic::Scaled unit{1, lift};
  return detail::store(Rect<T>{static_cast<T>(detail::arithmetic::scale(r.cx, lift)),
                               static_cast<T>(detail::arithmetic::scale(r.cy, lift)), static_cast<T>(r.ux),
                               static_cast<T>(r.uy), detail::multiply<T>(r.hx, unit), detail::multiply<T>(r.hy, unit)},
                       out);
}

/// The largest distance of a given corner from the rectangle's corner that corresponds to it. The four may start at any
/// corner and run in either sense: the least result of the eight ways counts.
///
/// It is right to 3 units in its last place plus 2^-96 of the largest coordinate, those of the rectangle's corners and
/// half axes among them. Errors: error_not_finite, those of check(), error_range (the result overflows).
template <class T>
int rect_corners_misfit(const T (&corners)[8], const Rect<T>& rect, T& out) noexcept {
  for (const T number : corners) {
    if (!detail::all_finite(number)) return error_not_finite;
  }
  if (const int error = check(rect); error != 0) return error;
  double p[8];
  Rect<double> r{static_cast<double>(rect.cx), static_cast<double>(rect.cy), static_cast<double>(rect.ux),
                 static_cast<double>(rect.uy), static_cast<double>(rect.hx), static_cast<double>(rect.hy)};
  const double axis = std::fmax(std::fabs(r.ux), std::fabs(r.uy));
  double largest = std::fmax(std::fmax(std::fabs(r.cx), std::fabs(r.cy)), std::fmax(r.hx, r.hy) * axis);
  for (int i = 0; i < 8; ++i) p[i] = static_cast<double>(corners[i]);
  for (const double number : p) largest = std::fmax(largest, std::fabs(number));
  const int lift = largest > 0x1p1018 ? 8 : 0;  // room for sums
  const auto lower = [lift](double& number) { number = detail::arithmetic::scale(number, -lift); };
  for (double& number : p) lower(number);
  lower(r.cx), lower(r.cy), lower(r.hx), lower(r.hy);
  // A half axis of 2^1026 is that far from some corner of finite numbers.
  if (!(std::fmax(r.hx, r.hy) * axis < 0x1p1018)) return error_range;
  const T result = static_cast<T>(detail::arithmetic::scale(detail::misfit(p, r), lift));
  if (!detail::all_finite(result)) return error_range;
  out = result;
  return 0;
}

/// Ellipse from centre, angle as rect_from_angle, and half lengths a along the angle and b across it.
/// Errors: error_not_finite, error_negative_size.
template <class T>
int ellipse_from_angle(T cx, T cy, T angle, T a, T b, Ellipse<T>& out) noexcept {
  if (!detail::all_finite(cx, cy, angle, a, b)) return error_not_finite;
  if (a < 0 || b < 0) return error_negative_size;
  const auto u = detail::arithmetic::direction(static_cast<double>(angle));
  out = {cx, cy, static_cast<T>(u.x), static_cast<T>(u.y), a, b};
  return 0;
}

/// Ellipse with half axes (wx, wy) and ratio * perp(wx, wy). Exact. A zero vector gives the point (cx, cy).
/// Errors: error_not_finite, error_negative_size.
template <class T>
constexpr int ellipse_from_radius_vector(T cx, T cy, T wx, T wy, T ratio, Ellipse<T>& out) noexcept {
  if (!detail::all_finite(cx, cy, wx, wy, ratio)) return error_not_finite;
  if (ratio < 0) return error_negative_size;
  out = wx == 0 && wy == 0 ? Ellipse<T>{cx, cy, 1, 0, 0, 0} : Ellipse<T>{cx, cy, wx, wy, 1, ratio};
  return 0;
}

/// Ellipse of the points within k standard deviations of a mean: a >= b up to rounding; the axis is a unit vector with
/// x >= 0.
///
/// The covariance must be positive semidefinite as stored; a singular one gives a segment or a point.
/// Errors: error_not_finite, error_negative_size (k < 0), error_argument (no covariance), error_range (overflow).
template <class T>
int ellipse_from_covariance(T mean_x, T mean_y, T cxx, T cxy, T cyy, T k, Ellipse<T>& out) noexcept {
  if (!detail::all_finite(mean_x, mean_y, cxx, cxy, cyy, k)) return error_not_finite;
  if (k < 0) return error_negative_size;
  detail::arithmetic::Spectrum s;
  const auto kind =
      detail::arithmetic::spectrum(static_cast<double>(cxx), static_cast<double>(cxy), static_cast<double>(cyy), s);
  if (kind == detail::arithmetic::Definite::no) return error_argument;
  const detail::arithmetic::Scaled times = detail::take_apart(static_cast<double>(k));
  const T a = detail::multiply<T>(times, s.larger), b = detail::multiply<T>(times, s.smaller);
  return detail::store(Ellipse<T>{mean_x, mean_y, static_cast<T>(s.x), static_cast<T>(s.y), a, detail::lesser(a, b)},
                       out);
}

/// Ellipse of the points X with (X - C) . M (X - C) <= 1: a >= b; the axis is a unit vector with x >= 0.
///
/// M must be positive definite as stored. Nothing can overflow: an eigenvalue is never below the smallest number by
/// more than the square of the precision. Errors: error_not_finite, error_argument (not positive definite).
template <class T>
int ellipse_from_matrix(T cx, T cy, T mxx, T mxy, T myy, Ellipse<T>& out) noexcept {
  if (!detail::all_finite(cx, cy, mxx, mxy, myy)) return error_not_finite;
  // The inverse of M is a positive multiple of (myy, -mxy, mxx), which has M's eigenvalues and the inverse's axis.
  detail::arithmetic::Spectrum s;
  const auto kind =
      detail::arithmetic::spectrum(static_cast<double>(myy), static_cast<double>(-mxy), static_cast<double>(mxx), s);
  if (kind != detail::arithmetic::Definite::positive) return error_argument;
  const T a = detail::invert<T>(s.smaller), b = detail::invert<T>(s.larger);
  out = {cx, cy, static_cast<T>(s.x), static_cast<T>(s.y), a, detail::lesser(a, b)};
  return 0;
}

}  // namespace vesica
