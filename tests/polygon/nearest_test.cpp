// SPDX-License-Identifier: Apache-2.0
// nearest, boundary_distance and signed_distance.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "inflated/shapes.hpp"
#include "polygon/distance_oracle.hpp"
#include "polygon/shapes.hpp"
#include "properties/random.hpp"

namespace polygon_nearest {

using namespace polygons;
using Closest = vesica_closest_points_f64;
using Function = std::int32_t (*)(std::int32_t, const void*, std::int32_t, const void*, Closest*);

constexpr double u = 0x1p-53, infinity = std::numeric_limits<double>::infinity();
constexpr std::array<Function, 2> functions{vesica_nearest_f64, vesica_boundary_distance_f64};

/// A shape as the C functions take it.
struct Given {
  std::int32_t kind;
  const void* shape;
};
inline Given given(const inflated::Shape& s) { return {s.kind, s.number.data()}; }
inline Given given(const vesica_polygon_f64& s, bool closed) { return {closed ? VESICA_POLYGON : VESICA_POLYLINE, &s}; }

inline Closest ask(Function function, const Given& a, const Given& b) {
  Closest c{-1, 0, 0, 0, 0};
  EXPECT_EQ(function(a.kind, a.shape, b.kind, b.shape, &c), 0);
  return c;
}
inline Closest exchanged(const Closest& c) { return {c.distance, c.bx, c.by, c.ax, c.ay}; }
inline bool same_bits(const Closest& a, const Closest& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

inline std::vector<vesica_segment_f64> edges_of(const Path& path, bool closed) {
  std::vector<vesica_segment_f64> edges;
  for (std::size_t j = 0; j < path.ring_count(); ++j) {
    const auto first = static_cast<std::size_t>(path.rings[j]), last = static_cast<std::size_t>(path.rings[j + 1]);
    const auto add = [&](std::size_t i, std::size_t k) {
      edges.push_back({path.xy[2 * i], path.xy[2 * i + 1], path.xy[2 * k], path.xy[2 * k + 1]});
    };
    for (std::size_t i = first; i + 1 < last; ++i) add(i, i + 1);
    if (last > first && (closed || last - first == 1)) add(last - 1, first);
  }
  return edges;
}

/// The distances of a point from a shape and from its outline.
inline double distance_from(double x, double y, const Given& s, Function function) {
  const vesica_point_f64 point{x, y};
  return ask(function, {VESICA_POINT, &point}, s).distance;
}

/// Small lattices: vertices coincide, lie on edges, and many pairs are equally close.
TEST(PolygonNearest, AgreesWithIntegers) {
  Random random(159);
  int met = 0, nested = 0;
  const int pairs = 30000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const int size = random.integer(2, 30);
    Path a = lattice_path(size, random), b = lattice_path(random.integer(2, size), random);
    const bool closed_a = random.chance(0.7), closed_b = random.chance(0.7);
    const int far = random.chance(0.5) ? 6 : 40;
    const double shift_x = random.below(far), shift_y = random.below(far);
    for (std::size_t k = 0; k < b.xy.size(); k += 2) b.xy[k] += shift_x, b.xy[k + 1] += shift_y;
    const Fraction outlines = squared_outline_distance(lattice_edges(a, closed_a), lattice_edges(b, closed_b));
    const bool overlapping = overlap(a, closed_a, b, closed_b);
    met += static_cast<int>(overlapping);
    nested += static_cast<int>(overlapping && outlines.over != 0);

    const double unit = std::ldexp(1.0, random.integer(-30, 30));
    for (Path* path : {&a, &b}) {
      for (double& c : path->xy) c *= unit;
    }
    const auto view_a = a.view(), view_b = b.view();
    const Given first = given(view_a, closed_a), second = given(view_b, closed_b);
    // No coordinate of an offset, and no half length, exceeds 100 units.
    const double scale = 100 * unit;
    for (const Function function : functions) {
      const bool zero = function == vesica_nearest_f64 ? overlapping : outlines.over == 0;
      const long double expected = zero ? 0 : root(outlines) * unit;
      const Closest c = ask(function, first, second);
      ASSERT_EQ(c.distance == 0, zero) << i;
      ASSERT_NEAR(static_cast<double>((c.distance - expected) / scale), 0, 4 * u) << i;
      ASSERT_TRUE(same_bits(ask(function, second, first), exchanged(c))) << i;
      // The points are of their shapes, or of their outlines, and that far apart.
      ASSERT_LE(distance_from(c.ax, c.ay, first, function), 8 * u * scale) << i;
      ASSERT_LE(distance_from(c.bx, c.by, second, function), 8 * u * scale) << i;
      ASSERT_NEAR(std::hypot(c.ax - c.bx, c.ay - c.by) / scale, c.distance / scale, 12 * u) << i;
      if (zero) {
        ASSERT_TRUE(c.ax == c.bx && c.ay == c.by) << i;
      }
      // The same set, written otherwise.
      const Path other = closed_a ? rewritten(a, random) : a;
      const auto other_view = other.view();
      const Closest again = ask(function, given(other_view, closed_a), second);
      ASSERT_EQ(again.distance == 0, zero) << i;
      ASSERT_NEAR(again.distance / scale, c.distance / scale, 4 * u) << i;
    }
    double signed_distance = 77;
    const std::int32_t code =
        vesica_signed_distance_f64(first.kind, first.shape, second.kind, second.shape, &signed_distance);
    if (overlapping) {
      vesica_penetration_f64 depth{};
      ASSERT_EQ(code, vesica_depth_f64(first.kind, first.shape, second.kind, second.shape, &depth));
      ASSERT_EQ(signed_distance, code == 0 ? 0 - depth.depth : 77);
    } else {
      ASSERT_EQ(code, 0);
      ASSERT_EQ(signed_distance, ask(vesica_nearest_f64, first, second).distance);
    }
  }
  EXPECT_GT(met, pairs / 10);
  EXPECT_LT(met, pairs * 9 / 10);
  EXPECT_GT(nested, pairs / 500);
}

/// The least of all pairs of edges, bit for bit, with its points. Of equal ones it is the first, in the order of one of
/// the two shapes.
inline void expect_least(Function function, const std::vector<vesica_segment_f64>& a,
                         const std::vector<vesica_segment_f64>& b, const Closest& c) {
  std::array<Closest, 2> least{Closest{infinity, 0, 0, 0, 0}, Closest{infinity, 0, 0, 0, 0}};
  for (std::size_t order = 0; order < 2; ++order) {
    const auto &outer = order == 0 ? a : b, &inner = order == 0 ? b : a;
    for (const vesica_segment_f64& e : outer) {
      for (const vesica_segment_f64& f : inner) {
        const Closest pair = ask(function, {VESICA_SEGMENT, &e}, {VESICA_SEGMENT, &f});
        if (pair.distance < least[order].distance) least[order] = pair;
      }
    }
  }
  ASSERT_EQ(c.distance, least[0].distance);
  ASSERT_TRUE(same_bits(c, least[0]) || same_bits(c, exchanged(least[1])));
}

/// Long outlines take the walk over blocks; points on a lattice have ties.
TEST(PolygonNearest, IsTheLeastOfAllPairs) {
  Random random(160);
  const int pairs = 60 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    Path a, b;
    const int n = random.integer(2, 200), m = random.integer(2, 200), grid = random.integer(2, 30);
    const double turn = random.between(0, 6.28), far = random.between(1.9, 4);
    a.add_ring(star(n, 0, 0, 1, 0.6, random));
    b.add_ring(star(m, far * std::cos(turn), far * std::sin(turn), 1, 0.6, random));
    if (random.chance(0.4)) b.add_ring(star(50, far, far, 0.3, 0.6, random));
    if (random.chance(0.5)) {
      for (Path* path : {&a, &b}) {
        for (double& c : path->xy) c = std::round(c * grid);
      }
    }
    const bool closed_a = random.chance(0.7), closed_b = random.chance(0.7);
    const auto view_a = a.view(), view_b = b.view();
    const Given first = given(view_a, closed_a), second = given(view_b, closed_b);
    const Closest c = ask(vesica_boundary_distance_f64, first, second);
    ASSERT_TRUE(same_bits(ask(vesica_boundary_distance_f64, second, first), exchanged(c)));
    if (c.distance == 0) continue;
    expect_least(vesica_nearest_f64, edges_of(a, closed_a), edges_of(b, closed_b), c);
    if (vesica_overlap_f64(first.kind, first.shape, second.kind, second.shape) == 0) {
      ASSERT_TRUE(same_bits(ask(vesica_nearest_f64, first, second), c));
    }
  }
}

