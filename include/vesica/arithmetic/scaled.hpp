// SPDX-License-Identifier: Apache-2.0
/// Powers of two, and numbers of any magnitude: a double and a power of two that is kept apart from it until the end.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <vesica/scalar.hpp>

namespace vesica::detail::arithmetic {

/// value * 2^exponent.
struct Scaled {
  double value;
  int exponent;
};

/// 2^exponent for an exponent of at most +-1000.
constexpr double power_of_two(int exponent) noexcept {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}

/// x * 2^exponent: one rounding, and any exponent, for x in [2^-20, 2^20] or 0; for any other x an exponent of at
/// most +-2000, and results below 2^-1022 may be rounded twice. Unlike the C library's ldexp it leaves errno alone.
constexpr double scale(double x, int exponent) noexcept {
  const int clamped = exponent < -2000 ? -2000 : exponent > 2000 ? 2000 : exponent;
  return x * power_of_two(clamped / 2) * power_of_two(clamped - clamped / 2);
}

/// The same for any x and an exponent of at most +-4000: from one end of the range of double to the other and beyond.
inline double scale_far(double x, int exponent) noexcept {
  return scale(scale(x, exponent / 2), exponent - exponent / 2);
}

/// The exponent e with 2^(e-1) <= |x| < 2^e; 0 for 0.
inline int exponent_of(double x) noexcept {
  int exponent;
  std::frexp(x, &exponent);
  return exponent;
}

/// (high + low) * 2^exponent, rounded once also where the result is subnormal. high is the double nearest to the sum.
inline double scale_rounded(double high, double low, int exponent) noexcept {
  if (high == 0 || exponent_of(high) + exponent >= -1021) return scale_far(high, exponent);
  const double quanta = scale_far(high, exponent + 1074), left = scale_far(low, exponent + 1074);
  const double whole = (quanta + 0x1.8p52) - 0x1.8p52, rest = quanta - whole;
  // How far beyond half a quantum: near it this is exact, however little `left` is.
  const double above = (rest - 0.5) + left, below = (rest + 0.5) + left;
  const bool odd = std::fmod(whole, 2.0) != 0;
  const double up = above > 0 || (above == 0 && odd) ? 1 : 0, down = below < 0 || (below == 0 && odd) ? 1 : 0;
  return scale_far(whole + (up - down), -1074);
}

}  // namespace vesica::detail::arithmetic
