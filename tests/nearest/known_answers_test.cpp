// SPDX-License-Identifier: Apache-2.0
/// Answers known without computing: literals, at every scale.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "nearest/face.hpp"

namespace {

using nearest_test::Answer;
using nearest_test::nearest;
using nearest_test::Numbers;
using nearest_test::Pair;
using properties::Scalar;

constexpr double ulp = 0x1p-52;

/// A shape of each kind whose farthest point along (3, 4) is the origin.
constexpr Numbers at_origin[6] = {
    {0, 0},
    {-6, -2, 0, 0},
    {-3, -4, 5},
    {-2, -3, 0, 0},
    {-1, -7, 4, 3, 1, 1},     // vertices (-1, -7) +- (4, 3) +- (-3, 4)
    {-75, -16, 1, 0, 85, 34}  // the point (85^2 3, 34^2 4) / sqrt((85 3)^2 + (34 4)^2) = (75, 16) from the centre
};

/// The same turned half round, moved to (3, 4).
Numbers facing(int kind) {
  Numbers n = at_origin[kind];
  const int coordinates = kind == VESICA_SEGMENT || kind == VESICA_AABB ? 4 : 2;
  for (int i = 0; i < coordinates; ++i) {
    n[static_cast<std::size_t>(i)] = (i % 2 == 0 ? 3 : 4) - n[static_cast<std::size_t>(i)];
  }
  if (kind == VESICA_AABB) {
    std::swap(n[0], n[2]);
    std::swap(n[1], n[3]);
  }
  return n;
}

Numbers times(int kind, Numbers n, double factor) {
  for (int i = 0; i < properties::field_count(kind); ++i) {
    if (properties::role(kind, i) != properties::Role::axis) n[static_cast<std::size_t>(i)] *= factor;
  }
  return n;
}

void expect_five(Scalar scalar, int kind_a, int kind_b, double factor) {
  SCOPED_TRACE(testing::Message() << properties::name(scalar) << ' ' << kind_a << ' ' << kind_b << ' ' << factor);
  const Pair p{kind_a, kind_b, times(kind_a, at_origin[kind_a], factor), times(kind_b, facing(kind_b), factor)};
  const Answer r = nearest(scalar, p);
  ASSERT_EQ(r.code, 0);
  EXPECT_EQ(r.distance, 5 * factor);
  const double off = 200 * (scalar == Scalar::f32 ? 0x1p-24 : 0x1p-53) * factor;
  EXPECT_NEAR(r.ax, 0, off);
  EXPECT_NEAR(r.ay, 0, off);
  EXPECT_NEAR(r.bx, 3 * factor, off);
  EXPECT_NEAR(r.by, 4 * factor, off);
}

TEST(NearestKnownAnswers, ThreeFourFiveForEveryPairOfKinds) {
  for (int a = 0; a < 6; ++a) {
    for (int b = 0; b < 6; ++b) {
      for (const double factor : {0x1p-1060, 0x1p-500, 0x1p-61, 1.0, 0x1p59, 0x1p300, 0x1p1000}) {
        expect_five(Scalar::f64, a, b, factor);
      }
      for (const double factor : {0x1p-140, 0x1p-30, 1.0, 0x1p115}) expect_five(Scalar::f32, a, b, factor);
    }
  }
}

void expect_answer(const Pair& p, const Answer& expected) {
  const Answer r = nearest(Scalar::f64, p);
  EXPECT_EQ(r.code, expected.code);
  EXPECT_EQ(r.distance, expected.distance);
  EXPECT_EQ(r.ax, expected.ax);
  EXPECT_EQ(r.ay, expected.ay);
  EXPECT_EQ(r.bx, expected.bx);
  EXPECT_EQ(r.by, expected.by);
}

TEST(NearestKnownAnswers, PointsThatAreStoredAreMetExactly) {
  // Ends of segments and sides of AABBs, at coordinates that no sum of a centre and an extent would hit.
  const double third = 1.0 / 3, tenth = 0.1;
  expect_answer({VESICA_SEGMENT, VESICA_POINT, {third, tenth, 7, 0.7}, {tenth, tenth}},
                {0, third - tenth, third, tenth, tenth, tenth});
  expect_answer({VESICA_AABB, VESICA_POINT, {-1e15 / 3, -1, third, 1}, {third + 1, 0.3}},
                {0, (third + 1) - third, third, 0.3, third + 1, 0.3});
  // Corner to corner.
  const Pair corners{VESICA_AABB, VESICA_AABB, {-1, -1, tenth, 0.7}, {third, 0.9, 1, 1}};
  const Answer r = nearest(Scalar::f64, corners);
  EXPECT_EQ(r.ax, tenth);
  EXPECT_EQ(r.ay, 0.7);
  EXPECT_EQ(r.bx, third);
  EXPECT_EQ(r.by, 0.9);
}

TEST(NearestKnownAnswers, OneShapeBesideTheOther) {
  // A face, not a vertex, of the rectangle; the ellipse's vertex.
  expect_answer({VESICA_RECT, VESICA_ELLIPSE, {0, 0, 1, 0, 2, 3}, {7, 1, 1, 0, 4, 1}}, {0, 1, 2, 1, 3, 1});
  expect_answer({VESICA_RECT, VESICA_ELLIPSE, {0, 0, 0, 2, 1.5, 1}, {7, 1, 0, -1, 1, 4}}, {0, 1, 2, 1, 3, 1});
  // Needles along one line, and side by side.
  expect_answer({VESICA_ELLIPSE, VESICA_ELLIPSE, {0, 0, 1, 0, 1, 0x1p-20}, {4, 0, 1, 0, 2, 0x1p-30}},
                {0, 1, 1, 0, 2, 0});
  expect_answer({VESICA_ELLIPSE, VESICA_ELLIPSE, {0, 0, 1, 0, 1, 0x1p-20}, {0, 1, 1, 0, 1, 0x1p-20}},
                {0, 1 - 0x1p-19, 0, 0x1p-20, 0, 1 - 0x1p-20});
}

TEST(NearestKnownAnswers, OnePlaceBesideContact) {
  // Circles 15 apart with radii 5 and 10 touch; with the larger one a place smaller they are that place apart.
  const Pair touching{VESICA_CIRCLE, VESICA_CIRCLE, {0, 0, 5}, {9, 12, 10}};
  const Answer zero = nearest(Scalar::f64, touching);
  EXPECT_EQ(zero.distance, 0);
  EXPECT_DOUBLE_EQ(zero.ax, 3);
  EXPECT_DOUBLE_EQ(zero.ay, 4);
  Pair apart = touching;
  apart.b[2] = 10 - 8 * ulp;
  EXPECT_EQ(nearest(Scalar::f64, apart).distance, 8 * ulp);

  // Boxes that share a face, moved one place; the smallest number as a distance, and next to 1.
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(nearest(Scalar::f64, {VESICA_AABB, VESICA_AABB, {-1, -1, 0, 1}, {tiny, -1, 1, 1}}).distance, tiny);
  EXPECT_EQ(nearest(Scalar::f64, {VESICA_POINT, VESICA_POINT, {0, 0}, {tiny, 0}}).distance, tiny);
  EXPECT_EQ(nearest(Scalar::f64, {VESICA_SEGMENT, VESICA_POINT, {0, -1, 0, 1e300}, {tiny, 1}}).distance, tiny);
  EXPECT_EQ(nearest(Scalar::f64, {VESICA_RECT, VESICA_RECT, {0, 0, 1, 0, 1, 1}, {2 + 2 * ulp, 0, 1, 0, 1, 1}}).distance,
            2 * ulp);

  // An ellipse above a tilted face: a |u.v| = 3 and b |u x v| = 4 reach 5 along the normal (0.6, 0.8) as stored here.
  const Pair tangent{VESICA_RECT, VESICA_ELLIPSE, {0, 0, 4, -3, 100, 1}, {6, 8, 1, 0, 3, 4}};
  EXPECT_GT(nearest(Scalar::f64, tangent).distance, 0);
}

TEST(NearestKnownAnswers, DistancesTooSmallForFloatStayAboveZero) {
  const float tiny = std::numeric_limits<float>::denorm_min();
  // 2^-149 less 2^-150 apart in double: half a place rounds to even, that is to zero.
  const Pair p{VESICA_CIRCLE, VESICA_POINT, {0, 0, 1}, {std::nextafterf(1, 2), 0}};
  EXPECT_EQ(nearest(Scalar::f32, p).distance, 0x1p-23);
  vesica_closest_points_f32 out{};
  const float a[] = {0, 0, tiny}, b[] = {tiny, tiny};  // (sqrt(2) - 1) places apart
  ASSERT_EQ(vesica_nearest_f32(VESICA_CIRCLE, a, VESICA_POINT, b, &out), 0);
  EXPECT_EQ(out.distance, tiny);
}

TEST(NearestKnownAnswers, CommonPoints) {
  // A cross of two segments; of two needles; a box on a circle's rim.
  expect_answer({VESICA_SEGMENT, VESICA_SEGMENT, {0, 0, 4, 4}, {0, 2, 4, -2}}, {0, 0, 1, 1, 1, 1});
  const Answer needles =
      nearest(Scalar::f64, {VESICA_ELLIPSE, VESICA_ELLIPSE, {0.5, 0, 1, 0, 1, 0x1p-40}, {0, 0.25, 0, 1, 0.5, 0x1p-40}});
  EXPECT_EQ(needles.distance, 0);
  EXPECT_NEAR(needles.ax, 0, 0x1p-39);
  EXPECT_NEAR(needles.ay, 0, 0x1p-39);
  expect_answer({VESICA_CIRCLE, VESICA_AABB, {0, 0, 1}, {1, -1, 3, 5}}, {0, 0, 1, 0, 1, 0});
}

TEST(NearestKnownAnswers, BeyondTheFiniteNumbers) {
  const double big = std::numeric_limits<double>::max();
  const vesica_closest_points_f64 before{1, 2, 3, 4, 5};
  vesica_closest_points_f64 out = before;
  const double left[] = {-big, 0}, right[] = {big, 0};
  EXPECT_EQ(vesica_nearest_f64(VESICA_POINT, left, VESICA_POINT, right, &out), VESICA_E_RANGE);
  EXPECT_EQ(out.distance, before.distance);
  EXPECT_EQ(out.by, before.by);
  // Only the distance counts, not how far the shapes reach.
  const double wide[] = {-big, -big, big, big};
  EXPECT_EQ(vesica_nearest_f64(VESICA_AABB, wide, VESICA_POINT, right, &out), 0);
  EXPECT_EQ(out.distance, 0);

  // Lengths are taken at an eighth: the least axes must not vanish. The shapes are points beside the distance.
  for (const double axis : {1.0, 4.0, 5.0}) {
    const double unit = axis * std::numeric_limits<double>::denorm_min();
    for (const int kind : {VESICA_RECT, VESICA_ELLIPSE}) {
      const Numbers tiny{0, 0, unit, -unit, 1, 2}, large{0, 0, unit, -unit, 0x1p1000, 0x1p1023}, point{0x1.4p1023, 0};
      const Answer expected{0, 0x1.4p1023, 0x1.4p1023, 0, 0, 0};
      EXPECT_EQ(nearest(Scalar::f64, {VESICA_POINT, kind, point, tiny}), expected);
      EXPECT_EQ(nearest(Scalar::f64, {VESICA_CIRCLE, kind, point, tiny}), expected);
      EXPECT_EQ(nearest(Scalar::f64, {VESICA_RECT, kind, {0x1.4p1023, 0, 1, 0, 0, 0}, tiny}), expected);
      EXPECT_EQ(nearest(Scalar::f64, {kind, VESICA_ELLIPSE, tiny, {0x1.4p1023, 0, 1, 0, 1, 1}}),
                nearest_test::exchanged(expected));
      EXPECT_EQ(nearest(Scalar::f64, {VESICA_POINT, kind, point, large}).distance, 0x1.4p1023);
    }
  }

  const float big_f = std::numeric_limits<float>::max();
  const float left_f[] = {-big_f, 0}, right_f[] = {big_f, 0};
  vesica_closest_points_f32 out_f{1, 2, 3, 4, 5};
  EXPECT_EQ(vesica_nearest_f32(VESICA_POINT, left_f, VESICA_POINT, right_f, &out_f), VESICA_E_RANGE);
  EXPECT_EQ(out_f.distance, 1);
}

}  // namespace
