// SPDX-License-Identifier: Apache-2.0
/// Stored numbers as integers, for polynomials of degree 2. Numbers of like magnitude have 63 bits, and their products
/// fit 128. Of other products only the last 128 bits are kept. A polynomial that has nearly vanished has few digits,
/// however long its numbers are: floating point shows that it is small, and its residue modulo 2^128 then tells it.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vesica/exact/limbs.hpp>
#include <vesica/scalar.hpp>

namespace vesica::filter {

/// Whether contacts are decided by the longer of such integers too, FarUnit and those of axes.hpp. WebAssembly has no
/// product of 64 by 64 bits, and its modules are downloaded: there the exact stage decides what the shorter ones leave.
#if defined(__wasm__)
inline constexpr bool has_wide_products = false;
#else
inline constexpr bool has_wide_products = true;
#endif

/// An integer modulo 2^128.
struct Residue128 {
  std::uint64_t low, high;

  /// A number with the sign of the integer of least magnitude that has this residue.
  VESICA_INLINE constexpr std::int64_t sign() const noexcept {
    return static_cast<std::int64_t>(high | std::uint64_t{low != 0});
  }
  VESICA_INLINE constexpr bool is_negative() const noexcept { return high >> 63 != 0; }
  /// By less than 64 places.
  VESICA_INLINE constexpr Residue128 shifted(int places) const noexcept {
    return {low << places, high << places | low >> 1 >> (63 - places)};
  }
  /// The magnitude of the integer of least magnitude that has this residue.
  VESICA_INLINE constexpr Residue128 magnitude() const noexcept;
};

// Where the compiler knows of 128 bits it has instructions that carry.
#if defined(__SIZEOF_INT128__)
namespace wide {
__extension__ using Integer = __int128;
__extension__ using Natural = unsigned __int128;
VESICA_INLINE constexpr Natural of(const Residue128& a) noexcept { return Natural{a.high} << 64 | a.low; }
VESICA_INLINE constexpr Residue128 residue(Natural n) noexcept {
  return {static_cast<std::uint64_t>(n), static_cast<std::uint64_t>(n >> 64)};
}
}  // namespace wide
VESICA_INLINE constexpr Residue128 operator+(const Residue128& a, const Residue128& b) noexcept {
  return wide::residue(wide::of(a) + wide::of(b));
}
VESICA_INLINE constexpr Residue128 operator-(const Residue128& a, const Residue128& b) noexcept {
  return wide::residue(wide::of(a) - wide::of(b));
}
VESICA_INLINE constexpr bool is_less(const Residue128& a, const Residue128& b) noexcept {
  return wide::of(a) < wide::of(b);
}
VESICA_INLINE constexpr Residue128 Residue128::magnitude() const noexcept {
  const auto n = static_cast<wide::Integer>(wide::of(*this)), mask = n >> 127;
  return wide::residue(static_cast<wide::Natural>((n ^ mask) - mask));
}
#else
VESICA_INLINE constexpr Residue128 operator+(const Residue128& a, const Residue128& b) noexcept {
  const std::uint64_t low = a.low + b.low;
  return {low, a.high + b.high + (low < a.low)};
}
VESICA_INLINE constexpr Residue128 operator-(const Residue128& a, const Residue128& b) noexcept {
  return {a.low - b.low, a.high - b.high - (a.low < b.low)};
}
VESICA_INLINE constexpr Residue128 Residue128::magnitude() const noexcept {
  const std::uint64_t mask = std::uint64_t{0} - (high >> 63);
  return Residue128{low ^ mask, high ^ mask} - Residue128{mask, mask};
}
VESICA_INLINE constexpr bool is_less(const Residue128& a, const Residue128& b) noexcept {
  return a.high != b.high ? a.high < b.high : a.low < b.low;
}
#endif
VESICA_INLINE constexpr Residue128 operator*(const Residue128& a, const Residue128& b) noexcept {
  const exact::detail::LimbPair product = exact::detail::multiply_add(a.low, b.low, 0, 0);
  return {product.low, product.high + a.low * b.high + a.high * b.low};
}
/// An integer modulo 2^256.
struct Residue256 {
  Residue128 low, high;

