// SPDX-License-Identifier: Apache-2.0
// Soft suppression: against its definition in the plainest form, known answers, its exponential against MPFR, errors.
#include <gtest/gtest.h>
#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>
#include <vesica/arithmetic/exponential.hpp>

#include "area/real.hpp"
#include "properties/random.hpp"

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Scene {
  std::vector<vesica_rect_f64> shapes;
  std::vector<double> scores;
  std::vector<std::int32_t> labels;
};

Scene draw(int n, properties::Random& random) {
  Scene s;
  for (int i = 0; i < n; ++i) {
    const double angle = random.between(0, 3), size = random.between(0.5, 2);
    s.shapes.push_back(
        {random.between(0, 8), random.between(0, 8), std::cos(angle), std::sin(angle), size, random.between(0.5, 2)});
    s.scores.push_back(random.chance(0.2) ? 0.5 : random.unit());
    s.labels.push_back(random.below(3));
  }
  return s;
}

struct Asked {
  std::int32_t ratio, decay;
  double parameter, least;
  std::int64_t most;
  bool by_label;
};

struct Kept {
  std::int32_t code;
  std::vector<std::int64_t> items;
  std::vector<double> scores;
};

Kept suppress(const Scene& s, const Asked& q) {
  const auto n = static_cast<std::int64_t>(s.shapes.size());
  vesica_shapes_f64 shapes;
  vesica_shapes_from_records_f64(VESICA_RECT, n, s.shapes.data(), sizeof(vesica_rect_f64), &shapes);
  std::vector<double> scratch(static_cast<std::size_t>(vesica_suppress_soft_scratch(n)) / 8 + 1);
  Kept r{0, std::vector<std::int64_t>(s.shapes.size()), std::vector<double>(s.shapes.size())};
  std::int64_t kept = -1;
  r.code = vesica_suppress_soft_f64(
      &shapes, s.scores.data(), q.by_label ? s.labels.data() : nullptr, q.ratio, q.decay, q.parameter, q.least, q.most,
      scratch.data(), static_cast<std::int64_t>(scratch.size() * 8), r.items.data(), r.scores.data(), &kept);
  if (kept < 0) kept = 0;
  r.items.resize(static_cast<std::size_t>(kept));
  r.scores.resize(static_cast<std::size_t>(kept));
  return r;
}

double ratio_of(const Scene& s, const Asked& q, std::size_t i, std::size_t j) {
  double r = 0;
  const std::int32_t code = vesica_ratio_f64(q.ratio, VESICA_RECT, &s.shapes[i].cx, VESICA_RECT, &s.shapes[j].cx, &r);
  return code == 0 ? r : 0;
}

/// As the comment in vesica_measures.h says it.
Kept by_definition(const Scene& s, const Asked& q) {
  Kept r{0, {}, {}};
  std::vector<double> score = s.scores;
  while (static_cast<std::int64_t>(r.items.size()) < q.most) {
    const auto best = static_cast<std::size_t>(std::max_element(score.begin(), score.end()) - score.begin());
    if (score.empty() || !(score[best] >= q.least) || score[best] == -infinity) break;
    r.items.push_back(static_cast<std::int64_t>(best));
    r.scores.push_back(score[best]);
    score[best] = -infinity;
    for (std::size_t i = 0; i < score.size(); ++i) {
      if (score[i] == -infinity || (q.by_label && s.labels[i] != s.labels[best])) continue;
      const double ratio = ratio_of(s, q, best, i);
      if (q.decay == VESICA_DECAY_LINEAR)
        score[i] *= ratio > q.parameter ? 1 - ratio : 1;
      else if (ratio > 0)
        score[i] *= static_cast<double>(std::exp(-static_cast<long double>(ratio) * static_cast<long double>(ratio) /
                                                 static_cast<long double>(q.parameter)));
      if (score[i] < q.least) score[i] = -infinity;
    }
  }
  return r;
}

