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
  return detail::sum_of_products(p.x, q.x, 1, p.y, q.y);
}

/// e's outline C + P cos + Q sin seen from f, and the rim of f. The offset of their centres has a degree.
template <int Offset = 1>
struct Outline {
  const Ellipse &e, &f;
  Number<2> dot, cross;  ///< of f's axis and e's
  Image<Offset + 2> c;
  Image<4> p, q;
  Number<4> radius;

  constexpr Outline(const Ellipse& its_e, const Ellipse& its_f) noexcept
      : Outline(its_e, its_f, its_e.cx - its_f.cx, its_e.cy - its_f.cy) {}
  /// With e moved to that offset from f.
  constexpr Outline(const Ellipse& its_e, const Ellipse& its_f, const Number<Offset>& x,
                    const Number<Offset>& y) noexcept
      : e(its_e),
        f(its_f),
        dot(exact::dot(f.ux, f.uy, e.ux, e.uy)),
        cross(exact::cross(f.ux, f.uy, e.ux, e.uy)),
        c(image(f, x, y)),
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
struct Cubic {
  Number<8> d1, c1, c2, d2;
};

/// The cubic, and what it is made of.
struct ContactCubic : Cubic {
  Number<8> mu, al, be;
};

namespace detail {

/// Sets the cubic and mu, al, be.
constexpr void set(const Outline<>& o, Cubic& p, Number<8>& mu, Number<8>& al, Number<8>& be) noexcept {
  const Ellipse &e = o.e, &f = o.f;
  const Image<3> from_e = image(e, f.cx - e.cx, f.cy - e.cy);
  mu = sum_of_products(o.p.x, o.p.x, 1, o.p.y, o.p.y) + sum_of_products(o.q.x, o.q.x, 1, o.q.y, o.q.y);
  al = sum_of_products(from_e.x, from_e.x, 1, from_e.y, from_e.y);
  be = sum_of_products(o.c.x, o.c.x, 1, o.c.y, o.c.y);
  p.d1 = square(e.a * e.b * dot(e.ux, e.uy, e.ux, e.uy));
  p.d2 = square(o.radius);
  p.c1 = p.d1 + mu - al;
  p.c2 = p.d2 + mu - be;
}
/// Not inlined: the outline takes stack that is not needed later.
VESICA_CALLED constexpr void set(const Ellipse& e, const Ellipse& f, ContactCubic& p) noexcept {
  set(Outline<>(e, f), p, p.mu, p.al, p.be);
}
VESICA_CALLED constexpr void set(const Ellipse& e, const Ellipse& f, Cubic& p) noexcept {
  Number<8> mu, al, be;
  set(Outline<>(e, f), p, mu, al, be);
}

/// The same for the disc of radius r about (x, y) in place of e. As S1 = r^2, no degree exceeds 8, though those of x
/// and y are 2.
VESICA_CALLED constexpr void set(const Length& r, const Number<2>& x, const Number<2>& y, const Ellipse& f, Cubic& p,
                                 Number<8>& mu, Number<8>& al, Number<8>& be) noexcept {
  const Number<2> rr = square(r), ww = dot(f.ux, f.uy, f.ux, f.uy);
  const Image<4> z = image(f, x, y);
  mu = rr * ((square(f.a) + square(f.b)) * ww);
  al = rr * (square(x) + square(y));
  be = sum_of_products(z.x, z.x, 1, z.y, z.y);
  p.d1 = square(rr);
  p.d2 = square(f.a * f.b * ww);
  p.c1 = p.d1 + mu - al;
  p.c2 = p.d2 + mu - be;
}

}  // namespace detail

constexpr Cubic cubic(const Ellipse& e, const Ellipse& f) noexcept {
  Cubic p;
  detail::set(e, f, p);
  return p;
}
/// The cubic of the disc of radius r about (x, y), seen from the centre of f, and f.
constexpr Cubic disc_cubic(const Length& r, const Number<2>& x, const Number<2>& y, const Ellipse& f) noexcept {
  Cubic p;
  Number<8> mu, al, be;
  detail::set(r, x, y, f, p, mu, al, be);
  return p;
}
constexpr ContactCubic disc_contact_cubic(const Length& r, const Number<2>& x, const Number<2>& y,
                                          const Ellipse& f) noexcept {
  ContactCubic p;
  detail::set(r, x, y, f, p, p.mu, p.al, p.be);
  return p;
}
constexpr ContactCubic contact_cubic(const Ellipse& e, const Ellipse& f) noexcept {
  ContactCubic p;
  detail::set(e, f, p);
  return p;
}

}  // namespace vesica::exact
