// SPDX-License-Identifier: Apache-2.0
#include "oracle/oracle.hpp"

#include <gmpxx.h>
#include <vesica.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstddef>
#include <vector>

// Every shape becomes integer geometry in one common unit, a power of two: a list of corners, or an ellipse as the
// image C + s P + t Q of the unit disc. The library decides by separating axes and by closed-form conditions on
// half lengths; here only orientations, quadratics along edges, and roots of a characteristic cubic are used.

namespace oracle {
namespace {

/// mantissa * 2^exponent.
struct Dyadic {
  mpz_class mantissa;
  long exponent;
};

Dyadic dyadic(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  Dyadic d{mpz_class(std::ldexp(fraction, 53)), exponent - 53L};
  if (d.mantissa == 0) return {0, LONG_MAX};
  // Short mantissas keep small integers small.
  const mp_bitcnt_t zeros = mpz_scan1(d.mantissa.get_mpz_t(), 0);
  d.mantissa >>= zeros;
  d.exponent += static_cast<long>(zeros);
  return d;
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  if (a.mantissa == 0 || b.mantissa == 0) return {0, LONG_MAX};
  return {a.mantissa * b.mantissa, a.exponent + b.exponent};
}

/// A shape's numbers as lengths: axis times half extent in place of the two.
std::vector<Dyadic> lengths(int kind, const double* n) {
  if (kind == VESICA_RECT || kind == VESICA_ELLIPSE) {
    const Dyadic ux = dyadic(n[2]), uy = dyadic(n[3]), h = dyadic(n[4]), k = dyadic(n[5]);
    return {dyadic(n[0]), dyadic(n[1]), h * ux, h * uy, k * ux, k * uy};
  }
  const int count = kind == VESICA_POINT ? 2 : kind == VESICA_CIRCLE ? 3 : 4;
  std::vector<Dyadic> result;
  for (int i = 0; i < count; ++i) result.push_back(dyadic(n[i]));
  return result;
}

std::vector<mpz_class> integers(const std::vector<Dyadic>& numbers, long unit) {
  std::vector<mpz_class> result;
  for (const Dyadic& d : numbers) {
    result.push_back(d.mantissa == 0 ? mpz_class(0)
                                     : mpz_class(d.mantissa << static_cast<mp_bitcnt_t>(d.exponent - unit)));
  }
  return result;
}

struct Vector {
  mpz_class x, y;
};

Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
bool operator==(const Vector& a, const Vector& b) { return a.x == b.x && a.y == b.y; }
mpz_class dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
mpz_class cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
/// > 0 when a, b, c turn counter-clockwise.
int orientation(const Vector& a, const Vector& b, const Vector& c) { return sgn(cross(b - a, c - a)); }

/// One corner (a point), two (a segment) or four counter-clockwise (a box with area); no corner twice.
using Corners = std::vector<Vector>;

/// { centre + s p + t q : s^2 + t^2 <= 1 } with p x q > 0.
struct Ellipse {
  Vector centre, p, q;
};

/// A polygon, or an ellipse when there are no corners.
struct Region {
  Corners corners;
  Ellipse ellipse;
};

Corners parallelogram(const Vector& c, const Vector& p, const Vector& q) {
  const Vector zero{0, 0};
  if (p == zero && q == zero) return {c};
  if (q == zero) return {c - p, c + p};
  if (p == zero) return {c - q, c + q};
  return {c - p - q, c + p - q, c + p + q, c - p + q};
}

Corners box(const Vector& low, const Vector& high) {
  if (low == high) return {low};
  if (low.x == high.x || low.y == high.y) return {low, high};
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

Region round_region(const Vector& c, const Vector& p, const Vector& q) {
  if (sgn(cross(p, q)) == 0) return {parallelogram(c, p, q), {}};
  return {{}, {c, p, q}};
}

Region region(int kind, const std::vector<mpz_class>& n) {
  const Vector first{n[0], n[1]};
  switch (kind) {
    case VESICA_POINT:
      return {{first}, {}};
    case VESICA_SEGMENT: {
      const Vector second{n[2], n[3]};
      return {first == second ? Corners{first} : Corners{first, second}, {}};
    }
    case VESICA_CIRCLE:
      return round_region(first, {n[2], 0}, {0, n[2]});
    case VESICA_AABB:
      return {box(first, {n[2], n[3]}), {}};
    case VESICA_RECT:
      return {parallelogram(first, {n[2], n[3]}, {-n[5], n[4]}), {}};
    default:
      return round_region(first, {n[2], n[3]}, {-n[5], n[4]});
  }
}

/// A polygon's edges as pairs of corner indices: none, one or four.
std::size_t edge_count(const Corners& c) { return c.size() == 2 ? 1 : c.size() == 4 ? 4 : 0; }
const Vector& edge_end(const Corners& c, std::size_t edge) { return c[(edge + 1) % c.size()]; }

bool contains(const Corners& c, const Vector& x) {
  if (c.size() == 1) return c[0] == x;
  if (c.size() == 2) return orientation(c[0], c[1], x) == 0 && sgn(dot(x - c[0], x - c[1])) <= 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (orientation(c[i], edge_end(c, i), x) < 0) return false;
  }
  return true;
}

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
  for (std::size_t i = 0; i < edge_count(a); ++i) {
    for (std::size_t j = 0; j < edge_count(b); ++j) {
      if (cross_inside(a[i], edge_end(a, i), b[j], edge_end(b, j))) return true;
    }
  }
  return false;
}

/// X in the frame where the ellipse is the disc of radius p x q about the origin.
Vector to_disc(const Ellipse& e, const Vector& x) {
  const Vector offset = x - e.centre;
  return {cross(offset, e.q), cross(e.p, offset)};
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

/// Symmetric 3 x 3 matrix M of a conic: X' M X <= 0 on the solid ellipse, X = (x, y, 1).
using Matrix = std::array<std::array<mpz_class, 3>, 3>;

/// Divides by the largest power of two that divides all: a positive factor, which no sign below depends on.
template <class Numbers>
void strip_power_of_two(Numbers& numbers) {
  mp_bitcnt_t shift = ~mp_bitcnt_t{0};
  for (const mpz_class& x : numbers) {
    if (x != 0) shift = std::min(shift, mpz_scan1(x.get_mpz_t(), 0));
  }
  if (shift == ~mp_bitcnt_t{0}) return;
  for (mpz_class& x : numbers) x >>= shift;
}

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

/// Coefficients, constant first; the last is not 0.
using Polynomial = std::vector<mpz_class>;

/// det(x A + B).
Polynomial characteristic(const Matrix& a, const Matrix& b) {
  const Matrix adjugate_a = adjugate(a), adjugate_b = adjugate(b);
  Polynomial f{determinant(b, adjugate_b), trace(a, adjugate_b), trace(adjugate_a, b), determinant(a, adjugate_a)};
  strip_power_of_two(f);
  return f;
}

Polynomial derivative(const Polynomial& f) {
  Polynomial result;
  for (std::size_t i = 1; i < f.size(); ++i) result.push_back(f[i] * static_cast<unsigned long>(i));
  return result;
}

/// A positive multiple of minus the remainder of f by g: the next member of a Sturm sequence. Empty when it is 0.
Polynomial negated_remainder(Polynomial f, const Polynomial& g) {
  while (f.size() >= g.size()) {
    const mpz_class scale = abs(g.back());
    const mpz_class factor = sgn(g.back()) * f.back();
    const std::size_t shift = f.size() - g.size();
    for (mpz_class& c : f) c *= scale;
    for (std::size_t i = 0; i < g.size(); ++i) f[i + shift] -= factor * g[i];
    while (!f.empty() && f.back() == 0) f.pop_back();
  }
  for (mpz_class& c : f) c = -c;
  strip_power_of_two(f);
  return f;
}

int sign_changes(const std::vector<int>& signs) {
  int changes = 0, previous = 0;
  for (const int s : signs) {
    if (s * previous < 0) ++changes;
    if (s != 0) previous = s;
  }
  return changes;
}

/// Distinct roots > 0 of f, f(0) != 0, by Sturm's theorem; a multiple root counts once.
int distinct_positive_roots(const Polynomial& f) {
  std::vector<int> at_zero, at_infinity;
  Polynomial p = f, q = derivative(f);
  while (!p.empty()) {
    at_zero.push_back(sgn(p.front()));
    at_infinity.push_back(sgn(p.back()));
    Polynomial next = q.empty() ? Polynomial{} : negated_remainder(p, q);
    p = std::move(q);
    q = std::move(next);
  }
  return sign_changes(at_zero) - sign_changes(at_infinity);
}

/// Wang, Wang and Kim, "An algebraic condition for the separation of two ellipsoids" (2001): solid ellipses are
/// disjoint iff det(x A + B) has two distinct positive roots; a double one means that they touch from outside.
bool ellipses_overlap(const Ellipse& a, const Ellipse& b) {
  if (contains(a, b.centre) || contains(b, a.centre)) return true;
  return distinct_positive_roots(characteristic(conic(a, a.centre), conic(b, a.centre))) < 2;
}

}  // namespace

bool overlap(int kind_a, const double* a, int kind_b, const double* b) {
  const std::vector<Dyadic> lengths_a = lengths(kind_a, a), lengths_b = lengths(kind_b, b);
  long unit = LONG_MAX;
  for (const Dyadic& d : lengths_a) unit = std::min(unit, d.exponent);
  for (const Dyadic& d : lengths_b) unit = std::min(unit, d.exponent);
  const Region ra = region(kind_a, integers(lengths_a, unit)), rb = region(kind_b, integers(lengths_b, unit));
  if (!ra.corners.empty() && !rb.corners.empty()) return polygons_overlap(ra.corners, rb.corners);
  if (!ra.corners.empty()) return polygon_overlaps_ellipse(ra.corners, rb.ellipse);
  if (!rb.corners.empty()) return polygon_overlaps_ellipse(rb.corners, ra.ellipse);
  return ellipses_overlap(ra.ellipse, rb.ellipse);
}

}  // namespace oracle
