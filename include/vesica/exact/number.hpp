// SPDX-License-Identifier: Apache-2.0
/// Exact arithmetic for the few questions that filters leave open. A number is a sign and a magnitude in 64-bit limbs,
/// scaled by a whole number of limbs. There is no heap, no overflow and no underflow: each type carries the degree of
/// the polynomial that its numbers are values of, and the degree bounds the storage that such a value can need.
#pragma once

#include <bit>
#include <cassert>
#include <cstdint>
#include <cstring>

namespace vesica::exact {

/// Limbs are 64 bits: value = sum of limb[i] * 2^(64 (low + i)).
using Limb = std::uint64_t;

namespace detail {

struct LimbPair {
  Limb low, high;
};

/// a * b + c + d, which cannot overflow two limbs.
inline LimbPair multiply_add(Limb a, Limb b, Limb c, Limb d) noexcept {
#if defined(__SIZEOF_INT128__)
  __extension__ using Wide = unsigned __int128;
  const Wide sum = Wide{a} * b + c + d;
  return {static_cast<Limb>(sum), static_cast<Limb>(sum >> 64)};
#else
  constexpr Limb half = 0xffffffffu;
  const Limb low_low = (a & half) * (b & half), low_high = (a & half) * (b >> 32);
  const Limb high_low = (a >> 32) * (b & half), high_high = (a >> 32) * (b >> 32);
  const Limb middle = (low_low >> 32) + (low_high & half) + (high_low & half);
  LimbPair sum{(middle << 32) | (low_low & half), high_high + (low_high >> 32) + (high_low >> 32) + (middle >> 32)};
  sum.low += c;
  sum.high += sum.low < c;
  sum.low += d;
  sum.high += sum.low < d;
  return sum;
#endif
}

/// out[0, na + nb) = a * b, schoolbook. Zero limbs of a are skipped.
inline void multiply(const Limb* a, int na, const Limb* b, int nb, Limb* out) noexcept {
  for (int i = 0; i < na + nb; ++i) out[i] = 0;
  for (int i = 0; i < na; ++i) {
    if (a[i] == 0) continue;
    Limb carry = 0;
    for (int j = 0; j < nb; ++j) {
      const LimbPair sum = multiply_add(a[i], b[j], out[i + j], carry);
      out[i + j] = sum.low;
      carry = sum.high;
    }
    out[i + nb] = carry;
  }
}

/// out[0, 2 n) = a * a: products of different limbs once, doubled, and the squares.
inline void multiply_by_itself(const Limb* a, int n, Limb* out) noexcept {
  for (int i = 0; i < 2 * n; ++i) out[i] = 0;
  for (int i = 0; i < n; ++i) {
    if (a[i] == 0) continue;
    Limb carry = 0;
    for (int j = i + 1; j < n; ++j) {
      const LimbPair sum = multiply_add(a[i], a[j], out[i + j], carry);
      out[i + j] = sum.low;
      carry = sum.high;
    }
    out[i + n] = carry;
  }
  Limb carry = 0, shifted_out = 0;
  for (int i = 0; i < n; ++i) {
    const Limb low = out[2 * i] << 1 | shifted_out, high = out[2 * i + 1] << 1 | out[2 * i] >> 63;
    shifted_out = out[2 * i + 1] >> 63;
    const LimbPair sum = multiply_add(a[i], a[i], low, carry);
    out[2 * i] = sum.low;
    out[2 * i + 1] = sum.high + high;
    carry = out[2 * i + 1] < high;
  }
}

/// Numbers with a wide range of exponents are mostly zeros: this many limbs are not.
inline int count_nonzero(const Limb* a, int n) noexcept {
  int count = 0;
  for (int i = 0; i < n; ++i) count += a[i] != 0;
  return count;
}

/// A magnitude placed on the limb grid; zeros surround it.
struct Span {
  const Limb* limb;
  int low, size;
  Limb at(int i) const noexcept { return i < low || i >= low + size ? 0 : limb[i - low]; }
};

/// Sign of |a| - |b|; both stripped of leading zeros.
inline int compare_magnitude(const Span& a, const Span& b) noexcept {
  const int top_a = a.low + a.size, top_b = b.low + b.size;
  if (top_a != top_b) return top_a < top_b ? -1 : 1;
  const int bottom = a.low < b.low ? a.low : b.low;
  for (int i = top_a - 1; i >= bottom; --i) {
    if (a.at(i) != b.at(i)) return a.at(i) < b.at(i) ? -1 : 1;
  }
  return 0;
}

/// out[0, n) = |a| + |b| on the grid from low on; n leaves room for the carry.
inline void add_magnitude(const Span& a, const Span& b, int low, int n, Limb* out) noexcept {
  Limb carry = 0;
  for (int i = 0; i < n; ++i) {
    const Limb x = a.at(low + i), y = b.at(low + i), sum = x + y, total = sum + carry;
    carry = static_cast<Limb>(sum < x) | static_cast<Limb>(total < sum);
    out[i] = total;
  }
}

/// out[0, n) = |a| - |b|, which must not be negative.
inline void subtract_magnitude(const Span& a, const Span& b, int low, int n, Limb* out) noexcept {
  Limb borrow = 0;
  for (int i = 0; i < n; ++i) {
    const Limb x = a.at(low + i), y = b.at(low + i), difference = x - y, total = difference - borrow;
    borrow = static_cast<Limb>(x < y) | static_cast<Limb>(difference < borrow);
    out[i] = total;
  }
}

}  // namespace detail

/// Most limbs a value of this degree can occupy. A stored number, halved at most once, is a multiple of 2^-1075
/// below 2^1024, so a product of `degree` of them spans at most 2099 * degree bits; 5 bits a degree and 32 besides
/// leave room for the sums in between (a predicate adds far fewer than 2^5 terms of a degree), and the value may
/// start and end inside a limb; a product is formed with one limb more than it may end with.
constexpr int limb_capacity(int degree) noexcept { return ((2099 + 5) * degree + 32) / 64 + 4; }

template <int Degree>
struct Number {
  static constexpr int capacity = limb_capacity(Degree);

