// SPDX-License-Identifier: Apache-2.0
// Depth of convex polygons: against rectangles, against support functions in all directions, exact contact, convexity.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "inflated/shapes.hpp"
#include "polygon/shapes.hpp"
#include "properties/random.hpp"

namespace polygon_depth {

using namespace polygons;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Answer {
  std::int32_t code;
  vesica_penetration_f64 at;
};
inline Answer depth(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b) {
  Answer answer{0, {9, 9, 9}};
  answer.code = vesica_depth_f64(kind_a, a, kind_b, b, &answer.at);
  return answer;
}
inline Answer depth(const Path& a, const Path& b) {
  const auto p = a.view(), q = b.view();
  return depth(VESICA_POLYGON, &p, VESICA_POLYGON, &q);
}

struct Vector {
  double x, y;
};

/// The most that a shape reaches along a unit vector, by the definition of each kind.
inline double support(const inflated::Shape& s, Vector n) {
  const inflated::Numbers& f = s.number;
  const auto along = [&](double x, double y) { return x * n.x + y * n.y; };
  const double u = f[2] * n.x + f[3] * n.y, w = f[2] * n.y - f[3] * n.x;
  switch (s.kind) {
    case VESICA_POINT:
      return along(f[0], f[1]);
    case VESICA_CIRCLE:
      return along(f[0], f[1]) + f[2];
    case VESICA_SEGMENT:
    case VESICA_CAPSULE:
      return std::max(along(f[0], f[1]), along(f[2], f[3])) + (s.kind == VESICA_CAPSULE ? f[4] : 0);
    case VESICA_AABB:
      return std::max(f[0] * n.x, f[2] * n.x) + std::max(f[1] * n.y, f[3] * n.y);
    case VESICA_ELLIPSE:
      return along(f[0], f[1]) + std::hypot(f[4] * u, f[5] * w);
    default:
      return along(f[0], f[1]) + std::abs(f[4] * u) + std::abs(f[5] * w) + (s.kind == VESICA_ROUND_RECT ? f[6] : 0);
  }
}
inline double support(const Path& p, Vector n) {
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < p.xy.size(); i += 2) most = std::max(most, p.xy[i] * n.x + p.xy[i + 1] * n.y);
  return most;
}
/// How far b must move along n until n separates it from a.
template <class A, class B>
double reach(const A& a, const B& b, Vector n) {
  return support(a, n) + support(b, {-n.x, -n.y});
}

/// The vertices are on an ellipse, in order: convex up to rounding, which a test asks for.
inline Path round_path(int n, double cx, double cy, Random& random) {
  std::vector<double> angles(static_cast<std::size_t>(n)), ring;
  for (double& a : angles) a = random.between(0, 6.283185307179586);
  std::sort(angles.begin(), angles.end());
  const double wide = random.between(0.1, 2), high = random.between(0.1, 2), turn = random.between(0, 6);
  for (const double a : angles) {
    const double x = wide * std::cos(a), y = high * std::sin(a);
    ring.push_back(cx + x * std::cos(turn) - y * std::sin(turn));
    ring.push_back(cy + x * std::sin(turn) + y * std::cos(turn));
  }
  Path path;
  path.add_ring(ring);
  return path;
}

/// The direction reaches the depth, and no other one less: neither those all round nor the normals of edges.
template <class Other>
void expect_least(const Path& a, const Other& b, const vesica_penetration_f64& found, int i) {
  ASSERT_NEAR(std::hypot(found.x, found.y), 1, 1e-15) << i;
  ASSERT_NEAR(reach(a, b, {found.x, found.y}), found.depth, 1e-14) << i;
  for (int k = 0; k < 128; ++k) {
    const double turn = k * (6.283185307179586 / 128);
    ASSERT_GE(reach(a, b, {std::cos(turn), std::sin(turn)}), found.depth - 1e-14) << i;
  }
  const std::size_t n = a.xy.size();
  for (std::size_t k = 0; k < n; k += 2) {
    const double x = a.xy[(k + 3) % n] - a.xy[k + 1], y = a.xy[k] - a.xy[(k + 2) % n], length = std::hypot(x, y);
    if (!(length > 1e-6)) continue;
    ASSERT_GE(reach(a, b, {x / length, y / length}), found.depth - 1e-14) << i;
    ASSERT_GE(reach(a, b, {-x / length, -y / length}), found.depth - 1e-14) << i;
  }
}

