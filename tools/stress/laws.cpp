// SPDX-License-Identifier: Apache-2.0
#include "stress/laws.hpp"

#include <vesica.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <utility>

#include "properties/exact_changes.hpp"
#include "stress/batches.hpp"

namespace stress {

using properties::Role;

std::string hex(double x) {
  std::array<char, 40> number{};
  std::snprintf(number.data(), number.size(), "%a", x);
  return number.data();
}

void Judge::demand(bool holds, const char* law, double expected, double got) {
  if (!holds) demand(false, law, hex(expected), hex(got));
}

bool valid(const Pair& p) { return properties::valid(p.kind_a, p.a) && properties::valid(p.kind_b, p.b); }

namespace {

double extent_of(int kind, const Numbers& n) {
  double place = 0, axis = 1, size = 0, radius = 0;
  for (int i = 0; i < properties::field_count(kind); ++i) {
    const double x = std::fabs(n[static_cast<std::size_t>(i)]);
    const Role r = properties::role(kind, i);
    if (r == Role::x || r == Role::y) place = std::fmax(place, x);
    if (r == Role::size) size = std::fmax(size, x);
    if (r == Role::radius) radius = x;
  }
  if (properties::has_axis(kind)) axis = std::fabs(n[2]) + std::fabs(n[3]);
  // Products that underflow count as the least number.
  return place + 2 * std::fmax(axis * size, size > 0 ? DBL_TRUE_MIN : 0) + 2 * radius;
}

}  // namespace

double extent(const Pair& p) { return std::fmax(extent_of(p.kind_a, p.a), extent_of(p.kind_b, p.b)); }

bool far_from_overflow(Scalar scalar, const Pair& p) {
  return extent(p) < (scalar == Scalar::f32 ? 0x1p122 : 0x1p1018);
}

bool has_wild_radius(const Pair& p) {
  return (is_inflated(p.kind_a) || is_inflated(p.kind_b)) && !is_moderate(p, 0x1p200);
}

bool move_exactly(Scalar scalar, const Pair& p, double x, double y, Pair& moved) {
  moved = p;
  for (const auto& [kind, n] : {std::pair(p.kind_a, &moved.a), std::pair(p.kind_b, &moved.b)}) {
    for (int i = 0; i < properties::field_count(kind); ++i) {
      const Role r = properties::role(kind, i);
      if (r != Role::x && r != Role::y) continue;
      double& number = (*n)[static_cast<std::size_t>(i)];
      const double by = r == Role::x ? x : y, sum = number + by, part = sum - number;
      if ((number - (sum - part)) + (by - part) != 0 || !properties::representable(scalar, sum)) return false;
      number = sum;
    }
  }
  return true;
}

bool scale_exactly(const Case& c, int exponent, Case& out) {
  const auto a = properties::scaled_exactly({c.pair.kind_a, c.pair.a}, c.scalar, exponent, false);
  const auto b = properties::scaled_exactly({c.pair.kind_b, c.pair.b}, c.scalar, exponent, false);
  if (!a || !b) return false;
  out = {c.query, c.scalar, {a->kind, b->kind, a->numbers, b->numbers}, c.motion, c.distance};
  return true;
}

std::vector<std::array<double, 2>> moves(const Pair& p) {
  const double e = extent(p);
  if (!(e > 0 && e < 0x1p900)) return {};
  const double unit = std::ldexp(1, std::ilogb(e));
  return {{-p.a[0], -p.a[1]}, {unit, -2 * unit}, {unit * 0.0625, unit * -0.1875}};
}

void demand_rounded(Judge& j, const Case& c, const Answer& narrow, std::size_t count) {
  const Answer wide = ask({c.query, Scalar::f64, c.pair, c.motion, c.distance});
  const bool stays_positive =
      c.query == Query::nearest || c.query == Query::boundary_distance || c.query == Query::depth;
  if (narrow.code == VESICA_E_RANGE || wide.code == VESICA_E_RANGE) return;
  j.demand(narrow.code == wide.code, "float_code", std::to_string(wide.code), std::to_string(narrow.code));
  for (std::size_t i = 0; i < count; ++i) {
    double rounded = static_cast<double>(static_cast<float>(wide.numbers[i]));
    if (stays_positive && i == 0 && rounded == 0 && wide.numbers[0] > 0) rounded = 0x1p-149;
    j.demand(rounded == narrow.numbers[i] || narrow.code < 0, "float_is_double_rounded", rounded, narrow.numbers[i]);
  }
}

void judge_environments(Judge& j, const Case& c) {
  const Answer usual = ask(c);
  for (const Environment& environment : environments()) {
    const Answer other = ask(c, environment);
    const std::string law = std::string("environment_") + environment.name;
    j.demand(same_bits(usual, other) && usual.wrote == other.wrote, law.c_str(), text(usual), text(other));
    j.demand(!other.environment_changed, "environment_kept", "as before", environment.name);
  }
}

namespace {

void judge_query(Judge& j, const Case& c, Effort effort) {
  switch (c.query) {
    case Query::overlap:
    case Query::relation:
    case Query::contains:
      return judge_code(j, c, effort);
    case Query::nearest:
      return judge_nearest(j, c, effort);
    case Query::boundary_distance:
      return judge_boundary(j, c, effort);
    case Query::depth:
      return judge_depth(j, c, effort);
    case Query::area:
      return judge_area(j, c, effort);
    case Query::iou:
      return judge_iou(j, c, effort);
    case Query::crossings:
      return judge_crossings(j, c, effort);
    case Query::shape_area:
      return judge_shape_area(j, c, effort);
    case Query::bounds:
      return judge_bounds(j, c, effort);
    case Query::ratio:
      return judge_ratio(j, c, effort);
    case Query::cast:
      return judge_cast(j, c, effort);
    case Query::sweep_bounds:
      return judge_sweep_bounds(j, c, effort);
    case Query::within:
      return judge_within(j, c, effort);
    case Query::signed_distance:
      return judge_signed_distance(j, c, effort);
    case Query::de9im:
      return judge_de9im(j, c, effort);
    case Query::intersection:
      return judge_intersection(j, c, effort);
    default:
      return;
  }
}

}  // namespace

std::vector<Fault> judge(const Case& c, const Choice& choice) {
  Judge j(c.query);
  if (c.query == Query::batch) {
    judge_copies(j, c, choice.environments);
    return j.faults();
  }
  const bool of_valid = of_one_shape(c.query) ? properties::valid(c.pair.kind_a, c.pair.a) : valid(c.pair);
  if ((c.query == Query::invalid) == of_valid) return {};  // a shrinking step too far
  if (c.query == Query::invalid) {
    judge_invalid(j, c, choice.environments);
    return j.faults();
  }
  if (is_refused(c.query, c.pair.kind_a, c.pair.kind_b)) {
    const Answer r = ask(c);
    j.demand(r.code == VESICA_E_KIND && !r.wrote, "refused", std::to_string(VESICA_E_KIND), text(r));
    return j.faults();
  }
  judge_query(j, c, choice.effort);
  if (choice.environments) judge_environments(j, c);
  return j.faults();
}

}  // namespace stress
