// SPDX-License-Identifier: Apache-2.0
#include "batch/contest.hpp"

#include <algorithm>
#include <chrono>

namespace vesica::bench {
namespace {

using Clock = std::chrono::steady_clock;

double nanoseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

/// What an empty pass seems to take.
double clock_time() {
  Times times;
  const Pass empty = [] { return 0; };
  for (int i = 0; i < 2001; ++i) {
    const Clock::time_point start = Clock::now();
    empty();
    times.push_back(nanoseconds_since(start));
  }
  return median(std::move(times));
}

volatile std::int64_t consumed;

double time_of(const Pass& pass) {
  const Clock::time_point start = Clock::now();
  consumed = pass();
  return nanoseconds_since(start);
}

}  // namespace

std::vector<Times> contest(const std::function<void(std::uint64_t round)>& prepare, const std::vector<Pass>& entrants,
                           Budget budget) {
  static const double clock = clock_time();
  const std::size_t count = entrants.size();
  std::vector<Times> times(count);
  const Clock::time_point start = Clock::now();
  const auto warming = static_cast<std::uint64_t>(budget.rounds / 8 + 1);
  for (std::uint64_t round = 0;
       round < warming + static_cast<std::uint64_t>(budget.rounds) || nanoseconds_since(start) < budget.seconds * 1e9;
       ++round) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t entrant = (i + round) % count;
      prepare(round);
      const double time = time_of(entrants[entrant]) - clock;
      if (round >= warming) times[entrant].push_back(std::max(time, 1.0));
    }
  }
  return times;
}

double quantile(Times values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

Times ratios(const Times& numerators, const Times& denominators) {
  Times all;
  for (std::size_t i = 0; i < numerators.size(); ++i) all.push_back(numerators[i] / denominators[i]);
  return all;
}

}  // namespace vesica::bench