/// With a shape of every other kind: the first of the closest edges, bit for bit.
TEST(PolygonNearest, IsTheLeastOverEdgesOfOtherKinds) {
  Random random(161);
  const int pairs = 4000 * properties::repeat();
  std::array<int, 2> apart{};
  for (int i = 0; i < pairs; ++i) {
    const inflated::Shape other = inflated::shape(i % 8, random);
    const int n = random.chance(0.5) ? random.integer(1, 40) : random.integer(40, 400);
    Path a;
    // About the other shape, within it, or beside it.
    const bool nested = random.chance(0.3);
    const double x = nested ? other.number[0] : random.between(-3, 3),
                 y = nested ? other.number[1] : random.between(-3, 3);
    a.add_ring(star(n, x, y, nested ? random.between(2, 6) : std::exp(random.between(-3, 1.5)), 0.6, random));
    if (random.chance(0.3)) a.add_ring(star(20, 0, 0, 0.3, 0.6, random));
    const bool closed = random.chance(0.7);
    const auto view = a.view();
    const Given path = given(view, closed), shape = given(other);
    const auto edges = edges_of(a, closed);
    const bool overlapping = vesica_overlap_f64(path.kind, path.shape, shape.kind, shape.shape) == 1;
    for (std::size_t k = 0; k < 2; ++k) {
      const Closest c = ask(functions[k], path, shape);
      ASSERT_TRUE(same_bits(ask(functions[k], shape, path), exchanged(c)));
      Closest least{infinity, 0, 0, 0, 0};
      for (const vesica_segment_f64& e : edges) {
        const Closest pair = ask(functions[k], {VESICA_SEGMENT, &e}, shape);
        if (pair.distance < least.distance) least = pair;
      }
      if (k == 0) {
        ASSERT_EQ(c.distance == 0, overlapping) << i;
      }
      if (c.distance == 0) {
        // A common point of both, or of both outlines.
        ASSERT_LE(distance_from(c.ax, c.ay, path, functions[k]), 1e-14) << i;
        ASSERT_LE(distance_from(c.bx, c.by, shape, functions[k]), 1e-14) << i;
        if (k == 1) {
          ASSERT_EQ(least.distance, 0) << i;
        }
        continue;
      }
      ++apart[k];
      ASSERT_TRUE(same_bits(c, least)) << i << ' ' << k << ' ' << c.distance - least.distance;
    }
  }
  EXPECT_GT(apart[0], pairs / 4);
  EXPECT_GT(apart[1], apart[0] + pairs / 20);
}

