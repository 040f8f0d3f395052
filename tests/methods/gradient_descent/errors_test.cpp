// SPDX-License-Identifier: Apache-2.0
// Every bad argument is an error code, and nothing is written.
#include <gtest/gtest.h>

#include <cerrno>
#include <cstring>
#include <limits>

#include "methods/gradient_descent/descent.hpp"

namespace {

using namespace descent;

template <class T>
class GradientDescentErrors : public testing::Test {
 protected:
  /// The code, and that neither the result nor the errors were touched.
  static void expect(std::int32_t code, const typename Face<T>::Ellipse* a, const typename Face<T>::Ellipse* b,
                     const typename Face<T>::Settings* s, std::int32_t capacity) {
    typename Face<T>::Result result;
    T errors[2] = {T{-7}, T{-7}};
    std::memset(static_cast<void*>(&result), 0x5a, sizeof result);
    const auto untouched = result;
    EXPECT_EQ(Face<T>::run(a, b, s, &result, errors, capacity), code);
    EXPECT_EQ(std::memcmp(&result, &untouched, sizeof result), 0);
    EXPECT_EQ(errors[0], T{-7});
    EXPECT_EQ(errors[1], T{-7});
  }

  const typename Face<T>::Ellipse a{0, 0, 1, 0, 1, 1}, b{4, 0, 1, 0, 1, 2};
};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(GradientDescentErrors, Scalars);

TYPED_TEST(GradientDescentErrors, Null) {
  using F = Face<TypeParam>;
  typename F::Result result;
  this->expect(VESICA_E_NULL, nullptr, &this->b, nullptr, 2);
  this->expect(VESICA_E_NULL, &this->a, nullptr, nullptr, 2);
  EXPECT_EQ(F::run(&this->a, &this->b, nullptr, nullptr, nullptr, 0), VESICA_E_NULL);
  EXPECT_EQ(F::run(&this->a, &this->b, nullptr, &result, nullptr, 1), VESICA_E_NULL);
  EXPECT_EQ(F::run(&this->a, &this->b, nullptr, &result, nullptr, 0), 1);
  EXPECT_EQ(F::defaults(VESICA_SCHEDULE_LITERAL, nullptr), VESICA_E_NULL);
}

TYPED_TEST(GradientDescentErrors, Shapes) {
  using Limits = std::numeric_limits<TypeParam>;
  using Ellipse = typename Face<TypeParam>::Ellipse;
  const auto broken = [](std::size_t field, TypeParam number) {
    TypeParam numbers[6] = {1, 2, 3, 4, 2, 1};
    numbers[field] = number;
    return Ellipse{numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]};
  };
  const auto expect_error = [&](const Ellipse& s) {
    this->expect(VESICA_E_SHAPE, &s, &this->b, nullptr, 2);
    this->expect(VESICA_E_SHAPE, &this->a, &s, nullptr, 2);
  };
  for (std::size_t field = 0; field < 6; ++field) {
    for (const TypeParam bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
      expect_error(broken(field, bad));
    }
  }
  expect_error(broken(4, -Limits::denorm_min()));
  expect_error(broken(5, -Limits::denorm_min()));
  expect_error(Ellipse{1, 2, 0, 0, 2, 1});
}

TYPED_TEST(GradientDescentErrors, Settings) {
  using T = TypeParam;
  using Limits = std::numeric_limits<T>;
  using Settings = typename Face<T>::Settings;
  for (const std::int32_t schedule : {VESICA_SCHEDULE_SCALE_AWARE, VESICA_SCHEDULE_LITERAL}) {
    const Settings good = settings<T>(schedule);
    const auto expect_error = [&](T Settings::*number, T bad) {
      Settings s = good;
      s.*number = bad;
      this->expect(VESICA_E_ARGUMENT, &this->a, &this->b, &s, 2);
    };
    for (const T bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), T{-1}}) {
      expect_error(&Settings::tolerance, bad);
      expect_error(&Settings::rate, bad);
      expect_error(&Settings::decay, bad);
    }
    expect_error(&Settings::tolerance, T{0});
    expect_error(&Settings::rate, T{0});
    for (const std::int32_t iterations : {0, -1, 1000001, INT32_MIN, INT32_MAX}) {
      Settings s = good;
      s.iterations = iterations;
      this->expect(VESICA_E_ARGUMENT, &this->a, &this->b, &s, 2);
    }
  }
  Settings s = settings<T>(VESICA_SCHEDULE_SCALE_AWARE);
  s.rate = 2;
  this->expect(VESICA_E_ARGUMENT, &this->a, &this->b, &s, 2);
  s.schedule = VESICA_SCHEDULE_LITERAL;
  typename Face<T>::Result result;
  EXPECT_GE(Face<T>::run(&this->a, &this->b, &s, &result, nullptr, 0), 0);
  for (const std::int32_t schedule : {-1, 2, INT32_MIN, INT32_MAX}) {
    s = settings<T>(VESICA_SCHEDULE_LITERAL);
    s.schedule = schedule;
    this->expect(VESICA_E_ARGUMENT, &this->a, &this->b, &s, 2);
    Settings untouched = s;
    EXPECT_EQ(Face<T>::defaults(schedule, &s), VESICA_E_ARGUMENT);
    EXPECT_EQ(std::memcmp(&s, &untouched, sizeof s), 0);
  }
}

TYPED_TEST(GradientDescentErrors, Capacity) {
  this->expect(VESICA_E_ARGUMENT, &this->a, &this->b, nullptr, -1);
  this->expect(VESICA_E_ARGUMENT, &this->a, &this->b, nullptr, INT32_MIN);
}

// Settings at which what is left of the rate underflows, and then the step.
TYPED_TEST(GradientDescentErrors, LeaveErrnoAlone) {
  using T = TypeParam;
  for (const std::int32_t schedule : {VESICA_SCHEDULE_SCALE_AWARE, VESICA_SCHEDULE_LITERAL}) {
    for (const T decay : {T{0}, T{740}, T{1000}, std::numeric_limits<T>::max()}) {
      auto s = settings<T>(schedule);
      s.decay = decay;
      typename Face<T>::Result result;
      errno = 0;
      EXPECT_GE(Face<T>::run(&this->a, &this->b, &s, &result, nullptr, 0), 0);
      EXPECT_EQ(errno, 0) << schedule << ' ' << decay;
    }
  }
}

// Centres a distance apart that no number holds.
TYPED_TEST(GradientDescentErrors, Range) {
  constexpr TypeParam most = std::numeric_limits<TypeParam>::max();
  const typename Face<TypeParam>::Ellipse left{-most, 0, 1, 0, 1, 1}, right{most, 0, 1, 0, 1, 1};
  typename Face<TypeParam>::Result result;
  EXPECT_EQ(Face<TypeParam>::run(&left, &right, nullptr, &result, nullptr, 0), VESICA_E_RANGE);
}

}  // namespace
