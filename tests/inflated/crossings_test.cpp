// SPDX-License-Identifier: Apache-2.0
// Places where outlines meet: known ones, and against 190 digits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "inflated/outlines.hpp"
#include "inflated/shapes.hpp"

namespace inflated_crossings {
namespace {

using namespace inflated;
using properties::Random;

struct Found {
  std::int64_t count;
  std::int32_t shared;
  std::array<vesica_point_f64, 8> at;
};
Found crossings(const Shape& a, const Shape& b) {
  Found found{-1, -1, {}};
  found.count =
      vesica_crossings_f64(a.kind, a.number.data(), b.kind, b.number.data(), found.at.data(), 8, &found.shared);
  return found;
}

using Places = std::vector<std::array<double, 2>>;

Places places(const Found& f) {
  Places all;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.count); ++i) all.push_back({f.at[i].x, f.at[i].y});
  return all;
}

/// These places in this order, and in the other order of the shapes the same.
void expect_places(const Shape& a, const Shape& b, const Places& expected, int shared = 0) {
  const Found found = crossings(a, b), exchanged = crossings(b, a);
  EXPECT_EQ(found.count, static_cast<std::int64_t>(expected.size()));
  EXPECT_EQ(found.shared, shared);
  EXPECT_EQ(places(found), expected);
  Places same = places(exchanged), sorted = expected;
  std::sort(same.begin(), same.end());
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(same, sorted);
  EXPECT_EQ(exchanged.shared, shared);
}

const Shape capsule{VESICA_CAPSULE, {0, 0, 10, 0, 1}};
const Shape tile{VESICA_ROUND_RECT, {0, 0, 1, 0, 2, 1, 1}};  // 3 and 2 from its centre

TEST(InflatedCrossings, OfCapsules) {
  expect_places(capsule, {VESICA_SEGMENT, {5, -5, 5, 5}}, {{5, -1}, {5, 1}});
  expect_places(capsule, {VESICA_SEGMENT, {-1, -5, -1, 5}}, {{-1, 0}});
  expect_places(capsule, {VESICA_SEGMENT, {0, -5, 0, 5}}, {{0, -1}, {0, 1}});
  expect_places(capsule, {VESICA_POINT, {11, 0}}, {{11, 0}});
  expect_places(capsule, {VESICA_POINT, {5, 0}}, {});
  expect_places(capsule, {VESICA_CIRCLE, {5, 0, 1}}, {{5, -1}, {5, 1}});
  expect_places(capsule, {VESICA_CIRCLE, {12, 0, 1}}, {{11, 0}});
  expect_places(capsule, {VESICA_CIRCLE, {13, 4, 4}}, {{10.6, 0.8}});
  expect_places(capsule, {VESICA_CAPSULE, {5, -5, 5, 5, 2}}, {{3, -1}, {7, -1}, {7, 1}, {3, 1}});
  // The end of one within the other: it leaves by the edges.
  expect_places(capsule, {VESICA_CAPSULE, {5, 0, 5, 5, 1}}, {{5, -1}, {6, 1}, {4, 1}});
}

TEST(InflatedCrossings, OfRoundedRectangles) {
  expect_places(tile, {VESICA_AABB, {-3, -2, 3, 2}},
                {{-2, -2}, {2, -2}, {3, -1}, {3, 1}, {2, 2}, {-2, 2}, {-3, 1}, {-3, -1}}, 1);
  expect_places(tile, {VESICA_CIRCLE, {2, 1, 1}}, {{3, 1}, {2, 2}}, 1);
  expect_places(tile, {VESICA_CIRCLE, {0, 0, 2}}, {{0, -2}, {0, 2}});
  expect_places(tile, {VESICA_SEGMENT, {-1, 2, 9, 2}}, {{2, 2}, {-1, 2}}, 1);
  expect_places(tile, {VESICA_ROUND_RECT, {0, 0, 0, 1, 1, 2, 1}},
                {{-2, -2}, {2, -2}, {3, -1}, {3, 1}, {2, 2}, {-2, 2}, {-3, 1}, {-3, -1}}, 1);
  // Both have radius 1 about (2, 1); their arcs share one end alone.
  expect_places(tile, {VESICA_CAPSULE, {2, 1, 2, 9, 1}}, {{3, 1}, {1, 2}});
}