/// A box as a polygon of its corners, a chain of two vertices as the segment, a ring of two or one as well.
TEST(PolygonNearest, OfBoxesAsPolygons) {
  Random random(162);
  const int pairs = 30000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const inflated::Shape drawn = inflated::any_shape(random);
    const Given other = given(drawn);
    double x0 = random.between(-3, 3), y0 = random.between(-3, 3), x1 = random.between(-3, 3),
           y1 = random.between(-3, 3);
    // Often in contact with a stored number.
    if (random.chance(0.2)) x0 = drawn.number[0];
    if (random.chance(0.2)) y1 = drawn.number[1];
    const vesica_segment_f64 segment{x0, y0, x1, y1};
    const vesica_point_f64 point{x0, y0};
    const vesica_aabb_f64 box{std::min(x0, x1), std::min(y0, y1), std::max(x0, x1), std::max(y0, y1)};
    const vesica_rect_f64 rect{0.5, -0.25, 3, 4, 0.125, 0.25};  // its corners are exact
    Path chain, one, corners, turned;
    chain.add_ring({x0, y0, x1, y1});
    one.add_ring({x0, y0});
    corners.add_ring({box.min_x, box.min_y, box.max_x, box.min_y, box.max_x, box.max_y, box.min_x, box.max_y});
    turned.add_ring({-0.875, 0, -0.125, 1, 1.875, -0.5, 1.125, -1.5});
    const auto line = chain.view(), dot = one.view(), polygon = corners.view(), turned_polygon = turned.view();
    for (const Function function : functions) {
      const Closest of_segment = ask(function, {VESICA_SEGMENT, &segment}, other);
      ASSERT_TRUE(same_bits(ask(function, {VESICA_POLYLINE, &line}, other), of_segment)) << i;
      const auto expect_near = [&](const Closest& c, const Closest& expected) {
        ASSERT_EQ(c.distance == 0, expected.distance == 0) << i;
        ASSERT_NEAR(c.distance, expected.distance, 8 * u * 10) << i;
      };
      expect_near(ask(function, {VESICA_POLYGON, &line}, other), of_segment);
      expect_near(ask(function, {VESICA_POLYGON, &dot}, other), ask(function, {VESICA_POINT, &point}, other));
      expect_near(ask(function, {VESICA_POLYGON, &polygon}, other), ask(function, {VESICA_AABB, &box}, other));
      expect_near(ask(function, {VESICA_POLYGON, &turned_polygon}, other), ask(function, {VESICA_RECT, &rect}, other));
    }
  }
}

