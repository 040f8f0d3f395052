// SPDX-License-Identifier: Apache-2.0
// exact::Number against GMP's rationals. Compiled with assertions and sanitizers: every sum and product checks that it
// stays within the storage its degree promises.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vesica/exact/compare.hpp>
#include <vesica/exact/ellipse_ellipse.hpp>

#include "exact/values.hpp"
#include "properties/random.hpp"

#ifdef NDEBUG
#error "This test is about the assertions."
#endif

namespace {

using namespace vesica;
using exact::from_double;
using exact::Limb;
using exact::Number;
using exact_values::scaled, exact_values::value;
using properties::Random;

/// Neither end is a zero limb, and zero has one form.
template <int D>
void expect_stripped(const Number<D>& n) {
  ASSERT_LE(n.size, n.capacity);
  if (n.size == 0) {
    EXPECT_EQ(n.sign, 0);
    EXPECT_EQ(n.low, 0);
  } else {
    EXPECT_EQ(std::abs(n.sign), 1);
    EXPECT_NE(n.limb[0], 0U);
    EXPECT_NE(n.limb[n.size - 1], 0U);
  }
}

template <int D>
void expect_value(const Number<D>& n, const mpq_class& truth) {
  expect_stripped(n);
  EXPECT_EQ(value(n), truth) << "seed " << properties::seed();
}

TEST(FromDouble, Literals) {
  const auto expect = [](double x, int sign, int low, Limb first, Limb second = 0) {
    const Number<1> n = from_double(x);
    EXPECT_EQ(n.sign, sign) << x;
    EXPECT_EQ(n.low, low) << x;
    ASSERT_EQ(n.size, second == 0 ? 1 : 2) << x;
    EXPECT_EQ(n.limb[0], first) << x;
    EXPECT_EQ(n.size == 2 ? n.limb[1] : 0, second) << x;
  };
  expect(1, 1, 0, 1);
  expect(-3, -1, 0, 3);
  expect(0.5, 1, -1, Limb{1} << 63);
  expect(0x1p63, 1, 0, Limb{1} << 63);
  expect(0x1p64, 1, 1, 1);
  expect(-1.5, -1, -1, Limb{1} << 63, 1);
  expect(0x1.8p64, 1, 0, Limb{1} << 63, 1);
  expect(0x1p-1074, 1, -17, Limb{1} << 14);  // -1074 = 64 (-17) + 14
  expect(0x1p-1022, 1, -16, 4);              // -1022 = 64 (-16) + 2
  expect(-DBL_MAX, -1, 15, 0xfffffffffffff800);
  EXPECT_EQ(from_double(0).sign, 0);
  EXPECT_EQ(from_double(-0.0).sign, 0);
  EXPECT_EQ(from_double(-0.0).size, 0);
  expect_stripped(from_double(0, -1));
}

/// Any finite double, landmarks often.
double any_double(Random& random) {
  constexpr double landmarks[] = {0,         1,           DBL_MAX, DBL_MIN, 0x1p-1074, 0x1.fffffffffffffp-1022,
                                  0x1p-1073, DBL_EPSILON, 0x1p63,  0x1p64,  0x1p-64,   0x1.fffffffffffffp0};
  double x = random.chance(0.2) ? landmarks[random.below(12)] : std::bit_cast<double>(random.bits());
  if (!std::isfinite(x)) x = std::bit_cast<double>(random.bits() >> 12);  // subnormal
  return random.chance(0.5) ? -x : x;
}

TEST(FromDouble, EqualsGmp) {
  Random random(properties::seed());
  for (int i = 0; i < 50'000 * properties::repeat(); ++i) {
    const double x = any_double(random);
    expect_value(from_double(x), mpq_class(x));
    expect_value(from_double(x, -1), scaled(mpq_class(x), -1));
  }
}

TEST(FromDouble, EveryExponent) {
  for (int e = -1074; e <= 1023; ++e) {
    const double power = std::ldexp(1.0, e);
    expect_value(from_double(power), mpq_class(power));
    expect_value(exact::half(-power), scaled(mpq_class(-power), -1));
    const double ones = std::nextafter(2 * power, 0);  // subnormal, and infinite twice its exponent, at the ends
    if (std::isfinite(ones)) expect_value(from_double(ones, -1), scaled(mpq_class(ones), -1));
  }
}

TEST(Number, Integers) {
  for (const int i : {0, 1, -1, 3, 4, 9, 2147483647, -2147483647 - 1}) expect_value(exact::integer(i), mpq_class(i));
}

TEST(Number, StripDropsZerosAtBothEnds) {
  Number<4> n;
  n.sign = -1;
  n.low = -7;
  n.size = 6;
  const Limb limbs[] = {0, 0, 5, 0, 6, 0};
  for (int i = 0; i < 6; ++i) n.limb[i] = limbs[i];
  n.strip();
  EXPECT_EQ(n.sign, -1);
  EXPECT_EQ(n.low, -5);
  ASSERT_EQ(n.size, 3);
  EXPECT_EQ(n.limb[0], 5U);
  EXPECT_EQ(n.limb[1], 0U);
  EXPECT_EQ(n.limb[2], 6U);

  n.limb[0] = n.limb[2] = 0;
  n.strip();
  EXPECT_EQ(n.sign, 0);
  EXPECT_EQ(n.low, 0);
  EXPECT_EQ(n.size, 0);
}

/// A number with its value.
template <int D>
struct Known {
  Number<D> number;
  mpq_class truth;
};

Known<1> any_length(Random& random) {
  const double x = any_double(random);
  return {from_double(x), mpq_class(x)};
}

/// A sum of products: numbers of a degree as predicates have them.
template <int D>
Known<D> any_known(Random& random) {
  if constexpr (D == 1) {
    const Known<1> a = any_length(random), b = any_length(random);
    return {a.number - b.number, a.truth - b.truth};
  } else {
    const Known<D / 2> a = any_known<D / 2>(random), b = any_known<D / 2>(random);
    const Known<D / 2> c = any_known<D / 2>(random);
    return {a.number * b.number + square(c.number), a.truth * b.truth + c.truth * c.truth};
  }
}

/// A neighbour of x on the grid of its own last limb, or x itself: differences cancel and comparisons are close.
template <int D>
Known<D> close_to(const Known<D>& x, Random& random) {
  Known<D> near = x;
  if (x.number.sign == 0 || random.chance(0.3)) return near;
  Number<D> last;
  last.sign = random.chance(0.5) ? 1 : -1;
  last.low = x.number.low;
  last.size = 1;
  last.limb[0] = Limb{1} << random.below(64);
  near.number = x.number + last;
  near.truth = x.truth + value(last);
  return near;
}

template <int A, int B>
void expect_arithmetic(const Known<A>& a, const Known<B>& b) {
  expect_value(a.number + b.number, a.truth + b.truth);
  expect_value(a.number - b.number, a.truth - b.truth);
  expect_value(a.number * b.number, a.truth * b.truth);
  expect_value(square(a.number), a.truth * a.truth);
  expect_value(abs(a.number), abs(a.truth));
  EXPECT_EQ(compare(a.number, b.number), sgn(a.truth - b.truth)) << "seed " << properties::seed();
  EXPECT_EQ(compare(b.number, a.number), sgn(b.truth - a.truth)) << "seed " << properties::seed();
  EXPECT_EQ(compare(a.number, a.number), 0);
}

template <int A, int B>
void expect_arithmetic(int pairs) {
  Random random(properties::seed());
  for (int i = 0; i < pairs * properties::repeat(); ++i) {
    const Known<A> a = any_known<A>(random);
    expect_arithmetic(a, any_known<B>(random));
    expect_arithmetic(a, close_to(a, random));
    Known<A> negative = close_to(a, random);
    negative.number.sign = -negative.number.sign;
    negative.truth = -negative.truth;
    expect_arithmetic(a, negative);
  }
}

TEST(Number, ArithmeticOfDegree1And1) { expect_arithmetic<1, 1>(4000); }
TEST(Number, ArithmeticOfDegree2And1) { expect_arithmetic<2, 1>(2000); }
TEST(Number, ArithmeticOfDegree4And8) { expect_arithmetic<4, 8>(300); }
TEST(Number, ArithmeticOfDegree16And16) { expect_arithmetic<16, 16>(30); }

TEST(Number, ProductAgainstSquare) {
  Random random(properties::seed());
  int ties = 0;
  for (int i = 0; i < 1500 * properties::repeat(); ++i) {
    const auto expect = [&](const auto& a, const auto& b, const auto& c) {
      const int truth = sgn(a.truth * b.truth - c.truth * c.truth);
      EXPECT_EQ(compare_product_with_square(a.number, b.number, c.number), truth) << "seed " << properties::seed();
      ties += truth == 0;
    };
    const Known<2> a = any_known<2>(random), b = any_known<2>(random), c = any_known<2>(random);
    expect(a, b, c);
    expect(c, c, c);
    expect(c, close_to(c, random), c);
    // (x^2)(y^2) against (x y)^2
    expect(Known<4>{square(a.number), a.truth * a.truth}, Known<4>{square(b.number), b.truth * b.truth},
           close_to(Known<4>{a.number * b.number, a.truth * b.truth}, random));
    expect(Known<2>{}, b, c);
    expect(a, b, Known<2>{});
    expect(Known<2>{}, b, Known<2>{});
  }
  EXPECT_GT(ties, 1500 * properties::repeat());
}

// Sums of two products share a buffer: of any lengths, with one or both products 0, nearly equal ones, and squares.
TEST(Number, SumsOfProducts) {
  Random random(properties::seed());
  int zeros = 0;
  for (int i = 0; i < 1500 * properties::repeat(); ++i) {
    const auto expect = [&](const auto& a, const auto& b, const auto& c, const auto& d) {
      const mpq_class ab = a.truth * b.truth, cd = c.truth * d.truth;
      expect_value(exact::detail::sum_of_products(a.number, b.number, 1, c.number, d.number), ab + cd);
      expect_value(exact::detail::sum_of_products(a.number, b.number, -1, c.number, d.number), ab - cd);
      EXPECT_EQ(compare_products(a.number, b.number, c.number, d.number), sgn(ab - cd))
          << "seed " << properties::seed();
      zeros += ab == cd;
    };
    const Known<2> a = any_known<2>(random), b = any_known<2>(random), c = any_known<2>(random);
    const Known<4> wide = any_known<4>(random), ab{a.number * b.number, a.truth * b.truth};
    expect(a, b, c, c);
    expect(a, a, c, b);
    expect(a, wide, b, wide);
    expect(a, wide, c, any_known<1>(random));
    expect(ab, c, a, Known<4>{b.number * c.number, b.truth * c.truth});
    expect(close_to(ab, random), c, a, Known<4>{b.number * c.number, b.truth * c.truth});
    expect(Known<2>{}, b, c, a);
    expect(a, b, c, Known<2>{});
    expect(a, Known<2>{}, Known<2>{}, c);
  }
  EXPECT_GT(zeros, 2000 * properties::repeat());
}

/// The widest lengths there are: a difference of the greatest and the least number, halved; every bit but two is set.
Known<1> widest(int sign) {
  const Number<1> a = exact::half(DBL_MAX) + exact::half(DBL_MAX), b = exact::half(sign * 0x1p-1074);
  const mpq_class top(DBL_MAX);
  return {a - b, top - scaled(mpq_class(sign * 0x1p-1074), -1)};
}

template <int D>
void expect_powers_within_capacity(const Known<D>& x) {
  expect_value(x.number, x.truth);
  if constexpr (D < 32) {
    expect_powers_within_capacity(Known<2 * D>{square(x.number), x.truth * x.truth});
    expect_powers_within_capacity(Known<2 * D>{x.number * x.number, x.truth * x.truth});
  }
}

TEST(Number, WidestPowersToDegree32) {
  const Known<1> above = widest(-1), below = widest(1);
  expect_powers_within_capacity(above);
  expect_powers_within_capacity(below);
  // As offsets of centres are: twice the greatest number, down to half the least.
  expect_powers_within_capacity(
      Known<1>{above.number + below.number + above.number, above.truth + below.truth + above.truth});
}

TEST(Number, LeastPowersToDegree32) {
  expect_powers_within_capacity(Known<1>{exact::half(0x1p-1074), scaled(mpq_class(0x1p-1074), -1)});
  expect_powers_within_capacity(Known<1>{from_double(DBL_MAX), mpq_class(DBL_MAX)});
}

/// A predicate's polynomial of the highest degree, with every number at its widest: sums of terms of one degree stay
/// within capacity too. The answers are tested elsewhere; here the assertions speak.
TEST(Number, PredicatesAtTheEndsOfTheRange) {
  Random random(properties::seed());
  constexpr double ends[] = {DBL_MAX, -DBL_MAX, 0x1p-1074, -0x1p-1074, 0x1.fffffffffffffp-1022, 0x1.5555555555555p1023};
  const auto end = [&] { return ends[random.below(6)]; };
  int overlaps = 0;
  const int cases = 300 * properties::repeat();
  for (int i = 0; i < cases; ++i) {
    const Ellipse<double> e{end(), end(), end(), end(), std::fabs(end()), std::fabs(end())};
    const Ellipse<double> f{end(), end(), end(), end(), std::fabs(end()), std::fabs(end())};
    const Segment<double> s{end(), end(), end(), end()};
    const Rect<double> r{end(), end(), end(), end(), std::fabs(end()), std::fabs(end())};
    overlaps += exact::overlap(exact::form(e), exact::form(f));
    overlaps += exact::overlap(exact::form(s), exact::form(f));
    overlaps += exact::overlap(exact::form(r), exact::form(e));
    overlaps += exact::overlap(exact::form(s), exact::form(r));
  }
  EXPECT_GT(overlaps, 0);
  EXPECT_LT(overlaps, 4 * cases);
}

}  // namespace
