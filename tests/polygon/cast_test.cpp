// SPDX-License-Identifier: Apache-2.0
// Casts of polygons and polylines: against all of their edges, against the exact overlap at the time, arrays, errors.
#include <gtest/gtest.h>
#include <vesica_motion.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "inflated/shapes.hpp"
#include "polygon/shapes.hpp"
#include "properties/random.hpp"

namespace polygon_cast {

using namespace polygons;

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

struct Shape {
  std::int32_t kind;
  const void* shape;
};
struct Answer {
  std::int32_t code;
  vesica_impact_f64 at;
};

inline Answer cast(const Shape& a, const Shape& b, double vx, double vy, double end) {
  Answer answer{};
  answer.code = vesica_cast_f64(a.kind, a.shape, b.kind, b.shape, vx, vy, end, &answer.at);
  return answer;
}
inline bool overlap(const Shape& a, const Shape& b) {
  return vesica_overlap_f64(a.kind, a.shape, b.kind, b.shape) == 1;
}

/// A path with its struct.
struct Held {
  Path path;
  bool closed;
  vesica_polygon_f64 view;

  Held(const Path& p, bool is_closed) : path(p), closed(is_closed), view(path.view()) {}
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;
  Shape shape() const { return {closed ? VESICA_POLYGON : VESICA_POLYLINE, &view}; }
};

inline std::vector<vesica_segment_f64> edges_of(const Held& held) {
  std::vector<vesica_segment_f64> edges;
  const std::vector<double>& xy = held.path.xy;
  const auto add = [&](std::size_t i, std::size_t j) {
    edges.push_back({xy[2 * i], xy[2 * i + 1], xy[2 * j], xy[2 * j + 1]});
  };
  for (std::size_t j = 0; j < held.path.ring_count(); ++j) {
    const auto first = static_cast<std::size_t>(held.path.rings[j]),
               last = static_cast<std::size_t>(held.path.rings[j + 1]);
    for (std::size_t i = first; i + 1 < last; ++i) add(i, i + 1);
    if (last > first && (held.closed || last - first == 1)) add(last - 1, first);
  }
  return edges;
}

/// The earliest contact of two lists of shapes, of which no two overlap, and how many have its time.
struct Earliest {
  Answer answer{VESICA_CAST_MISS, {infinity, nan, nan, nan, nan}};
  int ties = 0;

  void look(const Shape& a, const Shape& b, double vx, double vy, double end) {
    const Answer found = cast(a, b, vx, vy, end);
    if (found.code != VESICA_CAST_HIT || found.at.t > answer.at.t) return;
    ties = found.at.t == answer.at.t ? ties + 1 : 1;
    answer = found;
  }
};

inline double velocity(Random& random) { return random.chance(0.2) ? 0 : random.between(-2, 2); }
inline double end_of(Random& random) {
  return random.chance(0.1) ? 0 : random.chance(0.3) ? infinity : 4 * random.unit();
}

inline void expect_reversed(const Answer& swapped, const Answer& answer, bool same_normal, int i) {
  ASSERT_EQ(swapped.code, answer.code) << i;
  if (answer.code == VESICA_CAST_MISS) return;
  ASSERT_EQ(swapped.at.t, answer.at.t) << i;
  if (!same_normal) return;
  ASSERT_NEAR(swapped.at.nx, -answer.at.nx, 1e-12) << i;
  ASSERT_NEAR(swapped.at.ny, -answer.at.ny, 1e-12) << i;
}

inline Path any_path(Random& random) {
  if (random.chance(0.3)) {
    Path path = lattice_path(random.integer(2, 6), random);
    for (double& c : path.xy) c -= 2;
    return path;
  }
  Path path;
  path.add_ring(star(random.integer(1, 9), random.between(-3, 3), random.between(-3, 3), 1.5, 0.3, random));
  if (random.chance(0.2)) path.add_ring(star(3, 0, 0, 0.3, 0.5, random));
  return path;
}

TEST(PolygonCast, IsTheEarliestOfItsEdges) {
  Random random(590);
  std::array<int, 3> seen{};
  const int pairs = 40000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const Held held(any_path(random), random.chance(0.7));
    const inflated::Shape other = inflated::any_shape(random);
    const Shape a = held.shape(), b{other.kind, other.number.data()};
    const double vx = velocity(random), vy = velocity(random), end = end_of(random);
    const Answer answer = cast(a, b, vx, vy, end);
    ++seen[static_cast<std::size_t>(answer.code)];
    expect_reversed(cast(b, a, -vx, -vy, end), answer, true, i);
    const Held again(held.closed ? rewritten(held.path, random) : held.path, held.closed);
    const Answer same = cast(again.shape(), b, vx, vy, end);
    ASSERT_EQ(same.code, answer.code) << i;
    ASSERT_TRUE(same.at.t == answer.at.t) << i;
    ASSERT_EQ(answer.code == VESICA_CAST_START, overlap(a, b)) << i;
    if (answer.code == VESICA_CAST_START) {
      ASSERT_EQ(answer.at.t, 0) << i;
      continue;
    }
    Earliest expected;
    for (const vesica_segment_f64& e : edges_of(held)) expected.look({VESICA_SEGMENT, &e}, b, vx, vy, end);
    ASSERT_EQ(answer.code, expected.answer.code) << i;
    if (answer.code == VESICA_CAST_MISS) {
      ASSERT_EQ(answer.at.t, infinity);
      ASSERT_TRUE(std::isnan(answer.at.x) && std::isnan(answer.at.ny));
      continue;
    }
    ASSERT_EQ(answer.at.t, expected.answer.at.t) << i;
    if (expected.ties == 1) {
      ASSERT_EQ(std::memcmp(&answer.at, &expected.answer.at, sizeof answer.at), 0) << i;
    }
    ASSERT_NEAR(std::hypot(answer.at.nx, answer.at.ny), 1, 1e-12) << i;
    ASSERT_LE(answer.at.nx * vx + answer.at.ny * vy, 1e-9) << i;
  }
  for (const int count : seen) EXPECT_GT(count, pairs / 20);
}

