// SPDX-License-Identifier: Apache-2.0
/// The first item of an index that a moving and turning shape touches: the least time of all items, asked one by one.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "index/all_pairs.hpp"
#include "properties/random.hpp"

namespace index_tests {
namespace {

template <class T>
struct Touched {
  std::int64_t item;
  std::int32_t answer;
  typename Face<T>::Impact impact;
  T gap;
};

template <class T>
void expect_equal(const Touched<T>& got, const Touched<T>& expected) {
  ASSERT_EQ(got.item, expected.item) << got.impact.t << ' ' << expected.impact.t;
  EXPECT_EQ(got.answer, expected.answer);
  EXPECT_EQ(std::memcmp(&got.impact, &expected.impact, sizeof got.impact), 0);
  EXPECT_EQ(std::memcmp(&got.gap, &expected.gap, sizeof(T)), 0);
}

/// The result of a miss, whose NaN have the library's bits.
template <class T>
Touched<T> miss(std::int64_t count) {
  constexpr T nan = std::numeric_limits<T>::quiet_NaN();
  return {count, VESICA_CAST_MISS, {std::numeric_limits<T>::infinity(), nan, nan, nan, nan}, nan};
}

template <class T>
Touched<T> brute_force(const std::vector<Item<T>>& items, std::int64_t count, const Item<T>& one,
                       const typename Face<T>::Turn& turn, T tolerance) {
  constexpr typename Face<T>::Turn rest{0, 0, 0};
  Touched<T> first = miss<T>(count);
  for (const Item<T>& item : items) {
    Touched<T> at{item.number, 0, {}, 0};
    at.answer = Face<T>::impact_time(item.kind, item.numbers, &rest, one.kind, one.numbers, &turn, tolerance,
                                     &at.impact, &at.gap);
    EXPECT_GE(at.answer, 0);
    if (at.answer > 0 && at.impact.t < first.impact.t) first = at;
  }
  return first;
}

template <class T>
Touched<T> by_index(const Indexed<T>& many, const Item<T>& one, const typename Face<T>::Turn& turn, T tolerance) {
  typename Face<T>::Shapes shape;
  Face<T>::from_records(one.kind, 1, one.numbers, 0, &shape);
  Touched<T> got{0, -7, {}, 0};
  got.item = Face<T>::index_impact_time(many.index.get(), many.sets.data(), many.sets.count(), &shape, &turn, tolerance,
                                        &got.impact, &got.gap, &got.answer);
  return got;
}

template <class T>
class IndexImpactTime : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(IndexImpactTime, Scalars);

TYPED_TEST(IndexImpactTime, IsTheLeastOfAllItems) {
  using T = TypeParam;
  properties::Random random(properties::seed());
  int answers[4] = {};
  for (const char* name : {"uniform", "two_scales", "lattice", "points", "needles"}) {
    const Indexed<T> many(mixed<T>(name, 700, 1, 113));
    const std::vector<Item<T>> items = items_of(many.laid);
    const std::int64_t count = vesica_index_count(many.index.get());
    const Laid<T> others = mixed<T>(name, 240, 2);
    for (const Item<T>& one : items_of(others)) {
      const double size = std::fmax(std::fmax(one.max_x - one.min_x, one.max_y - one.min_y), 1e-3);
      const double way = size * std::ldexp(1, random.below(6)), angle = random.chance(0.2) ? 0 : random.between(-4, 4);
      const typename Face<T>::Turn turn{static_cast<T>(way * random.between(-1, 1)),
                                        static_cast<T>(way * random.between(-1, 1)), static_cast<T>(angle)};
      const T tolerance = static_cast<T>(size * (random.chance(0.5) ? 1e-3 : 0.5));
      const Touched<T> expected = brute_force(items, count, one, turn, tolerance);
      expect_equal(by_index(many, one, turn, tolerance), expected);
      ++answers[expected.answer];
    }
  }
  for (const int answer : {VESICA_CAST_MISS, VESICA_CAST_HIT, VESICA_CAST_START, VESICA_CAST_NEAR}) {
    EXPECT_GT(answers[answer], 0) << answer;
  }
}

/// A long thin shape that turns on the spot hits only what its ends reach; at the same time the lowest item.
TYPED_TEST(IndexImpactTime, TurnsOnTheSpot) {
  using T = TypeParam;
  const Indexed<T> many(Records<T>{VESICA_POINT, {0, 11, 7, 7, 7, 7, 7, -7, 100, 0}});
  const T rect[6] = {0, 0, 1, 0, 10, T(0.125)};
  const Item<T> one{VESICA_RECT, rect, 0, 0, 0, 0, 0};
  const auto first = [&](T angle) { return by_index(many, one, {0, 0, angle}, T(1e-3)); };
  const Touched<T> quarter = first(T(1.5));
  EXPECT_EQ(quarter.item, 1);
  EXPECT_EQ(quarter.answer, VESICA_CAST_HIT);
  EXPECT_NEAR(static_cast<double>(quarter.impact.t), std::acos(-1) / 4 / 1.5, 0.02);
  EXPECT_EQ(first(T(-1.5)).item, 3);
  EXPECT_EQ(first(T(0.5)).item, 5);
  EXPECT_EQ(first(T(-100)).item, 3);
}

/// The same numbers far from the origin, very small and very large.
TEST(IndexImpactTimes, AnyMagnitude) {
  for (const double k : {0x1p-900, 0x1p-300, 1.0, 0x1p300, 0x1p900, 0x1p1000}) {
    for (const double away : {0.0, 0x1p40}) {
      if (away > 0 && k > 0x1p950) continue;
      const double x = away * k;
      const Indexed<double> many(Records<double>{VESICA_CIRCLE, {x + 20 * k, 3 * k, k, x + 9 * k, 0, k, x, 40 * k, k}});
      const double rect[6] = {x, 0, 1, 1, 2 * k, k / 4};
      const Item<double> one{VESICA_RECT, rect, 0, 0, 0, 0, 0};
      const Touched<double> got = by_index(many, one, {16 * k, 0, -2}, 1e-6 * k);
      const std::vector<Item<double>> items = items_of(many.laid);
      expect_equal(got, brute_force<double>(items, 3, one, {16 * k, 0, -2}, 1e-6 * k));
      EXPECT_EQ(got.item, 1) << k;
      EXPECT_EQ(got.answer, VESICA_CAST_HIT) << k;
    }
  }
}

TEST(IndexImpactTimes, Polygons) {
  const double convex[] = {0, 0, 4, 0, 2, 3}, arrow[] = {20, 0, 24, 0, 21, 1, 20, 4},
               moving[] = {-9, 0, -6, 0, -7, 2, -9, 2};
  const vesica_polygon_f64 items[] = {{convex, convex + 1, 16, nullptr, 3}, {arrow, arrow + 1, 16, nullptr, 4}};
  const vesica_polygon_f64 one{moving, moving + 1, 16, nullptr, 4};
  vesica_shapes_f64 set, single;
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_POLYGON, 2, items, sizeof items[0], &set), 0);
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_POLYGON, 1, &one, 0, &single), 0);
  const Memory index(vesica_index_size(2)), scratch(vesica_index_scratch(2));
  ASSERT_GT(vesica_index_build_f64(&set, 1, index.get(), index.size, scratch.get(), scratch.size), 0);
  const vesica_turn_f64 rest{0, 0, 0}, turn{14, 0, 1}, beyond{60, 20, 0.1};
  Touched<double> got{}, expected{};
  got.item =
      vesica_index_impact_time_f64(index.get(), &set, 1, &single, &turn, 1e-3, &got.impact, &got.gap, &got.answer);
  expected.answer = vesica_impact_time_f64(VESICA_POLYGON, &items[0], &rest, VESICA_POLYGON, &one, &turn, 1e-3,
                                           &expected.impact, &expected.gap);
  EXPECT_EQ(expected.answer, VESICA_CAST_HIT);
  expect_equal(got, expected);
  // A polygon that is not convex is an error only if it may be first.
  const vesica_turn_f64 back{-30, 0, 1};
  EXPECT_EQ(
      vesica_index_impact_time_f64(index.get(), &set, 1, &single, &back, 1e-3, &got.impact, &got.gap, &got.answer), 2);
  EXPECT_EQ(got.answer, VESICA_CAST_MISS);
  const double start[] = {18, 1, 19, 1, 19, 2};
  const vesica_polygon_f64 near{start, start + 1, 16, nullptr, 3};
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_POLYGON, 1, &near, 0, &single), 0);
  EXPECT_EQ(
      vesica_index_impact_time_f64(index.get(), &set, 1, &single, &beyond, 1e-3, &got.impact, &got.gap, &got.answer),
      VESICA_E_NOT_CONVEX);
}

