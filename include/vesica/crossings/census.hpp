// SPDX-License-Identifier: Apache-2.0
/// How many places the outlines of two ellipses have in common, and how many of them only touch: signs of polynomials
/// in the coefficients of the contact cubic, from rough numbers where these tell, else exact.
#pragma once

#include <utility>
#include <vesica/crossings/rough.hpp>
#include <vesica/exact/ellipse_ellipse.hpp>

namespace vesica::detail::crossings {

/// Places at which the outlines cross, and at which they touch. Where they touch and cross at once (osculation) they
/// cross.
struct Census {
  int crossing, touching;
  bool equal;
};

/// With three equal roots of p, contact is of the highest order.
inline bool has_triple_root(const exact::ContactCubic& p) noexcept {
  return (exact::square(p.c2) - exact::integer(3) * (p.d2 * p.c1)).sign == 0;
}

/// With the double root x0 = -B / (2A) of p, whether S1 + x0 S2 has rank 1: d2 x0^2 + mu x0 + d1 = 0. Of nested
/// ellipses, these touch at two places. p'(x0) = c1 + 2 c2 x0 + 3 d2 x0^2 = 0 makes it (3 mu - 2 c2) x0 = c1 - 3 d1:
/// degree 24.
inline bool has_rank_one(const exact::ContactCubic& p) noexcept {
  const auto a = exact::square(p.c2) - exact::integer(3) * (p.d2 * p.c1);
  const auto b = p.c1 * p.c2 - exact::integer(9) * (p.d1 * p.d2);
  const exact::Number<8> left = exact::integer(2) * p.c2 - exact::integer(3) * p.mu;
  const exact::Number<8> right = exact::integer(2) * p.c1 - exact::integer(6) * p.d1;
  return exact::compare(left * b, right * a) == 0;
}

/// Of ellipses that have a multiple root and one of which contains the other, touching it.
inline Census touching_inside(const exact::ContactCubic& p) noexcept {
  return {0, !has_triple_root(p) && has_rank_one(p) ? 2 : 1, false};
}

/// The same distinctions as exact::relation makes, with the number of places.
VESICA_COLD inline Census exact_census(const exact::Ellipse& e, const exact::Ellipse& f) noexcept {
  exact::ContactCubic p = exact::contact_cubic(e, f);
  if (p.al.sign == 0) {
    switch (exact::detail::concentric(p)) {
      case Relation::cross:
        return {4, 0, false};
      case Relation::equal:
        return {0, 0, true};
      case Relation::inside_touch:
      case Relation::contains_touch:
        return {0, 2, false};
      default:
        return {0, 0, false};
    }
  }
  const int roots = exact::discriminant_sign(p);
  if (roots < 0) return {2, 0, false};
  if (p.c1.sign < 0 || p.c2.sign < 0) return {0, roots > 0 ? 0 : 1, false};
  const int order = exact::compare(p.d1, p.d2);
  if (order > 0) exact::detail::exchange_ellipses(p);
  if (order != 0 && exact::detail::first_in_second(p)) {
    if (roots > 0 || exact::detail::double_root_is_greater(p)) return {0, 0, false};
    return touching_inside(p);
  }
  if (roots > 0) return {4, 0, false};
  return has_triple_root(p) ? Census{2, 0, false} : Census{2, 1, false};
}

/// The coefficients of the contact cubic.
struct RoughCubic {
  Rough d1, c1, c2, d2, mu, al, be;

  RoughCubic(const exact::Ellipse& e, const exact::Ellipse& f) noexcept {
    const exact::Length dx = f.cx - e.cx, dy = f.cy - e.cy;
    const Rough c(exact::dot(e.ux, e.uy, f.ux, f.uy)), s(exact::cross(e.ux, e.uy, f.ux, f.uy));
    const Rough ea(e.a), eb(e.b), fa(f.a), fb(f.b), a0 = square(ea), a1 = square(eb), b0 = square(fa), b1 = square(fb);
    mu = square(c) * (a0 * b1 + a1 * b0) + square(s) * (a0 * b0 + a1 * b1);
    al = square(eb * Rough(exact::dot(e.ux, e.uy, dx, dy))) + square(ea * Rough(exact::cross(e.ux, e.uy, dx, dy)));
    be = square(fb * Rough(exact::dot(f.ux, f.uy, dx, dy))) + square(fa * Rough(exact::cross(f.ux, f.uy, dx, dy)));
    d1 = square(ea * eb * Rough(exact::dot(e.ux, e.uy, e.ux, e.uy)));
    d2 = square(fa * fb * Rough(exact::dot(f.ux, f.uy, f.ux, f.uy)));
    c1 = d1 + mu - al;
    c2 = d2 + mu - be;
  }
};

/// Signs of rough numbers, and whether all that were asked for were known.
struct RoughSigns {
  bool known = true;

  int operator()(const Rough& x) noexcept {
    known = known && x.sign_is_known();
    return x.sign();
  }
  /// Of a + b sqrt(delta), delta >= 0.
  int with_root(const Rough& a, const Rough& b, const Rough& delta) noexcept {
    const int sign_a = (*this)(a), sign_b = (*this)(b);
    if (sign_a == sign_b) return sign_a;
    return (*this)(square(b) * delta - square(a)) > 0 ? sign_b : sign_a;
  }
};

/// As exact::detail::first_in_second, where its signs are known and not 0.
inline bool first_in_second(const RoughCubic& p, RoughSigns& sign) noexcept {
  const Rough delta = square(p.mu) - times(4, p.d1 * p.d2), slope = times(2, p.c2) - times(3, p.mu);
  if (sign.with_root(slope, Rough(Real(-3.0), 0, 0), delta) > 0) return true;
  const Rough rest = slope * p.mu + times(2, p.d2 * (times(3, p.d1) - p.c1));
  return sign.with_root(rest, slope, delta) > 0;
}

/// Without multiple roots. False where rough numbers do not tell.
inline bool rough_census(const exact::Ellipse& e, const exact::Ellipse& f, Census& census) noexcept {
  if (exact::compare(e.cx, f.cx) == 0 && exact::compare(e.cy, f.cy) == 0) return false;
  RoughCubic p(e, f);
  const Rough a = square(p.c2) - times(3, p.d2 * p.c1), b = p.c1 * p.c2 - times(9, p.d1 * p.d2),
              c = square(p.c1) - times(3, p.d1 * p.c2), discriminant = times(4, a * c) - square(b);
  RoughSigns sign;
  const int roots = sign(discriminant);
  if (!sign.known || roots == 0) return false;
  if (roots < 0) {
    census = {2, 0, false};
    return true;
  }
  census = {0, 0, false};
  if (sign(p.c1) < 0 || sign(p.c2) < 0) return sign.known;
  const int order =
      exact::compare(e.a * e.b * exact::dot(e.ux, e.uy, e.ux, e.uy), f.a * f.b * exact::dot(f.ux, f.uy, f.ux, f.uy));
  if (order > 0) {
    std::swap(p.d1, p.d2);
    std::swap(p.c1, p.c2);
    std::swap(p.al, p.be);
  }
  if (order == 0 || !first_in_second(p, sign)) census = {4, 0, false};
  return sign.known;
}

inline Census census(const exact::Ellipse& e, const exact::Ellipse& f) noexcept {
  Census census;
  return rough_census(e, f, census) ? census : exact_census(e, f);
}

}  // namespace vesica::detail::crossings
