// SPDX-License-Identifier: Apache-2.0
// Suppression by any ratio and among like labels, against the definition followed literally.
#include <gtest/gtest.h>
#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "properties/random.hpp"

namespace suppress_test {
namespace {

using properties::Random;
using properties::repeat;
using properties::seed;
using Indices = std::vector<std::int64_t>;

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

struct Scene {
  std::vector<vesica_rect_f64> rects;
  std::vector<double> scores;
  std::optional<std::vector<std::int32_t>> labels;
  std::int32_t ratio = VESICA_RATIO_OVER_UNION;
  double threshold = 0.5, least_score = -inf;
  std::int64_t most = std::numeric_limits<std::int64_t>::max();
};

struct Result {
  std::int32_t code;
  Indices kept;
  bool operator==(const Result&) const = default;
};

vesica_shapes_f64 shapes_of(const std::vector<vesica_rect_f64>& rects) {
  vesica_shapes_f64 shapes;
  EXPECT_EQ(vesica_shapes_from_records_f64(VESICA_RECT, static_cast<std::int64_t>(rects.size()), rects.data(),
                                           sizeof rects[0], &shapes),
            0);
  return shapes;
}

Result suppress(const Scene& s) {
  const auto shapes = shapes_of(s.rects);
  const std::int64_t bytes = vesica_nms_scratch(shapes.count);
  std::vector<char> scratch(static_cast<std::size_t>(bytes));
  const auto room = static_cast<std::size_t>(std::clamp<std::int64_t>(s.most, 0, shapes.count));
  Indices keep(room + 1, -7);
  std::int64_t kept = -7;
  const std::int32_t code =
      vesica_suppress_f64(&shapes, s.scores.data(), s.labels ? s.labels->data() : nullptr, s.ratio, s.threshold,
                          s.least_score, s.most, scratch.data(), bytes, keep.data(), &kept);
  if (kept < 0) return {code, {}};
  EXPECT_LE(static_cast<std::size_t>(kept), room);
  for (std::size_t i = static_cast<std::size_t>(kept); i < keep.size(); ++i) EXPECT_EQ(keep[i], -7);
  keep.resize(static_cast<std::size_t>(kept));
  return {code, keep};
}

Result by_definition(const Scene& s) {
  Indices order;
  bool left_out = false;
  for (std::size_t i = 0; i < s.rects.size(); ++i) {
    const bool usable = vesica_check_f64(VESICA_RECT, &s.rects[i].cx) == 0 && !std::isnan(s.scores[i]);
    left_out |= !usable;
    if (usable && s.scores[i] >= s.least_score) order.push_back(static_cast<std::int64_t>(i));
  }
  const auto at = [](std::int64_t i) { return static_cast<std::size_t>(i); };
  std::stable_sort(order.begin(), order.end(), [&](auto i, auto j) { return s.scores[at(i)] > s.scores[at(j)]; });
  Indices kept;
  for (const std::int64_t i : order) {
    const bool suppressed = std::any_of(kept.begin(), kept.end(), [&](std::int64_t j) {
      if (s.labels && (*s.labels)[at(i)] != (*s.labels)[at(j)]) return false;
      double ratio = 0;
      vesica_ratio_f64(s.ratio, VESICA_RECT, &s.rects[at(j)].cx, VESICA_RECT, &s.rects[at(i)].cx, &ratio);
      return ratio > s.threshold;
    });
    if (!suppressed) kept.push_back(i);
  }
  if (static_cast<std::int64_t>(kept.size()) > s.most) kept.resize(static_cast<std::size_t>(s.most));
  return {left_out ? VESICA_E_SHAPE : 0, kept};
}

Scene random_scene(Random& random) {
  Scene s;
  const double width = random.between(3, 12);
  for (int i = random.integer(0, 250); i > 0; --i) {
    const double angle = random.between(0, 7);
    const bool again = !s.rects.empty() && random.chance(0.1);
    s.rects.push_back(again ? s.rects[random.below(static_cast<std::uint32_t>(s.rects.size()))]
                            : vesica_rect_f64{random.between(0, width), random.between(0, width), std::cos(angle),
                                              std::sin(angle), random.between(0.1, 2), random.between(0.1, 2)});
    s.scores.push_back(random.chance(0.3) ? random.integer(0, 3) : random.between(0, 3));
    if (random.chance(0.02)) s.scores.back() = nan;
    if (random.chance(0.02)) s.rects.back().hx = random.chance(0.5) ? 0 : -1;
  }
  constexpr std::int32_t ratios[] = {VESICA_RATIO_OVER_UNION, VESICA_RATIO_OVER_SMALLER, VESICA_RATIO_GENERALIZED,
                                     VESICA_RATIO_DISTANCE, VESICA_RATIO_COMPLETE};
  s.ratio = ratios[random.below(5)];
  s.threshold = random.chance(0.1) ? random.integer(0, 1) : random.between(0, 1);
  if (random.chance(0.5)) s.least_score = random.between(0, 3);
  if (random.chance(0.5)) s.most = random.integer(0, 40);
  if (random.chance(0.7)) {
    s.labels.emplace();
    for (std::size_t i = 0; i < s.rects.size(); ++i) s.labels->push_back(random.integer(-1, 1));
  }
  return s;
}

TEST(Suppress, FollowsItsDefinition) {
  Random random(seed());
  std::size_t kept = 0, all = 0;
  for (int i = 0; i < 400 * repeat(); ++i) {
    const Scene s = random_scene(random);
    const Result wanted = by_definition(s);
    EXPECT_EQ(suppress(s), wanted) << "scene " << i << ", seed " << seed() << ", ratio " << s.ratio;
    kept += wanted.kept.size();
    all += s.rects.size();
  }
  EXPECT_GT(10 * kept, all);
  EXPECT_LT(2 * kept, all);
}

TEST(Suppress, Known) {
  // A small box inside a large one: over the union 1/4, over the smaller 1.
  const std::vector<vesica_rect_f64> nested{{0, 0, 1, 0, 2, 2}, {0, 0, 1, 0, 1, 1}, {9, 9, 1, 0, 1, 1}};
  Scene s{nested, {3, 2, 1}, {}};
  EXPECT_EQ(suppress(s), (Result{0, {0, 1, 2}}));
  s.ratio = VESICA_RATIO_OVER_SMALLER;
  EXPECT_EQ(suppress(s), (Result{0, {0, 2}}));
  s.labels = {{5, 6, 5}};
  EXPECT_EQ(suppress(s), (Result{0, {0, 1, 2}}));
  s.least_score = 2;
  EXPECT_EQ(suppress(s), (Result{0, {0, 1}}));
  s.most = 1;
  EXPECT_EQ(suppress(s), (Result{0, {0}}));
  s.most = 0;
  EXPECT_EQ(suppress(s), (Result{0, {}}));
}

TEST(Suppress, Errors) {
  Scene s{{{0, 0, 1, 0, 2, 2}}, {1}, {}};
  for (const std::int32_t ratio : {-1, VESICA_RATIO_OVER_FIRST, VESICA_RATIO_OVER_SECOND, VESICA_RATIO_COMPLETE + 1}) {
    s.ratio = ratio;
    EXPECT_EQ(suppress(s).code, VESICA_E_ARGUMENT) << ratio;
  }
  s.ratio = VESICA_RATIO_DISTANCE;
  s.least_score = nan;
  EXPECT_EQ(suppress(s).code, VESICA_E_ARGUMENT);
  s.least_score = inf;
  EXPECT_EQ(suppress(s), (Result{0, {}}));
  s.most = -1;
  EXPECT_EQ(suppress(s).code, VESICA_E_ARGUMENT);
}

}  // namespace
}  // namespace suppress_test
