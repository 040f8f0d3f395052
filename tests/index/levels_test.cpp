// SPDX-License-Identifier: Apache-2.0
/// Cases of a large index alone: nested clusters, and blocks that overlap more blocks than are listed at once.
#include <gtest/gtest.h>

#include <functional>

#include "index/face.hpp"
#include "properties/random.hpp"

namespace index_tests {
namespace {

template <class T>
class LevelsTest : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(LevelsTest, Scalars);

template <class T>
Records<T> points(std::int64_t n, const std::function<double(std::int64_t)>& reach) {
  properties::Random random(1);
  Records<T> records{VESICA_POINT, {}};
  for (std::int64_t i = 0; i < n; ++i) {
    const double most = reach(i);
    for (int k = 0; k < 2; ++k) records.numbers.push_back(static_cast<T>(most * random.unit()));
  }
  return records;
}

/// True if the build, which plans by 4,096 of n items, skips item i.
bool is_passed_over(std::int64_t i, std::int64_t n) {
  const std::int64_t sample = (i * 4096 + n - 1) / n;
  return sample * n / 4096 != i;
}

/// Crowds that no sample shows: a third of 100,000 points lies in a hundred-millionth of the area of all, and a third
/// of those in as small a part again.
TYPED_TEST(LevelsTest, CrowdsWithinCrowds) {
  constexpr std::int64_t n = 100000;
  const auto is_crowded = [](std::int64_t i) { return i % 3 == 0 && is_passed_over(i, n); };
  std::int64_t crowd = 0, at = 0;
  for (std::int64_t i = 0; i < n; ++i) crowd += is_crowded(i);
  const Records<TypeParam> all = points<TypeParam>(n, [&](std::int64_t i) {
    if (!is_crowded(i)) return 1.0;
    const bool hidden = at % 3 == 0 && is_passed_over(at, crowd);
    ++at;
    return hidden ? 0x1p-26 : 0x1p-13;
  });
  const Indexed<TypeParam> many(all);
  EXPECT_EQ(vesica_index_check(many.index.get(), many.index.size), 0);
  for (const double size : {1.0, 0.25, 0x1p-12, 0x1p-13, 0x1p-14, 0x1p-20, 0x1p-26, 0x1p-27, 0x1p-40}) {
    const auto most = static_cast<TypeParam>(size);
    const TypeParam window[] = {most / 2, most / 4, most, most};
    std::int64_t expected = 0;
    for (std::size_t i = 0; i < all.numbers.size(); i += 2) {
      const TypeParam x = all.numbers[i], y = all.numbers[i + 1];
      expected += x >= window[0] && x <= window[2] && y >= window[1] && y <= window[3];
    }
    typename Face<TypeParam>::Shapes one;
    Face<TypeParam>::from_records(VESICA_AABB, 1, window, 0, &one);
    EXPECT_EQ(Face<TypeParam>::index_select(many.index.get(), many.sets.data(), 1, &one, nullptr, 0, nullptr), expected)
        << size;
  }
}

/// Parts are of like weight, which is counted before the join: of a block that meets more than 256 others too.
TYPED_TEST(LevelsTest, PartsOfBlocksThatMeetMany) {
  const Indexed<TypeParam> all(points<TypeParam>(700000, [](std::int64_t) { return 1; }));
  Records<TypeParam> few{VESICA_CIRCLE, {}};
  properties::Random random(2);
  for (int i = 0; i < 1500; ++i) {
    for (const double x : {random.unit(), random.unit(), 0x1p-12}) few.numbers.push_back(static_cast<TypeParam>(x));
  }
  const Indexed<TypeParam> discs(few);
  const std::vector<Pair> whole = join(VESICA_JOIN_OVERLAP, discs, all);
  EXPECT_GT(whole.size(), 50);
  std::vector<Pair> joined;
  for (std::int64_t part = 0; part < 3; ++part) {
    const std::vector<Pair> some = join(VESICA_JOIN_OVERLAP, discs, all, part, 3);
    EXPECT_EQ(count(VESICA_JOIN_OVERLAP, discs, all, part, 3), static_cast<std::int64_t>(some.size()));
    joined.insert(joined.end(), some.begin(), some.end());
  }
  EXPECT_TRUE(joined == whole);
}

}  // namespace
}  // namespace index_tests
