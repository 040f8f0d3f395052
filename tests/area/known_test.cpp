// SPDX-License-Identifier: Apache-2.0
// Areas and ratios that are known, at several scales; errors; shapes without area.
#include <gtest/gtest.h>
#include <vesica.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "area/reference.hpp"
#include "properties/generators.hpp"
#include "properties/random.hpp"

namespace {

struct Kinded {
  int kind;
  std::vector<double> numbers;
};

double area(const Kinded& a, const Kinded& b) {
  double out = -1;
  EXPECT_EQ(vesica_area_f64(a.kind, a.numbers.data(), b.kind, b.numbers.data(), &out), 0);
  return out;
}
double iou(const Kinded& a, const Kinded& b) {
  double out = -1;
  EXPECT_EQ(vesica_iou_f64(a.kind, a.numbers.data(), b.kind, b.numbers.data(), &out), 0);
  return out;
}
double shape_area(const Kinded& s) {
  double out = -1;
  EXPECT_EQ(vesica_shape_area_f64(s.kind, s.numbers.data(), &out), 0);
  return out;
}

constexpr double pi = 3.141592653589793;

const Kinded square{VESICA_AABB, {0, 0, 2, 2}};
const Kinded unit_circle{VESICA_CIRCLE, {0, 0, 1}};

TEST(KnownAreas, OfOneShape) {
  EXPECT_EQ(shape_area({VESICA_POINT, {3, 4}}), 0);
  EXPECT_EQ(shape_area({VESICA_SEGMENT, {0, 0, 3, 4}}), 0);
  EXPECT_EQ(shape_area(unit_circle), pi);
  EXPECT_EQ(shape_area({VESICA_CIRCLE, {9, 9, 2}}), 4 * pi);
  EXPECT_EQ(shape_area({VESICA_AABB, {-1, 2, 4, 5}}), 15);
  EXPECT_EQ(shape_area({VESICA_AABB, {0, 0, 0, 5}}), 0);
  EXPECT_EQ(shape_area({VESICA_RECT, {0, 0, 1, 0, 2, 3}}), 24);
  EXPECT_EQ(shape_area({VESICA_RECT, {0, 0, 3, 4, 2, 3}}), 600);
  EXPECT_EQ(shape_area({VESICA_ELLIPSE, {0, 0, 0, 1, 2, 3}}), 18.849555921538759);
  EXPECT_EQ(shape_area({VESICA_ELLIPSE, {0, 0, 0, -2, 0.5, 0.5}}), pi);
}

// The outline of a round shape 2^54 times as large as a box is a straight line through the box.
TEST(KnownAreas, OfABoxCutByAFarLargerOutline) {
  for (const double r : {0x1p58, 0x1p60, 0x1p600}) {
    const Kinded circle{VESICA_CIRCLE, {-5 * r, 0, 5 * r}}, oval{VESICA_ELLIPSE, {-5 * r, 0, 1, 0, 5 * r, 4 * r}};
    const Kinded oblique{VESICA_CIRCLE, {-3 * r, -4 * r, 5 * r}};
    for (const Kinded& round : {circle, oval}) {
      EXPECT_EQ(area(round, {VESICA_AABB, {-1, -1, 1, 1}}), 2);
      EXPECT_EQ(area(round, {VESICA_AABB, {-0.75, -1, 1.25, 1}}), 1.5);
      EXPECT_EQ(area(round, {VESICA_RECT, {0, 0, 3, 4, 1, 0.5}}), 25);
      EXPECT_EQ(area({VESICA_AABB, {0, -1, 1, 1}}, round), 0);
      EXPECT_EQ(area({VESICA_AABB, {-1, -1, 0, 1}}, round), 2);
    }
    // 3x + 4y <= 0 in [-1/2, 3/2] x [-1, 1]: of 1 - 3x/4 from -1/2 to 4/3.
    EXPECT_NEAR(area(oblique, {VESICA_AABB, {-0.5, -1, 1.5, 1}}), 121.0 / 96, 0x1p-50);
  }
}

// Half of an ellipse, and the part beyond half its longer radius: the share 1/3 - sqrt(3) / (4 pi) of the disc.
TEST(KnownAreas, OfAnEllipseCutByAFarLargerOutline) {
  for (const double r : {0x1p58, 0x1p60, 0x1p600}) {
    const Kinded circle{VESICA_CIRCLE, {-5 * r, 0, 5 * r}}, oval{VESICA_ELLIPSE, {-5 * r, 0, 1, 0, 5 * r, 4 * r}};
    for (const Kinded& round : {circle, oval}) {
      EXPECT_DOUBLE_EQ(area(round, {VESICA_ELLIPSE, {0, 0, 1, 0, 1.5, 0.75}}), 1.125 * pi / 2);
      EXPECT_DOUBLE_EQ(area(round, {VESICA_ELLIPSE, {0, 0, 3, 4, 1.5, 0.75}}), 25 * 1.125 * pi / 2);
      EXPECT_DOUBLE_EQ(area({VESICA_ELLIPSE, {0, 0, 0, 1, 40, 3}}, round), 120 * pi / 2);
      EXPECT_DOUBLE_EQ(area({VESICA_CIRCLE, {0, 0, 1.75}}, round), 3.0625 * pi / 2);
      EXPECT_DOUBLE_EQ(area(round, {VESICA_ELLIPSE, {0.75, 0, 1, 0, 1.5, 0.75}}),
                       1.125 * (pi / 3 - std::sqrt(3.0) / 4));
    }
  }
}

// Were a last place off: rounded to 53 bits first and to fewer then.
TEST(KnownAreas, SubnormalOnesAreRoundedOnce) {
  const Kinded rect{VESICA_RECT, {0, 0, 1, 0x1.e4715p-4, 0x1p-513, 0x1.f4p-512}};
  const Kinded turned{VESICA_RECT, {0, 0, 0x1.e4715ep-2, 1, 0x1.4p-514, 0x1.ep-512}};
  const Kinded ellipse{VESICA_ELLIPSE, {0, 0, 0, 2, 0x1p-514, 0x1.8p-514}};
  EXPECT_EQ(shape_area(rect), 4459567686302891 * 0x1p-1074);
  EXPECT_EQ(shape_area(turned), 3229431709444577 * 0x1p-1074);
  EXPECT_EQ(shape_area(ellipse), 1326419578505333 * 0x1p-1074);
  EXPECT_EQ(area(rect, {VESICA_AABB, {-1, -1, 1, 1}}), shape_area(rect));
}

TEST(KnownAreas, OfBoxes) {
  EXPECT_EQ(area(square, {VESICA_AABB, {1, 1, 3, 3}}), 1);
  EXPECT_EQ(area(square, {VESICA_AABB, {0.5, -1, 1.5, 3}}), 2);
  EXPECT_EQ(area(square, {VESICA_AABB, {2, 0, 4, 2}}), 0);
  EXPECT_EQ(area(square, {VESICA_AABB, {5, 5, 6, 6}}), 0);
  EXPECT_EQ(area(square, {VESICA_AABB, {0.5, 0.5, 1, 1}}), 0.25);
  EXPECT_EQ(area(square, {VESICA_RECT, {1, 1, 1, 1, 0.75, 0.75}}), 3.5);                     // an octagon
  EXPECT_EQ(area({VESICA_RECT, {0, 0, 1, 0, 1, 1}}, {VESICA_RECT, {1, 1, 1, 1, 1, 1}}), 2);  // half of the square
  EXPECT_EQ(area({VESICA_RECT, {0, 0, 3, 4, 1, 1}}, {VESICA_RECT, {3, 4, 4, -3, 1, 1}}), 50);
}

// The values with an ellipse are of a computation with 60 digits.
TEST(KnownAreas, WithEllipses) {
  EXPECT_DOUBLE_EQ(area(unit_circle, {VESICA_CIRCLE, {1, 0, 1}}), 1.2283696986087567);
  EXPECT_DOUBLE_EQ(area(unit_circle, {VESICA_AABB, {0, 0, 5, 5}}), pi / 4);
  EXPECT_DOUBLE_EQ(area(unit_circle, {VESICA_AABB, {0, -5, 5, 5}}), pi / 2);
  EXPECT_DOUBLE_EQ(area(unit_circle, {VESICA_AABB, {-5, 0.5, 5, 5}}), pi / 3 - std::sqrt(3.0) / 4);
  EXPECT_DOUBLE_EQ(area(unit_circle, {VESICA_AABB, {-5, -0.5, 5, 5}}), 2 * pi / 3 + std::sqrt(3.0) / 4);
  EXPECT_DOUBLE_EQ(area({VESICA_ELLIPSE, {0, 0, 1, 0, 2, 1}}, {VESICA_ELLIPSE, {0, 0, 0, 1, 2, 1}}),
                   8 * std::atan(0.5));
  EXPECT_EQ(area(unit_circle, {VESICA_CIRCLE, {2, 0, 1}}), 0);
  EXPECT_EQ(area(unit_circle, {VESICA_CIRCLE, {0.5, 0, 0.5}}), pi / 4);
  EXPECT_EQ(area(unit_circle, {VESICA_AABB, {-1, -1, 1, 1}}), pi);
}

TEST(KnownAreas, AtAnyScale) {
  for (const int exponent : {-500, -30, 0, 40, 500, 510}) {
    const double s = std::ldexp(1, exponent);
    SCOPED_TRACE(exponent);
    const Kinded box{VESICA_AABB, {0, 0, 2 * s, 2 * s}}, circle{VESICA_CIRCLE, {0, 0, s}};
    EXPECT_EQ(area(box, {VESICA_RECT, {s, s, s, s, 0.75, 0.75}}), 3.5 * s * s);
    EXPECT_EQ(area(box, {VESICA_RECT, {s, s, 1, 1, 0.75 * s, 0.75 * s}}), 3.5 * s * s);
    EXPECT_EQ(iou(box, {VESICA_AABB, {s, s, 3 * s, 3 * s}}), 1.0 / 7);
    EXPECT_EQ(area(circle, {VESICA_CIRCLE, {s, 0, s}}) / (s * s), area(unit_circle, {VESICA_CIRCLE, {1, 0, 1}}));
    EXPECT_EQ(area(circle, box) / (s * s), area(unit_circle, square));
  }
}

// Two boxes across each other, the axis of one far longer or shorter than 1: no number between overflows, and none
// loses digits to underflow.
TEST(KnownAreas, OfBoxesWithAxesOfAnyLength) {
  constexpr double height = 0x1.6a09e6p-3, width = 0x1.279a74p-3;
  for (int axis = -300; axis <= 300; axis += 3) {
    for (const int sizes : {-195, 0, 195}) {
      SCOPED_TRACE(testing::Message() << "axis 2^" << axis << ", sizes 2^" << sizes);
      const int unit = axis + sizes;
      for (const double longer : {0.5, 4.0}) {  // either of the boxes may be the lesser one
        const Kinded upright{VESICA_RECT,
                             {0, 0, 0, std::ldexp(1, axis), std::ldexp(longer, sizes), std::ldexp(width, sizes)}};
        const Kinded level{VESICA_RECT, {0, 0, 1, 0, std::ldexp(1, unit), std::ldexp(height, unit)}};
        const double expected = std::ldexp(4 * height * width, 2 * unit);
        EXPECT_DOUBLE_EQ(area(upright, level), expected);
        EXPECT_DOUBLE_EQ(area(level, upright), expected);
      }
    }
  }
}

// Parallel boxes whose corners are whole numbers in units of their own along either axis: however thin they are, only
// two lengths and their product are rounded.
TEST(KnownAreas, OfParallelBoxesAtAnyAspect) {
  properties::Random random(properties::seed() + 3);
  int asked = 0;
  for (const int i : {-1074, -1000, -500, -60, 0, 60, 500, 1000}) {
    for (const int j : {-1074, -1000, -500, -60, 0, 60, 500, 1000}) {
      if (std::abs(i - j) < 60 || i + j < -1074 || i + j > 1000) continue;
      for (int k = 0; k < 40; ++k) {
        const auto interval = [&] {
          const double low = random.integer(-9, 8);
          const double high = random.integer(static_cast<int>(low) + 1, 9);
          return std::pair{low, high};
        };
        const auto [x0, x1] = interval();
        const auto [y0, y1] = interval();
        const auto [z0, z1] = interval();
        const auto [w0, w1] = interval();
        const double width = std::max(0.0, std::min(x1, z1) - std::max(x0, z0));
        const double height = std::max(0.0, std::min(y1, w1) - std::max(y0, w0));
        const double expected = std::ldexp(width * height, i + j);
        const auto box = [i, j](double left, double low, double right, double high) {
          return Kinded{VESICA_AABB,
                        {std::ldexp(left, i), std::ldexp(low, j), std::ldexp(right, i), std::ldexp(high, j)}};
        };
        const Kinded a = box(x0, y0, x1, y1), b = box(z0, w0, z1, w1);
        EXPECT_DOUBLE_EQ(area(a, b), expected);
        EXPECT_EQ(area(b, a), area(a, b));
        ++asked;
        if (i < -1070 || j < -1070) continue;
        // The same box as one that is turned by a right angle: its first axis is (0, u).
        const double u = std::ldexp(1, random.integer(0, 3)), cx = std::ldexp((z0 + z1) / 2, i),
                     cy = std::ldexp((w0 + w1) / 2, j);
        const Kinded turned{VESICA_RECT,
                            {cx, cy, 0, u, std::ldexp((w1 - w0) / 2, j) / u, std::ldexp((z1 - z0) / 2, i) / u}};
        EXPECT_DOUBLE_EQ(area(a, turned), expected);
      }
    }
  }
  EXPECT_GT(asked, 500);
}

// A centre moved, an axis turned or a half length changed by one subnormal number: the outlines cross, and yet what is
// not shared is less than the outline's length times 2^-1000.
TEST(KnownAreas, OfShapesThatAllButCoincide) {
  constexpr double tiny = 0x1p-1074;
  const std::vector<std::pair<Kinded, Kinded>> pairs{
      {{VESICA_CIRCLE, {0, -tiny, 49}}, {VESICA_CIRCLE, {0, 0, 49}}},
      {{VESICA_CIRCLE, {0, tiny, 0x1.4p-131}}, {VESICA_ELLIPSE, {0, 0, -0x1.8p-137, 0x1p-136, 0x1p+5, 0x1p+5}}},
      {{VESICA_ELLIPSE, {0, 0, 1, 0, 3, 2}}, {VESICA_ELLIPSE, {tiny, -tiny, 1, 0, 3, 2}}},
      {{VESICA_ELLIPSE, {0, 0, 1, 0, 3, 2}}, {VESICA_ELLIPSE, {0, 0, 1, tiny, 3, 2}}},
      {{VESICA_ELLIPSE, {0, 0, 1, tiny, 4000, 0.5}}, {VESICA_ELLIPSE, {0, tiny, 1, 0, 4000, 0.5}}},
      {{VESICA_RECT, {0, 0, 1, 0, 3, 2}}, {VESICA_RECT, {0, 0, 1, tiny, 3, 2}}},
      {{VESICA_AABB, {-3, -2, 3, 2}}, {VESICA_RECT, {0, tiny, 1, 0, 3, 2}}},
  };
  for (const auto& [a, b] : pairs) {
    const auto code = [](const Kinded& s, const Kinded& t) {
      return vesica_relation_f64(s.kind, s.numbers.data(), t.kind, t.numbers.data());
    };
    ASSERT_EQ(code(a, b), VESICA_CROSS);
    const double whole = shape_area(a);
    EXPECT_EQ(shape_area(b), whole);
    for (const double shared : {area(a, b), area(b, a)}) {
      EXPECT_LE(shared, whole);
      EXPECT_GE(shared, whole * (1 - 16 * 0x1p-53));
    }
    EXPECT_GE(iou(a, b), 1 - 32 * 0x1p-53);
  }
}

// A tall ellipse touches the disc from the inside, at the middle of a slice, and crosses it below: which outline is the
// inner one is to be asked beside that place. With areas of 60 digits.
TEST(KnownAreas, OfOutlinesThatTouchFromTheInside) {
  const Kinded ellipses[] = {
      {VESICA_ELLIPSE, {0, -0x1.d42896a4370ecp-2, 1, 0, 0x1.0ec7bdc7b8921p-1, 0x1.750a25a90dc3ap+0}},
      {VESICA_ELLIPSE,
       {-0x1.50785c1f07738p-3, -0x1.43e0d06071448p-3, 0x1.63120dab0f062p-1, -0x1.70e00e2a0a279p-1, 0x1.cd1294b0dc9fp-2,
        0x1.3a60b186a449ap+0}},
      {VESICA_ELLIPSE,
       {-0x1.a50c27118accap-3, -0x1.7695985ed5e67p-1, 0x1.ece87b30a53cbp-1, -0x1.150625930e733p-2, 0x1.12d423def3cf6p-1,
        0x1.c28bed3d35ec6p+0}},
  };
  for (const Kinded& ellipse : ellipses) {
    const double expected =
        reference::area(unit_circle.kind, unit_circle.numbers.data(), ellipse.kind, ellipse.numbers.data());
    EXPECT_NEAR(area(unit_circle, ellipse), expected, 64 * 0x1p-53);
    EXPECT_NEAR(area(ellipse, unit_circle), expected, 64 * 0x1p-53);
  }
}

// Which of two equal boxes is cut by the other decides about the last digits: kernels take the same one as single
// calls.
TEST(KnownAreas, OfEqualBoxesInArrays) {
  constexpr int n = 64;
  properties::Random random(1);
  std::vector<std::array<double, 6>> first(n), second(n);
  for (int i = 0; i < n; ++i) {
    const auto axis = [&] { return random.between(-1, 1); };
    const double a = random.between(0.5, 1), b = random.between(0.5, 1), ux = axis(), uy = axis();
    first[i] = {0, 0, ux, uy, a, b};
    // The same length of the axis, so that areas are equal.
    second[i] = {i % 3 == 0 ? 0 : 0.2 * axis(), 0.2 * axis(), i % 2 == 0 ? uy : -ux, i % 2 == 0 ? ux : uy, b, a};
  }
  vesica_shapes_f64 of_first, of_second;
  vesica_shapes_from_records_f64(VESICA_RECT, n, first.data(), sizeof first[0], &of_first);
  vesica_shapes_from_records_f64(VESICA_RECT, n, second.data(), sizeof second[0], &of_second);
  std::vector<double> areas(n);
  ASSERT_EQ(vesica_area_many_f64(&of_first, &of_second, areas.data()), n);
  for (int i = 0; i < n; ++i) {
    double one = -1;
    EXPECT_EQ(vesica_area_f64(VESICA_RECT, first[i].data(), VESICA_RECT, second[i].data(), &one), 0);
    EXPECT_EQ(areas[i], one) << i;
  }
}

TEST(KnownAreas, Ratios) {
  EXPECT_EQ(iou(square, square), 1);
  EXPECT_EQ(iou(square, {VESICA_RECT, {1, 1, 0, -2, 0.5, 0.5}}), 1);
  EXPECT_EQ(iou(unit_circle, {VESICA_ELLIPSE, {0, 0, 3, 4, 0.2, 0.2}}), 0.99999999999999989);  // 0.2 is not a fifth
  EXPECT_EQ(iou(unit_circle, {VESICA_ELLIPSE, {0, 0, 0, 2, 0.5, 0.5}}), 1);
  EXPECT_EQ(iou(square, {VESICA_AABB, {1, 1, 3, 3}}), 1.0 / 7);
  EXPECT_EQ(iou(square, {VESICA_AABB, {1, 0, 3, 2}}), 1.0 / 3);
  EXPECT_EQ(iou(square, {VESICA_AABB, {0, 0, 1, 1}}), 0.25);
  EXPECT_EQ(iou(square, {VESICA_AABB, {2, 0, 4, 2}}), 0);
  EXPECT_EQ(iou(square, {VESICA_SEGMENT, {0, 0, 1, 1}}), 0);
  // Neither the areas nor their sum are finite numbers.
  EXPECT_EQ(iou({VESICA_AABB, {0, 0, 0x1p1000, 0x1p1000}}, {VESICA_AABB, {0, 0, 0x1p1000, 0x1p999}}), 0.5);
  EXPECT_EQ(iou({VESICA_AABB, {-0x1.8p1023, -1, 0x1.8p1023, 1}}, {VESICA_AABB, {0, -1, 0x1.8p1023, 1}}), 0.5);
  EXPECT_EQ(iou({VESICA_AABB, {0, 0, 0x1p-1060, 0x1p-1060}}, {VESICA_AABB, {0, 0, 0x1p-1061, 0x1p-1060}}), 0.5);
}

template <class Call>
void expect_untouched(std::int32_t error, const Call& call) {
  double out = 7;
  EXPECT_EQ(call(&out), error);
  EXPECT_EQ(out, 7);
}

TEST(AreaErrors, OfTwoShapes) {
  const double good[6] = {0, 0, 1, 0, 1, 1}, bad[6] = {0, 0, 0, 0, 1, 1}, point[2] = {0, 0};
  for (const auto query : {vesica_area_f64, vesica_iou_f64}) {
    EXPECT_EQ(query(VESICA_RECT, good, VESICA_RECT, good, nullptr), VESICA_E_NULL);
    expect_untouched(VESICA_E_NULL, [&](double* out) { return query(VESICA_RECT, nullptr, VESICA_RECT, good, out); });
    expect_untouched(VESICA_E_NULL, [&](double* out) { return query(99, good, VESICA_RECT, nullptr, out); });
    expect_untouched(VESICA_E_KIND,
                     [&](double* out) { return query(VESICA_POLYLINE + 1, good, VESICA_RECT, bad, out); });
    expect_untouched(VESICA_E_KIND, [&](double* out) { return query(VESICA_RECT, bad, -1, good, out); });
    expect_untouched(VESICA_E_SHAPE, [&](double* out) { return query(VESICA_RECT, bad, VESICA_RECT, good, out); });
    expect_untouched(VESICA_E_SHAPE, [&](double* out) { return query(VESICA_RECT, good, VESICA_ELLIPSE, bad, out); });
    expect_untouched(VESICA_E_SHAPE, [&](double* out) { return query(VESICA_POINT, point, VESICA_ELLIPSE, bad, out); });
    const double nan[2] = {std::numeric_limits<double>::quiet_NaN(), 0};
    expect_untouched(VESICA_E_SHAPE, [&](double* out) { return query(VESICA_POINT, nan, VESICA_POINT, nan, out); });
  }
}

TEST(AreaErrors, OfRatiosWithoutArea) {
  const double point[2] = {0, 0}, segment[4] = {0, 0, 1, 1}, flat[6] = {0, 0, 1, 0, 1, 0};
  expect_untouched(VESICA_E_ARGUMENT,
                   [&](double* out) { return vesica_iou_f64(VESICA_POINT, point, VESICA_POINT, point, out); });
  expect_untouched(VESICA_E_ARGUMENT,
                   [&](double* out) { return vesica_iou_f64(VESICA_SEGMENT, segment, VESICA_ELLIPSE, flat, out); });
  expect_untouched(VESICA_E_ARGUMENT,
                   [&](double* out) { return vesica_iou_f64(VESICA_RECT, flat, VESICA_RECT, flat, out); });
  const double far[4] = {50, 50, 50, 51};
  expect_untouched(VESICA_E_ARGUMENT,
                   [&](double* out) { return vesica_iou_f64(VESICA_RECT, flat, VESICA_AABB, far, out); });
  double out = 7;
  EXPECT_EQ(vesica_area_f64(VESICA_RECT, flat, VESICA_RECT, flat, &out), 0);
  EXPECT_EQ(out, 0);
}

TEST(AreaErrors, BeyondTheRange) {
  const double huge[4] = {0, 0, 0x1p600, 0x1p600}, large[4] = {-1, -1, 0x1p599, 0x1p599};
  expect_untouched(VESICA_E_RANGE,
                   [&](double* out) { return vesica_area_f64(VESICA_AABB, huge, VESICA_AABB, huge, out); });
  expect_untouched(VESICA_E_RANGE,
                   [&](double* out) { return vesica_area_f64(VESICA_AABB, huge, VESICA_AABB, large, out); });
  expect_untouched(VESICA_E_RANGE, [&](double* out) { return vesica_shape_area_f64(VESICA_AABB, huge, out); });
  const float wide[4] = {0, 0, 0x1p70f, 0x1p70f};
  float out = 7;
  EXPECT_EQ(vesica_area_f32(VESICA_AABB, wide, VESICA_AABB, wide, &out), VESICA_E_RANGE);
  EXPECT_EQ(vesica_shape_area_f32(VESICA_AABB, wide, &out), VESICA_E_RANGE);
  EXPECT_EQ(out, 7);
  EXPECT_EQ(vesica_iou_f32(VESICA_AABB, wide, VESICA_AABB, wide, &out), 0);
  EXPECT_EQ(out, 1);
}

TEST(AreaErrors, OfOneShape) {
  const double bad[6] = {0, 0, 0, 0, 1, 1};
  EXPECT_EQ(vesica_shape_area_f64(VESICA_RECT, bad, nullptr), VESICA_E_NULL);
  expect_untouched(VESICA_E_NULL, [](double* out) { return vesica_shape_area_f64(VESICA_RECT, nullptr, out); });
  expect_untouched(VESICA_E_KIND, [&](double* out) { return vesica_shape_area_f64(VESICA_POLYLINE + 1, bad, out); });
  expect_untouched(VESICA_E_SHAPE, [&](double* out) { return vesica_shape_area_f64(VESICA_RECT, bad, out); });
}

/// Correctly rounded: within half a place of 60 digits, on every workload and on widths whose product is a tie.
TEST(ShapeArea, IsTheNearestNumber) {
  using namespace properties;
  double worst = 0;
  for (int kind = VESICA_CIRCLE; kind <= VESICA_ELLIPSE; ++kind) {
    for (const Workload workload : all_workloads) {
      if (workload == Workload::near_contact) continue;
      Random random(seed());
      for (int i = 0; i < 150 * repeat(); ++i) {
        const Pair p = draw(workload, kind, kind, Scalar::f64, random);
        double out = 0;
        if (vesica_shape_area_f64(kind, p.a.data(), &out) != 0 || out < 0x1p-1022) continue;
        const double error = reference::shape_area_error_in_places(kind, p.a.data(), out);
        worst = std::fmax(worst, error);
        EXPECT_LE(error, 0.5) << describe(p) << ", seed " << seed();
      }
    }
  }
  EXPECT_GT(worst, 0.45);
  // (2^27 + 1)^2 = 2^54 + 2^28 + 1: halfway between two doubles, the lower one even.
  EXPECT_EQ(shape_area({VESICA_AABB, {0, 0, 0x1p27 + 1, 0x1p27 + 1}}), 0x1p54 + 0x1p28);
}

}  // namespace
