// SPDX-License-Identifier: Apache-2.0
#include "boundary_distance/dense_search.hpp"

#include <algorithm>
#include <cmath>

#include "vesica.h"

namespace outline_reference {
namespace {

/// Directions round the circle in order of angle.
using Ring = std::vector<Direction>;

constexpr int even_steps = 96, octaves = 26;

const Ring& even_ring() {
  static const Ring ring = [] {
    Ring r;
    for (int i = 0; i < even_steps; ++i) {
      const double angle = 2 * 3.14159265358979323846 * i / even_steps;
      r.push_back({std::cos(angle), std::sin(angle)});
    }
    return r;
  }();
  return ring;
}

void add_normals(const DenseShape& s, Ring& ring) {
  ring.clear();
  const double a = s.a > 0 ? s.a : 1, b = s.b > 0 ? s.b : 1, most = std::max(a, b);
  for (const Direction& w : even_ring()) ring.push_back(s.world(w.x * b / most, w.y * a / most));
}

void add_geometric(const DenseShape& s, Ring& ring) {
  ring.clear();
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double x = quarter == 0 || quarter == 3 ? 1 : -1, y = quarter < 2 ? 1 : -1;
    for (int i = -octaves; i <= octaves; ++i) ring.push_back(s.world(x, y * std::exp2(quarter % 2 == 0 ? i : -i)));
  }
}

void find_minima(const DensePair& f, const Ring& ring, std::vector<double>& value, std::vector<Bracket>& out) {
  const std::size_t n = ring.size();
  value.resize(n);
  for (std::size_t i = 0; i < n; ++i) value[i] = f(ring[i]);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = i == 0 ? n - 1 : i - 1, after = i + 1 == n ? 0 : i + 1;
    if (value[i] <= value[before] && value[i] <= value[after]) {
      out.push_back({ring[before], ring[i], ring[after], value[i]});
    }
  }
}

DenseShape of_centre(double cx, double cy, double ux, double uy, double a, double b, bool curved) {
  const double length = std::hypot(ux, uy);
  return {cx, cy, ux / length, uy / length, a * length, b * length, curved && a > 0 && b > 0};
}

}  // namespace

Direction unit(double x, double y) {
  const double length = std::sqrt(x * x + y * y);
  return {x / length, y / length};
}

double DenseShape::height(const Direction& n) const {
  const double x = a * (ux * n.x + uy * n.y), y = b * (ux * n.y - uy * n.x);
  return curved ? std::sqrt(x * x + y * y) : std::abs(x) + std::abs(y);
}

Direction DenseShape::world(double x, double y) const { return unit(x * ux - y * uy, x * uy + y * ux); }

DenseShape dense_shape(int kind, const properties::Numbers& n) {
  switch (kind) {
    case VESICA_POINT:
      return of_centre(n[0], n[1], 1, 0, 0, 0, false);
    case VESICA_SEGMENT: {
      const double dx = n[2] - n[0], dy = n[3] - n[1], cx = (n[0] + n[2]) / 2, cy = (n[1] + n[3]) / 2;
      return dx == 0 && dy == 0 ? of_centre(cx, cy, 1, 0, 0, 0, false) : of_centre(cx, cy, dx, dy, 0.5, 0, false);
    }
    case VESICA_CIRCLE:
      return of_centre(n[0], n[1], 1, 0, n[2], n[2], true);
    case VESICA_AABB:
      return of_centre((n[0] + n[2]) / 2, (n[1] + n[3]) / 2, 1, 0, (n[2] - n[0]) / 2, (n[3] - n[1]) / 2, false);
    default:
      return of_centre(n[0], n[1], n[2], n[3], n[4], n[5], kind == VESICA_ELLIPSE);
  }
}

double DensePair::operator()(const Direction& n) const {
  return a.height(n) + sign * b.height(n) - (n.x * dx + n.y * dy);
}

std::vector<Bracket> local_minima(const DensePair& f) {
  std::vector<Bracket> found;
  std::vector<double> values;
  Ring ring;
  find_minima(f, even_ring(), values, found);
  for (const DenseShape* s : {&f.a, &f.b}) {
    add_normals(*s, ring);
    find_minima(f, ring, values, found);
    add_geometric(*s, ring);
    find_minima(f, ring, values, found);
  }
  return found;
}

double refine(const DensePair& f, Bracket& bracket) {
  constexpr double golden = 0.38196601125010515;
  Direction a = bracket.before, b = bracket.after;
  const auto on_chord = [&](double t) { return unit(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)); };
  double best = bracket.value;
  // Both points anew each time: kept ones drift from their places on the chord, and the more so the longer they are
  // kept.
  for (int i = 0; i < 50; ++i) {
    const Direction low = on_chord(golden), high = on_chord(1 - golden);
    const double f_low = f(low), f_high = f(high);
    if (std::min(f_low, f_high) < best) {
      best = std::min(f_low, f_high);
      bracket.at = f_low < f_high ? low : high;
    }
    (f_low < f_high ? b : a) = f_low < f_high ? high : low;
  }
  return best;
}

double dense_minimum(const DensePair& f) {
  double best = HUGE_VAL;
  for (Bracket& bracket : local_minima(f)) best = std::min(best, refine(f, bracket));
  return best;
}

}  // namespace outline_reference
