// SPDX-License-Identifier: Apache-2.0
// Results of any length: the count says how many there are, and no more than there is room for are written.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "capi/face.hpp"

namespace {

using capi_tests::Face;

template <class T>
class Room : public testing::Test {
 protected:
  using F = Face<T>;
  using Point = typename F::Point;

  static constexpr std::array<T, 4> box{0, 0, 2, 1}, other{1, 0, 4, 1}, away{5, 5, 6, 6};
  static constexpr std::array<T, 4> inverted{1, 0, 0, 1};

  std::array<Point, 6> out_{{{7, 7}, {7, 7}, {7, 7}, {7, 7}, {7, 7}, {7, 7}}};
  std::int32_t shared_ = 7;

  std::int64_t crossings(const std::array<T, 4>& b, std::int64_t capacity) {
    return F::crossings_in_room(VESICA_AABB, box.data(), VESICA_AABB, b.data(), out_.data(), capacity, &shared_);
  }
  std::int64_t intersection(const std::array<T, 4>& b, std::int64_t capacity) {
    return F::intersection_in_room(VESICA_AABB, box.data(), VESICA_AABB, b.data(), out_.data(), capacity);
  }
  void expect_written(std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) EXPECT_TRUE(out_[i].x != 7 && out_[i].y != 7) << i;
    for (std::size_t i = count; i < out_.size(); ++i) EXPECT_TRUE(out_[i].x == 7 && out_[i].y == 7) << i;
  }
};

using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(Room, Scalars);

TYPED_TEST(Room, CrossingsAreAllWrittenWithRoomForMore) {
  EXPECT_EQ(this->crossings(this->other, 6), 4);
  EXPECT_EQ(this->shared_, 1);
  this->expect_written(4);
  EXPECT_TRUE(this->out_[0].x == 1 && this->out_[0].y == 0);
}

TYPED_TEST(Room, CrossingsFillTheRoom) {
  EXPECT_EQ(this->crossings(this->other, 2), 4);
  this->expect_written(2);
  EXPECT_EQ(this->crossings(this->other, 4), 4);
  this->expect_written(4);
}

TYPED_TEST(Room, CrossingsNeedNoRoom) {
  using Functions = Face<TypeParam>;
  const auto &a = this->box, &b = this->other;
  EXPECT_EQ(Functions::crossings_in_room(VESICA_AABB, a.data(), VESICA_AABB, b.data(), nullptr, 0, nullptr), 4);
  EXPECT_EQ(this->crossings(this->other, 0), 4);
  EXPECT_EQ(this->shared_, 1);
  this->expect_written(0);
  EXPECT_EQ(this->crossings(this->away, 6), 0);
  EXPECT_EQ(this->shared_, 0);
  this->expect_written(0);
}

TYPED_TEST(Room, IntersectionFillsTheRoom) {
  EXPECT_EQ(this->intersection(this->other, 0), 4);
  this->expect_written(0);
  EXPECT_EQ(this->intersection(this->other, 3), 4);
  this->expect_written(3);
  EXPECT_TRUE(this->out_[0].x == 1 && this->out_[0].y == 0 && this->out_[2].x == 2 && this->out_[2].y == 1);
  EXPECT_EQ(this->intersection(this->away, 6), 0);
  this->expect_written(3);
}

TYPED_TEST(Room, ErrorsInTheirOrderWriteNothing) {
  using Functions = Face<TypeParam>;
  const auto *a = this->box.data(), *bad = this->inverted.data();
  EXPECT_EQ(Functions::crossings_in_room(VESICA_POLYLINE + 1, a, VESICA_AABB, bad, nullptr, 1, nullptr), VESICA_E_NULL);
  EXPECT_EQ(Functions::crossings_in_room(VESICA_POLYLINE + 1, a, VESICA_AABB, bad, nullptr, -1, &this->shared_),
            VESICA_E_KIND);
  EXPECT_EQ(this->crossings(this->inverted, -1), VESICA_E_ARGUMENT);
  EXPECT_EQ(this->crossings(this->inverted, 6), VESICA_E_SHAPE);
  EXPECT_EQ(Functions::intersection_in_room(9, a, VESICA_AABB, bad, nullptr, 1), VESICA_E_NULL);
  EXPECT_EQ(Functions::intersection_in_room(VESICA_CIRCLE, a, VESICA_AABB, bad, nullptr, -1), VESICA_E_KIND);
  EXPECT_EQ(this->intersection(this->inverted, -1), VESICA_E_ARGUMENT);
  EXPECT_EQ(this->intersection(this->inverted, 6), VESICA_E_SHAPE);
  EXPECT_EQ(this->shared_, 7);
  this->expect_written(0);
}

}  // namespace
