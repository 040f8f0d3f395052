// SPDX-License-Identifier: Apache-2.0
// The reference itself, on distances known without it.
#include "methods/gradient_descent/outline_distance.hpp"

#include <gtest/gtest.h>

namespace {

TEST(OutlineDistance, Disjoint) {
  EXPECT_NEAR(outline_distance::of_disjoint({0, 0, 1, 0, 1, 1}, {3, 4, 0.6, 0.8, 2, 2}), 2, 1e-14);
  EXPECT_NEAR(outline_distance::of_disjoint({0, 0, 1, 0, 4, 3}, {0, 8, 0, 1, 2, 1}), 3, 1e-14);
  // A point and the ellipse x^2 / 25 + y^2 / 9 = 1 off its point (4, 9/5), along the normal (4/25, 1/5) or (4, 5).
  EXPECT_NEAR(outline_distance::of_disjoint({0, 0, 1, 0, 5, 3}, {8, 6.8, 1, 0, 0, 0}), 6.4031242374328485, 1e-13);
}

TEST(OutlineDistance, Nested) {
  EXPECT_NEAR(outline_distance::of_nested({1, 0, 1, 0, 2, 2}, {0, 0, 1, 0, 5, 5}), 2, 1e-14);
  EXPECT_NEAR(outline_distance::of_nested({0, 0, 1, 0, 2, 1}, {0, 0, 0, 1, 3, 5}), 2, 1e-14);
  EXPECT_LT(outline_distance::of_nested({0, 0, 1, 0, 5, 5}, {1, 0, 1, 0, 2, 2}), 0);
}

}  // namespace
