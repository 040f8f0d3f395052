// SPDX-License-Identifier: Apache-2.0
/// Leading digits of long numbers, as many as are asked for at run time: one function serves all precisions.
#pragma once

#include <vesica/exact/leading.hpp>

namespace vesica::exact {

/// Both numbers of an operation have the same limbs, or one of them is 0.
struct Digits : LeadingLimbs<Digits> {
  static constexpr int most_limbs = exact::most_limbs;

  std::int32_t limbs = 0;  ///< an even number of them
  Limb limb[most_limbs];   ///< [0, limbs) hold the value, unless the sign is 0

  constexpr Digits() noexcept {}
  template <int Degree>
  constexpr Digits(const Number<Degree>& x, int its_limbs) noexcept : limbs(its_limbs) {
    if (x.sign != 0) set(x.sign, x.span());
  }
  constexpr Digits(const Digits& other) noexcept : Digits() { *this = other; }
  constexpr Digits& operator=(const Digits& other) noexcept {
    LeadingLimbs::operator=(other);
    limbs = other.limbs;
    if (sign != 0) detail::move_limbs(other.limb, limbs, limb);
    return *this;
  }

  /// Of a magnitude that may begin with zeros.
  constexpr void set(int its_sign, detail::Span x) noexcept {
    while (x.size > 0 && x.limb[x.size - 1] == 0) --x.size;
    if (x.size == 0) return;
    sign = its_sign;
    low = x.low + x.size - limbs;
    const int cut = x.size - limbs;
    detail::place_magnitude(x, low, limbs, limb);
    for (int i = 0; i < cut; ++i) {
      if (x.limb[i] != 0) return lose(std::int64_t{64} * low);
    }
  }

  constexpr detail::Span span() const noexcept { return {limb, low, sign == 0 ? 0 : limbs}; }
};

namespace detail {

/// a * b, the same number or two. What is left out below the lowest limb that is kept is lost, as of Leading.
VESICA_CALLED constexpr Digits product(const Digits& a, const Digits& b) noexcept {
  Digits product;
  product.limbs = a.limbs > b.limbs ? a.limbs : b.limbs;
  if (a.sign != 0 && b.sign != 0) {
    const int n = a.limbs, first = n - 2;
    Limb limb[2 * Digits::most_limbs];
    if (&a == &b) {
      multiply_by_itself(a.limb, n, limb, first);
    } else {
      multiply(a.limb, n, b.limb, n, limb, first);
    }
    product.set(a.sign * b.sign, {limb + first, a.low + b.low + first, 2 * n - first});
    if (a.lowest() + b.lowest() < first) product.lose(std::int64_t{64} * (a.low + b.low + first + 1) + 6);
  }
  product.lose_factors(a, b);
  return product;
}

VESICA_CALLED constexpr Digits sum(const Digits& a, const Digits& b, int sign_b) noexcept {
  Digits sum;
  if (a.sign == 0 || b.sign == 0) {
    sum = a.sign == 0 ? b : a;
    sum.sign = a.sign == 0 ? sign_b : a.sign;
    sum.error = Digits::nothing;
  } else {
    sum.limbs = a.limbs;
    // As for Leading: one limb more, and what is cut off is the same for both.
    const int n = a.limbs + 2, low = (a.low > b.low ? a.low : b.low) - 1;
    Limb limb[Digits::most_limbs + 2];
    const int order = a.sign == sign_b ? 1 : compare_magnitude(a.span(), b.span());
    const Span x = order < 0 ? b.span() : a.span(), y = order < 0 ? a.span() : b.span();
    a.sign == sign_b ? add_magnitude(x, y, low, n, limb) : subtract_magnitude(x, y, low, n, limb);
    sum.set(order < 0 ? sign_b : a.sign, {limb, low, n});
    if (a.low < low || b.low < low) sum.lose(std::int64_t{64} * low);
  }
  sum.lose_if_any(a.error);
  sum.lose_if_any(b.error);
  return sum;
}

/// As a number of a degree that has room for them.
constexpr Number<2> digits_of(const Digits& x) noexcept {
  Number<2> kept;
  static_assert(Digits::most_limbs <= kept.capacity);
  kept.sign = x.sign;
  kept.low = x.low;
  kept.size = x.span().size;
  move_limbs(x.limb, kept.size, kept.limb);
  kept.strip();
  return kept;
}

}  // namespace detail

constexpr Digits operator*(const Digits& a, const Digits& b) noexcept { return detail::product(a, b); }
constexpr Digits square(const Digits& a) noexcept { return detail::product(a, a); }
constexpr Digits operator+(const Digits& a, const Digits& b) noexcept { return detail::sum(a, b, b.sign); }
constexpr Digits operator-(const Digits& a, const Digits& b) noexcept { return detail::sum(a, b, -b.sign); }
constexpr Digits operator-(const Digits& a) noexcept {
  Digits negative = a;
  negative.sign = -a.sign;
  return negative;
}

/// A small positive whole number of times.
VESICA_CALLED constexpr Digits times(int factor, const Digits& a) noexcept {
  Digits product;
  product.limbs = a.limbs;
  const Limb size = static_cast<Limb>(factor);
  if (a.sign != 0) {
    Limb limb[Digits::most_limbs + 1];
    detail::multiply(&size, 1, a.limb, a.limbs, limb);
    product.set(a.sign, {limb, a.low, a.limbs + 1});
  }
  product.lose_if_any(a.error + static_cast<std::int64_t>(std::bit_width(size)));
  return product;
}

}  // namespace vesica::exact
