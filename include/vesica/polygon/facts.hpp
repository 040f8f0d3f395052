// SPDX-License-Identifier: Apache-2.0
/// Facts about one polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
#pragma once

#include <vesica/polygon/convex.hpp>
#include <vesica/polygon/own_area.hpp>
#include <vesica/polygon/simple.hpp>

namespace vesica {

/// `convex` is what depth() requires; also 1 if all vertices are on one line. The area has the sign of `orientation`:
/// 1 if the inside is on the left of the first ring that is no point and no segment, -1 on the right, 0 without area.
/// The edges first_crossing and second_crossing begin at these vertices, and cross or overlap; -1 if none do.
template <class T>
struct PolygonFacts {
  std::int64_t vertices;  // but those equal to the one before on their ring
  std::int64_t first_crossing, second_crossing;
  T area;
  std::int32_t orientation, convex, simple, rings;  // rings with a vertex
};

namespace detail::polygon {

template <class T>
PolygonFacts<T> facts_of_valid(const Edges<T>& edges, const Box& box) noexcept {
  PolygonFacts<T> facts{};
  Outline<T> outline(edges, box);
  std::int64_t turning = -1;  // the first vertex of a ring that is no point and no segment
  for (std::int64_t j = 0; j < edges.rings(); ++j) {
    const Range ring = edges.ring(j);
    if (ring.length() == 0) continue;
    ++facts.rings;
    std::int64_t moves = 0;
    edges.for_edges(ring, [&](const Edge& e, std::int64_t) {
      moves += has_length(e) ? 1 : 0;
      return false;
    });
    facts.vertices += std::max<std::int64_t>(moves, 1);
    if (turning < 0 && outline.ring_dimension(ring.first) == 2) turning = ring.first;
  }
  const SelfCrossing<T> crossing(edges, box);
  facts.first_crossing = crossing.first;
  facts.second_crossing = crossing.second;
  facts.simple = crossing.first < 0 ? 1 : 0;
  facts.convex = convexity(edges).convex ? 1 : 0;
  facts.orientation = turning < 0 || is_flat(edges) ? 0 : outline.part_beside(turning, true) == inside_part ? 1 : -1;
  return facts;
}

}  // namespace detail::polygon

/// 0, error_null, error_shape or error_range (the area). Where edges cross, the area and the orientation mean nothing.
template <class T>
std::int32_t polygon_facts_or_error(const Polygon<T>& s, PolygonFacts<T>& out) noexcept {
  using namespace detail::polygon;
  const Edges<T> edges(s);
  Box box;
  if (edges.has_null()) return error_null;
  if (edges.check(box) != 0) return error_shape;
  Senses<T> senses(edges);
  T area;
  const std::int32_t error = detail::area::store(measure(edges, box, senses), area);
  if (error != 0) return error;
  out = facts_of_valid(edges, box);
  out.area = out.orientation < 0 ? -area : area;
  return 0;
}

}  // namespace vesica
