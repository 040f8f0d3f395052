// SPDX-License-Identifier: Apache-2.0
// Pairs by ratio are those of the join, in its order, that the scalar functions say have such a ratio, bit for bit.
#include <gtest/gtest.h>
#include <vesica_detection.h>

#include <cfenv>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "index/all_pairs.hpp"
#include "index/face.hpp"

namespace join_ratio_test {

using namespace index_tests;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

inline std::int64_t call(std::int32_t ratio, double threshold, const Indexed<double>& a, const Indexed<double>& b,
                         std::int64_t part, std::int64_t parts, const Memory& scratch, std::int64_t* out_a,
                         std::int64_t* out_b, double* values, std::int64_t capacity, std::int64_t* state) {
  return vesica_join_ratio_f64(ratio, threshold, a.index.get(), a.sets.data(), a.sets.count(), b.index.get(),
                               b.sets.data(), b.sets.count(), part, parts, scratch.get(), scratch.size, out_a, out_b,
                               values, capacity, state);
}
inline std::int64_t call(std::int32_t ratio, double threshold, const Indexed<float>& a, const Indexed<float>& b,
                         std::int64_t part, std::int64_t parts, const Memory& scratch, std::int64_t* out_a,
                         std::int64_t* out_b, float* values, std::int64_t capacity, std::int64_t* state) {
  return vesica_join_ratio_f32(ratio, static_cast<float>(threshold), a.index.get(), a.sets.data(), a.sets.count(),
                               b.index.get(), b.sets.data(), b.sets.count(), part, parts, scratch.get(), scratch.size,
                               out_a, out_b, values, capacity, state);
}

using Triple = std::tuple<std::int64_t, std::int64_t, double>;

/// The triples of all parts, in order.
template <class T>
std::vector<Triple> triples(std::int32_t ratio, double threshold, const Indexed<T>& a, const Indexed<T>& b,
                            std::int64_t parts = 1, std::int64_t capacity = 4096) {
  const Memory scratch(vesica_join_scratch());
  const auto room = static_cast<std::size_t>(capacity);
  std::vector<std::int64_t> out_a(room + 1, -7), out_b(room + 1, -7);
  std::vector<T> values(room + 1, -7);
  std::vector<Triple> found;
  for (std::int64_t part = 0; part < parts; ++part) {
    std::int64_t state[4] = {0, 0, 0, 0};
    while (state[0] != -1) {
      const std::int64_t n = call(ratio, threshold, a, b, part, parts, scratch, out_a.data(), out_b.data(),
                                  values.data(), capacity, state);
      EXPECT_TRUE(n == capacity || (n >= 0 && state[0] == -1)) << n;
      if (n < 0) return found;
      for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) found.emplace_back(out_a[i], out_b[i], values[i]);
    }
  }
  EXPECT_TRUE(out_a[room] == -7 && out_b[room] == -7 && values[room] == -7);
  return found;
}

/// Filters the join's pairs by the scalar function.
template <class T>
std::vector<Triple> by_definition(std::int32_t ratio, double threshold, const Indexed<T>& a, const Indexed<T>& b) {
  std::vector<const Item<T>*> of_a(static_cast<std::size_t>(a.sets.items)),
      of_b(static_cast<std::size_t>(b.sets.items));
  const std::vector<Item<T>> items_a = items_of(a.laid), items_b = items_of(b.laid);
  for (const Item<T>& item : items_a) of_a[static_cast<std::size_t>(item.number)] = &item;
  for (const Item<T>& item : items_b) of_b[static_cast<std::size_t>(item.number)] = &item;
  std::vector<Triple> expected;
  for (const auto& [i, j] : join(VESICA_JOIN_OVERLAP, a, b)) {
    const Item<T>&x = *of_a[static_cast<std::size_t>(i)], &y = *of_b[static_cast<std::size_t>(j)];
    T value = 0;
    if (Face<T>::ratio(ratio, x.kind, x.numbers, y.kind, y.numbers, &value) != 0) continue;
    if (value >= static_cast<T>(threshold)) expected.emplace_back(i, j, static_cast<double>(value));
  }
  return expected;
}

