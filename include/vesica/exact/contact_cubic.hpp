// SPDX-License-Identifier: Apache-2.0
/// The polynomial that decides everything between two ellipses.
#pragma once

#include <vesica/exact/form.hpp>

namespace vesica::exact {

/// A point or a vector in the frame in which f is the disc of radius a b W about the origin.
template <int Degree>
struct Image {
  Number<Degree> x, y;
};
template <int Degree>
constexpr Image<Degree + 2> image(const Ellipse& f, const Number<Degree>& x, const Number<Degree>& y) noexcept {
  return {f.b * dot(f.ux, f.uy, x, y), f.a * cross(f.ux, f.uy, x, y)};
}
template <int A, int B>
constexpr Number<A + B> dot(const Image<A>& p, const Image<B>& q) noexcept {
  return p.x * q.x + p.y * q.y;
}

/// e's outline C + P cos + Q sin seen from f, and the rim of f.
struct Outline {
  const Ellipse &e, &f;
  Number<2> dot, cross;  ///< of f's axis and e's
  Image<3> c;
  Image<4> p, q;
  Number<4> radius;

  constexpr Outline(const Ellipse& its_e, const Ellipse& its_f) noexcept
      : e(its_e),
        f(its_f),
        dot(exact::dot(f.ux, f.uy, e.ux, e.uy)),
        cross(exact::cross(f.ux, f.uy, e.ux, e.uy)),
        c(image(f, e.cx - f.cx, e.cy - f.cy)),
        p{f.b * e.a * dot, f.a * e.a * cross},
        q{f.b * e.b * cross, f.a * e.b * dot},
        radius(f.a * f.b * exact::dot(f.ux, f.uy, f.ux, f.uy)) {
    q.x.sign = -q.x.sign;
  }
};

/// The cubic p(x) = d1 + c1 x + c2 x^2 + d2 x^3 that decides everything between two ellipses: they share a point
/// iff p(x) >= 0 for all x > 0. With S1, S2 the matrices of the ellipses, E = { K + z : z . S^-1 z <= 1 }, and D the
/// offset of centres, they share a point iff the Perram-Wertheim contact function D . (S1 / l + S2 / (1 - l))^-1 D
/// stays at most 1 on 0 < l < 1. With x = l / (1 - l), cleared of fractions, that is
/// p(x) = (1 + x) det(S1 + x S2) - x D . adj(S1 + x S2) D, where det = d1 + mu x + d2 x^2 and the rest al + be x.
/// J. W. Perram and M. S. Wertheim, J. Comput. Phys. 58 (1985) 409.
struct ContactCubic {
  Number<8> d1, c1, c2, d2, mu, al, be;

  constexpr void set(const Outline& o) noexcept {
    const Ellipse &e = o.e, &f = o.f;
    const Image<3> from_e = image(e, f.cx - e.cx, f.cy - e.cy);
    mu = square(o.p.x) + square(o.p.y) + square(o.q.x) + square(o.q.y);
    al = square(from_e.x) + square(from_e.y);
    be = square(o.c.x) + square(o.c.y);
    d1 = square(e.a * e.b * dot(e.ux, e.uy, e.ux, e.uy));
    d2 = square(o.radius);
    c1 = d1 + mu - al;
    c2 = d2 + mu - be;
  }
  /// Not inlined: the outline takes stack that is not needed later.
  VESICA_CALLED constexpr void set(const Ellipse& e, const Ellipse& f) noexcept { set(Outline(e, f)); }
};

constexpr ContactCubic contact_cubic(const Outline& o) noexcept {
  ContactCubic p;
  p.set(o);
  return p;
}
constexpr ContactCubic contact_cubic(const Ellipse& e, const Ellipse& f) noexcept {
  ContactCubic p;
  p.set(e, f);
  return p;
}

}  // namespace vesica::exact
