// SPDX-License-Identifier: Apache-2.0
/// Numbers modulo 2^128. A polynomial of stored numbers that has nearly vanished has few digits, however long the numbers
/// are: floating point has its leading digits, which tell how small it is, and integers modulo 2^128 have its last ones.
/// Together they are the value, exactly, with its sign.
#pragma once

#include <bit>
#include <cstdint>
#include <vesica/exact/limbs.hpp>
#include <vesica/scalar.hpp>

namespace vesica::filter {

/// An integer modulo 2^128.
struct Residue {
  std::uint64_t low, high;

  /// Of the integer of least magnitude that has this residue.
  constexpr int sign() const noexcept { return static_cast<std::int64_t>(high) < 0 ? -1 : (low | high) != 0; }
  constexpr bool operator==(const Residue&) const = default;
};

VESICA_INLINE constexpr Residue operator+(const Residue& a, const Residue& b) noexcept {
  const std::uint64_t low = a.low + b.low;
  return {low, a.high + b.high + (low < a.low)};
}
VESICA_INLINE constexpr Residue operator-(const Residue& a, const Residue& b) noexcept {
  return {a.low - b.low, a.high - b.high - (a.low < b.low)};
}
VESICA_INLINE constexpr Residue operator*(const Residue& a, const Residue& b) noexcept {
  const exact::detail::LimbPair product = exact::detail::multiply_add(a.low, b.low, 0, 0);
  return {product.low, product.high + a.low * b.high + a.high * b.low};
}

/// The greatest power of two, G = 2^g, of which all numbers are multiples, and the numbers in units of it.
class Unit {
 public:
  template <class... X>
  VESICA_INLINE constexpr explicit Unit(X... stored) noexcept : exponent_(least(lowest_place(stored)...)) {}

  /// Whether numbers are of a magnitude at which no product of two of their differences underflows.
  VESICA_INLINE constexpr bool is_ordinary() const noexcept { return exponent_ >= -400 && exponent_ <= 400; }

  /// 2^e G^2, for an ordinary unit and |e| <= 200.
  VESICA_INLINE constexpr double of_degree_2(int e) const noexcept {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + e + 2 * exponent_) << 52);
  }

  /// x / G.
  VESICA_INLINE constexpr Residue operator()(double x) const noexcept {
    const std::uint64_t digits = digits_of(x) >> std::countr_zero(digits_of(x));
    const int places = lowest_place(x) - exponent_;
    const Residue magnitude = moved(digits, places);
    return std::bit_cast<std::uint64_t>(x) >> 63 ? Residue{0, 0} - magnitude : magnitude;
  }

 private:
  static constexpr int least(int first) noexcept { return first; }
  template <class... E>
  static constexpr int least(int first, int second, E... rest) noexcept {
    return least(first < second ? first : second, rest...);
  }
  /// Of a number that is neither 0 nor subnormal.
  VESICA_INLINE static constexpr std::uint64_t digits_of(double x) noexcept {
    return (std::bit_cast<std::uint64_t>(x) & 0xfffffffffffffu) | std::uint64_t{1} << 52;
  }
  /// The exponent of the last digit that is not 0. Zeros have none, and places beyond 128 are 0 to a residue; a subnormal
  /// number comes out below -1000, which is not ordinary.
  VESICA_INLINE static constexpr int lowest_place(double x) noexcept {
    const auto exponent = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff);
    return x == 0 ? 4000 : exponent - 1075 + std::countr_zero(digits_of(x));
  }
  /// n 2^places modulo 2^128.
  VESICA_INLINE static constexpr Residue moved(std::uint64_t n, int places) noexcept {
    if (places < 64) return {n << places, n >> 1 >> (63 - places)};
    return {0, places < 128 ? n << (places - 64) : 0};
  }

  int exponent_;
};

}  // namespace vesica::filter
