// SPDX-License-Identifier: Apache-2.0
/// vesica::Index and its loops over pairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <ranges>
#include <span>
#include <vector>
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

}  // namespace
}  // namespace index_tests
