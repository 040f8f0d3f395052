// SPDX-License-Identifier: Apache-2.0
/// Bad input: which error comes first, in every position, and that nothing is written.
#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <limits>
#include <vector>

namespace {

template <class T>
struct Face;
template <>
struct Face<double> {
  using Out = vesica_closest_points_f64;
  static constexpr auto nearest = vesica_nearest_f64;
};
template <>
struct Face<float> {
  using Out = vesica_closest_points_f32;
  static constexpr auto nearest = vesica_nearest_f32;
};

template <class T>
class NearestErrors : public testing::Test {
 protected:
  using Out = typename Face<T>::Out;
  using Numbers = properties::NumbersOf<T>;

  void expect_error(std::int32_t kind_a, const T* a, std::int32_t kind_b, const T* b, std::int32_t error) {
    const Out before{1, 2, 3, 4, 5};
    Out out = before;
    errno = EXDEV;
    EXPECT_EQ(Face<T>::nearest(kind_a, a, kind_b, b, &out), error);
    EXPECT_EQ(std::memcmp(&out, &before, sizeof out), 0);
    EXPECT_EQ(errno, EXDEV);
    EXPECT_EQ(Face<T>::nearest(kind_a, a, kind_b, b, nullptr), VESICA_E_NULL);
  }

  static Numbers valid(int kind) {
    switch (kind) {
      case VESICA_CIRCLE:
        return {3, 4, 2};
      case VESICA_RECT:
      case VESICA_ELLIPSE:
        return {3, 4, 3, 4, 2, 1};
      default:
        return {3, 4, 5, 6};
    }
  }

  static std::vector<Numbers> invalid(int kind) {
    constexpr T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    std::vector<Numbers> result;
    for (int i = 0; i < vesica_field_count(kind); ++i) {
      for (const T bad : {nan, infinity, -infinity}) {
        result.push_back(valid(kind));
        result.back()[static_cast<std::size_t>(i)] = bad;
      }
    }
    const auto with = [&](std::size_t i, T x, std::size_t j, T y) {
      result.push_back(valid(kind));
      result.back()[i] = x;
      result.back()[j] = y;
    };
    const T tiny = std::numeric_limits<T>::denorm_min();
    if (kind == VESICA_CIRCLE) with(2, -tiny, 2, -tiny);
    if (kind == VESICA_AABB) with(0, T(5) + 1, 2, 5);
    if (kind == VESICA_RECT || kind == VESICA_ELLIPSE) {
      with(4, -1, 5, 1);
      with(4, 1, 5, -tiny);
      with(2, 0, 3, -T(0));
    }
    return result;
  }
};

using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(NearestErrors, Scalars);

TYPED_TEST(NearestErrors, NullThenKindThenShape) {
  const auto good = this->valid(VESICA_RECT);
  const auto bad = this->invalid(VESICA_RECT).front();
  for (const auto* n : {&good, &bad}) {
    this->expect_error(VESICA_RECT, nullptr, VESICA_RECT, n->data(), VESICA_E_NULL);
    this->expect_error(VESICA_RECT, n->data(), VESICA_RECT, nullptr, VESICA_E_NULL);
    this->expect_error(-1, nullptr, 6, n->data(), VESICA_E_NULL);
    for (const std::int32_t kind : {-1, VESICA_POLYLINE + 1, std::numeric_limits<std::int32_t>::max()}) {
      this->expect_error(kind, n->data(), VESICA_RECT, n->data(), VESICA_E_KIND);
      this->expect_error(VESICA_RECT, n->data(), kind, n->data(), VESICA_E_KIND);
    }
  }
}

TYPED_TEST(NearestErrors, InvalidShapesInEitherPlace) {
  for (int kind = 0; kind < 6; ++kind) {
    for (const auto& bad : this->invalid(kind)) {
      for (int other = 0; other < 6; ++other) {
        const auto good = this->valid(other);
        this->expect_error(kind, bad.data(), other, good.data(), VESICA_E_SHAPE);
        this->expect_error(other, good.data(), kind, bad.data(), VESICA_E_SHAPE);
      }
      this->expect_error(kind, bad.data(), kind, bad.data(), VESICA_E_SHAPE);
    }
  }
}

}  // namespace
