// SPDX-License-Identifier: Apache-2.0
// Numbers with a bound on their error, against rational numbers: whatever the operands are within their errors, the
// result is within its own; and that is hardly more than what the operands' errors make of it.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vesica/crossings/estimate.hpp>

#include "exact/values.hpp"
#include "properties/random.hpp"

namespace estimate_test {
namespace {

using namespace vesica::detail::crossings;
namespace exact = vesica::exact;
using exact_values::power_of_two, exact_values::value;
using properties::Random;

mpq_class value(const Estimate& x) {
  return (mpq_class(x.value.high) + mpq_class(x.value.low)) * power_of_two(x.exponent);
}
mpq_class error(const Estimate& x) { return mpq_class(x.error) * power_of_two(x.exponent); }

/// From 1/4 to 4 in magnitude times a power of two; its error from 2^-104 to an eighth of that, or none.
Estimate draw(Random& random, int exponents) {
  const double high = random.sign() * (1 + random.unit()), low = std::ldexp(random.unit() - 0.5, -53);
  const double size = random.chance(0.2) ? 0 : std::ldexp(1 + random.unit(), -random.integer(4, 104));
  return {{high, high + low == high ? low : 0}, size, random.integer(-exponents, exponents)};
}

/// The operands at the ends of their errors.
void check(const Estimate& found, const Estimate& a, const Estimate& b,
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

TEST(Estimates, AreWithinTheirErrors) {
  Random random(properties::seed());
  for (int i = 0; i < 3000 * properties::repeat(); ++i) {
    const Estimate a = draw(random, 700), far = draw(random, 700);
    Estimate b = draw(random, 0);
    b.exponent = a.exponent + random.integer(-130, 130);
    if (random.chance(0.3)) b = {-a.value * Real(1 + std::ldexp(1, -random.integer(1, 60))), b.error, a.exponent};
    check(a + b, a, b, std::plus());
    check(a - b, a, b, std::minus());
    check(a * far, a, far, std::multiplies());
    check(a / far, a, far, std::divides());
    check(times(3, a), a, Estimate(Real(3.0), 0, 0), std::multiplies());
  }
}

/// The root's square, at the ends of the operand's error.
TEST(Estimates, Roots) {
  Random random(properties::seed() + 1);
  for (int i = 0; i < 3000 * properties::repeat(); ++i) {
    Estimate a = draw(random, 700);
    if (a.sign() < 0) a = -a;
    const Estimate x = root(a);
    const mpq_class low = value(x) - error(x), high = value(x) + error(x);
    EXPECT_LE(low * low, value(a) - error(a));
    EXPECT_GE(high * high, value(a) + error(a));
    // The error is half of the operand's, over the root, up to roundings.
    EXPECT_LE(error(x) * value(x), 2 * error(a) + power_of_two(-95) * value(a));
  }
}

/// One that is far below another is part of its error, and one that is 0 is not.
TEST(Estimates, FarBelow) {
  const Estimate one(Real(1.0), 0, 0), zero;
  for (const int exponent : {-290, -299, -300, -301, -310, -1000, -100000}) {
    const Estimate tiny(Real(1.0), 0, exponent);
    for (const Estimate& sum : {one + tiny, tiny + one}) {
      EXPECT_EQ(rounded(sum.value), 1);
      EXPECT_GT(sum.error, 0);
      EXPECT_LT(sum.error, 0x1p-98);
    }
  }
  for (const Estimate& sum : {one + zero, zero + one}) {
    EXPECT_EQ(rounded(sum.value), 1);
    EXPECT_EQ(sum.error, 0);
  }
  EXPECT_EQ((zero + zero).error, 0);
  EXPECT_EQ((zero + zero).sign(), 0);
}

Estimate number(double high, double low, double error) { return {{high, low}, error, 0}; }

TEST(Estimates, Signs) {
  EXPECT_TRUE(number(1, 0, 0x1p-60).sign_is_known() && number(-1, 0, 0.5).sign_is_known());
  EXPECT_TRUE(number(1, 0, 0.999).sign_is_known() && number(0, 0, 0).sign_is_known());
  EXPECT_FALSE(number(1, 0, 1).sign_is_known() || number(-1, 0, 1).sign_is_known());
  EXPECT_FALSE(number(0x1p-20, 0, 0x1p-19).sign_is_known() || number(0, 0, 0x1p-300).sign_is_known());
  EXPECT_EQ(number(1, 0, 0).sign(), 1);
  EXPECT_EQ(number(-1, 0, 0).sign(), -1);
  EXPECT_EQ(number(0, 0, 1).sign(), 0);
}

/// To 2^-60 of the number.
TEST(Estimates, PreciseOnes) {
  for (const double x : {1.0, -1.0, 0.25, 3.0}) {
    EXPECT_TRUE(number(x, 0, std::fabs(x) * 0x1p-60).is_precise() && number(x, 0, 0).is_precise()) << x;
    EXPECT_FALSE(number(x, 0, std::fabs(x) * 0x1.01p-60).is_precise() || number(x, 0, 0x1p-50).is_precise()) << x;
  }
  EXPECT_FALSE(number(0, 0, 0x1p-200).is_precise());
}

}  // namespace
}  // namespace estimate_test
