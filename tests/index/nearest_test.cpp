// SPDX-License-Identifier: Apache-2.0
/// The nearest items are those of all, sorted by the scalar function's distances and their numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "index/all_pairs.hpp"

namespace index_tests {
namespace {

template <class T>
std::vector<std::pair<T, std::int64_t>> all_distances(const Item<T>& one, const std::vector<Item<T>>& many, T within) {
  std::vector<std::pair<T, std::int64_t>> all;
  for (const Item<T>& other : many) {
    typename Face<T>::Points points;
    if (Face<T>::nearest(one.kind, one.numbers, other.kind, other.numbers, &points) != 0) continue;
    if (points.distance <= within) all.emplace_back(points.distance, other.number);
  }
  std::sort(all.begin(), all.end());
  return all;
}

template <class T>
class NearestTest : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(NearestTest, Scalars);

TYPED_TEST(NearestTest, AllSorted) {
  using T = TypeParam;
  constexpr T infinity = std::numeric_limits<T>::infinity();
  for (const char* name : {"uniform", "two_scales", "lattice", "points", "needles", "pareto_needles", "line",
                           "near_ties", "whole_range"}) {
    const Indexed<T> many(mixed<T>(name, 900, 1, 113));
    const std::vector<Item<T>> items = items_of(many.laid);
    const Laid<T> ones = mixed<T>(name, 30, 2);
    for (const Item<T>& one : items_of(ones)) {
      typename Face<T>::Shapes shape;
      Face<T>::from_records(one.kind, 1, one.numbers, 0, &shape);
      for (const T within : {infinity, T(1.5), T(0)}) {
        const auto expected = all_distances<T>(one, items, within);
        const auto find = Face<T>::index_nearest;
        EXPECT_EQ(find(many.index.get(), many.sets.data(), many.sets.count(), &shape, 0, within, nullptr, nullptr),
                  static_cast<std::int64_t>(expected.size()));
        for (const std::int64_t k : {1, 10, 1000}) {
          std::vector<std::int64_t> out(static_cast<std::size_t>(k));
          std::vector<T> distance(static_cast<std::size_t>(k));
          const std::int64_t n = find(many.index.get(), many.sets.data(), many.sets.count(), &shape, k, within,
                                      out.data(), distance.data());
          ASSERT_EQ(n, std::min(k, static_cast<std::int64_t>(expected.size()))) << name;
          for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
            ASSERT_EQ(distance[i], expected[i].first) << name << ", number " << i;
            ASSERT_EQ(out[i], expected[i].second) << name << ", number " << i;
          }
        }
      }
    }
  }
}

/// Numbers between -1 and 1 from a seed.
struct Directions {
  std::uint64_t state;
  double next() {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return std::ldexp(static_cast<double>(state >> 11), -52) - 1;
  }
};

/// The `k` nearest of one shape, and nothing else, as the scalar function has them.
template <class T>
void expect_nearest(const Indexed<T>& many, const std::vector<Item<T>>& items, std::int32_t kind, const T* numbers,
                    std::size_t k) {
  typename Face<T>::Shapes shape;
  Face<T>::from_records(kind, 1, numbers, 0, &shape);
  std::vector<std::int64_t> out(k);
  std::vector<T> distance(k);
  constexpr T infinity = std::numeric_limits<T>::infinity();
  const Item<T> one{kind, numbers, 0, 0, 0, 0, 0};
  const auto expected = all_distances<T>(one, items, infinity);
  const std::int64_t n = Face<T>::index_nearest(many.index.get(), many.sets.data(), many.sets.count(), &shape,
                                                static_cast<std::int64_t>(k), infinity, out.data(), distance.data());
  ASSERT_EQ(n, static_cast<std::int64_t>(std::min(k, expected.size())));
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
    ASSERT_EQ(distance[i], expected[i].first) << "kind " << kind << ", number " << i;
    ASSERT_EQ(out[i], expected[i].second) << "kind " << kind << ", number " << i;
  }
}