/// A float is a double exactly, and the result is rounded once.
TEST(PolygonNearest, OfFloats) {
  Random random(163);
  const int pairs = 3000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    std::array<std::vector<float>, 2> narrow;
    std::array<std::vector<double>, 2> wide;
    for (std::size_t k = 0; k < 2; ++k) {
      for (const double c : star(random.integer(1, 20), 2 * static_cast<double>(k), 0, 1.3, 0.3, random)) {
        narrow[k].push_back(static_cast<float>(c));
        wide[k].push_back(static_cast<double>(narrow[k].back()));
      }
    }
    std::array<vesica_polygon_f32, 2> p32{};
    std::array<vesica_polygon_f64, 2> p64{};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto count = static_cast<std::int64_t>(narrow[k].size() / 2);
      p32[k] = {narrow[k].data(), narrow[k].data() + 1, 8, nullptr, count};
      p64[k] = {wide[k].data(), wide[k].data() + 1, 16, nullptr, count};
    }
    const vesica_circle_f32 disc{static_cast<float>(random.between(-2, 4)), 1, 0.25f};
    const vesica_circle_f64 wide_disc{static_cast<double>(disc.cx), 1, 0.25};
    const auto expect_rounded = [&](const vesica_closest_points_f32& c, const Closest& w) {
      ASSERT_EQ(c.distance, static_cast<float>(w.distance));
      ASSERT_EQ(c.ax, static_cast<float>(w.ax));
      ASSERT_EQ(c.ay, static_cast<float>(w.ay));
      ASSERT_EQ(c.bx, static_cast<float>(w.bx));
      ASSERT_EQ(c.by, static_cast<float>(w.by));
    };
    vesica_closest_points_f32 c;
    ASSERT_EQ(vesica_nearest_f32(VESICA_POLYGON, p32.data(), VESICA_POLYLINE, &p32[1], &c), 0);
    expect_rounded(c, ask(vesica_nearest_f64, {VESICA_POLYGON, p64.data()}, {VESICA_POLYLINE, &p64[1]}));
    ASSERT_EQ(vesica_boundary_distance_f32(VESICA_CIRCLE, &disc, VESICA_POLYGON, &p32[1], &c), 0);
    expect_rounded(c, ask(vesica_boundary_distance_f64, {VESICA_CIRCLE, &wide_disc}, {VESICA_POLYGON, &p64[1]}));
    float signed_distance = 77;
    if (vesica_signed_distance_f32(VESICA_CIRCLE, &disc, VESICA_POLYGON, &p32[1], &signed_distance) == 0) {
      const Closest w = ask(vesica_nearest_f64, {VESICA_CIRCLE, &wide_disc}, {VESICA_POLYGON, &p64[1]});
      // It is below 0 where they overlap.
      ASSERT_EQ(std::max(signed_distance, 0.0f), static_cast<float>(w.distance));
    } else {
      ASSERT_EQ(signed_distance, 77);
    }
  }
}

