// SPDX-License-Identifier: Apache-2.0
/// Joins hold exactly the pairs that the scalar functions find, whatever lies in the sets.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <type_traits>

#include "index/all_pairs.hpp"
#include "properties/random.hpp"

namespace index_tests {
namespace {

/// So many of a workload that its pairs are not too many for the scalar functions: of few all overlap, as the exact
/// stage alone can decide; as circles and as floats others fall together.
template <class T>
std::int64_t many_of(const std::string& name, bool of_all_kinds) {
  if (name == "whole_range") return 250;
  if (name == "apart" && of_all_kinds) return 2000;
  if (name == "three_scales" && std::is_same_v<T, float>) return 2000;
  const std::int64_t most = name == "near_ties" ? 10000 : 20000;
  return properties::draws_all() ? most : most * properties::repeat();
}

template <class T>
void expect_all_pairs(const Indexed<T>& a, const Indexed<T>& b, const std::string& what) {
  const bool self = &a == &b;
  const std::vector<Pair> expected = all_pairs<T>(a.laid, b.laid, self, overlaps<T>);
  const std::vector<Pair> found = sorted(join(VESICA_JOIN_OVERLAP, a, b));
  EXPECT_EQ(found.size(), expected.size()) << what;
  EXPECT_TRUE(found == expected) << what;
  if (self) {
    EXPECT_EQ(count(VESICA_JOIN_OVERLAP, a, b), static_cast<std::int64_t>(expected.size())) << what;
  }
}

template <class T>
class JoinTest : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(JoinTest, Scalars);

TYPED_TEST(JoinTest, RectsOfEveryWorkload) {
  for (const std::string& name : rect_workloads()) {
    const std::int64_t n = many_of<TypeParam>(name, false);
    const Indexed<TypeParam> a(rects<TypeParam>(name, n, 1)), b(rects<TypeParam>(name, n - n / 20, 2));
    ASSERT_GT(a.result, 0) << name;
    ASSERT_EQ(vesica_index_check(a.index.get(), a.result), 0) << name;
    expect_all_pairs(a, b, name);
    expect_all_pairs(a, a, name + " with itself");
  }
}

TYPED_TEST(JoinTest, AllKindsOfEveryWorkloadWithInvalidOnes) {
  for (const std::string& name : rect_workloads()) {
    const std::int64_t n = many_of<TypeParam>(name, true);
    const Indexed<TypeParam> a(mixed<TypeParam>(name, n, 3, 97)), b(mixed<TypeParam>(name, n - n / 20, 4, 89));
    ASSERT_EQ(a.result, VESICA_E_SHAPE) << name;
    ASSERT_EQ(vesica_index_check(a.index.get(), a.index.size), 0) << name;
    expect_all_pairs(a, b, name);
    expect_all_pairs(a, a, name + " with itself");
  }
}

TYPED_TEST(JoinTest, Containment) {
  for (const std::string name : {"decades_3", "one_giant", "points", "near_ties"}) {
    const Indexed<TypeParam> a(mixed<TypeParam>(name, std::min<std::int64_t>(3000, many_of<TypeParam>(name, true)), 5)),
        b(mixed<TypeParam>(name, std::min<std::int64_t>(3000, many_of<TypeParam>(name, true)), 6));
    const auto inside = [](const Item<TypeParam>& x, const Item<TypeParam>& y) { return contains<TypeParam>(y, x); };
    EXPECT_TRUE(sorted(join(VESICA_JOIN_CONTAINS, a, b)) ==
                all_pairs<TypeParam>(a.laid, b.laid, false, contains<TypeParam>))
        << name;
    EXPECT_TRUE(sorted(join(VESICA_JOIN_INSIDE, a, b)) == all_pairs<TypeParam>(a.laid, b.laid, false, inside)) << name;
    EXPECT_TRUE(sorted(join(VESICA_JOIN_CONTAINS, a, a)) ==
                all_pairs<TypeParam>(a.laid, a.laid, true, contains<TypeParam>))
        << name;
    EXPECT_TRUE(sorted(join(VESICA_JOIN_INSIDE, a, a)) == all_pairs<TypeParam>(a.laid, a.laid, true, inside)) << name;
  }
}

TYPED_TEST(JoinTest, Interiors) {
  for (const std::string name : {"decades_3", "one_giant", "points", "near_ties"}) {
    const std::int64_t n = std::min<std::int64_t>(3000, many_of<TypeParam>(name, true));
    const Indexed<TypeParam> a(mixed<TypeParam>(name, n, 5)), b(mixed<TypeParam>(name, n, 6));
    EXPECT_TRUE(sorted(join(VESICA_JOIN_INTERIORS, a, b)) ==
                all_pairs<TypeParam>(a.laid, b.laid, false, interiors_overlap<TypeParam>))
        << name;
    EXPECT_TRUE(sorted(join(VESICA_JOIN_INTERIORS, a, a)) ==
                all_pairs<TypeParam>(a.laid, a.laid, true, interiors_overlap<TypeParam>))
        << name;
  }
}

TYPED_TEST(JoinTest, BoundsHoldAllPairsAndLittleMore) {
  for (const std::string& name : rect_workloads()) {
    const Indexed<TypeParam> a(rects<TypeParam>(name, std::min<std::int64_t>(3000, many_of<TypeParam>(name, true)), 7)),
        b(rects<TypeParam>(name, std::min<std::int64_t>(3000, many_of<TypeParam>(name, true)), 8));
    const auto meet = [](const Item<TypeParam>&, const Item<TypeParam>&) { return true; };
    const std::vector<Pair> certain = all_pairs<TypeParam>(a.laid, b.laid, false, meet);
    const std::vector<Pair> found = sorted(join(VESICA_JOIN_BOUNDS, a, b));
    EXPECT_TRUE(std::includes(found.begin(), found.end(), certain.begin(), certain.end())) << name;
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << name << ": a pair twice";
  }
}

/// Shapes in columns, of several kinds, have the pairs of records: numbers are put together from wherever they lie.
TYPED_TEST(JoinTest, Columns) {
  for (const std::string name : {"uniform", "decades_6"}) {
    const Indexed<TypeParam> a(mixed<TypeParam>(name, 20000, 12)), b(rects<TypeParam>(name, 20000, 13));
    Indexed<TypeParam> in_columns(mixed<TypeParam>(name, 20000, 12));
    std::vector<std::vector<TypeParam>> columns;
    for (auto& set : in_columns.sets.sets) {
      const auto fields = static_cast<std::size_t>(vesica_field_count(set.kind));
      const std::vector<TypeParam>& numbers = in_columns.laid[columns.size() / 6].numbers;
      for (std::size_t k = 0; k < 6; ++k) {
        std::vector<TypeParam>& column = columns.emplace_back();
        for (std::size_t i = k; k < fields && i < numbers.size(); i += fields) column.push_back(numbers[i]);
        if (k < fields) set.field[k] = column.data();
      }
      set.stride = sizeof(TypeParam);
    }
    EXPECT_TRUE(join(VESICA_JOIN_OVERLAP, in_columns, b) == join(VESICA_JOIN_OVERLAP, a, b)) << name;
    EXPECT_TRUE(join(VESICA_JOIN_OVERLAP, b, in_columns) == join(VESICA_JOIN_OVERLAP, b, a)) << name;
    EXPECT_TRUE(join(VESICA_JOIN_OVERLAP, in_columns, in_columns) == join(VESICA_JOIN_OVERLAP, a, a)) << name;
  }
}

/// Overlap of bounds depends neither on the grid of comparison nor on which of two blocks holds few shapes.
TYPED_TEST(JoinTest, BoundsMeetFromBothSides) {
  for (const std::string& name : rect_workloads()) {
    const std::int64_t n = many_of<TypeParam>(name, false);
    const Indexed<TypeParam> a(rects<TypeParam>(name, n, 10)), b(rects<TypeParam>(name, n / 3, 11));
    std::vector<Pair> swapped = join(VESICA_JOIN_BOUNDS, b, a);
    for (Pair& pair : swapped) std::swap(pair.first, pair.second);
    EXPECT_TRUE(sorted(join(VESICA_JOIN_BOUNDS, a, b)) == sorted(std::move(swapped))) << name;
  }
}

TYPED_TEST(JoinTest, NothingAndOneAndTheSame) {
  const Indexed<TypeParam> nothing(Laid<TypeParam>{}), empty(Records<TypeParam>{VESICA_RECT, {}});
  const Indexed<TypeParam> one(Records<TypeParam>{VESICA_CIRCLE, {1, 2, 3}});
  const Indexed<TypeParam> invalid(Records<TypeParam>{VESICA_CIRCLE, {1, 2, -3, NAN, 2, 3}});
  ASSERT_GT(nothing.result, 0);
  ASSERT_EQ(vesica_index_check(nothing.index.get(), nothing.result), 0);
  ASSERT_EQ(invalid.result, VESICA_E_SHAPE);
  for (const auto* a : {&nothing, &empty, &one, &invalid}) {
    for (const auto* b : {&nothing, &empty, &one, &invalid}) {
      const bool pair = a == &one && b == &one;
      EXPECT_EQ(count(VESICA_JOIN_OVERLAP, *a, *b), 0) << pair;
    }
  }
  const Indexed<TypeParam> other(Records<TypeParam>{VESICA_POINT, {4, 2}});
  EXPECT_EQ(join(VESICA_JOIN_OVERLAP, one, other), (std::vector<Pair>{{0, 0}}));

  Records<TypeParam> same{VESICA_RECT, {}};
  for (int i = 0; i < 1100; ++i) same.numbers.insert(same.numbers.end(), {5, 5, TypeParam(0.75), TypeParam(0.5), 1, 2});
  const Indexed<TypeParam> crowd(same);
  EXPECT_EQ(count(VESICA_JOIN_OVERLAP, crowd, crowd), 1100 * 1099 / 2);
  EXPECT_EQ(join(VESICA_JOIN_OVERLAP, crowd, crowd).size(), 1100u * 1099 / 2);
}

/// One item that reaches over the whole grid of others was reported once a lane that holds none.
TYPED_TEST(JoinTest, LanesWithoutAnItemNeverMatch) {
  for (const int n : {1, 31, 32, 33, 700, 1025}) {
    const Indexed<TypeParam> many(rects<TypeParam>("uniform", n, 9));
    const Indexed<TypeParam> over(Records<TypeParam>{VESICA_CIRCLE, {0, 0, TypeParam(1e30)}});
    EXPECT_EQ(join(VESICA_JOIN_OVERLAP, over, many).size(), static_cast<std::size_t>(n));
    EXPECT_EQ(join(VESICA_JOIN_OVERLAP, many, over).size(), static_cast<std::size_t>(n));
  }
}

/// Bounds that overflow are infinite, and meet everything that they must.
TYPED_TEST(JoinTest, BoundsBeyondTheRange) {
  constexpr TypeParam most = std::numeric_limits<TypeParam>::max(),
                      least = std::numeric_limits<TypeParam>::denorm_min();
  const Indexed<TypeParam> a(
      Laid<TypeParam>{{VESICA_CIRCLE, {most, 0, most, 0, 0, most, -most, -most, least}},
                      {VESICA_RECT, {0, 0, most, most, most, most, 0, 0, least, least, least, least}},
                      {VESICA_ELLIPSE, {most, most, most, most, most, 1, least, 0, 1, 0, least, 0}}});
  const Indexed<TypeParam> b(Laid<TypeParam>{{VESICA_POINT, {0, 0, most, most, -most, -most, least, -least, -least, 0}},
                                             {VESICA_SEGMENT, {-most, most, most, -most, least, 0, 0, least}}});
  expect_all_pairs(a, b, "both ends of the range");
  expect_all_pairs(a, a, "both ends of the range, itself");
}

/// A node's missing children have infinite sides: once a box with infinite sides overlapped them.
TYPED_TEST(JoinTest, InfiniteBoundsMeetOnlyWhatIsThere) {
  constexpr TypeParam most = std::numeric_limits<TypeParam>::max();
  const Indexed<TypeParam> everywhere(
      Laid<TypeParam>{{VESICA_CIRCLE, {0, 0, most}}, {VESICA_RECT, {0, 0, most, most, most, most}}});
  for (const int n : {1, 1000, 10000, 70000}) {
    const Indexed<TypeParam> many(rects<TypeParam>("uniform", n, 14));
    expect_all_pairs(everywhere, many, "over " + std::to_string(n));
    expect_all_pairs(many, everywhere, std::to_string(n) + " below");
  }
}

/// Grids whose exponents differ by 0, 1, 14, 15, 60 and 1000: sets of one scale against sets of another.
TEST(JoinFrames, UnlikeExponents) {
  for (const int e : {0, 1, 13, 14, 15, 16, 27, 28, 29, 30, 60, 64, 300, 1000}) {
    Records<double> large = rects<double>("lattice", 900, 1), small = large;
    for (std::size_t i = 0; i < small.numbers.size(); ++i) {
      if (i % 6 != 2 && i % 6 != 3) small.numbers[i] = std::ldexp(small.numbers[i], -e);
    }
    const Indexed<double> a(large), b(small);
    expect_all_pairs(a, b, "2^" + std::to_string(e));
    expect_all_pairs(b, a, "2^-" + std::to_string(e));
  }
}

/// Four blocks of equal weight, shared by as many parts as make products exceed 64 bits.
TEST(JoinParts, MoreThanCanBeMultiplied) {
  constexpr std::int64_t block = 1024, quarter = std::int64_t{1} << 60, parts = 4 * quarter;
  const Indexed<double> a(Records<double>{VESICA_POINT, std::vector<double>(2 * 4 * block)});
  const Indexed<double> b(Records<double>{VESICA_POINT, std::vector<double>(2 * 3)});
  std::vector<Pair> all;
  for (std::int64_t g = 0; g < 4; ++g) {
    const std::vector<Pair> some = join(VESICA_JOIN_OVERLAP, a, b, g * quarter, parts);
    EXPECT_EQ(some.size(), std::size_t{3 * block}) << g;
    all.insert(all.end(), some.begin(), some.end());
    EXPECT_EQ(count(VESICA_JOIN_OVERLAP, a, b, g * quarter + 1, parts), 0) << g;
    EXPECT_EQ(count(VESICA_JOIN_OVERLAP, a, b, (g + 1) * quarter - 1, parts), 0) << g;
  }
  EXPECT_TRUE(all == join(VESICA_JOIN_OVERLAP, a, b));
}

}  // namespace
}  // namespace index_tests
