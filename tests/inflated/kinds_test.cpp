// SPDX-License-Identifier: Apache-2.0
// Questions that do not take capsules and rounded rectangles yet say so, and write nothing.
#include <gtest/gtest.h>
#include <vesica_topology.h>

#include <cstdint>

#include "inflated/shapes.hpp"

namespace {

using namespace inflated;

TEST(InflatedKinds, AreRefusedByOtherQuestions) {
  const vesica_capsule_f64 a{0, 0, 1, 0, 1};
  const vesica_ellipse_f64 b{0, 0, 1, 0, 2, 1};
  vesica_closest_points_f64 points{7, 7, 7, 7, 7};
  EXPECT_EQ(vesica_boundary_distance_f64(VESICA_CAPSULE, &a, VESICA_ELLIPSE, &b, &points), VESICA_E_KIND);
  EXPECT_EQ(points.distance, 7);
  char matrix[10] = "untouched";
  EXPECT_EQ(vesica_de9im_f64(VESICA_CAPSULE, &a, VESICA_ELLIPSE, &b, matrix), VESICA_E_KIND);
  EXPECT_STREQ(matrix, "untouched");
  std::int32_t shared = 7;
  EXPECT_EQ(vesica_crossings_f64(VESICA_CAPSULE, &a, VESICA_ELLIPSE, &b, nullptr, 0, &shared), VESICA_E_KIND);
  EXPECT_EQ(shared, 7);
  EXPECT_EQ(vesica_intersection_f64(VESICA_CAPSULE, &a, VESICA_CAPSULE, &a, nullptr, 0), VESICA_E_KIND);
}

}  // namespace
