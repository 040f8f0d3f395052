// SPDX-License-Identifier: Apache-2.0
// Convex polygons that move and turn: no contact before the time, by exact overlap of sampled poses, which are shrunk
// so as to lie within the true ones; laws; what is refused.
#include <gtest/gtest.h>
#include <vesica_measures.h>
#include <vesica_motion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "impact_time/face.hpp"
#include "polygon/shapes.hpp"

namespace polygon_turning {

using namespace polygons;
using impact_time_test::Numbers;
using impact_time_test::Placed;
using impact_time_test::placed_at;
using impact_time_test::Turn;

/// A polygon, or a shape of another kind.
struct Given {
  std::int32_t kind = VESICA_POLYGON;
  Path path;
  Numbers numbers{};

  bool is_path() const { return kind >= VESICA_POLYGON; }
};

struct Answer {
  std::int32_t code;
  vesica_impact_f64 impact;
  double gap;
};
inline Answer ask(const Given& a, const Turn& turn_a, const Given& b, const Turn& turn_b, double tolerance) {
  Answer r{0, {7, 7, 7, 7, 7}, 7};
  const auto path_a = a.path.view(), path_b = b.path.view();
  const void* const first = a.is_path() ? static_cast<const void*>(&path_a) : a.numbers.data();
  const void* const second = b.is_path() ? static_cast<const void*>(&path_b) : b.numbers.data();
  const vesica_turn_f64 p{turn_a.vx, turn_a.vy, turn_a.angle}, q{turn_b.vx, turn_b.vy, turn_b.angle};
  r.code = vesica_impact_time_f64(a.kind, first, &p, b.kind, second, &q, tolerance, &r.impact, &r.gap);
  return r;
}

/// The shape at t, its sizes times 1 + grown.
inline Given posed(const Given& s, const Turn& turn, double t, double grown) {
  Given out = s;
  if (!s.is_path()) {
    const Placed placed = placed_at(s.kind, s.numbers, turn, t, grown);
    out.kind = placed.kind;
    out.numbers = placed.numbers;
    return out;
  }
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  for (std::size_t i = 0; i < s.path.xy.size(); ++i) {
    low[i % 2] = std::min(low[i % 2], s.path.xy[i]);
    high[i % 2] = std::max(high[i % 2], s.path.xy[i]);
  }
  const long double x = 0.5 * (low[0] + high[0]), y = 0.5 * (low[1] + high[1]), time = t,
                    angle = static_cast<long double>(turn.angle) * time, c = std::cos(angle), k = std::sin(angle),
                    size = 1 + static_cast<long double>(grown);
  for (std::size_t i = 0; i < s.path.xy.size(); i += 2) {
    const long double px = size * (static_cast<long double>(s.path.xy[i]) - x),
                      py = size * (static_cast<long double>(s.path.xy[i + 1]) - y);
    out.path.xy[i] = static_cast<double>(x + time * static_cast<long double>(turn.vx) + c * px - k * py);
    out.path.xy[i + 1] = static_cast<double>(y + time * static_cast<long double>(turn.vy) + k * px + c * py);
  }
  return out;
}
template <class Ask>
auto with(const Given& a, const Given& b, Ask query) {
  const auto path_a = a.path.view(), path_b = b.path.view();
  return query(a.kind, a.is_path() ? static_cast<const void*>(&path_a) : a.numbers.data(), b.kind,
               b.is_path() ? static_cast<const void*>(&path_b) : b.numbers.data());
}
inline bool overlap(const Given& a, const Given& b) { return with(a, b, vesica_overlap_f64) == 1; }
inline double distance(const Given& a, const Given& b) {
  return with(a, b, [](auto... shapes) {
    vesica_closest_points_f64 c{};
    EXPECT_EQ(vesica_nearest_f64(shapes..., &c), 0);
    return c.distance;
  });
}

/// Vertices on an ellipse: convex, of any number; sometimes a segment or a point.
inline Given draw_polygon(Random& random) {
  Given s;
  const int n = random.chance(0.1) ? random.integer(1, 2) : random.integer(3, 12);
  const double x = random.between(-3, 3), y = random.between(-3, 3), a = random.between(0.3, 1),
               b = random.chance(0.3) ? 0.1 : random.between(0.3, 1), turn = random.between(0, 6.28);
  std::vector<double> angles, ring;
  for (int i = 0; i < n; ++i) angles.push_back(6.283185307179586 * (i + random.between(0, 0.8)) / n);
  for (const double angle : angles) {
    const double p = a * std::cos(angle), q = b * std::sin(angle);
    ring.insert(ring.end(), {x + std::cos(turn) * p - std::sin(turn) * q, y + std::sin(turn) * p + std::cos(turn) * q});
  }
  s.path.add_ring(ring);
  if (n < 3 && random.chance(0.5)) s.kind = VESICA_POLYLINE;
  return s;
}
inline Given draw_other(Random& random) {
  if (random.chance(0.3)) return draw_polygon(random);
  const double x = random.between(-3, 3), y = random.between(-3, 3), a = random.between(0.3, 1),
               b = random.between(0.2, 1), turn = random.between(0, 6.28), ux = std::cos(turn), uy = std::sin(turn);
  Given s;
  s.kind = random.below(8);
  switch (s.kind) {
    case VESICA_POINT:
      s.numbers = {x, y};
      break;
    case VESICA_SEGMENT:
      s.numbers = {x - a, y - b, x + a, y + b};
      break;
    case VESICA_CIRCLE:
      s.numbers = {x, y, a};
      break;
    case VESICA_AABB:
      s.numbers = {x - a, y - b, x + a, y + b};
      break;
    case VESICA_CAPSULE:
      s.numbers = {x - a, y - b, x + a, y + b, 0.3};
      break;
    case VESICA_ROUND_RECT:
      s.numbers = {x, y, ux, uy, a, b, 0.2};
      break;
    default:
      s.numbers = {x, y, ux, uy, a, b};
  }
  return s;
}

struct Case {
  Given a, b;
  Turn turn_a, turn_b;
  double tolerance;
};
inline Case draw_case(Random& random) {
  Case c{draw_polygon(random), draw_other(random), {}, {}, std::pow(10, -random.between(1, 10))};
  if (random.chance(0.3)) std::swap(c.a, c.b);
  const double spin = std::array{0.0, 1.0, 6.3, 40.0}[static_cast<std::size_t>(random.below(4))];
  vesica_closest_points_f64 near_each{};
  with(c.a, c.b, [&](auto... shapes) { return vesica_nearest_f64(shapes..., &near_each); });
  c.turn_b = {random.between(-8, 8), random.between(-8, 8), random.between(-spin, spin)};
  if (random.chance(0.6)) {
    c.turn_b.vx = 1.5 * (near_each.ax - near_each.bx) + random.between(-1, 1);
    c.turn_b.vy = 1.5 * (near_each.ay - near_each.by);
  }
  if (random.chance(0.6)) c.turn_a = {random.between(-2, 2), random.between(-2, 2), random.between(-spin, spin)};
  return c;
}
inline bool cores_overlap(const Case& c, double t) {
  return overlap(posed(c.a, c.turn_a, t, -0x1p-40), posed(c.b, c.turn_b, t, -0x1p-40));
}

TEST(PolygonTurning, Known) {
  Given square, away, corner;
  square.path.add_ring({-1, -1, 1, -1, 1, 1, -1, 1});
  away.path.add_ring({4, -1, 6, -1, 6, 1, 4, 1});
  corner.path.add_ring({5, 0, 6, -1, 7, 0, 6, 1});
  const Turn still{0, 0, 0};
  Answer r = ask(square, still, away, {-4, 0, 0}, 1e-9);
  EXPECT_EQ(r.code, VESICA_CAST_HIT);
  EXPECT_NEAR(r.impact.t, 0.75, 1e-9);
  EXPECT_LE(r.impact.t, 0.75);
  EXPECT_EQ(r.impact.nx, 1);
  EXPECT_EQ(ask(square, still, away, {-2.999, 0, 0}, 1e-9).code, VESICA_CAST_MISS);
  EXPECT_EQ(ask(square, still, away, {-5, 2.5, 0}, 1e-9).code, VESICA_CAST_HIT);
  EXPECT_EQ(ask(square, still, away, {0, 9, 31}, 1e-9).code, VESICA_CAST_MISS);
  // Turned by an eighth, a corner of the square reaches the square root of 2.
  EXPECT_EQ(ask(square, {0, 0, 1.5707963267948966}, corner, {-3.6, 0, 0}, 1e-9).code, VESICA_CAST_MISS);
  r = ask(square, {0, 0, 6.2831853071795862}, corner, {-4.2, 0, 0}, 1e-9);
  EXPECT_EQ(r.code, VESICA_CAST_HIT);
  EXPECT_GT(r.impact.t, 0.84);
  EXPECT_LT(r.impact.t, 0.875);
  r = ask(square, still, square, {1, 0, 0}, 1e-9);
  EXPECT_EQ(r.code, VESICA_CAST_START);
  EXPECT_EQ(r.gap, 0);
}

TEST(PolygonTurning, Refused) {
  Given square, bent, circle, chain;
  square.path.add_ring({-1, -1, 1, -1, 1, 1, -1, 1});
  bent.path.add_ring({9, 0, 12, 0, 12, 3, 11, 1});
  chain.kind = VESICA_POLYLINE;
  chain.path.add_ring({9, 0, 12, 0, 12, 3});
  circle.kind = VESICA_CIRCLE;
  circle.numbers = {5, 0, -1};
  const Turn still{0, 0, 0}, move{1, 0, 1};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](const Answer& r, std::int32_t code) {
    EXPECT_EQ(r.code, code);
    EXPECT_EQ(r.impact.t, 7);
    EXPECT_EQ(r.gap, 7);
  };
  refused(ask(square, still, bent, move, 0.1), VESICA_E_NOT_CONVEX);
  refused(ask(bent, still, square, move, 0.1), VESICA_E_NOT_CONVEX);
  refused(ask(square, still, chain, move, 0.1), VESICA_E_NOT_CONVEX);
  refused(ask(circle, still, square, move, 0.1), VESICA_E_SHAPE);
  refused(ask(square, still, square, move, 0), VESICA_E_ARGUMENT);
  refused(ask(square, {nan, 0, 0}, square, move, 0.1), VESICA_E_ARGUMENT);
  refused(ask(square, {0, 0, 0x1p21}, square, move, 0.1), VESICA_E_ARGUMENT);
  square.path.xy[3] = nan;
  refused(ask(square, still, bent, move, 0.1), VESICA_E_SHAPE);
}

