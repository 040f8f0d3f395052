// SPDX-License-Identifier: Apache-2.0
/// within(a, b, distance): are two shapes at most that far apart? A distance of exactly that counts, as touching does.
///
/// Capsules, rounded rectangles and circles are the points at most a radius from a core, and other shapes are their own
/// core (form/inflated.hpp). So the question is whether two cores are at most a sum of three lengths apart. A filter
/// decides nearly all pairs. With an ellipse, the distance of nearest() and its error decide most of the rest. Exact
/// polynomials of degree 6 decide what remains; with an ellipse of degree 12 and 32. The distance of two ellipses is
/// not an algebraic number of low degree: the answer is yes or no only where the error of the computed number leaves no
/// doubt.
///
/// Laws, each tested: exchanging the shapes changes nothing; within(a, b, 0) == overlap(a, b); shapes within a distance
/// are within any greater one.
#pragma once

#include <limits>
#include <vesica/nearest.hpp>
#include <vesica/overlap.hpp>

namespace vesica {

/// Numbered as in the C face.
enum class Within : std::int32_t {
  no,
  yes,
  nearly,  ///< only of two ellipses: their distance is too close to the one asked for to decide
};

namespace detail::within {

/// No less than an ellipse's longer half length, and greater by a few roundoffs at most.
inline double half_length(const Ellipse<double>& s) noexcept {
  const double x = std::fabs(s.ux), y = std::fabs(s.uy), longer = std::fmax(x, y), ratio = std::fmin(x, y) / longer;
  return std::fmax(s.a, s.b) * (longer * std::sqrt(1 + ratio * ratio));
}

/// The scale of vesica.h.
inline double scale(const Ellipse<double>& a, const Ellipse<double>& b) noexcept {
  return std::fmax(std::fmax(std::fabs(b.cx - a.cx), std::fabs(b.cy - a.cy)),
                   std::fmax(half_length(a), half_length(b)));
}

/// An ellipse with all its lengths times k: the axis or, if that is short, the sizes. An axis must not vanish.
inline Ellipse<double> times(double k, const Ellipse<double>& s) noexcept {
  const bool is_short = std::fmax(std::fabs(s.ux), std::fabs(s.uy)) < 1;
  const double of_axis = is_short ? 1 : k, of_sizes = is_short ? k : 1;
  return {k * s.cx, k * s.cy, of_axis * s.ux, of_axis * s.uy, of_sizes * s.a, of_sizes * s.b};
}

/// Two disjoint ellipses with an area, and a distance above 0. The distance of nearest() is right to 4u of the scale,
/// and to half the least number; 4.5u leave room for the roundings here.
VESICA_COLD inline Within by_distance(Ellipse<double> a, Ellipse<double> b, double distance) noexcept {
  // Lengths are below 2^2050. In a unit of 2^600, or of its square, none is beyond the range of double. What
  // underflows there is nothing beside them: where the shapes overlap then, their distance is a rounding error.
  for (int unit = 0; unit < 3; ++unit) {
    ClosestPoints<double> found;
    const double error = 9 * 0x1p-54 * scale(a, b) + std::numeric_limits<double>::denorm_min();
    if (all_finite(error) && nearest::nearest_in_order(a, b, 0, found) == 0) {
      if (std::fabs(found.distance - distance) <= error) return Within::nearly;
      return found.distance < distance ? Within::yes : Within::no;
    }
    constexpr double k = 0x1p-600;
    a = times(k, a);
    b = times(k, b);
    distance *= k;
  }
  return Within::nearly;
}

/// Undecided by the filter, and not two ellipses. The sum of radii and distance is exact.
template <class A, class B>
VESICA_COLD std::int32_t decide(const A& a, const B& b, double distance) noexcept {
  if (check(a) != 0 || check(b) != 0) return error_shape;
  if (!all_finite(distance)) return 1;
  const std::int32_t answer = overlap::estimate_within(a, b, distance);
  return answer >= 0 ? answer : static_cast<std::int32_t>(overlap::exactly_within(a, b, distance));
}

}  // namespace detail::within

/// The checked form: a Within as a number, error_argument for a distance that is negative or NaN, error_shape when
/// either shape is invalid. Shapes of any kinds, in either order.
template <template <class> class A, template <class> class B>
std::int32_t within_or_error(const A<double>& a, const B<double>& b, double distance) noexcept {
  namespace within = detail::within;
  if constexpr (!detail::in_order<A<double>, B<double>>) {
    return within_or_error(b, a, distance);
  } else if constexpr (detail::overlap::is_ellipse<A<double>> && detail::overlap::is_ellipse<B<double>>) {
    if (!(distance >= 0)) return error_argument;
    // Without an area it is a rectangle without one.
    if (a.a == 0 || a.b == 0) return within_or_error(Rect<double>{a.cx, a.cy, a.ux, a.uy, a.a, a.b}, b, distance);
    if (b.a == 0 || b.b == 0) return within_or_error(Rect<double>{b.cx, b.cy, b.ux, b.uy, b.a, b.b}, a, distance);
    const std::int32_t overlapping = overlap_or_error(a, b);
    if (overlapping != 0 || distance == 0) return overlapping;
    return detail::all_finite(distance) ? static_cast<std::int32_t>(within::by_distance(a, b, distance)) : 1;
  } else {
    if (!(distance > 0)) return distance == 0 ? overlap_or_error(a, b) : error_argument;
    const auto verdict = detail::overlap::filter_within(a, b, distance);
    if (verdict.overlap || verdict.disjoint) [[likely]]
      return verdict.overlap ? 1 : 0;
    return within::decide(a, b, distance);
  }
}

/// A float is a double exactly.
template <template <class> class A, template <class> class B>
std::int32_t within_or_error(const A<float>& a, const B<float>& b, float distance) noexcept {
  return within_or_error(widen(a), widen(b), static_cast<double>(distance));
}

/// True if two valid shapes of any kinds are at most `distance` >= 0 apart.
template <template <class> class A, template <class> class B, class T>
Within within(const A<T>& a, const B<T>& b, T distance) noexcept {
  const std::int32_t answer = within_or_error(a, b, distance);
  return answer < 0 ? Within::no : static_cast<Within>(answer);
}

}  // namespace vesica
