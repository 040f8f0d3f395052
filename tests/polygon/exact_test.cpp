// SPDX-License-Identifier: Apache-2.0
// Two polygons against rational numbers: relation, areas and their bound, depth, casts. Pairs share vertices or edges,
// nearly contain one another, are thin, far from the origin, or tiny.
#include <gtest/gtest.h>
#include <vesica_measures.h>
#include <vesica_motion.h>

#include <array>
#include <cstring>
#include <limits>
#include <string>

#include "polygon/convex_pairs.hpp"
#include "polygon/rational_oracle.hpp"

namespace polygon_exact {

using namespace polygons;
using rational::Rational;
/// Simple polygons on a lattice, perhaps with several rings; sheared, they are thin.
inline Path simple_path(int size, Random& random) {
  for (;;) {
    Path path;
    for (int rings = random.chance(0.7) ? 1 : random.integer(2, 3); rings > 0; --rings)
      path.add_ring(lattice_ring(random.integer(3, 6), size, random));
    const auto view = path.view();
    bool fine = vesica_check_f64(VESICA_POLYGON, &view) == 0;
    for (std::size_t j = 0; j < path.ring_count(); ++j) {
      Path ring;
      ring.add_ring({path.xy.begin() + 2 * path.rings[j], path.xy.begin() + 2 * path.rings[j + 1]});
      const rational::Edges edges = rational::edges(ring, true, 0);
      fine = fine && sgn(rational::areas(edges, edges).a) > 0;
    }
    if (fine) return path;
  }
}

inline std::string text(const Two& pair) {
  std::string out;
  char number[64];
  for (const Path* path : {&pair.a, &pair.b}) {
    for (const double v : path->xy) out += (std::snprintf(number, sizeof number, "%a ", v), number);
    out += '\n';
  }
  return out;
}

/// Asks both functions of a number, in both orders, for the same bits.
using Function = std::int32_t (*)(std::int32_t, const void*, std::int32_t, const void*, double*);
inline double number_of(Function function, const Two& pair) {
  const auto a = pair.a.view(), b = pair.b.view();
  double out = -1, exchanged = -2;
  EXPECT_EQ(function(VESICA_POLYGON, &a, VESICA_POLYGON, &b, &out), 0);
  EXPECT_EQ(function(VESICA_POLYGON, &b, VESICA_POLYGON, &a, &exchanged), 0);
  EXPECT_EQ(out, exchanged);
  return out;
}
inline double own_area(const Path& path) {
  const auto view = path.view();
  double out = -1;
  EXPECT_EQ(vesica_shape_area_f64(VESICA_POLYGON, &view, &out), 0);
  return out;
}

/// The heights g and the widths w of the bound of vesica_area_f64, and w of convex polygons.
struct BoundTerms {
  Rational g, w, convex_w;