TEST(PolygonCast, OfTwoPathsIsTheEarliestOfTheirEdges) {
  Random random(591);
  std::array<int, 3> seen{};
  const int pairs = 10000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const Held first(any_path(random), random.chance(0.7)), second(any_path(random), random.chance(0.7));
    const Shape a = first.shape(), b = second.shape();
    const double vx = random.integer(-2, 2), vy = velocity(random), end = end_of(random);
    const Answer answer = cast(a, b, vx, vy, end);
    ++seen[static_cast<std::size_t>(answer.code)];
    ASSERT_EQ(answer.code == VESICA_CAST_START, overlap(a, b)) << i;
    expect_reversed(cast(b, a, -vx, -vy, end), answer, answer.code == VESICA_CAST_HIT, i);
    if (answer.code == VESICA_CAST_START) continue;
    Earliest expected;
    for (const vesica_segment_f64& e : edges_of(first)) {
      for (const vesica_segment_f64& f : edges_of(second)) {
        expected.look({VESICA_SEGMENT, &e}, {VESICA_SEGMENT, &f}, vx, vy, end);
      }
    }
    ASSERT_EQ(answer.code, expected.answer.code) << i;
    if (answer.code == VESICA_CAST_HIT) {
      ASSERT_EQ(answer.at.t, expected.answer.at.t) << i;
    }
    if (expected.ties == 1) {
      ASSERT_EQ(std::memcmp(&answer.at, &expected.answer.at, sizeof answer.at), 0) << i;
    }
  }
  for (const int count : seen) EXPECT_GT(count, pairs / 20);
}

/// Long rings are walked by blocks of edges; the search by brute force looks at all pairs.
TEST(PolygonCast, OfManyVertices) {
  Random random(592);
  int hits = 0;
  const int pairs = 40 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    Path p, q;
    p.add_ring(star(random.integer(40, 300), 0, 0, 3, 0.6, random));
    q.add_ring(star(random.integer(3, 200), random.between(4, 9), random.between(4, 9), 2, 0.6, random));
    const Held first(p, true), second(q, random.chance(0.7));
    const double vx = random.between(-3, 0), vy = random.between(-3, 0), end = random.between(0, 6);
    const Answer answer = cast(first.shape(), second.shape(), vx, vy, end);
    Earliest expected;
    for (const vesica_segment_f64& e : edges_of(first)) {
      for (const vesica_segment_f64& f : edges_of(second)) {
        expected.look({VESICA_SEGMENT, &e}, {VESICA_SEGMENT, &f}, vx, vy, end);
      }
    }
    if (overlap(first.shape(), second.shape())) {
      ASSERT_EQ(answer.code, VESICA_CAST_START);
      continue;
    }
    hits += static_cast<int>(answer.code == VESICA_CAST_HIT);
    ASSERT_EQ(answer.code, expected.answer.code) << i;
    ASSERT_TRUE(answer.at.t == expected.answer.at.t) << i;
  }
  EXPECT_GT(hits, pairs / 4);
}

