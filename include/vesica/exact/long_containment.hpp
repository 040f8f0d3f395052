// SPDX-License-Identifier: Apache-2.0
/// Whether one ellipse lies in another, from leading digits, for extreme magnitudes, where all digits would take up to
/// a hundred microseconds.
#pragma once

#include <vesica/exact/contact_cubic.hpp>
#include <vesica/exact/leading.hpp>

namespace vesica::exact {

/// What may be far smaller than its terms: delta = mu^2 - 4 d1 d2, which is 0 iff S1 and S2 are proportional, by its
/// factors mu -+ 2 sqrt(d1 d2), and g = d1 + d2 - mu = det(S1 - S2). From leading digits these lose what cancels; so,
/// where it must be, they are formed exactly.
template <class Real>
struct SmallParts {
  Real delta_less, delta_more, g, al_less_2be;
};

constexpr SmallParts<Number<8>> exact_small_parts(const ContactCubic& p) noexcept {
  const auto twice = integer(2) * (p.root1 * p.root2);
  return {p.mu - twice, p.mu + twice, p.d1 + p.d2 - p.mu, p.al - integer(2) * p.be};
}

template <class Real>
constexpr SmallParts<Real> leading_small_parts(const ContactCubic& p) noexcept {
  const Real d1(p.d1), d2(p.d2), mu(p.mu), al(p.al), be(p.be), twice = times(2, Real(p.root1) * Real(p.root2));
  return {mu - twice, mu + twice, d1 + d2 - mu, al - times(2, be)};
}

namespace detail {

/// (slope^2 delta - rest^2) / (4 d2), slope and rest as of first_in_second() in ellipse_ellipse.hpp, from what cancels
/// less; g = d1 + d2 - mu and h = al - 2 be.
template <class Real>
constexpr Real rise(const ContactCubic& p, const Real& delta, const Real& g, const Real& h) noexcept {
  const Real d1(p.d1), d2(p.d2), al(p.al), be(p.be);
  return delta * (g + h) + h * (times(2, be * d1) - al * d2) - times(2, al * be * g);
}

template <class Real, class Small>
constexpr bool first_in_second(const ContactCubic& p, const Small& parts, Signs& signs) noexcept {
  const Real slope = times(2, Real(p.c2)) - times(3, Real(p.mu));
  if (signs.of(slope) <= 0) return false;
  const Real delta = Real(parts.delta_less) * Real(parts.delta_more);
  if (signs.of(delta) == 0 || signs.of(square(slope) - times(9, delta)) > 0) return true;
  const int rising = signs.of(rise(p, delta, Real(parts.g), Real(parts.al_less_2be)));
  if (rising == 0) signs.certain = false;  // a tie
  return rising > 0;
}

/// By digits from the top, which tell ties too.
constexpr bool digits_tell_first_in_second(const ContactCubic& p, const SmallParts<Number<8>>& parts) noexcept {
  const Number<8> slope = integer(2) * p.c2 - integer(3) * p.mu, sum = parts.g + parts.al_less_2be;
  if (slope.sign <= 0) return false;
  const Number<0> unit = integer(1);
  DigitsOfDegree<0> one(unit);
  DigitsOfDegree<8> d1(p.d1), d2(p.d2), mu(p.mu), al(p.al), be(p.be), slope_digits(slope), sum_digits(sum), g(parts.g),
      h(parts.al_less_2be), less(parts.delta_less), more(parts.delta_more);
  DigitsOfDegree<16> delta{{1, &less, &more}};
  if (delta.is_zero() || ToldSum({{1, &slope_digits, &slope_digits}, {-9, &delta, &one}}).sign() > 0) return true;
  DigitsOfDegree<16> al_be{{1, &al, &be}}, turned{{2, &be, &d1}, {-1, &al, &d2}};
  const int rising = ToldSum({{1, &delta, &sum_digits}, {1, &h, &turned}, {-2, &al_be, &g}}).sign();  // rise()
  if (rising != 0) return rising > 0;
  DigitsOfDegree<16> be_be{{1, &be, &be}}, rest{{2, &d2, &al}, {-1, &be, &mu}};
  return ToldSum({{1, &rest, &one}}).sign() > 0 && ToldSum({{1, &be_be, &delta}, {-1, &rest, &rest}}).sign() == 0;
}

}  // namespace detail

constexpr bool few_digits_tell_first_in_second(bool& inside, const ContactCubic& p) noexcept {
  using Few = Leading<few_limbs>;
  Signs signs;
  inside = detail::first_in_second<Few>(p, leading_small_parts<Few>(p), signs);
  return signs.certain;
}

/// As first_in_second() in ellipse_ellipse.hpp, of long coefficients of which few digits do not tell it.
constexpr bool more_digits_tell_first_in_second(const ContactCubic& p) noexcept {
  const auto parts = exact_small_parts(p);
  Signs signs;
  const bool inside = detail::first_in_second<Leading<few_limbs>>(p, parts, signs);
  return signs.certain ? inside : detail::digits_tell_first_in_second(p, parts);
}
constexpr bool long_first_in_second(const ContactCubic& p) noexcept {
  bool inside = false;
  return few_digits_tell_first_in_second(inside, p) ? inside : more_digits_tell_first_in_second(p);
}

}  // namespace vesica::exact
