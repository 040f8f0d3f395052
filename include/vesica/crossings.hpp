// SPDX-License-Identifier: Apache-2.0
/// crossings(a, b): the places where the outlines of two shapes meet, touching included.
///
/// The outline of a shape with area is the curve around it; a segment, a point, and a shape without area are their own
/// outlines. The number of places is decided by exact signs. A place where outlines touch counts once, however high the
/// order of contact. If straight outlines have a stretch in common, its two end points count and `shared` is set; so
/// equal boxes give their corners. Equal curves have no single places: they give none, and `shared` is set.
///
/// Places come in order along a's outline: counter-clockwise (in the frame of the stored axis) from the corner
/// -hx u - hy perp u of a box, from the end of the axis +u of an ellipse (+x of a circle); from a segment's first end.
///
/// Accuracy: within 16u of the greatest coordinate and size met, of the place that the stored numbers have, for all
/// pairs but two ellipses. There that holds where outlines cross; where they nearly touch, or touch to order k, the
/// place is within 2^(-90/k) of the lesser ellipse's size, along both outlines; where they differ by a part e of it all
/// round, within 2^-90 / e.
#pragma once

#include <vesica/crossings/box_box.hpp>
#include <vesica/crossings/box_ellipse.hpp>
#include <vesica/crossings/ellipse_ellipse.hpp>
#include <vesica/overlap.hpp>
#include <vesica/shape_area.hpp>

namespace vesica {

namespace detail::crossings {

template <class Shape>
inline constexpr bool is_round = ShapeTraits<Shape>::kind == Kind::circle || ShapeTraits<Shape>::kind == Kind::ellipse;

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
    const Census census = detail::crossings::census(form_a, form_b);
    const bool a_is_less = !detail::area::less(detail::area::shape_measure(b), detail::area::shape_measure(a));
    return a_is_less ? places(a, b, census).in_order(false) : places(b, a, census).in_order(true);
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

/// The checked form: returns the number of places where two outlines meet, up to 8, and writes the places to `out`.
/// Shapes of any kinds, in either order. Errors: error_shape, error_range (a place is beyond the finite numbers); on
/// error `out` is untouched. Floats are the double places, rounded.
template <template <class> class A, template <class> class B, class T>
std::int32_t crossings_or_error(const A<T>& a, const B<T>& b, CrossingPoints<T>& out) noexcept {
  const std::int32_t meet = overlap_or_error(a, b);
  if (meet < 0) return meet;
  return detail::crossings::store(meet == 0 ? CrossingPoints<double>{} : detail::crossings::between(widen(a), widen(b)),
                                  out);
}

/// The places where two outlines meet. For valid shapes: there are none where crossings_or_error(), the checked form,
/// returns an error.
template <template <class> class A, template <class> class B, class T>
CrossingPoints<T> crossings(const A<T>& a, const B<T>& b) noexcept {
  CrossingPoints<T> out{};
  crossings_or_error(a, b, out);
  return out;
}

}  // namespace vesica
