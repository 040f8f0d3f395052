// SPDX-License-Identifier: Apache-2.0
// Fusion of boxes: known answers; boxes against rational arithmetic; rectangles against the nearest corners, in long
// double; floats against doubles, bit for bit; errors.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <vesica_detection.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "properties/random.hpp"

namespace fuse_test {

using Numbers = std::vector<std::int64_t>;
using properties::Random;

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
constexpr double u = 0x1p-53;

struct Scene {
  std::int32_t kind = VESICA_AABB;
  std::vector<double> numbers, scores, weights;
  std::vector<std::int32_t> labels;
  double threshold = 0.5;
  std::int32_t fused_score = VESICA_FUSED_MEAN;

  std::size_t fields() const { return kind == VESICA_AABB ? 4 : 6; }
  std::size_t count() const { return numbers.size() / fields(); }
  const double* box(std::size_t i) const { return &numbers[i * fields()]; }
  double weight(std::size_t i) const { return weights.empty() ? 1 : weights[i]; }
  std::int32_t label(std::size_t i) const { return labels.empty() ? 0 : labels[i]; }
};

struct Fused {
  std::int32_t code;
  std::vector<double> shapes, scores;
  Numbers clusters;
  bool operator==(const Fused&) const = default;
};

template <class T, class Shapes, class FromRecords, class Fuse>
Fused run(const Scene& s, FromRecords from_records, Fuse fuse) {
  const std::vector<T> numbers(s.numbers.begin(), s.numbers.end()), scores(s.scores.begin(), s.scores.end()),
      weights(s.weights.begin(), s.weights.end());
  const auto n = static_cast<std::int64_t>(s.count());
  Shapes shapes;
  EXPECT_EQ(from_records(s.kind, n, numbers.data(), static_cast<std::ptrdiff_t>(s.fields() * sizeof(T)), &shapes), 0);
  const std::int64_t bytes = vesica_fuse_scratch(n);
  std::vector<std::uint64_t> scratch(static_cast<std::size_t>(bytes) / 8 + 1, ~std::uint64_t{0});
  std::vector<T> fused(numbers.size() + 1, -7), fused_scores(s.count() + 1, -7);
  Fused out{0, {}, {}, Numbers(s.count(), -7)};
  std::int64_t count = -7;
  out.code = fuse(&shapes, scores.data(), weights.empty() ? nullptr : weights.data(),
                  s.labels.empty() ? nullptr : s.labels.data(), static_cast<T>(s.threshold), s.fused_score,
                  scratch.data(), bytes, fused.data(), fused_scores.data(), out.clusters.data(), &count);
  EXPECT_EQ(scratch.back(), ~std::uint64_t{0});
  EXPECT_GE(count, 0);
  const auto clusters = static_cast<std::size_t>(count);
  for (std::size_t i = clusters * s.fields(); i < fused.size(); ++i) EXPECT_EQ(fused[i], -7);
  for (std::size_t i = clusters; i < fused_scores.size(); ++i) EXPECT_EQ(fused_scores[i], -7);
  out.shapes.assign(fused.begin(), fused.begin() + static_cast<std::ptrdiff_t>(clusters * s.fields()));
  out.scores.assign(fused_scores.begin(), fused_scores.begin() + static_cast<std::ptrdiff_t>(clusters));
  return out;
}
inline Fused fuse(const Scene& s) {
  return run<double, vesica_shapes_f64>(s, vesica_shapes_from_records_f64, vesica_fuse_f64);
}
inline Fused fuse_floats(const Scene& s) {
  return run<float, vesica_shapes_f32>(s, vesica_shapes_from_records_f32, vesica_fuse_f32);
}

inline void expect_near(const std::vector<double>& found, const std::vector<double>& expected, double error) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], error) << i;
}

/// IoU of the first two is 81 / 119. Weights 3 : 2 of scores 0.6 and 0.4; the third is apart.
TEST(Fuse, WeightedMean) {
  Scene s{
      .numbers = {1, 1, 11, 11, 0, 0, 10, 10, 30, 0, 40, 10}, .scores = {0.4, 0.6, 0.5}, .weights = {}, .labels = {}};
  Fused f = fuse(s);
  EXPECT_EQ(f.code, 0);
  EXPECT_EQ(f.clusters, (Numbers{0, 0, 1}));
  expect_near(f.shapes, {0.4, 0.4, 10.4, 10.4, 30, 0, 40, 10}, 1e-15);
  expect_near(f.scores, {0.5, 0.5}, 1e-15);
  s.fused_score = VESICA_FUSED_MAX;
  expect_near(fuse(s).scores, {0.6, 0.5}, 0);
  s.fused_score = VESICA_FUSED_MEAN;
  // Weights 1, 3, 1: strengths 0.4 and 1.8; the score is (0.4 + 3 * 0.6) / 4.
  s.weights = {1, 3, 1};
  f = fuse(s);
  expect_near(f.shapes, {4.0 / 22, 4.0 / 22, 10 + 4.0 / 22, 10 + 4.0 / 22, 30, 0, 40, 10}, 1e-15);
  expect_near(f.scores, {0.55, 0.5}, 1e-15);
}

