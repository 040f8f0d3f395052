// SPDX-License-Identifier: Apache-2.0
#include "crossings/crossing_count.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "oracle/polynomial.hpp"
#include "oracle/region.hpp"

namespace reference {
namespace {

using oracle::Corners;
using oracle::Ellipse;
using oracle::Polynomial;
using oracle::Region;
using oracle::Vector;

void trim(Polynomial& f) {
  while (!f.empty() && f.back() == 0) f.pop_back();
}

Vector image(const Ellipse& e, const Vector& direction) { return to_disc(e, e.centre + direction); }

/// f's outline is C + P cos + Q sin; with t the tangent of half the angle, times 1 + t^2, quadratics in t. Where they
/// are on e's disc's rim is a quartic, of a lower degree where t = infinity is one of the places.
Polynomial quartic_along(const Ellipse& e, const Ellipse& f) {
  const Vector c = to_disc(e, f.centre), p = image(e, f.p), q = image(e, f.q);
  const mpz_class radius = cross(e.p, e.q);
  const auto square = [](const mpz_class& a0, const mpz_class& a1, const mpz_class& a2) {
    return Polynomial{a0 * a0, 2 * a0 * a1, a1 * a1 + 2 * a0 * a2, 2 * a1 * a2, a2 * a2};
  };
  const Polynomial x = square(c.x + p.x, 2 * q.x, c.x - p.x), y = square(c.y + p.y, 2 * q.y, c.y - p.y);
  const Polynomial rim = square(radius, 0, radius);
  Polynomial quartic;
  for (std::size_t i = 0; i < 5; ++i) quartic.push_back(x[i] + y[i] - rim[i]);
  return quartic;
}

Meeting meeting(const Ellipse& e, const Ellipse& f) {
  Polynomial quartic = quartic_along(e, f);
  trim(quartic);
  if (quartic.empty()) return {0, true};
  return {oracle::distinct_real_roots(quartic) + (quartic.size() < 5 ? 1 : 0), false};
}

/// Between two corners P and Q, in (P + s Q) / (1 + s), s > 0.
int meetings_within_edge(const Vector& p, const Vector& q, const mpz_class& radius) {
  const mpz_class rim = radius * radius;
  Polynomial f{dot(p, p) - rim, 2 * (dot(p, q) - rim), dot(q, q) - rim};
  trim(f);
  while (!f.empty() && f.front() == 0) f.erase(f.begin());
  return f.size() < 2 ? 0 : oracle::distinct_positive_roots(f);
}

Meeting meeting(const Corners& corners, const Ellipse& e) {
  const mpz_class radius = cross(e.p, e.q);
  Corners in_disc;
  for (const Vector& x : corners) in_disc.push_back(to_disc(e, x));
  Meeting found{0, false};
  for (const Vector& x : in_disc) found.count += dot(x, x) == radius * radius ? 1 : 0;
  for (std::size_t i = 0; i < edge_count(corners); ++i) {
    found.count += meetings_within_edge(in_disc[i], edge_end(in_disc, i), radius);
  }
  return found;
}

using Place = std::pair<mpq_class, mpq_class>;

Place place(const Vector& from, const Vector& step, const mpq_class& t) {
  return {mpq_class(from.x) + t * mpq_class(step.x), mpq_class(from.y) + t * mpq_class(step.y)};
}

/// The part of p0 + t d that lies on a line parallel to it: t between the two ends of the other edge, within 0 and 1.
void add_common_stretch(const Vector& p, const Vector& d, const Vector& q0, const Vector& q1, std::set<Place>& places,
                        bool& shared) {
  const mpz_class length = dot(d, d);
  mpq_class t0(dot(q0 - p, d), length), t1(dot(q1 - p, d), length);
  t0.canonicalize();
  t1.canonicalize();
  const mpq_class low = std::max(mpq_class(0), std::min(t0, t1)), high = std::min(mpq_class(1), std::max(t0, t1));
  if (low > high) return;
  places.insert(place(p, d, low));
  places.insert(place(p, d, high));
  shared = shared || low < high;
}

void add_edges(const Vector& p0, const Vector& p1, const Vector& q0, const Vector& q1, std::set<Place>& places,
               bool& shared) {
  const Vector d = p1 - p0, e = q1 - q0;
  const mpz_class turn = cross(d, e);
  if (turn == 0) {
    if (orientation(p0, p1, q0) == 0) add_common_stretch(p0, d, q0, q1, places, shared);
    return;
  }
  mpq_class t(cross(q0 - p0, e), turn), s(cross(q0 - p0, d), turn);
  t.canonicalize();
  s.canonicalize();
  if (t >= 0 && t <= 1 && s >= 0 && s <= 1) places.insert(place(p0, d, t));
}

Meeting meeting(const Corners& a, const Corners& b) {
  std::set<Place> places;
  bool shared = false;
  for (std::size_t i = 0; i < edge_count(a); ++i) {
    for (std::size_t j = 0; j < edge_count(b); ++j)
      add_edges(a[i], edge_end(a, i), b[j], edge_end(b, j), places, shared);
  }
  // A single corner has no edge.
  const auto add_point = [&](const Vector& x, const Corners& other) {
    if (other.size() == 1 && other[0] == x) places.insert({mpq_class(x.x), mpq_class(x.y)});
    for (std::size_t i = 0; i < edge_count(other); ++i) {
      const Vector d = edge_end(other, i) - other[i], off = x - other[i];
      if (cross(d, off) != 0 || dot(off, d) < 0 || dot(off, d) > dot(d, d)) continue;
      places.insert({mpq_class(x.x), mpq_class(x.y)});
    }
  };
  if (a.size() == 1) add_point(a[0], b);
  if (b.size() == 1) add_point(b[0], a);
  return {static_cast<int>(places.size()), shared};
}

/// Times 2^60; the rounding is far below what callers ask about.
mpz_class whole(double x) { return mpz_class(std::ldexp(x, 60)); }

Polynomial product(const Polynomial& f, const Polynomial& g) {
  Polynomial out(f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t k = 0; k < g.size(); ++k) out[i + k] += f[i] * g[k];
  }
  return out;
}

}  // namespace

