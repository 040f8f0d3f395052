// SPDX-License-Identifier: Apache-2.0
// Greedy non-maximum suppression: known cases, errors, and against the definition followed literally.
#include <gtest/gtest.h>
#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>
#include <vesica/shapes.hpp>

#include "properties/generators.hpp"

namespace {

using properties::Random;
using Indices = std::vector<std::int64_t>;

struct Result {
  std::int32_t code;
  Indices kept;
};

template <class Shapes, class T>
using Function = std::int32_t (*)(const Shapes*, const T*, T, void*, std::int64_t, std::int64_t*, std::int64_t*);

template <class Shapes, class T>
Result run(Function<Shapes, T> nms, const Shapes& shapes, const std::vector<T>& scores, T threshold) {
  const auto bytes = static_cast<std::size_t>(vesica_nms_scratch(shapes.count));
  std::vector<char> scratch(bytes + 1, 'x');
  Indices keep(scores.size() + 1, -7);
  std::int64_t kept = -1;
  // Scratch need not be aligned.
  const std::int32_t code =
      nms(&shapes, scores.data(), threshold, scratch.data() + 1, vesica_nms_scratch(shapes.count), keep.data(), &kept);
  if (kept < 0) return {code, {}};
  for (std::size_t i = static_cast<std::size_t>(kept); i < keep.size(); ++i) EXPECT_EQ(keep[i], -7);
  keep.resize(static_cast<std::size_t>(kept));
  return {code, keep};
}

template <class Record>
vesica_shapes_f64 shapes_of(std::int32_t kind, const std::vector<Record>& records) {
  vesica_shapes_f64 shapes;
  EXPECT_EQ(vesica_shapes_from_records_f64(kind, static_cast<std::int64_t>(records.size()), records.data(),
                                           sizeof(Record), &shapes),
            0);
  return shapes;
}

Result nms_of_boxes(const std::vector<vesica_aabb_f64>& boxes, const std::vector<double>& scores, double threshold) {
  return run(vesica_nms_f64, shapes_of(VESICA_AABB, boxes), scores, threshold);
}

TEST(Nms, KeepsTheBestOfEachGroup) {
  const std::vector<vesica_aabb_f64> boxes{{0, 0, 2, 2}, {0, 0, 2, 3}, {5, 5, 6, 6}, {5, 5, 6, 6.5}};
  EXPECT_EQ(nms_of_boxes(boxes, {0.1, 0.9, 0.8, 0.7}, 0.5).kept, (Indices{1, 2}));
  EXPECT_EQ(nms_of_boxes(boxes, {0.9, 0.1, 0.7, 0.8}, 0.5).kept, (Indices{0, 3}));
  EXPECT_EQ(nms_of_boxes(boxes, {0.9, 0.1, 0.7, 0.8}, 0.7).kept, (Indices{0, 3, 2, 1}));
}

// The ratio of the two is 1/2 exactly.
TEST(Nms, TheThresholdItselfDoesNotSuppress) {
  const std::vector<vesica_aabb_f64> boxes{{0, 0, 2, 2}, {0, 0, 2, 1}};
  EXPECT_EQ(nms_of_boxes(boxes, {2, 1}, 0.5).kept, (Indices{0, 1}));
  EXPECT_EQ(nms_of_boxes(boxes, {2, 1}, std::nextafter(0.5, 0)).kept, (Indices{0}));
  EXPECT_EQ(nms_of_boxes({{0, 0, 1, 1}, {0, 0, 1, 1}}, {1, 1}, 1).kept, (Indices{0, 1}));
  // Touching boxes share nothing, at any threshold.
  EXPECT_EQ(nms_of_boxes({{0, 0, 1, 1}, {1, 0, 2, 1}}, {1, 2}, 0).kept, (Indices{1, 0}));
}

TEST(Nms, TiesGoByIndex) {
  const std::vector<vesica_aabb_f64> boxes{{4, 0, 5, 1}, {0, 0, 1, 1}, {2, 0, 3, 1}, {0, 0, 1, 1}};
  EXPECT_EQ(nms_of_boxes(boxes, {3, 3, 3, 3}, 0.5).kept, (Indices{0, 1, 2}));
  EXPECT_EQ(nms_of_boxes(boxes, {0.0, -0.0, 0.0, -0.0}, 0.5).kept, (Indices{0, 1, 2}));
}

// A suppressed shape suppresses nothing.
TEST(Nms, SuppressionIsNotPassedOn) {
  const std::vector<vesica_aabb_f64> chain{{0, 0, 4, 1}, {1, 0, 5, 1}, {2, 0, 6, 1}};
  EXPECT_EQ(nms_of_boxes(chain, {3, 2, 1}, 0.5).kept, (Indices{0, 2}));
}

TEST(Nms, LeavesOutWhatIsInvalid) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const std::vector<vesica_aabb_f64> boxes{{0, 0, 1, 1}, {2, 0, 1, 1}, {0, 0, 1, 1}, {4, 0, 5, 1}, {0, 0, nan, 1}};
  const Result result = nms_of_boxes(boxes, {-inf, 9, nan, inf, 5}, 0.5);
  EXPECT_EQ(result.code, VESICA_E_SHAPE);
  EXPECT_EQ(result.kept, (Indices{3, 0}));
}

