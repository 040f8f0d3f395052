// SPDX-License-Identifier: Apache-2.0
// Parts of crossings at the ends of what they are defined for, and the rare pairs that lead there.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <vector>
#include <vesica/crossings.hpp>
#include <vesica/intersection/polygons.hpp>
#include <vesica/relation.hpp>

#include "crossings/quartics.hpp"

namespace {

using namespace vesica;
using namespace vesica::detail::crossings;

Census census_of(const Ellipse<double>& a, const Ellipse<double>& b) {
  const exact::Ellipse e = exact::form(a), f = exact::form(b);
  return detail::crossings::census(exact::Outline(e, f));
}
::testing::AssertionResult is(const Census& c, int crossing, int touching) {
  if (c.crossing == crossing && c.touching == touching && !c.equal) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << c.crossing << " cross, " << c.touching << " touch";
}

Fixed fixed_of(double x, int exponent) { return fixed(exact::from_double(x), exponent); }

TEST(CrossingsParts, QuarticsOfNothing) {
  const Quartic none{};
  EXPECT_FALSE(none.has_digits());
  EXPECT_EQ(none.sign_changes(), 4) << "coefficients without digits have either sign";
  for (const double x : InDoubles(none).coefficient) EXPECT_EQ(x, 0);
}

/// As doubles over a power of two, wherever the highest bit is.
TEST(CrossingsParts, QuarticsAsDoubles) {
  for (int shift = 2; shift <= 380; ++shift) {
    Quartic q{};
    q.coefficient[1] = fixed_of(1, shift);
    q.coefficient[3] = fixed_of(-0.375, shift);
    const InDoubles doubles(q);
    const double* out = doubles.coefficient;
    const int exponent = doubles.exponent;
    EXPECT_TRUE(out[1] >= 0.5 && out[1] <= 1) << shift;
    EXPECT_EQ(std::ldexp(out[1], exponent), std::ldexp(1, -shift)) << shift;
    EXPECT_EQ(std::ldexp(out[3], exponent), std::ldexp(-0.375, -shift)) << shift;
    EXPECT_EQ(out[0], 0);
  }
}

TEST(CrossingsParts, AsManyPlacesAsThereIsRoomFor) {
  Found found;
  for (int i = 0; i < 9; ++i) found.add({1.0 * i, 0, Real(8.0 - i), Real(0.0)});
  EXPECT_EQ(found.count, 8);
  const CrossingPoints<double> points = found.in_order(false);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(points.x[i], 7 - i);
}

/// Of places as far off the other outline's start as can be told, on either side of it.
TEST(CrossingsParts, PlacesNearTheOtherStart) {
  const auto near = [](std::initializer_list<double> along) {
    Found found;
    for (const double at : along) found.add({0, 0, Real(0.0), Real(at)});
    return found.is_near_start_of_b();
  };
  EXPECT_FALSE(near({}) || near({2}) || near({0x1p-29, 1, 3}) || near({4 - 0x1p-29, 2, 3, 1}));
  EXPECT_TRUE(near({0}) && near({2, 0x1p-31}) && near({4 - 0x1p-31}) && near({1, 2, 3, 0}));
}

TEST(CrossingsParts, AsManyVerticesAsThereIsRoomFor) {
  detail::intersection::Vertices region;
  for (int i = 0; i < 9; ++i) region.add({1.0 * i, 0});
  ASSERT_EQ(region.count, 8);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(region.at[i].x, i);
}

TEST(CrossingsParts, AsManySpotsAsThereIsRoomFor) {
  Spots spots;
  for (int i = 0; i < 17; ++i) {
    EXPECT_EQ(spots.is_full(), i == 16);
    spots.add({Real(0.0625 * i), Real(0.0625 * i), i, true, false, 0});
  }
  ASSERT_EQ(spots.count, 16);
  for (int i = 0; i < 16; ++i) EXPECT_EQ(spots.spot[i].most, i);
  // A search ends then.
  const Quartic one_zero = crossings_test::quartic_of_powers({-1, 2, 0, 0, 0}, 20);
  Spots empty;
  ZeroSearch(one_zero, 1, empty, nullptr);
  EXPECT_EQ(empty.count, 1);
  ZeroSearch(one_zero, 1, spots, nullptr);
  EXPECT_EQ(spots.count, 16);
}

Spots spots_of(std::initializer_list<Spot> those) {
  Spots spots;
  for (const Spot& s : those) spots.add(s);
  return spots;
}

TEST(CrossingsParts, GroupsOfSpots) {
  EXPECT_EQ(Groups(Spots{}).count, 0);
  // All of the outline is one group, in one spot or two.
  const Groups whole(spots_of({{Real(0.0), Real(4.0), 4, true, true, 0}}));
  EXPECT_EQ(whole.count, 1);
  const Groups halves(spots_of({{Real(0.0), Real(2.0), 2, true, true, 0}, {Real(2.0), Real(4.0), 2, true, true, 0}}));
  EXPECT_EQ(halves.count, 1);
  EXPECT_EQ(halves.group[0].most, 2);
  // Across the start, and not.
  const Groups across(spots_of({{Real(0.0), Real(1.0), 1, false, true, 0},
                                {Real(2.0), Real(2.5), 1, true, false, 0},
                                {Real(3.0), Real(4.0), 2, false, false, 0}}));
  EXPECT_EQ(across.count, 2);
}

/// How many zeros there are, by signs that may be certain on one side of a gap alone.
TEST(CrossingsParts, CertainCrossingsOfGroups) {
  const auto spot = [](double at, int most, bool negative_before, bool is_certain_before, bool is_certain_after) {
    return Spot{Real(at), Real(at), most, negative_before, !negative_before, 0, is_certain_before, is_certain_after};
  };
  const auto certain = [](std::initializer_list<Spot> those) { return Groups(spots_of(those)).certain_crossings(); };
  EXPECT_EQ(certain({}), 0);
  EXPECT_EQ(certain({spot(0.5, 1, true, true, true), spot(2.5, 1, false, true, true)}), 2);
  // The sign in each gap is known from one of its sides, or not at all.
  EXPECT_EQ(certain({spot(0.5, 1, true, true, false), spot(2.5, 1, false, true, false)}), 2);
  EXPECT_EQ(certain({spot(0.5, 1, true, false, false), spot(2.5, 1, false, true, true)}), 2);
  EXPECT_EQ(certain({spot(0.5, 1, true, false, false), spot(2.5, 1, false, true, false)}), std::nullopt);
  // A sign that is not certain gives way.
  const Groups mended(
      spots_of({spot(0.5, 2, true, true, false), spot(1.5, 1, true, true, true), spot(2.5, 1, false, true, true)}));
  EXPECT_FALSE(mended.group[0].is_odd());
  EXPECT_EQ(mended.group[0].most, 2);
  EXPECT_EQ(mended.surely_odd(), 2);
  // A group may hold three zeros, but not where four groups hold one at least.
  EXPECT_EQ(certain({spot(0.5, 3, true, true, true), spot(2.5, 1, false, true, true)}), std::nullopt);
  EXPECT_EQ(certain({spot(0.5, 3, true, true, true), spot(1.5, 1, false, true, true), spot(2.5, 1, true, true, true),
                     spot(3.5, 2, false, true, true)}),
            4);
}

/// Places go to groups with a change of sign, and then to the flattest ones that have room.
TEST(CrossingsParts, PlacesOfGroups) {
  const auto odd = [](double at, int most) { return Spot{Real(at), Real(at), most, true, false, 0}; };
  const auto even = [](double at, double height) { return Spot{Real(at), Real(at), 2, false, false, height}; };
  const auto shared_out = [](const Spots& spots, const Census& census) {
    Groups groups(spots);
    share_out(groups, census);
    std::vector<int> places;
    for (int i = 0; i < groups.count; ++i) places.push_back(groups.group[i].places);
    return places;
  };
  using Places = std::vector<int>;
  EXPECT_EQ(shared_out(spots_of({odd(0.5, 1), odd(1.5, 1), odd(2.5, 1), odd(3.5, 1)}), {2, 0, false}),
            (Places{1, 1, 0, 0}));
  EXPECT_EQ(shared_out(spots_of({odd(0.5, 3), even(1.5, 1), odd(2.5, 1)}), {4, 0, false}), (Places{1, 2, 1}));
  EXPECT_EQ(shared_out(spots_of({odd(0.5, 3), odd(2.5, 1)}), {4, 0, false}), (Places{3, 1}));
  EXPECT_EQ(shared_out(spots_of({odd(0.5, 1), odd(2.5, 3)}), {4, 0, false}), (Places{1, 3}));
  EXPECT_EQ(shared_out(spots_of({even(0.5, 3), even(1.5, 1), even(2.5, 2)}), {0, 2, false}), (Places{0, 1, 1}));
  EXPECT_EQ(shared_out(spots_of({even(0.5, 3), even(1.5, 1)}), {2, 0, false}), (Places{0, 2}));
  EXPECT_EQ(shared_out(spots_of({odd(0.5, 1), even(1.5, 1)}), {2, 0, false}), (Places{1, 1}));
}

/// Sizes of which each is just precise enough, and their difference is not: that is formed exactly.
TEST(CrossingsParts, SidesThatAreJustPrecise) {
  const Polygon a(exact::form(Aabb<double>{0, 0, 4, 2})), b(exact::form(Aabb<double>{1, -1, 3, 6}));
  const Sides sides(a, b);
  int crossings = 0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const int end = b.corners.next(j);
      if (sides.sign[i][j] * sides.sign[i][end] >= 0) continue;
      Sides rough = sides;
      for (const int corner : {j, end}) {
        Rough& size = rough.size[i][corner];
        size.error = std::fabs(rounded(size.value)) * 0x1p-60;
        ASSERT_TRUE(size.is_precise());
      }
      ASSERT_FALSE((rough.size[i][j] - rough.size[i][end]).is_precise());
      std::optional<Scaled> edges, not_asked;
      const double at = sides.crossing(a, i, b, j, not_asked);
      EXPECT_EQ(rough.crossing(a, i, b, j, edges), at);
      EXPECT_TRUE(edges && !not_asked);
      EXPECT_EQ(rough.crossing(a, i, b, j, edges), at);
      ++crossings;
    }
  }
  EXPECT_EQ(crossings, 4);
}