/// Half the angle's tangent is p / q; between p0 / q0 and p1 / q1 it is (p0 + s p1) / (q0 + s q1), s > 0.
int meetings_between(int kind_a, const double* a, int kind_b, const double* b, double from, double to) {
  const oracle::RegionPair pair = oracle::regions(kind_a, a, kind_b, b);
  const Polynomial quartic = quartic_along(pair.a.ellipse, pair.b.ellipse);
  const Polynomial p{whole(std::sin(from / 2)), whole(std::sin(to / 2))},
      q{whole(std::cos(from / 2)), whole(std::cos(to / 2))};
  Polynomial sum(5);
  for (int i = 0; i < 5; ++i) {
    Polynomial term{quartic[static_cast<std::size_t>(i)]};
    for (int k = 0; k < 4; ++k) term = product(term, k < i ? p : q);
    for (std::size_t k = 0; k < 5; ++k) sum[k] += term[k];
  }
  trim(sum);
  while (!sum.empty() && sum.front() == 0) sum.erase(sum.begin());
  return sum.size() < 2 ? 0 : oracle::distinct_positive_roots(sum);
}

Meeting meeting(int kind_a, const double* a, int kind_b, const double* b) {
  const oracle::RegionPair pair = oracle::regions(kind_a, a, kind_b, b);
  const Region &s = pair.a, &t = pair.b;
  if (s.corners.empty() && t.corners.empty()) return meeting(s.ellipse, t.ellipse);
  if (s.corners.empty()) return meeting(t.corners, s.ellipse);
  if (t.corners.empty()) return meeting(s.corners, t.ellipse);
  return meeting(s.corners, t.corners);
}

}  // namespace reference
