// SPDX-License-Identifier: Apache-2.0
#include "methods/measure.hpp"

#include <chrono>
#include <ctime>

#include "quantile.hpp"

namespace vesica::bench::methods {
namespace {

using Clock = std::chrono::steady_clock;

/// The result of a timed loop; written so that the loop cannot be dropped.
volatile std::int64_t consumed;

/// A pass that is long is interrupted on a busy machine: of those the processor's time counts, which is too coarse and
/// too slow to read for the short ones.
template <class Pass>
double nanoseconds_a_test(std::size_t tests, Pass pass) {
  constexpr double longest_short = 1e5;
  const std::clock_t processor_start = std::clock();
  const Clock::time_point start = Clock::now();
  consumed = pass();
  const double elapsed = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
  const double processor = 1e9 * static_cast<double>(std::clock() - processor_start) / CLOCKS_PER_SEC;
  return (elapsed < longest_short ? elapsed : processor) / static_cast<double>(tests);
}

/// Both sides on the same pairs, each copied into the same hot buffers just before; who goes first alternates. At least
/// ten passes, then as many as fit in a twentieth of a second.
void time(Contest& contest, Outcome& outcome, std::uint64_t seed) {
  constexpr std::size_t fewest = 10;
  std::vector<double> method, exact;
  Random random(seed);
  const Clock::time_point end = Clock::now() + std::chrono::milliseconds(50);
  while (method.size() < fewest || Clock::now() < end) {
    const Random start = random;
    const bool method_first = method.size() % 2 == 0;
    for (const bool is_method : {method_first, !method_first}) {
      random = start;
      contest.draw(random);
      const double time = is_method ? nanoseconds_a_test(contest.pairs(), [&] { return contest.method_sum(); })
                                    : nanoseconds_a_test(contest.pairs(), [&] { return contest.exact_sum(); });
      (is_method ? method : exact).push_back(time);
    }
  }
  outcome.method = median(method);
  outcome.exact = median(exact);
}

Outcome outcome_of(Contest& contest, const Pool& pool) {
  Outcome outcome;
  contest.load(pool);
  contest.count(outcome);
  time(contest, outcome, seed_of_run());
  contest.unload();
  return outcome;
}

}  // namespace

void measure(const std::vector<Method*>& methods) {
  for (const Trial trial : trials) {
    // A pool takes longer to make than to use: methods on the same kinds, which come one after the other, share it.
    const Method* made_for = nullptr;
    Pool pool;
    for (Method* method : methods) {
      if (made_for == nullptr || made_for->kinds != method->kinds) {
        pool = make_pool(method->kinds, trial, seed_of_run());
        made_for = method;
      }
      method->outcomes.push_back(outcome_of(*method->contest, pool));
    }
  }
}

}  // namespace vesica::bench::methods
