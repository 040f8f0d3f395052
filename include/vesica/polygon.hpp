// SPDX-License-Identifier: Apache-2.0
/// Polygons and polylines: shapes of any number of vertices, which stay in the caller's memory.
///
/// They are no kinds of each_shape.hpp, whose shapes are a fixed row of numbers. A polygon's answer comes from the
/// answers for its edges, which are segments, and from whether a point is inside (polygon/). So each question has one
/// loop for all other shapes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vesica/shapes.hpp>

namespace vesica {

/// The points on an edge, and those around which the rings cross an odd number of times. Ring j has the vertices
/// rings[j] to rings[j + 1] - 1, and its last vertex is joined to its first. Rings need no order and no orientation;
/// the first vertex may be repeated at the end. A ring of one vertex is a point, one of two a segment.
template <class T>
struct Polygon {
  const T *x, *y;             // of vertex 0
  std::ptrdiff_t stride;      // bytes from a vertex to the next
  const std::int32_t* rings;  // offsets, one more than rings; null: one ring
  std::int64_t count;         // rings; vertices if rings is null
};

/// The points on an edge of chains, which are rings that are not closed. It has no area.
template <class T>
struct Polyline {
  const T *x, *y;
  std::ptrdiff_t stride;
  const std::int32_t* rings;
  std::int64_t count;
};

/// Their kinds follow those of the list.
inline constexpr std::int32_t polygon_kind = kind_count, polyline_kind = kind_count + 1, all_kinds = kind_count + 2;

template <class Shape>
inline constexpr bool is_path = false;
template <class T>
inline constexpr bool is_path<Polygon<T>> = true;
template <class T>
inline constexpr bool is_path<Polyline<T>> = true;

/// Polygons and polylines.
template <class Shape>
concept Path = is_path<Shape>;

}  // namespace vesica
