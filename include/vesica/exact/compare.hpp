// SPDX-License-Identifier: Apache-2.0
/// Signs of differences of products. A product is formed only if the signs and magnitudes of its factors do not decide.
#pragma once

#include <vesica/exact/number.hpp>
#include <vesica/scalar.hpp>

namespace vesica::exact {

namespace detail {

/// The sign of a b - c d by the signs and top bits of the factors; 2 where these leave it open.
template <int A, int B, int C, int D>
constexpr int compare_products_by_size(const Number<A>& a, const Number<B>& b, const Number<C>& c,
                                       const Number<D>& d) noexcept {
  const int sign = a.sign * b.sign, other = c.sign * d.sign;
  if (sign != other) return sign > other ? 1 : -1;
  if (sign == 0) return 0;
  // The top bit of a product is that of its factors' sum, or one below.
  const std::int64_t left = top_bit(a) + top_bit(b), right = top_bit(c) + top_bit(d);
  return left + 1 < right ? -sign : right + 1 < left ? sign : 2;
}

}  // namespace detail

/// Sign of a b - c d. Not inlined: the products take stack only here.
template <int A, int B, int C, int D>
VESICA_CALLED constexpr int compare_products(const Number<A>& a, const Number<B>& b, const Number<C>& c,
                                             const Number<D>& d) noexcept {
  const int by_size = detail::compare_products_by_size(a, b, c, d);
  return by_size < 2 ? by_size : compare(a * b, c * d);
}
/// Sign of a b - c^2.
template <int A, int B, int C>
VESICA_CALLED constexpr int compare_product_with_square(const Number<A>& a, const Number<B>& b,
                                                        const Number<C>& c) noexcept {
  const int by_size = detail::compare_products_by_size(a, b, c, c);
  return by_size < 2 ? by_size : compare(a * b, square(c));
}
/// Sign of a^2 x - b^2 y.
template <int A, int X, int B, int Y>
VESICA_CALLED constexpr int compare_squares_times(const Number<A>& a, const Number<X>& x, const Number<B>& b,
                                                  const Number<Y>& y) noexcept {
  return compare_products(square(a), x, square(b), y);
}

namespace detail {

/// Sign of a + b sqrt(d), d >= 0.
template <int A, int B, int D>
constexpr int sign_with_root(const Number<A>& a, const Number<B>& b, const Number<D>& d) noexcept {
  const int root_sign = d.sign == 0 ? 0 : b.sign;
  if (a.sign * root_sign >= 0) return a.sign + root_sign > 0 ? 1 : a.sign + root_sign < 0 ? -1 : 0;
  return root_sign * compare_products(square(b), d, a, a);
}

}  // namespace detail

}  // namespace vesica::exact