/// The second has IoU 1/2 exactly with the first: not above the threshold.
TEST(Fuse, TheThresholdItselfDoesNotFuse) {
  Scene s{.numbers = {0, 0, 2, 2, 0, 0, 2, 1}, .scores = {2, 1}, .weights = {}, .labels = {}};
  EXPECT_EQ(fuse(s).clusters, (Numbers{0, 1}));
  s.threshold = std::nextafter(0.5, 0);
  EXPECT_EQ(fuse(s).clusters, (Numbers{0, 0}));
  s.threshold = 1;
  s.numbers = {0, 0, 2, 2, 0, 0, 2, 2};
  EXPECT_EQ(fuse(s).clusters, (Numbers{0, 1}));
  // Boxes that touch, and boxes without area, share nothing.
  s = {
      .numbers = {0, 0, 1, 1, 1, 0, 2, 1, 3, 3, 3, 3, 3, 3, 3, 3}, .scores = {4, 3, 2, 1}, .weights = {}, .labels = {}};
  s.threshold = 0;
  EXPECT_EQ(fuse(s).clusters, (Numbers{0, 1, 2, 3}));
}

TEST(Fuse, LabelsAreApart) {
  const Scene s{
      .numbers = {0, 0, 2, 2, 0, 0, 2, 2, 0, 0, 2, 2}, .scores = {1, 3, 2}, .weights = {}, .labels = {7, -1, 7}};
  const Fused f = fuse(s);
  EXPECT_EQ(f.clusters, (Numbers{1, 0, 1}));
  expect_near(f.scores, {3, 1.5}, 1e-15);
}

/// The mean has moved to [1/2, 5/2] when the third is asked, whose IoU with it is 3/5, and with the first box 1/3.
TEST(Fuse, TheRunningMeanDecides) {
  const Scene s{.numbers = {0, 0, 2, 1, 1, 0, 3, 1, 1, 0, 3, 1},
                .scores = {1, 1, 1},
                .weights = {},
                .labels = {},
                .threshold = 0.32};
  const Fused f = fuse(s);
  EXPECT_EQ(f.clusters, (Numbers{0, 0, 0}));
  expect_near(f.shapes, {2.0 / 3, 0, 2 + 2.0 / 3, 1}, 1e-15);
  Scene apart = s;
  apart.threshold = 0.34;
  EXPECT_EQ(fuse(apart).clusters, (Numbers{0, 1, 1}));
}

/// Equally strong boxes go by number, and of clusters with equal IoU the first is joined.
TEST(Fuse, Ties) {
  Scene s{.numbers = {0, 0, 2, 1, 2, 0, 4, 1, 1, 0, 3, 1},
          .scores = {1, 1, 1},
          .weights = {},
          .labels = {},
          .threshold = 0.2};
  EXPECT_EQ(fuse(s).clusters, (Numbers{0, 1, 0}));
  s.scores = {0, 0, 0};
  const Fused f = fuse(s);
  EXPECT_EQ(f.clusters, (Numbers{0, 1, 0}));
  // Nothing counts: the first remains.
  expect_near(f.shapes, {0, 0, 2, 1, 2, 0, 4, 1}, 0);
  s.scores = {1, 2, 3};
  s.weights = {0, 0, 0};
  EXPECT_EQ(fuse(s).clusters, (Numbers{0, 1, 0}));
  expect_near(fuse(s).scores, {1, 2}, 0);
}

TEST(Fuse, OneBoxKeepsItsBits) {
  const Scene s{
      .kind = VESICA_RECT, .numbers = {0.1, 0.2, 3, 0.7, 0.3, 0.9}, .scores = {0.3}, .weights = {0.1}, .labels = {}};
  EXPECT_EQ(fuse(s), (Fused{0, s.numbers, s.scores, {0}}));
}