TEST(SoftSuppression, IsItsDefinition) {
  properties::Random random(properties::seed());
  int decayed = 0;
  for (int round = 0; round < 60 * properties::repeat(); ++round) {
    const Scene s = draw(random.below(round % 10 == 0 ? 700 : 60), random);
    for (const std::int32_t ratio :
         {VESICA_RATIO_OVER_UNION, VESICA_RATIO_OVER_SMALLER, VESICA_RATIO_GENERALIZED, VESICA_RATIO_COMPLETE}) {
      const bool linear = random.chance(0.5);
      const Asked q{ratio,
                    linear ? VESICA_DECAY_LINEAR : VESICA_DECAY_GAUSSIAN,
                    linear ? random.between(0, 0.6) : random.between(0.1, 1),
                    random.chance(0.5) ? 0.0 : 0.2,
                    random.chance(0.5) ? 1000 : 5,
                    random.chance(0.5)};
      const Kept found = suppress(s, q), right = by_definition(s, q);
      ASSERT_EQ(found.code, 0);
      ASSERT_EQ(found.items, right.items) << "ratio " << ratio;
      for (std::size_t i = 0; i < found.scores.size(); ++i) {
        // The reference's exponential may be rounded to the number beside it, in each turn.
        if (linear)
          EXPECT_EQ(found.scores[i], right.scores[i]);
        else
          EXPECT_NEAR(found.scores[i], right.scores[i], 1e-13 * right.scores[i]);
        decayed += found.scores[i] < s.scores[static_cast<std::size_t>(found.items[i])];
      }
    }
  }
  EXPECT_GT(decayed, 1000);
}

TEST(SoftSuppression, KnownAnswers) {
  // The second shares half of the first's area: IoU 1/3. The third shares nothing.
  const Scene s{{{0, 0, 1, 0, 1, 1}, {1, 0, 1, 0, 1, 1}, {9, 0, 1, 0, 1, 1}}, {0.9, 0.6, 0.5}, {1, 1, 1}};
  const double third = ratio_of(s, {VESICA_RATIO_OVER_UNION, 0, 0, 0, 0, false}, 0, 1);
  Kept r = suppress(s, {VESICA_RATIO_OVER_UNION, VESICA_DECAY_LINEAR, 0.3, 0, 9, true});
  EXPECT_EQ(r.items, (std::vector<std::int64_t>{0, 2, 1}));
  EXPECT_EQ(r.scores, (std::vector<double>{0.9, 0.5, 0.6 * (1 - third)}));
  r = suppress(s, {VESICA_RATIO_OVER_UNION, VESICA_DECAY_LINEAR, 0.34, 0, 9, true});
  EXPECT_EQ(r.items, (std::vector<std::int64_t>{0, 1, 2}));
  EXPECT_EQ(r.scores, s.scores);
  r = suppress(s, {VESICA_RATIO_OVER_UNION, VESICA_DECAY_LINEAR, 0.3, 0.45, 9, true});
  EXPECT_EQ(r.items, (std::vector<std::int64_t>{0, 2}));
  r = suppress(s, {VESICA_RATIO_OVER_UNION, VESICA_DECAY_LINEAR, 0.3, 0, 1, true});
  EXPECT_EQ(r.items, (std::vector<std::int64_t>{0}));
  r = suppress(s, {VESICA_RATIO_OVER_UNION, VESICA_DECAY_GAUSSIAN, 0.5, 0, 9, false});
  EXPECT_EQ(r.items, (std::vector<std::int64_t>{0, 2, 1}));
  EXPECT_NEAR(r.scores[2], 0.6 * std::exp(-third * third / 0.5), 1e-15);
}

/// With the smallest parameters nothing is left of a score.
TEST(SoftSuppression, NothingIsLeft) {
  const Scene s{{{0, 0, 1, 0, 1, 1}, {0, 0, 1, 0, 1, 1}, {9, 0, 1, 0, 1, 1}}, {0.9, 0.6, 0.5}, {1, 1, 1}};
  for (const double parameter : {0x1p-100, 0x1p-20, 0.001 / 1.001}) {
    const Kept r = suppress(s, {VESICA_RATIO_OVER_UNION, VESICA_DECAY_GAUSSIAN, parameter, 0, 9, false});
    EXPECT_EQ(r.items, (std::vector<std::int64_t>{0, 2, 1}));
    EXPECT_EQ(r.scores, (std::vector<double>{0.9, 0.5, 0}));
  }
}

/// Discs have fewer numbers than rectangles: a rectangle's other columns are never read.
TEST(SoftSuppression, OfDiscs) {
  const double discs[3][3] = {{0, 0, 1}, {1, 0, 1}, {9, 0, 1}}, scores[3] = {0.9, 0.6, 0.5};
  vesica_shapes_f64 shapes;
  vesica_shapes_from_records_f64(VESICA_CIRCLE, 3, discs, sizeof discs[0], &shapes);
  double iou, scratch[64], decayed[3];
  ASSERT_EQ(vesica_iou_f64(VESICA_CIRCLE, discs[0], VESICA_CIRCLE, discs[1], &iou), 0);
  ASSERT_LE(vesica_suppress_soft_scratch(3), std::int64_t{sizeof scratch});
  std::int64_t keep[3], kept;
  ASSERT_EQ(vesica_suppress_soft_f64(&shapes, scores, nullptr, VESICA_RATIO_OVER_UNION, VESICA_DECAY_LINEAR, 0, 0, 9,
                                     scratch, sizeof scratch, keep, decayed, &kept),
            0);
  ASSERT_EQ(kept, 3);
  EXPECT_TRUE(keep[0] == 0 && keep[1] == 2 && keep[2] == 1);
  EXPECT_TRUE(decayed[0] == 0.9 && decayed[1] == 0.5 && decayed[2] == 0.6 * (1 - iou));
}

