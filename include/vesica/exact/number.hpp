// SPDX-License-Identifier: Apache-2.0
/// Exact arithmetic for the few pairs that filters leave undecided. A number is a sign and a magnitude in 64-bit limbs,
/// scaled by a whole number of limbs. There is no heap, no overflow and no underflow: each type carries the degree of
/// the polynomial that its numbers are values of, and the degree bounds the storage that such a value can need.
#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vesica/exact/limbs.hpp>

namespace vesica::exact {

/// Most limbs a value of this degree can occupy. A stored number, halved at most once, is a multiple of 2^-1075
/// below 2^1024, so a product of `degree` of them spans at most 2099 * degree bits; 5 bits a degree and 32 besides
/// leave room for the sums in between (a predicate adds far fewer than 2^5 terms of a degree), and the value may
/// start and end inside a limb; a product is formed with up to three limbs more than it may end with.
constexpr int limb_capacity(int degree) noexcept { return ((2099 + 5) * degree + 32) / 64 + 6; }

template <int Degree>
struct Number {
  static constexpr int capacity = limb_capacity(Degree);

  std::int32_t sign;  // -1, 0 or 1
  std::int32_t low;
  std::int32_t size;
  Limb limb[std::size_t{capacity}];  // [0, size) hold the value; neither end is zero

  constexpr Number() noexcept : sign(0), low(0), size(0) {}
  constexpr Number(const Number& other) noexcept { *this = other; }
  /// A value of a lower degree is one of this degree too.
  template <int Lower>
  constexpr Number(const Number<Lower>& other) noexcept {
    static_assert(Lower < Degree);
    copy(other);
  }
  constexpr Number& operator=(const Number& other) noexcept {
    copy(other);
    return *this;
  }

  constexpr detail::Span span() const noexcept { return {limb, low, size}; }

  /// Drops zero limbs at both ends.
  constexpr void strip() noexcept {
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
    detail::move_limbs(limb + zeros, size, limb);
  }

 private:
  template <int Other>
  constexpr void copy(const Number<Other>& other) noexcept {
    sign = other.sign;
    low = other.low;
    size = other.size;
    detail::move_limbs(other.limb, size, limb);
  }
};

/// x * 2^shift for a finite x, exactly.
constexpr Number<1> from_double(double x, int shift = 0) noexcept {
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
constexpr Number<0> integer(int value) noexcept {
  Number<0> n;
  if (value == 0) return n;
  n.sign = value < 0 ? -1 : 1;
  n.size = 1;
  n.limb[0] = static_cast<Limb>(value < 0 ? -static_cast<std::int64_t>(value) : value);
  return n;
}

template <int A, int B>
constexpr Number<A + B> operator*(const Number<A>& a, const Number<B>& b) noexcept {
  Number<A + B> product;
  if (a.sign == 0 || b.sign == 0) return product;
  product.sign = a.sign * b.sign;
  product.low = a.low + b.low;
  product.size = a.size + b.size;
  assert(product.size <= product.capacity);
  const bool in_order = a.size <= b.size;
  const detail::Span shorter = in_order ? a.span() : b.span(), longer = in_order ? b.span() : a.span();
  detail::multiply(shorter.limb, shorter.size, longer.limb, longer.size, product.limb);
  product.strip();
  return product;
}

template <int A>
constexpr Number<2 * A> square(const Number<A>& a) noexcept {
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
constexpr Number<(A > B ? A : B)> add(const Number<A>& a, const Number<B>& b, int flip) noexcept {
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

namespace detail {

/// The grid on which both of two products, a b and c d, fit.
struct Grid {
  int low, size;

  constexpr Grid(const Span& a, const Span& b, const Span& c, const Span& d) noexcept {
    const int low_first = a.low + b.low, low_second = c.low + d.low;
    const int top_first = low_first + a.size + b.size, top_second = low_second + c.size + d.size;
    low = low_first < low_second ? low_first : low_second;
    size = (top_first > top_second ? top_first : top_second) - low;
  }
};

/// a b + flip c d in one buffer, flip being 1 or -1.
template <int A, int B, int C, int D>
constexpr Number<(A + B > C + D ? A + B : C + D)> sum_of_products(const Number<A>& a, const Number<B>& b, int flip,
                                                                  const Number<C>& c, const Number<D>& d) noexcept {
  Number<(A + B > C + D ? A + B : C + D)> sum;
  const int sign = a.sign * b.sign, other = flip * c.sign * d.sign;
  if (sign == 0 && other == 0) return sum;
  const bool first_alone = other == 0, second_alone = sign == 0;
  const Span x = second_alone ? c.span() : a.span(), y = second_alone ? d.span() : b.span(),
             z = first_alone ? x : c.span(), w = first_alone ? y : d.span();
  const Grid grid(x, y, z, w);
  sum.sign = second_alone ? other : sign;
  sum.low = grid.low;
  sum.size = grid.size + (sign == other ? 1 : 0);
  assert(sum.size <= sum.capacity);
  place_product(x, y, sum.low, sum.size, sum.limb);
  if (sign == other) {
    add_product(z, w, sum.low, sum.size, sum.limb);
  } else if (!first_alone && !second_alone && subtract_product(z, w, sum.low, sum.size, sum.limb)) {
    sum.sign = -sum.sign;
  }
  sum.strip();
  return sum;
}

}  // namespace detail

template <int A, int B>
constexpr Number<(A > B ? A : B)> operator+(const Number<A>& a, const Number<B>& b) noexcept {
  return detail::add(a, b, 1);
}

template <int A, int B>
constexpr Number<(A > B ? A : B)> operator-(const Number<A>& a, const Number<B>& b) noexcept {
  return detail::add(a, b, -1);
}

template <int A>
constexpr Number<A> abs(Number<A> a) noexcept {
  a.sign = a.sign < 0 ? 1 : a.sign;
  return a;
}

template <int A>
constexpr Number<A> operator-(Number<A> a) noexcept {
  a.sign = -a.sign;
  return a;
}

/// Sign of a - b: -1, 0 or 1. No difference is formed.
template <int A, int B>
constexpr int compare(const Number<A>& a, const Number<B>& b) noexcept {
  if (a.sign != b.sign) return a.sign < b.sign ? -1 : 1;
  return a.sign * detail::compare_magnitude(a.span(), b.span());
}

namespace detail {

/// The position of the highest bit of a value that is not zero.
template <int A>
constexpr std::int64_t top_bit(const Number<A>& a) noexcept {
  return 64 * (std::int64_t{a.low} + a.size) - std::countl_zero(a.limb[a.size - 1]);
}

}  // namespace detail

}  // namespace vesica::exact
