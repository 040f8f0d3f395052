// SPDX-License-Identifier: Apache-2.0
// Places where outlines of polygons and polylines meet: against fractions of integers, boxes, and each edge alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "inflated/shapes.hpp"
#include "polygon/oracle.hpp"
#include "polygon/shapes.hpp"
#include "properties/random.hpp"

namespace polygon_crossings {

using namespace polygons;

using Places = std::vector<std::pair<double, double>>;
struct Answer {
  std::int64_t count;
  std::int32_t shared;
  Places places;
};
inline Answer crossings(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b) {
  std::array<vesica_point_f64, 256> room{};
  Answer answer{0, 9, {}};
  answer.count = vesica_crossings_f64(kind_a, a, kind_b, b, room.data(), room.size(), &answer.shared);
  for (std::int64_t i = 0; i < answer.count; ++i) {
    const vesica_point_f64& p = room[static_cast<std::size_t>(i)];
    answer.places.emplace_back(p.x, p.y);
  }
  return answer;
}
inline Places sorted(Places places) {
  std::sort(places.begin(), places.end());
  return places;
}
/// The same places in any order, to within 1e-9.
inline bool alike(const Places& p, Places q) {
  for (const auto& [x, y] : p) {
    const auto found = std::find_if(q.begin(), q.end(), [x = x, y = y](const auto& at) {
      return std::abs(at.first - x) < 1e-9 && std::abs(at.second - y) < 1e-9;
    });
    if (found == q.end()) return false;
    q.erase(found);
  }
  return q.empty();
}

TEST(PolygonCrossings, Known) {
  Path square, other;
  square.add_ring({0, 0, 4, 0, 4, 4, 0, 4});
  other.add_ring({2, 2, 6, 2, 6, 6, 2, 6});
  const auto a = square.view(), b = other.view();
  Answer answer = crossings(VESICA_POLYGON, &a, VESICA_POLYGON, &b);
  EXPECT_EQ(answer.places, (Places{{4, 2}, {2, 4}}));
  EXPECT_EQ(answer.shared, 0);
  answer = crossings(VESICA_POLYGON, &a, VESICA_POLYGON, &a);
  EXPECT_EQ(answer.places, (Places{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  EXPECT_EQ(answer.shared, 1);
  const vesica_circle_f64 disc{0, 0, 4}, inner{2, 2, 2}, apart{9, 9, 1};
  EXPECT_EQ(crossings(VESICA_POLYGON, &a, VESICA_CIRCLE, &disc).places, (Places{{4, 0}, {0, 4}}));
  EXPECT_EQ(crossings(VESICA_CIRCLE, &inner, VESICA_POLYGON, &a).places, (Places{{2, 0}, {4, 2}, {2, 4}, {0, 2}}));
  EXPECT_EQ(crossings(VESICA_POLYGON, &a, VESICA_CIRCLE, &apart).count, 0);
  EXPECT_EQ(crossings(VESICA_POLYLINE, &a, VESICA_CIRCLE, &inner).places, (Places{{2, 0}, {4, 2}, {2, 4}}));
  const vesica_ellipse_f64 ellipse{2, 2, 1, 0, 3, 1};
  EXPECT_EQ(crossings(VESICA_POLYGON, &a, VESICA_ELLIPSE, &ellipse).count, 4);
  const vesica_capsule_f64 capsule{1, 1, 3, 1, 1};
  answer = crossings(VESICA_POLYGON, &a, VESICA_CAPSULE, &capsule);
  EXPECT_EQ(answer.places, (Places{{1, 0}, {3, 0}, {4, 1}, {0, 1}}));
  EXPECT_EQ(answer.shared, 1);
}

TEST(PolygonCrossings, RoomAndErrors) {
  Path square, other;
  square.add_ring({0, 0, 4, 0, 4, 4, 0, 4});
  other.add_ring({2, 2, 6, 2, 6, 6, 2, 6});
  const auto a = square.view(), b = other.view();
  std::array<vesica_point_f64, 2> room{{{7, 7}, {7, 7}}};
  std::int32_t shared = 9;
  EXPECT_EQ(vesica_crossings_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, room.data(), 1, nullptr), 2);
  EXPECT_EQ(room[0].x, 4);
  EXPECT_EQ(room[1].x, 7);
  EXPECT_EQ(vesica_crossings_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, nullptr, 0, &shared), 2);
  EXPECT_EQ(shared, 0);
  EXPECT_EQ(vesica_crossings_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, nullptr, 1, &shared), VESICA_E_NULL);
  EXPECT_EQ(vesica_crossings_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, room.data(), -1, &shared), VESICA_E_ARGUMENT);
  const vesica_circle_f64 invalid{0, 0, -1};
  EXPECT_EQ(vesica_crossings_f64(VESICA_POLYGON, &a, VESICA_CIRCLE, &invalid, room.data(), 2, &shared), VESICA_E_SHAPE);
  const std::vector<float> xy{0, 0, 4, 0, 4, 4, 0, 4};
  const vesica_polygon_f32 narrow{xy.data(), xy.data() + 1, 8, nullptr, 4};
  const vesica_segment_f32 segment{1, -1, 1, 9};
  std::array<vesica_point_f32, 2> narrow_room{};
  EXPECT_EQ(vesica_crossings_f32(VESICA_POLYGON, &narrow, VESICA_SEGMENT, &segment, narrow_room.data(), 2, &shared), 2);
  EXPECT_EQ(narrow_room[0].x, 1);
  EXPECT_EQ(narrow_room[1].y, 4);
}

