// SPDX-License-Identifier: Apache-2.0
// Matching of detections to truths and average precision: numbers worked out by hand, the definitions on full matrices,
// errors. The Python package's tests have the challenges' programs as oracles.
#include <gtest/gtest.h>
#include <vesica_detection.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

#include "properties/random.hpp"

namespace precision_test {

using Numbers = std::vector<std::int64_t>;
using Codes = std::vector<std::uint8_t>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Case {
  std::int32_t rule = VESICA_MATCH_COCO;
  Numbers a, b;
  std::vector<double> values, scores;
  Codes flags;
  std::int64_t truths = 0;
  std::vector<double> thresholds = {0.5};
};

struct Matches {
  Codes outcomes;
  Numbers taken;
  bool operator==(const Matches&) const = default;
};

template <class T, class Function>
Matches matched(const Case& c, Function function) {
  const auto count = static_cast<std::int64_t>(c.a.size()), detections = static_cast<std::int64_t>(c.scores.size());
  const std::int64_t bytes = vesica_match_truths_scratch(count, detections, c.truths);
  std::vector<std::uint64_t> scratch(static_cast<std::size_t>(bytes) / 8 + 2, ~std::uint64_t{0});
  const std::size_t results = c.scores.size() * c.thresholds.size();
  Matches m{Codes(results + 1, 77), Numbers(results + 1, -7)};
  const std::vector<T> values(c.values.begin(), c.values.end()), scores(c.scores.begin(), c.scores.end()),
      thresholds(c.thresholds.begin(), c.thresholds.end());
  EXPECT_EQ(
      function(c.rule, c.a.data(), c.b.data(), values.data(), count, scores.data(), detections,
               c.flags.empty() ? nullptr : c.flags.data(), c.truths, thresholds.data(),
               static_cast<std::int64_t>(thresholds.size()), scratch.data(), bytes, m.outcomes.data(), m.taken.data()),
      0);
  EXPECT_EQ(scratch.back(), ~std::uint64_t{0});
  EXPECT_TRUE(m.outcomes.back() == 77 && m.taken.back() == -7);
  m.outcomes.pop_back();
  m.taken.pop_back();
  return m;
}
inline Matches matched(const Case& c) { return matched<double>(c, vesica_match_truths_f64); }

inline double precision(std::int32_t rule, const std::vector<double>& scores, const Codes& outcomes,
                        std::int64_t truths) {
  const auto count = static_cast<std::int64_t>(scores.size());
  const std::int64_t bytes = vesica_average_precision_scratch(count);
  std::vector<std::uint64_t> scratch(static_cast<std::size_t>(bytes) / 8 + 1, ~std::uint64_t{0});
  double out = -7;
  EXPECT_EQ(
      vesica_average_precision_f64(rule, scores.data(), outcomes.data(), count, truths, scratch.data(), bytes, &out),
      0);
  EXPECT_EQ(scratch.back(), ~std::uint64_t{0});
  float rounded = -7;
  const std::vector<float> floats(scores.begin(), scores.end());
  EXPECT_EQ(vesica_average_precision_f32(rule, floats.data(), outcomes.data(), count, truths, scratch.data(), bytes,
                                         &rounded),
            0);
  EXPECT_TRUE(rounded == static_cast<float>(out) || std::isnan(out));
  return out;
}

/// Two detections of two truths. The second prefers the first truth too.
TEST(MatchTruths, ChallengesDifferWhereTheBestIsTaken) {
  Case c{.a = {0, 0, 1, 1},
         .b = {0, 1, 0, 1},
         .values = {0.8, 0.6, 0.7, 0.6},
         .scores = {0.9, 0.8},
         .flags = {},
         .truths = 2};
  EXPECT_EQ(matched(c), (Matches{{1, 1}, {0, 1}}));
  c.rule = VESICA_MATCH_VOC;
  EXPECT_EQ(matched(c), (Matches{{1, 0}, {0, -1}}));
  // Scores decide, equal ones the number.
  c.scores = {0.8, 0.9};
  EXPECT_EQ(matched(c), (Matches{{0, 1}, {-1, 0}}));
  c.scores = {0.8, 0.8};
  EXPECT_EQ(matched(c), (Matches{{1, 0}, {0, -1}}));
}

TEST(MatchTruths, EqualValues) {
  Case c{.a = {0, 0}, .b = {1, 0}, .values = {0.7, 0.7}, .scores = {1}, .flags = {}, .truths = 2};
  EXPECT_EQ(matched(c).taken, (Numbers{1}));  // the last
  c.rule = VESICA_MATCH_VOC;
  EXPECT_EQ(matched(c).taken, (Numbers{0}));  // the first
}

TEST(MatchTruths, TheThresholdItselfIsEnough) {
  for (const std::int32_t rule : {VESICA_MATCH_VOC, VESICA_MATCH_COCO}) {
    const Case c{.rule = rule,
                 .a = {0, 1},
                 .b = {0, 1},
                 .values = {0.5, 1},
                 .scores = {1, 2},
                 .flags = {},
                 .truths = 2,
                 .thresholds = {0.5, std::nextafter(0.5, 1), 1}};
    EXPECT_EQ(matched(c).outcomes, (Codes{1, 1, 0, 1, 0, 1}));
  }
  // COCO takes 1 - 1e-10 in place of 1.
  Case c{.a = {0}, .b = {0}, .values = {1 - 1e-11}, .scores = {1}, .flags = {}, .truths = 1, .thresholds = {1}};
  EXPECT_EQ(matched(c).outcomes, (Codes{1}));
  c.rule = VESICA_MATCH_VOC;
  EXPECT_EQ(matched(c).outcomes, (Codes{0}));
}

/// A crowd takes both detections, an ignored truth one; COCO asks them only where no other is free.
TEST(MatchTruths, TruthsThatDoNotCount) {
  Case c{.a = {0, 1}, .b = {0, 0}, .values = {0.9, 0.8}, .scores = {2, 1}, .flags = {VESICA_TRUTH_CROWD}, .truths = 1};
  EXPECT_EQ(matched(c), (Matches{{2, 2}, {0, 0}}));
  c.rule = VESICA_MATCH_VOC;
  EXPECT_EQ(matched(c), (Matches{{2, 2}, {0, 0}}));
  c.flags = {VESICA_TRUTH_IGNORED};
  EXPECT_EQ(matched(c), (Matches{{2, 2}, {0, 0}}));
  c.rule = VESICA_MATCH_COCO;
  EXPECT_EQ(matched(c), (Matches{{2, 0}, {0, -1}}));
  c = {.a = {0, 0},
       .b = {0, 1},
       .values = {0.9, 0.6},
       .scores = {1},
       .flags = {VESICA_TRUTH_CROWD, VESICA_TRUTH_COUNTS},
       .truths = 2};
  EXPECT_EQ(matched(c), (Matches{{1}, {1}}));
  c.rule = VESICA_MATCH_VOC;
  EXPECT_EQ(matched(c), (Matches{{2}, {0}}));
}

/// The definitions on a full matrix, without sorting pairs.
inline Matches by_definition(const Case& c) {
  const std::size_t n = c.scores.size(), m = static_cast<std::size_t>(c.truths);
  std::map<std::pair<std::int64_t, std::int64_t>, double> value;
  for (std::size_t k = 0; k < c.a.size(); ++k) {
    if (!std::isnan(c.values[k])) value[{c.a[k], c.b[k]}] = c.values[k];
  }
  const auto flag = [&](std::size_t t) { return c.flags.empty() ? 0 : c.flags[t]; };
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return c.scores[i] > c.scores[j]; });
  Matches result{Codes(n * c.thresholds.size(), 0), Numbers(n * c.thresholds.size(), -1)};
  for (std::size_t row = 0; row < c.thresholds.size(); ++row) {
    std::vector<bool> taken(m);
    for (const std::size_t d : order) {
      // Candidates in the order of preference; the first that will do is taken.
      std::vector<std::pair<std::size_t, double>> candidates;
      for (std::size_t t = 0; t < m; ++t) {
        const auto found = value.find({static_cast<std::int64_t>(d), static_cast<std::int64_t>(t)});
        if (found != value.end()) candidates.emplace_back(t, found->second);
      }
      const bool voc = c.rule == VESICA_MATCH_VOC;
      std::sort(candidates.begin(), candidates.end(), [&](const auto& p, const auto& q) {
        const bool p_counts = flag(p.first) == VESICA_TRUTH_COUNTS, q_counts = flag(q.first) == VESICA_TRUTH_COUNTS;
        if (!voc && p_counts != q_counts) return p_counts;
        if (p.second != q.second) return p.second > q.second;
        return voc ? p.first < q.first : p.first > q.first;
      });
      for (const auto& [t, v] : candidates) {
        const bool counts = flag(t) == VESICA_TRUTH_COUNTS;
        const bool enough = v >= (voc ? c.thresholds[row] : std::min(c.thresholds[row], 1 - 1e-10));
        const bool free = !taken[t] || (voc ? !counts : flag(t) == VESICA_TRUTH_CROWD);
        if (enough && free) {
          taken[t] = true;
          result.outcomes[row * n + d] = counts ? VESICA_OUTCOME_HIT : VESICA_OUTCOME_IGNORED;
          result.taken[row * n + d] = static_cast<std::int64_t>(t);
          break;
        }
        if (voc) break;
      }
    }
  }
  return result;
}