  explicit BoundTerms(const Two& pair) : g(0), w(0) {
    std::array<std::array<double, 4>, 2> box{};
    for (std::size_t k = 0; k < 2; ++k) {
      const std::vector<double>& xy = (k == 0 ? pair.a : pair.b).xy;
      box[k] = {xy[0], xy[1], xy[0], xy[1]};
      for (std::size_t i = 0; i < xy.size(); ++i) {
        box[k][i % 2] = std::min(box[k][i % 2], xy[i]);
        box[k][2 + i % 2] = std::max(box[k][2 + i % 2], xy[i]);
      }
    }
    const Rational level = (Rational(std::max(box[0][1], box[1][1])) + Rational(std::min(box[0][3], box[1][3]))) / 2;
    for (const auto& b : box) g = std::max({g, Rational(b[3] - level), Rational(level - b[1])});
    convex_w = 4 * (Rational(std::min(box[0][2], box[1][2])) - Rational(std::max(box[0][0], box[1][0])));
    const int unit = rational::unit_of(pair.a, pair.b);
    for (const rational::Edge& e : rational::edges(pair.a, true, unit)) {
      for (const rational::Edge& f : rational::edges(pair.b, true, unit)) {
        const rational::Integer low = std::max(std::min(e.a.x, e.b.x), std::min(f.a.x, f.b.x)),
                                high = std::min(std::max(e.a.x, e.b.x), std::max(f.a.x, f.b.x));
        if (high > low) w += high - low;
      }
    }
    w = rational::shifted(w, unit);
  }
  Rational bound() const { return rational::shifted(192 * g * w, -53); }
  Rational convex_bound() const { return rational::shifted(192 * g * convex_w, -53); }
};

inline void expect_areas(const Two& pair, const rational::Areas& truth, std::int32_t relation, bool is_convex) {
  const double found = number_of(vesica_area_f64, pair), iou = number_of(vesica_iou_f64, pair),
               least = std::min(own_area(pair.a), own_area(pair.b));
  if (relation <= VESICA_TOUCH) {
    EXPECT_EQ(found, 0);
    EXPECT_EQ(iou, 0);
    return;
  }
  EXPECT_LE(found, least);
  if (relation >= VESICA_INSIDE) {
    EXPECT_EQ(found, least);
  }
  if (relation == VESICA_EQUAL) {
    EXPECT_EQ(iou, 1);
  }
  const BoundTerms terms(pair);
  const Rational error = abs(Rational(found) - truth.both), all = truth.a + truth.b - truth.both;
  EXPECT_LE(error, terms.bound());
  if (is_convex) {
    EXPECT_LE(error, terms.convex_bound());
  }
  EXPECT_LE(abs(Rational(iou) - truth.both / all), 3 * terms.bound() / all + rational::shifted(1, -52));
}

inline std::int32_t expect_all(const Two& pair, bool is_convex, Random& random) {
  const auto a = pair.a.view(), b = pair.b.view();
  const int unit = rational::unit_of(pair.a, pair.b);
  const rational::Edges edges_a = rational::edges(pair.a, true, unit), edges_b = rational::edges(pair.b, true, unit);
  rational::Areas truth = is_convex ? areas_of_convex(edges_a, edges_b) : areas(edges_a, edges_b);
  const bool outlines = outlines_meet(edges_a, edges_b), insides = sgn(truth.both) > 0, a_leaves = truth.a > truth.both,
             b_leaves = truth.b > truth.both;
  const std::int32_t relation = !insides               ? (outlines ? VESICA_TOUCH : VESICA_DISJOINT)
                                : a_leaves && b_leaves ? VESICA_CROSS
                                : a_leaves             ? (outlines ? VESICA_CONTAINS_TOUCH : VESICA_CONTAINS)
                                : b_leaves             ? (outlines ? VESICA_INSIDE_TOUCH : VESICA_INSIDE)
                                                       : VESICA_EQUAL;
  EXPECT_EQ(vesica_relation_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b), relation);
  EXPECT_EQ(vesica_overlap_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b), relation == VESICA_DISJOINT ? 0 : 1);
  const Path other = rewritten(pair.a, random);
  const auto rewritten_a = other.view();
  EXPECT_EQ(vesica_check_f64(VESICA_POLYGON, &rewritten_a), 0);
  EXPECT_EQ(vesica_relation_f64(VESICA_POLYGON, &rewritten_a, VESICA_POLYGON, &b), relation);
  for (Rational* area : {&truth.both, &truth.a, &truth.b}) *area = rational::shifted(*area, 2 * unit);
  if (std::min(own_area(pair.a), own_area(pair.b)) > 0x1p-1000) expect_areas(pair, truth, relation, is_convex);
  vesica_penetration_f64 depth{-1, 0, 0};
  const std::int32_t code = vesica_depth_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, &depth);
  EXPECT_TRUE(code == 0 || (!is_convex && code == VESICA_E_NOT_CONVEX));
  if (code == 0) {
    EXPECT_EQ(depth.depth > 0, insides);
  }
  return relation;
}

TEST(PolygonExact, ConvexPairs) {
  Random random(701);
  std::array<int, 8> seen{};
  const int pairs = 8000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    Two pair;
    if (!convex_pair(pair, random)) continue;
    ++seen[static_cast<std::size_t>(expect_all(pair, true, random))];
    if (HasFailure()) FAIL() << text(pair);
  }
  if (!properties::draws_all()) return;
  for (const int count : seen) EXPECT_GT(count, 10);
}

