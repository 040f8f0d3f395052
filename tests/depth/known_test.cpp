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
  double depth, x, y;
};

vesica_penetration_f64 ask(const Case& c) {
  vesica_penetration_f64 out{-1, -1, -1};
  EXPECT_EQ(vesica_depth_f64(c.kind_a, c.a.data(), c.kind_b, c.b.data(), &out), 0) << c.name;
  return out;
}

vesica_penetration_f32 ask_f32(const Case& c) {
  properties::NumbersOf<float> a{}, b{};
  for (std::size_t i = 0; i < 6; ++i) a[i] = static_cast<float>(c.a[i]), b[i] = static_cast<float>(c.b[i]);
  vesica_penetration_f32 out{-1, -1, -1};
  EXPECT_EQ(vesica_depth_f32(c.kind_a, a.data(), c.kind_b, b.data(), &out), 0) << c.name;
  return out;
}

Case exchanged(const Case& c) { return {c.name, c.kind_b, c.b, c.kind_a, c.a, c.depth, -c.x, -c.y}; }

void expect(const Case& c) {
  const auto found = ask(c);
  EXPECT_DOUBLE_EQ(found.depth, c.depth) << c.name;
  EXPECT_NEAR(found.x, c.x, 1e-15) << c.name;
  EXPECT_NEAR(found.y, c.y, 1e-15) << c.name;
  const auto in_float = ask_f32(c);
  EXPECT_FLOAT_EQ(in_float.depth, static_cast<float>(c.depth)) << c.name;
  EXPECT_NEAR(static_cast<double>(in_float.x), c.x, 1e-6) << c.name;
  EXPECT_NEAR(static_cast<double>(in_float.y), c.y, 1e-6) << c.name;
}

TEST(DepthKnown, Overlapping) {
  const std::vector<Case> cases{
      {"point, circle", VESICA_POINT, {1, 0}, VESICA_CIRCLE, {0, 0, 3}, 2, -1, 0},
      {"point, aabb", VESICA_POINT, {2, 1}, VESICA_AABB, {0, 0, 10, 4}, 1, 0, 1},
      {"point, rect", VESICA_POINT, {1, 3}, VESICA_RECT, {0, 0, 0.6, 0.8, 5, 2}, 1, 0.8, -0.6},
      {"point, ellipse", VESICA_POINT, {0, 1}, VESICA_ELLIPSE, {0, 0, 1, 0, 5, 3}, 2, 0, -1},
      {"segment, segment", VESICA_SEGMENT, {0, 0, 4, 0}, VESICA_SEGMENT, {1, -1, 1, 3}, 1, 0, 1},
      {"segment, circle", VESICA_SEGMENT, {-4, 1, 4, 1}, VESICA_CIRCLE, {0, 0, 3}, 2, 0, -1},
      {"segment, aabb", VESICA_SEGMENT, {1, -5, 1, 5}, VESICA_AABB, {0, -2, 6, 2}, 1, 1, 0},
      {"segment, rect", VESICA_SEGMENT, {-8, -6.5, 4, 9.5}, VESICA_RECT, {0, 0, 3, 4, 1, 1}, 2.5, 0.8, -0.6},
      {"segment, ellipse", VESICA_SEGMENT, {-9, 1, 9, 1}, VESICA_ELLIPSE, {0, 0, 1, 0, 5, 3}, 2, 0, -1},
      {"circle, circle", VESICA_CIRCLE, {0, 0, 5}, VESICA_CIRCLE, {3, 4, 3}, 3, 0.6, 0.8},
      {"circle, aabb", VESICA_CIRCLE, {1, 5, 2}, VESICA_AABB, {0, 0, 10, 4}, 1, 0, -1},
      {"circle, rect", VESICA_CIRCLE, {6, 8, 6}, VESICA_RECT, {0, 0, 0, 1, 4, 3}, 1, -0.6, -0.8},
      {"circle, ellipse", VESICA_CIRCLE, {0, 3.5, 1}, VESICA_ELLIPSE, {0, 0, 1, 0, 5, 3}, 0.5, 0, -1},
      {"aabb, aabb", VESICA_AABB, {0, 0, 4, 4}, VESICA_AABB, {3, 1, 8, 3}, 1, 1, 0},
      {"aabb, rect", VESICA_AABB, {-2, -2, 2, 2}, VESICA_RECT, {4, 0, 1, 1, 1.5, 1.5}, 1, 1, 0},
      {"aabb, ellipse", VESICA_AABB, {-2, -2, 2, 2}, VESICA_ELLIPSE, {6, 0, 1, 0, 5, 3}, 1, 1, 0},
      {"rect, rect", VESICA_RECT, {0, 0, 0.6, 0.8, 3, 2}, VESICA_RECT, {3, 4, 6, 8, 0.3, 0.5}, 1, 0.6, 0.8},
      {"rect, ellipse", VESICA_RECT, {0, 0, 0, 1, 2, 4}, VESICA_ELLIPSE, {0, 4, 0, 1, 3, 5}, 1, 0, 1},
      {"ellipse, ellipse", VESICA_ELLIPSE, {0, 0, 1, 0, 5, 3}, VESICA_ELLIPSE, {7, 0, 1, 0, 3, 4}, 1, 1, 0},
      {"circle in circle", VESICA_CIRCLE, {0, 0, 5}, VESICA_CIRCLE, {0.75, 1, 1}, 4.75, 0.6, 0.8},
      {"ellipse in rect", VESICA_RECT, {0, 0, 3, 4, 2, 1}, VESICA_ELLIPSE, {2.2, 4.6, 3, 4, 0.4, 0.2}, 5, -0.8, 0.6},
  };
  for (const Case& c : cases) {
    expect(c);
    expect(exchanged(c));
  }
}