/// The shapes are apart before the time, and together after it. Coordinates are such that none is rounded when moved.
TEST(PolygonCast, AgreesWithTheExactOverlapAtItsTime) {
  Random random(593);
  int checked = 0;
  const int pairs = 20000 * properties::repeat();
  const auto moved = [](const Path& path, double way, bool& exact) {
    Path out = path;
    for (std::size_t k = 0; k < out.xy.size(); k += 2) {
      const double x = path.xy[k] + way;
      exact = exact && x - way == path.xy[k] && x - path.xy[k] == way;
      out.xy[k] = x;
    }
    return out;
  };
  for (int i = 0; i < pairs; ++i) {
    Path p, q;
    p.add_ring(star(random.integer(3, 8), 1.7, random.unit(), 0.2, 0.5, random));
    q.add_ring(star(random.integer(3, 8), 0.3, random.unit(), 0.2, 0.5, random));
    for (Path* path : {&p, &q}) {
      for (double& c : path->xy) c = std::ldexp(std::round(std::ldexp(c, 20)), -20);
    }
    const Held first(p, true), second(q, true);
    const Answer answer = cast(first.shape(), second.shape(), 1, 0, 4);
    if (answer.code != VESICA_CAST_HIT) continue;
    bool exact = true;
    const Held before(moved(q, std::nextafter(answer.at.t, 0), exact), true),
        after(moved(q, std::nextafter(answer.at.t, 2), exact), true);
    if (!exact) continue;
    ++checked;
    ASSERT_FALSE(overlap(first.shape(), before.shape())) << i;
    ASSERT_TRUE(overlap(first.shape(), after.shape())) << i;
  }
  EXPECT_GT(checked, pairs / 8);
}

/// A box as a polygon of its corners is hit as the box is, a polyline of two vertices as the segment, one of one vertex
/// as the point.
TEST(PolygonCast, OfBoxesAsPolygons) {
  Random random(594);
  int normals = 0;
  const int pairs = 30000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const inflated::Shape other = inflated::any_shape(random);
    const Shape b{other.kind, other.number.data()};
    const double x0 = random.between(-2, 2), y0 = random.chance(0.3) ? other.number[1] : random.between(-2, 2),
                 x1 = random.between(-2, 2), y1 = random.between(-2, 2);
    const double vx = velocity(random), vy = velocity(random), end = end_of(random);
    Path corners, chain, one;
    const vesica_aabb_f64 box{std::min(x0, x1), std::min(y0, y1), std::max(x0, x1), std::max(y0, y1)};
    corners.add_ring({box.min_x, box.min_y, box.max_x, box.min_y, box.max_x, box.max_y, box.min_x, box.max_y});
    chain.add_ring({x0, y0, x1, y1});
    one.add_ring({x0, y0});
    const vesica_segment_f64 segment{x0, y0, x1, y1};
    const vesica_point_f64 point{x0, y0};
    const Held polygon(rewritten(corners, random), true), polyline(chain, false), dot(one, random.chance(0.5));
    const Answer of_box = cast({VESICA_AABB, &box}, b, vx, vy, end), answer = cast(polygon.shape(), b, vx, vy, end);
    ASSERT_EQ(answer.code, of_box.code) << i;
    ASSERT_TRUE(answer.at.t == of_box.at.t) << i;
    if (answer.code == VESICA_CAST_HIT) {
      const bool smooth =
          other.kind == VESICA_CIRCLE || other.kind == VESICA_CAPSULE || other.kind == VESICA_ROUND_RECT;
      normals += static_cast<int>(smooth);
      if (smooth) {
        ASSERT_NEAR(answer.at.nx, of_box.at.nx, 1e-6) << i;
      }
      if (smooth) {
        ASSERT_NEAR(answer.at.ny, of_box.at.ny, 1e-6) << i;
      }
    }
    vesica_penetration_f64 deep{};
    EXPECT_EQ(vesica_depth_f64(VESICA_AABB, &box, b.kind, b.shape, &deep), 0);
    if (answer.code == VESICA_CAST_START && deep.depth > 1e-9) {
      ASSERT_NEAR(answer.at.nx, of_box.at.nx, 1e-9) << i;
      ASSERT_NEAR(answer.at.ny, of_box.at.ny, 1e-9) << i;
    }
    const Answer of_segment = cast({VESICA_SEGMENT, &segment}, b, vx, vy, end);
    const Answer of_polyline = cast(polyline.shape(), b, vx, vy, end);
    ASSERT_EQ(of_polyline.code, of_segment.code) << i;
    ASSERT_EQ(std::memcmp(&of_polyline.at, &of_segment.at, sizeof of_segment.at), 0) << i;
    const Answer of_point = cast(b, {VESICA_POINT, &point}, vx, vy, end), of_dot = cast(b, dot.shape(), vx, vy, end);
    ASSERT_EQ(of_dot.code, of_point.code) << i;
    ASSERT_TRUE(of_dot.at.t == of_point.at.t) << i;
  }
  EXPECT_GT(normals, pairs / 40);
}

