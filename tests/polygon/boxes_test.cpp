// SPDX-License-Identifier: Apache-2.0
/// Boxes about the edges of a path, kept by the caller or made for a call on arrays: no bit of an answer changes.
#include <gtest/gtest.h>
#include <vesica_boxes.h>
#include <vesica_index.h>
#include <vesica_measures.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "inflated/shapes.hpp"
#include "polygon/shapes.hpp"
#include "properties/random.hpp"

namespace polygon_boxes {

using namespace polygons;

/// The boxes of a path, in aligned memory.
struct Kept {
  explicit Kept(std::int32_t kind, const Path& path) {
    const auto view = path.view();
    size = vesica_polygon_boxes_size(static_cast<std::int64_t>(path.xy.size() / 2));
    words.resize(static_cast<std::size_t>(size + 7) / 8);
    EXPECT_EQ(vesica_polygon_boxes_f64(kind, &view, words.data(), size), 0);
  }
  std::vector<std::int64_t> words;
  std::int64_t size;
};

/// A path of up to some hundred vertices, with holes, or any ring on a lattice.
inline Path any_path(Random& random) {
  Path path;
  if (random.chance(0.3)) {
    for (int j = random.integer(1, 3); j > 0; --j) path.add_ring(lattice_ring(random.integer(1, 80), 7, random));
    for (double& c : path.xy) c -= 3;
    return path;
  }
  path.add_ring(star(random.integer(3, 600), 0, 0, 3, 0.6, random));
  for (int j = random.below(3); j > 0; --j) path.add_ring(star(random.integer(1, 40), 0, 0, 1.5, 0.5, random));
  return path;
}

/// A shape near the path, often at one of its vertices.
inline inflated::Shape near_path(std::int32_t kind, const Path& path, Random& random) {
  inflated::Shape s = inflated::shape(kind, random);
  const auto at = static_cast<std::size_t>(random.below(static_cast<int>(path.xy.size() / 2)));
  if (kind == VESICA_POINT && random.chance(0.7)) {
    s.number[0] = random.chance(0.6) ? path.xy[2 * at] : random.between(-4, 4);
    s.number[1] = random.chance(0.6) ? path.xy[2 * at + 1] : random.between(-4, 4);
  }
  return s;
}

inline void expect_same_points(const vesica_closest_points_f64& a, const vesica_closest_points_f64& b) {
  EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0) << a.distance << ' ' << b.distance;
}

TEST(PolygonBoxes, ChangeNoAnswer) {
  Random random(301);
  int overlapping = 0, paths = 0;
  const int pairs = 20000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const std::int32_t kind = random.chance(0.7) ? VESICA_POLYGON : VESICA_POLYLINE;
    const Path path = any_path(random);
    const Kept kept(kind, path);
    const auto view = path.view();
    const Path other_path = any_path(random);
    const auto other_view = other_path.view();
    const std::int32_t kind_b = i % (VESICA_POLYLINE + 1);
    const bool is_path = kind_b >= VESICA_POLYGON;
    const inflated::Shape row = near_path(is_path ? VESICA_POINT : kind_b, path, random);
    const void* b = is_path ? static_cast<const void*>(&other_view) : row.number.data();
    const std::int32_t expected = vesica_overlap_f64(kind, &view, kind_b, b);
    ASSERT_GE(expected, 0);
    overlapping += expected;
    paths += static_cast<int>(is_path);
    ASSERT_EQ(vesica_polygon_boxes_overlap_f64(kind, &view, kept.words.data(), kept.size, kind_b, b), expected) << i;
    vesica_closest_points_f64 points, of_boxes;
    ASSERT_EQ(vesica_nearest_f64(kind, &view, kind_b, b, &points), 0);
    ASSERT_EQ(vesica_polygon_boxes_nearest_f64(kind, &view, kept.words.data(), kept.size, kind_b, b, &of_boxes), 0);
    expect_same_points(points, of_boxes);
    const double distance = random.chance(0.5) ? points.distance : random.between(0, 3);
    ASSERT_EQ(vesica_polygon_boxes_within_f64(kind, &view, kept.words.data(), kept.size, kind_b, b, distance),
              vesica_within_f64(kind, &view, kind_b, b, distance));
  }
  EXPECT_GT(overlapping, pairs / 4);
  EXPECT_LT(overlapping, pairs * 9 / 10);
  EXPECT_GT(paths, pairs / 6);
}

