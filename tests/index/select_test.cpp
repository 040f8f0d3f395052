// SPDX-License-Identifier: Apache-2.0
/// One shape against an index: the items that the scalar function says, whole and resumed.
#include <gtest/gtest.h>

#include "index/all_pairs.hpp"

namespace index_tests {
namespace {

template <class T>
std::vector<std::int64_t> select(const Indexed<T>& many, const typename Face<T>::Shapes& one, std::int64_t capacity) {
  std::vector<std::int64_t> out(static_cast<std::size_t>(capacity)), all;
  std::int64_t state[4] = {0, 0, 0, 0};
  while (state[0] != -1) {
    const std::int64_t n =
        Face<T>::index_select(many.index.get(), many.sets.data(), many.sets.count(), &one, out.data(), capacity, state);
    EXPECT_GE(n, 0);
    if (n < 0) break;
    all.insert(all.end(), out.begin(), out.begin() + n);
  }
  return all;
}

template <class T>
class SelectTest : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(SelectTest, Scalars);

TYPED_TEST(SelectTest, WhatTheScalarFunctionSays) {
  for (const char* name : {"uniform", "three_scales", "needles", "near_ties"}) {
    const Indexed<TypeParam> many(mixed<TypeParam>(name, 1500, 1, 101));
    const Laid<TypeParam> ones = mixed<TypeParam>(name, 60, 2);
    const std::vector<Pair> pairs = all_pairs<TypeParam>(ones, many.laid, false, overlaps<TypeParam>);
    std::vector<Pair> found;
    std::int64_t number = 0;
    for (const Records<TypeParam>& records : ones) {
      for (std::int64_t i = 0; i < records.count(); ++i, ++number) {
        const std::size_t fields = records.numbers.size() / static_cast<std::size_t>(records.count());
        typename Face<TypeParam>::Shapes one;
        Face<TypeParam>::from_records(records.kind, 1, records.numbers.data() + static_cast<std::size_t>(i) * fields, 0,
                                      &one);
        const std::vector<std::int64_t> all = select<TypeParam>(many, one, 4096);
        EXPECT_EQ(select<TypeParam>(many, one, 1), all) << name;
        EXPECT_EQ(select<TypeParam>(many, one, 7), all) << name;
        EXPECT_EQ(Face<TypeParam>::index_select(many.index.get(), many.sets.data(), many.sets.count(), &one, nullptr, 0,
                                                nullptr),
                  static_cast<std::int64_t>(all.size()));
        EXPECT_GE(Face<TypeParam>::index_select(many.index.get(), nullptr, 0, &one, nullptr, 0, nullptr),
                  static_cast<std::int64_t>(all.size()));
        for (const std::int64_t item : all) found.emplace_back(number, item);
      }
    }
    EXPECT_TRUE(sorted(found) == pairs) << name;
  }
}

}  // namespace
}  // namespace index_tests
