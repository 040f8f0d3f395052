// SPDX-License-Identifier: Apache-2.0
#include "lanes/portable.hpp"
// The lanes come first.
#include "kernels/guard_cases.hpp"

namespace {

TEST(GuardOfPortableLanes, HoldsWithinItsRangesOnly) {
  guard_cases::expect_all<vesica::Floats>();
  guard_cases::expect_all<vesica::Doubles>();
}

/// One lane is a number: its operations are the number's.
TEST(PortableLanes, AreNumbers) {
  using vesica::Doubles, vesica::Floats;
  EXPECT_EQ((Doubles(3) / Doubles(2)).v, 1.5);
  EXPECT_EQ((Floats(1) / Floats(3)).v, 1.0f / 3.0f);
  EXPECT_EQ(sqrt(Doubles(2)).v, 0x1.6a09e667f3bcdp+0);
  EXPECT_EQ(sqrt(Floats(2)).v, 0x1.6a09e6p+0f);
  EXPECT_EQ(select(Doubles(1) < Doubles(2), Doubles(3), Doubles(4)).v, 3);
  EXPECT_EQ(select(Doubles(2) < Doubles(1), Doubles(3), Doubles(4)).v, 4);
}

}  // namespace
