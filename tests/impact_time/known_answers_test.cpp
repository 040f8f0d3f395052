// SPDX-License-Identifier: Apache-2.0
/// Contacts that can be worked out by hand, among them such as stepping from pose to pose would miss; and what is
/// refused.
#include <gtest/gtest.h>

#include <cmath>

#include "impact_time/face.hpp"

namespace known_answers_test {
namespace {

using namespace impact_time_test;

constexpr double pi = 3.14159265358979323846, nan = std::numeric_limits<double>::quiet_NaN(), infinity = HUGE_VAL;
constexpr Turn still{0, 0, 0};

const Pair bar_and_disc{VESICA_SEGMENT, VESICA_CIRCLE, {-1, 0, 1, 0}, {0, 0.5, 1e-8}};
const Pair bar_and_point{VESICA_SEGMENT, VESICA_POINT, {-1, 0, 1, 0}, {0, 0.5}};
const Pair boxes{VESICA_AABB, VESICA_RECT, {0, 0, 1, 1}, {-5, 0.5, 1, 1, 0.5, 0.5}};

void expect_hit(const Turning& s, double t, double x, double y, double slack) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    const double speed = std::fabs(s.a.vx) + std::fabs(s.b.vx) + std::fabs(s.b.vy) + std::fabs(s.a.angle);
    const double less = scalar == Scalar::f64 ? slack : std::fmax(slack, 1e-5), gap_of_float = 1e-6 * speed;
    const Answer r = impact_time(scalar, s);
    EXPECT_EQ(r.code, VESICA_CAST_HIT);
    EXPECT_LE(r.t, t);
    EXPECT_GE(r.t, t - less);
    EXPECT_NEAR(r.x, x, 2 * less + 4 * s.tolerance);
    EXPECT_NEAR(r.y, y, 2 * less + 4 * s.tolerance);
    EXPECT_LE(r.gap, s.tolerance + (scalar == Scalar::f64 ? 0 : gap_of_float));
  }
}

void expect_miss(const Turning& s) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    const Answer r = impact_time(scalar, s);
    EXPECT_EQ(r.code, VESICA_CAST_MISS);
    EXPECT_EQ(r.t, infinity);
    EXPECT_TRUE(std::isnan(r.x) && std::isnan(r.y) && std::isnan(r.nx) && std::isnan(r.ny) && std::isnan(r.gap));
  }
}

TEST(Known, ABarTurnsOntoADisc) {
  // At a quarter turn, whichever way.
  expect_hit({bar_and_disc, {0, 0, pi}, still, 1e-7}, 0.5, 0, 0.5, 1e-6);
  expect_hit({bar_and_disc, {0, 0, -pi}, still, 1e-7}, 0.5, 0, 0.5, 1e-6);
  expect_miss({bar_and_disc, {0, 0, 1.57}, still, 1e-7});
  // All the way round, so that the ends show nothing.
  expect_hit({bar_and_disc, {0, 0, 2 * pi}, still, 1e-7}, 0.25, 0, 0.5, 1e-6);
  expect_hit({bar_and_disc, {0, 0, 100}, still, 1e-7}, pi / 200, 0, 0.5, 1e-6);
}

/// Shapes that do not move relative to each other never meet, however near they are; a disc may turn about itself.
TEST(Known, NearAndAtRest) {
  for (const double size : {1.0, 0x1p-3, 3.0, 0x1p40, 0x1p-40}) {
    for (const double angle : {0.0, 1.0, -50.0}) {
      const Pair discs{VESICA_CIRCLE, VESICA_CIRCLE, {0, 0, size}, {3 * size, 0, 1.75 * size}};
      const Pair in_box{VESICA_CIRCLE, VESICA_RECT, {0, 0, size}, {2.25 * size, 0, 1, 0, size, size}};
      const Turn a{size, 0, angle}, b{size, 0, 0};
      expect_miss({discs, a, {size, 0, -angle}, size});
      expect_miss({in_box, a, b, size});
      expect_miss({properties::swapped(in_box), b, a, size});
    }
  }
}

/// However long it is, as a segment and as a box.
TEST(Known, ABarOfAnyLengthTurnsOntoADisc) {
  for (const double h : {0.25, 0.5, 1.0, 2.0, 4.0}) {
    const Pair segment{VESICA_SEGMENT, VESICA_CIRCLE, {-h, 0, h, 0}, {0, h / 2, 1e-8}};
    const Pair box{VESICA_RECT, VESICA_CIRCLE, {0, 0, 1, 0, h, 0}, {0, h / 2, 1e-8}};
    expect_hit({segment, {0, 0, pi}, still, 1e-7}, 0.5, 0, h / 2, 2e-6);
    expect_hit({box, {0, 0, pi}, still, 1e-7}, 0.5, 0, h / 2, 2e-6);
  }
}

