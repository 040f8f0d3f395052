// SPDX-License-Identifier: Apache-2.0
/// within(a, b, distance): are two shapes at most that far apart? A distance of exactly that counts, as touching does.
/// With a negative distance: do they overlap at least that deep? The depth is that of depth().
///
/// Capsules, rounded rectangles and circles are the points at most a radius from a core, and other shapes are their own
/// core (form/inflated.hpp). So the question is whether two cores are at most a sum of three lengths apart. A filter
/// decides nearly all pairs. With an ellipse, the distance of nearest() and its error decide most of the rest. Exact
/// polynomials of degree 6 decide what remains; with an ellipse of degree 12 and 32. The distance of two ellipses is
/// not an algebraic number of low degree: the answer is yes or no only where the error of the computed number leaves no
/// doubt.
///
/// If the sum of the three lengths is negative, the cores must overlap at least that deep (core_reach()). With an
/// ellipse, depth() and its error decide that, and an exact predicate only where the other core is a point.
///
/// Laws, each tested: exchanging the shapes changes nothing; within(a, b, 0) == overlap(a, b); shapes within a distance
/// are within any greater one.
#pragma once

#include <limits>
#include <vesica/depth.hpp>
#include <vesica/nearest.hpp>
#include <vesica/overlap.hpp>

