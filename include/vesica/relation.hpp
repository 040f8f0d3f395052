// SPDX-License-Identifier: Apache-2.0
/// relation(a, b): which of eight ways do two shapes relate? contains(a, b): does a contain all of b? Exact for every
/// valid input, touching included.
///
/// Definition, for closed convex sets. The outline of a shape is its relative boundary: for a shape with area the curve
/// around it, for a segment (or a shape with one zero size) its two end points; a point (or a shape without any size)
/// has none. The inside is the rest of the shape: all but the ends of a segment; a point itself. The
/// relation is the first one that holds:
///   equal            each contains the other: the same set of points, whatever kinds and numbers describe it;
///   inside           b contains a, and a has no point of b's outline;
///   inside_touch     b contains a, and a has points of b's outline;
///   contains, contains_touch   the same with a and b exchanged;
///   cross            the insides have a common point: two segments that cross, or overlap in part along one line;
///   touch            they have one at all: a segment's end on another's middle, a segment beside a rectangle's side;
///   disjoint         they have none.
///
/// Laws, each tested: relation(b, a) is the converse of relation(a, b); contains(a, b) iff the relation is contains,
/// contains_touch or equal; overlap(a, b) iff it is not disjoint; contains is transitive; both are unchanged when both
/// shapes are mirrored, turned by quarter turns, or scaled by a power of two without leaving the format.
#pragma once

#include <vesica/overlap.hpp>
#include <vesica/relation/box_box.hpp>
#include <vesica/relation/box_ellipse.hpp>
#include <vesica/relation/comparison.hpp>
#include <vesica/relation/disc.hpp>
#include <vesica/relation/ellipse_ellipse.hpp>
#include <vesica/relation/inflated.hpp>

