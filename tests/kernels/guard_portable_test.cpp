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

/// Numbers from 1 to 2, where a roundoff counts least and most.
template <class V>
void expect_raised(double u) {
  for (const double x : {1.0, 1.25, 1.5, 2 - 2 * u}) {
    const auto raised = static_cast<double>(vesica::raised<112>(V(static_cast<typename V::Element>(x))).v);
    EXPECT_GE(raised - x, 112 * u * x);
    EXPECT_LE(raised - x, 225 * u * x);
  }
}
TEST(GuardOfPortableLanes, RaisesByAsManyRoundoffsAsItSays) {
  expect_raised<vesica::Floats>(0x1p-24);
  expect_raised<vesica::Doubles>(0x1p-53);
}

}  // namespace
