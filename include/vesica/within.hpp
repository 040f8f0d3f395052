// SPDX-License-Identifier: Apache-2.0
/// within(a, b, distance): are two shapes at most that far apart? A distance of exactly that counts, as touching does.
///
/// Shapes without a curve are boxes, and a circle is the points within its radius of its centre. So the question is
/// whether two boxes are at most a sum of three lengths apart. It is answered in two stages, by a filter, then by exact
/// polynomials of degree 6. With an ellipse the filter is the distance of nearest() and its error, and the polynomials
/// are of degree 12 and 32. The distance of two ellipses is not an algebraic number of low degree: the answer is yes or
/// no only where the error of the computed number leaves no doubt.
///
/// Laws, each tested: exchanging the shapes changes nothing; within(a, b, 0) == overlap(a, b); shapes within a distance
/// are within any greater one.
#pragma once

#include <limits>
#include <vesica/exact/within_ellipse.hpp>
#include <vesica/filter/disc.hpp>
#include <vesica/filter/within.hpp>
#include <vesica/nearest.hpp>

namespace vesica {

/// Numbered as in the C face.
enum class Within : std::int32_t {
  no,
  yes,
  nearly,  ///< only of two ellipses: their distance is too close to the one asked for to decide
};

namespace detail::within {

/// The points at most `reach` from `core`.
template <class Shape>
struct Swept {
  Shape core;
  double reach;
};
template <class Shape>
VESICA_INLINE Swept<Shape> swept(const Shape& s) noexcept {
  return {s, 0};
}
VESICA_INLINE Swept<Point<double>> swept(const Circle<double>& s) noexcept { return {{s.cx, s.cy}, s.r}; }

template <class Shape>
inline constexpr bool is_ellipse = ShapeTraits<Shape>::kind == Kind::ellipse;
template <class Shape>
inline constexpr bool is_point = ShapeTraits<Shape>::kind == Kind::point;

template <class A, class B>
VESICA_INLINE auto filter(const A& a, const B& b, double reach) noexcept {
  const auto d = filter::offset(filter::place(a), filter::place(b));
  if constexpr (is_point<A> && is_point<B>) {
    return filter::guarded(reach >= 0, filter::beyond_reach(d, reach));
  } else if constexpr (is_point<A>) {
    return filter::point_box_within(filter::box(b), {-d.x, -d.y}, reach);
  } else {
    return filter::box_box_within(filter::box(a), filter::box(b), d, reach);
  }
}

/// Shapes, not two ellipses, of kinds in order, that the filter left undecided. The sum of radii and distance is exact.
template <class A, class B>
VESICA_COLD std::int32_t decide(const A& a, const B& b, double distance) noexcept {
  if (check(a) != 0 || check(b) != 0) return error_shape;
  const auto first = swept(a);
  const auto second = swept(b);
  const exact::Length reach =
      exact::from_double(first.reach) + exact::from_double(second.reach) + exact::from_double(distance);
  return exact::within(exact::form(first.core), exact::form(second.core), reach) ? 1 : 0;
}

/// No less than a shape's longer half length, and greater by a few roundoffs at most.
template <class Shape>
double half_length(const Shape& s) noexcept {
  constexpr form::AsStored<double> number;
  const auto f = form::of(s);
  const double x = std::fabs(number(f.ux)), y = std::fabs(number(f.uy)), longer = std::fmax(x, y);
  if (longer == 0) return 0;
  const double ratio = std::fmin(x, y) / longer;
  return std::fmax(number(f.hx), number(f.hy)) * (longer * std::sqrt(1 + ratio * ratio));
}

/// The scale of vesica.h.
template <class A, class B>
double scale(const A& a, const B& b) noexcept {
  const auto p = form::corners(form::of(a).place), q = form::corners(form::of(b).place);
  const double dx = 0.5 * ((q.x0 - p.x0) + (q.x1 - p.x1)), dy = 0.5 * ((q.y0 - p.y0) + (q.y1 - p.y1));
  return std::fmax(std::fmax(std::fabs(dx), std::fabs(dy)), std::fmax(half_length(a), half_length(b)));
}

/// The distance of nearest() is right to 4u of the scale, and to half the least number; 4.5u leave room for the
/// roundings here.
template <class A, class B>
double error_of_distance(const A& a, const B& b) noexcept {
  return 9 * 0x1p-54 * scale(a, b) + std::numeric_limits<double>::denorm_min();
}

/// Compares a distance, known to `error`, with the one asked for.
inline Within compared(double found, double asked, double error) noexcept {
  if (std::fabs(found - asked) <= error) return Within::nearly;
  return found < asked ? Within::yes : Within::no;
}

/// Valid disjoint shapes, of kinds in order, the second an ellipse with an area, and a distance above 0.
template <class A>
VESICA_COLD Within by_distance(const A& a, const Ellipse<double>& b, double distance) noexcept {
  ClosestPoints<double> found;
  const double error = error_of_distance(a, b);
  if (!all_finite(error) || nearest::nearest_in_order(a, b, 0, found) != 0) return Within::nearly;
  return compared(found.distance, distance, error);
}

/// An ellipse with all its lengths times k: the axis or, if that is short, the sizes. An axis must not vanish.
inline Ellipse<double> times(double k, const Ellipse<double>& s) noexcept {
  const bool is_short = std::fmax(std::fabs(s.ux), std::fabs(s.uy)) < 1;
  const double of_axis = is_short ? 1 : k, of_sizes = is_short ? k : 1;
  return {k * s.cx, k * s.cy, of_axis * s.ux, of_axis * s.uy, of_sizes * s.a, of_sizes * s.b};
}

/// Two ellipses have no exact stage.
VESICA_COLD inline Within by_distance(Ellipse<double> a, Ellipse<double> b, double distance) noexcept {
  // Lengths are below 2^2050. In a unit of 2^600, or of its square, none is beyond the range of double. What
  // underflows there is nothing beside them: where the shapes overlap then, their distance is a rounding error.
  for (int unit = 0; unit < 3; ++unit) {
    ClosestPoints<double> found;
    const double error = error_of_distance(a, b);
    if (all_finite(error) && nearest::nearest_in_order(a, b, 0, found) == 0) {
      return compared(found.distance, distance, error);
    }
    constexpr double k = 0x1p-600;
    a = times(k, a);
    b = times(k, b);
    distance *= k;
  }
  return Within::nearly;
}

/// With an ellipse.
template <class A, class B>
std::int32_t curved(const A& a, const B& b, double distance) noexcept {
  const std::int32_t overlapping = overlap_or_error(a, b);
  if (overlapping != 0 || distance == 0) return overlapping;
  if (!all_finite(distance)) return 1;
  const Within answer = by_distance(a, b, distance);
  if constexpr (!is_ellipse<A>) {
    if (answer == Within::nearly) return decide(a, b, distance);
  }
  return static_cast<std::int32_t>(answer);
}

/// With a core and a radius, undecided by the filter.
template <class A, class B>
VESICA_COLD std::int32_t decide_inflated(const A& a, const B& b, double distance) noexcept {
  if (check(a) != 0 || check(b) != 0) return error_shape;
  if (!all_finite(distance)) return 1;
  if constexpr (overlap::HasEstimate<A, B>) {
    const std::int32_t answer = overlap::estimate_within(a, b, distance);
    if (answer >= 0) return answer;
  }
  return overlap::exactly_within(a, b, distance) ? 1 : 0;
}

}  // namespace detail::within

/// The checked form: a Within as a number, error_argument for a distance that is negative or NaN, error_shape when
/// either shape is invalid. Shapes of any kinds, in either order.
template <template <class> class A, template <class> class B>
std::int32_t within_or_error(const A<double>& a, const B<double>& b, double distance) noexcept {
  namespace within = detail::within;
  if constexpr (!detail::in_order<A<double>, B<double>>) {
    return within_or_error(b, a, distance);
  } else if constexpr (detail::form::Inflated<B<double>>) {
    if (!(distance > 0)) return distance == 0 ? overlap_or_error(a, b) : error_argument;
    const auto verdict = detail::overlap::filter_within(a, b, distance);
    if (verdict.overlap || verdict.disjoint) [[likely]]
      return verdict.overlap ? 1 : 0;
    return within::decide_inflated(a, b, distance);
  } else if constexpr (within::is_ellipse<B<double>>) {
    if (!(distance >= 0)) return error_argument;
    // Without an area it is a rectangle without one.
    if (b.a == 0 || b.b == 0) return within_or_error(a, Rect<double>{b.cx, b.cy, b.ux, b.uy, b.a, b.b}, distance);
    if constexpr (within::is_ellipse<A<double>>) {
      if (a.a == 0 || a.b == 0) return within_or_error(Rect<double>{a.cx, a.cy, a.ux, a.uy, a.a, a.b}, b, distance);
    }
    return within::curved(a, b, distance);
  } else {
    if (!(distance > 0)) return distance == 0 ? overlap_or_error(a, b) : error_argument;
    const auto first = within::swept(a);
    const auto second = within::swept(b);
    if (first.reach >= 0 && second.reach >= 0) {
      const double reach = (first.reach + second.reach) + distance;
      const filter::Verdict<bool> verdict = [&] {
        if constexpr (within::is_point<decltype(second.core)> && !within::is_point<decltype(first.core)>) {
          return within::filter(second.core, first.core, reach);
        } else {
          return within::filter(first.core, second.core, reach);
        }
      }();
      if (verdict.overlap || verdict.disjoint) [[likely]]
        return verdict.overlap ? 1 : 0;
    }
    if (!detail::all_finite(distance)) return check(a) != 0 || check(b) != 0 ? error_shape : 1;
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
