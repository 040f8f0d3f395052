// SPDX-License-Identifier: Apache-2.0
#include "relation/known.hpp"

#include <gtest/gtest.h>
#include <vesica.h>

#include <cstddef>

#include "properties/answers.hpp"
#include "properties/shape_maker.hpp"
#include "relation/answers.hpp"

namespace known {
namespace {

using namespace properties;

void expect_relation(Scalar scalar, const Pair& pair, int expected) {
  EXPECT_EQ(relations::relation(scalar, pair), expected) << name(scalar) << " " << describe(pair);
  EXPECT_EQ(relations::relation(scalar, swapped(pair)), relations::converse(expected))
      << name(scalar) << " exchanged " << describe(pair);
  EXPECT_EQ(relations::contains(scalar, pair), relations::says_contains(expected))
      << name(scalar) << " " << describe(pair);
}

Pair nudged(Pair pair, Scalar scalar, const Nudge& nudge) {
  double& x = (nudge.shape == 'a' ? pair.a : pair.b)[static_cast<std::size_t>(nudge.field)];
  x = at_ordinal(scalar, ordinal(scalar, x) + nudge.places);
  return pair;
}

void expect_case(Scalar scalar, int kind_a, int kind_b, const Case& c, int exponent, bool scale_axis) {
  const Pair pair{kind_a, kind_b, scaled(kind_a, c.a, exponent, scale_axis), scaled(kind_b, c.b, exponent, scale_axis)};
  expect_relation(scalar, pair, c.expected);
  for (const Nudge& nudge : c.nudges) expect_relation(scalar, nudged(pair, scalar, nudge), nudge.expected);
}

}  // namespace

void expect_cases(int kind_a, int kind_b, const std::vector<Case>& cases) {
  for (const Case& c : cases) {
    for (const bool scale_axis : {false, true}) {
      for (const int exponent : {-1060, -537, -100, -1, 0, 3, 300, 1000}) {
        expect_case(Scalar::f64, kind_a, kind_b, c, exponent, scale_axis);
      }
      for (const int exponent : {-140, -70, -1, 0, 3, 50, 116}) {
        expect_case(Scalar::f32, kind_a, kind_b, c, exponent, scale_axis);
      }
    }
  }
}

}  // namespace known
