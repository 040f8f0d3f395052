// SPDX-License-Identifier: Apache-2.0
// Bounds on an arc of directions, by which a search leaves arcs out: never above what is there, or a minimum would be
// missed, and no further below it than the range of the curvature makes them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>
#include <vesica/support_minimum/arc_bound.hpp>

#include "properties/random.hpp"

namespace {

using namespace vesica::detail::support_minimum;
using properties::Random;

constexpr double noise = 1e-12;
constexpr int steps = 200;

/// Half lengths of an ellipse, and the angle of its axis.
struct Oval {
  double a, b, angle;

  double height(double at) const { return std::hypot(a * std::cos(at - angle), b * std::sin(at - angle)); }
  /// The height's derivative with respect to the angle.
  double slope(double at) const { return (b * b - a * a) * std::sin(2 * (at - angle)) / (2 * height(at)); }
  double radius(double at) const { return std::pow(a * b, 2) / std::pow(height(at), 3); }
};

struct Combination {
  Oval first, second;
  double sign, x, y;

  Sample at(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {{c, s},
            first.height(angle) + sign * second.height(angle) + x * c + y * s,
            first.slope(angle) + sign * second.slope(angle) - x * s + y * c,
            first.radius(angle),
            second.radius(angle)};
  }
};

template <class Value>
bool is_monotone(const std::vector<Sample>& samples, const Value& value) {
  const auto less = [&](const Sample& s, const Sample& t) { return value(s) < value(t); };
  return std::is_sorted(samples.begin(), samples.end(), less) || std::is_sorted(samples.rbegin(), samples.rend(), less);
}

Combination draw(Random& random) {
  const double size = std::exp2(random.between(-6, 3));
  const Oval first{size * random.between(0.1, 1), size * random.between(0.1, 1), random.between(0, 3)};
  Oval second{size * random.between(0.1, 1), size * random.between(0.1, 1), random.between(0, 3)};
  if (random.chance(0.5)) second = {first.a * random.between(0.9, 1), first.b * random.between(0.9, 1), first.angle};
  return {first, second, random.sign(), size * random.between(-1, 1), size * random.between(-1, 1)};
}

TEST(ArcBounds, AreBelowAndNotFarBelow) {
  Random random(properties::seed());
  int asked = 0, inside = 0;
  for (int i = 0; i < 3000 * properties::repeat(); ++i) {
    const Combination f = draw(random);
    const double from = random.between(0, 6.28), arc = 1.57 * std::exp2(-random.between(0, 8));
    std::vector<Sample> samples;
    for (int k = 0; k <= steps; ++k) samples.push_back(f.at(from + arc * k / steps));
    if (!is_monotone(samples, [](const Sample& s) { return s.radius1; }) ||
        !is_monotone(samples, [](const Sample& s) { return s.radius2; }) ||
        !is_monotone(samples, [](const Sample& s) { return s.radius1 / s.radius2; })) {
      continue;
    }
    ++asked;
    const Sample &a = samples.front(), &b = samples.back();
    const double size = std::max(a.radius1, b.radius1) + std::max(a.radius2, b.radius2) + std::hypot(f.x, f.y) +
                        f.first.a + f.first.b + f.second.a + f.second.b;
    const Range range = curvature(a, b, f.sign);
    double least = samples[0].value;
    for (const Sample& s : samples) {
      const double curved = s.radius1 + f.sign * s.radius2;
      EXPECT_TRUE(range.low <= curved + noise * size && curved <= range.high + noise * size) << i;
      least = std::min(least, s.value);
    }
    inside += least < std::min(a.value, b.value);
    // From either end F differs from what the bound takes it for by at most the range times 1 - cos of the way, and
    // between two directions that were tried it may be lower than at them.
    const double bound = lower_bound(a, b, range), between = 2 * size * std::pow(arc / steps, 2);
    EXPECT_LE(bound, least + noise * size) << i << ", seed " << properties::seed();
    EXPECT_GE(bound, least - (range.high - range.low) * (1 - std::cos(arc)) - between - noise * size)
        << i << ", seed " << properties::seed();
  }
  EXPECT_TRUE(asked > 300 * properties::repeat() && inside > 30 * properties::repeat()) << asked << ' ' << inside;
}

/// g'' + g = c has the solution c + (g(0) - c) cos + g'(0) sin.
TEST(ArcBounds, LeastValueOfConstantCurvature) {
  Random random(properties::seed());
  for (int i = 0; i < 3000 * properties::repeat(); ++i) {
    const double value = random.between(-1, 1), slope = random.between(-1, 1), arc = random.between(0, 1.57);
    const double curvature = random.between(-1, 1) * std::exp2(random.integer(-3, 10));
    double expected = value;
    for (int k = 0; k <= steps; ++k) {
      const double t = arc * k / steps;
      expected = std::min(expected, curvature + (value - curvature) * std::cos(t) + slope * std::sin(t));
    }
    const double found = least(value, slope, curvature, std::cos(arc), std::sin(arc)), size = 2 + std::fabs(curvature);
    EXPECT_LE(found, expected + noise * size) << i;
    EXPECT_GE(found, expected - 2 * size * std::pow(arc / steps, 2) - noise * size) << i;
  }
}

void expect_range(const Range& range, double low, double high) {
  EXPECT_DOUBLE_EQ(range.low, low);
  EXPECT_DOUBLE_EQ(range.high, high);
}

/// Radii that nearly cancel all along: their ratio says how nearly.
TEST(ArcBounds, CurvatureByTheRatioOfRadii) {
  const auto sample = [](double radius1, double radius2) { return Sample{{1, 0}, 0, 0, radius1, radius2}; };
  expect_range(curvature(sample(0.5, 0.375), sample(0.25, 0.1875), -1), 0.0625, 0.125);
  expect_range(curvature(sample(0.375, 0.5), sample(0.1875, 0.25), -1), -0.125, -0.0625);
  expect_range(curvature(sample(4, 3), sample(2, 1.5), -1), 0.5, 1);
  expect_range(curvature(sample(4, 4), sample(2, 2), -1), 0, 0);
  // A box's corner has no radius, and no ratio.
  expect_range(curvature(sample(0.5, 0), sample(0.25, 0), -1), 0.25, 0.5);
  expect_range(curvature(sample(0, 0.5), sample(0, 0.25), -1), -0.5, -0.25);
  expect_range(curvature(sample(0.5, 0.375), sample(0.25, 0.1875), 1), 0.4375, 0.875);
}

}  // namespace
