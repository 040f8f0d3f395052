// SPDX-License-Identifier: Apache-2.0
// Every documented error of every constructor, in its order, with the output left alone.
#include <gtest/gtest.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>

#include "capi/constructors.hpp"

namespace {

/// A constructor of `count` numbers, all in one array.
template <class T, class Shape>
struct Constructor {
  const char* name;
  int count;
  std::int32_t (*call)(const T*, Shape*);
  std::array<T, 8> valid;
};

template <class Api>
class ConstructErrors : public testing::Test {
 protected:
  using Scalar = typename Api::Scalar;
  using Aabb = typename Api::Aabb;
  using Rect = typename Api::Rect;
  using Ellipse = typename Api::Ellipse;
  using Capsule = typename Api::Capsule;
  using RoundRect = typename Api::RoundRect;
  using Numbers = std::array<Scalar, 8>;

  static constexpr Constructor<Scalar, Aabb> aabb_from_corners{
      "aabb_from_corners",
      4,
      [](const Scalar* n, Aabb* out) { return Api::aabb_from_corners(n[0], n[1], n[2], n[3], out); },
      {1, 2, 3, 4}};
  static constexpr Constructor<Scalar, Rect> rect_from_angle{
      "rect_from_angle",
      5,
      [](const Scalar* n, Rect* out) { return Api::rect_from_angle(n[0], n[1], n[2], n[3], n[4], out); },
      {1, 2, 3, 4, 5}};
  static constexpr Constructor<Scalar, Rect> rect_from_corners{
      "rect_from_corners",
      8,
      [](const Scalar* n, Rect* out) { return Api::rect_from_corners(n, out); },
      {0, 0, 2, 0, 2, 1, 0, 1}};
  static constexpr Constructor<Scalar, RoundRect> round_rect_from_angle{"round_rect_from_angle",
                                                                        6,
                                                                        [](const Scalar* n, RoundRect* out) {
                                                                          return Api::round_rect_from_angle(
                                                                              n[0], n[1], n[2], n[3], n[4], n[5], out);
                                                                        },
                                                                        {1, 2, 3, 4, 5, 1}};
  static constexpr Constructor<Scalar, Capsule> capsule_from_angle{
      "capsule_from_angle",
      5,
      [](const Scalar* n, Capsule* out) { return Api::capsule_from_angle(n[0], n[1], n[2], n[3], n[4], out); },
      {1, 2, 3, 4, 5}};
  static constexpr Constructor<Scalar, Capsule> capsule_from_width{
      "capsule_from_width",
      5,
      [](const Scalar* n, Capsule* out) { return Api::capsule_from_width(n[0], n[1], n[2], n[3], n[4], out); },
      {1, 2, 3, 4, 5}};
  static constexpr Constructor<Scalar, Ellipse> ellipse_from_angle{
      "ellipse_from_angle",
      5,
      [](const Scalar* n, Ellipse* out) { return Api::ellipse_from_angle(n[0], n[1], n[2], n[3], n[4], out); },
      {1, 2, 3, 4, 5}};
  static constexpr Constructor<Scalar, Ellipse> ellipse_from_radius_vector{
      "ellipse_from_radius_vector",
      5,
      [](const Scalar* n, Ellipse* out) { return Api::ellipse_from_radius_vector(n[0], n[1], n[2], n[3], n[4], out); },
      {1, 2, 3, 4, 5}};
  static constexpr Constructor<Scalar, Ellipse> ellipse_from_covariance{"ellipse_from_covariance",
                                                                        6,
                                                                        [](const Scalar* n, Ellipse* out) {
                                                                          return Api::ellipse_from_covariance(
                                                                              n[0], n[1], n[2], n[3], n[4], n[5], out);
                                                                        },
                                                                        {1, 2, 3, 0, 4, 1}};
  static constexpr Constructor<Scalar, Ellipse> ellipse_from_matrix{
      "ellipse_from_matrix",
      5,
      [](const Scalar* n, Ellipse* out) { return Api::ellipse_from_matrix(n[0], n[1], n[2], n[3], n[4], out); },
      {1, 2, 3, 0, 4}};

  template <class Shape>
  static void expect(const Constructor<Scalar, Shape>& constructor, const Numbers& numbers, std::int32_t error) {
    Shape out, before;
    std::memset(&out, 0x5a, sizeof out);
    before = out;
    errno = 0;
    EXPECT_EQ(constructor.call(numbers.data(), &out), error) << constructor.name;
    EXPECT_EQ(std::memcmp(&out, &before, sizeof out) == 0, error != 0) << constructor.name;
    EXPECT_EQ(errno, 0) << constructor.name;
  }

  /// `numbers` with its i-th replaced.
  static Numbers with(Numbers numbers, int i, Scalar value) {
    numbers[static_cast<std::size_t>(i)] = value;
    return numbers;
  }

