// SPDX-License-Identifier: Apache-2.0
// Nested outlines: the answer is the least distance, not a local minimum only, and the search ends well within its
// limits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vesica/boundary_distance/nested.hpp>

#include "boundary_distance/dense_search.hpp"
#include "boundary_distance/nested_pairs.hpp"
#include "properties/random.hpp"
#include "vesica.h"

namespace {

using nested_pairs::Style;
using properties::Pair;

/// The dense search and the library each round; neither by as much as this times 2^-53 of the largest length.
constexpr double noise = 16 * 0x1p-53;

struct Tally {
  int pairs = 0, missed = 0, limits_met = 0, most_evaluations = 0, most_arcs = 0;
  long evaluations = 0;
};

vesica::Ellipse<double> ellipse(int kind, const properties::Numbers& n) {
  if (kind == VESICA_CIRCLE) return {n[0], n[1], 1, 0, n[2], n[2]};
  return {n[0], n[1], n[2], n[3], n[4], n[5]};
}

void count_search(const Pair& pair, Tally& tally) {
  using namespace vesica::detail::support_minimum;
  const auto placed = place(form(ellipse(pair.kind_a, pair.a)), form(ellipse(pair.kind_b, pair.b)));
  const Minimum m = minimise(Frame(placed).objective(-1));
  tally.limits_met += !m.settled;
  tally.evaluations += m.evaluations;
  tally.most_evaluations = std::max(tally.most_evaluations, m.evaluations);
  tally.most_arcs = std::max(tally.most_arcs, m.most_arcs);
}

void compare_with_dense(const Pair& pair, Tally& tally) {
  using namespace outline_reference;
  vesica_closest_points_f64 found;
  ASSERT_EQ(vesica_boundary_distance_f64(pair.kind_a, pair.a.data(), pair.kind_b, pair.b.data(), &found), 0);
  const DenseShape a = dense_shape(pair.kind_a, pair.a), b = dense_shape(pair.kind_b, pair.b);
  const double scale = std::max(a.a, a.b), least = dense_minimum({a, b, -1});
  ++tally.pairs;
  if (found.distance <= least + noise * scale) return;
  if (++tally.missed <= 3) {
    ADD_FAILURE() << properties::describe(pair) << ": " << found.distance << ", but there is " << least;
  }
}

void run(int outer, int inner, int pairs_a_style, int limit) {
  properties::Random random(properties::seed() + static_cast<unsigned>(10 * outer + inner));
  const bool searched =
      (outer == VESICA_ELLIPSE || outer == VESICA_CIRCLE) && (inner == VESICA_ELLIPSE || inner == VESICA_CIRCLE);
  for (const Style style : nested_pairs::all_styles) {
    Tally tally;
    for (int i = 0; i < pairs_a_style * properties::repeat(); ++i) {
      const auto pair = nested_pairs::draw(style, outer, inner, random);
      if (!pair) continue;
      if (searched) count_search(*pair, tally);
      compare_with_dense(*pair, tally);
    }
    EXPECT_EQ(tally.missed, 0);
    EXPECT_EQ(tally.limits_met, 0);
    EXPECT_LE(tally.most_evaluations, limit);
    EXPECT_GT(tally.pairs, pairs_a_style / 3 * properties::repeat());
    std::printf("%s in %s, %s: %d pairs, %d missed", vesica_kind_name(inner), vesica_kind_name(outer), name(style),
                tally.pairs, tally.missed);
    if (searched) {
      std::printf("; evaluations %.1f on average, %d at most, %d arcs at most",
                  static_cast<double>(tally.evaluations) / tally.pairs, tally.most_evaluations, tally.most_arcs);
    }
    std::printf("\n");
  }
}

/// A quarter of the limit, which no search may ever meet.
constexpr int expected_evaluations = vesica::detail::support_minimum::evaluation_limit / 4;

/// An ellipse and its copy within it, about one centre: F is 1 - within times a support function, and least along the
/// lesser half length. A tolerance below 0 calls no value least, so that arcs are refined until a limit ends it.
vesica::detail::support_minimum::Minimum of_copy(double within) {
  using namespace vesica::detail::support_minimum;
  const CentredShape outer{{1, 0}, 1, 0.25, true}, inner{{1, 0}, within, within * 0.25, true};
  return minimise({outer, inner, -1, {0, 0}, -1});
}

TEST(GlobalMinimum, EndsAtItsLimits) {
  using vesica::detail::support_minimum::arc_limit, vesica::detail::support_minimum::evaluation_limit;
  const auto flat = of_copy(1), deep = of_copy(1 - 0x1p-20);
  EXPECT_FALSE(flat.settled);
  EXPECT_EQ(flat.most_arcs, arc_limit);
  EXPECT_LT(flat.evaluations, evaluation_limit);
  EXPECT_EQ(flat.at.value, 0);
  EXPECT_FALSE(deep.settled);
  EXPECT_LT(deep.most_arcs, arc_limit);
  EXPECT_GE(deep.evaluations, evaluation_limit);
  EXPECT_NEAR(deep.at.value, 0x1p-22, 0x1p-52);
}

/// Discs concentric up to a last place: F is flat all around, and to rounding its second derivative is not
/// positive where a descent begins. The value is least all the same.
TEST(GlobalMinimum, NearlyConcentricDiscs) {
  using namespace vesica::detail::support_minimum;
  const Objective objectives[] = {
      {{{-0x1.f3b8db6a25624p-1, 0x1.bdd01e384cc2p-3}, 1, 1, true},
       {{-0x1.f3b8db6a25624p-1, 0x1.bdd01e384cc2p-3}, 0x1.f0c963d643b44p-16, 0x1.f0c963d61433ap-16, true},
       -1,
       {-0x1.0e02514b47b0ep-51, -0x1.87446673f8cc7p-50},
       0x1.37076b6796d94p-59},
      {{{-0x1.8331816ffaa05p-1, 0x1.4f001bec5e557p-1}, 1, 1, true},
       {{0x1.a191b3352d911p-3, 0x1.f53ea4c21eac2p-1}, 1, 0x1.fffffffffffffp-1, true},
       -1,
       {0x1.b58598302e50bp-55, 0x1.c4656f259aae2p-54},
       0}};
  for (const Objective& o : objectives) {
    const Minimum found = minimise(o);
    EXPECT_TRUE(found.settled);
    EXPECT_LT(found.evaluations, evaluation_limit / 4);
    double least = 2;
    for (int i = 0; i < 1000; ++i) {
      const PlaneVector n{std::cos(0.001 * 6.2832 * i), std::sin(0.001 * 6.2832 * i)};
      const double value = ellipse_support(o.first, n).height - ellipse_support(o.second, n).height + dot(n, o.e);
      least = std::fmin(least, value);
    }
    EXPECT_NEAR(found.at.value, least, 0x1p-51);
  }
}

/// A needle down to 2^-240 of its length, or a round ellipse.
vesica::detail::support_minimum::CentredShape drawn(double length, bool needle, properties::Random& random) {
  const double angle = random.between(0, 6.2832);
  const double thinness = needle ? std::exp2(random.between(-240, 0)) : random.between(0.3, 1);
  return {{std::cos(angle), std::sin(angle)}, length, length * thinness, true};
}

// Took up to 152 evaluations: it followed the curvature alone, which says nothing on the arc where a needle turns.
TEST(GlobalMinimum, NeedlesTakeNoMoreSteps) {
  using namespace vesica::detail::support_minimum;
  properties::Random random(properties::seed() + 6);
  int most = 0;
  for (int i = 0; i < 24000 * properties::repeat(); ++i) {
    const bool first = i % 3 != 1, second = i % 3 != 2;
    const double length = std::exp2(random.between(-30, 0) * random.unit());
    const double offset = std::exp2(random.between(-40, 0) * random.unit()), way = random.between(0, 6.2832);
    const Objective o{drawn(1, first, random),
                      drawn(length, second, random),
                      i % 2 == 0 ? 1.0 : -1.0,
                      {offset * std::cos(way), offset * std::sin(way)},
                      0x1p-54};
    const Minimum found = minimise(o);
    EXPECT_TRUE(found.settled);
    most = std::max(most, found.evaluations);
  }
  std::printf("evaluations: %d at most\n", most);
  EXPECT_LE(most, expected_evaluations);
}

TEST(GlobalMinimum, EllipseInEllipse) { run(VESICA_ELLIPSE, VESICA_ELLIPSE, 18000, expected_evaluations); }
TEST(GlobalMinimum, CircleInEllipse) { run(VESICA_ELLIPSE, VESICA_CIRCLE, 2000, expected_evaluations); }
TEST(GlobalMinimum, EllipseInCircle) { run(VESICA_CIRCLE, VESICA_ELLIPSE, 2000, expected_evaluations); }
TEST(GlobalMinimum, RectInEllipse) { run(VESICA_ELLIPSE, VESICA_RECT, 1000, expected_evaluations); }
TEST(GlobalMinimum, PointInEllipse) { run(VESICA_ELLIPSE, VESICA_POINT, 1000, expected_evaluations); }
TEST(GlobalMinimum, SegmentInEllipse) { run(VESICA_ELLIPSE, VESICA_SEGMENT, 1000, expected_evaluations); }
TEST(GlobalMinimum, EllipseInRect) { run(VESICA_RECT, VESICA_ELLIPSE, 500, expected_evaluations); }
TEST(GlobalMinimum, RectInRect) { run(VESICA_RECT, VESICA_RECT, 500, expected_evaluations); }

}  // namespace
