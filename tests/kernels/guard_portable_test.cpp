// SPDX-License-Identifier: Apache-2.0
#include "lanes/portable.hpp"
// The lanes come first.
#include "kernels/guard_cases.hpp"

namespace {

TEST(GuardOfPortableLanes, HoldsWithinItsRangesOnly) {
  guard_cases::expect_all<vesica::Floats>();
  guard_cases::expect_all<vesica::Doubles>();
}

}  // namespace
