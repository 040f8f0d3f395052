// SPDX-License-Identifier: Apache-2.0
/// crossings(a, b): the places where the outlines of two shapes meet, touching included.
///
/// The outline of a shape with area is the curve around it; a segment, a point, and a shape without area are their own
/// outlines. How many places there are is decided by exact signs: a place where outlines touch counts once, whatever
/// the order of contact. A stretch that edges share, or arcs about one corner, counts as its two end points, and sets
/// `shared`; so equal boxes meet at their corners, and equal capsules where their edges begin and end. Equal circles
/// and ellipses meet everywhere: no places, and `shared` is set.
///
/// Places come in order along a's outline: counter-clockwise (in the frame of the stored axis) from the corner -hx u -
/// hy perp u of a box, from the end of the axis +u of an ellipse (+x of a circle); from a segment's first end. With a
/// radius the outline begins with the edge from that corner or end, moved out: of a capsule, the edge to the right of
/// its segment. A capsule or rounded rectangle that is a circle begins as that, one without a radius as its core. A
/// place exactly there is the first. Places closer than the accuracy may be in either order, or be equal. The same
/// holds for places of two ellipses within 2^-95 of a turn of each other on the smaller one, as can happen with needles
/// of aspects beyond 2^90.
///
/// Accuracy: within 4u of the greatest coordinate and size of either shape, u = 2^-53, of a true place, and so of both
/// outlines, however closely these touch, osculate or coincide; each true place is found once. Exchanging the shapes
/// gives the same places, to the bit, in the other order.
#pragma once

#include <algorithm>
#include <optional>
#include <vesica/crossings/box_box.hpp>
#include <vesica/crossings/box_ellipse.hpp>
#include <vesica/crossings/ellipse_ellipse.hpp>
#include <vesica/crossings/inflated.hpp>
#include <vesica/crossings/inflated_ellipse.hpp>
#include <vesica/overlap.hpp>
#include <vesica/shape_area.hpp>

