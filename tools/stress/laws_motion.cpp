// SPDX-License-Identifier: Apache-2.0
// Shapes that move: contact against the exact stage at the start, the oracle of the whole way, and other ends; times to
// the bit. Boxes about a motion against the bounds of the shape at rest.
#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/motion.hpp"
#include "properties/shape_maker.hpp"
#include "stress/exact_stage.hpp"
#include "stress/laws.hpp"

namespace stress {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double next(Scalar scalar, double x, int by) {
  return properties::at_ordinal(scalar, properties::ordinal(scalar, x) + by);
}

/// How many steps too far out a side may be after its motion.
constexpr double most_steps = 3;

/// From a number of this magnitude to the next one of its type.
double step(Scalar scalar, double x) {
  const bool narrow = scalar == Scalar::f32;
  const double least = narrow ? 0x1p-149 : 0x1p-1074;
  return x == 0 ? least : std::fmax(least, std::ldexp(1, std::ilogb(x) - (narrow ? 23 : 52)));
}

Case ended(Case c, double end) {
  c.motion.end = end;
  return c;
}

/// If exponents are wildly unlike, one may be out of range and the other not.
bool same(const Answer& r, const Answer& s) {
  return r.code == VESICA_E_RANGE || s.code == VESICA_E_RANGE || (r.code == s.code && r.numbers[0] == s.numbers[0]);
}

void demand_same(Judge& j, const char* law, const Answer& r, const Answer& s) {
  j.demand(same(r, s), law, text(r), text(s));
}

bool meets(const Case& c, double time, int less = 0) {
  const Pair& p = c.pair;
  return oracle::meets(p.kind_a, p.a.data(), p.kind_b, p.b.data(), {c.motion.vx, c.motion.vy, time, less});
}

/// Exponents within this of each other keep the oracle's integers short.
bool for_oracle(const Case& c) {
  const Pair& p = c.pair;
  const auto of_moderate_size = [](double x) { return x == 0 || (std::fabs(x) > 0x1p-40 && std::fabs(x) < 0x1p40); };
  for (const Numbers* numbers : {&p.a, &p.b}) {
    for (const double x : *numbers) {
      if (!of_moderate_size(x)) return false;
    }
  }
  return of_moderate_size(c.motion.vx) && of_moderate_size(c.motion.vy);
}

void demand_by_oracle(Judge& j, const Case& c, const Answer& r) {
  const double t = r.numbers[0];
  const int less = is_round(c.pair.kind_a) && is_round(c.pair.kind_b) ? 300 : 6500;
  j.demand((r.code != VESICA_CAST_MISS) == (meets(c, 0) || meets(c, c.motion.end)), "oracle", "otherwise", text(r));
  if (r.code != VESICA_CAST_HIT) return;
  j.demand(t == 0 || !meets(c, t, less), "not_before", "later", text(r));
  const double after = next(c.scalar, t, 1);
  j.demand(meets(c, after, less) || meets(c, t), "before_next", "earlier", text(r));
}

struct Extent {
  double x, y, half_length;
};
Extent extent(int kind, const Numbers& n) {
  const double r = properties::radius(kind, n);
  if (properties::role(kind, 2) == properties::Role::x) {
    return {n[0] / 2 + n[2] / 2, n[1] / 2 + n[3] / 2,
            std::fmax(std::fabs(n[2] / 2 - n[0] / 2), std::fabs(n[3] / 2 - n[1] / 2)) + r};
  }
  const double half = properties::has_axis(kind) ? std::hypot(n[2], n[3]) * std::fmax(n[4], n[5]) : 0;
  return {n[0], n[1], half + r};
}

double aspect(const Numbers& ellipse) { return std::fmax(ellipse[4], ellipse[5]) / std::fmin(ellipse[4], ellipse[5]); }

/// True if v is along (x, y) to 2^-77. Exactness is known only if both are along an axis of the plane.
bool is_nearly_along(double x, double y, const Motion& v) {
  if ((x == 0 && v.vx == 0) || (y == 0 && v.vy == 0)) return false;
  const double longer = std::fmax(std::fabs(x), std::fabs(y)), speed = std::fmax(std::fabs(v.vx), std::fabs(v.vy));
  return std::fabs((x / longer) * (v.vy / speed) - (y / longer) * (v.vx / speed)) < 0x1p-77;
}

/// At so small an angle a face may be mistaken for its neighbour, as vesica_motion.h says.
bool is_nearly_along_a_face(int kind, const Numbers& n, const Motion& v) {
  switch (kind) {
    case VESICA_SEGMENT:
    case VESICA_CAPSULE:
      return is_nearly_along(n[2] / 2 - n[0] / 2, n[3] / 2 - n[1] / 2, v);
    case VESICA_AABB:
      return is_nearly_along(1, 0, v) || is_nearly_along(0, 1, v);
    case VESICA_RECT:
    case VESICA_ROUND_RECT:
      return is_nearly_along(n[2], n[3], v) || is_nearly_along(-n[3], n[2], v);
    default:
      return false;
  }
}

/// The point is on the first outline, and about on the other one: how far that may be off goes with how slowly it
/// comes.
void demand_point(Judge& j, const Case& c, const Answer& r) {
  const double u = c.scalar == Scalar::f64 ? 0x1p-53 : 0x1p-24, x = r.numbers[1], y = r.numbers[2];
  const Extent a = extent(c.pair.kind_a, c.pair.a), b = extent(c.pair.kind_b, c.pair.b);
  const double scale =
      std::fmax(std::fmax(std::fabs(b.x - a.x), std::fabs(b.y - a.y)), std::fmax(a.half_length, b.half_length));
  const Answer off = ask(Query::boundary_distance, c.scalar, {c.pair.kind_a, VESICA_POINT, c.pair.a, {x, y}});
  if (off.code < 0 || !std::isfinite(scale)) return;
  const double rounding = u * (std::fabs(x) + std::fabs(y)) + 4 * step(c.scalar, 0);
  j.demand(off.numbers[0] <= 9 * u * scale + rounding, "point_on_outline", 9 * u * scale, off.numbers[0]);
  if (is_nearly_along_a_face(c.pair.kind_a, c.pair.a, c.motion)) return;
  if (is_nearly_along_a_face(c.pair.kind_b, c.pair.b, c.motion)) return;
  // The other one's place then: as all numbers round, and along the outline.
  const double t = r.numbers[0], vx = c.motion.vx, vy = c.motion.vy, way_x = vx * t, way_y = vy * t;
  const Numbers later = properties::moved(c.pair.kind_b, c.pair.b, {way_x, way_y});
  const double most = std::fmax(std::fabs(vx), std::fabs(vy)), length = std::hypot(vx / most, vy / most);
  const double approach = std::fabs(r.numbers[3] * (vx / most) + r.numbers[4] * (vy / most)) / length - 8 * u;
  const double radius = c.pair.kind_a == VESICA_ELLIPSE ? a.half_length * aspect(c.pair.a) : a.half_length;
  const double place =
      std::fabs(way_x) + std::fabs(way_y) + std::fabs(b.x) + std::fabs(b.y) + std::fabs(x) + std::fabs(y);
  const double most_off = 16 * (u * (scale + place + radius) + most * step(c.scalar, t) + step(c.scalar, 0)) / approach;
  if (!(approach > 0) || !(most_off < scale) || !properties::valid(c.pair.kind_b, later)) return;
  const Answer away = ask(Query::nearest, Scalar::f64, {VESICA_POINT, c.pair.kind_b, {x, y}, later});
  j.demand(away.code < 0 || away.numbers[0] <= most_off, "point_on_other", most_off, away.numbers[0]);
}

/// Between these no time overflows, and no place has more digits than there is room for.
bool is_in_range(const Case& c) {
  const auto is_moderate = [](double x) { return x == 0 || (std::fabs(x) > 0x1p-300 && std::fabs(x) < 0x1p300); };
  const auto all = [&](const Numbers& n) { return std::all_of(n.begin(), n.end(), is_moderate); };
  return all(c.pair.a) && all(c.pair.b) && is_moderate(c.motion.vx) && is_moderate(c.motion.vy);
}

void demand_hit(Judge& j, const Case& c, const Answer& r) {
  demand_point(j, c, r);
  const double t = r.numbers[0], nx = r.numbers[3], ny = r.numbers[4];
  demand_same(j, "end_at_infinity", r, ask(ended(c, infinity)));
  demand_same(j, "end_after", r, ask(ended(c, next(c.scalar, t, 1))));
  if (t > 0) {
    const Answer before = ask(ended(c, next(c.scalar, t, -1)));
    j.demand(before.code == VESICA_CAST_MISS || before.code == VESICA_E_RANGE, "end_before", "a miss", text(before));
  }
  const double u = c.scalar == Scalar::f64 ? 0x1p-53 : 0x1p-24;
  j.demand(std::fabs(std::hypot(nx, ny) - 1) <= 4 * u, "unit_normal", 1, std::hypot(nx, ny));
  const double most = std::fmax(std::fabs(c.motion.vx), std::fabs(c.motion.vy));
  const double against = nx * (c.motion.vx / most) + ny * (c.motion.vy / most);
  j.demand(against <= 6 * u, "normal_against_velocity", 0, against);
}

/// A float's time is the double's rounded down.
void demand_rounded_down(Judge& j, const Case& c, const Answer& r) {
  const Answer wide = ask({c.query, Scalar::f64, c.pair, c.motion});
  if (wide.code == VESICA_E_RANGE || r.code == VESICA_E_RANGE) return;
  j.demand(wide.code == r.code, "float_code", text(wide), text(r));
  if (r.code != VESICA_CAST_HIT) return;
  const double t = wide.numbers[0];
  auto down = static_cast<float>(t);
  if (static_cast<double>(down) > t) down = std::nextafterf(down, 0);
  j.demand(static_cast<double>(down) == r.numbers[0], "float_time", static_cast<double>(down), r.numbers[0]);
}

/// Shapes outside of the box about the motion are never touched.
void demand_within_sweep(Judge& j, const Case& c, const Answer& r) {
  const Answer at_rest = ask(Query::bounds, c.scalar, c.pair);
  const Answer swept = ask({Query::sweep_bounds, c.scalar, swapped(c.pair), c.motion});
  if (at_rest.code != 0 || swept.code != 0) return;
  const auto &a = at_rest.numbers, &b = swept.numbers;
  const bool apart = a[0] > b[2] || b[0] > a[2] || a[1] > b[3] || b[1] > a[3];
  j.demand(!apart || r.code == VESICA_CAST_MISS, "within_sweep", "a miss", text(r));
}

/// Does the box hold the other, to the bit?
bool holds(const Answer& box, const Answer& other) {
  const auto &a = box.numbers, &b = other.numbers;
  return a[0] <= b[0] && a[1] <= b[1] && a[2] >= b[2] && a[3] >= b[3];
}

/// The first shape at the end of its motion, where that is exact.
bool moved_exactly(const Case& c, Pair& moved) {
  const double x = c.motion.vx * c.motion.end, y = c.motion.vy * c.motion.end;
  if (!std::isfinite(x) || !std::isfinite(y) || !properties::representable(c.scalar, x) ||
      !properties::representable(c.scalar, y)) {
    return false;
  }
  const bool whole = std::fma(c.motion.vx, c.motion.end, -x) == 0 && std::fma(c.motion.vy, c.motion.end, -y) == 0;
  const bool normal = (x == 0 || std::fabs(x) > 0x1p-900) && (y == 0 || std::fabs(y) > 0x1p-900);
  return whole && normal && move_exactly(c.scalar, {c.pair.kind_a, c.pair.kind_a, c.pair.a, c.pair.a}, x, y, moved);
}

}  // namespace

