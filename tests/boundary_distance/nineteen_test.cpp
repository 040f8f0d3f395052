// SPDX-License-Identifier: Apache-2.0
// The nineteen sample ellipses of a published distance by gradient descent, against 90 digits.
#include <gtest/gtest.h>

#include <cstring>

#include "boundary_distance/reference.hpp"
#include "methods/nineteen_ellipses.hpp"
#include "vesica.h"

namespace {

properties::Numbers numbers(const nineteen_ellipses::Sample& s) {
  const auto e = nineteen_ellipses::ellipse<double>(s);
  return {e.cx, e.cy, e.ux, e.uy, e.a, e.b};
}

TEST(NineteenEllipses, BoundaryDistance) {
  const auto first = numbers(nineteen_ellipses::first);
  const auto a = outline_reference::shape(VESICA_ELLIPSE, first);
  for (std::size_t i = 0; i < nineteen_ellipses::others.size(); ++i) {
    const auto other = numbers(nineteen_ellipses::others[i]);
    const auto b = outline_reference::shape(VESICA_ELLIPSE, other);
    vesica_closest_points_f64 c;
    ASSERT_EQ(vesica_boundary_distance_f64(VESICA_ELLIPSE, first.data(), VESICA_ELLIPSE, other.data(), &c), 0);
    const double scale = outline_reference::scale(a, b), unit = 0x1p-53 * scale;
    const int32_t relation = vesica_relation_f64(VESICA_ELLIPSE, first.data(), VESICA_ELLIPSE, other.data());
    if (nineteen_ellipses::touches_or_crosses(i)) {
      EXPECT_LE(c.distance, 4 * unit) << i;  // up to the rounding of the axes
    } else {
      // The gap of disjoint shapes says how far they are from contact; the gap of nested shapes has its own least.
      const bool nested = relation == VESICA_CONTAINS;
      EXPECT_EQ(relation, i == 18 ? VESICA_CONTAINS : VESICA_DISJOINT) << i;
      const auto exact = outline_reference::least(a, b, nested ? -1 : 1).value;
      const double error = outline_reference::error_in_roundoffs(nested ? c.distance : -c.distance, exact, scale);
      EXPECT_LE(std::abs(error), 4) << i;
    }
    EXPECT_LE(outline_reference::distance_from_outline(a, c.ax, c.ay), 16 * unit) << i;
    EXPECT_LE(outline_reference::distance_from_outline(b, c.bx, c.by), 16 * unit) << i;
  }
}

}  // namespace
