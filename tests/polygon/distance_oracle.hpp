// SPDX-License-Identifier: Apache-2.0
/// Distances of paths with integer vertices: their squares as fractions of integers, over all pairs of edges.
#pragma once

#include <cmath>

#include "polygon/oracle.hpp"

namespace polygons {

/// over / under, 0 or more.
struct Fraction {
  std::int64_t over, under;
};
/// The sign of a - b.
inline int compared(const Fraction& a, const Fraction& b) {
  __extension__ using Wide = __int128;
  const auto left = static_cast<Wide>(a.over) * b.under, right = static_cast<Wide>(b.over) * a.under;
  return (left > right) - (left < right);
}

inline Fraction squared_distance(Lattice p, const LatticeEdge& e) {
  const auto squared = [](Lattice a, Lattice b) { return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y); };
  const std::int64_t vx = e.to.x - e.from.x, vy = e.to.y - e.from.y, length = vx * vx + vy * vy;
  const std::int64_t along = (p.x - e.from.x) * vx + (p.y - e.from.y) * vy;
  if (along <= 0) return {squared(p, e.from), 1};
  if (along >= length) return {squared(p, e.to), 1};
  const std::int64_t across = (p.x - e.from.x) * vy - (p.y - e.from.y) * vx;
  return {across * across, length};
}

/// The squared distance of two outlines: the least over all pairs of edges.
inline Fraction squared_outline_distance(const std::vector<LatticeEdge>& a, const std::vector<LatticeEdge>& b) {
  Fraction least{1, 0};
  for (const LatticeEdge& e : a) {
    for (const LatticeEdge& f : b) {
      if (meet(e, f)) return {0, 1};
      for (const Fraction& d : {squared_distance(e.from, f), squared_distance(e.to, f), squared_distance(f.from, e),
                                squared_distance(f.to, e)}) {
        if (least.under == 0 || compared(d, least) < 0) least = d;
      }
    }
  }
  return least;
}

inline long double root(const Fraction& squared) {
  return std::sqrt(static_cast<long double>(squared.over) / static_cast<long double>(squared.under));
}

}  // namespace polygons
