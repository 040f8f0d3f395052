// SPDX-License-Identifier: Apache-2.0
// vesica_check of polygons: do edges cross or overlap?
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "polygon/cells.hpp"
#include "polygon/oracle.hpp"
#include "polygon/shapes.hpp"
#include "properties/random.hpp"

namespace polygon_simple {

using namespace polygons;

inline std::int32_t check(const Path& path) {
  const auto view = path.view();
  return vesica_check_f64(VESICA_POLYGON, &view);
}
inline std::int32_t check(const std::vector<double>& ring) {
  Path path;
  path.add_ring(ring);
  return check(path);
}

TEST(PolygonSimple, KnownRings) {
  EXPECT_EQ(check({0, 0, 1, 0, 1, 1, 0, 1}), 0);
  EXPECT_EQ(check({0, 0, 0, 0, 1, 0, 1, 1, 1, 1, 0, 1, 0, 0}), 0);
  EXPECT_EQ(check({2, 3}), 0);
  EXPECT_EQ(check({0, 0, 1, 1}), 0);
  EXPECT_EQ(check({0, 0, 0, 0, 1, 1, 1, 1}), 0);
  EXPECT_EQ(check({0, 0, 1, 1, 1, 0, 0, 1}), VESICA_E_NOT_SIMPLE);              // edges cross
  EXPECT_EQ(check({0, 0, 1, 1, 2, 2, 2, 0, 1, 1, 0, 2}), VESICA_E_NOT_SIMPLE);  // at a vertex of both
  EXPECT_EQ(check({0, 0, 2, 2, 2, 0, 1, 1, 0, 2}), VESICA_E_NOT_SIMPLE);        // at a vertex of one
  EXPECT_EQ(check({0, 0, 4, 0, 4, 4, 2, 0, 0, 4}), 0);                          // a vertex touches an edge
  EXPECT_EQ(check({0, 0, 2, 0, 4, 0, 4, 4, 2, 0, 0, 4}), 0);                    // a vertex touches a vertex
  EXPECT_EQ(check({0, 0, 4, 0, 2, 0, 2, 2}), VESICA_E_NOT_SIMPLE);              // there and back
  EXPECT_EQ(check({0, 0, 1, 0, 2, 0}), VESICA_E_NOT_SIMPLE);
  EXPECT_EQ(check({0, 0, 1, 1, 0, 0, 1, 1}), VESICA_E_NOT_SIMPLE);
}

TEST(PolygonSimple, KnownHoles) {
  Path path;
  path.add_ring({0, 0, 8, 0, 8, 8, 0, 8});
  path.add_ring({2, 2, 6, 2, 6, 6, 2, 6});
  EXPECT_EQ(check(path), 0);
  path.add_ring({6, 6, 7, 6, 7, 7});  // touches the other hole
  EXPECT_EQ(check(path), 0);
  path.add_ring({0, 4, 1, 3, 1, 5});  // touches the shell
  EXPECT_EQ(check(path), 0);
  Path crossing = path;
  crossing.add_ring({7.5, 1, 8.5, 1, 7.5, 2});
  EXPECT_EQ(check(crossing), VESICA_E_NOT_SIMPLE);
  Path sharing = path;
  sharing.add_ring({8, 1, 8, 2, 7.5, 1});
  EXPECT_EQ(check(sharing), VESICA_E_NOT_SIMPLE);
  Path twice = path;
  twice.add_ring({2, 2, 6, 2, 6, 6, 2, 6});
  EXPECT_EQ(check(twice), VESICA_E_NOT_SIMPLE);
}

/// Every pair of edges, and every pair of passes through one point by the order of their directions.
inline bool is_simple(const Path& path) {
  struct Pass {
    Lattice before, at, after;
  };
  const auto edges = lattice_edges(path, true);
  const auto equal = [](Lattice p, Lattice q) { return p.x == q.x && p.y == q.y; };
  std::vector<Pass> passes;
  for (std::size_t j = 0; j < path.ring_count(); ++j) {
    std::vector<Lattice> ring;
    for (std::int32_t i = path.rings[j]; i < path.rings[j + 1]; ++i) {
      const auto k = static_cast<std::size_t>(2 * i);
      const Lattice p{static_cast<std::int64_t>(path.xy[k]), static_cast<std::int64_t>(path.xy[k + 1])};
      if (ring.empty() || !equal(ring.back(), p)) ring.push_back(p);
    }
    while (ring.size() > 1 && equal(ring.front(), ring.back())) ring.pop_back();
    const std::size_t n = ring.size();
    // A segment there and back counts as one edge, which has no passes.
    for (std::size_t i = 0; n > 2 && i < n; ++i) passes.push_back({ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]});
    if (n == 2) passes.push_back({ring[0], ring[1], ring[1]});
  }
  std::vector<LatticeEdge> proper;
  for (const Pass& p : passes) {
    if (area_sign(p.before, p.at, p.after) == 0 && !equal(p.at, p.after) &&
        (p.at.x - p.before.x) * (p.after.x - p.at.x) + (p.at.y - p.before.y) * (p.after.y - p.at.y) < 0) {
      return false;
    }
    proper.push_back({p.before, p.at});
  }
  for (std::size_t i = 0; i < proper.size(); ++i) {
    for (std::size_t j = i + 1; j < proper.size(); ++j) {
      const LatticeEdge &e = proper[i], &f = proper[j];
      const int s0 = area_sign(e.from, e.to, f.from), s1 = area_sign(e.from, e.to, f.to),
                t0 = area_sign(f.from, f.to, e.from), t1 = area_sign(f.from, f.to, e.to);
      if (s0 * s1 < 0 && t0 * t1 < 0) return false;
      if (s0 != 0 || s1 != 0) continue;
      // On one line: do they share more than a point?
      int ends = 0;
      for (const Lattice& p : {f.from, f.to}) ends += is_on(p, e) && !equal(p, e.from) && !equal(p, e.to) ? 2 : 0;
      for (const Lattice& p : {e.from, e.to}) ends += is_on(p, f) && !equal(p, f.from) && !equal(p, f.to) ? 2 : 0;
      const bool same_edge =
          (equal(e.from, f.from) && equal(e.to, f.to)) || (equal(e.from, f.to) && equal(e.to, f.from));
      if (ends > 0 || same_edge) return false;
    }
  }
  // All passes through a point, also those straight through an edge.
  const auto angle = [](Lattice at, Lattice to) {
    return std::atan2(static_cast<double>(to.y - at.y), static_cast<double>(to.x - at.x));
  };
  for (const Pass& p : passes) {
    if (equal(p.at, p.after)) continue;
    for (std::size_t k = 0; k < passes.size(); ++k) {
      const Pass& q = passes[k];
      Pass other = q;
      if (&q == &p) continue;
      if (!equal(q.at, p.at)) {
        const LatticeEdge e{q.before, q.at};
        if (!is_on(p.at, e) || equal(p.at, e.from)) continue;
        other = {e.from, p.at, e.to};
      }
      if (equal(other.at, other.after)) continue;
      const double low = std::min(angle(p.at, p.before), angle(p.at, p.after)),
                   high = std::max(angle(p.at, p.before), angle(p.at, p.after));
      const auto between = [&](Lattice to) { return angle(p.at, to) > low && angle(p.at, to) < high; };
      if (between(other.before) != between(other.after)) return false;
    }
  }
  return true;
}