TEST(Nms, ShapesWithoutAreaAreKept) {
  const std::vector<vesica_aabb_f64> boxes{{0, 0, 1, 1}, {0.5, 0, 0.5, 1}, {0.5, 0, 0.5, 1}};
  EXPECT_EQ(nms_of_boxes(boxes, {1, 2, 3}, 0).kept, (Indices{2, 1, 0}));
}

TEST(Nms, Errors) {
  const std::vector<vesica_aabb_f64> boxes{{0, 0, 1, 1}};
  const vesica_shapes_f64 shapes = shapes_of(VESICA_AABB, boxes);
  const double score = 1;
  const std::int64_t size = vesica_nms_scratch(1);
  std::vector<char> scratch(static_cast<std::size_t>(size));
  std::int64_t keep = -7, kept = -7;
  const auto call = [&](const vesica_shapes_f64* s, const double* scores, double threshold, void* room,
                        std::int64_t bytes, std::int64_t* out,
                        std::int64_t* count) { return vesica_nms_f64(s, scores, threshold, room, bytes, out, count); };
  EXPECT_EQ(call(nullptr, &score, 0.5, scratch.data(), size, &keep, &kept), VESICA_E_NULL);
  EXPECT_EQ(call(&shapes, nullptr, 0.5, scratch.data(), size, &keep, &kept), VESICA_E_NULL);
  EXPECT_EQ(call(&shapes, &score, 0.5, nullptr, size, &keep, &kept), VESICA_E_NULL);
  EXPECT_EQ(call(&shapes, &score, 0.5, scratch.data(), size, nullptr, &kept), VESICA_E_NULL);
  EXPECT_EQ(call(&shapes, &score, 0.5, scratch.data(), size, &keep, nullptr), VESICA_E_NULL);
  EXPECT_EQ(call(&shapes, &score, 0.5, scratch.data(), size - 1, &keep, &kept), VESICA_E_ARGUMENT);
  EXPECT_EQ(call(&shapes, &score, -0.1, scratch.data(), size, &keep, &kept), VESICA_E_ARGUMENT);
  EXPECT_EQ(call(&shapes, &score, 1.1, scratch.data(), size, &keep, &kept), VESICA_E_ARGUMENT);
  EXPECT_EQ(call(&shapes, &score, std::nan(""), scratch.data(), size, &keep, &kept), VESICA_E_ARGUMENT);
  vesica_shapes_f64 wrong = shapes;
  wrong.kind = VESICA_SEGMENT;
  EXPECT_EQ(call(&wrong, &score, 0.5, scratch.data(), size, &keep, &kept), VESICA_E_KIND);
  wrong.kind = VESICA_POLYLINE + 1;
  EXPECT_EQ(call(&wrong, &score, 0.5, scratch.data(), size, &keep, &kept), VESICA_E_KIND);
  wrong = shapes;
  wrong.count = -1;
  EXPECT_EQ(call(&wrong, &score, 0.5, scratch.data(), size, &keep, &kept), VESICA_E_ARGUMENT);
  wrong = shapes;
  wrong.field[3] = nullptr;
  EXPECT_EQ(call(&wrong, &score, 0.5, scratch.data(), size, &keep, &kept), VESICA_E_NULL);
  EXPECT_EQ(keep, -7);
  EXPECT_EQ(kept, -7);
  wrong = shapes;
  wrong.count = 0;
  EXPECT_EQ(call(&wrong, nullptr, 0.5, nullptr, 0, nullptr, &kept), 0);
  EXPECT_EQ(kept, 0);
  EXPECT_EQ(vesica_nms_scratch(-1), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_nms_scratch(std::numeric_limits<std::int64_t>::max()), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_nms_scratch(std::int64_t{1} << 31), VESICA_E_ARGUMENT);
  EXPECT_GE(vesica_nms_scratch(0), 0);
  EXPECT_GE(vesica_nms_scratch(1000), 1000 * 8);
}

