// SPDX-License-Identifier: Apache-2.0
/// The cases built to graze do: a little farther off there is no contact at any time, and a little nearer there is.
#include "cast/swept/cases.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cast/swept/contact.hpp"
#include "properties/pairs_of_kinds.hpp"

namespace {

using namespace cast_test;
using swept::Case;

/// b moved by so much of the normal, which its numbers have digits for.
Pair moved(const Case& c, double by) {
  Pair p = c.pair;
  const bool ends = p.kind_b == VESICA_SEGMENT || p.kind_b == VESICA_AABB;
  for (std::size_t i = 0; i < (ends ? 4 : 2); ++i) p.b[i] += by * (i % 2 == 0 ? c.nx : c.ny);
  return p;
}

bool ever(const Pair& p, const Motion& m) {
  const swept::Scene forth(p, m.vx, m.vy), back(p, -m.vx, -m.vy);
  return swept::contact(forth)->by(forth.time(infinity)) || swept::contact(back)->by(back.time(infinity));
}

class Grazing : public testing::TestWithParam<properties::Kinds> {};

TEST_P(Grazing, IsBetweenContactAndNone) {
  properties::Random random(properties::seed() + 81);
  const properties::Kinds k = GetParam();
  int seen = 0;
  for (int i = 0; i < 500 * properties::repeat(); ++i) {
    const Case c = swept::draw(k.a, k.b, k.scalar, random);
    if (c.kind != swept::Class::grazing) continue;
    SCOPED_TRACE(describe(c.pair, c.motion));
    const double step = 0x1p-30;
    ASSERT_TRUE(ever(c.pair, c.motion));
    ASSERT_FALSE(ever(moved(c, step), c.motion));
    const bool flat = !ever(moved(c, -step), c.motion);
    const bool both_flat = !properties::has_area(k.a, c.pair.a) && !properties::has_area(k.b, c.pair.b);
    ASSERT_TRUE(!flat || both_flat);
    ++seen;
  }
  EXPECT_GT(seen, 0);
}

INSTANTIATE_TEST_SUITE_P(Cast, Grazing, testing::ValuesIn(properties::all_pairs_of_kinds(properties::kinds_with_form)),
                         properties::test_name);

}  // namespace
