// SPDX-License-Identifier: Apache-2.0
// Nearest points and distances of outlines.
#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "boundary_distance/reference.hpp"
#include "nearest/reference.hpp"
#include "properties/exact_changes.hpp"
#include "stress/exact_stage.hpp"
#include "stress/laws.hpp"

namespace stress {
namespace {

using nearest_reference::Real;
using nearest_reference::Shape;

constexpr double u = 0x1p-53, last_place = 0x1p-1074;

/// (distance, ax, ay, bx, by) of the shapes in the other order, put back.
Answer put_back(Answer answer) {
  std::swap(answer.numbers[1], answer.numbers[3]);
  std::swap(answer.numbers[2], answer.numbers[4]);
  return answer;
}

bool equal_but_for_zeros_signs(const Answer& a, const Answer& b) { return a.code == b.code && a.numbers == b.numbers; }

void demand_symmetry(Judge& j, const Case& c, const Answer& r) {
  const Answer back = put_back(ask(c.query, c.scalar, swapped(c.pair)));
  if (same_bits(r, back)) return;
  j.demand(false, equal_but_for_zeros_signs(r, back) ? "exchanged_zero_sign" : "exchanged", text(r), text(back));
}

void demand_moved(Judge& j, const Case& c, const Answer& r) {
  for (const auto& [x, y] : moves(c.pair)) {
    Pair q;
    if (!move_exactly(c.scalar, c.pair, x, y, q)) continue;
    const Answer moved = ask(c.query, c.scalar, q);
    j.demand(moved.code != 0 || moved.numbers[0] == r.numbers[0], "moved", r.numbers[0], moved.numbers[0]);
  }
}

/// True if the sizes are in the range of the quicker code, and so is the offset of centres.
std::pair<bool, bool> moderate(const Pair& p) {
  const auto sizes = [](int kind, const properties::Numbers& numbers) {
    for (int i = 0; i < properties::field_count(kind); ++i) {
      const double x = numbers[static_cast<std::size_t>(i)];
      if (properties::is_size(properties::role(kind, i)) && !(x >= 0x1p-40 && x <= 0x1p40)) return false;
    }
    return true;
  };
  const double offset = std::fabs(p.b[0] - p.a[0]) + std::fabs(p.b[1] - p.a[1]);
  return {sizes(p.kind_a, p.a) && sizes(p.kind_b, p.b), offset <= 0x1p50};
}

void demand_scaled(Judge& j, const Case& c, const Answer& r) {
  const double least = c.scalar == Scalar::f32 ? 0x1p-120 : 0x1p-1000;
  for (const int exponent : {-3, 5}) {
    const auto a = properties::scaled_exactly({c.pair.kind_a, c.pair.a}, c.scalar, exponent, false);
    const auto b = properties::scaled_exactly({c.pair.kind_b, c.pair.b}, c.scalar, exponent, false);
    if (!a || !b) continue;
    const Pair q{a->kind, b->kind, a->numbers, b->numbers};
    if (moderate(q) != moderate(c.pair)) continue;
    const Answer scaled = ask(c.query, c.scalar, q);
    if (scaled.code != 0 || scaled.numbers[0] <= least || r.numbers[0] <= least) continue;
    const double expected = std::ldexp(r.numbers[0], exponent);
    j.demand(scaled.numbers[0] == expected, "scaled", expected, scaled.numbers[0]);
  }
}

/// The error that every point has.
Real coordinate_rounding(double x, double y) { return Real(u) * (abs(Real(x)) + abs(Real(y))) + 2 * Real(last_place); }

bool is_inflated(int kind) { return kind == VESICA_CAPSULE || kind == VESICA_ROUND_RECT; }
/// The same for the closest point of a shape, whose core's point is rounded before the radius is added.
Real coordinate_rounding(int kind, double x, double y) {
  return (is_inflated(kind) ? 2 : 1) * coordinate_rounding(x, y);
}

std::string in_units(const Real& error, const Real& unit) {
  return unit > 0 ? std::to_string(Real(error / unit).get_d()) : "any of 0";
}

void judge_common_point(Judge& j, const Pair& p, const Shape& a, const Shape& b, const Answer& r) {
  const double x = r.numbers[1], y = r.numbers[2];
  const Real scale = nearest_reference::scale(a, b);
  const Real rounding = coordinate_rounding(std::max(p.kind_a, p.kind_b), x, y);
  for (const Shape* s : {&a, &b}) {
    const Real off = nearest_reference::beyond_outline(*s, x, y, rounding) - rounding;
    j.demand(off <= Real(8 * u) * scale, "common_point", "8 u scale", in_units(off, Real(u) * scale));
  }
}

/// Does the header promise a relative error for this distance?
bool promised_of_itself(const Real& distance, const Real& scale, const Real& aspect) {
  return (aspect <= Real(1e6) && distance > Real(1e-10) * scale) ||
         (aspect <= Real(1000) && distance > Real(1e-14) * scale);
}

void judge_disjoint(Judge& j, const Pair& p, const Shape& a, const Shape& b, const Answer& r) {
  const auto& n = r.numbers;
  const auto exact = nearest_reference::distance(a, b, n[3] - n[1], n[4] - n[2]);
  if (!exact.proved()) return;
  const Real scale = nearest_reference::scale(a, b), error = abs(Real(n[0]) - exact.upper);
  const Real aspect = std::max(nearest_reference::aspect(a), nearest_reference::aspect(b));
  const bool normal = exact.upper > Real(0x1p-1020);
  j.demand(error <= Real(4 * u) * scale + Real(last_place), normal ? "of_scale" : "subnormal_of_scale", "4 u scale",
           in_units(error, Real(u) * scale));
  if (normal && promised_of_itself(exact.upper, scale, aspect)) {
    j.demand(error <= Real(2 * u) * exact.upper, "of_itself", "2 u of itself", in_units(error, Real(u) * exact.upper));
  }
  for (const auto& [s, kind, x, y] : {std::tuple{&a, p.kind_a, n[1], n[2]}, {&b, p.kind_b, n[3], n[4]}}) {
    const Real rounding = coordinate_rounding(kind, x, y);
    const Real off = abs(nearest_reference::beyond_outline(*s, x, y, Real(rounding + Real(u) * scale))) - rounding;
    j.demand(off <= Real(4 * u) * scale, "off_outline", "4 u scale", in_units(off, Real(u) * scale));
  }
}

/// The laws of both queries for a pair with finite results, in double. zero: whether the distance must be 0.
void demand_quick(Judge& j, const Case& c, const Answer& r, bool zero) {
  const auto& n = r.numbers;
  j.demand(zero ? n[0] == 0 : n[0] > 0, "zero", zero ? 0 : 1, n[0]);
  if (zero) j.demand(n[1] == n[3] && n[2] == n[4], "one_common_point", n[1], n[3]);
  const bool finite = std::all_of(n.begin(), n.end(), [](double x) { return std::isfinite(x); });
  j.demand(finite, "finite", "finite numbers", text(r));
  if (!has_wild_radius(c.pair)) demand_symmetry(j, c, r);
  demand_moved(j, c, r);
}

/// True if there is more to check: errors are checked here, and floats by the doubles.
bool has_numbers(Judge& j, const Case& c, const Answer& r) {
  if (r.code != 0) {
    j.demand(r.code == VESICA_E_RANGE && !far_from_overflow(c.scalar, c.pair), "code", "0", text(r));
    return false;
  }
  if (c.scalar == Scalar::f32) demand_rounded(j, c, r, 5);
  return true;
}

/// The references know no infinity.
bool for_reference(const Pair& p, const Answer& r) {
  return far_from_overflow(Scalar::f64, p) &&
         std::all_of(r.numbers.begin(), r.numbers.end(), [](double x) { return std::isfinite(x); });
}

bool outlines_meet(const Pair& p) {
  const std::int32_t relation = exact_relation(p);
  if (relation == VESICA_INSIDE) return !has_area(p.kind_b, p.b);
  if (relation == VESICA_CONTAINS) return !has_area(p.kind_a, p.a);
  return relation != VESICA_DISJOINT;
}

void judge_outline_points(Judge& j, const Pair& p, const Answer& r, double scale) {
  const auto& n = r.numbers;
  set_reference_precision(p, r);
  const Shape a = nearest_reference::shape(p.kind_a, p.a), b = nearest_reference::shape(p.kind_b, p.b);
  const Real unit = Real(u) * Real(scale);
  Real both = 0;
  for (const auto& [s, x, y] : {std::tuple{&a, n[1], n[2]}, {&b, n[3], n[4]}}) {
    const Real rounding = coordinate_rounding(x, y);
    const Real off = abs(nearest_reference::beyond_outline(*s, x, y, Real(rounding + unit))) - rounding;
    j.demand(off <= 12 * unit, n[0] == 0 ? "common_point" : "off_outline", "12 u scale", in_units(off, unit));
    both += rounding;
  }
  if (std::max(nearest_reference::aspect(a), nearest_reference::aspect(b)) > Real(1e6)) return;
  const Real dx = Real(n[3]) - Real(n[1]), dy = Real(n[4]) - Real(n[2]);
  const Real off = abs(Real(sqrt(Real(dx * dx + dy * dy)) - Real(n[0]))) - both - Real(last_place);
  j.demand(off <= 16 * unit, "points_apart", "16 u scale", in_units(off, unit));
}

void judge_nested(Judge& j, const Pair& outer_first, const Answer& r) {
  const auto a = outline_reference::shape(outer_first.kind_a, outer_first.a);
  const auto b = outline_reference::shape(outer_first.kind_b, outer_first.b);
  if (!(outline_reference::aspect(a) <= 1e6 && outline_reference::aspect(b) <= 1e6)) return;
  const double scale = outline_reference::scale(a, b);
  if (!(scale <= 0x1p1020)) return;
  const auto exact = outline_reference::least(a, b, -1).value;
  const Real error = abs(Real(r.numbers[0]) - exact);
  j.demand(error <= Real(4 * u) * Real(scale) + Real(last_place), scale > 0x1p-1018 ? "nested" : "subnormal_nested",
           "4 u scale", in_units(error, Real(u) * Real(scale)) + " u scale, exact " + hex(exact.get_d()));
}

}  // namespace

void set_reference_precision(const Pair& p, const Answer& answer) {
  int low = 9999, high = -9999;
  const auto include = [&](double x) {
    if (x == 0 || !std::isfinite(x)) return;
    low = std::min(low, std::ilogb(x));
    high = std::max(high, std::ilogb(x));
  };
  for (const double x : p.a) include(x);
  for (const double x : p.b) include(x);
  for (const double x : answer.numbers) include(x);
  mpf_set_default_prec(static_cast<mp_bitcnt_t>(704 + 4 * std::max(0, high - low - 64)));
}

void judge_nearest(Judge& j, const Case& c, Effort effort) {
  const Answer r = ask(c.query, c.scalar, c.pair);
  if (!has_numbers(j, c, r)) return;
  const bool overlap = exact_overlap(c.pair) == 1;
  demand_quick(j, c, r, overlap);
  demand_scaled(j, c, r);
  if (effort == Effort::quick || c.scalar == Scalar::f32 || !for_reference(c.pair, r)) return;
  set_reference_precision(c.pair, r);
  const Shape a = nearest_reference::shape(c.pair.kind_a, c.pair.a),
              b = nearest_reference::shape(c.pair.kind_b, c.pair.b);
  if (overlap) {
    judge_common_point(j, c.pair, a, b, r);
  } else {
    judge_disjoint(j, c.pair, a, b, r);
  }
}

void judge_boundary(Judge& j, const Case& c, Effort effort) {
  const Answer r = ask(c.query, c.scalar, c.pair);
  if (!has_numbers(j, c, r)) return;
  demand_quick(j, c, r, outlines_meet(c.pair));
  const std::int32_t relation = exact_relation(c.pair);
  const Answer solid = ask(Query::nearest, c.scalar, c.pair);
  if (solid.code == 0) {
    j.demand(r.numbers[0] >= solid.numbers[0], "at_least_nearest", solid.numbers[0], r.numbers[0]);
    j.demand(relation != VESICA_DISJOINT || r.numbers == solid.numbers, "as_nearest", text(solid), text(r));
  }
  if (effort == Effort::quick || c.scalar == Scalar::f32 || relation == VESICA_DISJOINT) return;
  if (!for_reference(c.pair, r)) return;
  const auto a = outline_reference::shape(c.pair.kind_a, c.pair.a),
             b = outline_reference::shape(c.pair.kind_b, c.pair.b);
  judge_outline_points(j, c.pair, r, outline_reference::scale(a, b));
  if (relation == VESICA_CONTAINS && has_area(c.pair.kind_a, c.pair.a)) judge_nested(j, c.pair, r);
  if (relation == VESICA_INSIDE && has_area(c.pair.kind_b, c.pair.b)) judge_nested(j, swapped(c.pair), r);
}

}  // namespace stress
