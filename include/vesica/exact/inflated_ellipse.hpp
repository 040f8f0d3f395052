// SPDX-License-Identifier: Apache-2.0
/// Relation and containment of an ellipse and a core with a radius r > 0 (exact/inflated.hpp), exactly.
///
/// Proved: for an ellipse E and a core with corners p, containment follows from signs of degree 12 and from the contact
/// cubics of E and discs of radius r about p. No root is computed.
///
///   - The core with its radius is in E iff each of these discs is, since E is convex.
///   - Let h(n) be the greatest n.(x - p) of E's points x, for unit normals n. The cone of p has the normals with
///     n.e >= 0 for each axis e that leads out of the core at p. There the shape has the support of the disc about p.
///     So E is in it iff h <= r in every cone, and reaches its outline iff h = r somewhere.
///   - At the ends of cones this says that E is within r of each side's line (side_clearance()). If it holds there, h
///     exceeds r inside a cone iff a local maximum there does.
///   - Let d lead from p to the centre, along axes of E with half lengths A1 >= A2. Where h is stationary, n is along
///     x - p, and proportional to (d1 / (l - A1^2), d2 / (l - A2^2)) for a root l of phi(l) = sum Ai^2 di^2 /
///     (l - Ai^2)^2 - 1. Then h^2 = G(l) = l (1 + sum di^2 / (l - Ai^2)), and G' = -phi.
///   - One root is greater than A1^2: the farthest point of E, the greatest maximum F. Between A2^2 and A1^2 phi is
///     convex: if it has two roots, the lesser one is a minimum S > 0 of h and the greater one the other maximum M > S
///     (J. M. Martinez, SIAM J. Optim. 4 (1994) 159). Below A2^2 there is only the least minimum N.
///   - If d1 = 0 the farthest points may be two, with normals that are mirror images. Both are then what d1 of either
///     sign stands for, and no other maximum is left.
///   - n.e = 0 for one le only, which is rational. maxima_ahead() decides by phi(le) and phi'(le) on which side n lies.
///   - F <= r iff E is in the disc. Otherwise the cone must not have F. Let it have M, if M exists:
///     - If the disc and E are disjoint or touch from outside, no point of E at distance S <= r exists. But the cone's
///       ends are on either side of M, where h falls to S on one of them before it rises to F. So S <= r, and M does
///       not exist, or is not in the cone.
///     - If the disc is in E, h >= r everywhere, and more than r somewhere between the cone's ends.
///     - If they cross, G takes the value r^2 once or three times between A2^2 and A1^2 and nowhere else: M > r iff
///       the contact cubic has three real roots. If two are equal, they are M = r or S = r < M: the place of the double
///       root says which. If all are, h is monotonic there and M is none.
#pragma once

#include <vesica/exact/inflated.hpp>
#include <vesica/exact/within_ellipse.hpp>

namespace vesica::exact {

namespace detail {

/// An ellipse in the frame of a box, in units of |u|, and the box in the ellipse's. (c, s) is the ellipse's axis, P its
/// matrix, (kx, ky) its centre.
struct EllipseInBoxFrame {
  Number<2> c, s, kx, ky;
  Number<3> ex, ey;
  Number<6> p00, p01, p11;

  constexpr EllipseInBoxFrame(const Box& box, const Ellipse& ellipse) noexcept
      : c(dot(box.ux, box.uy, ellipse.ux, ellipse.uy)), s(cross(box.ux, box.uy, ellipse.ux, ellipse.uy)) {
    const Length dx = ellipse.cx - box.cx, dy = ellipse.cy - box.cy;
    const auto uu = dot(box.ux, box.uy, box.ux, box.uy);
    kx = dot(box.ux, box.uy, dx, dy);
    ky = cross(box.ux, box.uy, dx, dy);
    ex = box.hx * uu;
    ey = box.hy * uu;
    const Number<2> aa = square(ellipse.a), bb = square(ellipse.b);
    const Number<4> cc = square(c), ss = square(s);
    p00 = sum_of_products(aa, cc, 1, bb, ss);
    p11 = sum_of_products(aa, ss, 1, bb, cc);
    p01 = (aa - bb) * (c * s);
  }
};

/// The sign of e + R - |k| - sqrt(p) for R^2 = rr: how far an ellipse stays within R beyond a side. Degree 12.
VESICA_CALLED constexpr int side_clearance(const Number<3>& e, const Number<2>& k, const Number<6>& p,
                                           const Number<4>& rr) noexcept {
  const Number<3> x = e - abs(k);
  if (x.sign < 0 && compare(rr, square(x)) < 0) return -1;
  return sign_with_root(rr + square(x) - p, integer(2) * x, rr);
}

/// The offset d from a corner to an ellipse's centre, along the ellipse's axes, the greater half length first.
struct SeenFromCorner {
  Length greater, lesser;
  Number<3> d1, d2;
};

/// An axis out of a box: along the axes of an ellipse, and how far it is to the ellipse's centre from a corner.
struct OutwardAxis {
  int sign;  ///< the outward axis is this times (e1, e2)
  const Number<2>&e1, &e2;
  Number<3> distance;
};

/// The maxima with normals ahead, n.e > 0; and whether they are in a cone. `first` is F, with d1 > 0 or d1 < 0 if it
/// is 0.
struct Maxima {
  bool first[2], second;

