// SPDX-License-Identifier: Apache-2.0
/// Logarithms that are accurate relative to the result, the same bits on every machine.
#pragma once

#include <vesica/arithmetic/scaled.hpp>

namespace vesica::detail::arithmetic {

/// x - log(1 + x) for -1/2 <= x <= 1, with a relative error of at most 8 u, also near 0.
///
/// With z = x / (2 + x), |z| <= 1/3, log(1 + x) is 2 (z + z^3 / 3 + z^5 / 5 + ...), and x - 2 z is x z. So the result
/// is z (x - 2 z^2 (1/3 + z^2 / 5 + ...)). The difference is more than 3/5 of x. The terms left out, from z^32 / 35 in
/// the brackets on, are below 2^-57 of the result.
inline double excess_over_log(double x) noexcept {
  const double z = x / (2 + x), w = z * z;
  double series = 1.0 / 33;
  constexpr double factors[] = {1.0 / 31, 1.0 / 29, 1.0 / 27, 1.0 / 25, 1.0 / 23, 1.0 / 21, 1.0 / 19, 1.0 / 17,
                                1.0 / 15, 1.0 / 13, 1.0 / 11, 1.0 / 9,  1.0 / 7,  1.0 / 5,  1.0 / 3};
  for (const double factor : factors) series = series * w + factor;
  return z * (x - 2 * w * series);
}

/// log(x) for a finite x >= 2^-1022, with a relative error of at most 2 u.
///
/// With x = (1 + f) 2^k, 3/4 <= 1 + f < 3/2, f is exact. k times the first part of log 2, of 37 digits, is exact too.
inline double log_of(double x) noexcept {
  constexpr double log2_high = 0x1.62e42fefap-1, log2_low = 0x1.cf79abc9e3b3ap-40;
  int exponent = exponent_of(x);
  double part = scale_far(x, -exponent);
  if (part < 0.75) part *= 2, --exponent;
  const double f = part - 1, k = exponent;
  return k * log2_high + (f - (excess_over_log(f) - k * log2_low));
}

/// log(1 + x) for x >= 0 that is finite, with a relative error of at most 4 u.
inline double log_of_1_plus(double x) noexcept { return x <= 0.5 ? x - excess_over_log(x) : log_of(1 + x); }

}  // namespace vesica::detail::arithmetic
