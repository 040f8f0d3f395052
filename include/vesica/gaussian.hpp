// SPDX-License-Identifier: Apache-2.0
/// Distances of two shapes as Gaussian distributions: of Bhattacharyya and Hellinger, the divergence of Kullback and
/// Leibler, and the squared distance of Wasserstein. Rotated detectors train and match with them. None of them is an
/// IoU: shapes that share no area have them too, and shapes with the same Gaussian have 0.
///
/// A shape's Gaussian has the mean and the covariance of its points: h^2 / 3 along an axis of a box with half length h,
/// which is width^2 / 12, and a^2 / 4 of an ellipse with half length a.
///
/// Formulas are sums of terms >= 0, so nothing cancels between them. Let both Gaussians have their longer axes first,
/// deviations p1 >= p2 and q1 >= q2, and the angle theta between the axes. Each trace and determinant is what it would
/// be without the angle, and a multiple of n = sin(theta)^2 (p1^2 - p2^2) (q1^2 - q2^2):
///
///   trace(Q^-1 P) = p1^2/q1^2 + p2^2/q2^2 + n / (q1 q2)^2
///   det(P + Q) = (p1^2 + q1^2) (p2^2 + q2^2) + n
///   trace((P^1/2 Q P^1/2)^1/2)^2 = (p1 q1 + p2 q2)^2 - n
///
/// Differences of deviations, of means, and the sine are formed from double-doubles, and so right to few u themselves.
///
/// J. M. Llerena et al., "Gaussian Bounding Boxes and Probabilistic Intersection-over-Union", 2021. X. Yang et al.,
/// "Rethinking Rotated Object Detection with Gaussian Wasserstein Distance Loss", ICML 2021; "Learning High-Precision
/// Bounding Box for Rotated Object Detection via Kullback-Leibler Divergence", NeurIPS 2021.
#pragma once

#include <algorithm>
#include <cmath>
#include <vesica/arithmetic/double_double.hpp>
#include <vesica/arithmetic/exponential.hpp>
#include <vesica/arithmetic/logarithm.hpp>
#include <vesica/check.hpp>
#include <vesica/form/placement.hpp>

