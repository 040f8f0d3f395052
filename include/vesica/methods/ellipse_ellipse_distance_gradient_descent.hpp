// SPDX-License-Identifier: Apache-2.0
/// Distance between the outlines of two ellipses by gradient descent.
///
/// Idea: the squared distance of the outline points at two angles is a function of those angles; walk down it. Start
/// on the line of centres, for overlapping ellipses from the nearest of 24 x 24 vertices. Source: "Minimum Distance
/// Between Ellipses" (2021).
/// Wrong in print: whether a centre is inside is asked without subtracting the other's; one formula has cosine twice;
/// and the step, rate * exp(-decay i) times the gradient, has the dimension 1 / area, so that it fits samples of size
/// about 5 only. That is Schedule::literal here.
/// Differs, as Schedule::scale_aware: each angle's step is divided by R (R + R' + d), R and R' the two larger half
/// lengths and d the distance so far, which no second derivative of half the squared distance exceeds. A rate of 1
/// then needs no tuning, is the same at any scale, and never goes up. A saddle, where print stops on pairs that mirror
/// each other, is distinguished from a minimum by its second derivatives and left. The result's angles are those of its
/// distance, not the ones a step further.
/// Accuracy: the distance is between two outline points, so below the true one by at most a few roundings of the
/// sizes and the distance of centres. With s = R + R' + d, disjoint ellipses come within about (tolerance s / d)^2 s,
/// and contact within about tolerance^(2/3) s (needles of aspect 1e16: ten times that). Descent slows down like s / d:
/// about ln(1 / tolerance) s / d iterations, so nearer than s / 1000 the default 10000 may run out, and success is 0.
/// Overlapping outlines have several local minima and descent finds one: not the least in 0.4% of random nested pairs
/// of aspect up to 3 and 3% beyond, and not 0 in 1% and 3% of crossing pairs. boundary_distance() has no such
/// limits.
/// Cost: 60 ns an iteration; 25 iterations for the median of random disjoint pairs, 300 for one in a hundred.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vesica/arithmetic/exponential.hpp>
#include <vesica/methods/ellipse_outline.hpp>
#include <vesica/overlap.hpp>