TEST(Fuse, UnfitBoxesAreLeftOut) {
  Scene s{.numbers = {},
          .scores = {1, nan, -1, inf, 1, 1, 1, 1, 2},
          .weights = {1, 1, 1, 1, nan, -1, 1, 1, 1},
          .labels = {}};
  for (std::size_t i = 0; i < s.scores.size(); ++i) s.numbers.insert(s.numbers.end(), {0, 0, 1, 1});
  s.numbers[6 * 4] = 2;  // min above max
  s.numbers[7 * 4 + 3] = 0x1p1021;
  const Fused f = fuse(s);
  EXPECT_EQ(f.code, VESICA_E_SHAPE);
  EXPECT_EQ(f.clusters, (Numbers{0, -1, -1, -1, -1, -1, -1, -1, 0}));
  expect_near(f.scores, {1.5}, 0);
  EXPECT_EQ(fuse({.numbers = {2, 0, 1, 1}, .scores = {1}, .weights = {}, .labels = {}}),
            (Fused{VESICA_E_SHAPE, {}, {}, {-1}}));
}

// ---- Rectangles. ----

struct Direction {
  double x, y;
};
inline Direction direction(double degrees) {
  const double a = degrees * (3.14159265358979323846 / 180);
  return {std::cos(a), std::sin(a)};
}
inline void add_rect(Scene& s, double cx, double cy, double degrees, double hx, double hy, double score,
                     double length = 1) {
  const Direction d = direction(degrees);
  s.numbers.insert(s.numbers.end(), {cx, cy, length * d.x, length * d.y, hx / length, hy / length});
  s.scores.push_back(score);
}

inline void expect_rect(const double* found, double cx, double cy, double degrees, double hx, double hy, double error) {
  const Direction d = direction(degrees);
  const double expected[] = {cx, cy, d.x, d.y, hx, hy};
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(found[k], expected[k], error) << k;
}

TEST(FuseRects, DirectionsAreAveraged) {
  Scene s{.kind = VESICA_RECT, .numbers = {}, .scores = {}, .weights = {}, .labels = {}, .threshold = 0.3};
  add_rect(s, 0, 0, 10, 10, 2, 0.5);
  add_rect(s, 0, 0, -10, 10, 2, 0.5);
  Fused f = fuse(s);
  EXPECT_EQ(f.clusters, (Numbers{0, 0}));
  expect_rect(f.shapes.data(), 0, 0, 0, 10, 2, 1e-15);
  // The second written in its other three forms, with a longer axis.
  for (const int quarter : {1, 2, 3}) {
    Scene turned{.kind = VESICA_RECT, .numbers = {}, .scores = {}, .weights = {}, .labels = {}, .threshold = 0.3};
    add_rect(turned, 0, 0, 10, 10, 2, 0.5);
    add_rect(turned, 0, 0, -10 + 90 * quarter, quarter % 2 == 0 ? 10 : 2, quarter % 2 == 0 ? 2 : 10, 0.5, 3);
    f = fuse(turned);
    EXPECT_EQ(f.clusters, (Numbers{0, 0}));
    expect_rect(f.shapes.data(), 0, 0, 0, 10, 2, 1e-14);
  }
}

/// A square turned by 80 degrees is one turned by -10. A long rectangle turned by 50 degrees is not one by -40.
TEST(FuseRects, TheNearestCornersSayWhichForm) {
  Scene s{.kind = VESICA_RECT, .numbers = {}, .scores = {}, .weights = {}, .labels = {}, .threshold = 0.1};
  add_rect(s, 0, 0, 0, 1, 1, 1);
  add_rect(s, 1, 0, 80, 1.5, 1, 1);
  expect_rect(fuse(s).shapes.data(), 0.5, 0, -5, 1, 1.25, 1e-15);
  s.numbers.clear();
  s.scores.clear();
  add_rect(s, 0, 0, 0, 4, 1, 1);
  add_rect(s, 0, 0, 50, 4, 1, 1);
  expect_rect(fuse(s).shapes.data(), 0, 0, 25, 4, 1, 1e-15);
}

// ---- Random boxes. ----

