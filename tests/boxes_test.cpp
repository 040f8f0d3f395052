// SPDX-License-Identifier: Apache-2.0
// Arrays of boxes: known answers, strides, errors beside valid neighbours, and accuracy against 115 digits.
#include <gtest/gtest.h>
#include <vesica.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

#include "area/real.hpp"
#include "properties/random.hpp"

namespace {

using properties::Random;
using properties::repeat;
using properties::seed;
using reference::Real;

using Box = std::array<double, 5>;

vesica_rect_f64 rect(const Box& box, std::int32_t unit, std::int64_t returned = 0) {
  vesica_rect_f64 out{};
  EXPECT_EQ(vesica_rects_from_boxes_f64(box.data(), 1, 0, unit, &out), returned);
  return out;
}

vesica_shapes_f64 array_of(std::int32_t kind, std::int64_t count, const void* records, ptrdiff_t stride) {
  vesica_shapes_f64 shapes;
  EXPECT_EQ(vesica_shapes_from_records_f64(kind, count, records, stride, &shapes), 0);
  return shapes;
}

/// The unit in the last place of a double of this size.
double last_place(double x) { return std::fabs(x) - std::nextafter(std::fabs(x), -1); }
double error_in_ulps(double found, const Real& exact) {
  const double nearest = static_cast<double>(exact);
  return static_cast<double>(abs(Real(found) - exact) / std::max(last_place(nearest), 0x1p-1074));
}

const Real& pi() {
  static const Real pi = Real(4) * atan(Real(1));
  return pi;
}

TEST(Boxes, QuartersAreExact) {
  for (int quarters = -8; quarters <= 8; ++quarters) {
    const double x[] = {1, 0, -1, 0}, y[] = {0, 1, 0, -1};
    const auto k = static_cast<std::size_t>(quarters & 3);
    for (const auto& r : {rect({3, 4, 6, 2, 90.0 * quarters}, VESICA_ANGLE_DEGREES),
                          rect({3, 4, 6, 2, 1.0 * quarters}, VESICA_ANGLE_QUARTERS),
                          rect({3, 4, 6, 2, -90.0 * quarters}, VESICA_ANGLE_DEGREES + VESICA_ANGLE_REVERSED)}) {
      EXPECT_EQ(r.ux, x[k]);
      EXPECT_EQ(r.uy, y[k]);
      EXPECT_EQ(r.cx, 3);
      EXPECT_EQ(r.cy, 4);
      EXPECT_EQ(r.hx, 3);
      EXPECT_EQ(r.hy, 1);
    }
  }
  EXPECT_EQ(rect({0, 0, 1, 1, 0x1p60 * 90}, VESICA_ANGLE_DEGREES).ux, 1);
  EXPECT_FALSE(std::signbit(rect({0, 0, 1, 1, 90}, VESICA_ANGLE_DEGREES).ux));
}

TEST(Boxes, AxesAreAccurate) {
  Random random(seed());
  for (int i = 0; i < 20000 * repeat(); ++i) {
    const double turn = random.chance(0.5) ? random.between(-720, 720) : 45.0 * random.integer(-16, 16);
    const double degrees = random.chance(0.2) ? std::nextafter(turn, 1e9) : turn;
    const auto r = rect({0, 0, 1, 1, degrees}, VESICA_ANGLE_DEGREES);
    const Real angle = Real(degrees) * pi() / Real(180);
    // At a whole number of quarter turns one of them is 0, which has no last place.
    if (std::fmod(degrees, 90) != 0) {
      EXPECT_LE(error_in_ulps(r.ux, cos(angle)), 1.1) << degrees;
      EXPECT_LE(error_in_ulps(r.uy, sin(angle)), 1.1) << degrees;
    }
    const double quarters = random.chance(0.1) ? random.integer(-3, 3) * (std::acos(0.0) / 2) : random.between(-8, 8);
    const auto q = rect({0, 0, 1, 1, quarters}, VESICA_ANGLE_QUARTERS);
    EXPECT_LE(error_in_ulps(q.ux, cos(Real(quarters) * pi() / Real(2))), 1.1) << quarters;
    EXPECT_LE(error_in_ulps(q.uy, sin(Real(quarters) * pi() / Real(2))), 1.1) << quarters;
    const auto plain = rect({0, 0, 1, 1, quarters}, VESICA_ANGLE_RADIANS);
    EXPECT_LE(error_in_ulps(plain.ux, cos(Real(quarters))), 1.1) << quarters;
    EXPECT_LE(error_in_ulps(plain.uy, sin(Real(quarters))), 1.1) << quarters;
    vesica_rect_f64 alone;
    ASSERT_EQ(vesica_rect_from_angle_f64(0, 0, quarters, 1, 1, &alone), 0);
    EXPECT_EQ(std::memcmp(&plain, &alone, sizeof plain), 0);
  }
}

template <class T>
using RectOf = std::conditional_t<std::is_same_v<T, double>, vesica_rect_f64, vesica_rect_f32>;
template <class T>
using EllipseOf = std::conditional_t<std::is_same_v<T, double>, vesica_ellipse_f64, vesica_ellipse_f32>;

template <class T>
RectOf<T> rect_of(T width, T height, T angle, std::int32_t unit) {
  const T box[] = {5, 5, width, height, angle};
  RectOf<T> out{};
  if constexpr (std::is_same_v<T, double>) {
    EXPECT_EQ(vesica_rects_from_boxes_f64(box, 1, 0, unit, &out), 0);
  } else {
    EXPECT_EQ(vesica_rects_from_boxes_f32(box, 1, 0, unit, &out), 0);
  }
  return out;
}
template <class T>
EllipseOf<T> ellipse_of(T width, T height, T angle, std::int32_t unit) {
  const T box[] = {5, 5, width, height, angle};
  EllipseOf<T> out{};
  if constexpr (std::is_same_v<T, double>) {
    EXPECT_EQ(vesica_ellipses_from_boxes_f64(box, 1, 0, unit, &out), 0);
  } else {
    EXPECT_EQ(vesica_ellipses_from_boxes_f32(box, 1, 0, unit, &out), 0);
  }
  return out;
}
std::int32_t relation(const RectOf<double>& a, const RectOf<double>& b) {
  return vesica_relation_f64(VESICA_RECT, &a.cx, VESICA_RECT, &b.cx);
}
std::int32_t relation(const RectOf<float>& a, const RectOf<float>& b) {
  return vesica_relation_f32(VESICA_RECT, &a.cx, VESICA_RECT, &b.cx);
}
std::int32_t relation(const EllipseOf<double>& a, const EllipseOf<double>& b) {
  return vesica_relation_f64(VESICA_ELLIPSE, &a.cx, VESICA_ELLIPSE, &b.cx);
}
std::int32_t relation(const EllipseOf<float>& a, const EllipseOf<float>& b) {
  return vesica_relation_f32(VESICA_ELLIPSE, &a.cx, VESICA_ELLIPSE, &b.cx);
}

template <class T>
class BoxesOf : public testing::Test {
 protected:
  /// The axis at an angle, the complement's, the opposite's, and those some quarter turns on.
  static void expect_mirrored(T angle, T quarter, std::int32_t unit) {
    SCOPED_TRACE(testing::Message() << "angle " << angle << ", unit " << unit);
    const auto r = rect_of<T>(10, 6, angle, unit), complement = rect_of<T>(10, 6, quarter - angle, unit),
               opposite = rect_of<T>(10, 6, -angle, unit);
    const T sense = unit >= VESICA_ANGLE_REVERSED ? -1 : 1;
    EXPECT_EQ(complement.ux, sense * r.uy);
    EXPECT_EQ(complement.uy, sense * r.ux);
    EXPECT_EQ(opposite.ux, r.ux);
    EXPECT_EQ(opposite.uy, -r.uy);
    for (int k = -4; k <= 4; ++k) {
      const T turned = angle + static_cast<T>(k) * quarter;
      if (turned - static_cast<T>(k) * quarter != angle) continue;  // rounded: another angle
      const auto t = rect_of<T>(10, 6, turned, unit);
      const T x[] = {r.ux, -r.uy, -r.ux, r.uy}, y[] = {r.uy, r.ux, -r.uy, -r.ux};
      const int turns = sense < 0 ? -k & 3 : k & 3;
      EXPECT_EQ(t.ux, x[turns]);
      EXPECT_EQ(t.uy, y[turns]);
      const T width = k % 2 == 0 ? 10 : 6, height = k % 2 == 0 ? 6 : 10;
      EXPECT_EQ(relation(r, rect_of<T>(width, height, turned, unit)), VESICA_EQUAL) << k;
      EXPECT_EQ(relation(ellipse_of<T>(10, 6, angle, unit), ellipse_of<T>(width, height, turned, unit)), VESICA_EQUAL);
    }
  }
};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(BoxesOf, Scalars);

// At 45 degrees the components were a unit in the last place apart, so one rectangle said in two ways was CROSS.
TYPED_TEST(BoxesOf, ComplementsAreMirrored) {
  using T = TypeParam;
  for (const std::int32_t sense : {0, VESICA_ANGLE_REVERSED}) {
    for (int degrees = -360; degrees <= 360; degrees += 5) {
      this->expect_mirrored(static_cast<T>(degrees), 90, VESICA_ANGLE_DEGREES + sense);
    }
    for (int sixteenths = -64; sixteenths <= 64; ++sixteenths) {
      this->expect_mirrored(static_cast<T>(sixteenths) / 16, 1, VESICA_ANGLE_QUARTERS + sense);
    }
  }
  Random random(seed());
  for (int i = 0; i < 300 * repeat(); ++i) {
    // Digits that leave room for 360 degrees before the point: complements are then exact.
    constexpr int digits = std::numeric_limits<T>::digits - 10;
    const int exponent = random.integer(1, digits);
    const T fraction = static_cast<T>(std::ldexp(std::floor(std::ldexp(random.unit(), exponent)), -exponent));
    this->expect_mirrored(static_cast<T>(random.integer(-360, 359)) + fraction, 90, VESICA_ANGLE_DEGREES);
    this->expect_mirrored(static_cast<T>(random.integer(-4, 3)) + fraction, 1, VESICA_ANGLE_QUARTERS);
    const T beside = static_cast<T>(random.integer(-7, 7)) * static_cast<T>(std::ldexp(1, -digits));
    this->expect_mirrored(45 + beside, 90, VESICA_ANGLE_DEGREES);
  }
}

// In radians no number is an eighth turn: the nearest ones are taken for it from -pi to pi.
TYPED_TEST(BoxesOf, EighthTurnsInRadiansAreMirrored) {
  using T = TypeParam;
  const T eighth = static_cast<T>(std::acos(0.0) / 2), three = static_cast<T>(3 * (std::acos(0.0) / 2));
  for (const T angle : {eighth, -eighth, three, -three}) {
    const auto r = rect_of<T>(10, 6, angle, VESICA_ANGLE_RADIANS);
    EXPECT_EQ(std::fabs(r.ux), std::fabs(r.uy)) << angle;
    EXPECT_EQ(std::signbit(r.ux), std::fabs(angle) == three);
    EXPECT_EQ(std::signbit(r.uy), angle < 0);
    for (const T other : {eighth, -eighth, three, -three}) {
      const T between = std::fabs(angle - other);
      const bool along = between == 0 || (between > 3 && between < 4);
      const T width = along ? 10 : 6, height = along ? 6 : 10;
      EXPECT_EQ(relation(r, rect_of<T>(width, height, other, VESICA_ANGLE_RADIANS)), VESICA_EQUAL) << other;
    }
  }
}

TEST(Boxes, ThereAndBack) {
  Random random(seed());
  for (const std::int32_t unit : {VESICA_ANGLE_RADIANS, VESICA_ANGLE_DEGREES, VESICA_ANGLE_QUARTERS,
                                  VESICA_ANGLE_DEGREES + VESICA_ANGLE_REVERSED}) {
    const double quarter = (unit & 3) == 0 ? std::acos(0.0) : (unit & 3) == 1 ? 90 : 1;
    for (int i = 0; i < 5000 * repeat(); ++i) {
      const bool whole = random.chance(0.3);
      const Box box{random.between(-9, 9), random.between(-9, 9), random.between(0, 9), random.between(0, 9),
                    quarter * (whole ? random.integer(-1, 2) : random.between(-2, 2))};
      const auto r = rect(box, unit);
      const auto shapes = array_of(VESICA_RECT, 1, &r, 0);
      Box back;
      ASSERT_EQ(vesica_boxes_from_shapes_f64(&shapes, unit, back.data()), 0);
      EXPECT_EQ(back[0], box[0]);
      EXPECT_EQ(back[1], box[1]);
      EXPECT_NEAR(back[2], box[2], 5 * last_place(box[2]));
      EXPECT_NEAR(back[3], box[3], 5 * last_place(box[3]));
      EXPECT_NEAR(back[4], box[4], quarter * 0x1p-51) << unit;
      if (whole && unit != VESICA_ANGLE_RADIANS) {
        EXPECT_EQ(back[4], box[4]);
      }
    }
  }
}

TEST(Boxes, OfEllipses) {
  const Box box{1, 2, 6, 4, 90};
  vesica_ellipse_f64 e;
  ASSERT_EQ(vesica_ellipses_from_boxes_f64(box.data(), 1, 0, VESICA_ANGLE_DEGREES, &e), 0);
  const vesica_ellipse_f64 wanted{1, 2, 0, 1, 3, 2};
  EXPECT_EQ(std::memcmp(&e, &wanted, sizeof e), 0);
  const auto shapes = array_of(VESICA_ELLIPSE, 1, &e, 0);
  Box back;
  ASSERT_EQ(vesica_boxes_from_shapes_f64(&shapes, VESICA_ANGLE_DEGREES, back.data()), 0);
  EXPECT_EQ(back, box);
}

TEST(Boxes, Corners) {
  const vesica_rect_f64 r{10, 20, 0, 1, 3, 2};
  const auto shapes = array_of(VESICA_RECT, 1, &r, 0);
  std::array<double, 8> corners, wanted{12, 17, 12, 23, 8, 23, 8, 17};
  ASSERT_EQ(vesica_corners_of_shapes_f64(&shapes, corners.data()), 0);
  EXPECT_EQ(corners, wanted);
}

TEST(Boxes, CornersAreRightToALastPlace) {
  Random random(seed());
  double worst = 0;
  for (int i = 0; i < 5000 * repeat(); ++i) {
    const double far = std::ldexp(1, random.integer(-60, 60)), thin = std::ldexp(1, random.integer(-60, 60));
    const vesica_rect_f64 r{far * random.between(-1, 1), random.between(-1, 1),       random.between(-1, 1),
                            random.between(-1, 1),       thin * random.between(0, 1), random.between(0, 1)};
    const auto shapes = array_of(VESICA_RECT, 1, &r, 0);
    double corners[8];
    ASSERT_EQ(vesica_corners_of_shapes_f64(&shapes, corners), 0);
    const int along[] = {-1, 1, 1, -1}, across[] = {-1, -1, 1, 1};
    for (int k = 0; k < 4; ++k) {
      const Real p = Real(along[k] * r.hx), q = Real(across[k] * r.hy);
      const Real x = Real(r.cx) + p * r.ux - q * r.uy, y = Real(r.cy) + p * r.uy + q * r.ux;
      const double terms = std::max({std::fabs(r.cx), std::fabs(r.cy), r.hx, r.hy});
      for (const auto& [found, exact] : {std::pair(corners[2 * k], x), std::pair(corners[2 * k + 1], y)}) {
        const double allowed = last_place(static_cast<double>(exact)) + terms * 0x1p-98;
        worst = std::max(worst, static_cast<double>(abs(Real(found) - exact)) / allowed);
      }
    }
  }
  EXPECT_LE(worst, 1);
}

TEST(Boxes, OfAnyStrideAndBackwards) {
  unsigned char bytes[1 + 3 * 48] = {};
  const Box boxes[] = {{1, 1, 2, 2, 0}, {2, 2, 4, 4, 90}, {3, 3, 6, 6, 180}};
  for (std::size_t i = 0; i < 3; ++i) std::memcpy(bytes + 1 + 48 * i, boxes[i].data(), sizeof boxes[i]);
  vesica_rect_f64 out[3];
  const auto at = [&](std::size_t i) { return reinterpret_cast<const double*>(bytes + 1 + 48 * i); };
  ASSERT_EQ(vesica_rects_from_boxes_f64(at(2), 3, -48, VESICA_ANGLE_DEGREES, out), 0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(out[i].cx, boxes[2 - i][0]);
  EXPECT_EQ(out[1].uy, 1);
}

TEST(Boxes, AnInvalidOneLosesNoNeighbour) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Box boxes[] = {{1, 1, 2, 2, 0}, {2, 2, -4, 4, 90}, {3, 3, 6, 6, nan}, {4, 4, 2, 2, 0}};
  vesica_rect_f64 out[4];
  EXPECT_EQ(vesica_rects_from_boxes_f64(boxes[0].data(), 4, sizeof(Box), VESICA_ANGLE_DEGREES, out), VESICA_E_SHAPE);
  EXPECT_EQ(out[0].cx, 1);
  EXPECT_TRUE(std::isnan(out[1].cx) && std::isnan(out[1].hy) && std::isnan(out[2].ux));
  EXPECT_EQ(out[3].cx, 4);

  const vesica_rect_f64 rects[] = {
      {0, 0, 1, 0, 1, 1}, {0, 0, 0, 0, 1, 1}, {0, 0, 1e300, 0, 1e300, 1}, {5, 0, 1, 0, 1, 1}};
  const auto shapes = array_of(VESICA_RECT, 4, rects, sizeof rects[0]);
  double corners[32];
  EXPECT_EQ(vesica_corners_of_shapes_f64(&shapes, corners), VESICA_E_SHAPE);
  EXPECT_TRUE(std::isnan(corners[8]) && std::isnan(corners[16]));
  EXPECT_EQ(corners[24], 4);
  const auto huge = array_of(VESICA_RECT, 1, rects + 2, 0);
  EXPECT_EQ(vesica_corners_of_shapes_f64(&huge, corners), VESICA_E_RANGE);
  EXPECT_EQ(vesica_boxes_from_shapes_f64(&huge, VESICA_ANGLE_DEGREES, corners), VESICA_E_RANGE);

  vesica_aabb_f64 bounds[4];
  EXPECT_EQ(vesica_bounds_many_f64(&shapes, bounds), VESICA_E_SHAPE);
  EXPECT_EQ(bounds[0].max_x, 1);
  EXPECT_TRUE(std::isnan(bounds[1].min_x) && std::isnan(bounds[2].max_y));
  EXPECT_EQ(bounds[3].min_x, 4);
}

TEST(Boxes, Errors) {
  const Box box{0, 0, 1, 1, 0};
  vesica_rect_f64 out{7, 7, 7, 7, 7, 7};
  EXPECT_EQ(vesica_rects_from_boxes_f64(nullptr, 1, 0, 0, &out), VESICA_E_NULL);
  EXPECT_EQ(vesica_rects_from_boxes_f64(box.data(), 1, 0, 0, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_rects_from_boxes_f64(nullptr, 0, 0, 0, nullptr), 0);
  EXPECT_EQ(vesica_rects_from_boxes_f64(box.data(), -1, 0, 0, &out), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_rects_from_boxes_f64(box.data(), INT64_MAX, 40, 0, &out), VESICA_E_ARGUMENT);
  for (const std::int32_t unit : {-1, 3, 7, 8}) {
    EXPECT_EQ(vesica_rects_from_boxes_f64(box.data(), 1, 0, unit, &out), VESICA_E_ARGUMENT) << unit;
  }
  EXPECT_EQ(out.cx, 7);
  const auto circle = array_of(VESICA_CIRCLE, 1, box.data(), 0);
  double numbers[8] = {7};
  EXPECT_EQ(vesica_corners_of_shapes_f64(&circle, numbers), VESICA_E_KIND);
  EXPECT_EQ(vesica_boxes_from_shapes_f64(&circle, VESICA_ANGLE_DEGREES, numbers), VESICA_E_KIND);
  EXPECT_EQ(vesica_boxes_from_shapes_f64(nullptr, VESICA_ANGLE_DEGREES, numbers), VESICA_E_NULL);
  EXPECT_EQ(vesica_bounds_many_f64(&circle, nullptr), VESICA_E_NULL);
  EXPECT_EQ(numbers[0], 7);
}

TEST(Boxes, OfFloats) {
  const float box[] = {1.5f, 2.5f, 3, 5, 30};
  vesica_rect_f32 r;
  ASSERT_EQ(vesica_rects_from_boxes_f32(box, 1, 0, VESICA_ANGLE_DEGREES, &r), 0);
  EXPECT_EQ(r.uy, 0.5f);
  EXPECT_EQ(r.ux, static_cast<float>(std::sqrt(0.75)));
  EXPECT_EQ(r.hy, 2.5f);
}

TEST(Boxes, BoundsAreThoseOfOne) {
  const vesica_ellipse_f64 ellipses[] = {{0, 0, 0.6, 0.8, 3, 1}, {1, 2, 1, 1, 1, 2}};
  const auto shapes = array_of(VESICA_ELLIPSE, 2, ellipses, sizeof ellipses[0]);
  vesica_aabb_f64 many[2], one;
  ASSERT_EQ(vesica_bounds_many_f64(&shapes, many), 0);
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(vesica_bounds_f64(VESICA_ELLIPSE, &ellipses[i].cx, &one), 0);
    EXPECT_EQ(std::memcmp(&one, &many[i], sizeof one), 0);
  }
}

}  // namespace
