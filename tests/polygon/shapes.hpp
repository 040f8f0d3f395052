// SPDX-License-Identifier: Apache-2.0
/// Polygons and polylines that own their vertices, and random ones.
#pragma once

#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "properties/random.hpp"

namespace polygons {

using properties::Random;

/// Vertices x y x y ..., and the first vertex of each ring, with the end.
struct Path {
  std::vector<double> xy;
  std::vector<std::int32_t> rings{0};

  void add_ring(const std::vector<double>& vertices) {
    xy.insert(xy.end(), vertices.begin(), vertices.end());
    rings.push_back(static_cast<std::int32_t>(xy.size() / 2));
  }
  std::size_t ring_count() const { return rings.size() - 1; }

  /// The struct of a polygon or a polyline; a single ring has no offsets.
  template <class Struct = vesica_polygon_f64>
  Struct view() const {
    Struct s{};
    s.x = xy.data();
    s.y = xy.data() + 1;
    s.stride = 2 * sizeof(double);
    s.rings = ring_count() == 1 ? nullptr : rings.data();
    s.count = static_cast<std::int64_t>(ring_count() == 1 ? xy.size() / 2 : ring_count());
    return s;
  }
};

/// A simple ring about a centre: at each of n angles a radius up to `radius`, and at least `least` times as much.
inline std::vector<double> star(int n, double cx, double cy, double radius, double least, Random& random) {
  std::vector<double> angles(static_cast<std::size_t>(n)), ring;
  for (double& a : angles) a = random.between(0, 6.283185307179586);
  std::sort(angles.begin(), angles.end());
  for (const double a : angles) {
    const double r = radius * random.between(least, 1);
    ring.push_back(cx + r * std::cos(a));
    ring.push_back(cy + r * std::sin(a));
  }
  return ring;
}

/// Vertices at integers from 0 to size - 1, which often coincide, lie on edges or on one line. Edges may cross.
inline std::vector<double> lattice_ring(int n, int size, Random& random) {
  std::vector<double> ring;
  for (int i = 0; i < 2 * n; ++i) ring.push_back(random.below(size));
  return ring;
}
inline Path lattice_path(int size, Random& random) {
  Path path;
  const int count = random.chance(0.6) ? 1 : random.integer(2, 3);
  for (int j = 0; j < count; ++j) path.add_ring(lattice_ring(random.integer(1, 6), size, random));
  return path;
}

/// The same set: each ring begun elsewhere, reversed, or closed by its first vertex.
inline Path rewritten(const Path& path, Random& random) {
  Path out;
  for (std::size_t j = 0; j < path.ring_count(); ++j) {
    std::vector<std::size_t> order(static_cast<std::size_t>(path.rings[j + 1] - path.rings[j]));
    std::iota(order.begin(), order.end(), static_cast<std::size_t>(path.rings[j]));
    std::rotate(order.begin(), order.begin() + random.below(static_cast<int>(order.size())), order.end());
    if (random.chance(0.5)) std::reverse(order.begin(), order.end());
    if (random.chance(0.5)) order.push_back(order.front());
    std::vector<double> ring;
    for (const std::size_t i : order) ring.insert(ring.end(), {path.xy[2 * i], path.xy[2 * i + 1]});
    out.add_ring(ring);
  }
  return out;
}

}  // namespace polygons