TEST(PolygonDepth, IsTheLeastReach) {
  Random random(600);
  int deep = 0;
  const int pairs = 20000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const Path path =
        rewritten(round_path(random.integer(3, 12), random.between(-3, 3), random.between(-3, 3), random), random);
    const inflated::Shape other = inflated::any_shape(random);
    const auto view = path.view();
    const Answer answer = depth(VESICA_POLYGON, &view, other.kind, other.number.data());
    if (answer.code == VESICA_E_NOT_CONVEX) continue;  // by rounding
    ASSERT_EQ(answer.code, 0) << i;
    const Answer swapped = depth(other.kind, other.number.data(), VESICA_POLYGON, &view);
    ASSERT_EQ(swapped.at.depth, answer.at.depth) << i;
    ASSERT_EQ(swapped.at.x, 0 - answer.at.x) << i;
    ASSERT_EQ(swapped.at.y, 0 - answer.at.y) << i;
    const bool met = vesica_overlap_f64(VESICA_POLYGON, &view, other.kind, other.number.data()) == 1;
    ASSERT_EQ(answer.at.x != 0 || answer.at.y != 0, met) << i;
    if (!met) continue;
    ++deep;
    expect_least(path, other, answer.at, i);
  }
  EXPECT_GT(deep, pairs / 20);
}

/// Vertices at integers, of which hulls are made, in contact with ellipses exactly, often. A ring that is closed by its
/// first vertex, or repeats vertices, had a depth where it touches from outside.
TEST(PolygonDepth, OfAClosedRingThatTouchesAnEllipse) {
  const std::vector<vesica_ellipse_f64> ellipses{{-3, 3, 0, 1, 2, 2}, {3, -2, 1, 1, 1, 1}, {1, -2, 1, 0, 1, 0.5}};
  const std::vector<std::vector<double>> rings{
      {-3, 1, -1, -1, 1, 0, -1, 1}, {-1, -2, 2, -1, 2, 0}, {-3, -2, 0, -3, 0, -2}};
  for (std::size_t i = 0; i < ellipses.size(); ++i) {
    const std::vector<double>& xy = rings[i];
    std::vector<double> closed = xy, doubled;
    closed.insert(closed.end(), {xy[0], xy[1]});
    for (std::size_t k = 0; k < xy.size(); k += 2) doubled.insert(doubled.end(), {xy[k], xy[k + 1], xy[k], xy[k + 1]});
    for (const std::vector<double>& ring : {xy, closed, doubled}) {
      Path path;
      path.add_ring(ring);
      const auto view = path.view();
      const Answer answer = depth(VESICA_POLYGON, &view, VESICA_ELLIPSE, &ellipses[i]);
      ASSERT_EQ(answer.code, 0) << i;
      EXPECT_EQ(answer.at.depth, 0) << i;
      EXPECT_NEAR(std::hypot(answer.at.x, answer.at.y), 1, 1e-15) << i;
      EXPECT_EQ(vesica_interiors_overlap_f64(VESICA_POLYGON, &view, VESICA_ELLIPSE, &ellipses[i]), 0) << i;
    }
  }
}

/// Disjoint shapes have no depth and no direction; shapes that touch have no depth and a direction; others have both.
TEST(PolygonDepth, DisjointIsNoOverlap) {
  Random random(602);
  std::array<int, 3> seen{};
  const int pairs = 20000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    inflated::Shape other = inflated::any_shape(random);
    for (double& number : other.number) number = std::round(2 * number) / 2;
    if (vesica_check_f64(other.kind, other.number.data()) != 0) continue;
    const double x = random.integer(-3, 2), y = random.integer(-3, 2);
    const double wide = random.integer(1, 3), high = random.integer(1, 3);
    Path path;
    path.add_ring(random.chance(0.5) ? std::vector<double>{x, y, x + wide, y, x + wide, y + high, x, y + high}
                                     : std::vector<double>{x, y, x + wide, y, x + wide, y, x, y + high});
    path = rewritten(path, random);
    const auto view = path.view();
    const std::int32_t relation = vesica_relation_f64(VESICA_POLYGON, &view, other.kind, other.number.data());
    const bool met = vesica_overlap_f64(VESICA_POLYGON, &view, other.kind, other.number.data()) == 1;
    const bool insides = vesica_interiors_overlap_f64(VESICA_POLYGON, &view, other.kind, other.number.data()) == 1;
    const Answer answer = depth(VESICA_POLYGON, &view, other.kind, other.number.data());
    ASSERT_EQ(answer.code, 0) << i;
    ASSERT_EQ(relation != VESICA_DISJOINT, met) << i;
    ASSERT_EQ(answer.at.x != 0 || answer.at.y != 0, met) << i;
    ASSERT_EQ(answer.at.depth > 0, insides) << i;
    ++seen[met ? insides ? 2 : 1 : 0];
  }
  for (const int count : seen) EXPECT_GT(count, pairs / 100);
}

