// SPDX-License-Identifier: Apache-2.0
/// Measuring a row of the table.
#pragma once

#include <cstdint>
#include <optional>

#include "batch/contest.hpp"
#include "batch/spec.hpp"

namespace vesica::bench {

/// The yardstick of a row: as a rule the unfiltered kernel of the same instruction set.
struct Comparison {
  double nanoseconds;          ///< a test
  double ratio;                ///< its time to ours, the median over rounds: 1 is as fast, below 1 we are slower
  double quartile, quartile3;  ///< of the ratio
  std::int64_t unlike = 0, asked = 0;  ///< answers that differ from ours
};

struct Result {
  double nanoseconds = 0;     ///< a test, the median over rounds
  double tests_a_second = 0;  ///< of all threads
  double hits = 0;            ///< share of the tests that overlap
  std::optional<Comparison> reference;
  double bandwidth = 0;        ///< bytes a second that a sum over the same memory reads, 0 where not measured
  double bandwidth_share = 0;  ///< the input bytes we read a second, beside that
};

Result run(const Spec& spec);

/// Nanoseconds a test from passes of as many tests.
Result summary(const Times& ours, double tests_a_pass);
Comparison compare(const Times& ours, const Times& reference, double our_tests, double reference_tests);

template <class T>
Result run_in_cache(const Spec& spec);
template <class T>
Result run_in_memory(const Spec& spec);
template <class T>
Result run_matrix_1e5(const Spec& spec);
template <class T>
Result run_large_matrix(const Spec& spec);
template <class T>
Result run_near(const Spec& spec);
Result run_two_threads(const Spec& spec);

/// Tests a pass in cache: 16 KiB a column. All columns together stay in the second-level cache, as a caller's own
/// would, and a pass is long enough for the clock.
template <class T>
inline constexpr std::size_t batch_length = 16384 / sizeof(T);

}  // namespace vesica::bench
