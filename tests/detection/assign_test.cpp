// SPDX-License-Identifier: Apache-2.0
// Greedy assignment: known answers, against the definition followed literally, and errors.
#include <gtest/gtest.h>
#include <vesica_detection.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "properties/random.hpp"

namespace assign_test {

using Numbers = std::vector<std::int64_t>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Pairs {
  Numbers a, b;
  std::vector<double> values;
  std::int64_t count_a, count_b;

  std::int64_t count() const { return static_cast<std::int64_t>(a.size()); }
};

template <class T, class Function>
Numbers assigned(const Pairs& p, Function function) {
  const std::int64_t bytes = vesica_assign_greedy_scratch(p.count(), p.count_a, p.count_b);
  std::vector<std::uint64_t> scratch(static_cast<std::size_t>(bytes) / 8 + 1, ~std::uint64_t{0});
  const std::int64_t most = std::min({p.count(), p.count_a, p.count_b});
  Numbers chosen(static_cast<std::size_t>(most) + 1, -7);
  const std::vector<T> values(p.values.begin(), p.values.end());
  const std::int64_t n = function(p.a.data(), p.b.data(), values.data(), p.count(), p.count_a, p.count_b,
                                  scratch.data(), bytes, chosen.data());
  EXPECT_GE(n, 0);
  EXPECT_EQ(scratch.back(), ~std::uint64_t{0});
  for (std::size_t i = static_cast<std::size_t>(n); i < chosen.size(); ++i) EXPECT_EQ(chosen[i], -7);
  chosen.resize(static_cast<std::size_t>(n));
  return chosen;
}
inline Numbers assigned(const Pairs& p) { return assigned<double>(p, vesica_assign_greedy_f64); }

/// Looks for the best pair of free items again and again.
inline Numbers by_definition(const Pairs& p) {
  std::vector<bool> used_a(static_cast<std::size_t>(p.count_a)), used_b(static_cast<std::size_t>(p.count_b));
  Numbers chosen;
  for (;;) {
    std::int64_t best = -1;
    for (std::size_t k = 0; k < p.a.size(); ++k) {
      if (std::isnan(p.values[k]) || used_a[static_cast<std::size_t>(p.a[k])] ||
          used_b[static_cast<std::size_t>(p.b[k])])
        continue;
      const auto rank = [&](std::size_t i) { return std::tuple(-p.values[i], p.a[i], p.b[i], i); };
      if (best < 0 || rank(k) < rank(static_cast<std::size_t>(best))) best = static_cast<std::int64_t>(k);
    }
    if (best < 0) return chosen;
    used_a[static_cast<std::size_t>(p.a[static_cast<std::size_t>(best)])] = true;
    used_b[static_cast<std::size_t>(p.b[static_cast<std::size_t>(best)])] = true;
    chosen.push_back(best);
  }
}

TEST(AssignGreedy, TakesTheBestFirst) {
  EXPECT_EQ(assigned({{0, 0, 1}, {0, 1, 0}, {0.5, 0.4, 0.6}, 2, 2}), (Numbers{2, 1}));
  // The sum would be larger with the other two.
  EXPECT_EQ(assigned({{0, 0, 1, 1}, {0, 1, 0, 1}, {0.9, 0.8, 0.8, 0.1}, 2, 2}), (Numbers{0, 3}));
  EXPECT_EQ(assigned({{3}, {70}, {0.0}, 4, 71}), (Numbers{0}));
}

TEST(AssignGreedy, TiesGoByItems) {
  EXPECT_EQ(assigned({{1, 0, 0, 1}, {0, 1, 0, 1}, {2, 2, 2, 2}, 2, 2}), (Numbers{2, 3}));
  EXPECT_EQ(assigned({{0, 0, 0}, {1, 1, 0}, {2, 2, 1}, 1, 2}), (Numbers{0}));
  EXPECT_EQ(assigned({{1, 0}, {1, 1}, {0.0, -0.0}, 2, 2}), (Numbers{1}));
}

TEST(AssignGreedy, AnyValues) {
  EXPECT_EQ(assigned({{0, 1, 2, 3}, {0, 1, 2, 3}, {-infinity, nan, infinity, -1}, 4, 4}), (Numbers{2, 3, 0}));
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(assigned({{0, 0, 0}, {0, 1, 2}, {0, least, -least}, 1, 3}), (Numbers{1}));
  EXPECT_EQ(assigned({{0, 0}, {0, 1}, {nan, nan}, 1, 2}), Numbers{});
}

TEST(AssignGreedy, IsTheDefinition) {
  properties::Random random(properties::seed());
  std::size_t matches = 0;
  for (int round = 0; round < 300; ++round) {
    Pairs p{{}, {}, {}, random.integer(1, 90), random.integer(1, 90)};
    const int count = random.integer(0, 200);
    for (int k = 0; k < count; ++k) {
      p.a.push_back(random.below(static_cast<int>(p.count_a)));
      p.b.push_back(random.below(static_cast<int>(p.count_b)));
      // Numbers that a float has too, many of them equal.
      p.values.push_back(random.chance(0.02)  ? nan
                         : random.chance(0.5) ? random.below(4)
                                              : random.below(1000) / 1024.0);
    }
    const Numbers expected = by_definition(p);
    EXPECT_EQ(assigned(p), expected) << "seed " << properties::seed();
    EXPECT_EQ(assigned<float>(p, vesica_assign_greedy_f32), expected) << "seed " << properties::seed();
    matches += expected.size();
  }
  EXPECT_GT(matches, 3000U);
}

/// Flushed subnormal numbers would be ties; rounding downward makes 0 - 0 negative.
TEST(AssignGreedy, TheCallersEnvironment) {
  const double least = std::numeric_limits<double>::denorm_min();
  const Pairs p{{1, 0, 2}, {0, 0, 0}, {least, 0.0, -0.0}, 3, 1}, zeros{{1, 0}, {0, 0}, {0.0, -0.0}, 2, 1};
  std::fesetround(FE_DOWNWARD);
  const Numbers found = assigned(p), of_zeros = assigned(zeros);
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(found, (Numbers{0}));
  EXPECT_EQ(of_zeros, (Numbers{1}));
}

TEST(AssignGreedy, Errors) {
  const Numbers a{0, 1}, b{1, 0};
  const std::vector<double> values{1, 2};
  const std::int64_t size = vesica_assign_greedy_scratch(2, 2, 2);
  std::vector<std::uint64_t> scratch(static_cast<std::size_t>(size) / 8 + 1);
  Numbers chosen(2, -7);
  const auto ask = [&](const std::int64_t* i, const std::int64_t* j, const double* v, std::int64_t n, std::int64_t of_a,
                       std::int64_t of_b, void* room, std::int64_t bytes, std::int64_t* out) {
    return vesica_assign_greedy_f64(i, j, v, n, of_a, of_b, room, bytes, out);
  };
  const auto room = scratch.data();
  EXPECT_EQ(ask(nullptr, b.data(), values.data(), 2, 2, 2, room, size, chosen.data()), VESICA_E_NULL);
  EXPECT_EQ(ask(a.data(), nullptr, values.data(), 2, 2, 2, room, size, chosen.data()), VESICA_E_NULL);
  EXPECT_EQ(ask(a.data(), b.data(), nullptr, 2, 2, 2, room, size, chosen.data()), VESICA_E_NULL);
  EXPECT_EQ(ask(a.data(), b.data(), values.data(), 2, 2, 2, nullptr, size, chosen.data()), VESICA_E_NULL);
  EXPECT_EQ(ask(a.data(), b.data(), values.data(), 2, 2, 2, room, size, nullptr), VESICA_E_NULL);
  EXPECT_EQ(ask(a.data(), b.data(), values.data(), -1, 2, 2, room, size, chosen.data()), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(a.data(), b.data(), values.data(), 2, 1, 2, room, size, chosen.data()), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(a.data(), b.data(), values.data(), 2, 2, 1, room, size, chosen.data()), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(a.data(), b.data(), values.data(), 2, -1, 2, room, size, chosen.data()), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(a.data(), b.data(), values.data(), 2, 2, 2, room, size - 1, chosen.data()), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(a.data(), b.data(), values.data(), 2, 2, 2, reinterpret_cast<char*>(room) + 4, size, chosen.data()),
            VESICA_E_ARGUMENT);
  const Numbers below{0, -1}, beyond{0, 2};
  EXPECT_EQ(ask(below.data(), b.data(), values.data(), 2, 2, 2, room, size, chosen.data()), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(a.data(), below.data(), values.data(), 2, 2, 2, room, size, chosen.data()), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(a.data(), beyond.data(), values.data(), 2, 2, 2, room, size, chosen.data()), VESICA_E_ARGUMENT);
  EXPECT_EQ(chosen, (Numbers{-7, -7}));
  EXPECT_EQ(ask(nullptr, nullptr, nullptr, 0, 0, 0, nullptr, 0, nullptr), 0);
  for (int k = 0; k < 3; ++k) {
    for (const std::int64_t n : {std::int64_t{-1}, std::int64_t{1} << 31, std::numeric_limits<std::int64_t>::max()}) {
      EXPECT_EQ(vesica_assign_greedy_scratch(k == 0 ? n : 1, k == 1 ? n : 1, k == 2 ? n : 1), VESICA_E_ARGUMENT);
    }
  }
  EXPECT_EQ(vesica_assign_greedy_scratch(0, 0, 0), 0);
  EXPECT_EQ(vesica_assign_greedy_scratch(10, 64, 65), 320 + 8 + 16);
}

}  // namespace assign_test
