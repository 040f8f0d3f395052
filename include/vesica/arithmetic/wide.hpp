// SPDX-License-Identifier: Apache-2.0
/// Doubles whose exponents have no bounds, for searches over many magnitudes. Operations round about as double's.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <vesica/arithmetic/scaled.hpp>

namespace vesica::detail::arithmetic {

/// value * 2^exponent; value is 0, or between 1 and 2 in magnitude.
struct Wide {
  double value = 0;
  int exponent = 0;

  constexpr Wide() noexcept = default;
  /// For a normal x, or 0.
  constexpr Wide(double x, int scale) noexcept {
    if (x == 0) return;
    constexpr std::uint64_t field = std::uint64_t{0x7ff} << 52, of_one = std::uint64_t{0x3ff} << 52;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    value = std::bit_cast<double>((bits & ~field) | of_one);
    exponent = scale + static_cast<int>((bits & field) >> 52) - 1023;
  }
  constexpr explicit Wide(const Scaled& x) noexcept : Wide(x.value, x.exponent) {}

  constexpr int sign() const noexcept { return value > 0 ? 1 : value < 0 ? -1 : 0; }
};

constexpr Wide operator-(const Wide& a) noexcept { return {-a.value, a.exponent}; }
constexpr Wide operator*(const Wide& a, const Wide& b) noexcept { return {a.value * b.value, a.exponent + b.exponent}; }
constexpr Wide operator/(const Wide& a, const Wide& b) noexcept { return {a.value / b.value, a.exponent - b.exponent}; }
constexpr Wide operator+(const Wide& a, const Wide& b) noexcept {
  if (a.value == 0 || b.value == 0) return a.value == 0 ? b : a;
  if (a.exponent < b.exponent) return b + a;
  const int way = a.exponent - b.exponent;
  return way > 60 ? a : Wide(a.value + b.value * power_of_two(-way), a.exponent);
}
constexpr Wide operator-(const Wide& a, const Wide& b) noexcept { return a + -b; }
constexpr bool operator<(const Wide& a, const Wide& b) noexcept { return (a - b).value < 0; }
constexpr Wide square(const Wide& a) noexcept { return a * a; }
inline Wide root(const Wide& a) noexcept {
  const int odd = a.exponent & 1;
  return {std::sqrt(odd != 0 ? 2 * a.value : a.value), (a.exponent - odd) / 2};
}
constexpr Wide abs(const Wide& a) noexcept { return {a.value < 0 ? -a.value : a.value, a.exponent}; }

}  // namespace vesica::detail::arithmetic
