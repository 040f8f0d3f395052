// SPDX-License-Identifier: Apache-2.0
// The places where outlines meet.
#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "area/reference.hpp"
#include "crossings/crossing_count.hpp"
#include "nearest/reference.hpp"
#include "stress/exact_stage.hpp"
#include "stress/laws.hpp"

namespace stress {
namespace {

using nearest_reference::Real;

constexpr double u = 0x1p-53;

struct Place {
  double x, y;
  bool operator==(const Place&) const = default;
};
Place place(const Answer& r, int i) {
  const auto k = static_cast<std::size_t>(i);
  return {r.numbers[1 + k], r.numbers[13 + k]};
}

/// A place along an outline: an angle from an ellipse's start. In long double, whose range no product leaves.
double along_ellipse(const Numbers& n, double a, double b, double ux, double uy, const Place& p) {
  const long double dx = static_cast<long double>(p.x) - n[0], dy = static_cast<long double>(p.y) - n[1];
  const auto angle = static_cast<double>(std::atan2((dy * ux - dx * uy) / b, (dx * ux + dy * uy) / a));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

struct Along {
  bool known;
  double turn;  ///< the whole way round
  double (*of)(const Numbers& n, const Place& p);
};

Along along(int kind, const Numbers& n) {
  if (!has_area(kind, n)) return {false, 0, nullptr};
  constexpr double turn = 2 * std::numbers::pi;
  if (kind == VESICA_CIRCLE) {
    return {true, turn, [](const Numbers& s, const Place& p) { return along_ellipse(s, s[2], s[2], 1, 0, p); }};
  }
  if (kind == VESICA_ELLIPSE) {
    return {true, turn, [](const Numbers& s, const Place& p) { return along_ellipse(s, s[4], s[5], s[2], s[3], p); }};
  }
  return {false, 0, nullptr};
}

/// A round shape's start, C + a u, where it takes no rounding to write it.
bool exact_start(int kind, const Numbers& n, Place& start) {
  if (kind == VESICA_CIRCLE) {
    const double x = n[0] + n[2];
    start = {x, n[1]};
    return x - n[0] == n[2] && x - n[2] == n[0];
  }
  if (kind != VESICA_ELLIPSE || !(n[3] == 0 && (n[2] == 1 || n[2] == -1))) return false;
  const double by = n[4] * n[2], x = n[0] + by;
  start = {x, n[1]};
  return x - n[0] == by && x - by == n[0];
}

/// Decided exactly: another place may only round to the start.
bool on_outline(int kind, const Numbers& n, const Place& p) {
  const std::int32_t relation = exact_relation({VESICA_POINT, kind, {p.x, p.y}, n});
  return relation == VESICA_INSIDE_TOUCH || relation == VESICA_EQUAL ||
         (relation == VESICA_INSIDE && !has_area(kind, n));
}

void demand_order(Judge& j, const Pair& p, const Answer& r) {
  const Along line = along(p.kind_a, p.a);
  if (!line.known || r.code < 1) return;
  const double size = p.kind_a == VESICA_CIRCLE ? p.a[2] : std::fmin(p.a[4], p.a[5]) * std::hypot(p.a[2], p.a[3]);
  const double slack = 1e-9 + 256 * (u * extent(p) + std::numeric_limits<double>::denorm_min()) / size;
  if (!(slack < 0.05)) return;
  Place start;
  const bool starts = exact_start(p.kind_a, p.a, start) && on_outline(p.kind_b, p.b, start);
  double last = -1;
  for (int i = 0; i < r.code; ++i) {
    const Place here = place(r, i);
    if (starts && here == start) {
      // Another place may round to the same numbers.
      j.demand(place(r, 0) == start, "start_first", 0, i);
      continue;
    }
    const double at = line.of(p.a, here);
    if (at < slack || at > line.turn - slack) continue;  // either end may be meant
    j.demand(at >= last - slack, "order", last, at);
    last = at;
  }
}

/// Half the chord that two circles have in common, 0 where they have none.
Real half_chord(const Numbers& a, const Numbers& b) {
  const Real dx = Real(b[0]) - a[0], dy = Real(b[1]) - a[1], square = dx * dx + dy * dy;
  if (square == 0) return Real(0);
  const Real ra = Real(a[2]) * a[2], rb = Real(b[2]) * b[2], sum = square + ra - rb;
  const Real h = ra - sum * sum / (4 * square);
  return h > 0 ? Real(sqrt(h)) : Real(0);
}

/// Two circles cross at two places, which may be one number only where they are as near as roundings.
void demand_distinct(Judge& j, const Pair& p, const Answer& r) {
  if (p.kind_a != VESICA_CIRCLE || p.kind_b != VESICA_CIRCLE || r.code != 2 || !(place(r, 0) == place(r, 1)) ||
      !far_from_overflow(Scalar::f64, p)) {
    return;
  }
  set_reference_precision(p, r);
  const bool apart = half_chord(p.a, p.b) > Real(32 * u) * Real(extent(p)) + Real(0x1p-1070);
  j.demand(!apart, "distinct", "places apart", text(r));
}

void demand_rest_zero(Judge& j, const Answer& r) {
  for (int i = r.code; i < 12; ++i) {
    if (!(place(r, i) == Place{0, 0})) return j.demand(false, "rest_is_zero", "0", text(r));
  }
}

/// Each place lies on both outlines, within the error that the header states.
void demand_on_outlines(Judge& j, const Pair& p, const Answer& r) {
  const double size = extent(p);
  if (!(size < 0x1p1000) ||
      std::any_of(r.numbers.begin(), r.numbers.end(), [](double x) { return !std::isfinite(x); })) {
    return;
  }
  const bool round = p.kind_a >= VESICA_CIRCLE && p.kind_b >= VESICA_CIRCLE && p.kind_a != VESICA_AABB &&
                     p.kind_b != VESICA_AABB && p.kind_a != VESICA_RECT && p.kind_b != VESICA_RECT;
  double allowed = 16 * u * size + 0x1p-1073;
  if (round && has_area(p.kind_a, p.a) && has_area(p.kind_b, p.b)) {
    // Outlines that all but coincide.
    const double apart = reference::difference(p.kind_a, p.a.data(), p.kind_b, p.b.data());
    allowed += 0x1p-90 / std::fmax(apart, 0x1p-90) * size;
  }
  set_reference_precision(p, r);
  for (const auto& [kind, n] : {std::pair(p.kind_a, &p.a), std::pair(p.kind_b, &p.b)}) {
    const auto s = nearest_reference::shape(kind, *n);
    for (int i = 0; i < r.code; ++i) {
      const Place here = place(r, i);
      const double off = Real(abs(nearest_reference::beyond_outline(s, here.x, here.y, Real(allowed)))).get_d();
      j.demand(off <= allowed, round ? "off_outline_round" : "off_outline", "16 u extent",
               std::to_string(off / (u * size)) + " u extent");
    }
  }
}

}  // namespace

void judge_crossings(Judge& j, const Case& c, Effort effort) {
  const Answer r = ask(c.query, c.scalar, c.pair);
  if (r.code < 0) {
    j.demand(r.code == VESICA_E_RANGE && !far_from_overflow(c.scalar, c.pair), "code", "0 or more", text(r));
    return;
  }
  const auto are = [&c](int a, int b) { return c.pair.kind_a == a && c.pair.kind_b == b; };
  const bool may_be_more = are(VESICA_ELLIPSE, VESICA_ROUND_RECT) || are(VESICA_ROUND_RECT, VESICA_ELLIPSE);
  const int most = may_be_more ? 12 : 8;
  j.demand(r.code <= most, "at_most", most, r.code);
  if (r.code > most) return;
  demand_rest_zero(j, r);
  const Answer back = ask(c.query, c.scalar, swapped(c.pair));
  j.demand(back.code == VESICA_E_RANGE || (back.code == r.code && back.numbers[0] == r.numbers[0]), "exchanged",
           text(r), text(back));
  if (c.scalar == Scalar::f32) return demand_rounded(j, c, r, most_numbers);
  demand_distinct(j, c.pair, r);
  demand_order(j, c.pair, r);
  const Pair& p = c.pair;
  if (effort == Effort::quick || is_inflated(p.kind_a) || is_inflated(p.kind_b)) return;  // the reference knows no such
  const reference::Meeting truth = reference::meeting(p.kind_a, p.a.data(), p.kind_b, p.b.data());
  j.demand(r.code == truth.count, "count", truth.count, r.code);
  j.demand((r.numbers[0] == 1) == truth.shared, "shared", truth.shared, r.numbers[0]);
  demand_on_outlines(j, p, r);
}

}  // namespace stress
