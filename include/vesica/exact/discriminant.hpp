// SPDX-License-Identifier: Apache-2.0
/// The discriminant of the contact cubic of two ellipses, of degree 32: positive for three real roots, 0 for a multiple
/// one, negative for a single real root.
#pragma once

#include <vesica/exact/contact_cubic.hpp>
#include <vesica/exact/leading.hpp>

namespace vesica::exact {

constexpr bool is_long(const ContactCubic& p) noexcept { return is_long(p.c1) || is_long(p.c2); }

namespace detail {

/// That of k0 + k1 x + k2 x^2 + k3 x^3, given k0 k3. Its factors `lower` and `upper` are discriminants too, of the
/// quadratics that are left without k3 x^3 and without k0. If two roots are close to each other and far from the third,
/// what cancels does so within one of them.
template <class C, class D>
constexpr auto discriminant(const C& k0, const C& k1, const C& k2, const C& k3, const D& k0_k3) noexcept {
  const auto lower = square(k1) - times(4, k0 * k2), upper = square(k2) - times(4, k1 * k3);
  return lower * upper + k0_k3 * (times(2, k1 * k2) - times(27, k0_k3));
}

/// By whole products.
VESICA_CALLED constexpr int short_discriminant_sign(const ContactCubic& p) noexcept {
  const Number<16> ends = p.d1 * p.d2, lower = square(p.c1) - integer(4) * (p.d1 * p.c2),
                   upper = square(p.c2) - integer(4) * (p.c1 * p.d2),
                   less = integer(27) * ends - integer(2) * (p.c1 * p.c2);
  return compare_products(lower, upper, ends, less);
}

/// The coefficients of a cubic, the constant one first.
struct Coefficients {
  const Number<8>&k0, &k1, &k2, &k3;
};

/// The coefficients of p(t - 1), or of that with the ellipses in the other order. Where the ellipses' centres are close
/// to each other, as seen from an ellipse that is large or thin, two roots of p are close to -1. Then the discriminant
/// from these has smaller terms than from p's own coefficients, and fewer digits cancel.
struct CubicAboutMinusOne {
  Number<8> k0, k1, k2;
  const Number<8>& k3;

  constexpr CubicAboutMinusOne(const ContactCubic& p, bool exchanged) noexcept
      : CubicAboutMinusOne(exchanged ? p.be - p.al : p.al - p.be, exchanged ? p.c2 : p.c1, exchanged ? p.c1 : p.c2,
                           exchanged ? p.d1 : p.d2) {}
  constexpr Coefficients coefficients() const noexcept { return {k0, k1, k2, k3}; }

 private:
  /// From p(-1) and the other coefficients of p.
  constexpr CubicAboutMinusOne(const Number<8>& value, const Number<8>& c1, const Number<8>& c2,
                               const Number<8>& d2) noexcept
      : k0(value), k1(c1 - c2), k2(c2 - integer(3) * d2), k3(d2) {
    k1 = k1 - k2;
  }
};

constexpr Coefficients coefficients(const ContactCubic& p) noexcept { return {p.d1, p.c1, p.c2, p.d2}; }

/// The value of a polynomial that is the same for p(x) and p(t - 1), given what few leading digits tell: so many of
/// them that its sign is certain.
template <class Polynomial>
constexpr Leading<few_limbs> told_invariant(const ContactCubic& p, const Leading<few_limbs>& few) noexcept {
  if (few.sign_is_certain()) return few;
  const Coefficients plain = coefficients(p);
  // With a negative coefficient one root alone is negative; two that are close to each other are positive, not near -1.
  if (p.c1.sign < 0 || p.c2.sign < 0) return Polynomial::told(plain);
  // The third root is farther from the two for the lesser of d1 and d2.
  const CubicAboutMinusOne q(p, Polynomial::is_same_if_exchanged && compare(p.d1, p.d2) < 0);
  const Coefficients about = q.coefficients();
  const Leading<few_limbs> other = Polynomial::few(about);
  if (other.sign_is_certain()) return other;
  // The terms are smaller of which more is known. The other cubic's numbers have more digits: a little is not enough.
  constexpr int least_gain = 256;
  return Polynomial::told(other.error + least_gain < few.error ? about : plain);
}

/// The discriminant, which is the same for both orders of the ellipses too.
class Discriminant {
 public:
  static constexpr bool is_same_if_exchanged = true;
  static constexpr Leading<few_limbs> few(const Coefficients& k) noexcept {
    const Leading<few_limbs> k0(k.k0), k3(k.k3);
    return discriminant(k0, Leading<few_limbs>(k.k1), Leading<few_limbs>(k.k2), k3, k0 * k3);
  }
  /// Sparse numbers are multiplied sooner than taken apart.
  static constexpr Leading<few_limbs> told(const Coefficients& k) noexcept {
    return is_sparse(k.k0) && is_sparse(k.k1) && is_sparse(k.k2) && is_sparse(k.k3) ? whole(k) : by_digits(k);
  }
  /// By digits from the top.
  VESICA_CALLED static constexpr Leading<few_limbs> by_digits(const Coefficients& k) noexcept {
    return leading(Discriminant(k).sum());
  }
  VESICA_CALLED static constexpr Leading<few_limbs> whole(const Coefficients& k) noexcept {
    return Leading<few_limbs>(discriminant(k.k0, k.k1, k.k2, k.k3, k.k0 * k.k3));
  }