  VESICA_INLINE constexpr bool is_negative() const noexcept { return high.is_negative(); }
};

VESICA_INLINE constexpr Residue256 operator+(const Residue256& a, const Residue256& b) noexcept {
  const Residue128 low = a.low + b.low;
  return {low, a.high + b.high + Residue128{is_less(low, a.low), 0}};
}
VESICA_INLINE constexpr Residue256 operator-(const Residue256& a, const Residue256& b) noexcept {
  return {a.low - b.low, a.high - b.high - Residue128{is_less(a.low, b.low), 0}};
}

/// Of natural numbers.
VESICA_INLINE constexpr bool operator<=(const Residue256& a, const Residue256& b) noexcept {
  if (a.high.high != b.high.high || a.high.low != b.high.low) return is_less(a.high, b.high);
  return !is_less(b.low, a.low);
}

// Products of natural numbers.
VESICA_INLINE constexpr Residue128 product(std::uint64_t a, std::uint64_t b) noexcept {
  const exact::detail::LimbPair product = exact::detail::multiply_add(a, b, 0, 0);
  return {product.low, product.high};
}
VESICA_INLINE constexpr Residue256 product(const Residue128& a, const Residue128& b) noexcept {
  using exact::detail::LimbPair;
  using exact::detail::multiply_add;
  const LimbPair low = multiply_add(a.low, b.low, 0, 0), across = multiply_add(a.low, b.high, low.high, 0);
  const LimbPair other = multiply_add(a.high, b.low, across.low, 0);
  const LimbPair high = multiply_add(a.high, b.high, across.high, other.high);
  return {{low.low, other.low}, {high.low, high.high}};
}
/// Of a number below 2^127.
VESICA_INLINE constexpr Residue256 square(const Residue128& a) noexcept {
  const Residue128 low = product(a.low, a.low), across = product(a.low, a.high << 1), high = product(a.high, a.high);
  return Residue256{low, high} + Residue256{{0, across.low}, {across.high, 0}};
}

/// An integer of 64 bits, of either sign.
struct Integer64 {
  std::int64_t n;

  VESICA_INLINE constexpr Residue128 extended(int places) const noexcept {
    return {static_cast<std::uint64_t>(n) << places, static_cast<std::uint64_t>(n >> 32 >> (32 - places))};
  }
  VESICA_INLINE constexpr Integer64 magnitude() const noexcept { return {n < 0 ? -n : n}; }
};

VESICA_INLINE constexpr Integer64 operator+(Integer64 a, Integer64 b) noexcept { return {a.n + b.n}; }
VESICA_INLINE constexpr Integer64 operator-(Integer64 a, Integer64 b) noexcept { return {a.n - b.n}; }
/// The product itself.
VESICA_INLINE constexpr Residue128 operator*(Integer64 a, Integer64 b) noexcept {
#if defined(__SIZEOF_INT128__)
  return wide::residue(static_cast<wide::Natural>(wide::Integer{a.n} * b.n));
#else
  const auto p = static_cast<std::uint64_t>(a.n), q = static_cast<std::uint64_t>(b.n);
  const exact::detail::LimbPair product = exact::detail::multiply_add(p, q, 0, 0);
  return {product.low,
          product.high - (static_cast<std::uint64_t>(a.n >> 63) & q) - (static_cast<std::uint64_t>(b.n >> 63) & p)};
#endif
}

/// Numbers as multiples of a power of two, G, chosen such that their absolute values, summed and rounded, are from
/// 2^(digits - 1) G to 2^digits G. So any of them differ by less than 2^(digits + 1) G.
template <int digits>
class Unit {
 public:
  /// Whether all are finite, and their sum is from 2^-300 to 2^300. Only then may numbers be made.
  VESICA_INLINE constexpr bool is_ordinary() const noexcept {
    return exponent_ >= 1023 - 300 && exponent_ <= 1023 + 300;
  }
  /// log2 G.
  VESICA_INLINE constexpr int exponent() const noexcept { return exponent_ - 1023 - digits + 1; }
  /// Makes G at least 2^least.
  VESICA_INLINE constexpr void raise(int least) noexcept {
    const int exponent = least + 1023 + digits - 1;
    exponent_ = exponent_ > exponent ? exponent_ : exponent;
  }
  /// Whether all numbers so far were multiples of G.
  VESICA_INLINE constexpr bool holds() const noexcept { return lost_ == 0; }