/// Whom the definition keeps, asking vesica_iou of every two.
template <class T, class Iou>
Indices literally(const std::vector<T>& scores, T threshold, const Iou& iou) {
  Indices order(scores.size()), kept;
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::int64_t i, std::int64_t j) {
    return scores[static_cast<std::size_t>(i)] > scores[static_cast<std::size_t>(j)];
  });
  for (const std::int64_t i : order) {
    if (std::none_of(kept.begin(), kept.end(), [&](std::int64_t j) { return iou(j, i) > threshold; }))
      kept.push_back(i);
  }
  return kept;
}

constexpr std::size_t fields = 6;

/// Records of one kind, clustered, some equal and some with equal scores.
template <class T>
std::vector<T> clusters(int kind, std::size_t count, properties::Workload workload, Random& random) {
  const auto scalar = sizeof(T) == 8 ? properties::Scalar::f64 : properties::Scalar::f32;
  std::vector<T> numbers(fields * count);
  for (std::size_t i = 0; i < count; ++i) {
    const properties::Pair p = properties::draw(workload, kind, kind, scalar, random);
    const bool again = i > 0 && random.chance(0.1);
    const auto from = static_cast<std::size_t>(random.below(i > 0 ? static_cast<int>(i) : 1));
    for (std::size_t k = 0; k < fields; ++k) {
      numbers[fields * i + k] = again ? numbers[fields * from + k] : static_cast<T>(p.a[k]);
    }
  }
  return numbers;
}

TEST(Nms, IsTheDefinition) {
  Random random(properties::seed());
  const auto workloads = {properties::Workload::random,    properties::Workload::grid,
                          properties::Workload::thin,      properties::Workload::huge,
                          properties::Workload::tiny,      properties::Workload::mixed_scale,
                          properties::Workload::degenerate};
  int suppressed = 0;
  for (int kind = VESICA_CIRCLE; kind <= VESICA_ELLIPSE; ++kind) {
    for (const auto workload : workloads) {
      for (int round = 0; round < 3 * properties::repeat(); ++round) {
        const std::size_t count = 120;
        const double threshold = random.chance(0.2) ? 0 : random.unit();
        const std::vector<double> numbers = clusters<double>(kind, count, workload, random);
        std::vector<double> scores(count);
        for (double& score : scores) score = random.chance(0.3) ? random.below(4) : random.unit();
        vesica_shapes_f64 shapes;
        ASSERT_EQ(vesica_shapes_from_records_f64(kind, count, numbers.data(), fields * sizeof(double), &shapes), 0);
        const auto at = [&](std::int64_t i) { return numbers.data() + fields * static_cast<std::size_t>(i); };
        const Indices truth = literally(scores, threshold, [&](std::int64_t i, std::int64_t j) {
          double ratio = 0;
          vesica_iou_f64(kind, at(i), kind, at(j), &ratio);
          return ratio;
        });
        const Result result = run(vesica_nms_f64, shapes, scores, threshold);
        EXPECT_EQ(result.code, 0);
        ASSERT_EQ(result.kept, truth) << "seed " << properties::seed();
        suppressed += static_cast<int>(count - truth.size());
      }
    }
  }
  EXPECT_GT(suppressed, 100);
}

TEST(Nms, OfFloatsIsTheDefinition) {
  Random random(properties::seed());
  for (int kind = VESICA_CIRCLE; kind <= VESICA_ELLIPSE; ++kind) {
    const std::size_t count = 150;
    const std::vector<float> numbers = clusters<float>(kind, count, properties::Workload::random, random);
    std::vector<float> scores(count);
    for (float& score : scores) score = static_cast<float>(random.unit());
    vesica_shapes_f32 shapes;
    ASSERT_EQ(vesica_shapes_from_records_f32(kind, count, numbers.data(), fields * sizeof(float), &shapes), 0);
    const auto at = [&](std::int64_t i) { return numbers.data() + fields * static_cast<std::size_t>(i); };
    const Indices truth = literally(scores, 0.25f, [&](std::int64_t i, std::int64_t j) {
      float ratio = 0;
      vesica_iou_f32(kind, at(i), kind, at(j), &ratio);
      return ratio;
    });
    EXPECT_EQ(run(vesica_nms_f32, shapes, scores, 0.25f).kept, truth);
  }
}

