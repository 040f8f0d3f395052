// SPDX-License-Identifier: Apache-2.0
// Quartics of fixed-point fractions: results do not depend on how many limbs are computed with, and doubles decide only
// what exact numbers confirm.
#include "crossings/quartics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vesica/crossings/quartic_zeros.hpp>

#include "properties/random.hpp"

namespace quartics_test {
namespace {

using namespace vesica::detail::crossings;
namespace exact = vesica::exact;
using properties::Random;

/// The lowest `bits` bits are random, or all zeros or ones in runs, and those above repeat the sign.
Fixed draw_fixed(Random& random, int bits) {
  Fixed x{};
  const bool negative = random.chance(0.5);
  const auto some = random.below(4);
  for (int i = 0; i < Fixed::limbs; ++i) {
    const exact::Limb limb = some == 0 ? 0 : some == 1 ? ~exact::Limb{0} : random.bits();
    const int left = bits - 64 * i;
    x.limb[i] = left <= 0 ? 0 : left >= 64 ? limb : limb & ((exact::Limb{1} << left) - 1);
  }
  return negative ? -x : x;
}

/// A size from rounding errors up to nearly the greatest, the coefficients of about one size or not.
Quartic draw_quartic(Random& random) {
  Quartic q;
  const int bits = random.integer(1, 380);
  for (Fixed& c : q.coefficient) c = draw_fixed(random, random.chance(0.7) ? bits : random.integer(0, bits));
  return q;
}

/// (t - zero)^k (t - other)^(4 - k) about, which a search finds in a group: as Bernstein coefficients.
Quartic draw_group(Random& random) {
  const int k = random.integer(1, 4);
  const double zero = random.between(-0.25, 1.25), other = random.between(-9, 9);
  const double spread = std::ldexp(random.unit(), -random.integer(1, 40));
  double power[5] = {1, 0, 0, 0, 0};
  for (int i = 0; i < 4; ++i) {
    const double root = i < k ? zero + spread * random.between(-1, 1) : other;
    for (int j = i + 1; j > 0; --j) power[j] = (j <= i ? -root * power[j] : 0) + power[j - 1];
    power[0] *= -root;
  }
  return crossings_test::quartic_of_powers(power, random.integer(20, 300));
}

/// x 2^383, a whole number.
exact::Number<1> exactly(const Fixed& x) {
  exact::Number<1> out;
  const Fixed size = x.negative() ? -x : x;
  out.sign = x.negative() ? -1 : 1;
  out.size = Fixed::limbs;
  std::copy(size.limb, size.limb + Fixed::limbs, out.limb);
  out.strip();
  return out;
}

Quartic part_of(const Quartic& q, exact::Limb from, exact::Limb to, int limbs) {
  Quartic out;
  const int changes = part(q, from, to, limbs, out);
  EXPECT_EQ(changes, out.sign_changes());
  return out;
}

::testing::AssertionResult equal(const Quartic& a, const Quartic& b) {
  for (int i = 0; i < 5; ++i) {
    for (int k = 0; k < Fixed::limbs; ++k) {
      if (a.coefficient[i].limb[k] != b.coefficient[i].limb[k]) {
        return ::testing::AssertionFailure() << "coefficient " << i << ", limb " << k;
      }
    }
  }
  return ::testing::AssertionSuccess();
}

/// Only the limbs that hold the coefficients are computed with.
TEST(Quartics, FewLimbsOfQuartics) {
  Random random(properties::seed());
  std::array<int, Fixed::limbs + 1> of_limbs{};
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    const Quartic q = draw_quartic(random);
    const InDoubles doubles(q), again(q, InDoubles(q).limbs);
    const int limbs = doubles.limbs;
    ++of_limbs[static_cast<std::size_t>(limbs)];
    ASSERT_EQ(doubles.exponent, again.exponent);
    for (int k = 0; k < 5; ++k) {
      const double x = doubles.coefficient[k];
      ASSERT_EQ(x, again.coefficient[k]);
      const Fixed& c = q.coefficient[k];
      ASSERT_EQ(std::signbit(x), c.negative());
      // Rounded to nearest, of the 64 bits from the greatest coefficient's highest on.
      const auto nearest = exact::rounded(exactly(c));
      const double expected =
          std::ldexp(std::fabs(nearest.value), nearest.exponent - (64 * Fixed::limbs - 1) - doubles.exponent);
      ASSERT_LE(std::fabs(std::fabs(x) - expected), 0x1p-52 * expected + 0x1p-63);
    }
    Quartic high = q, low{}, high_of_all = q, low_of_all{};
    halve(high, low, limbs);
    halve(high_of_all, low_of_all, Fixed::limbs);
    ASSERT_TRUE(equal(high, high_of_all) && equal(low, low_of_all)) << limbs;
    const exact::Limb from = random.chance(0.3) ? 0 : random.bits() >> 1;
    const exact::Limb to = from != 0 && random.chance(0.3) ? 0 : from + (random.bits() >> 1 | 1);
    ASSERT_TRUE(equal(part_of(q, from, to, limbs), part_of(q, from, to, Fixed::limbs))) << limbs;
  }
  for (int n = 2; n <= Fixed::limbs; ++n) EXPECT_GT(of_limbs[static_cast<std::size_t>(n)], 500 * properties::repeat());
}

/// s / 2^64 of the way from one number to another, rounded down, by exact numbers; of few limbs and all.
template <int n>
void expect_moved(const Fixed& a, const Fixed& b, exact::Limb s) {
  exact::Number<1> share;
  share.sign = share.size = 1;
  share.limb[0] = s;
  const exact::Number<8> from = exact::from_double(0x1p64) * exactly(a),
                         place = from + share * (exactly(b) - exactly(a));
  Fixed found = a;
  move_towards<n>(found, b, s);
  found.extend_sign<n>();
  const exact::Number<8> rest = place - exact::from_double(0x1p64) * exactly(found);
  EXPECT_TRUE(rest.sign >= 0 && exact::compare(rest, exact::from_double(0x1p64)) < 0) << n << ' ' << s;
}
TEST(Quartics, PlacesBetweenFixedNumbers) {
  Random random(properties::seed());
  const auto of_one = [](int x) {
    Fixed one{};
    one.limb[0] = static_cast<exact::Limb>(std::abs(x));
    return x < 0 ? -one : one;
  };
  // All digits that are rounded off are ones, or zeros.
  for (int a = -3; a <= 3; ++a) {
    for (int b = -3; b <= 3; ++b) {
      for (const exact::Limb s : {exact::Limb{1}, exact::Limb{1} << 63, ~exact::Limb{0}}) {
        expect_moved<2>(of_one(a), of_one(b), s);
        expect_moved<Fixed::limbs>(of_one(a), of_one(b), s);
      }
    }
  }
  for (int i = 0; i < 1000 * properties::repeat(); ++i) {
    const Fixed a = draw_fixed(random, 190), b = draw_fixed(random, random.integer(0, 190));
    const Fixed c = draw_fixed(random, 380), d = draw_fixed(random, random.integer(0, 380));
    const exact::Limb s = random.bits() | 1;
    expect_moved<3>(a, b, s);
    expect_moved<Fixed::limbs>(c, d, s);
  }
}

/// The part from 0 on or up to 1, by one construction, agrees with the polar form; and the number of sign changes
/// is known, be they those that were expected or not.
TEST(Quartics, PartsFromAnEnd) {
  Random random(properties::seed());
  std::array<int, 5> counts{};
  for (int i = 0; i < 5000 * properties::repeat(); ++i) {
    const Quartic q = random.chance(0.5) ? draw_group(random) : draw_quartic(random);
    const exact::Limb at = random.bits() | 1;
    const bool from_start = random.chance(0.5);
    Quartic expected;
    for (int k = 0; k < 5; ++k) {
      Quartic rest = q;
      Fixed* const c = rest.coefficient + (from_start ? 0 : k);
      for (int n = from_start ? k : 4 - k; n > 0; --n) interpolate<Fixed::limbs>(c, n, at);
      expected.coefficient[k] = c[0];
    }
    const exact::Limb from = from_start ? 0 : at, to = from_start ? at : 0;
    ASSERT_TRUE(equal(part_of(q, from, to, Fixed::limbs), expected));
    ++counts[static_cast<std::size_t>(expected.sign_changes())];
  }
  for (const int count : counts) EXPECT_GT(count, 0);
}

TEST(Quartics, ChangesOfSign) {
  Random random(properties::seed());
  std::array<int, 6> counts{};
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    Quartic q;
    const bool of_one_sign = random.chance(0.2);
    for (Fixed& c : q.coefficient) {
      c = draw_fixed(random, random.chance(0.4) ? random.integer(0, 66) : 300);
      if (of_one_sign && c.negative()) c = -c;
    }
    int changes = 0, known = 0;
    bool last = false;
    for (const Fixed& c : q.coefficient) {
      if (c.negligible()) {
        ++changes;
        last = !last;
        continue;
      }
      changes += known > 0 && c.negative() != last;
      ++known;
      last = c.negative();
    }
    if (known == 0) changes = 4;
    ASSERT_EQ(q.sign_changes(), changes);
    ++counts[static_cast<std::size_t>(changes)];
  }
  for (int n = 0; n < 5; ++n) EXPECT_GT(counts[static_cast<std::size_t>(n)], 30 * properties::repeat());
}

