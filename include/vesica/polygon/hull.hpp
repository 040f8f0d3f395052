// SPDX-License-Identifier: Apache-2.0
/// The convex hull of points, exact.
#pragma once

#include <algorithm>
#include <vesica/polygon/convex.hpp>

namespace vesica::detail::polygon {

/// Replaces n >= 1 finite points by the corners of their hull, counter-clockwise from the lowest of the leftmost, and
/// returns how many there are.
///
/// The points below the line from the first to the last in order of x are sorted to the right, those above it to the
/// left. One walk round them then drops each corner at which the outline does not turn left.
template <class T>
std::int64_t hull_in_place(Point<T>* p, std::int64_t n) noexcept {
  using P = Point<T>;
  const auto [least, most] = std::minmax_element(p, p + n, is_left_of<P>);
  const P first = *least, last = *most;
  const auto turns = [](const P& a, const P& b, const P& c) { return turn(widen(a), widen(b), widen(c)); };
  if (!is_left_of(first, last)) return 1;
  P* const below = std::partition(p, p + n, [&](const P& q) { return turns(first, last, q) < 0; });
  P* const above = std::partition(below, p + n, [&](const P& q) { return turns(first, last, q) <= 0; });
  std::sort(p, below, is_left_of<P>);
  std::sort(above, p + n, [](const P& a, const P& b) { return is_left_of(b, a); });
  // The points between hold the first and the last: there is room for both.
  std::move_backward(p, below, below + 1);
  p[0] = first;
  std::int64_t corners = 1;
  const auto drop = [&](const P& next, std::int64_t kept) {
    while (corners > kept && turns(p[corners - 2], p[corners - 1], next) <= 0) --corners;
  };
  const auto add = [&](const P& next) {
    drop(next, 1);
    p[corners++] = next;
  };
  for (const P* q = p + 1; q <= below; ++q) add(P(*q));
  add(last);
  for (const P* q = above; q < p + n; ++q) add(P(*q));
  drop(first, 2);
  return corners;
}

}  // namespace vesica::detail::polygon

namespace vesica {

/// Corners of the convex hull of a path's vertices, counter-clockwise where y points up, from the lowest of the
/// leftmost. None is on the line between its neighbours. Equal points give one corner, points on a line two.
///
/// Returns the number of corners, or error_null, error_rings, error_not_finite, or error_argument: `out` must have room
/// for all vertices.
template <class T>
std::int64_t convex_hull_or_error(const Polygon<T>& points, Point<T>* out, std::int64_t capacity) noexcept {
  const detail::polygon::Edges<T> edges(points);
  detail::polygon::Box box;
  if (const int error = edges.check(box); error != 0) return error;
  const detail::polygon::Range all = edges.all();
  if (capacity < all.length()) return error_argument;
  for (std::int64_t i = all.first; i < all.last; ++i) {
    const Point<double> v = edges.vertex(i);
    out[i - all.first] = {static_cast<T>(v.x), static_cast<T>(v.y)};
  }
  return detail::polygon::hull_in_place(out, all.length());
}

}  // namespace vesica
