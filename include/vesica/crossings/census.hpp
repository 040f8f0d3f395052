// SPDX-License-Identifier: Apache-2.0
/// How many places the outlines of two ellipses have in common, and how many of them only touch: exact signs of
/// polynomials in the coefficients of the contact cubic.
#pragma once

#include <vesica/exact/ellipse_ellipse.hpp>

namespace vesica::detail::crossings {

/// Places at which the outlines cross, and at which they touch. Where they touch and cross at once (osculation) they
/// cross.
struct Census {
  int crossing, touching;
  bool equal;
};

/// With three equal roots of p, contact is of the highest order. Not inlined, for its numbers' stack.
VESICA_CALLED inline bool has_triple_root(const exact::ContactCubic& p) noexcept {
  return exact::compare_products(p.c2, p.c2, exact::integer(3) * p.d2, p.c1) == 0;
}

/// With the double root x0 = -B / (2A) of p, whether S1 + x0 S2 has rank 1: d2 x0^2 + mu x0 + d1 = 0. Of nested
/// ellipses, these touch at two places. p'(x0) = c1 + 2 c2 x0 + 3 d2 x0^2 = 0 makes it (3 mu - 2 c2) x0 = c1 - 3 d1:
/// degree 24.
VESICA_CALLED inline bool has_rank_one(const exact::ContactCubic& p) noexcept {
  using exact::detail::difference_of_multiples;
  const auto a = difference_of_multiples(1, p.c2, p.c2, 3, p.d2, p.c1);
  const auto b = difference_of_multiples(1, p.c1, p.c2, 9, p.d1, p.d2);
  const exact::Number<8> left = exact::detail::slope_of(p);
  const exact::Number<8> right = exact::integer(2) * p.c1 - exact::integer(6) * p.d1;
  return exact::compare_products(left, b, right, a) == 0;
}

/// The census of nested ellipses that touch: p has a multiple root.
inline Census touching_inside(const exact::ContactCubic& p) noexcept {
  return {0, !has_triple_root(p) && has_rank_one(p) ? 2 : 1, false};
}

/// The census of ellipses that cross, by the sign of the discriminant.
inline Census crossing(const exact::ContactCubic& p, int roots) noexcept {
  if (roots != 0) return {roots > 0 ? 4 : 2, 0, false};
  return has_triple_root(p) ? Census{2, 0, false} : Census{2, 1, false};
}

/// Makes the distinctions of exact::relation, and counts the places. `cross`: the ellipses are known to cross. They may
/// be left exchanged.
inline Census census(exact::ContactCubic& p, bool cross) noexcept {
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
  if (cross) return crossing(p, exact::discriminant_sign(p));
  const int order = exact::compare(p.d1, p.d2);
  if (order > 0) exact::detail::exchange_ellipses(p);
  const int roots = exact::discriminant_sign(p);
  if (roots < 0) return {2, 0, false};
  if (p.c1.sign < 0 || p.c2.sign < 0) return {0, roots > 0 ? 0 : 1, false};
  if (order != 0 && exact::detail::first_in_second(p)) {
    if (roots > 0 || exact::double_root_is_greater(p)) return {0, 0, false};
    return touching_inside(p);
  }
  return crossing(p, roots);
}
VESICA_COLD inline Census census(const exact::Ellipse& e, const exact::Ellipse& f, bool cross = false) noexcept {
  exact::ContactCubic p = exact::contact_cubic(e, f);
  return census(p, cross);
}

}  // namespace vesica::detail::crossings
