// SPDX-License-Identifier: Apache-2.0
/// Several pieces of code timed in turns on the same data, so that what disturbs the machine disturbs all of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "quantile.hpp"

namespace vesica::bench {

/// One timed pass; its result is consumed, so that it cannot be dropped.
using Pass = std::function<std::int64_t()>;

/// Nanoseconds of each round's pass.
using Times = std::vector<double>;

/// How long a contest goes on: at least `rounds`, and until `seconds` have passed.
struct Budget {
  double seconds = 0.2;
  int rounds = 9;
  /// Passes of milliseconds, which a busy machine interrupts: timed by the processor time of the thread, whose clock is
  /// too slow to read for shorter ones.
  bool long_passes = false;
};

/// In every round each entrant makes one pass, right after prepare(round), which must lay out the same data whenever
/// it is called for the same round. Who goes first changes from round to round. The clock's own time is taken off.
std::vector<Times> contest(const std::function<void(std::uint64_t round)>& prepare, const std::vector<Pass>& entrants,
                           Budget budget);

/// Round by round: what disturbed one round disturbed both of its times.
Times ratios(const Times& numerators, const Times& denominators);

}  // namespace vesica::bench
