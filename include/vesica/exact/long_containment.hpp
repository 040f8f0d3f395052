// SPDX-License-Identifier: Apache-2.0
/// Whether one ellipse lies in another, from leading digits and from digits from the top, for extreme magnitudes, where
/// whole products would take up to a hundred microseconds.
#pragma once

#include <vesica/exact/contact_cubic.hpp>
#include <vesica/exact/leading.hpp>

namespace vesica::exact {

namespace detail {

/// What q''(y+) and q'(y+) of first_in_second() in ellipse_ellipse.hpp are made of: with p = k0 + k1 x + ... and
/// det(S1 + x S2) = m0 + m1 x + m2 x^2, slope = 2 k2 - 3 m1 and turn = 3 m0 - k1. With the coefficients of p(t - 1) and
/// det(S1 + (t - 1) S2) instead, Bend and Rise are the same; where the ellipses all but coincide fewer digits of these
/// cancel.
struct PencilParts {
  const Number<8>&m0, &m1, &m2, &slope, &turn;
};

template <class Real>
constexpr Real bend(const Real& m0, const Real& m1, const Real& m2, const Real& slope) noexcept {
  return square(slope) - times(9, square(m1) - times(4, m0 * m2));
}
template <class Real>
constexpr Real rise(const Real& m0, const Real& m1, const Real& m2, const Real& slope, const Real& turn) noexcept {
  return -(m0 * square(slope) + turn * (m1 * slope + m2 * turn));
}

/// slope^2 - 9 delta, which has the sign of q''(y+) for a positive slope.
class Bend {
 public:
  static constexpr Leading<few_limbs> few(const PencilParts& e) noexcept {
    using Few = Leading<few_limbs>;
    return bend(Few(e.m0), Few(e.m1), Few(e.m2), Few(e.slope));
  }
  constexpr explicit Bend(const PencilParts& e) noexcept : m0_(e.m0), m1_(e.m1), m2_(e.m2), slope_(e.slope) {}
  constexpr ToldSum told() noexcept { return ToldSum({{1, &slope_, &slope_}, {-9, &m1_, &m1_}, {36, &m0_, &m2_}}); }

 private:
  DigitsOfDegree<8> m0_, m1_, m2_, slope_;
};

/// (slope^2 delta - rest^2) / (4 d2), which has the sign of q'(y+) for a positive slope; rest = slope mu + 2 d2 turn.
class Rise {
 public:
  static constexpr Leading<few_limbs> few(const PencilParts& e) noexcept {
    using Few = Leading<few_limbs>;
    return rise(Few(e.m0), Few(e.m1), Few(e.m2), Few(e.slope), Few(e.turn));
  }
  constexpr explicit Rise(const PencilParts& e) noexcept
      : m0_(e.m0), m1_(e.m1), m2_(e.m2), slope_(e.slope), turn_(e.turn) {}
  constexpr ToldSum told() noexcept { return ToldSum({{-1, &m0_, &slope_slope_}, {-1, &turn_, &along_}}); }

 private:
  DigitsOfDegree<8> m0_, m1_, m2_, slope_, turn_;
  DigitsOfDegree<16> slope_slope_{{1, &slope_, &slope_}}, along_{{1, &m1_, &slope_}, {1, &m2_, &turn_}};
};

/// The sign of a polynomial that is the same from both: by few digits of either, else by digits from the top of the one
/// of which more is known.
template <class Polynomial>
constexpr int told_sign(const PencilParts& plain, const PencilParts& about) noexcept {
  const Leading<few_limbs> of_plain = Polynomial::few(plain);
  if (of_plain.sign_is_certain()) return of_plain.sign;
  const Leading<few_limbs> of_about = Polynomial::few(about);
  if (of_about.sign_is_certain()) return of_about.sign;
  return Polynomial(of_about.error < of_plain.error ? about : plain).told().sign();
}

/// Whether q(y+) is 0: be sqrt(delta) = 2 d2 al - be mu.
VESICA_CALLED constexpr bool reaches_end(const ContactCubic& p) noexcept {
  const Number<0> unit = integer(1);
  DigitsOfDegree<0> one(unit);
  DigitsOfDegree<8> d1(p.d1), d2(p.d2), mu(p.mu), al(p.al), be(p.be);
  DigitsOfDegree<16> delta{{1, &mu, &mu}, {-4, &d1, &d2}}, be_be{{1, &be, &be}}, rest{{2, &d2, &al}, {-1, &be, &mu}};
  return ToldSum({{1, &rest, &one}}).sign() > 0 && ToldSum({{1, &be_be, &delta}, {-1, &rest, &rest}}).sign() == 0;
}

}  // namespace detail

/// Where this is true, `inside` is first_in_second() of ellipse_ellipse.hpp.
constexpr bool few_digits_tell_first_in_second(bool& inside, const ContactCubic& p) noexcept {
  using Few = Leading<few_limbs>;
  const Few d1(p.d1), d2(p.d2), mu(p.mu), slope = times(2, Few(p.c2)) - times(3, mu);
  Signs signs;
  inside = signs.of(slope) > 0;
  if (!inside || signs.of(detail::bend(d1, mu, d2, slope)) > 0) return signs.certain;
  const int rising = signs.of(detail::rise(d1, mu, d2, slope, times(3, d1) - Few(p.c1)));
  inside = rising > 0;
  return signs.certain && rising != 0;  // a tie
}

/// As first_in_second() in ellipse_ellipse.hpp, of long coefficients of which few digits do not tell it; `determinant`:
/// det(S2 - S1).
VESICA_CALLED constexpr bool more_digits_tell_first_in_second(const ContactCubic& p,
                                                              const Number<8>& determinant) noexcept {
  const Number<0> two = integer(2), three = integer(3);
  const Number<8> slope = two * p.c2 - three * p.mu;
  if (slope.sign <= 0) return false;
  const Number<8> turn = three * p.d1 - p.c1, m1 = p.mu - two * p.d2, turn_about = two * (determinant - p.be) + p.al;
  const detail::PencilParts plain{p.d1, p.mu, p.d2, slope, turn}, about{determinant, m1, p.d2, slope, turn_about};
  if (detail::told_sign<detail::Bend>(plain, about) > 0) return true;
  const int rising = detail::told_sign<detail::Rise>(plain, about);
  return rising != 0 ? rising > 0 : detail::reaches_end(p);
}
constexpr bool long_first_in_second(const ContactCubic& p) noexcept {
  bool inside = false;
  return few_digits_tell_first_in_second(inside, p) ? inside : more_digits_tell_first_in_second(p, p.d1 + p.d2 - p.mu);
}

}  // namespace vesica::exact
