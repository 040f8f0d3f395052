// SPDX-License-Identifier: Apache-2.0
/// The discriminant of the contact cubic of two ellipses, of degree 32: positive for three real roots, 0 for a multiple
/// one, negative for a single real root.
#pragma once

#include <vesica/exact/contact_cubic.hpp>
#include <vesica/exact/leading.hpp>

namespace vesica::exact {

namespace detail {

/// m a b - n c d. Not inlined: the multiples take stack only here.
VESICA_CALLED constexpr Number<16> difference_of_multiples(int m, const Number<8>& a, const Number<8>& b, int n,
                                                           const Number<8>& c, const Number<8>& d) noexcept {
  const Number<8> multiple = integer(n) * c;
  return m == 1 ? sum_of_products(a, b, -1, multiple, d) : sum_of_products(integer(m) * a, b, -1, multiple, d);
}

/// (k1^2 - 4 k0 k2) (k2^2 - 4 k1 k3) + k0 k3 (2 k1 k2 - 27 k0 k3) for p = k0 + k1 x + k2 x^2 + k3 x^3. The first two
/// factors are the discriminants of the quadratics that are left without k3 x^3 and without k0.
template <class C, class D>
constexpr auto discriminant(const C& k0, const C& k1, const C& k2, const C& k3, const D& k0_k3) noexcept {
  const auto lower = square(k1) - times(4, k0 * k2), upper = square(k2) - times(4, k1 * k3);
  return lower * upper + k0_k3 * (times(2, k1 * k2) - times(27, k0_k3));
}

}  // namespace detail

/// Leading digits decide most discriminants of long numbers, in 1 us. A cast computes up to 64 discriminants.
VESICA_CALLED constexpr int discriminant_sign(const Cubic& p) noexcept {
  using detail::difference_of_multiples;
  if (is_long(p.c1) || is_long(p.c2)) {
    using Few = Leading<few_limbs>;
    const Few k0(p.d1), k3(p.d2), few = detail::discriminant(k0, Few(p.c1), Few(p.c2), k3, k0 * k3);
    if (few.sign_is_certain()) return few.sign;
  }
  const Number<16> lower = difference_of_multiples(1, p.c1, p.c1, 4, p.d1, p.c2);
  const Number<16> upper = difference_of_multiples(1, p.c2, p.c2, 4, p.c1, p.d2);
  const Number<16> ends = p.d1 * p.d2, less = difference_of_multiples(27, p.d1, p.d2, 2, p.c1, p.c2);
  return compare_products(lower, upper, ends, less);
}

/// The place of a double root of p: 1 if it is greater than the other root, so that p'' > 0 there, -1 if it is less, 0
/// if the root is triple. x0 = -b / (2a) against -c2 / (3 d2), a = c2^2 - 3 c1 d2 and b = c1 c2 - 9 d1 d2. a > 0 unless
/// the root is triple, and then both sides are 0. Degree 24.
VESICA_CALLED constexpr int double_root_place(const Cubic& p) noexcept {
  using detail::difference_of_multiples;
  return compare_products(integer(2) * p.c2, difference_of_multiples(1, p.c2, p.c2, 3, p.c1, p.d2), integer(3) * p.d2,
                          difference_of_multiples(1, p.c1, p.c2, 9, p.d1, p.d2));
}
constexpr bool double_root_is_greater(const Cubic& p) noexcept { return double_root_place(p) > 0; }

}  // namespace vesica::exact