/// One path against an array is asked by boxes made within the call.
TEST(PolygonBoxes, OfACallOnArraysChangeNoAnswer) {
  Random random(302);
  const int calls = 400 * properties::repeat();
  for (int i = 0; i < calls; ++i) {
    const std::int32_t kind = random.chance(0.7) ? VESICA_POLYGON : VESICA_POLYLINE, kind_b = i % VESICA_POLYGON;
    Path path = any_path(random);
    while (path.xy.size() < 128) path.add_ring(star(40, 0, 0, 4, 0.5, random));
    const auto view = path.view();
    constexpr std::int64_t n = 16;
    std::vector<double> numbers;
    for (std::int64_t j = 0; j < n; ++j) {
      const inflated::Shape s = near_path(kind_b, path, random);
      numbers.insert(numbers.end(), s.number.begin(), s.number.begin() + 7);
    }
    vesica_shapes_f64 one, many;
    ASSERT_EQ(vesica_shapes_from_records_f64(kind, 1, &view, sizeof view, &one), 0);
    ASSERT_EQ(vesica_shapes_from_records_f64(kind_b, n, numbers.data(), 7 * sizeof(double), &many), 0);
    std::uint8_t in_step[n], row[n], column[n];
    vesica_overlap_many_f64(&one, &many, in_step);
    vesica_overlap_matrix_f64(&one, &many, row, n);
    vesica_overlap_matrix_f64(&many, &one, column, 1);
    double distance[n], signed_distance[n];
    vesica_nearest_many_f64(&many, &one, distance, nullptr, nullptr, nullptr, nullptr);
    vesica_signed_distance_many_f64(&one, &many, signed_distance);
    for (std::int64_t j = 0; j < n; ++j) {
      const double* b = numbers.data() + 7 * j;
      const std::int32_t expected = vesica_overlap_f64(kind, &view, kind_b, b);
      ASSERT_EQ(in_step[j], expected);
      ASSERT_EQ(row[j], expected);
      ASSERT_EQ(column[j], expected);
      vesica_closest_points_f64 points;
      ASSERT_EQ(vesica_nearest_f64(kind_b, b, kind, &view, &points), 0);
      ASSERT_EQ(distance[j], points.distance);
      double single;
      if (vesica_signed_distance_f64(kind, &view, kind_b, b, &single) == 0) {
        ASSERT_EQ(signed_distance[j], single);
      } else {
        ASSERT_TRUE(std::isnan(signed_distance[j]));
      }
    }
  }
}

/// An array of structs in which paths are repeated, as joins ask.
TEST(PolygonBoxes, OfRepeatedPathsChangeNoAnswer) {
  Random random(304);
  const int calls = 400 * properties::repeat();
  int overlapping = 0;
  for (int i = 0; i < calls; ++i) {
    const std::int32_t kind = random.chance(0.7) ? VESICA_POLYGON : VESICA_POLYLINE, kind_b = i % (VESICA_POLYGON + 1);
    std::vector<Path> paths;
    for (int k = 0; k < 3; ++k) paths.push_back(any_path(random));
    std::vector<vesica_polygon_f64> first, second;
    std::vector<double> numbers;
    int at = 0;
    constexpr int n = 40;
    for (int j = 0; j < n; ++j) {
      if (random.chance(0.15)) at = random.below(3);
      first.push_back(paths[static_cast<std::size_t>(at)].view());
      second.push_back(paths[static_cast<std::size_t>(random.below(3))].view());
      const inflated::Shape s = near_path(std::min(kind_b, VESICA_ROUND_RECT), paths[0], random);
      numbers.insert(numbers.end(), s.number.begin(), s.number.end());
    }
    const bool rows = kind_b < VESICA_POLYGON;
    const std::ptrdiff_t stride_b = rows ? 7 * sizeof(double) : sizeof(vesica_polygon_f64);
    const void* base_b = rows ? static_cast<const void*>(numbers.data()) : second.data();
    vesica_shapes_f64 a, b;
    ASSERT_EQ(vesica_shapes_from_records_f64(kind, n, first.data(), sizeof first[0], &a), 0);
    ASSERT_EQ(vesica_shapes_from_records_f64(kind_b, n, base_b, stride_b, &b), 0);
    std::uint8_t forward[n], backward[n];
    const std::int64_t found = vesica_overlap_many_f64(&a, &b, forward);
    ASSERT_EQ(vesica_overlap_many_f64(&b, &a, backward), found);
    for (std::size_t j = 0; j < n; ++j) {
      const void* one = static_cast<const char*>(base_b) + static_cast<std::ptrdiff_t>(j) * stride_b;
      ASSERT_EQ(forward[j], vesica_overlap_f64(kind, &first[j], kind_b, one)) << i << ' ' << j;
      ASSERT_EQ(backward[j], forward[j]);
      overlapping += forward[j];
    }
  }
  EXPECT_GT(overlapping, calls * 4);
  EXPECT_LT(overlapping, calls * 36);
}

