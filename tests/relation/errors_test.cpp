// SPDX-License-Identifier: Apache-2.0
// Errors of relation and containment, for every pair of kinds in both scalars and orders, in the documented order.
#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

using Query = std::int32_t (*)(std::int32_t, const void*, std::int32_t, const void*);

template <class T>
using Numbers = std::array<T, 6>;

template <class T>
std::vector<Query> queries();
template <>
std::vector<Query> queries<double>() {
  return {vesica_relation_f64, vesica_contains_f64};
}
template <>
std::vector<Query> queries<float>() {
  return {vesica_relation_f32, vesica_contains_f32};
}

/// Near the others, so that filters look at all numbers; and far away, where they need not.
template <class T>
std::array<Numbers<T>, 2> valid_shapes(std::int32_t kind) {
  constexpr T far = static_cast<T>(1e30);
  if (kind == VESICA_CIRCLE) return {{{3, 4, 2}, {far, far, 0}}};
  if (kind == VESICA_RECT || kind == VESICA_ELLIPSE) return {{{3, 4, 3, 4, 2, 1}, {far, far, 3, 4, 0, 0}}};
  return {{{3, 4, 5, 6}, {far, far, far, far}}};
}

template <class T>
std::vector<Numbers<T>> invalid_shapes(std::int32_t kind, const Numbers<T>& valid) {
  using Limits = std::numeric_limits<T>;
  std::vector<Numbers<T>> result;
  const auto with = [&](std::size_t field, T x) {
    Numbers<T> n = valid;
    n[field] = x;
    result.push_back(n);
  };
  for (std::int32_t field = 0; field < vesica_field_count(kind); ++field) {
    for (const T bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
      with(static_cast<std::size_t>(field), bad);
    }
  }
  const std::size_t first_size = kind == VESICA_CIRCLE ? 2 : 4;
  for (std::int32_t field = static_cast<std::int32_t>(first_size); field < vesica_field_count(kind); ++field) {
    for (const T bad : {T(-1), -Limits::denorm_min(), -Limits::max()}) with(static_cast<std::size_t>(field), bad);
  }
  if (kind == VESICA_RECT || kind == VESICA_ELLIPSE) {
    Numbers<T> n = valid;
    n[2] = 0;
    n[3] = -T(0);
    result.push_back(n);
  }
  if (kind == VESICA_AABB) {
    with(0, Limits::max());
    with(1, Limits::max());
  }
  return result;
}

template <class T>
class RelationErrors : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(RelationErrors, Scalars);

TYPED_TEST(RelationErrors, InvalidShapes) {
  using T = TypeParam;
  for (const Query query : queries<T>()) {
    for (std::int32_t a = 0; a < 6; ++a) {
      for (std::int32_t b = 0; b < 6; ++b) {
        for (const Numbers<T>& valid_a : valid_shapes<T>(a)) {
          for (const Numbers<T>& valid_b : valid_shapes<T>(b)) {
            EXPECT_GE(query(a, valid_a.data(), b, valid_b.data()), 0);
            for (const Numbers<T>& bad : invalid_shapes(a, valid_a)) {
              EXPECT_EQ(query(a, bad.data(), b, valid_b.data()), VESICA_E_SHAPE) << a << ' ' << b;
              EXPECT_EQ(query(a, bad.data(), a, bad.data()), VESICA_E_SHAPE) << a;
            }
            for (const Numbers<T>& bad : invalid_shapes(b, valid_b)) {
              EXPECT_EQ(query(a, valid_a.data(), b, bad.data()), VESICA_E_SHAPE) << a << ' ' << b;
            }
          }
        }
      }
    }
  }
}

TYPED_TEST(RelationErrors, NullThenKindThenShape) {
  using T = TypeParam;
  const Numbers<T> bad{std::numeric_limits<T>::quiet_NaN()};
  for (const Query query : queries<T>()) {
    for (std::int32_t kind = 0; kind < 6; ++kind) {
      const Numbers<T> good = valid_shapes<T>(kind)[0];
      EXPECT_EQ(query(kind, nullptr, kind, good.data()), VESICA_E_NULL);
      EXPECT_EQ(query(kind, good.data(), kind, nullptr), VESICA_E_NULL);
      for (const std::int32_t unknown : {-1, VESICA_POLYLINE + 1, INT32_MIN, INT32_MAX, 256, 65537}) {
        EXPECT_EQ(query(unknown, nullptr, kind, good.data()), VESICA_E_NULL);
        EXPECT_EQ(query(unknown, good.data(), kind, nullptr), VESICA_E_NULL);
        EXPECT_EQ(query(unknown, good.data(), kind, good.data()), VESICA_E_KIND);
        EXPECT_EQ(query(kind, good.data(), unknown, good.data()), VESICA_E_KIND);
        EXPECT_EQ(query(unknown, good.data(), kind, bad.data()), VESICA_E_KIND);
        EXPECT_EQ(query(kind, bad.data(), unknown, good.data()), VESICA_E_KIND);
      }
    }
  }
}

}  // namespace