/// Boxes in groups, with jitter; numbers that floats have too, so that both functions get the same. Scales are powers
/// of two up to 2^scales: means of large boxes then wander far, in the small ones' units.
inline Scene draw(std::int32_t kind, std::size_t count, Random& random, int scales = 0) {
  Scene s{.kind = kind, .numbers = {}, .scores = {}, .weights = {}, .labels = {}};
  const auto as_float = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  const double side = std::sqrt(static_cast<double>(count)), jitter = random.between(0.02, 0.4);
  for (std::size_t i = 0; i < count; ++i) {
    const double scale = std::exp2(random.below(scales + 1)),
                 x = 1.5 * random.below(static_cast<int>(side)) + jitter * scale * random.between(-1, 1),
                 y = 1.5 * random.below(static_cast<int>(side)) + jitter * scale * random.between(-1, 1),
                 a = scale * (1 + jitter * random.between(-1, 1)), b = scale * (0.5 + jitter * random.between(-1, 1)),
                 degrees = 90 * random.below(4) + 100 * jitter * random.between(-1, 1);
    const Direction d = direction(degrees);
    if (kind == VESICA_AABB) {
      for (const double z : {x - a, y - b, x + a, y + b}) s.numbers.push_back(as_float(z));
    } else {
      const double length = random.chance(0.5) ? 1 : random.between(0.1, 10);
      for (const double z : {x, y, length * d.x, length * d.y, a / length, b / length})
        s.numbers.push_back(as_float(z));
    }
    s.scores.push_back(random.chance(0.1) ? random.below(3) / 2.0 : as_float(random.unit()));
    s.weights.push_back(random.chance(0.1) ? 0 : random.integer(1, 3));
    s.labels.push_back(random.below(3));
  }
  if (random.chance(0.5)) s.weights.clear();
  if (random.chance(0.5)) s.labels.clear();
  s.threshold = as_float(random.between(scales == 0 ? 0.2 : 0.02, 0.8));
  s.fused_score = random.chance(0.5) ? VESICA_FUSED_MEAN : VESICA_FUSED_MAX;
  return s;
}

inline std::vector<std::size_t> by_strength(const Scene& s) {
  std::vector<std::size_t> order(s.count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return s.scores[i] * s.weight(i) > s.scores[j] * s.weight(j); });
  return order;
}

using Box = std::array<mpq_class, 4>;

inline mpq_class area(const Box& b) { return (b[2] - b[0]) * (b[3] - b[1]); }

inline mpq_class iou(const Box& a, const Box& b) {
  const mpq_class x = std::min(a[2], b[2]) - std::max(a[0], b[0]), y = std::min(a[3], b[3]) - std::max(a[1], b[1]);
  if (x <= 0 || y <= 0) return 0;
  const mpq_class shared = x * y;
  return shared / (area(a) + area(b) - shared);
}

/// The weighted mean of members' numbers.
template <class Member>
mpq_class weighted_mean(const Scene& s, const std::vector<std::size_t>& members, const Member& member) {
  mpq_class sum = 0, all = 0;
  for (const std::size_t i : members) {
    const mpq_class p = mpq_class(s.scores[i]) * s.weight(i);
    sum += p * member(i);
    all += p;
  }
  return all == 0 ? mpq_class(member(members[0])) : mpq_class(sum / all);
}

inline mpq_class score_of(const Scene& s, const std::vector<std::size_t>& members) {
  mpq_class sum = 0, all = 0, highest = 0;
  for (const std::size_t i : members) {
    sum += mpq_class(s.scores[i]) * s.weight(i);
    all += s.weight(i);
    highest = std::max(highest, mpq_class(s.scores[i]));
  }
  if (s.fused_score == VESICA_FUSED_MAX) return highest;
  return all == 0 ? mpq_class(s.scores[members[0]]) : mpq_class(sum / all);
}

