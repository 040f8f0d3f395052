// SPDX-License-Identifier: Apache-2.0
/// Capsules and rounded rectangles against every shape: are two cores at most the sum of the radii apart? This is
/// within() at a distance of 0, which takes the stages below for every pair but two ellipses.
#pragma once

#include <vesica/check.hpp>
#include <vesica/exact/within_ellipse.hpp>
#include <vesica/filter/inflated.hpp>
#include <vesica/nearest/inflated.hpp>

namespace vesica::detail::overlap {

template <class Shape>
inline constexpr bool is_ellipse = false;
template <class V>
inline constexpr bool is_ellipse<Ellipse<V>> = true;

/// An ellipse and a core with a radius, `distance` farther each way.
template <class V, class B>
VESICA_INLINE constexpr auto ellipse_filter_within(const Ellipse<V>& a, const B& b, V distance) noexcept {
  const auto [core, radius] = form::inflated(b);
  const auto verdict = filter::inflated_box_ellipse(filter::box(core), radius + distance, a,
                                                    filter::offset(filter::place(core), filter::place(a)));
  return filter::guarded(radius >= V(0.0f), verdict.overlap, verdict.disjoint);
}

/// `overlap` stands for at most `distance` apart. Not for two ellipses.
template <class A, class B, class V>
VESICA_INLINE constexpr auto filter_within(const A& a, const B& b, V distance) noexcept {
  if constexpr (is_ellipse<A>) {
    return ellipse_filter_within(a, b, distance);
  } else if constexpr (is_ellipse<B>) {
    return ellipse_filter_within(b, a, distance);
  } else {
    return filter::inflated_pair(form::inflated(a), form::inflated(b), distance);
  }
}

template <class A, form::Inflated B>
VESICA_INLINE constexpr auto filter(const A& a, const B& b) noexcept {
  return filter_within(a, b, decltype(form::inflated(b).radius)(0.0f));
}

/// action(core, core, reach) for valid shapes, not two ellipses: their cores, an ellipse last, and the sum of radii and
/// distance.
template <class A, class B, class Action>
constexpr auto with_cores(const A& a, const B& b, double distance, Action action) noexcept {
  if constexpr (is_ellipse<A>) {
    return with_cores(b, a, distance, action);
  } else {
    const auto p = form::inflated(a);
    const auto q = form::inflated(b);
    const exact::Length reach =
        exact::from_double(p.radius) + exact::from_double(q.radius) + exact::from_double(distance);
    return action(exact::form(p.core), exact::form(q.core), reach);
  }
}

/// Are they at most `distance` apart? It may be negative, except that -distance may exceed the radius of a core only if
/// the core is a point or the other shape is no ellipse.
template <class A, class B>
constexpr bool exactly_within(const A& a, const B& b, double distance) noexcept {
  return with_cores(a, b, distance, [](const auto& p, const auto& q, const exact::Length& reach) {
    return exact::within(p, q, reach);
  });
}

template <class A, form::Inflated B>
constexpr int contact(const A& a, const B& b, Common common) noexcept {
  return with_cores(a, b, 0, [common](const auto& p, const auto& q, const exact::Length& reach) {
    return exact::contact(p, q, reach, common);
  });
}

/// 1 if the shapes are at most `distance` apart, 0 if not, -1 if that is not certain. By the distance of nearest(),
/// which is right to 4u of the scale; 16u are taken. At distance 0, 1 stands for insides that meet.
template <class B>
VESICA_COLD std::int32_t estimate_within(const Ellipse<double>& a, const B& b, double distance) noexcept {
  if (check(a) != 0 || check(b) != 0 || !(a.a > 0 && a.b > 0)) return -1;
  const auto core = form::inflated(b).core;
  const auto cores = filter::in_masks(
      filter::box_ellipse(filter::box(core), a, filter::offset(filter::place(core), filter::place(a))));
  if (cores.overlap) return 1;
  if (!cores.disjoint) return -1;
  const nearest::ClosestCores c = nearest::closest_cores(a, b);
  const double gap = nearest::scaled_distance(c.distance - c.radii, c.exponent) - distance;
  const double error = 0x1p-49 * (arithmetic::scale_far(c.size, c.exponent) + std::fabs(distance));
  return gap < -error ? 1 : gap > error ? 0 : -1;
}
/// Other pairs go from the filter to exact arithmetic.
template <class A, class B>
constexpr std::int32_t estimate_within(const A& a, const B& b, double distance) noexcept {
  if constexpr (is_ellipse<B>) {
    return estimate_within(b, a, distance);
  } else {
    return -1;
  }
}

}  // namespace vesica::detail::overlap