namespace vesica {

namespace detail::crossings {

template <class Shape>
inline constexpr bool is_round = ShapeTraits<Shape>::kind == Kind::circle || ShapeTraits<Shape>::kind == Kind::ellipse;

/// True if a's numbers are the later ones of two shapes of one kind.
template <class Shape>
bool is_later(const Shape& a, const Shape& b) noexcept {
  return with_numbers(a, [&](auto... x) {
    return with_numbers(b, [&](auto... y) {
      const double first[] = {x...}, second[] = {y...};
      return std::lexicographical_compare(second, second + sizeof...(y), first, first + sizeof...(x));
    });
  });
}

/// True if places are searched along a's outline: along the smaller shape's, in either order of the arguments.
template <class A, class B>
bool is_first(const A& a, const B& b) noexcept {
  const auto area_a = detail::area::shape_measure(a), area_b = detail::area::shape_measure(b);
  if (detail::area::less(area_a, area_b)) return true;
  if (detail::area::less(area_b, area_a)) return false;
  if constexpr (ShapeTraits<A>::kind != ShapeTraits<B>::kind) {
    return ShapeTraits<A>::kind < ShapeTraits<B>::kind;
  } else {
    return is_later(b, a);
  }
}

/// A box and any shape, or two ellipses; a round shape without area is a box. The answer is in order along a.
template <class A, class B>
CrossingPoints<double> between(const A& a, const B& b) noexcept {
  const auto form_a = exact::form(a);
  const auto form_b = exact::form(b);
  if constexpr (!is_round<A> && !is_round<B>) {
    return crossings(form_a, form_b).in_order(false);
  } else if constexpr (!is_round<A>) {
    if (exact::degenerate(form_b)) return crossings(form_a, exact::as_box(form_b)).in_order(false);
    return crossings(form_a, form_b).in_order(false);
  } else if constexpr (!is_round<B>) {
    if (exact::degenerate(form_a)) return crossings(exact::as_box(form_a), form_b).in_order(false);
    return crossings(form_b, form_a).in_order(true);
  } else {
    if (exact::degenerate(form_a) && exact::degenerate(form_b)) {
      return crossings(exact::as_box(form_a), exact::as_box(form_b)).in_order(false);
    }
    if (exact::degenerate(form_a)) return crossings(exact::as_box(form_a), form_b).in_order(false);
    if (exact::degenerate(form_b)) return crossings(exact::as_box(form_b), form_a).in_order(true);
    if (is_first(a, b)) return places(form_a, StoredOutline(a), form_b).in_order(false);
    return places(form_b, StoredOutline(b), form_a).in_order(true);
  }
}

// Not inlined: an ellipse with an area needs no second outline.
template <form::Inflated B>
VESICA_COLD Found with_flat_ellipse(const exact::Ellipse& a, const B& b) noexcept {
  return crossings(RoundOutline(exact::as_box(a), {}), round_outline(b));
}
template <form::Inflated B>
VESICA_CALLED Found with_wide_ellipse(const exact::Ellipse& a, const B& b) noexcept {
  return crossings(round_outline(b), a);
}
/// An ellipse and a core with a radius.
template <form::Inflated B>
CrossingPoints<double> with_ellipse(const Ellipse<double>& a, const B& b, bool along_ellipse) noexcept {
  const exact::Ellipse e = exact::form(a);
  const bool is_flat = exact::degenerate(e);
  Found found = is_flat ? with_flat_ellipse(e, b) : with_wide_ellipse(e, b);
  return found.in_order(along_ellipse != is_flat);
}

/// With a core and a radius. Kinds that need no radius are asked instead. Both orders of the shapes search in the same.
template <class A, class B>
requires(form::Inflated<A> || form::Inflated<B>) CrossingPoints<double> between(const A& a, const B& b)
noexcept {
  return form::with_simplest(a, [&](const auto& p) {
    return form::with_simplest(b, [&](const auto& q) {
      if constexpr (!std::is_same_v<decltype(p), const A&> || !std::is_same_v<decltype(q), const B&>) {
        return between(p, q);
      } else if constexpr (ShapeTraits<A>::kind == Kind::ellipse) {
        return with_ellipse(a, b, true);
      } else if constexpr (ShapeTraits<B>::kind == Kind::ellipse) {
        return with_ellipse(b, a, false);
      } else {
        bool reversed = !vesica::detail::in_order<A, B>;
        if constexpr (std::is_same_v<A, B>) reversed = is_later(a, b);
        return reversed ? crossings(round_outline(b), round_outline(a)).in_order(true)
                        : crossings(round_outline(a), round_outline(b)).in_order(false);
      }
    });
  });
}

/// One place where outlines meet, the same in either order of the shapes. Returns false if there is none, and writes
/// nothing then. `known`: how two ellipses meet, where that is known; there may be more places than it says.
template <class A, class B>
VESICA_COLD bool one_place(const A& a, const B& b, double& x, double& y,
                           const std::optional<Census>& known = std::nullopt) noexcept {
  if constexpr (is_round<A> && is_round<B>) {
    const exact::Ellipse form_a = exact::form(a), form_b = exact::form(b);
    if (!exact::degenerate(form_a) && !exact::degenerate(form_b)) {
      return is_first(a, b) ? any_place(form_a, StoredOutline(a), form_b, x, y, known)
                            : any_place(form_b, StoredOutline(b), form_a, x, y, known);
    }
  }
  const CrossingPoints<double> met = between(a, b);
  if (met.count == 0) return false;
  int first = 0;
  for (int i = 1; i < met.count; ++i) {
    const bool level = met.x[i] == met.x[first];
    if (level ? met.y[i] < met.y[first] : met.x[i] < met.x[first]) first = i;
  }
  x = met.x[first];
  y = met.y[first];
  return true;
}

/// Pairs that the filter leaves undecided need no exact answer here: if they are disjoint, no places will be found.
template <class A, class B>
filter::Verdict<bool> overlap_filter(const A& a, const B& b) noexcept {
  if constexpr (vesica::detail::in_order<A, B>) {
    return vesica::detail::overlap::filter(a, b);
  } else {
    return vesica::detail::overlap::filter(b, a);
  }
}

template <class T>
std::int32_t store(const CrossingPoints<double>& found, CrossingPoints<T>& out) noexcept {
  CrossingPoints<T> points{found.count, found.shared, {}, {}};
  for (int i = 0; i < found.count; ++i) {
    points.x[i] = static_cast<T>(found.x[i]);
    points.y[i] = static_cast<T>(found.y[i]);
    if (!vesica::detail::all_finite(points.x[i], points.y[i])) return error_range;
  }
  out = points;
  return found.count;
}

}  // namespace detail::crossings

/// The number of places where two outlines meet, up to 12, with the places in `out`; shapes of any kinds, in either
/// order.
/// Errors: error_shape, error_range (a place is beyond the finite numbers); on error `out` is untouched. Floats are the
/// double places, rounded.
template <template <class> class A, template <class> class B, class T>
std::int32_t crossings_or_error(const A<T>& a, const B<T>& b, CrossingPoints<T>& out) noexcept {
  const auto verdict = detail::crossings::overlap_filter(widen(a), widen(b));
  if (!verdict.overlap && !verdict.disjoint && (check(a) != 0 || check(b) != 0)) return error_shape;
  return detail::crossings::store(
      verdict.disjoint ? CrossingPoints<double>{} : detail::crossings::between(widen(a), widen(b)), out);
}

/// The same as a value: none where there is an error.
template <template <class> class A, template <class> class B, class T>
CrossingPoints<T> crossings(const A<T>& a, const B<T>& b) noexcept {
  CrossingPoints<T> out{};
  crossings_or_error(a, b, out);
  return out;
}

}  // namespace vesica