/// Roots that rounding has put before an edge's start, and behind its end.
TEST(CrossingsParts, RootsBesideAnEdge) {
  Roots before, behind;
  before.add(-0x1p-60, 1);
  behind.add(1 + 0x1p-52, -1);
  EXPECT_TRUE(before.count == 1 && before.t[0] == 0 && before.side[0] == 1);
  EXPECT_TRUE(behind.count == 1 && behind.t[0] == 1 && behind.side[0] == -1);
}

/// A point of an edge, of which no place, one, or two are known: the first where the edge leads away from +x, else the
/// last.
TEST(CrossingsParts, PlacesOfAnEdge) {
  const exact::Box box = exact::form(Aabb<double>{0, 0, 4, 2});
  const Corners corners(box);
  const Ellipse<double> e{2, 1, 1, 0, 1, 1};
  const exact::Ellipse exact_e = exact::form(e);
  const DiscFrame frame(exact_e);
  const DiscBox disc_box(frame, box);
  DiscCorner corner[4];
  for (int i = 0; i < 4; ++i) corner[i].set(disc_box, corners, i);
  const auto start = [&](double x, double y, const PlacesOfBox& places) {
    const exact::Length one = exact::from_double(1.0);
    return start_of_ellipse(corners, corner, places, exact::from_double(x) * one, exact::from_double(y) * one);
  };
  EXPECT_EQ(start(4, 1, {{-1, -1, -1, -1}, {0, 0, 0, 0, 0}}), -1);
  EXPECT_EQ(start(4, 1, {{-1, -1, -1, -1}, {0, 0, 1, 1, 1}}), 0);
  EXPECT_EQ(start(2, 0, {{-1, -1, -1, -1}, {3, 5, 5, 5, 5}}), 4);
  EXPECT_EQ(start(2, 2, {{-1, -1, -1, -1}, {0, 0, 0, 2, 2}}), 0);
  EXPECT_EQ(start(0, 0, {{7, -1, -1, -1}, {0, 0, 0, 0, 0}}), 7);
  EXPECT_EQ(start(9, 9, {{-1, -1, -1, -1}, {0, 1, 2, 3, 4}}), -1);
}

