// SPDX-License-Identifier: Apache-2.0
/// Tiny rectangles that move nearly along a segment. The segment's normal times v is less than 2^-106 of its terms, so
/// a twofold sum of them is 0, and the normal was taken for one across v: a contact at about 4 was reported at 2.
#include <gtest/gtest.h>

#include <cmath>

#include "cast/exact_truth.hpp"
#include "properties/random.hpp"

namespace {

using namespace cast_test;

TEST(NearlyParallelCasts, TinyRectBesideSegment) {
  const Pair p{VESICA_SEGMENT,
               VESICA_RECT,
               {0x1.b9e570485919p+1, 0x1.81c9f9b92ffbp+1, 0x1p-106, 0},
               {-0x1.b9e570485919p+1, -0x1.81c9f9b92ffbp+1, 1, 0, 0x1p-118, 0}};
  const double vx = 0x1.b9e570485919p+0, vy = 0x1.81c9f9b92ffbp+0;
  EXPECT_EQ(cast(Scalar::f64, p, {vx, vy, 3}).code, VESICA_CAST_MISS);
  const Answer r = cast(Scalar::f64, p, {vx, vy, 8});
  EXPECT_EQ(r.code, VESICA_CAST_HIT);
  EXPECT_NEAR(r.t, 4, 0x1p-9);
  expect_exact(p, {vx, vy, 8});
}

TEST(NearlyParallelCasts, AgreeWithTheOracle) {
  properties::Random random(properties::seed() + 62);
  int hits = 0, misses = 0;
  for (int i = 0; i < 300 * properties::repeat(); ++i) {
    const double x = random.between(1, 4), y = random.between(1, 4), share = std::ldexp(1, -random.integer(0, 2));
    const auto tiny = [&](int least, int most) {
      return random.sign() * std::ldexp(random.chance(0.5) ? 1 : 1 + random.unit(), -random.integer(least, most));
    };
    const Pair p{VESICA_SEGMENT,
                 VESICA_RECT,
                 {x, y, tiny(96, 112), random.chance(0.5) ? 0 : tiny(96, 112)},
                 {-x, -y, 1, random.chance(0.5) ? 0 : random.between(-1, 1), std::fabs(tiny(100, 125)),
                  random.chance(0.5) ? 0 : std::fabs(tiny(100, 125))}};
    const double end = random.chance(0.3) ? infinity : random.between(0, 8) / share;
    const bool exchanged = random.chance(0.5);
    const double sign = exchanged ? -share : share;
    const std::int32_t code = expect_exact(exchanged ? properties::swapped(p) : p, {sign * x, sign * y, end});
    hits += code == VESICA_CAST_HIT;
    misses += code == VESICA_CAST_MISS;
    if (HasFailure()) return;
  }
  EXPECT_GT(hits, 20 * properties::repeat());
  EXPECT_GT(misses, 20 * properties::repeat());
}

}  // namespace