TEST(PolygonDepth, OfTwoPolygons) {
  Random random(601);
  int deep = 0;
  const int pairs = 10000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const Path a = rewritten(round_path(random.integer(3, 30), 0, 0, random), random),
               b = rewritten(round_path(random.integer(3, 30), random.between(-2, 2), random.between(-2, 2), random),
                             random);
    const Answer answer = depth(a, b), swapped = depth(b, a);
    if (answer.code == VESICA_E_NOT_CONVEX) continue;
    ASSERT_EQ(answer.code, 0) << i;
    ASSERT_EQ(swapped.at.depth, answer.at.depth) << i;
    ASSERT_EQ(swapped.at.x, 0 - answer.at.x) << i;
    if (answer.at.x == 0 && answer.at.y == 0) continue;
    ++deep;
    expect_least(a, b, answer.at, i);
  }
  EXPECT_GT(deep, pairs / 20);
}

/// A box as a polygon of its corners, in contact exactly, often.
TEST(PolygonDepth, OfBoxesAsPolygons) {
  Random random(602);
  std::array<int, 3> seen{};
  const int pairs = 40000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const inflated::Shape other = inflated::any_shape(random);
    double x0 = random.between(-2, 2), y0 = random.between(-2, 2);
    const double x1 = random.between(-2, 2), y1 = random.between(-2, 2);
    if (random.chance(0.3)) x0 = other.number[0];
    if (random.chance(0.3)) y0 = other.number[1];
    const vesica_aabb_f64 box{std::min(x0, x1), std::min(y0, y1), std::max(x0, x1), std::max(y0, y1)};
    Path corners, chain;
    corners.add_ring({box.min_x, box.min_y, box.max_x, box.min_y, box.max_x, box.max_y, box.min_x, box.max_y});
    chain.add_ring({x0, y0, x1, y1});
    const Path path = rewritten(corners, random);
    const auto view = path.view();
    const Answer of_box = depth(VESICA_AABB, &box, other.kind, other.number.data());
    const Answer answer = depth(VESICA_POLYGON, &view, other.kind, other.number.data());
    ASSERT_EQ(answer.code, 0) << i;
    ASSERT_NEAR(answer.at.depth, of_box.at.depth, 64 * 0x1p-53) << i;
    ASSERT_EQ(answer.at.depth == 0, of_box.at.depth == 0) << i << " kind " << other.kind;
    ASSERT_EQ(answer.at.x == 0 && answer.at.y == 0, of_box.at.x == 0 && of_box.at.y == 0) << i;
    const bool met = of_box.at.x != 0 || of_box.at.y != 0;
    ++seen[!met ? 0u : of_box.at.depth == 0 ? 1u : 2u];
    const vesica_segment_f64 segment{x0, y0, x1, y1};
    const auto line = chain.view<vesica_polyline_f64>();
    const Answer of_segment = depth(VESICA_SEGMENT, &segment, other.kind, other.number.data());
    const Answer of_line = depth(VESICA_POLYLINE, &line, other.kind, other.number.data());
    ASSERT_EQ(of_line.at.depth, of_segment.at.depth) << i;
  }
  EXPECT_GT(seen[0], pairs / 10);
  EXPECT_GT(seen[1], pairs / 100);
  EXPECT_GT(seen[2], pairs / 10);
}

