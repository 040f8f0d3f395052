// SPDX-License-Identifier: Apache-2.0
// Distances of nested boxes where all numbers are subnormal: right to the last place.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "boundary_distance/reference.hpp"
#include "properties/generators.hpp"
#include "vesica.h"

namespace {

using outline_reference::Real;
using properties::Numbers;

// Was up to 3.5 quanta off: products underflowed, and the result was rounded twice. Turned boxes are still up to 1.6
// quanta off; the aim is half a quantum.
TEST(OutlineLastPlace, SubnormalBoxes) {
  std::mt19937_64 random(properties::seed());
  std::uniform_real_distribution<double> unit(-1, 1);
  int nested = 0;
  for (int i = 0; i < 150 * properties::repeat(); ++i) {
    const double size = std::ldexp(1, -1066 + static_cast<int>(random() % 46));
    const Numbers outer{size * unit(random), size * unit(random),       unit(random),
                        unit(random),        size * (5 + unit(random)), size * (5 + unit(random))};
    const Numbers inner{outer[0],     outer[1] + size * 0.2 * unit(random), unit(random),
                        unit(random), size * 0.3 * (1 + unit(random)),      size * 0.3 * (1 + unit(random))};
    if (vesica_relation_f64(VESICA_RECT, outer.data(), VESICA_RECT, inner.data()) != VESICA_CONTAINS) continue;
    if (!(inner[4] > 0 && inner[5] > 0)) continue;
    vesica_closest_points_f64 found;
    ASSERT_EQ(vesica_boundary_distance_f64(VESICA_RECT, outer.data(), VESICA_RECT, inner.data(), &found), 0);
    const auto exact = outline_reference::least(outline_reference::shape(VESICA_RECT, outer),
                                                outline_reference::shape(VESICA_RECT, inner), -1);
    const Real off = abs(Real(Real(found.distance) - exact.value)) / Real(0x1p-1074);
    EXPECT_LE(off.get_d(), 2) << i;
    ++nested;
  }
  EXPECT_GT(nested, 30);
}

}  // namespace
