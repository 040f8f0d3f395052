// SPDX-License-Identifier: Apache-2.0
/// relation(), contains() and interiors_overlap() with polygons and polylines. Exact.
///
/// The inside of a polygon is what its edges enclose, and its outline is its edges. A polygon whose vertices are on one
/// line is a segment. A polyline has no area: its outline is the points where an odd number of its chains end.
/// Polygons must be simple: where edges cross or overlap, the answer is finite and unspecified.
#pragma once

#include <vesica/polygon/row_parts.hpp>

namespace vesica {

namespace detail::polygon {

/// The segment that a path is: a polygon of one ring, all of whose vertices are on one line; a polyline of one point.
template <class T>
std::optional<Edge> flat(const Edges<T>& path) noexcept {
  Range ring{0, 0};
  for (std::int64_t j = 0; j < path.rings(); ++j) {
    if (path.ring(j).length() == 0) continue;
    if (ring.length() > 0) return {};
    ring = path.ring(j);
  }
  Point<double> low = path.vertex(ring.first), high = low;
  for (std::int64_t i = ring.first; i < ring.last; ++i) {
    const Point<double> p = path.vertex(i);
    if (same(p, low) || same(p, high)) continue;
    if (!path.closed()) return {};
    if (!same(low, high) && side(p.x, p.y, {low.x, low.y, high.x, high.y}) != 0) return {};
    if (p.x != low.x ? p.x < low.x : p.y < low.y) low = p;
    if (p.x != high.x ? p.x > high.x : p.y > high.y) high = p;
  }
  return Edge{low.x, low.y, high.x, high.y};
}

/// For valid shapes.
template <class T, class Row>
Relation relation_valid(const Edges<T>& a, const Box& box, const Row& b) noexcept {
  if (!meet(box, box_about(b))) return Relation::disjoint;
  if (const auto segment = flat(a)) return edge_relation(*segment, b);
  return RowParts<T, Row>(a, box, b, Asked::relation).find().relation();
}
template <class T>
Relation relation_valid(const Edges<T>& a, const Box& box_a, const Edges<T>& b, const Box& box_b) noexcept {
  if (!meet(box_a, box_b)) return Relation::disjoint;
  if (const auto segment = flat(b)) return relation_valid(a, box_a, *segment);
  if (const auto segment = flat(a)) return converse(relation_valid(b, box_b, *segment));
  return PathParts<T>(a, box_a, b, box_b, Asked::relation).find().relation();
}

template <class T, class Row>
bool insides_meet_valid(const Edges<T>& a, const Box& box, const Row& b) noexcept {
  if (!meet(box, box_about(b))) return false;
  if (const auto segment = flat(a)) return edge_insides_meet(*segment, b);
  return RowParts<T, Row>(a, box, b, Asked::insides).find().insides_meet();
}
template <class T>
bool insides_meet_valid(const Edges<T>& a, const Box& box_a, const Edges<T>& b, const Box& box_b) noexcept {
  if (!meet(box_a, box_b)) return false;
  if (const auto segment = flat(b)) return insides_meet_valid(a, box_a, *segment);
  if (const auto segment = flat(a)) return insides_meet_valid(b, box_b, *segment);
  return PathParts<T>(a, box_a, b, box_b, Asked::insides).find().insides_meet();
}

/// action(boxes...) for valid shapes, else error_shape.
template <class T, class Row, class Action>
std::int32_t if_valid(const Edges<T>& a, const Row& b, Action action) noexcept {
  Box box_a;
  if (a.check(box_a) != 0) return error_shape;
  if constexpr (std::is_same_v<Row, Edges<T>>) {
    Box box_b;
    return b.check(box_b) != 0 ? static_cast<std::int32_t>(error_shape) : action(a, box_a, b, box_b);
  } else {
    return check_other(b) != 0 ? static_cast<std::int32_t>(error_shape) : action(a, box_a, b);
  }
}

template <class T, class Other>
std::int32_t relation_or_error(const Edges<T>& a, const Other& b) noexcept {
  return if_valid(a, b, [](const auto&... s) { return static_cast<std::int32_t>(relation_valid(s...)); });
}
template <class T, class Other>
std::int32_t interiors_overlap_or_error(const Edges<T>& a, const Other& b) noexcept {
  return if_valid(a, b, [](const auto&... s) { return insides_meet_valid(s...) ? 1 : 0; });
}

}  // namespace detail::polygon

/// The checked form with a polygon or a polyline, in either order: a Relation, or error_shape.
template <template <class> class A, template <class> class B, class T>
requires Path<A<T>> || Path<B<T>> std::int32_t relation_or_error(const A<T>& a, const B<T>& b)
noexcept {
  using namespace detail::polygon;
  if constexpr (!Path<A<T>>) {
    const std::int32_t code = vesica::relation_or_error(b, a);
    return code < 0 ? code : static_cast<std::int32_t>(converse(static_cast<Relation>(code)));
  } else if constexpr (Path<B<T>>) {
    return detail::polygon::relation_or_error(Edges(a), Edges(b));
  } else {
    return detail::polygon::relation_or_error(Edges(a), widen(b));
  }
}

/// The relation of a to b. For valid shapes: an invalid one is disjoint from everything.
template <template <class> class A, template <class> class B, class T>
requires Path<A<T>> || Path<B<T>> Relation relation(const A<T>& a, const B<T>& b)
noexcept {
  const std::int32_t code = vesica::relation_or_error(a, b);
  return code < 0 ? Relation::disjoint : static_cast<Relation>(code);
}

/// True if a contains all of b. For valid shapes.
template <template <class> class A, template <class> class B, class T>
requires Path<A<T>> || Path<B<T>>
bool contains(const A<T>& a, const B<T>& b) noexcept { return vesica::relation(a, b) >= Relation::contains; }

/// The checked form with a polygon or a polyline, in either order: 1, 0 or error_shape.
template <template <class> class A, template <class> class B, class T>
requires Path<A<T>> || Path<B<T>> std::int32_t interiors_overlap_or_error(const A<T>& a, const B<T>& b)
noexcept {
  using namespace detail::polygon;
  if constexpr (!Path<A<T>>) {
    return vesica::interiors_overlap_or_error(b, a);
  } else if constexpr (Path<B<T>>) {
    return detail::polygon::interiors_overlap_or_error(Edges(a), Edges(b));
  } else {
    return detail::polygon::interiors_overlap_or_error(Edges(a), widen(b));
  }
}

/// True if the insides share a point. For valid shapes.
template <template <class> class A, template <class> class B, class T>
requires Path<A<T>> || Path<B<T>>
bool interiors_overlap(const A<T>& a, const B<T>& b) noexcept { return vesica::interiors_overlap_or_error(a, b) == 1; }

}  // namespace vesica