/// A disc in a hole, in the ring around it, in the island, and an outline around everything.
TEST(PolygonNearest, HolesAndIslands) {
  Path path;
  path.add_ring({0, 0, 20, 0, 20, 20, 0, 20});
  path.add_ring({4, 4, 16, 4, 16, 16, 4, 16});
  path.add_ring({8, 8, 12, 8, 12, 12, 8, 12});
  const auto polygon = path.view();
  const auto distances = [&](double x, double y, double r) {
    const vesica_circle_f64 disc{x, y, r};
    const Given a{VESICA_POLYGON, &polygon}, b{VESICA_CIRCLE, &disc};
    return std::array<double, 2>{ask(vesica_nearest_f64, a, b).distance,
                                 ask(vesica_boundary_distance_f64, a, b).distance};
  };
  using Two = std::array<double, 2>;
  EXPECT_EQ(distances(5.5, 10, 0.5), (Two{1, 1}));     // in the hole
  EXPECT_EQ(distances(2, 10, 0.5), (Two{0, 1.5}));     // in the ring
  EXPECT_EQ(distances(10, 10, 0.25), (Two{0, 1.75}));  // in the island
  EXPECT_EQ(distances(30, 10, 2), (Two{8, 8}));        // outside
  EXPECT_EQ(distances(10, 10, 100)[0], 0);             // around
  EXPECT_NEAR(distances(10, 10, 100)[1], 100 - std::sqrt(200), 1e-13);
  // A polygon in the hole, one around the island.
  Path inner, around;
  inner.add_ring({5, 9, 7, 9, 7, 11, 5, 11});
  around.add_ring({7, 7, 13, 7, 13, 13, 7, 13});
  const auto a = inner.view(), b = around.view();
  EXPECT_EQ(ask(vesica_nearest_f64, {VESICA_POLYGON, &a}, {VESICA_POLYGON, &polygon}).distance, 1);
  EXPECT_EQ(ask(vesica_nearest_f64, {VESICA_POLYGON, &b}, {VESICA_POLYGON, &polygon}).distance, 0);
  EXPECT_EQ(ask(vesica_nearest_f64, {VESICA_POLYLINE, &b}, {VESICA_POLYGON, &polygon}).distance, 1);
  EXPECT_EQ(ask(vesica_boundary_distance_f64, {VESICA_POLYGON, &b}, {VESICA_POLYGON, &polygon}).distance, 1);
}

/// Coordinates whose squares or differences are beyond the range of double.
TEST(PolygonNearest, AtTheEndsOfTheRange) {
  Path a, b;
  a.add_ring({0, 0, 2, 0, 2, 3, 0, 3});
  b.add_ring({5, 7, 8, 7, 8, 9, 5, 9});
  for (const int exponent : {-1060, -600, 600, 1019}) {
    const double unit = std::ldexp(1.0, exponent);
    Path p = a, q = b;
    for (Path* path : {&p, &q}) {
      for (double& c : path->xy) c *= unit;
    }
    const auto first = p.view(), second = q.view();
    const Closest c = ask(vesica_nearest_f64, {VESICA_POLYGON, &first}, {VESICA_POLYGON, &second});
    EXPECT_EQ(c.distance, 5 * unit);
    EXPECT_EQ(c.ax, 2 * unit);
    EXPECT_EQ(c.by, 7 * unit);
    EXPECT_EQ(vesica_within_f64(VESICA_POLYGON, &first, VESICA_POLYGON, &second, 5 * unit), VESICA_WITHIN_YES);
    EXPECT_EQ(vesica_within_f64(VESICA_POLYGON, &first, VESICA_POLYGON, &second, 4.999 * unit), VESICA_WITHIN_NO);
  }
  // The nearest edges are too far apart for a number; then only some are.
  const double most = std::numeric_limits<double>::max();
  const std::vector<double> left{-most, 0, -most, 1}, right{most, 0, most, 1, most / 8, 0};
  vesica_polygon_f64 p{left.data(), left.data() + 1, 16, nullptr, 2}, q{right.data(), right.data() + 1, 16, nullptr, 2};
  Closest c{9, 9, 9, 9, 9};
  EXPECT_EQ(vesica_nearest_f64(VESICA_POLYGON, &p, VESICA_POLYGON, &q, &c), VESICA_E_RANGE);
  EXPECT_EQ(c.distance, 9);
  q.count = 3;
  const vesica_point_f64 middle{0, 0};
  EXPECT_EQ(vesica_nearest_f64(VESICA_POLYLINE, &q, VESICA_POINT, &middle, &c), 0);
  EXPECT_EQ(c.distance, most / 8);
}