  template <class Action>
  static void for_each_constructor(Action action) {
    action(aabb_from_corners);
    action(rect_from_angle);
    action(rect_from_corners);
    action(round_rect_from_angle);
    action(capsule_from_angle);
    action(capsule_from_width);
    action(ellipse_from_angle);
    action(ellipse_from_radius_vector);
    action(ellipse_from_covariance);
    action(ellipse_from_matrix);
  }
};

using Scalars = testing::Types<capi::F64, capi::F32>;
TYPED_TEST_SUITE(ConstructErrors, Scalars);

TYPED_TEST(ConstructErrors, NullIsLookedAtFirst) {
  using T = typename TypeParam::Scalar;
  this->for_each_constructor([&](const auto& constructor) {
    EXPECT_EQ(constructor.call(constructor.valid.data(), nullptr), VESICA_E_NULL) << constructor.name;
    const auto broken = this->with(constructor.valid, 0, std::numeric_limits<T>::quiet_NaN());
    EXPECT_EQ(constructor.call(broken.data(), nullptr), VESICA_E_NULL) << constructor.name;
  });
  typename TypeParam::Rect out{1, 2, 3, 4, 5, 6};
  EXPECT_EQ(TypeParam::rect_from_corners(nullptr, &out), VESICA_E_NULL);
  EXPECT_EQ(out.hx, 5);
}

TYPED_TEST(ConstructErrors, EveryNumberMustBeFinite) {
  using Limits = std::numeric_limits<typename TypeParam::Scalar>;
  this->for_each_constructor([&](const auto& constructor) {
    this->expect(constructor, constructor.valid, 0);
    for (int i = 0; i < constructor.count; ++i) {
      for (const auto bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
        this->expect(constructor, this->with(constructor.valid, i, bad), VESICA_E_NOT_FINITE);
      }
    }
  });
}

TYPED_TEST(ConstructErrors, NegativeSizesAndTheirOrder) {
  using T = typename TypeParam::Scalar;
  const T nan = std::numeric_limits<T>::quiet_NaN(), least = -std::numeric_limits<T>::denorm_min();
  const auto check = [&](const auto& constructor, int size) {
    const auto negative = this->with(constructor.valid, size, least);
    this->expect(constructor, negative, VESICA_E_NEGATIVE_SIZE);
    this->expect(constructor, this->with(negative, 0, nan), VESICA_E_NOT_FINITE);
  };
  check(this->rect_from_angle, 3);
  check(this->rect_from_angle, 4);
  check(this->round_rect_from_angle, 3);
  check(this->round_rect_from_angle, 4);
  check(this->round_rect_from_angle, 5);
  check(this->capsule_from_angle, 3);
  check(this->capsule_from_angle, 4);
  check(this->capsule_from_width, 4);
  check(this->ellipse_from_angle, 3);
  check(this->ellipse_from_angle, 4);
  check(this->ellipse_from_radius_vector, 4);
  check(this->ellipse_from_covariance, 5);
  this->expect(this->ellipse_from_radius_vector, {1, 2, 0, 0, -1}, VESICA_E_NEGATIVE_SIZE);
}

// Half the lesser side is legal; the number after it is not, not even where its double overflows.
TYPED_TEST(ConstructErrors, RadiusOfMoreThanHalfASide) {
  using T = typename TypeParam::Scalar;
  const T tiny = std::numeric_limits<T>::denorm_min(), max = std::numeric_limits<T>::max();
  const T sides[][2] = {{4, 6}, {6, 4}, {4, 4}, {T{1} / 3, 1}, {2 * tiny, 1}, {max, max}};
  for (const auto& [width, height] : sides) {
    const T most = (width < height ? width : height) / 2, more = std::nextafter(most, max);
    this->expect(this->round_rect_from_angle, {1, 2, 3, width, height, most}, 0);
    this->expect(this->round_rect_from_angle, {1, 2, 3, width, height, more}, VESICA_E_ARGUMENT);
    this->expect(this->round_rect_from_angle, {1, 2, 3, width, height, max}, VESICA_E_ARGUMENT);
  }
  this->expect(this->round_rect_from_angle, {1, 2, 3, 5 * tiny, 1, 2 * tiny}, 0);
  this->expect(this->round_rect_from_angle, {1, 2, 3, 5 * tiny, 1, 3 * tiny}, VESICA_E_ARGUMENT);
  this->expect(this->round_rect_from_angle, {1, 2, 3, 0, 1, tiny}, VESICA_E_ARGUMENT);
  this->expect(this->round_rect_from_angle, {1, 2, 3, 1, 0, tiny}, VESICA_E_ARGUMENT);
  this->expect(this->round_rect_from_angle, {1, 2, 3, -1, 4, 3}, VESICA_E_NEGATIVE_SIZE);
}

TYPED_TEST(ConstructErrors, EndsOfACapsuleOverflow) {
  using T = typename TypeParam::Scalar;
  const T max = std::numeric_limits<T>::max();
  this->expect(this->capsule_from_angle, {0, 0, 0, max, max}, 0);
  this->expect(this->capsule_from_angle, {max / 2, 0, 0, max, 1}, 0);
  this->expect(this->capsule_from_angle, {max, 0, 0, max / 4, 1}, VESICA_E_RANGE);
  this->expect(this->capsule_from_angle, {-max, 0, 0, max / 4, 1}, VESICA_E_RANGE);
  this->expect(this->capsule_from_angle, {0, max, 2, max / 4, 1}, VESICA_E_RANGE);
  this->expect(this->capsule_from_angle, {0, -max, 2, max / 4, 1}, VESICA_E_RANGE);
  this->expect(this->capsule_from_angle, {max, 0, 0, max / 4, -1}, VESICA_E_NEGATIVE_SIZE);
}

TYPED_TEST(ConstructErrors, NotACovariance) {
  const auto max = std::numeric_limits<typename TypeParam::Scalar>::max();
  this->expect(this->ellipse_from_covariance, {1, 2, -3, 0, 4, 1}, VESICA_E_ARGUMENT);
  this->expect(this->ellipse_from_covariance, {1, 2, 3, 0, -4, 1}, VESICA_E_ARGUMENT);
  this->expect(this->ellipse_from_covariance, {1, 2, -3, 4, -4, 1}, VESICA_E_ARGUMENT);
  this->expect(this->ellipse_from_covariance, {1, 2, 3, 4, 4, 1}, VESICA_E_ARGUMENT);
  this->expect(this->ellipse_from_covariance, {1, 2, 3, 4, 4, -1}, VESICA_E_NEGATIVE_SIZE);
  this->expect(this->ellipse_from_covariance, {1, 2, 3, 4, 4, max}, VESICA_E_ARGUMENT);
  this->expect(this->ellipse_from_covariance, {1, 2, 3, 0, 4, max}, VESICA_E_RANGE);
}

TYPED_TEST(ConstructErrors, Misfit) {
  using T = typename TypeParam::Scalar;
  using Limits = std::numeric_limits<T>;
  using Made = typename TypeParam::Rect;
  const T square[] = {-1, -1, 1, -1, 1, 1, -1, 1}, nan = Limits::quiet_NaN(), max = Limits::max();
  const Made unit{0, 0, 1, 0, 1, 1};
  T out = 7;
  EXPECT_EQ(TypeParam::rect_corners_misfit(nullptr, &unit, &out), VESICA_E_NULL);
  EXPECT_EQ(TypeParam::rect_corners_misfit(square, nullptr, &out), VESICA_E_NULL);
  EXPECT_EQ(TypeParam::rect_corners_misfit(square, &unit, nullptr), VESICA_E_NULL);
  const auto refused = [&](const Made& rect, std::int32_t error) {
    EXPECT_EQ(TypeParam::rect_corners_misfit(square, &rect, &out), error);
  };
  refused({nan, 0, 1, 0, 1, 1}, VESICA_E_NOT_FINITE);
  refused({0, 0, 1, 0, 1, Limits::infinity()}, VESICA_E_NOT_FINITE);
  refused({0, 0, 1, 0, -1, 1}, VESICA_E_NEGATIVE_SIZE);
  refused({0, 0, 0, 0, 1, 1}, VESICA_E_ZERO_AXIS);
  refused({0, 0, max, 0, max, 1}, VESICA_E_RANGE);
  for (int i = 0; i < 8; ++i) {
    for (const T bad : {nan, Limits::infinity(), -Limits::infinity()}) {
      T corners[8];
      std::memcpy(corners, square, sizeof corners);
      corners[i] = bad;
      EXPECT_EQ(TypeParam::rect_corners_misfit(corners, &unit, &out), VESICA_E_NOT_FINITE);
    }
  }
  const T far[] = {max, max, max, max, max, max, max, max};
  const Made opposite{-max, -max, 1, 0, 0, 0};
  EXPECT_EQ(TypeParam::rect_corners_misfit(far, &opposite, &out), VESICA_E_RANGE);
  EXPECT_EQ(out, 7);
  EXPECT_EQ(TypeParam::rect_corners_misfit(square, &unit, &out), 0);
  EXPECT_EQ(out, 0);
}

// Negative zero is no negative size, and zero sizes are legal.
TYPED_TEST(ConstructErrors, ZeroSizesAreLegal) {
  using T = typename TypeParam::Scalar;
  for (const T zero : {T{0}, -T{0}}) {
    this->expect(this->rect_from_angle, {1, 2, 3, zero, zero}, 0);
    this->expect(this->round_rect_from_angle, {1, 2, 3, zero, zero, zero}, 0);
    this->expect(this->round_rect_from_angle, {1, 2, 3, 4, 5, zero}, 0);
    this->expect(this->capsule_from_angle, {1, 2, 3, zero, zero}, 0);
    this->expect(this->capsule_from_width, {1, 2, 1, 2, zero}, 0);
    this->expect(this->ellipse_from_angle, {1, 2, 3, zero, zero}, 0);
    this->expect(this->ellipse_from_radius_vector, {1, 2, 3, 4, zero}, 0);
    this->expect(this->ellipse_from_radius_vector, {1, 2, zero, zero, 4}, 0);
    this->expect(this->ellipse_from_covariance, {1, 2, zero, zero, zero, zero}, 0);
  }
}

}  // namespace
