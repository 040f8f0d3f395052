// SPDX-License-Identifier: Apache-2.0
/// Signs about two ellipses from leading digits, for extreme magnitudes, where all digits would take up to a hundred
/// microseconds.
#pragma once

#include <vesica/exact/contact_cubic.hpp>
#include <vesica/exact/leading.hpp>

namespace vesica::exact {

constexpr bool is_long(const ContactCubic& p) noexcept { return is_long(p.c1) || is_long(p.c2); }

/// What may be far smaller than its terms: delta = mu^2 - 4 d1 d2, which is 0 iff S1 and S2 are proportional, by its
/// factors mu -+ 2 sqrt(d1 d2), and g = d1 + d2 - mu = det(S1 - S2). From leading digits these lose what cancels; so,
/// where it must be, they are formed exactly.
template <class Real>
struct SmallParts {
  Real delta_less, delta_more, g, al_less_be, al_less_2be;
};

constexpr SmallParts<Number<8>> exact_small_parts(const ContactCubic& p) noexcept {
  const auto twice = integer(2) * (p.root1 * p.root2);
  return {p.mu - twice, p.mu + twice, p.d1 + p.d2 - p.mu, p.al - p.be, p.al - integer(2) * p.be};
}

template <class Real>
constexpr SmallParts<Real> leading_small_parts(const ContactCubic& p) noexcept {
  const Real d1(p.d1), d2(p.d2), mu(p.mu), al(p.al), be(p.be), twice = times(2, Real(p.root1) * Real(p.root2));
  return {mu - twice, mu + twice, d1 + d2 - mu, al - be, al - times(2, be)};
}

namespace detail {

/// The discriminant from the cubic's coefficients and d1 d2.
template <class C, class D>
constexpr auto discriminant(const C& d1, const C& c1, const C& c2, const C& d2, const D& d1_d2) noexcept {
  const auto a = square(c2) - times(3, d2 * c1), b = c1 * c2 - times(9, d1_d2), c = square(c1) - times(3, d1 * c2);
  return times(4, a * c) - square(b);
}
template <class Real, class Cubic>
constexpr Real discriminant(const Cubic& p) noexcept {
  const Real d1(p.d1), c1(p.c1), c2(p.c2), d2(p.d2);
  return discriminant(d1, c1, c2, d2, d1 * d2);
}

/// A third of it, in powers of al and be: with both 0 it is delta g^2. So nothing cancels where the ellipses' centres
/// are close to each other, as seen from an ellipse that is large or thin.
template <class Real, class Cubic, class Small>
constexpr Real discriminant_by_offset(const Cubic& p, const Small& parts) noexcept {
  const Real d1(p.d1), d2(p.d2), mu(p.mu), al(p.al), be(p.be), g(parts.g);
  const Real delta = Real(parts.delta_less) * Real(parts.delta_more);
  const Real al_al = square(al), be_be = square(be), al_be = al * be, d1_d2 = d1 * d2;
  const Real linear = g * (al * d2 * (times(2, d1) - mu) + be * d1 * (times(2, d2) - mu)) +
                      delta * (times(2, be * g) + Real(parts.al_less_be) * (times(3, d2) - d1 - mu));
  const Real rest = square(mu) - times(12, d1_d2);
  const Real quadratic = al_al * (d2 * (d2 - times(10, mu)) + rest) + be_be * (d1 * (d1 - times(10, mu)) + rest) +
                         al_be * (times(22, d1_d2) + times(4, mu) * (d1 + d2 + mu));
  const Real cubic = al_al * (be * (d2 + mu) - times(2, al * d2)) + be_be * (al * (d1 + mu) - times(2, be * d1));
  return delta * square(g) + times(2, linear) + quadratic - times(2, cubic) + square(al_be);
}

/// The same for proportional S1 and S2 with offset centres, over factors that are positive: a degree of 16.
constexpr int sign_of_discriminant_of_proportional(const ContactCubic& p) noexcept {
  const auto value = [](const auto& al, const auto& less, const auto& twice_less) {
    const auto product = al * (al - less), twice = product + product;
    return square(twice_less) + (twice + twice);
  };
  const auto twice_d1 = integer(2) * p.d1;
  return sign_of(value, p.al, twice_d1 + p.mu, twice_d1 - p.mu);
}

/// (slope^2 delta - rest^2) / (4 d2), slope and rest as of first_in_second() in ellipse_ellipse.hpp, from what cancels
/// less; g = d1 + d2 - mu and h = al - 2 be.
template <class Real, class Cubic>
constexpr Real rise(const Cubic& p, const Real& delta, const Real& g, const Real& h) noexcept {
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

/// Whether c1 and c2 have so many limbs with digits that a few leading ones are sooner there than all.
constexpr bool is_dense(const ContactCubic& p) noexcept {
  return dense_limbs(p.c1) + dense_limbs(p.c2) > 3 * some_limbs;
}

/// The discriminant as a sum of products whose digits are formed from the top.
class DiscriminantDigits {
 public:
  constexpr explicit DiscriminantDigits(const ContactCubic& p) noexcept : d1_(p.d1), c1_(p.c1), c2_(p.c2), d2_(p.d2) {}
  constexpr ToldSum told() noexcept { return ToldSum({{1, &four_a_, &c_}, {-1, &b_, &b_}}); }

 private:
  DigitsOfDegree<8> d1_, c1_, c2_, d2_;
  DigitsOfDegree<16> four_a_{{4, &c2_, &c2_}, {-12, &d2_, &c1_}}, b_{{1, &c1_, &c2_}, {-9, &d1_, &d2_}},
      c_{{1, &c1_, &c1_}, {-3, &d1_, &c2_}};
};

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

namespace detail {

/// Of functions of their own, as their numbers take stack.
VESICA_CALLED constexpr int discriminant_sign_by_offset(const ContactCubic& p, Signs& signs) noexcept {
  const auto parts = exact_small_parts(p);
  if (parts.delta_less.sign == 0) return sign_of_discriminant_of_proportional(p);
  return signs.of(discriminant_by_offset<Leading<few_limbs>>(p, parts));
}
VESICA_CALLED constexpr int discriminant_sign_by_digits(const ContactCubic& p) noexcept {
  return DiscriminantDigits(p).told().sign();
}

}  // namespace detail

/// As the function of the same name in ellipse_ellipse.hpp; not certain where all digits tell as soon.
constexpr int discriminant_sign(const ContactCubic& p, Signs& signs) noexcept {
  const Leading<few_limbs> few = detail::discriminant<Leading<few_limbs>>(p);
  if (few.sign_is_certain()) return few.sign;
  signs.certain = detail::is_dense(p);
  if (!signs.certain) return 0;
  Signs by_offset;
  const int sign = detail::discriminant_sign_by_offset(p, by_offset);
  return by_offset.certain ? sign : detail::discriminant_sign_by_digits(p);
}

constexpr bool few_digits_tell_first_in_second(bool& inside, const ContactCubic& p) noexcept {
  using Few = Leading<few_limbs>;
  Signs signs;
  inside = detail::first_in_second<Few>(p, leading_small_parts<Few>(p), signs);
  return signs.certain;
}

/// As first_in_second() in ellipse_ellipse.hpp, of long coefficients.
constexpr bool long_first_in_second(const ContactCubic& p) noexcept {
  bool inside = false;
  if (few_digits_tell_first_in_second(inside, p)) return inside;
  const auto parts = exact_small_parts(p);
  Signs signs;
  inside = detail::first_in_second<Leading<few_limbs>>(p, parts, signs);
  return signs.certain ? inside : detail::digits_tell_first_in_second(p, parts);
}

}  // namespace vesica::exact
