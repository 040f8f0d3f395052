// SPDX-License-Identifier: Apache-2.0
/// Arguments that the functions refuse, and that they then write nothing.
#include <gtest/gtest.h>

#include <limits>

#include "index/face.hpp"

namespace index_tests {
namespace {

template <class T>
class ArgumentsTest : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(ArgumentsTest, Scalars);

TEST(Arguments, Sizes) {
  EXPECT_EQ(vesica_index_size(0), 65536);
  EXPECT_EQ(vesica_index_size(1000000), 17065536);
  EXPECT_EQ(vesica_index_size(-1), VESICA_E_ARGUMENT);
  EXPECT_GT(vesica_index_size(INT32_MAX), 0);
  EXPECT_EQ(vesica_index_size(std::int64_t{1} << 31), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_index_scratch(-1), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_index_scratch(std::int64_t{1} << 31), VESICA_E_ARGUMENT);
  EXPECT_LE(vesica_index_scratch(100000000), 1800000000);
  EXPECT_GT(vesica_join_scratch(), 0);
  EXPECT_LE(vesica_join_scratch(), 1 << 20);
}

TYPED_TEST(ArgumentsTest, Build) {
  const Laid<TypeParam> laid{rects<TypeParam>("uniform", 100, 1)};
  Sets<TypeParam> sets(laid);
  const Memory index(vesica_index_size(100)), scratch(vesica_index_scratch(100));
  const std::vector<unsigned char> before(static_cast<const unsigned char*>(index.get()),
                                          static_cast<const unsigned char*>(index.get()) + index.size);
  const auto build = [&](const auto* s, std::int32_t n, void* to, std::int64_t size, void* with,
                         std::int64_t with_size) {
    return Face<TypeParam>::index_build(s, n, to, size, with, with_size);
  };
  char* const odd_index = static_cast<char*>(index.get()) + 8;
  char* const odd_scratch = static_cast<char*>(scratch.get()) + 8;
  EXPECT_EQ(build(sets.data(), 1, nullptr, index.size, scratch.get(), scratch.size), VESICA_E_NULL);
  EXPECT_EQ(build(sets.data(), 1, index.get(), index.size, nullptr, scratch.size), VESICA_E_NULL);
  EXPECT_EQ(build(static_cast<decltype(sets.data())>(nullptr), 1, index.get(), index.size, scratch.get(), scratch.size),
            VESICA_E_NULL);
  EXPECT_EQ(build(sets.data(), -1, index.get(), index.size, scratch.get(), scratch.size), VESICA_E_ARGUMENT);
  EXPECT_EQ(build(sets.data(), 1, index.get(), index.size - 1, scratch.get(), scratch.size), VESICA_E_ARGUMENT);
  EXPECT_EQ(build(sets.data(), 1, index.get(), index.size, scratch.get(), scratch.size - 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(build(sets.data(), 1, odd_index, index.size, scratch.get(), scratch.size), VESICA_E_ARGUMENT);
  EXPECT_EQ(build(sets.data(), 1, index.get(), index.size, odd_scratch, scratch.size), VESICA_E_ARGUMENT);
  auto wrong = sets.sets[0];
  wrong.kind = VESICA_POLYLINE + 1;
  EXPECT_EQ(build(&wrong, 1, index.get(), index.size, scratch.get(), scratch.size), VESICA_E_KIND);
  wrong = sets.sets[0];
  wrong.count = std::int64_t{1} << 31;
  wrong.stride = 0;
  EXPECT_EQ(build(&wrong, 1, index.get(), INT64_MAX, scratch.get(), INT64_MAX), VESICA_E_ARGUMENT);
  wrong = sets.sets[0];
  wrong.field[5] = nullptr;
  EXPECT_EQ(build(&wrong, 1, index.get(), index.size, scratch.get(), scratch.size), VESICA_E_NULL);
  const std::vector<typename Face<TypeParam>::Shapes> many(65, sets.sets[0]);
  EXPECT_EQ(build(many.data(), 65, index.get(), INT64_MAX, scratch.get(), INT64_MAX), VESICA_E_ARGUMENT);
  EXPECT_EQ(std::memcmp(index.get(), before.data(), before.size()), 0) << "nothing was written";

  const auto step = [&](std::int32_t number, std::int64_t part, std::int64_t parts) {
    return Face<TypeParam>::index_step(number, part, parts, sets.data(), 1, index.get(), index.size, scratch.get(),
                                       scratch.size);
  };
  EXPECT_EQ(step(1, 0, 1), VESICA_E_ARGUMENT) << "step 0 was not done";
  EXPECT_EQ(step(-1, 0, 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(step(5, 0, 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(step(0, 0, 2), VESICA_E_ARGUMENT);
  EXPECT_EQ(step(0, 0, 1), 0);
  EXPECT_EQ(step(1, 2, 2), VESICA_E_ARGUMENT);
  EXPECT_EQ(step(1, -1, 2), VESICA_E_ARGUMENT);
  EXPECT_EQ(step(1, 0, 0), VESICA_E_ARGUMENT);
  EXPECT_EQ(step(4, 0, 2), VESICA_E_ARGUMENT);
  auto fewer = sets.sets[0];
  --fewer.count;
  EXPECT_EQ(Face<TypeParam>::index_step(1, 0, 1, &fewer, 1, index.get(), index.size, scratch.get(), scratch.size),
            VESICA_E_ARGUMENT)
      << "step 0 was of more shapes";
  for (std::int32_t number = 1; number < 4; ++number) EXPECT_EQ(step(number, 0, 1), 0);
  EXPECT_GT(step(4, 0, 1), 0);
  for (std::int32_t number = 1; number <= 4; ++number) EXPECT_EQ(step(number, 0, 1), VESICA_E_ARGUMENT) << "it ended";
}

/// Steps in another order than theirs, and a part that is missing or comes twice, are refused, and harm nothing: the
/// build goes on as if they had not been asked for. Scratch and index hold numbers of no sense before.
TYPED_TEST(ArgumentsTest, StepsOutOfOrder) {
  const Laid<TypeParam> laid = mixed<TypeParam>("decades_3", 20000, 1);
  const Sets<TypeParam> sets(laid);
  const Indexed<TypeParam> whole{Laid<TypeParam>(laid)};
  const Memory index(vesica_index_size(sets.items)), scratch(vesica_index_scratch(sets.items));
  std::memset(index.get(), 0xa5, static_cast<std::size_t>(index.size));
  std::memset(scratch.get(), 0xa5, static_cast<std::size_t>(scratch.size));
  const auto step = [&](std::int32_t number, std::int64_t part, std::int64_t parts) {
    return Face<TypeParam>::index_step(number, part, parts, sets.data(), sets.count(), index.get(), index.size,
                                       scratch.get(), scratch.size);
  };
  const auto refused = [&](std::int32_t number, std::int64_t part, std::int64_t parts) {
    EXPECT_EQ(step(number, part, parts), VESICA_E_ARGUMENT) << number << ": " << part << " of " << parts;
  };
  const auto only_next_is = [&](std::int32_t next) {
    for (std::int32_t number = 1; number <= 4; ++number) {
      if (number != next) refused(number, 0, 1);
    }
  };
  ASSERT_EQ(step(0, 0, 1), 0);
  for (std::int32_t number = 1; number <= 3; ++number) {
    only_next_is(number);
    ASSERT_EQ(step(number, 0, 3), 0);
    only_next_is(number);
    refused(number, 0, 3);
    refused(number, 0, 2);
    ASSERT_EQ(step(number, 2, 3), 0);
    only_next_is(number);
    ASSERT_EQ(step(number, 1, 3), 0);
    ASSERT_EQ(step(number, 999, 1000), 0) << "a part without a share";
  }
  only_next_is(4);
  ASSERT_EQ(step(4, 0, 1), whole.result);
  EXPECT_EQ(std::memcmp(index.get(), whole.index.get(), static_cast<std::size_t>(whole.result)), 0);
}

/// An index holds 64 sets that are not empty, however few shapes they have; of empty ones there may be any number.
TYPED_TEST(ArgumentsTest, SetsOfOneShape) {
  const Laid<TypeParam> laid{rects<TypeParam>("uniform", 1, 1)};
  const Sets<TypeParam> one(laid);
  auto none = one.sets[0];
  none.count = 0;
  std::vector<typename Face<TypeParam>::Shapes> sets(64, one.sets[0]);
  const Memory index(vesica_index_size(65)), scratch(vesica_index_scratch(65));
  const auto build = [&] {
    return Face<TypeParam>::index_build(sets.data(), static_cast<std::int32_t>(sets.size()), index.get(), index.size,
                                        scratch.get(), scratch.size);
  };
  EXPECT_GT(build(), 0);
  EXPECT_EQ(vesica_index_count(index.get()), 64);
  sets.insert(sets.begin(), none);
  sets.push_back(none);
  EXPECT_GT(build(), 0);
  EXPECT_EQ(vesica_index_count(index.get()), 64);
  sets.push_back(one.sets[0]);
  EXPECT_EQ(build(), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_index_count(index.get()), 64) << "nothing was written";
}

TYPED_TEST(ArgumentsTest, Join) {
  const Indexed<TypeParam> a(rects<TypeParam>("uniform", 1000, 1)), b(rects<TypeParam>("uniform", 900, 2));
  const Memory scratch(vesica_join_scratch());
  std::int64_t out[2][4] = {{7, 7, 7, 7}, {7, 7, 7, 7}}, state[4] = {0, 0, 0, 0};
  const auto call = [&](std::int32_t query, const Indexed<TypeParam>& sets_of_b, std::int64_t part, std::int64_t parts,
                        std::int64_t scratch_size, std::int64_t capacity, std::int64_t* at) {
    return Face<TypeParam>::join(query, a.index.get(), a.sets.data(), 1, b.index.get(), sets_of_b.sets.data(), 1, part,
                                 parts, scratch.get(), scratch_size, out[0], out[1], capacity, at);
  };
  EXPECT_EQ(call(-1, b, 0, 1, scratch.size, 4, state), VESICA_E_ARGUMENT);
  EXPECT_EQ(call(VESICA_JOIN_INTERIORS + 1, b, 0, 1, scratch.size, 4, state), VESICA_E_ARGUMENT);
  EXPECT_EQ(call(0, a, 0, 1, scratch.size, 4, state), VESICA_E_ARGUMENT) << "another index's sets";
  EXPECT_EQ(call(0, b, 1, 1, scratch.size, 4, state), VESICA_E_ARGUMENT);
  EXPECT_EQ(call(0, b, 0, 0, scratch.size, 4, state), VESICA_E_ARGUMENT);
  EXPECT_EQ(call(0, b, 0, 1, scratch.size - 1, 4, state), VESICA_E_ARGUMENT);
  EXPECT_EQ(call(0, b, 0, 1, scratch.size, -1, state), VESICA_E_ARGUMENT);
  EXPECT_EQ(call(0, b, 0, 1, scratch.size, 4, nullptr), VESICA_E_NULL);
  for (const std::int64_t x : {-2, 1, 1000000}) {
    std::int64_t wrong[4] = {x, 0, 0, 0};
    EXPECT_EQ(call(0, b, 0, 1, scratch.size, 4, wrong), VESICA_E_ARGUMENT) << "no such state";
    EXPECT_EQ(wrong[0], x);
  }
  EXPECT_EQ(out[0][0], 7);
  EXPECT_EQ(state[0], 0) << "nothing was written";
  ASSERT_EQ(call(0, b, 0, 1, scratch.size, 4, state), 4);
  EXPECT_EQ(call(0, b, 0, 2, scratch.size, 4, state), VESICA_E_ARGUMENT) << "the state of another join";
  EXPECT_EQ(call(2, b, 0, 1, scratch.size, 4, state), VESICA_E_ARGUMENT) << "the state of another query";

  const std::int64_t sound[4] = {state[0], state[1], state[2], state[3]};
  state[2] = -1;
  EXPECT_EQ(call(0, b, 0, 1, scratch.size, 4, state), VESICA_E_ARGUMENT) << "fewer than no candidates";
  state[2] = sound[2];
  constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min(), far = std::int64_t{1} << 40;
  for (const int number : {0, 1, 3}) {
    for (const std::int64_t x : {least, -far, std::int64_t{-2}, far, std::numeric_limits<std::int64_t>::max()}) {
      state[number] = x;
      EXPECT_EQ(call(0, b, 0, 1, scratch.size, 4, state), VESICA_E_ARGUMENT) << number << ' ' << x;
    }
    state[number] = sound[number];
  }
  EXPECT_EQ(call(0, b, 0, 1, scratch.size, 4, state), 4);

  char foreign[512] = {};
  alignas(64) char zeros[512] = {};
  std::memcpy(zeros, foreign, sizeof zeros);
  EXPECT_EQ(vesica_index_count(zeros), VESICA_E_INDEX);
  EXPECT_EQ(vesica_index_count(zeros + 8), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_index_order(zeros + 8, nullptr, 1), VESICA_E_NULL);
  EXPECT_EQ(vesica_index_order(zeros, nullptr, 1), VESICA_E_NULL);
  EXPECT_EQ(vesica_index_order(zeros, nullptr, -1), VESICA_E_INDEX);
  EXPECT_EQ(vesica_index_count(nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_index_count(a.index.get()), 1000);
  vesica_aabb_f64 box;
  EXPECT_EQ(vesica_index_bounds(a.index.get(), nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_index_bounds(a.index.get(), &box), 0);
  EXPECT_EQ(vesica_index_order(a.index.get(), nullptr, 0), 1000);
  EXPECT_EQ(vesica_index_order(a.index.get(), nullptr, 1), VESICA_E_NULL);
  EXPECT_STREQ(vesica_strerror(VESICA_E_INDEX), "the bytes are not an index of this version, or are damaged");
}

/// As many as there can be numbers for, of a part without a shape: nothing is written.
TYPED_TEST(ArgumentsTest, TheMostNeighboursOfAJoin) {
  using T = TypeParam;
  const Indexed<T> many(rects<T>("uniform", 10, 1));
  for (const std::int64_t n : {1, 2, 6}) {
    const Indexed<T> asked(rects<T>("uniform", n, 2));
    std::int64_t item = 7;
    T distance = 7;
    const auto call = [&](std::int64_t k) {
      return Face<T>::join_nearest(asked.sets.data(), 1, many.index.get(), many.sets.data(), 1, k, T(1), 9, 10, &item,
                                   &distance);
    };
    const std::int64_t most = INT64_MAX / 8 / (n + 1);
    EXPECT_EQ(call(most), 0);
    EXPECT_EQ(call(most + 1), VESICA_E_ARGUMENT);
    EXPECT_TRUE(item == 7 && distance == 7);
  }
}

}  // namespace
}  // namespace index_tests
