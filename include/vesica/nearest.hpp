// SPDX-License-Identifier: Apache-2.0
/// nearest(a, b): how far apart are two solid shapes, and which points of them are closest?
///
/// Disjoint shapes have a distance > 0 and two closest points. These prove the answer: the line at right angles to
/// their connection, through its middle, separates the shapes. Shapes that share a point (touching counts) have
/// distance 0, and both closest points are one point of both. overlap() decides exactly which case it is. If several
/// pairs of points are equally close, the answer is one of them.
///
/// Accuracy, u = 2^-53, scale the largest coordinate of the offset of centres or half length: the distance is within 4u
/// scale at any aspect ratio (in tests always within 2u, beyond aspect 1e15 too); within a relative 2u if it is above
/// 1e-10 scale at aspects up to 1e6, above 1e-14 scale at aspects up to 1000; and never rounded to 0 where shapes are
/// disjoint. Each closest point is within 4u scale of its shape's outline, a common point within 8u scale of both
/// shapes, before the rounding of its coordinates. Points of capsules and rounded rectangles are rounded twice: the
/// core's point, and the sum with the radius.
///
/// Laws, each tested: nearest(b, a) has the same bits with the points exchanged; the distance is unchanged when both
/// shapes are moved alike without rounding, and is multiplied by a power of two when they are, unless a size or the
/// offset then comes across 2^-40, 2^40 or 2^50: between these a quicker way answers (nearest/lane_pairs.hpp), and may
/// round otherwise.
#pragma once

#include <limits>
#include <vesica/crossings.hpp>
#include <vesica/nearest/common_point.hpp>
#include <vesica/nearest/inflated.hpp>
#include <vesica/nearest/lane_pairs.hpp>
#include <vesica/overlap.hpp>

