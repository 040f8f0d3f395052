// SPDX-License-Identifier: Apache-2.0
/// The least distance within which an ellipse and another shape are, to the last place: found by bisection, compared
/// with the oracle at that number and at the one below. Thin, far, tiny and degenerate shapes; mirrored, turned,
/// exchanged.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vesica/exact/within_ellipse.hpp>

#include "oracle/distance.hpp"
#include "properties/exact_changes.hpp"
#include "properties/pairs_of_kinds.hpp"
#include "within/face.hpp"

namespace {

using namespace within_test;
using properties::Numbers;
using properties::Random;
using properties::Role;

enum class Family { plain, lattice, thin, far, tiny, degenerate };
constexpr Family families[] = {Family::plain, Family::lattice, Family::thin,
                               Family::far,   Family::tiny,    Family::degenerate};

double drawn(Family family, Role role, Random& random) {
  const bool whole = family == Family::lattice || family == Family::tiny || family == Family::far;
  switch (role) {
    case Role::size:
    case Role::radius:
      if (family == Family::thin) return std::pow(10, random.between(-12, 0));
      if (family == Family::degenerate && random.chance(0.4)) return 0;
      return whole ? random.integer(0, 6) : random.between(0, 4);
    case Role::axis:
      return whole ? random.integer(-4, 4) : random.between(-2, 2);
    default:
      return whole ? random.integer(-40, 40) : random.between(-9, 9);
  }
}

Numbers shape(Scalar scalar, Family family, int kind, Random& random) {
  const double unit = family != Family::tiny ? 1 : scalar == Scalar::f64 ? 0x1p-1060 : 0x1p-140;
  const double away = family != Family::far ? 0 : scalar == Scalar::f64 ? 1e15 : 0x1p22;
  Numbers n{};
  for (int i = 0; i < properties::field_count(kind); ++i) {
    const Role role = properties::role(kind, i);
    double& x = n[static_cast<std::size_t>(i)];
    x = drawn(family, role, random);
    if (role == Role::x || role == Role::y) x = (x + away) * unit;
    if (role == Role::radius) x *= unit;
    if (role == Role::axis) x *= unit;
  }
  if (family == Family::degenerate && kind == VESICA_SEGMENT && random.chance(0.3)) n[2] = n[0], n[3] = n[1];
  return properties::nearest_shape(scalar, kind, n);
}

class WithinContact : public testing::TestWithParam<properties::Kinds> {
 protected:
  Scalar scalar() const { return GetParam().scalar; }
  double at(std::int64_t place) const { return properties::at_ordinal(scalar(), place); }
  std::int32_t answer(const Pair& p, std::int64_t place) const { return within(scalar(), p, at(place)); }

  /// The place of the least distance within which a pair is that does not overlap.
  std::int64_t least_place(const Pair& p) const {
    std::int64_t low = 0, high = properties::ordinal(scalar(), scalar() == Scalar::f64 ? 0x1p1023 : 0x1p127);
    while (high - low > 1) {
      const std::int64_t middle = low + (high - low) / 2;
      (answer(p, middle) == VESICA_WITHIN_NO ? low : high) = middle;
    }
    return high;
  }

  void check(const Pair& p, std::int64_t place) const {
    char text[40];
    std::snprintf(text, sizeof text, " within %a", at(place));
    SCOPED_TRACE(properties::describe(p) + text);
    const auto expect = [&](const Pair& same, const char* name) {
      EXPECT_EQ(answer(same, place), VESICA_WITHIN_YES) << name;
      EXPECT_EQ(answer(same, place - 1), VESICA_WITHIN_NO) << name;
    };
    const auto moved = [&](properties::Shape (*move)(const properties::Shape&)) {
      return pair_of(move(first(p)), move(second(p)));
    };
    expect(p, "itself");
    expect(swapped(p), "exchanged");
    expect(moved(properties::mirrored), "mirrored");
    expect(moved(properties::turned), "turned");
    EXPECT_TRUE(oracle::within(p.kind_a, p.a.data(), p.kind_b, p.b.data(), at(place)));
    EXPECT_FALSE(oracle::within(p.kind_a, p.a.data(), p.kind_b, p.b.data(), at(place - 1)));
  }
};

TEST_P(WithinContact, LeastDistance) {
  std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(properties::seed()));
  const properties::Kinds k = GetParam();
  Random random(properties::seed() + 31);
  for (const Family family : families) {
    int apart = 0;
    for (int i = 0; i < 100 * properties::repeat(); ++i) {
      const Pair p{k.a, k.b, shape(k.scalar, family, k.a, random), shape(k.scalar, family, k.b, random)};
      if (answer(p, 0) == VESICA_WITHIN_YES) continue;
      ++apart;
      check(p, least_place(p));
      if (HasFailure()) FAIL() << "family " << static_cast<int>(family);
    }
    EXPECT_GT(apart, 4);
  }
}

std::vector<properties::Kinds> with_an_ellipse() {
  std::vector<properties::Kinds> result;
  for (const properties::Kinds& k : properties::all_pairs_of_kinds()) {
    if ((k.a == VESICA_ELLIPSE) != (k.b == VESICA_ELLIPSE)) result.push_back(k);
  }
  return result;
}
INSTANTIATE_TEST_SUITE_P(All, WithinContact, testing::ValuesIn(with_an_ellipse()), properties::test_name);

