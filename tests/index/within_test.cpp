// SPDX-License-Identifier: Apache-2.0
/// Joins within a distance hold exactly the pairs that single calls find, in any parts and with any capacity.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "index/all_pairs.hpp"
#include "properties/random.hpp"

namespace index_tests {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::int64_t call(const Indexed<double>& a, const Indexed<double>& b, double distance, std::int64_t part,
                  std::int64_t parts, std::int64_t* out_a, std::int64_t* out_b, std::int64_t capacity,
                  std::int64_t* state) {
  return vesica_join_within_f64(a.index.get(), a.sets.data(), a.sets.count(), b.index.get(), b.sets.data(),
                                b.sets.count(), distance, part, parts, out_a, out_b, capacity, state);
}
std::int64_t call(const Indexed<float>& a, const Indexed<float>& b, double distance, std::int64_t part,
                  std::int64_t parts, std::int64_t* out_a, std::int64_t* out_b, std::int64_t capacity,
                  std::int64_t* state) {
  return vesica_join_within_f32(a.index.get(), a.sets.data(), a.sets.count(), b.index.get(), b.sets.data(),
                                b.sets.count(), static_cast<float>(distance), part, parts, out_a, out_b, capacity,
                                state);
}
bool near(const Item<double>& a, const Item<double>& b, double distance) {
  return vesica_within_f64(a.kind, a.numbers, b.kind, b.numbers, distance) > 0;
}
bool near(const Item<float>& a, const Item<float>& b, double distance) {
  return vesica_within_f32(a.kind, a.numbers, b.kind, b.numbers, static_cast<float>(distance)) > 0;
}

template <class T>
std::vector<Pair> pairs_within(const Indexed<T>& a, const Indexed<T>& b, double distance, std::int64_t parts,
                               std::int64_t capacity) {
  std::vector<std::int64_t> out_a(static_cast<std::size_t>(capacity)), out_b(static_cast<std::size_t>(capacity));
  std::vector<Pair> pairs;
  for (std::int64_t part = 0; part < parts; ++part) {
    std::int64_t state[4] = {0, 0, 0, 0};
    while (state[0] != -1) {
      const std::int64_t n = call(a, b, distance, part, parts, out_a.data(), out_b.data(), capacity, state);
      EXPECT_GE(n, 0);
      EXPECT_TRUE(n == capacity || state[0] == -1);
      if (n < 0) return pairs;
      for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) pairs.emplace_back(out_a[i], out_b[i]);
    }
  }
  return pairs;
}

template <class T>
std::vector<Pair> every_pair(const Indexed<T>& a, const Indexed<T>& b, double distance) {
  std::vector<Pair> pairs;
  const auto of_a = items_of(a.laid), of_b = items_of(b.laid);
  for (const auto& x : of_a) {
    for (const auto& y : of_b) {
      if (&a == &b && x.number >= y.number) continue;
      if (near(x, y, distance)) pairs.emplace_back(x.number, y.number);
    }
  }
  return sorted(std::move(pairs));
}

template <class T>
void expect_all(const Indexed<T>& a, const Indexed<T>& b, double distance, const std::string& what) {
  const std::vector<Pair> expected = every_pair(a, b, distance), found = pairs_within(a, b, distance, 1, 4096);
  EXPECT_EQ(found.size(), expected.size()) << what;
  EXPECT_TRUE(sorted(found) == expected) << what;
  EXPECT_EQ(call(a, b, distance, 0, 1, nullptr, nullptr, 0, nullptr), static_cast<std::int64_t>(expected.size()));
  EXPECT_TRUE(pairs_within(a, b, distance, 3, 7) == found) << what << ", in parts";
}

template <class T>
class JoinWithinTest : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(JoinWithinTest, Scalars);