namespace vesica {

namespace detail {

/// Points and AABBs: comparisons are exact by themselves.
template <class Shape>
inline constexpr bool is_compared = ShapeTraits<Shape>::kind == Kind::point || ShapeTraits<Shape>::kind == Kind::aabb;

template <class A, class B>
inline constexpr bool are_points = ShapeTraits<A>::kind == Kind::point&& ShapeTraits<B>::kind == Kind::point;

/// Overlap decides a point on a segment quickly; comparisons then find the place on it.
template <class A, class B>
inline constexpr bool is_told_by_overlap = ShapeTraits<A>::kind == Kind::point&& ShapeTraits<B>::kind == Kind::segment;

/// The relation of a point to a segment that it is on.
constexpr Relation place_on(const Segment<double>& s, const Point<double>& p) noexcept {
  const bool at_start = p.x == s.x0 && p.y == s.y0, at_end = p.x == s.x1 && p.y == s.y1;
  if (at_start && at_end) return Relation::equal;
  return at_start || at_end ? Relation::inside_touch : Relation::inside;
}

/// For pairs in double, of kinds in order, that a filter left undecided.
template <class A, class B>
VESICA_COLD constexpr std::int32_t decide_relation(const A& a, const B& b) noexcept {
  if constexpr (is_told_by_overlap<A, B>) {
    const std::int32_t meets = decide_undecided(a, b, Common::any);
    return meets == 1 ? static_cast<std::int32_t>(place_on(b, a)) : meets;  // 0 is Relation::disjoint
  }
  if (check(a) != 0 || check(b) != 0) return error_shape;
  if constexpr (is_compared<A> && is_compared<B>) {
    return static_cast<std::int32_t>(
        detail::relation::aabb_aabb(detail::relation::as_aabb(a), detail::relation::as_aabb(b)));
  } else {
    return static_cast<std::int32_t>(exact::relate(exact::relation_form(a), exact::relation_form(b)));
  }
}

/// With a core and a radius.
template <class A, form::Inflated B>
VESICA_COLD constexpr std::int32_t decide_relation(const A& a, const B& b) noexcept {
  if (check(a) != 0 || check(b) != 0) return error_shape;
  return static_cast<std::int32_t>(exact::relate(exact::inflated_box(a), exact::inflated_box(b)));
}
template <form::Inflated B>
VESICA_COLD constexpr std::int32_t decide_relation(const Ellipse<double>& a, const B& b) noexcept {
  if (check(a) != 0 || check(b) != 0) return error_shape;
  return static_cast<std::int32_t>(exact::relate(exact::form(a), exact::inflated_box(b)));
}

template <template <class> class A, template <class> class B>
VESICA_COLD constexpr std::int32_t decide_relation(const A<float>& a, const B<float>& b) noexcept {
  return decide_relation(widen(a), widen(b));
}

/// The facts that the pair's filter is certain of about a and b, of kinds in either order.
template <class A, class B>
VESICA_INLINE constexpr auto certain_facts(const A& a, const B& b) noexcept {
  if constexpr (in_order<A, B>) {
    return detail::relation::certain_facts(widen(a), widen(b));
  } else {
    return detail::relation::certain_facts(widen(b), widen(a)).exchanged();
  }
}

}  // namespace detail

/// The checked form: the relation of a to b as a number of 0 to 7 (see Relation), error_shape when either is invalid,
/// as the C functions return. Any kinds, in either order.
template <template <class> class A, template <class> class B, class T>
VESICA_INLINE constexpr std::int32_t relation_or_error(const A<T>& a, const B<T>& b) noexcept {
  if constexpr (detail::are_points<A<T>, B<T>>) {
    const std::int32_t same = overlap_or_error(a, b);
    return same > 0 ? static_cast<std::int32_t>(Relation::equal) : same;
  } else {
    if (!std::is_constant_evaluated()) {
      const auto certain = filter::certain_relation(detail::certain_facts(a, b));
      // By arithmetic, without a jump, as in overlap. At most one of them is certain; -1 stands for none.
      const std::int32_t answer = std::int32_t{certain.disjoint} + 3 * std::int32_t{certain.cross} +
                                  4 * std::int32_t{certain.inside} + 6 * std::int32_t{certain.contains} - 1;
      if (answer >= 0) [[likely]]
        return answer;
    }
    if constexpr (detail::in_order<A<T>, B<T>>) {
      return detail::decide_relation(a, b);
    } else {
      const std::int32_t reversed = detail::decide_relation(b, a);
      return reversed < 0 ? reversed : static_cast<std::int32_t>(converse(static_cast<Relation>(reversed)));
    }
  }
}

namespace detail {

/// The same, not inlined: for functions that do much more.
template <class A, class B>
VESICA_CALLED std::int32_t called_relation(const A& a, const B& b) noexcept {
  return relation_or_error(a, b);
}

}  // namespace detail

/// The relation of a to b, shapes of any kinds. For valid shapes: an invalid one is disjoint from everything.
/// relation_or_error() is the checked form.
template <template <class> class A, template <class> class B, class T>
VESICA_INLINE constexpr Relation relation(const A<T>& a, const B<T>& b) noexcept {
  const std::int32_t answer = relation_or_error(a, b);
  return answer < 0 ? Relation::disjoint : static_cast<Relation>(answer);
}

/// The checked form: 1 when a contains all of b, 0 when not, error_shape when either is invalid.
template <template <class> class A, template <class> class B, class T>
VESICA_INLINE constexpr std::int32_t contains_or_error(const A<T>& a, const B<T>& b) noexcept {
  const std::int32_t relation = relation_or_error(a, b);
  return relation < 0 ? relation : std::int32_t{relation >= static_cast<std::int32_t>(Relation::contains)};
}

/// True if a contains all of b, shapes of any kinds. For valid shapes: an invalid one contains nothing and is contained
/// in nothing. contains_or_error() is the checked form.
template <template <class> class A, template <class> class B, class T>
VESICA_INLINE constexpr bool contains(const A<T>& a, const B<T>& b) noexcept {
  return contains_or_error(a, b) == 1;
}

}  // namespace vesica
