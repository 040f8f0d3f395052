// SPDX-License-Identifier: Apache-2.0
// An ellipse and its circle of curvature, both with rational numbers. At a vertex the contact is four-fold: on the long
// axis the circle lies inside, on the short one outside, and one place of the radius decides. At any other point it is
// three-fold, where the outlines change sides. A filter sees a multiple root in all of them.
#include <gtest/gtest.h>
#include <vesica.h>

#include <cmath>
#include <cstddef>

#include "properties/shape_maker.hpp"
#include "relation/answers.hpp"
#include "relation/nesting.hpp"

namespace {

using namespace properties;

constexpr int cases = 400;

Pair scaled_pair(const Pair& p, int exponent, bool scale_axis) {
  return {p.kind_a, p.kind_b, scaled(p.kind_a, p.a, exponent, scale_axis), scaled(p.kind_b, p.b, exponent, scale_axis)};
}

/// The circle, second of the pair, with its size (both, of an ellipse) some places larger.
Pair grown(Pair pair, int places) {
  for (std::size_t field = pair.kind_b == VESICA_CIRCLE ? 2U : 4U; field < (pair.kind_b == VESICA_CIRCLE ? 3U : 6U);
       ++field) {
    pair.b[field] = at_ordinal(Scalar::f64, ordinal(Scalar::f64, pair.b[field]) + places);
  }
  return pair;
}

/// The relation of the ellipse to the circle.
std::int32_t expected(const relations::Osculation& o) {
  if (!o.four_fold) return VESICA_CROSS;
  const Pair& p = o.pair;
  const double ellipse_area = p.a[4] * p.a[5] * std::hypot(p.a[2], p.a[3]) * std::hypot(p.a[2], p.a[3]);
  const double length = p.kind_b == VESICA_CIRCLE ? 1 : std::hypot(p.b[2], p.b[3]);
  const double radius = p.kind_b == VESICA_CIRCLE ? p.b[2] : p.b[4] * length;
  if (ellipse_area == radius * radius) return VESICA_EQUAL;
  return ellipse_area < radius * radius ? VESICA_INSIDE_TOUCH : VESICA_CONTAINS_TOUCH;
}

/// The relation when the circle is a little larger or smaller: strictly nested, or crossing.
std::int32_t expected_with_circle(std::int32_t code, bool larger) {
  switch (code) {
    case VESICA_INSIDE_TOUCH:
      return larger ? VESICA_INSIDE : VESICA_CROSS;
    case VESICA_CONTAINS_TOUCH:
      return larger ? VESICA_CROSS : VESICA_CONTAINS;
    case VESICA_EQUAL:
      return larger ? VESICA_INSIDE : VESICA_CONTAINS;
    default:
      return VESICA_CROSS;
  }
}

void expect_osculation(int kind_of_circle) {
  Random random(seed());
  int four_fold = 0, three_fold = 0;
  for (int i = 0; i < cases * repeat(); ++i) {
    const relations::Osculation o = relations::osculating_circle(VESICA_ELLIPSE, kind_of_circle, random);
    // The ellipse may come second among two ellipses: then its half lengths are not equal there.
    if (kind_of_circle == VESICA_ELLIPSE && o.pair.b[4] != o.pair.b[5]) continue;
    ++(o.four_fold ? four_fold : three_fold);
    const std::int32_t code = expected(o);
    for (const int exponent : {-1060, -1, 0, 960}) {
      const Pair p = scaled_pair(o.pair, exponent, random.chance(0.5));
      EXPECT_EQ(relations::relation(Scalar::f64, p), code) << describe(p);
      EXPECT_EQ(relations::relation(Scalar::f64, grown(p, 1)), expected_with_circle(code, true)) << describe(p);
      EXPECT_EQ(relations::relation(Scalar::f64, grown(p, -1)), expected_with_circle(code, false)) << describe(p);
    }
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(four_fold, cases / 10 * repeat());
  EXPECT_GT(three_fold, cases / 10 * repeat());
}

TEST(Osculation, EllipseAndCircle) { expect_osculation(VESICA_CIRCLE); }
TEST(Osculation, EllipseAndEllipse) { expect_osculation(VESICA_ELLIPSE); }

}  // namespace
