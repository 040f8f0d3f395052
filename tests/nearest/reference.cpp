// SPDX-License-Identifier: Apache-2.0
#include "nearest/reference.hpp"

#include <vesica.h>

#include <algorithm>
#include <cmath>

namespace nearest_reference {
namespace {

Real real(double x) { return Real(x); }
Real dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
Real cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
Vector operator*(const Real& k, const Vector& a) { return {k * a.x, k * a.y}; }
Real length(const Vector& a) { return sqrt(dot(a, a)); }
Vector unit(const Vector& a) { return (1 / length(a)) * a; }

/// The point of a shape, seen from its centre, that is farthest along n.
Vector support(const Shape& s, const Vector& n) {
  const Real p = dot(s.u, n), q = cross(s.u, n);
  Real along, across;
  if (s.curved) {
    const Real ap = s.a * p, bq = s.b * q, h = sqrt(Real(ap * ap + bq * bq));
    along = s.a * (ap / h);
    across = s.b * (bq / h);
  } else {
    along = p < 0 ? Real(-s.a) : s.a;
    across = q < 0 ? Real(-s.b) : s.b;
  }
  const Vector on_core{along * s.u.x - across * s.u.y, along * s.u.y + across * s.u.x};
  return s.r == 0 ? on_core : on_core + (s.r / length(n)) * n;
}

/// A direction and what is nearest along it: the difference of the two support points.
struct Probe {
  Vector n, g;
};

/// The point of the segment from g to h closest to the origin.
Vector foot(const Vector& g, const Vector& h) {
  const Vector along = h - g;
  const Real square = dot(along, along);
  if (square == 0) return g;
  Real t = -dot(g, along) / square;
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  return g + t * along;
}

/// The convex set of all differences of points of b and a: its distance from the origin is wanted. Directions low and
/// high hold the best one between them, as the slopes there say.
class Search {
 public:
  Search(const Shape& a, const Shape& b) : a_(a), b_(b), d_(b.centre - a.centre) {
    const Probe middle = probe(d_);
    const bool rising = slope(middle) > 0;
    low_ = rising ? middle : probe({d_.y, -d_.x});
    high_ = rising ? probe({-d_.y, d_.x}) : middle;
    best_.lower = 0;
    bound();
  }

  void try_direction(const Vector& n) {
    if (cross(low_.n, n) <= 0 || cross(n, high_.n) <= 0) return;
    const Probe p = probe(n);
    (slope(p) > 0 ? low_ : high_) = p;
    const Real width = dot(p.n, p.g) / length(p.n);
    if (width > best_.lower) best_.lower = width;
    bound();
  }
  void halve() { try_direction(unit(low_.n) + unit(high_.n)); }
  void aim() { try_direction(foot(low_.g, high_.g)); }
  /// Either side of a direction.
  void hint(const Vector& n, double tangent) {
    const Real t = real(tangent);
    try_direction({n.x + t * n.y, n.y - t * n.x});
    try_direction({n.x - t * n.y, n.y + t * n.x});
  }
  const Distance& best() const { return best_; }

 private:
  Probe probe(const Vector& n) const { return {n, d_ - support(a_, n) - support(b_, n)}; }
  static Real slope(const Probe& p) { return cross(p.n, p.g); }
  void bound() {
    best_.upper = length(foot(low_.g, high_.g));
    const Vector n = foot(low_.g, high_.g);
    if (n.x == 0 && n.y == 0) return;
    const Real width = dot(n, probe(n).g) / length(n);
    if (width > best_.lower) best_.lower = width;
  }

