// SPDX-License-Identifier: Apache-2.0
// Suppression of polygons: by its definition, from the ratios of each two.
#include <gtest/gtest.h>
#include <vesica_measures.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "polygon/shapes.hpp"
#include "properties/random.hpp"

namespace polygon_suppress {

using namespace polygons;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Quads about a few places, with scores, one of them bad.
struct Scene {
  int count;
  std::vector<double> xy, scores;
  std::vector<std::int32_t> labels;

  Scene(int n, Random& random) : count(n) {
    for (int i = 0; i < n; ++i) {
      const auto quad = star(4, random.between(0, 6), random.between(0, 6), 1, 0.8, random);
      xy.insert(xy.end(), quad.begin(), quad.end());
      scores.push_back(random.chance(0.2) ? 0.5 : random.between(0.1, 1));
      labels.push_back(random.below(2));
    }
    xy[8 * 3 + 5] = nan;
    scores[5] = nan;
  }
  bool is_bad(int i) const { return i == 3 || i == 5; }
  vesica_shapes_f64 shapes() const {
    vesica_shapes_f64 quads{};
    quads.kind = VESICA_POLYGON;
    quads.count = count;
    quads.stride = 16;
    quads.field[0] = xy.data();
    quads.field[1] = xy.data() + 1;
    quads.each = 4;
    return quads;
  }
  double ratio(std::int32_t which, int i, int j) const {
    const double *const p = xy.data() + 8 * i, *const q = xy.data() + 8 * j;
    const vesica_polygon_f64 a{p, p + 1, 16, nullptr, 4}, b{q, q + 1, 16, nullptr, 4};
    double out = nan;
    EXPECT_EQ(vesica_ratio_f64(which, VESICA_POLYGON, &a, VESICA_POLYGON, &b, &out), 0);
    return out;
  }
};

TEST(PolygonSuppress, Greedy) {
  Random random(170);
  std::size_t kept_in_all = 0, drawn = 0;
  for (int round = 0; round < 20 * properties::repeat(); ++round) {
    const Scene s(random.integer(6, 150), random);
    const double threshold = random.between(0, 0.6);
    const std::int32_t which = random.chance(0.5) ? VESICA_RATIO_OVER_UNION : VESICA_RATIO_OVER_SMALLER;
    std::vector<int> order;
    for (int i = 0; i < s.count; ++i) {
      if (!s.is_bad(i)) order.push_back(i);
    }
    const auto score = [&](int i) { return s.scores[static_cast<std::size_t>(i)]; };
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return score(i) > score(j); });
    std::vector<std::int64_t> expected;
    for (const int i : order) {
      const bool covered = std::any_of(expected.begin(), expected.end(), [&](std::int64_t k) {
        const bool same = s.labels[static_cast<std::size_t>(i)] == s.labels[static_cast<std::size_t>(k)];
        return same && s.ratio(which, i, static_cast<int>(k)) > threshold;
      });
      if (!covered) expected.push_back(i);
    }
    const vesica_shapes_f64 quads = s.shapes();
    std::vector<char> scratch(static_cast<std::size_t>(vesica_nms_scratch(s.count)));
    std::vector<std::int64_t> keep(static_cast<std::size_t>(s.count));
    std::int64_t kept = -1;
    ASSERT_EQ(vesica_suppress_f64(&quads, s.scores.data(), s.labels.data(), which, threshold, 0, s.count,
                                  scratch.data(), static_cast<std::int64_t>(scratch.size()), keep.data(), &kept),
              VESICA_E_SHAPE);
    keep.resize(static_cast<std::size_t>(kept));
    ASSERT_EQ(keep, expected);
    kept_in_all += keep.size();
    drawn += order.size();
  }
  EXPECT_LT(kept_in_all, drawn * 9 / 10);
}

