// SPDX-License-Identifier: Apache-2.0
/// overlap(a, b): do two shapes share a point? Touching counts. interiors_overlap(a, b): do their insides share one?
/// Touching does not count. Both are exact for every valid input.
///
/// The inside of a shape is the shape without its outline, as in relation.hpp. The outline of a segment is its two
/// ends; a point has none. So the insides of two segments that cross share a point, and of two equal points too.
/// The insides of a disc and of a point on its rim share none.
///
/// Three stages. The pair's filter evaluates the predicate in floating point with a bound on its error and answers
/// nearly always. What it leaves open, mostly contact, integers of 256 bits decide, unless an ellipse is among the two
/// or exponents are far apart. The rest is checked for validity and decided in exact arithmetic. There is no epsilon.
/// Both questions share all stages: a filter with a bound on its error finds only overlaps of insides, and the others
/// take the contact (contact.hpp) that counts as a parameter. Comparisons alone need a filter for each question.
///
/// Laws, each tested: overlap(a, b) == overlap(b, a); unchanged when both shapes are mirrored, turned by quarter turns,
/// or scaled by a power of two without leaving the format; overlap(a, a); a shape's bounds overlap whatever it
/// overlaps. The first three hold for interiors_overlap too; it implies overlap, and agrees with relation and de9im.
#pragma once

#include <vesica/check.hpp>
#include <vesica/contact.hpp>
#include <vesica/filter/by_integers.hpp>
#include <vesica/overlap/aabb_aabb.hpp>
#include <vesica/overlap/aabb_ellipse.hpp>
#include <vesica/overlap/aabb_rect.hpp>
#include <vesica/overlap/circle_aabb.hpp>
#include <vesica/overlap/circle_circle.hpp>
#include <vesica/overlap/circle_ellipse.hpp>
#include <vesica/overlap/circle_rect.hpp>
#include <vesica/overlap/ellipse_ellipse.hpp>
#include <vesica/overlap/inflated.hpp>
#include <vesica/overlap/point_aabb.hpp>
#include <vesica/overlap/point_circle.hpp>
#include <vesica/overlap/point_ellipse.hpp>
#include <vesica/overlap/point_point.hpp>
#include <vesica/overlap/point_rect.hpp>
#include <vesica/overlap/point_segment.hpp>
#include <vesica/overlap/rect_ellipse.hpp>
#include <vesica/overlap/rect_rect.hpp>
#include <vesica/overlap/segment_aabb.hpp>
#include <vesica/overlap/segment_circle.hpp>
#include <vesica/overlap/segment_ellipse.hpp>
#include <vesica/overlap/segment_rect.hpp>
#include <vesica/overlap/segment_segment.hpp>