TEST(SoftSuppression, WhatIsInvalidIsLeftOut) {
  Scene s{{{0, 0, 1, 0, 1, 1}, {0, 0, 0, 0, 1, 1}, {0, 0, 1, 0, 1, 1}, {5, 5, 1, 0, 1, 1}}, {0.9, 0.8, nan, 0.3}, {}};
  const Kept r = suppress(s, {VESICA_RATIO_OVER_UNION, VESICA_DECAY_LINEAR, 0.5, 0, 9, false});
  EXPECT_EQ(r.code, VESICA_E_SHAPE);
  EXPECT_EQ(r.items, (std::vector<std::int64_t>{0, 3}));
}

TEST(SoftSuppression, Errors) {
  const Scene s{{{0, 0, 1, 0, 1, 1}}, {0.9}, {1}};
  const auto code = [&](const Asked& q) { return suppress(s, q).code; };
  const std::int32_t iou = VESICA_RATIO_OVER_UNION, linear = VESICA_DECAY_LINEAR, gaussian = VESICA_DECAY_GAUSSIAN;
  EXPECT_EQ(code({iou, linear, 0.5, 0, 9, false}), 0);
  EXPECT_EQ(code({VESICA_RATIO_OVER_FIRST, linear, 0.5, 0, 9, false}), VESICA_E_ARGUMENT);
  EXPECT_EQ(code({7, linear, 0.5, 0, 9, false}), VESICA_E_ARGUMENT);
  EXPECT_EQ(code({iou, 2, 0.5, 0, 9, false}), VESICA_E_ARGUMENT);
  EXPECT_EQ(code({iou, linear, 1.5, 0, 9, false}), VESICA_E_ARGUMENT);
  EXPECT_EQ(code({iou, linear, nan, 0, 9, false}), VESICA_E_ARGUMENT);
  EXPECT_EQ(code({iou, linear, 1, 0, 9, false}), 0);
  EXPECT_EQ(code({iou, linear, std::nextafter(1.0, 2.0), 0, 9, false}), VESICA_E_ARGUMENT);
  EXPECT_EQ(code({iou, gaussian, 0x1p-100, 0, 9, false}), 0);
  EXPECT_EQ(code({iou, gaussian, std::nextafter(0x1p-100, 0.0), 0, 9, false}), VESICA_E_ARGUMENT);
  EXPECT_EQ(code({iou, gaussian, 0, 0, 9, false}), VESICA_E_ARGUMENT);
  EXPECT_EQ(code({iou, gaussian, infinity, 0, 9, false}), VESICA_E_ARGUMENT);
  EXPECT_EQ(code({iou, gaussian, 1, -0.1, 9, false}), VESICA_E_ARGUMENT);
  EXPECT_EQ(code({iou, gaussian, 1, nan, 9, false}), VESICA_E_ARGUMENT);
  EXPECT_EQ(code({iou, gaussian, 1, 0, -1, false}), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_suppress_soft_scratch(-1), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_suppress_soft_scratch(std::int64_t{1} << 31), VESICA_E_ARGUMENT);
  vesica_shapes_f64 shapes;
  vesica_shapes_from_records_f64(VESICA_POINT, 1, s.shapes.data(), sizeof(vesica_rect_f64), &shapes);
  double scratch[9], decayed = 7;
  std::int64_t keep = 7, kept = 7;
  const auto ask = [&](const vesica_shapes_f64* of, std::int64_t size, double* scores_out) {
    return vesica_suppress_soft_f64(of, s.scores.data(), nullptr, iou, linear, 0.5, 0, 9, scratch, size, &keep,
                                    scores_out, &kept);
  };
  EXPECT_EQ(ask(&shapes, sizeof scratch, &decayed), VESICA_E_KIND);
  shapes.kind = VESICA_RECT;
  EXPECT_EQ(ask(nullptr, sizeof scratch, &decayed), VESICA_E_NULL);
  vesica_shapes_from_records_f64(VESICA_RECT, 1, s.shapes.data(), sizeof(vesica_rect_f64), &shapes);
  EXPECT_EQ(ask(&shapes, sizeof scratch, nullptr), VESICA_E_NULL);
  EXPECT_EQ(ask(&shapes, 8, &decayed), VESICA_E_ARGUMENT);
  EXPECT_EQ(kept, 7);
  EXPECT_EQ(ask(&shapes, sizeof scratch, &decayed), 0);
  EXPECT_EQ(kept, 1);
  shapes.count = 0;
  EXPECT_EQ(ask(&shapes, 0, nullptr), 0);
  EXPECT_EQ(kept, 0);
}

