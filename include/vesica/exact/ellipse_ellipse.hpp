// SPDX-License-Identifier: Apache-2.0
/// Ellipse against ellipse, exactly, in closed form.
#pragma once

#include <vesica/exact/box_ellipse.hpp>
#include <vesica/exact/contact_cubic.hpp>
#include <vesica/exact/discriminant.hpp>
#include <vesica/relation_code.hpp>

namespace vesica::exact {

namespace detail {

/// The contact of the ellipses of a cubic. Their insides meet if p > 0 for all x > 0: if both inner coefficients are
/// non-negative, or p has one real root, which is negative. They touch if p has a multiple root.
constexpr int contact(const Cubic& p) noexcept { return p.c1.sign >= 0 && p.c2.sign >= 0 ? -1 : discriminant_sign(p); }

/// The contact of ellipses that are not degenerate. Not inlined: boxes do not need this stack.
VESICA_CALLED constexpr int contact_by_cubic(const Ellipse& e, const Ellipse& f) noexcept {
  const Cubic p = cubic(e, f);
  return contact(p);
}

}  // namespace detail

/// The contact of two ellipses, or one that counts already.
constexpr int contact(const Ellipse& e, const Ellipse& f, Common common) noexcept {
  if (degenerate(e)) return contact(as_box(e), f, common);
  if (degenerate(f)) return contact(as_box(f), e, common);
  return detail::contact_by_cubic(e, f);
}

/// True if two ellipses share a point.
constexpr bool overlap(const Ellipse& e, const Ellipse& f) noexcept { return contact(e, f, Common::any) <= 0; }

namespace detail {

/// Ellipses about one centre, where p(x) = (1 + x) det(S1 + x S2): one contains the other iff S2 - S1 is semidefinite,
/// and touches it iff that is singular.
constexpr Relation concentric(const ContactCubic& p) noexcept {
  const int order = compare(p.d1, p.d2), det = compare(p.d1 + p.d2, p.mu);
  if (det < 0) return Relation::cross;
  if (order == 0) return Relation::equal;  // mu >= 2 sqrt(d1 d2), with equality iff S1 and S2 are proportional
  if (order < 0) return det > 0 ? Relation::inside : Relation::inside_touch;
  return det > 0 ? Relation::contains : Relation::contains_touch;
}

/// mu^2 - 4 d1 d2.
constexpr Number<16> delta(const ContactCubic& p) noexcept {
  return difference_of_multiples(1, p.mu, p.mu, 4, p.d1, p.d2);
}

// The numbers of first_in_second(), one function each, so that they share stack.

/// 2 c2 - 3 mu.
VESICA_CALLED constexpr Number<8> slope_of(const ContactCubic& p) noexcept {
  return integer(2) * p.c2 - integer(3) * p.mu;
}

/// Sign of slope - 3 sqrt(delta), which q''(y+) has.
VESICA_CALLED constexpr int bend_sign(const ContactCubic& p, const Number<8>& slope) noexcept {
  return sign_with_root(slope, integer(-3), delta(p));
}
/// Sign of slope^2 delta - rest^2 with rest = slope mu + 2 d2 turn, without the factor 4 d2: q'(y+) has it.
VESICA_CALLED constexpr int rise_sign(const ContactCubic& p, const Number<8>& slope) noexcept {
  const Number<8> turn = integer(3) * p.d1 - p.c1;
  return compare_products(-turn, sum_of_products(p.mu, slope, 1, p.d2, turn), p.d1, square(slope));
}
/// True if q(y+) is 0.
VESICA_CALLED constexpr bool reaches_zero(const ContactCubic& p) noexcept {
  return sign_with_root(difference_of_multiples(2, p.d2, p.al, 1, p.be, p.mu), -p.be, delta(p)) == 0;
}

/// True if the first ellipse lies in the second, for ellipses that overlap without a common centre, the first of lesser
/// area, c1, c2 >= 0 and p with three real roots (counted with multiplicity). The following shows that three signs, of
/// numbers a + b sqrt(delta), decide it; so containment needs no root to be computed.
///
/// By the S-lemma it does iff q(y) = p(-y) = (1 - y) det M - y D . adj(M) D reaches 0 for some y at which M = y S2 - S1
/// is positive semidefinite, that is from y+ = (mu + sqrt(mu^2 - 4 d1 d2)) / (2 d2) on. There q <= 0, so q must rise at
/// or beyond y+ to a local maximum; with three real roots that maximum is not negative. q'(y+), q''(y+) and q(y+) times
/// positive factors are numbers a + b sqrt(delta). Of q', rest + slope sqrt(delta), the rest is negative: where
/// S1 = diag(s, t), S2 = 1 and D = (x, y) it is -2 (s x^2 + t y^2) - (s - t)^2. So q' has the sign of
/// slope^2 delta - rest^2, which has the factor 4 d2. Degree 32.
VESICA_CALLED constexpr bool first_in_second(const ContactCubic& p) noexcept {
  const Number<8> slope = slope_of(p);
  if (slope.sign <= 0) return false;
  if (bend_sign(p, slope) > 0) return true;
  const int rising = rise_sign(p, slope);
  return rising != 0 ? rising > 0 : reaches_zero(p);
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

/// The relation of the lesser ellipse to the other, of ellipses as for first_in_second(), but with any roots. If p has
/// a multiple root they touch, with one exception: ellipses that are a projective image of two concentric circles.
/// Then, and only then, the double root of q is the pair of lower roots, which enclose y+ whenever one ellipse contains
/// the other.
constexpr Relation nesting(const ContactCubic& p) noexcept {
  const int roots = discriminant_sign(p);
  if (roots < 0 || !first_in_second(p)) return Relation::cross;
  return roots > 0 || double_root_is_greater(p) ? Relation::inside : Relation::inside_touch;
}

}  // namespace detail

/// How the two ellipses of a cubic relate, which may be left with them exchanged.
constexpr Relation relation(ContactCubic& p) noexcept {
  if (p.al.sign == 0) return detail::concentric(p);
  if (p.c1.sign < 0 || p.c2.sign < 0) {
    const int roots = discriminant_sign(p);
    return roots < 0 ? Relation::cross : roots > 0 ? Relation::disjoint : Relation::touch;
  }
  // Their insides meet. Each is wider than the other in some direction where S2 - S1 is indefinite.
  if (compare(p.d1 + p.d2, p.mu) < 0) return Relation::cross;
  const int order = compare(p.d1, p.d2);
  if (order == 0) return Relation::cross;  // only the same ellipse could lie within one of its area
  if (order > 0) detail::exchange_ellipses(p);
  const Relation of_lesser = detail::nesting(p);
  return order < 0 ? of_lesser : converse(of_lesser);
}

/// How two ellipses relate, neither degenerate.
constexpr Relation relation(const Ellipse& e, const Ellipse& f) noexcept {
  ContactCubic p = contact_cubic(e, f);
  return relation(p);
}

}  // namespace vesica::exact