 private:
  constexpr explicit Discriminant(const Coefficients& k) noexcept : k0_(k.k0), k1_(k.k1), k2_(k.k2), k3_(k.k3) {}
  constexpr ToldSum sum() noexcept { return ToldSum({{1, &lower_, &upper_}, {1, &ends_, &rest_}}); }

  DigitsOfDegree<8> k0_, k1_, k2_, k3_;
  DigitsOfDegree<16> lower_{{1, &k1_, &k1_}, {-4, &k0_, &k2_}}, upper_{{1, &k2_, &k2_}, {-4, &k1_, &k3_}},
      ends_{{1, &k0_, &k3_}}, rest_{{2, &k1_, &k2_}, {-27, &k0_, &k3_}};
};

/// 2 k2^3 - 9 k1 k2 k3 + 27 k0 k3^2: see double_root_is_greater().
class DoubleRootOrder {
 public:
  static constexpr bool is_same_if_exchanged = false;  // the roots' order is not
  static constexpr Leading<few_limbs> few(const Coefficients& k) noexcept {
    const Leading<few_limbs> k0(k.k0), k1(k.k1), k2(k.k2), k3(k.k3);
    return times(2, k2) * (square(k2) - times(3, k1 * k3)) - times(3, k3) * (k1 * k2 - times(9, k0 * k3));
  }
  /// By digits from the top.
  VESICA_CALLED static constexpr Leading<few_limbs> told(const Coefficients& k) noexcept {
    return leading(DoubleRootOrder(k).sum());
  }

 private:
  constexpr explicit DoubleRootOrder(const Coefficients& k) noexcept : k0_(k.k0), k1_(k.k1), k2_(k.k2), k3_(k.k3) {}
  constexpr ToldSum sum() noexcept { return ToldSum({{2, &k2_, &a_}, {-3, &k3_, &b_}}); }

  DigitsOfDegree<8> k0_, k1_, k2_, k3_;
  DigitsOfDegree<16> a_{{1, &k2_, &k2_}, {-3, &k1_, &k3_}}, b_{{1, &k1_, &k2_}, {-9, &k0_, &k3_}};
};

}  // namespace detail

/// What few leading digits of the coefficients tell of the discriminant.
constexpr Leading<few_limbs> few_digits_of_discriminant(const ContactCubic& p) noexcept {
  return detail::Discriminant::few(detail::coefficients(p));
}
/// The leading digits of the discriminant.
VESICA_CALLED constexpr Leading<few_limbs> leading_discriminant(const ContactCubic& p) noexcept {
  return detail::told_invariant<detail::Discriminant>(p, few_digits_of_discriminant(p));
}

namespace detail {

/// Of ellipses with proportional S1 and S2, over factors that are positive: (2 al - 2 d1 - mu)^2 - 8 d1 mu. All their
/// roots may be so close to each other that hundreds of digits cancel in the other forms.
constexpr int sign_for_proportional(const ContactCubic& p) noexcept {
  const Number<0> two = integer(2);
  return -compare_product_with_square(integer(8) * p.d1, p.mu, two * p.al - two * p.d1 - p.mu);
}
constexpr bool are_proportional(const ContactCubic& p) noexcept {
  using Few = Leading<few_limbs>;
  const Few less = Few(p.mu) - times(2, Few(p.root1) * Few(p.root2));
  return less.sign_is_certain() ? less.sign == 0 : compare(p.mu, integer(2) * (p.root1 * p.root2)) == 0;
}
/// Where few leading digits do not tell it.
VESICA_CALLED constexpr int more_digits_tell_discriminant(const ContactCubic& p,
                                                          const Leading<few_limbs>& few) noexcept {
  return are_proportional(p) ? sign_for_proportional(p) : told_invariant<Discriminant>(p, few).sign;
}

}  // namespace detail

constexpr int discriminant_sign(const ContactCubic& p) noexcept {
  if (!is_long(p)) return detail::short_discriminant_sign(p);
  const Leading<few_limbs> few = few_digits_of_discriminant(p);
  return few.sign_is_certain() ? few.sign : detail::more_digits_tell_discriminant(p, few);
}

/// Whether a double root of p is the greater of its roots, so that p'' > 0 there: x0 = -b / (2a) > -c2 / (3 d2),
/// a = c2^2 - 3 c1 d2 and b = c1 c2 - 9 d1 d2, a > 0 unless the root is triple, and then both sides are 0. Degree 24.
VESICA_CALLED constexpr bool double_root_is_greater(const ContactCubic& p) noexcept {
  using Order = detail::DoubleRootOrder;
  return detail::told_invariant<Order>(p, Order::few(detail::coefficients(p))).sign > 0;
}

}  // namespace vesica::exact
