// SPDX-License-Identifier: Apache-2.0
#include "oracle/oracle.hpp"

#include <array>
#include <cstddef>

#include "oracle/polynomial.hpp"
#include "oracle/region.hpp"

// The library decides by separating axes and by closed-form conditions on half lengths; here only orientations,
// quadratics along edges, and roots of a characteristic cubic are used.

namespace oracle {
namespace {

/// Do two edges cross inside both? End points on the other edge are found as corners in the other polygon.
bool cross_inside(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
}

bool polygons_overlap(const Corners& a, const Corners& b) {
  for (const Vector& x : a) {
    if (contains(b, x)) return true;
  }
  for (const Vector& x : b) {
    if (contains(a, x)) return true;
  }
  return edges_cross(a, b);
}

bool contains(const Ellipse& e, const Vector& x) {
  const Vector y = to_disc(e, x);
  const mpz_class radius = cross(e.p, e.q);
  return dot(y, y) <= radius * radius;
}

/// Does the edge from y to z, both outside the disc about the origin, meet it? |y + t (z - y)|^2 - r^2 is a quadratic
/// in t, positive at 0 and at 1: it reaches 0 between iff its vertex lies between and its discriminant is >= 0.
bool edge_meets_disc(const Vector& y, const Vector& z, const mpz_class& radius_squared) {
  const Vector d = z - y;
  const mpz_class a = dot(d, d);
  const mpz_class half_b = dot(y, d);
  if (sgn(half_b) >= 0 || -half_b >= a) return false;
  const mpz_class c = dot(y, y) - radius_squared;
  return half_b * half_b >= a * c;
}

/// Symmetric 3 x 3 matrix M of a conic: X' M X <= 0 on the solid ellipse, X = (x, y, 1).
using Matrix = std::array<std::array<mpz_class, 3>, 3>;

Matrix conic(const Ellipse& e, const Vector& origin) {
  const Vector c = e.centre - origin;
  // The two coordinates of to_disc and its radius, as linear forms in (x, y, 1).
  const std::array<mpz_class, 3> s{e.q.y, -e.q.x, -cross(c, e.q)};
  const std::array<mpz_class, 3> t{-e.p.y, e.p.x, -cross(e.p, c)};
  const mpz_class radius = cross(e.p, e.q);
  std::array<mpz_class, 9> entries;
  for (std::size_t i = 0; i < 9; ++i) entries[i] = s[i / 3] * s[i % 3] + t[i / 3] * t[i % 3];
  entries[8] -= radius * radius;
  strip_power_of_two(entries);
  Matrix m;
  for (std::size_t i = 0; i < 9; ++i) m[i / 3][i % 3] = entries[i];
  return m;
}

Matrix adjugate(const Matrix& m) {
  Matrix result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t r = (j + 1) % 3, s = (j + 2) % 3, k = (i + 1) % 3, l = (i + 2) % 3;
      result[i][j] = m[r][k] * m[s][l] - m[r][l] * m[s][k];
    }
  }
  return result;
}

/// Trace of the product of two matrices.
mpz_class trace(const Matrix& a, const Matrix& b) {
  mpz_class sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum += a[i][j] * b[j][i];
  }
  return sum;
}

mpz_class determinant(const Matrix& m, const Matrix& adjugate_of_m) {
  return m[0][0] * adjugate_of_m[0][0] + m[0][1] * adjugate_of_m[1][0] + m[0][2] * adjugate_of_m[2][0];
}

/// det(x A + B).
Polynomial characteristic(const Matrix& a, const Matrix& b) {
  const Matrix adjugate_a = adjugate(a), adjugate_b = adjugate(b);
  Polynomial f{determinant(b, adjugate_b), trace(a, adjugate_b), trace(adjugate_a, b), determinant(a, adjugate_a)};
  strip_power_of_two(f);
  return f;
}

bool cores_overlap(const Region& a, const Region& b) {
  if (!a.corners.empty() && !b.corners.empty()) return polygons_overlap(a.corners, b.corners);
  if (!a.corners.empty()) return polygon_overlaps_ellipse(a.corners, b.ellipse);
  if (!b.corners.empty()) return polygon_overlaps_ellipse(b.corners, a.ellipse);
  return ellipses_overlap(a.ellipse, b.ellipse);
}

}  // namespace

bool edges_cross(const Corners& a, const Corners& b) {
  for (std::size_t i = 0; i < edge_count(a); ++i) {
    for (std::size_t j = 0; j < edge_count(b); ++j) {
      if (cross_inside(a[i], edge_end(a, i), b[j], edge_end(b, j))) return true;
    }
  }
  return false;
}

bool polygon_overlaps_ellipse(const Corners& c, const Ellipse& e) {
  if (contains(c, e.centre)) return true;
  for (const Vector& x : c) {
    if (contains(e, x)) return true;
  }
  const mpz_class radius = cross(e.p, e.q);
  const mpz_class radius_squared = radius * radius;
  for (std::size_t i = 0; i < edge_count(c); ++i) {
    if (edge_meets_disc(to_disc(e, c[i]), to_disc(e, edge_end(c, i)), radius_squared)) return true;
  }
  return false;
}

/// Wang, Wang and Kim, "An algebraic condition for the separation of two ellipsoids" (2001): solid ellipses are
/// disjoint iff det(x A + B) has two distinct positive roots; a double one means that they touch from outside.
bool ellipses_overlap(const Ellipse& a, const Ellipse& b) {
  if (contains(a, b.centre) || contains(b, a.centre)) return true;
  return distinct_positive_roots(characteristic(conic(a, a.centre), conic(b, a.centre))) < 2;
}

bool overlap(int kind_a, const double* a, int kind_b, const double* b) {
  const auto [ra, rb] = regions(kind_a, a, kind_b, b);
  return cores_overlap(ra, rb) || (ra.radius + rb.radius > 0 && near(with_core(ra), with_core(rb), 0));
}

}  // namespace oracle