TEST(MatchTruths, AreTheDefinitions) {
  properties::Random random(properties::seed());
  std::map<int, int> outcomes;
  for (int round = 0; round < 400; ++round) {
    const int detections = random.integer(1, 30), truths = random.integer(1, 15);
    Case c{.rule = round % 2,
           .a = {},
           .b = {},
           .values = {},
           .scores = {},
           .flags = {},
           .truths = truths,
           .thresholds = {0.5, 0.25, 0.75, 1, 0}};
    for (int d = 0; d < detections; ++d) {
      c.scores.push_back(random.below(8));
      for (int t = 0; t < truths; ++t) {
        if (!random.chance(0.4)) continue;
        c.a.push_back(d);
        c.b.push_back(t);
        c.values.push_back(random.chance(0.02) ? nan : random.below(9) / 8.0);
      }
    }
    // Pairs come in any order.
    for (std::size_t k = c.a.size(); k > 1; --k) {
      const auto j = static_cast<std::size_t>(random.below(static_cast<int>(k)));
      std::swap(c.a[k - 1], c.a[j]);
      std::swap(c.b[k - 1], c.b[j]);
      std::swap(c.values[k - 1], c.values[j]);
    }
    if (random.chance(0.7)) {
      for (int t = 0; t < truths; ++t) c.flags.push_back(static_cast<std::uint8_t>(random.below(3)));
    }
    const Matches expected = by_definition(c);
    ASSERT_EQ(matched(c), expected) << "seed " << properties::seed();
    ASSERT_EQ(matched<float>(c, vesica_match_truths_f32), expected);
    for (const std::uint8_t o : expected.outcomes) ++outcomes[o];
  }
  EXPECT_TRUE(outcomes[0] > 1000 && outcomes[1] > 1000 && outcomes[2] > 1000);
}

