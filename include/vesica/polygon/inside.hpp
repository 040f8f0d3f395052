// SPDX-License-Identifier: Apache-2.0
/// Is a point inside a polygon, by the parity of the edges that a ray from it crosses?
#pragma once

#include <vesica/exact/number.hpp>
#include <vesica/polygon/walk.hpp>

namespace vesica::detail::polygon {

/// (a - p) x (b - p) for an edge from a to b, exact.
inline exact::Number<2> exact_cross(double px, double py, const Edge& e) noexcept {
  using exact::from_double;
  const auto x = from_double(px), y = from_double(py);
  return (from_double(e.x0) - x) * (from_double(e.y1) - y) - (from_double(e.y0) - y) * (from_double(e.x1) - x);
}
/// The side of p on which b lies, seen from a: the sign of that.
VESICA_COLD inline int exact_side(double px, double py, const Edge& e) noexcept {
  if ((px == e.x0 && py == e.y0) || (px == e.x1 && py == e.y1)) return 0;
  return exact_cross(px, py, e).sign;
}
VESICA_INLINE int side(double px, double py, const Edge& e) noexcept {
  const double left = (e.x0 - px) * (e.y1 - py), right = (e.y0 - py) * (e.x1 - px);
  const double cross = left - right;
  // Each factor is right to u, so each product to 3u and the least number; 2u for u, as every rounding mode allows.
  const double bound = (lane::abs(left) + lane::abs(right)) * 0x1p-49 + 0x1p-1000;
  if (cross > bound) return 1;
  if (cross < -bound) return -1;
  return exact_side(px, py, e);
}
/// 1 if the way from a through b to c turns left at b, -1 if right, 0 if it does not turn. Exact.
VESICA_INLINE int turn(const Point<double>& a, const Point<double>& b, const Point<double>& c) noexcept {
  return side(c.x, c.y, {a.x, a.y, b.x, b.y});
}

/// Does the ray from p to the right cross an edge? The edge holds its lower end and not its upper one, so that a
/// vertex on the ray counts once. p must be on no edge.
VESICA_INLINE bool crosses_ray(double px, double py, const Edge& e) noexcept {
  if ((e.y0 > py) == (e.y1 > py)) return false;
  if (px < lesser(e.x0, e.x1)) return true;
  if (px > greater(e.x0, e.x1)) return false;
  const int s = side(px, py, e);
  return e.y1 > e.y0 ? s > 0 : s < 0;
}

template <class T>
bool odd_crossings(const Edges<T>& edges, const Range& range, double px, double py) noexcept {
  bool odd = false;
  edges.for_edges(range, [&](const Edge& e, std::int64_t) {
    odd ^= crosses_ray(px, py, e);
    return false;
  });
  return odd;
}
/// By boxes. Edges of one ring to the right of p cross its ray an odd number of times if they end on opposite sides.
template <class T>
bool odd_crossings(const Edges<T>& edges, const KeptBoxes& boxes, double px, double py) noexcept {
  bool odd = false;
  boxes.for_runs(
      [&](const Range& range, const Box& box) {
        if (py < box.min_y || py > box.max_y || px > box.max_x) return false;
        if (!(px < box.min_x)) return true;
        const Range ring = edges.ring(edges.ring_of(range.first));
        if (range.last > ring.last) return true;
        const double end = edges.vertex(range.last < ring.last ? range.last : ring.first).y;
        odd ^= (edges.vertex(range.first).y > py) != (end > py);
        return false;
      },
      [&](const Range& run, const Box&) {
        odd ^= odd_crossings(edges, run, px, py);
        return false;
      });
  return odd;
}

/// Is a point that is on no edge inside? Polylines have no inside.
template <class T>
bool inside(const Edges<T>& edges, const Point<double>& p) noexcept {
  if (!edges.closed()) return false;
  return edges.boxes() != nullptr ? odd_crossings(edges, *edges.boxes(), p.x, p.y)
                                  : odd_crossings(edges, edges.all(), p.x, p.y);
}

}  // namespace vesica::detail::polygon