/// Sets of many blocks of the index: rectangles against the definition.
void expect_the_definition(const std::vector<vesica_rect_f64>& rects, const std::vector<double>& scores,
                           double threshold, const char* what) {
  const auto at = [&](std::int64_t i) { return &rects[static_cast<std::size_t>(i)].cx; };
  const Indices truth = literally(scores, threshold, [&](std::int64_t i, std::int64_t j) {
    double ratio = 0;
    vesica_iou_f64(VESICA_RECT, at(i), VESICA_RECT, at(j), &ratio);
    return ratio;
  });
  EXPECT_EQ(run(vesica_nms_f64, shapes_of(VESICA_RECT, rects), scores, threshold).kept, truth)
      << what << ", threshold " << threshold << ", seed " << properties::seed();
}

vesica_rect_f64 turned_rect(double side, double size, Random& random) {
  const double angle = random.between(0, 6.3);
  return {random.between(0, side), random.between(0, side),         std::cos(angle),
          std::sin(angle),         size * random.between(0.5, 1.5), size * random.between(0.5, 1.5)};
}

TEST(Nms, OfManyIsTheDefinition) {
  Random random(properties::seed());
  for (const double threshold : {0.0, 0x1p-11, 0.1, 0.5, 0.9}) {
    std::vector<vesica_rect_f64> crowded, mixed;
    std::vector<double> scores;
    for (int i = 0; i < 2500; ++i) {
      crowded.push_back(turned_rect(40, 1, random));
      // Small ones, large ones, needles and giants.
      mixed.push_back(turned_rect(40, std::exp2(random.between(-9, 3)), random));
      if (i % 16 == 0) mixed.back().hx = 60;
      if (i % 512 == 0) mixed.back().hy = 60;
      scores.push_back(random.chance(0.2) ? random.below(8) / 8.0 : random.unit());
    }
    expect_the_definition(crowded, scores, threshold, "crowded");
    expect_the_definition(mixed, scores, threshold, "mixed");
  }
}

/// Equal shapes: all at threshold 1, else one of each place.
TEST(Nms, OfManyEqualShapes) {
  Random random(properties::seed());
  std::vector<vesica_rect_f64> one_place, places;
  std::vector<double> scores;
  for (int i = 0; i < 1500; ++i) {
    one_place.push_back({1, 2, 0.8, 0.6, 3, 1});
    places.push_back({10.0 * random.below(7), 0, 0.8, 0.6, 3, 1});
    scores.push_back(random.unit());
  }
  for (const double threshold : {0.0, 0.5, 1.0}) {
    expect_the_definition(one_place, scores, threshold, "one place");
    expect_the_definition(places, scores, threshold, "places");
  }
}

/// Each suppresses the next one only if it is kept, and the best is the last of them, however the index orders them.
TEST(Nms, OfAChain) {
  for (const double direction : {1.0, -1.0}) {
    std::vector<vesica_rect_f64> chain;
    std::vector<double> scores;
    for (int i = 0; i < 5001; ++i) {
      chain.push_back({0.5 * i, 0, 1, 0, 1, 1});
      scores.push_back(direction * i);
    }
    const Result result = run(vesica_nms_f64, shapes_of(VESICA_RECT, chain), scores, 0.5);
    ASSERT_EQ(result.kept.size(), 2501u);
    for (std::size_t k = 0; k < result.kept.size(); ++k) {
      ASSERT_EQ(result.kept[k],
                direction > 0 ? 5000 - 2 * static_cast<std::int64_t>(k) : 2 * static_cast<std::int64_t>(k));
    }
  }
}

constexpr int grid_side = 220;

struct Scored {
  std::vector<vesica_circle_f64> discs;
  std::vector<double> scores;
};

