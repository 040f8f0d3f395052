// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <vector>

#include "oracle/oracle.hpp"
#include "oracle/polynomial.hpp"
#include "oracle/region.hpp"

// The library decides by separating axes, supports, and the pencil of two ellipses; here the common part of two
// polygons is made, distances from a disc are compared, and the outline of one ellipse is followed round the other.

namespace oracle {
namespace {

// Codes of vesica.h.
constexpr int disjoint = 0, touch = 1, cross_code = 2, inside_code = 3, contains_code = 5, equal = 7;

int converse(int code) { return code == 3 || code == 4 ? code + 2 : code == 5 || code == 6 ? code - 2 : code; }

/// a is or is not in b, reaching b's outline or not; b is or is not in a; the insides meet or not; the shapes meet.
struct Facts {
  bool a_in_b, a_reaches_b, b_in_a, b_reaches_a, insides_meet, meet;
};

int code(const Facts& f) {
  if (f.a_in_b && f.b_in_a) return equal;
  if (f.a_in_b) return inside_code + (f.a_reaches_b ? 1 : 0);
  if (f.b_in_a) return contains_code + (f.b_reaches_a ? 1 : 0);
  if (f.insides_meet) return cross_code;
  return f.meet ? touch : disjoint;
}

/// x is one of c's points. Is it of its outline?
bool on_outline(const Corners& c, const Vector& x) {
  if (c.size() == 1) return false;
  if (c.size() == 2) return x == c[0] || x == c[1];
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (orientation(c[i], edge_end(c, i), x) == 0) return true;
  }
  return false;
}

struct Within {
  bool within, reaches_outline;
};

Within within(const Corners& a, const Corners& b) {
  Within result{true, false};
  for (const Vector& x : a) {
    result.within &= contains(b, x);
    result.reaches_outline |= on_outline(b, x);
  }
  return result;
}

struct RationalPoint {
  mpq_class x, y;
};

/// The intersection of the lines of two edges that are not parallel.
RationalPoint crossing(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  const Vector e = b - a, f = d - c;
  mpq_class t(cross(c - a, f), cross(e, f));
  t.canonicalize();
  return {a.x + t * e.x, a.y + t * e.y};
}

/// All corners of the common part of two polygons, some of them more than once.
std::vector<RationalPoint> common_corners(const Corners& a, const Corners& b) {
  std::vector<RationalPoint> corners;
  for (const Vector& x : a) {
    if (contains(b, x)) corners.push_back({x.x, x.y});
  }
  for (const Vector& x : b) {
    if (contains(a, x)) corners.push_back({x.x, x.y});
  }
  for (std::size_t i = 0; i < edge_count(a); ++i) {
    for (std::size_t j = 0; j < edge_count(b); ++j) {
      const Vector &p = a[i], &q = edge_end(a, i), &r = b[j], &s = edge_end(b, j);
      if (orientation(p, q, r) * orientation(p, q, s) < 0 && orientation(r, s, p) * orientation(r, s, q) < 0) {
        corners.push_back(crossing(p, q, r, s));
      }
    }
  }
  return corners;
}

/// Is x, a point of c, inside c?
bool in_inside(const Corners& c, const RationalPoint& x) {
  if (c.size() == 1) return true;
  if (c.size() == 2) return !((x.x == c[0].x && x.y == c[0].y) || (x.x == c[1].x && x.y == c[1].y));
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Vector edge = edge_end(c, i) - c[i];
    if (sgn(edge.x * (x.y - c[i].y) - edge.y * (x.x - c[i].x)) <= 0) return false;
  }
  return true;
}

int relation(const Corners& a, const Corners& b) {
  const Within a_in_b = within(a, b), b_in_a = within(b, a);
  const std::vector<RationalPoint> corners = common_corners(a, b);
  bool insides_meet = false;
  if (!corners.empty()) {
    // The mean of the corners lies inside the common part, which is the common part of the insides if they meet.
    RationalPoint mean{0, 0};
    for (const RationalPoint& x : corners) mean = {mean.x + x.x, mean.y + x.y};
    const mpq_class count(static_cast<unsigned long>(corners.size()));
    mean = {mean.x / count, mean.y / count};
    insides_meet = in_inside(a, mean) && in_inside(b, mean);
  }
  return code(
      {a_in_b.within, a_in_b.reaches_outline, b_in_a.within, b_in_a.reaches_outline, insides_meet, !corners.empty()});
}