namespace vesica {

namespace detail {

namespace overlap {
/// For HasTwoFilters to look up. Pairs that have two filters overload both names.
template <class A, class B>
filter::DecidedVerdict<bool> first_filter(const A&, const B&) = delete;
template <class A, class B>
filter::DecidedVerdict<bool> second_filter(const A&, const B&) = delete;

/// Pairs that comparisons decide have an insides_filter() of their own, unless they are points. Every other filter
/// finds an overlap only where the insides meet: its value is beyond its bound.
constexpr bool has_insides_filter(Kind a, Kind b) noexcept {
  return b == Kind::aabb && (a == Kind::point || a == Kind::aabb);
}
template <class A, class B>
constexpr bool has_insides_filter() noexcept {
  return has_insides_filter(ShapeTraits<A>::kind, ShapeTraits<B>::kind);
}

/// The filter of a question, for kinds in order.
template <Common common, class A, class B>
VESICA_INLINE constexpr auto filter_of(const A& a, const B& b) noexcept {
  if constexpr (common == Common::insides && has_insides_filter<A, B>()) {
    return insides_filter(a, b);
  } else {
    return filter(a, b);
  }
}

/// The exact stage of overlap().
template <class A, class B>
constexpr bool exact(const A& a, const B& b) noexcept {
  return contact(a, b, Common::any) <= 0;
}
}  // namespace overlap

/// 1, 0, or -1 for undecided. Computed by arithmetic, because a branch on the answer would be mispredicted.
template <class Mask>
VESICA_INLINE constexpr std::int32_t answer_of(const filter::Verdict<Mask>& verdict) noexcept {
  return 2 * static_cast<std::int32_t>(verdict.overlap) + static_cast<std::int32_t>(verdict.disjoint) - 1;
}

/// The branch is nearly always predicted.
VESICA_INLINE constexpr std::int32_t answer_of(const filter::DecidedVerdict<bool>& verdict) noexcept {
  return verdict.decided ? static_cast<std::int32_t>(verdict.overlap) : -1;
}

/// By the pair's filter, for kinds in order.
template <Common common = Common::any, class A, class B>
VESICA_INLINE constexpr std::int32_t decide_by_filter(const A& a, const B& b) noexcept {
  return answer_of(detail::overlap::filter_of<common>(a, b));
}

/// Pairs whose filter is two filters: a short one that decides most pairs, and a long one.
template <class A, class B>
concept HasTwoFilters = requires(const A& a, const B& b) {
  detail::overlap::first_filter(a, b);
};
/// By the short filter; other pairs have one filter.
template <class A, class B>
VESICA_INLINE constexpr std::int32_t decide_by_first_filter(const A& a, const B& b) noexcept {
  if constexpr (HasTwoFilters<A, B>) {
    return answer_of(detail::overlap::first_filter(a, b));
  } else {
    return decide_by_filter(a, b);
  }
}
template <class A, class B>
VESICA_INLINE constexpr std::int32_t decide_by_second_filter(const A& a, const B& b) noexcept {
  if constexpr (HasTwoFilters<A, B>) return answer_of(detail::overlap::second_filter(a, b));
  return -1;
}

/// The third stage. Invalid shapes get their error here.
template <class A, class B>
VESICA_COLD constexpr std::int32_t decide_exactly(const A& a, const B& b, Common common) noexcept {
  if (check(a) != 0 || check(b) != 0) return error_shape;
  return counts(detail::overlap::contact(a, b, common), common) ? 1 : 0;
}

/// For pairs in double that a filter left undecided.
template <class A, class B>
VESICA_CALLED constexpr std::int32_t decide_undecided(const A& a, const B& b, Common common) noexcept {
  if constexpr (filter::HasIntegers<A, B>) {
    if (!std::is_constant_evaluated()) {
      const std::int32_t answer = answer_of(filter::by_integers(a, b, common));
      if (answer >= 0) return answer;
    }
  }
  if constexpr (form::Inflated<B>) {
    if (!std::is_constant_evaluated()) {
      const std::int32_t answer = detail::overlap::estimate_within(a, b, 0);
      if (answer >= 0) return answer;
    }
  }
  return decide_exactly(a, b, common);
}
/// Floats are widened here, in the cold code, so that the hot code does not.
template <template <class> class A, template <class> class B>
VESICA_COLD constexpr std::int32_t decide_undecided(const A<float>& a, const B<float>& b, Common common) noexcept {
  return decide_undecided(widen(a), widen(b), common);
}

template <class A, class B>
inline constexpr bool in_order = ShapeTraits<A>::kind <= ShapeTraits<B>::kind;

/// Any kinds, in either order. A float is a double exactly, so one path serves both.
template <Common common, class A, class B>
VESICA_INLINE constexpr std::int32_t common_point_or_error(const A& a, const B& b) noexcept {
  if constexpr (!in_order<A, B>) {
    return common_point_or_error<common>(b, a);
  } else {
    if (std::is_constant_evaluated()) return decide_undecided(a, b, common);
    const std::int32_t answer = decide_by_filter<common>(widen(a), widen(b));
    if (answer >= 0) [[likely]]
      return answer;
    return decide_undecided(a, b, common);
  }
}

}  // namespace detail

/// The checked form: 1 when the shapes share a point, 0 when not, error_shape when either is invalid, as the C
/// functions return. Any kinds, in either order.
template <template <class> class A, template <class> class B, class T>
VESICA_INLINE constexpr std::int32_t overlap_or_error(const A<T>& a, const B<T>& b) noexcept {
  return detail::common_point_or_error<Common::any>(a, b);
}

/// True if two shapes of any kinds, in either order, share a point. For valid shapes: an invalid one overlaps nothing.
/// overlap_or_error() is the checked form.
template <template <class> class A, template <class> class B, class T>
VESICA_INLINE constexpr bool overlap(const A<T>& a, const B<T>& b) noexcept {
  return overlap_or_error(a, b) == 1;
}

/// The checked form: 1 when the insides share a point, 0 when not, error_shape when either shape is invalid.
template <template <class> class A, template <class> class B, class T>
VESICA_INLINE constexpr std::int32_t interiors_overlap_or_error(const A<T>& a, const B<T>& b) noexcept {
  return detail::common_point_or_error<Common::insides>(a, b);
}

/// True if the insides of two shapes of any kinds, in either order, share a point. For valid shapes, as overlap().
template <template <class> class A, template <class> class B, class T>
VESICA_INLINE constexpr bool interiors_overlap(const A<T>& a, const B<T>& b) noexcept {
  return interiors_overlap_or_error(a, b) == 1;
}

}  // namespace vesica
