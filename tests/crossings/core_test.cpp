// SPDX-License-Identifier: Apache-2.0
// Places where outlines meet, through the header: one place of a pair, and pairs whose cubic has special roots.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vesica/crossings.hpp>
#include <vesica/relation.hpp>

namespace core_test {
namespace {

using namespace vesica;
using namespace vesica::detail::crossings;

Census census_of(const Ellipse<double>& a, const Ellipse<double>& b) {
  const exact::Ellipse e = exact::form(a), f = exact::form(b);
  return detail::crossings::census(e, f);
}
::testing::AssertionResult is(const Census& c, int crossing, int touching) {
  if (c.crossing == crossing && c.touching == touching && !c.equal) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << c.crossing << " cross, " << c.touching << " touch";
}

TEST(OnePlace, NoneOfApartOrNested) {
  double x = 7, y = 7;
  EXPECT_FALSE(one_place(Circle<double>{0, 0, 1}, Circle<double>{9, 0, 1}, x, y));
  EXPECT_FALSE(one_place(Circle<double>{0, 0, 3}, Circle<double>{1, 0, 1}, x, y));
  EXPECT_FALSE(one_place(Circle<double>{0, 0, 3}, Ellipse<double>{0, 0, 1, 0, 3, 3}, x, y));
  EXPECT_FALSE(one_place(Aabb<double>{0, 0, 1, 1}, Circle<double>{9, 0, 1}, x, y));
  EXPECT_TRUE(x == 7 && y == 7);
}

/// A crossing, a touch from outside and one from inside, and of an ellipse without area: the same in either order.
TEST(OnePlace, SameInEitherOrder) {
  const auto place = [](const auto& a, const auto& b) {
    double x = 0, y = 0, other_x = 0, other_y = 0;
    EXPECT_TRUE(one_place(a, b, x, y) && one_place(b, a, other_x, other_y));
    EXPECT_TRUE(x == other_x && y == other_y);
    return std::array<double, 2>{x, y};
  };
  const auto crossing = place(Circle<double>{0, 0, 5}, Circle<double>{6, 0, 5});
  EXPECT_EQ(crossing[0], 3);
  EXPECT_EQ(std::fabs(crossing[1]), 4);
  EXPECT_EQ(place(Circle<double>{0, 0, 1}, Ellipse<double>{3, 0, 1, 0, 2, 1}), (std::array<double, 2>{1, 0}));
  EXPECT_EQ(place(Circle<double>{0, 0, 3}, Circle<double>{2, 0, 1}), (std::array<double, 2>{3, 0}));
  EXPECT_EQ(place(Ellipse<double>{0, 0, 1, 0, 2, 0}, Circle<double>{0, 0, 1}), (std::array<double, 2>{-1, 0}));
  EXPECT_EQ(place(Circle<double>{1, 0, 0}, Circle<double>{0, 0, 1}), (std::array<double, 2>{1, 0}));
}

/// Ellipses of one size; neither lies in the other.
TEST(Crossings, EllipsesOfOneArea) {
  const Ellipse<double> wide{0, 0, 1, 0, 2, 1}, high{0.125, 0, 0, 1, 2, 1};
  EXPECT_TRUE(is(census_of(wide, high), 4, 0));
  CrossingPoints<double> out;
  EXPECT_EQ(crossings_or_error(wide, high, out), 4);
}

/// A coefficient that vanishes: of circles where D^2 = r^2 + 2 R^2.
TEST(Crossings, CoefficientsThatVanish) {
  const Ellipse<double> small{0, 0, 1, 0, 1, 1}, large{17, 0, 1, 0, 12, 12};
  EXPECT_TRUE(is(census_of(small, large), 0, 0));
  EXPECT_TRUE(is(census_of(large, small), 0, 0));
  EXPECT_EQ(relation(small, large), Relation::disjoint);
}

/// The unit circle and x^2 + y^2 - 1 - 3/4 (x - 4)^2 = 0: a projective image of concentric circles, which touch nowhere
/// though their cubic has a double root.
TEST(Crossings, ImageOfConcentricCircles) {
  const Ellipse<double> inner{0, 0, 1, 0, 1, 1}, outer{-12, 0, 1, 0, 14, 7};
  EXPECT_TRUE(is(census_of(inner, outer), 0, 0));
  EXPECT_TRUE(is(census_of(outer, inner), 0, 0));
  EXPECT_EQ(relation(inner, outer), Relation::inside);
  EXPECT_EQ(relation(outer, inner), Relation::contains);
  CrossingPoints<double> out;
  EXPECT_EQ(crossings_or_error(Circle<double>{0, 0, 1}, outer, out), 0);
}

/// A tip that touches the other outline, or is far less than roundings off it, beside two places where they cross: at
/// x = -2/3, where x^2 / 4 + y^2 = 1 and (x - 1/2)^2 + y^2 = 9/4.
TEST(Crossings, TipBesideTwoPlaces) {
  const Circle<double> disc{0.5, 0, 1.5};
  for (const double off : {-0x1p-250, -0x1p-500, 0.0, 0x1p-250, 0x1p-500}) {
    const Ellipse<double> e{off, 0, 1, 0, 2, 1};
    CrossingPoints<double> out;
    const int count = crossings_or_error(e, disc, out), at_tip = off < 0 ? 0 : off == 0 ? 1 : 2;
    ASSERT_EQ(count, 2 + at_tip) << off;
    int tips = 0;
    for (int i = 0; i < count; ++i) {
      const bool tip = out.x[i] > 0;
      EXPECT_NEAR(out.x[i], tip ? 2 : -2.0 / 3, 0x1p-50);
      EXPECT_NEAR(std::fabs(out.y[i]), tip ? 0 : std::sqrt(8.0 / 9), 0x1p-50);
      tips += tip;
    }
    EXPECT_EQ(tips, at_tip);
  }
}

}  // namespace
}  // namespace core_test