void judge_cast(Judge& j, const Case& c, Effort effort) {
  const Answer r = ask(c);
  if (r.code < 0) {
    j.demand(r.code == VESICA_E_RANGE && !r.wrote && (c.scalar == Scalar::f32 || !is_in_range(c)), "code", "an answer",
             text(r));
    return;
  }
  j.demand((r.code == VESICA_CAST_START) == (exact_overlap(c.pair) == 1), "start", "overlap", text(r));
  const double t = r.numbers[0];
  j.demand(r.code == VESICA_CAST_MISS    ? t == infinity
           : r.code == VESICA_CAST_START ? t == 0
                                         : t >= 0 && t <= c.motion.end,
           "time", "from 0 to the end", text(r));
  const Case other{c.query, c.scalar, swapped(c.pair), {-c.motion.vx, -c.motion.vy, c.motion.end}};
  demand_same(j, "exchanged", r, ask(other));
  if (r.code == VESICA_CAST_HIT) demand_hit(j, c, r);
  const double half = properties::nearest(c.scalar, c.motion.end / 2);
  if (r.code == VESICA_CAST_MISS && half <= c.motion.end) demand_same(j, "shortened_miss", r, ask(ended(c, half)));
  Case q;
  for (const int exponent : {-7, 6}) {
    if (!scale_exactly(c, exponent, q)) continue;
    q.motion.vx = std::ldexp(c.motion.vx, exponent), q.motion.vy = std::ldexp(c.motion.vy, exponent);
    const bool exact =
        std::ldexp(q.motion.vx, -exponent) == c.motion.vx && std::ldexp(q.motion.vy, -exponent) == c.motion.vy &&
        properties::representable(c.scalar, q.motion.vx) && properties::representable(c.scalar, q.motion.vy);
    if (exact) demand_same(j, "scaled", r, ask(q));
  }
  demand_within_sweep(j, c, r);
  if (c.scalar == Scalar::f32) demand_rounded_down(j, c, r);
  if (effort == Effort::slow && for_oracle(c)) demand_by_oracle(j, c, r);
}