  std::int32_t sign;  // -1, 0 or 1
  std::int32_t low;
  std::int32_t size;
  Limb limb[capacity];  // [0, size) hold the value; neither end is zero

  Number() noexcept : sign(0), low(0), size(0) {}
  Number(const Number& other) noexcept { *this = other; }
  /// A value of a lower degree is one of this degree too.
  template <int Lower>
  Number(const Number<Lower>& other) noexcept {
    static_assert(Lower < Degree);
    copy(other);
  }
  Number& operator=(const Number& other) noexcept {
    copy(other);
    return *this;
  }

  detail::Span span() const noexcept { return {limb, low, size}; }

  /// Drops zero limbs at both ends.
  void strip() noexcept {
    assert(size <= capacity);
    while (size > 0 && limb[size - 1] == 0) --size;
    if (size == 0) {
      sign = 0;
      low = 0;
      return;
    }
    int zeros = 0;
    while (limb[zeros] == 0) ++zeros;
    if (zeros == 0) return;
    size -= zeros;
    low += zeros;
    std::memmove(limb, limb + zeros, static_cast<std::size_t>(size) * sizeof(Limb));
  }

 private:
  template <int Other>
  void copy(const Number<Other>& other) noexcept {
    sign = other.sign;
    low = other.low;
    size = other.size;
    std::memmove(limb, other.limb, static_cast<std::size_t>(size) * sizeof(Limb));
  }
};

/// x * 2^shift for a finite x, exactly.
inline Number<1> from_double(double x, int shift = 0) noexcept {
  Number<1> n;
  if (x == 0) return n;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int field = static_cast<int>(bits >> 52 & 0x7ff);
  const Limb fraction = bits & 0xfffffffffffffu;
  const Limb significand = field == 0 ? fraction : fraction | Limb{1} << 52;
  const int exponent = (field == 0 ? 1 : field) - 1075 + shift;
  const int offset = exponent & 63;  // two's complement: the position within the limb, also below zero
  n.sign = (bits >> 63) != 0 ? -1 : 1;
  n.low = (exponent - offset) / 64;
  n.limb[0] = significand << offset;
  n.limb[1] = offset == 0 ? 0 : significand >> (64 - offset);
  n.size = 2;
  n.strip();
  return n;
}

/// A small whole number, as a factor of no degree.
inline Number<0> integer(int value) noexcept {
  Number<0> n;
  if (value == 0) return n;
  n.sign = value < 0 ? -1 : 1;
  n.size = 1;
  n.limb[0] = static_cast<Limb>(value < 0 ? -static_cast<std::int64_t>(value) : value);
  return n;
}

template <int A, int B>
Number<A + B> operator*(const Number<A>& a, const Number<B>& b) noexcept {
  Number<A + B> product;
  if (a.sign == 0 || b.sign == 0) return product;
  product.sign = a.sign * b.sign;
  product.low = a.low + b.low;
  product.size = a.size + b.size;
  assert(product.size <= product.capacity);
  if (detail::count_nonzero(a.limb, a.size) * b.size < detail::count_nonzero(b.limb, b.size) * a.size) {
    detail::multiply(a.limb, a.size, b.limb, b.size, product.limb);
  } else {
    detail::multiply(b.limb, b.size, a.limb, a.size, product.limb);
  }
  product.strip();
  return product;
}

template <int A>
Number<2 * A> square(const Number<A>& a) noexcept {
  Number<2 * A> product;
  if (a.sign == 0) return product;
  product.sign = 1;
  product.low = 2 * a.low;
  product.size = 2 * a.size;
  assert(product.size <= product.capacity);
  detail::multiply_by_itself(a.limb, a.size, product.limb);
  product.strip();
  return product;
}

namespace detail {

/// a + flip * b, flip being 1 or -1.
template <int A, int B>
Number<(A > B ? A : B)> add(const Number<A>& a, const Number<B>& b, int flip) noexcept {
  const int sign_b = b.sign * flip;
  Number<(A > B ? A : B)> sum;
  if (sign_b == 0) {
    sum = a;
    return sum;
  }
  if (a.sign == 0) {
    sum = b;
    sum.sign = sign_b;
    return sum;
  }
  const Span x = a.span(), y = b.span();
  const int top = x.low + x.size > y.low + y.size ? x.low + x.size : y.low + y.size;
  sum.low = x.low < y.low ? x.low : y.low;
  sum.size = top - sum.low;
  if (a.sign == sign_b) {
    sum.sign = a.sign;
    sum.size += 1;
    add_magnitude(x, y, sum.low, sum.size, sum.limb);
  } else {
    const int order = compare_magnitude(x, y);
    sum.sign = order < 0 ? sign_b : a.sign;
    if (order < 0) {
      subtract_magnitude(y, x, sum.low, sum.size, sum.limb);
    } else {
      subtract_magnitude(x, y, sum.low, sum.size, sum.limb);
    }
  }
  sum.strip();
  return sum;
}

}  // namespace detail

template <int A, int B>
Number<(A > B ? A : B)> operator+(const Number<A>& a, const Number<B>& b) noexcept {
  return detail::add(a, b, 1);
}

template <int A, int B>
Number<(A > B ? A : B)> operator-(const Number<A>& a, const Number<B>& b) noexcept {
  return detail::add(a, b, -1);
}

template <int A>
Number<A> abs(Number<A> a) noexcept {
  a.sign = a.sign < 0 ? 1 : a.sign;
  return a;
}

/// Sign of a - b: -1, 0 or 1. No difference is formed.
template <int A, int B>
int compare(const Number<A>& a, const Number<B>& b) noexcept {
  if (a.sign != b.sign) return a.sign < b.sign ? -1 : 1;
  return a.sign * detail::compare_magnitude(a.span(), b.span());
}

namespace detail {

/// The position of the highest bit of a value that is not zero.
template <int A>
std::int64_t top_bit(const Number<A>& a) noexcept {
  return 64 * (std::int64_t{a.low} + a.size) - std::countl_zero(a.limb[a.size - 1]);
}

}  // namespace detail

/// Sign of a b - c^2, with neither product formed where signs or magnitudes tell.
template <int A, int B, int C>
int compare_product_with_square(const Number<A>& a, const Number<B>& b, const Number<C>& c) noexcept {
  const int sign = a.sign * b.sign;
  if (sign <= 0 || c.sign == 0) return sign < 0 || c.sign == 0 ? sign : -1;
  // The top bit of a product is that of its factors' sum, or one below.
  const std::int64_t left = detail::top_bit(a) + detail::top_bit(b), right = 2 * detail::top_bit(c);
  if (left + 1 < right) return -1;
  if (right + 1 < left) return 1;
  return compare(a * b, square(c));
}

}  // namespace vesica::exact