template <class T>
class JoinRatioTest : public testing::Test {};
using RatioScalars = testing::Types<double, float>;
TYPED_TEST_SUITE(JoinRatioTest, RatioScalars);

TYPED_TEST(JoinRatioTest, EveryRatioOfEveryWorkload) {
  std::size_t pairs = 0, negative = 0, touching = 0;
  for (const std::string& name : rect_workloads()) {
    const std::int64_t n = name == "whole_range" ? 60 : 150;
    const Indexed<TypeParam> a(mixed<TypeParam>(name, n, 3, 47)), b(mixed<TypeParam>(name, n, 4, 39));
    for (std::int32_t ratio = VESICA_RATIO_OVER_UNION; ratio <= VESICA_RATIO_COMPLETE; ++ratio) {
      for (const double threshold : {-infinity, 0.0, 0.25, 1.0}) {
        const std::vector<Triple> expected = by_definition(ratio, threshold, a, b);
        EXPECT_EQ(triples(ratio, threshold, a, b), expected) << name << ' ' << ratio << ' ' << threshold;
        EXPECT_EQ(triples(ratio, threshold, a, a), by_definition(ratio, threshold, a, a)) << name << ", itself";
        pairs += expected.size();
        for (const auto& [i, j, value] : expected) negative += value < 0, touching += value == 0;
      }
    }
  }
  EXPECT_GT(pairs, 10000U);
  EXPECT_GT(negative, 100U);
  EXPECT_GT(touching, 100U);
}

/// Thresholds that a ratio has exactly, and the next number: bounds and areas rule out no pair that has it.
TYPED_TEST(JoinRatioTest, ThresholdsThatRatiosHave) {
  std::size_t pairs = 0;
  for (const std::string& name : rect_workloads()) {
    const Indexed<TypeParam> a(mixed<TypeParam>(name, name == "whole_range" ? 60 : 150, 7)),
        b(mixed<TypeParam>(name, name == "whole_range" ? 60 : 150, 8));
    for (std::int32_t ratio = VESICA_RATIO_OVER_UNION; ratio <= VESICA_RATIO_COMPLETE; ++ratio) {
      const std::vector<Triple> all = by_definition(ratio, 0, a, b);
      for (std::size_t k = 0; k < all.size(); k += 1 + all.size() / 8) {
        const auto value = static_cast<TypeParam>(std::get<2>(all[k]));
        for (const TypeParam threshold : {value, std::nextafter(value, TypeParam{2})}) {
          std::vector<Triple> expected;
          for (const Triple& triple : all) {
            if (std::get<2>(triple) >= static_cast<double>(threshold)) expected.push_back(triple);
          }
          EXPECT_EQ(triples(ratio, static_cast<double>(threshold), a, b), expected) << name << ' ' << ratio;
          pairs += expected.size();
        }
      }
    }
  }
  EXPECT_GT(pairs, 10000U);
}

TYPED_TEST(JoinRatioTest, PartsAndRoomChangeNothing) {
  const Indexed<TypeParam> a(mixed<TypeParam>("decades_3", 600, 5)), b(rects<TypeParam>("decades_3", 400, 6));
  const Memory scratch(vesica_join_scratch());
  for (const double threshold : {0.0, 0.4}) {
    const std::vector<Triple> expected = by_definition(VESICA_RATIO_OVER_SMALLER, threshold, a, b);
    EXPECT_GT(expected.size(), 100U);
    for (const auto& [parts, capacity] : {std::pair{1, 1}, {1, 7}, {3, 100}, {5, 1 << 16}}) {
      EXPECT_EQ(triples(VESICA_RATIO_OVER_SMALLER, threshold, a, b, parts, capacity), expected) << parts;
    }
    EXPECT_EQ(call(VESICA_RATIO_OVER_SMALLER, threshold, a, b, 0, 1, scratch, nullptr, nullptr, nullptr, 0, nullptr),
              static_cast<std::int64_t>(expected.size()));
  }
}

