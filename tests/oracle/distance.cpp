// SPDX-License-Identifier: Apache-2.0
#include "oracle/distance.hpp"

#include <vesica.h>

#include "oracle/oracle.hpp"
#include "oracle/polynomial.hpp"
#include "oracle/region.hpp"

// The library looks at corners in the frame of the other shape; here only feet of perpendiculars on single edges are
// used, and whether corners are inside is told by orientations. With an ellipse the library asks which part of a box is
// closest; here a disc moves along each edge, and the places where it touches the ellipse are counted.

namespace oracle {
namespace {

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

Polynomial line(const mpz_class& at_0, const mpz_class& at_1) { return {at_0, at_1 - at_0}; }
Polynomial times(long factor, const Polynomial& f) { return Polynomial{factor} * f; }

/// The discriminant of det(x A + B(t)), A the conic of the ellipse and B(t) that of the disc of radius `reach` > 0
/// about from + t (to - from): 0 where there is a double root. Of degree 8 in t.
Polynomial contacts(const Ellipse& e, const Vector& from, const Vector& to, const mpz_class& reach) {
  // About the ellipse's centre A = diag(Q, -w^2): X' Q X is the square of to_disc().
  const mpz_class w = cross(e.p, e.q), minus_ww = -w * w, minus_square = -reach * reach;
  const mpz_class q00 = e.q.y * e.q.y + e.p.y * e.p.y, q11 = e.q.x * e.q.x + e.p.x * e.p.x;
  const mpz_class q01 = -(e.q.x * e.q.y + e.p.x * e.p.y), trace = q00 + q11, det = q00 * q11 - q01 * q01;
  const Vector first = from - e.centre, last = to - e.centre;
  const Polynomial x = line(first.x, last.x), y = line(first.y, last.y), xx = x * x, yy = y * y;
  // B has the rows (1, 0, -x), (0, 1, -y), (-x, -y, x^2 + y^2 - reach^2). With V = (x, y) its adjugate has
  // V V' - reach^2 1 in the first two rows and columns, and 1 last.
  const Polynomial k3{det * minus_ww}, k0{minus_square};
  const Polynomial k2 = Polynomial{minus_ww * trace} + Polynomial{det} * (xx + yy + Polynomial{minus_square});
  const Polynomial vqv = Polynomial{q00} * xx + Polynomial{2 * q01} * (x * y) + Polynomial{q11} * yy;
  const Polynomial k1 = vqv + Polynomial{minus_square * trace + minus_ww};
  return k2 * k2 * k1 * k1 + times(-4, k3 * k1 * k1 * k1) + times(-4, k2 * k2 * k2 * k0) +
         times(18, k3 * k2 * k1 * k0) + times(-27, k3 * k3 * k0 * k0);
}

/// A disc moves along an edge that does not meet the ellipse; at both ends it is apart from it. In between it comes to
/// meet the ellipse iff there is a double root: roots are simple where shapes are apart, and two are equal where they
/// touch (Wang, Wang and Kim).
bool edge_near_ellipse(const Vector& from, const Vector& to, const Ellipse& e, const mpz_class& reach) {
  return distinct_roots_below_1(contacts(e, from, to, reach)) > 0;
}

bool is_disc(const Ellipse& e) { return e.q == Vector{-e.p.y, e.p.x}; }

}  // namespace

Region with_core(const Region& region) {
  const Ellipse& e = region.ellipse;
  const bool along_axes = region.corners.empty() && is_disc(e) && (e.p.x == 0 || e.p.y == 0);
  return along_axes ? Region{{e.centre}, {}, abs(e.p.x + e.p.y)} : region;
}

bool near_ellipse(const Corners& c, const Ellipse& e, const mpz_class& reach) {
  if (reach == 0) return false;
  for (const Vector& x : c) {
    if (ellipses_overlap({x, {reach, 0}, {0, reach}}, e)) return true;
  }
  for (std::size_t i = 0; i < edge_count(c); ++i) {
    if (edge_near_ellipse(c[i], edge_end(c, i), e, reach)) return true;
  }
  return false;
}

bool near(const Region& a, const Region& b, const mpz_class& distance) {
  const mpz_class reach = a.radius + b.radius + distance;
  const Corners &first = a.corners, &second = b.corners;
  if (first.empty()) return near_ellipse(second, a.ellipse, reach);
  if (second.empty()) return near_ellipse(first, b.ellipse, reach);
  return any_corner_within(first, second, reach) || any_corner_within(second, first, reach) ||
         (first.size() > 1 && contains(first, second[0])) || (second.size() > 1 && contains(second, first[0]));
}

bool within(int kind_a, const double* a, int kind_b, const double* b, double distance) {
  if (overlap(kind_a, a, kind_b, b)) return true;
  // The distance in the unit of the shapes is how far a unit velocity leads.
  const MovingPair p = regions_on_way(kind_a, a, kind_b, b, {distance, 0, 1});
  return near(with_core(p.a), with_core(p.b), p.by.x);
}

}  // namespace oracle
