// SPDX-License-Identifier: Apache-2.0
/// de9im(a, b): the nine-intersection matrix of two shapes (DE-9IM). Exact for every valid input.
///
/// Inside and outline are as in relation.hpp: the outline of a segment is its two ends, an area's is the curve
/// around it; a point has none. The outside is the rest of the plane. Most of the matrix follows from the relation,
/// which is exact. The rest follows from exact signs: where the ends of a segment are, and whether straight outlines
/// share a stretch.
///
/// Laws, each tested: exchanging the shapes transposes the matrix; the relation follows from it.
#pragma once

#include <utility>
#include <vesica/de9im/area.hpp>
#include <vesica/relation.hpp>

namespace vesica {

namespace detail::de9im {

/// 0, 1 or 2; of valid shapes.
inline int dimension(const Point<double>&) noexcept { return 0; }
inline int dimension(const Segment<double>& s) noexcept { return s.x0 != s.x1 || s.y0 != s.y1 ? 1 : 0; }
inline int dimension(const Circle<double>& s) noexcept { return s.r > 0 ? 2 : 0; }
inline int dimension(const Aabb<double>& s) noexcept {
  return (s.min_x < s.max_x ? 1 : 0) + (s.min_y < s.max_y ? 1 : 0);
}
inline int dimension(const Rect<double>& s) noexcept { return (s.hx > 0 ? 1 : 0) + (s.hy > 0 ? 1 : 0); }
inline int dimension(const Ellipse<double>& s) noexcept { return (s.a > 0 ? 1 : 0) + (s.b > 0 ? 1 : 0); }
/// With a radius above 0.
template <form::Inflated Shape>
int dimension(const Shape&) noexcept {
  return 2;
}

template <class Shape>
inline constexpr bool is_round = ShapeTraits<Shape>::kind == Kind::circle || ShapeTraits<Shape>::kind == Kind::ellipse;

/// A straight shape, or a round one without area.
template <class Shape>
exact::Box straight_form(const Shape& s) noexcept {
  if constexpr (is_round<Shape>) {
    return exact::as_box(exact::form(s));
  } else {
    return exact::form(s);
  }
}

inline NineIntersections of_point(Relation r, int dimension_b) noexcept {
  const bool outside = r == Relation::disjoint, on_outline = r == Relation::inside_touch;
  const char rest = r == Relation::equal ? 'F' : dimension(dimension_b);
  const char outline = dimension_b == 0 ? 'F' : dimension(dimension_b - 1);
  return {{point_if(!outside && !on_outline), point_if(on_outline), point_if(outside), 'F', 'F', 'F', rest, outline,
           '2', 0}};
}

/// A segment and a shape that it does not meet, or that it equals, or whose inside holds it.
inline bool of_segment_by_relation(Relation r, int dimension_b, NineIntersections& out) noexcept {
  if (r == Relation::disjoint) {
    out = dimension_b == 1 ? NineIntersections{"FF1FF0102"} : NineIntersections{"FF1FF0212"};
    return true;
  }
  if (r == Relation::equal) out = {"1FFF0FFF2"};
  if (r == Relation::inside && dimension_b == 2) out = {"1FF0FF212"};
  return r == Relation::equal || (r == Relation::inside && dimension_b == 2);
}

template <class A, class B>
VESICA_CALLED NineIntersections of_segment(const A& a, const B& b, Relation r, int dimension_b) noexcept {
  NineIntersections m;
  if (of_segment_by_relation(r, dimension_b, m)) return m;
  if constexpr (form::Inflated<B>) {
    return of_segment_and_outline(straight_form(a), crossings::round_outline(b), r);
  } else {
    if (dimension_b == 1) return of_segments(straight_form(a), straight_form(b), r);
    if constexpr (is_round<B>) {
      return of_segment_and_ellipse(straight_form(a), exact::form(b), r);
    } else {
      return of_segment_and_box(straight_form(a), straight_form(b), r);
    }
  }
}

template <class A, class B>
NineIntersections of_areas(const A& a, const B& b, Relation r) noexcept {
  constexpr bool may_share = form::Inflated<A> || form::Inflated<B> || (!is_round<A> && !is_round<B>);
  if constexpr (!may_share) {
    return of_areas(r, '0');
  } else {
    const bool settled = r == Relation::disjoint || r == Relation::inside || r == Relation::contains;
    return of_areas(r, !settled && outlines_share_stretch(a, b) ? '1' : '0');
  }
}

/// The shape of the lower dimension comes first.
template <class A, class B>
VESICA_INLINE NineIntersections in_order_of_dimension(const A& a, const B& b, Relation r) noexcept {
  const int of_a = dimension(a), of_b = dimension(b);
  if (of_a == 0) return of_point(r, of_b);
  if constexpr (!form::Inflated<A>) {
    if (of_a == 1) return of_segment(a, b, r, of_b);
  }
  return of_areas(a, b, r);
}

template <class A, class B>
VESICA_INLINE NineIntersections by_relation(const A& a, const B& b, Relation r) noexcept {
  return dimension(a) <= dimension(b) ? in_order_of_dimension(a, b, r)
                                      : transposed(in_order_of_dimension(b, a, converse(r)));
}
/// With a core and a radius. Kinds that need no radius are asked instead.
template <class A, class B>
requires(form::Inflated<A> || form::Inflated<B>) NineIntersections by_relation(const A& a, const B& b, Relation r)
noexcept {
  return form::with_simplest(a, [&](const auto& p) {
    return form::with_simplest(b, [&](const auto& q) {
      if constexpr (std::is_same_v<decltype(p), const A&> && std::is_same_v<decltype(q), const B&>) {
        return dimension(a) <= dimension(b) ? in_order_of_dimension(a, b, r)
                                            : transposed(in_order_of_dimension(b, a, converse(r)));
      } else {
        return by_relation(p, q, r);
      }
    });
  });
}

/// de9im_or_error() for kinds in order.
template <class A, class B>
VESICA_INLINE std::int32_t de9im_in_order(const A& a, const B& b, NineIntersections& out) noexcept {
  const std::int32_t code = called_relation(a, b);
  if (code < 0) return code;
  out = by_relation(a, b, static_cast<Relation>(code));
  return 0;
}
/// The same as a call, but of a point, which is shorter than a call.
template <class A, class B>
VESICA_CALLED std::int32_t called_de9im(const A& a, const B& b, NineIntersections& out) noexcept {
  return de9im_in_order(a, b, out);
}
template <class B>
VESICA_INLINE std::int32_t called_de9im(const Point<double>& a, const B& b, NineIntersections& out) noexcept {
  return de9im_in_order(a, b, out);
}

}  // namespace detail::de9im

/// The checked form: writes the matrix of two shapes of any kinds, in either order. Returns 0, or error_shape, and then
/// `out` is untouched. A float is a double exactly.
template <template <class> class A, template <class> class B, class T>
VESICA_INLINE std::int32_t de9im_or_error(const A<T>& first, const B<T>& second, NineIntersections& out) noexcept {
  namespace nine = detail::de9im;
  if constexpr (!detail::in_order<A<T>, B<T>>) {
    const std::int32_t error = de9im_or_error(second, first, out);
    if (error == 0) out = nine::transposed(out);
    return error;
  } else {
    return nine::called_de9im(widen(first), widen(second), out);
  }
}

/// The matrix of two valid shapes of any kinds.
template <template <class> class A, template <class> class B, class T>
NineIntersections de9im(const A<T>& a, const B<T>& b) noexcept {
  NineIntersections out{};
  de9im_or_error(a, b, out);
  return out;
}

}  // namespace vesica