TEST(PolygonTurning, NoneOverlapBefore) {
  Random random(properties::seed() + 91);
  std::array<int, 4> answers{};
  int unseen = 0, near_enough = 0, ends = 0;
  const int cases = 20000 * properties::repeat();
  for (int i = 0; i < cases; ++i) {
    const Case c = draw_case(random);
    SCOPED_TRACE(i);
    const Answer r = ask(c.a, c.turn_a, c.b, c.turn_b, c.tolerance);
    ASSERT_GE(r.code, 0);
    ++answers[static_cast<std::size_t>(r.code)];
    ASSERT_EQ(r.code == VESICA_CAST_START, overlap(c.a, c.b));
    if (r.code == VESICA_CAST_START) continue;
    const double t = r.code == VESICA_CAST_MISS ? 1 : r.impact.t;
    for (int k = 0; k < 24; ++k) {
      const double at = k % 2 == 0 ? t * random.unit() : t * (1 - std::pow(10, -random.between(0.5, 15)));
      ASSERT_FALSE(cores_overlap(c, at)) << at << " before " << t;
    }
    if (r.code == VESICA_CAST_MISS) continue;
    ++ends;
    const Given a = posed(c.a, c.turn_a, t, 0), b = posed(c.b, c.turn_b, t, 0);
    ASSERT_LE(distance(a, b), r.gap + 1e-13);
    near_enough += r.gap <= c.tolerance ? 1 : 0;
    Given point;
    point.kind = VESICA_POINT;
    point.numbers = {r.impact.x, r.impact.y};
    ASSERT_LE(distance(a, point), 1e-12);
    ASSERT_NEAR(std::hypot(r.impact.nx, r.impact.ny), 1, 1e-15);
    if (r.code != VESICA_CAST_HIT) continue;
    bool seen = false;
    for (int k = 0; k <= 300 && !seen; ++k) {
      seen = cores_overlap(c, std::min(1.0, t + (1 - t) * (k < 150 ? std::pow(10, -15 + k * 0.1) : (k - 150) / 150.0)));
    }
    unseen += seen ? 0 : 1;
  }
  EXPECT_GT(*std::min_element(answers.begin(), answers.begin() + 3), cases / 20);
  EXPECT_LE(unseen, cases / 200);
  EXPECT_GE(near_enough, ends * 99 / 100);
}

