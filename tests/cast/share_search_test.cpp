// SPDX-License-Identifier: Apache-2.0
// A search over all magnitudes for where a function is 0 that is known here.
#include <gtest/gtest.h>

#include <vesica/cast/share_search.hpp>

#include "properties/random.hpp"

namespace {

using vesica::detail::cast::ShareSearch;
using vesica::detail::cast::Wide;

/// l^p below 1 and l^q from there on, in units of the zero: their logarithms.
struct Powers {
  int p, q;
};

/// Newton's step at l for 1 - (l / zero)^n, n being p below the zero and q beyond.
Wide step(const Wide& l, const Wide& zero, Powers powers) {
  const Wide x = l / zero;
  const int n = x < Wide(1, 0) ? powers.p : powers.q;
  Wide power(1, 0);
  for (int i = 0; i < n; ++i) power = power * x;
  return (Wide(1, 0) - power) * l / (Wide(n, 0) * power);
}

/// How many l are looked at; a step of less than a quarter is taken, until it is short.
int looked_at(const Wide& from, const Wide& zero, Powers powers) {
  ShareSearch search;
  Wide l = from;
  int count = 1;
  for (; l.sign() > 0 && count < 100; ++count) {
    const Wide s = step(l, zero, powers);
    if (s.sign() == 0 || s.exponent < l.exponent - 20) break;
    l = s.exponent < l.exponent - 2 ? l + s : search.next(l, s);
  }
  EXPECT_TRUE(l.sign() > 0 && abs(l - zero) < zero * Wide(0x1p-18, 0));
  return count;
}

TEST(ShareSearch, FindsAZeroAtAnyMagnitude) {
  properties::Random random(1);
  for (const Powers powers : {Powers{1, 1}, {1, 3}, {3, 1}, {3, 2}, {3, 3}}) {
    for (int i = 0; i < 200; ++i) {
      const int size = i % 2 == 0 ? 3000 : 20;
      const Wide zero(1 + random.unit(), random.integer(-size, size));
      EXPECT_LE(looked_at(Wide(1, 0), zero, powers), 30) << i;
    }
  }
}

/// The step may lead out of a bracket that is narrow, and then its middle is looked at.
TEST(ShareSearch, StaysWithinANarrowBracket) {
  ShareSearch search;
  const Wide low(1, 0), high(1, 2);
  EXPECT_GT(search.next(low, Wide(1, 0)).exponent, 0);
  const Wide middle = search.next(high, Wide(-1, 4));
  EXPECT_TRUE(middle.value == 1.25 && middle.exponent == 1);
  const Wide there = search.next(middle, Wide(-1, 0));
  EXPECT_TRUE(there.value == 1.5 && there.exponent == 0);
}

/// Where steps never turn nothing is left in the end; nor do steps of one length tell how they fall.
TEST(ShareSearch, EndsWhereNothingIsFound) {
  for (const double sign : {1.0, -1.0}) {
    ShareSearch search;
    Wide l(1, 0);
    int looked = 0;
    for (; l.sign() > 0 && looked < 50; ++looked) l = search.next(l, Wide(sign, l.exponent));
    EXPECT_EQ(looked, 9);
  }
}

/// Where steps hardly fall they say nothing: what they tell is beyond all exponents, and of an int.
TEST(ShareSearch, OfStepsThatHardlyFall) {
  ShareSearch search;
  const Wide far = search.next(Wide(1, -900'000), Wide(1, 100'000));
  EXPECT_EQ(far.exponent, -899'999);
  EXPECT_EQ(search.next(Wide(1, 900'000), Wide(1, 1'899'999)).exponent, 900'004);
  ShareSearch down;
  EXPECT_EQ(down.next(Wide(1, 900'000), Wide(-1, 1'900'000)).exponent, 899'999);
  EXPECT_EQ(down.next(Wide(1, -900'000), Wide(-1, 99'999)).exponent, -900'004);
}

}  // namespace
