// SPDX-License-Identifier: Apache-2.0
// The answers of the named methods: macro and the core's constant agree, and none of them may ever change.
#include <gtest/gtest.h>
#include <vesica_methods.h>

#include <vesica/methods/bisected_arc.hpp>
#include <vesica/methods/rect_rect_sample_points.hpp>
#include <vesica/methods/verdict.hpp>

namespace {

TEST(MethodsVerdict, MacrosAndCoreAgree) {
  EXPECT_EQ(VESICA_NO, 0);
  EXPECT_EQ(VESICA_YES, 1);
  EXPECT_EQ(VESICA_UNCERTAIN, 2);
  EXPECT_EQ(VESICA_MOST_SAMPLE_POINTS, 1000);
  EXPECT_EQ(VESICA_MOST_SANDWICH_ITERATIONS, 30);
  EXPECT_EQ(vesica::methods::no, 0);
  EXPECT_EQ(vesica::methods::yes, 1);
  EXPECT_EQ(vesica::methods::uncertain, 2);
  EXPECT_EQ(vesica::methods::most_sample_points, 1000);
  EXPECT_EQ(vesica::methods::most_sandwich_iterations, 30);
}

}  // namespace
