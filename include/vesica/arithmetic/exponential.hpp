// SPDX-License-Identifier: Apache-2.0
/// exp(-x), the same bits on every machine: the mathematics libraries differ in the last place.
#pragma once

#include <vesica/arithmetic/error_free.hpp>
#include <vesica/arithmetic/scaled.hpp>

namespace vesica::detail::arithmetic {

/// exp(-(high + low)) for high >= 0 and |low| a rounding of it: right to 1 unit in its last place, and 0 or the least
/// number where it is below that.
///
/// With k the whole number nearest to x / log 2 and x = k log 2 - r, |r| < 0.347, the result is exp(r) 2^-k. k times
/// the first part of log 2, of 37 digits, is exact, and so is its difference from `high`. Rounding the rest leaves less
/// than 2^-60 in r. The series up to r^13 / 13! leaves less than 2^-57; its terms from r^2 / 2 <= 0.061 on are rounded
/// to less than a quarter of a unit together, and the last two sums to little more than half a one.
inline double exp_of_minus(double high, double low) noexcept {
  if (!(high < 746)) return 0;
  constexpr double log2_high = 0x1.62e42fefap-1, log2_low = 0x1.cf79abc9e3b3ap-40;
  constexpr double rounder = 0x1.8p52;
  const double k = (high * 0x1.71547652b82fep0 + rounder) - rounder;
  const double whole = k * log2_high - high;
  const Pair<double> r = two_sum(whole, k * log2_low - low);
  const double x = r.high;
  double series = 1.0 / 6227020800.0;
  constexpr double factors[] = {1.0 / 479001600.0,
                                1.0 / 39916800.0,
                                1.0 / 3628800.0,
                                1.0 / 362880.0,
                                1.0 / 40320.0,
                                1.0 / 5040.0,
                                1.0 / 720.0,
                                1.0 / 120.0,
                                1.0 / 24.0,
                                1.0 / 6.0,
                                0.5};
  for (const double factor : factors) series = series * x + factor;
  const Pair<double> sum = two_sum(1.0, x);
  const double value = sum.high + (sum.low + (r.low + x * x * series));
  return scale(value, -static_cast<int>(k));
}

/// 1 - exp(-x) for x >= 0, with a relative error of at most 4 u, also near 0.
///
/// Below 1/2 the series up to x^16 / 16! leaves less than 2^-60. Its terms from the second on are less than a quarter.
inline double one_minus_exp_of_minus(double x) noexcept {
  if (x >= 0.5) return 1 - exp_of_minus(x, 0);
  double series = 1;
  for (int k = 16; k >= 2; --k) series = 1 - x * series / k;
  return x * series;
}

}  // namespace vesica::detail::arithmetic