namespace vesica::methods {

/// How long a step is: fit for the pair's scale and proportions, or as printed.
enum class Schedule : std::int32_t { scale_aware = 0, literal = 1 };

/// The largest number of iterations that may be asked for.
inline constexpr std::int32_t most_descent_iterations = 1000000;

/// Step i is rate * exp(-decay * i) times the gradient of the squared distance (literal), or times half of it with each
/// component divided by its bound on the second derivatives (scale_aware). The error is that gradient's larger
/// component: squared units of length (literal), radians (scale_aware). Descent stops when it is below the tolerance.
template <class T>
struct DescentSettings {
  T tolerance, rate, decay;
  std::int32_t iterations;
  Schedule schedule;
};

/// The start of a schedule. The literal one's numbers are those in print.
template <class T>
constexpr DescentSettings<T> descent_settings(Schedule schedule) noexcept {
  const bool literal = schedule == Schedule::literal;
  return {static_cast<T>(1e-8), static_cast<T>(literal ? 0.04 : 1), static_cast<T>(literal ? 0.002 : 0), 10000,
          schedule};
}

/// tolerance > 0, rate > 0 (scale_aware: below 2, where it still goes down), decay >= 0, all finite; iterations from 1
/// to most_descent_iterations.
template <class T>
constexpr bool valid(const DescentSettings<T>& s) noexcept {
  if (!vesica::detail::all_finite(s.tolerance, s.rate, s.decay)) return false;
  if (!(s.tolerance > 0 && s.rate > 0 && s.decay >= 0)) return false;
  if (s.iterations < 1 || s.iterations > most_descent_iterations) return false;
  return s.schedule == Schedule::literal || (s.schedule == Schedule::scale_aware && s.rate < 2);
}

/// The two outline points as angles t of C + a cos(t) u + b sin(t) perp(u), in radians of [-pi, pi]; their distance;
/// the error there; how often the gradient was evaluated; and 1 when the error came below the tolerance, else 0.
template <class T>
struct DescentResult {
  T angle_a, angle_b, distance, error;
  std::int32_t iterations, success;
};

namespace detail {

/// On the line of centres, angles taken as for circles.
inline Angles start_on_line_of_centres(const OutlinePair& p) noexcept {
  const auto angle_of = [](const Outline& e, double x, double y) {
    return std::atan2(e.ux * y - e.uy * x, e.ux * x + e.uy * y);
  };
  return {angle_of(p.a, p.dx, p.dy), angle_of(p.b, -p.dx, -p.dy)};
}

/// The nearest of 24 x 24 vertices.
inline Angles start_at_nearest_vertices(const OutlinePair& p) noexcept {
  constexpr int vertices = 24;
  constexpr double step = 2 * std::numbers::pi / vertices;
  OutlinePoint of_b[vertices];
  for (int j = 0; j < vertices; ++j) of_b[j] = point_at(p.b, j * step);
  double nearest = std::numeric_limits<double>::infinity();
  Angles start{};
  for (int i = 0; i < vertices; ++i) {
    const OutlinePoint of_a = point_at(p.a, i * step);
    for (int j = 0; j < vertices; ++j) {
      const double x = of_a.x - of_b[j].x - p.dx, y = of_a.y - of_b[j].y - p.dy, squared = x * x + y * y;
      if (squared >= nearest) continue;
      nearest = squared;
      start = {i * step, j * step};
    }
  }
  return start;
}

/// 0 / 0 is 0: what a point contributes.
inline double quotient(double x, double y) noexcept { return x == 0 ? 0 : x / y; }

/// The gradient with each component over its bound R (R + R' + d). For the matrix of second derivatives exceeds
/// diag(R (R + d), R' (R' + d)) by an off-diagonal of at most R R' only, and that is no more than R R' on both
/// diagonals; so of steps along this vector all below twice its length go down.
inline Angles scaled_gradient(const OutlinePair& p, const Slope& s) noexcept {
  const double reach = p.a.largest + p.b.largest + s.distance;
  return {quotient(quotient(s.gradient.a, p.a.largest), reach), quotient(quotient(s.gradient.b, p.b.largest), reach)};
}

/// The gradient of the squared distance in the caller's units; infinite where it leaves the range.
inline Angles literal_gradient(const OutlinePair& p, const Slope& s) noexcept {
  return {vesica::detail::arithmetic::scale(2 * s.gradient.a, 2 * p.exponent),
          vesica::detail::arithmetic::scale(2 * s.gradient.b, 2 * p.exponent)};
}

/// From a stationary point, the steepest way down by second derivatives, in the measure in which their bounds are 1.
/// Zero when no eigenvalue of theirs is below -threshold.
inline Angles way_off_saddle(const OutlinePair& p, const Slope& s, double threshold) noexcept {
  const double reach = p.a.largest + p.b.largest + s.distance;
  const double root_a = std::sqrt(p.a.largest), root_b = std::sqrt(p.b.largest);
  const double tax = quotient(s.a.tangent_x, root_a), tay = quotient(s.a.tangent_y, root_a);
  const double tbx = quotient(s.b.tangent_x, root_b), tby = quotient(s.b.tangent_y, root_b);
  const double bend_a = quotient(s.a.x, p.a.largest) * s.dx + quotient(s.a.y, p.a.largest) * s.dy;
  const double bend_b = quotient(s.b.x, p.b.largest) * s.dx + quotient(s.b.y, p.b.largest) * s.dy;
  const double aa = quotient(tax * tax + tay * tay - bend_a, reach);
  const double bb = quotient(tbx * tbx + tby * tby + bend_b, reach);
  const double ab = quotient(-(tax * tbx + tay * tby), reach);
  const double lower = (aa + bb) / 2 - vesica::detail::arithmetic::length((aa - bb) / 2, ab);
  if (lower >= -threshold) return {0, 0};
  // The eigenvector, by the row of the matrix that is larger.
  const double along_a = quotient(aa > bb ? -ab : bb - lower, root_a);
  const double along_b = quotient(aa > bb ? aa - lower : -ab, root_b);
  const double longest = larger(std::fabs(along_a), std::fabs(along_b));
  // So long that what this derivative gains outweighs the fourth one's loss; of the two ways along it, see to the
  // third.
  const double length = longest > 0 ? -lower / longest : 0;
  return longest > 0 ? Angles{length * along_a, length * along_b} : Angles{-lower, 0};
}

inline Angles leave_saddle(const OutlinePair& p, Angles at, Angles way) noexcept {
  const Angles one{at.a + way.a, at.b + way.b}, other{at.a - way.a, at.b - way.b};
  return slope(p, one).distance <= slope(p, other).distance ? one : other;
}

/// A number that was computed in double; the largest finite one beyond the range.
template <class T>
T saturated(double x) noexcept {
  constexpr T most = std::numeric_limits<T>::max();
  return x < static_cast<double>(most) ? static_cast<T>(x) : most;
}

/// The position of the descent, and the gradient there.
struct Descent {
  Slope slope;
  double error;
  std::int32_t iterations;
  bool success;
};

/// Errors of the first `capacity` iterations go to `errors`.
template <class T>
Descent descend(const OutlinePair& p, Angles at, const DescentSettings<T>& settings, T* errors,
                std::int32_t capacity) noexcept {
  const bool scale_aware = settings.schedule == Schedule::scale_aware;
  const double tolerance = static_cast<double>(settings.tolerance), cube_root = std::cbrt(tolerance);
  // At contact descent ends this far from the minimum, in distance and in second derivatives.
  const double threshold = 4 * cube_root * cube_root;
  const double decay = vesica::detail::arithmetic::exp_of_minus(static_cast<double>(settings.decay), 0);
  double rate = static_cast<double>(settings.rate);
  for (std::int32_t i = 1;; ++i, rate *= decay) {
    const Slope s = slope(p, at);
    const Angles gradient = scale_aware ? scaled_gradient(p, s) : literal_gradient(p, s);
    const double error = larger(std::fabs(gradient.a), std::fabs(gradient.b));
    if (i <= capacity) errors[i - 1] = saturated<T>(error);
    Angles next{at.a - rate * gradient.a, at.b - rate * gradient.b};
    if (error < tolerance) {
      const Angles way = scale_aware ? way_off_saddle(p, s, threshold) : Angles{0, 0};
      if (way.a == 0 && way.b == 0) return {s, error, i, true};
      next = leave_saddle(p, at, way);
    }
    if (i == settings.iterations || !vesica::detail::all_finite(next.a, next.b)) return {s, error, i, false};
    at = next;
  }
}

}  // namespace detail

/// The error of iteration i goes to errors[i], for i below `capacity`; errors may be null when capacity is 0. 1 when
/// it converged, 0 when not; error_shape when an ellipse is invalid, error_argument when a setting or capacity is,
/// error_range when the distance is beyond the finite numbers (errors may then be written already).
template <class T>
std::int32_t gradient_descent_distance(const Ellipse<T>& a, const Ellipse<T>& b, const DescentSettings<T>& settings,
                                       DescentResult<T>& out, T* errors = nullptr, std::int32_t capacity = 0) noexcept {
  if (check(a) != 0 || check(b) != 0) return error_shape;
  if (!valid(settings) || capacity < 0) return error_argument;
  const detail::OutlinePair p = detail::outline_pair(widen(a), widen(b));
  const detail::Angles start =
      overlap(a, b) ? detail::start_at_nearest_vertices(p) : detail::start_on_line_of_centres(p);
  const detail::Descent end = detail::descend(p, start, settings, errors, capacity);
  // In two steps, for the exponents of lengths go up to twice those of numbers.
  const double half_way = vesica::detail::arithmetic::scale(end.slope.distance, p.exponent / 2);
  const double distance = vesica::detail::arithmetic::scale(half_way, p.exponent - p.exponent / 2);
  if (!(distance <= static_cast<double>(std::numeric_limits<T>::max()))) return error_range;
  out = {static_cast<T>(std::atan2(end.slope.a.sine, end.slope.a.cosine)),
         static_cast<T>(std::atan2(end.slope.b.sine, end.slope.b.cosine)),
         static_cast<T>(distance),
         detail::saturated<T>(end.error),
         end.iterations,
         end.success ? 1 : 0};
  return out.success;
}

}  // namespace vesica::methods
