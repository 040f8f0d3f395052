// SPDX-License-Identifier: Apache-2.0
/// Random pairs of convex polygons that share vertices or edges, nearly contain one another, are thin, far from the
/// origin, or tiny.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "polygon/shapes.hpp"

namespace polygons {

using Corner = std::array<double, 2>;

inline Path path_of(const std::vector<Corner>& ring) {
  Path path;
  std::vector<double> xy;
  for (const Corner& c : ring) xy.insert(xy.end(), {c[0], c[1]});
  path.add_ring(xy);
  return path;
}

/// The convex hull of stored points, counter-clockwise, without collinear vertices.
inline std::vector<Corner> hull(std::vector<Corner> corners) {
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  if (corners.size() < 3) return corners;
  const auto turns_left = [](const Corner& o, const Corner& a, const Corner& b) {
    const mpq_class x(o[0]), y(o[1]);
    return (mpq_class(a[0]) - x) * (mpq_class(b[1]) - y) > (mpq_class(a[1]) - y) * (mpq_class(b[0]) - x);
  };
  std::vector<Corner> ring;
  for (const bool back : {false, true}) {
    const std::size_t first = ring.size();
    for (const Corner& c : corners) {
      while (ring.size() >= first + 2 && !turns_left(ring[ring.size() - 2], ring.back(), c)) ring.pop_back();
      ring.push_back(c);
    }
    ring.pop_back();
    if (!back) std::reverse(corners.begin(), corners.end());
  }
  return ring;
}

inline double nudged(double v, Random& random) {
  for (int k = random.integer(-3, 3); k != 0; k -= k > 0 ? 1 : -1) v = std::nextafter(v, k > 0 ? 1e300 : -1e300);
  return v;
}
inline std::vector<Corner> convex(bool lattice, Random& random) {
  std::vector<Corner> corners;
  const int size = random.integer(2, 12);
  const double x = random.between(-1, 1), y = random.between(-1, 1), radius = random.between(0.1, 2);
  for (int n = random.integer(3, 9); n > 0; --n) {
    const double angle = random.between(0, 6.283185307179586);
    lattice ? corners.push_back({1.0 * random.below(size), 1.0 * random.below(size)})
            : corners.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
  return hull(corners);
}
/// Another polygon, which shares something with the first.
inline std::vector<Corner> relative(const std::vector<Corner>& of, bool lattice, Random& random) {
  const auto pick = [&] { return of[static_cast<std::size_t>(random.below(static_cast<int>(of.size())))]; };
  std::vector<Corner> corners;
  switch (random.below(6)) {
    case 0:
      return convex(lattice, random);
    case 1:  // some vertices are the same
      corners = convex(lattice, random);
      for (int n = random.integer(1, 3); n > 0; --n) corners.push_back(pick());
      break;
    case 2:  // nearly the same
      corners = of;
      for (Corner& c : corners) {
        if (random.chance(0.4)) c = {nudged(c[0], random), nudged(c[1], random)};
      }
      break;
    case 3:  // nearly or exactly inside
      for (int n = random.integer(3, 6); n > 0; --n) {
        const Corner p = pick(), q = pick();
        const double t = random.chance(0.3) ? 0.5 : random.unit();
        corners.push_back({(1 - t) * p[0] + t * q[0], (1 - t) * p[1] + t * q[1]});
      }
      break;
    case 4: {  // on an edge
      const Corner p = of[0], q = of[1];
      corners = {p, q};
      for (int n = random.integer(1, 3); n > 0; --n) {
        const double t = random.between(-0.2, 1.2),
                     h = (random.chance(0.8) ? 1 : -1) * std::exp(random.between(-30, 0));
        corners.push_back({p[0] + t * (q[0] - p[0]) + h * (q[1] - p[1]), p[1] + t * (q[1] - p[1]) - h * (q[0] - p[0])});
      }
      break;
    }
    default: {  // turned and moved a little
      const double turn = random.between(-1e-9, 1e-9), by = random.between(-1e-14, 1e-14);
      for (const Corner& c : of) corners.push_back({c[0] - turn * c[1] + by, turn * c[0] + c[1]});
    }
  }
  return hull(corners);
}

struct Two {
  Path a, b;
};
/// False if rounding has left less than a triangle.
inline bool convex_pair(Two& pair, Random& random) {
  const bool lattice = random.chance(0.4);
  std::vector<Corner> a = convex(lattice, random), b;
  if (a.size() < 3) return false;
  b = relative(a, lattice, random);
  const bool thin = random.chance(0.3), sheared = random.chance(0.5), far = random.chance(0.2),
             tiny = random.chance(0.1);
  const double flat = random.chance(0.5) ? 0x1p-40 : 1e-12, x = random.chance(0.5) ? 1e15 : 1e8,
               unit = random.chance(0.5) ? 0x1p-500 : std::ldexp(1.0, random.integer(-900, 450));
  for (std::vector<Corner>* ring : {&a, &b}) {
    for (Corner& c : *ring) {
      if (thin) c = {c[0], flat * c[1] + (sheared ? c[0] : 0)};
      if (far) c = {64 * c[0] + x, 64 * c[1] - 3};
      if (tiny) c = {c[0] * unit, c[1] * unit};
    }
    *ring = hull(*ring);
    if (ring->size() < 3) return false;
  }
  pair = {path_of(a), path_of(b)};
  return true;
}

}  // namespace polygons
