// SPDX-License-Identifier: Apache-2.0
/// Ellipse against ellipse, exactly, in closed form.
#pragma once

#include <vesica/exact/box_ellipse.hpp>
#include <vesica/relation_code.hpp>

namespace vesica::exact {

/// The cubic p(x) = d1 + c1 x + c2 x^2 + d2 x^3 that decides everything between two ellipses: they share a point
/// iff p(x) >= 0 for all x > 0. With S1, S2 the matrices of the ellipses, E = { K + z : z . S^-1 z <= 1 }, and D the
/// offset of centres, they share a point iff the Perram-Wertheim contact function D . (S1 / l + S2 / (1 - l))^-1 D
/// stays at most 1 on 0 < l < 1. With x = l / (1 - l), cleared of fractions, that is
/// p(x) = (1 + x) det(S1 + x S2) - x D . adj(S1 + x S2) D, where det = d1 + mu x + d2 x^2 and the rest al + be x.
/// J. W. Perram and M. S. Wertheim, J. Comput. Phys. 58 (1985) 409.
template <class Coefficient>
struct CubicOf {
  Coefficient d1, c1, c2, d2, mu, al, be;
};
using ContactCubic = CubicOf<Number<8>>;

inline ContactCubic contact_cubic(const Ellipse& e, const Ellipse& f) noexcept {
  const Length dx = f.cx - e.cx, dy = f.cy - e.cy;
  const auto c = dot(e.ux, e.uy, f.ux, f.uy), s = cross(e.ux, e.uy, f.ux, f.uy);
  const auto a0 = square(e.a), a1 = square(e.b), b0 = square(f.a), b1 = square(f.b);
  ContactCubic p;
  p.mu = square(c) * (a0 * b1 + a1 * b0) + square(s) * (a0 * b0 + a1 * b1);
  p.al = square(e.b * dot(e.ux, e.uy, dx, dy)) + square(e.a * cross(e.ux, e.uy, dx, dy));
  p.be = square(f.b * dot(f.ux, f.uy, dx, dy)) + square(f.a * cross(f.ux, f.uy, dx, dy));
  p.d1 = square(e.a * e.b * dot(e.ux, e.uy, e.ux, e.uy));
  p.d2 = square(f.a * f.b * dot(f.ux, f.uy, f.ux, f.uy));
  p.c1 = p.d1 + p.mu - p.al;
  p.c2 = p.d2 + p.mu - p.be;
  return p;
}

/// What the signs of a question's numbers say: of the coefficients' leading digits where these tell, else of all.
template <class Question>
auto decide(const ContactCubic& p, const Question& question) noexcept {
  Signs signs;
  if (p.c1.size > least_long || p.c2.size > least_long) {
    const auto answer = question(CubicOf<Leading>{p.d1, p.c1, p.c2, p.d2, p.mu, p.al, p.be}, signs);
    if (signs.certain) return answer;
  }
  return question(p, signs);
}

/// Sign of the discriminant of p, up to a positive factor: 1 for three real roots, 0 for a multiple one, -1 for a
/// single real root. Degree 32.
VESICA_COLD inline int discriminant_sign(const ContactCubic& cubic) noexcept {
  return decide(cubic, [](const auto& p, Signs& sign) {
    const Number<0> three = integer(3);
    const auto a = square(p.c2) - three * (p.d2 * p.c1);
    const auto b = p.c1 * p.c2 - integer(9) * (p.d1 * p.d2);
    const auto c = square(p.c1) - three * (p.d1 * p.c2);
    return sign.of_product_less_square(integer(4) * a, c, b);
  });
}

/// Whether two ellipses share a point: both inner coefficients non-negative, or a discriminant that is not positive
/// (p has one real root, which is negative, or a multiple one).
inline bool overlap(const Ellipse& e, const Ellipse& f) noexcept {
  if (degenerate(e)) return overlap(as_box(e), f);
  if (degenerate(f)) return overlap(as_box(f), e);
  const ContactCubic p = contact_cubic(e, f);
  if (p.c1.sign >= 0 && p.c2.sign >= 0) return true;
  return discriminant_sign(p) <= 0;
}

namespace detail {

/// Sign of a + b sqrt(delta), delta >= 0.
template <class A, class B, class Delta>
int sign_with_root(const A& a, const B& b, const Delta& delta, Signs& sign) noexcept {
  const int sign_a = sign.of(a), root_sign = sign.of(delta) == 0 ? 0 : sign.of(b);
  if (sign_a * root_sign >= 0) return sign_a + root_sign > 0 ? 1 : sign_a + root_sign < 0 ? -1 : 0;
  return root_sign * sign.of_product_less_square(square(b), delta, a);
}

/// Ellipses about one centre, where p(x) = (1 + x) det(S1 + x S2): one contains the other iff S2 - S1 is semidefinite,
/// and touches it iff that is singular.
inline Relation concentric(const ContactCubic& p) noexcept {
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
/// positive factors are numbers a + b sqrt(delta). Degree 32.
VESICA_COLD inline bool first_in_second(const ContactCubic& cubic) noexcept {
  return decide(cubic, [](const auto& p, Signs& sign) {
    const Number<0> two = integer(2), three = integer(3);
    const auto delta = square(p.mu) - integer(4) * (p.d1 * p.d2);
    const auto slope = two * p.c2 - three * p.mu;
    if (sign_with_root(slope, integer(-3), delta, sign) > 0) return true;  // q''
    const auto rest = slope * p.mu + two * (p.d2 * (three * p.d1 - p.c1));
    const int rising = sign_with_root(rest, slope, delta, sign);  // q'
    if (rising != 0) return rising > 0;
    const auto minus_be = integer(-1) * p.be;
    return sign_with_root(two * (p.d2 * p.al) + minus_be * p.mu, minus_be, delta, sign) == 0;  // q
  });
}

/// Whether a double root of p is the greater of its roots, so that p'' > 0 there: x0 = -b / (2a) > -c2 / (3 d2), a > 0
/// unless the root is triple, and then both sides are 0. Degree 24.
inline bool double_root_is_greater(const ContactCubic& p) noexcept {
  const auto a = square(p.c2) - integer(3) * (p.d2 * p.c1);
  const auto b = p.c1 * p.c2 - integer(9) * (p.d1 * p.d2);
  return compare(integer(2) * (p.c2 * a), integer(3) * (p.d2 * b)) > 0;
}

inline void exchange(Number<8>& a, Number<8>& b) noexcept {
  const Number<8> first = a;
  a = b;
  b = first;
}

/// The cubic with the ellipses in the other order; in place, since a copy would be large.
inline void exchange_ellipses(ContactCubic& p) noexcept {
  exchange(p.d1, p.d2);
  exchange(p.c1, p.c2);
  exchange(p.al, p.be);
}

}  // namespace detail

/// How two ellipses relate, neither degenerate. If p has a multiple root and one ellipse contains the other, they
/// touch, with one exception: ellipses that are a projective image of two concentric circles. Then, and only then, the
/// double root of q is the pair of lower roots, which enclose y+ whenever one ellipse contains the other.
inline Relation relation(const Ellipse& e, const Ellipse& f) noexcept {
  ContactCubic p = contact_cubic(e, f);
  if (p.al.sign == 0) return detail::concentric(p);
  const int roots = discriminant_sign(p);
  if (roots < 0) return Relation::cross;
  if (p.c1.sign < 0 || p.c2.sign < 0) return roots > 0 ? Relation::disjoint : Relation::touch;
  const int order = compare(p.d1, p.d2);
  if (order == 0) return Relation::cross;  // only the same ellipse could lie within one of its area
  if (order > 0) detail::exchange_ellipses(p);
  if (!detail::first_in_second(p)) return Relation::cross;
  const bool apart = roots > 0 || detail::double_root_is_greater(p);
  const Relation inside = apart ? Relation::inside : Relation::inside_touch;
  return order < 0 ? inside : converse(inside);
}

}  // namespace vesica::exact