namespace vesica {

enum class GaussianDistance : std::int32_t {
  bhattacharyya = 0,     ///< -log of the integral of sqrt(density of a * density of b)
  hellinger = 1,         ///< sqrt(1 - exp(-bhattacharyya)); ProbIoU is 1 - this
  kullback_leibler = 2,  ///< of a from b: the mean of log(density of a / density of b) under a
  wasserstein = 3,       ///< the squared one: the least mean square of the way from a's mass to b's
};

constexpr bool is_gaussian_distance(std::int32_t number) noexcept { return number >= 0 && number < 4; }

namespace detail::gaussian {

using Number = arithmetic::FastDoubleDouble<double>;

/// value * 2^exponent.
struct Width {
  Number value;
  int exponent;
};

inline double scaled(double x, int exponent) noexcept { return exponent == 0 ? x : arithmetic::scale_far(x, exponent); }
inline Number scaled(const Number& x, int exponent) noexcept {
  return {scaled(x.high, exponent), scaled(x.low, exponent)};
}
inline Width normalised(const Number& x, int exponent) noexcept {
  if (x.high == 0) return {{}, form::no_exponent};
  const int own = arithmetic::exponent_of(x.high);
  return {scaled(x, -own), exponent + own};
}
inline bool is_less(const Width& a, const Width& b) noexcept {
  if (a.exponent != b.exponent) return a.exponent < b.exponent;
  return a.value.high < b.value.high || (a.value.high == b.value.high && a.value.low < b.value.low);
}

/// A mean, the direction of the larger deviation, and both deviations times sqrt(12): a box's width and height. These
/// are in units of 2^unit. The unit is 1 for usual lengths; for others the longer deviation is in [1/2, 1).
struct Gaussian {
  form::Corners<double> place;  // two points, whose middle is the mean
  double ux, uy, length;        // the larger of |ux| and |uy| is in [1/2, 1); length is that of (ux, uy)
  Number longer, shorter;
  int unit;
};

inline Gaussian ordered(const form::Corners<double>& place, double ux, double uy, double length, const Width& along,
                        const Width& across) noexcept {
  if (is_less(along, across)) return ordered(place, -uy, ux, length, across, along);
  const int unit = along.exponent >= -60 && along.exponent <= 60 ? 0 : along.exponent;
  return {
      place, ux, uy, length, scaled(along.value, along.exponent - unit), scaled(across.value, across.exponent - unit),
      unit};
}

/// sqrt(12) deviations for each half length: of boxes 2, of ellipses sqrt(3).
inline constexpr Number of_box{2.0, 0.0}, of_ellipse{0x1.bb67ae8584caap+0, 0x1.cec95d0b5c1e3p-54};

inline Gaussian of_axis(double cx, double cy, double ux, double uy, double along, double across,
                        const Number& factor) noexcept {
  const int unit = form::axis_exponent(ux, uy);
  const double x = arithmetic::scale_far(ux, -unit), y = arithmetic::scale_far(uy, -unit);
  const Number length = arithmetic::root(arithmetic::product(x, x) + arithmetic::product(y, y));
  const auto width = [&](double half) {
    const int own = arithmetic::exponent_of(half);
    return normalised(length * arithmetic::scale_far(half, -own) * factor, unit + own);
  };
  return ordered({cx, cy, cx, cy}, x, y, arithmetic::rounded(length), width(along), width(across));
}
inline Gaussian of(const Rect<double>& s) noexcept { return of_axis(s.cx, s.cy, s.ux, s.uy, s.hx, s.hy, of_box); }
inline Gaussian of(const Ellipse<double>& s) noexcept { return of_axis(s.cx, s.cy, s.ux, s.uy, s.a, s.b, of_ellipse); }
inline Gaussian of(const Circle<double>& s) noexcept { return of_axis(s.cx, s.cy, 1, 0, s.r, s.r, of_ellipse); }
inline Gaussian of(const Aabb<double>& s) noexcept {
  const auto width = [](double min, double max) {
    const int unit = arithmetic::exponent_of(std::fmax(std::fabs(min), std::fabs(max)));
    const auto [high, low] =
        arithmetic::two_difference(arithmetic::scale_far(max, -unit), arithmetic::scale_far(min, -unit));
    return normalised({high, low}, unit);
  };
  return ordered({s.min_x, s.min_y, s.max_x, s.max_y}, 0.5, 0, 0.5, width(s.min_x, s.max_x), width(s.min_y, s.max_y));
}

template <class Shape>
concept HasGaussian = requires(const Shape& s) {
  of(s);
};

/// From a's mean to b's, times 2^-exponent.
struct Offset {
  Number x, y;
  int exponent;
};

inline Width twice_offset(double from0, double from1, double to0, double to1) noexcept {
  double most = 0;
  for (const double x : {from0, from1, to0, to1}) most = std::fmax(most, std::fabs(x));
  const int lift = most > 0x1p1000 ? -4 : 0;
  const auto [high, low] = form::twice_offset(to0, to1, from0, from1, arithmetic::power_of_two(lift));
  return {{high, low}, -lift};
}
inline Offset offset(const Gaussian& a, const Gaussian& b) noexcept {
  const form::Corners<double>&p = a.place, &q = b.place;
  const Width x = twice_offset(p.x0, p.x1, q.x0, q.x1), y = twice_offset(p.y0, p.y1, q.y0, q.y1);
  const double most = std::fmax(std::fabs(x.value.high), std::fabs(y.value.high));
  const double least =
      std::fmin(x.value.high == 0 ? most : std::fabs(x.value.high), y.value.high == 0 ? most : std::fabs(y.value.high));
  if (most == 0 || (least >= 0x1p-300 && most <= 0x1p300)) return {x.value * 0.5, y.value * 0.5, 0};
  const Width s = normalised(x.value, x.exponent - 1), t = normalised(y.value, y.exponent - 1);
  const int unit = std::max(s.exponent, t.exponent);
  return {scaled(s.value, s.exponent - unit), scaled(t.value, t.exponent - unit), unit};
}

/// Two Gaussians in units of 2^unit. Deviations are times sqrt(12).
struct Facts {
  double p1, p2, q1, q2;        // deviations of a and of b
  double less_1, less_2;        // p1 - q1, p2 - q2
  double p_squares, q_squares;  // p1^2 - p2^2, q1^2 - q2^2
  double sine, cosine;          // of the angle between the longer axes, but for signs
  int unit;
};

inline Facts facts(const Gaussian& a, const Gaussian& b) noexcept {
  int unit = a.unit;
  if (a.unit != b.unit) {
    const int exponents[] = {form::length_exponent(a.longer.high, a.unit),
                             form::length_exponent(b.longer.high, b.unit)};
    unit = form::common_exponent(exponents);
  }
  const Number p1 = scaled(a.longer, a.unit - unit), p2 = scaled(a.shorter, a.unit - unit);
  const Number q1 = scaled(b.longer, b.unit - unit), q2 = scaled(b.shorter, b.unit - unit);
  const auto less = [](const Number& x, const Number& y) { return arithmetic::rounded(x - y); };
  const double lengths = a.length * b.length;
  const auto product = [](double x, double y) { return arithmetic::product(x, y); };
  return {p1.high,
          p2.high,
          q1.high,
          q2.high,
          less(p1, q1),
          less(p2, q2),
          less(p1, p2) * (p1.high + p2.high),
          less(q1, q2) * (q1.high + q2.high),
          less(product(a.ux, b.uy), product(a.uy, b.ux)) / lengths,
          arithmetic::rounded(product(a.ux, b.ux) + product(a.uy, b.uy)) / lengths,
          unit};
}

/// From mean to mean along the axes of a Gaussian, in units of 2^unit.
struct Way {
  double along, across;
};
inline Way way(const Offset& d, const Gaussian& g, int unit) noexcept {
  const auto length = [&](const Number& x) { return scaled(arithmetic::rounded(x) / g.length, d.exponent - unit); };
  return {length(d.x * g.ux + d.y * g.uy), length(d.y * g.ux - d.x * g.uy)};
}

inline double wasserstein(const Facts& f, const Offset& d) noexcept {
  const double straight = f.p1 * f.q1 + f.p2 * f.q2, crossed = f.p1 * f.q2 + f.p2 * f.q1;
  const double along = f.cosine * straight, across = f.sine * crossed;
  const double sum = straight + std::sqrt(along * along + across * across);
  const double turned = sum > 0 ? 2 * (f.sine * f.sine) * (f.p_squares * f.q_squares) / sum : 0;
  const double sizes = f.less_1 * f.less_1 + f.less_2 * f.less_2 + turned;
  const double dx = arithmetic::rounded(d.x), dy = arithmetic::rounded(d.y);
  return scaled(dx * dx + dy * dy, 2 * d.exponent) + scaled(sizes / 12, 2 * f.unit);
}

/// The terms of Bhattacharyya's distance: that of the means, and three whose log(1 + x) / 2 count.
struct Terms {
  double means, longer, shorter, turned;
};
inline Terms terms(const Facts& f, const Way& p, const Way& q) noexcept {
  const double longer = f.p1 * f.p1 + f.q1 * f.q1, shorter = f.p2 * f.p2 + f.q2 * f.q2;
  const double turned = f.sine * f.sine * (f.p_squares * f.q_squares) / longer / shorter;
  const double root = std::sqrt(longer) * std::sqrt(shorter) * std::sqrt(1 + turned);
  const auto square = [](double x) { return x * x; };
  const double of_p = square(p.along * (f.p2 / root)) + square(p.across * (f.p1 / root));
  const double of_q = square(q.along * (f.q2 / root)) + square(q.across * (f.q1 / root));
  return {3 * (of_p + of_q), 0.5 * ((f.less_1 / f.p1) * (f.less_1 / f.q1)),
          0.5 * ((f.less_2 / f.p2) * (f.less_2 / f.q2)), turned};
}

/// The product of 1 + x for the three, less 1: at most 2^801, as distance() admits no smaller deviations.
inline double product_less_1(const Terms& t) noexcept {
  const double sizes = t.longer + t.shorter + t.longer * t.shorter;
  return sizes + t.turned + sizes * t.turned;
}

inline double bhattacharyya(const Terms& t) noexcept {
  return t.means + 0.5 * arithmetic::log_of_1_plus(product_less_1(t));
}

inline double hellinger(const Terms& t) noexcept {
  const double all = product_less_1(t);
  const double root = std::sqrt(1 + all), of_sizes = all < 0x1p120 ? all / (root * (root + 1)) : 1;
  const double of_means = arithmetic::one_minus_exp_of_minus(t.means);
  return std::sqrt(std::fmin(1, of_means + (1 - of_means) * of_sizes));
}

/// r^2 - 1 - log(r^2) of the ratio r = p / q.
inline double divergence(double p, double q, double less) noexcept {
  const double x = less / q;
  const double excess = x >= -0.5 && x <= 1 ? arithmetic::excess_over_log(x) : x - arithmetic::log_of(p / q);
  return x * x + 2 * excess;
}

inline double kullback_leibler(const Facts& f, const Way& q) noexcept {
  const double squares = f.q1 * f.q2, along = q.along / f.q1, across = q.across / f.q2;
  const double turned = (f.sine * (f.p_squares / squares)) * (f.sine * (f.q_squares / squares));
  const double sizes = divergence(f.p1, f.q1, f.less_1) + divergence(f.p2, f.q2, f.less_2);
  return 0.5 * (sizes + turned + 12 * (along * along + across * across));
}

/// Returns 0, error_argument for a deviation of 0, or error_range; Wasserstein's distance takes any deviations.
inline std::int32_t distance(GaussianDistance which, const Gaussian& a, const Gaussian& b, double& out) noexcept {
  const bool any_widths = which == GaussianDistance::wasserstein;
  if (!any_widths && (a.shorter.high == 0 || b.shorter.high == 0)) return error_argument;
  const Facts f = facts(a, b);
  if (!any_widths && !(std::fmin(f.p2, f.q2) >= 0x1p-400 * std::fmax(f.p1, f.q1))) return error_range;
  const Offset d = offset(a, b);
  double result = 0;
  switch (which) {
    case GaussianDistance::bhattacharyya:
      result = bhattacharyya(terms(f, way(d, a, f.unit), way(d, b, f.unit)));
      break;
    case GaussianDistance::hellinger:
      result = hellinger(terms(f, way(d, a, f.unit), way(d, b, f.unit)));
      break;
    case GaussianDistance::kullback_leibler:
      result = kullback_leibler(f, way(d, b, f.unit));
      break;
    case GaussianDistance::wasserstein:
      result = wasserstein(f, d);
      break;
  }
  if (!all_finite(result)) return error_range;
  out = result;
  return 0;
}

/// A result of distance() as a T. Returns 0 or error_range.
template <class T>
std::int32_t rounded_to(double distance, T& out) noexcept {
  const T result = static_cast<T>(distance);
  if (!all_finite(result)) return error_range;
  out = result;
  return 0;
}

}  // namespace detail::gaussian

/// The checked form, for circles, boxes, rectangles and ellipses: writes the distance. Returns 0 or, with nothing
/// written, error_shape, error_argument (no such distance; or a deviation of 0, but for Wasserstein's) or error_range
/// (the distance would overflow; or, but for Wasserstein's, one deviation is more than 2^400 times another).
///
/// Exchanging the shapes changes no bit but for the divergence. Equal Gaussians have exactly 0. Scaling both shapes by
/// 2^k changes nothing but Wasserstein's distance, times 4^k. The relative error is at most 24 u (u = 2^-53), the
/// absolute one beside it 2^-1074.
template <template <class> class A, template <class> class B, class T>
requires detail::gaussian::HasGaussian<A<double>> && detail::gaussian::HasGaussian<B<double>> std::int32_t
gaussian_distance_or_error(GaussianDistance which, const A<T>& a, const B<T>& b, T& out)
noexcept {
  if (!is_gaussian_distance(static_cast<std::int32_t>(which))) return error_argument;
  if (check(a) != 0 || check(b) != 0) return error_shape;
  double result = 0;
  const std::int32_t error =
      detail::gaussian::distance(which, detail::gaussian::of(widen(a)), detail::gaussian::of(widen(b)), result);
  return error != 0 ? error : detail::gaussian::rounded_to(result, out);
}

/// The distance of valid shapes; NaN where gaussian_distance_or_error(), the checked form, returns an error.
template <template <class> class A, template <class> class B, class T>
requires detail::gaussian::HasGaussian<A<double>> && detail::gaussian::HasGaussian<B<double>> T
gaussian_distance(GaussianDistance which, const A<T>& a, const B<T>& b)
noexcept {
  T out = std::numeric_limits<T>::quiet_NaN();
  gaussian_distance_or_error(which, a, b, out);
  return out;
}

}  // namespace vesica