TEST(FuseRandom, BoxesInRationalNumbers) {
  Random random(properties::seed());
  std::size_t fused = 0, rounds = 0;
  for (int round = 0; round < 40; ++round) {
    const Scene s = draw(VESICA_AABB, 60, random, round % 2 == 0 ? 0 : 6);
    std::vector<std::vector<std::size_t>> clusters;
    std::vector<Box> means;
    Numbers cluster(s.count(), -1);
    bool open = false;
    for (const std::size_t i : by_strength(s)) {
      const Box box{s.box(i)[0], s.box(i)[1], s.box(i)[2], s.box(i)[3]};
      std::size_t best = clusters.size();
      mpq_class highest = s.threshold;
      for (std::size_t c = 0; c < clusters.size(); ++c) {
        if (s.label(clusters[c][0]) != s.label(i)) continue;
        const mpq_class ratio = iou(means[c], box);
        // Rounded numbers need not decide the same.
        open |= abs(ratio - highest) < 1e-12 && ratio != 0;
        if (ratio > highest) highest = ratio, best = c;
      }
      if (best == clusters.size()) clusters.emplace_back(), means.emplace_back();
      clusters[best].push_back(i);
      cluster[i] = static_cast<std::int64_t>(best);
      for (std::size_t k = 0; k < 4; ++k) {
        means[best][k] = weighted_mean(s, clusters[best], [&](std::size_t m) { return mpq_class(s.box(m)[k]); });
      }
    }
    if (open) continue;
    ++rounds;
    const Fused f = fuse(s);
    ASSERT_EQ(f.clusters, cluster) << "seed " << properties::seed();
    ASSERT_EQ(f.scores.size(), clusters.size());
    for (std::size_t c = 0; c < clusters.size(); ++c) {
      const auto n = static_cast<double>(clusters[c].size());
      fused += clusters[c].size() - 1;
      const mpq_class score = score_of(s, clusters[c]);
      EXPECT_LE(std::fabs(mpq_class(score - f.scores[c]).get_d()), 4 * u * n);
      for (std::size_t k = 0; k < 4; ++k) {
        double spread = 0;
        for (const std::size_t i : clusters[c])
          spread = std::max(spread, std::fabs(s.box(i)[k] - s.box(clusters[c][0])[k]));
        const double x = f.shapes[4 * c + k];
        EXPECT_LE(std::fabs(mpq_class(means[c][k] - x).get_d()), 4 * u * (n * spread + std::fabs(x)));
      }
    }
  }
  EXPECT_GT(rounds, 20U);
  EXPECT_GT(fused, 200U);
}

// ---- Random rectangles, in long double. ----

struct Wide {
  long double cx, cy, x, y, a, b;
};

inline Wide wide(const double* r) {
  const long double length = std::hypot(static_cast<long double>(r[2]), static_cast<long double>(r[3]));
  return {r[0], r[1], r[2] / length, r[3] / length, r[4] * length, r[5] * length};
}

/// The same rectangle, turned by some quarters.
inline Wide turned(Wide r, int quarters) {
  for (; quarters > 0; --quarters) r = {r.cx, r.cy, -r.y, r.x, r.b, r.a};
  return r;
}

/// The sum of squared distances of corners, both about one centre.
inline long double distance_of_corners(const Wide& p, const Wide& q) {
  long double sum = 0;
  for (const int i : {-1, 1}) {
    for (const int j : {-1, 1}) {
      const long double x = i * (p.a * p.x - q.a * q.x) - j * (p.b * p.y - q.b * q.y);
      const long double y = i * (p.a * p.y - q.a * q.y) + j * (p.b * p.x - q.b * q.x);
      sum += x * x + y * y;
    }
  }
  return sum;
}

struct RectCluster {
  std::vector<std::size_t> members;
  std::vector<Wide> forms;
  std::array<double, 6> mean;
};

/// Returns the mean; sets `open` where two forms of a member are equally near.
inline std::array<double, 6> mean_of(const Scene& s, RectCluster& c, bool& open) {
  const Wide first = wide(s.box(c.members[0]));
  const auto at = [&](std::size_t i) { return s.box(c.members[i]); };
  const auto counts = [&](std::size_t i) { return s.scores[i] * s.weight(i) > 0; };
  // Members that do not count leave the first as it is.
  if (std::none_of(c.members.begin() + 1, c.members.end(), counts))
    return {at(0)[0], at(0)[1], at(0)[2], at(0)[3], at(0)[4], at(0)[5]};
  long double sum[6] = {}, all = 0;
  for (const std::size_t i : c.members) {
    const Wide r = wide(s.box(i));
    long double least = std::numeric_limits<long double>::infinity(), second = least;
    Wide form{};
    for (int quarters = 0; quarters < 4; ++quarters) {
      const long double d = distance_of_corners(turned(r, quarters), first);
      if (d < least) {
        second = least;
        least = d;
        form = turned(r, quarters);
      } else {
        second = std::min(second, d);
      }
    }
    open |= second - least < 1e-9L;
    const long double p = static_cast<long double>(s.scores[i]) * s.weight(i);
    const long double part[] = {form.cx, form.cy, form.x, form.y, form.a, form.b};
    for (int k = 0; k < 6; ++k) sum[k] += p * part[k];
    all += p;
  }
  const long double length = std::hypot(sum[2], sum[3]);
  std::array<double, 6> mean;
  for (std::size_t k = 0; k < 6; ++k) mean[k] = static_cast<double>(sum[k] / (k == 2 || k == 3 ? length : all));
  return mean;
}

