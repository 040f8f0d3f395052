// SPDX-License-Identifier: Apache-2.0
// How many places two ellipses have in common: the search for places agrees with exact integers, and it
// nearly always decides.
#include <gtest/gtest.h>

#include <cmath>
#include <vesica/crossings/ellipse_ellipse.hpp>
#include <vesica/shapes.hpp>

#include "properties/random.hpp"

namespace census_test {
namespace {

using namespace vesica;
using namespace vesica::detail::crossings;
using properties::Random;

struct EllipsePair {
  Ellipse<double> e, f;
};

Ellipse<double> any(Random& random, double spread, double aspect) {
  const double angle = random.between(0, 6.283185307179586), size = std::exp(random.between(-1, 1));
  return {random.between(-spread, spread),
          random.between(-spread, spread),
          std::cos(angle),
          std::sin(angle),
          size,
          size * std::exp2(random.between(-aspect, 0))};
}
double tiny(Random& random, int least) { return random.between(-1, 1) * std::ldexp(1, -random.integer(2, least)); }

/// Ellipses that lie anyhow.
EllipsePair scattered(Random& random) { return {any(random, 1, 3), any(random, 1, 3)}; }
/// Nearly the same.
EllipsePair alike(Random& random) {
  const Ellipse<double> e = any(random, 0.1, 1);
  return {e,
          {e.cx + tiny(random, 40), e.cy + tiny(random, 40), e.ux + tiny(random, 40), e.uy + tiny(random, 40),
           e.a * (1 + tiny(random, 40)), e.b * (1 + tiny(random, 40))}};
}
/// Centres that are hardly apart, which takes many digits.
EllipsePair nearly_concentric(Random& random) {
  Ellipse<double> e = any(random, 0, 2), f = any(random, 0, 2);
  f.cx = tiny(random, 300);
  f.cy = tiny(random, 300);
  if (random.chance(0.5)) f.ux = e.ux, f.uy = e.uy;
  return {e, f};
}
/// The same centre, or the same except for one coordinate.
EllipsePair about_one_point(Random& random) {
  Ellipse<double> e = any(random, 1, 2), f = any(random, 1, 2);
  f.cx = e.cx + (random.chance(0.3) ? tiny(random, 60) : 0);
  f.cy = e.cy + (random.chance(0.3) ? tiny(random, 60) : 0);
  if (random.chance(0.2)) f.ux = e.ux, f.uy = e.uy, f.a = e.a;
  if (random.chance(0.1)) f = e;
  return {e, f};
}
/// An ellipse and its circle of curvature at the end of an axis, moved hardly.
EllipsePair nearly_osculating(Random& random) {
  const double q = random.integer(1, 8), p = q * random.integer(2, 4), r = p * (p / q);
  return {{tiny(random, 200), 0, 1, 0, p, q}, {0, q - r, 1, 0, r, r * (1 + tiny(random, 50))}};
}
/// Needles, across one another or nearly along.
EllipsePair thin(Random& random) {
  Ellipse<double> e = any(random, 1, 60), f = any(random, 1, 60);
  if (random.chance(0.5)) f.ux = e.ux + tiny(random, 60), f.uy = e.uy;
  return {e, f};
}

struct Tally {
  int known = 0, of[5] = {};
};

template <class Draw>
Tally tell(const Draw& draw, int count) {
  Random random(properties::seed());
  Tally tally;
  for (int i = 0; i < count; ++i) {
    const EllipsePair p = draw(random);
    const auto e = exact::form(p.e), f = exact::form(p.f);
    for (const bool exchanged : {false, true}) {
      const exact::Ellipse &first = exchanged ? f : e, &second = exchanged ? e : f;
      const Groups groups(find_spots(prepared(first, second).harmonics));
      const Census expected = census(first, second);
      if (groups.surely_odd() > 0) {
        const Census crossing = census(first, second, true);
        EXPECT_TRUE(crossing.crossing == expected.crossing && crossing.touching == expected.touching);
        EXPECT_FALSE(expected.equal);
        EXPECT_GE(expected.crossing, groups.surely_odd()) << "case " << i << ", seed " << properties::seed();
      }
      const std::optional<int> known = groups.certain_crossings();
      if (!known) continue;
      EXPECT_TRUE(*known == expected.crossing && expected.touching == 0 && !expected.equal)
          << *known << " instead of " << expected.crossing << ", case " << i << ", seed " << properties::seed();
      ++tally.known;
      ++tally.of[expected.crossing];
    }
  }
  return tally;
}

TEST(CensusOfEllipses, IsWhatExactIntegersTell) {
  constexpr int count = 4000;
  const auto nearly_all = [](const Tally& t) { EXPECT_GT(t.known, 2 * count * 9 / 10); };
  const Tally any_pair = tell(scattered, count);
  nearly_all(any_pair);
  EXPECT_TRUE(any_pair.of[0] > 0 && any_pair.of[2] > 0 && any_pair.of[4] > 0);
  nearly_all(tell(alike, count));
  const Tally concentric = tell(nearly_concentric, count);
  nearly_all(concentric);
  EXPECT_TRUE(concentric.of[0] > 0 && concentric.of[4] > 0);
  nearly_all(tell(thin, count));
  EXPECT_GT(tell(about_one_point, count).known, count / 4);
  EXPECT_GT(tell(nearly_osculating, count).known, count);
}

}  // namespace
}  // namespace census_test