/// Many blocks, few of them searched, and more items at hand than the search has room for.
TYPED_TEST(NearestTest, OfMany) {
  using T = TypeParam;
  for (const char* name : {"uniform", "clustered", "decades_6", "pareto_needles", "line", "points", "whole_range"}) {
    const Indexed<T> many(mixed<T>(name, 6000, 1, 113));
    const std::vector<Item<T>> items = items_of(many.laid);
    const Laid<T> ones = mixed<T>(name, 6, 2);
    for (const Item<T>& one : items_of(ones)) {
      for (const std::size_t k : {1, 10, 3000}) expect_nearest<T>(many, items, one.kind, one.numbers, k);
    }
  }
}

/// All equally far from the middle, up to rounding: neither places nor items come in an order.
TYPED_TEST(NearestTest, OfACircle) {
  using T = TypeParam;
  Records<T> points{VESICA_POINT, {}};
  Directions random{5};
  for (int i = 0; i < 30000; ++i) {
    const double x = random.next(), y = random.next(), length = std::sqrt(x * x + y * y);
    points.numbers.insert(points.numbers.end(), {static_cast<T>(x / length), static_cast<T>(y / length)});
  }
  const Indexed<T> many(points);
  const std::vector<Item<T>> items = items_of(many.laid);
  const T middle[2] = {0, 0};
  for (const std::size_t k : {1, 10, 7000}) expect_nearest<T>(many, items, VESICA_POINT, middle, k);
}

/// Points, circles and boxes at all distances from each other: of exact halves between numbers, a unit in the last
/// place apart, far smaller and far larger than the shapes.
TYPED_TEST(NearestTest, PlainShapes) {
  using T = TypeParam;
  constexpr int digits = std::numeric_limits<T>::digits;
  Directions random{11};
  for (const int exponent : {0, -60, 60, 99, 102, -99, -103}) {
    const auto number = [&](int smaller) {
      return static_cast<T>(
          std::ldexp(1 + std::fabs(random.next()), exponent - static_cast<int>(std::fabs(random.next()) * smaller)));
    };
    Records<T> points{VESICA_POINT, {}}, circles{VESICA_CIRCLE, {}}, boxes{VESICA_AABB, {}};
    for (int i = 0; i < 400; ++i) {
      const T x = number(2 * digits), y = i % 3 == 0 ? T(0) : number(2 * digits),
              size = number(i % 2 == 0 ? 4 : digits);
      points.numbers.insert(points.numbers.end(), {x, y});
      circles.numbers.insert(circles.numbers.end(), {x + size, y, i % 5 == 0 ? std::nextafter(size, T(0)) : size / 2});
      boxes.numbers.insert(boxes.numbers.end(), {x, y, x + size, y + size / 4});
      // From an end below 0 this is a number and half of its last place.
      boxes.numbers.insert(boxes.numbers.end(), {std::nextafter(x, x + size), -size, x + size, size});
    }
    const Indexed<T> many(Laid<T>{points, circles, boxes});
    const std::vector<Item<T>> items = items_of(many.laid);
    const auto half = static_cast<T>(std::ldexp(1.0, exponent - digits));
    const T numbers[][4] = {{0, 0}, {-half, 0}, {-half, -half}, {-half, 0, half / 2}, {-2 * half, -half, -half, half}};
    const std::int32_t kinds[] = {VESICA_POINT, VESICA_POINT, VESICA_POINT, VESICA_CIRCLE, VESICA_AABB};
    for (int q = 0; q < 5; ++q) expect_nearest<T>(many, items, kinds[q], numbers[q], items.size());
  }
}