/// If no group is searched, none would have been found; and a sign from doubles belongs to the part cut off.
TEST(Quartics, SearchesThatFail) {
  Random random(properties::seed());
  int left_out = 0, narrow = 0, close = 0, certain = 0, uncertain = 0;
  for (int i = 0; i < 40000 * properties::repeat(); ++i) {
    const Quartic q = random.chance(0.8) ? draw_group(random) : draw_quartic(random);
    const auto is_negligible = [](const Fixed& c) { return c.negligible(); };
    if (std::all_of(q.coefficient, q.coefficient + 5, is_negligible)) continue;
    const Local local(q);
    for (int k = 1; k <= 4; ++k) {
      const double t = local.zero_of_derivative(k - 1), reach = local.reach(k, t);
      const bool far = local.is_far_reaching(k);
      ASSERT_TRUE(!far || reach >= 0x1p-5) << k;
      left_out += far;
      narrow += !far && reach < 0x1p-5;
      close += far && reach < 4;
    }
    const double low = (1 + std::floor(random.unit() * 0x1.ffffep19)) * 0x1p-20;
    const double at = local.certain_value(low);
    (at == 0 ? uncertain : certain) += 1;
    const Quartic cut = part_of(q, static_cast<exact::Limb>(low * 0x1p64), 0, local.bernstein.limbs);
    if (at == 0) continue;
    ASSERT_FALSE(cut.coefficient[0].negligible());
    ASSERT_EQ(cut.coefficient[0].negative(), at < 0);
  }
  const auto n = properties::repeat();
  EXPECT_GT(left_out, 10000 * n);
  EXPECT_GT(close, 500 * n);
  EXPECT_GT(narrow, 5000 * n);
  EXPECT_GT(certain, 10000 * n);
  EXPECT_GT(uncertain, 100 * n);
}