TEST(PolygonSuppress, Soft) {
  Random random(171);
  for (int round = 0; round < 10 * properties::repeat(); ++round) {
    const Scene s(random.integer(6, 60), random);
    std::vector<double> score = s.scores;
    std::vector<int> left;
    for (int i = 0; i < s.count; ++i) {
      if (!s.is_bad(i)) left.push_back(i);
    }
    const auto at = [&](int i) -> double& { return score[static_cast<std::size_t>(i)]; };
    std::vector<std::int64_t> expected;
    std::vector<double> expected_scores;
    while (!left.empty()) {
      const auto best = std::max_element(left.begin(), left.end(), [&](int i, int j) { return at(i) < at(j); });
      const int i = *best;
      left.erase(best);
      expected.push_back(i);
      expected_scores.push_back(at(i));
      for (const int j : left) {
        const double ratio = s.ratio(VESICA_RATIO_OVER_UNION, i, j);
        if (ratio > 0.3) at(j) *= 1 - ratio;
      }
      left.erase(std::remove_if(left.begin(), left.end(), [&](int j) { return at(j) < 0.2; }), left.end());
    }
    // Scores below the least are never kept.
    while (!expected.empty() && expected_scores.back() < 0.2) {
      expected.pop_back();
      expected_scores.pop_back();
    }
    const vesica_shapes_f64 quads = s.shapes();
    std::vector<double> scratch(static_cast<std::size_t>(vesica_suppress_soft_scratch(s.count)) / 8);
    std::vector<std::int64_t> keep(static_cast<std::size_t>(s.count));
    std::vector<double> decayed(static_cast<std::size_t>(s.count));
    std::int64_t kept = -1;
    ASSERT_EQ(vesica_suppress_soft_f64(&quads, s.scores.data(), nullptr, VESICA_RATIO_OVER_UNION, VESICA_DECAY_LINEAR,
                                       0.3, 0.2, s.count, scratch.data(), static_cast<std::int64_t>(scratch.size() * 8),
                                       keep.data(), decayed.data(), &kept),
              VESICA_E_SHAPE);
    keep.resize(static_cast<std::size_t>(kept));
    decayed.resize(static_cast<std::size_t>(kept));
    ASSERT_EQ(keep, expected);
    ASSERT_EQ(decayed, expected_scores);
  }
}

/// Floats, and polygons that lie in records of structs.
TEST(PolygonSuppress, OfStructsOfFloats) {
  const std::vector<float> xy{0, 0, 2, 0, 2, 2, 0, 2, 0, 0, 2, 0, 2, 3, 0, 3, 5, 5, 7, 5, 7, 7, 5, 7};
  std::vector<vesica_polygon_f32> structs;
  for (std::size_t i = 0; i < 3; ++i) structs.push_back({&xy[8 * i], &xy[8 * i + 1], 8, nullptr, 4});
  vesica_shapes_f32 shapes{};
  ASSERT_EQ(vesica_shapes_from_records_f32(VESICA_POLYGON, 3, structs.data(), sizeof structs[0], &shapes), 0);
  const std::vector<float> scores{0.9f, 0.8f, 0.1f};
  std::vector<double> scratch(static_cast<std::size_t>(vesica_nms_scratch(3)) / 8 + 1);
  const auto bytes = static_cast<std::int64_t>(scratch.size() * 8);
  std::vector<std::int64_t> keep(3);
  std::int64_t kept = -1;
  ASSERT_EQ(vesica_nms_f32(&shapes, scores.data(), 0.5f, scratch.data(), bytes, keep.data(), &kept), 0);
  EXPECT_EQ(kept, 2);
  EXPECT_EQ(keep, (std::vector<std::int64_t>{0, 2, 0}));
  std::vector<float> decayed(3);
  ASSERT_EQ(vesica_suppress_soft_f32(&shapes, scores.data(), nullptr, VESICA_RATIO_OVER_UNION, VESICA_DECAY_LINEAR,
                                     0.5f, 0, 3, scratch.data(), bytes, keep.data(), decayed.data(), &kept),
            0);
  EXPECT_EQ(kept, 3);
  EXPECT_FLOAT_EQ(decayed[1], 0.8f / 3);
  // Polylines have no area.
  shapes.kind = VESICA_POLYLINE;
  EXPECT_EQ(vesica_nms_f32(&shapes, scores.data(), 0.5f, scratch.data(), bytes, keep.data(), &kept), VESICA_E_KIND);
}

}  // namespace polygon_suppress