inline double iou_of(const std::array<double, 6>& mean, const double* rect) {
  double ratio = 0;
  return vesica_iou_f64(VESICA_RECT, mean.data(), VESICA_RECT, rect, &ratio) == 0 ? ratio : 0;
}

TEST(FuseRandom, RectsByTheirNearestCorners) {
  Random random(properties::seed());
  std::size_t fused = 0, rounds = 0;
  for (int round = 0; round < 60; ++round) {
    const Scene s = draw(VESICA_RECT, 80, random, round % 2 == 0 ? 0 : 6);
    std::vector<RectCluster> clusters;
    Numbers cluster(s.count(), -1);
    bool open = false;
    for (const std::size_t i : by_strength(s)) {
      std::size_t best = clusters.size();
      double highest = s.threshold;
      for (std::size_t c = 0; c < clusters.size(); ++c) {
        if (s.label(clusters[c].members[0]) != s.label(i)) continue;
        const double ratio = iou_of(clusters[c].mean, s.box(i));
        open |= std::fabs(ratio - highest) < 1e-12;
        if (ratio > highest) highest = ratio, best = c;
      }
      if (best == clusters.size()) clusters.emplace_back();
      clusters[best].members.push_back(i);
      clusters[best].mean = mean_of(s, clusters[best], open);
      cluster[i] = static_cast<std::int64_t>(best);
    }
    if (open) continue;
    ++rounds;
    const Fused f = fuse(s);
    ASSERT_EQ(f.clusters, cluster) << "seed " << properties::seed();
    for (std::size_t c = 0; c < clusters.size(); ++c) {
      fused += clusters[c].members.size() - 1;
      for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(f.shapes[6 * c + k], clusters[c].mean[k], 1e-13) << k;
      EXPECT_NEAR(f.scores[c], score_of(s, clusters[c].members).get_d(), 1e-14);
    }
  }
  EXPECT_GT(rounds, 30U);
  EXPECT_GT(fused, 500U);
}

/// Many boxes in one call, in many blocks of an index, become what those of each label become alone.
TEST(FuseRandom, ManyBoxesAsEachLabelAlone) {
  Random random(properties::seed());
  std::size_t fused = 0;
  for (const std::int32_t kind : {VESICA_AABB, VESICA_RECT}) {
    for (const int scales : {0, 6}) {
      Scene s = draw(kind, 5000, random, scales);
      s.threshold = 0.3;
      s.labels.clear();
      const int labels = 200;
      for (std::size_t i = 0; i < s.count(); ++i) s.labels.push_back(random.below(labels));
      // So that those of a label meet.
      for (std::size_t i = 0; i < s.numbers.size(); ++i) {
        if (kind == VESICA_AABB || i % 6 < 2) s.numbers[i] *= 0.0625;
        if (kind == VESICA_RECT && i % 6 >= 4) s.numbers[i] *= 0.0625;
      }
      for (std::size_t i = 0; i < s.numbers.size(); i += s.fields()) {
        const double x = std::floor(s.numbers[i]), y = std::floor(s.numbers[i + 1]);
        s.numbers[i] -= x, s.numbers[i + 1] -= y;
        if (kind == VESICA_AABB) s.numbers[i + 2] -= x, s.numbers[i + 3] -= y;
      }
      const Fused all = fuse(s);
      ASSERT_EQ(all.code, 0);
      fused += s.count() - all.scores.size();
      for (std::int32_t label = 0; label < labels; ++label) {
        Scene own{.kind = kind,
                  .numbers = {},
                  .scores = {},
                  .weights = {},
                  .labels = {},
                  .threshold = s.threshold,
                  .fused_score = s.fused_score};
        std::vector<std::size_t> items;
        for (std::size_t i = 0; i < s.count(); ++i) {
          if (s.labels[i] != label) continue;
          items.push_back(i);
          own.numbers.insert(own.numbers.end(), s.box(i), s.box(i) + s.fields());
          own.scores.push_back(s.scores[i]);
          if (!s.weights.empty()) own.weights.push_back(s.weights[i]);
        }
        const Fused alone = fuse(own);
        for (std::size_t k = 0; k < items.size(); ++k) {
          const auto c = static_cast<std::size_t>(all.clusters[items[k]]),
                     d = static_cast<std::size_t>(alone.clusters[k]);
          ASSERT_EQ(all.scores[c], alone.scores[d]) << "seed " << properties::seed();
          for (std::size_t f = 0; f < s.fields(); ++f)
            ASSERT_EQ(all.shapes[c * s.fields() + f], alone.shapes[d * s.fields() + f]);
        }
      }
    }
  }
  EXPECT_GT(fused, 2000U);
}

