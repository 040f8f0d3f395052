// SPDX-License-Identifier: Apache-2.0
// Ratios of shared area: from the areas and the IoU, whose own laws are in laws_area.cpp, and among each other.
#include <vesica.h>

#include <cmath>

#include "stress/exact_stage.hpp"
#include "stress/laws.hpp"

namespace stress {
namespace {

constexpr double u = 0x1p-53;

double code_of(const Answer& r, std::size_t which) { return r.numbers[ratio_count + which]; }

/// Only if the divisor is an area of 0.
void demand_codes(Judge& j, const Case& c, const Answer& r) {
  const bool a = has_area(c.pair.kind_a, c.pair.a), b = has_area(c.pair.kind_b, c.pair.b);
  for (std::size_t which = 0; which < ratio_count; ++which) {
    const bool divides = which == VESICA_RATIO_OVER_FIRST     ? a
                         : which == VESICA_RATIO_OVER_SECOND  ? b
                         : which == VESICA_RATIO_OVER_SMALLER ? a && b
                                                              : a || b;
    j.demand(code_of(r, which) == (divides ? 0 : VESICA_E_ARGUMENT), "code", "another", text(r));
  }
}

void demand_range(Judge& j, const Answer& r, std::int32_t relation) {
  for (std::size_t which = 0; which < ratio_count; ++which) {
    if (code_of(r, which) != 0) continue;
    const double x = r.numbers[which];
    const double least = which == VESICA_RATIO_COMPLETE ? -2 : which >= VESICA_RATIO_GENERALIZED ? -1 : 0;
    j.demand(x >= least && x <= (least < 0 ? r.numbers[0] : 1), "range", std::to_string(which), text(r));
    if (least == 0 && relation <= VESICA_TOUCH) j.demand(x == 0, "apart_is_0", 0, x);
  }
  j.demand(
      code_of(r, VESICA_RATIO_COMPLETE) != 0 || r.numbers[VESICA_RATIO_COMPLETE] <= r.numbers[VESICA_RATIO_DISTANCE],
      "complete_at_most_distance", r.numbers[VESICA_RATIO_DISTANCE], r.numbers[VESICA_RATIO_COMPLETE]);
}

/// One over a shape is 1 if the other contains it.
void demand_contained(Judge& j, const Answer& r, std::int32_t relation) {
  const bool in_b = relation == VESICA_INSIDE || relation == VESICA_INSIDE_TOUCH || relation == VESICA_EQUAL;
  const bool in_a = relation >= VESICA_CONTAINS && relation != VESICA_INSIDE && relation != VESICA_INSIDE_TOUCH;
  const auto demand_1 = [&](std::size_t which) {
    if (code_of(r, which) == 0) j.demand(r.numbers[which] == 1, "contained_is_1", 1, r.numbers[which]);
  };
  if (in_b) demand_1(VESICA_RATIO_OVER_FIRST);
  if (in_a) demand_1(VESICA_RATIO_OVER_SECOND);
  if (in_a || in_b) demand_1(VESICA_RATIO_OVER_SMALLER);
}

/// Halves of such numbers are exact.
bool far_from_subnormal(const Pair& p) {
  for (const Numbers* numbers : {&p.a, &p.b}) {
    for (const double x : *numbers) {
      if (x != 0 && std::fabs(x) < 0x1p-1000) return false;
    }
  }
  return true;
}

bool moderate(double area) { return area >= 0x1p-400 && area <= 0x1p400; }

/// Within 8 u of the quotient of what the library says of the areas, and its own rounding.
void demand_of_areas(Judge& j, const Case& c, const Answer& r) {
  const Answer shared = ask(Query::area, c.scalar, c.pair);
  const Answer areas[] = {ask(Query::shape_area, c.scalar, c.pair), ask(Query::shape_area, c.scalar, swapped(c.pair))};
  if (shared.code != 0 || !moderate(shared.numbers[0])) return;
  for (std::size_t i = 0; i < 2; ++i) {
    if (areas[i].code != 0 || !moderate(areas[i].numbers[0])) continue;
    const double expected = shared.numbers[0] / areas[i].numbers[0], got = r.numbers[VESICA_RATIO_OVER_FIRST + i];
    j.demand(std::fabs(got - expected) <= 9 * u, "quotient_of_areas", expected, got);
  }
}

}  // namespace

void judge_ratio(Judge& j, const Case& c, Effort) {
  if (has_wild_radius(c.pair)) return;
  const Answer r = ask(c), back = ask({c.query, c.scalar, swapped(c.pair)});
  Answer exchanged_back = back;
  for (const std::size_t i : {std::size_t{0}, ratio_count}) {
    std::swap(exchanged_back.numbers[i + VESICA_RATIO_OVER_FIRST],
              exchanged_back.numbers[i + VESICA_RATIO_OVER_SECOND]);
  }
  j.demand(same_bits(r, exchanged_back), "exchanged", text(r), text(exchanged_back));
  const Answer iou = ask(Query::iou, c.scalar, c.pair);
  j.demand(iou.code == r.code && iou.numbers[0] == r.numbers[0], "over_union", text(iou), text(r));
  const std::int32_t relation = exact_relation(c.pair);
  demand_codes(j, c, r);
  demand_range(j, r, relation);
  demand_contained(j, r, relation);
  Case q;
  for (const int exponent : {-7, 6}) {
    if (!scale_exactly(c, exponent, q) || !far_from_subnormal(c.pair) || !far_from_subnormal(q.pair)) continue;
    const Answer after = ask(q);
    j.demand(same_bits(after, r), "scaled", text(r), text(after));
  }
  if (c.scalar == Scalar::f32) return demand_rounded(j, c, r, ratio_count);
  demand_of_areas(j, c, r);
}

}  // namespace stress
