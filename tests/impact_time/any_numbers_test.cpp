// SPDX-License-Identifier: Apache-2.0
/// Any numbers at all, of shapes, motions and tolerances: an answer or an error that is documented, what is written is
/// sound, and an error writes nothing. Where nothing turns, no contradiction to vesica_cast.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "impact_time/face.hpp"

namespace {

using properties::Random;

double any_number(Random& random) {
  switch (random.below(6)) {
    case 0:
      return random.integer(-4, 4);
    case 1:
      return std::ldexp(random.between(-1, 1), random.integer(-20, 20));
    case 2:
      return std::bit_cast<double>(random.bits());
    case 3:
      return 0;
    case 4:
      return std::ldexp(random.integer(1, 5), random.integer(-1075, 1022));
    default:
      return random.between(-4, 4);
  }
}

/// Made valid, mostly.
void draw(int kind, double (&n)[6], Random& random) {
  for (double& x : n) x = any_number(random);
  if (random.chance(0.05)) return;
  for (double& x : n) x = std::isfinite(x) ? x : 1;
  if (kind == VESICA_CIRCLE) n[2] = std::fabs(n[2]);
  if (kind == VESICA_AABB && n[0] > n[2]) std::swap(n[0], n[2]);
  if (kind == VESICA_AABB && n[1] > n[3]) std::swap(n[1], n[3]);
  if (kind < VESICA_RECT) return;
  n[4] = std::fabs(n[4]);
  n[5] = std::fabs(n[5]);
  if (n[2] == 0 && n[3] == 0) n[2] = 1;
}

vesica_turn_f64 draw_turn(Random& random, bool turns) {
  vesica_turn_f64 turn{any_number(random), any_number(random), turns ? any_number(random) : 0};
  if (random.chance(0.05)) return turn;
  if (!std::isfinite(turn.vx)) turn.vx = 1;
  if (!std::isfinite(turn.vy)) turn.vy = 1;
  if (!(std::fabs(turn.angle) <= 0x1p20)) turn.angle = 2.5;
  return turn;
}

void expect_sound(std::int32_t code, const vesica_impact_f64& out, double gap) {
  if (code < 0) {
    EXPECT_TRUE(code == VESICA_E_ARGUMENT || code == VESICA_E_SHAPE || code == VESICA_E_RANGE) << code;
    EXPECT_TRUE(out.t == 7 && out.x == 7 && out.y == 7 && out.nx == 7 && out.ny == 7 && gap == 7);
  } else if (code == VESICA_CAST_MISS) {
    EXPECT_TRUE(std::isinf(out.t) && std::isnan(out.x) && std::isnan(gap));
  } else {
    EXPECT_LE(code, VESICA_CAST_NEAR);
    EXPECT_TRUE(out.t >= 0 && out.t <= 1 && gap >= 0 && std::isfinite(gap) && std::isfinite(out.x + out.y));
    EXPECT_NEAR(std::hypot(out.nx, out.ny), 1, 1e-15);
  }
}

TEST(AnyNumbers, AreAnsweredOrRefused) {
  Random random(properties::seed() + 35);
  int answers[4] = {}, refused = 0;
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    const int kind_a = random.below(6), kind_b = random.below(6);
    double a[6], b[6];
    draw(kind_a, a, random);
    draw(kind_b, b, random);
    const bool turns = random.chance(0.7);
    const vesica_turn_f64 still{0, 0, 0}, turn_a = turns ? draw_turn(random, true) : still,
                                          turn_b = draw_turn(random, turns);
    const double tolerance = std::fabs(any_number(random));
    vesica_impact_f64 out{7, 7, 7, 7, 7}, cast{};
    double gap = 7;
    const std::int32_t code = vesica_impact_time_f64(kind_a, a, &turn_a, kind_b, b, &turn_b, tolerance, &out, &gap);
    SCOPED_TRACE(i);
    expect_sound(code, out, gap);
    if (code < 0) {
      ++refused;
      continue;
    }
    ++answers[code];
    const std::int32_t exact = turns ? -1 : vesica_cast_f64(kind_a, a, kind_b, b, turn_b.vx, turn_b.vy, 1, &cast);
    if (exact >= 0) {
      EXPECT_FALSE(code < VESICA_CAST_NEAR && code != exact) << code << " but " << exact;
      EXPECT_FALSE(code != VESICA_CAST_MISS && exact == VESICA_CAST_HIT && out.t > cast.t);
      EXPECT_FALSE(code == VESICA_CAST_NEAR && exact == VESICA_CAST_START);
    }
    if (HasFailure()) FAIL();
  }
  for (const int count : answers) EXPECT_GT(count, 20 * properties::repeat());
  EXPECT_GT(refused, 20 * properties::repeat());
}

}  // namespace
