// SPDX-License-Identifier: Apache-2.0
// Penetration depth. What a direction costs is worked out in many digits: it bounds the true depth from above.
#include <vesica.h>

#include <algorithm>
#include <cmath>

#include "boundary_distance/reference.hpp"
#include "stress/exact_stage.hpp"
#include "stress/laws.hpp"

namespace stress {
namespace {

using outline_reference::Real;
using outline_reference::Shape;

constexpr double u = 0x1p-53, last_place = 0x1p-1074;
constexpr unsigned bits = 320;

Real real(double x) { return Real(x, bits); }

/// How far the shape reaches from its centre along a unit vector.
Real reach(const Shape& s, const Real& x, const Real& y) {
  const Real p = s.a * (s.ux * x + s.uy * y), q = s.b * (s.ux * y - s.uy * x);
  return s.radius + (s.curved ? Real(sqrt(Real(p * p + q * q))) : Real(abs(p) + abs(q)));
}

/// How far b must be moved along n / |n|.
Real needed_along(const Shape& a, const Shape& b, double nx, double ny) {
  Real x = real(nx), y = real(ny);
  const Real length = sqrt(Real(x * x + y * y));
  x /= length, y /= length;
  return reach(a, x, y) + reach(b, x, y) - (x * (b.cx - a.cx) + y * (b.cy - a.cy));
}

/// (depth, x, y) for the other order, put back.
bool reversed(const Answer& a, const Answer& b) {
  return a.code == b.code && a.numbers[0] == b.numbers[0] && a.numbers[1] == -b.numbers[1] &&
         a.numbers[2] == -b.numbers[2];
}

void demand_zero(Judge& j, const Pair& p, const Answer& r) {
  const std::int32_t relation = exact_relation(p);
  const bool directed = r.numbers[1] != 0 || r.numbers[2] != 0;
  j.demand(directed == (relation != VESICA_DISJOINT), "directed", relation != VESICA_DISJOINT, directed);
  if (relation <= VESICA_TOUCH) j.demand(r.numbers[0] == 0, "touching_is_zero", 0, r.numbers[0]);
  const bool deep = has_area(p.kind_a, p.a) && has_area(p.kind_b, p.b) && relation >= VESICA_CROSS;
  if (deep) j.demand(r.numbers[0] > 0, "positive", 1, r.numbers[0]);
  j.demand(r.numbers[0] >= 0, "not_negative", 0, r.numbers[0]);
  if (directed) {
    const double length = std::hypot(r.numbers[1], r.numbers[2]);
    j.demand(std::fabs(length - 1) <= 4 * u, "unit_direction", 1, length);
  }
}

void demand_moved(Judge& j, const Case& c, const Answer& r) {
  for (const auto& [x, y] : moves(c.pair)) {
    Pair q;
    if (!move_exactly(c.scalar, c.pair, x, y, q)) continue;
    const Answer moved = ask(c.query, c.scalar, q);
    j.demand(moved.code != 0 || moved.numbers == r.numbers, "moved", text(r), text(moved));
  }
}

void judge_accuracy(Judge& j, const Pair& p, const Answer& r, Effort effort) {
  const Shape a = outline_reference::shape(p.kind_a, p.a), b = outline_reference::shape(p.kind_b, p.b);
  const double scale = outline_reference::scale(a, b);
  if (!(outline_reference::aspect(a) <= 1e6 && outline_reference::aspect(b) <= 1e6 && scale <= 0x1p1020)) return;
  const bool subnormal = scale < 0x1p-1018;
  const Real unit = real(u) * real(scale), allowed = 4 * unit + real(last_place), depth = real(r.numbers[0]);
  const auto in_units = [&](const Real& error) {
    return subnormal ? std::to_string(Real(error / real(last_place)).get_d()) + " last places"
                     : std::to_string(Real(error / unit).get_d()) + " u scale";
  };
  const Real needed = needed_along(a, b, r.numbers[1], r.numbers[2]);
  j.demand(needed - depth <= allowed + 4 * unit, subnormal ? "subnormal_moves_clear" : "moves_clear", "8 u scale",
           in_units(needed - depth));
  if (effort == Effort::quick) return;
  const Real error = abs(Real(depth - outline_reference::least(a, b, 1).value));
  j.demand(error <= allowed, subnormal ? "subnormal_accuracy" : "accuracy", "4 u scale", in_units(error));
}

}  // namespace

void judge_depth(Judge& j, const Case& c, Effort effort) {
  if (has_wild_radius(c.pair)) return;
  const Answer r = ask(c.query, c.scalar, c.pair);
  if (r.code != 0) {
    j.demand(r.code == VESICA_E_RANGE && !far_from_overflow(c.scalar, c.pair), "code", "0", text(r));
    return;
  }
  const bool finite = std::all_of(r.numbers.begin(), r.numbers.end(), [](double x) { return std::isfinite(x); });
  j.demand(finite, "finite", "finite numbers", text(r));
  const Answer back = ask(c.query, c.scalar, swapped(c.pair));
  const bool equal = exact_relation(c.pair) == VESICA_EQUAL;
  j.demand(reversed(r, back) || (equal && r.numbers[0] == back.numbers[0]), "exchanged", text(r), text(back));
  if (c.scalar == Scalar::f32) return demand_rounded(j, c, r, 3);
  demand_zero(j, c.pair, r);
  demand_moved(j, c, r);
  if (finite && far_from_overflow(Scalar::f64, c.pair) && (r.numbers[1] != 0 || r.numbers[2] != 0))
    judge_accuracy(j, c.pair, r, effort);
}

}  // namespace stress
