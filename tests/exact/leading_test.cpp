// SPDX-License-Identifier: Apache-2.0
// Leading digits and sparse products, which serve exponents that are wildly unlike, against GMP: what they claim is
// within their bound, and a sign that they call certain is the sign.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>
#include <vesica/exact/ellipse_ellipse.hpp>
#include <vesica/exact/leading.hpp>
#include <vesica/exact/rounded.hpp>
#include <vesica/shape_area.hpp>

#include "exact/values.hpp"
#include "properties/random.hpp"

namespace {

using namespace vesica;
using exact::Limb;
using exact::Number;
using exact_values::about, exact_values::any_number, exact_values::integer, exact_values::power_of_two,
    exact_values::value;
using properties::Random;

template <int limbs>
mpq_class value(const exact::Leading<limbs>& x) {
  if (x.sign == 0) return 0;
  return mpq_class(x.sign * integer(x.limb, limbs)) * power_of_two(std::int64_t{64} * x.low);
}

/// Runs of zeros and of ones, and between them limbs of any kind.
std::vector<Limb> sparse_limbs(Random& random) {
  std::vector<Limb> limbs;
  const int runs = random.integer(1, 8);
  for (int i = 0; i < runs; ++i) {
    const int filling = random.integer(0, 20), content = random.integer(1, 3);
    limbs.insert(limbs.end(), static_cast<std::size_t>(filling), random.chance(0.5) ? Limb{0} : ~Limb{0});
    for (int k = 0; k < content; ++k) limbs.push_back(random.chance(0.2) ? ~Limb{0} : random.bits());
  }
  return limbs;
}

TEST(Sparse, ProductsAndSquares) {
  Random random(properties::seed());
  const auto expect = [&random](const std::vector<Limb>& a, const std::vector<Limb>& b) {
    const int na = static_cast<int>(a.size()), nb = static_cast<int>(b.size());
    std::vector<Limb> out(a.size() + b.size() + 2, 0x5555), sum(2 * a.size() + 2, 0);
    for (std::size_t i = 0; i + 3 < sum.size(); ++i) sum[i] = random.bits();
    const mpz_class before = integer(sum.data(), 2 * na + 2);
    if (exact::detail::add_square_sparse({a.data(), 0, na}, sum.data())) {
      EXPECT_EQ(integer(sum.data(), 2 * na + 2), before + integer(a.data(), na) * integer(a.data(), na))
          << "seed " << properties::seed();
    } else {
      EXPECT_EQ(integer(sum.data(), 2 * na + 2), before);
    }
    if (!exact::detail::multiply_sparse({a.data(), 0, na}, {b.data(), 0, nb}, out.data())) return false;
    EXPECT_EQ(integer(out.data(), na + nb + 2), integer(a.data(), na) * integer(b.data(), nb))
        << "seed " << properties::seed();
    return true;
  };
  int formed = 0, left = 0;
  for (int i = 0; i < 20'000 * properties::repeat(); ++i) {
    const std::vector<Limb> a = sparse_limbs(random);
    (expect(a, random.chance(0.3) ? a : sparse_limbs(random)) ? formed : left) += 1;
  }
  EXPECT_GT(formed, left);
  EXPECT_GT(left, 0);
}

template <class Kept>
void expect_within_bound(const Kept& x, const mpq_class& truth) {
  if (x.error == x.nothing) {
    EXPECT_EQ(value(x), truth);
  } else {
    EXPECT_LT(abs(mpq_class(value(x) - truth)), power_of_two(x.error));
  }
  if (x.sign_is_certain()) {
    EXPECT_EQ(x.sign, sgn(truth)) << "seed " << properties::seed();
  }
}

template <class Kept>
int expect_arithmetic(const Number<8>& p, const Number<8>& q) {
  const Kept a(p), b(q), sum = a + b, product = a * b;
  const mpq_class x = value(p), y = value(q);
  expect_within_bound(a, x);
  expect_within_bound(sum, x + y);
  expect_within_bound(a - b, x - y);
  expect_within_bound(product, x * y);
  expect_within_bound(square(a), x * x);
  expect_within_bound(times(12, a), 12 * x);
  // What is left of these is what was not exact.
  const Kept none = square(sum) - square(a) - square(b) - times(2, product);
  expect_within_bound(none, 0);
  expect_within_bound(none * b, 0);
  return none.sign_is_certain() ? 1 : 0;
}

/// Factors whose lowest limb is anywhere: what is not formed of a product is in its error, and a product that fits is
/// exact.
TEST(Leading, ProductsOfAnyLowestLimb) {
  constexpr int limbs = exact::more_limbs;
  Random random(properties::seed());
  const auto number = [&random](int lowest, Limb limb, bool is_full) {
    exact::Leading<limbs> x;
    x.sign = 1;
    for (int i = lowest + 1; i < limbs; ++i) x.limb[i] = is_full ? random.bits() : 0;
    x.limb[limbs - 1] |= Limb{1} << 63;
    x.limb[lowest] |= limb;
    return x;
  };
  for (int i = 0; i < limbs; ++i) {
    for (int k = 0; k < limbs; ++k) {
      for (const Limb limb : {Limb{1}, Limb{2}, ~Limb{0}}) {
        const auto a = number(i, limb, k % 2 == 0), b = number(k, limb, i % 3 == 0), product = a * b;
        expect_within_bound(product, value(a) * value(b));
        expect_within_bound(square(a), value(a) * value(a));
        if (i + k >= limbs) {
          EXPECT_EQ(product.error, product.nothing) << i << ' ' << k;
        }
      }
    }
  }
}

TEST(Leading, WithinItsBound) {
  using exact::Leading, exact::few_limbs, exact::some_limbs, exact::more_limbs;
  Random random(properties::seed());
  int certain = 0;
  for (int i = 0; i < 2000 * properties::repeat(); ++i) {
    const Number<8> p = any_number(random);
    // Often nearly the same, or the same.
    const Number<8> q = random.chance(0.5) ? any_number(random) : random.chance(0.5) ? p : p + any_number(random);
    certain += expect_arithmetic<Leading<few_limbs>>(p, q) + expect_arithmetic<Leading<more_limbs>>(q, p);
    expect_arithmetic<Leading<some_limbs>>(p, Number<8>());
    expect_arithmetic<Leading<some_limbs>>(Number<8>(), q);
    // Of a number that is exact, what a sum leaves out of the other one is all that is lost.
    const Number<8> brief = exact::from_double(std::ldexp(1 + random.unit(), random.integer(-1000, 1000)));
    expect_arithmetic<Leading<few_limbs>>(p, brief);
    expect_arithmetic<Leading<few_limbs>>(brief, p);
  }
  EXPECT_EQ(certain, 0);
}

// Signs and roundings from the leading digits are those of all digits.
TEST(Leading, PolynomialsOfLongNumbers) {
  Random random(properties::seed());
  const auto difference = [](const auto& a, const auto& b, const auto& c, const auto& d) { return a * b - c * d; };
  int ties = 0, differing = 0;
  for (int i = 0; i < 2000 * properties::repeat(); ++i) {
    const Number<8> a = any_number(random), b = any_number(random), c = about(a, random), d = about(b, random);
    const auto truth = difference(a, b, c, d);
    EXPECT_EQ(exact::sign_of(difference, a, b, c, d), truth.sign) << "seed " << properties::seed();
    EXPECT_EQ(exact::sign_of(exact::DifferenceOfProducts{}, a, b, c, d), truth.sign) << "seed " << properties::seed();
    EXPECT_EQ(exact::sign_of(exact::SumOfProducts{}, a, b, exact::times(-1, c), d), truth.sign)
        << "seed " << properties::seed();
    const auto rounded = exact::rounded_value(difference, a, b, c, d), expected = exact::rounded(truth);
    EXPECT_TRUE(rounded.value == expected.value && rounded.exponent == expected.exponent)
        << "seed " << properties::seed();
    (truth.sign == 0 ? ties : differing) += 1;
  }
  EXPECT_GT(ties, 50 * properties::repeat());
  EXPECT_GT(differing, 500 * properties::repeat());
}

// Each of the four numbers may be the only long one, or none is.
TEST(Leading, TwoProductsOfWhichOneIsLong) {
  const Number<8> one = exact::integer(1), two = exact::integer(2), longer = one + exact::from_double(0x1p-1074);
  ASSERT_TRUE(is_long(longer) && !is_long(two));
  const auto sum = exact::SumOfProducts{};
  const auto difference = exact::DifferenceOfProducts{};
  EXPECT_EQ(exact::sign_of(difference, two, one, one, two), 0);
  EXPECT_EQ(exact::sign_of(difference, longer, one, one, one), 1);
  EXPECT_EQ(exact::sign_of(difference, one, longer, one, one), 1);
  EXPECT_EQ(exact::sign_of(difference, one, one, longer, one), -1);
  EXPECT_EQ(exact::sign_of(difference, one, one, one, longer), -1);
  EXPECT_EQ(exact::sign_of(sum, two, one, exact::times(-1, one), two), 0);
  EXPECT_EQ(exact::sign_of(sum, longer, one, exact::times(-1, one), one), 1);
  EXPECT_EQ(exact::sign_of(sum, one, longer, exact::times(-1, one), one), 1);
  EXPECT_EQ(exact::sign_of(sum, exact::times(-1, one), one, longer, one), 1);
  EXPECT_EQ(exact::sign_of(sum, exact::times(-1, one), one, one, longer), 1);
}

// Halfway between two doubles, and so little from there that leading digits do not tell.
TEST(Leading, RoundsTiesByWhatIsFarBelow) {
  const auto itself = [](const auto& x) { return x; };
  const auto tie = exact::from_double(1) + exact::from_double(0x1p-53);
  for (int exponent = -1074; exponent < -30; ++exponent) {
    const auto tiny = square(exact::from_double(std::ldexp(1, exponent)));
    EXPECT_EQ(exact::rounded_value(itself, tie + tiny).value, 0.5 + 0x1p-53);
    EXPECT_EQ(exact::rounded_value(itself, tie - tiny).value, 0.5);
  }
}

/// 2^383 and some more, with a last kept place of 1: less than 2^error is missing.
exact::Leading<6> with_error(std::int64_t error, std::initializer_list<int> bits, int low = 0) {
  exact::Leading<6> x;
  x.sign = 1;
  x.low = low;
  x.limb[5] = Limb{1} << 63;
  for (const int bit : bits) x.limb[bit / 64] |= Limb{1} << bit % 64;
  x.error = error == exact::Leading<6>::nothing ? error : error + std::int64_t{64} * low;
  return x;
}

TEST(Leading, RoundsSurelyWhereWhatIsMissingMakesNoDifference) {
  constexpr int place = 383 - 52, half = place - 1;  // the last place of a double, and half of it
  constexpr auto nothing = exact::Leading<6>::nothing;
  detail::arithmetic::Scaled out{7, 7};
  const auto surely = [&out](const exact::Leading<6>& x) { return exact::detail::rounds_surely(x, out); };
  EXPECT_TRUE(surely({}));
  EXPECT_EQ(out.value, 0);
  EXPECT_TRUE(surely(with_error(nothing, {half})));
  EXPECT_TRUE(out.value == 0.5 && out.exponent == 384) << "a tie goes to the even one";
  EXPECT_TRUE(surely(with_error(nothing, {half, 0})));
  EXPECT_TRUE(out.value == 0.5 + 0x1p-53 && out.exponent == 384);
  EXPECT_TRUE(surely(with_error(300, {place})));
  EXPECT_TRUE(out.value == 0.5 + 0x1p-53 && out.exponent == 384);
  EXPECT_FALSE(surely(with_error(383, {}))) << "not even the sign";
  EXPECT_FALSE(surely(with_error(-1, {}))) << "beyond the digits kept";
  for (const int low : {0, -7, 5, -1000}) {
    EXPECT_FALSE(surely(with_error(10, {half}, low))) << "up, with more";
    EXPECT_FALSE(surely(with_error(10, {half, 5}, low))) << "down, with less";
    EXPECT_TRUE(surely(with_error(10, {half, 12}, low))) << low;
    EXPECT_FALSE(surely(with_error(300, {half, 300}, low))) << "as much less";
    EXPECT_TRUE(surely(with_error(299, {half, 300}, low))) << low;
  }
}

/// The sum of eight numbers, asked in each of the ways in which leading digits may tell.
struct OfEight {
  static constexpr auto sum = [](const auto& x, const auto&... rest) { return (x + ... + rest); };

