// SPDX-License-Identifier: Apache-2.0
// Ellipses at what their fast decisions are made for: how many contacts of two are left to the general search, and
// rays at ellipses that are tiny or thin, where a bound that is a little too small tells a wrong answer.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vesica/cast/fast_round_hit.hpp>

#include "cast/motions.hpp"
#include "properties/random.hpp"

namespace {

using namespace cast_test;

/// Ellipses of sizes 1/2 to 1 that come towards each other, within a third of their sizes, from 4 to 40 away.
struct Approach {
  vesica::Ellipse<double> a, b;
  vesica::detail::cast::Motion motion;
};
Approach draw(properties::Random& random, int exponent_of_speed) {
  const auto ellipse = [&](double x, double y) {
    const double t = random.between(-1, 1);
    return vesica::Ellipse<double>{x, y, 1 - t * t, 2 * t, random.between(0.5, 1), random.between(0.5, 1)};
  };
  const double x = random.between(4, 40), y = random.between(-x, x), speed = std::ldexp(1, exponent_of_speed);
  return {ellipse(0, 0),
          ellipse(x, y),
          {-speed * (x + random.between(-0.3, 0.3)), -speed * (y + random.between(-0.3, 0.3)), infinity}};
}

/// Counts the hits that the fast path leaves open, of 500 at each speed.
TEST(EllipsesThatMeet, AreAnsweredFastAtAnySpeed) {
  constexpr std::array exponents{-50, -40, -20, 0, 20, 40, 47, 53};
  std::array<int, exponents.size()> open{};
  properties::Random random(1);
  for (std::size_t k = 0; k < exponents.size(); ++k) {
    for (int i = 0; i < 500; ++i) {
      const Approach m = draw(random, exponents[k]);
      vesica::Impact<double> found;
      const auto quick = vesica::detail::cast::fast_hit<vesica::detail::cast::SplitProducts>(m.a, m.b, m.motion, found);
      open[k] += quick == vesica::detail::cast::EarlyOut::open;
    }
  }
  EXPECT_EQ(open, (std::array{0, 0, 0, 0, 0, 0, 0, 0}));
}

// Products of its sizes are far below what is allowed for underflow.
TEST(RaysAtEllipses, ThatAreTiny) {
  const Answer r = cast(Scalar::f64, {VESICA_ELLIPSE, VESICA_POINT, {0, 0, 1, 0, 0x1p-210, 0x1p-211}, {0x1p+15, 0}},
                        {-1, 0, infinity});
  EXPECT_EQ(r.code, VESICA_CAST_HIT);
  EXPECT_EQ(r.t, std::nextafter(0x1p+15, 0));
  EXPECT_TRUE(r.nx == 1 && r.ny == 0);
}

// At the end of the short axis, inside by less than roundings: the contact is at the start.
TEST(RaysAtEllipses, FromWithinThinOnes) {
  const Moving rays[] = {
      {{VESICA_ELLIPSE,
        VESICA_POINT,
        {0, 0, -0x1.ff935ed583bdap-1, -0x1.4d73d6ed22d95p-5, 0x1.03e3b375acdb2p+0, 0x1.866699efcaee2p-13},
        {0x1.fc841e17787fep-18, -0x1.8613c567a9c75p-13}},
       {-0x1.da0c52236444cp-2, -0x1.c5d505ce71e57p-1, infinity}},
      {{VESICA_ELLIPSE,
        VESICA_POINT,
        {0, 0, -0x1.fffc91784f54ep-1, 0x1.da3cacfa8c7b8p-8, 0x1.292366eb77f9cp+0, 0x1.148f645e3c9b4p-6},
        {-0x1.77d337137f7b5p-12, -0x1.14865da130561p-6}},
       {-0x1.6855e19641b62p-5, -0x1.ff8123ded2f85p-1, infinity}},
  };
  for (const auto& [pair, motion] : rays) {
    ASSERT_EQ(vesica_overlap_f64(pair.kind_a, pair.a.data(), pair.kind_b, pair.b.data()), 1);
    const Answer r = cast(Scalar::f64, pair, motion);
    EXPECT_EQ(r.code, VESICA_CAST_START);
    EXPECT_EQ(r.t, 0);
  }
}

}  // namespace
