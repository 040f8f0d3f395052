// SPDX-License-Identifier: Apache-2.0
/// Signs about two ellipses from leading digits, where exponents are wildly unlike and all digits would take hundreds of
/// microseconds.
#pragma once

#include <vesica/exact/contact_cubic.hpp>
#include <vesica/exact/leading.hpp>

namespace vesica::exact {

inline bool is_long(const ContactCubic& p) noexcept { return is_long(p.c1) || is_long(p.c2); }

/// What may be far smaller than its terms, formed exactly: delta = mu^2 - 4 d1 d2, which is 0 iff S1 and S2 are
/// proportional, and g = d1 + d2 - mu = det(S1 - S2).
struct SmallParts {
  Number<16> delta;
  Number<8> g, al_less_be, al_less_2be;

  explicit SmallParts(const ContactCubic& p) noexcept
      : delta(square(p.mu) - integer(4) * (p.d1 * p.d2)),
        g(p.d1 + p.d2 - p.mu),
        al_less_be(p.al - p.be),
        al_less_2be(p.al - integer(2) * p.be) {}
};

namespace detail {

/// The discriminant from the cubic's coefficients.
template <class Real>
Real discriminant(const ContactCubic& p) noexcept {
  const Real d1(p.d1), c1(p.c1), c2(p.c2), d2(p.d2);
  const Real a = square(c2) - times(3, d2 * c1), b = c1 * c2 - times(9, d1 * d2), c = square(c1) - times(3, d1 * c2);
  return times(4, a * c) - square(b);
}

/// A third of it, in powers of al and be: with both 0 it is delta g^2. So nothing cancels where the ellipses' centres
/// are close to each other, as seen from an ellipse that is large or thin.
template <class Real>
Real discriminant_by_offset(const ContactCubic& p, const SmallParts& small) noexcept {
  const Real d1(p.d1), d2(p.d2), mu(p.mu), al(p.al), be(p.be), delta(small.delta), g(small.g);
  const Real al_al = square(al), be_be = square(be), al_be = al * be, d1_d2 = d1 * d2;
  const Real linear = g * (al * d2 * (times(2, d1) - mu) + be * d1 * (times(2, d2) - mu)) +
                      delta * (times(2, be * g) + Real(small.al_less_be) * (times(3, d2) - d1 - mu));
  const Real rest = square(mu) - times(12, d1_d2);
  const Real quadratic = al_al * (d2 * (d2 - times(10, mu)) + rest) + be_be * (d1 * (d1 - times(10, mu)) + rest) +
                         al_be * (times(22, d1_d2) + times(4, mu) * (d1 + d2 + mu));
  const Real cubic = al_al * (be * (d2 + mu) - times(2, al * d2)) + be_be * (al * (d1 + mu) - times(2, be * d1));
  return delta * square(g) + times(2, linear) + quadratic - times(2, cubic) + square(al_be);
}

/// The same for proportional S1 and S2 with offset centres, over factors that are positive: a degree of 16.
template <class Real>
Real discriminant_of_proportional(const ContactCubic& p) noexcept {
  const Real al(p.al), mu(p.mu), twice_d1(integer(2) * p.d1);
  return square(twice_d1 - mu) + times(4, al * (al - twice_d1 - mu));
}

/// With r = d2 al - be mu and h = al - 2 be: q' is a positive multiple of 2 r - delta + slope sqrt(delta), and
/// slope^2 delta - (2 r - delta)^2 = 4 d2 (delta (g + h) + h (2 be d1 - al d2) - 2 al be g).
template <class Real>
bool first_in_second(const ContactCubic& p, const SmallParts& small, Signs& signs) noexcept {
  const Real d2(p.d2), mu(p.mu), al(p.al), be(p.be), delta(small.delta);
  const Real slope = times(2, Real(p.c2)) - times(3, mu);
  const int slope_sign = signs.of(slope), delta_sign = signs.of(delta);
  if (slope_sign > 0 && (delta_sign == 0 || signs.of(square(slope) - times(9, delta)) > 0)) return true;
  const int rest_sign = signs.of(times(2, d2 * al - be * mu) - delta);
  int rising = rest_sign;
  if (delta_sign != 0 && slope_sign != rest_sign && slope_sign != 0) {
    const Real g(small.g), h(small.al_less_2be);
    const Real difference = delta * (g + h) + h * (times(2, be * Real(p.d1)) - al * d2) - times(2, al * be * g);
    rising = rest_sign == 0 ? slope_sign : slope_sign * signs.of(difference);
  }
  if (rising == 0) signs.certain = false;  // a tie
  return rising > 0;
}

}  // namespace detail

/// As the functions of the same names in ellipse_ellipse.hpp; not certain where the leading digits do not tell.
inline int discriminant_sign(const ContactCubic& p, Signs& signs) noexcept {
  using Few = Leading<few_limbs>;
  using Some = Leading<some_limbs>;
  using More = Leading<more_limbs>;
  const Few few = detail::discriminant<Few>(p);
  if (few.sign_is_certain()) return few.sign;
  const SmallParts small(p);
  if (small.delta.sign == 0) return signs.of(detail::discriminant_of_proportional<More>(p));
  const Few by_offset = detail::discriminant_by_offset<Few>(p, small);
  if (by_offset.sign_is_certain()) return by_offset.sign;
  const Some some = detail::discriminant<Some>(p);
  return some.sign_is_certain() ? some.sign : signs.of(detail::discriminant<More>(p));
}

inline bool first_in_second(const ContactCubic& p, Signs& signs) noexcept {
  const SmallParts small(p);
  Signs of_few, of_some;
  const bool by_few = detail::first_in_second<Leading<few_limbs>>(p, small, of_few);
  if (of_few.certain) return by_few;
  const bool by_some = detail::first_in_second<Leading<some_limbs>>(p, small, of_some);
  return of_some.certain ? by_some : detail::first_in_second<Leading<more_limbs>>(p, small, signs);
}

}  // namespace vesica::exact