  template <class... Same>
  static void expect_positive(const Same&... x) {
    EXPECT_EQ(exact::sign_of(sum, x...), 1);
    EXPECT_GT(exact::rounded_value(sum, x...).value, 0);
  }
};

Number<8> eighth_power(double x) { return square(square(square(exact::from_double(x)))); }

/// Below 2^exponent, of some 40 limbs of any kind.
Number<8> dense(int exponent) {
  Number<8> sum;
  for (int i = 0; i < 6; ++i) sum = sum + eighth_power(std::ldexp(0x1.921fb54442d19p-1, exponent / 8 - 53 * i));
  return sum;
}

// Any of the numbers may be the one that is long, or none. It is 7 less than a sum of powers of two, and the others are
// 1: so what leads cancels, and the first digits to tell are those of the sum. Of a long sum more digits are tried.
TEST(Leading, EachNumberMayBeTheLongOne) {
  const Number<8> one = eighth_power(1), seven = one + one + one + one + one + one + one;
  const Number<8> far = eighth_power(0x1p-125), farther = eighth_power(0x1p-250), very_far = eighth_power(0x1p-500),
                  farthest = eighth_power(0x1p-1000);
  const Number<8> longest = farthest - seven;
  ASSERT_GT(longest.size, 96);
  const Number<8> dense_far = dense(-904) - seven, dense_farther = dense(-1704) - seven;
  for (const Number<8>& x : {dense_far, dense_farther}) ASSERT_TRUE(exact::detail::is_longer(x, exact::more_limbs));
  for (const Number<8>& x : {one, one + far, far - seven, far + far + far + very_far - seven, very_far - seven,
                             farther + farthest - seven, longest, dense_far, dense_farther}) {
    OfEight::expect_positive(x, one, one, one, one, one, one, one);
    OfEight::expect_positive(one, x, one, one, one, one, one, one);
    OfEight::expect_positive(one, one, x, one, one, one, one, one);
    OfEight::expect_positive(one, one, one, x, one, one, one, one);
    OfEight::expect_positive(one, one, one, one, x, one, one, one);
    OfEight::expect_positive(one, one, one, one, one, x, one, one);
    OfEight::expect_positive(one, one, one, one, one, one, x, one);
    OfEight::expect_positive(one, one, one, one, one, one, one, x);
  }
}

/// Limbs of any kind between `zeros` limbs that are 0 in pairs, and then `ones` that are all ones in pairs.
std::vector<Limb> runs_of(int zeros, int ones) {
  std::vector<Limb> limbs;
  for (int i = 0; i < zeros + ones; ++i) {
    const Limb filling = i < zeros ? 0 : ~Limb{0};
    limbs.insert(limbs.end(), {5, filling, filling});
  }
  limbs.push_back(5);
  return limbs;
}

// There is room for 48 runs, and for 256 limbs in them.
TEST(Sparse, OfFewRunsAndOfNoMoreLimbsThanThereIsRoomFor) {
  const auto is_sparse = [](const std::vector<Limb>& a) {
    exact::detail::Runs runs;
    return runs.set(a.data(), static_cast<int>(a.size()));
  };
  for (int zeros = 0; zeros < 60; ++zeros) {
    for (int ones = 0; ones < 60; ++ones) EXPECT_EQ(is_sparse(runs_of(zeros, ones)), zeros + ones + 1 <= 48);
  }
  // The last one is subtracted: above it the carry is one more.
  for (int zeros = 0; zeros < 60; ++zeros) {
    std::vector<Limb> limbs = runs_of(zeros, 0);
    limbs.insert(limbs.end(), 2, ~Limb{0});
    EXPECT_EQ(is_sparse(limbs), zeros + 2 <= 48);
  }
  EXPECT_TRUE(is_sparse(std::vector<Limb>(256, 5)));
  EXPECT_FALSE(is_sparse(std::vector<Limb>(257, 5)));
  std::vector<Limb> out(2000);
  const auto multiplied = [&out](const std::vector<Limb>& a, const std::vector<Limb>& b) {
    const auto span = [](const std::vector<Limb>& x) {
      return exact::detail::Span{x.data(), 0, static_cast<int>(x.size())};
    };
    return exact::detail::multiply_sparse(span(a), span(b), out.data());
  };
  const auto gap = [](std::size_t zeros) {
    std::vector<Limb> limbs(zeros + 2);
    limbs.front() = limbs.back() = 3;
    return limbs;
  };
  ASSERT_TRUE(multiplied(gap(547), gap(547)));
  EXPECT_TRUE(out[0] == 9 && out[548] == 18 && out[1096] == 9);
  EXPECT_FALSE(multiplied(gap(547), gap(548))) << "1,101 limbs";
  EXPECT_FALSE(multiplied(runs_of(48, 0), gap(40)));
  EXPECT_FALSE(multiplied(gap(40), runs_of(48, 0)));
}

TEST(Leading, ShortNumbersAreExact) {
  const exact::Leading<6> three(exact::integer(3)), four(exact::integer(4)), five(exact::integer(5));
  const exact::Leading<6> zero = square(three) + square(four) - square(five);
  EXPECT_EQ(zero.sign, 0);
  EXPECT_TRUE(zero.sign_is_certain());
}

/// Of as many limbs as are kept, or fewer, nothing is lost; of one more what is below is, unless it is 0.
TEST(Leading, NothingIsLostOfWhatFits) {
  constexpr int limbs = exact::few_limbs;
  for (int size = 1; size <= limbs + 2; ++size) {
    Number<4> x;
    x.sign = -1;
    x.size = size;
    for (int i = 0; i < size; ++i) x.limb[i] = Limb{3};
    const exact::Leading<limbs> leading(x);
    expect_within_bound(leading, value(x));
    EXPECT_EQ(leading.error == leading.nothing, size <= limbs) << size;
  }
}

/// Of right triangles, whose legs end on the rim of their hypotenuse, and beside them.
TEST(Leading, BeyondARim) {
  Random random(properties::seed());
  const auto any = [&random] {
    const auto length = [&] { return exact::from_double(std::ldexp(1 + random.unit(), random.integer(-1000, 1000))); };
    return random.chance(0.5) ? length() * length() : length() * length() - length() * length();
  };
  int on = 0, precise = 0;
  for (int i = 0; i < 2000 * properties::repeat(); ++i) {
    const Number<2> s = any(), t = any();
    Number<4> legs[] = {square(s) - square(t), exact::integer(2) * (s * t)}, radius = square(s) + square(t);
    if (random.chance(0.5)) std::swap(legs[0], legs[1]);
    const auto tiny = square(exact::from_double(std::ldexp(1 + random.unit(), random.integer(-500, 500))));
    if (random.chance(0.3)) radius = radius + tiny;
    if (random.chance(0.3)) legs[0] = legs[0] - tiny;
    const auto &x = legs[0], &y = legs[1];
    const exact::BeyondRim z(x, y, radius);
    const mpq_class truth = value(x) * value(x) + value(y) * value(y) - value(radius) * value(radius);
    EXPECT_EQ(value(z.value()), truth);
    const auto leading = z.leading();
    expect_within_bound(leading, truth);
    EXPECT_TRUE(leading.sign == sgn(truth) && leading.sign_is_certain()) << "seed " << properties::seed();
    EXPECT_EQ(exact::side_of_rim(x, y, radius), -sgn(truth)) << "seed " << properties::seed();
    (truth == 0 ? on : precise) += truth == 0 || leading.error < leading.top() - 100;
  }
  EXPECT_GT(on, 500 * properties::repeat());
  EXPECT_EQ(on + precise, 2000 * properties::repeat());
}

/// A number in these limbs; beyond them there is no zero.
Number<4> of_limbs(std::initializer_list<Limb> limbs) {
  Number<4> x;
  for (Limb& limb : x.limb) limb = 5;
  x.sign = 1;
  for (const Limb limb : limbs) x.limb[x.size++] = limb;
  return x;
}
constexpr Limb ones = ~Limb{0};

/// Limbs that are neither all zeros nor all ones, and none beyond the number's own.
TEST(Leading, DenseLimbs) {
  EXPECT_EQ(exact::detail::dense_limbs(of_limbs({1})), 1);
  EXPECT_EQ(exact::detail::dense_limbs(of_limbs({ones})), 0);
  EXPECT_EQ(exact::detail::dense_limbs(of_limbs({1, 0, 0, 2})), 2);
  EXPECT_EQ(exact::detail::dense_limbs(of_limbs({7, ones, ones - 1, 0, 1, ones})), 3);
}

/// 19 dense limbs in one run, or 7 runs of one limb.
TEST(Leading, FewLimbsInFewRunsAreSparse) {
  EXPECT_TRUE(exact::detail::is_sparse(Number<4>()));
  EXPECT_TRUE(exact::detail::is_sparse(of_limbs({1, 2, 3, 4, 5, 6, 7, 8, 9, 8, 7, 6, 5, 4, 3, 2, 1, 2, 3})));
  EXPECT_FALSE(exact::detail::is_sparse(of_limbs({1, 2, 3, 4, 5, 6, 7, 8, 9, 8, 7, 6, 5, 4, 3, 2, 1, 2, 3, 4})));
  EXPECT_TRUE(exact::detail::is_sparse(of_limbs({1, 0, 2, ones, 3, 0, 0, 4, ones, 5, ones, ones, 6, 0, 7})));
  EXPECT_FALSE(exact::detail::is_sparse(of_limbs({1, 0, 2, ones, 3, 0, 0, 4, ones, 5, ones, ones, 6, 0, 7, 8})));
}

/// Ellipses with numbers of wildly unlike exponents, of which many are alike: then much cancels.
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

/// Leading digits and digits from the top of what is the same for p(x) and p(t - 1), from either one.
template <class Polynomial>
void expect_invariant(const exact::ContactCubic& p, const mpq_class& truth) {
  const exact::detail::Coefficients plain = exact::detail::coefficients(p);
  const exact::detail::CubicAboutMinusOne about(p, false), exchanged(p, true);
  const auto expect = [&truth](const exact::detail::Coefficients& k) {
    expect_within_bound(Polynomial::few(k), truth);
    const auto told = Polynomial::told(k);
    expect_within_bound(told, truth);
    EXPECT_EQ(told.sign, sgn(truth)) << "seed " << properties::seed();
  };
  expect(plain);
  expect(about.coefficients());
  if (Polynomial::is_same_if_exchanged) expect(exchanged.coefficients());
  const auto leading = exact::detail::told_invariant<Polynomial>(p, Polynomial::few(plain));
  expect_within_bound(leading, truth);
  EXPECT_EQ(leading.sign, sgn(truth)) << "seed " << properties::seed();
}

/// The same of what is the same for the pencil about 0 and about -1.
template <class Polynomial>
void expect_of_pencil(const exact::detail::PencilParts& plain, const exact::detail::PencilParts& about,
                      const mpq_class& truth) {
  for (const exact::detail::PencilParts& e : {plain, about}) {
    expect_within_bound(Polynomial::few(e), truth);
    const auto told = exact::leading(Polynomial(e).told());
    expect_within_bound(told, truth);
    EXPECT_EQ(told.sign, sgn(truth)) << "seed " << properties::seed();
  }
  EXPECT_EQ(exact::detail::told_sign<Polynomial>(plain, about), sgn(truth)) << "seed " << properties::seed();
}
void expect_containment_of_pencil(const exact::ContactCubic& p) {
  const mpq_class d1 = value(p.d1), d2 = value(p.d2), mu = value(p.mu), slope = 2 * value(p.c2) - 3 * mu;
  const mpq_class delta = mu * mu - 4 * d1 * d2, turn = 3 * d1 - value(p.c1), rest = slope * mu + 2 * d2 * turn;
  const Number<8> determinant = p.d1 + p.d2 - p.mu, m1 = p.mu - exact::integer(2) * p.d2;
  const Number<8> exact_slope = exact::integer(2) * p.c2 - exact::integer(3) * p.mu;
  const Number<8> exact_turn = exact::integer(3) * p.d1 - p.c1;
  const exact::detail::CubicAboutMinusOne k(p, false);
  const Number<8> turn_about = exact::integer(3) * determinant - k.k1;
  const exact::detail::PencilParts plain{p.d1, p.mu, p.d2, exact_slope, exact_turn};
  const exact::detail::PencilParts about{determinant, m1, p.d2, exact_slope, turn_about};
  expect_of_pencil<exact::detail::Bend>(plain, about, slope * slope - 9 * delta);
  expect_of_pencil<exact::detail::Rise>(plain, about, (slope * slope * delta - rest * rest) / (4 * d2));
}

TEST(LongCubic, SignsAreThoseOfAllDigits) {
  using exact::detail::Discriminant;
  Random random(properties::seed());
  int certain = 0, not_certain = 0;
  for (int i = 0; i < 3000 * properties::repeat(); ++i) {
    const Ellipses e = any_ellipses(random);
    const exact::ContactCubic p = exact::contact_cubic(e.a, e.b);
    if (p.al.sign == 0 || !exact::is_long(p)) continue;
    const mpq_class d1 = value(p.d1), c1 = value(p.c1), c2 = value(p.c2), d2 = value(p.d2), mu = value(p.mu);
    const mpq_class a = c2 * c2 - 3 * d2 * c1, b = c1 * c2 - 9 * d1 * d2, c = c1 * c1 - 3 * d1 * c2;
    const mpq_class discriminant = (4 * a * c - b * b) / 3;
    expect_invariant<Discriminant>(p, discriminant);
    for (const auto& told : {Discriminant::by_digits(exact::detail::coefficients(p)),
                             Discriminant::whole(exact::detail::coefficients(p))}) {
      expect_within_bound(told, discriminant);
      EXPECT_EQ(told.sign, sgn(discriminant)) << "seed " << properties::seed();
    }
    EXPECT_EQ(exact::discriminant_sign(p), sgn(discriminant)) << "seed " << properties::seed();
    const mpq_class order = 2 * c2 * a - 3 * d2 * b;
    expect_invariant<exact::detail::DoubleRootOrder>(p, order);
    EXPECT_EQ(exact::double_root_is_greater(p), order > 0) << "seed " << properties::seed();
    EXPECT_EQ(exact::detail::short_discriminant_sign(p), sgn(discriminant)) << "seed " << properties::seed();

    expect_containment_of_pencil(p);
    const mpq_class delta = mu * mu - 4 * d1 * d2, slope = 2 * c2 - 3 * mu;
    const bool inside = exact::long_first_in_second(p);
    const mpq_class al = value(p.al), be = value(p.be);
    const int rising = sign_with_root(slope * mu + 2 * d2 * (3 * d1 - c1), slope, delta);
    const bool touches = rising == 0 && sign_with_root(2 * d2 * al - be * mu, -be, delta) == 0;
    const bool truth = slope > 0 && (sign_with_root(slope, -3, delta) > 0 || rising > 0 || touches);
    EXPECT_EQ(inside, truth) << "seed " << properties::seed();
    const exact::detail::CubicAboutMinusOne about(p, exact::compare(p.d1, p.d2) < 0);
    const bool few_tell = Discriminant::few(exact::detail::coefficients(p)).sign_is_certain() ||
                          Discriminant::few(about.coefficients()).sign_is_certain();
    (few_tell ? certain : not_certain) += 1;
  }
  // Few leading digits tell all but about one in thirty; digits from the top tell those, too.
  EXPECT_GT(certain, 10 * not_certain);
  EXPECT_GT(not_certain, 4 * properties::repeat());
  EXPECT_GT(certain, 1000 * properties::repeat());
}

/// Polynomials of ellipses of small whole numbers, of which every digit is a leading one: ties, and signs beside them.
TEST(LongCubic, OfSmallNumbers) {
  const Number<8> one = exact::square(exact::square(exact::square(exact::from_double(1.0))));
  const auto number = [&](int k) -> Number<8> { return exact::integer(k) * one; };
  const Number<4> root_of_one = exact::square(exact::square(exact::from_double(1.0)));
  const auto root = [&](int k) -> Number<4> { return exact::integer(k) * root_of_one; };
  int ties = 0, touching = 0, of_slope = 0, of_delta = 0;
  const auto expect = [&](int root1, int root2, int mu, int al, int be) {
    const int d1 = root1 * root1, d2 = root2 * root2;
    const int c1 = d1 + mu - al, c2 = d2 + mu - be, delta = mu * mu - 4 * d1 * d2, slope = 2 * c2 - 3 * mu;
    const exact::ContactCubic p{number(d1), number(c1), number(c2),  number(d2), number(mu),
                                number(al), number(be), root(root1), root(root2)};
    expect_containment_of_pencil(p);
    bool inside = false;
    const bool certain = exact::few_digits_tell_first_in_second(inside, p);
    const mpq_class rest = mpq_class(slope) * mu + mpq_class(2 * d2) * (3 * d1 - c1);
    EXPECT_LT(rest, 0);
    const int rising = sign_with_root(rest, slope, delta);
    const bool bends = sign_with_root(slope, -3, delta) > 0, tie = !bends && rising == 0;
    EXPECT_EQ(certain, !tie) << d1 << ' ' << d2 << ' ' << mu << ' ' << al << ' ' << be;
    EXPECT_EQ(inside, bends || rising > 0) << d1 << ' ' << d2 << ' ' << mu << ' ' << al << ' ' << be;
    // Digits tell a tie too: it is inside where q is 0 at its maximum.
    const bool touches = tie && sign_with_root(2 * d2 * al - be * mu, -be, delta) == 0;
    touching += touches;
    EXPECT_EQ(exact::more_digits_tell_first_in_second(p, p.d1 + p.d2 - p.mu), inside || touches);
    ties += tie;
    of_slope += slope == 0;
    of_delta += delta == 0;
  };
  // S1 = diag(s, t), S2 = diag(k, k), and an offset of squares x and y.
  for (int k = 1; k <= 24; ++k) {
    for (const int root1 : {1, 2, 3, 4, 6, 8, 10, 12}) {
      for (int s = root1; s <= k; ++s) {
        const int t = root1 * root1 / s;
        if (s * t != root1 * root1) continue;
        for (int x = 0; x < k; ++x) {
          for (int y = x == 0 ? 1 : 0; y < k; ++y) expect(root1, k, k * (s + t), t * x + s * y, k * (x + y));
        }
      }
    }
  }
  for (const int count : {ties, of_slope, of_delta}) EXPECT_GT(count, 20);
  for (const int count : {touching, ties - touching}) EXPECT_GT(count, 10);
}

// An ellipse in another about nearly one centre, and the other way round.
TEST(LongCubic, SurelyInside) {
  const Ellipse<double> lesser{0x1p-300, 0, 1, 0, 2, 1}, greater{0, 0x1p-200, 1, 0x1p-400, 3, 1.75};
  const auto inside = [](const Ellipse<double>& a, const Ellipse<double>& b) {
    const exact::ContactCubic p = exact::contact_cubic(exact::form(a), exact::form(b));
    return exact::detail::surely_inside(p, p.d1 + p.d2 - p.mu);
  };
  EXPECT_TRUE(inside(lesser, greater));
  EXPECT_FALSE(inside(greater, lesser));
}

// Of similar ellipses about nearly one centre the lesser is told to be inside, whatever the ratio of their sizes.
TEST(LongCubic, SurelyInsideASimilarOne) {
  Random random(properties::seed());
  const auto inside = [](const Ellipse<double>& a, const Ellipse<double>& b) {
    const exact::ContactCubic p = exact::contact_cubic(exact::form(a), exact::form(b));
    return exact::detail::surely_inside(p, p.d1 + p.d2 - p.mu);
  };
  for (int i = 0; i < 500 * properties::repeat(); ++i) {
    const double a = std::exp2(random.between(-4, 4)), b = std::exp2(random.between(-4, 4));
    const double share = std::exp2(-random.between(1, 40)), ratio = random.chance(0.5) ? share : 1 - share;
    // Exactly similar, as the axis alone is shorter.
    const Ellipse<double> lesser{0x1p-200, 0, ratio, 0, a, b}, greater{0, 0x1p-200, 1, 0, a, b};
    EXPECT_TRUE(inside(lesser, greater)) << ratio << ' ' << a << ' ' << b;
    EXPECT_FALSE(inside(greater, lesser)) << ratio << ' ' << a << ' ' << b;
  }
}

/// What is far below a tie breaks it, and what is far below a double is what that leaves.
TEST(LeadingDigits, OneThatIsFarBelow) {
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
TEST(Leading, RoundedOnceAndTwice) {
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
