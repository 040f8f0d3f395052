// SPDX-License-Identifier: Apache-2.0
/// overlap() of polygons and polylines: does an edge meet the other shape, or is one inside the other? Exact, since
/// segments' overlap and the side of a point are.
#pragma once

#include <vesica/polygon/inside.hpp>
#include <vesica/polygon/other.hpp>

namespace vesica {

namespace detail::polygon {

/// A path and another shape, both valid; box holds the path.
template <class T, class Other>
bool overlap_valid(const Edges<T>& a, const Box& box, const Other& b) noexcept {
  const Box about = box_about(b);
  if (!meet(box, about)) return false;
  const bool met = a.for_edges([&](const Edge& e, std::int64_t) { return meet(box_of(e), about) && edge_meets(e, b); });
  return met || inside(a, stored_point(b));
}

/// Keeps pairs of edges that may meet.
struct AnyMeet {
  bool keeps(const Box& a, const Box& b) const noexcept { return meet(a, b); }
  bool visit(const Edge& e, std::int64_t, const Edge& f, std::int64_t) const noexcept { return vesica::overlap(e, f); }
};

template <class T>
bool overlap_valid(const Edges<T>& a, const Box& box_a, const Edges<T>& b, const Box& box_b) noexcept {
  if (!meet(box_a, box_b)) return false;
  return walk(a, box_a, b, box_b, AnyMeet{}) || holds_ring(a, box_a, b) || holds_ring(b, box_b, a);
}

template <class T, class Other>
std::int32_t overlap_or_error(const Edges<T>& a, const Other& b) noexcept {
  Box box;
  if (a.check(box) != 0 || check_other(b) != 0) return error_shape;
  return overlap_valid(a, box, b) ? 1 : 0;
}
template <class T>
std::int32_t overlap_or_error(const Edges<T>& a, const Edges<T>& b) noexcept {
  Box box_a, box_b;
  if (a.check(box_a) != 0 || b.check(box_b) != 0) return error_shape;
  return overlap_valid(a, box_a, b, box_b) ? 1 : 0;
}

}  // namespace detail::polygon

/// The checked form with a polygon or a polyline, in either order: 1, 0 or error_shape.
template <template <class> class A, template <class> class B, class T>
requires Path<A<T>> || Path<B<T>> std::int32_t overlap_or_error(const A<T>& a, const B<T>& b)
noexcept {
  using namespace detail::polygon;
  if constexpr (!Path<A<T>>) {
    return vesica::overlap_or_error(b, a);
  } else if constexpr (Path<B<T>>) {
    return detail::polygon::overlap_or_error(Edges(a), Edges(b));
  } else {
    return detail::polygon::overlap_or_error(Edges(a), widen(b));
  }
}

/// True if they share a point; touching counts. For valid shapes.
template <template <class> class A, template <class> class B, class T>
requires Path<A<T>> || Path<B<T>>
bool overlap(const A<T>& a, const B<T>& b) noexcept { return vesica::overlap_or_error(a, b) == 1; }

}  // namespace vesica