TEST(IndexImpactTimes, Errors) {
  const Indexed<double> many(Records<double>{VESICA_POINT, {5, 0}});
  const double circle[3] = {0, 0, 1}, bad[3] = {0, 0, -1};
  vesica_shapes_f64 one, invalid;
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_CIRCLE, 1, circle, 0, &one), 0);
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_CIRCLE, 1, bad, 0, &invalid), 0);
  const vesica_turn_f64 turn{8, 0, 1};
  vesica_impact_f64 out{-7, -7, -7, -7, -7};
  double gap = -7;
  std::int32_t answer = -7;
  const auto ask = [&](const vesica_shapes_f64* shape, const vesica_turn_f64* way, double tolerance) {
    return vesica_index_impact_time_f64(many.index.get(), many.sets.data(), 1, shape, way, tolerance, &out, &gap,
                                        &answer);
  };
  EXPECT_EQ(ask(nullptr, &turn, 1), VESICA_E_NULL);
  EXPECT_EQ(ask(&one, nullptr, 1), VESICA_E_NULL);
  EXPECT_EQ(vesica_index_impact_time_f64(many.index.get(), many.sets.data(), 1, &one, &turn, 1, nullptr, &gap, &answer),
            VESICA_E_NULL);
  EXPECT_EQ(vesica_index_impact_time_f64(many.index.get(), many.sets.data(), 1, &one, &turn, 1, &out, nullptr, &answer),
            VESICA_E_NULL);
  EXPECT_EQ(vesica_index_impact_time_f64(many.index.get(), many.sets.data(), 1, &one, &turn, 1, &out, &gap, nullptr),
            VESICA_E_NULL);
  EXPECT_EQ(vesica_index_impact_time_f64(nullptr, many.sets.data(), 1, &one, &turn, 1, &out, &gap, &answer),
            VESICA_E_NULL);
  EXPECT_EQ(vesica_index_impact_time_f64(many.index.get(), many.sets.data(), 0, &one, &turn, 1, &out, &gap, &answer),
            VESICA_E_ARGUMENT);
  for (const double tolerance : {0.0, -1.0, std::nan("")}) EXPECT_EQ(ask(&one, &turn, tolerance), VESICA_E_ARGUMENT);
  for (const vesica_turn_f64 wrong : {vesica_turn_f64{INFINITY, 0, 0}, {0, 0, 0x1p21}, {0, std::nan(""), 0}}) {
    EXPECT_EQ(ask(&one, &wrong, 1), VESICA_E_ARGUMENT);
  }
  EXPECT_EQ(ask(&invalid, &turn, 1), VESICA_E_SHAPE);
  EXPECT_EQ(out.t, -7);
  EXPECT_EQ(answer, -7);
  EXPECT_EQ(ask(&one, &turn, INFINITY), 0);
  EXPECT_EQ(ask(&one, &turn, 1e-9), 0);
  const Indexed<double> none(Records<double>{VESICA_POINT, {}});
  EXPECT_EQ(vesica_index_impact_time_f64(none.index.get(), nullptr, 0, &one, &turn, 1, &out, &gap, &answer), 0);
  EXPECT_EQ(answer, VESICA_CAST_MISS);
  EXPECT_EQ(out.t, INFINITY);
}

}  // namespace
}  // namespace index_tests