/// A point of the plane as fractions over one denominator.
struct Fractions {
  std::int64_t x, y, over;
  Fractions(std::int64_t px, std::int64_t py, std::int64_t q) {
    const std::int64_t common = std::gcd(std::gcd(px, py), q) * (q < 0 ? -1 : 1);
    x = px / common;
    y = py / common;
    over = q / common;
  }
  bool operator<(const Fractions& o) const { return std::array{x, y, over} < std::array{o.x, o.y, o.over}; }
  LatticeEdge scaled(const LatticeEdge& e) const {
    return {{e.from.x * over, e.from.y * over}, {e.to.x * over, e.to.y * over}};
  }
};
inline bool equal(Lattice p, Lattice q) { return p.x == q.x && p.y == q.y; }

/// The directions in which edges lead on from a place.
inline std::set<std::pair<std::int64_t, std::int64_t>> directions(const Fractions& p,
                                                                  const std::vector<LatticeEdge>& edges) {
  std::set<std::pair<std::int64_t, std::int64_t>> found;
  for (const LatticeEdge& edge : edges) {
    const LatticeEdge e = p.scaled(edge);
    if (!is_on({p.x, p.y}, e)) continue;
    for (const Lattice& end : {e.from, e.to}) {
      const std::int64_t x = end.x - p.x, y = end.y - p.y, common = std::gcd(x, y);
      if (common != 0) found.insert({x / common, y / common});
    }
  }
  return found;
}

