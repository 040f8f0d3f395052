// SPDX-License-Identifier: Apache-2.0
#include "oracle/motion.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "oracle/polynomial.hpp"
#include "oracle/region.hpp"

// The library tests a line and one point of it. Here the moving shape's whole way is laid out: against polygons as the
// hull of its two ends, between ellipses as a polynomial in time whose roots are the times of tangency.

namespace oracle {
namespace {

/// Counter-clockwise, without points between corners (A. M. Andrew's monotone chain).
Corners hull(Corners points) {
  const auto before = [](const Vector& a, const Vector& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Corners chain;
  const auto extend = [&](const Vector& x, std::size_t least) {
    while (chain.size() >= least && orientation(chain[chain.size() - 2], chain.back(), x) <= 0) chain.pop_back();
    chain.push_back(x);
  };
  for (const Vector& x : points) extend(x, 2);
  const std::size_t upper = chain.size() + 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) extend(points[i], upper);
  chain.pop_back();
  return chain;
}

bool hull_holds(const Corners& c, const Vector& x) {
  if (c.size() == 1) return c[0] == x;
  if (c.size() == 2) return orientation(c[0], c[1], x) == 0 && sgn(dot(x - c[0], x - c[1])) <= 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (orientation(c[i], c[(i + 1) % c.size()], x) < 0) return false;
  }
  return true;
}

/// Does the segment from y to z come within r of the origin?
bool within(const Vector& y, const Vector& z, const mpz_class& radius_squared) {
  if (dot(y, y) <= radius_squared || dot(z, z) <= radius_squared) return true;
  const Vector d = z - y;
  if (sgn(dot(y, d)) >= 0 || sgn(dot(z, d)) <= 0) return false;
  const mpz_class height = cross(y, d);
  return height * height <= radius_squared * dot(d, d);
}

/// Does a convex polygon come within r of the origin?
bool hull_within(const Corners& c, const mpz_class& radius) {
  if (hull_holds(c, {0, 0})) return true;
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (within(c[i], c[(i + 1) % c.size()], radius * radius)) return true;
  }
  return false;
}

/// The differences of points of a and points of b are the moves of b that bring them together: to at most the sum of
/// both radii.
bool polygons_meet(const Corners& a, const Corners& b, const mpz_class& radii, const Vector& way) {
  Corners moves;
  for (const Vector& x : a) {
    for (const Vector& y : b) {
      moves.push_back(x - y);
      moves.push_back(x - y - way);
    }
  }
  return hull_within(hull(moves), radii);
}

/// way: of the polygon.
bool polygon_meets_ellipse(const Corners& c, const Ellipse& e, const Vector& way) {
  Corners places;
  for (const Vector& x : c) {
    places.push_back(to_disc(e, x));
    places.push_back(to_disc(e, x + way));
  }
  return hull_within(hull(places), cross(e.p, e.q));
}

/// The core with a radius > 0 is moved: its way is a polygon, from which the ellipse may be as far as the radius.
bool rounded_meets_ellipse(const Region& rounded, const Ellipse& e, const Vector& way) {
  Corners places = rounded.corners;
  for (const Vector& x : rounded.corners) places.push_back(x + way);
  const Corners swept = hull(places);
  return polygon_overlaps_ellipse(swept, e) || near_ellipse(swept, e, rounded.radius);
}

Polynomial operator+(Polynomial f, const Polynomial& g) {
  f.resize(std::max(f.size(), g.size()));
  for (std::size_t i = 0; i < g.size(); ++i) f[i] += g[i];
  return f;
}
Polynomial operator*(const Polynomial& f, const Polynomial& g) {
  Polynomial product(f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t j = 0; j < g.size(); ++j) product[i + j] += f[i] * g[j];
  }
  return product;
}
Polynomial operator*(long k, const Polynomial& f) { return Polynomial{mpz_class(k)} * f; }

mpz_class value_at_one(const Polynomial& f) {
  mpz_class sum = 0;
  for (const mpz_class& c : f) sum += c;
  return sum;
}

/// det(x A + B), its coefficients being polynomials in the share t of the way. In the frame where the first ellipse is
/// the disc of radius r about the origin, the second is m + s p + t q, (s, t) in the unit disc; A is the first's conic
/// in (s, t), B the unit disc's.
struct Pencil {
  Polynomial c0, c1, c2, c3;

