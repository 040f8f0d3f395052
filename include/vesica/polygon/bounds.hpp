// SPDX-License-Identifier: Apache-2.0
/// bounds() of polygons and polylines: the box of their vertices, exactly.
#pragma once

#include <vesica/polygon/edges.hpp>

namespace vesica {

namespace detail::polygon {

template <class T>
int bounds(const Edges<T>& edges, Aabb<T>& out) noexcept {
  Box box;
  if (edges.check(box) != 0) return error_shape;
  out = {static_cast<T>(box.min_x), static_cast<T>(box.min_y), static_cast<T>(box.max_x), static_cast<T>(box.max_y)};
  return 0;
}

}  // namespace detail::polygon

/// Returns 0 or error_shape; on error `out` is untouched.
template <template <class> class Shape>
requires Path<Shape<double>>
int bounds(const Shape<double>& s, Aabb<double>& out) noexcept {
  return detail::polygon::bounds(detail::polygon::Edges(s), out);
}
template <template <class> class Shape>
requires Path<Shape<float>>
int bounds(const Shape<float>& s, Aabb<float>& out) noexcept {
  return detail::polygon::bounds(detail::polygon::Edges(s), out);
}

}  // namespace vesica
