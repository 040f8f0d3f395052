// SPDX-License-Identifier: Apache-2.0
/// Looks for the input at which a filter errs most, measured by its own bound.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include "filter/inputs.hpp"
#include "properties/random.hpp"

namespace search {

/// A pair and its error over bound; negative outside of the filter's guard.
template <class V>
struct Candidate {
  double ratio;
  inputs::Numbers<V> n;
};

template <class V>
struct Result {
  Candidate<V> worst;
  int measured;  // inputs within the guard
};

inline constexpr std::size_t climbers = 12;

/// Draws, then climbs from the worst few: a changed input replaces its parent unless it errs less.
template <class V, class Draw, class Ratio>
Result<V> worst_ratio(inputs::Inputs<V>& pairs, Draw draw, Ratio ratio, int draws, int changes) {
  const auto worse = [](const Candidate<V>& a, const Candidate<V>& b) { return a.ratio > b.ratio; };
  std::vector<Candidate<V>> best;
  int measured = 0;
  for (int i = 0; i < draws; ++i) {
    const inputs::Numbers<V> n = draw();
    const Candidate<V> drawn{ratio(n), n};
    if (drawn.ratio < 0) continue;
    ++measured;
    if (best.size() == climbers && !worse(drawn, best.back())) continue;
    if (best.size() == climbers) best.pop_back();
    best.insert(std::upper_bound(best.begin(), best.end(), drawn, worse), drawn);
  }
  for (Candidate<V>& climber : best) {
    for (int i = 0; i < changes / static_cast<int>(climbers); ++i) {
      const inputs::Numbers<V> n = pairs.changed(climber.n);
      const Candidate<V> next{ratio(n), n};
      measured += next.ratio >= 0;
      if (next.ratio >= climber.ratio) climber = next;
    }
  }
  if (best.empty()) return {{-1, {}}, 0};
  return {*std::min_element(best.begin(), best.end(), worse), measured};
}

/// Fails when the worst error exceeds its bound, and when the search cannot have been one: hardly an input within the
/// guard, or none whose error comes within a fiftieth of a bound that is a small multiple of the least provable one.
template <class V, class Draw, class Ratio>
void expect_within_bound(const std::string& what, inputs::Inputs<V>& pairs, Draw draw, Ratio ratio, int effort) {
  const int draws = effort * properties::repeat();
  const Result<V> found = worst_ratio(pairs, draw, ratio, draws, draws);
  const char* scalar = sizeof(V) == 4 ? "f32" : "f64";
  std::printf("  %-38s %s  error / bound <= %.3f over %d inputs\n", what.c_str(), scalar, found.worst.ratio,
              found.measured);
  testing::Test::RecordProperty(what, std::to_string(found.worst.ratio));
  EXPECT_LE(found.worst.ratio, 1.0) << what << ", seed " << properties::seed() << ": "
                                    << inputs::describe(found.worst.n, pairs.first_count(), pairs.count());
  EXPECT_GE(found.measured, draws / 5) << what;
  EXPECT_GE(found.worst.ratio, 0.02) << what;
}

template <class V, class Ratio>
void expect_within_bound(const std::string& what, inputs::Inputs<V>& pairs, Ratio ratio, int effort) {
  expect_within_bound(
      what, pairs, [&] { return pairs.draw(); }, ratio, effort);
}

}  // namespace search