/// Hit, miss, hit, ignored, miss, of three truths: precision 1, 1/2, 2/3, 2/3, 1/2 at recall 1/3, 1/3, 2/3, 2/3, 2/3.
TEST(AveragePrecision, ByHand) {
  const std::vector<double> scores{0.5, 0.9, 0.8, 0.6, 0.7};
  const Codes outcomes{0, 1, 0, 2, 1};
  EXPECT_NEAR(precision(VESICA_PRECISION_VOC_2010, scores, outcomes, 3), (1 + 2.0 / 3) / 3, 1e-15);
  // 1 at 0 ... 0.3, 2/3 at 0.4, 0.5 and 0.6.
  EXPECT_NEAR(precision(VESICA_PRECISION_VOC_2007, scores, outcomes, 3), 6.0 / 11, 1e-15);
  // 1 at 0 ... 0.33, 2/3 at 0.34 ... 0.66.
  EXPECT_NEAR(precision(VESICA_PRECISION_COCO, scores, outcomes, 3), 56.0 / 101, 1e-15);
}

/// Miss, hit, hit: precision 0, 1/2, 2/3; the best one at every recall is 2/3.
TEST(AveragePrecision, TheBestPrecisionMayComeLater) {
  for (const std::int32_t rule : {0, 1, 2}) EXPECT_NEAR(precision(rule, {3, 2, 1}, {0, 1, 1}, 2), 2.0 / 3, 1e-15);
  for (const std::int32_t rule : {0, 1, 2}) {
    EXPECT_EQ(precision(rule, {}, {}, 2), 0);
    EXPECT_EQ(precision(rule, {1, 2}, {0, 2}, 2), 0);
    EXPECT_EQ(precision(rule, {1, 2}, {1, 1}, 2), 1);
    EXPECT_TRUE(std::isnan(precision(rule, {1}, {0}, 0)));
  }
}

