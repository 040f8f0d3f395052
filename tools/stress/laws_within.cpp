// SPDX-License-Identifier: Apache-2.0
// Within a distance, and signed distances: against overlap, distances and depths, and the oracle where it is exact.
#include <vesica.h>

#include <cmath>

#include "oracle/distance.hpp"
#include "stress/exact_stage.hpp"
#include "stress/laws.hpp"

namespace stress {
namespace {

constexpr double u = 0x1p-53, last_place = 0x1p-1074;

bool are_ellipses(const Pair& p) {
  return p.kind_a == VESICA_ELLIPSE && has_area(p.kind_a, p.a) && p.kind_b == VESICA_ELLIPSE && has_area(p.kind_b, p.b);
}

void demand_code(Judge& j, const char* law, std::int32_t expected, std::int32_t got) {
  if (expected != got) j.demand(false, law, std::to_string(expected), std::to_string(got));
}

/// A certain answer agrees with the distance, whose error is 4 u times the scale at most; an uncertain one is near it.
void demand_of_nearest(Judge& j, const Case& c, std::int32_t code) {
  const Answer nearest = ask(Query::nearest, Scalar::f64, c.pair);
  const double scale = 2 * extent(c.pair);
  if (nearest.code != 0 || !(scale < 0x1p1000)) return;
  const double d = nearest.numbers[0], room = 16 * u * scale + 8 * last_place;
  if (code == VESICA_WITHIN_YES) j.demand(d <= c.distance + room, "yes_is_near", c.distance, d);
  if (code == VESICA_WITHIN_NO) j.demand(d >= c.distance - room, "no_is_far", c.distance, d);
  if (code == VESICA_WITHIN_NEARLY) j.demand(std::fabs(d - c.distance) <= room, "nearly", c.distance, d);
}

/// True if no bound on the depth is stated.
bool is_thin(int kind, const Numbers& n) {
  const bool is_box = kind == VESICA_AABB;
  if (!is_box && !properties::has_axis(kind)) return false;
  const double a = is_box ? n[2] - n[0] : n[4], b = is_box ? n[3] - n[1] : n[5];
  return std::fmax(a, b) > 1e6 * std::fmin(a, b);
}

/// Shapes are at least so deep in one another, by the negative distance, iff their depth is, but for its error.
void demand_of_depth(Judge& j, const Case& c) {
  const Answer depth = ask(Query::depth, Scalar::f64, c.pair);
  const double asked = c.distance, scale = 2 * extent(c.pair);
  Case deep = c;
  deep.distance = -asked;
  const std::int32_t code = ask(deep).code;
  deep.pair = swapped(c.pair);
  demand_code(j, "deep_exchanged", code, ask(deep).code);
  if (depth.code != 0 || !(scale < 0x1p1000) || is_thin(c.pair.kind_a, c.pair.a) || is_thin(c.pair.kind_b, c.pair.b)) {
    return;
  }
  const double d = depth.numbers[0], room = 16 * u * (scale + asked) + 8 * last_place;
  if (code == VESICA_WITHIN_YES) j.demand(d >= asked - room && d > 0, "yes_is_deep", asked, d);
  if (code == VESICA_WITHIN_NO) j.demand(d <= asked + room, "no_is_shallow", asked, d);
  if (code == VESICA_WITHIN_NEARLY) j.demand(std::fabs(d - asked) <= room && d > 0, "nearly_deep", asked, d);
}

}  // namespace

void judge_within(Judge& j, const Case& c, Effort effort) {
  const std::int32_t code = ask(c).code;
  demand_code(j, "exchanged", code, ask({c.query, c.scalar, swapped(c.pair), c.motion, c.distance}).code);
  const bool overlap = exact_overlap(c.pair) == 1;
  if (overlap) demand_code(j, "overlap_is_within", VESICA_WITHIN_YES, code);
  if (c.distance == 0) return demand_code(j, "of_0_is_overlap", overlap, code);
  if (!are_ellipses(c.pair)) j.demand(code == 0 || code == 1, "certain", "0 or 1", std::to_string(code));
  demand_of_nearest(j, c, code);
  if (!has_wild_radius(c.pair)) demand_of_depth(j, c);
  if (code == VESICA_WITHIN_YES) {
    Case further = c;
    further.distance = properties::nearest(c.scalar, 1.5 * c.distance);
    if (std::isfinite(further.distance)) demand_code(j, "further", VESICA_WITHIN_YES, ask(further).code);
  }
  if (c.scalar == Scalar::f32) {
    demand_code(j, "float_is_double", ask({c.query, Scalar::f64, c.pair, c.motion, c.distance}).code, code);
  }
  if (effort == Effort::slow && !are_ellipses(c.pair)) {
    const Pair& p = c.pair;
    demand_code(j, "oracle", oracle::within(p.kind_a, p.a.data(), p.kind_b, p.b.data(), c.distance), code);
  }
}

void judge_signed_distance(Judge& j, const Case& c, Effort) {
  const Answer r = ask(c), back = ask({c.query, c.scalar, swapped(c.pair)});
  j.demand(same_bits(r, back), "exchanged", text(r), text(back));
  const bool disjoint = exact_overlap(c.pair) == 0;
  const Answer part = ask(disjoint ? Query::nearest : Query::depth, c.scalar, c.pair);
  j.demand((r.code < 0) == (part.code < 0), "code", text(part), text(r));
  if (r.code < 0) return;
  const double expected = disjoint ? part.numbers[0] : -part.numbers[0];
  j.demand(r.numbers[0] == expected, disjoint ? "is_distance" : "is_depth", expected, r.numbers[0]);
  j.demand((r.numbers[0] > 0) == disjoint, "sign", disjoint ? "> 0" : "<= 0", text(r));
}

}  // namespace stress
