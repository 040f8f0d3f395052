// SPDX-License-Identifier: Apache-2.0
// The library against the oracle: every pair of kinds, every workload, both scalars, by kind in both orders and typed.
#include <gtest/gtest.h>

#include <cstdint>

#include "oracle/oracle.hpp"
#include "properties/answers.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"

namespace {

using namespace properties;

constexpr int cases_per_workload = 5000;
constexpr int slow_cases_per_workload = 50;  // where the oracle takes milliseconds
constexpr int answers_per_case = 2;
constexpr int most_printed = 3;
static_assert(36 * 2 * all_workloads.size() * cases_per_workload * answers_per_case >= 1'200'000);

class Differential : public testing::TestWithParam<Kinds> {};

/// Prints one disagreement so that it can be pasted into a test, but few of them.
void report(const Pair& pair, Workload workload, bool truth, const char* function, std::int32_t answer, int& wrong) {
  if (++wrong > most_printed) return;
  ADD_FAILURE() << function << " answers " << answer << ", truth " << truth << " (" << name(workload) << ", seed "
                << seed() << ")\n  " << describe(pair);
}

TEST_P(Differential, AgreesWithOracle) {
  const Kinds& kinds = GetParam();
  const bool is_slow = kinds.a == VESICA_ELLIPSE && kinds.b >= kinds_with_form;
  const int cases = is_slow ? slow_cases_per_workload * repeat() : cases_per_workload * repeat();
  int wrong = 0;
  for (const Workload workload : all_workloads) {
    Stream stream(workload, kinds.a, kinds.b, kinds.scalar, seed());
    for (int i = 0; i < cases; ++i) {
      const Pair pair = stream.next();
      const bool truth = oracle::overlap(pair.kind_a, pair.a.data(), pair.kind_b, pair.b.data());
      const auto expect_truth = [&](const char* function, std::int32_t answer) {
        if (answer != static_cast<std::int32_t>(truth)) report(pair, workload, truth, function, answer, wrong);
      };
      expect_truth("by kind", overlap_by_kind(kinds.scalar, pair));
      expect_truth("by kind, other order,", overlap_by_kind(kinds.scalar, swapped(pair)));
      if (kinds.b >= kinds_with_form) continue;  // no typed functions
      expect_truth("typed", overlap_typed(kinds.scalar, pair));
      if (kinds.a == kinds.b) expect_truth("typed, other order,", overlap_typed(kinds.scalar, swapped(pair)));
    }
  }
  EXPECT_EQ(wrong, 0) << "wrong answers of " << cases * static_cast<int>(all_workloads.size())
                      << " cases; replay with VESICA_SEED=" << seed();
}

INSTANTIATE_TEST_SUITE_P(Pairs, Differential, testing::ValuesIn(all_pairs_of_kinds()), test_name);

}  // namespace
