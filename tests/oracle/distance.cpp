// SPDX-License-Identifier: Apache-2.0
#include "oracle/distance.hpp"

#include <vesica.h>

#include "oracle/oracle.hpp"
#include "oracle/region.hpp"

// The library looks at corners in the frame of the other shape; here only feet of perpendiculars on single edges are
// used, and whether corners are inside is told by orientations.

namespace oracle {
namespace {

/// A circle as its centre, which is then the only corner.
Corners skeleton(const Region& region) {
  return region.corners.empty() ? Corners{region.ellipse.centre} : region.corners;
}
mpz_class radius(const Region& region) { return region.corners.empty() ? region.ellipse.p.x : mpz_class(0); }

bool points_within(const Vector& x, const Vector& y, const mpz_class& reach) {
  return dot(x - y, x - y) <= reach * reach;
}

/// By the foot of the perpendicular, if it lies on the edge.
bool edge_within(const Vector& x, const Vector& from, const Vector& to, const mpz_class& reach) {
  const Vector edge = to - from, offset = x - from;
  const mpz_class along = dot(offset, edge), length = dot(edge, edge);
  if (sgn(along) <= 0 || along >= length) return points_within(x, from, reach) || points_within(x, to, reach);
  const mpz_class across = cross(edge, offset);
  return across * across <= reach * reach * length;
}

bool any_corner_within(const Corners& a, const Corners& b, const mpz_class& reach) {
  for (const Vector& x : a) {
    if (points_within(x, b[0], reach)) return true;
    for (std::size_t i = 0; i < edge_count(b); ++i) {
      if (edge_within(x, b[i], edge_end(b, i), reach)) return true;
    }
  }
  return false;
}

}  // namespace

bool within(int kind_a, const double* a, int kind_b, const double* b, double distance) {
  if (overlap(kind_a, a, kind_b, b)) return true;
  // The distance in the unit of the shapes is how far a unit velocity leads.
  const MovingPair p = regions_on_way(kind_a, a, kind_b, b, {distance, 0, 1});
  const Corners first = skeleton(p.a), second = skeleton(p.b);
  const mpz_class reach = radius(p.a) + radius(p.b) + p.by.x;
  return any_corner_within(first, second, reach) || any_corner_within(second, first, reach) ||
         (first.size() > 1 && contains(first, second[0])) || (second.size() > 1 && contains(second, first[0]));
}

}  // namespace oracle