  Pencil(const Ellipse& a, const Ellipse& b, const Vector& way) {
    const auto linear = [&](const Vector& x) { return Vector{cross(x, a.q), cross(a.p, x)}; };
    const Vector m = to_disc(a, b.centre), p = linear(b.p), q = linear(b.q), w = linear(way);
    const mpz_class radius = cross(a.p, a.q), pp = dot(p, p), pq = dot(p, q), qq = dot(q, q);
    const Polynomial pm{dot(p, m), dot(p, w)}, qm{dot(q, m), dot(q, w)};
    const Polynomial mm{mpz_class(dot(m, m) - radius * radius), mpz_class(2 * dot(m, w)), dot(w, w)};
    const mpz_class area = cross(p, q) * radius;
    c0 = {mpz_class(-1)};
    c1 = mm + Polynomial{mpz_class(-pp - qq)};
    c2 = Polynomial{mpz_class(pq * pq - pp * qq)} + Polynomial{mpz_class(pp + qq)} * mm + -1 * (pm * pm) +
         -1 * (qm * qm);
    c3 = {mpz_class(-area * area)};
    centre_at_start = mm.front();
    centre_at_end = value_at_one(mm);
  }

  mpz_class centre_at_start, centre_at_end;

  /// Two distinct positive roots: Wang, Wang and Kim, "An algebraic condition for the separation of two ellipsoids"
  /// (2001).
  static bool overlap(const mpz_class& centre, Polynomial f) {
    strip_power_of_two(f);
    return centre <= 0 || distinct_positive_roots(f) < 2;
  }
  bool overlap_at_start() const { return overlap(centre_at_start, {c0.front(), c1.front(), c2.front(), c3.front()}); }
  bool overlap_at_end() const {
    return overlap(centre_at_end, {value_at_one(c0), value_at_one(c1), value_at_one(c2), value_at_one(c3)});
  }

  /// Ellipses that are apart at both ends are tangent in between iff the discriminant has a root there.
  bool tangent_between() const {
    const Polynomial discriminant = c1 * c1 * (c2 * c2) + -4 * (c0 * (c2 * c2 * c2)) + -4 * (c1 * c1 * c1 * c3) +
                                    18 * (c0 * c1 * (c2 * c3)) + -27 * (c0 * c0 * (c3 * c3));
    // t = x / (1 + x): the way's inside is x > 0.
    const std::size_t degree = discriminant.size() - 1;
    Polynomial all;
    for (std::size_t i = 0; i <= degree; ++i) {
      Polynomial term{discriminant[i]};
      for (std::size_t k = 0; k < degree; ++k) term = term * (k < i ? Polynomial{0, 1} : Polynomial{1, 1});
      all = all + term;
    }
    while (all.size() > 1 && all.back() == 0) all.pop_back();
    strip_power_of_two(all);
    return distinct_positive_roots(all) > 0;
  }
};

bool ellipses_meet(const Ellipse& a, const Ellipse& b, const Vector& way) {
  const Pencil pencil(a, b, way);
  return pencil.overlap_at_start() || pencil.overlap_at_end() || pencil.tangent_between();
}

}  // namespace

bool meets(int kind_a, const double* a, int kind_b, const double* b, const Way& way) {
  auto [ra, rb, by] = regions_on_way(kind_a, a, kind_b, b, way);
  if (ra.radius + rb.radius > 0) {
    ra = with_core(ra);
    rb = with_core(rb);
    if (ra.corners.empty()) return rounded_meets_ellipse(rb, ra.ellipse, by);
    if (rb.corners.empty()) return rounded_meets_ellipse(ra, rb.ellipse, {-by.x, -by.y});
  }
  if (!ra.corners.empty() && !rb.corners.empty()) {
    return polygons_meet(ra.corners, rb.corners, ra.radius + rb.radius, by);
  }
  if (!ra.corners.empty()) return polygon_meets_ellipse(ra.corners, rb.ellipse, {-by.x, -by.y});
  if (!rb.corners.empty()) return polygon_meets_ellipse(rb.corners, ra.ellipse, by);
  return ellipses_meet(ra.ellipse, rb.ellipse, by);
}

}  // namespace oracle