/// Shares that are only a point: half circles back to back, and a corner that the outline of another touches.
TEST(InflatedCrossings, TouchesAreOnePlace) {
  expect_places({VESICA_CAPSULE, {0, 0, -4, 0, 2}}, {VESICA_CAPSULE, {0, 0, 4, 0, 2}}, {{0, 2}, {0, -2}});
  expect_places(capsule, {VESICA_RECT, {5, 2, 1, 1, 0.5, 0.5}}, {{5, 1}});
  expect_places(capsule, {VESICA_CAPSULE, {-3, 0, -3, 0, 2}}, {{-1, 0}});
  expect_places(capsule, {VESICA_CAPSULE, {2, 3, 4, 3, 2}}, {{4, 1}, {2, 1}}, 1);
}

/// A shape without a radius, or without a size of its core, has the places of the simpler kind.
TEST(InflatedCrossings, OfSimplerKinds) {
  Random random(properties::seed());
  for (int i = 0; i < 4000 * properties::repeat(); ++i) {
    Shape a = lattice_shape(random), b = lattice_shape(random);
    while (!is_inflated(b)) b = lattice_shape(random);
    Shape simple = core(b);
    if (i % 4 < 2) {
      b.number[b.kind == VESICA_CAPSULE ? 4 : 6] = 0;
    } else if (b.kind == VESICA_CAPSULE) {
      b.number[2] = b.number[0];
      b.number[3] = b.number[1];
      simple = {VESICA_CIRCLE, {b.number[0], b.number[1], b.number[4]}};
    } else {
      b.number[4] = b.number[5] = 0;
      simple = {VESICA_CIRCLE, {b.number[0], b.number[1], b.number[6]}};
    }
    const Found found = crossings(a, b), expected = crossings(a, simple);
    ASSERT_EQ(places(found), places(expected)) << i;
    ASSERT_EQ(found.shared, expected.shared) << i;
    ASSERT_EQ(places(crossings(b, a)), places(crossings(simple, a))) << i;
  }
}

struct Tally {
  int met = 0, shared = 0, most = 0;
};

/// The count, each place to 4u of the greatest coordinate and size, the order, and the law of exchange.
void compare(const Shape& a, const Shape& b, Tally& tally) {
  SCOPED_TRACE(described(a) + "   " + described(b));
  const Found found = crossings(a, b), exchanged = crossings(b, a);
  const OutlinePlaces expected = outline_places(Outline(a), Outline(b));
  ASSERT_EQ(found.count, static_cast<std::int64_t>(expected.places.size()));
  ASSERT_EQ(found.shared, expected.shared ? 1 : 0);
  const double bound = 4 * 0x1p-53 * scale(a, b);
  for (std::size_t i = 0; i < expected.places.size(); ++i) {
    const auto& [x, y, along] = expected.places[i];
    ASSERT_LE(std::hypot(mpf_class(found.at[i].x - x).get_d(), mpf_class(found.at[i].y - y).get_d()), bound)
        << i << ' ' << along;
  }
  Places sorted = places(found), same = places(exchanged);
  std::sort(sorted.begin(), sorted.end());
  std::sort(same.begin(), same.end());
  ASSERT_EQ(sorted, same);
  ASSERT_EQ(exchanged.shared, found.shared);
  tally.met += found.count > 0;
  tally.shared += found.shared;
  tally.most = std::max(tally.most, static_cast<int>(found.count));
}

/// A shape of a's kind, many of its numbers those of a.
Shape like(const Shape& a, Random& random) {
  Shape b = lattice_shape(random);
  while (b.kind != a.kind) b = lattice_shape(random);
  if (a.kind == VESICA_AABB) return b;
  for (const auto& [first, last] : {std::pair{0U, 2U}, {2U, 4U}, {4U, 5U}, {5U, 6U}, {6U, 7U}}) {
    if (random.below(3) == 0) continue;
    for (std::size_t k = first; k < last; ++k) b.number[k] = a.number[k];
  }
  return b;
}

/// Few digits, so that outlines often touch or share stretches, and numbers that differ are far apart.
TEST(InflatedCrossings, OfShapesOnALattice) {
  Random random(properties::seed());
  Tally tally;
  for (int i = 0; i < 4000 * properties::repeat() && !HasFatalFailure(); ++i) {
    const Shape a = lattice_shape(random);
    Shape b = i % 2 == 0 && is_inflated(a) ? like(a, random) : lattice_shape(random);
    while (!is_inflated(a) && !is_inflated(b)) b = lattice_shape(random);
    compare(a, b, tally);
  }
  EXPECT_GT(tally.met, 1000 * properties::repeat());
  EXPECT_GT(tally.shared, 100 * properties::repeat());
  EXPECT_EQ(tally.most, 8);
}