TEST(PolygonExact, SimplePairs) {
  Random random(702);
  std::array<int, 8> seen{};
  const int pairs = 1500 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const int size = random.integer(2, 6);
    Two pair{simple_path(size, random), simple_path(size, random)};
    if (random.chance(0.2)) pair.b = pair.a;
    const double flat = random.chance(0.3) ? 1e-12 : 1;
    const bool sheared = random.chance(0.5);
    for (Path* path : {&pair.a, &pair.b}) {
      for (std::size_t k = 0; k < path->xy.size(); k += 2)
        path->xy[k + 1] = flat * path->xy[k + 1] + (sheared ? path->xy[k] : 0);
    }
    const auto a = pair.a.view(), b = pair.b.view();
    if (vesica_check_f64(VESICA_POLYGON, &a) != 0 || vesica_check_f64(VESICA_POLYGON, &b) != 0) continue;
    ++seen[static_cast<std::size_t>(expect_all(pair, false, random))];
    if (HasFailure()) FAIL() << text(pair);
  }
  if (!properties::draws_all()) return;
  for (const int relation : {VESICA_DISJOINT, VESICA_TOUCH, VESICA_CROSS, VESICA_CONTAINS_TOUCH, VESICA_EQUAL})
    EXPECT_GT(seen[static_cast<std::size_t>(relation)], 5) << relation;
}

/// The two oracles of areas agree.
TEST(PolygonExact, OraclesAgree) {
  Random random(703);
  const int pairs = 300 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    Two pair;
    if (!convex_pair(pair, random)) continue;
    const int unit = rational::unit_of(pair.a, pair.b);
    const rational::Edges a = rational::edges(pair.a, true, unit), b = rational::edges(pair.b, true, unit);
    const rational::Areas first = areas_of_convex(a, b), second = areas(a, b);
    ASSERT_TRUE(first.both == second.both && first.a == second.a && first.b == second.b) << text(pair);
  }
}

/// Polygons thinner than the error of their areas: the exact relation decides. A triangle, and one on its long edge.
TEST(PolygonExact, AreaOfThinPolygons) {
  const Two pair{path_of({{0, 0}, {1, 1}, {0.5, 0.5 + 0x1p-50}}),
                 path_of({{0.25, 0.25}, {0.75, 0.75}, {0.5, 0.5 + 0x1p-51}})};
  EXPECT_EQ(own_area(pair.b), 0x1p-53);
  EXPECT_EQ(number_of(vesica_area_f64, pair), own_area(pair.b));
  EXPECT_EQ(number_of(vesica_iou_f64, {pair.a, pair.a}), 1);
  const Two beside{pair.a, path_of({{0.25, 0.25}, {0.75, 0.75}, {0.5, 0.5 - 0x1p-51}})};
  EXPECT_EQ(number_of(vesica_area_f64, beside), 0);
  // A rectangle about the triangle.
  const auto view = pair.a.view();
  const vesica_rect_f64 rect{0.5, 0.5, 1, 1, 1, 0x1p-45};
  double area = -1;
  ASSERT_EQ(vesica_area_f64(VESICA_POLYGON, &view, VESICA_RECT, &rect, &area), 0);
  EXPECT_EQ(area, own_area(pair.a));
}

/// Far from the origin sums of products round by more than the polygons' size: nothing may be decided by them.
TEST(PolygonExact, MovedAlike) {
  Random random(704);
  int overlaps = 0;
  const int pairs = 20000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const std::vector<Corner> first = convex(true, random), second = convex(true, random);
    if (first.size() < 3 || second.size() < 3) continue;
    const Two here{path_of(first), path_of(second)};
    Two there = here;
    const double x = std::ldexp(random.integer(-9, 9), random.integer(0, 48)),
                 y = std::ldexp(random.integer(-9, 9), random.integer(0, 48));
    for (Path* path : {&there.a, &there.b}) {
      for (std::size_t k = 0; k < path->xy.size(); ++k) path->xy[k] += k % 2 == 0 ? x : y;
    }
    std::array<vesica_penetration_f64, 2> depth{};
    std::array<double, 2> distance{}, outlines{};
    for (std::size_t k = 0; k < 2; ++k) {
      const Two& pair = k == 0 ? here : there;
      const auto a = pair.a.view(), b = pair.b.view();
      vesica_closest_points_f64 points{};
      ASSERT_EQ(vesica_depth_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, &depth[k]), 0);
      ASSERT_EQ(vesica_nearest_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, &points), 0);
      distance[k] = points.distance;
      ASSERT_EQ(vesica_boundary_distance_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, &points), 0);
      outlines[k] = points.distance;
    }
    overlaps += static_cast<int>(depth[0].depth > 0);
    ASSERT_EQ(std::memcmp(&depth[0], &depth[1], sizeof depth[0]), 0) << text(here) << x << ' ' << y;
    ASSERT_EQ(distance[0], distance[1]) << text(here) << x << ' ' << y;
    ASSERT_EQ(outlines[0], outlines[1]) << text(here) << x << ' ' << y;
  }
  EXPECT_GT(overlaps, pairs / 10);
}

