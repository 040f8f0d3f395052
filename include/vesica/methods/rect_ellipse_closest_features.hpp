// SPDX-License-Identifier: Apache-2.0
/// Rectangle against ellipse by closest features.
///
/// Idea: the lines through the edges cut the plane into nine regions. With the ellipse's centre in the middle one they
/// overlap; beside an edge only that edge and its ends can be met first, off a corner only two edges and three
/// vertices. Source: David Eberly, "Intersection of Rectangle and Ellipse" (2015), section 3.
/// Wrong in print: the comparisons that select the region stand the wrong way round, the second sign of a vertex is
/// made from a bit worth 2 as if it were worth 1 (3 where 1 is meant), and of three vertices also the two that no edge
/// joins are tried as an edge. Differs: the signs of the region name vertices and edges themselves, so there is no
/// table of cases; no division (rect_ellipse_metric.hpp).
/// Cost: a point, 3 vertices and 2 edges; about 25 ns. May err within a few roundings of contact.
/// An ellipse of half length 0, or so small (about 2^-176 of the largest length, float 2^-22) that squares underflow,
/// is left to the exact overlap().
#pragma once

#include <vesica/methods/rect_ellipse_metric.hpp>

namespace vesica::methods {

/// 1 when they overlap, 0 when not, error_shape when either is invalid.
template <class T>
std::int32_t closest_features(const Rect<T>& rect, const Ellipse<T>& ellipse) noexcept {
  if (check(rect) != 0 || check(ellipse) != 0) return error_shape;
  const auto m = detail::metric(rect, ellipse);
  if (!m.usable) return overlap_or_error(rect, ellipse);
  // The region: which of the two edges nearer to the centre it can see. The vertices between and beside them are the
  // region's three, or with one edge its two and another, which does no harm.
  const T sx = std::copysign(T{1}, m.k0), sy = std::copysign(T{1}, m.k1);
  const bool sees_side = std::fabs(m.k0) > m.e0, sees_long = std::fabs(m.k1) > m.e1;
  bool meets = !lane::either(sees_side, sees_long);
  meets |= detail::vertex_in_disc(m, sx, sy);
  meets |= lane::either(detail::vertex_in_disc(m, sx, -sy), detail::vertex_in_disc(m, -sx, sy));
  meets |= lane::both(sees_side, detail::side_edge_meets(m, sx));
  meets |= lane::both(sees_long, detail::long_edge_meets(m, sy));
  return meets ? 1 : 0;
}

}  // namespace vesica::methods