/// Infinite scores times 0 are 0, and so are kept where that is enough.
TEST(SoftSuppression, InfiniteScores) {
  const vesica_rect_f64 one{0, 0, 1, 0, 1, 1}, apart{9, 9, 1, 0, 1, 1};
  const Scene s{{one, one, apart, one}, {infinity, infinity, infinity, 1}, {}};
  for (const std::int32_t decay : {VESICA_DECAY_LINEAR, VESICA_DECAY_GAUSSIAN}) {
    // A Gaussian so narrow that nothing is left of a score.
    const Kept all = suppress(s, {VESICA_RATIO_OVER_UNION, decay, 0.001, 0, 9, false});
    EXPECT_EQ(all.items, (std::vector<std::int64_t>{0, 2, 1, 3}));
    EXPECT_EQ(all.scores, (std::vector<double>{infinity, infinity, 0, 0}));
    const Kept some = suppress(s, {VESICA_RATIO_OVER_UNION, decay, 0.001, 1e-300, 9, false});
    EXPECT_EQ(some.items, (std::vector<std::int64_t>{0, 2}));
  }
}

TEST(SoftSuppression, FloatsAreWidened) {
  const std::vector<vesica_rect_f32> shapes{{0, 0, 1, 0, 1, 1}, {1, 0, 1, 0, 1, 1}};
  const std::vector<vesica_rect_f64> wide{{0, 0, 1, 0, 1, 1}, {1, 0, 1, 0, 1, 1}};
  const float scores[] = {0.9f, 0.6f};
  const Scene s{wide, {static_cast<double>(scores[0]), static_cast<double>(scores[1])}, {}};
  vesica_shapes_f32 view;
  vesica_shapes_from_records_f32(VESICA_RECT, 2, shapes.data(), sizeof shapes[0], &view);
  double scratch[18];
  std::int64_t keep[2], kept = 0;
  float decayed[2];
  EXPECT_EQ(vesica_suppress_soft_f32(&view, scores, nullptr, VESICA_RATIO_OVER_UNION, VESICA_DECAY_GAUSSIAN, 0.5f, 0, 9,
                                     scratch, sizeof scratch, keep, decayed, &kept),
            0);
  const Kept right = suppress(s, {VESICA_RATIO_OVER_UNION, VESICA_DECAY_GAUSSIAN, 0.5, 0, 9, false});
  ASSERT_EQ(kept, 2);
  EXPECT_EQ(decayed[1], static_cast<float>(right.scores[1]));
}

/// To one unit in the last place, over all of its range.
TEST(SoftSuppression, Exponential) {
  using reference::Real;
  properties::Random random(properties::seed() + 5);
  double worst = 0;
  for (int i = 0; i < 200000 * properties::repeat(); ++i) {
    const double high = random.chance(0.5) ? random.between(0, 3) : random.between(0, 700);
    const double low = (random.unit() - 0.5) * 0x1p-53 * high;
    const double value = vesica::detail::arithmetic::exp_of_minus(high, low);
    const Real exact = exp(-(Real(high) + Real(low)));
    const double rounded = static_cast<double>(exact), unit = std::nextafter(rounded, 2) - rounded;
    worst = std::max(worst, std::fabs(static_cast<double>(Real(value) - exact)) / unit);
  }
  EXPECT_LE(worst, 1);
  EXPECT_GT(worst, 0.4);
  RecordProperty("worst", std::to_string(worst));
  std::printf("exp: %.3f units in the last place\n", worst);
  EXPECT_EQ(vesica::detail::arithmetic::exp_of_minus(0, 0), 1);
  EXPECT_EQ(vesica::detail::arithmetic::exp_of_minus(1000, 0), 0);
  EXPECT_EQ(vesica::detail::arithmetic::exp_of_minus(infinity, 0), 0);
}

}  // namespace