/// An outline that begins on the other one, of which no place is known.
TEST(CrossingsParts, AStartWithoutAPlace) {
  Found none;
  mend_start(exact::form(Ellipse<double>{0, 0, 1, 0, 2, 1}), exact::form(Ellipse<double>{1, 0, 1, 0, 1, 1}), none);
  EXPECT_EQ(none.count, 0);
}

TEST(CrossingsParts, NoPlaceAtAll) {
  double x = 7, y = 7;
  EXPECT_FALSE(one_place(Circle<double>{0, 0, 1}, Circle<double>{9, 0, 1}, x, y));
  EXPECT_FALSE(one_place(Circle<double>{0, 0, 3}, Circle<double>{1, 0, 1}, x, y));
  EXPECT_FALSE(one_place(Circle<double>{0, 0, 3}, Ellipse<double>{0, 0, 1, 0, 3, 3}, x, y));
  EXPECT_FALSE(one_place(Aabb<double>{0, 0, 1, 1}, Circle<double>{9, 0, 1}, x, y));
  EXPECT_TRUE(x == 7 && y == 7);
}

/// A crossing, a touch from outside and one from inside, and of an ellipse without area: the same in either order.
TEST(CrossingsParts, OnePlace) {
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

/// Ellipses of one size, of which neither lies in the other.
TEST(CrossingsParts, OfOneArea) {
  const Ellipse<double> wide{0, 0, 1, 0, 2, 1}, high{0.125, 0, 0, 1, 2, 1};
  EXPECT_TRUE(is(census_of(wide, high), 4, 0));
  CrossingPoints<double> out;
  EXPECT_EQ(crossings_or_error(wide, high, out), 4);
}

/// A coefficient that vanishes: of circles where D^2 = r^2 + 2 R^2.
TEST(CrossingsParts, CoefficientsThatVanish) {
  const Ellipse<double> small{0, 0, 1, 0, 1, 1}, large{17, 0, 1, 0, 12, 12};
  EXPECT_TRUE(is(census_of(small, large), 0, 0));
  EXPECT_TRUE(is(census_of(large, small), 0, 0));
  EXPECT_EQ(relation(small, large), Relation::disjoint);
}

/// The unit circle and x^2 + y^2 - 1 - 3/4 (x - 4)^2 = 0: a projective image of concentric circles, which touch nowhere
/// though their cubic has a double root.
TEST(CrossingsParts, ImageOfConcentricCircles) {
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
TEST(CrossingsParts, ATipBesideTwoPlaces) {
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

/// From 0 at the positive x axis up to 4, which is not reached.
TEST(CrossingsParts, Turns) {
  const auto at = [](double x, double y) { return rounded(turn(Real(x), Real(y))); };
  EXPECT_EQ(at(0, 0), 0);
  for (const double size : {1.0, 0x1p-60, 3.0}) {
    EXPECT_TRUE(at(size, 0) == 0 && at(0, size) == 1 && at(-size, 0) == 2 && at(0, -size) == 3) << size;
    EXPECT_TRUE(at(size, size) == 0.5 && at(-size, size) == 1.5 && at(-size, -size) == 2.5 && at(size, -size) == 3.5);
  }
  EXPECT_TRUE(at(1, 0x1p-60) > 0 && at(1, -0x1p-40) > 3.99 && at(1, -0x1p-40) < 4);
}

}  // namespace