/// Discs that do not meet, of scores from 1 to 7.
Scored grid_of_discs() {
  Scored grid;
  for (int i = 0; i < grid_side * grid_side; ++i) {
    grid.discs.push_back({static_cast<double>(i % grid_side), static_cast<double>(i / grid_side), 0.25});
    grid.scores.push_back(1 + i % 7);
  }
  return grid;
}

/// Discs, and one over all of them, which is in hundreds of blocks' reach: the best, it is left alone; the worst, it
/// alone goes.
TEST(Nms, OneOverAll) {
  auto [discs, scores] = grid_of_discs();
  discs.push_back({grid_side / 2.0, grid_side / 2.0, grid_side});
  scores.push_back(0);
  const Result worst = run(vesica_nms_f64, shapes_of(VESICA_CIRCLE, discs), scores, 0.0);
  ASSERT_EQ(worst.kept.size(), static_cast<std::size_t>(grid_side * grid_side));
  EXPECT_EQ(std::count(worst.kept.begin(), worst.kept.end(), grid_side * grid_side), 0);
  scores.back() = 9;
  EXPECT_EQ(run(vesica_nms_f64, shapes_of(VESICA_CIRCLE, discs), scores, 0.0).kept, (Indices{grid_side * grid_side}));
}

/// The same with two giants of little score, at a threshold that no ratio of large and small reaches: their block has
/// more neighbours than are listed, and still the better one suppresses the other and nothing else.
TEST(Nms, GiantsAmongManyBlocks) {
  auto [discs, scores] = grid_of_discs();
  for (const double score : {0.25, 0.5}) {
    discs.push_back({grid_side / 2.0, grid_side / 2.0, grid_side + score});
    scores.push_back(score);
  }
  const Indices kept = run(vesica_nms_f64, shapes_of(VESICA_CIRCLE, discs), scores, 0.5).kept;
  ASSERT_EQ(kept.size(), static_cast<std::size_t>(grid_side * grid_side + 1));
  EXPECT_EQ(kept.back(), grid_side * grid_side + 1);
}

TEST(Nms, OfManyFloats) {
  Random random(properties::seed());
  std::vector<vesica_rect_f32> rects;
  std::vector<float> scores;
  for (int i = 0; i < 2500; ++i) {
    const vesica_rect_f64 r = turned_rect(40, 1, random);
    rects.push_back({static_cast<float>(r.cx), static_cast<float>(r.cy), static_cast<float>(r.ux),
                     static_cast<float>(r.uy), static_cast<float>(r.hx), static_cast<float>(r.hy)});
    scores.push_back(static_cast<float>(random.unit()));
  }
  vesica_shapes_f32 shapes;
  ASSERT_EQ(vesica_shapes_from_records_f32(VESICA_RECT, 2500, rects.data(), sizeof rects[0], &shapes), 0);
  const auto at = [&](std::int64_t i) { return &rects[static_cast<std::size_t>(i)].cx; };
  const Indices truth = literally(scores, 0.3f, [&](std::int64_t i, std::int64_t j) {
    float ratio = 0;
    vesica_iou_f32(VESICA_RECT, at(i), VESICA_RECT, at(j), &ratio);
    return ratio;
  });
  EXPECT_EQ(run(vesica_nms_f32, shapes, scores, 0.3f).kept, truth);
}

/// Columns, read backwards, and one shape repeated.
TEST(Nms, AnyLayout) {
  const double cx[] = {0, 10, 20.5}, cy[] = {0, 0, 0}, r[] = {1, 1, 1};
  vesica_shapes_f64 shapes{VESICA_CIRCLE, 0, 3, sizeof(double), {cx, cy, r}, nullptr, nullptr, 0};
  EXPECT_EQ(run(vesica_nms_f64, shapes, {1, 2, 3}, 0.5).kept, (Indices{2, 1, 0}));
  shapes = {VESICA_CIRCLE,           0,       3,       -static_cast<std::ptrdiff_t>(sizeof(double)),
            {cx + 2, cy + 2, r + 2}, nullptr, nullptr, 0};
  EXPECT_EQ(run(vesica_nms_f64, shapes, {1, 3, 2}, 0.5).kept, (Indices{1, 2, 0}));
  shapes.stride = 0;
  EXPECT_EQ(run(vesica_nms_f64, shapes, {1, 3, 2}, 0.5).kept, (Indices{1}));
}

}  // namespace
