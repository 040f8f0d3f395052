// SPDX-License-Identifier: Apache-2.0
/// Questions of paths with integer vertices, answered in integers and by looking at every edge. Nothing of the library
/// is used: a ray here goes upward, segments are compared by the signs of four areas.
#pragma once

#include <cstdint>
#include <vector>

#include "polygon/shapes.hpp"

namespace polygons {

struct Lattice {
  std::int64_t x, y;
};
struct LatticeEdge {
  Lattice from, to;
};

inline std::vector<LatticeEdge> lattice_edges(const Path& path, bool closed) {
  std::vector<LatticeEdge> edges;
  const auto vertex = [&](std::int32_t i) {
    const auto k = static_cast<std::size_t>(2 * i);
    return Lattice{static_cast<std::int64_t>(path.xy[k]), static_cast<std::int64_t>(path.xy[k + 1])};
  };
  for (std::size_t j = 0; j < path.ring_count(); ++j) {
    const std::int32_t first = path.rings[j], last = path.rings[j + 1];
    for (std::int32_t i = first; i + 1 < last; ++i) edges.push_back({vertex(i), vertex(i + 1)});
    if (last > first && (closed || last - first == 1)) edges.push_back({vertex(last - 1), vertex(first)});
  }
  return edges;
}

inline int area_sign(Lattice a, Lattice b, Lattice c) {
  const std::int64_t area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return (area > 0) - (area < 0);
}
inline bool is_on(Lattice p, const LatticeEdge& e) {
  return area_sign(e.from, e.to, p) == 0 && std::min(e.from.x, e.to.x) <= p.x && p.x <= std::max(e.from.x, e.to.x) &&
         std::min(e.from.y, e.to.y) <= p.y && p.y <= std::max(e.from.y, e.to.y);
}
inline bool meet(const LatticeEdge& e, const LatticeEdge& f) {
  if (is_on(e.from, f) || is_on(e.to, f) || is_on(f.from, e) || is_on(f.to, e)) return true;
  return area_sign(e.from, e.to, f.from) * area_sign(e.from, e.to, f.to) < 0 &&
         area_sign(f.from, f.to, e.from) * area_sign(f.from, f.to, e.to) < 0;
}

/// Is a point that is on no edge inside? By edges above it.
inline bool is_inside(Lattice p, const std::vector<LatticeEdge>& edges) {
  bool odd = false;
  for (const LatticeEdge& e : edges) {
    const bool rightward = e.from.x <= p.x && e.to.x > p.x, leftward = e.to.x <= p.x && e.from.x > p.x;
    if (rightward && area_sign(e.from, e.to, p) < 0) odd = !odd;
    if (leftward && area_sign(e.from, e.to, p) > 0) odd = !odd;
  }
  return odd;
}

inline bool overlap(const Path& a, bool closed_a, const Path& b, bool closed_b) {
  const auto first = lattice_edges(a, closed_a), second = lattice_edges(b, closed_b);
  for (const LatticeEdge& e : first) {
    for (const LatticeEdge& f : second) {
      if (meet(e, f)) return true;
    }
  }
  for (const LatticeEdge& e : first) {
    if (closed_b && is_inside(e.from, second)) return true;
  }
  for (const LatticeEdge& f : second) {
    if (closed_a && is_inside(f.from, first)) return true;
  }
  return false;
}

}  // namespace polygons
