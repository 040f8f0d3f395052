// SPDX-License-Identifier: Apache-2.0
// Nested outlines against 90 digits: the distance, and that each point is on its outline.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "boundary_distance/nested_pairs.hpp"
#include "boundary_distance/reference.hpp"
#include "properties/random.hpp"
#include "vesica.h"

namespace {

using properties::Numbers;
using properties::Pair;

/// The header's error bounds, in roundoffs of the scale; for points also times the aspect ratio.
constexpr double promised = 4;

/// Largest errors met, in those units.
struct Worst {
  double distance = 0, point = 0, length = 0;
};

/// Half a unit in the last place of each coordinate, which no point is free of.
double rounding_of(double x, double y) { return 0x1p-53 * (std::abs(x) + std::abs(y)); }

double off_outline(const outline_reference::Shape& s, double x, double y, double scale) {
  const double off = outline_reference::distance_from_outline(s, x, y) - rounding_of(x, y);
  return std::max(off, 0.0) / (0x1p-53 * scale * outline_reference::aspect(s));
}

void measure(const Pair& pair, Worst& worst) {
  vesica_closest_points_f64 c;
  ASSERT_EQ(vesica_boundary_distance_f64(pair.kind_a, pair.a.data(), pair.kind_b, pair.b.data(), &c), 0);
  const auto a = outline_reference::shape(pair.kind_a, pair.a), b = outline_reference::shape(pair.kind_b, pair.b);
  const double scale = outline_reference::scale(a, b), unit = 0x1p-53 * scale;
  const double error =
      std::abs(outline_reference::error_in_roundoffs(c.distance, outline_reference::least(a, b, -1).value, scale));
  const double on_a = off_outline(a, c.ax, c.ay, scale), on_b = off_outline(b, c.bx, c.by, scale);
  EXPECT_LE(error, promised) << properties::describe(pair);
  EXPECT_LE(on_a, promised) << properties::describe(pair);
  EXPECT_LE(on_b, promised) << properties::describe(pair);
  EXPECT_GT(c.distance, 0) << properties::describe(pair);
  // The points are as far apart as the answer says: with both on their outlines, it is no less than the truth.
  const double rounding = rounding_of(c.ax, c.ay) + rounding_of(c.bx, c.by);
  const double length = std::abs(std::hypot(c.bx - c.ax, c.by - c.ay) - c.distance) - rounding;
  worst = {std::max(worst.distance, error), std::max({worst.point, on_a, on_b}), std::max(worst.length, length / unit)};
}

void run(int outer, int inner, int pairs_a_style) {
  properties::Random random(properties::seed() + static_cast<unsigned>(10 * outer + inner) + 1000);
  for (const nested_pairs::Style style : nested_pairs::all_styles) {
    Worst worst;
    for (int i = 0; i < pairs_a_style * properties::repeat() && !testing::Test::HasFailure(); ++i) {
      const auto pair = nested_pairs::draw(style, outer, inner, random);
      if (pair) measure(*pair, worst);
    }
    std::printf("%s in %s, %s: distance off by %.2f, points by %.2f, their distance by %.2f\n", vesica_kind_name(inner),
                vesica_kind_name(outer), name(style), worst.distance, worst.point, worst.length);
  }
}

TEST(BoundaryDistanceAccuracy, InEllipse) {
  run(VESICA_ELLIPSE, VESICA_ELLIPSE, 250);
  for (int inner = VESICA_POINT; inner < VESICA_ELLIPSE; ++inner) run(VESICA_ELLIPSE, inner, 40);
}

TEST(BoundaryDistanceAccuracy, InCircle) {
  for (int inner = VESICA_POINT; inner <= VESICA_ELLIPSE; ++inner) run(VESICA_CIRCLE, inner, 30);
}

TEST(BoundaryDistanceAccuracy, InBoxes) {
  for (int inner = VESICA_POINT; inner <= VESICA_ELLIPSE; ++inner) run(VESICA_AABB, inner, 30);
  for (int inner = VESICA_POINT; inner <= VESICA_ELLIPSE; ++inner) run(VESICA_RECT, inner, 30);
}

TEST(BoundaryDistanceAccuracy, WithACoreAndARadius) {
  for (const int outer : {VESICA_CAPSULE, VESICA_ROUND_RECT}) {
    for (int inner = VESICA_POINT; inner <= VESICA_ROUND_RECT; ++inner) run(outer, inner, 40);
  }
  for (int outer = VESICA_CIRCLE; outer <= VESICA_ELLIPSE; ++outer) {
    for (const int inner : {VESICA_CAPSULE, VESICA_ROUND_RECT}) run(outer, inner, 40);
  }
}

}  // namespace
