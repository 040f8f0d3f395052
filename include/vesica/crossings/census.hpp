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
  const int order = exact::compare(p.d1, p.d2);
  if (order > 0) exact::detail::exchange_ellipses(p);
  if (order != 0 && exact::is_long(p) && p.c1.sign >= 0 && p.c2.sign >= 0) {
    if (exact::detail::surely_inside(p, p.d1 + p.d2 - p.mu)) return {0, 0, false};
  }
  const int roots = exact::discriminant_sign(p);
  if (roots < 0) return {2, 0, false};
  if (p.c1.sign < 0 || p.c2.sign < 0) return {0, roots > 0 ? 0 : 1, false};
  if (order != 0 && exact::detail::first_in_second(p)) {
    if (roots > 0 || exact::double_root_is_greater(p)) return {0, 0, false};
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

/// The coefficients of the contact cubic in rough numbers.
struct RoughCubic {
  Rough d1, c1, c2, d2, mu, al, be;
  Rough root1, root2;  ///< of d1 and d2

  explicit RoughCubic(const SeenEllipses& seen) noexcept {
    const Rough ea(seen.e.a), eb(seen.e.b), fa(seen.f.a), fb(seen.f.b);
    const Rough a0 = square(ea), a1 = square(eb), b0 = square(fa), b1 = square(fb);
    mu = square(Rough(seen.c)) * (a0 * b1 + a1 * b0) + square(Rough(seen.s)) * (a0 * b0 + a1 * b1);
    al = square(eb * Rough(seen.e_along)) + square(ea * Rough(seen.e_across));
    be = square(fb * Rough(seen.f_along)) + square(fa * Rough(seen.f_across));
    root1 = ea * eb * Rough(seen.uu);
    root2 = fa * fb * Rough(seen.ww);
    d1 = square(root1);
    d2 = square(root2);
    c1 = d1 + mu - al;
    c2 = d2 + mu - be;
  }
  void exchange() noexcept {
    std::swap(d1, d2);
    std::swap(c1, c2);
    std::swap(al, be);
  }
};

/// The census by rough numbers, without multiple roots.
class RoughCensus {
 public:
  explicit RoughCensus(const SeenEllipses& seen) noexcept : seen_(seen), p_(seen) {}

  /// False where rough numbers do not tell.
  bool tell(Census& census) noexcept {
    const int roots = sign(discriminant());
    if (!known_) return false;  // else it is not 0: its terms have an error
    census = {roots < 0 ? 2 : 0, 0, false};
    if (roots < 0) return true;
    if (sign(p_.c1) >= 0 && sign(p_.c2) >= 0) {
      const int order = seen_.order();
      if (order > 0) p_.exchange();
      if (order == 0 || !first_in_second()) census.crossing = 4;
    }
    return known_;
  }

 private:
  const SeenEllipses& seen_;
  RoughCubic p_;
  bool known_ = true;

  int sign(const Rough& x) noexcept {
    known_ = known_ && x.sign_is_known();
    return x.sign();
  }

  /// Three times the discriminant. Where all roots are nearly equal a, b and c are small, and so are their errors.
  Rough discriminant() const noexcept {
    const Rough &d1 = p_.d1, &c1 = p_.c1, &c2 = p_.c2, &d2 = p_.d2;
    const Rough a = square(c2) - times(3, d2 * c1), b = c1 * c2 - times(9, d1 * d2), c = square(c1) - times(3, d1 * c2);
    return times(4, a * c) - square(b);
  }
  /// As exact::detail::first_in_second, where its signs are known and not 0.
  bool first_in_second() noexcept {
    const Rough twice = times(2, p_.root1 * p_.root2), delta = (p_.mu - twice) * (p_.mu + twice);
    const Rough slope = times(2, p_.c2) - times(3, p_.mu), g = p_.d1 + p_.d2 - p_.mu;
    if (sign(slope) <= 0) return false;
    if (sign(square(slope) - times(9, delta)) > 0) return true;
    return sign(exact::detail::rise(p_, delta, g, p_.al - times(2, p_.be))) > 0;
  }
};

/// Rough numbers nearly always tell: all digits of long numbers are many.
inline bool census_is_known(const exact::Ellipse& e, const exact::Ellipse& f, Census& census) noexcept {
  if (exact::compare(e.cx, f.cx) == 0 && exact::compare(e.cy, f.cy) == 0) return false;
  const SeenEllipses seen(e, f);
  return RoughCensus(seen).tell(census);
}

inline Census census(const exact::Ellipse& e, const exact::Ellipse& f) noexcept {
  Census census;
  return census_is_known(e, f, census) ? census : exact_census(e, f);
}

}  // namespace vesica::detail::crossings
