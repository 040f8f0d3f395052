// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vesica_measures.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "inflated/shapes.hpp"
#include "polygon/distance_oracle.hpp"
#include "polygon/shapes.hpp"
#include "properties/random.hpp"

namespace polygon_within {

using namespace polygons;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

/// Distances that are exactly those asked for are frequent.
TEST(PolygonWithin, AgreesWithIntegers) {
  Random random(259);
  int yes = 0, equal = 0;
  const int pairs = 40000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const int size = random.integer(2, 20);
    Path a = lattice_path(size, random), b = lattice_path(random.integer(2, size), random);
    const bool closed_a = random.chance(0.7), closed_b = random.chance(0.7);
    const double shift_x = random.below(30), shift_y = random.below(30);
    for (std::size_t k = 0; k < b.xy.size(); k += 2) b.xy[k] += shift_x, b.xy[k + 1] += shift_y;
    const Fraction outlines = squared_outline_distance(lattice_edges(a, closed_a), lattice_edges(b, closed_b));
    const bool overlapping = overlap(a, closed_a, b, closed_b);
    // Near the distance, or equal to it if that is an integer.
    const auto asked = static_cast<std::int64_t>(std::round(root(outlines))) + random.integer(-1, 1);
    if (asked < 0) continue;
    const Fraction squared{asked * asked, 1};
    const bool expected = overlapping || compared(outlines, squared) <= 0;
    yes += static_cast<int>(expected);
    equal += static_cast<int>(!overlapping && compared(outlines, squared) == 0);
    const double unit = std::ldexp(1.0, random.integer(-1060, 1000)), distance = static_cast<double>(asked) * unit;
    for (Path* path : {&a, &b}) {
      for (double& c : path->xy) c *= unit;
    }
    const auto view_a = a.view(), view_b = b.view();
    const std::int32_t kind_a = closed_a ? VESICA_POLYGON : VESICA_POLYLINE,
                       kind_b = closed_b ? VESICA_POLYGON : VESICA_POLYLINE;
    ASSERT_EQ(vesica_within_f64(kind_a, &view_a, kind_b, &view_b, distance), expected) << i;
    ASSERT_EQ(vesica_within_f64(kind_b, &view_b, kind_a, &view_a, distance), expected) << i;
    const Path other = closed_a ? rewritten(a, random) : a;
    const auto view = other.view();
    ASSERT_EQ(vesica_within_f64(kind_a, &view, kind_b, &view_b, distance), expected) << i;
    ASSERT_EQ(vesica_within_f64(kind_a, &view, kind_b, &view_b, 0), overlapping) << i;
  }
  EXPECT_GT(yes, pairs / 4);
  EXPECT_LT(yes, pairs * 9 / 10);
  EXPECT_GT(equal, pairs / 50);
}

/// With each other kind: yes if an edge says so or the shapes overlap, else nearly if an edge says so.
TEST(PolygonWithin, IsTheAnswerOfTheEdges) {
  Random random(260);
  std::array<int, 3> count{};
  const int pairs = 20000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const inflated::Shape other = inflated::shape(i % 8, random);
    Path path;
    path.add_ring(star(random.integer(2, 60), random.between(-3, 3), random.between(-3, 3), 1, 0.5, random));
    const auto view = path.view();
    vesica_closest_points_f64 c;
    ASSERT_EQ(vesica_nearest_f64(VESICA_POLYGON, &view, other.kind, other.number.data(), &c), 0);
    const double distance = random.chance(0.5) ? c.distance : random.unit() * 3;
    bool expected = c.distance == 0, nearly = false;
    for (std::size_t k = 0, n = path.xy.size() / 2; k < n; ++k) {
      const std::size_t next = (k + 1) % n;
      const vesica_segment_f64 e{path.xy[2 * k], path.xy[2 * k + 1], path.xy[2 * next], path.xy[2 * next + 1]};
      const std::int32_t code = vesica_within_f64(VESICA_SEGMENT, &e, other.kind, other.number.data(), distance);
      expected = expected || code == VESICA_WITHIN_YES;
      nearly = nearly || code == VESICA_WITHIN_NEARLY;
    }
    const std::int32_t answer = expected ? VESICA_WITHIN_YES : nearly ? VESICA_WITHIN_NEARLY : VESICA_WITHIN_NO;
    ASSERT_EQ(vesica_within_f64(VESICA_POLYGON, &view, other.kind, other.number.data(), distance), answer) << i;
    ASSERT_EQ(vesica_within_f64(other.kind, other.number.data(), VESICA_POLYGON, &view, distance), answer) << i;
    ++count[static_cast<std::size_t>(answer)];
  }
  EXPECT_GT(count[0], pairs / 20);
  EXPECT_GT(count[1], pairs / 4);
}

/// Long outlines take the walk over blocks.
TEST(PolygonWithin, OfManyVertices) {
  Random random(261);
  const int pairs = 100 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    Path a, b;
    a.add_ring(star(random.integer(30, 500), 0, 0, 3000, 0.5, random));
    b.add_ring(star(random.integer(3, 500), random.between(3000, 8000), random.between(0, 5000), 2500, 0.5, random));
    for (Path* path : {&a, &b}) {
      for (double& c : path->xy) c = std::round(c);
    }
    const auto view_a = a.view(), view_b = b.view();
    const Fraction outlines = squared_outline_distance(lattice_edges(a, true), lattice_edges(b, true));
    const bool overlapping = overlap(a, true, b, true);
    for (const int step : {0, 1}) {
      const auto asked = static_cast<std::int64_t>(root(outlines)) + step;
      const bool expected = overlapping || compared(outlines, {asked * asked, 1}) <= 0;
      ASSERT_EQ(vesica_within_f64(VESICA_POLYGON, &view_a, VESICA_POLYGON, &view_b, static_cast<double>(asked)),
                expected);
    }
  }
}

