// SPDX-License-Identifier: Apache-2.0
/// A filter for two convex polygons of three or four vertices: separating axes, all in registers.
#pragma once

#include <vesica/filter/convex_rings.hpp>
#include <vesica/polygon/edges.hpp>

namespace vesica::detail::polygon {

/// The vertices of a single ring without one that closes it, if they are three or four; else none.
template <class T>
VESICA_INLINE Range few_vertices(const Edges<T>& edges) noexcept {
  if (!edges.closed() || edges.rings() != 1 || edges.has_null()) return {0, 0};
  Range ring = edges.ring(0);
  if (ring.first < 0 || ring.length() < 3 || ring.length() > 5) return {0, 0};
  const Point<double> first = edges.vertex(ring.first), last = edges.vertex(ring.last - 1);
  if (ring.length() > 3 && first.x == last.x && first.y == last.y) --ring.last;
  return ring;
}

#if VESICA_HAS_TWO_DOUBLES
template <int n, class T>
VESICA_INLINE int convex_overlap(const Edges<T>& a, const Range& ring_a, const Edges<T>& b,
                                 const Range& ring_b) noexcept {
  using lane::TwoDoubles;
  const auto p = filter::numbers<n>([&](int i) { return a.vertex(ring_a.first + i); });
  const auto q = filter::numbers<n>([&](int i) { return b.vertex(ring_b.first + i); });
  return filter::convex_rings<n>({filter::numbers<n>([&](int i) { return TwoDoubles(p[i].x, q[i].x); }),
                                  filter::numbers<n>([&](int i) { return TwoDoubles(p[i].y, q[i].y); })});
}
#endif

/// 1 if insides meet, 0 if the polygons are apart, else undecided. In every rounding mode, if subnormals are kept.
template <class T>
VESICA_CALLED int convex_overlap([[maybe_unused]] const Polygon<T>& a, [[maybe_unused]] const Polygon<T>& b) noexcept {
#if VESICA_HAS_TWO_DOUBLES
  const Edges<T> e(a), f(b);
  const Range p = few_vertices(e), q = few_vertices(f);
  if (p.length() == 4 && q.length() == 4) return convex_overlap<4>(e, p, f, q);
  if (p.length() == 3 && q.length() == 3) return convex_overlap<3>(e, p, f, q);
#endif
  return filter::undecided;
}
/// The same for polylines, or a polygon and a polyline, which have no inside.
template <class A, class B>
int convex_overlap(const A&, const B&) noexcept {
  return filter::undecided;
}

}  // namespace vesica::detail::polygon