/// 57 of 100 truths: 0.57 is below 57 times 0.01, as a double; 3 of 10 below 3 times 0.1. So are the programs'.
TEST(AveragePrecision, RecallsAreComparedAsDoubles) {
  EXPECT_NEAR(precision(VESICA_PRECISION_COCO, std::vector<double>(57, 1), Codes(57, 1), 100), 57.0 / 101, 1e-14);
  EXPECT_NEAR(precision(VESICA_PRECISION_COCO, std::vector<double>(50, 1), Codes(50, 1), 100), 51.0 / 101, 1e-14);
  EXPECT_NEAR(precision(VESICA_PRECISION_VOC_2007, {1, 2, 3}, {1, 1, 1}, 10), 3.0 / 11, 1e-15);
  EXPECT_NEAR(precision(VESICA_PRECISION_VOC_2010, {1, 2, 3}, {1, 1, 1}, 10), 0.3, 1e-15);
}

/// The best precision at each recall, searched for among all detections.
TEST(AveragePrecision, IsTheDefinition) {
  properties::Random random(properties::seed());
  for (int round = 0; round < 300; ++round) {
    const int n = random.integer(0, 120);
    std::vector<double> scores;
    Codes outcomes;
    for (int i = 0; i < n; ++i) {
      scores.push_back(random.chance(0.5) ? random.below(5) : random.below(1 << 20) / 1024.0);
      outcomes.push_back(static_cast<std::uint8_t>(random.below(3)));
    }
    const auto hits = std::count(outcomes.begin(), outcomes.end(), 1);
    const std::int64_t truths = hits + random.below(4) + (hits == 0 ? 1 : 0);
    std::vector<std::size_t> order(scores.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return scores[i] > scores[j]; });
    std::vector<std::pair<double, double>> curve;  // recall, precision
    double found = 0, all = 0;
    for (const std::size_t i : order) {
      if (outcomes[i] == 2) continue;
      found += outcomes[i] == 1;
      curve.emplace_back(found / static_cast<double>(truths), found / ++all);
    }
    const auto best_at = [&](double recall) {
      double best = 0;
      for (const auto& [r, p] : curve) best = r >= recall ? std::max(best, p) : best;
      return best;
    };
    const auto mean = [&](int count, double step) {
      double sum = 0;
      for (int i = 0; i < count; ++i) sum += best_at(i + 1 == count ? 1 : i * step);
      return sum / count;
    };
    double area = 0;
    for (std::int64_t k = 1; k <= truths; ++k) area += best_at(static_cast<double>(k) / static_cast<double>(truths));
    EXPECT_NEAR(precision(VESICA_PRECISION_VOC_2007, scores, outcomes, truths), mean(11, 0.1), 1e-14);
    EXPECT_NEAR(precision(VESICA_PRECISION_COCO, scores, outcomes, truths), mean(101, 0.01), 1e-14);
    EXPECT_NEAR(precision(VESICA_PRECISION_VOC_2010, scores, outcomes, truths), area / static_cast<double>(truths),
                1e-14);
  }
}