/// Times are the same, normals too, at any scale; floats are as doubles of the same numbers, the time rounded down.
TEST(PolygonCast, ScalesAndFloats) {
  Random random(595);
  const int pairs = 5000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    Path path = any_path(random);
    std::vector<float> narrow;
    for (double& c : path.xy) {
      narrow.push_back(static_cast<float>(c));
      c = static_cast<double>(narrow.back());
    }
    const bool closed = random.chance(0.7);
    const float cx = static_cast<float>(random.between(-3, 3)), cy = static_cast<float>(random.between(-3, 3)),
                vx = static_cast<float>(velocity(random)), vy = static_cast<float>(velocity(random));
    const vesica_circle_f64 disc{static_cast<double>(cx), static_cast<double>(cy), 0.5};
    const vesica_circle_f32 narrow_disc{cx, cy, 0.5f};
    const Held held(path, closed);
    const Answer answer =
        cast(held.shape(), {VESICA_CIRCLE, &disc}, static_cast<double>(vx), static_cast<double>(vy), 3);
    vesica_polygon_f32 view{narrow.data(), narrow.data() + 1, 8, held.view.rings, held.view.count};
    vesica_impact_f32 at;
    ASSERT_EQ(vesica_cast_f32(held.shape().kind, &view, VESICA_CIRCLE, &narrow_disc, vx, vy, 3, &at), answer.code);
    if (answer.code > 0) {
      ASSERT_LE(static_cast<double>(at.t), answer.at.t);
      ASSERT_GT(static_cast<double>(std::nextafter(at.t, std::numeric_limits<float>::infinity())), answer.at.t);
      ASSERT_EQ(at.nx, static_cast<float>(answer.at.nx));
      ASSERT_EQ(at.y, static_cast<float>(answer.at.y));
    }
    const double scale = std::ldexp(1.0, random.integer(-300, 300));
    for (double& c : path.xy) c *= scale;
    const vesica_circle_f64 scaled{disc.cx * scale, disc.cy * scale, disc.r * scale};
    const Answer far = cast(Held(path, closed).shape(), {VESICA_CIRCLE, &scaled}, static_cast<double>(vx) * scale,
                            static_cast<double>(vy) * scale, 3);
    ASSERT_EQ(far.code, answer.code) << i;
    ASSERT_TRUE(far.at.t == answer.at.t) << i;
    if (answer.code == VESICA_CAST_HIT) {
      ASSERT_EQ(far.at.nx, answer.at.nx) << i;
    }
  }
}

