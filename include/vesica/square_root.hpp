// SPDX-License-Identifier: Apache-2.0
/// The square root in constant expressions, where the C library's cannot be called. Correctly rounded, so the bits are
/// those of the processor's.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace vesica::detail {

/// The integer part of sqrt(m * 2^54), for an m below 2^54; digit by digit.
constexpr std::uint64_t integer_root(std::uint64_t m) noexcept {
  std::uint64_t root = 0, rest = 0;
  for (int i = 53; i >= 0; --i) {
    const std::uint64_t next_two_bits = i >= 27 ? m >> (2 * i - 54) & 3 : 0, trial = root << 2 | 1;
    rest = rest << 2 | next_two_bits;
    const bool fits = rest >= trial;
    if (fits) rest -= trial;
    root = root << 1 | (fits ? 1 : 0);
  }
  return root;
}

/// The double nearest to the square root; NaN of a number below 0.
constexpr double square_root(double x) noexcept {
  using Limits = std::numeric_limits<double>;
  if (x == 0 || x == Limits::infinity()) return x;
  if (!(x > 0)) return Limits::quiet_NaN();
  // x = m 2^e, e even, m in [2^52, 2^54).
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int stored = static_cast<int>(bits >> 52);
  std::uint64_t m = stored == 0 ? bits : (bits & 0xfffffffffffffu) | 0x10000000000000u;
  int e = (stored == 0 ? 1 : stored) - 1075;
  const int lift = std::countl_zero(m) - 11, odd = (e - lift) & 1;
  m <<= lift + odd;
  e -= lift + odd;
  // 54 bits: the last one rounds. A tie cannot be: the square of an odd number is odd, and m 2^54 is not.
  const std::uint64_t rounded = (integer_root(m) + 1) >> 1;
  const int exponent = e / 2 - 26;  // sqrt(x) is rounded 2^exponent, a normal number
  return std::bit_cast<double>((static_cast<std::uint64_t>(exponent + 1075) << 52) + (rounded - 0x10000000000000u));
}

/// The same among floats: twice their digits and two more leave nothing to round twice.
constexpr float square_root(float x) noexcept { return static_cast<float>(square_root(static_cast<double>(x))); }

}  // namespace vesica::detail