TEST(Known, ABarTurnsOntoAPoint) {
  // Without area contact is never proved; but it is not missed.
  const Answer r = impact_time(Scalar::f64, {bar_and_point, {0, 0, pi}, still, 1e-7});
  EXPECT_EQ(r.code, VESICA_CAST_NEAR);
  EXPECT_LE(r.t, 0.5);
  EXPECT_GE(r.t, 0.5 - 1e-6);
  expect_miss({bar_and_point, {0, 0, 1.57}, still, 1e-7});
}

TEST(Known, NeedlesThatPassThroughEachOther) {
  // Two thin bars that cross each other's way at speed; before and after they are apart.
  const Pair p{VESICA_RECT, VESICA_RECT, {0, 0, 1, 0, 1, 1e-12}, {3, 100, 0, 1, 1, 1e-12}};
  expect_miss({p, still, {0, -200, 0}, 1e-9});
  const Pair q{VESICA_RECT, VESICA_RECT, {0, 0, 1, 0, 1, 1e-12}, {0.5, 100, 0, 1, 1, 1e-12}};
  expect_hit({q, still, {0, -200, 0}, 1e-9}, 0.495, 0.5, 0, 1e-6);
  const Pair spun{VESICA_ELLIPSE, VESICA_SEGMENT, {0, 0, 1, 0, 1, 0}, {1.5, -1e-6, 1.5, 1e-6}};
  expect_hit({spun, {1, 0, 0}, {0, 0, 0.5}, 1e-9}, 0.5, 1.5, 0, 1e-6);
}

TEST(Known, NothingTurns) {
  expect_hit({boxes, still, {8, 0, 0}, 1e-9}, 0.5, 0, 0.5, 1e-9);
  expect_hit({boxes, {-4, 0, 0}, {4, 0, 0}, 1e-9}, 0.5, -2, 0.5, 1e-9);
  expect_miss({boxes, still, {3.9, 0, 0}, 1e-9});
  expect_miss({boxes, {0, 3, 0}, {8, 0, 0}, 1e-9});
  // Whatever the distance, shapes that do not move meet nothing; nor do discs and points that only turn.
  expect_miss({{VESICA_AABB, VESICA_AABB, {0, 0, 1, 1}, {1 + 0x1p-23, 0, 2, 1}}, still, still, 1});
  expect_miss({{VESICA_CIRCLE, VESICA_POINT, {0, 0, 1}, {1 + 0x1p-23, 0}}, {5, 0, 3}, {5, 0, 3}, 1});
}

TEST(Known, AtTheStart) {
  const Turning touching{{VESICA_AABB, VESICA_AABB, {0, 0, 1, 1}, {1, 0, 3, 1}}, still, {9, 0, 7}, 1e-3};
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    const Answer r = impact_time(scalar, touching);
    EXPECT_EQ(r.code, VESICA_CAST_START);
    EXPECT_EQ(r.t, 0);
    EXPECT_EQ(r.x, 1);
    EXPECT_EQ(r.nx, 1);
    EXPECT_EQ(r.ny, 0);
    EXPECT_EQ(r.gap, 0);
  }
}

TEST(Known, NearWithoutContact) {
  // A disc passes at a distance that is within the tolerance: no contact is claimed, and none is excluded.
  const Turning s{{VESICA_CIRCLE, VESICA_RECT, {0, 0, 1}, {-5, 1.5005, 1, 0, 0.5, 0.5}}, still, {10, 0, 0}, 1e-3};
  const Answer r = impact_time(Scalar::f64, s);
  EXPECT_EQ(r.code, VESICA_CAST_NEAR);
  EXPECT_LE(r.gap, 1e-3);
  EXPECT_GE(r.gap, 5e-4 * (1 - 1e-9));
  Turning finer = s;
  finer.tolerance = 1e-4;
  expect_miss(finer);
}