TEST(DepthKnown, TouchingHasDepthZeroAndADirection) {
  const std::vector<Case> cases{
      {"point on a rim", VESICA_POINT, {3, 4}, VESICA_CIRCLE, {0, 0, 5}, 0, -0.6, -0.8},
      {"point on a side", VESICA_POINT, {3, 2}, VESICA_AABB, {0, 0, 3, 9}, 0, -1, 0},
      {"point at a vertex", VESICA_POINT, {6, 8}, VESICA_ELLIPSE, {0, 0, 3, 4, 2, 1}, 0, -0.6, -0.8},
      {"point of a segment", VESICA_SEGMENT, {0, 0, 6, 8}, VESICA_POINT, {3, 4}, 0, 0.8, -0.6},
      {"segments on one line", VESICA_SEGMENT, {0, 0, 6, 8}, VESICA_SEGMENT, {3, 4, 9, 12}, 0, 0.8, -0.6},
      {"a segment along a side", VESICA_AABB, {0, 0, 4, 4}, VESICA_SEGMENT, {1, 4, 2, 4}, 0, 0, 1},
      {"a tangent", VESICA_SEGMENT, {-7, 5, 7, 5}, VESICA_CIRCLE, {0, 0, 5}, 0, 0, -1},
      {"discs", VESICA_CIRCLE, {0, 0, 5}, VESICA_CIRCLE, {6, 8, 5}, 0, 0.6, 0.8},
      {"sides", VESICA_AABB, {0, 0, 4, 4}, VESICA_RECT, {6, 2, 0, 2, 5, 1}, 0, 1, 0},
      {"a vertex on a side", VESICA_AABB, {0, 0, 3, 9}, VESICA_ELLIPSE, {7, 4, 1, 0, 4, 2}, 0, 1, 0},
      {"vertices", VESICA_ELLIPSE, {0, 0, 3, 4, 2, 1}, VESICA_ELLIPSE, {9, 12, 3, 4, 1, 2}, 0, 0.6, 0.8},
  };
  for (const Case& c : cases) {
    const auto found = ask(c), back = ask(exchanged(c));
    EXPECT_EQ(found.depth, 0) << c.name;
    EXPECT_EQ(back.depth, 0) << c.name;
    // Without area on either side the opposite direction is as good.
    const bool flat = c.kind_a <= VESICA_SEGMENT && c.kind_b <= VESICA_SEGMENT;
    const double side = flat && found.x * c.x + found.y * c.y < 0 ? -1 : 1;
    EXPECT_NEAR(side * found.x, c.x, 1e-15) << c.name;
    EXPECT_NEAR(side * found.y, c.y, 1e-15) << c.name;
    EXPECT_TRUE(back.x == -found.x && back.y == -found.y) << c.name;
  }
}

TEST(DepthKnown, OneNumberPastTouchingIsAboveZero) {
  const double past = std::nextafter(5, 6);
  EXPECT_GT(ask({"", VESICA_CIRCLE, {0, 0, past}, VESICA_CIRCLE, {6, 8, 5}, 0, 0, 0}).depth, 0);
  EXPECT_LT(ask({"", VESICA_CIRCLE, {0, 0, past}, VESICA_CIRCLE, {6, 8, 5}, 0, 0, 0}).depth, 1e-14);
  EXPECT_GT(ask({"", VESICA_POINT, {3, 4}, VESICA_CIRCLE, {0, 0, past}, 0, 0, 0}).depth, 0);
  EXPECT_GT(ask({"", VESICA_AABB, {0, 0, past, 1}, VESICA_AABB, {5, 0, 6, 1}, 0, 0, 0}).depth, 0);
  EXPECT_GT(ask({"", VESICA_ELLIPSE, {0, 0, 3, 4, 1, past}, VESICA_ELLIPSE, {-40, 30, 3, 4, 1, 5}, 0, 0, 0}).depth, 0);
  EXPECT_GT(ask({"", VESICA_SEGMENT, {0, 0, 4, 0}, VESICA_SEGMENT, {1, -0x1p-1074, 1, 3}, 0, 0, 0}).depth, 0);
}

TEST(DepthKnown, DisjointShapesGiveZeros) {
  for (const Case& c : {Case{"", VESICA_CIRCLE, {0, 0, 5}, VESICA_CIRCLE, {6, 9, 5}, 0, 0, 0},
                        Case{"", VESICA_POINT, {0, 0}, VESICA_POINT, {0, 0x1p-1074}, 0, 0, 0},
                        Case{"", VESICA_RECT, {0, 0, 3, 4, 1, 1}, VESICA_ELLIPSE, {1e300, 0, 3, 4, 1, 1}, 0, 0, 0}}) {
    const auto found = ask(c);
    EXPECT_TRUE(found.depth == 0 && found.x == 0 && found.y == 0);
  }
}

