// SPDX-License-Identifier: Apache-2.0
// How many trials find the time at which two ellipses begin to touch, which is known here: the discriminant is 0 there.
// A search that begins elsewhere, or closes otherwise, finds the same time by another number of trials: that is a
// reason to write other numbers here. Nothing is fused, so that they are the same everywhere.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vesica/cast/trial_search.hpp>

#include "properties/random.hpp"

namespace {

using namespace vesica::detail::cast;
using properties::Random;
using vesica::detail::arithmetic::Scaled;

constexpr double infinity = std::numeric_limits<double>::infinity(), largest = std::numeric_limits<double>::max();
constexpr int count = 64;

/// What a trial tells of the time: nothing but before or after; a value that falls straight through 0; one that falls
/// ever more steeply; one with a double zero, of either sign; one with a triple zero; one that has two zeros close
/// together; one that touches 0 and is not told after; the same with a zero of order 8; one of the first sort that is
/// not told far off either; one that falls to a tenth long before, as where shapes all but meet, and rises again.
enum class Form { none, straight, bent, twofold, triple, dipping, touching, flat, near_alone, near_miss };

Scaled scaled(double x, double unit) {
  int exponent;
  const double value = std::frexp(x / unit, &exponent);
  return {value, exponent};
}

Trial trial(Form form, double zero, double t) {
  const bool after = t > zero;
  const double left = (zero - t) / zero;  // exact enough: only where trials go depends on it
  const Trial of_side{true, after};
  const auto of_value = [&](double x) { return x == 0 ? of_side : Trial{true, after, true, scaled(x, 1)}; };
  switch (form) {
    case Form::none:
      return of_side;
    case Form::straight:
      return of_value(left);
    case Form::bent:
      return of_value(left * (1 + 100 * (t / zero)));
    case Form::twofold:
      return of_value(left * std::fabs(left));
    case Form::triple:
      return of_value(left * left * left);
    case Form::dipping:
      return left < -0x1p-44 ? of_side : of_value(left * (left + 0x1p-44));
    case Form::touching:
      return after ? of_side : of_value(left * left);
    case Form::flat:
      return after ? of_side : of_value(std::pow(left, 8));
    case Form::near_alone:
      return after || left > 0.25 ? of_side : of_value(left * left);
    default: {
      const double early = 0x1p30 * (t / zero);
      return of_value(left * (1 - 2 * early + early * early / 0.9));
    }
  }
}

/// Where a search begins: from nothing; from the time or a little before; from far before, and a start of no use; from
/// a start beside the time; from a witness that is about it, or far after.
enum class From { nothing, near, below, start, witness, far_witness };

/// Trials in all, to times of 2^-900 to 2^900 and to times about 1.
int trials(Form form, From from) {
  Random random(1);
  int asked = 0;
  for (int i = 0; i < count; ++i) {
    const int exponent = i % 2 == 0 ? random.integer(-900, 900) : random.integer(-2, 2);
    const double zero = std::ldexp(1 + random.unit(), exponent);
    const int bits = random.integer(1, 53);
    const double before = zero * (1 - std::ldexp(1, -bits));
    const double guess = from == From::near ? before : from == From::below ? std::ldexp(before, -bits) : 0;
    const double start = from == From::start   ? std::nextafter(zero, i % 4 < 2 ? infinity : 0.0)
                         : from == From::below ? 1
                                               : 0;
    const Between witness = from == From::witness       ? Between{before, 2 * zero - before}
                            : from == From::far_witness ? Between{4 * zero, 5 * zero}
                                                        : Between{infinity, infinity};
    const auto ask = [&](double t) {
      ++asked;
      return trial(form, zero, t);
    };
    EXPECT_EQ(TrialSearch(ask, trial(form, zero, 0)).floor(start, witness, guess), zero) << i;
  }
  return asked;
}

struct Expected {
  const char* name;
  Form form;
  std::array<int, 6> trials;  ///< from each
};

class TrialsOfEllipses : public testing::TestWithParam<Expected> {};

TEST_P(TrialsOfEllipses, FindTheTimeByAsMany) {
  const auto of = [](From from) { return trials(GetParam().form, from); };
  const std::array<int, 6> found{of(From::nothing), of(From::near),    of(From::below),
                                 of(From::start),   of(From::witness), of(From::far_witness)};
  EXPECT_EQ(found, GetParam().trials);
}

constexpr Expected all_expected[] = {
    {"none", Form::none, {4034, 2762, 4581, 352, 1782, 4030}},
    {"straight", Form::straight, {397, 346, 649, 192, 257, 334}},
    {"bent", Form::bent, {1092, 452, 1155, 192, 261, 655}},
    {"twofold", Form::twofold, {785, 542, 941, 192, 258, 687}},
    {"triple", Form::triple, {1030, 710, 1090, 192, 260, 789}},
    {"dipping", Form::dipping, {1913, 826, 1919, 192, 1341, 1959}},
    {"touching", Form::touching, {1837, 1215, 1867, 352, 1750, 1883}},
    {"flat", Form::flat, {2240, 1277, 2649, 352, 1781, 2144}},
    {"near_alone", Form::near_alone, {1992, 1215, 2524, 352, 1750, 1988}},
    {"near_miss", Form::near_miss, {1485, 622, 1621, 192, 261, 1450}},
};

INSTANTIATE_TEST_SUITE_P(Forms, TrialsOfEllipses, testing::ValuesIn(all_expected),
                         [](const auto& test) { return std::string(test.param.name); });

/// At the ends of the numbers there is one.
TEST(TrialsOfEllipses, AtTheEndsOfNumbers) {
  const Between none{infinity, infinity};
  const auto find = [&](double zero, double guess) {
    const auto ask = [zero](double t) { return trial(Form::none, zero, t); };
    return TrialSearch(ask, Trial{true, false}).floor(1, none, guess);
  };
  for (const double guess : {0.0, 0x1p-1074, 0.75, 0x1p1022, 0x1p1023}) {
    EXPECT_EQ(find(infinity, guess), infinity) << guess;
    EXPECT_EQ(find(0x1.8p1023, guess), 0x1.8p1023) << guess;
    EXPECT_EQ(find(0x1.ffffffffffffep1023, guess), 0x1.ffffffffffffep1023) << guess;
  }
  for (const double guess : {0.0, 0x1p-1074}) {
    EXPECT_EQ(find(0x1p-1074, guess), 0x1p-1074) << guess;
    EXPECT_EQ(find(0x1p-1073, guess), 0x1p-1073) << guess;
  }
  for (const double guess : {largest, 0x1.ffffffffffff0p1023}) EXPECT_EQ(find(infinity, guess), infinity) << guess;
  EXPECT_EQ(find(0, 0), 0);
  EXPECT_EQ(find(0x1.fffffffffffffp1022, 0), 0x1.fffffffffffffp1022);
}

}  // namespace