void judge_sweep_bounds(Judge& j, const Case& c, Effort) {
  const Answer r = ask(c), at_rest = ask(Query::bounds, c.scalar, c.pair);
  if (r.code != 0) {
    j.demand(r.code == VESICA_E_RANGE && !r.wrote, "code", "0", text(r));
    return;
  }
  j.demand(at_rest.code == 0 && holds(r, at_rest), "at_rest", text(at_rest), text(r));
  const bool stays_x = c.motion.vx == 0 || c.motion.end == 0, stays_y = c.motion.vy == 0 || c.motion.end == 0;
  const auto as_at_rest = [&](bool stays, double v, std::size_t side) {
    const bool same_side = stays || (side < 2 ? v > 0 : v < 0);
    j.demand(!same_side || r.numbers[side] == at_rest.numbers[side], "unmoved_side", at_rest.numbers[side],
             r.numbers[side]);
  };
  for (const std::size_t side : {0U, 2U}) as_at_rest(stays_x, c.motion.vx, side);
  for (const std::size_t side : {1U, 3U}) as_at_rest(stays_y, c.motion.vy, side);
  const Answer shorter = ask(ended(c, properties::nearest(c.scalar, c.motion.end / 2)));
  j.demand(c.motion.end == 0 || (shorter.code == 0 && holds(r, shorter)), "shortened", text(shorter), text(r));
  Pair moved;
  if (!moved_exactly(c, moved)) return;
  const Answer end = ask(Query::bounds, c.scalar, moved);
  if (end.code != 0) return;
  j.demand(holds(r, end), "at_end", text(end), text(r));
  for (std::size_t i = 0; i < 4; ++i) {
    const double start = at_rest.numbers[i], stop = end.numbers[i];
    if (std::fmax(std::fabs(start), std::fabs(stop)) > (c.scalar == Scalar::f32 ? 0x1p120 : 0x1p1000)) continue;
    const double least = i < 2 ? std::fmin(start, stop) : std::fmax(start, stop);
    const double way = (i % 2 == 0 ? c.motion.vx : c.motion.vy) * c.motion.end;
    const double largest = std::fmax(std::fabs(way), std::fmax(std::fabs(start), std::fabs(stop)));
    const double off = std::fabs(r.numbers[i] - least) / step(c.scalar, largest);
    j.demand(off <= most_steps, "steps_out", least, r.numbers[i]);
  }
}

}  // namespace stress