/// The derivative of an order at t over the order's factorial, times 2^383, from the powers of t with all digits.
exact::Number<8> exact_derivative(const Quartic& q, int order, double t) {
  constexpr int choices[5][5] = {{1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}};
  exact::Number<8> sum;
  for (int i = 4; i >= order; --i) {
    exact::Number<1> power;
    for (int k = 0; k <= i; ++k) {
      const int sign = (i - k) % 2 == 0 ? 1 : -1;
      power = power + exact::integer(sign * choices[4][i] * choices[i][k]) * exactly(q.coefficient[k]);
    }
    const exact::Number<1> x = exact::from_double(t), one = exact::integer(1);
    const exact::Number<2> square = i - order >= 2 ? exact::square(x) : exact::Number<2>(i - order == 1 ? x : one);
    const exact::Number<2> rest = i - order == 4 ? exact::square(x) : exact::Number<2>(i - order == 3 ? x : one);
    sum = sum + exact::integer(choices[i][order]) * power * square * rest;
  }
  return sum;
}

/// Groups whose derivatives cancel in doubles.
TEST(Quartics, ExactDerivatives) {
  Random random(properties::seed());
  int cancelled = 0;
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    const Quartic q = draw_group(random);
    const Local local(q);
    const double drawn = i % 4 == 0 ? i / 4 % 2 : local.zero_of_derivative(random.integer(0, 3));
    const double t = std::floor(drawn * 0x1p53) * 0x1p-53;
    const Derivatives found(q, t, local.bernstein.limbs);
    for (int order = 0; order <= 4; ++order) {
      const auto expected = exact::rounded(exact_derivative(q, order, t));
      const double size = std::fabs(vesica::detail::arithmetic::scale(expected.value, expected.exponent - 383));
      ASSERT_NEAR(found.size[order], size, 0x1p-50 * size + 0x1p-374) << order << " at " << t;
    }
    cancelled += local.is_unknown_at(t);
  }
  EXPECT_GT(cancelled, 1000 * properties::repeat());
}

}  // namespace
}  // namespace quartics_test