TEST(PolygonCast, NormalsWhereEdgesMeet) {
  Path square, wedge, slot;
  square.add_ring({0, 0, 1, 0, 1, 1, 0, 1});
  const Held box(square, true);
  const auto expect = [](const Answer& answer, double t, double x, double y, double nx, double ny) {
    EXPECT_EQ(answer.code, VESICA_CAST_HIT);
    EXPECT_EQ(answer.at.t, t);
    EXPECT_NEAR(answer.at.x, x, 1e-15);
    EXPECT_NEAR(answer.at.y, y, 1e-15);
    EXPECT_NEAR(answer.at.nx, nx, 1e-15);
    EXPECT_NEAR(answer.at.ny, ny, 1e-15);
  };
  // Dead on a corner: the normal of the first edge there. Along a side, and past a corner: it slides.
  const vesica_point_f64 corner{-1, -1}, side{-1, 0};
  expect(cast(box.shape(), {VESICA_POINT, &corner}, 1, 1, 9), 1, 0, 0, 0, -1);
  expect(cast(box.shape(), {VESICA_POINT, &side}, 1, 0, 9), 1, 0, 0, 0, -1);
  expect(cast(box.shape(), {VESICA_POINT, &side}, 1, 1, infinity), 1, 0, 1, -0.70710678118654757, 0.70710678118654757);
  // A point that the wedge meets head on, and its back edge that ends there.
  wedge.add_ring({0, 0, 1, 1, 1, -1});
  const Held tip(wedge, true);
  expect(cast(tip.shape(), {VESICA_POINT, &side}, 1, 0, 9), 1, 0, 0, -0.70710678118654757, 0.70710678118654757);
  // A box moves into a slot as wide as it is: it slides on either side.
  slot.add_ring({0, 2, 5, 2});
  slot.add_ring({0, 1, 5, 1});
  const Held pipe(slot, false);
  const vesica_aabb_f64 fits{-2, 1, -1, 2};
  const Answer into = cast(pipe.shape(), {VESICA_AABB, &fits}, 1, 0, 9);
  EXPECT_EQ(into.at.t, 1);
  EXPECT_EQ(into.at.nx, 0);
  EXPECT_EQ(std::abs(into.at.ny), 1);
}

/// A shape that touches may part or not. One that is held within moves out of a convex polygon by its depth; others
/// give no normal.
TEST(PolygonCast, ContactAtTheStart) {
  Path ground, ring;
  ground.add_ring({0, 0, 2, 0, 4, 2, 6, 2});
  ring.add_ring({0, 0, 9, 0, 9, 9, 0, 9});
  const Held terrain(ground, false), zone(ring, true);
  const vesica_circle_f64 disc{1, 0.5, 0.5}, inside{4, 4, 1};
  const Answer on_ground = cast(terrain.shape(), {VESICA_CIRCLE, &disc}, 1, 1, 9);
  EXPECT_EQ(on_ground.code, VESICA_CAST_START);
  EXPECT_EQ(on_ground.at.nx, 0);
  EXPECT_EQ(on_ground.at.ny, 1);
  EXPECT_NEAR(on_ground.at.x, 1, 1e-15);
  // In the bend it touches both edges: the one that it moves into counts.
  const vesica_circle_f64 in_bend{1.5, 0.5, 0.5};
  vesica_circle_f64 both = in_bend;
  both.cx = 2 - 0.5 * std::tan(std::acos(-1.0) / 8) + 1e-9;
  const Answer right = cast(terrain.shape(), {VESICA_CIRCLE, &both}, 1, 0, 9),
               left = cast(terrain.shape(), {VESICA_CIRCLE, &both}, -1, 0, 9);
  EXPECT_NEAR(right.at.nx, -std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(left.at.ny, 1, 1e-6);
  const Answer held = cast(zone.shape(), {VESICA_CIRCLE, &inside}, 1, 0, 9);
  EXPECT_EQ(held.code, VESICA_CAST_START);
  EXPECT_EQ(held.at.x, 4);
  EXPECT_EQ(std::abs(held.at.nx) + std::abs(held.at.ny), 1);
  Path bent;
  bent.add_ring({0, 0, 9, 0, 9, 9, 5, 8.5, 0, 9});
  const Answer in_bent = cast(Held(bent, true).shape(), {VESICA_CIRCLE, &inside}, 1, 0, 9);
  EXPECT_EQ(in_bent.code, VESICA_CAST_START);
  EXPECT_EQ(in_bent.at.x, 4);
  EXPECT_EQ(in_bent.at.nx, 0);
  EXPECT_EQ(in_bent.at.ny, 0);
  EXPECT_EQ(cast({VESICA_CIRCLE, &inside}, zone.shape(), 1, 0, 9).code, VESICA_CAST_START);
  // A polyline is its edges alone.
  EXPECT_EQ(cast(Held(ring, false).shape(), {VESICA_CIRCLE, &inside}, 1, 0, 9).at.t, 4);
}

/// Neither quadratic time nor much stack, in any direction.
TEST(PolygonCast, OfManyVerticesFarApart) {
  Random random(596);
  Path p, q;
  p.add_ring(star(50000, 0, 0, 1, 0.999, random));
  q.add_ring(star(50000, 300, 400, 1, 0.999, random));
  const Held first(p, true), second(q, true);
  const auto began = std::chrono::steady_clock::now();
  EXPECT_EQ(cast(first.shape(), second.shape(), -3, -4, 200).code, VESICA_CAST_HIT);
  EXPECT_EQ(cast(first.shape(), second.shape(), 3, 4, 200).code, VESICA_CAST_MISS);
  EXPECT_EQ(cast(first.shape(), second.shape(), -3, -3.9, 200).code, VESICA_CAST_MISS);
  // All pairs of edges would take more than a minute.
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(10));
}