  const Shape& a_;
  const Shape& b_;
  Vector d_;
  Probe low_, high_;
  Distance best_{real(0), real(0)};
};

/// Distance of (x, y) from the outline of (x/a)^2 + (y/b)^2 = 1, x, y >= 0: the foot is (a^2 x / (t + a^2), b^2 y / (t
/// + b^2)) with the largest t that puts it on the outline, found by halving.
Real from_ellipse(const Real& a, const Real& b, const Real& x, const Real& y) {
  if (b > a) return from_ellipse(b, a, y, x);
  const Real aa = a * a, bb = b * b;
  if (y == 0 && a * x <= aa - bb) {
    const Real fx = aa > bb ? Real(aa * x / (aa - bb)) : real(0);
    return length({fx - x, b * sqrt(Real(1 - fx * fx / aa))});
  }
  Real low = std::max(Real(b * y - bb), Real(a * x - aa)), high = length({a * x, b * y}) - bb;
  for (int step = 0; step < 400; ++step) {
    const Real t = (low + high) / 2;
    const Vector w{a * x / (t + aa), b * y / (t + bb)};
    (dot(w, w) > 1 ? low : high) = t;
  }
  const Vector w{a * x / (high + aa), b * y / (high + bb)};
  return length({a * w.x - x, b * w.y - y});
}

/// At most that distance, negative inside. Points of the outline at hand (straight along either axis, and the vertices)
/// and the first order along the slope, where that is far below the least radius of curvature, spare the search.
Real beyond_ellipse(const Real& a, const Real& b, const Real& x, const Real& y, const Real& enough) {
  const Vector w{x / a, y / b}, slope{w.x / a, w.y / b};
  const Real excess = dot(w, w) - 1;
  Real least = std::min(length({x - a, y}), length({x, y - b}));
  if (w.y <= 1) least = std::min(least, Real(abs(x - a * sqrt(Real(1 - w.y * w.y)))));
  if (w.x <= 1) least = std::min(least, Real(abs(y - b * sqrt(Real(1 - w.x * w.x)))));
  if (slope.x != 0 || slope.y != 0) {
    const Real first_order = abs(excess) / (2 * length(slope)), furthest = b < a ? b * b / a : a * a / b;
    if (16 * first_order < furthest) least = std::min(least, first_order);
  }
  if (least > enough) least = std::min(least, from_ellipse(a, b, x, y));
  return excess < 0 ? Real(-least) : least;
}

Shape box(const Vector& centre, const Vector& u, const Real& a, const Real& b) {
  return {centre, u, a, b, real(0), false};
}

}  // namespace

void set_precision(const properties::Pair& pair) {
  int low = 9999, high = -9999;
  for (const auto* numbers : {&pair.a, &pair.b}) {
    for (const double x : *numbers) {
      if (x == 0) continue;
      low = std::min(low, std::ilogb(x));
      high = std::max(high, std::ilogb(x));
    }
  }
  // A variable keeps the precision it was made with, whatever is assigned to it.
  mpf_set_default_prec(static_cast<mp_bitcnt_t>(448 + 4 * std::max(0, high - low - 64)));
}

Shape shape(int kind, const properties::Numbers& s) {
  const Vector first{real(s[0]), real(s[1])}, second{real(s[2]), real(s[3])};
  const Vector right{real(1), real(0)};
  const Real half = real(0.5), zero = real(0);
  switch (kind) {
    case VESICA_POINT:
      return box(first, right, zero, zero);
    case VESICA_SEGMENT:
      return first.x == second.x && first.y == second.y ? box(first, right, zero, zero)
                                                        : box(half * (first + second), second - first, half, zero);
    case VESICA_CIRCLE:
      return {first, right, zero, zero, real(s[2]), false};
    case VESICA_CAPSULE:
    case VESICA_ROUND_RECT: {
      Shape core = shape(kind == VESICA_CAPSULE ? VESICA_SEGMENT : VESICA_RECT, s);
      core.r = real(s[kind == VESICA_CAPSULE ? 4 : 6]);
      return core;
    }
    case VESICA_AABB:
      return box(half * (first + second), right, half * (second.x - first.x), half * (second.y - first.y));
    default: {
      Shape result = box(first, second, real(s[4]), real(s[5]));
      result.curved = kind == VESICA_ELLIPSE && s[4] > 0 && s[5] > 0;
      return result;
    }
  }
}

bool Distance::proved() const { return upper > 0 && upper - lower <= upper * real(0x1p-80); }

Distance distance(const Shape& a, const Shape& b, double hint_x, double hint_y) {
  Search search(a, b);
  const Vector hint{real(hint_x), real(hint_y)};
  for (const double tangent : {0x1p-20, 0x1p-40, 0x1p-48}) search.hint(hint, tangent);
  for (int step = 0; step < 4000 && !search.best().proved(); ++step) {
    if (step % 2 == 0) {
      search.aim();
    } else {
      search.halve();
    }
  }
  return search.best();
}

Real scale(const Shape& a, const Shape& b) {
  const Vector d = b.centre - a.centre;
  Real result = abs(d.x) > abs(d.y) ? abs(d.x) : abs(d.y);
  for (const Shape* s : {&a, &b}) {
    const Real u = length(s->u);
    for (const Real& size : {Real(s->a * u), Real(s->b * u), s->r}) {
      if (size > result) result = size;
    }
  }
  return result;
}

Real aspect(const Shape& s) {
  const bool first = s.a > s.b;
  const Real &longer = first ? s.a : s.b, &shorter = first ? s.b : s.a;
  return shorter > 0 ? Real(longer / shorter) : real(1);
}

Real beyond_outline(const Shape& s, double x, double y, const Real& enough) {
  const Vector p = Vector{real(x), real(y)} - s.centre;
  const Real u = length(s.u), along = abs(dot(s.u, p)) / u, across = abs(cross(s.u, p)) / u;
  const Real a = s.a * u, b = s.b * u;
  if (s.curved) return beyond_ellipse(a, b, along, across, enough);
  const Real dx = along - a, dy = across - b;
  if (dx <= 0 || dy <= 0) return Real(dx > dy ? dx : dy) - s.r;
  return length({dx, dy}) - s.r;
}

}  // namespace nearest_reference