TEST(PolygonWithin, OtherDistances) {
  const std::vector<double> xy{0, 0, 2, 0, 2, 2, 0, 2}, small{0.5, 0.5, 1, 0.5, 1, 1};
  const vesica_polygon_f64 square{xy.data(), xy.data() + 1, 16, nullptr, 4},
      triangle{small.data(), small.data() + 1, 16, nullptr, 3};
  const vesica_circle_f64 disc{5, 0, 1}, inside{1, 1, 0.5}, negative{0, 0, -1};
  const auto ask = [&](const vesica_circle_f64& s, double distance) {
    return vesica_within_f64(VESICA_CIRCLE, &s, VESICA_POLYGON, &square, distance);
  };
  EXPECT_EQ(ask(disc, 2), VESICA_WITHIN_YES);
  EXPECT_EQ(ask(disc, std::nextafter(2, 0)), VESICA_WITHIN_NO);
  EXPECT_EQ(ask(disc, infinity), VESICA_WITHIN_YES);
  EXPECT_EQ(ask(disc, -infinity), VESICA_WITHIN_NO);
  EXPECT_EQ(ask(disc, -1), VESICA_WITHIN_NO);  // apart
  EXPECT_EQ(ask(inside, 0), VESICA_WITHIN_YES);
  EXPECT_EQ(ask(inside, -0.25), VESICA_WITHIN_YES);
  EXPECT_EQ(ask(inside, -1.5), VESICA_WITHIN_YES);
  EXPECT_EQ(ask(inside, std::nextafter(-1.5, -2)), VESICA_WITHIN_NO);
  const std::vector<double> bent{0, 0, 2, 0, 1, 0.5, 0, 2};
  const vesica_polygon_f64 not_convex{bent.data(), bent.data() + 1, 16, nullptr, 4};
  EXPECT_EQ(vesica_within_f64(VESICA_POLYGON, &not_convex, VESICA_POLYGON, &square, -0.25), VESICA_E_NOT_CONVEX);
  EXPECT_EQ(ask(disc, nan), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(negative, 1), VESICA_E_SHAPE);
  EXPECT_EQ(ask(negative, nan), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_within_f64(VESICA_POLYGON, &square, VESICA_POLYGON, &triangle, 0.25), VESICA_WITHIN_YES);
  EXPECT_EQ(vesica_within_f64(VESICA_POLYLINE, &square, VESICA_POLYLINE, &triangle, 0.25), VESICA_WITHIN_NO);
  EXPECT_EQ(vesica_within_f64(VESICA_POLYLINE, &square, VESICA_POLYLINE, &triangle, 0.5), VESICA_WITHIN_YES);
  EXPECT_EQ(vesica_within_f64(VESICA_POLYGON, nullptr, VESICA_POLYGON, &triangle, 1), VESICA_E_NULL);
  EXPECT_EQ(vesica_within_f64(VESICA_POLYGON, &square, 10, &triangle, 1), VESICA_E_KIND);
}

TEST(PolygonWithin, Arrays) {
  const std::vector<double> xy{0, 0, 1, 0, 1, 1, 0, 1, 2, 0, nan, 0, 3, 1, 2, 1, 4, 0, 5, 0, 5, 1, 4, 1};
  vesica_shapes_f64 quads{}, discs;
  quads.kind = VESICA_POLYGON;
  quads.count = 3;
  quads.stride = 16;
  quads.field[0] = xy.data();
  quads.field[1] = xy.data() + 1;
  quads.each = 4;
  const std::array<vesica_circle_f64, 2> two{{{2.5, 0.5, 0.5}, {7, 0.5, 0.5}}};
  vesica_shapes_from_records_f64(VESICA_CIRCLE, 1, two.data(), sizeof two[0], &discs);
  std::array<std::uint8_t, 3> out{9, 9, 9};
  EXPECT_EQ(vesica_within_many_f64(&quads, &discs, 1, out.data()), VESICA_E_SHAPE);
  EXPECT_EQ(out, (std::array<std::uint8_t, 3>{1, 0, 1}));
  vesica_shapes_from_records_f64(VESICA_CIRCLE, 2, two.data(), sizeof two[0], &discs);
  std::array<std::uint8_t, 6> matrix{};
  EXPECT_EQ(vesica_within_matrix_f64(&discs, &quads, 1.5, matrix.data(), 3), VESICA_E_SHAPE);
  EXPECT_EQ(matrix, (std::array<std::uint8_t, 6>{1, 0, 1, 0, 0, 1}));
  EXPECT_EQ(vesica_within_matrix_f64(&discs, &quads, nan, matrix.data(), 3), VESICA_E_ARGUMENT);
  quads.count = 1;
  EXPECT_EQ(vesica_within_matrix_f64(&discs, &quads, -1, matrix.data(), 3), 0);
  // Floats.
  const std::vector<float> narrow{0, 0, 1, 0, 1, 1, 0, 1};
  const vesica_polygon_f32 square{narrow.data(), narrow.data() + 1, 8, nullptr, 4};
  const vesica_point_f32 point{4, 5};
  EXPECT_EQ(vesica_within_f32(VESICA_POINT, &point, VESICA_POLYGON, &square, 5), VESICA_WITHIN_YES);
  EXPECT_EQ(vesica_within_f32(VESICA_POINT, &point, VESICA_POLYGON, &square, std::nextafter(5.0f, 0.0f)),
            VESICA_WITHIN_NO);
}

}  // namespace polygon_within