inline Indexed<double> boxes(std::vector<double> numbers) {
  return Indexed<double>(Records<double>{VESICA_AABB, numbers});
}

/// The ratio of the first two is 1/2 exactly; the third touches, the fourth has no area, the fifth is far away.
TEST(JoinRatio, TheThresholdItselfIsEnough) {
  const auto a = boxes({0, 0, 2, 2}), b = boxes({0, 0, 2, 1, 2, 0, 3, 1, 1, 0, 1, 1, 9, 9, 10, 10});
  EXPECT_EQ(triples(VESICA_RATIO_OVER_UNION, 0.5, a, b), (std::vector<Triple>{{0, 0, 0.5}}));
  EXPECT_EQ(triples(VESICA_RATIO_OVER_UNION, std::nextafter(0.5, 1), a, b), std::vector<Triple>{});
  EXPECT_EQ(triples(VESICA_RATIO_OVER_UNION, 0, a, b).size(), 3U);
  EXPECT_EQ(triples(VESICA_RATIO_OVER_UNION, std::numeric_limits<double>::denorm_min(), a, b).size(), 1U);
  EXPECT_EQ(triples(VESICA_RATIO_OVER_UNION, infinity, a, b).size(), 0U);
  // Boxes without area have no IoU, though they overlap.
  const auto flat = boxes({0, 0, 0, 1, 0, 0, 0, 1});
  EXPECT_EQ(triples(VESICA_RATIO_OVER_UNION, -infinity, flat, flat).size(), 0U);
  EXPECT_EQ(join(VESICA_JOIN_OVERLAP, flat, flat).size(), 1U);
}

/// Ratios do not change where boxes are moved or scaled, while their numbers stay exact.
TEST(JoinRatio, FarAwayAndAnySize) {
  for (const double scale : {0x1p-1060, 1.0, 0x1p1000}) {
    const double s = scale;
    EXPECT_EQ(triples(VESICA_RATIO_OVER_UNION, 0.25, boxes({0, 0, 2 * s, 2 * s}), boxes({0, s, 2 * s, 3 * s})),
              (std::vector<Triple>{{0, 0, 1.0 / 3}}));
  }
  const double far = 1e15;
  EXPECT_EQ(triples(VESICA_RATIO_OVER_UNION, 0.25, boxes({far, 0, far + 2, 2}), boxes({far, 1, far + 2, 3})),
            (std::vector<Triple>{{0, 0, 1.0 / 3}}));
  EXPECT_EQ(triples(VESICA_RATIO_OVER_UNION, 0.25, boxes({0, 0, 1e12, 1}), boxes({0, 0.5, 1e12, 1.5})),
            (std::vector<Triple>{{0, 0, 1.0 / 3}}));
}