/// Floats are computed in double and rounded at the end.
TEST(FuseRandom, FloatsAreDoublesRounded) {
  Random random(properties::seed());
  for (int round = 0; round < 40; ++round) {
    const Scene s = draw(round % 2 == 0 ? VESICA_AABB : VESICA_RECT, 200, random);
    Fused wide_ones = fuse(s);
    for (double& x : wide_ones.shapes) x = static_cast<double>(static_cast<float>(x));
    for (double& x : wide_ones.scores) x = static_cast<double>(static_cast<float>(x));
    EXPECT_EQ(fuse_floats(s), wide_ones);
  }
}

/// Powers of two change nothing but the exponents; nor does the caller's rounding.
TEST(FuseRandom, AnyMagnitudeAndEnvironment) {
  Random random(properties::seed());
  for (int round = 0; round < 20; ++round) {
    const Scene s = draw(round % 2 == 0 ? VESICA_AABB : VESICA_RECT, 100, random);
    const Fused expected = fuse(s);
    for (const double scale : {0x1p-900, 0x1p1000}) {
      Scene scaled = s;
      Fused back = expected;
      for (std::size_t i = 0; i < s.numbers.size(); ++i) {
        if (s.kind == VESICA_AABB || i % 6 == 0 || i % 6 == 1 || i % 6 >= 4) scaled.numbers[i] *= scale;
      }
      for (std::size_t i = 0; i < back.shapes.size(); ++i) {
        if (s.kind == VESICA_AABB || i % 6 == 0 || i % 6 == 1 || i % 6 >= 4) back.shapes[i] *= scale;
      }
      EXPECT_EQ(fuse(scaled), back) << scale;
    }
    std::fesetround(FE_UPWARD);
    const Fused upward = fuse(s);
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(upward, expected);
  }
}

/// Far away, thin, and among the smallest numbers.
TEST(Fuse, ExtremePlaces) {
  Scene s{.numbers = {1e15, 0, 1e15 + 8, 8, 1e15 + 2, 0, 1e15 + 10, 8}, .scores = {1, 1}, .weights = {}, .labels = {}};
  EXPECT_EQ(fuse(s).shapes, (std::vector<double>{1e15 + 1, 0, 1e15 + 9, 8}));
  s.numbers = {0, 0, 1e12, 1, 0, 0.25, 1e12, 1.25};
  EXPECT_EQ(fuse(s).shapes, (std::vector<double>{0, 0.125, 1e12, 1.125}));
  const double q = 0x1p-1060;
  s.numbers = {0, 0, 8 * q, 8 * q, 2 * q, 0, 10 * q, 8 * q};
  EXPECT_EQ(fuse(s).shapes, (std::vector<double>{q, 0, 9 * q, 8 * q}));
  s = {.kind = VESICA_RECT,
       .numbers = {q, q, q, 0, 4, 4, q, 3 * q, 0, 1, 4 * q, 4 * q},
       .scores = {1, 1},
       .weights = {},
       .labels = {}};
  EXPECT_EQ(fuse(s).shapes, (std::vector<double>{q, 2 * q, 1, 0, 4 * q, 4 * q}));
  // Axes of any length; hx is in their units.
  s = {.kind = VESICA_RECT,
       .numbers = {1, 1, 0x1p-900, 0, 0x1p902, 0x1p902, 1, 3, 0, 0x1p900, 0x1p-898, 0x1p-898},
       .scores = {1, 1},
       .weights = {},
       .labels = {}};
  EXPECT_EQ(fuse(s).shapes, (std::vector<double>{1, 2, 1, 0, 4, 4}));
}

TEST(Fuse, ColumnsOfAnyStride) {
  const double x0[] = {1, 0}, y0[] = {1, 0}, x1[] = {11, 10}, y1[] = {11, 10}, scores[] = {0.4, 0.6};
  const vesica_shapes_f64 columns{
      VESICA_AABB, 0,       2, -static_cast<std::ptrdiff_t>(sizeof(double)), {x0 + 1, y0 + 1, x1 + 1, y1 + 1},
      nullptr,     nullptr, 0};
  std::vector<std::uint64_t> scratch(static_cast<std::size_t>(vesica_fuse_scratch(2)) / 8);
  double fused[8], fused_scores[2];
  std::int64_t clusters[2], count = 0;
  ASSERT_EQ(vesica_fuse_f64(&columns, scores, nullptr, nullptr, 0.5, 0, scratch.data(), vesica_fuse_scratch(2), fused,
                            fused_scores, clusters, &count),
            0);
  EXPECT_EQ(count, 1);
  EXPECT_NEAR(fused[0], 0.6, 1e-15);
}