/// Points and boxes of whole numbers, some of them several times: many are equally far, and the k-th is one of these.
TYPED_TEST(NearestTest, BoxesAtEqualDistances) {
  using T = TypeParam;
  Records<T> points{VESICA_POINT, {}}, boxes{VESICA_AABB, {}};
  for (int i = 0; i < 3000; ++i) {
    const auto x = static_cast<T>(i * 7 % 40), y = static_cast<T>(i * 11 % 37);
    points.numbers.insert(points.numbers.end(), {x, y});
    boxes.numbers.insert(boxes.numbers.end(), {x, y, x + static_cast<T>(i % 3), y + static_cast<T>(i % 2)});
  }
  const T numbers[][4] = {{20, 18}, {20.5, 18.5}, {-3, 7}, {10, 10, 13, 12}};
  const std::int32_t kinds[] = {VESICA_POINT, VESICA_POINT, VESICA_POINT, VESICA_AABB};
  for (const Laid<T>& laid : {Laid<T>{points}, Laid<T>{boxes}, Laid<T>{boxes, points}}) {
    const Indexed<T> many(laid);
    const std::vector<Item<T>> items = items_of(many.laid);
    for (int q = 0; q < 4; ++q) {
      for (const std::size_t k : {1, 2, 5, 10, 31, 32, 33, 40}) expect_nearest<T>(many, items, kinds[q], numbers[q], k);
    }
  }
}

/// Points and boxes of one magnitude and of all, the farthest of them at a distance beyond the finite numbers.
TYPED_TEST(NearestTest, BoxesOfAllMagnitudes) {
  using T = TypeParam;
  constexpr int least = std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits,
                most = std::numeric_limits<T>::max_exponent;
  Directions random{17};
  Laid<T> all;
  for (const int exponent : {least + 15, least + 80, -60, 0, 60, most / 2, most - 20, most}) {
    Records<T> points{VESICA_POINT, {}}, boxes{VESICA_AABB, {}};
    for (int i = 0; i < 100; ++i) {
      const auto number = [&] { return static_cast<T>(std::ldexp(random.next() * 0.99, exponent)); };
      const T x = number(), y = number(), other_x = number(), other_y = number();
      points.numbers.insert(points.numbers.end(), {x, y});
      boxes.numbers.insert(boxes.numbers.end(),
                           {std::min(x, other_x), std::min(y, other_y), std::max(x, other_x), std::max(y, other_y)});
    }
    points.numbers[0] = std::numeric_limits<T>::quiet_NaN();  // not in the index
    all.push_back(points);
    all.push_back(boxes);
    for (const Laid<T>& laid : {Laid<T>{points}, Laid<T>{boxes}, all}) {
      const Indexed<T> many(laid);
      const std::vector<Item<T>> items = items_of(many.laid);
      for (const T factor : {T(0), T(1), T(-0.7)}) {
        const auto far = static_cast<T>(std::ldexp(0.99, exponent));
        const T numbers[4] = {factor * far, factor * far / 2, factor * far, far};
        for (const std::size_t k : {std::size_t{1}, std::size_t{10}, std::size_t{32}, items.size() + 5}) {
          expect_nearest<T>(many, items, VESICA_POINT, numbers, k);
          expect_nearest<T>(many, items, VESICA_AABB, numbers, k);
        }
      }
    }
  }
}

TYPED_TEST(NearestTest, OfEachItem) {
  using T = TypeParam;
  constexpr T infinity = std::numeric_limits<T>::infinity();
  const Indexed<T> many(mixed<T>("uniform", 300, 1));
  const Laid<T> laid = mixed<T>("uniform", 100, 2, 31);
  const Sets<T> sets(laid);
  const std::vector<Item<T>> items = items_of(many.laid);
  std::vector<std::int64_t> out(500, 77);
  std::vector<T> distance(500);
  bool invalid = false;
  for (const std::int64_t part : {0, 1, 2}) {
    invalid |= Face<T>::join_nearest(sets.data(), sets.count(), many.index.get(), many.sets.data(), many.sets.count(),
                                     5, T(2), part, 3, out.data(), distance.data()) == VESICA_E_SHAPE;
  }
  EXPECT_TRUE(invalid);
  std::vector<bool> seen(100);
  for (const Item<T>& one : items_of(laid)) {
    const auto expected = all_distances<T>(one, items, T(2));
    seen[static_cast<std::size_t>(one.number)] = true;
    for (std::size_t i = 0; i < 5; ++i) {
      const std::size_t at = static_cast<std::size_t>(one.number) * 5 + i;
      EXPECT_EQ(out[at], i < expected.size() ? expected[i].second : -1);
      EXPECT_EQ(distance[at], i < expected.size() ? expected[i].first : infinity);
    }
  }
  for (std::size_t i = 0; i < 100; ++i) {
    if (!seen[i]) {
      EXPECT_EQ(out[i * 5], -1);
    }
  }
}