TYPED_TEST(JoinWithinTest, AllKindsOfEveryWorkload) {
  std::size_t pairs = 0;
  for (const std::string& name : rect_workloads()) {
    const Indexed<TypeParam> a(mixed<TypeParam>(name, 120, 3, 47)), b(mixed<TypeParam>(name, 100, 4, 39));
    for (const double distance : {0.0, 1.0, 1000.0, -0.125, -1.0}) {
      expect_all(a, b, distance, name);
      expect_all(a, a, distance, name + " with itself");
      pairs += every_pair(a, b, distance).size();
    }
    expect_all(a, b, infinity, name + " at any distance");
    EXPECT_EQ(call(a, b, -infinity, 0, 1, nullptr, nullptr, 0, nullptr), 0);
  }
  EXPECT_GT(pairs, 3000U);
}

TYPED_TEST(JoinWithinTest, AnyDistanceFindsEveryItemOnce) {
  const Indexed<TypeParam> few(rects<TypeParam>("uniform", 3, 5)), many(rects<TypeParam>("uniform", 70000, 6));
  EXPECT_EQ(call(few, many, infinity, 0, 1, nullptr, nullptr, 0, nullptr), 3 * 70000);
  EXPECT_EQ(call(many, few, infinity, 0, 1, nullptr, nullptr, 0, nullptr), 3 * 70000);
}

TEST(JoinWithin, DistanceZeroIsOverlap) {
  const Indexed<double> a(rects<double>("near_ties", 3000, 1)), b(rects<double>("near_ties", 2000, 2));
  EXPECT_TRUE(sorted(pairs_within(a, b, 0, 1, 500)) == sorted(join(VESICA_JOIN_OVERLAP, a, b)));
}

/// Ellipses that only rounding makes near: their boxes are farther apart than the distance. Other shapes are not near.
TEST(JoinWithin, NearlyWithin) {
  constexpr double distance = 1e-3, beyond = 1e-9 + distance + 4e-16;
  const Indexed<double> needle(Records<double>{VESICA_ELLIPSE, {0, 0, 0, 1, 1, 1e-9}});
  const Indexed<double> other(Records<double>{VESICA_ELLIPSE, {beyond + 1e-9, 0, 0, 1, 9, 1e-9}});
  const Indexed<double> point(Records<double>{VESICA_POINT, {beyond, 0}});
  const Indexed<double> edge(Records<double>{VESICA_SEGMENT, {beyond, -9, beyond, 9}});
  const auto answer = [&](const Indexed<double>& to) {
    return vesica_within_f64(VESICA_ELLIPSE, needle.laid[0].numbers.data(), to.laid[0].kind, to.laid[0].numbers.data(),
                             distance);
  };
  ASSERT_EQ(answer(other), VESICA_WITHIN_NEARLY);
  for (const Indexed<double>* to : {&other, &point, &edge}) {
    const int expected = to == &other ? 1 : 0;
    ASSERT_EQ(answer(*to) > 0, expected == 1);
    EXPECT_EQ(call(needle, *to, distance, 0, 1, nullptr, nullptr, 0, nullptr), expected);
    EXPECT_EQ(call(*to, needle, distance, 0, 1, nullptr, nullptr, 0, nullptr), expected);
  }
}

/// A shape far out must not widen the windows of all others: this would compare 200 million pairs then.
TEST(JoinWithin, OneItemFarOut) {
  for (const std::int32_t kind : {VESICA_CIRCLE, VESICA_ELLIPSE}) {
    constexpr int n = 20000;
    properties::Random random(7);
    Records<double> shapes{kind, {}};
    for (int i = 0; i < n; ++i) {
      const double x = i == n / 2 ? 1e20 : random.between(0, 1), y = random.between(0, 1);
      shapes.numbers.insert(shapes.numbers.end(), {x, y});
      if (kind == VESICA_ELLIPSE) shapes.numbers.insert(shapes.numbers.end(), {1, 0, 2e-4});
      shapes.numbers.push_back(2e-4);
    }
    const Indexed<double> all(shapes);
    EXPECT_GT(call(all, all, 1e-3, 0, 1, nullptr, nullptr, 0, nullptr), n / 50);
  }
}