/// Sign of the distance from the origin to the segment from y to z, squared, less the radius squared.
int nearest_beyond(const Vector& y, const Vector& z, const mpz_class& radius_squared) {
  const Vector d = z - y;
  if (sgn(dot(y, d)) >= 0) return sgn(mpz_class(dot(y, y) - radius_squared));
  if (sgn(dot(z, d)) <= 0) return sgn(mpz_class(dot(z, z) - radius_squared));
  const mpz_class area = cross(y, z);
  return sgn(mpz_class(area * area - radius_squared * dot(d, d)));
}

int relation(const Corners& polygon, const Ellipse& e) {
  // An affine map, so nothing about the relation changes.
  Corners c;
  for (const Vector& x : polygon) c.push_back(to_disc(e, x));
  const mpz_class radius = cross(e.p, e.q);
  const mpz_class radius_squared = radius * radius;
  Facts facts{true, false, c.size() == 4, false, false, false};
  const bool centre_in_polygon = contains(c, {0, 0});
  int nearest = centre_in_polygon ? -1 : 1;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const int corner = sgn(mpz_class(dot(c[i], c[i]) - radius_squared));
    facts.a_in_b &= corner <= 0;
    facts.a_reaches_b |= corner == 0;
    const Vector& end = edge_end(c, i);
    nearest = std::min(nearest, c.size() == 1 ? corner : nearest_beyond(c[i], end, radius_squared));
    // Twice the area of the triangle with the centre is the edge's length times the edge's distance.
    const mpz_class area = cross(c[i], end);
    const Vector edge = end - c[i];
    const int room = sgn(area) < 0 ? -1 : sgn(mpz_class(area * area - radius_squared * dot(edge, edge)));
    facts.b_in_a &= room >= 0;
    facts.b_reaches_a |= room == 0;
  }
  facts.insides_meet = nearest < 0;
  facts.meet = nearest <= 0;
  return code(facts);
}

/// |y|^2 - r^2 along the outline of f in the frame in which e is the disc of radius r, times (1 + t^2)^2, t the tangent
/// of half the angle. The outline's last point, t infinite, is a root as many times as the degree falls short of 4.
Polynomial outline_beyond(const Ellipse& e, const Ellipse& f) {
  const Vector origin = to_disc(e, e.centre), c = to_disc(e, f.centre);
  const Vector p = to_disc(e, e.centre + f.p) - origin, q = to_disc(e, e.centre + f.q) - origin;
  const mpz_class radius = cross(e.p, e.q);
  const mpz_class rr = radius * radius;
  const Vector first = c + p, middle = q + q, last = c - p;
  Polynomial g{dot(first, first) - rr, 2 * dot(first, middle), dot(middle, middle) + 2 * dot(first, last) - 2 * rr,
               2 * dot(middle, last), dot(last, last) - rr};
  while (!g.empty() && g.back() == 0) g.pop_back();
  strip_power_of_two(g);
  return g;
}

/// Does f change its sign at some real root: are there roots of odd multiplicity?
bool changes_sign(const Polynomial& f) {
  int odd = 0, sign = 1;
  for (Polynomial g = f; g.size() > 1; g = repeated_part(g), sign = -sign) odd += sign * distinct_real_roots(g);
  return odd > 0;
}

int relation(const Ellipse& e, const Ellipse& f) {
  const Polynomial beyond = outline_beyond(e, f);
  if (beyond.empty()) return equal;
  if (changes_sign(beyond)) return cross_code;
  const bool reaches = beyond.size() < 5 || distinct_real_roots(beyond) > 0;
  if (sgn(beyond.back()) < 0) return contains_code + (reaches ? 1 : 0);
  // The outline of f runs outside e: round it, or beside it.
  const Vector centre = to_disc(f, e.centre);
  const mpz_class radius = cross(f.p, f.q);
  if (dot(centre, centre) < radius * radius) return inside_code + (reaches ? 1 : 0);
  return reaches ? touch : disjoint;
}

}  // namespace

int relation(int kind_a, const double* a, int kind_b, const double* b) {
  const auto [ra, rb] = regions(kind_a, a, kind_b, b);
  if (ra.radius + rb.radius > 0) return rounded_relation(with_core(ra), with_core(rb));
  if (!ra.corners.empty() && !rb.corners.empty()) return relation(ra.corners, rb.corners);
  if (!ra.corners.empty()) return relation(ra.corners, rb.ellipse);
  if (!rb.corners.empty()) return converse(relation(rb.corners, ra.ellipse));
  return relation(ra.ellipse, rb.ellipse);
}

}  // namespace oracle