 protected:
  template <class... X>
  VESICA_INLINE constexpr explicit Unit(X... stored) noexcept
      : exponent_(static_cast<int>(std::bit_cast<std::uint64_t>(sum(lane::abs(stored)...)) >> 52)) {}

  /// 2^e G.
  VESICA_INLINE constexpr double scale(int e) const noexcept { return power(exponent_ - 1023 - digits + 1 + e); }
  /// 2^-e / G.
  VESICA_INLINE constexpr double inverse(int e) const noexcept { return power(1023 + digits - 1 - exponent_ - e); }

  /// The whole number nearest to x / (2^e G) towards 0; takes it away from x. Neither is rounded, nor is a scaled
  /// number, unless it is too small to count: then all of x is left.
  VESICA_INLINE constexpr std::int64_t take(double& x, int e) const noexcept {
    const auto whole = static_cast<std::int64_t>(x * inverse(e));
    x = x - static_cast<double>(whole) * scale(e);
    return whole;
  }
  VESICA_INLINE constexpr void lose(double x) noexcept { lost_ = lane::or_bits(lost_, x); }

 private:
  VESICA_INLINE static constexpr double power(int e) noexcept {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + e) << 52);
  }
  /// By pairs: no sum waits for all others.
  VESICA_INLINE static constexpr double sum(double first) noexcept { return first; }
  template <class... X>
  VESICA_INLINE static constexpr double sum(double first, double second, X... rest) noexcept {
    return sum(rest..., first + second);
  }

  int exponent_;  // of the sum, as it is stored
  double lost_ = 0;
};

/// For numbers of a like magnitude, as most are: each is an integer of 64 bits.
template <int digits>
class UnitOf64 : public Unit<digits> {
 public:
  using Number = Integer64;
  template <class... X>
  VESICA_INLINE constexpr explicit UnitOf64(X... stored) noexcept : Unit<digits>(stored...) {}

  VESICA_INLINE constexpr Integer64 number(double x) noexcept {
    const std::int64_t whole = this->take(x, 0);
    this->lose(x);
    return {whole};
  }
};

/// Differences have 64 bits too.
using NearUnit = UnitOf64<62>;

template <std::size_t n>
struct Numbers {
  double x[n];
};
template <class... X>
Numbers(X...) -> Numbers<sizeof...(X)>;

/// The same where numbers are checked together, at first: most are so large that one look at the least of them tells.
template <int digits>
class UnitOfAll : public Unit<digits> {
 public:
  template <std::size_t n>
  VESICA_INLINE constexpr explicit UnitOfAll(const Numbers<n>& stored) noexcept
      : UnitOfAll(stored, std::make_index_sequence<n>()) {}

  /// Of a multiple of G that counted.
  VESICA_INLINE constexpr Integer64 number(double x) const noexcept { return {this->take(x, 0)}; }
  /// Whether all these are multiples of G. A number of at least 2^52 G is, as it has 53 digits.
  template <std::size_t n>
  VESICA_INLINE constexpr bool divides(const Numbers<n>& stored) const noexcept {
    return divides(stored, std::make_index_sequence<n>());
  }

 private:
  template <std::size_t n, std::size_t... i>
  VESICA_INLINE constexpr UnitOfAll(const Numbers<n>& stored, std::index_sequence<i...>) noexcept
      : Unit<digits>(stored.x[i]...) {}

  template <std::size_t n, std::size_t... i>
  VESICA_INLINE constexpr bool divides(const Numbers<n>& stored, std::index_sequence<i...>) const noexcept {
    double least = std::numeric_limits<double>::max(), lost = 0;
    ((least = lane::min(lane::abs(stored.x[i]), least)), ...);
    if (least >= this->scale(52)) return true;
    ((lost = lane::or_bits(lost, rest(stored.x[i]))), ...);
    return lost == 0;
  }
  VESICA_INLINE constexpr double rest(double x) const noexcept {
    this->take(x, 0);
    return x;
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
