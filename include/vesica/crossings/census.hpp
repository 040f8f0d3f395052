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
  bool exchanged = false;

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
    exchanged = true;
    std::swap(d1, d2);
    std::swap(c1, c2);
    std::swap(al, be);
  }
};

/// The census by rough numbers, without multiple roots. What may be far smaller than its terms is formed again, from
/// exact factors, where its sign is not known: most cancels in their differences.
class RoughCensus {
 public:
  explicit RoughCensus(const SeenEllipses& seen) noexcept : seen_(seen), p_(seen) {}

  /// False where rough numbers do not tell.
  bool tell(Census& census) noexcept {
    const int roots = sign(discriminant());
    if (!known_) return false;  // else it is not 0: its terms have an error
    census = {roots < 0 ? 2 : 0, 0, false};
    if (roots < 0) return true;
    if (!p_.c1.sign_is_known() || !p_.c2.sign_is_known()) form_again();
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

  void form_again() noexcept {
    if (!p_.c1.is_precise()) p_.c1 = inner(seen_.e, seen_.uu, seen_.e_along, seen_.e_across, seen_.f);
    if (!p_.c2.is_precise()) p_.c2 = inner(seen_.f, seen_.ww, seen_.f_along, seen_.f_across, seen_.e);
  }
  /// Three times the discriminant. Where all roots are nearly equal a, b and c are small, and so are their errors.
  Rough discriminant() const noexcept {
    const Rough &d1 = p_.d1, &c1 = p_.c1, &c2 = p_.c2, &d2 = p_.d2;
    const Rough a = square(c2) - times(3, d2 * c1), b = c1 * c2 - times(9, d1 * d2), c = square(c1) - times(3, d1 * c2);
    return times(4, a * c) - square(b);
  }
  /// As exact::detail::first_in_second, where its signs are known and not 0.
  bool first_in_second() noexcept {
    const Rough delta = delta_less() * delta_more(), slope = times(2, p_.c2) - times(3, p_.mu);
    if (sign(slope) <= 0) return false;
    if (sign(square(slope) - times(9, delta)) > 0) return true;
    return sign(exact::detail::rise(p_, delta, determinant(), al_less_be() - p_.be)) > 0;
  }

  /// d1 + mu - al = a^2 ((c g)^2 + (s h)^2 - across^2) + b^2 ((c h)^2 + (s g)^2 - along^2) + (a b V)^2 for half lengths
  /// h and g of the other ellipse.
  Rough inner(const exact::Ellipse& e, const Position& axis, const Position& along, const Position& across,
              const exact::Ellipse& other) const noexcept {
    const exact::Number<2>&c = seen_.c, &s = seen_.s;
    const exact::Number<3> ch = other.a * c, cg = other.b * c, sh = other.a * s, sg = other.b * s;
    const bool by_across = is_greater(e.a * across, e.b * along);
    const Rough by_a = by_across ? squares_less(across, e.b * axis, cg, sh) : squares_less(across, cg, sh);
    const Rough by_b = by_across ? squares_less(along, ch, sg) : squares_less(along, e.a * axis, ch, sg);
    return square(Rough(e.a)) * by_a + square(Rough(e.b)) * by_b;
  }
  Rough al_less_be() const noexcept {
    const Rough plain = p_.al - p_.be;
    if (plain.is_precise()) return plain;
    const exact::Ellipse &e = seen_.e, &f = seen_.f;
    const exact::Number<3> x = e.b * seen_.e_along, y = e.a * seen_.e_across;
    const bool by_x = is_greater(x, y);
    const Rough be_less_al =
        squares_less(by_x ? x : y, f.b * seen_.f_along, f.a * seen_.f_across) - square(Rough(by_x ? y : x));
    return p_.exchanged ? be_less_al : -be_less_al;
  }
  /// mu - 2 sqrt(d1 d2) = (c (ea fb - eb fa))^2 + (s (ea fa - eb fb))^2.
  Rough delta_less() const noexcept {
    const Rough plain = p_.mu - times(2, p_.root1 * p_.root2);
    if (plain.is_precise()) return plain;
    const exact::Ellipse &e = seen_.e, &f = seen_.f;
    return square(Rough(seen_.c) * Rough(e.a * f.b - e.b * f.a)) +
           square(Rough(seen_.s) * Rough(e.a * f.a - e.b * f.b));
  }
  Rough delta_more() const noexcept { return p_.mu + times(2, p_.root1 * p_.root2); }
  /// det(S1 - S2) in the frame of e, where S1 is diagonal; each element times V is of squares.
  Rough determinant() const noexcept {
    const Rough plain = p_.d1 + p_.d2 - p_.mu;
    if (plain.is_precise()) return plain;
    const exact::Ellipse &e = seen_.e, &f = seen_.f;
    const Rough along = squares_less(e.a * seen_.uu, f.a * seen_.c, f.b * seen_.s);
    const Rough across = squares_less(e.b * seen_.uu, f.a * seen_.s, f.b * seen_.c);
    const Rough beside = Rough(f.a - f.b) * (Rough(f.a) + Rough(f.b)) * Rough(seen_.c) * Rough(seen_.s);
    return (along * across - square(beside)) / square(Rough(seen_.uu));
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
