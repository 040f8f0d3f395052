// SPDX-License-Identifier: Apache-2.0
/// A moving shape hits the items of an index that the scalar function says it hits.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "index/all_pairs.hpp"

namespace index_tests {
namespace {

template <class T>
struct Hits {
  std::vector<std::int64_t> all;
  std::int64_t first;
  typename Face<T>::Impact impact;
};

template <class T>
Hits<T> all_hits(const std::vector<Item<T>>& items, std::int64_t count, const Item<T>& one, T vx, T vy, T end) {
  Hits<T> hits{{}, count, {}};
  for (const Item<T>& item : items) {
    typename Face<T>::Impact impact;
    if (Face<T>::cast(item.kind, item.numbers, one.kind, one.numbers, vx, vy, end, &impact) <= 0) continue;
    hits.all.push_back(item.number);
    if (hits.first == count || impact.t < hits.impact.t) {
      hits.first = item.number;
      hits.impact = impact;
    }
  }
  return hits;
}

template <class T>
class CastTest : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(CastTest, Scalars);

TYPED_TEST(CastTest, AllAndFirst) {
  using T = TypeParam;
  constexpr T infinity = std::numeric_limits<T>::infinity();
  std::int64_t found = 0, misses = 0, ties = 0;
  const std::string several_levels = "uniform";  // blocks enough for nodes above nodes
  for (const char* name : {"uniform", "two_scales", "lattice", "points", "needles"}) {
    const Indexed<T> many(mixed<T>(name, name == several_levels ? 20000 : 700, 1, 113));
    const std::vector<Item<T>> items = items_of(many.laid);
    const Laid<T> ones = mixed<T>(name, 12, 2);
    const std::int64_t count = vesica_index_count(many.index.get());
    int turn = 0;
    for (const Item<T>& one : items_of(ones)) {
      typename Face<T>::Shapes shape;
      Face<T>::from_records(one.kind, 1, one.numbers, 0, &shape);
      for (const T end : {infinity, T(2), T(0)}) {
        const T vx = T(turn % 5 - 2) * T(1.5), vy = T(turn % 3 - 1) * T(2.25);
        ++turn;
        const Hits<T> expected = all_hits<T>(items, count, one, vx, vy, end);
        const auto all = [&](std::int64_t* out, std::int64_t capacity, std::int64_t* state) {
          return Face<T>::index_cast(many.index.get(), many.sets.data(), many.sets.count(), &shape, vx, vy, end, out,
                                     capacity, state);
        };
        ASSERT_EQ(all(nullptr, 0, nullptr), static_cast<std::int64_t>(expected.all.size())) << name;
        std::vector<std::int64_t> got;
        std::int64_t out[7], state[4] = {};
        while (state[0] != -1) {
          const std::int64_t n = all(out, 7, state);
          ASSERT_GE(n, 0);
          got.insert(got.end(), out, out + n);
        }
        std::sort(got.begin(), got.end());
        ASSERT_EQ(got, expected.all) << name;
        typename Face<T>::Impact impact;
        const std::int64_t first = Face<T>::index_cast_first(many.index.get(), many.sets.data(), many.sets.count(),
                                                             &shape, vx, vy, end, &impact);
        ASSERT_EQ(first, expected.first) << name;
        found += static_cast<std::int64_t>(expected.all.size());
        if (first == count) {
          ++misses;
          EXPECT_EQ(impact.t, infinity);
          continue;
        }
        ties += expected.impact.t == 0;
        EXPECT_EQ(impact.t, expected.impact.t);
        EXPECT_EQ(impact.x, expected.impact.x);
        EXPECT_EQ(impact.ny, expected.impact.ny);
      }
    }
  }
  EXPECT_GT(found, 300);
  EXPECT_GT(misses, 10);
  EXPECT_GT(ties, 10);
}

/// Ways across most of an index of several levels, page by page: whatever block a page ends in.
TYPED_TEST(CastTest, AcrossManyBlocks) {
  using T = TypeParam;
  const Indexed<T> many(mixed<T>("uniform", 20000, 1, 113));
  const std::vector<Item<T>> items = items_of(many.laid);
  const Laid<T> others = mixed<T>("uniform", 20000, 2);
  const std::vector<Item<T>> ones = items_of(others);
  const std::int64_t count = vesica_index_count(many.index.get());
  std::size_t longest = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const Item<T>& one = ones[(2 * i + 1) * ones.size() / 16];
    typename Face<T>::Shapes shape;
    Face<T>::from_records(one.kind, 1, one.numbers, 0, &shape);
    const T vx = T(i % 3) - 1, vy = T(i % 4) / 2 - T(0.75), end = 100;
    const Hits<T> expected = all_hits<T>(items, count, one, vx, vy, end);
    longest = std::max(longest, expected.all.size());
    std::vector<std::int64_t> got;
    std::int64_t out[5], state[4] = {};
    while (state[0] != -1) {
      const std::int64_t n = Face<T>::index_cast(many.index.get(), many.sets.data(), many.sets.count(), &shape, vx, vy,
                                                 end, out, 5, state);
      ASSERT_GE(n, 0);
      got.insert(got.end(), out, out + n);
    }
    std::sort(got.begin(), got.end());
    EXPECT_EQ(got, expected.all) << i;
    typename Face<T>::Impact impact;
    EXPECT_EQ(
        Face<T>::index_cast_first(many.index.get(), many.sets.data(), many.sets.count(), &shape, vx, vy, end, &impact),
        expected.first);
  }
  EXPECT_GT(longest, 50U);
}

/// Contact later than the greatest number is contact; which is first is not known, unless another one is.
TYPED_TEST(CastTest, LaterThanAllNumbers) {
  using T = TypeParam;
  constexpr T largest = std::numeric_limits<T>::max();
  const Indexed<T> many(Records<T>{VESICA_POINT, {largest / 2, 0, largest / 4, 0}});
  const T point[2] = {0, 0};
  typename Face<T>::Shapes one;
  Face<T>::from_records(VESICA_POINT, 1, point, 0, &one);
  std::int64_t out[2] = {7, 7}, state[4] = {};
  const auto cast = [&](T vx, std::int64_t capacity) {
    return Face<T>::index_cast(many.index.get(), many.sets.data(), 1, &one, vx, 0, std::numeric_limits<T>::infinity(),
                               out, capacity, state);
  };
  EXPECT_EQ(cast(T(0.125), 2), 2);
  EXPECT_EQ(cast(T(0.125), 0), 2);
  EXPECT_EQ(cast(1, 0), 2);
  const auto first = [&one](const Indexed<T>& index, T vx) {
    typename Face<T>::Impact impact;
    return Face<T>::index_cast_first(index.index.get(), index.sets.data(), 1, &one, vx, 0,
                                     std::numeric_limits<T>::infinity(), &impact);
  };
  EXPECT_EQ(first(many, T(0.125)), VESICA_E_RANGE);
  EXPECT_EQ(first(many, 1), 1);
  Records<T> points{VESICA_POINT, {}};
  for (int i = 0; i < 300; ++i) points.numbers.insert(points.numbers.end(), {largest / T(2 + i % 7), 0});
  points.numbers[2 * 170] = 5;
  EXPECT_EQ(first(Indexed<T>(points), T(0.125)), 170);
}

/// Items whose place at the end has more digits than exact numbers: each is an error of a page of its own, and all
/// other items are found, whatever the pages' length.
TEST(CastOfAllThereIs, BesideItemsThatCannotBeTold) {
  constexpr double vx = 0x1.0000000000001p-500, end = 0x1.0000000000001p-478;
  const double origin[2] = {0, 0};
  vesica_shapes_f64 one;
  vesica_shapes_from_records_f64(VESICA_POINT, 1, origin, 0, &one);
  Records<double> boxes{VESICA_AABB, {}};
  std::vector<std::int64_t> sound, unknown;
  for (int i = 0; i < 300; ++i) {
    const bool is_unknown = i % 50 == 7;
    boxes.numbers.insert(boxes.numbers.end(), {0x1p-990, -1, is_unknown ? 0x1p1020 : 0x1p-980, 1});
    (is_unknown ? unknown : sound).push_back(i);
    vesica_impact_f64 impact;
    ASSERT_EQ(vesica_cast_f64(VESICA_AABB, &boxes.numbers[4 * static_cast<std::size_t>(i)], VESICA_POINT, origin, vx, 0,
                              end, &impact),
              is_unknown ? VESICA_E_RANGE : VESICA_CAST_HIT);
  }
  const Indexed<double> many(boxes);
  const auto cast = [&](std::int64_t* out, std::int64_t capacity, std::int64_t* state) {
    return vesica_index_cast_f64(many.index.get(), many.sets.data(), 1, &one, vx, 0, end, out, capacity, state);
  };
  EXPECT_EQ(cast(nullptr, 0, nullptr), VESICA_E_RANGE);
  for (const std::int64_t capacity : {1, 2, 7, 64, 1000}) {
    std::vector<std::int64_t> got, out(static_cast<std::size_t>(capacity));
    std::int64_t state[4] = {};
    std::size_t errors = 0;
    while (state[0] != -1 && errors <= unknown.size()) {
      std::fill(out.begin(), out.end(), -7);
      const std::int64_t n = cast(out.data(), capacity, state);
      if (n < 0) {
        EXPECT_EQ(n, VESICA_E_RANGE);
        EXPECT_EQ(out[0], -7);
        ++errors;
        continue;
      }
      got.insert(got.end(), out.begin(), out.begin() + n);
    }
    std::sort(got.begin(), got.end());
    EXPECT_EQ(got, sound) << capacity;
    EXPECT_EQ(errors, unknown.size()) << capacity;
  }
}

/// Two sides whose times round down to one float: the lesser number is first, though it is hit later.
TEST(CastOfFloats, EqualTimesAfterRounding) {
  int ties = 0;
  for (int i = 0; i < 200; ++i) {
    const float x = std::nextafter(1.99f, 2.0f) + static_cast<float>(i) * 0x1p-23f, next = std::nextafter(x, 3.0f);
    const Indexed<float> many(Records<float>{VESICA_AABB, {next, -1, 3, 1, x, -1, 3, 1}});
    const std::vector<Item<float>> items = items_of(many.laid);
    const float point[2] = {0, 0}, vx = 1.9f;
    vesica_shapes_f32 one;
    vesica_shapes_from_records_f32(VESICA_POINT, 1, point, 0, &one);
    const Hits<float> expected = all_hits<float>(items, 2, {VESICA_POINT, point, 0, 0, 0, 0, 0}, vx, 0, INFINITY);
    vesica_impact_f32 impact;
    EXPECT_EQ(vesica_index_cast_first_f32(many.index.get(), many.sets.data(), 1, &one, vx, 0, INFINITY, &impact),
              expected.first);
    EXPECT_EQ(impact.t, expected.impact.t);
    ties += expected.first == 0;
  }
  EXPECT_GT(ties, 20);
  EXPECT_LT(ties, 180);
}

/// A moving shape whose bounds are beyond the finite numbers hits what is there, and no more.
TEST(CastOfAllThereIs, InfiniteBounds) {
  const Indexed<double> many(Records<double>{VESICA_POINT, {1, 0, 0, 3, -5, 5}});
  const double everything[6] = {0, 0, 1, 1, 0x1p1023, 0x1p1023};
  vesica_shapes_f64 one;
  vesica_shapes_from_records_f64(VESICA_RECT, 1, everything, 0, &one);
  for (const auto& [vx, vy] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {-1.0, 2.0}, {0x1p1000, -0x1p1000}}) {
    std::int64_t out[5], state[4] = {};
    EXPECT_EQ(vesica_index_cast_f64(many.index.get(), many.sets.data(), 1, &one, vx, vy, INFINITY, nullptr, 0, nullptr),
              3);
    EXPECT_EQ(vesica_index_cast_f64(many.index.get(), many.sets.data(), 1, &one, vx, vy, 1, out, 5, state), 3);
    vesica_impact_f64 impact;
    EXPECT_EQ(vesica_index_cast_first_f64(many.index.get(), many.sets.data(), 1, &one, vx, vy, 1, &impact), 0);
  }
}

