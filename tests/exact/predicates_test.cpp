// SPDX-License-Identifier: Apache-2.0
// Exact predicates and roundings against GMP, also for wildly unlike exponents.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vesica/exact/ellipse_ellipse.hpp>
#include <vesica/exact/rounded.hpp>
#include <vesica/shape_area.hpp>

#include "exact/values.hpp"
#include "properties/random.hpp"

namespace {

using namespace vesica;
using exact::Limb;
using exact::Number;
using exact_values::power_of_two, exact_values::value;
using properties::Random;

TEST(Predicates, PointAgainstRim) {
  Random random(properties::seed());
  const auto any = [&random] {
    const auto length = [&] { return exact::from_double(std::ldexp(1 + random.unit(), random.integer(-1000, 1000))); };
    return random.chance(0.5) ? length() * length() : length() * length() - length() * length();
  };
  int on = 0;
  for (int i = 0; i < 2000 * properties::repeat(); ++i) {
    const Number<2> s = any(), t = any();
    Number<4> legs[] = {square(s) - square(t), exact::integer(2) * (s * t)}, radius = square(s) + square(t);
    if (random.chance(0.5)) std::swap(legs[0], legs[1]);
    const auto tiny = square(exact::from_double(std::ldexp(1 + random.unit(), random.integer(-500, 500))));
    if (random.chance(0.3)) radius = radius + tiny;
    if (random.chance(0.3)) legs[0] = legs[0] - tiny;
    const auto &x = legs[0], &y = legs[1];
    const mpq_class truth = value(x) * value(x) + value(y) * value(y) - value(radius) * value(radius);
    EXPECT_EQ(value(exact::beyond_rim(x, y, radius)), truth);
    EXPECT_EQ(exact::side_of_rim(x, y, radius), -sgn(truth)) << "seed " << properties::seed();
    on += truth == 0;
  }
  EXPECT_GT(on, 500 * properties::repeat());
}

/// Ellipses with numbers of wildly unlike exponents, many of them alike: then much cancels.
struct Ellipses {
  exact::Ellipse a, b;
};
Ellipses any_ellipses(Random& random) {
  std::array<double, 6> a{}, b{};
  for (double& x : a) x = std::ldexp(1 + random.unit(), random.integer(-1000, 1000));
  for (std::size_t i = 0; i < 6; ++i) {
    b[i] = random.chance(0.6) ? a[i] : std::ldexp(1 + random.unit(), random.integer(-1000, 1000));
  }
  if (random.chance(0.3)) a[5] = a[4];
  if (random.chance(0.3)) b[5] = b[4];
  if (random.chance(0.3)) b[4] = a[4] * 2;
  const auto form = [](const std::array<double, 6>& n) {
    return exact::form(Ellipse<double>{n[0], n[1], n[2], n[3], n[4], n[5]});
  };
  return {form(a), form(b)};
}

/// The sign of a + b sqrt(c), c >= 0.
int sign_with_root(const mpq_class& a, const mpq_class& b, const mpq_class& c) {
  const int root = sgn(b) * sgn(c);
  if (sgn(a) == root || root == 0) return sgn(a);
  if (sgn(a) == 0) return root;
  return root * sgn(mpq_class(b * b * c - a * a));
}

/// The decision of exact::detail::first_in_second().
bool first_is_in_second(const exact::ContactCubic& p) {
  const mpq_class d1 = value(p.d1), c1 = value(p.c1), c2 = value(p.c2), d2 = value(p.d2), mu = value(p.mu);
  const mpq_class delta = mu * mu - 4 * d1 * d2, slope = 2 * c2 - 3 * mu, al = value(p.al), be = value(p.be);
  const int rising = sign_with_root(slope * mu + 2 * d2 * (3 * d1 - c1), slope, delta);
  const bool touches = rising == 0 && sign_with_root(2 * d2 * al - be * mu, -be, delta) == 0;
  return slope > 0 && (sign_with_root(slope, -3, delta) > 0 || rising > 0 || touches);
}

TEST(ContactCubic, OfAnyExponents) {
  Random random(properties::seed());
  std::array<int, 3> signs{};
  for (int i = 0; i < 3000 * properties::repeat(); ++i) {
    const Ellipses e = any_ellipses(random);
    const exact::ContactCubic p = exact::contact_cubic(e.a, e.b);
    if (p.al.sign == 0) continue;
    const mpq_class d1 = value(p.d1), c1 = value(p.c1), c2 = value(p.c2), d2 = value(p.d2);
    const mpq_class a = c2 * c2 - 3 * d2 * c1, b = c1 * c2 - 9 * d1 * d2, c = c1 * c1 - 3 * d1 * c2;
    const int truth = sgn(mpq_class(4 * a * c - b * b));
    EXPECT_EQ(exact::discriminant_sign(p), truth) << "seed " << properties::seed();
    EXPECT_EQ(exact::double_root_is_greater(p), 2 * c2 * a > 3 * d2 * b) << "seed " << properties::seed();
    EXPECT_EQ(exact::detail::first_in_second(p), first_is_in_second(p)) << "seed " << properties::seed();
    ++signs[static_cast<std::size_t>(truth + 1)];
  }
  EXPECT_GT(signs[0], 100 * properties::repeat());
  EXPECT_GT(signs[2], 100 * properties::repeat());
}

/// Ties too: S1 = diag(s, t), S2 = diag(k, k), and an offset of squares x and y.
TEST(ContactCubic, OfSmallNumbers) {
  const Number<8> one = square(square(square(exact::from_double(1.0))));
  const auto number = [&](int k) -> Number<8> { return exact::integer(k) * one; };
  int touching = 0;
  const auto expect = [&](int root1, int d2, int mu, int al, int be) {
    const int d1 = root1 * root1, c1 = d1 + mu - al, c2 = d2 + mu - be;
    const exact::ContactCubic p{number(d1), number(c1), number(c2), number(d2), number(mu), number(al), number(be)};
    EXPECT_EQ(exact::detail::first_in_second(p), first_is_in_second(p)) << d1 << ' ' << d2 << ' ' << mu << ' ' << al;
    const mpq_class slope = 2 * c2 - 3 * mu, rest = slope * mu + 2 * d2 * (3 * d1 - c1);
    touching += sign_with_root(rest, slope, mpq_class(mu) * mu - mpq_class(4) * d1 * d2) == 0;
  };
  for (int k = 1; k <= 24; ++k) {
    for (const int root1 : {1, 2, 3, 4, 6, 8, 10, 12}) {
      for (int s = root1; s <= k; ++s) {
        const int t = root1 * root1 / s;
        if (s * t != root1 * root1) continue;
        for (int x = 0; x < k; ++x) {
          for (int y = x == 0 ? 1 : 0; y < k; ++y) expect(root1, k * k, k * (s + t), t * x + s * y, k * (x + y));
        }
      }
    }
  }
  EXPECT_GT(touching, 20);
}

/// A term far below a tie breaks it.
TEST(Rounding, OfOneFarBelow) {
  const auto one = exact::from_double(1), tie = exact::from_double(0x1p128) + exact::from_double(0x1p75);
  const auto rounded = [](const auto& x) {
    const auto found = exact::rounded(x);
    return std::ldexp(found.value, found.exponent);
  };
  EXPECT_EQ(rounded(tie), 0x1p128);
  EXPECT_EQ(rounded(tie + one), 0x1p128 + 0x1p76);
  EXPECT_EQ(rounded(tie - one), 0x1p128);
  for (const int exponent : {60, 130, 400, 800, 1000}) {
    const auto [high, low] = exact::rounded_twice(exact::from_double(1, exponent) + one);
    EXPECT_EQ(std::ldexp(high.value, high.exponent - exponent), 1);
    EXPECT_EQ(std::ldexp(low, high.exponent), 1) << exponent;
  }
}

/// The nearest number of 53 bits, ties to even; of a whole number over a power of two.
mpq_class nearest_of_53_bits(const mpq_class& x) {
  const auto cut = static_cast<long>(mpz_sizeinbase(x.get_num().get_mpz_t(), 2)) - 53;
  if (cut <= 0) return x;
  mpz_class unit, kept, rest;
  mpz_ui_pow_ui(unit.get_mpz_t(), 2, static_cast<unsigned long>(cut));
  mpz_fdiv_qr(kept.get_mpz_t(), rest.get_mpz_t(), x.get_num().get_mpz_t(), unit.get_mpz_t());
  const int order = cmp(mpz_class(2 * rest), unit);
  if (order > 0 || (order == 0 && mpz_odd_p(kept.get_mpz_t()) != 0)) ++kept;
  mpq_class nearest(kept * unit, x.get_den());
  nearest.canonicalize();
  return nearest;
}

/// Limbs of zeros, of ones, of one bit, and any: ties, carries through all limbs, and little that is left.
TEST(Rounding, OnceAndTwice) {
  Random random(properties::seed());
  for (int i = 0; i < 20'000 * properties::repeat(); ++i) {
    Number<4> x;
    x.sign = random.chance(0.5) ? 1 : -1;
    x.low = random.integer(-4, 4);
    x.size = random.chance(0.1) ? random.integer(1, 60) : random.integer(1, 6);
    for (int k = 0; k < x.size; ++k) {
      const Limb bit = Limb{1} << random.below(64), kinds[] = {0, ~Limb{0}, bit, ~(bit - 1), bit - 1, random.bits()};
      x.limb[k] = kinds[random.below(6)];
    }
    x.strip();
    const mpq_class truth = value(x);
    const auto once = exact::rounded(x);
    const auto [high, low] = exact::rounded_twice(x);
    const mpq_class first = mpq_class(high.value) * power_of_two(high.exponent);
    EXPECT_EQ(first, nearest_of_53_bits(truth)) << "seed " << properties::seed();
    EXPECT_EQ(mpq_class(low) * power_of_two(high.exponent), nearest_of_53_bits(truth - first))
        << "seed " << properties::seed();
    EXPECT_TRUE(once.value == high.value && once.exponent == high.exponent);
  }
}

/// The ratio of a circle's circumference to its diameter, to a hundred decimals.
TEST(ExactPi, HasThreeLimbsOfFraction) {
  mpz_class digits(
      "3141592653589793238462643383279502884197169399375105820974944592307816406286208998628034825342117067");
  mpz_class one;
  mpz_ui_pow_ui(one.get_mpz_t(), 10, 99);
  const mpq_class pi = mpq_class(digits, one), off = value(detail::area::exact_pi()) - pi;
  EXPECT_LT(abs(off), power_of_two(-192));
}

}  // namespace