  constexpr bool any() const noexcept { return first[0] || first[1] || second; }
};
constexpr Maxima both(const Maxima& a, const Maxima& b) noexcept {
  return {{a.first[0] && b.first[0], a.first[1] && b.first[1]}, a.second && b.second};
}

/// The maxima ahead, for the squared half extent p of the ellipse across the axis and P's mixed element p01. Where a
/// normal is across the axis it may count either way: there the clearance of a side decides.
///
/// Proved: let k1 = d1 e1, k2 = d2 e2, so that d.e = k1 + k2 and le (d.e) = k1 A2^2 + k2 A1^2.
///
///   - le - A1^2 = -k1 (A1^2 - A2^2) / d.e, le - A2^2 = k2 (A1^2 - A2^2) / d.e. So phi(le) has the sign of
///     (d.e)^2 p - p01^2, and phi'(le), where k1 and k2 have one sign, that of A1^2 |d2 e2^3| - A2^2 |d1 e1^3|.
///   - Beyond A1^2, n.e has the sign of k1 / (l - A1^2) + k2 / (l - A2^2). If k1 and k2 have one sign, it is theirs.
///     Otherwise it is that of k1, unless d.e has the other one and l > le, which is phi(le) > 0. Then it is d.e's.
///   - Between A2^2 and A1^2, n.e has the sign of k2 / (l - A2^2) - k1 / (A1^2 - l), decided unless k1 and k2 have one
///     sign. Then it is theirs iff l < le, which is phi(le) > 0 and phi'(le) > 0 for the greater root.
VESICA_CALLED constexpr Maxima maxima_ahead(const SeenFromCorner& d, const OutwardAxis& e, const Number<6>& p,
                                            const Number<6>& p01) noexcept {
  const bool exceeds = compare_products(square(e.distance), p, p01, p01) > 0;
  const int side = e.sign * e.e1.sign, k2 = e.sign * e.e2.sign * d.d2.sign;
  const auto first = [&](int sign) { return (exceeds ? e.distance.sign : side * sign) > 0; };
  if (d.d1.sign == 0) return {{first(1), first(-1)}, false};
  const int k1 = side * d.d1.sign;
  Maxima ahead{{first(d.d1.sign), false}, k2 > k1};
  if (k1 * k2 > 0) {
    const bool is_less = exceeds && compare_products(square(d.greater) * abs(d.d2), square(e.e2) * abs(e.e2),
                                                     square(d.lesser) * abs(d.d1), square(e.e1) * abs(e.e1)) > 0;
    ahead.second = is_less == (k1 > 0);
  }
  return ahead;
}

/// Looks at an ellipse from the corners of a core.
struct CornerCones {
  int sides;  ///< the clearance of the ellipse at the core's sides; if it is negative, the rest is unknown
  int count;
  Corner corner[4];
  Maxima maxima[4];  ///< in the corner's cone
};

/// Not inlined: the contact cubics do not need this stack.
VESICA_CALLED constexpr CornerCones corner_cones(const Box& box, const Ellipse& ellipse, const Length& r) noexcept {
  const EllipseInBoxFrame f(box, ellipse);
  CornerCones cones{};
  {
    const Number<4> rr = square(r) * dot(box.ux, box.uy, box.ux, box.uy);
    const int along = side_clearance(f.ex, f.kx, f.p00, rr);
    const int across = along < 0 ? -1 : side_clearance(f.ey, f.ky, f.p11, rr);
    cones.sides = across < along ? across : along;
  }
  if (cones.sides < 0) return cones;
  const Length dx = ellipse.cx - box.cx, dy = ellipse.cy - box.cy;
  const Number<2> w0 = dot(ellipse.ux, ellipse.uy, dx, dy), w1 = cross(ellipse.ux, ellipse.uy, dx, dy);
  // The box's axes along those of the ellipse are (c, -s) and (s, c).
  const Number<2> minus_s = -f.s;
  const bool in_order = compare(ellipse.a, ellipse.b) >= 0;
  const bool has_width = box.hx.sign != 0, has_height = box.hy.sign != 0;
  for (int i = has_width ? -1 : 1; i <= 1; i += 2) {
    for (int j = has_height ? -1 : 1; j <= 1; j += 2) {
      const Number<3> d0 = add(add(Number<3>(w0), box.hx * f.c, -i), box.hy * f.s, -j);
      const Number<3> d1 = add(add(Number<3>(w1), box.hx * f.s, i), box.hy * f.c, -j);
      const SeenFromCorner d{in_order ? ellipse.a : ellipse.b, in_order ? ellipse.b : ellipse.a, in_order ? d0 : d1,
                             in_order ? d1 : d0};
      Maxima found{{true, true}, true};
      if (has_width) {
        const OutwardAxis e{i, in_order ? f.c : minus_s, in_order ? minus_s : f.c, add(-f.ex, f.kx, i)};
        found = both(found, maxima_ahead(d, e, f.p11, f.p01));
      }
      if (has_height) {
        const OutwardAxis e{j, in_order ? f.s : f.c, in_order ? f.c : f.s, add(-f.ey, f.ky, j)};
        found = both(found, maxima_ahead(d, e, f.p00, f.p01));
      }
      if (!found.any()) continue;
      cones.corner[cones.count] = {i, j};
      cones.maxima[cones.count++] = found;
    }
  }
  return cones;
}

/// How the disc of radius r about a corner relates to an ellipse. Not inlined, as above.
VESICA_CALLED constexpr Relation corner_relation(const Box& box, const Corner& corner, const Ellipse& ellipse,
                                                 const Length& r) noexcept {
  const CornerOffset at(box, corner, ellipse);
  ContactCubic p = disc_contact_cubic(r, at.x, at.y, ellipse);
  return relation(p);
}

/// How far r is above M, where a disc about a corner and an ellipse cross. Not inlined, as above.
VESICA_CALLED constexpr int second_clearance(const Box& box, const Corner& corner, const Ellipse& ellipse,
                                             const Length& r) noexcept {
  const Cubic p = corner_cubic(box, corner, ellipse, r);
  const int roots = discriminant_sign(p);
  if (roots != 0) return -roots;
  // A root of p is -r^2 / l: the greater root stands for the greater l.
  const int place = double_root_place(p);
  return place > 0 ? 0 : place < 0 ? -1 : 1;
}

/// How far r is above the maxima in a corner's cone: 1, 0 or -1.
constexpr int cone_clearance(const Box& box, const Corner& corner, const Ellipse& ellipse, const Length& r,
                             const Maxima& maxima) noexcept {
  const bool has_first = maxima.first[0] || maxima.first[1];
  const Relation disc = corner_relation(box, corner, ellipse, r);
  if (disc == Relation::contains) return 1;
  if (disc == Relation::contains_touch || disc == Relation::equal) return has_first ? 0 : 1;
  if (has_first || disc == Relation::inside || disc == Relation::inside_touch) return -1;
  return disc == Relation::cross ? second_clearance(box, corner, ellipse, r) : 1;
}

}  // namespace detail

/// How far an ellipse stays within a core with a radius.
constexpr int clearance(const Ellipse& ellipse, const InflatedBox& b) noexcept {
  const detail::CornerCones cones = detail::corner_cones(b.core, ellipse, b.radius);
  int least = cones.sides;
  for (int k = 0; k < cones.count && least >= 0; ++k) {
    const int found = detail::cone_clearance(b.core, cones.corner[k], ellipse, b.radius, cones.maxima[k]);
    least = found < least ? found : least;
  }
  return least;
}

/// How far a core with a radius stays within an ellipse.
constexpr int clearance(const InflatedBox& a, const Ellipse& ellipse) noexcept {
  int least = 1;
  for (int i = a.core.hx.sign == 0 ? 1 : -1; i <= 1; i += 2) {
    for (int j = a.core.hy.sign == 0 ? 1 : -1; j <= 1; j += 2) {
      const Relation disc = detail::corner_relation(a.core, {i, j}, ellipse, a.radius);
      if (disc == Relation::inside) continue;
      if (disc != Relation::inside_touch && disc != Relation::equal) return -1;
      least = 0;
    }
  }
  return least;
}

namespace detail {

// Not inlined: the contact cubics are computed without the stack of these.

/// The relation where the ellipse has no area, or the core no radius.
VESICA_CALLED constexpr Relation relation_of_simpler(const InflatedBox& a, const Ellipse& b) noexcept {
  return degenerate(b) ? relate(a, InflatedBox{as_box(b), {}}) : relate(a.core, b);
}
VESICA_CALLED constexpr int called_contact(const InflatedBox& a, const Ellipse& b) noexcept {
  return contact(a.core, b, a.radius, Common::insides);
}

}  // namespace detail

constexpr Relation relate(const InflatedBox& a, const Ellipse& b) noexcept {
  if (degenerate(b) || a.radius.sign == 0) return detail::relation_of_simpler(a, b);
  if (detail::is_point(a.core)) return detail::corner_relation(a.core, {1, 1}, b, a.radius);
  const int touching = detail::called_contact(a, b);
  if (touching >= 0) return touching > 0 ? Relation::disjoint : Relation::touch;
  return detail::relation_of(touching, clearance(a, b), clearance(b, a));
}
constexpr Relation relate(const Ellipse& a, const InflatedBox& b) noexcept { return converse(relate(b, a)); }

}  // namespace vesica::exact