TEST(Fuse, Errors) {
  const double boxes[] = {0, 0, 1, 1, 0, 0, 1, 1}, scores[] = {1, 2};
  vesica_shapes_f64 shapes;
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_AABB, 2, boxes, 32, &shapes), 0);
  const std::int64_t size = vesica_fuse_scratch(2);
  std::vector<std::uint64_t> scratch(static_cast<std::size_t>(size) / 8 + 1);
  double fused[8] = {-7}, fused_scores[2] = {-7, -7};
  std::int64_t clusters[2] = {-7, -7}, count = -7;
  struct Arguments {
    const vesica_shapes_f64* shapes;
    const double* scores;
    void* scratch;
    void* fused;
    double* fused_scores;
    std::int64_t *clusters, *count;
    double threshold = 0.5;
    std::int32_t fused_score = 0;
    std::int64_t size;
  };
  const Arguments good{&shapes, scores, scratch.data(), fused, fused_scores, clusters, &count, 0.5, 0, size};
  const auto ask = [](const Arguments& a) {
    return vesica_fuse_f64(a.shapes, a.scores, nullptr, nullptr, a.threshold, a.fused_score, a.scratch, a.size, a.fused,
                           a.fused_scores, a.clusters, a.count);
  };
  const auto with = [&](auto change) {
    Arguments a = good;
    change(a);
    return ask(a);
  };
  EXPECT_EQ(with([](Arguments& a) { a.shapes = nullptr; }), VESICA_E_NULL);
  EXPECT_EQ(with([](Arguments& a) { a.scores = nullptr; }), VESICA_E_NULL);
  EXPECT_EQ(with([](Arguments& a) { a.scratch = nullptr; }), VESICA_E_NULL);
  EXPECT_EQ(with([](Arguments& a) { a.fused = nullptr; }), VESICA_E_NULL);
  EXPECT_EQ(with([](Arguments& a) { a.fused_scores = nullptr; }), VESICA_E_NULL);
  EXPECT_EQ(with([](Arguments& a) { a.clusters = nullptr; }), VESICA_E_NULL);
  EXPECT_EQ(with([](Arguments& a) { a.count = nullptr; }), VESICA_E_NULL);
  for (const double threshold : {-0.1, 1.1, nan}) {
    EXPECT_EQ(with([&](Arguments& a) { a.threshold = threshold; }), VESICA_E_ARGUMENT);
  }
  EXPECT_EQ(with([](Arguments& a) { a.fused_score = 2; }), VESICA_E_ARGUMENT);
  EXPECT_EQ(with([](Arguments& a) { a.fused_score = -1; }), VESICA_E_ARGUMENT);
  EXPECT_EQ(with([](Arguments& a) { --a.size; }), VESICA_E_ARGUMENT);
  vesica_shapes_f64 wrong = shapes;
  for (std::int32_t kind = -1; kind <= VESICA_POLYLINE + 1; ++kind) {
    wrong.kind = kind;
    if (kind != VESICA_AABB && kind != VESICA_RECT) {
      EXPECT_EQ(with([&](Arguments& a) { a.shapes = &wrong; }), VESICA_E_KIND) << kind;
    }
  }
  wrong = shapes;
  wrong.count = -1;
  EXPECT_EQ(with([&](Arguments& a) { a.shapes = &wrong; }), VESICA_E_ARGUMENT);
  wrong = shapes;
  wrong.field[2] = nullptr;
  EXPECT_EQ(with([&](Arguments& a) { a.shapes = &wrong; }), VESICA_E_NULL);
  EXPECT_TRUE(fused[0] == -7 && fused_scores[0] == -7 && clusters[0] == -7 && count == -7);
  wrong = shapes;
  wrong.count = 0;
  EXPECT_EQ(ask({&wrong, nullptr, nullptr, nullptr, nullptr, nullptr, &count, 0.5, 0, 0}), 0);
  EXPECT_EQ(count, 0);
  EXPECT_EQ(ask(good), 0);
  EXPECT_EQ(count, 1);
  EXPECT_EQ(vesica_fuse_scratch(-1), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_fuse_scratch(std::int64_t{1} << 31), VESICA_E_ARGUMENT);
}

}  // namespace fuse_test