TEST(DepthKnown, ConcentricShapesTakeTheShortWayOut) {
  const auto found = ask({"", VESICA_ELLIPSE, {1, 2, 3, 4, 2, 1}, VESICA_ELLIPSE, {1, 2, 3, 4, 2, 1}, 0, 0, 0});
  EXPECT_DOUBLE_EQ(found.depth, 10);
  EXPECT_NEAR(std::abs(found.x * 0.8 - found.y * 0.6), 1, 1e-15);
  EXPECT_EQ(ask({"", VESICA_POINT, {1, 2}, VESICA_POINT, {1, 2}, 0, 0, 0}).depth, 0);
}

TEST(DepthKnown, AllScales) {
  for (const int exponent : {-1060, -1000, -500, -40, 40, 500, 1000}) {
    const double k = std::ldexp(1, exponent);
    const properties::NumbersOf<double> a{0, 0, k, 0, 5, 3}, b{7 * k, 0, 1, 0, 3 * k, 4 * k}, box{7 * k, 0, 0, k, 4, 3};
    vesica_penetration_f64 out;
    for (const int kind : {VESICA_ELLIPSE, VESICA_RECT}) {
      ASSERT_EQ(vesica_depth_f64(VESICA_ELLIPSE, a.data(), kind, kind == VESICA_RECT ? box.data() : b.data(), &out), 0);
      EXPECT_DOUBLE_EQ(out.depth, k) << exponent;
      EXPECT_NEAR(out.x, 1, 1e-15) << exponent;
      ASSERT_EQ(vesica_depth_f64(VESICA_RECT, a.data(), kind, kind == VESICA_RECT ? box.data() : b.data(), &out), 0);
      EXPECT_DOUBLE_EQ(out.depth, k) << exponent;
    }
  }
}

TEST(DepthKnown, MixedScales) {
  const double tiny = 0x1p-1074, huge = 0x1p1023;
  EXPECT_EQ(ask({"", VESICA_CIRCLE, {0, 0, tiny}, VESICA_CIRCLE, {0, 0, huge}, 0, 0, 0}).depth, huge);
  EXPECT_EQ(ask({"", VESICA_SEGMENT, {-huge, 0, huge, 0}, VESICA_SEGMENT, {0, -tiny, 0, tiny}, 0, 0, 0}).depth, tiny);
  EXPECT_DOUBLE_EQ(
      ask({"", VESICA_ELLIPSE, {0, 0, 1, 0, 1, 1e-300}, VESICA_ELLIPSE, {0, 0, 1, 0, 0.5, 1e-300}, 0, 0, 0}).depth,
      2e-300);
}

TEST(DepthKnown, AboveTheRangeIsAnErrorAndFloatsStayAboveZero) {
  const properties::NumbersOf<double> vast{0, 0, 1e300, 0, 1e300, 1e300}, point{0, 0};
  vesica_penetration_f64 out{7, 7, 7};
  EXPECT_EQ(vesica_depth_f64(VESICA_ELLIPSE, vast.data(), VESICA_POINT, point.data(), &out), VESICA_E_RANGE);
  EXPECT_EQ(vesica_depth_f64(VESICA_POINT, point.data(), VESICA_RECT, vast.data(), &out), VESICA_E_RANGE);
  EXPECT_TRUE(out.depth == 7 && out.x == 7 && out.y == 7);
  const properties::NumbersOf<float> broad{0, 0, 1, 0, 3e38f, 3e38f};
  vesica_penetration_f32 narrow{7, 7, 7};
  EXPECT_EQ(vesica_depth_f32(VESICA_RECT, broad.data(), VESICA_ELLIPSE, broad.data(), &narrow), VESICA_E_RANGE);
  EXPECT_EQ(narrow.depth, 7);
  const properties::NumbersOf<float> thin{0, 0, 0x1p-100f, 0, 0x1p-100f, 0x1p-100f};
  const std::array<float, 2> origin{0, 0};
  ASSERT_EQ(vesica_depth_f32(VESICA_ELLIPSE, thin.data(), VESICA_POINT, origin.data(), &narrow), 0);
  EXPECT_EQ(narrow.depth, 0x1p-149f);
}

/// Errors come in the order NULL, kind, shape, and leave the result alone.
template <class T, class Out, class Ask>
void expect_errors(Ask ask_for) {
  const properties::NumbersOf<T> good{0, 0, 1, 0, 2, 1}, bad{0, 0, 0, 0, 2, 1};
  Out out{7, 7, 7};
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
  EXPECT_TRUE(out.depth == 7 && out.x == 7 && out.y == 7);
}

TEST(DepthErrors, LeaveTheResultAlone) {
  expect_errors<double, vesica_penetration_f64>(vesica_depth_f64);
  expect_errors<float, vesica_penetration_f32>(vesica_depth_f32);
}

}  // namespace
