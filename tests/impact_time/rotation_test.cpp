// SPDX-License-Identifier: Apache-2.0
/// The sine and cosine that shapes are turned by: within the bound that is stated, and the same bits everywhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vesica/arithmetic/rotation.hpp>

#include "properties/random.hpp"

namespace {

using vesica::detail::arithmetic::rotation;

/// In units of 2^-53. long double has at least 11 bits more where this test asks.
double error_at(double angle) {
  const auto r = rotation(angle);
  const long double x = angle;
  return static_cast<double>(std::max(std::fabs(r.cosine - std::cos(x)), std::fabs(r.sine - std::sin(x))) * 0x1p53L);
}

TEST(Rotation, WithinItsBound) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "no wider type to compare with";
  properties::Random random(properties::seed() + 3);
  double worst = 0;
  for (int i = 0; i < 400000 * properties::repeat(); ++i) {
    const double size = std::ldexp(1.0, random.integer(-30, 20));
    double angle = random.between(-size, size);
    // Beside quarters and eighths of a turn, where digits cancel or the count changes.
    if (i % 3 == 0)
      angle = random.integer(-667000, 667000) * 0.78539816339744830962 * (1 + random.between(-1e-15, 1e-15));
    worst = std::max(worst, error_at(std::clamp(angle, -0x1p20, 0x1p20)));
  }
  EXPECT_LE(worst, 4);
  std::printf("at most %.3f u\n", worst);
}

TEST(Rotation, Bits) {
  EXPECT_EQ(rotation(0).cosine, 1);
  EXPECT_EQ(rotation(0).sine, 0);
  EXPECT_EQ(rotation(1).cosine, 0x1.14a280fb5068cp-1);
  EXPECT_EQ(rotation(1).sine, 0x1.aed548f090ceep-1);
  EXPECT_EQ(rotation(-100).cosine, 0x1.b981dbf665fep-1);
  EXPECT_EQ(rotation(-100).sine, 0x1.03425b78c4db8p-1);
}

}  // namespace
