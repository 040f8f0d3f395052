// SPDX-License-Identifier: Apache-2.0
// The answers that the near-tie hash is made of, held against the oracle: the literal stands for the truth, not for
// what the library said on one day.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "batch/near_tie_hash/contact.hpp"
#include "oracle/oracle.hpp"

namespace {

constexpr int fewest_pairs = 4000;

template <class T>
void expect_truth(int kind_a, int kind_b) {
  int wrong = 0, overlaps = 0, pairs = 0;
  for (const near_tie::Pair<T>& pair : near_tie::contacts<T>(kind_a, kind_b)) {
    std::array<double, 6> a{}, b{};
    std::copy(pair.a.begin(), pair.a.end(), a.begin());
    std::copy(pair.b.begin(), pair.b.end(), b.begin());
    const bool truth = oracle::overlap(kind_a, a.data(), kind_b, b.data());
    wrong += near_tie::overlap(pair) != static_cast<std::int32_t>(truth);
    overlaps += truth;
    ++pairs;
  }
  EXPECT_EQ(wrong, 0) << "kinds " << kind_a << " and " << kind_b << ", " << sizeof(T) << " bytes";
  EXPECT_GE(pairs, fewest_pairs);
  EXPECT_GT(overlaps, 0);
  EXPECT_LT(overlaps, pairs);
}

TEST(NearTies, AreAnsweredAsTheOracleDoes) {
  for (int a = 0; a < 6; ++a) {
    for (int b = a; b < 6; ++b) {
      expect_truth<float>(a, b);
      expect_truth<double>(a, b);
    }
  }
}

}  // namespace
