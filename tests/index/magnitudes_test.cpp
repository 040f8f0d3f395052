// SPDX-License-Identifier: Apache-2.0
/// Shapes near either end of the numbers, and far larger and less than others: pairs and nearest ones are those of the
/// same shapes about 1, and those of the scalar functions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "index/all_pairs.hpp"
#include "index/face.hpp"

namespace index_tests {
namespace {

/// Discs of integers up to 200, times 2^exponent: exactly, subnormal numbers too.
Records<double> discs(std::int64_t n, int exponent) {
  Records<double> out{VESICA_CIRCLE, {}};
  std::uint64_t state = 1;
  const auto integer = [&state](std::uint64_t below) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>((state >> 33) % below);
  };
  for (std::int64_t i = 0; i < n; ++i) {
    const double x = integer(401) - 200, y = integer(401) - 200, r = integer(9);
    for (const double number : {x, y, r}) out.numbers.push_back(std::ldexp(number, exponent));
  }
  return out;
}

/// The nearest ten of a disc, by their distances and numbers.
using Distances = std::vector<std::pair<double, std::int64_t>>;
Distances nearest_ten(const Indexed<double>& many, const double* disc) {
  vesica_shapes_f64 one;
  Face<double>::from_records(VESICA_CIRCLE, 1, disc, 0, &one);
  std::int64_t out[10];
  double distance[10];
  EXPECT_EQ(Face<double>::index_nearest(many.index.get(), many.sets.data(), many.sets.count(), &one, 10,
                                        std::numeric_limits<double>::infinity(), out, distance),
            10);
  Distances found;
  for (int i = 0; i < 10; ++i) found.emplace_back(distance[i], out[i]);
  return found;
}
Distances nearest_ten_of_all(const Records<double>& many, const double* disc) {
  Distances all;
  for (std::int64_t i = 0; i < many.count(); ++i) {
    vesica_closest_points_f64 points;
    const double* other = &many.numbers[static_cast<std::size_t>(3 * i)];
    EXPECT_EQ(vesica_nearest_f64(VESICA_CIRCLE, disc, VESICA_CIRCLE, other, &points), 0);
    all.emplace_back(points.distance, i);
  }
  std::sort(all.begin(), all.end());
  all.resize(10);
  return all;
}

TEST(Magnitudes, TimesAPowerOfTwo) {
  const Indexed<double> usual(discs(1500, 0));
  const std::vector<Pair> pairs = sorted(join(VESICA_JOIN_OVERLAP, usual, usual));
  ASSERT_GT(pairs.size(), 1000u);
  for (const int exponent : {-1074, -1060, -1015, -980, -900, 900, 980, 1014}) {
    const Indexed<double> other(discs(1500, exponent));
    ASSERT_EQ(vesica_index_check(other.index.get(), other.result), 0) << exponent;
    EXPECT_TRUE(sorted(join(VESICA_JOIN_OVERLAP, other, other)) == pairs) << exponent;
    for (std::size_t i = 0; i < 20; ++i) {
      const double* disc = &other.laid[0].numbers[3 * i];
      ASSERT_EQ(nearest_ten(other, disc), nearest_ten_of_all(other.laid[0], disc)) << exponent << ", number " << i;
    }
  }
}

TEST(Magnitudes, FarLargerAndLess) {
  for (const int exponent_a : {-1074, -900, 0}) {
    for (const int exponent_b : {-1000, 8, 1014}) {
      const Indexed<double> a(discs(300, exponent_a)), b(discs(700, exponent_b));
      std::vector<Pair> pairs;
      for (std::int64_t i = 0; i < 300; ++i) {
        for (std::int64_t k = 0; k < 700; ++k) {
          const double *p = &a.laid[0].numbers[static_cast<std::size_t>(3 * i)],
                       *q = &b.laid[0].numbers[static_cast<std::size_t>(3 * k)];
          if (vesica_overlap_f64(VESICA_CIRCLE, p, VESICA_CIRCLE, q) == 1) pairs.emplace_back(i, k);
        }
      }
      EXPECT_TRUE(sorted(join(VESICA_JOIN_OVERLAP, a, b)) == pairs) << exponent_a << ", " << exponent_b;
    }
  }
}

/// More equal shapes than a cell is to hold, alone and with others.
TEST(Magnitudes, EqualShapes) {
  for (const std::int64_t others : {0, 100, 6000}) {
    Records<double> records = discs(others, 0);
    for (int i = 0; i < 5000; ++i) records.numbers.insert(records.numbers.end(), {500.25, 500.25, 1});
    const Indexed<double> all(records), rest(discs(others, 0));
    EXPECT_EQ(vesica_index_check(all.index.get(), all.result), 0);
    EXPECT_EQ(count(VESICA_JOIN_OVERLAP, all, all),
              std::int64_t{5000} * 4999 / 2 + count(VESICA_JOIN_OVERLAP, rest, rest));
  }
}

}  // namespace
}  // namespace index_tests
