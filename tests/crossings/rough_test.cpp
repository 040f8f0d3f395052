// SPDX-License-Identifier: Apache-2.0
// Numbers with a bound on their error, against rational numbers: whatever the operands are within their errors, the
// result is within its own; and that is hardly more than what the operands' errors make of it.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vesica/crossings/rough.hpp>

#include "exact/values.hpp"
#include "properties/random.hpp"

namespace {

using namespace vesica::detail::crossings;
namespace exact = vesica::exact;
using exact_values::power_of_two, exact_values::value;
using properties::Random;

mpq_class value(const Rough& x) {
  return (mpq_class(x.value.high) + mpq_class(x.value.low)) * power_of_two(x.exponent);
}
mpq_class error(const Rough& x) { return mpq_class(x.error) * power_of_two(x.exponent); }

/// From 1/4 to 4 in magnitude times a power of two; its error from 2^-104 to an eighth of that, or none.
Rough draw(Random& random, int exponents) {
  const double high = random.sign() * (1 + random.unit()), low = std::ldexp(random.unit() - 0.5, -53);
  const double size = random.chance(0.2) ? 0 : std::ldexp(1 + random.unit(), -random.integer(4, 104));
  return {{high, high + low == high ? low : 0}, size, random.integer(-exponents, exponents)};
}

/// The operands at the ends of their errors.
void check(const Rough& found, const Rough& a, const Rough& b,
           const std::function<mpq_class(const mpq_class&, const mpq_class&)>& exactly) {
  mpq_class worst = 0;
  for (const int i : {-1, 1}) {
    for (const int k : {-1, 1}) {
      const mpq_class off = abs(exactly(value(a) + i * error(a), value(b) + k * error(b)) - value(found));
      worst = std::max(worst, off);
    }
  }
  EXPECT_LE(worst, error(found));
  // Up to 2 of the quotient's 1.4; the rest is of rounding: 2^-95 of the size of what is added or multiplied.
  const mpq_class size = abs(exactly(abs(value(a)), abs(value(b)))) + abs(value(found));
  EXPECT_LE(error(found), 2 * worst + size * power_of_two(-95));
  const double kept = std::fabs(rounded(found.value));
  EXPECT_TRUE(kept == 0 || std::max(kept, found.error) >= 0.25) << kept;
  EXPECT_LE(kept, 4);
}

TEST(RoughNumbers, AreWithinTheirErrors) {
  Random random(properties::seed());
  for (int i = 0; i < 3000 * properties::repeat(); ++i) {
    const Rough a = draw(random, 700), far = draw(random, 700);
    Rough b = draw(random, 0);
    b.exponent = a.exponent + random.integer(-130, 130);
    if (random.chance(0.3)) b = {-a.value * Real(1 + std::ldexp(1, -random.integer(1, 60))), b.error, a.exponent};
    check(a + b, a, b, std::plus());
    check(a - b, a, b, std::minus());
    check(a * far, a, far, std::multiplies());
    check(a / far, a, far, std::divides());
    check(times(3, a), a, Rough(Real(3.0), 0, 0), std::multiplies());
  }
}

/// The root's square, at the ends of the operand's error.
TEST(RoughNumbers, Roots) {
  Random random(properties::seed() + 1);
  for (int i = 0; i < 3000 * properties::repeat(); ++i) {
    Rough a = draw(random, 700);
    if (a.sign() < 0) a = -a;
    const Rough x = root(a);
    const mpq_class low = value(x) - error(x), high = value(x) + error(x);
    EXPECT_LE(low * low, value(a) - error(a));
    EXPECT_GE(high * high, value(a) + error(a));
    // The error is half of the operand's, over the root, but for roundings.
    EXPECT_LE(error(x) * value(x), 2 * error(a) + power_of_two(-95) * value(a));
  }
}

/// Of differences that all digits kept tell, that some tell, and of which none is left; or one that is below the error.
TEST(RoughNumbers, OfLeadingDigits) {
  Random random(properties::seed() + 2);
  using Few = exact::Leading<exact::few_limbs>;
  int certain = 0, known = 0, unknown = 0;
  for (int i = 0; i < 1000 * properties::repeat(); ++i) {
    exact::Number<4> p;
    p.sign = 1;
    p.low = random.integer(-20, 20);
    p.size = random.integer(1, 12);
    for (int k = 0; k < p.size; ++k) p.limb[k] = random.bits() | 1;
    exact::Number<4> q = p;
    q.limb[random.integer(0, p.size - 1)] ^= exact::Limb{2} << random.integer(0, 61);
    const exact::Number<4> tiny =
        exact::from_double(random.chance(0.5) ? 0 : std::ldexp(1, random.integer(-1000, 1000)));
    const Few sum = Few(p) - Few(q) + Few(tiny);
    const Rough found = rough(sum);
    EXPECT_LE(abs(value(p) - value(q) + value(tiny) - value(found)), error(found));
    (sum.error == sum.nothing ? certain : found.sign() != 0 ? known : unknown) += 1;
  }
  for (const int count : {certain, known, unknown}) EXPECT_GT(count, 50 * properties::repeat());
}

/// One that is far below another is part of its error, and one that is 0 is not.
TEST(RoughNumbers, FarBelow) {
  const Rough one(Real(1.0), 0, 0), zero;
  for (const int exponent : {-290, -299, -300, -301, -310, -1000, -100000}) {
    const Rough tiny(Real(1.0), 0, exponent);
    for (const Rough& sum : {one + tiny, tiny + one}) {
      EXPECT_EQ(rounded(sum.value), 1);
      EXPECT_GT(sum.error, 0);
      EXPECT_LT(sum.error, 0x1p-98);
    }
  }
  for (const Rough& sum : {one + zero, zero + one}) {
    EXPECT_EQ(rounded(sum.value), 1);
    EXPECT_EQ(sum.error, 0);
  }
  EXPECT_EQ((zero + zero).error, 0);
  EXPECT_EQ((zero + zero).sign(), 0);
}

Rough number(double high, double low, double error) { return {{high, low}, error, 0}; }

TEST(RoughNumbers, Signs) {
  EXPECT_TRUE(number(1, 0, 0x1p-60).sign_is_known() && number(-1, 0, 0.5).sign_is_known());
  EXPECT_TRUE(number(1, 0, 0.999).sign_is_known() && number(0, 0, 0).sign_is_known());
  EXPECT_FALSE(number(1, 0, 1).sign_is_known() || number(-1, 0, 1).sign_is_known());
  EXPECT_FALSE(number(0x1p-20, 0, 0x1p-19).sign_is_known() || number(0, 0, 0x1p-300).sign_is_known());
  EXPECT_EQ(number(1, 0, 0).sign(), 1);
  EXPECT_EQ(number(-1, 0, 0).sign(), -1);
  EXPECT_EQ(number(0, 0, 1).sign(), 0);
}

/// To 2^-60 of the number.
TEST(RoughNumbers, PreciseOnes) {
  for (const double x : {1.0, -1.0, 0.25, 3.0}) {
    EXPECT_TRUE(number(x, 0, std::fabs(x) * 0x1p-60).is_precise() && number(x, 0, 0).is_precise()) << x;
    EXPECT_FALSE(number(x, 0, std::fabs(x) * 0x1.01p-60).is_precise() || number(x, 0, 0x1p-50).is_precise()) << x;
  }
  EXPECT_FALSE(number(0, 0, 0x1p-200).is_precise());
}

/// Half way between doubles is 2^-53 from 1 upwards and 2^-54 downwards.
TEST(RoughNumbers, RoundSurely) {
  Scaled nearest{};
  const auto rounds = [&](double low, double error) { return rounds_surely(number(1, low, error), nearest); };
  EXPECT_TRUE(rounds(0, 0x1p-60) && rounds(0x1p-54, 0x1p-60) && rounds(-0x1p-55, 0x1p-60));
  EXPECT_EQ(std::ldexp(nearest.value, nearest.exponent), 1);
  EXPECT_FALSE(rounds(0, 0x1p-52) || rounds(0x1p-53, 0x1p-60) || rounds(-0x1p-54, 0x1p-60));
  // Within the error of half way, and not.
  EXPECT_FALSE(rounds(0x1p-53 - 0x1p-62, 0x1p-61) || rounds(-0x1p-54 + 0x1p-62, 0x1p-61));
  EXPECT_TRUE(rounds(0x1p-53 - 0x1p-58, 0x1p-61) && rounds(-0x1p-54 + 0x1p-58, 0x1p-61));
  EXPECT_FALSE(rounds_surely(number(0, 0, 0), nearest));
  EXPECT_TRUE(rounds_surely(Rough({-0x1.8p-1, 0}, 0x1p-80, 700), nearest));
  EXPECT_EQ(std::ldexp(nearest.value, nearest.exponent - 700), -0.75);
}

/// (a, b, c) with a^2 + b^2 - c^2 = 2^-80, as whole numbers: nothing cancels but in the sum.
TEST(RoughNumbers, SquaresLess) {
  const auto less = [](double whole, double first, double second) {
    return squares_less(exact::from_double(whole), exact::from_double(first), exact::from_double(second));
  };
  const auto is = [](const Rough& x, double expected) {
    const mpq_class off = value(x) - mpq_class(expected);
    return abs(off) <= error(x) && error(x) <= power_of_two(-85);
  };
  EXPECT_TRUE(is(less(5, 3, 4), 0) && is(less(-5, 4, -3), 0));
  EXPECT_TRUE(is(less(1, 1, 0x1p-40), 0x1p-80) && is(less(-1, 0x1p-40, -1), 0x1p-80));
  for (const auto& tiny : {less(1, 1, 0x1p-60), less(-1, 0x1p-60, -1)}) {
    EXPECT_LE(abs(mpq_class(value(tiny) - power_of_two(-120))), error(tiny));
    EXPECT_LE(error(tiny), power_of_two(-210));
  }
  EXPECT_TRUE(is(less(2, 1, 1), -2) && is(less(1, 2, 2), 7) && is(less(0, 0, 0), 0));
}

}  // namespace
