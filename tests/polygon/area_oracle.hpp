// SPDX-License-Identifier: Apache-2.0
/// Areas of polygons by slabs, in long doubles: between two neighbouring places where an outline turns or two edges
/// cross, all edges are straight and in order, so a trapezoid's middle decides. By the even-odd rule alone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "polygon/shapes.hpp"

namespace polygons {

using Real = long double;

struct RealEdge {
  Real x0, y0, x1, y1;
  bool second;  // of the second polygon
  Real at(Real x) const { return y0 + (y1 - y0) * ((x - x0) / (x1 - x0)); }
};

/// Edges from left to right, upright ones left out.
inline void add_edges(const Path& path, bool second, std::vector<RealEdge>& edges) {
  for (std::size_t j = 0; j < path.ring_count(); ++j) {
    const auto first = static_cast<std::size_t>(path.rings[j]), last = static_cast<std::size_t>(path.rings[j + 1]);
    for (std::size_t i = first; i < last; ++i) {
      const std::size_t k = i + 1 == last ? first : i + 1;
      RealEdge e{path.xy[2 * i], path.xy[2 * i + 1], path.xy[2 * k], path.xy[2 * k + 1], second};
      if (e.x0 > e.x1) e = {e.x1, e.y1, e.x0, e.y0, second};
      if (e.x0 < e.x1) edges.push_back(e);
    }
  }
}

/// The area of what is inside both.
inline Real area_by_slabs(const Path& a, const Path& b) {
  std::vector<RealEdge> edges;
  add_edges(a, false, edges);
  add_edges(b, true, edges);
  std::vector<Real> places;
  for (const RealEdge& e : edges) {
    places.push_back(e.x0);
    places.push_back(e.x1);
    for (const RealEdge& f : edges) {
      const Real from = std::max(e.x0, f.x0), to = std::min(e.x1, f.x1);
      if (!(from < to)) continue;
      const Real p = e.at(from) - f.at(from), q = e.at(to) - f.at(to);
      if ((p < 0 && q > 0) || (p > 0 && q < 0)) places.push_back(from + (to - from) * (p / (p - q)));
    }
  }
  std::sort(places.begin(), places.end());
  Real area = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Real width = places[i] - places[i - 1], middle = places[i - 1] + width / 2;
    if (!(width > 0)) continue;
    std::vector<std::pair<Real, bool>> heights;
    for (const RealEdge& e : edges) {
      if (e.x0 < middle && middle < e.x1) heights.emplace_back(e.at(middle), e.second);
    }
    std::sort(heights.begin(), heights.end());
    bool inside[2] = {false, false};
    for (std::size_t k = 0; k < heights.size(); ++k) {
      if (inside[0] && inside[1]) area += width * (heights[k].first - heights[k - 1].first);
      inside[heights[k].second ? 1 : 0] ^= true;
    }
  }
  return area;
}

/// The library's bound for two polygons: 192 * 2^-53 g w (vesica/polygon/area.hpp).
inline double area_bound(const Path& a, const Path& b) {
  std::vector<RealEdge> e, f;
  add_edges(a, false, e);
  add_edges(b, true, f);
  Real low[2] = {1e300L, 1e300L}, high[2] = {-1e300L, -1e300L}, widths = 0;
  for (const Path* path : {&a, &b}) {
    const int k = path == &b ? 1 : 0;
    for (std::size_t i = 1; i < path->xy.size(); i += 2) {
      low[k] = std::min(low[k], static_cast<Real>(path->xy[i]));
      high[k] = std::max(high[k], static_cast<Real>(path->xy[i]));
    }
  }
  for (const RealEdge& s : e) {
    for (const RealEdge& t : f) widths += std::max(std::min(s.x1, t.x1) - std::max(s.x0, t.x0), Real{0});
  }
  const Real level = (std::max(low[0], low[1]) + std::min(high[0], high[1])) / 2;
  const Real most = std::max(std::max(high[0], high[1]) - level, level - std::min(low[0], low[1]));
  return static_cast<double>(0x1.8p-46L * most * widths);
}

}  // namespace polygons
