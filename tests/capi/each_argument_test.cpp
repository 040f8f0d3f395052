// SPDX-License-Identifier: Apache-2.0
// Arguments of functions over arrays and an index made wrong one at a time, where error_order_test.cpp has no place for
// them: each pointer, each count, each stride. Nothing is written then.
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

#include "capi/face.hpp"

namespace {

using namespace capi_tests;

template <class T>
class EachArgument : public testing::Test {
 protected:
  using Shapes = typename Face<T>::Shapes;

  static Shapes shapes_of(std::int32_t kind, std::int64_t count) {
    Shapes shapes;
    EXPECT_EQ(Face<T>::from_records(kind, count, numbers, 6 * sizeof(T), &shapes), 0);
    return shapes;
  }
  static Shapes with_a_null(Shapes shapes) {
    shapes.field[1] = nullptr;
    return shapes;
  }
  static Shapes unsound(Shapes shapes) {
    shapes.reserved = 1;
    return shapes;
  }

  static constexpr T numbers[12] = {0, 0, 1, 0, 1, 1, 5, 5, 1, 0, 1, 1};
  static constexpr T nan = std::numeric_limits<T>::quiet_NaN();
  static constexpr std::int64_t too_many = std::int64_t{1} << 31;  // more than an index or a suppression takes
};

using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(EachArgument, Scalars);

TYPED_TEST(EachArgument, OfBoxes) {
  using F = Face<TypeParam>;
  const auto two = this->shapes_of(VESICA_RECT, 2), none = this->shapes_of(VESICA_RECT, 0);
  TypeParam out[16] = {7};
  EXPECT_EQ(F::boxes_from_shapes(nullptr, VESICA_ANGLE_RADIANS, out), VESICA_E_NULL);
  EXPECT_EQ(F::corners_of_shapes(nullptr, out), VESICA_E_NULL);
  EXPECT_EQ(F::corners_of_shapes(&two, nullptr), VESICA_E_NULL);
  EXPECT_EQ(out[0], 7);
  EXPECT_EQ(F::boxes_from_shapes(&none, VESICA_ANGLE_RADIANS, nullptr), 0);
  EXPECT_EQ(F::corners_of_shapes(&none, nullptr), 0);
  EXPECT_EQ(F::corners_of_shapes(&two, out), 0);
  EXPECT_TRUE(out[0] == -1 && out[1] == -1 && out[8] == 4 && out[9] == 4);
}

TYPED_TEST(EachArgument, OfWithin) {
  using F = Face<TypeParam>;
  const auto two = this->shapes_of(VESICA_RECT, 2), three = this->shapes_of(VESICA_RECT, 3), bad = this->unsound(two);
  std::uint8_t out[4] = {7, 7, 7, 7};
  EXPECT_EQ(F::within_many(&two, &three, 1, out), VESICA_E_ARGUMENT);
  EXPECT_EQ(F::within_many(&two, &two, this->nan, out), VESICA_E_ARGUMENT);
  EXPECT_EQ(F::within_many(&two, &bad, 1, out), VESICA_E_ARGUMENT);
  EXPECT_EQ(F::within_matrix(&two, nullptr, 1, out, 2), VESICA_E_NULL);
  EXPECT_EQ(F::within_matrix(&two, &bad, 1, out, 2), VESICA_E_ARGUMENT);
  EXPECT_EQ(F::within_matrix(&two, &two, 1, out, 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(F::within_matrix(&two, &two, this->nan, out, 2), VESICA_E_ARGUMENT);
  EXPECT_EQ(out[0], 7);
  EXPECT_EQ(F::within_matrix(&two, &two, 1, out, 2), 2);
}

TYPED_TEST(EachArgument, OfCasts) {
  using F = Face<TypeParam>;
  const auto two = this->shapes_of(VESICA_RECT, 2), three = this->shapes_of(VESICA_RECT, 3),
             none = this->shapes_of(VESICA_RECT, 0);
  const TypeParam v[2] = {1, 1};
  TypeParam t[2] = {7, 7};
  const auto cast = [&](const auto& a, const auto& b, const TypeParam* vx, const TypeParam* vy, std::ptrdiff_t stride,
                        TypeParam end) {
    return F::cast_many(&a, &b, vx, vy, stride, end, t, nullptr, nullptr, nullptr, nullptr);
  };
  constexpr std::ptrdiff_t step = sizeof(TypeParam), endless = std::numeric_limits<std::ptrdiff_t>::max();
  EXPECT_EQ(cast(two, two, nullptr, v, step, 1), VESICA_E_NULL);
  EXPECT_EQ(cast(two, two, v, nullptr, step, 1), VESICA_E_NULL);
  EXPECT_EQ(cast(two, three, v, v, step, 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(cast(two, two, v, v, endless, 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(cast(two, two, v, v, step, this->nan), VESICA_E_ARGUMENT);
  EXPECT_EQ(cast(two, two, v, v, step, -1), VESICA_E_ARGUMENT);
  EXPECT_EQ(t[0], 7);
  EXPECT_EQ(cast(none, none, nullptr, nullptr, step, 1), 0);
  EXPECT_EQ(cast(two, two, v, v, step, 1), 2);
}

/// Contacts later than the greatest number, in arrays long enough for lanes.
TYPED_TEST(EachArgument, OfCastsOutOfRange) {
  using F = Face<TypeParam>;
  using T = TypeParam;
  const T far = std::numeric_limits<T>::max() / 16, slow = T(0x1p-20);
  for (const std::int32_t kind : {VESICA_CIRCLE, VESICA_RECT}) {
    std::vector<T> first, second;
    for (int i = 0; i < 40; ++i) {
      first.insert(first.end(), {0, 0, 1, 0, 1, 1});
      second.insert(second.end(), {far, 0, 1, 0, 1, 1});
    }
    typename F::Shapes a, b;
    ASSERT_EQ(F::from_records(kind, 40, first.data(), 6 * sizeof(T), &a), 0);
    ASSERT_EQ(F::from_records(kind, 40, second.data(), 6 * sizeof(T), &b), 0);
    T t[40];
    const T vx = -slow, vy = 0, endless = std::numeric_limits<T>::infinity();
    EXPECT_EQ(F::cast_many(&a, &b, &vx, &vy, 0, endless, t, nullptr, nullptr, nullptr, nullptr), VESICA_E_RANGE);
    for (const T found : t) EXPECT_NE(found, found);
    typename F::Impact impact;
    EXPECT_EQ(F::cast(kind, first.data(), kind, second.data(), vx, vy, endless, &impact), VESICA_E_RANGE);
    b.count = 1;
    EXPECT_EQ(F::cast_first(&b, &a, vx, vy, endless, &impact), VESICA_E_RANGE);
  }
}

/// Needles that cross beyond the greatest number, which is 2 in their units, as in core_errors_test.cpp.
TYPED_TEST(EachArgument, OfCastsThatStartOutOfRange) {
  using F = Face<TypeParam>;
  using T = TypeParam;
  const T one = std::numeric_limits<T>::max() / 4 + std::numeric_limits<T>::max() / 4;
  const T level[6] = {one + one / 2, 0, 1, 0, one / 4 * 3, 1};
  const T falling[6] = {one + one / 16 * 10, one / 2, 1, -1, one / 4 * 3, 1};
  ASSERT_EQ(F::overlap(VESICA_RECT, level, VESICA_RECT, falling), 1);
  typename F::Points points;
  typename F::Impact impact{7, 7, 7, 7, 7};
  EXPECT_EQ(F::nearest(VESICA_RECT, level, VESICA_RECT, falling, &points), VESICA_E_RANGE);
  EXPECT_EQ(F::cast(VESICA_RECT, level, VESICA_RECT, falling, 1, 0, 1, &impact), VESICA_E_RANGE);
  const typename F::Turn still{0, 0, 0};
  T gap = 7;
  EXPECT_EQ(F::impact_time(VESICA_RECT, level, &still, VESICA_RECT, falling, &still, T(0x1p-10), &impact, &gap),
            VESICA_E_RANGE);
  EXPECT_TRUE(impact.t == 7 && gap == 7);
}

TYPED_TEST(EachArgument, OfSuppression) {
  using F = Face<TypeParam>;
  const auto two = this->shapes_of(VESICA_RECT, 2), points = this->shapes_of(VESICA_POINT, 2), bad = this->unsound(two),
             holed = this->with_a_null(two), none = this->shapes_of(VESICA_RECT, 0);
  auto many = two;
  many.count = this->too_many;
  const TypeParam scores[2] = {1, 1};
  std::int64_t keep[2], kept = 7;
  TypeParam decayed[2];
  std::vector<std::uint64_t> scratch(static_cast<std::size_t>(vesica_suppress_soft_scratch(2)) / 8 + 2);
  const auto bytes = static_cast<std::int64_t>(8 * scratch.size());
  const auto soft = [&](const auto* shapes, const TypeParam* s, void* room, std::int64_t* to, TypeParam* d,
                        std::int64_t* count) {
    return F::suppress_soft(shapes, s, nullptr, VESICA_RATIO_OVER_UNION, VESICA_DECAY_LINEAR, TypeParam{0.5}, 0, 9,
                            room, bytes - 8, to, d, count);
  };
  EXPECT_EQ(soft(&two, scores, scratch.data(), keep, decayed, nullptr), VESICA_E_NULL);
  EXPECT_EQ(soft(&two, nullptr, scratch.data(), keep, decayed, &kept), VESICA_E_NULL);
  EXPECT_EQ(soft(&two, scores, nullptr, keep, decayed, &kept), VESICA_E_NULL);
  EXPECT_EQ(soft(&two, scores, scratch.data(), nullptr, decayed, &kept), VESICA_E_NULL);
  EXPECT_EQ(soft(&two, scores, scratch.data(), keep, nullptr, &kept), VESICA_E_NULL);
  EXPECT_EQ(soft(&holed, scores, scratch.data(), keep, decayed, &kept), VESICA_E_NULL);
  EXPECT_EQ(soft(&points, scores, scratch.data(), keep, decayed, &kept), VESICA_E_KIND);
  EXPECT_EQ(soft(&bad, scores, scratch.data(), keep, decayed, &kept), VESICA_E_ARGUMENT);
  EXPECT_EQ(soft(&many, scores, scratch.data(), keep, decayed, &kept), VESICA_E_ARGUMENT);
  EXPECT_EQ(soft(&two, scores, reinterpret_cast<char*>(scratch.data()) + 4, keep, decayed, &kept), VESICA_E_ARGUMENT);
  EXPECT_EQ(F::nms(&many, scores, TypeParam{0.5}, scratch.data(), bytes, keep, &kept), VESICA_E_ARGUMENT);
  EXPECT_EQ(kept, 7);
  EXPECT_EQ(soft(&two, scores, scratch.data(), keep, decayed, &kept), 0);
  EXPECT_EQ(kept, 2);
  EXPECT_EQ(soft(&none, nullptr, nullptr, nullptr, nullptr, &kept), 0);
  EXPECT_EQ(kept, 0);
}

TYPED_TEST(EachArgument, OfAnIndex) {
  using F = Face<TypeParam>;
  alignas(64) static unsigned char index[1 << 17], scratch[1 << 19];
  const auto two = this->shapes_of(VESICA_RECT, 2), bad = this->unsound(two);
  EXPECT_EQ(F::index_step(0, 0, 1, &bad, 1, index, sizeof index, scratch, sizeof scratch), VESICA_E_ARGUMENT);
  EXPECT_EQ(F::index_step(0, 0, 1, nullptr, 1, index, sizeof index, scratch, sizeof scratch), VESICA_E_NULL);
  ASSERT_GT(F::index_build(&two, 1, index, sizeof index, scratch, sizeof scratch), 0);
  EXPECT_EQ(vesica_index_check(nullptr, sizeof index), VESICA_E_NULL);
  EXPECT_EQ(vesica_index_check(index + 8, sizeof index - 8), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_index_check(index, sizeof index), 0);
  EXPECT_EQ(vesica_index_bytes(index + 64), VESICA_E_INDEX);
  EXPECT_EQ(vesica_index_count(index + 64), VESICA_E_INDEX);
  vesica_aabb_f64 box{7, 7, 7, 7};
  std::int64_t order[2] = {7, 7};
  EXPECT_EQ(vesica_index_bounds(nullptr, &box), VESICA_E_NULL);
  EXPECT_EQ(vesica_index_bounds(index, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_index_bounds(index + 64, &box), VESICA_E_INDEX);
  EXPECT_EQ(vesica_index_order(index + 64, order, 2), VESICA_E_INDEX);
  EXPECT_EQ(vesica_index_order(index, order, -1), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_index_order(index, nullptr, 1), VESICA_E_NULL);
  EXPECT_TRUE(box.min_x == 7 && order[0] == 7);
  EXPECT_EQ(vesica_index_order(index, nullptr, 0), 2);
  EXPECT_EQ(vesica_index_order(index, order, 1), 2);
  EXPECT_EQ(order[1], 7);
}

}  // namespace