TEST(PolygonNearest, OfAMillionVertices) {
  constexpr int n = 1000000;
  Path a, b;
  std::vector<double> ring;
  for (int i = 0; i < n; ++i) {
    const double t = i * (6.283185307179586 / n), r = 1 + 0.01 * (i % 2);
    ring.push_back(r * std::cos(t));
    ring.push_back(r * std::sin(t));
  }
  a.add_ring(ring);
  for (std::size_t k = 0; k < ring.size(); k += 2) ring[k] += 3;
  b.add_ring(ring);
  const auto first = a.view(), second = b.view();
  // Vertex n/2 lies at (-1, 0) of b's centre, its neighbours at -1.01 cos t.
  const Closest c = ask(vesica_nearest_f64, {VESICA_POLYGON, &first}, {VESICA_POLYGON, &second});
  EXPECT_NEAR(c.distance, 3 - 2 * 1.01, 1e-10);
  const vesica_ellipse_f64 ellipse{3, 0, 0.6, 0.8, 1, 0.5};
  const Closest e = ask(vesica_nearest_f64, {VESICA_POLYGON, &first}, {VESICA_ELLIPSE, &ellipse});
  const vesica_circle_f64 disc{0, 0, 1.01};
  EXPECT_NEAR(e.distance, ask(vesica_nearest_f64, {VESICA_CIRCLE, &disc}, {VESICA_ELLIPSE, &ellipse}).distance, 1e-8);
}

TEST(PolygonNearest, Arrays) {
  Random random(164);
  constexpr std::size_t n = 40;
  std::vector<double> xy;
  for (std::size_t i = 0; i < n; ++i) {
    const auto ring = star(4, random.between(-3, 3), random.between(-3, 3), 1, 0.3, random);
    xy.insert(xy.end(), ring.begin(), ring.end());
  }
  xy[8 * 7 + 3] = std::numeric_limits<double>::quiet_NaN();
  vesica_shapes_f64 quads{};
  quads.kind = VESICA_POLYGON;
  quads.count = n;
  quads.stride = 16;
  quads.field[0] = xy.data();
  quads.field[1] = xy.data() + 1;
  quads.each = 4;
  const inflated::Columns<double> columns(VESICA_CAPSULE, n, random);
  const vesica_shapes_f64 capsules = inflated::array(columns);
  std::array<std::vector<double>, 5> out;
  for (auto& column : out) column.assign(n, 77);
  std::vector<double> matrix(n * n, 77), signed_distances(n, 77);
  EXPECT_EQ(vesica_nearest_many_f64(&quads, &capsules, out[0].data(), out[1].data(), out[2].data(), out[3].data(),
                                    out[4].data()),
            VESICA_E_SHAPE);
  EXPECT_EQ(vesica_boundary_distance_matrix_f64(&capsules, &quads, matrix.data(), n), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_signed_distance_many_f64(&quads, &capsules, signed_distances.data()), VESICA_E_SHAPE);
  for (std::size_t i = 0; i < n; ++i) {
    const vesica_polygon_f64 quad{xy.data() + 8 * i, xy.data() + 8 * i + 1, 16, nullptr, 4};
    if (i == 7) {
      for (const auto& column : out) EXPECT_TRUE(std::isnan(column[i]));
      EXPECT_TRUE(std::isnan(matrix[i]) && std::isnan(signed_distances[i]));
      Closest c{9, 9, 9, 9, 9};
      EXPECT_EQ(vesica_nearest_f64(VESICA_POLYGON, &quad, VESICA_CAPSULE, columns.at(i).number.data(), &c),
                VESICA_E_SHAPE);
      EXPECT_EQ(c.ax, 9);
      continue;
    }
    const inflated::Shape capsule = columns.at(i);
    const Closest c = ask(vesica_nearest_f64, {VESICA_POLYGON, &quad}, given(capsule));
    EXPECT_TRUE(same_bits(c, {out[0][i], out[1][i], out[2][i], out[3][i], out[4][i]}));
    double signed_distance = 0;
    const std::int32_t code =
        vesica_signed_distance_f64(VESICA_POLYGON, &quad, VESICA_CAPSULE, capsule.number.data(), &signed_distance);
    EXPECT_TRUE(code == 0 ? signed_distances[i] == signed_distance : std::isnan(signed_distances[i]));
    for (std::size_t j = 0; j < n; ++j) {
      const inflated::Shape other = columns.at(j);
      EXPECT_EQ(matrix[j * n + i], ask(vesica_boundary_distance_f64, {VESICA_POLYGON, &quad}, given(other)).distance);
    }
  }
}

}  // namespace polygon_nearest