TEST(NearestParts, WriteEachRowOnce) {
  constexpr std::size_t rows = 10;
  const Indexed<double> many(Records<double>{VESICA_POINT, {0, 0, 1, 0}});
  const Laid<double> laid{{VESICA_POINT, std::vector<double>(2 * rows)}};
  const Sets<double> sets(laid);
  for (const std::int64_t parts : {std::int64_t{1}, std::int64_t{3}, std::int64_t{4}, std::int64_t{7}, std::int64_t{10},
                                   std::int64_t{12}, std::numeric_limits<std::int64_t>::max()}) {
    std::vector<int> written(rows);
    std::int64_t found = 0;
    for (std::int64_t part = 0; part < std::min<std::int64_t>(parts, 12); ++part) {
      std::vector<std::int64_t> out(rows, -7);
      std::vector<double> distance(rows);
      found += vesica_join_nearest_f64(sets.data(), sets.count(), many.index.get(), many.sets.data(), many.sets.count(),
                                       1, INFINITY, part, parts, out.data(), distance.data());
      for (std::size_t i = 0; i < rows; ++i) written[i] += out[i] != -7;
    }
    EXPECT_EQ(found, static_cast<std::int64_t>(rows)) << parts;
    EXPECT_EQ(written, std::vector<int>(rows, 1)) << parts;
  }
}

TEST(NearestArguments, Refused) {
  const Indexed<double> many(rects<double>("uniform", 50, 1));
  const double point[2] = {NAN, 1};
  vesica_shapes_f64 one;
  vesica_shapes_from_records_f64(VESICA_POINT, 1, point, 0, &one);
  std::int64_t out[3];
  double distance[3];
  const auto call = [&](std::int64_t k, double within) {
    return vesica_index_nearest_f64(many.index.get(), many.sets.data(), 1, &one, k, within, out, distance);
  };
  EXPECT_EQ(call(3, 1), VESICA_E_SHAPE);
  EXPECT_EQ(call(-1, 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(call(3, -1), VESICA_E_ARGUMENT);
  EXPECT_EQ(call(3, NAN), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_index_nearest_f64(many.index.get(), many.sets.data(), 0, &one, 3, 1, out, distance),
            VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_index_nearest_f64(many.index.get(), many.sets.data(), 1, nullptr, 3, 1, out, distance),
            VESICA_E_NULL);
  EXPECT_EQ(vesica_index_nearest_f64(many.index.get(), many.sets.data(), 1, &one, 3, 1, nullptr, distance),
            VESICA_E_NULL);
}

/// Rows of no items take no room.
TEST(Nearest, OfEachOfNone) {
  const Indexed<double> many(mixed<double>("uniform", 3, 1));
  vesica_shapes_f64 none;
  vesica_shapes_from_records_f64(VESICA_POINT, 0, nullptr, 0, &none);
  const auto call = [&](const vesica_shapes_f64* sets, std::int64_t k) {
    return vesica_join_nearest_f64(sets, 1, many.index.get(), many.sets.data(), many.sets.count(), k, 1, 0, 1, nullptr,
                                   nullptr);
  };
  EXPECT_EQ(call(&none, 3), 0);
  EXPECT_EQ(call(&none, 0), VESICA_E_ARGUMENT);
  EXPECT_EQ(call(many.sets.data(), 3), VESICA_E_NULL);
  EXPECT_EQ(call(nullptr, 3), VESICA_E_NULL);
}

}  // namespace
}  // namespace index_tests