TEST(AveragePrecision, TheCallersEnvironment) {
  const std::vector<double> scores{0.0, -0.0, 0x1p-149};
  const Codes outcomes{1, 0, 1};
  const double expected = precision(VESICA_PRECISION_COCO, scores, outcomes, 3);
  const Case c{.a = {0, 1, 2}, .b = {0, 0, 0}, .values = {1, 1, 1}, .scores = scores, .flags = {}, .truths = 1};
  std::fesetround(FE_DOWNWARD);
  const double found = precision(VESICA_PRECISION_COCO, scores, outcomes, 3);
  const Matches matches = matched(c);
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(found, expected);
  EXPECT_EQ(matches.taken, (Numbers{-1, -1, 0}));
}

TEST(MatchTruths, Errors) {
  const std::int64_t a[] = {0, 1}, b[] = {0, 0}, below[] = {0, -1}, beyond[] = {0, 2};
  const double values[] = {1, 1}, scores[] = {1, 2}, with_nan[] = {1, nan}, thresholds[] = {0.5};
  const std::uint8_t flags[] = {0}, wrong_flags[] = {3};
  const std::int64_t size = vesica_match_truths_scratch(2, 2, 1);
  std::vector<std::uint64_t> scratch(static_cast<std::size_t>(size) / 8 + 2);
  std::uint8_t outcomes[] = {77, 77};
  struct Arguments {
    std::int32_t rule;
    const std::int64_t *a, *b;
    const double* values;
    std::int64_t count;
    const double* scores;
    std::int64_t detections;
    const std::uint8_t* flags;
    std::int64_t truths;
    const double* thresholds;
    std::int64_t threshold_count;
    void* scratch;
    std::int64_t size;
    std::uint8_t* outcomes;
  };
  const Arguments good{1, a, b, values, 2, scores, 2, flags, 1, thresholds, 1, scratch.data(), size, outcomes};
  const auto ask = [](const Arguments& g) {
    return vesica_match_truths_f64(g.rule, g.a, g.b, g.values, g.count, g.scores, g.detections, g.flags, g.truths,
                                   g.thresholds, g.threshold_count, g.scratch, g.size, g.outcomes, nullptr);
  };
  const auto with = [&](auto change) {
    Arguments g = good;
    change(g);
    return ask(g);
  };
  EXPECT_EQ(with([](Arguments& g) { g.a = nullptr; }), VESICA_E_NULL);
  EXPECT_EQ(with([](Arguments& g) { g.b = nullptr; }), VESICA_E_NULL);
  EXPECT_EQ(with([](Arguments& g) { g.values = nullptr; }), VESICA_E_NULL);
  EXPECT_EQ(with([](Arguments& g) { g.scores = nullptr; }), VESICA_E_NULL);
  EXPECT_EQ(with([](Arguments& g) { g.thresholds = nullptr; }), VESICA_E_NULL);
  EXPECT_EQ(with([](Arguments& g) { g.scratch = nullptr; }), VESICA_E_NULL);
  EXPECT_EQ(with([](Arguments& g) { g.outcomes = nullptr; }), VESICA_E_NULL);
  for (const std::int32_t rule : {-1, 2}) EXPECT_EQ(with([&](Arguments& g) { g.rule = rule; }), VESICA_E_ARGUMENT);
  EXPECT_EQ(with([&](Arguments& g) { g.a = below; }), VESICA_E_ARGUMENT);
  EXPECT_EQ(with([&](Arguments& g) { g.a = beyond; }), VESICA_E_ARGUMENT);
  EXPECT_EQ(with([&](Arguments& g) { g.b = below; }), VESICA_E_ARGUMENT);
  EXPECT_EQ(with([&](Arguments& g) { g.b = a; }), VESICA_E_ARGUMENT);
  EXPECT_EQ(with([&](Arguments& g) { g.scores = with_nan; }), VESICA_E_ARGUMENT);
  EXPECT_EQ(with([&](Arguments& g) { g.thresholds = with_nan + 1; }), VESICA_E_ARGUMENT);
  EXPECT_EQ(with([&](Arguments& g) { g.flags = wrong_flags; }), VESICA_E_ARGUMENT);
  EXPECT_EQ(with([](Arguments& g) { g.count = -1; }), VESICA_E_ARGUMENT);
  EXPECT_EQ(with([](Arguments& g) { g.detections = -1; }), VESICA_E_ARGUMENT);
  EXPECT_EQ(with([](Arguments& g) { g.truths = -1; }), VESICA_E_ARGUMENT);
  EXPECT_EQ(with([](Arguments& g) { g.threshold_count = -1; }), VESICA_E_ARGUMENT);
  EXPECT_EQ(with([](Arguments& g) { --g.size; }), VESICA_E_ARGUMENT);
  EXPECT_EQ(with([](Arguments& g) { g.scratch = static_cast<char*>(g.scratch) + 4; }), VESICA_E_ARGUMENT);
  EXPECT_TRUE(outcomes[0] == 77 && outcomes[1] == 77);
  EXPECT_EQ(with([](Arguments& g) { g.threshold_count = 0; }), 0);
  EXPECT_TRUE(outcomes[0] == 77 && outcomes[1] == 77);
  EXPECT_EQ(ask({1, nullptr, nullptr, nullptr, 0, nullptr, 0, nullptr, 5, thresholds, 1, nullptr, 0, nullptr}), 0);
  EXPECT_EQ(ask(good), 0);
  EXPECT_TRUE(outcomes[0] == 0 && outcomes[1] == 1);
  EXPECT_EQ(vesica_match_truths_scratch(-1, 0, 0), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_match_truths_scratch(0, std::int64_t{1} << 31, 0), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_match_truths_scratch(1, 1, 1), 32 + 36 + 1 + 4);
}

