// SPDX-License-Identifier: Apache-2.0
// Questions that do not take capsules and rounded rectangles yet say so, and write nothing.
#include <gtest/gtest.h>
#include <vesica_topology.h>

#include <cstdint>

#include "inflated/shapes.hpp"

namespace {

using namespace inflated;
using properties::Random;

TEST(InflatedKinds, AreRefusedByOtherQuestions) {
  const vesica_capsule_f64 a{0, 0, 1, 0, 1};
  EXPECT_EQ(vesica_intersection_f64(VESICA_CAPSULE, &a, VESICA_CAPSULE, &a, nullptr, 0), VESICA_E_KIND);
}

/// The matrices of an ellipse with a core and a radius say what its relations and overlaps say.
TEST(InflatedKinds, MatricesOfEllipsesAgreeWithRelations) {
  Random random(properties::seed());
  int crossing = 0, inside = 0;
  const int pairs = 20000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    Shape a = shape(VESICA_ELLIPSE, random);
    const Shape b = inflated_shape(random);
    if (random.chance(0.5)) {
      for (std::size_t k = 4; k < 6; ++k) a.number[k] *= random.chance(0.5) ? 4 : 0.1;
    }
    const std::int32_t relation = vesica_relation_f64(a.kind, a.number.data(), b.kind, b.number.data());
    char matrix[10];
    ASSERT_EQ(vesica_de9im_f64(a.kind, a.number.data(), b.kind, b.number.data(), matrix), 0);
    const auto fits = [&](const char* pattern) { return vesica_de9im_match(matrix, pattern) == 1; };
    ASSERT_EQ(fits("FF*FF****"), relation == VESICA_DISJOINT) << i << ' ' << matrix;
    ASSERT_EQ(fits("T********"), relation >= VESICA_CROSS) << i << ' ' << matrix;
    ASSERT_EQ(fits("T*F**F***"), relation == VESICA_INSIDE || relation == VESICA_INSIDE_TOUCH) << i << ' ' << matrix;
    ASSERT_EQ(fits("T*****FF*"), relation == VESICA_CONTAINS || relation == VESICA_CONTAINS_TOUCH)
        << i << ' ' << matrix;
    char converse[10];
    ASSERT_EQ(vesica_de9im_f64(b.kind, b.number.data(), a.kind, a.number.data(), converse), 0);
    for (std::size_t k = 0; k < 9; ++k) ASSERT_EQ(matrix[k], converse[k % 3 * 3 + k / 3]) << i;
    crossing += static_cast<int>(relation == VESICA_CROSS);
    inside += static_cast<int>(relation >= VESICA_INSIDE);
  }
  EXPECT_GT(crossing, pairs / 20);
  EXPECT_GT(inside, pairs / 50);
}

}  // namespace
