// SPDX-License-Identifier: Apache-2.0
/// The leading digits of long numbers, with a bound on the rest. They mostly decide the sign of a polynomial, in a
/// small part of the time that all digits take.
#pragma once

#include <cstddef>
#include <vesica/exact/number.hpp>

namespace vesica::exact {

/// A number to 64 limbs - 63 binary digits or more.
template <int count>
struct Leading {
  static constexpr int limbs = count;
  static constexpr std::int64_t nothing = -(std::int64_t{1} << 40);

  std::int32_t sign = 0;
  std::int32_t low = 0;                ///< the place of the first limb
  std::int64_t error = nothing;        ///< the number is less than 2^error away, or `nothing` is missing
  Limb limb[std::size_t{limbs}] = {};  ///< the last one not zero, unless the sign is 0

  constexpr Leading() noexcept = default;
  template <int Degree>
  constexpr explicit Leading(const Number<Degree>& x) noexcept {
    if (x.sign != 0) set(x.sign, x.span());
  }
  /// The leading digits of a magnitude that may begin with zeros.
  constexpr void set(int its_sign, detail::Span x) noexcept {
    while (x.size > 0 && x.limb[x.size - 1] == 0) --x.size;
    if (x.size == 0) return;
    sign = its_sign;
    low = x.low + x.size - limbs;
    for (int i = 0; i < limbs; ++i) limb[i] = x.at(low + i);
    for (int i = 0; i < x.size - limbs; ++i) {
      if (x.limb[i] != 0) return lose(std::int64_t{64} * low);
    }
  }

  constexpr void lose(std::int64_t exponent) noexcept { error = (error > exponent ? error : exponent) + 1; }
  /// A sum with an error of nothing is below half of that.
  constexpr void lose_if_any(std::int64_t exponent) noexcept {
    if (exponent > nothing / 2) lose(exponent);
  }
  /// As a product.
  constexpr void lose_factors(const Leading& a, const Leading& b) noexcept {
    lose_if_any(a.top() + b.error);
    lose_if_any(b.top() + a.error);
    lose_if_any(a.error + b.error);
  }

  /// Its magnitude is less than 2^top, and at least half of that unless it is 0.
  constexpr std::int64_t top() const noexcept {
    return sign == 0 ? nothing : 64 * (std::int64_t{low} + limbs) - std::countl_zero(limb[limbs - 1]);
  }
  /// Its lowest limb that is not 0, unless it is 0.
  constexpr int lowest() const noexcept {
    int i = 0;
    while (limb[i] == 0) ++i;
    return i;
  }
  constexpr bool sign_is_certain() const noexcept { return error == nothing || top() - 1 > error; }
  constexpr detail::Span span() const noexcept { return {limb, low, limbs}; }
};

namespace detail {

/// a * b, the same number or two.
template <int limbs>
constexpr Leading<limbs> product(const Leading<limbs>& a, const Leading<limbs>& b) noexcept {
  Leading<limbs> product;
  if (a.sign != 0 && b.sign != 0) {
    Limb limb[std::size_t{2 * limbs}];
    if (&a == &b) {
      multiply_by_itself(a.limb, limbs, limb);
    } else {
      multiply(a.limb, limbs, b.limb, limbs, limb);
    }
    product.set(a.sign * b.sign, {limb, a.low + b.low, 2 * limbs});
  }
  product.lose_factors(a, b);
  return product;
}

}  // namespace detail

template <int limbs>
constexpr Leading<limbs> operator*(const Leading<limbs>& a, const Leading<limbs>& b) noexcept {
  return detail::product(a, b);
}
template <int limbs>
constexpr Leading<limbs> square(const Leading<limbs>& a) noexcept {
  return detail::product(a, a);
}

/// A small positive whole number of times.
template <int limbs>
constexpr Leading<limbs> times(int factor, const Leading<limbs>& a) noexcept {
  Leading<limbs> product;
  const Limb size = static_cast<Limb>(factor);
  if (a.sign != 0) {
    Limb limb[std::size_t{limbs + 1}];
    detail::multiply(&size, 1, a.limb, limbs, limb);
    product.set(a.sign, {limb, a.low, limbs + 1});
  }
  product.lose_if_any(a.error + static_cast<std::int64_t>(std::bit_width(size)));
  return product;
}

template <int limbs>
constexpr Leading<limbs> operator-(const Leading<limbs>& a) noexcept {
  Leading<limbs> negative = a;
  negative.sign = -a.sign;
  return negative;
}

template <int limbs>
constexpr Leading<limbs> operator+(const Leading<limbs>& a, const Leading<limbs>& b) noexcept {
  Leading<limbs> sum;
  // One limb more than the longer of them; what is cut off below is the same for both, so that no order changes.
  constexpr int n = limbs + 2;
  Limb limb[std::size_t{n}];
  if (a.sign == 0 || b.sign == 0) {
    sum = a.sign == 0 ? b : a;
    sum.error = Leading<limbs>::nothing;
  } else {
    const int low = (a.low > b.low ? a.low : b.low) - 1;
    const int order = a.sign == b.sign ? 1 : detail::compare_magnitude(a.span(), b.span());
    const detail::Span x = order < 0 ? b.span() : a.span(), y = order < 0 ? a.span() : b.span();
    if (a.sign == b.sign) {
      detail::add_magnitude(x, y, low, n, limb);
    } else {
      detail::subtract_magnitude(x, y, low, n, limb);
    }
    sum.set(order < 0 ? b.sign : a.sign, {limb, low, n});
    if (a.low < low || b.low < low) sum.lose(std::int64_t{64} * low);
  }
  sum.lose_if_any(a.error);
  sum.lose_if_any(b.error);
  return sum;
}

template <int limbs>
constexpr Leading<limbs> operator-(const Leading<limbs>& a, const Leading<limbs>& b) noexcept {
  return a + -b;
}

/// For numbers with more limbs than this, few leading ones are tried first.
inline constexpr int least_long = 16, few_limbs = 6;

template <int Degree>
constexpr bool is_long(const Number<Degree>& x) noexcept {
  return x.size > least_long;
}
}  // namespace vesica::exact