/// Speeds near either end of the range, whose inverses overflow or have few digits: item i is hit at i + 1 ticks.
TEST(CastOfAllThereIs, LeastAndGreatestSpeeds) {
  constexpr std::int64_t n = 120, met = 50;
  const double origin[2] = {0, 0};
  vesica_shapes_f64 one;
  vesica_shapes_from_records_f64(VESICA_POINT, 1, origin, 0, &one);
  for (const int exponent : {-1074, -1060, -1026, -1023, -1001, -1000, -999, 0, 999, 1000, 1001, 1012}) {
    const double speed = std::ldexp(1.0, exponent);
    // So long that the least speeds go farther than the narrowest columns are wide, and the greatest within range.
    const double tick = exponent < 0 ? 0x1p80 : 1;
    for (const auto& [vx, vy] : {std::pair{speed, 0.0}, {-speed, 0.0}, {0.0, speed}, {speed, -speed}}) {
      Records<double> points{VESICA_POINT, {}};
      for (int i = 1; i <= n; ++i) points.numbers.insert(points.numbers.end(), {i * tick * vx, i * tick * vy});
      const Indexed<double> many(points);
      const double end = met * tick;
      EXPECT_EQ(vesica_index_cast_f64(many.index.get(), many.sets.data(), 1, &one, vx, vy, end, nullptr, 0, nullptr),
                met)
          << exponent;
      vesica_impact_f64 impact;
      EXPECT_EQ(vesica_index_cast_first_f64(many.index.get(), many.sets.data(), 1, &one, vx, vy, end, &impact), 0);
      EXPECT_EQ(impact.t, tick) << exponent;
    }
  }
}

