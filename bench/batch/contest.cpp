// SPDX-License-Identifier: Apache-2.0
#include "batch/contest.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <utility>

namespace vesica::bench {
namespace {

using Clock = std::chrono::steady_clock;

double wall_time() { return std::chrono::duration<double, std::nano>(Clock::now().time_since_epoch()).count(); }

double thread_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

volatile std::int64_t consumed;

template <class Now>
double time_of(const Pass& pass, Now now) {
  const double start = now();
  consumed = pass();
  return now() - start;
}

/// The measured time of an empty pass.
double clock_time() {
  Times times;
  for (int i = 0; i < 2001; ++i) times.push_back(time_of([] { return 0; }, wall_time));
  return median(std::move(times));
}

}  // namespace

std::vector<Times> contest(const std::function<void(std::uint64_t round)>& prepare, const std::vector<Pass>& entrants,
                           Budget budget) {
  static const double clock = clock_time();
  const std::size_t count = entrants.size();
  std::vector<Times> times(count);
  const double start = wall_time();
  const auto warming = static_cast<std::uint64_t>(budget.rounds / 8 + 1);
  for (std::uint64_t round = 0;
       round < warming + static_cast<std::uint64_t>(budget.rounds) || wall_time() - start < budget.seconds * 1e9;
       ++round) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t entrant = (i + round) % count;
      prepare(round);
      const double time =
          budget.long_passes ? time_of(entrants[entrant], thread_time) : time_of(entrants[entrant], wall_time) - clock;
      if (round >= warming) times[entrant].push_back(std::max(time, 1.0));
    }
  }
  return times;
}

Times ratios(const Times& numerators, const Times& denominators) {
  Times all;
  for (std::size_t i = 0; i < numerators.size(); ++i) all.push_back(numerators[i] / denominators[i]);
  return all;
}

}  // namespace vesica::bench