TEST(PolygonSimple, AgreesWithIntegers) {
  Random random(598);
  int simple = 0;
  const int count = 40000 * properties::repeat();
  for (int i = 0; i < count; ++i) {
    Path path = lattice_path(random.integer(3, 8), random);
    if (random.chance(0.3)) {
      const Grid grid(random.integer(1, 2));
      path = region(grid, 0.6, random).path;
    }
    const bool expected = is_simple(path);
    simple += static_cast<int>(expected);
    const double scale = std::ldexp(1.0, random.integer(-1060, 1000));
    for (double& c : path.xy) c *= scale;
    ASSERT_EQ(check(path), expected ? 0 : VESICA_E_NOT_SIMPLE) << i;
    ASSERT_EQ(check(rewritten(path, random)), expected ? 0 : VESICA_E_NOT_SIMPLE) << i;
  }
  EXPECT_GT(simple, count / 8);
  EXPECT_LT(simple, count * 7 / 8);
}

/// A long outline, and the same with two of its places exchanged.
TEST(PolygonSimple, OfManyVertices) {
  std::vector<double> ring;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double t = i * (6.283185307179586 / n), r = 1 + 0.01 * (i % 2);
    ring.insert(ring.end(), {r * std::cos(t), r * std::sin(t)});
  }
  EXPECT_EQ(check(ring), 0);
  std::swap(ring[n], ring[n + 8]);
  std::swap(ring[n + 1], ring[n + 9]);
  EXPECT_EQ(check(ring), VESICA_E_NOT_SIMPLE);
}

