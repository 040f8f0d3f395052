// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "inflated/shapes.hpp"
#include "polygon/oracle.hpp"
#include "polygon/shapes.hpp"
#include "properties/random.hpp"

namespace polygon_overlap {

using namespace polygons;

inline std::int32_t ask(const Path& a, bool closed_a, const Path& b, bool closed_b) {
  const auto polygon_a = a.view(), polygon_b = b.view();
  // The structs of both kinds are the same.
  const std::int32_t kind_a = closed_a ? VESICA_POLYGON : VESICA_POLYLINE,
                     kind_b = closed_b ? VESICA_POLYGON : VESICA_POLYLINE;
  return vesica_overlap_f64(kind_a, &polygon_a, kind_b, &polygon_b);
}

/// Lattices small enough that vertices coincide, scaled anywhere.
TEST(PolygonOverlap, AgreesWithIntegers) {
  Random random(59);
  int met = 0;
  const int pairs = 200000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const int size = random.integer(2, 12);
    Path a = lattice_path(size, random), b = lattice_path(size, random);
    const bool closed_a = random.chance(0.7), closed_b = random.chance(0.7);
    const double shift = random.below(8);
    for (std::size_t k = 0; k < b.xy.size(); k += 2) b.xy[k] += shift;
    const bool expected = overlap(a, closed_a, b, closed_b);
    met += static_cast<int>(expected);
    const double scale = std::ldexp(1.0, random.integer(-1060, 1000));
    for (Path* path : {&a, &b}) {
      for (double& c : path->xy) c *= scale;
    }
    ASSERT_EQ(ask(a, closed_a, b, closed_b), expected) << i;
    ASSERT_EQ(ask(b, closed_b, a, closed_a), expected) << i;
    const Path other = closed_a ? rewritten(a, random) : a;
    ASSERT_EQ(ask(other, closed_a, b, closed_b), expected) << i;
  }
  EXPECT_GT(met, pairs / 4);
  EXPECT_LT(met, pairs * 9 / 10);
}

/// Long rings take the walk over blocks of edges; the oracle looks at every pair.
TEST(PolygonOverlap, OfManyVertices) {
  Random random(60);
  int met = 0;
  const int pairs = 200 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    Path a, b;
    const int n = random.integer(30, 700), m = random.integer(3, 700);
    a.add_ring(star(n, 4000, 4000, 3000, 0.3, random));
    b.add_ring(star(m, 4000 + random.between(-6000, 6000), 4000 + random.between(-6000, 6000), 3000, 0.3, random));
    if (random.chance(0.3)) a.add_ring(star(30, 4000, 4000, 600, 0.5, random));
    for (Path* path : {&a, &b}) {
      for (double& c : path->xy) c = std::round(c);
    }
    const bool closed_a = random.chance(0.8), closed_b = random.chance(0.8),
               expected = overlap(a, closed_a, b, closed_b);
    met += static_cast<int>(expected);
    ASSERT_EQ(ask(a, closed_a, b, closed_b), expected) << i;
  }
  EXPECT_GT(met, pairs / 4);
  EXPECT_LT(met, pairs * 9 / 10);
}

/// A box as a polygon of its corners meets what the box meets, a polyline of two vertices what the segment meets.
TEST(PolygonOverlap, OfBoxesAsPolygons) {
  Random random(61);
  const int pairs = 100000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const inflated::Shape other = inflated::any_shape(random);
    double x0 = random.between(-2, 2), y0 = random.between(-2, 2), x1 = random.between(-2, 2),
           y1 = random.between(-2, 2);
    // Often in contact with a stored number.
    if (random.chance(0.3)) x0 = other.number[0];
    if (random.chance(0.3)) y1 = other.number[1];
    Path chain;
    chain.add_ring({x0, y0, x1, y1});
    const auto line = chain.view<vesica_polyline_f64>();
    const vesica_segment_f64 segment{x0, y0, x1, y1};
    ASSERT_EQ(vesica_overlap_f64(VESICA_POLYLINE, &line, other.kind, other.number.data()),
              vesica_overlap_f64(VESICA_SEGMENT, &segment, other.kind, other.number.data()));
    const vesica_aabb_f64 box{std::min(x0, x1), std::min(y0, y1), std::max(x0, x1), std::max(y0, y1)};
    Path path;
    path.add_ring({box.min_x, box.min_y, box.max_x, box.min_y, box.max_x, box.max_y, box.min_x, box.max_y});
    const auto polygon = rewritten(path, random);
    const auto view = polygon.view();
    ASSERT_EQ(vesica_overlap_f64(other.kind, other.number.data(), VESICA_POLYGON, &view),
              vesica_overlap_f64(other.kind, other.number.data(), VESICA_AABB, &box))
        << i;
  }
}

/// Small things in a hole, in the ring around it, and in an island.
TEST(PolygonOverlap, HolesAndIslands) {
  Path path;
  path.add_ring({0, 0, 10, 0, 10, 10, 0, 10});
  path.add_ring({2, 2, 8, 2, 8, 8, 2, 8});
  path.add_ring({4, 4, 6, 4, 6, 6, 4, 6});
  const auto polygon = path.view();
  const auto holds = [&](double x, double y) {
    const vesica_circle_f64 disc{x, y, 0.5};
    return vesica_overlap_f64(VESICA_POLYGON, &polygon, VESICA_CIRCLE, &disc);
  };
  EXPECT_EQ(holds(1, 5), 1);
  EXPECT_EQ(holds(3, 5), 0);
  EXPECT_EQ(holds(5, 5), 1);
  EXPECT_EQ(holds(11, 5), 0);
  EXPECT_EQ(holds(2.5, 5), 1);  // it touches the hole's edge
  // Only the second ring of two is inside the other polygon.
  Path apart, far;
  apart.add_ring({20, 0, 21, 0, 20, 1});
  apart.add_ring({4.5, 4.5, 5.5, 4.5, 5, 5.5});
  EXPECT_EQ(ask(path, true, apart, true), 1);
  far.add_ring({20, 0, 21, 0, 20, 1});
  far.add_ring({2.5, 2.5, 3.5, 2.5, 3, 3.5});
  EXPECT_EQ(ask(path, true, far, true), 0);
}

TEST(PolygonOverlap, OfAMillionVertices) {
  Path a, b;
  std::vector<double> ring;
  constexpr int n = 1000000;
  for (int i = 0; i < n; ++i) {
    const double t = i * (6.283185307179586 / n), r = 1 + 0.01 * (i % 2);
    ring.push_back(r * std::cos(t));
    ring.push_back(r * std::sin(t));
  }
  a.add_ring(ring);
  for (double& c : ring) c *= 0.98;  // inside, and no edge meets
  b.add_ring(ring);
  EXPECT_EQ(ask(a, true, b, true), 1);
  EXPECT_EQ(ask(a, false, b, false), 0);
}

/// One of many rings is inside the other polygon.
TEST(PolygonOverlap, OfManyRings) {
  Path a, b;
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 50; ++j) {
      const double x = 4 * i, y = 4 * j;
      a.add_ring({x, y, x + 1, y, x + 1, y + 1, x, y + 1});
      b.add_ring({x + 2, y + 2, x + 3, y + 2, x + 3, y + 3, x + 2, y + 3});
    }
  }
  EXPECT_EQ(ask(a, true, b, true), 0);
  const double x = 4 * 59, y = 4 * 49;
  b.add_ring({x + 0.25, y + 0.25, x + 0.5, y + 0.25, x + 0.25, y + 0.5});
  EXPECT_EQ(ask(a, true, b, true), 1);
}

}  // namespace polygon_overlap