namespace vesica {

/// Numbered as in the C interface.
enum class Within : std::int32_t {
  no,
  yes,
  nearly,  ///< only with ellipses: the distance is too close to the one asked for to decide
};

namespace detail::within {

/// No less than a shape's longer half length, and greater by a few roundoffs at most.
inline double half_length(const filter::Box<double>& s) noexcept {
  const double x = std::fabs(s.ux), y = std::fabs(s.uy), longer = std::fmax(x, y);
  if (longer == 0) return 0;  // a segment from a point to itself
  const double ratio = std::fmin(x, y) / longer;
  return std::fmax(s.hx, s.hy) * (longer * std::sqrt(1 + ratio * ratio));
}

/// The scale of vesica.h.
template <class A, class B>
double scale(const A& a, const B& b) noexcept {
  const auto d = filter::offset(filter::place(a), filter::place(b));
  return std::fmax(std::fmax(std::fabs(d.x), std::fabs(d.y)),
                   std::fmax(half_length(filter::box(a)), half_length(filter::box(b))));
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
  if (!all_finite(distance)) return distance > 0 ? 1 : 0;
  const std::int32_t answer = overlap::estimate_within(a, b, distance);
  return answer >= 0 ? answer : static_cast<std::int32_t>(overlap::exactly_within(a, b, distance));
}

/// How far cores may be apart, or how deep they must overlap if it is negative: the sum of both radii and the distance.
///
/// Proved: the points of b less those of a are K, the same of the cores, with a disc of both radii r. The shapes
/// overlap at least t = -distance deep iff that contains the disc of radius t about the origin. Of convex sets a common
/// disc may be taken away: if t <= r, K with r - t must contain the origin. Otherwise K must contain the disc of radius
/// t - r.
///
/// It has a relative error of at most 2u. If r and t differ by at most a factor of 2, their difference is exact, and
/// one rounding follows. If not, the result is at least r / 2, and the two small terms are at most u of r and u of it.
inline double core_reach(double radius_a, double radius_b, double distance) noexcept {
  const auto radii = arithmetic::two_sum(radius_a, radius_b), sum = arithmetic::two_sum(radii.high, distance);
  return sum.high + (sum.low + radii.low);
}

/// True if depth() states no bound on its error with a shape of these half sizes, which is no segment.
inline bool is_thin(double a, double b) noexcept {
  return std::fmin(a, b) > 0 && std::fmax(a, b) > 1e6 * std::fmin(a, b);
}

/// A box without its shorter size.
inline Rect<double> flattened(Rect<double> s) noexcept {
  (s.hx < s.hy ? s.hx : s.hy) = 0;
  return s;
}
inline Aabb<double> flattened(Aabb<double> s) noexcept {
  const auto [ux, uy, hx, hy] = filter::box(s);
  return hx < hy ? Aabb<double>{s.min_x, s.min_y, s.min_x, s.max_y} : Aabb<double>{s.min_x, s.min_y, s.max_x, s.min_y};
}

/// Does an ellipse with an area overlap another shape at least `depth` > 0 deep? The depth of depth() is right to 4u of
/// the scale, and to half the least number; whether it is 0 is exact. The depth asked for may have an error of 2u.
template <class A>
VESICA_COLD Within by_depth(const A& a, const Ellipse<double>& b, double depth) noexcept {
  if (!all_finite(depth)) return Within::no;
  Penetration<double> found{};
  const bool is_beyond_range = depth::depth_in_order(a, b, depth::not_asked, found) != 0;
  if (!is_beyond_range && found.depth == 0) return Within::no;
  if constexpr (ShapeTraits<A>::kind == Kind::aabb || ShapeTraits<A>::kind == Kind::rect) {
    const auto [ux, uy, hx, hy] = filter::box(a);
    if (is_thin(hx, hy)) {
      // The depth lies between that of the flat box and as much more as was taken away.
      const double rest = (depth - half_length({ux, uy, 2 * std::fmin(hx, hy), 0})) * (1 - 0x1p-50);
      if (by_depth(flattened(a), b, depth) == Within::yes) return Within::yes;
      return rest > 0 && by_depth(flattened(a), b, rest) == Within::no ? Within::no : Within::nearly;
    }
  }
  const double error = 9 * 0x1p-54 * scale(a, b) + 4 * 0x1p-54 * depth + std::numeric_limits<double>::denorm_min();
  if (is_beyond_range) return all_finite(error) && depth < 0x1p1023 ? Within::yes : Within::nearly;
  if (!(std::fabs(found.depth - depth) > error)) return Within::nearly;
  return found.depth > depth ? Within::yes : Within::no;
}

/// The same for a thin ellipse, by the rectangle around it and its longer axis: the greater a shape, the deeper.
template <class A>
VESICA_COLD Within by_bounds(const A& a, const Ellipse<double>& e, double distance) noexcept {
  Rect<double> box{e.cx, e.cy, e.ux, e.uy, e.a, e.b};
  if (within_or_error(a, box, distance) == 0) return Within::no;
  (e.a < e.b ? box.hx : box.hy) = 0;
  return within_or_error(a, box, distance) == 1 ? Within::yes : Within::nearly;
}

/// Two ellipses with an area, for a distance < 0.
VESICA_COLD inline Within deep(const Ellipse<double>& a, const Ellipse<double>& b, double distance) noexcept {
  if (is_thin(a.a, a.b)) return by_bounds(b, a, distance);
  return is_thin(b.a, b.b) ? by_bounds(a, b, distance) : by_depth(a, b, -distance);
}

/// For a distance < 0; shapes in order, not two ellipses.
template <class A, class B>
VESICA_CALLED std::int32_t deep(const A& a, const B& b, double distance) noexcept {
  const auto p = form::inflated(a);
  const auto q = form::inflated(b);
  const double reach = core_reach(p.radius, q.radius, distance);
  if (reach >= 0) {
    const auto verdict = overlap::filter_within(p.core, q.core, reach);
    if ((verdict.overlap || verdict.disjoint) && p.radius >= 0 && q.radius >= 0) return verdict.overlap ? 1 : 0;
  } else {
    const auto d = filter::offset(filter::place(p.core), filter::place(q.core));
    const auto verdict = filter::box_box_deep(filter::box(p.core), filter::box(q.core), d, -reach);
    if ((verdict.overlap || verdict.disjoint) && p.radius >= 0 && q.radius >= 0) return verdict.overlap ? 1 : 0;
  }
  return decide(a, b, distance);
}

/// One of the two is an ellipse; it may come first or second.
template <class B>
VESICA_CALLED std::int32_t deep_in_ellipse(const B& b, const Ellipse<double>& e, double distance) noexcept {
  const auto [core, radius] = form::inflated(b);
  const double reach = core_reach(radius, 0, distance);
  if (reach >= 0) {
    const auto verdict = overlap::filter_within(core, e, reach);
    if ((verdict.overlap || verdict.disjoint) && radius >= 0) return verdict.overlap ? 1 : 0;
  } else {
    if (check(b) != 0 || check(e) != 0) return error_shape;
    const bool has_area = e.a > 0 && e.b > 0;
    const bool is_exact = filter::is_point<std::remove_cv_t<decltype(core)>> || !has_area;
    const Within answer = !has_area           ? Within::nearly
                          : is_thin(e.a, e.b) ? by_bounds(b, e, distance)
                                              : by_depth(core, e, -reach);
    if (answer != Within::nearly || !is_exact) return static_cast<std::int32_t>(answer);
    if (all_finite(distance)) return overlap::exactly_within(b, e, distance) ? 1 : 0;
  }
  return decide(b, e, distance);
}
template <class A>
std::int32_t deep(const A& a, const Ellipse<double>& b, double distance) noexcept {
  return deep_in_ellipse(a, b, distance);
}
template <class B>
std::int32_t deep(const Ellipse<double>& a, const B& b, double distance) noexcept {
  return deep_in_ellipse(b, a, distance);
}

}  // namespace detail::within

/// The checked form: a Within as a number, error_argument for a distance that is NaN, error_shape when either shape is
/// invalid. Shapes of any kinds, in either order.
template <template <class> class A, template <class> class B>
std::int32_t within_or_error(const A<double>& a, const B<double>& b, double distance) noexcept {
  namespace within = detail::within;
  if constexpr (!detail::in_order<A<double>, B<double>>) {
    return within_or_error(b, a, distance);
  } else if constexpr (detail::overlap::is_ellipse<A<double>> && detail::overlap::is_ellipse<B<double>>) {
    if (distance != distance) return error_argument;
    // Without an area it is a rectangle without one.
    if (a.a == 0 || a.b == 0) return within_or_error(Rect<double>{a.cx, a.cy, a.ux, a.uy, a.a, a.b}, b, distance);
    if (b.a == 0 || b.b == 0) return within_or_error(Rect<double>{b.cx, b.cy, b.ux, b.uy, b.a, b.b}, a, distance);
    if (distance < 0) {
      if (check(a) != 0 || check(b) != 0) return error_shape;
      return static_cast<std::int32_t>(within::deep(a, b, distance));
    }
    const std::int32_t overlapping = overlap_or_error(a, b);
    if (overlapping != 0 || distance == 0) return overlapping;
    return detail::all_finite(distance) ? static_cast<std::int32_t>(within::by_distance(a, b, distance)) : 1;
  } else {
    if (!(distance > 0)) {
      if (distance < 0) return within::deep(a, b, distance);
      return distance == 0 ? overlap_or_error(a, b) : error_argument;
    }
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

/// Are two valid shapes of any kinds at most `distance` apart, or at least -distance deep in one another?
template <template <class> class A, template <class> class B, class T>
Within within(const A<T>& a, const B<T>& b, T distance) noexcept {
  const std::int32_t answer = within_or_error(a, b, distance);
  return answer < 0 ? Within::no : static_cast<Within>(answer);
}

}  // namespace vesica