TEST(PolygonCast, Arrays) {
  Random random(597);
  constexpr std::size_t count = 50;
  std::vector<double> xy;
  std::array<vesica_circle_f64, count> discs;
  std::array<double, count> vx, vy;
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<double> ring = star(4, random.between(-3, 3), random.between(-3, 3), 1, 0.4, random);
    xy.insert(xy.end(), ring.begin(), ring.end());
    discs[i] = {random.between(-3, 3), random.between(-3, 3), random.unit()};
    vx[i] = random.between(-2, 2);
    vy[i] = random.between(-2, 2);
  }
  xy[8 * 7] = nan;
  vx[9] = nan;
  vesica_shapes_f64 quads{}, others;
  quads.kind = VESICA_POLYGON;
  quads.count = count;
  quads.stride = 16;
  quads.field[0] = xy.data();
  quads.field[1] = xy.data() + 1;
  quads.each = 4;
  vesica_shapes_from_records_f64(VESICA_CIRCLE, count, discs.data(), sizeof discs[0], &others);
  std::array<std::array<double, count>, 5> out;
  const auto quad = [&](std::size_t i) { return vesica_polygon_f64{&xy[8 * i], &xy[8 * i + 1], 16, nullptr, 4}; };
  for (const bool moves : {false, true}) {
    const vesica_shapes_f64 &a = moves ? others : quads, &b = moves ? quads : others;
    std::int64_t hits = 0;
    EXPECT_EQ(vesica_cast_many_f64(&a, &b, vx.data(), vy.data(), sizeof(double), 3, out[0].data(), out[1].data(),
                                   out[2].data(), out[3].data(), out[4].data()),
              VESICA_E_SHAPE);
    for (std::size_t i = 0; i < count; ++i) {
      const vesica_polygon_f64 polygon = quad(i);
      const Shape p{VESICA_POLYGON, &polygon}, c{VESICA_CIRCLE, &discs[i]};
      const Answer expected = moves ? cast(c, p, vx[i], vy[i], 3) : cast(p, c, vx[i], vy[i], 3);
      if (expected.code < 0) {
        EXPECT_EQ(expected.code, i == 7 ? VESICA_E_SHAPE : VESICA_E_ARGUMENT);
        EXPECT_TRUE(std::isnan(out[0][i]) && std::isnan(out[4][i]));
        continue;
      }
      hits += static_cast<std::int64_t>(expected.code > 0);
      const double found[] = {out[0][i], out[1][i], out[2][i], out[3][i], out[4][i]};
      EXPECT_EQ(std::memcmp(found, &expected.at, sizeof found), 0) << i;
    }
    EXPECT_GT(hits, 0);
    EXPECT_LT(hits, static_cast<std::int64_t>(count));
  }
  // The first of many, and of polygons among them.
  xy[8 * 7] = xy[8 * 7 + 2];
  vesica_shapes_f64 one;
  const vesica_circle_f64 disc{-9, 0, 0.5};
  vesica_shapes_from_records_f64(VESICA_CIRCLE, 1, &disc, sizeof disc, &one);
  vesica_impact_f64 first;
  const std::int64_t found = vesica_cast_first_f64(&one, &quads, 1, 0.125, 99, &first);
  ASSERT_GE(found, 0);
  ASSERT_LT(found, static_cast<std::int64_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const vesica_polygon_f64 polygon = quad(i);
    const Answer each = cast({VESICA_POLYGON, &polygon}, {VESICA_CIRCLE, &disc}, 1, 0.125, 99);
    EXPECT_GE(each.at.t, first.t) << i;
    if (static_cast<std::int64_t>(i) == found) {
      EXPECT_EQ(std::memcmp(&each.at, &first, sizeof first), 0);
    }
  }
  // A polygon moves among discs.
  quads.count = 1;
  ASSERT_GE(vesica_cast_first_f64(&quads, &others, 1, 0.125, 99, &first), 0);
  xy[0] = nan;
  EXPECT_EQ(vesica_cast_first_f64(&quads, &others, 1, 0.125, 99, &first), VESICA_E_SHAPE);
}