/// Ellipses of half length 2^-40 across, which moves the contact by last places.
const struct {
  Pair pair;
  double distance;
} thin[] = {
    {{VESICA_POINT, VESICA_ELLIPSE, {2, 0}, {0, 0, 1, 0, 1, 0x1p-40}}, 1},
    {{VESICA_POINT, VESICA_ELLIPSE, {0, 1 + 0x1p-40}, {0, 0, 1, 0, 1, 0x1p-40}}, 1},
    {{VESICA_SEGMENT, VESICA_ELLIPSE, {-1, 1 + 0x1p-40, 1, 1 + 0x1p-40}, {0, 0, 1, 0, 9, 0x1p-40}}, 1},
    {{VESICA_RECT, VESICA_ELLIPSE, {-3 - 0x1p-40, 0, 0, 2, 1, 1}, {0, 0, 0, 1, 1e12, 0x1p-40}}, 1},
};

TEST(KnownWithin, ThinEllipses) {
  for (const auto& c : thin) {
    SCOPED_TRACE(properties::describe(c.pair));
    EXPECT_EQ(within(Scalar::f64, c.pair, c.distance), VESICA_WITHIN_YES);
    EXPECT_EQ(within(Scalar::f64, c.pair, std::nextafter(c.distance, 0)), VESICA_WITHIN_NO);
  }
}

// Ellipses that pass beneath the corner (2, -1) of a box, along y = (x - 5) / 2, with their centre above that corner or
// above the whole box. The line of the box's right side meets them. They are 1 / sqrt(5) away from the corner, less
// some 2^-59.
TEST(KnownWithin, EllipseAroundACorner) {
  const double least = 0x1.c9f25c5bfedd9p-2 + 0x1p-54;
  for (const double y : {0.5, 2.5}) {
    for (const double mirror : {1.0, -1.0}) {
      const Pair p{
          VESICA_AABB, VESICA_ELLIPSE, {-2, -1, 2, 1}, {mirror * (2 * y + 5), mirror * y, 2, 1, y + 3.5, 0x1p-60}};
      SCOPED_TRACE(properties::describe(p));
      EXPECT_EQ(within(Scalar::f64, p, least), VESICA_WITHIN_YES);
      EXPECT_EQ(within(Scalar::f64, p, std::nextafter(least, 0)), VESICA_WITHIN_NO);
    }
  }
}

// Centres on an axis of a square: which of two corners is closer is for the direction of the ellipse to say. The nearer
// corner is 14 / sqrt(5) from the ellipse's axis, the other one 18 / sqrt(5).
TEST(KnownWithin, EllipseBesideTheMiddleOfASide) {
  constexpr double least = 0x1.90b410d07f01fp+2;
  properties::Shape square{VESICA_AABB, {-2, -2, 2, 2}}, ellipse{VESICA_ELLIPSE, {0, -10, 2, 1, 4, 0x1p-60}};
  for (int turn = 0; turn < 4; ++turn) {
    for (const properties::Shape& e : {ellipse, properties::mirrored(ellipse)}) {
      const Pair p = pair_of(square, e);
      SCOPED_TRACE(properties::describe(p));
      EXPECT_EQ(within(Scalar::f64, p, least), VESICA_WITHIN_YES);
      EXPECT_EQ(within(Scalar::f64, p, std::nextafter(least, 0)), VESICA_WITHIN_NO);
    }
    ellipse = properties::turned(ellipse);
  }
}

// The exact stage by itself, which the filter and overlap keep from pairs such as these: an ellipse across a box far
// from its corners, and a reach far greater than the distance.
TEST(KnownWithin, ExactStage) {
  const auto box = vesica::exact::form(vesica::Aabb<double>{-100, -1, 100, 1});
  const auto across = vesica::exact::form(vesica::Ellipse<double>{0, 5, 1, 0, 0.125, 10});
  const auto above = vesica::exact::form(vesica::Ellipse<double>{0, 20, 1, 0, 0.125, 10});
  const auto reach = [](double x) { return vesica::exact::from_double(x); };
  EXPECT_TRUE(vesica::exact::within(box, across, reach(0x1p-1074)));
  EXPECT_TRUE(vesica::exact::within(box, across, reach(0)));
  EXPECT_FALSE(vesica::exact::within(box, above, reach(0)));
  const auto beyond_corner = vesica::exact::form(vesica::Ellipse<double>{110, 20, 1, 0, 0.125, 10});
  EXPECT_FALSE(vesica::exact::within(box, beyond_corner, reach(0)));
  EXPECT_FALSE(vesica::exact::within(box, above, reach(8)));
  EXPECT_TRUE(vesica::exact::within(box, above, reach(9)));
  EXPECT_TRUE(vesica::exact::within(box, above, reach(1e9)));
  // Three terms: 9 - 2^-1000 and 9.
  EXPECT_FALSE(vesica::exact::within(box, above, reach(5) + reach(4) - reach(0x1p-1000)));
  EXPECT_TRUE(vesica::exact::within(box, above, reach(5) + reach(4) + reach(0x1p-1074)));
  const auto flat = vesica::exact::form(vesica::Ellipse<double>{0, 20, 1, 0, 0, 10});
  EXPECT_FALSE(vesica::exact::within(box, flat, reach(8)));
  EXPECT_TRUE(vesica::exact::within(box, flat, reach(9)));
}

}  // namespace
