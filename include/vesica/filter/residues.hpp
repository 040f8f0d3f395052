// SPDX-License-Identifier: Apache-2.0
/// Stored numbers as integers, for polynomials of degree 2. Of a like magnitude they have 63 bits, and products 128. Of others
/// the products' last 128 bits are kept: a polynomial that has nearly vanished has few digits, however long the numbers are.
/// Floating point has its leading digits, which tell how small it is, and its residue modulo 2^128 has the rest.
#pragma once

#include <bit>
#include <cstdint>
#include <vesica/exact/limbs.hpp>
#include <vesica/scalar.hpp>

namespace vesica::filter {

/// An integer modulo 2^128.
struct Residue128 {
  std::uint64_t low, high;

  /// A number with the sign of the integer of least magnitude that has this residue.
  VESICA_INLINE constexpr std::int64_t sign() const noexcept {
    return static_cast<std::int64_t>(high | std::uint64_t{low != 0});
  }
};

VESICA_INLINE constexpr Residue128 operator+(const Residue128& a, const Residue128& b) noexcept {
  const std::uint64_t low = a.low + b.low;
  return {low, a.high + b.high + (low < a.low)};
}
VESICA_INLINE constexpr Residue128 operator-(const Residue128& a, const Residue128& b) noexcept {
  return {a.low - b.low, a.high - b.high - (a.low < b.low)};
}
VESICA_INLINE constexpr Residue128 operator*(const Residue128& a, const Residue128& b) noexcept {
  const exact::detail::LimbPair product = exact::detail::multiply_add(a.low, b.low, 0, 0);
  return {product.low, product.high + a.low * b.high + a.high * b.low};
}

/// An integer of 64 bits, of either sign.
struct Integer64 {
  std::int64_t n;

  VESICA_INLINE constexpr Residue128 extended(int places) const noexcept {
    return {static_cast<std::uint64_t>(n) << places, static_cast<std::uint64_t>(n >> 32 >> (32 - places))};
  }
};

VESICA_INLINE constexpr Integer64 operator-(Integer64 a, Integer64 b) noexcept { return {a.n - b.n}; }
/// The product itself.
VESICA_INLINE constexpr Residue128 operator*(Integer64 a, Integer64 b) noexcept {
  const auto p = static_cast<std::uint64_t>(a.n), q = static_cast<std::uint64_t>(b.n);
  const exact::detail::LimbPair product = exact::detail::multiply_add(p, q, 0, 0);
  return {product.low,
          product.high - (static_cast<std::uint64_t>(a.n >> 63) & q) - (static_cast<std::uint64_t>(b.n >> 63) & p)};
}

/// Numbers as multiples of a power of two, G, chosen such that the greatest is from 2^(digits - 1) G to 2^digits G.
template <int digits>
class Unit {
 public:
  /// Whether all are finite, and the greatest is from 2^-300 to 2^300. Only then may numbers be made.
  VESICA_INLINE constexpr bool is_ordinary() const noexcept {
    return greatest_ >= 1023 - 300 && greatest_ <= 1023 + 300;
  }
  /// Whether all numbers so far were multiples of G.
  VESICA_INLINE constexpr bool holds() const noexcept { return lost_ == 0; }

 protected:
  template <class... X>
  VESICA_INLINE constexpr explicit Unit(X... stored) noexcept
      : greatest_(static_cast<int>(greatest((std::bit_cast<std::uint64_t>(stored) & magnitude_bits)...) >> 52)) {}

  /// 2^e G.
  VESICA_INLINE constexpr double scale(int e) const noexcept { return power(greatest_ - 1023 - digits + 1 + e); }
  /// 2^-e / G.
  VESICA_INLINE constexpr double inverse(int e) const noexcept { return power(1023 + digits - 1 - greatest_ - e); }

  /// The whole number nearest to x / (2^e G) towards 0; takes it away from x. Neither is rounded, nor is a scaled number,
  /// unless it is too small to count: then all of x is left.
  VESICA_INLINE constexpr std::int64_t take(double& x, int e) const noexcept {
    const auto whole = static_cast<std::int64_t>(x * inverse(e));
    x = x - static_cast<double>(whole) * scale(e);
    return whole;
  }
  VESICA_INLINE constexpr void lose(double x) noexcept { lost_ = lane::or_bits(lost_, x); }

 private:
  static constexpr std::uint64_t magnitude_bits = 0x7fffffffffffffffu;

  VESICA_INLINE static constexpr double power(int e) noexcept {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + e) << 52);
  }
  VESICA_INLINE static constexpr std::uint64_t greatest(std::uint64_t first) noexcept { return first; }
  template <class... E>
  VESICA_INLINE static constexpr std::uint64_t greatest(std::uint64_t first, std::uint64_t second, E... rest) noexcept {
    return greatest(first > second ? first : second, rest...);
  }

  int greatest_;  // the stored exponent of the greatest number
  double lost_ = 0;
};

/// For numbers of a like magnitude, as most are: differences are integers of 64 bits.
class NearUnit : public Unit<62> {
 public:
  using Number = Integer64;
  template <class... X>
  VESICA_INLINE constexpr explicit NearUnit(X... stored) noexcept : Unit(stored...) {}

  VESICA_INLINE constexpr Integer64 number(double x) noexcept {
    const std::int64_t whole = take(x, 0);
    lose(x);
    return {whole};
  }
};

/// For others.
class FarUnit : public Unit<86> {
 public:
  using Number = Residue128;
  template <class... X>
  VESICA_INLINE constexpr explicit FarUnit(X... stored) noexcept : Unit(stored...) {}

  VESICA_INLINE constexpr Residue128 number(double x) noexcept {
    const Integer64 upper{take(x, 32)}, lower{take(x, 0)};
    lose(x);
    return upper.extended(32) + lower.extended(0);
  }
};

}  // namespace vesica::filter