/// All places of all pairs of edges, but those from which both outlines lead on alike along one line.
inline Answer expected(const std::vector<LatticeEdge>& first, const std::vector<LatticeEdge>& second) {
  std::set<Fractions> met;
  Answer answer{0, 0, {}};
  for (const LatticeEdge& e : first) {
    for (const LatticeEdge& f : second) {
      for (const Lattice& p : {e.from, e.to}) {
        if (is_on(p, f)) met.insert({p.x, p.y, 1});
      }
      for (const Lattice& p : {f.from, f.to}) {
        if (is_on(p, e)) met.insert({p.x, p.y, 1});
      }
      const std::int64_t ex = e.to.x - e.from.x, ey = e.to.y - e.from.y, fx = f.to.x - f.from.x, fy = f.to.y - f.from.y,
                         whole = ex * fy - ey * fx, part = (f.from.x - e.from.x) * fy - (f.from.y - e.from.y) * fx;
      if (whole != 0 && meet(e, f)) met.insert({e.from.x * whole + ex * part, e.from.y * whole + ey * part, whole});
      if (whole != 0 || equal(e.from, e.to) || equal(f.from, f.to) || area_sign(e.from, e.to, f.from) != 0) continue;
      const auto range = [&](const LatticeEdge& g) {
        return ex != 0 ? std::minmax({g.from.x, g.to.x}) : std::minmax({g.from.y, g.to.y});
      };
      if (std::max(range(e).first, range(f).first) < std::min(range(e).second, range(f).second)) answer.shared = 1;
    }
  }
  for (const Fractions& p : met) {
    const auto a = directions(p, first), b = directions(p, second);
    const bool straight =
        a == b && a.size() == 2 && a.begin()->first == -a.rbegin()->first && a.begin()->second == -a.rbegin()->second;
    if (straight) continue;
    answer.places.emplace_back(static_cast<double>(p.x) / static_cast<double>(p.over),
                               static_cast<double>(p.y) / static_cast<double>(p.over));
  }
  answer.count = static_cast<std::int64_t>(answer.places.size());
  return answer;
}

/// Does no edge cross another one of its path, or lie along it?
inline bool has_no_crossing(const Path& path, bool closed) {
  const auto edges = lattice_edges(path, closed);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const LatticeEdge &e = edges[i], &f = edges[j];
      const int s0 = area_sign(e.from, e.to, f.from), s1 = area_sign(e.from, e.to, f.to),
                t0 = area_sign(f.from, f.to, e.from), t1 = area_sign(f.from, f.to, e.to);
      if (s0 * s1 < 0 && t0 * t1 < 0) return false;
      if (s0 == 0 && s1 == 0 && expected({e}, {f}).shared != 0) return false;
    }
  }
  return true;
}

TEST(PolygonCrossings, AgreeWithFractions) {
  Random random(608);
  std::array<int, 2> seen{};
  const int pairs = 20000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const int size = random.integer(2, 6);
    const Path a = lattice_path(size, random), b = lattice_path(size, random);
    const bool closed_a = random.chance(0.6), closed_b = random.chance(0.6);
    if (!has_no_crossing(a, closed_a) || !has_no_crossing(b, closed_b)) continue;
    const std::int32_t kind_a = closed_a ? VESICA_POLYGON : VESICA_POLYLINE,
                       kind_b = closed_b ? VESICA_POLYGON : VESICA_POLYLINE;
    const auto view_a = a.view(), view_b = b.view();
    const Answer answer = crossings(kind_a, &view_a, kind_b, &view_b),
                 swapped = crossings(kind_b, &view_b, kind_a, &view_a),
                 truth = expected(lattice_edges(a, closed_a), lattice_edges(b, closed_b));
    ASSERT_EQ(answer.count, truth.count) << i;
    ASSERT_EQ(answer.shared, truth.shared) << i;
    ASSERT_TRUE(alike(answer.places, truth.places)) << i;
    ASSERT_EQ(sorted(answer.places), sorted(swapped.places)) << i;
    ++seen[static_cast<std::size_t>(truth.shared)];
    if (!closed_a || !closed_b) continue;
    const Path other_a = rewritten(a, random), other_b = rewritten(b, random);
    const auto other_view_a = other_a.view(), other_view_b = other_b.view();
    const Answer other = crossings(kind_a, &other_view_a, kind_b, &other_view_b);
    ASSERT_EQ(other.count, truth.count) << i;
    ASSERT_TRUE(alike(other.places, truth.places)) << i;
  }
  EXPECT_GT(std::min(seen[0], seen[1]), pairs / 100);
}