inline vesica_facts_f64 facts_of(const Path& path) {
  const auto view = path.view();
  vesica_facts_f64 facts{};
  EXPECT_EQ(vesica_polygon_facts_f64(&view, &facts), 0);
  const std::vector<float> narrow(path.xy.begin(), path.xy.end());
  const vesica_polygon_f32 narrow_view{narrow.data(), narrow.data() + 1, 8, view.rings, view.count};
  vesica_facts_f32 same{};
  EXPECT_EQ(vesica_polygon_facts_f32(&narrow_view, &same), 0);
  EXPECT_EQ(same.vertices, facts.vertices);
  EXPECT_EQ(same.first_crossing, facts.first_crossing);
  EXPECT_EQ(same.second_crossing, facts.second_crossing);
  EXPECT_EQ(static_cast<double>(same.area), facts.area);
  EXPECT_EQ(same.orientation, facts.orientation);
  EXPECT_EQ(same.convex, facts.convex);
  EXPECT_EQ(same.simple, facts.simple);
  EXPECT_EQ(same.rings, facts.rings);
  return facts;
}

TEST(PolygonFacts, Known) {
  Path frame;
  frame.add_ring({0, 0, 4, 0, 4, 4, 4, 4, 0, 4, 0, 0});
  vesica_facts_f64 f = facts_of(frame);
  EXPECT_EQ(f.vertices, 4);
  EXPECT_EQ(f.area, 16);
  EXPECT_EQ(f.orientation, 1);
  EXPECT_EQ(f.convex, 1);
  EXPECT_EQ(f.simple, 1);
  EXPECT_EQ(f.first_crossing, -1);
  EXPECT_EQ(f.second_crossing, -1);
  EXPECT_EQ(f.rings, 1);
  frame.add_ring({1, 1, 2, 1, 2, 2, 1, 2});
  f = facts_of(frame);
  EXPECT_EQ(f.vertices, 8);
  EXPECT_EQ(f.area, 15);
  EXPECT_EQ(f.orientation, 1);
  EXPECT_EQ(f.convex, 0);
  EXPECT_EQ(f.rings, 2);
  Path bow;
  bow.add_ring({0, 0, 4, 4, 4, 0, 0, 2});
  f = facts_of(bow);
  EXPECT_EQ(f.simple, 0);
  EXPECT_EQ(f.first_crossing, 0);
  EXPECT_EQ(f.second_crossing, 2);
  EXPECT_EQ(f.convex, 0);
  Path line;
  line.add_ring({0, 0, 3, 1});
  f = facts_of(line);
  EXPECT_EQ(f.vertices, 2);
  EXPECT_EQ(f.area, 0);
  EXPECT_EQ(f.orientation, 0);
  EXPECT_EQ(f.convex, 1);
  Path point;
  point.add_ring({7, 7, 7, 7});
  EXPECT_EQ(facts_of(point).vertices, 1);
  // A hole that comes first has the inside of the polygon around it.
  Path hole;
  hole.add_ring({1, 1, 2, 1, 2, 2});
  hole.add_ring({0, 0, 4, 0, 4, 4, 0, 4});
  EXPECT_EQ(facts_of(hole).orientation, -1);
  EXPECT_EQ(facts_of(hole).area, -15.5);
}