/// Without turns, as a cast says. Rings written in another way, and shapes exchanged, get no other answer.
TEST(PolygonTurning, Laws) {
  Random random(properties::seed() + 92);
  int casts = 0;
  for (int i = 0; i < 6000 * properties::repeat(); ++i) {
    Case c = draw_case(random);
    SCOPED_TRACE(i);
    const Answer r = ask(c.a, c.turn_a, c.b, c.turn_b, c.tolerance);
    const Answer back = ask(c.b, c.turn_b, c.a, c.turn_a, c.tolerance);
    const bool sure = r.code != VESICA_CAST_NEAR && back.code != VESICA_CAST_NEAR;
    if (sure) {
      ASSERT_EQ(r.code, back.code);
    }
    if (r.code != VESICA_CAST_MISS && c.a.is_path() != c.b.is_path()) {
      ASSERT_EQ(r.impact.t, back.impact.t);
      ASSERT_EQ(r.gap, back.gap);
    }
    Case other = c;
    for (Given* s : {&other.a, &other.b}) {
      if (s->kind == VESICA_POLYGON) s->path = rewritten(s->path, random);
    }
    const Answer written = ask(other.a, c.turn_a, other.b, c.turn_b, c.tolerance);
    if (sure && written.code != VESICA_CAST_NEAR) {
      ASSERT_EQ(written.code, r.code);
    }
    // By a power of two, nothing is rounded otherwise.
    const double unit = std::ldexp(1.0, random.integer(-40, 40));
    for (Given* s : {&c.a, &c.b}) {
      for (double& v : s->path.xy) v *= unit;
      for (std::size_t k = 0; k < s->numbers.size(); ++k) {
        const bool is_axis =
            (k == 2 || k == 3) && (s->kind == VESICA_RECT || s->kind == VESICA_ELLIPSE || s->kind == VESICA_ROUND_RECT);
        if (!is_axis) s->numbers[k] *= unit;
      }
    }
    const Answer scaled = ask(c.a, {unit * c.turn_a.vx, unit * c.turn_a.vy, c.turn_a.angle}, c.b,
                              {unit * c.turn_b.vx, unit * c.turn_b.vy, c.turn_b.angle}, unit * c.tolerance);
    ASSERT_EQ(scaled.code, r.code);
    if (r.code != VESICA_CAST_MISS) {
      ASSERT_EQ(scaled.impact.t, r.impact.t);
    }
    vesica_impact_f64 cast{};
    const Turn moves{c.turn_b.vx, c.turn_b.vy, 0};
    const std::int32_t exact =
        with(c.a, c.b, [&](auto... shapes) { return vesica_cast_f64(shapes..., moves.vx, moves.vy, 1, &cast); });
    const Answer straight = ask(c.a, {0, 0, 0}, c.b, moves, unit * c.tolerance);
    if (straight.code == VESICA_CAST_NEAR) {
      ASSERT_NE(exact, VESICA_CAST_START);
    } else {
      ASSERT_EQ(straight.code, exact);
    }
    if (exact == VESICA_CAST_HIT && straight.code != VESICA_CAST_MISS) {
      ASSERT_LE(straight.impact.t, cast.t);
      ++casts;
    }
  }
  EXPECT_GT(casts, 100 * properties::repeat());
}