/// Places come in order along a ring: the edges' angles about its centre.
TEST(PolygonCrossings, InOrderAlongTheFirst) {
  Random random(609);
  const int pairs = 2000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    Path a, b;
    std::vector<double> around;
    const int corners = random.integer(3, 60);
    for (int k = 0; k < corners; ++k) {
      const double turn = k * 6.283185307179586 / corners, r = random.between(0.3, 1);
      around.insert(around.end(), {r * std::cos(turn), r * std::sin(turn)});
    }
    a.add_ring(around);
    b.add_ring(star(random.integer(3, 60), random.between(-1, 1), 0, 1, 0.3, random));
    const auto view_a = a.view(), view_b = b.view();
    const Answer answer = crossings(VESICA_POLYGON, &view_a, VESICA_POLYGON, &view_b);
    ASSERT_EQ(answer.count % 2, 0) << i;
    double before = std::atan2(a.xy[1], a.xy[0]);
    const double start = before;
    for (const auto& [x, y] : answer.places) {
      double angle = std::atan2(y, x);
      while (angle < start - 1e-9) angle += 6.283185307179586;
      ASSERT_GE(angle, before - 1e-9) << i;
      before = angle;
    }
  }
}

/// A box as a polygon has the box's places, with shapes of every kind.
TEST(PolygonCrossings, OfBoxesAsPolygons) {
  Random random(610);
  const int pairs = 20000 * properties::repeat();
  int met = 0;
  for (int i = 0; i < pairs; ++i) {
    inflated::Shape other = random.chance(0.5) ? inflated::any_shape(random) : inflated::lattice_shape(random);
    if (random.chance(0.5)) {
      for (double& number : other.number) number = std::round(2 * number);
    }
    if (vesica_check_f64(other.kind, other.number.data()) != 0) continue;
    std::array<double, 4> at{};
    for (std::size_t k = 0; k < 4; ++k) {
      at[k] = random.chance(0.3)   ? other.number[k % 2]
              : random.chance(0.5) ? random.integer(-2, 2)
                                   : random.between(-2, 2);
    }
    const vesica_aabb_f64 box{std::min(at[0], at[2]), std::min(at[1], at[3]), std::max(at[0], at[2]),
                              std::max(at[1], at[3])};
    const double middle = std::max(box.min_x, std::min(box.max_x, std::round(0.5 * box.min_x + 0.5 * box.max_x)));
    Path path;
    path.add_ring(
        {box.min_x, box.min_y, middle, box.min_y, box.max_x, box.min_y, box.max_x, box.max_y, box.min_x, box.max_y});
    path = rewritten(path, random);
    const auto view = path.view();
    const Answer answer = crossings(VESICA_POLYGON, &view, other.kind, other.number.data()),
                 swapped = crossings(other.kind, other.number.data(), VESICA_POLYGON, &view),
                 truth = crossings(VESICA_AABB, &box, other.kind, other.number.data());
    ASSERT_EQ(answer.places, swapped.places) << i;
    ASSERT_EQ(answer.count, truth.count) << i << " " << inflated::described(other);
    ASSERT_EQ(answer.shared, truth.shared) << i << " " << inflated::described(other);
    ASSERT_TRUE(alike(answer.places, truth.places)) << i << " " << inflated::described(other);
    met += answer.count > 0 ? 1 : 0;
  }
  EXPECT_GT(met, pairs / 10);
}

/// Edges that go up and down across a long line: every crossing, more than the room has.
TEST(PolygonCrossings, OfManyEdges) {
  constexpr int n = 20000;
  Path zigzag, line;
  std::vector<double> xy;
  for (int i = 0; i < n; ++i) xy.insert(xy.end(), {static_cast<double>(i), i % 2 == 0 ? -1.0 : 1.0});
  zigzag.add_ring(xy);
  line.add_ring({-1, 0, n, 0});
  const auto a = zigzag.view(), b = line.view();
  std::array<vesica_point_f64, 3> room{};
  EXPECT_EQ(vesica_crossings_f64(VESICA_POLYLINE, &a, VESICA_POLYLINE, &b, room.data(), 3, nullptr), n - 1);
  EXPECT_EQ(room[2].x, 2.5);
  EXPECT_EQ(vesica_crossings_f64(VESICA_POLYLINE, &b, VESICA_POLYLINE, &a, room.data(), 3, nullptr), n - 1);
  EXPECT_EQ(room[2].x, 2.5);
}

}  // namespace polygon_crossings
