// SPDX-License-Identifier: Apache-2.0
// Parts of impact_time at the ends of what they are defined for, and the header's own errors.
#include <gtest/gtest.h>
#include <vesica.h>

#include <cmath>
#include <limits>
#include <vesica/impact_time.hpp>

namespace parts_test {
namespace {

using namespace vesica;
using namespace vesica::detail::impact_time;

constexpr double largest = std::numeric_limits<double>::max(), nan = std::numeric_limits<double>::quiet_NaN();

/// Two discs of radius 1, four apart, that come together while t runs from 0 to 1.
Scene discs() { return scene({Kind::circle, {0, 0, 1}}, {0, 0, 0}, {Kind::circle, {4, 0, 1}}, {-4, 0, 0}); }

TEST(ImpactTimeParts, DiscsApartWhileTheyMove) {
  const Scene s = discs();
  EXPECT_TRUE(discs_apart(s, 0, 0, 0));
  EXPECT_TRUE(discs_apart(s, 0, 0, 0.25));
  EXPECT_FALSE(discs_apart(s, 0, 0, 1));
  EXPECT_FALSE(discs_apart(s, 0, 1, 0));
  EXPECT_FALSE(discs_apart(s, 1, 0, 0));
}

TEST(ImpactTimeParts, ClearBetweenTwoTimes) {
  const Scene s = discs();
  const auto clear = [&](double s0, double s1) { return is_clear_between(s, Kept::still, {s0, 0, 4}, s1, 0.125); };
  EXPECT_TRUE(clear(1, 0.5));
  EXPECT_FALSE(clear(-1, 0.5) || clear(0, 0.5) || clear(1, -0.5) || clear(1, 0));
}

/// After the limit of poses no other is tried, and the time stays.
TEST(ImpactTimeParts, MarchesNoFurtherThanItsPoses) {
  const Scene s = discs();
  const Heading along{{1, 0}, Kept::still, {}};
  const Separation by = separation(s, pose(s, 0), along.n, Kept::still);
  int poses = most_poses;
  EXPECT_EQ(march(s, along, {0, by}, 0x1p-20, 1, poses).t, 0);
  EXPECT_EQ(poses, most_poses);
  poses = most_poses - 1;
  const double one = march(s, along, {0, by}, 0x1p-20, 1, poses).t;
  EXPECT_LE(poses, most_poses);
  poses = 0;
  const double all = march(s, along, {0, by}, 0x1p-20, 1, poses).t;
  EXPECT_TRUE(one > 0 && one <= all && all < 0.5) << one << ' ' << all;
}

TEST(ImpactTimeParts, RoundedToFloats) {
  Impact<float> out{7, 7, 7, 7, 7};
  float gap = 7;
  EXPECT_FALSE(rounded_to<float>({0.5, 1e39, 0, 1, 0}, 1, out, gap));
  EXPECT_FALSE(rounded_to<float>({0.5, 1, 0, 1, 0}, 1e39, out, gap));
  EXPECT_TRUE(out.t == 7 && gap == 7);
  EXPECT_TRUE(rounded_to<float>({0.5, 1, 0, 1, 0}, 0x1.000001p0, out, gap));
  EXPECT_EQ(gap, 0x1.000002p0f);
}

TEST(ImpactTimeParts, ErrorsOfTheHeader) {
  const Circle<double> a{0, 0, 1}, b{4, 0, 1};
  const Turn<double> still{0, 0, 0}, moves{-4, 0, 0};
  Impact<double> out{7, 7, 7, 7, 7};
  double gap = 7;
  EXPECT_EQ(impact_time_or_error(a, {nan, 0, 0}, b, moves, 0.125, out, gap), error_argument);
  EXPECT_EQ(impact_time_or_error(a, still, b, {0, 0, 0x1p21}, 0.125, out, gap), error_argument);
  EXPECT_EQ(impact_time_or_error(a, still, b, moves, 0.0, out, gap), error_argument);
  EXPECT_EQ(impact_time_or_error(a, still, Circle<double>{4, 0, -1}, moves, 0.125, out, gap), error_shape);
  // A start whose depth is beyond the numbers.
  const Aabb<double> all{-largest, -largest, largest, largest};
  EXPECT_EQ(impact_time_or_error(all, still, all, moves, 0.125, out, gap), error_range);
  EXPECT_TRUE(out.t == 7 && gap == 7);
  EXPECT_EQ(impact_time_or_error(a, still, b, moves, 0.125, out, gap), cast_hit);
}

/// Velocities whose difference overflows.
TEST(ImpactTimeParts, SpeedsThatOverflow) {
  const double a[3] = {-0.3e308, 0, 0.1e308}, b[3] = {0.3e308, 0, 0.1e308};
  const vesica_turn_f64 forth{1.7e308, 0, 0}, back{-1.7e308, 0, 0};
  vesica_impact_f64 out;
  double gap;
  EXPECT_EQ(vesica_impact_time_f64(VESICA_CIRCLE, a, &forth, VESICA_CIRCLE, b, &back, 1e300, &out, &gap), 1);
  EXPECT_NEAR(out.t, 0.4 / 3.4, 1e-7);
  EXPECT_NEAR(out.x / 1e308, 0, 1e-6);
  EXPECT_EQ(out.nx, 1);
  EXPECT_LE(gap, 1e300);
  EXPECT_EQ(vesica_impact_time_f64(VESICA_CIRCLE, a, &back, VESICA_CIRCLE, b, &forth, 1e300, &out, &gap), 0);
}

/// The point of contact is beyond the floats, though all that is given is not.
TEST(ImpactTimeParts, PointBeyondTheFloats) {
  const float a[3] = {3e38f, 0, 1e36f}, b[3] = {3.2e38f, 0, 1e36f};
  const vesica_turn_f32 fast{3e38f, 0, 0}, slow{2e38f, 0, 0};
  vesica_impact_f32 out{7, 7, 7, 7, 7};
  float gap = 7;
  EXPECT_EQ(vesica_impact_time_f32(VESICA_CIRCLE, a, &fast, VESICA_CIRCLE, b, &slow, 1e30f, &out, &gap),
            VESICA_E_RANGE);
  EXPECT_TRUE(out.t == 7 && gap == 7);
}

}  // namespace
}  // namespace parts_test
