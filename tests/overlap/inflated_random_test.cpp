// SPDX-License-Identifier: Apache-2.0
// Capsules and rounded rectangles on a lattice, where contact is common, against the oracle's distance of their cores.
#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <cstdint>

#include "oracle/distance.hpp"
#include "properties/random.hpp"

namespace {

using properties::Random;

/// A shape, and its core with the radius that it has.
struct Shape {
  std::int32_t kind, core_kind;
  std::array<double, 7> number, core;
  double radius;
};

/// Axes of rational and of irrational length.
constexpr std::array<std::array<double, 2>, 5> axes{{{1, 0}, {0, -2}, {3, 4}, {1, 1}, {0.6, 0.8}}};

std::array<double, 7> rect(Random& random) {
  const auto& axis = axes[static_cast<std::size_t>(random.below(axes.size()))];
  return {static_cast<double>(random.integer(-6, 6)), static_cast<double>(random.integer(-6, 6)),     axis[0], axis[1],
          static_cast<double>(random.integer(0, 2)),  static_cast<double>(random.integer(0, 4)) * 0.5};
}

Shape shape(std::int32_t kind, Random& random) {
  const auto number = [&] { return static_cast<double>(random.integer(-6, 6)); };
  const double r = random.integer(0, 10);
  switch (kind) {
    case VESICA_POINT: {
      const std::array<double, 7> n{number(), number()};
      return {kind, kind, n, n, 0};
    }
    case VESICA_CIRCLE: {
      const double x = number(), y = number();
      return {kind, VESICA_POINT, {x, y, r}, {x, y}, r};
    }
    case VESICA_SEGMENT:
    case VESICA_CAPSULE: {
      const double x0 = number(), y0 = number(), x1 = number(), y1 = number();
      const double radius = kind == VESICA_CAPSULE ? r : 0;
      return {kind, VESICA_SEGMENT, {x0, y0, x1, y1, radius}, {x0, y0, x1, y1}, radius};
    }
    case VESICA_AABB: {
      const double x = number(), y = number();
      const std::array<double, 7> n{x, y, x + random.integer(0, 4), y + random.integer(0, 4)};
      return {kind, kind, n, n, 0};
    }
    default: {
      const auto core = rect(random);
      auto n = core;
      const double radius = kind == VESICA_ROUND_RECT ? r : 0;
      n[6] = radius;
      return {kind, VESICA_RECT, n, core, radius};
    }
  }
}

std::int32_t overlap(const Shape& a, const Shape& b) {
  return vesica_overlap_f64(a.kind, a.number.data(), b.kind, b.number.data());
}

TEST(OverlapInflated, AgreesWithTheOracleOnALattice) {
  Random random(properties::seed());
  int overlapping = 0;
  const int cases = 200000 * properties::repeat();
  for (int i = 0; i < cases; ++i) {
    const std::int32_t kinds[] = {VESICA_POINT, VESICA_SEGMENT, VESICA_CIRCLE,    VESICA_AABB,
                                  VESICA_RECT,  VESICA_CAPSULE, VESICA_ROUND_RECT};
    const Shape a = shape(kinds[random.below(7)], random);
    const Shape b = shape(random.chance(0.5) ? VESICA_CAPSULE : VESICA_ROUND_RECT, random);
    const bool truth = oracle::within(a.core_kind, a.core.data(), b.core_kind, b.core.data(), a.radius + b.radius);
    ASSERT_EQ(overlap(a, b), truth) << "case " << i;
    ASSERT_EQ(overlap(b, a), truth) << "case " << i << ", exchanged";
    overlapping += truth;
  }
  EXPECT_GT(overlapping, cases / 4);
  EXPECT_LT(overlapping, cases * 9 / 10);
}

/// A circle said as an ellipse: exact arithmetic goes another way.
TEST(OverlapInflated, EllipsesThatAreCircles) {
  Random random(properties::seed());
  int touching = 0;
  const int cases = 20000 * properties::repeat();
  for (int i = 0; i < cases; ++i) {
    Shape c = shape(VESICA_CIRCLE, random);
    const Shape b = shape(random.chance(0.5) ? VESICA_CAPSULE : VESICA_ROUND_RECT, random);
    const double fifth = random.integer(1, 2);
    c.number[2] = 5 * fifth;
    const vesica_ellipse_f64 e{c.number[0], c.number[1], 3, 4, fifth, fifth};
    const std::int32_t as_circle = overlap(c, b);
    ASSERT_EQ(vesica_overlap_f64(VESICA_ELLIPSE, &e, b.kind, b.number.data()), as_circle) << "case " << i;
    touching += as_circle;
  }
  EXPECT_GT(touching, 0);
}

}  // namespace