/// Powers of two scale distances and depths, also where their squares are beyond the range.
TEST(PolygonExact, Scaled) {
  Random random(706);
  int apart = 0;
  const int pairs = 10000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const std::vector<Corner> first = convex(false, random), second = convex(false, random);
    if (first.size() < 3 || second.size() < 3) continue;
    const Two pair{path_of(first), path_of(second)};
    const double k = std::ldexp(1.0, random.chance(0.5) ? random.integer(500, 1000) : random.integer(-900, -400)),
                 flat = random.chance(0.5) ? 0x1p-40 : 1;
    std::array<double, 2> distance{}, depth{};
    for (std::size_t j = 0; j < 2; ++j) {
      Two two = pair;
      for (Path* path : {&two.a, &two.b}) {
        for (std::size_t c = 0; c < path->xy.size(); ++c) path->xy[c] *= (c % 2 == 0 ? 1 : flat) * (j == 0 ? 1 : k);
      }
      const auto a = two.a.view(), b = two.b.view();
      vesica_closest_points_f64 points{};
      vesica_penetration_f64 found{};
      ASSERT_EQ(vesica_nearest_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, &points), 0);
      ASSERT_EQ(vesica_depth_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, &found), 0);
      distance[j] = points.distance;
      depth[j] = found.depth;
    }
    apart += static_cast<int>(distance[0] > 0);
    ASSERT_EQ(distance[1], distance[0] * k) << text(pair) << k << ' ' << flat;
    ASSERT_EQ(depth[1], depth[0] * k) << text(pair) << k << ' ' << flat;
  }
  EXPECT_GT(apart, pairs / 5);
}

/// The time is the last double at or before the contact, which a cast to that time or a little before does not reach.
TEST(PolygonExact, TimesOfCasts) {
  Random random(705);
  int hits = 0;
  const int pairs = 3000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    Two pair;
    if (random.chance(0.5)) {
      pair = {simple_path(5, random), simple_path(5, random)};
      for (std::size_t k = 0; k < pair.b.xy.size(); k += 2) pair.b.xy[k] += 6;
    } else if (!convex_pair(pair, random)) {
      continue;
    }
    const auto a = pair.a.view(), b = pair.b.view();
    if (vesica_overlap_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b) != 0) continue;
    const double vx = random.chance(0.1) ? 0 : random.integer(-9, 3),
                 vy = random.chance(0.5) ? random.integer(-4, 4) : random.between(-4, 4);
    if (vx == 0 && vy == 0) continue;
    const int unit = rational::unit_of(pair.a, pair.b), unit_of_v = rational::unit_of({vx, vy});
    Rational time;
    const bool hit = first_contact(rational::edges(pair.a, true, unit), rational::edges(pair.b, true, unit),
                                   rational::in_units(vx, unit_of_v), rational::in_units(vy, unit_of_v), time);
    const auto cast = [&](double end, vesica_impact_f64& at) {
      return vesica_cast_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, vx, vy, end, &at);
    };
    vesica_impact_f64 at;
    const std::int32_t code = cast(std::numeric_limits<double>::infinity(), at);
    if (code == VESICA_E_RANGE) continue;
    ASSERT_EQ(code, hit ? VESICA_CAST_HIT : VESICA_CAST_MISS) << text(pair);
    if (!hit) continue;
    ++hits;
    time = rational::shifted(time, unit - unit_of_v);
    const double next = std::nextafter(at.t, std::numeric_limits<double>::infinity()), t = at.t;
    ASSERT_LE(Rational(t), time) << text(pair) << vx << ' ' << vy;
    ASSERT_GT(Rational(next), time) << text(pair) << vx << ' ' << vy;
    const bool exactly = Rational(t) == time;
    if (t > 0) {
      ASSERT_EQ(cast(exactly ? std::nextafter(t, 0) : t, at), VESICA_CAST_MISS) << text(pair);
    }
    ASSERT_EQ(cast(exactly ? t : next, at), VESICA_CAST_HIT) << text(pair);
  }
  EXPECT_GT(hits, pairs / 10);
}

}  // namespace polygon_exact