/// Rings at integers: the edges named do meet; area, direction and convexity by sums and signs of integers.
TEST(PolygonFacts, AgreeWithIntegers) {
  Random random(603);
  int convex = 0, crossed = 0;
  const int count = 20000 * properties::repeat();
  for (int i = 0; i < count; ++i) {
    Path path;
    path.add_ring(lattice_ring(random.integer(3, 6), random.integer(3, 8), random));
    path = rewritten(path, random);
    const vesica_facts_f64 f = facts_of(path);
    const auto edges = lattice_edges(path, true);
    ASSERT_EQ(f.simple, is_simple(path)) << i;
    ASSERT_EQ(f.simple == 0, f.first_crossing >= 0 && f.first_crossing < f.second_crossing) << i;
    if (f.simple == 0) {
      const auto at = [&](std::int64_t k) { return edges[static_cast<std::size_t>(k)]; };
      ASSERT_TRUE(meet(at(f.first_crossing), at(f.second_crossing))) << i;
      ++crossed;
      continue;
    }
    std::int64_t twice = 0, places = 0;
    std::vector<Lattice> ring;
    for (const LatticeEdge& e : edges) {
      twice += e.from.x * e.to.y - e.from.y * e.to.x;
      if (e.from.x == e.to.x && e.from.y == e.to.y) continue;
      ++places;
      ring.push_back(e.from);
    }
    bool left = false, right = false;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const int turn = area_sign(ring[k], ring[(k + 1) % ring.size()], ring[(k + 2) % ring.size()]);
      left = left || turn > 0;
      right = right || turn < 0;
    }
    ASSERT_EQ(f.vertices, std::max<std::int64_t>(places, 1)) << i;
    ASSERT_EQ(f.area, static_cast<double>(twice) / 2) << i;
    ASSERT_EQ(f.orientation, (twice > 0) - (twice < 0)) << i;
    ASSERT_EQ(f.convex, !(left && right)) << i;
    convex += f.convex;
  }
  EXPECT_GT(convex, count / 20);
  EXPECT_GT(crossed, count / 20);
}

/// Regions of a grid, with holes: the triangle on the left of the first edge, and the number of triangles.
TEST(PolygonFacts, OfRegions) {
  Random random(604);
  const int count = 2000 * properties::repeat();
  for (int i = 0; i < count; ++i) {
    const Grid grid(random.integer(1, 4));
    Figure figure = region(grid, random.between(0.2, 0.9), random);
    const vesica_facts_f64 f = facts_of(figure.path);
    const auto inside = std::count(figure.triangle.begin(), figure.triangle.end(), in);
    ASSERT_EQ(std::abs(f.area), static_cast<double>(inside)) << i;
    ASSERT_EQ(f.area > 0, f.orientation > 0) << i;
    ASSERT_EQ(f.simple, is_simple(figure.path)) << i;
    ASSERT_EQ(f.rings, static_cast<std::int32_t>(figure.path.ring_count())) << i;
    // Reversed, the direction is the other one, and nothing else changes.
    Path reversed;
    for (std::size_t j = 0; j < figure.path.ring_count(); ++j) {
      std::vector<double> ring;
      for (std::int32_t k = figure.path.rings[j + 1] - 1; k >= figure.path.rings[j]; --k) {
        const auto at = static_cast<std::size_t>(2 * k);
        ring.insert(ring.end(), {figure.path.xy[at], figure.path.xy[at + 1]});
      }
      reversed.add_ring(ring);
    }
    const vesica_facts_f64 back = facts_of(reversed);
    ASSERT_EQ(back.orientation, -f.orientation) << i;
    ASSERT_EQ(back.area, -f.area) << i;
    ASSERT_EQ(back.vertices, f.vertices) << i;
    ASSERT_EQ(back.convex, f.convex) << i;
  }
}

TEST(PolygonFacts, Errors) {
  const std::vector<double> xy{0, 0, 1e308, 0, 1e308, 1e308};
  vesica_polygon_f64 big{xy.data(), xy.data() + 1, 16, nullptr, 3};
  vesica_facts_f64 facts{};
  facts.vertices = 77;
  EXPECT_EQ(vesica_polygon_facts_f64(nullptr, &facts), VESICA_E_NULL);
  EXPECT_EQ(vesica_polygon_facts_f64(&big, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_polygon_facts_f64(&big, &facts), VESICA_E_RANGE);
  big.count = 0;
  EXPECT_EQ(vesica_polygon_facts_f64(&big, &facts), VESICA_E_SHAPE);
  big.x = nullptr;
  EXPECT_EQ(vesica_polygon_facts_f64(&big, &facts), VESICA_E_NULL);
  EXPECT_EQ(facts.vertices, 77);
}

TEST(PolygonSimple, PolylinesMayCross) {
  const std::vector<double> xy{0, 0, 1, 1, 1, 0, 0, 1};
  const vesica_polyline_f64 line{xy.data(), xy.data() + 1, 16, nullptr, 4};
  EXPECT_EQ(vesica_check_f64(VESICA_POLYLINE, &line), 0);
}

}  // namespace polygon_simple
