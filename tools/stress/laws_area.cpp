// SPDX-License-Identifier: Apache-2.0
// Areas: of one shape, shared, and over the union.
#include <vesica.h>

#include <algorithm>
#include <cmath>

#include "area/reference.hpp"
#include "stress/exact_stage.hpp"
#include "stress/laws.hpp"

namespace stress {
namespace {

constexpr double promised = 64, most_aspect = 1e4;

/// Not so small or large anywhere that an area could leave the range.
bool moderate(Scalar scalar, const Pair& p) { return is_moderate(p, scalar == Scalar::f32 ? 0x1p25 : 0x1p200); }

bool inside(std::int32_t relation) { return relation == VESICA_INSIDE || relation == VESICA_INSIDE_TOUCH; }
bool contains(std::int32_t relation) { return relation >= VESICA_CONTAINS; }

Answer area_of(const Case& c, bool of_b) { return ask(Query::shape_area, c.scalar, of_b ? swapped(c.pair) : c.pair); }

/// Shapes for which the reference is made, both within 10^15 of each other and with areas far within the range.
bool for_reference(const Pair& p) {
  const Answer a = ask(Query::shape_area, Scalar::f64, p), b = ask(Query::shape_area, Scalar::f64, swapped(p));
  if (a.code != 0 || b.code != 0) return false;
  const double least = std::fmin(a.numbers[0], b.numbers[0]), most = std::fmax(a.numbers[0], b.numbers[0]);
  return least > 1e-290 && most < 1e290 && most / least < 1e30;
}

void demand_scaled_area(Judge& j, const Case& c, const Answer& r) {
  const double least = c.scalar == Scalar::f32 ? 0x1p-126 : 0x1p-1022;
  Case q;
  for (const int exponent : {-7, 6}) {
    if (!scale_exactly(c, exponent, q)) continue;
    const Answer after = ask(q.query, q.scalar, q.pair);
    const bool zero = r.numbers[0] == 0 && exact_relation(c.pair) <= VESICA_TOUCH;
    if (after.code != 0 || (!zero && (r.numbers[0] < least || after.numbers[0] < least))) continue;
    const double expected = std::ldexp(r.numbers[0], 2 * exponent);
    j.demand(after.numbers[0] == expected, "scaled", expected, after.numbers[0]);
  }
}

}  // namespace

void judge_shape_area(Judge& j, const Case& c, Effort effort) {
  const Answer r = ask(c.query, c.scalar, c.pair);
  const int kind = c.pair.kind_a;
  if (r.code != 0) {
    j.demand(r.code == VESICA_E_RANGE && !moderate(c.scalar, {kind, kind, c.pair.a, c.pair.a}), "code", "0", text(r));
    return;
  }
  if (!has_area(kind, c.pair.a)) return j.demand(r.numbers[0] == 0, "zero", 0, r.numbers[0]);
  if (c.scalar == Scalar::f32) return;  // rounded once from the true area, which need not be the double's rounding
  if (effort == Effort::quick || r.numbers[0] == 0 || has_wild_radius({kind, kind, c.pair.a, c.pair.a})) return;
  const double off = reference::shape_area_error_in_places(kind, c.pair.a.data(), r.numbers[0]);
  j.demand(off <= 0.5, "nearest_number", "0.5 places", std::to_string(off));
}

void judge_area(Judge& j, const Case& c, Effort effort) {
  if (has_wild_radius(c.pair)) return;
  const Answer r = ask(c.query, c.scalar, c.pair);
  const Answer back = ask(c.query, c.scalar, swapped(c.pair));
  j.demand(same_bits(r, back), "exchanged", text(r), text(back));
  const Answer a = area_of(c, false), b = area_of(c, true);
  const std::int32_t relation = exact_relation(c.pair);
  if (relation <= VESICA_TOUCH) j.demand(r.code == 0 && r.numbers[0] == 0, "apart_is_zero", "0", text(r));
  if (inside(relation)) j.demand(same_bits(r, a), "inside", text(a), text(r));
  if (contains(relation)) j.demand(same_bits(r, b), "contains", text(b), text(r));
  if (r.code != 0) {
    j.demand(r.code == VESICA_E_RANGE && !moderate(c.scalar, c.pair), "code", "0", text(r));
    return;
  }
  j.demand(r.numbers[0] >= 0, "not_negative", 0, r.numbers[0]);
  if (a.code == 0) j.demand(r.numbers[0] <= a.numbers[0], "at_most_a", a.numbers[0], r.numbers[0]);
  if (b.code == 0) j.demand(r.numbers[0] <= b.numbers[0], "at_most_b", b.numbers[0], r.numbers[0]);
  const bool areal = has_area(c.pair.kind_a, c.pair.a) && has_area(c.pair.kind_b, c.pair.b);
  if (relation == VESICA_CROSS && areal && moderate(c.scalar, c.pair) && c.scalar == Scalar::f64) {
    j.demand(r.numbers[0] > 0, "positive", 1, r.numbers[0]);
  }
  demand_scaled_area(j, c, r);
  if (effort == Effort::quick || c.scalar == Scalar::f32 || relation != VESICA_CROSS || !areal) return;
  if (!for_reference(c.pair)) return;
  const auto off = reference::deviation(c.pair.kind_a, c.pair.a.data(), c.pair.kind_b, c.pair.b.data(), r.numbers[0]);
  if (off.aspect > most_aspect) return;
  j.demand(off.in_roundoffs <= promised, "accuracy", "64 u aspect area", std::to_string(off.in_roundoffs));
}

void judge_iou(Judge& j, const Case& c, Effort effort) {
  if (has_wild_radius(c.pair)) return;
  const Answer r = ask(c.query, c.scalar, c.pair);
  const Answer back = ask(c.query, c.scalar, swapped(c.pair));
  j.demand(same_bits(r, back), "exchanged", text(r), text(back));
  const bool area_a = has_area(c.pair.kind_a, c.pair.a), area_b = has_area(c.pair.kind_b, c.pair.b);
  const std::int32_t code = area_a || area_b ? 0 : VESICA_E_ARGUMENT;
  j.demand(r.code == code, "code", std::to_string(code), text(r));
  if (r.code != 0) return;
  const std::int32_t relation = exact_relation(c.pair);
  j.demand(r.numbers[0] >= 0 && r.numbers[0] <= 1, "from_0_to_1", 1, r.numbers[0]);
  if (relation == VESICA_EQUAL) j.demand(r.numbers[0] == 1, "equal_is_1", 1, r.numbers[0]);
  if (relation <= VESICA_TOUCH || !area_a || !area_b) j.demand(r.numbers[0] == 0, "apart_is_0", 0, r.numbers[0]);
  Case q;
  for (const int exponent : {-7, 6}) {
    if (!scale_exactly(c, exponent, q)) continue;
    const Answer after = ask(q.query, q.scalar, q.pair);
    j.demand(same_bits(after, r), "scaled", text(r), text(after));
  }
  if (c.scalar == Scalar::f32) return demand_rounded(j, c, r, 1);
  if (effort == Effort::quick || relation <= VESICA_TOUCH || !area_a || !area_b || !for_reference(c.pair)) return;
  const Pair& p = c.pair;
  const long double a = area_of(c, false).numbers[0], b = area_of(c, true).numbers[0];
  const auto found = reference::deviation(p.kind_a, p.a.data(), p.kind_b, p.b.data(), 0);
  if (found.aspect > most_aspect) return;
  const long double least = std::min(a, b), shared = found.share * least, all = a + b - shared;
  const long double allowed = 0x1p-53L * (promised * found.aspect * least / all + 4 * shared / all);
  const long double off = std::fabs(r.numbers[0] - shared / all);
  j.demand(off <= allowed, "accuracy", static_cast<double>(shared / all), r.numbers[0]);
}

}  // namespace stress
