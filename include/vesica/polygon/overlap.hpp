// SPDX-License-Identifier: Apache-2.0
/// overlap() of polygons and polylines: does an edge meet the other shape, or is one inside the other? Exact, since
/// segments' overlap and the side of a point are.
#pragma once

#include <vesica/polygon/few_vertices.hpp>
#include <vesica/polygon/other.hpp>
#include <vesica/polygon/place.hpp>

namespace vesica {

namespace detail::polygon {

/// A vertex of b inside a, or -1: the first vertex of one of b's rings. If no edges meet, a ring lies inside as its
/// first vertex does.
template <class T>
std::int64_t vertex_inside(const Edges<T>& a, const Box& box_a, const Edges<T>& b) noexcept {
  if (!a.closed()) return -1;
  if (b.rings() == 1) {
    const std::int64_t first = b.ring(0).first;
    const Point<double> p = b.vertex(first);
    return meet(box_a, {p.x, p.y, p.x, p.y}) && inside(a, p) ? first : -1;
  }
  const Locator<T> locator(a);
  for (std::int64_t j = 0; j < b.rings(); ++j) {
    const Range ring = b.ring(j);
    if (ring.length() == 0) continue;
    const Point<double> p = b.vertex(ring.first);
    if (meet(box_a, {p.x, p.y, p.x, p.y}) && locator.is_odd(Stored{p})) return ring.first;
  }
  return -1;
}
template <class T>
bool holds_ring(const Edges<T>& a, const Box& box_a, const Edges<T>& b) noexcept {
  return vertex_inside(a, box_a, b) >= 0;
}

/// Is a stored point of one shape inside the other? If no edges meet, this decides whether the shapes overlap; if it
/// is found, it is a point of both in any case. `about` holds b.
template <class T, class Other>
bool point_inside(const Edges<T>& a, const Box& box, const Other& b, const Box& about, Point<double>& common) noexcept {
  if (!meet(box, about)) return false;
  common = stored_point(b);
  return inside(a, common);
}
template <class T>
bool point_inside(const Edges<T>& a, const Box& box_a, const Edges<T>& b, const Box& box_b,
                  Point<double>& common) noexcept {
  if (!meet(box_a, box_b)) return false;
  const std::int64_t of_b = vertex_inside(a, box_a, b), of_a = of_b < 0 ? vertex_inside(b, box_b, a) : -1;
  if (of_b >= 0) common = b.vertex(of_b);
  if (of_a >= 0) common = a.vertex(of_a);
  return of_a >= 0 || of_b >= 0;
}

/// A path and another shape, both valid; `about` holds the other.
template <class T, class Other>
bool overlap_valid(const Edges<T>& a, const Box& box, const Other& b, const Box& about) noexcept {
  if (!meet(box, about)) return false;
  const bool met = any_edge(
      a, [&](const Box& part) { return meet(part, about); },
      [&](const Edge& e, std::int64_t) { return edge_meets(e, b); });
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
  return any_pair(a, box_a, b, box_b, AnyMeet{}) || holds_ring(a, box_a, b) || holds_ring(b, box_b, a);
}

template <class T, class Other>
std::int32_t overlap_or_error(const Edges<T>& a, const Other& b) noexcept {
  Box box_a, box_b;
  if (!is_valid(a, box_a) || !is_valid(b, box_b)) return error_shape;
  return overlap_valid(a, box_a, b, box_b) ? 1 : 0;
}

}  // namespace detail::polygon

/// The checked form with a polygon or a polyline, in either order: 1, 0 or error_shape.
template <template <class> class A, template <class> class B, class T>
std::int32_t overlap_or_error(const A<T>& a, const B<T>& b) noexcept requires AnyPath<A<T>, B<T>> {
  const int overlap = detail::polygon::convex_overlap(a, b);
  if (overlap != filter::undecided) return overlap;
  return detail::polygon::with_edges(
      a, b, [](const auto& edges, const auto& other, bool) { return detail::polygon::overlap_or_error(edges, other); });
}

/// True if they share a point; touching counts. For valid shapes.
template <template <class> class A, template <class> class B, class T>
bool overlap(const A<T>& a, const B<T>& b) noexcept requires AnyPath<A<T>, B<T>> {
  return vesica::overlap_or_error(a, b) == 1;
}

}  // namespace vesica
