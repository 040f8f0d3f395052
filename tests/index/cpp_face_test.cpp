// SPDX-License-Identifier: Apache-2.0
/// vesica::Index and its loops over pairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <ranges>
#include <span>
#include <vector>
#include <vesica/shapes.hpp>
#include <vesica_index.hpp>

#include "index/face.hpp"

namespace index_tests {
namespace {

TEST(CppFace, PairsSelectionNearestAndBytes) {
  const Laid<double> laid_a = mixed<double>("uniform", 600, 1), laid_b = mixed<double>("uniform", 500, 2);
  const Sets<double> a(laid_a), b(laid_b);
  const vesica::Index<double> first(a.sets), second(b.sets);
  const Indexed<double> plain_a{Laid<double>(laid_a)}, plain_b{Laid<double>(laid_b)};
  EXPECT_FALSE(first.has_invalid());
  EXPECT_EQ(first.count(), 600);
  EXPECT_EQ(static_cast<std::int64_t>(first.bytes().size()), plain_a.result);
  EXPECT_EQ(first.order().size(), 600u);
  std::vector<Pair> found;
  auto all = vesica::pairs(first, second);
  for (const auto& pair : all) found.push_back(pair);
  EXPECT_EQ(found, join(VESICA_JOIN_OVERLAP, plain_a, plain_b));
  EXPECT_EQ(all.count(), static_cast<std::int64_t>(found.size()));
  EXPECT_EQ(vesica::pairs(first).count(), count(VESICA_JOIN_OVERLAP, plain_a, plain_a));

  vesica_shapes_f64 one;
  vesica_shapes_from_records_f64(VESICA_POINT, 1, laid_b[0].numbers.data(), 0, &one);
  const auto nearest = first.nearest(one, 3, std::numeric_limits<double>::infinity());
  ASSERT_EQ(nearest.size(), 3u);
  EXPECT_LE(nearest[0].second, nearest[1].second);
  EXPECT_TRUE(first.nearest(one, 0, std::numeric_limits<double>::infinity()).empty());
  for (const std::int64_t item : first.overlapping(one)) EXPECT_TRUE(std::ranges::count(found, Pair{item, 0}) == 1);
  const double broken[3] = {0, 0, -1};
  vesica_shapes_from_records_f64(VESICA_CIRCLE, 1, broken, 0, &one);
  const vesica::Index<double> invalid(std::span(&one, 1));
  EXPECT_TRUE(invalid.has_invalid());
  EXPECT_TRUE(vesica::Index<double>(std::span(&one, 1), invalid.bytes()).has_invalid()) << "restored";
  EXPECT_THROW(first.overlapping(one), std::invalid_argument);
}

TEST(CppFace, SpansOfStructsRangesAndSavedBytes) {
  const std::vector<vesica_circle_f32> circles{{0, 0, 1}, {9, 0, 1}};
  const vesica_aabb_f32 boxes[] = {{1, -1, 2, 1}, {4, 4, 5, 5}};
  const vesica::Index<float> a({vesica::shapes(circles), vesica::shapes(boxes)});
  static_assert(std::ranges::input_range<decltype(vesica::pairs(a))>);
  auto touching = vesica::pairs(a);
  ASSERT_EQ(std::ranges::distance(touching), 1);
  EXPECT_EQ(*touching.begin(), (Pair{0, 2}));

  const auto sets = std::span(a.sets(), static_cast<std::size_t>(a.set_count()));
  const vesica::Index<float> again(sets, a.bytes());
  EXPECT_TRUE(std::ranges::equal(again.bytes(), a.bytes()));
  EXPECT_EQ(vesica::pairs(again, a, VESICA_JOIN_CONTAINS).count(), 4) << "each shape contains itself";
  EXPECT_THROW(vesica::Index<float>(sets, a.bytes().subspan(64)), std::invalid_argument);
  EXPECT_THROW(vesica::Index<float>(sets, {}), std::invalid_argument);
}

/// An executor of one's own: the last part first.
struct Backwards {
  template <class Task>
  void operator()(std::int64_t parts, const Task& task) const {
    for (std::int64_t part = parts; part > 0; --part) task(part - 1);
  }
};

TEST(CppFace, ExecutorsGiveTheSameBytesAndPairs) {
  const Laid<double> laid_a = mixed<double>("uniform", 3000, 3), laid_b = mixed<double>("uniform", 2000, 4);
  const Sets<double> a(laid_a), b(laid_b);
  const vesica::Index<double> first(a.sets), second(b.sets), threaded(a.sets, vesica::Threads(3)),
      backwards(a.sets, Backwards());
  EXPECT_TRUE(std::ranges::equal(first.bytes(), threaded.bytes()));
  EXPECT_TRUE(std::ranges::equal(first.bytes(), backwards.bytes()));
  const auto compare = [](auto pairs) {
    std::vector<Pair> expected;
    for (const auto& pair : pairs) expected.push_back(pair);
    EXPECT_GT(expected.size(), 100U);
    EXPECT_EQ(pairs.all(vesica::Threads(1)), expected);
    EXPECT_EQ(pairs.all(vesica::Threads(3)), expected);
    EXPECT_EQ(pairs.all(Backwards()), expected);
  };
  compare(vesica::pairs(first, second));
  compare(vesica::pairs(first));
  compare(vesica::pairs_within(first, second, 0.25));
  const auto nearest = vesica::nearest_of_each(second, first, 2, vesica::Threads(2), 5.0);
  ASSERT_EQ(nearest.item.size(), 4000U);
  for (const std::size_t i : {std::size_t{0}, std::size_t{777}, std::size_t{1999}}) {
    std::int64_t kept = static_cast<std::int64_t>(i);
    for (std::int32_t set = 0; set < second.set_count(); ++set) {
      auto one = second.sets()[set];
      if (kept >= one.count) {
        kept -= one.count;
        continue;
      }
      for (auto& field : one.field) {
        if (field != nullptr) {
          field = reinterpret_cast<const double*>(reinterpret_cast<const unsigned char*>(field) + kept * one.stride);
        }
      }
      one.count = 1;
      const auto found = first.nearest(one, 2, 5);
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_EQ(nearest.items_of(i)[k], found[k].first);
        EXPECT_EQ(nearest.distance[2 * i + k], found[k].second);
      }
      break;
    }
  }
  EXPECT_THROW(vesica::pairs_within(first, second, std::numeric_limits<double>::quiet_NaN()).all(Backwards()),
               std::invalid_argument);
  for (const std::int64_t k : {0, -1})
    EXPECT_THROW(vesica::nearest_of_each(second, first, k, vesica::Threads(2)), std::invalid_argument);
  EXPECT_THROW(first.nearest(vesica_point_f64{0, 0}, -1), std::invalid_argument);
}

TEST(CppFace, ShapesOfTheCoreAndSingleOnes) {
  const std::vector<vesica::Rect<double>> rects{{0, 0, 1, 0, 1, 1}, {10, 0, 0.6, 0.8, 2, 1}};
  const vesica::Capsule<double> capsules[] = {{20, 0, 22, 0, 0.5}};
  const double corners[] = {30, -1, 32, -1, 32, 1, 30, 1};
  const vesica_polygon_f64 zones[] = {{corners, corners + 1, 2 * sizeof(double), nullptr, 4}};
  const vesica::Index<double> index({vesica::shapes(rects), vesica::shapes(capsules), vesica::shapes(zones)});
  EXPECT_FALSE(index.has_invalid());
  EXPECT_EQ(index.overlapping(vesica_point_f64{31, 0}), std::vector<std::int64_t>{3});
  EXPECT_EQ(index.overlapping(vesica::Circle<double>{21, 1, 0.6}), std::vector<std::int64_t>{2});
  EXPECT_EQ(index.nearest(vesica::Point<double>{3, 0}, 1)[0], std::pair(std::int64_t{0}, 2.0));
  std::vector<std::int64_t> touched = index.touched(vesica_point_f64{-5, 0}, 1, 0, 26);
  std::ranges::sort(touched);
  EXPECT_EQ(touched, (std::vector<std::int64_t>{0, 1, 2}));
  const auto hit = index.first_touched(vesica::Circle<double>{-5, 0, 1}, 1, 0);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->first, 0);
  EXPECT_EQ(hit->second.t, 3);
  EXPECT_FALSE(index.first_touched(vesica::Circle<double>{-5, 0, 1}, -1, 0).has_value());
  // It comes down on the first rectangle, whose top is at y = 1.
  const vesica::Segment<double> bar{-4, 6, 4, 6};
  const vesica_turn_f64 down{0, -8, 0}, up{0, 8, 1};
  const auto turning = index.first_touched(bar, down, 1e-9);
  ASSERT_TRUE(turning.has_value());
  EXPECT_EQ(turning->item, 0);
  EXPECT_NEAR(turning->impact.t, 0.625, 1e-9);
  EXPECT_LE(turning->gap, 1e-9);
  EXPECT_EQ(turning->answer, VESICA_CAST_HIT);
  EXPECT_FALSE(index.first_touched(bar, up, 1e-9).has_value());
  EXPECT_THROW(index.first_touched(bar, down, 0), std::invalid_argument);
  EXPECT_THROW(index.overlapping(vesica::Circle<double>{0, 0, -1}), std::invalid_argument);
}

}  // namespace
}  // namespace index_tests
