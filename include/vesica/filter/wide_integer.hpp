// SPDX-License-Identifier: Apache-2.0
/// Integers of a fixed number of 64-bit limbs, and stored numbers as multiples of a power of two. Nothing checks for
/// overflow: callers prove their ranges.
#pragma once

#include <bit>
#include <cstdint>
#include <vesica/exact/limbs.hpp>
#include <vesica/scalar.hpp>

namespace vesica::filter {

/// An integer in two's complement, least limb first.
template <int limbs>
struct Wide {
  std::uint64_t limb[static_cast<std::size_t>(limbs)];

  VESICA_INLINE constexpr bool is_negative() const noexcept { return limb[limbs - 1] >> 63 != 0; }
};

namespace limbs = exact::detail;

/// a + b + carry; `complement` is ~0 for a - b - 1 + carry.
template <int n>
VESICA_INLINE constexpr Wide<n> sum(const Wide<n>& a, const Wide<n>& b, std::uint64_t complement,
                                    std::uint64_t carry) noexcept {
  Wide<n> sum{};
#pragma GCC unroll 8
  for (int i = 0; i < n; ++i) {
    const limbs::LimbPair limb = limbs::add_limbs(a.limb[i], b.limb[i] ^ complement, carry);
    sum.limb[i] = limb.low;
    carry = limb.high;
  }
  return sum;
}
template <int n>
VESICA_INLINE constexpr Wide<n> operator+(const Wide<n>& a, const Wide<n>& b) noexcept {
  return sum(a, b, 0, 0);
}
/// a - b - less, where less is 0 or 1.
template <int n>
VESICA_INLINE constexpr Wide<n> difference(const Wide<n>& a, const Wide<n>& b, bool less) noexcept {
  return sum(a, b, ~std::uint64_t{0}, less ? 0 : 1);
}
template <int n>
VESICA_INLINE constexpr Wide<n> operator-(const Wide<n>& a, const Wide<n>& b) noexcept {
  return difference(a, b, false);
}

/// The product of two natural numbers.
template <int m, int n>
VESICA_INLINE constexpr Wide<m + n> product(const Wide<m>& a, const Wide<n>& b) noexcept {
  Wide<m + n> product{};
#pragma GCC unroll 8
  for (int i = 0; i < m; ++i) {
    std::uint64_t carry = 0;
#pragma GCC unroll 8
    for (int j = 0; j < n; ++j) {
      const limbs::LimbPair limb = limbs::multiply_add(a.limb[i], b.limb[j], product.limb[i + j], carry);
      product.limb[i + j] = limb.low;
      carry = limb.high;
    }
    product.limb[i + n] = carry;
  }
  return product;
}

/// a times 2^places for a natural number a and places >= 0. Limbs beyond `to` are lost.
template <int to, int from>
VESICA_INLINE constexpr Wide<to> shifted(const Wide<from>& a, int places) noexcept {
  Wide<to> result{};
#pragma GCC unroll 8
  for (int i = 0; i < (from < to ? from : to); ++i) result.limb[i] = a.limb[i];
  for (; places >= 64; places -= 64) {
#pragma GCC unroll 8
    for (int i = to - 1; i > 0; --i) result.limb[i] = result.limb[i - 1];
    result.limb[0] = 0;
  }
#pragma GCC unroll 8
  for (int i = to - 1; i >= 0; --i) {
    result.limb[i] = result.limb[i] << places | (i > 0 ? result.limb[i - 1] >> 1 >> (63 - places) : 0);
  }
  return result;
}

/// A vector of integers.
struct WideVector {
  std::int64_t x, y;
};

#if defined(__SIZEOF_INT128__)
__extension__ using Integer128 = __int128;
VESICA_INLINE constexpr Wide<2> magnitude(Integer128 a) noexcept {
  const Integer128 mask = a >> 127, positive = (a ^ mask) - mask;
  return {{static_cast<std::uint64_t>(positive), static_cast<std::uint64_t>(positive >> 64)}};
}
/// |a . b|, below 2^127.
VESICA_INLINE constexpr Wide<2> dot(const WideVector& a, const WideVector& b) noexcept {
  return magnitude(Integer128{a.x} * b.x + Integer128{a.y} * b.y);
}
#else
VESICA_INLINE constexpr Wide<2> signed_product(std::int64_t a, std::int64_t b) noexcept {
  const auto p = static_cast<std::uint64_t>(a), q = static_cast<std::uint64_t>(b);
  const limbs::LimbPair natural = limbs::multiply_add(p, q, 0, 0);
  return {{natural.low,
           natural.high - (static_cast<std::uint64_t>(a >> 63) & q) - (static_cast<std::uint64_t>(b >> 63) & p)}};
}
VESICA_INLINE constexpr Wide<2> dot(const WideVector& a, const WideVector& b) noexcept {
  const Wide<2> dot = signed_product(a.x, b.x) + signed_product(a.y, b.y);
  return dot.is_negative() ? Wide<2>{} - dot : dot;
}
#endif
/// |a x b|
VESICA_INLINE constexpr Wide<2> cross(const WideVector& a, const WideVector& b) noexcept { return dot({-a.y, a.x}, b); }

/// A power of two of which stored numbers shall be multiples, chosen by the sum of their magnitudes: that is from
/// 2^60 to 2^61 units. For the default floating-point environment.
class Unit {
 public:
  VESICA_INLINE constexpr explicit Unit(double sum) noexcept
      : exponent_(static_cast<int>(std::bit_cast<std::uint64_t>(sum) >> 52) - 1023 - 60), is_zero_(sum == 0) {
    usable_ = lane::either(is_zero_, lane::both(sum >= 0x1p-300, sum <= 0x1p300));
    if (is_zero_) exponent_ = 0;
  }

  /// True if all numbers are finite, and their sum is 0 or from 2^-300 to 2^300. Only then may numbers be made.
  VESICA_INLINE constexpr bool is_usable() const noexcept { return usable_; }
  /// True if all numbers are 0, which are multiples of any unit.
  VESICA_INLINE constexpr bool is_zero() const noexcept { return is_zero_; }
  /// log2 of the unit.
  VESICA_INLINE constexpr int exponent() const noexcept { return exponent_; }
  /// True if all numbers so far were multiples of the unit.
  VESICA_INLINE constexpr bool divides() const noexcept { return divides_; }

  /// x in units. No product is rounded, unless x is too small to count.
  VESICA_INLINE constexpr std::int64_t number(double x) noexcept {
    const auto whole = static_cast<std::int64_t>(x * power(-exponent_));
    divides_ = lane::both(divides_, static_cast<double>(whole) * power(exponent_) == x);
    return whole;
  }

 private:
  VESICA_INLINE static constexpr double power(int e) noexcept {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + e) << 52);
  }

  int exponent_;
  bool is_zero_, usable_, divides_ = true;
};

}  // namespace vesica::filter
