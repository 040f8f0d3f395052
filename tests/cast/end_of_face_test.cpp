// SPDX-License-Identifier: Apache-2.0
/// Contact where a face ends: the search must not mistake that end for the other one.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "cast/face.hpp"
#include "properties/random.hpp"

namespace {

using namespace cast_test;
using properties::Random;

/// Its leftmost point is (x, y).
Numbers round_shape(int kind, double x, double y, Random& random) {
  const double r = std::ldexp(random.integer(1, 64), -random.integer(0, 24));
  if (kind == VESICA_CIRCLE) return {x + r, y, r};
  return {x + r, y, 1, 0, r, std::ldexp(random.integer(1, 64), -random.integer(0, 12))};
}

double radius_of_curvature(int kind, const Numbers& n) { return kind == VESICA_CIRCLE ? n[2] : n[5] * n[5] / n[4]; }

class CastAtEndOfFace : public testing::TestWithParam<int> {};  // the round shape

TEST_P(CastAtEndOfFace, ThePointIsThere) {
  Random random(properties::seed() + 71);
  for (int i = 0; i < 6000 * properties::repeat(); ++i) {
    // It meets the right face of a box within a few last places of its upper end.
    const double top = random.integer(1, 64) / 16.0, way = random.integer(1, 64) / 64.0;
    const double vy = std::ldexp(random.integer(-1024, 1024), -10), y = top - vy * way;
    const double beside = y + random.integer(-4, 4) * std::ldexp(y == 0 ? 1 : y, -52);
    const Pair pair{VESICA_AABB, GetParam(), {-1, 0, 0, top}, round_shape(GetParam(), way, beside, random)};
    const bool swaps = random.chance(0.5);
    const Motion m{swaps ? 1.0 : -1.0, swaps ? -vy : vy, infinity};
    SCOPED_TRACE(describe(swaps ? swapped(pair) : pair, m));
    const Answer found = cast(Scalar::f64, swaps ? swapped(pair) : pair, m);
    ASSERT_EQ(found.code, VESICA_CAST_HIT);
    EXPECT_NEAR(found.t, way, 0x1p-44);
    const double rest_x = swaps ? way : 0, rest_y = swaps ? way * -vy : 0;  // where the box is then
    const double error = swaps ? 0x1p-40 + 0x1p-49 * radius_of_curvature(pair.kind_b, pair.b) : 0x1p-40;
    EXPECT_NEAR(found.x, rest_x, error);
    EXPECT_NEAR(found.y, rest_y + top, error);
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Cast, CastAtEndOfFace, testing::Values(VESICA_CIRCLE, VESICA_ELLIPSE),
                         [](const auto& test) { return std::string(vesica_kind_name(test.param)); });

TEST(CastAtEndOfFace, OfFacesNearlyParallel) {
  const Pair pair{VESICA_AABB, VESICA_SEGMENT, {0, -1, 4, -1}, {0, 0, 1, -0x1p-101}};
  const Answer found = cast(Scalar::f64, pair, {0, -1, infinity});
  ASSERT_EQ(found.code, VESICA_CAST_HIT);
  EXPECT_EQ(found.x, 1);
  EXPECT_EQ(found.y, -1);
}

TEST(CastAtEndOfFace, OfAFaceNearlyAlongTheWay) {
  // Met 2^-47 of its length above its lower end, at an angle of 2^-71.
  const Pair pair{VESICA_SEGMENT, VESICA_POINT, {0, 0, 0, 0x1p-168}, {-0x1p-286, 0}};
  const Answer found = cast(Scalar::f64, pair, {0x1p-240, 0x1p-169, infinity});
  ASSERT_EQ(found.code, VESICA_CAST_HIT);
  EXPECT_EQ(found.x, 0);
  EXPECT_EQ(found.y, 0x1p-215);
  EXPECT_EQ(found.nx, -1);
  EXPECT_EQ(found.ny, 0);
}

TEST(CastAtEndOfFace, OfAnEllipseThinnerThanTheSearchSees) {
  // Beside its long axis, along which the point comes.
  const Pair pair{VESICA_ELLIPSE, VESICA_POINT, {0, 0, 1, 0, 1, 0x1p75}, {0x1.8p-1, 0x1.8p74}};
  for (const bool mirrored : {false, true}) {
    Pair p = pair;
    if (mirrored) p.b[0] = -p.b[0];
    const Answer found = cast(Scalar::f64, p, {0, -0x1p34, infinity});
    ASSERT_EQ(found.code, VESICA_CAST_HIT);
    const double height = 0x1p75 * std::sqrt(1 - 0.75 * 0.75);
    EXPECT_NEAR(found.t, (0x1.8p74 - height) / 0x1p34, 0x1p-10);
    EXPECT_EQ(found.nx, mirrored ? -1 : 1);
    EXPECT_EQ(found.ny, 0);
  }
}

TEST(CastAtEndOfFace, OfAWayThatNearlyGrazes) {
  // By 2^-182 of the ellipse, which the search does not see.
  const Pair pair{VESICA_ELLIPSE, VESICA_POINT, {0x1p-182, 0, 2, 2, 0x1.04p-2, 0x1.38p-1}, {0x1.52p+0, -1}};
  const Answer found = cast(Scalar::f64, pair, {0, 0x1.dc00001p+0, 1});
  ASSERT_EQ(found.code, VESICA_CAST_HIT);
  EXPECT_NEAR(found.x, 0x1.52p+0, 0x1p-50);
  EXPECT_NEAR(found.y, -0.9296875, 0x1p-40);
  EXPECT_NEAR(found.nx, 1, 0x1p-50);
}

TEST(CastAtEndOfFace, OfThinOnesThatWereMistaken) {
  const Pair circle{VESICA_CIRCLE,
                    VESICA_RECT,
                    {0, 0, 0x1.9da487e80eca6p+0},
                    {-0x1.9ce2ae0104453p+0, 0x1.eace1025d17ebp-4, -0x1.d63045b33a07p-4, -0x1.01027fe593ddp+1,
                     0x1.c142a0ad5ff5p-7, 0x1.4666d53b74p-11}};
  const Answer of_circle = cast(Scalar::f64, circle, {1.5, 1, infinity});
  ASSERT_EQ(of_circle.code, VESICA_CAST_HIT);
  // The time is below 2^-53: the corner is where it was.
  const Numbers& n = circle.b;
  const double x = n[0] + n[2] * n[4] - n[3] * n[5], y = n[1] + n[3] * n[4] + n[2] * n[5];
  EXPECT_NEAR(std::fabs(of_circle.x - x), 0, 0x1p-44);
  EXPECT_NEAR(std::fabs(of_circle.y - y), 0, 0x1p-44);

  const Pair ellipse{VESICA_AABB, VESICA_ELLIPSE, {0, 0, 1, .5}, {0x1.0000055p+0, .5, 0, 2, 1, 0x1.53p-23}};
  const Answer of_ellipse = cast(Scalar::f64, ellipse, {-0x1.fb5f9p+0, -0x1.48ff2239p+0, infinity});
  ASSERT_EQ(of_ellipse.code, VESICA_CAST_HIT);
  EXPECT_EQ(of_ellipse.x, 1);
  EXPECT_NEAR(of_ellipse.y, 0.5, 0x1p-29);
}

}  // namespace