TEST(JoinWithin, Arguments) {
  const Indexed<double> a(rects<double>("points", 50, 1));
  const void* const index = a.index.get();
  const vesica_shapes_f64* const sets = a.sets.data();
  std::int64_t out_a[2], out_b[2], state[4] = {0, 0, 0, 0};
  const auto ask = [&](const void* from, std::int32_t count, double distance, std::int64_t part,
                       std::int64_t capacity) {
    return vesica_join_within_f64(from, sets, count, index, sets, 1, distance, part, 2, out_a, out_b, capacity, state);
  };
  EXPECT_EQ(ask(nullptr, 1, 1, 0, 2), VESICA_E_NULL);
  EXPECT_EQ(ask(index, 0, 1, 0, 2), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(index, 1, std::nan(""), 0, 2), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(index, 1, 1, 2, 2), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(index, 1, 1, 0, -1), VESICA_E_ARGUMENT);
  state[0] = 5;
  EXPECT_EQ(ask(index, 1, 1, 0, 2), VESICA_E_ARGUMENT);
  state[3] = 0x3179;
  state[1] = 1000000;
  EXPECT_EQ(ask(index, 1, 1, 0, 2), VESICA_E_ARGUMENT);
  state[0] = -1;
  EXPECT_EQ(ask(index, 1, 1, 0, 2), 0);
}

/// A pair a call: each call goes on behind the last, also where several pairs are of one item and one block, and where
/// one item's are of several blocks.
TEST(JoinWithin, OneByOne) {
  const Indexed<double> few(rects<double>("uniform", 40, 1)), many(rects<double>("uniform", 3000, 2));
  for (const auto& [a, b] : {std::pair{&few, &many}, {&many, &few}, {&few, &few}}) {
    const std::vector<Pair> expected = every_pair(*a, *b, 1);
    ASSERT_GT(expected.size(), 20U);
    std::vector<Pair> found;
    std::int64_t out_a = 7, out_b = 7, state[4] = {0, 0, 0, 0};
    while (state[0] != -1 && found.size() <= expected.size()) {
      const std::int64_t n = call(*a, *b, 1, 0, 1, &out_a, &out_b, 1, state);
      ASSERT_TRUE(n == 1 || (n == 0 && state[0] == -1)) << n;
      if (n == 1) found.emplace_back(out_a, out_b);
    }
    EXPECT_TRUE(sorted(found) == expected);
  }
}

/// A state with any of its numbers out of range is refused, and nothing is written.
TEST(JoinWithin, StatesMadeUp) {
  const Indexed<double> a(rects<double>("uniform", 3000, 1)), b(rects<double>("uniform", 2000, 2));
  std::int64_t out_a[3], out_b[3], state[4] = {0, 0, 0, 0};
  const auto ask = [&](std::int64_t part) { return call(a, b, 1, part, 2, out_a, out_b, 3, state); };
  ASSERT_EQ(ask(0), 3);
  const std::int64_t sound[4] = {state[0], state[1], state[2], state[3]};
  std::fill_n(out_a, 3, 7);
  std::fill_n(out_b, 3, 7);
  constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min(), most = -(least + 1),
                         far = std::int64_t{1} << 40;
  for (const int number : {0, 1, 2, 3}) {
    for (const std::int64_t x : {least, -far, std::int64_t{-2}, std::int64_t{-1}, far, most}) {
      // An end is a state of any call; pairs to skip may be more than there are.
      if ((number == 0 && x == -1) || (number == 2 && x > 0)) continue;
      std::copy_n(sound, 4, state);
      state[number] = x;
      EXPECT_EQ(ask(0), VESICA_E_ARGUMENT) << number << ' ' << x;
      for (int i = 0; i < 4; ++i) EXPECT_EQ(state[i], i == number ? x : sound[i]);
      for (int i = 0; i < 3; ++i) EXPECT_TRUE(out_a[i] == 7 && out_b[i] == 7);
    }
  }
  std::copy_n(sound, 4, state);
  EXPECT_EQ(ask(1), VESICA_E_ARGUMENT) << "the state of another part";
  EXPECT_EQ(ask(0), 3);
}

}  // namespace
}  // namespace index_tests
