// SPDX-License-Identifier: Apache-2.0
// Answers known by construction.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "vesica.h"

namespace {

using Numbers = properties::NumbersOf<double>;

struct Case {
  const char* name;
  int kind_a;
  Numbers a;
  int kind_b;
  Numbers b;
  double distance, ax, ay, bx, by;
};

constexpr double rounding = 1e-14;  // numbers below are of size 20 at most

vesica_closest_points_f64 ask(const Case& c) {
  vesica_closest_points_f64 out{-1, -1, -1, -1, -1};
  EXPECT_EQ(vesica_boundary_distance_f64(c.kind_a, c.a.data(), c.kind_b, c.b.data(), &out), 0) << c.name;
  return out;
}

vesica_closest_points_f32 ask_f32(const Case& c) {
  properties::NumbersOf<float> a{}, b{};
  for (std::size_t i = 0; i < 6; ++i) a[i] = static_cast<float>(c.a[i]), b[i] = static_cast<float>(c.b[i]);
  vesica_closest_points_f32 out{-1, -1, -1, -1, -1};
  EXPECT_EQ(vesica_boundary_distance_f32(c.kind_a, a.data(), c.kind_b, b.data(), &out), 0) << c.name;
  return out;
}

void expect(const Case& c) {
  const auto found = ask(c);
  EXPECT_DOUBLE_EQ(found.distance, c.distance) << c.name;
  EXPECT_NEAR(found.ax, c.ax, rounding) << c.name;
  EXPECT_NEAR(found.ay, c.ay, rounding) << c.name;
  EXPECT_NEAR(found.bx, c.bx, rounding) << c.name;
  EXPECT_NEAR(found.by, c.by, rounding) << c.name;
  const auto in_float = ask_f32(c);
  EXPECT_NEAR(static_cast<double>(in_float.distance), c.distance, 1e-6 * (1 + c.distance)) << c.name;
  EXPECT_EQ(in_float.distance == 0, c.distance == 0) << c.name;
}

TEST(BoundaryDistanceKnown, Nested) {
  constexpr double contact_y = 173.25 / 13;  // of the ellipse with half lengths 20 along (3, 4) and 6.25 across
  const std::vector<Case> cases{
      {"point in circle", VESICA_CIRCLE, {0, 0, 5}, VESICA_POINT, {3, 0}, 2, 5, 0, 3, 0},
      {"point in aabb", VESICA_AABB, {0, 0, 10, 6}, VESICA_POINT, {3, 2}, 2, 3, 0, 3, 2},
      {"point in rect", VESICA_RECT, {0, 0, 3, 4, 2, 1}, VESICA_POINT, {4.5, 6}, 2.5, 6, 8, 4.5, 6},
      {"point in ellipse", VESICA_ELLIPSE, {0, 0, 1, 0, 5, 3}, VESICA_POINT, {0, 1}, 2, 0, 3, 0, 1},
      {"segment in circle", VESICA_CIRCLE, {0, 0, 5}, VESICA_SEGMENT, {-1, 0, 3, 0}, 2, 5, 0, 3, 0},
      {"segment in aabb", VESICA_AABB, {0, 0, 10, 6}, VESICA_SEGMENT, {3, 2, 5, 3}, 2, 3, 0, 3, 2},
      {"segment in rect", VESICA_RECT, {0, 0, 0, 1, 6, 3}, VESICA_SEGMENT, {-1, 0, 2, 0}, 1, 3, 0, 2, 0},
      {"segment in ellipse", VESICA_ELLIPSE, {0, 0, 1, 0, 5, 3}, VESICA_SEGMENT, {0, -1, 0, 1.5}, 1.5, 0, 3, 0, 1.5},
      {"circle in circle", VESICA_CIRCLE, {0, 0, 10}, VESICA_CIRCLE, {3, 4, 2}, 3, 6, 8, 4.2, 5.6},
      {"circle in aabb", VESICA_AABB, {0, 0, 10, 6}, VESICA_CIRCLE, {4, 3.5, 1}, 1.5, 4, 6, 4, 4.5},
      {"circle in rect", VESICA_RECT, {0, 0, 3, 4, 3, 2}, VESICA_CIRCLE, {-4, 3, 2}, 3, -8, 6, -5.6, 4.2},
      {"circle in ellipse", VESICA_ELLIPSE, {0, 0, 1, 0, 5, 3}, VESICA_CIRCLE, {0, 1, 1}, 1, 0, 3, 0, 2},
      {"aabb in circle", VESICA_CIRCLE, {0, 0, 5}, VESICA_AABB, {-1, -1, 2.4, 1.8}, 2, 4, 3, 2.4, 1.8},
      {"aabb in aabb", VESICA_AABB, {0, 0, 10, 6}, VESICA_AABB, {4, 3, 9.5, 3}, 0.5, 10, 3, 9.5, 3},
      {"aabb in rect", VESICA_RECT, {0, 0, 3, 4, 2, 1}, VESICA_AABB, {-1, -1, 3, 4}, 1.8, -2.44, 5.08, -1, 4},
      {"aabb in ellipse", VESICA_ELLIPSE, {0, 0, 3, 4, 1, 1}, VESICA_AABB, {-1, -1, 2.4, 1.8}, 2, 4, 3, 2.4, 1.8},
      {"rect in circle", VESICA_CIRCLE, {0, 0, 5}, VESICA_RECT, {0.7, 0.4, 0, 1, 1.4, 1.7}, 2, 4, 3, 2.4, 1.8},
      {"rect in aabb", VESICA_AABB, {-9, -9, 9, 9}, VESICA_RECT, {1, 0, 3, 4, 1, 0.5}, 3, 9, 2.5, 6, 2.5},
      {"rect in rect", VESICA_RECT, {0, 0, 3, 4, 2, 2}, VESICA_RECT, {3, 4, -1, 7, 0.25, 0.25}, 2.5, 6, 8, 4.5, 6},
      {"rect in ellipse",
       VESICA_ELLIPSE,
       {0, 0, 3, 4, 1, 1},
       VESICA_RECT,
       {0.7, 0.4, 0, 1, 1.4, 1.7},
       2,
       4,
       3,
       2.4,
       1.8},
      {"ellipse in circle", VESICA_CIRCLE, {0, 0, 5}, VESICA_ELLIPSE, {1, 0, 1, 0, 3, 1}, 1, 5, 0, 4, 0},
      {"ellipse in aabb",
       VESICA_AABB,
       {-15, -20, 15, 20},
       VESICA_ELLIPSE,
       {1, 0, 3, 4, 4, 1.25},
       1,
       15,
       contact_y,
       14,
       contact_y},
      {"ellipse in rect",
       VESICA_RECT,
       {0, 0, 0, 1, 20, 15},
       VESICA_ELLIPSE,
       {1, 0, 3, 4, 4, 1.25},
       1,
       15,
       contact_y,
       14,
       contact_y},
      {"ellipse in ellipse",
       VESICA_ELLIPSE,
       {0, 0, 1, 0, 5, 3},
       VESICA_ELLIPSE,
       {1.5, 0, 0, 1, 1, 3},
       0.5,
       5,
       0,
       4.5,
       0},
  };
  for (const Case& c : cases) {
    expect(c);
    expect({c.name, c.kind_b, c.b, c.kind_a, c.a, c.distance, c.bx, c.by, c.ax, c.ay});
  }
}

TEST(BoundaryDistanceKnown, OneCommonPoint) {
  const std::vector<Case> cases{
      {"equal points", VESICA_POINT, {3, 4}, VESICA_POINT, {3, 4}, 0, 3, 4, 3, 4},
      {"a point of a segment", VESICA_POINT, {3, 4}, VESICA_SEGMENT, {0, 0, 6, 8}, 0, 3, 4, 3, 4},
      {"a point of a rim", VESICA_POINT, {3, 4}, VESICA_CIRCLE, {0, 0, 5}, 0, 3, 4, 3, 4},
      {"a point of a side", VESICA_POINT, {3, 4}, VESICA_AABB, {0, 0, 3, 9}, 0, 3, 4, 3, 4},
      {"a corner", VESICA_POINT, {-1, 7}, VESICA_RECT, {0, 0, 3, 4, 1, 1}, 0, -1, 7, -1, 7},
      {"a vertex", VESICA_POINT, {6, 8}, VESICA_ELLIPSE, {0, 0, 3, 4, 2, 1}, 0, 6, 8, 6, 8},
      {"crossing segments",
       VESICA_SEGMENT,
       {0, 0, 8, 8},
       VESICA_SEGMENT,
       {0, 4, 8, 0},
       0,
       8. / 3,
       8. / 3,
       8. / 3,
       8. / 3},
      {"a tangent", VESICA_SEGMENT, {-7, 5, 7, 5}, VESICA_CIRCLE, {0, 0, 5}, 0, 0, 5, 0, 5},
      {"a segment into a disc", VESICA_SEGMENT, {0, 0, 7, 0}, VESICA_CIRCLE, {0, 0, 5}, 0, 5, 0, 5, 0},
      {"a segment into a box", VESICA_SEGMENT, {1, 1, 7, 1}, VESICA_AABB, {0, 0, 5, 5}, 0, 5, 1, 5, 1},
      {"a segment into a rectangle", VESICA_SEGMENT, {0, 0, 6, 8}, VESICA_RECT, {0, 0, 3, 4, 1, 1}, 0, 3, 4, 3, 4},
      {"a segment into an ellipse", VESICA_SEGMENT, {0, 0, 6, 8}, VESICA_ELLIPSE, {0, 0, 3, 4, 1, 2}, 0, 3, 4, 3, 4},
      {"touching discs", VESICA_CIRCLE, {0, 0, 5}, VESICA_CIRCLE, {6, 8, 5}, 0, 3, 4, 3, 4},
      {"a disc touching from inside", VESICA_CIRCLE, {0, 0, 10}, VESICA_CIRCLE, {3, 4, 5}, 0, 6, 8, 6, 8},
      {"a disc touching a side", VESICA_CIRCLE, {3, 9, 5}, VESICA_AABB, {0, 0, 9, 4}, 0, 3, 4, 3, 4},
      {"a disc touching a corner", VESICA_CIRCLE, {6, 8, 5}, VESICA_RECT, {0, 0, 0, 1, 4, 3}, 0, 3, 4, 3, 4},
      {"a disc touching an ellipse", VESICA_CIRCLE, {9, 12, 5}, VESICA_ELLIPSE, {0, 0, 3, 4, 2, 1}, 0, 6, 8, 6, 8},
      {"touching corners", VESICA_AABB, {0, 0, 3, 4}, VESICA_AABB, {3, 4, 5, 6}, 0, 3, 4, 3, 4},
      {"a corner on a side", VESICA_AABB, {0, 0, 3, 9}, VESICA_RECT, {7, 4, 1, 1, 2, 2}, 0, 3, 4, 3, 4},
      {"a vertex on a side", VESICA_AABB, {0, 0, 3, 9}, VESICA_ELLIPSE, {7, 4, 1, 0, 4, 2}, 0, 3, 4, 3, 4},
      {"rectangles' corners", VESICA_RECT, {0, 0, 1, 1, 2, 1}, VESICA_RECT, {4, 4, 1, 0, 3, 1}, 0, 1, 3, 1, 3},
      {"a vertex on a corner",
       VESICA_RECT,
       {0, 0, 3, 4, 1, 0.5},
       VESICA_ELLIPSE,
       {1, 9, 0, 1, 3.5, 2},
       0,
       1,
       5.5,
       1,
       5.5},
      {"vertices", VESICA_ELLIPSE, {0, 0, 3, 4, 2, 1}, VESICA_ELLIPSE, {9, 12, 3, 4, 1, 2}, 0, 6, 8, 6, 8},
      {"an ellipse touching from inside",
       VESICA_ELLIPSE,
       {0, 0, 3, 4, 2, 2},
       VESICA_ELLIPSE,
       {3, 4, 3, 4, 1, 0.5},
       0,
       6,
       8,
       6,
       8},
  };
  for (const Case& c : cases) expect(c);
}

TEST(BoundaryDistanceKnown, SegmentsOnOneLineHaveACommonPoint) {
  const auto found = ask({"", VESICA_SEGMENT, {0, 0, 6, 8}, VESICA_SEGMENT, {3, 4, 4.5, 6}, 0, 0, 0, 0, 0});
  EXPECT_EQ(found.distance, 0);
  EXPECT_GE(found.ax, 3);
  EXPECT_LE(found.ax, 4.5);
  EXPECT_DOUBLE_EQ(found.ay * 3, found.ax * 4);
}

TEST(BoundaryDistanceKnown, DisjointShapesGiveWhatNearestGives) {
  const Case c{"", VESICA_CIRCLE, {0, 0, 5}, VESICA_ELLIPSE, {12, 16, 3, 4, 1, 3}, 10, 3, 4, 9, 12};
  expect(c);
}

TEST(BoundaryDistanceKnown, AllScales) {
  for (const int exponent : {-1060, -1000, -500, -40, 40, 500, 1000}) {
    const double k = std::ldexp(1, exponent);
    const properties::NumbersOf<double> outer{0, 0, k, 0, 5, 3}, inner{1.5 * k, 0, 0, k, 1, 3};
    vesica_closest_points_f64 out;
    ASSERT_EQ(vesica_boundary_distance_f64(VESICA_ELLIPSE, outer.data(), VESICA_ELLIPSE, inner.data(), &out), 0);
    EXPECT_DOUBLE_EQ(out.distance, 0.5 * k) << exponent;
    EXPECT_DOUBLE_EQ(out.ax, 5 * k) << exponent;
    EXPECT_DOUBLE_EQ(out.bx, 4.5 * k) << exponent;
  }
}

TEST(BoundaryDistanceKnown, ANeedleAroundAPointAndMixedScales) {
  // The true distance is 2^-1000, far below the rounding of the needle's length.
  const properties::NumbersOf<double> needle{0, 0, 1, 0, 1, 0x1p-1000}, point{0, 0},
      huge{0, 0, 1, 0, 0x1p1000, 0x1p1000};
  vesica_closest_points_f64 out;
  ASSERT_EQ(vesica_boundary_distance_f64(VESICA_ELLIPSE, needle.data(), VESICA_POINT, point.data(), &out), 0);
  EXPECT_GT(out.distance, 0);
  EXPECT_LE(out.distance, 0x1p-51);
  ASSERT_EQ(vesica_boundary_distance_f64(VESICA_POINT, point.data(), VESICA_RECT, huge.data(), &out), 0);
  EXPECT_EQ(out.distance, 0x1p1000);
  ASSERT_EQ(vesica_boundary_distance_f64(VESICA_ELLIPSE, needle.data(), VESICA_ELLIPSE, huge.data(), &out), 0);
  EXPECT_EQ(out.distance, 0x1p1000);
}

TEST(BoundaryDistanceKnown, AboveTheRangeIsAnErrorAndFloatsStayAboveZero) {
  const properties::NumbersOf<double> vast{0, 0, 1e300, 0, 1e300, 1e300}, point{0, 0};
  vesica_closest_points_f64 out{7, 7, 7, 7, 7};
  EXPECT_EQ(vesica_boundary_distance_f64(VESICA_ELLIPSE, vast.data(), VESICA_POINT, point.data(), &out),
            VESICA_E_RANGE);
  EXPECT_EQ(out.distance, 7);
  const std::array<float, 3> disc{0, 0, 0x1p-149f}, origin{0, 0, 0};
  vesica_closest_points_f32 small;
  ASSERT_EQ(vesica_boundary_distance_f32(VESICA_CIRCLE, disc.data(), VESICA_POINT, origin.data(), &small), 0);
  EXPECT_EQ(small.distance, 0x1p-149f);
  const properties::NumbersOf<float> thin{0, 0, 1, 0, 1, 1},
      thinner{0, 0, 0x1p-100f, 0, 0x1.fffffep99f, 0x1.fffffep99f};
  ASSERT_EQ(vesica_boundary_distance_f32(VESICA_ELLIPSE, thin.data(), VESICA_ELLIPSE, thinner.data(), &small), 0);
  EXPECT_EQ(small.distance, 0x1p-24f);
}

/// Issues errors in the order NULL, kind, shape, and leaves the result alone.
template <class T, class Out, class Ask>
void expect_errors(Ask ask_for) {
  const properties::NumbersOf<T> good{0, 0, 1, 0, 2, 1}, bad{0, 0, 0, 0, 2, 1};
  Out out{7, 7, 7, 7, 7};
  EXPECT_EQ(ask_for(9, nullptr, VESICA_RECT, good.data(), &out), VESICA_E_NULL);
  EXPECT_EQ(ask_for(VESICA_RECT, good.data(), 9, nullptr, &out), VESICA_E_NULL);
  EXPECT_EQ(ask_for(9, good.data(), VESICA_RECT, good.data(), nullptr), VESICA_E_NULL);
  EXPECT_EQ(ask_for(VESICA_POLYLINE + 1, good.data(), VESICA_RECT, bad.data(), &out), VESICA_E_KIND);
  EXPECT_EQ(ask_for(VESICA_RECT, bad.data(), -1, good.data(), &out), VESICA_E_KIND);
  for (int kind = VESICA_POINT; kind <= VESICA_ELLIPSE; ++kind) {
    EXPECT_EQ(ask_for(VESICA_RECT, bad.data(), kind, good.data(), &out), VESICA_E_SHAPE);
    EXPECT_EQ(ask_for(kind, good.data(), VESICA_ELLIPSE, bad.data(), &out), VESICA_E_SHAPE);
    properties::NumbersOf<T> nan = good;
    nan[1] = std::numeric_limits<T>::quiet_NaN();
    EXPECT_EQ(ask_for(kind, nan.data(), VESICA_ELLIPSE, good.data(), &out), VESICA_E_SHAPE);
  }
  EXPECT_TRUE(out.distance == 7 && out.ax == 7 && out.ay == 7 && out.bx == 7 && out.by == 7);
}

TEST(BoundaryDistanceErrors, LeaveTheResultAlone) {
  expect_errors<double, vesica_closest_points_f64>(vesica_boundary_distance_f64);
  expect_errors<float, vesica_closest_points_f32>(vesica_boundary_distance_f32);
}

}  // namespace
