// SPDX-License-Identifier: Apache-2.0
/// Rectangle against ellipse by all features.
///
/// Idea: the shapes overlap iff a vertex of the rectangle is in the ellipse, or an edge meets the ellipse, or the
/// ellipse, missing the outline, lies inside, and then its centre does. Source: David Eberly, "Intersection of
/// Rectangle and Ellipse" (2015), section 2.
/// Wrong in print: the loop over the vertices picks axes and extents by its counters, where the first and the second
/// are meant: two of its points are no vertices, the other two are the same vertex (21% of random pairs misjudged).
/// Differs: the four vertices of the signs (-1, -1) ... (1, 1); the discriminant in the form that does not cancel; no
/// division (rect_ellipse_metric.hpp).
/// Cost: 4 vertices, 4 edges and a point, all always: a jump on fresh data costs more than it saves. About 25 ns. May
/// err within a few roundings of contact. An ellipse of half length 0, or so small (about 2^-176 of the largest length,
/// float 2^-22) that squares underflow, is left to the exact overlap().
#pragma once

#include <vesica/methods/rect_ellipse_metric.hpp>

namespace vesica::methods {

/// 1 when they overlap, 0 when not, error_shape when either is invalid.
template <class T>
std::int32_t all_features(const Rect<T>& rect, const Ellipse<T>& ellipse) noexcept {
  if (check(rect) != 0 || check(ellipse) != 0) return error_shape;
  const auto m = detail::metric(rect, ellipse);
  if (!m.usable) return overlap_or_error(rect, ellipse);
  bool meets = lane::both(std::fabs(m.k0) <= m.e0, std::fabs(m.k1) <= m.e1);
  for (T s = -1; s <= 1; s += 2) {
    meets |= lane::either(detail::vertex_in_disc(m, s, T{-1}), detail::vertex_in_disc(m, s, T{1}));
    meets |= lane::either(detail::side_edge_meets(m, s), detail::long_edge_meets(m, s));
  }
  return meets ? 1 : 0;
}

}  // namespace vesica::methods
