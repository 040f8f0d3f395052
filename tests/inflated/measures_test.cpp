// SPDX-License-Identifier: Apache-2.0
// Validity, bounds and areas.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "inflated/shapes.hpp"

namespace {

using namespace inflated;
using properties::Random;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Inflated, Check) {
  const vesica_capsule_f64 dot{1, 2, 1, 2, 0}, negative{0, 0, 1, 0, -1}, none{0, nan, 1, 0, 1};
  EXPECT_EQ(vesica_check_f64(VESICA_CAPSULE, &dot), 0);
  EXPECT_EQ(vesica_check_f64(VESICA_CAPSULE, &negative), VESICA_E_NEGATIVE_SIZE);
  EXPECT_EQ(vesica_check_f64(VESICA_CAPSULE, &none), VESICA_E_NOT_FINITE);
  const vesica_round_rect_f64 bare{1, 2, 1, 0, 0, 0, 0}, without_axis{0, 0, 0, 0, 1, 1, 1}, below{0, 0, 1, 0, 1, 1, -1};
  const vesica_round_rect_f64 thin{0, 0, 1, 0, -1, 1, 1};
  EXPECT_EQ(vesica_check_f64(VESICA_ROUND_RECT, &bare), 0);
  EXPECT_EQ(vesica_check_f64(VESICA_ROUND_RECT, &without_axis), VESICA_E_ZERO_AXIS);
  EXPECT_EQ(vesica_check_f64(VESICA_ROUND_RECT, &below), VESICA_E_NEGATIVE_SIZE);
  EXPECT_EQ(vesica_check_f64(VESICA_ROUND_RECT, &thin), VESICA_E_NEGATIVE_SIZE);
  const vesica_circle_f64 circle{0, 0, 9};
  EXPECT_EQ(vesica_overlap_f64(VESICA_CIRCLE, &circle, VESICA_ROUND_RECT, &below), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_overlap_f64(VESICA_CAPSULE, &negative, VESICA_CAPSULE, &dot), VESICA_E_SHAPE);
}

TEST(Inflated, KnownBounds) {
  vesica_aabb_f64 box;
  const vesica_capsule_f64 capsule{6, 8, 0, 1, 5};
  ASSERT_EQ(vesica_bounds_f64(VESICA_CAPSULE, &capsule, &box), 0);
  EXPECT_EQ((std::array{box.min_x, box.min_y, box.max_x, box.max_y}), (std::array{-5.0, -4.0, 11.0, 13.0}));
  const vesica_round_rect_f64 rect{1, 1, 3, 4, 2, 1, 5};
  ASSERT_EQ(vesica_bounds_f64(VESICA_ROUND_RECT, &rect, &box), 0);
  EXPECT_EQ((std::array{box.min_x, box.min_y, box.max_x, box.max_y}), (std::array{-14.0, -15.0, 16.0, 17.0}));
  const vesica_capsule_f64 beyond{0, 0, 0x1.8p1023, 0, 0x1.8p1023};
  EXPECT_EQ(vesica_bounds_f64(VESICA_CAPSULE, &beyond, &box), VESICA_E_RANGE);
}

/// The least double that is at least a + b.
double rounded_up(double a, double b) {
  const double sum = a + b, from_b = sum - a, error = (a - (sum - from_b)) + (b - from_b);
  return error > 0 ? std::nextafter(sum, std::numeric_limits<double>::infinity()) : sum;
}

TEST(Inflated, BoundsAreTheLeastDoubles) {
  Random random(properties::seed());
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    const Shape s = shape(VESICA_CAPSULE, random);
    const auto& [x0, y0, x1, y1, r, unused, none] = s.number;
    vesica_aabb_f64 box;
    ASSERT_EQ(vesica_bounds_f64(s.kind, s.number.data(), &box), 0);
    ASSERT_EQ(box.max_x, rounded_up(std::fmax(x0, x1), r));
    ASSERT_EQ(box.max_y, rounded_up(std::fmax(y0, y1), r));
    ASSERT_EQ(box.min_x, -rounded_up(-std::fmin(x0, x1), r));
    ASSERT_EQ(box.min_y, -rounded_up(-std::fmin(y0, y1), r));
  }
}

TEST(Inflated, KnownAreas) {
  constexpr double pi = std::numbers::pi;
  const auto area = [](std::int32_t kind, const auto& s) {
    double found = -1;
    EXPECT_EQ(vesica_shape_area_f64(kind, &s, &found), 0);
    return found;
  };
  EXPECT_EQ(area(VESICA_CAPSULE, vesica_capsule_f64{0, 0, 6, 8, 0}), 0);
  EXPECT_EQ(area(VESICA_CAPSULE, vesica_capsule_f64{6, 8, 6, 8, 1}), pi);
  EXPECT_EQ(area(VESICA_ROUND_RECT, vesica_round_rect_f64{1, 2, 3, 4, 2, 1, 0}), 200);
  EXPECT_EQ(area(VESICA_ROUND_RECT, vesica_round_rect_f64{1, 2, 3, 4, 0, 0, 2}), 4 * pi);
  // 10 long: 100 and 25 pi; about the rectangle of 20 by 10, 200 + 5 * 60 and 25 pi.
  EXPECT_DOUBLE_EQ(area(VESICA_CAPSULE, vesica_capsule_f64{0, 0, 6, 8, 5}), 100 + 25 * pi);
  EXPECT_DOUBLE_EQ(area(VESICA_ROUND_RECT, vesica_round_rect_f64{1, 2, 3, 4, 2, 1, 5}), 500 + 25 * pi);
  // Lengths times a power of two, out of the range of squares and back.
  const double unit = area(VESICA_CAPSULE, vesica_capsule_f64{0, 0, 3, 1, 0.7});
  for (const int e : {-500, -300, 300, 500}) {
    const double k = std::ldexp(1.0, e);
    EXPECT_EQ(area(VESICA_CAPSULE, vesica_capsule_f64{0, 0, 3 * k, k, 0.7 * k}), std::ldexp(unit, 2 * e)) << e;
  }
  double found = 7;
  const vesica_capsule_f64 beyond{0, 0, 0x1p800, 0, 0x1p800};
  EXPECT_EQ(vesica_shape_area_f64(VESICA_CAPSULE, &beyond, &found), VESICA_E_RANGE);
  EXPECT_EQ(found, 7);
}

/// The same sets in other numbers, to the last place but one.
TEST(Inflated, CapsulesAsRoundedRectangles) {
  Random random(properties::seed());
  for (int i = 0; i < 2000 * properties::repeat(); ++i) {
    const double x = random.integer(-9, 9), y = random.integer(-9, 9), r = random.unit();
    const vesica_capsule_f64 capsule{-x, -y, x, y, r};
    const vesica_round_rect_f64 rect{0, 0, x, y, 1, 0, r};
    if (x == 0 && y == 0) continue;
    double a, b;
    ASSERT_EQ(vesica_shape_area_f64(VESICA_CAPSULE, &capsule, &a), 0);
    ASSERT_EQ(vesica_shape_area_f64(VESICA_ROUND_RECT, &rect, &b), 0);
    ASSERT_EQ(a, b);
  }
}

}  // namespace
