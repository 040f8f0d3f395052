// SPDX-License-Identifier: Apache-2.0
// The header where an answer is an error, or just not one: arguments and shapes that are invalid, one at a time,
// numbers beyond the finite ones, and what the plain forms give then.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vesica/vesica.hpp>

namespace {

using namespace vesica;

constexpr double largest = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();
constexpr float largest_f32 = std::numeric_limits<float>::max(), infinity_f32 = std::numeric_limits<float>::infinity();

constexpr Circle<double> unit{0, 0, 1}, invalid{0, 0, -1};
constexpr Ellipse<double> oval{9, 0, 1, 0, 2, 1}, invalid_oval{9, 0, 1, 0, 2, -1};

TEST(CoreErrors, AnInvalidShapeIsDisjointAndNotNear) {
  EXPECT_EQ(relation(invalid, unit), Relation::disjoint);
  EXPECT_FALSE(contains(unit, invalid));
  EXPECT_EQ(within(unit, invalid_oval, 100.0), Within::no);
  EXPECT_EQ(within(invalid, unit, 100.0), Within::no);
  EXPECT_EQ(depth(invalid, unit).depth, 0);
  EXPECT_TRUE(std::isnan(nearest(invalid_oval, Ellipse<double>{100, 0, 1, 0, 2, 1}).distance));
  EXPECT_EQ(signed_distance(Circle<double>{0, 0, 1}, Circle<double>{5, 0, 1}), 3);
  EXPECT_TRUE(std::isnan(signed_distance(unit, invalid)));
  EXPECT_EQ(within(unit, oval, 5.0), Within::no);  // they are 6 apart
  EXPECT_EQ(within(unit, oval, 7.0), Within::yes);
}

TEST(CoreErrors, EachShapeIsLookedAt) {
  double out = 7;
  for (int which = 0; which < ratio_count; ++which) {
    EXPECT_EQ(ratio_or_error(static_cast<Ratio>(which), unit, invalid, out), error_shape);
    EXPECT_EQ(ratio_or_error(static_cast<Ratio>(which), invalid, unit, out), error_shape);
  }
  EXPECT_EQ(ratio(Ratio::over_first, unit, unit), 1);
  TurnedBox<double> box;
  EXPECT_EQ(box_from_rect(Rect<double>{0, 0, 0, 0, 1, 1}, {AngleUnit::degrees}, box), error_shape);
  CrossingPoints<double> points;
  EXPECT_EQ(crossings_or_error(unit, Circle<double>{1, 0, 1}, points), 2);
  EXPECT_EQ(crossings_or_error(unit, Circle<double>{2, 0, 1}, points), 1);
  EXPECT_EQ(crossings_or_error(unit, Circle<double>{5, 0, 1}, points), 0);
  EXPECT_EQ(crossings_or_error(unit, invalid, points), error_shape);
  EXPECT_EQ(crossings_or_error(invalid, unit, points), error_shape);
  double corner[8];
  EXPECT_EQ(corners(Rect<double>{0, 0, 0, 0, 1, 1}, corner), error_shape);
  EXPECT_EQ(out, 7);
}

/// Equal numbers do not make an invalid shape one that is equal to itself.
TEST(CoreErrors, TheSameInvalidShapeTwice) {
  double out = 7;
  constexpr Rect<double> invalid_rect{0, 0, 0, 0, 1, 1};
  EXPECT_EQ(area_or_error(invalid, invalid, out), error_shape);
  EXPECT_EQ(area_or_error(invalid_oval, invalid_oval, out), error_shape);
  EXPECT_EQ(area_or_error(invalid_rect, invalid_rect, out), error_shape);
  EXPECT_EQ(iou_or_error(invalid_oval, invalid_oval, out), error_shape);
  EXPECT_EQ(out, 7);
}

/// Two shapes without area have no intersection over union, apart or not, the same or not; one has, and it is 0.
TEST(CoreErrors, ARatioOfNoArea) {
  constexpr Segment<double> flat{0, 0, 2, 2};
  constexpr Point<double> middle{1, 1}, apart{5, 1};
  constexpr Circle<double> dot{1, 1, 0}, disc{1, 1, 2};
  double out = 7;
  EXPECT_EQ(iou_or_error(flat, middle, out), error_argument);
  EXPECT_EQ(iou_or_error(apart, flat, out), error_argument);
  EXPECT_EQ(iou_or_error(middle, middle, out), error_argument);
  EXPECT_EQ(iou_or_error(dot, dot, out), error_argument);
  EXPECT_EQ(iou_or_error(dot, Circle<double>{9, 9, 0}, out), error_argument);
  EXPECT_EQ(iou_or_error(invalid, dot, out), error_shape);
  EXPECT_EQ(iou_or_error(dot, invalid, out), error_shape);
  EXPECT_EQ(out, 7);
  EXPECT_EQ(iou(middle, flat), 0);
  EXPECT_EQ(iou(dot, dot), 0);
  EXPECT_EQ(iou(dot, invalid), 0);
  EXPECT_EQ(iou(disc, disc), 1);
  EXPECT_EQ(iou_or_error(disc, dot, out), 0);
  EXPECT_EQ(out, 0);
  EXPECT_EQ(iou_or_error(flat, disc, out), 0);
  EXPECT_EQ(out, 0);
}

/// A depth beyond the range of float is an error, and none where the answer is a value.
TEST(CoreErrors, ADepthBeyondTheRange) {
  const Circle<float> huge{0, 0, largest_f32};
  Penetration<float> out{7, 7, 7};
  EXPECT_EQ(depth_or_error(huge, huge, out), error_range);
  EXPECT_TRUE(out.depth == 7 && out.x == 7 && out.y == 7);
  const Penetration<float> none = depth(huge, huge);
  EXPECT_TRUE(none.depth == 0 && none.x == 0 && none.y == 0);
}

/// An area beyond the range is an error, and the greatest number where the answer is a value.
TEST(CoreErrors, AnAreaBeyondTheRange) {
  const Aabb<double> huge{0, 0, 0x1p600, 0x1p600};
  double out = 7;
  EXPECT_EQ(area_or_error(huge, huge, out), error_range);
  EXPECT_EQ(out, 7);
  EXPECT_EQ(area(huge, huge), largest);
  EXPECT_EQ(area(huge, Aabb<double>{0x1p600, 0, 0x1p601, 1}), 0);
  const Circle<float> disc{0, 0, largest_f32};
  EXPECT_EQ(area(disc, disc), largest_f32);
}

TEST(CoreErrors, OutlinesInEitherOrder) {
  const auto first = boundary_distance(unit, oval), second = boundary_distance(oval, unit);
  EXPECT_EQ(first.distance, 6);
  EXPECT_TRUE(second.distance == 6 && second.ax == first.bx && second.ay == first.by && second.bx == first.ax);
}

TEST(CoreErrors, EachArgumentIsLookedAt) {
  EXPECT_EQ(within_or_error(unit, oval, nan), error_argument);
  EXPECT_EQ(within_or_error(unit, unit, nan), error_argument);
  EXPECT_EQ(within_or_error(oval, oval, nan), error_argument);
  Impact<double> impact;
  EXPECT_EQ(cast_or_error(unit, oval, infinity, 0.0, 1.0, impact), error_argument);
  EXPECT_EQ(cast_or_error(unit, oval, 0.0, infinity, 1.0, impact), error_argument);
  EXPECT_EQ(cast_or_error(unit, oval, 0.0, 0.0, -1.0, impact), error_argument);
  EXPECT_EQ(cast_or_error(unit, oval, 0.0, 0.0, nan, impact), error_argument);
  // Kinds that have a filter of their own, missing by far and moving away.
  for (const double end : {-1.0, nan, -infinity}) {
    for (const double vy : {0.0, 1.0}) {
      EXPECT_EQ(cast_or_error(oval, Ellipse<double>{10, 100, 1, 0, 2, 1}, 1.0, vy, end, impact), error_argument);
      EXPECT_EQ(cast_or_error(Circle<double>{0, 0, 1}, Circle<double>{10, 100, 1}, 1.0, vy, end, impact),
                error_argument);
      EXPECT_EQ(cast_or_error(Aabb<double>{0, 0, 1, 1}, Point<double>{10, 100}, 1.0, vy, end, impact), error_argument);
    }
  }
  Aabb<double> box;
  EXPECT_EQ(sweep_bounds(unit, nan, 0.0, 1.0, box), error_argument);
  constexpr Turn<double> still{0, 0, 0}, lost{nan, 0, 0};
  double gap;
  EXPECT_EQ(impact_time_or_error(unit, still, oval, still, 0x1p-20, impact, gap), static_cast<int>(cast_miss));
  EXPECT_EQ(impact_time_or_error(unit, lost, oval, still, 0x1p-20, impact, gap), error_argument);
  EXPECT_EQ(impact_time_or_error(unit, still, oval, lost, 0x1p-20, impact, gap), error_argument);
  EXPECT_EQ(impact_time_or_error(unit, still, oval, still, 0.0, impact, gap), error_argument);
  EXPECT_EQ(impact_time_or_error(unit, still, oval, still, nan, impact, gap), error_argument);
  Rect<double> rect;
  Ellipse<double> ellipse;
  EXPECT_EQ(rect_from_box(TurnedBox<double>{0, 0, -1, 1, 0}, {AngleUnit::degrees}, rect), error_negative_size);
  EXPECT_EQ(rect_from_box(TurnedBox<double>{0, 0, 1, -1, 0}, {AngleUnit::degrees}, rect), error_negative_size);
  EXPECT_EQ(ellipse_from_box(TurnedBox<double>{0, 0, 1, -1, 0}, {AngleUnit::degrees}, ellipse), error_negative_size);
}

// Distances and depths of up to twice the greatest number.
TEST(CoreErrors, BeyondTheFiniteNumbers) {
  const Point<float> left{-largest_f32, 0}, right{largest_f32, 0};
  const Circle<float> great{0, 0, largest_f32};
  float out = 7;
  EXPECT_EQ(signed_distance_or_error(left, right, out), error_range);
  EXPECT_EQ(signed_distance_or_error(great, great, out), error_range);
  EXPECT_EQ(out, 7);
  EXPECT_EQ(depth(great, great).depth, 0);
  EXPECT_TRUE(std::isnan(signed_distance(Point<double>{-largest, 0}, Point<double>{largest, 0})));
  Impact<float> impact{7, 7, 7, 7, 7};
  EXPECT_EQ(cast_or_error(great, great, 1.0f, 0.0f, 1.0f, impact), error_range);
  constexpr Turn<float> still{0, 0, 0};
  float gap = 7;
  EXPECT_EQ(impact_time_or_error(great, still, great, still, 0x1p-10f, impact, gap), error_range);
  // After 2^200 units of time.
  EXPECT_EQ(cast_or_error(Circle<float>{0, 0, 1}, Point<float>{0x1p100f, 0}, -0x1p-100f, 0.0f, infinity_f32, impact),
            error_range);
  EXPECT_EQ(impact.t, 7);
  EXPECT_EQ(gap, 7);
}

// In units of 2^1023 two needles, along y = 0 to x = 2.25 and from (0.85, 1.25) to (2.35, -0.25), that cross at x =
// 2.1.
TEST(CoreErrors, ACrossingBeyondTheFiniteNumbers) {
  constexpr double unit_length = 0x1p1023;
  const Rect<double> level{1.5 * unit_length, 0, 1, 0, 0.75 * unit_length, 1};
  const Rect<double> falling{1.6 * unit_length, 0.5 * unit_length, 1, -1, 0.75 * unit_length, 1};
  ASSERT_TRUE(overlap(level, falling));
  ClosestPoints<double> points;
  Impact<double> impact{7, 7, 7, 7, 7};
  EXPECT_EQ(nearest_or_error(level, falling, points), error_range);
  EXPECT_EQ(cast_or_error(level, falling, 1.0, 0.0, 1.0, impact), error_range);
  EXPECT_EQ(cast_or_error(falling, level, 1.0, 0.0, 1.0, impact), error_range);
  EXPECT_EQ(impact.t, 7);
}

// In units of 2^127 the circle is about (2, 0) of radius 1. The point, at (1.5 + t, 1.9375 - 1.25 t), meets it where
// 2.5625 t^2 - 5.84375 t + 3.00390625 = 0, at x = 2.28: a double, but no float.
TEST(CoreErrors, AContactBeyondTheFiniteFloats) {
  const Circle<float> circle{largest_f32, 0, 0x1p127f};
  const Point<float> point{0x1.8p127f, 0x1.fp127f};
  Impact<double> wide;
  ASSERT_EQ(cast_or_error(widen(circle), widen(point), 0x1p127, -0x1.4p127, 2.0, wide), static_cast<int>(cast_hit));
  EXPECT_NEAR(wide.t, (5.84375 - std::sqrt(5.84375 * 5.84375 - 4 * 2.5625 * 3.00390625)) / 5.125, 1e-6);
  Impact<float> impact{7, 7, 7, 7, 7};
  EXPECT_EQ(cast_or_error(circle, point, 0x1p127f, -0x1.4p127f, 2.0f, impact), error_range);
  constexpr Turn<float> still{0, 0, 0}, moves{0x1p127f, -0x1.4p127f, 0};
  float gap = 7;
  EXPECT_EQ(impact_time_or_error(circle, still, point, moves, 0x1p100f, impact, gap), error_range);
  EXPECT_EQ(impact.t, 7);
  EXPECT_EQ(gap, 7);
}

// Differences overflow: such boxes are compared exactly.
TEST(CoreErrors, RelationOfBoxesFarApart) {
  const Aabb<double> left{-largest, 0, -largest, 1}, right{largest, 0, largest, 1};
  const Aabb<double> below{0, -largest, 1, -largest}, above{0, largest, 1, largest};
  EXPECT_EQ(relation(left, right), Relation::disjoint);
  EXPECT_EQ(relation(right, left), Relation::disjoint);
  EXPECT_EQ(relation(below, above), Relation::disjoint);
  EXPECT_EQ(relation(above, below), Relation::disjoint);
  EXPECT_EQ(relation(left, Aabb<double>{-largest, 0, largest, 1}), Relation::inside_touch);
}

// Facts that are known in advance do not change the answer.
TEST(CoreErrors, NearestWithKnownOverlap) {
  const Ellipse<double> near{1, 0, 1, 0, 2, 1}, other{0, 1, 3, 4, 0.5, 0.25};
  const auto distance = [](const Ellipse<double>& a, const Ellipse<double>& b, std::int32_t known) {
    ClosestPoints<double> found{};
    EXPECT_EQ(detail::nearest::nearest_in_order(a, b, known, found), 0);
    return found.distance;
  };
  EXPECT_EQ(distance(near, oval, 0), 4);  // from x = 3 to x = 7
  EXPECT_EQ(distance(near, oval, detail::nearest::not_asked), 4);
  EXPECT_EQ(distance(near, other, 1), 0);
}

// Areas on both sides of 2^-400 and 2^400, where they are no longer plain doubles, and far beyond.
TEST(CoreErrors, RatiosOfAreasOfAnyMagnitude) {
  for (const double side :
       {0x1p-600, 0x1p-250, 0x1.8p-201, 0x1p-200, 1.0, 0x1p200, 0x1.8p200, 0x1p201, 0x1p250, 0x1p600}) {
    const Aabb<double> whole{0, 0, side, side}, half{0, 0, side, side / 2};
    EXPECT_EQ(ratio(Ratio::over_first, whole, half), 0.5) << side;
    EXPECT_EQ(ratio(Ratio::over_second, whole, half), 1) << side;
    EXPECT_EQ(ratio(Ratio::over_smaller, whole, half), 1) << side;
    EXPECT_EQ(ratio(Ratio::over_union, whole, half), 0.5) << side;
    const Aabb<double> apart{0, side, side, 2 * side};
    EXPECT_EQ(ratio(Ratio::over_first, half, apart), 0) << side;
  }
}

TEST(CoreErrors, BoundsAndVectors) {
  Aabb<double> box;
  EXPECT_EQ(sweep_bounds(unit, 3.0, 4.0, 0.0, box), 0);
  EXPECT_TRUE(box.min_x == -1 && box.min_y == -1 && box.max_x == 1 && box.max_y == 1);
  // From a centre near one end of the numbers, an extent beyond them leads to a side that is one.
  for (const double extent : {0x1p423, 0x1.8p423, 0x1p424, 0x1.8p424, 0x1p430}) {
    EXPECT_EQ(bounds(Ellipse<double>{-largest, 0, 0x1p600, 0, extent, 1}, box), error_range);
    EXPECT_EQ(bounds(Rect<double>{-largest, 0, 0x1p600, 0, extent, 1}, box), error_range);
  }
  Ellipse<double> e;
  EXPECT_EQ(ellipse_from_radius_vector(1.0, 2.0, 0.0, 3.0, 0.5, e), 0);
  EXPECT_TRUE(e.cx == 1 && e.cy == 2 && e.ux == 0 && e.uy == 3 && e.a == 1 && e.b == 0.5);
  EXPECT_EQ(ellipse_from_radius_vector(1.0, 2.0, 0.0, 0.0, 0.5, e), 0);
  EXPECT_TRUE(e.ux == 1 && e.uy == 0 && e.a == 0 && e.b == 0);
}

}  // namespace