TEST(Known, ExtremeExponents) {
  for (const int e : {-1000, -500, 0, 500, 1000}) {
    const double k = std::ldexp(1.0, e);
    const Turning s{
        {VESICA_SEGMENT, VESICA_CIRCLE, {-k, 0, k, 0}, {0, 0.5 * k, 1e-8 * k}}, {0, 0, pi}, still, 1e-7 * k};
    const Answer r = impact_time(Scalar::f64, s);
    EXPECT_EQ(r.code, VESICA_CAST_HIT) << e;
    EXPECT_LE(r.t, 0.5);
    EXPECT_GE(r.t, 0.499999);
    EXPECT_LE(r.gap, 1e-7 * k);
  }
  // An axis whose square underflows.
  for (const int e : {-1000, -600, 600, 1000}) {
    const double u = std::ldexp(1.0, e), h = std::ldexp(1.0, -e);
    const Turning s{{VESICA_POINT, VESICA_RECT, {0, 0}, {-5, 0.25, u, 0, h, h}}, still, {8, 0, 0.125}, 1e-9};
    const Answer r = impact_time(Scalar::f64, s);
    EXPECT_EQ(r.code, VESICA_CAST_HIT) << e;
    EXPECT_LE(r.t, 0.5);
    EXPECT_GE(r.t, 0.48);
  }
  // A tolerance below rounding is not reached, and the result says so.
  const Answer r = impact_time(Scalar::f64, {bar_and_disc, {0, 0, pi}, still, 1e-300});
  EXPECT_EQ(r.code, VESICA_CAST_HIT);
  EXPECT_LE(r.t, 0.5);
  EXPECT_GE(r.t, 0.5 - 1e-7);
  EXPECT_GT(r.gap, 1e-300);
  EXPECT_LE(r.gap, 1e-12);
}

TEST(Known, Refused) {
  const auto code = [](const Pair& p, const Turn& a, const Turn& b, double tolerance) {
    return impact_time(Scalar::f64, {p, a, b, tolerance}).code;
  };
  EXPECT_EQ(code(boxes, {nan, 0, 0}, still, 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(code(boxes, {0, infinity, 0}, still, 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(code(boxes, still, {0, 0, nan}, 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(code(boxes, still, {0, 0, -infinity}, 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(code(boxes, still, {0, 0, 0x1.000002p20}, 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(code(boxes, still, still, 0), VESICA_E_ARGUMENT);
  EXPECT_EQ(code(boxes, still, still, -1), VESICA_E_ARGUMENT);
  EXPECT_EQ(code(boxes, still, still, nan), VESICA_E_ARGUMENT);
  EXPECT_EQ(code({VESICA_AABB, VESICA_POLYLINE + 1, {}, {}}, still, still, 1), VESICA_E_KIND);
  EXPECT_EQ(code({VESICA_CIRCLE, VESICA_POINT, {0, 0, -1}, {5, 0}}, still, still, 1), VESICA_E_SHAPE);
  EXPECT_EQ(code({VESICA_CIRCLE, VESICA_POINT, {0, 0, 1}, {nan, 0}}, still, still, 1), VESICA_E_SHAPE);
  EXPECT_EQ(code({VESICA_RECT, VESICA_POINT, {0, 0, 0, 0, 1, 1}, {5, 0}}, still, still, 1), VESICA_E_SHAPE);
  EXPECT_EQ(code({VESICA_AABB, VESICA_POINT, {1, 0, 0, 1}, {5, 0}}, still, still, 1), VESICA_E_SHAPE);

  const double* const a = boxes.a.data();
  const vesica_turn_f64 turn{0, 0, 0}, wrong{nan, 0, 0};
  vesica_impact_f64 out{7, 7, 7, 7, 7};
  double gap = 7;
  EXPECT_EQ(vesica_impact_time_f64(3, nullptr, &turn, 3, a, &turn, 1, &out, &gap), VESICA_E_NULL);
  EXPECT_EQ(vesica_impact_time_f64(3, a, nullptr, 3, a, &turn, 1, &out, &gap), VESICA_E_NULL);
  EXPECT_EQ(vesica_impact_time_f64(3, a, &turn, 3, nullptr, &turn, 1, &out, &gap), VESICA_E_NULL);
  EXPECT_EQ(vesica_impact_time_f64(3, a, &turn, 3, a, nullptr, 1, &out, &gap), VESICA_E_NULL);
  EXPECT_EQ(vesica_impact_time_f64(3, a, &turn, 3, a, &turn, 1, nullptr, &gap), VESICA_E_NULL);
  EXPECT_EQ(vesica_impact_time_f64(3, a, &turn, 3, a, &turn, 1, &out, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_impact_time_f64(3, a, &wrong, VESICA_POLYLINE + 1, a, &turn, 1, &out, &gap), VESICA_E_KIND);
  EXPECT_EQ(vesica_impact_time_f64(3, a, &wrong, 3, a, &turn, 1, &out, &gap), VESICA_E_ARGUMENT);
  EXPECT_EQ(out.t, 7);
  EXPECT_EQ(gap, 7);
}

}  // namespace
}  // namespace known_answers_test