TEST(PolygonCast, BadInput) {
  std::vector<double> xy{0, 0, 1, 0, 1, 1};
  vesica_polygon_f64 polygon{xy.data(), xy.data() + 1, 16, nullptr, 3};
  const vesica_circle_f64 disc{5, 0, 1}, negative{5, 0, -1};
  vesica_impact_f64 out{9, 9, 9, 9, 9};
  const auto ask = [&](const vesica_polygon_f64* p, std::int32_t kind, const void* other, double vx, double end) {
    return vesica_cast_f64(VESICA_POLYGON, p, kind, other, vx, 0, end, &out);
  };
  EXPECT_EQ(ask(&polygon, VESICA_CIRCLE, &negative, -1, 9), VESICA_E_SHAPE);
  EXPECT_EQ(ask(&polygon, VESICA_CIRCLE, &disc, nan, 9), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(&polygon, VESICA_CIRCLE, &disc, -1, nan), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(&polygon, VESICA_CIRCLE, &disc, -1, -1), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(&polygon, 10, &disc, -1, 9), VESICA_E_KIND);
  EXPECT_EQ(ask(nullptr, VESICA_CIRCLE, &disc, -1, 9), VESICA_E_NULL);
  EXPECT_EQ(vesica_cast_f64(VESICA_CIRCLE, &disc, VESICA_POLYGON, &polygon, 1, 0, 9, nullptr), VESICA_E_NULL);
  const std::vector<std::int32_t> rings{0, 2, 1};
  polygon.rings = rings.data();
  polygon.count = 2;
  EXPECT_EQ(ask(&polygon, VESICA_CIRCLE, &disc, -1, 9), VESICA_E_SHAPE);
  EXPECT_EQ(ask(&polygon, VESICA_POLYGON, &polygon, -1, 9), VESICA_E_SHAPE);
  polygon = {xy.data(), xy.data() + 1, 16, nullptr, 3};
  xy[3] = nan;
  EXPECT_EQ(ask(&polygon, VESICA_CIRCLE, &disc, -1, 9), VESICA_E_SHAPE);
  EXPECT_EQ(out.t, 9);
  EXPECT_EQ(out.ny, 9);
}

TEST(PolygonCast, SweptBounds) {
  Path path;
  path.add_ring({0, 0, 1, 0, 1, 1});
  const Held held(path, true);
  vesica_aabb_f64 box{9, 9, 9, 9};
  EXPECT_EQ(vesica_sweep_bounds_f64(VESICA_POLYGON, &held.view, 1, -2, 4, &box), 0);
  EXPECT_EQ(box.min_x, 0);
  EXPECT_EQ(box.max_y, 1);
  EXPECT_NEAR(box.max_x, 5, 1e-14);
  EXPECT_GE(box.max_x, 5);
  EXPECT_LE(box.min_y, -8);
  box.min_x = 9;
  EXPECT_EQ(vesica_sweep_bounds_f64(VESICA_POLYGON, &held.view, nan, 0, 4, &box), VESICA_E_ARGUMENT);
  EXPECT_EQ(box.min_x, 9);
}

}  // namespace polygon_cast