/// Integers decide whether two convex polygons have common insides.
TEST(PolygonDepth, IsZeroExactly) {
  Random random(603);
  std::array<int, 2> seen{};
  const int pairs = 60000 * properties::repeat();
  const auto draw = [&random](int shift) {
    Path path;
    std::vector<double> ring = lattice_ring(3, 6, random);
    for (std::size_t k = 0; k < ring.size(); k += 2) ring[k] += shift;
    path.add_ring(ring);
    return path;
  };
  // Twice the area of a vertex over an edge of a triangle, positive on its inside.
  const auto height = [](const Path& t, std::size_t e, double x, double y) {
    const auto v = [&t](std::size_t k) { return Vector{t.xy[2 * (k % 3)], t.xy[2 * (k % 3) + 1]}; };
    const auto area = [](Vector p, Vector q, Vector r) {
      return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    };
    const double turn = area(v(0), v(1), v(2));
    return (turn > 0 ? 1 : -1) * area(v(e), v(e + 1), {x, y});
  };
  const auto area = [](const Path& t) {
    return (t.xy[2] - t.xy[0]) * (t.xy[5] - t.xy[1]) - (t.xy[3] - t.xy[1]) * (t.xy[4] - t.xy[0]);
  };
  for (int i = 0; i < pairs; ++i) {
    Path a = draw(0), b = draw(random.below(5));
    if (area(a) == 0 || area(b) == 0) continue;
    bool parted = false;
    for (std::size_t e = 0; e < 3; ++e) {
      bool by_a = true, by_b = true;
      for (std::size_t k = 0; k < 6; k += 2) {
        by_a = by_a && height(a, e, b.xy[k], b.xy[k + 1]) <= 0;
        by_b = by_b && height(b, e, a.xy[k], a.xy[k + 1]) <= 0;
      }
      parted = parted || by_a || by_b;
    }
    const double scale = std::ldexp(1.0, random.integer(-1040, 1000));
    for (Path* path : {&a, &b}) {
      for (double& c : path->xy) c *= scale;
    }
    const Answer answer = depth(a, b);
    ASSERT_EQ(answer.code, 0) << i;
    ASSERT_EQ(answer.at.depth > 0, !parted) << i;
    const bool met = answer.at.x != 0 || answer.at.y != 0;
    if (met) ++seen[parted ? 0u : 1u];
  }
  for (const int count : seen) EXPECT_GT(count, pairs / 50);
}

TEST(PolygonDepth, Convexity) {
  const vesica_circle_f64 disc{0.5, 0.5, 1};
  const auto code = [&](const Path& path, bool closed = true) {
    const auto view = path.view();
    return depth(closed ? VESICA_POLYGON : VESICA_POLYLINE, &view, VESICA_CIRCLE, &disc).code;
  };
  const auto ring = [](const std::vector<double>& xy) {
    Path path;
    path.add_ring(xy);
    return path;
  };
  EXPECT_EQ(code(ring({0, 0, 1, 0, 2, 0, 2, 2, 0, 2, 0, 1, 0, 0})), 0);  // collinear, closed
  EXPECT_EQ(code(ring({0, 0, 0, 0, 1, 0, 1, 0, 1, 1})), 0);              // repeated
  EXPECT_EQ(code(ring({0, 0, 2, 0, 1, 0.5, 0, 2})), VESICA_E_NOT_CONVEX);
  EXPECT_EQ(code(ring({0, 0, 2, 0, 3, 0, 2, 0, 1, 2})), VESICA_E_NOT_CONVEX);                    // a spike
  EXPECT_EQ(code(ring({0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 0, 1, 1, 0, 1})), VESICA_E_NOT_CONVEX);  // twice round
  EXPECT_EQ(code(ring({0, 0, 2, 2, 2, 0, 0, 2})), VESICA_E_NOT_CONVEX);                          // it crosses itself
  EXPECT_EQ(code(ring({1, 0, -0.8, 0.6, 0.3, -0.95, 0.3, 0.95, -0.8, -0.6})), VESICA_E_NOT_CONVEX);  // a pentagram
  EXPECT_EQ(code(ring({0, 0, 2, 2, 1, 1})), 0);                                                      // on one line
  EXPECT_EQ(code(ring({0, 0, 1, 0, 1, 1}), false), VESICA_E_NOT_CONVEX);
  EXPECT_EQ(code(ring({0, 0, 1, 0}), false), 0);
  EXPECT_EQ(code(ring({0, 0}), false), 0);
  Path holed = ring({0, 0, 9, 0, 9, 9, 0, 9});
  holed.add_ring({1, 1, 2, 1, 2, 2});
  EXPECT_EQ(code(holed), VESICA_E_NOT_CONVEX);
  // By an ulp.
  const double above = std::nextafter(1.0, 2.0), below = std::nextafter(1.0, 0.0);
  EXPECT_EQ(code(ring({0, 0, 1, below, 2, 2, 0, 2})), 0);
  EXPECT_EQ(code(ring({0, 0, 1, above, 2, 2, 0, 2})), VESICA_E_NOT_CONVEX);
}

