// SPDX-License-Identifier: Apache-2.0
// Shapes with a radius that move and turn, against their poses at many times.
#include <gtest/gtest.h>
#include <vesica_motion.h>

#include <cmath>

#include "inflated/shapes.hpp"

namespace inflated_impact_time {
namespace {

using namespace inflated;
using properties::Random;

/// The shape at t, as a kind that can turn.
Shape posed(const Shape& s, const vesica_turn_f64& turn, double t) {
  Numbers n = s.number;
  std::int32_t kind = s.kind;
  if (kind == VESICA_AABB) {
    n = {(n[0] + n[2]) / 2, (n[1] + n[3]) / 2, 1, 0, (n[2] - n[0]) / 2, (n[3] - n[1]) / 2};
    kind = VESICA_RECT;
  }
  const double c = std::cos(t * turn.angle), k = std::sin(t * turn.angle), x = t * turn.vx, y = t * turn.vy;
  if (kind == VESICA_SEGMENT || kind == VESICA_CAPSULE) {
    const double mx = (n[0] + n[2]) / 2, my = (n[1] + n[3]) / 2, ux = (n[2] - n[0]) / 2, uy = (n[3] - n[1]) / 2;
    const double vx = c * ux - k * uy, vy = c * uy + k * ux;
    return {kind, {mx + x - vx, my + y - vy, mx + x + vx, my + y + vy, n[4]}};
  }
  n[0] += x;
  n[1] += y;
  if (kind >= VESICA_RECT) {
    const double ux = n[2], uy = n[3];
    n[2] = c * ux - k * uy;
    n[3] = c * uy + k * ux;
  }
  return {kind, n};
}

double signed_distance(const Shape& a, const Shape& b) {
  double out = NAN;
  EXPECT_EQ(vesica_signed_distance_f64(a.kind, a.number.data(), b.kind, b.number.data(), &out), 0);
  return out;
}

TEST(InflatedImpactTime, IsProvedByPoses) {
  Random random(properties::seed());
  constexpr double tolerance = 1e-4;
  int of_code[4] = {};
  for (int i = 0; i < 4000 * properties::repeat(); ++i) {
    const Shape a = any_shape(random), b = inflated_shape(random);
    const auto turn = [&] {
      return vesica_turn_f64{random.between(-4, 4), random.between(-4, 4), random.between(-6, 6)};
    };
    const vesica_turn_f64 of_a = turn(), of_b = turn();
    vesica_impact_f64 at;
    double gap;
    const std::int32_t code =
        vesica_impact_time_f64(a.kind, a.number.data(), &of_a, b.kind, b.number.data(), &of_b, tolerance, &at, &gap);
    ASSERT_GE(code, 0) << i;
    ++of_code[code];
    const auto distance_at = [&](double t) { return signed_distance(posed(a, of_a, t), posed(b, of_b, t)); };
    if (code == VESICA_CAST_START) {
      ASSERT_LE(distance_at(0), 0) << i;
      continue;
    }
    const double end = code == VESICA_CAST_MISS ? 1 : at.t;
    for (int k = 0; k <= 64; ++k) ASSERT_GT(distance_at(k / 64.0 * end), -0x1p-44) << i << " " << k;
    if (code == VESICA_CAST_MISS) continue;
    ASSERT_LE(gap, tolerance);
    ASSERT_LE(distance_at(at.t), gap + 0x1p-44) << i;
    const vesica_point_f64 point{at.x, at.y};
    const Shape there = posed(a, of_a, at.t);
    ASSERT_LE(signed_distance({VESICA_POINT, {point.x, point.y}}, there), 0x1p-44) << i;
    ASSERT_NEAR(std::hypot(at.nx, at.ny), 1, 0x1p-50);
    if (code == VESICA_CAST_HIT) {
      double least = 1;
      for (int k = 0; k <= 1024; ++k) least = std::fmin(least, distance_at(at.t + k / 1024.0 * (1 - at.t)));
      ASSERT_LE(least, tolerance) << i;
    }
  }
  for (const int code : {VESICA_CAST_MISS, VESICA_CAST_HIT, VESICA_CAST_START})
    EXPECT_GT(of_code[code], 10 * properties::repeat());
}

/// Without turns it is the cast.
TEST(InflatedImpactTime, WithoutTurnsIsTheCast) {
  Random random(properties::seed());
  int hits = 0;
  for (int i = 0; i < 2000 * properties::repeat(); ++i) {
    const Shape a = any_shape(random), b = inflated_shape(random);
    const vesica_turn_f64 still{0, 0, 0}, way{random.between(-4, 4), random.between(-4, 4), 0};
    vesica_impact_f64 at, expected;
    double gap;
    constexpr double tolerance = 1e-9;
    const std::int32_t code =
        vesica_impact_time_f64(a.kind, a.number.data(), &still, b.kind, b.number.data(), &way, tolerance, &at, &gap);
    const std::int32_t cast =
        vesica_cast_f64(a.kind, a.number.data(), b.kind, b.number.data(), way.vx, way.vy, 1, &expected);
    ASSERT_TRUE(code == cast || code == VESICA_CAST_NEAR) << i;
    if (cast != VESICA_CAST_HIT) continue;
    ++hits;
    ASSERT_LE(at.t, expected.t);
    const double speed = std::hypot(way.vx, way.vy);
    // The gap closes at the rate of |n.v|.
    const double rate = -(expected.nx * way.vx + expected.ny * way.vy);
    ASSERT_TRUE(rate < 0.1 * speed || at.t >= expected.t - 4 * tolerance / rate) << i;
  }
  EXPECT_GT(hits, 100 * properties::repeat());
}

}  // namespace
}  // namespace inflated_impact_time
