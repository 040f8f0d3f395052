// SPDX-License-Identifier: Apache-2.0
/// A shape far smaller than the other one is cast as its centre is: the same answer, and nearly the same time, place
/// and normal.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "cast/face.hpp"
#include "properties/random.hpp"

namespace {

using namespace cast_test;
using properties::Random;

/// A shape about (x, y), of about this size, in the order of vesica.h.
Numbers shape(int kind, double x, double y, double size, Random& random) {
  const double angle = 6.3 * random.unit(), c = std::cos(angle), s = std::sin(angle), a = size * (0.5 + random.unit()),
               b = a * (0.2 + 0.8 * random.unit());
  switch (kind) {
    case VESICA_POINT:
      return {x, y};
    case VESICA_SEGMENT:
      return {x - a * c, y - a * s, x + a * c, y + a * s};
    case VESICA_AABB:
      return {x - a, y - b, x + a, y + b};
    case VESICA_CIRCLE:
      return {x, y, a};
    default:
      return {x, y, c, s, a, b};
  }
}

class CastOfUnlikeSizes : public testing::TestWithParam<int> {};  // the larger kind

TEST_P(CastOfUnlikeSizes, TheSmallOneIsCastAsItsCentre) {
  Random random(properties::seed() + 67);
  int hits = 0;
  for (int i = 0; i < 6000 * properties::repeat(); ++i) {
    const double unit = std::ldexp(1, random.integer(-300, 300)), small = std::ldexp(unit, -random.integer(61, 650));
    const double angle = 6.3 * random.unit(), x = 4 * unit * std::cos(angle), y = 4 * unit * std::sin(angle);
    // Its centre stays where it is, as its bounds round.
    const int kind = random.chance(0.5) ? VESICA_CIRCLE : random.chance(0.5) ? VESICA_ELLIPSE : VESICA_RECT;
    const Pair pair{GetParam(), kind, shape(GetParam(), 0, 0, unit, random), shape(kind, x, y, small, random)};
    const Pair of_centre{pair.kind_a, VESICA_POINT, pair.a, {x, y}};
    const double vx = unit * (random.unit() - 0.5) - x, vy = unit * (random.unit() - 0.5) - y;
    const bool swaps = random.chance(0.5);
    const Motion m{swaps ? -vx : vx, swaps ? -vy : vy, infinity};
    SCOPED_TRACE(describe(swaps ? swapped(pair) : pair, m));
    const Answer found = cast(Scalar::f64, swaps ? swapped(pair) : pair, m),
                 wanted = cast(Scalar::f64, swaps ? swapped(of_centre) : of_centre, m);
    ASSERT_EQ(found.code, wanted.code);
    if (found.code != VESICA_CAST_HIT) continue;
    ++hits;
    // In units of the larger shape; the slower it goes against the outline, the farther along that.
    const double approach = std::fabs(found.nx * vx + found.ny * vy) / std::hypot(vx, vy), error = 0x1p-44 / approach;
    EXPECT_NEAR(found.t, wanted.t, error);
    EXPECT_NEAR(found.x / unit, wanted.x / unit, error);
    EXPECT_NEAR(found.y / unit, wanted.y / unit, error);
    EXPECT_NEAR(found.nx, wanted.nx, 8 * error);
    EXPECT_NEAR(found.ny, wanted.ny, 8 * error);
    if (HasFailure()) return;
  }
  EXPECT_GT(hits, 0);
}

class CastAtCorner : public testing::TestWithParam<int> {};  // the box

TEST_P(CastAtCorner, TheSmallOneHitsThatCorner) {
  Random random(properties::seed() + 68);
  for (int i = 0; i < 6000 * properties::repeat(); ++i) {
    // All places are exact.
    const double unit = std::ldexp(1, random.integer(-300, 300)), small = std::ldexp(unit, -random.integer(40, 650));
    const bool is_segment = GetParam() == VESICA_SEGMENT;
    const double x = unit * random.integer(1, 64), y = unit * random.integer(is_segment ? -64 : 1, 64);
    const Numbers box = GetParam() == VESICA_RECT ? Numbers{0, 0, 0, 1, y, x} : Numbers{-x, -y, x, y};
    const double from_x = x + unit * random.integer(1, 64),
                 from_y = y + unit * random.integer(is_segment ? -64 : 0, 64);
    // Ahead of that end of a segment, else its face may be hit first.
    if (is_segment && (from_x - x) * x + (from_y - y) * y <= 0) continue;
    const int kind = random.chance(0.5) ? VESICA_CIRCLE : random.chance(0.5) ? VESICA_ELLIPSE : VESICA_RECT;
    const Pair pair{GetParam(), kind, box, shape(kind, from_x, from_y, small, random)};
    const Motion m{x - from_x, y - from_y, infinity};
    SCOPED_TRACE(describe(pair, m));
    const Answer found = cast(Scalar::f64, pair, m);
    ASSERT_EQ(found.code, VESICA_CAST_HIT);
    const double error = 0x1p-44 + 64 * small / unit;
    EXPECT_NEAR(found.t, 1, error);
    EXPECT_NEAR(found.x / unit, x / unit, 64 * error);
    EXPECT_NEAR(found.y / unit, y / unit, 64 * error);
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Cast, CastAtCorner, testing::Values(VESICA_SEGMENT, VESICA_AABB, VESICA_RECT),
                         [](const auto& test) { return std::string(vesica_kind_name(test.param)); });

INSTANTIATE_TEST_SUITE_P(Cast, CastOfUnlikeSizes,
                         testing::Values(VESICA_SEGMENT, VESICA_AABB, VESICA_RECT, VESICA_CIRCLE, VESICA_ELLIPSE),
                         [](const auto& test) { return std::string(vesica_kind_name(test.param)); });

}  // namespace
