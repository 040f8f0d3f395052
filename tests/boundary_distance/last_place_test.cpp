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

// Was up to 3.5 quanta off: products underflowed, the result was rounded twice. A distance below one quantum is one.
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
    const double place = std::nextafter(found.distance, 1) - found.distance;
    EXPECT_TRUE(off.get_d() <= 0.5001 * place / 0x1p-1074 || found.distance == 0x1p-1074) << i;
    ++nested;
  }
  EXPECT_GT(nested, 30);
}

// Were a last place off: an AABB's width was rounded before it was used.
TEST(OutlineLastPlace, AabbsAtAnyMagnitude) {
  const Numbers a{-0x1.3a8a05b50c8ebp-1021, -0x1.76ea81920f92p-1021, 0x1.c366c75d36d5cp-1021, 0x1.cd0654bea756p-1021};
  const Numbers b{-0x0.94564c4dbe52p-1022, -0x1.035fe46cf11b1p-1022, 0x1.152bf06581cdcp-1022, 0x0.a0e1b2041c37ep-1022};
  for (const int exponent : {0, 1, 600, 1020}) {
    Numbers p = a, q = b;
    for (std::size_t i = 0; i < 4; ++i) p[i] = std::ldexp(a[i], exponent), q[i] = std::ldexp(b[i], exponent);
    vesica_closest_points_f64 found;
    ASSERT_EQ(vesica_boundary_distance_f64(VESICA_AABB, p.data(), VESICA_AABB, q.data(), &found), 0);
    EXPECT_EQ(found.distance, q[0] - p[0]);
  }
}

}  // namespace
