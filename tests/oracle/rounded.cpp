// SPDX-License-Identifier: Apache-2.0
#include <vesica.h>

#include "oracle/region.hpp"

// The library asks which part of one core is closest to the other, in floating point first. Here all corners are
// compared with all edges, by squared distances in fractions.

namespace oracle {
namespace {

/// num / den, with den > 0; or infinite, with den 0.
struct Square {
  mpz_class num, den;
};
int compare(const Square& a, const Square& b) { return sgn(a.num * b.den - b.num * a.den); }

Square squared_distance(const Vector& p, const Vector& a, const Vector& b) {
  const Vector edge = b - a, offset = p - a;
  const mpz_class length = dot(edge, edge), along = dot(offset, edge), across = cross(edge, offset);
  if (length == 0 || sgn(along) <= 0) return {dot(offset, offset), 1};
  if (along >= length) return {dot(p - b, p - b), 1};
  return {across * across, length};
}

Square to_outline(const Vector& p, const Corners& c) {
  Square least{1, 0};
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Square d = squared_distance(p, c[i], edge_end(c, i));
    if (compare(d, least) < 0) least = d;
  }
  return least;
}

/// 1 if a is inside b, 0 if it reaches b's outline from inside, -1 if it reaches out of b.
int clearance(const Region& a, const Region& b) {
  const mpz_class length = b.radius - a.radius;
  int least = 1;
  for (const Vector& p : a.corners) {
    const int distance = compare(to_outline(p, b.corners), {length * length, 1});
    const bool in = contains(b.corners, p);
    const int room = in ? (length > 0 ? 1 : distance) : length < 0 ? -1 : -distance;
    least = room < least ? room : least;
  }
  return least;
}

/// The distance of the cores against the sum of the radii: -1 if it is less, 0 if equal, 1 if more.
int contact(const Region& a, const Region& b) {
  const mpz_class sum = a.radius + b.radius;
  Square least{1, 0};
  const auto take = [&](const Square& d) {
    if (compare(d, least) < 0) least = d;
  };
  for (const Vector& p : a.corners) take(contains(b.corners, p) ? Square{0, 1} : to_outline(p, b.corners));
  for (const Vector& p : b.corners) take(contains(a.corners, p) ? Square{0, 1} : to_outline(p, a.corners));
  if (edges_cross(a.corners, b.corners)) take({0, 1});
  return compare(least, {sum * sum, 1});
}

}  // namespace

int rounded_relation(const Region& a, const Region& b) {
  const int apart = contact(a, b), in_b = clearance(a, b), in_a = clearance(b, a);
  if (apart > 0) return VESICA_DISJOINT;
  if (in_a >= 0 && in_b >= 0) return VESICA_EQUAL;
  if (in_b >= 0) return in_b > 0 ? VESICA_INSIDE : VESICA_INSIDE_TOUCH;
  if (in_a >= 0) return in_a > 0 ? VESICA_CONTAINS : VESICA_CONTAINS_TOUCH;
  return apart < 0 ? VESICA_CROSS : VESICA_TOUCH;
}

}  // namespace oracle
