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

/// What the contact cubic is made of: products of axes and of the offset of centres.
struct SeenEllipses {
  const exact::Ellipse &e, &f;
  exact::Number<2> c, s, uu, ww;
  exact::Number<2> e_along, e_across, f_along, f_across;  ///< the offset by either axis

  SeenEllipses(const exact::Ellipse& first, const exact::Ellipse& second) noexcept
      : SeenEllipses(first, second, second.cx - first.cx, second.cy - first.cy) {}
  bool is_long() const noexcept {
    return exact::is_long(c) || exact::is_long(s) || exact::is_long(e_along) || exact::is_long(f_along);
  }
  /// Of their areas.
  int order() const noexcept {
    const auto difference = [](const auto& a, const auto& b, const auto& axis, const auto& p, const auto& q,
                               const auto& other) { return a * b * axis - p * q * other; };
    return exact::sign_of(difference, e.a, e.b, uu, f.a, f.b, ww);
  }

 private:
  SeenEllipses(const exact::Ellipse& first, const exact::Ellipse& second, const exact::Length& dx,
               const exact::Length& dy) noexcept
      : e(first),
        f(second),
        c(exact::dot(e.ux, e.uy, f.ux, f.uy)),
        s(exact::cross(e.ux, e.uy, f.ux, f.uy)),
        uu(exact::dot(e.ux, e.uy, e.ux, e.uy)),
        ww(exact::dot(f.ux, f.uy, f.ux, f.uy)),
        e_along(exact::dot(e.ux, e.uy, dx, dy)),
        e_across(exact::cross(e.ux, e.uy, dx, dy)),
        f_along(exact::dot(f.ux, f.uy, dx, dy)),
        f_across(exact::cross(f.ux, f.uy, dx, dy)) {}
};

/// The coefficients of the contact cubic in numbers with a bound on their error.
template <class Bounded>
struct BoundedCubic {
  Bounded d1, c1, c2, d2, mu, al, be;

  explicit BoundedCubic(const SeenEllipses& seen) noexcept {
    const Bounded ea(seen.e.a), eb(seen.e.b), fa(seen.f.a), fb(seen.f.b);
    const Bounded a0 = square(ea), a1 = square(eb), b0 = square(fa), b1 = square(fb);
    mu = square(Bounded(seen.c)) * (a0 * b1 + a1 * b0) + square(Bounded(seen.s)) * (a0 * b0 + a1 * b1);
    al = square(eb * Bounded(seen.e_along)) + square(ea * Bounded(seen.e_across));
    be = square(fb * Bounded(seen.f_along)) + square(fa * Bounded(seen.f_across));
    d1 = square(ea * eb * Bounded(seen.uu));
    d2 = square(fa * fb * Bounded(seen.ww));
    c1 = d1 + mu - al;
    c2 = d2 + mu - be;
  }
};

/// Signs of such numbers, and whether all that were asked for were known.
struct KnownSigns {
  bool known = true;

  int operator()(const Rough& x) noexcept {
    known = known && x.sign_is_known();
    return x.sign();
  }
  template <int limbs>
  int operator()(const exact::Leading<limbs>& x) noexcept {
    known = known && x.sign_is_certain();
    return x.sign;
  }
  /// Of a + b sqrt(delta), delta >= 0.
  template <class Bounded>
  int with_root(const Bounded& a, const Bounded& b, const Bounded& delta) noexcept {
    const int sign_a = (*this)(a), sign_b = (*this)(b);
    if (sign_a == sign_b) return sign_a;
    return (*this)(square(b) * delta - square(a)) > 0 ? sign_b : sign_a;
  }
};

/// As exact::detail::first_in_second, where its signs are known and not 0.
template <class Bounded>
bool first_in_second(const BoundedCubic<Bounded>& p, KnownSigns& sign) noexcept {
  const Bounded delta = square(p.mu) - times(4, p.d1 * p.d2), slope = times(2, p.c2) - times(3, p.mu);
  if (sign.with_root(slope, Bounded(exact::integer(-3)), delta) > 0) return true;
  const Bounded rest = slope * p.mu + times(2, p.d2 * (times(3, p.d1) - p.c1));
  return sign.with_root(rest, slope, delta) > 0;
}

/// Without multiple roots. False where such numbers do not tell.
template <class Bounded>
bool bounded_census(const SeenEllipses& seen, Census& census) noexcept {
  BoundedCubic<Bounded> p(seen);
  const Bounded a = square(p.c2) - times(3, p.d2 * p.c1), b = p.c1 * p.c2 - times(9, p.d1 * p.d2),
                c = square(p.c1) - times(3, p.d1 * p.c2), discriminant = times(4, a * c) - square(b);
  KnownSigns sign;
  const int roots = sign(discriminant);
  if (!sign.known || roots == 0) return false;
  if (roots < 0) {
    census = {2, 0, false};
    return true;
  }
  census = {0, 0, false};
  if (sign(p.c1) < 0 || sign(p.c2) < 0) return sign.known;
  const int order = seen.order();
  if (order > 0) {
    std::swap(p.d1, p.d2);
    std::swap(p.c1, p.c2);
    std::swap(p.al, p.be);
  }
  if (order == 0 || !first_in_second(p, sign)) census = {4, 0, false};
  return sign.known;
}

/// Rough numbers tell where little cancels, leading digits where more does: all digits of long numbers are many.
inline bool census_is_known(const exact::Ellipse& e, const exact::Ellipse& f, Census& census) noexcept {
  if (exact::compare(e.cx, f.cx) == 0 && exact::compare(e.cy, f.cy) == 0) return false;
  const SeenEllipses seen(e, f);
  if (bounded_census<Rough>(seen, census)) return true;
  return seen.is_long() && bounded_census<exact::Leading<exact::few_limbs>>(seen, census);
}

inline Census census(const exact::Ellipse& e, const exact::Ellipse& f) noexcept {
  Census census;
  return census_is_known(e, f, census) ? census : exact_census(e, f);
}

}  // namespace vesica::detail::crossings