TEST(PolygonBoxes, AreRefusedIfTheyAreNotOfThePath) {
  Path path, shorter, broken;
  path.add_ring({0, 0, 4, 0, 4, 4, 0, 4});
  shorter.add_ring({0, 0, 4, 0, 4, 4});
  broken.add_ring({0, 0, 4, 0, std::nan(""), 4});
  const auto view = path.view(), less = shorter.view(), bad = broken.view();
  Kept kept(VESICA_POLYGON, path);
  const vesica_point_f64 p{1, 1};
  const auto ask = [&](std::int32_t kind, const void* s, const void* boxes, std::int64_t size) {
    return vesica_polygon_boxes_overlap_f64(kind, s, boxes, size, VESICA_POINT, &p);
  };
  EXPECT_EQ(ask(VESICA_POLYGON, &view, kept.words.data(), kept.size), 1);
  EXPECT_EQ(ask(VESICA_POLYLINE, &view, kept.words.data(), kept.size), VESICA_E_INDEX);
  EXPECT_EQ(ask(VESICA_POLYGON, &less, kept.words.data(), kept.size), VESICA_E_INDEX);
  EXPECT_EQ(ask(VESICA_POLYGON, &view, kept.words.data(), kept.size - 1), VESICA_E_INDEX);
  EXPECT_EQ(ask(VESICA_POLYGON, &view, kept.words.data(), -1), VESICA_E_INDEX);
  EXPECT_EQ(ask(VESICA_POLYGON, &view, reinterpret_cast<const char*>(kept.words.data()) + 4, kept.size),
            VESICA_E_INDEX);
  EXPECT_EQ(ask(VESICA_RECT, &view, kept.words.data(), kept.size), VESICA_E_KIND);
  EXPECT_EQ(ask(VESICA_POLYGON, nullptr, kept.words.data(), kept.size), VESICA_E_NULL);
  EXPECT_EQ(ask(VESICA_POLYGON, &view, nullptr, kept.size), VESICA_E_NULL);
  EXPECT_EQ(vesica_polygon_boxes_overlap_f32(VESICA_POLYGON, &view, kept.words.data(), kept.size, VESICA_POINT, &p),
            VESICA_E_INDEX);
  EXPECT_EQ(vesica_polygon_boxes_within_f64(VESICA_POLYGON, &view, kept.words.data(), kept.size, VESICA_POINT, &p,
                                            std::nan("")),
            VESICA_E_ARGUMENT);
  vesica_polygon_f64 none = view;
  none.count = -1;
  EXPECT_EQ(ask(VESICA_POLYGON, &none, kept.words.data(), kept.size), VESICA_E_INDEX);
  kept.words[0] ^= 1;
  EXPECT_EQ(ask(VESICA_POLYGON, &view, kept.words.data(), kept.size), VESICA_E_INDEX);
  EXPECT_EQ(vesica_polygon_boxes_f64(VESICA_POLYGON, &bad, kept.words.data(), kept.size), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_polygon_boxes_f64(VESICA_POLYGON, &view, kept.words.data(), kept.size - 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_polygon_boxes_f64(VESICA_CIRCLE, &view, kept.words.data(), kept.size), VESICA_E_KIND);
  EXPECT_EQ(vesica_polygon_boxes_size(0), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_polygon_boxes_size(std::numeric_limits<std::int64_t>::max()), VESICA_E_ARGUMENT);
  EXPECT_LT(vesica_polygon_boxes_size(40000), 44000);
}

/// Coordinates beyond float's range, and below it.
TEST(PolygonBoxes, HoldExtremeCoordinates) {
  Random random(303);
  for (const double unit : {0x1p1000, 0x1p140, 0x1p-160, 0x1p-1060}) {
    Path path = any_path(random);
    for (double& c : path.xy) c *= unit;
    const Kept kept(VESICA_POLYGON, path);
    const auto view = path.view();
    for (int i = 0; i < 200; ++i) {
      const vesica_point_f64 p{random.between(-4, 4) * unit, random.between(-4, 4) * unit};
      ASSERT_EQ(vesica_polygon_boxes_overlap_f64(VESICA_POLYGON, &view, kept.words.data(), kept.size, VESICA_POINT, &p),
                vesica_overlap_f64(VESICA_POLYGON, &view, VESICA_POINT, &p));
      vesica_closest_points_f64 a, b;
      ASSERT_EQ(vesica_nearest_f64(VESICA_POLYGON, &view, VESICA_POINT, &p, &a), 0);
      ASSERT_EQ(
          vesica_polygon_boxes_nearest_f64(VESICA_POLYGON, &view, kept.words.data(), kept.size, VESICA_POINT, &p, &b),
          0);
      expect_same_points(a, b);
    }
  }
}

}  // namespace polygon_boxes
