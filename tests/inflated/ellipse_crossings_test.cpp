// SPDX-License-Identifier: Apache-2.0
// Places where the outlines of ellipses meet those of capsules and rounded rectangles: known ones, and against 190
// digits.
#include <gtest/gtest.h>
#include <vesica_topology.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "inflated/ellipse_outline.hpp"

namespace ellipse_crossings {
namespace {

using namespace inflated;
using properties::Random;

using Places = std::vector<std::array<double, 2>>;

struct Found {
  Places places;
  std::int32_t shared;
};
Found crossings(const Shape& a, const Shape& b) {
  std::array<vesica_point_f64, 16> at{};
  Found found{{}, -1};
  const std::int64_t count =
      vesica_crossings_f64(a.kind, a.number.data(), b.kind, b.number.data(), at.data(), 16, &found.shared);
  EXPECT_GE(count, 0);
  EXPECT_LE(count, 12);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) found.places.push_back({at[i].x, at[i].y});
  return found;
}
Places sorted(Places p) {
  std::sort(p.begin(), p.end());
  return p;
}

Shape ellipse(double cx, double cy, double ux, double uy, double a, double b) {
  return {VESICA_ELLIPSE, {cx, cy, ux, uy, a, b}};
}
void expect_places(const Shape& a, const Shape& b, const Places& expected, int shared = 0) {
  const Found found = crossings(a, b), exchanged = crossings(b, a);
  EXPECT_EQ(found.places, expected);
  EXPECT_EQ(found.shared, shared);
  EXPECT_EQ(sorted(exchanged.places), sorted(expected));
  EXPECT_EQ(exchanged.shared, shared);
}

const Shape capsule{VESICA_CAPSULE, {0, 0, 10, 0, 1}};
const Shape tile{VESICA_ROUND_RECT, {0, 0, 1, 0, 2, 1, 1}};  // 3 and 2 from its centre

TEST(EllipseCrossings, OfEdges) {
  expect_places(capsule, ellipse(5, -3, 1, 0, 4, 2), {{5, -1}});
  expect_places(capsule, ellipse(5, 0, 1, 0, 4, 1), {{5, -1}, {5, 1}});
  expect_places(capsule, ellipse(5, 0, 1, 0, 3, 1.25), {{3.2, -1}, {6.8, -1}, {6.8, 1}, {3.2, 1}});
  expect_places(tile, ellipse(-3, 0, 1, 0, 2, 1), {{-3, 1}, {-3, -1}});
}

TEST(EllipseCrossings, OfArcs) {
  // At the ends of edges, and at the tip between them.
  expect_places(capsule, ellipse(12, 0, 1, 0, 1, 3), {{11, 0}});
  expect_places(capsule, ellipse(10, 0, 1, 0, 2, 1), {{10, -1}, {10, 1}});
  expect_places(capsule, ellipse(5, 0, 1, 0, 6, 3), {{11, 0}, {-1, 0}});
  expect_places(tile, ellipse(5, 1, 1, 0, 2, 1), {{3, 1}});
  expect_places(tile, ellipse(0, 0, 1, 0, 3, 2), {{0, -2}, {3, 0}, {0, 2}, {-3, 0}});
  // An ellipse whose curvature at its end is the arc's, about the arc's centre: contact of order four.
  expect_places(capsule, ellipse(10 - 3, 0, 1, 0, 4, 2),
                {{7 - 2 * std::sqrt(3), -1}, {11, 0}, {7 - 2 * std::sqrt(3), 1}});
}

struct Tally {
  int met = 0, most = 0;
};

/// The count, each place to 4u of the greatest coordinate and size, the order along either, and the law of exchange.
void compare(const Shape& round, const Shape& oval, Tally& tally) {
  SCOPED_TRACE(described(round) + "   " + described(oval));
  const Found found = crossings(round, oval), exchanged = crossings(oval, round);
  const std::vector<EllipsePlace> expected = places_with_ellipse(round, oval);
  ASSERT_EQ(found.places.size(), expected.size());
  ASSERT_EQ(found.shared, 0);
  ASSERT_EQ(exchanged.shared, 0);
  const double bound = 4 * 0x1p-53 * scale(round, oval);
  const auto is_at = [bound](const std::array<double, 2>& p, const EllipsePlace& q) {
    return std::hypot(mpf_class(p[0] - q.x).get_d(), mpf_class(p[1] - q.y).get_d()) <= bound;
  };
  for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_TRUE(is_at(found.places[i], expected[i])) << i;
  std::vector<EllipsePlace> around = expected;
  std::sort(around.begin(), around.end(), [](const auto& p, const auto& q) { return p.turn < q.turn; });
  for (std::size_t i = 0; i < around.size(); ++i) ASSERT_TRUE(is_at(exchanged.places[i], around[i])) << i;
  ASSERT_EQ(sorted(found.places), sorted(exchanged.places));
  tally.met += !found.places.empty();
  tally.most = std::max(tally.most, static_cast<int>(found.places.size()));
}

Shape lattice_ellipse(Random& random) {
  constexpr double axes[][2] = {{1, 0}, {0, 1}, {-1, 0}, {3, 4}, {-4, 3}, {1, 1}, {2, 1}};
  constexpr double sizes[] = {0.5, 1, 1.5, 2, 3};
  const auto& axis = axes[random.below(7)];
  const auto size = [&] { return sizes[random.below(5)] / (axis[0] * axis[1] == 0 ? 1 : 4); };
  return ellipse(random.integer(-3, 3), random.integer(-3, 3), axis[0], axis[1], size(), size());
}
bool has_core_and_radius(const Shape& s) {
  const auto& n = s.number;
  if (s.kind == VESICA_CAPSULE) return n[4] > 0 && (n[0] != n[2] || n[1] != n[3]);
  return s.kind == VESICA_ROUND_RECT && n[6] > 0 && (n[4] > 0 || n[5] > 0);
}
Shape lattice_round(Random& random) {
  Shape s = lattice_shape(random);
  while (!has_core_and_radius(s)) s = lattice_shape(random);
  return s;
}
/// True if the ellipse is a circle about a corner of the core: then outlines may share an arc.
bool is_own_circle(const Shape& round, const Shape& oval) {
  const auto& n = oval.number;
  return n[4] == n[5] && n[4] * std::hypot(n[2], n[3]) == radius(round);
}

/// Few digits, so that places often are where edges and arcs join, and outlines touch.
TEST(EllipseCrossings, OfShapesOnALattice) {
  Random random(properties::seed());
  Tally tally;
  for (int i = 0; i < 6000 * properties::repeat() && !HasFatalFailure(); ++i) {
    const Shape round = lattice_round(random), oval = lattice_ellipse(random);
    if (!is_own_circle(round, oval)) compare(round, oval, tally);
  }
  EXPECT_GT(tally.met, 500 * properties::repeat());
}

TEST(EllipseCrossings, OfAnyShapes) {
  Random random(properties::seed());
  Tally tally;
  for (int i = 0; i < 6000 * properties::repeat() && !HasFatalFailure(); ++i) {
    compare(inflated_shape(random), shape(VESICA_ELLIPSE, random), tally);
  }
  EXPECT_GT(tally.met, 300 * properties::repeat());
}

/// The ellipse is moved to where the count changes: asked at the doubles next to that.
TEST(EllipseCrossings, WhereTheCountChanges) {
  Random random(properties::seed());
  Tally tally;
  int changes = 0;
  for (int i = 0; i < 2000 * properties::repeat() && !HasFatalFailure(); ++i) {
    const Shape round = i % 2 == 0 ? inflated_shape(random) : lattice_round(random);
    const Shape oval = i % 4 < 2 ? shape(VESICA_ELLIPSE, random) : lattice_ellipse(random);
    double from = random.between(-2, 2), to = from + random.between(0.1, 4);
    const auto count = [&](double dx) { return crossings(round, moved(oval, dx)).places.size(); };
    const std::size_t before = count(from);
    if (count(to) == before) continue;
    for (int k = 0; k < 60; ++k) {
      const double middle = from + (to - from) / 2;
      (count(middle) == before ? from : to) = middle;
    }
    ++changes;
    for (int k = -2; k <= 2; ++k) compare(round, moved(oval, from + k * (to - from)), tally);
  }
  EXPECT_GT(changes, 100 * properties::repeat());
}

TEST(EllipseCrossings, TwelveOfARoundedRectangle) {
  const Shape round{VESICA_ROUND_RECT, {0, 0, 1, 0, 0.5, 0.5, 0.5}}, oval = ellipse(0, 0, 1, 1, 0.854, 0.53);
  Tally tally;
  compare(round, oval, tally);
  EXPECT_EQ(tally.most, 12);
  // With less room the count is the same.
  std::array<vesica_point_f64, 12> at{};
  std::int32_t shared = 7;
  EXPECT_EQ(vesica_crossings_f64(oval.kind, oval.number.data(), round.kind, round.number.data(), at.data(), 9, &shared),
            12);
  EXPECT_EQ(shared, 0);
  EXPECT_NE(at[8].x, 0);
  EXPECT_EQ(at[9].x, 0);
}

/// An ellipse that is the circle of an arc shares that.
TEST(EllipseCrossings, OfAnArcsOwnCircle) {
  expect_places(capsule, ellipse(10, 0, 0, 1, 1, 1), {{10, -1}, {10, 1}}, 1);
  // 0.2 is more than 1/5: this circle leaves the shape by the edges.
  EXPECT_EQ(crossings(tile, ellipse(-2, 1, 3, 4, 0.2, 0.2)).shared, 0);
  expect_places(tile, ellipse(-2, 1, 4, 0, 0.25, 0.25), {{-2, 2}, {-3, 1}}, 1);
  expect_places({VESICA_CAPSULE, {0, 0, 10, 0, 5}}, ellipse(10, 0, 3, 4, 1, 1), {{10, -5}, {10, 5}}, 1);
  // From the ellipse's start.
  EXPECT_EQ(crossings(ellipse(10, 0, 0, 1, 1, 1), capsule).places, (Places{{10, 1}, {10, -1}}));
}

/// With a size of 0 an ellipse is a rectangle; without a radius, or without a core, the others are simpler.
TEST(EllipseCrossings, OfSimplerShapes) {
  Random random(properties::seed());
  int met = 0;
  for (int i = 0; i < 4000 * properties::repeat(); ++i) {
    Shape oval = lattice_ellipse(random), round = lattice_round(random), simple = round, straight = oval;
    if (i % 2 == 0) {
      oval.number[4 + static_cast<std::size_t>(random.below(2))] = 0;
      straight = oval;
      straight.kind = VESICA_RECT;
    } else if (i % 4 == 1) {
      round.number[round.kind == VESICA_CAPSULE ? 4 : 6] = 0;
      simple = core(round);
    } else if (round.kind == VESICA_CAPSULE) {
      round.number[2] = round.number[0];
      round.number[3] = round.number[1];
      simple = {VESICA_CIRCLE, {round.number[0], round.number[1], round.number[4]}};
    } else {
      round.number[4] = round.number[5] = 0;
      simple = {VESICA_CIRCLE, {round.number[0], round.number[1], round.number[6]}};
    }
    const Found found = crossings(oval, round), expected = crossings(straight, simple);
    ASSERT_EQ(found.places, expected.places) << described(oval) << "   " << described(round);
    ASSERT_EQ(found.shared, expected.shared);
    ASSERT_EQ(crossings(round, oval).places, crossings(simple, straight).places);
    met += !found.places.empty();
  }
  EXPECT_GT(met, 400 * properties::repeat());
}

/// A quarter turn, and lengths times a power of two: no place changes but so.
TEST(EllipseCrossings, TurnedAndScaled) {
  Random random(properties::seed());
  const auto turned = [](Shape s) {
    const auto turn = [&s](std::size_t k) { s.number[k] = -std::exchange(s.number[k + 1], s.number[k]); };
    turn(0);
    turn(2);
    return s;
  };
  for (int i = 0; i < 1000 * properties::repeat(); ++i) {
    const Shape round = i % 2 == 0 ? inflated_shape(random) : lattice_round(random);
    const Shape oval = i % 2 == 0 ? shape(VESICA_ELLIPSE, random) : lattice_ellipse(random);
    const Places unit = crossings(round, oval).places;
    Places expected;
    for (const auto& [x, y] : unit) expected.push_back({-y, x});
    ASSERT_EQ(crossings(turned(round), turned(oval)).places, expected) << described(round) << "   " << described(oval);
    for (const int exponent : {-900, -300, 300, 900}) {
      const double k = std::ldexp(1, exponent);
      expected.clear();
      for (const auto& [x, y] : unit) expected.push_back({x * k, y * k});
      ASSERT_EQ(crossings(times(round, k), times(oval, k)).places, expected) << exponent;
    }
  }
}

/// Contact of order four at (1, 0), the middle of the capsule's end, which has the ellipse's curvature; and offsets
/// from there that are far below roundings.
TEST(EllipseCrossings, OfOsculatingOutlines) {
  const Shape round{VESICA_CAPSULE, {-8, 0, 0, 0, 1}};
  const auto count = [&round](const Shape& oval) { return crossings(round, oval).places.size(); };
  EXPECT_EQ(count(ellipse(-3, 0, 1, 0, 4, 2)), 3U);
  for (const double tiny : {0x1p-52, 0x1p-100, 0x1p-200, 0x1p-400, 0x1p-1000}) {
    // Across: the order is odd where it was even, so that one place more appears, as near as the cube root of this.
    EXPECT_EQ(count(ellipse(-3, tiny, 1, 0, 4, 2)), 4U) << tiny;
    EXPECT_EQ(count(ellipse(-3, -tiny, 1, 0, 4, 2)), 4U) << tiny;
    // Along, by the arc: out it crosses on both sides, in it is free.
    EXPECT_EQ(crossings({VESICA_CAPSULE, {-8, 0, tiny, 0, 1}}, ellipse(-3, 0, 1, 0, 4, 2)).places.size(), 4U) << tiny;
    EXPECT_EQ(crossings({VESICA_CAPSULE, {-8, 0, -tiny, 0, 1}}, ellipse(-3, 0, 1, 0, 4, 2)).places.size(), 2U) << tiny;
  }
}

/// Outlines meet iff the matrix of nine intersections says so.
TEST(EllipseCrossings, AgreeWithMatrices) {
  Random random(properties::seed());
  int met = 0;
  for (int i = 0; i < 10000 * properties::repeat(); ++i) {
    const Shape round = i % 2 == 0 ? inflated_shape(random) : lattice_round(random);
    const Shape oval = i % 2 == 0 ? shape(VESICA_ELLIPSE, random) : lattice_ellipse(random);
    char matrix[VESICA_DE9IM_SIZE];
    ASSERT_EQ(vesica_de9im_f64(round.kind, round.number.data(), oval.kind, oval.number.data(), matrix), 0);
    const Found found = crossings(round, oval);
    ASSERT_EQ(!found.places.empty() || found.shared == 1, matrix[4] != 'F')
        << described(round) << "   " << described(oval);
    met += !found.places.empty();
  }
  EXPECT_GT(met, 1000 * properties::repeat());
}

}  // namespace
}  // namespace ellipse_crossings