/// Coordinates so far apart that their difference is beyond doubles.
TEST(CastOfAllThereIs, FromOneEndOfTheNumbersToTheOther) {
  constexpr double far = 1.7e308;
  const double origins[4][2] = {{-far, 0}, {far, 0}, {0, -far}, {0, far}};
  for (const auto& origin : origins) {
    for (const double speed : {1e290, 1e300, 1e301}) {
      const double target[2] = {-origin[0], -origin[1]};
      const Indexed<double> many(Records<double>{VESICA_POINT, {3, 5, target[0], target[1], 5, 3}});
      const double vx = origin[0] == 0 ? 0 : std::copysign(speed, target[0]);
      const double vy = origin[1] == 0 ? 0 : std::copysign(speed, target[1]);
      vesica_shapes_f64 one;
      vesica_shapes_from_records_f64(VESICA_POINT, 1, origin, 0, &one);
      vesica_impact_f64 impact;
      EXPECT_EQ(vesica_index_cast_first_f64(many.index.get(), many.sets.data(), 1, &one, vx, vy, 1e20, &impact), 1);
      EXPECT_NEAR(impact.t * (speed / far), 2, 1e-15);
      EXPECT_EQ(vesica_index_cast_f64(many.index.get(), many.sets.data(), 1, &one, vx, vy, 1e20, nullptr, 0, nullptr),
                1);
    }
  }
}