/// The search for the last edge went on before the first vertex where no edge had a length in the pair's unit: with a
/// triangle 2^-500 wide in an ellipse 2^600 wide.
TEST(PolygonDepth, TinyInAHugeShape) {
  const double w = 0x1p-500;
  Path tiny;
  tiny.add_ring({0, 0, 0, w, w, 0});
  const auto view = tiny.view();
  const vesica_ellipse_f64 ellipse{0, 0, 1, 0, 0x1p600, 0x1p599};
  const vesica_round_rect_f64 rounded{0, 0, 1, 0, 0x1p600, 0x1p599, 0x1p598};
  vesica_penetration_f64 p{};
  ASSERT_EQ(vesica_depth_f64(VESICA_POLYGON, &view, VESICA_ELLIPSE, &ellipse, &p), 0);
  EXPECT_EQ(p.depth, 0x1p599);
  ASSERT_EQ(vesica_depth_f64(VESICA_POLYGON, &view, VESICA_ROUND_RECT, &rounded, &p), 0);
  EXPECT_EQ(p.depth, 0x1.8p599);
}

TEST(PolygonDepth, OfManyVertices) {
  std::vector<double> ring;
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i) {
    ring.push_back(std::cos(i * (6.283185307179586 / n)));
    ring.push_back(std::sin(i * (6.283185307179586 / n)));
  }
  Path a, b;
  a.add_ring(ring);
  for (std::size_t k = 0; k < ring.size(); k += 2) ring[k] += 1.25;
  b.add_ring(ring);
  const vesica_ellipse_f64 ellipse{1.25, 0, 1, 0, 0.5, 0.25};
  const auto view = a.view();
  const Answer answer = depth(a, b), of_ellipse = depth(VESICA_POLYGON, &view, VESICA_ELLIPSE, &ellipse);
  EXPECT_EQ(answer.code, 0);
  EXPECT_NEAR(answer.at.depth, 0.75, 1e-7);
  EXPECT_NEAR(answer.at.x, 1, 1e-6);
  EXPECT_NEAR(of_ellipse.at.depth, 0.25, 1e-7);
}

TEST(PolygonDepth, ArraysAndFloats) {
  const std::vector<double> xy{0, 0, 2, 0, 2, 2, 0, 2, 0, 0, 2, 0, 1, 0.5, 0, 2, 4, 0, 6, 0, 6, 2, 4, nan};
  vesica_shapes_f64 quads{}, others;
  quads.kind = VESICA_POLYGON;
  quads.count = 3;
  quads.stride = 16;
  quads.field[0] = xy.data();
  quads.field[1] = xy.data() + 1;
  quads.each = 4;
  const vesica_circle_f64 disc{1.75, 1, 0.5};
  vesica_shapes_from_records_f64(VESICA_CIRCLE, 1, &disc, sizeof disc, &others);
  std::array<double, 3> out{}, x{}, y{};
  EXPECT_EQ(vesica_depth_many_f64(&quads, &others, out.data(), x.data(), y.data()), VESICA_E_SHAPE);
  EXPECT_EQ(out[0], 0.75);
  EXPECT_EQ(x[0], 1);
  EXPECT_TRUE(std::isnan(out[1]) && std::isnan(out[2]));
  const std::vector<float> narrow{0, 0, 2, 0, 2, 2, 0, 2};
  const vesica_polygon_f32 polygon{narrow.data(), narrow.data() + 1, 8, nullptr, 4};
  const vesica_circle_f32 narrow_disc{1.75f, 1, 0.5f};
  vesica_penetration_f32 found;
  EXPECT_EQ(vesica_depth_f32(VESICA_CIRCLE, &narrow_disc, VESICA_POLYGON, &polygon, &found), 0);
  EXPECT_EQ(found.depth, 0.75f);
  EXPECT_EQ(found.x, -1);
}

}  // namespace polygon_depth