TEST(AveragePrecision, Errors) {
  const double scores[] = {1, 2}, with_nan[] = {1, nan};
  const std::uint8_t outcomes[] = {1, 1}, wrong[] = {1, 3};
  const std::int64_t size = vesica_average_precision_scratch(2);
  std::vector<std::uint64_t> scratch(static_cast<std::size_t>(size) / 8 + 1);
  double out = -7;
  const auto ask = [&](std::int32_t rule, const double* s, const std::uint8_t* o, std::int64_t n, std::int64_t truths,
                       void* room, std::int64_t bytes,
                       double* to) { return vesica_average_precision_f64(rule, s, o, n, truths, room, bytes, to); };
  const auto room = scratch.data();
  EXPECT_EQ(ask(0, nullptr, outcomes, 2, 2, room, size, &out), VESICA_E_NULL);
  EXPECT_EQ(ask(0, scores, nullptr, 2, 2, room, size, &out), VESICA_E_NULL);
  EXPECT_EQ(ask(0, scores, outcomes, 2, 2, nullptr, size, &out), VESICA_E_NULL);
  EXPECT_EQ(ask(0, scores, outcomes, 2, 2, room, size, nullptr), VESICA_E_NULL);
  EXPECT_EQ(ask(-1, scores, outcomes, 2, 2, room, size, &out), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(3, scores, outcomes, 2, 2, room, size, &out), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(0, with_nan, outcomes, 2, 2, room, size, &out), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(0, scores, wrong, 2, 2, room, size, &out), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(0, scores, outcomes, 2, 1, room, size, &out), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(0, scores, outcomes, 0, -1, room, size, &out), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(0, scores, outcomes, -1, 2, room, size, &out), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(0, scores, outcomes, 2, 2, room, size - 1, &out), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(0, scores, outcomes, 2, 2, reinterpret_cast<char*>(room) + 4, size, &out), VESICA_E_ARGUMENT);
  EXPECT_EQ(out, -7);
  EXPECT_EQ(ask(0, nullptr, nullptr, 0, 2, nullptr, 0, &out), 0);
  EXPECT_EQ(out, 0);
  EXPECT_EQ(vesica_average_precision_scratch(-1), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_average_precision_scratch(std::int64_t{1} << 31), VESICA_E_ARGUMENT);
}

}  // namespace precision_test
