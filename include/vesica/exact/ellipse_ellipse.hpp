// SPDX-License-Identifier: Apache-2.0
/// Ellipse against ellipse, exactly, in closed form.
#pragma once

#include <vesica/exact/box_ellipse.hpp>
#include <vesica/exact/contact_cubic.hpp>
#include <vesica/exact/discriminant.hpp>
#include <vesica/exact/long_containment.hpp>
#include <vesica/relation_code.hpp>

namespace vesica::exact {

namespace detail {

/// Of ellipses that are not degenerate: both inner coefficients non-negative, or a discriminant that is not positive (p
/// has one real root, which is negative, or a multiple one). A function of its own, as its numbers take stack that
/// boxes do not need.
VESICA_CALLED constexpr bool overlap_by_cubic(const Ellipse& e, const Ellipse& f) noexcept {
  const ContactCubic p = contact_cubic(e, f);
  if (p.c1.sign >= 0 && p.c2.sign >= 0) return true;
  return discriminant_sign(p) <= 0;
}

}  // namespace detail

/// Whether two ellipses share a point.
constexpr bool overlap(const Ellipse& e, const Ellipse& f) noexcept {
  if (degenerate(e)) return overlap(as_box(e), f);
  if (degenerate(f)) return overlap(as_box(f), e);
  return detail::overlap_by_cubic(e, f);
}

namespace detail {

/// Sign of a + b sqrt(delta), delta >= 0.
template <int A, int B, int D>
constexpr int sign_with_root(const Number<A>& a, const Number<B>& b, const Number<D>& delta) noexcept {
  const int root_sign = delta.sign == 0 ? 0 : b.sign;
  if (a.sign * root_sign >= 0) return a.sign + root_sign > 0 ? 1 : a.sign + root_sign < 0 ? -1 : 0;
  return root_sign * compare_squares_times(b, delta, a, integer(1));
}

/// Ellipses about one centre, where p(x) = (1 + x) det(S1 + x S2): one contains the other iff S2 - S1 is semidefinite,
/// and touches it iff that is singular.
constexpr Relation concentric(const ContactCubic& p) noexcept {
  const int order = compare(p.d1, p.d2), det = compare(p.d1 + p.d2, p.mu);
  if (det < 0) return Relation::cross;
  if (order == 0) return Relation::equal;  // mu >= 2 sqrt(d1 d2), with equality iff S1 and S2 are proportional
  if (order < 0) return det > 0 ? Relation::inside : Relation::inside_touch;
  return det > 0 ? Relation::contains : Relation::contains_touch;
}

/// Whether the first ellipse lies in the second, for ellipses that overlap without a common centre, the first of lesser
/// area, c1, c2 >= 0 and p with three real roots (counted with multiplicity). The following shows that three signs, of
/// numbers a + b sqrt(delta), decide it; so containment needs no root to be computed.
///
/// By the S-lemma it does iff q(y) = p(-y) = (1 - y) det M - y D . adj(M) D reaches 0 for some y at which M = y S2 - S1
/// is positive semidefinite, that is from y+ = (mu + sqrt(mu^2 - 4 d1 d2)) / (2 d2) on. There q <= 0, so q must rise at
/// or beyond y+ to a local maximum; with three real roots that maximum is not negative. q'(y+), q''(y+) and q(y+) times
/// positive factors are numbers a + b sqrt(delta). Of q', rest + slope sqrt(delta), the rest is negative: where
/// S1 = diag(s, t), S2 = 1 and D = (x, y) it is -2 (s x^2 + t y^2) - (s - t)^2. So q' has the sign of
/// slope^2 delta - rest^2, of which 4 d2 is a factor. Degree 32.
VESICA_CALLED constexpr bool first_in_second(const ContactCubic& p) noexcept {
  if (is_long(p)) return long_first_in_second(p);
  const Number<0> two = integer(2), three = integer(3);
  const Number<16> delta = square(p.mu) - integer(4) * (p.d1 * p.d2);
  const Number<8> slope = two * p.c2 - three * p.mu;
  if (slope.sign <= 0) return false;
  if (sign_with_root(slope, integer(-3), delta) > 0) return true;  // q''
  // rest = slope mu + 2 d2 turn
  const Number<8> turn = three * p.d1 - p.c1;
  const Number<24> falling = p.d1 * square(slope) + turn * (p.mu * slope + p.d2 * turn);
  if (falling.sign != 0) return falling.sign < 0;  // q'
  const Number<8> minus_be = integer(-1) * p.be;
  return sign_with_root(two * (p.d2 * p.al) + minus_be * p.mu, minus_be, delta) == 0;  // q
}

/// Whether the first ellipse certainly lies in the inside of the second, by one y and a few leading digits: M is
/// positive definite and q(y) > 0 (see above). So ellipses about nearly one centre are told that are nearly similar: of
/// these the discriminant and first_in_second() are nearly 0. 1 - y is a power of two, an eighth to a half of
/// 1 - mu / (2 d2), which is 1 - y+ for similar ellipses. difference: det(S2 - S1).
constexpr bool surely_inside(const ContactCubic& p, const Number<8>& difference) noexcept {
  using Few = Leading<few_limbs>;
  const Number<8> twice = integer(2) * p.d2, gap = twice - p.mu;
  if (gap.sign <= 0) return false;
  const auto halvings = static_cast<int>(top_bit(twice) - top_bit(gap));
  // As a whole number y could be longer than all others here.
  const Few t(from_double(1, -2 - halvings)), y = Few(integer(1)) - t, d2(p.d2), al(p.al), be(p.be);
  const Few determinant = Few(difference) - t * Few(gap) + square(t) * d2;
  const auto positive = [](const Few& x) { return x.sign > 0 && x.sign_is_certain(); };
  return positive(determinant) && positive(times(2, y * d2) - Few(p.mu)) &&
         positive(t * determinant - y * (y * be - al));
}

constexpr void exchange(Number<8>& a, Number<8>& b) noexcept {
  const Number<8> first = a;
  a = b;
  b = first;
}

/// The cubic with the ellipses in the other order; in place, since a copy would be large.
constexpr void exchange_ellipses(ContactCubic& p) noexcept {
  exchange(p.d1, p.d2);
  exchange(p.c1, p.c2);
  exchange(p.al, p.be);
}

/// The relation to the other of an ellipse for which first_in_second() is true, by the sign of the discriminant. If p
/// has a multiple root they touch, with one exception: ellipses that are a projective image of two concentric circles.
/// Then, and only then, the double root of q is the pair of lower roots, which enclose y+ whenever one ellipse contains
/// the other.
constexpr Relation nesting_with(int roots, const ContactCubic& p) noexcept {
  if (roots < 0) return Relation::cross;
  return roots > 0 || double_root_is_greater(p) ? Relation::inside : Relation::inside_touch;
}

/// Of ellipses as for first_in_second(), but with any roots.
constexpr Relation nesting(const ContactCubic& p) noexcept {
  const int roots = discriminant_sign(p);
  return roots < 0 || !first_in_second(p) ? Relation::cross : nesting_with(roots, p);
}
/// Of long coefficients: what few digits tell goes first, and containment before the number of roots, since ellipses
/// that all but coincide mostly cross. Whatever p's roots are, first_in_second() is false of no ellipse that is in the
/// other.
constexpr Relation long_nesting(const ContactCubic& p, const Number<8>& determinant) noexcept {
  if (surely_inside(p, determinant)) return Relation::inside;
  bool contained = false;
  const bool is_known = few_digits_tell_first_in_second(contained, p);
  if (is_known && !contained) return Relation::cross;
  const Leading<few_limbs> few = few_digits_of_discriminant(p);
  const bool are_roots_known = few.sign_is_certain();
  if (are_roots_known && few.sign < 0) return Relation::cross;
  if (!is_known && !more_digits_tell_first_in_second(p, determinant)) return Relation::cross;
  return nesting_with(are_roots_known ? few.sign : more_digits_tell_discriminant(p, few), p);
}

}  // namespace detail

/// How two ellipses relate, neither degenerate.
constexpr Relation relation(const Ellipse& e, const Ellipse& f) noexcept {
  ContactCubic p = contact_cubic(e, f);
  if (p.al.sign == 0) return detail::concentric(p);
  if (p.c1.sign < 0 || p.c2.sign < 0) {
    const int roots = discriminant_sign(p);
    return roots < 0 ? Relation::cross : roots > 0 ? Relation::disjoint : Relation::touch;
  }
  // Their insides meet. Each is wider than the other in some direction where S2 - S1 is indefinite.
  const Number<8> determinant = p.d1 + p.d2 - p.mu;
  if (determinant.sign < 0) return Relation::cross;
  const int order = compare(p.d1, p.d2);
  if (order == 0) return Relation::cross;  // only the same ellipse could lie within one of its area
  if (order > 0) detail::exchange_ellipses(p);
  const Relation of_lesser = is_long(p) ? detail::long_nesting(p, determinant) : detail::nesting(p);
  return order < 0 ? of_lesser : converse(of_lesser);
}

}  // namespace vesica::exact