/// Far from the origin, at vertices that are integers, every number but the place is the same.
TEST(PolygonTurning, FarAway) {
  Random random(properties::seed() + 93);
  int hits = 0;
  for (int i = 0; i < 500 * properties::repeat(); ++i) {
    const auto box = [&](double x, double y) {
      const double w = 2 * random.integer(1, 9), h = 2 * random.integer(1, 9);
      Given s;
      s.path.add_ring({x, y, x + w, y, x + w, y + h, x + w / 2, y + h + 2, x, y + h});
      return s;
    };
    Given a = box(0, 0), b = box(2 * random.integer(6, 12), 2 * random.integer(-6, 6));
    const Turn turn_a{0, 0, random.between(-7, 7)}, turn_b{random.between(-30, 0), random.between(-9, 9), 2};
    const Answer here = ask(a, turn_a, b, turn_b, 1e-6);
    for (Given* s : {&a, &b}) {
      for (double& v : s->path.xy) v += 0x1p50;
    }
    const Answer there = ask(a, turn_a, b, turn_b, 1e-6);
    ASSERT_EQ(here.code, there.code) << i;
    if (here.code == VESICA_CAST_MISS) continue;
    ASSERT_EQ(here.impact.t, there.impact.t) << i;
    ASSERT_EQ(here.gap, there.gap) << i;
    hits += here.code == VESICA_CAST_HIT ? 1 : 0;
  }
  EXPECT_GT(hits, 50 * properties::repeat());
}

TEST(PolygonTurning, InFloat) {
  const std::vector<float> square{-1, -1, 1, -1, 1, 1, -1, 1}, away{4, -1, 6, -1, 6, 1, 4, 1};
  const vesica_polygon_f32 a{square.data(), square.data() + 1, 8, nullptr, 4},
      b{away.data(), away.data() + 1, 8, nullptr, 4};
  const vesica_turn_f32 still{0, 0, 0}, moves{-4, 0, 0};
  vesica_impact_f32 impact{};
  float gap = 0;
  EXPECT_EQ(vesica_impact_time_f32(VESICA_POLYGON, &a, &still, VESICA_POLYGON, &b, &moves, 1e-4F, &impact, &gap),
            VESICA_CAST_HIT);
  EXPECT_LE(impact.t, 0.75F);
  EXPECT_NEAR(impact.t, 0.75F, 1e-4F);
  EXPECT_LE(gap, 1e-4F);
}

}  // namespace polygon_turning
