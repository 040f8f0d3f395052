// SPDX-License-Identifier: Apache-2.0
// Distance and depth, against the distance of the cores and by the laws of both.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "inflated/shapes.hpp"

namespace {

using namespace inflated;
using properties::Random;

/// Sizes are about 1 and places within 3 of the origin: this many roundings of such numbers.
constexpr double tolerance = 64 * 0x1p-53;

vesica_closest_points_f64 nearest(const Shape& a, const Shape& b) {
  vesica_closest_points_f64 found;
  EXPECT_EQ(vesica_nearest_f64(a.kind, a.number.data(), b.kind, b.number.data(), &found), 0);
  return found;
}
vesica_penetration_f64 depth(const Shape& a, const Shape& b) {
  vesica_penetration_f64 found;
  EXPECT_EQ(vesica_depth_f64(a.kind, a.number.data(), b.kind, b.number.data(), &found), 0);
  return found;
}
bool overlap(const Shape& a, const Shape& b) {
  return vesica_overlap_f64(a.kind, a.number.data(), b.kind, b.number.data()) == 1;
}

/// How far a point is outside a shape.
double beyond(const Shape& s, double x, double y) {
  return nearest({VESICA_POINT, {x, y}}, core(s)).distance - radius(s);
}

Shape moved(Shape s, double dx, double dy) {
  const bool has_ends = s.kind == VESICA_SEGMENT || s.kind == VESICA_AABB || s.kind == VESICA_CAPSULE;
  for (std::size_t k = 0; k < (has_ends ? 4 : 2); k += 2) s.number[k] += dx, s.number[k + 1] += dy;
  return s;
}

TEST(InflatedDistance, IsThatOfTheCoresLessTheRadii) {
  Random random(properties::seed());
  int apart = 0, together = 0;
  for (int i = 0; i < 40000 * properties::repeat(); ++i) {
    const Shape a = any_shape(random), b = inflated_shape(random);
    const auto found = nearest(a, b), exchanged = nearest(b, a);
    ASSERT_EQ(found.distance, exchanged.distance);
    ASSERT_EQ(found.ax, exchanged.bx);
    ASSERT_EQ(found.by, exchanged.ay);
    ASSERT_EQ(found.distance > 0, !overlap(a, b)) << i;
    ASSERT_LE(std::fabs(beyond(a, found.ax, found.ay)), found.distance > 0 && a.kind != VESICA_ELLIPSE ? tolerance : 9)
        << i;
    ASSERT_LE(beyond(a, found.ax, found.ay), tolerance) << i;
    ASSERT_LE(beyond(b, found.bx, found.by), tolerance) << i;
    if (found.distance > 0) {
      ++apart;
      ASSERT_NEAR(found.distance, nearest(core(a), core(b)).distance - radius(a) - radius(b), tolerance);
      ASSERT_NEAR(found.distance, std::hypot(found.bx - found.ax, found.by - found.ay), tolerance);
    } else {
      ++together;
      ASSERT_EQ(found.ax, found.bx);
      ASSERT_EQ(found.ay, found.by);
    }
  }
  EXPECT_GT(apart, 100 * properties::repeat());
  EXPECT_GT(together, 100 * properties::repeat());
}

TEST(InflatedDistance, KnownPoints) {
  const vesica_capsule_f64 capsule{0, 0, 10, 0, 1};
  const vesica_point_f64 point{5, 3};
  vesica_closest_points_f64 found;
  ASSERT_EQ(vesica_nearest_f64(VESICA_POINT, &point, VESICA_CAPSULE, &capsule, &found), 0);
  EXPECT_EQ((std::array{found.distance, found.ax, found.ay, found.bx, found.by}),
            (std::array{2.0, 5.0, 3.0, 5.0, 1.0}));
  const vesica_round_rect_f64 rect{0, 5, 1, 0, 2, 1, 0.5};
  ASSERT_EQ(vesica_nearest_f64(VESICA_CAPSULE, &capsule, VESICA_ROUND_RECT, &rect, &found), 0);
  EXPECT_EQ(found.distance, 2.5);
  EXPECT_EQ(found.ay, 1);
  EXPECT_EQ(found.by, 3.5);
}

/// Distances far smaller than the shapes keep their digits: only the last step rounds.
TEST(InflatedDistance, SmallGaps) {
  for (const double gap : {0x1p-40, 0x1p-50, 0x1p-51}) {
    const vesica_capsule_f64 a{-1, 0, 1, 0, 0.25}, b{-1, 0.75 + gap, 1, 0.75 + gap, 0.5};
    vesica_closest_points_f64 found;
    ASSERT_EQ(vesica_nearest_f64(VESICA_CAPSULE, &a, VESICA_CAPSULE, &b, &found), 0);
    EXPECT_EQ(found.distance, gap);
  }
}

TEST(InflatedDepth, EndsTheOverlap) {
  Random random(properties::seed());
  int together = 0;
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    const Shape a = any_shape(random), b = inflated_shape(random);
    const auto found = depth(a, b);
    if (!overlap(a, b)) {
      ASSERT_EQ(found.depth, 0);
      continue;
    }
    ++together;
    ASSERT_NEAR(std::hypot(found.x, found.y), 1, 1e-15);
    const double less = found.depth * (1 - 1e-9) - tolerance, more = found.depth * (1 + 1e-9) + tolerance;
    ASSERT_TRUE(overlap(a, moved(b, less * found.x, less * found.y))) << i;
    ASSERT_FALSE(overlap(a, moved(b, more * found.x, more * found.y))) << i;
    const auto exchanged = depth(b, a);
    ASSERT_EQ(found.depth, exchanged.depth) << i;
    ASSERT_EQ(found.x, 0 - exchanged.x) << i;
    double signed_distance;
    ASSERT_EQ(vesica_signed_distance_f64(a.kind, a.number.data(), b.kind, b.number.data(), &signed_distance), 0);
    ASSERT_EQ(signed_distance, 0 - found.depth);
  }
  EXPECT_GT(together, 100 * properties::repeat());
}

/// No shorter move in any of many directions ends the overlap.
TEST(InflatedDepth, IsTheShortestMove) {
  Random random(properties::seed());
  for (int i = 0; i < 500 * properties::repeat(); ++i) {
    const Shape a = any_shape(random), b = inflated_shape(random);
    if (!overlap(a, b)) continue;
    const double length = depth(a, b).depth * (1 - 1e-9) - tolerance;
    for (int k = 0; k < 64; ++k) {
      const double turn = k * 0.0981747704;
      ASSERT_TRUE(overlap(a, moved(b, length * std::cos(turn), length * std::sin(turn)))) << i << ", " << k;
    }
  }
}

}  // namespace
