// SPDX-License-Identifier: Apache-2.0
// The arc tangent that ratios are made of: its bits are promised, and the last terms of its series show in no
// tolerance.
#include <gtest/gtest.h>

#include <vesica/arithmetic/angle.hpp>

namespace {

using vesica::detail::arithmetic::angle_of;
using vesica::detail::arithmetic::angle_of_eighth;
using vesica::detail::arithmetic::angle_of_tangent;
using vesica::detail::arithmetic::right_angle;

TEST(Angle, IsNearestWhereTheSeriesIsLongest) {
  // Nearest doubles, from 60 digits. Near 1/16 nothing is taken from the table; another divisor of the last two terms
  // shows.
  EXPECT_EQ(angle_of_tangent(0x1.fbdcf1e107d7cp-5), 0x1.fb36c3cb2fc64p-5);
  EXPECT_EQ(angle_of_tangent(0x1.d42075869c70dp-5), 0x1.d39e44bcc9e7fp-5);
  EXPECT_EQ(angle_of_tangent(0x1.cdd46ce4691c1p-5), 0x1.cd57696374fb4p-5);
  EXPECT_EQ(angle_of_tangent(0x1.f6b621e40061ap-5), 0x1.f614f367dcc6bp-5);
}

TEST(Angle, OfEighthsIsTheTables) {
  for (int i = 0; i <= 8; ++i) EXPECT_EQ(angle_of_tangent(i / 8.0), angle_of_eighth[i]) << i;
}

TEST(Angle, OfVectors) {
  EXPECT_EQ(angle_of(0, 0), 0);
  EXPECT_EQ(angle_of(2, 0), 0);
  EXPECT_EQ(angle_of(0, 2), right_angle);
  EXPECT_EQ(angle_of(2, 2), angle_of_eighth[8]);
  EXPECT_EQ(angle_of(8, 3), angle_of_eighth[3]);
  EXPECT_EQ(angle_of(3, 8), right_angle - angle_of_eighth[3]);
}

}  // namespace
