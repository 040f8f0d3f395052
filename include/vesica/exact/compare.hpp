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
  // The top bit of a product is at the sum of its factors' bits, or one below.
  const std::int64_t left = top_bit(a) + top_bit(b), right = top_bit(c) + top_bit(d);
  return left + 1 < right ? -sign : right + 1 < left ? sign : 2;
}

/// Sign of |a b| - |c d|, none of them zero; `room` holds either product.
constexpr int compare_magnitudes_in_order(const Span& a, const Span& b, const Span& c, const Span& d,
                                          Limb* room) noexcept {
  const Grid grid(a, b, c, d);
  place_product(a, b, grid.low, grid.size, room);
  if (subtract_product(c, d, grid.low, grid.size, room)) return -1;
  for (int i = 0; i < grid.size; ++i) {
    if (room[i] != 0) return 1;
  }
  return 0;
}

/// The same, with a square placed first: it is quicker than its rows are.
constexpr int compare_magnitudes_of_products(const Span& a, const Span& b, const Span& c, const Span& d,
                                             Limb* room) noexcept {
  const bool square_is_last = c.limb == d.limb && a.limb != b.limb;
  return square_is_last ? -compare_magnitudes_in_order(c, d, a, b, room)
                        : compare_magnitudes_in_order(a, b, c, d, room);
}

}  // namespace detail

/// Sign of a b - c d, in one buffer. Not inlined: the buffer takes stack only here.
template <int A, int B, int C, int D>
VESICA_CALLED constexpr int compare_products(const Number<A>& a, const Number<B>& b, const Number<C>& c,
                                             const Number<D>& d) noexcept {
  const int by_size = detail::compare_products_by_size(a, b, c, d);
  if (by_size < 2) return by_size;
  Limb room[std::size_t{limb_capacity(A + B > C + D ? A + B : C + D)}];
  return a.sign * b.sign * detail::compare_magnitudes_of_products(a.span(), b.span(), c.span(), d.span(), room);
}
/// Sign of a b - c^2.
template <int A, int B, int C>
constexpr int compare_product_with_square(const Number<A>& a, const Number<B>& b, const Number<C>& c) noexcept {
  return compare_products(a, b, c, c);
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