namespace vesica {

/// A distance and the points, one of each shape, that are that far apart; as the C structs, byte for byte.
template <class T>
struct ClosestPoints {
  T distance, ax, ay, bx, by;
};

namespace detail::nearest {

/// Any disjoint pair. steps: how many steps the search took, for tests.
template <class A, class B>
ClosestPoints<double> disjoint_points(const A& a, const B& b, int& steps) noexcept {
  const ScaledPair p = scaled_pair(a, b);
  const Closest c = closest(p, steps);
  const Located first = located(a, p.a, c.a, p.exponent), second = located(b, p.b, c.b, p.exponent);
  const Located on_a = located_beside(a, p.a, c.a, first, second), on_b = located_beside(b, p.b, c.b, second, first);
  const double distance = scaled_distance(c.distance, p.exponent);
  return {distance, on_a.x, on_a.y, on_b.x, on_b.y};
}

/// A point of both shapes of an overlapping pair.
template <class A, class B>
VESICA_COLD ClosestPoints<double> common_points(const A& a, const B& b) noexcept {
  const ScaledPair p = scaled_pair(a, b);
  const Located middle_a = located(a, p.a, middle_of_shape, p.exponent);
  const Located middle_b = located(b, p.b, middle_of_shape, p.exponent);
  const bool in_a = holds_other(p.a, p.b, p.d, p.size), in_b = holds_other(p.b, p.a, flipped(p.d, -1.0), p.size);
  Located common{0, 0};
  if (in_a && in_b) {
    const bool a_first = middle_a.x < middle_b.x || (middle_a.x == middle_b.x && middle_a.y < middle_b.y);
    common = a_first ? middle_a : middle_b;
  } else if (in_a || in_b) {
    common = in_a ? middle_b : middle_a;
  } else {
    // Neither shape contains the other then, so outlines meet; except for ellipses so thin that they are taken for
    // segments: then one may hold the other beside that segment.
    Common c = common_point(p);
    bool crossed = false;
    if (!is_certain(c, p)) {
      crossed = crossings::one_place(a, b, common.x, common.y);
      if (!crossed) c = closest_point(p);
    }
    if (!crossed) common = c.of_a ? located(a, p.a, c.contact, p.exponent) : located(b, p.b, c.contact, p.exponent);
  }
  // The sign of a zero must not depend on the order of the shapes.
  const double x = common.x + 0.0, y = common.y + 0.0;
  return {0, x, y, x, y};
}

template <class A, class B>
VESICA_COLD ClosestPoints<double> general_points(const A& a, const B& b, bool overlapping) noexcept {
  int steps = 0;
  return overlapping ? common_points(a, b) : disjoint_points(a, b, steps);
}

/// The core that batches run in vector lanes. Returns false if it does not reach its accuracy.
template <class A, class B>
VESICA_INLINE bool settled_points(const A& a, const B& b, bool overlapping, ClosestPoints<double>& out) noexcept {
  if constexpr (has_lanes<A, B>) {
    if (!moderate_pair(a, b)) return false;
    const LaneAnswer<double> lanes = lane_answer(a, b, overlapping);
    if (lanes.settled) out = {lanes.distance, lanes.ax, lanes.ay, lanes.bx, lanes.by};
    return lanes.settled;
  } else {
    return false;
  }
}

/// Rounds once. A distance that is not 0 stays so. Returns false where a number would exceed the finite ones.
template <class T>
VESICA_INLINE bool rounded_to(const ClosestPoints<double>& c, bool overlapping, ClosestPoints<T>& out) noexcept {
  ClosestPoints<T> r{static_cast<T>(c.distance), static_cast<T>(c.ax), static_cast<T>(c.ay), static_cast<T>(c.bx),
                     static_cast<T>(c.by)};
  if (!overlapping && !(r.distance > 0)) r.distance = std::numeric_limits<T>::denorm_min();
  // A distance that is not a number may have been replaced; whatever else is not finite still is not once rounded.
  if (!vesica::detail::all_finite(c.distance) || !vesica::detail::all_finite(r.distance, r.ax, r.ay, r.bx, r.by)) {
    return false;
  }
  out = r;
  return true;
}

/// The caller does not know whether the shapes overlap.
inline constexpr std::int32_t not_asked = -1;

/// nearest_or_error() for kinds in order; overlapping: 1, 0 or not_asked.
template <class A, class B>
VESICA_CALLED std::int32_t nearest_in_order(const A& a, const B& b, std::int32_t overlapping,
                                            ClosestPoints<double>& out) noexcept {
  // Often makes the exact predicate unnecessary. The core answers only for shapes of moderate numbers, which are valid;
  // otherwise the predicate is called after all.
  const bool apart = overlapping == not_asked && apart_along_offset(a, b);
  if (overlapping == not_asked) overlapping = apart ? 0 : overlap_or_error(a, b);
  if (overlapping < 0) return overlapping;
  ClosestPoints<double> found;
  if (!settled_points(a, b, overlapping == 1, found)) [[unlikely]] {
    if (apart) overlapping = overlap_or_error(a, b);
    if (overlapping < 0) return overlapping;
    found = general_points(a, b, overlapping == 1);
  }
  return rounded_to(found, overlapping == 1, out) ? 0 : error_range;
}

/// With a core and a radius (form/inflated.hpp): the closest points of the cores, moved by the radii.
template <class A, form::Inflated B>
VESICA_CALLED std::int32_t nearest_in_order(const A& a, const B& b, std::int32_t overlapping,
                                            ClosestPoints<double>& out) noexcept {
  if (overlapping == not_asked) overlapping = overlap_or_error(a, b);
  if (overlapping < 0) return overlapping;
  ClosestPoints<double> found;
  if (overlapping == 1 && vesica::overlap(form::inflated(a).core, form::inflated(b).core)) {
    found = common_points(form::inflated(a).core, form::inflated(b).core);
  } else {
    const ClosestCores c = closest_cores(a, b);
    if (overlapping == 1) {
      const Located common = c.common();
      found = {0, common.x, common.y, common.x, common.y};
    } else {
      const Located on_a = c.from_a(c.radius_a), on_b = c.from_b(c.radius_b);
      found = {scaled_distance(c.distance - c.radii, c.exponent), on_a.x, on_a.y, on_b.x, on_b.y};
    }
  }
  return rounded_to(found, overlapping == 1, out) ? 0 : error_range;
}

}  // namespace detail::nearest

/// The checked form: writes the distance of two shapes of any kinds, in either order, and their closest points. Returns
/// 0, error_shape when either is invalid, or error_range when a number would exceed the largest finite one; on error
/// `out` is untouched.
template <template <class> class A, template <class> class B>
std::int32_t nearest_or_error(const A<double>& a, const B<double>& b, ClosestPoints<double>& out) noexcept {
  if constexpr (!detail::in_order<A<double>, B<double>>) {
    ClosestPoints<double> found;
    const std::int32_t error = nearest_or_error(b, a, found);
    if (error == 0) out = {found.distance, found.bx, found.by, found.ax, found.ay};
    return error;
  } else {
    return detail::nearest::nearest_in_order(a, b, detail::nearest::not_asked, out);
  }
}

template <template <class> class A, template <class> class B>
std::int32_t nearest_or_error(const A<float>& a, const B<float>& b, ClosestPoints<float>& out) noexcept {
  ClosestPoints<double> wide;
  const std::int32_t error = nearest_or_error(widen(a), widen(b), wide);
  if (error != 0) return error;
  return detail::nearest::rounded_to(wide, wide.distance == 0, out) ? 0 : error_range;
}

/// The distance of two shapes and their closest points. For valid shapes: all numbers are NaN where nearest_or_error(),
/// the checked form, returns an error.
template <template <class> class A, template <class> class B, class T>
ClosestPoints<T> nearest(const A<T>& a, const B<T>& b) noexcept {
  constexpr T none = std::numeric_limits<T>::quiet_NaN();
  ClosestPoints<T> found{none, none, none, none, none};
  nearest_or_error(a, b, found);
  return found;
}

}  // namespace vesica