TEST(InflatedCrossings, OfAnyShapes) {
  Random random(properties::seed());
  Tally tally;
  for (int i = 0; i < 2000 * properties::repeat() && !HasFatalFailure(); ++i) {
    const Shape a = any_shape(random, 5), b = inflated_shape(random);
    compare(a, b, tally);
    compare(b, inflated_shape(random), tally);
  }
  EXPECT_GT(tally.met, 500 * properties::repeat());
}

/// Moves the second shape to where the count changes, and asks at the doubles next to that.
TEST(InflatedCrossings, WhereTheCountChanges) {
  Random random(properties::seed());
  Tally tally;
  int changes = 0;
  for (int i = 0; i < 1500 * properties::repeat() && !HasFatalFailure(); ++i) {
    const Shape a = any_shape(random, 5), b = inflated_shape(random);
    double from = random.between(-2, 2), to = from + random.between(0.1, 4);
    const auto count = [&](double dx) { return crossings(a, moved(b, dx)).count; };
    const std::int64_t before = count(from);
    if (count(to) == before) continue;
    for (int k = 0; k < 60; ++k) {
      const double middle = from + (to - from) / 2;
      (count(middle) == before ? from : to) = middle;
    }
    ++changes;
    for (int k = -2; k <= 2; ++k) compare(a, moved(b, from + k * (to - from)), tally);
  }
  EXPECT_GT(changes, 20 * properties::repeat());
}

TEST(InflatedCrossings, Errors) {
  const Shape invalid{VESICA_CAPSULE, {0, 0, 1, 0, -1}}, ellipse{VESICA_ELLIPSE, {0, 0, 1, 0, 2, 1}};
  EXPECT_EQ(crossings(capsule, invalid).count, VESICA_E_SHAPE);
  EXPECT_EQ(crossings(invalid, {VESICA_POINT, {0, 0}}).count, VESICA_E_SHAPE);
  EXPECT_EQ(crossings(invalid, ellipse).count, VESICA_E_SHAPE);
  EXPECT_EQ(crossings(ellipse, {VESICA_ROUND_RECT, {0, 0, 0, 0, 1, 1, 1}}).count, VESICA_E_SHAPE);
  const Shape huge{VESICA_CAPSULE, {0, 0, 0x1p1023, 0, 0x1p1023}};
  EXPECT_EQ(crossings(huge, {VESICA_SEGMENT, {0x1.8p1023, 0, 0x1.8p1023, 0x1p1023}}).count, 1);
  // Its end is beyond the greatest number.
  EXPECT_EQ(crossings(huge, {VESICA_SEGMENT, {0, 0, 0x1.fffffffffffffp1023, 0}}).count, 0);
  const Shape wide{VESICA_CAPSULE, {0x1.8p1023, -0x1p1023, 0x1.8p1023, 0x1p1023, 0x1.8p1023}};
  EXPECT_EQ(crossings(wide, {VESICA_CIRCLE, {0x1.8p1023, 0, 0x1.8p1023}}).count, VESICA_E_RANGE);
}

/// Lengths times a power of two, from subnormal to huge ones: the same places.
TEST(InflatedCrossings, PowersOfTwo) {
  Random random(properties::seed());
  for (int i = 0; i < 1000 * properties::repeat(); ++i) {
    const Shape a = i % 2 == 0 ? any_shape(random, 5) : lattice_shape(random);
    Shape b = i % 2 == 0 ? inflated_shape(random) : lattice_shape(random);
    while (!is_inflated(b)) b = lattice_shape(random);
    const Found unit = crossings(a, b);
    for (const int exponent : {-900, -300, 300, 900}) {
      const Found found = crossings(times(a, std::ldexp(1, exponent)), times(b, std::ldexp(1, exponent)));
      ASSERT_EQ(found.count, unit.count);
      for (std::size_t k = 0; k < static_cast<std::size_t>(unit.count); ++k) {
        ASSERT_EQ(found.at[k].x, std::ldexp(unit.at[k].x, exponent));
        ASSERT_EQ(found.at[k].y, std::ldexp(unit.at[k].y, exponent));
      }
    }
  }
}

}  // namespace
}  // namespace inflated_crossings
