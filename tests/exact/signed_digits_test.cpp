// SPDX-License-Identifier: Apache-2.0
// Digits from the top against GMP: they are those of the number, of any length, and no sign is told too soon.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vesica/exact/leading.hpp>

#include "exact/portable_limbs.hpp"
#include "exact/values.hpp"
#include "properties/random.hpp"

namespace {

using namespace vesica::exact::detail;
using exact_values::about, exact_values::any_number, exact_values::scaled, exact_values::value;
using properties::Random;
using vesica::exact::from_double, vesica::exact::integer, vesica::exact::Limb, vesica::exact::Number;

constexpr Digit most = (Digit{1} << (digit_bits - 1)) + 1;

mpz_class integer_of(const ColumnSum& x) {
  return mpz_class(static_cast<long>(x.high)) * (mpz_class(1) << 64) + mpz_class(static_cast<unsigned long>(x.low));
}

/// The value of all digits, each of which is in its range.
mpq_class value(SignedDigits& x) {
  if (x.is_zero()) return 0;
  x.know<true>(x.last());
  mpz_class sum = 0;
  for (int depth = 0; depth <= x.last(); ++depth) {
    EXPECT_LE(std::abs(x[depth]), most);
    sum = (sum << digit_bits) + mpz_class(static_cast<long>(x[depth]));
  }
  return scaled(sum, std::int64_t{digit_bits} * x.bottom());
}

// Every combination of digits at the ends of their range, and of sums to which they are added.
TEST(ColumnSum, Products) {
  for (const Digit a : {most, -most, Digit{0}, Digit{1}, Digit{-1}, most / 3}) {
    for (const Digit b : {most, -most, Digit{0}, Digit{1}, Digit{-1}, -most / 5}) {
      for (const ColumnSum sum : {ColumnSum{}, ColumnSum{~Limb{0}, ~Limb{0}}, ColumnSum{~Limb{0}, 5},
                                  ColumnSum{0, ~Limb{0} << 40}, ColumnSum{1, Limb{1} << 60}}) {
        ColumnSum wide = sum;
        wide.add(a, b);
        RunningSum running(sum);
        running.add(a, b);
        EXPECT_TRUE(running.sum().low == wide.low && running.sum().high == wide.high) << a << ' ' << b;
        EXPECT_EQ(integer_of(wide), integer_of(sum) + mpz_class(static_cast<long>(a)) * static_cast<long>(b));
        const auto portable = portable::add_product({sum.low, sum.high}, a, b);
        EXPECT_TRUE(portable.low == wide.low && portable.high == wide.high) << a << ' ' << b;
      }
    }
  }
}

TEST(ColumnSum, TimesAndDigits) {
  Random random(properties::seed());
  for (int i = 0; i < 10'000; ++i) {
    const auto high = static_cast<std::int64_t>(random.bits()) >> random.integer(8, 63);
    const ColumnSum sum{random.chance(0.2) ? 0 : random.bits(), static_cast<Limb>(high)};
    const mpz_class truth = integer_of(sum);
    for (const int factor : {1, -1, 2, -12, 36}) EXPECT_EQ(integer_of(sum.times(factor)), factor * truth);
    EXPECT_EQ(sum.sign(), sgn(truth));
    EXPECT_EQ(sum.is_small(), truth < mpz_class(1) << 69 && truth >= -(mpz_class(1) << 69));
    const ColumnSum::Digits d = sum.digits();
    for (const Digit digit : {d.low, d.middle}) EXPECT_TRUE(-most < digit && digit < most - 1) << digit;
    const auto whole = [](Digit digit) { return mpz_class(static_cast<long>(digit)); };
    EXPECT_EQ((((whole(d.high) << digit_bits) + whole(d.middle)) << digit_bits) + whole(d.low), truth);
    if (!sum.is_small()) continue;
    ColumnSum lower = sum;
    lower.go_down();
    EXPECT_EQ(integer_of(lower), truth << digit_bits);
  }
}

TEST(SignedDigits, OfANumber) {
  Random random(properties::seed());
  for (int i = 0; i < 500 * properties::repeat(); ++i) {
    const Number<8> x = any_number(random), tiny = from_double(std::ldexp(1, random.integer(-1074, 1023)));
    for (const Number<8>& number : {x, tiny, x - tiny, x * integer(-1), Number<8>()}) {
      DigitsOfDegree<8> digits(number);
      EXPECT_EQ(value(digits), value(number)) << "seed " << properties::seed();
    }
  }
}

// 2^n - 2^-n has ones in every limb but two digits.
TEST(SignedDigits, LongRunsOfOnesAreZeros) {
  for (int n = 100; n < 1000; ++n) {
    const Number<1> x = from_double(std::ldexp(1, n)) - from_double(std::ldexp(1, -n));
    DigitsOfDegree<1> digits(x);
    digits.know<false>(digits.last());
    EXPECT_LE(digits.dense(), 3) << n;
  }
}

TEST(SignedDigits, OfSumsOfProducts) {
  Random random(properties::seed());
  for (int i = 0; i < 300 * properties::repeat(); ++i) {
    const Number<8> x = any_number(random), y = random.chance(0.2) ? Number<8>() : any_number(random);
    const Number<8> other = from_double(std::ldexp(1, random.integer(-1000, 1000)));
    const Number<8> z = random.chance(0.3) ? about(x, random) : other;
    DigitsOfDegree<8> a(x), b(y), c(z);
    const mpq_class p = value(x), q = value(y), r = value(z);
    DigitsOfDegree<16> of_one{{-9, &a, &b}}, of_two{{4, &a, &a}, {-12, &b, &c}},
        of_three{{1, &a, &a}, {-1, &c, &c}, {1, &b, &c}};
    EXPECT_EQ(value(of_one), -9 * p * q) << "seed " << properties::seed();
    EXPECT_EQ(value(of_two), 4 * p * p - 12 * q * r) << "seed " << properties::seed();
    EXPECT_EQ(value(of_three), p * p - r * r + q * r) << "seed " << properties::seed();
    // And of such sums again.
    const ToldSum told({{1, &of_one, &of_two}, {-2, &of_three, &of_three}});
    const mpq_class three = p * p - r * r + q * r, truth = -9 * p * q * (4 * p * p - 12 * q * r) - 2 * three * three;
    EXPECT_EQ(told.sign(), sgn(truth)) << "seed " << properties::seed();
    EXPECT_LE(abs(mpq_class(value(told.number()) - truth)), scaled(abs(truth), -110)) << "seed " << properties::seed();
  }
}

// As many digits as numbers of degree 8 can have, all as great as can be: no column overflows.
TEST(SignedDigits, OfSumsOfTheGreatestDigits) {
  Number<8> x;
  x.sign = 1;
  x.size = Number<8>::capacity - 6;  // the rest is for carries and what products have besides
  for (int i = 0; i < x.size; ++i) x.limb[i] = 0;
  for (int bit = 0; bit < 64 * x.size; ++bit) {
    if (bit % digit_bits != digit_bits - 1) x.limb[bit / 64] |= Limb{1} << (bit % 64);
  }
  for (const int low : {0, -1, -130, 7}) {
    x.low = low;
    Number<8> minus_x = x;
    minus_x.sign = -1;
    DigitsOfDegree<8> a(x), b(x), c(x), d(minus_x);
    const mpq_class square = value(x) * value(x);
    DigitsOfDegree<16> sum{{2, &a, &b}, {-27, &c, &d}}, less{{-2, &a, &b}, {27, &c, &d}}, of_squares{{29, &a, &a}};
    EXPECT_EQ(value(sum), 29 * square) << low;
    EXPECT_EQ(value(less), -29 * square) << low;
    EXPECT_EQ(value(of_squares), 29 * square) << low;
    EXPECT_EQ(ToldSum({{1, &sum, &less}, {1, &less, &less}}).sign(), 0);
  }
}

/// x^2 y^2 against (x y)^2 with something beside them: from nothing to far more than either.
TEST(ToldSum, SignsAndValues) {
  Random random(properties::seed());
  int zeros = 0, negative = 0;
  for (int i = 0; i < 2000 * properties::repeat(); ++i) {
    const int far = random.chance(0.5) ? 1000 : 60;
    const auto length = [&] { return from_double(std::ldexp(1 + random.unit(), random.integer(-far, far))); };
    const auto degree_4 = [&] { return square(length() * length() - length() * length()) + length(); };
    const Number<4> x = degree_4(), y = degree_4();
    const Number<8> a = about(square(x), random), b = square(y), c = about(x * y, random);
    DigitsOfDegree<8> p(a), q(b), r(c);
    const ToldSum told({{1, &p, &q}, {-1, &r, &r}});
    const mpq_class truth = value(a) * value(b) - value(c) * value(c);
    ASSERT_EQ(told.sign(), sgn(truth)) << "seed " << properties::seed();
    EXPECT_EQ(compare_product_with_square(a, b, c), sgn(truth));
    zeros += truth == 0 ? 1 : 0;
    negative += truth < 0 ? 1 : 0;
    const auto found = vesica::exact::leading(told);
    EXPECT_TRUE(found.sign_is_certain());
    const mpq_class error = abs(mpq_class(value(told.number()) - truth));
    EXPECT_LE(error, scaled(abs(truth), -110)) << "seed " << properties::seed();
    if (found.error == found.nothing) {
      EXPECT_EQ(error, 0);
    } else {
      EXPECT_LT(error, exact_values::power_of_two(found.error));
    }
  }
  EXPECT_GT(zeros, 100 * properties::repeat());
  EXPECT_GT(negative, 300 * properties::repeat());
}

TEST(ToldSum, OfNothing) {
  const Number<8> nothing, unit = integer(1);
  DigitsOfDegree<8> zero(nothing), one(unit);
  EXPECT_EQ(ToldSum({}).sign(), 0);
  EXPECT_EQ(ToldSum({{1, &zero, &one}, {-1, &zero, &zero}}).sign(), 0);
  EXPECT_EQ(ToldSum({{1, &one, &one}, {-1, &one, &one}}).sign(), 0);
  EXPECT_EQ(ToldSum({{1, &zero, &one}, {-1, &one, &one}}).sign(), -1);
}

// Products of unlike signs and sizes, equal ones, and ones that differ by as little as any double; short and long ones.
TEST(ToldSum, TwoProducts) {
  Random random(properties::seed());
  int ties = 0;
  for (int i = 0; i < 1000 * properties::repeat(); ++i) {
    const Number<8> a = any_number(random), b = any_number(random), c = about(a, random), d = about(b, random);
    const Number<8> small = integer(random.integer(-2, 2)), one = integer(1), zero;
    const auto expect = [](const auto& p, const auto& q, const auto& r, const auto& s) {
      const int truth = sgn(mpq_class(value(p) * value(q) - value(r) * value(s)));
      EXPECT_EQ(compare_products(p, q, r, s), truth) << "seed " << properties::seed();
      EXPECT_EQ(compare_products(r, s, p, q), -truth) << "seed " << properties::seed();
      return truth == 0 ? 1 : 0;
    };
    ties += expect(a, b, c, d) + expect(a, b, b, a) + expect(a, a, c, c);
    expect(a, b, zero, d);
    expect(a, small, one, c);
    expect(small, small, one, small);
    const Number<8> tiny = from_double(0x1p-1000), unlike = one + tiny;
    for (const Number<8>& sign : {one, small}) {
      expect(unlike, sign, one, one);
      expect(one, unlike, sign, one);
      expect(one, one, unlike, sign);
      expect(one, sign, one, unlike);
    }
  }
  EXPECT_GT(ties, 1000 * properties::repeat());
}

TEST(ToldSum, SquaresTimesNumbers) {
  Random random(properties::seed());
  int ties = 0;
  for (int i = 0; i < 500 * properties::repeat(); ++i) {
    const Number<8> a = any_number(random), b = any_number(random), c = about(a, random), d = about(b, random);
    const mpq_class truth = value(a) * value(a) * value(b) - value(c) * value(c) * value(d);
    EXPECT_EQ(vesica::exact::compare_squares_times(a, b, c, d), sgn(truth)) << "seed " << properties::seed();
    ties += truth == 0 ? 1 : 0;
  }
  EXPECT_GT(ties, 10 * properties::repeat());
}

// Any of the numbers may be the long one, or 0.
TEST(ToldSum, SquaresTimesNumbersOfWhichOneIsLong) {
  const Number<8> one = integer(1), nothing, far = square(square(square(from_double(0x1p-250))));
  const Number<8> less = one - far, more = one + far;
  using vesica::exact::compare_squares_times;
  ASSERT_TRUE(is_long(less) && is_long(more) && !is_long(one));
  EXPECT_EQ(compare_squares_times(one, one, one, one), 0);
  EXPECT_EQ(compare_squares_times(less, one, one, one), -1);
  EXPECT_EQ(compare_squares_times(one, less, one, one), -1);
  EXPECT_EQ(compare_squares_times(one, one, less, one), 1);
  EXPECT_EQ(compare_squares_times(one, one, one, less), 1);
  EXPECT_EQ(compare_squares_times(one, one, one, more), -1);
  EXPECT_EQ(compare_squares_times(less, nothing, one, nothing), 0);
  EXPECT_EQ(compare_squares_times(less, one, nothing, one), 1);
  EXPECT_EQ(compare_squares_times(more, more, more, more), 0);
}

// No more digits are formed than tell the sign: here the first ones do.
TEST(ToldSum, FormsTheDigitsThatItNeeds) {
  Random random(properties::seed());
  for (int i = 0; i < 100 * properties::repeat(); ++i) {
    const Number<8> x = any_number(random), y = any_number(random);
    const Number<8> double_x = integer(2) * x;
    DigitsOfDegree<8> a(x), b(y), twice(double_x);
    const ToldSum told({{1, &twice, &b}, {-1, &a, &b}});
    EXPECT_EQ(told.sign(), x.sign * y.sign) << "seed " << properties::seed();
    EXPECT_LE(a.dense() + b.dense() + twice.dense(), 3 * 2 * Columns::block) << "seed " << properties::seed();
  }
}

}  // namespace