TEST(CastArguments, Refused) {
  const Indexed<double> many(rects<double>("uniform", 50, 1));
  const double point[2] = {0, 1}, invalid[2] = {NAN, 1};
  vesica_shapes_f64 one, bad;
  vesica_shapes_from_records_f64(VESICA_POINT, 1, point, 0, &one);
  vesica_shapes_from_records_f64(VESICA_POINT, 1, invalid, 0, &bad);
  vesica_impact_f64 impact{7, 7, 7, 7, 7};
  const auto first = [&](const vesica_shapes_f64* s, double vx, double end) {
    return vesica_index_cast_first_f64(many.index.get(), many.sets.data(), many.sets.count(), s, vx, 0, end, &impact);
  };
  EXPECT_EQ(first(nullptr, 1, 1), VESICA_E_NULL);
  EXPECT_EQ(first(&one, NAN, 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(first(&one, 1, -1), VESICA_E_ARGUMENT);
  EXPECT_EQ(first(&bad, 1, 1), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_index_cast_first_f64(many.index.get(), many.sets.data(), many.sets.count(), &one, 1, 0, 1, nullptr),
            VESICA_E_NULL);
  EXPECT_EQ(vesica_index_cast_first_f64(many.index.get(), nullptr, 0, &one, 1, 0, 1, &impact), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_index_cast_first_f64(nullptr, many.sets.data(), many.sets.count(), &one, 1, 0, 1, &impact),
            VESICA_E_NULL);
  EXPECT_EQ(impact.t, 7);
  std::int64_t out[3], state[4] = {0, 1, 0, 0};
  const auto all = [&](std::int64_t capacity) {
    return vesica_index_cast_f64(many.index.get(), many.sets.data(), many.sets.count(), &one, 1, 0, 1, out, capacity,
                                 state);
  };
  EXPECT_EQ(all(3), VESICA_E_ARGUMENT);  // not a state of this call
  EXPECT_EQ(all(-1), VESICA_E_ARGUMENT);
  state[0] = -1;
  EXPECT_EQ(all(3), 0);
}

// The state of a call with one number changed: no block, a negative count, or no mark.
TEST(CastArguments, StatesMadeUp) {
  const Indexed<double> many(rects<double>("uniform", 2000, 1));
  const double circle[3] = {0, 0, 1e6};
  vesica_shapes_f64 one;
  vesica_shapes_from_records_f64(VESICA_CIRCLE, 1, circle, 0, &one);
  std::int64_t out[3], state[4] = {};
  const auto next = [&] {
    return vesica_index_cast_f64(many.index.get(), many.sets.data(), many.sets.count(), &one, 1, 0, 1, out, 3, state);
  };
  ASSERT_EQ(next(), 3);
  const std::int64_t sound[4] = {state[0], state[1], state[2], state[3]};
  for (int number = 0; number < 4; ++number) {
    for (const std::int64_t x : {std::numeric_limits<std::int64_t>::min(), std::int64_t{-2}, std::int64_t{1} << 40}) {
      if (number == 1 && x > 0) continue;  // more items than there are: none is left
      state[number] = x;
      EXPECT_EQ(next(), VESICA_E_ARGUMENT) << number << ' ' << x;
      state[number] = sound[number];
    }
  }
  EXPECT_EQ(next(), 3);
}

}  // namespace
}  // namespace index_tests
