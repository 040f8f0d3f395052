// SPDX-License-Identifier: Apache-2.0
/// The polynomial that decides everything between two ellipses.
#pragma once

#include <vesica/exact/form.hpp>

namespace vesica::exact {

/// The cubic p(x) = d1 + c1 x + c2 x^2 + d2 x^3 that decides everything between two ellipses: they share a point
/// iff p(x) >= 0 for all x > 0. With S1, S2 the matrices of the ellipses, E = { K + z : z . S^-1 z <= 1 }, and D the
/// offset of centres, they share a point iff the Perram-Wertheim contact function D . (S1 / l + S2 / (1 - l))^-1 D
/// stays at most 1 on 0 < l < 1. With x = l / (1 - l), cleared of fractions, that is
/// p(x) = (1 + x) det(S1 + x S2) - x D . adj(S1 + x S2) D, where det = d1 + mu x + d2 x^2 and the rest al + be x.
/// J. W. Perram and M. S. Wertheim, J. Comput. Phys. 58 (1985) 409.
struct ContactCubic {
  Number<8> d1, c1, c2, d2, mu, al, be;
  Number<4> root1, root2;  ///< of d1 and d2
};

constexpr ContactCubic contact_cubic(const Ellipse& e, const Ellipse& f) noexcept {
  const Length dx = f.cx - e.cx, dy = f.cy - e.cy;
  const auto c = dot(e.ux, e.uy, f.ux, f.uy), s = cross(e.ux, e.uy, f.ux, f.uy);
  ContactCubic p;
  p.mu = square(e.a * f.b * c) + square(e.b * f.a * c) + square(e.a * f.a * s) + square(e.b * f.b * s);
  p.al = square(e.b * dot(e.ux, e.uy, dx, dy)) + square(e.a * cross(e.ux, e.uy, dx, dy));
  p.be = square(f.b * dot(f.ux, f.uy, dx, dy)) + square(f.a * cross(f.ux, f.uy, dx, dy));
  p.root1 = e.a * e.b * dot(e.ux, e.uy, e.ux, e.uy);
  p.root2 = f.a * f.b * dot(f.ux, f.uy, f.ux, f.uy);
  p.d1 = square(p.root1);
  p.d2 = square(p.root2);
  p.c1 = p.d1 + p.mu - p.al;
  p.c2 = p.d2 + p.mu - p.be;
  return p;
}

}  // namespace vesica::exact
