// SPDX-License-Identifier: Apache-2.0
// Exact counts of the places on an arc, which outlines need only where a place is near an end: against 190 digits, for
// circles and ellipses that cross, touch and osculate in every combination.
#include <gtest/gtest.h>

#include <map>
#include <vesica/crossings.hpp>

#include "inflated/ellipse_outline.hpp"

namespace arc_counts {
namespace {

using namespace inflated;
using properties::Random;
namespace crossings = vesica::detail::crossings;

crossings::RoundOutline outline(const Shape& s) {
  const auto& n = s.number;
  if (s.kind == VESICA_CAPSULE) {
    return crossings::round_outline(vesica::Capsule<double>{n[0], n[1], n[2], n[3], n[4]});
  }
  return crossings::round_outline(vesica::RoundRect<double>{n[0], n[1], n[2], n[3], n[4], n[5], n[6]});
}

/// Counts of cases by crossings and touches on the whole circle and inside an arc.
using Seen = std::map<std::array<int, 3>, int>;

void compare(const Shape& round, const Shape& oval, Seen& seen) {
  SCOPED_TRACE(described(round) + "   " + described(oval));
  const auto& n = oval.number;
  const auto ellipse = vesica::exact::form(vesica::Ellipse<double>{n[0], n[1], n[2], n[3], n[4], n[5]});
  const crossings::RoundOutline k = outline(round);
  const std::vector<std::array<int, 3>> expected = places_on_arcs(round, oval);
  ASSERT_EQ(expected.size(), static_cast<std::size_t>(k.corners.count));
  for (int i = 0; i < k.corners.count; ++i) {
    const crossings::CircleAndEllipse circle(k, i, ellipse);
    if (circle.all.equal) continue;
    const crossings::CircleCensus all = circle.zeros(k, i, ellipse);
    const crossings::ArcCounts found = k.corners.count == 2 ? crossings::counts_on_half(k, i, ellipse, all)
                                                            : crossings::counts_on_quarter(k, i, ellipse, all);
    const auto& [begin, inside, end] = expected[static_cast<std::size_t>(i)];
    ASSERT_EQ(found.begin, begin) << i;
    ASSERT_EQ(found.inside, inside) << i;
    ASSERT_EQ(found.end, end) << i;
    ++seen[{circle.all.crossing, circle.all.touching, inside}];
  }
}

/// A core in one of many directions that has a corner at (x, y).
Shape with_corner(double x, double y, double r, Random& random) {
  constexpr double axes[][2] = {{1, 0}, {0, 1},  {-1, 0}, {0, -1}, {3, 4},  {-4, 3},  {4, 3},
                                {1, 1}, {2, -1}, {-1, 3}, {7, 24}, {5, 12}, {12, -5}, {-5, -12}};
  const auto& [ux, uy] = axes[random.below(14)];
  const double a = random.integer(1, 3), b = random.integer(1, 3);
  if (random.below(3) == 0) return {VESICA_CAPSULE, {x, y, x + a * ux, y + a * uy, r}};
  const double along = random.sign() * a, across = random.sign() * b;
  return {VESICA_ROUND_RECT, {x + along * ux - across * uy, y + along * uy + across * ux, ux, uy, a, b, r}};
}

/// Circle and ellipse of nearly one size about nearly one centre.
TEST(ArcCounts, OfCirclesAndEllipsesThatCross) {
  Random random(properties::seed());
  Seen seen;
  for (int i = 0; i < 3000 * properties::repeat() && !HasFatalFailure(); ++i) {
    const double r = random.integer(3, 12);
    const Shape round = with_corner(random.integer(-1, 1), random.integer(-1, 1), r, random);
    constexpr double axes[][2] = {{1, 0}, {0, 1}, {0.6, 0.8}, {3, 4}, {1, 1}};
    const auto& [ux, uy] = axes[random.below(5)];
    const double unit = std::max(1.0, std::round(std::hypot(ux, uy)));
    compare(round,
            {VESICA_ELLIPSE, {0, 0, ux, uy, (r + random.integer(-2, 2)) / unit, (r + random.integer(-2, 2)) / unit}},
            seen);
  }
  for (int inside = 0; inside <= 3; ++inside) EXPECT_GT((seen[{4, 0, inside}]), 0) << inside;
}

/// About points on an axis of the ellipse with sizes 125 and 75. Its end has the curvature of a circle of radius 45.
TEST(ArcCounts, OfCirclesAndEllipsesThatTouch) {
  Random random(properties::seed());
  Seen seen;
  for (int i = 0; i < 4000 * properties::repeat() && !HasFatalFailure(); ++i) {
    constexpr double axes[][2] = {{3, 4}, {-4, 3}, {5, 0}, {0, -5}};
    const auto& [ux, uy] = axes[random.below(4)];
    double off = 0, r = 0;
    switch (random.below(3)) {
      case 0:  // touches at both sides of the axis, or crosses beside that
        off = 60;
        r = random.below(2) == 0 ? 60 : 60 + random.integer(-1, 1);
        break;
      case 1:  // touches at the end of the axis
        off = 5 * random.integer(0, 24);
        r = 125 - off;
        break;
      default:
        off = 5 * random.integer(-10, 24);
        r = random.below(3) == 0 ? 45 : 5 * random.integer(1, 30);
        break;
    }
    const double way = random.sign() * off / 25;
    const Shape round = with_corner(way * 5 * ux, way * 5 * uy, r, random);
    compare(round, {VESICA_ELLIPSE, {0, 0, ux, uy, 25, 15}}, seen);
  }
  for (const std::array<int, 3>& each :
       {std::array{2, 1, 3}, {2, 1, 2}, {2, 1, 1}, {0, 2, 2}, {0, 2, 1}, {0, 1, 1}, {4, 0, 2}}) {
    EXPECT_GT(seen[each], 0) << each[0] << ' ' << each[1] << ' ' << each[2];
  }
}

/// At the point (351, 260) of an ellipse with sizes 585 and 325: away from its axes, with the normal (5, 12) / 13.
TEST(ArcCounts, OfCirclesThatTouchAnywhere) {
  Random random(properties::seed());
  Seen seen;
  for (int i = 0; i < 3000 * properties::repeat() && !HasFatalFailure(); ++i) {
    const int steps = random.integer(1, 90);
    const Shape round = with_corner(351 - 5 * steps, 260 - 12 * steps, 13 * steps, random);
    compare(round, {VESICA_ELLIPSE, {0, 0, 1, 0, 585, 325}}, seen);
  }
  for (const std::array<int, 3>& each : {std::array{2, 1, 3}, {2, 1, 2}, {2, 1, 1}, {0, 1, 1}}) {
    EXPECT_GT(seen[each], 0) << each[0] << ' ' << each[1] << ' ' << each[2];
  }
}

}  // namespace
}  // namespace arc_counts