TEST(JoinRatio, Errors) {
  const auto a = boxes({0, 0, 2, 2, 1, 1, 3, 3}), other = boxes({0, 0, 1, 1});
  const Memory scratch(vesica_join_scratch());
  std::int64_t i[4], j[4], state[4] = {0, 0, 0, 0};
  double v[4];
  const auto ask = [&](std::int32_t ratio, double threshold, std::int64_t part = 0, std::int64_t parts = 1,
                       std::int64_t capacity = 4) {
    return call(ratio, threshold, a, a, part, parts, scratch, i, j, v, capacity, state);
  };
  EXPECT_EQ(ask(-1, 0), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(7, 0), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(0, nan), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(0, 0, 1, 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(0, 0, 0, 0), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(0, 0, -1, 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(0, 0, 0, 1, -1), VESICA_E_ARGUMENT);
  const auto with = [&](const void* index_a, const vesica_shapes_f64* sets_a, std::int32_t count_a, void* room,
                        std::int64_t size, std::int64_t* out_a, double* values, std::int64_t* where) {
    return vesica_join_ratio_f64(0, 0, index_a, sets_a, count_a, a.index.get(), a.sets.data(), 1, 0, 1, room, size,
                                 out_a, j, values, 4, where);
  };
  EXPECT_EQ(with(nullptr, a.sets.data(), 1, scratch.get(), scratch.size, i, v, state), VESICA_E_NULL);
  EXPECT_EQ(with(a.index.get(), nullptr, 1, scratch.get(), scratch.size, i, v, state), VESICA_E_NULL);
  EXPECT_EQ(with(a.index.get(), a.sets.data(), 1, nullptr, scratch.size, i, v, state), VESICA_E_NULL);
  EXPECT_EQ(with(a.index.get(), a.sets.data(), 1, scratch.get(), scratch.size, nullptr, v, state), VESICA_E_NULL);
  EXPECT_EQ(with(a.index.get(), a.sets.data(), 1, scratch.get(), scratch.size, i, nullptr, state), VESICA_E_NULL);
  EXPECT_EQ(with(a.index.get(), a.sets.data(), 1, scratch.get(), scratch.size, i, v, nullptr), VESICA_E_NULL);
  EXPECT_EQ(with(scratch.get(), a.sets.data(), 1, scratch.get(), scratch.size, i, v, state), VESICA_E_INDEX);
  EXPECT_EQ(with(a.index.get(), other.sets.data(), 1, scratch.get(), scratch.size, i, v, state), VESICA_E_ARGUMENT);
  EXPECT_EQ(with(a.index.get(), a.sets.data(), 0, scratch.get(), scratch.size, i, v, state), VESICA_E_ARGUMENT);
  EXPECT_EQ(with(a.index.get(), a.sets.data(), 1, scratch.get(), scratch.size - 1, i, v, state), VESICA_E_ARGUMENT);
  EXPECT_EQ(with(a.index.get(), a.sets.data(), 1, static_cast<char*>(scratch.get()) + 8, scratch.size, i, v, state),
            VESICA_E_ARGUMENT);
  vesica_shapes_f64 wrong = *a.sets.data();
  wrong.kind = 99;
  EXPECT_EQ(with(a.index.get(), &wrong, 1, scratch.get(), scratch.size, i, v, state), VESICA_E_KIND);
  EXPECT_EQ(std::vector<std::int64_t>(state, state + 4), (std::vector<std::int64_t>{0, 0, 0, 0}));
  // The state of a join, or of another ratio.
  const Indexed<double> many(rects<double>("uniform", 3000, 1));
  EXPECT_EQ(call(0, 0, many, many, 0, 1, scratch, i, j, v, 4, state), 4);
  EXPECT_EQ(call(1, 0, many, many, 0, 1, scratch, i, j, v, 4, state), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_join_f64(0, many.index.get(), many.sets.data(), 1, many.index.get(), many.sets.data(), 1, 0, 1,
                            scratch.get(), scratch.size, i, j, 4, state),
            VESICA_E_ARGUMENT);
  EXPECT_EQ(call(0, 0, many, many, 0, 1, scratch, i, j, v, 4, state), 4);
}

TEST(JoinRatio, NothingToJoin) {
  const Indexed<double> nothing(Laid<double>{});
  const auto a = boxes({0, 0, 2, 2});
  EXPECT_TRUE(triples(0, 0, nothing, a).empty());
  EXPECT_TRUE(triples(0, 0, a, nothing).empty());
  EXPECT_TRUE(triples(0, 0, a, a).empty());
}

TEST(JoinRatio, TheCallersRounding) {
  const Indexed<double> a(mixed<double>("uniform", 300, 1)), b(mixed<double>("uniform", 300, 2));
  const std::vector<Triple> expected = triples(VESICA_RATIO_OVER_UNION, 0, a, b);
  for (const int rounding : {FE_UPWARD, FE_TOWARDZERO}) {
    std::fesetround(rounding);
    const std::vector<Triple> found = triples(VESICA_RATIO_OVER_UNION, 0, a, b);
    EXPECT_EQ(std::fegetround(), rounding);
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(found, expected);
  }
}

}  // namespace join_ratio_test
