// SPDX-License-Identifier: Apache-2.0
/// The direction of the shortest connection between an ellipse and a point outside it, or between two ellipses.
///
/// phi(n) = n.D - sum of h(n), with h the support functions, is the width of the gap seen along the unit vector n. Its
/// maximum is the distance, and it is concave wherever it is positive, so Newton-like steps find the maximum. With
/// g = D - sum of x(n), x the support points: phi' = n x g, phi'' = -(phi + sum of rho), rho the radii of curvature.
/// Within a quarter turn of the maximum phi' leads towards it even where phi is negative. The reason: g lies on the far
/// side of the line at right angles to the best direction whose distance from the origin is the maximum.
#pragma once

#include <vesica/nearest/support.hpp>

namespace vesica::detail::nearest {

/// An ellipse as the search sees it: semi-axis vectors (rounded, for here only), (a b u.u)^2 and the square of the
/// longer one's length.
template <class V>
struct SemiAxes {
  V x0, y0, x1, y1, area_squared, longer_squared;
};

template <class V>
VESICA_INLINE SemiAxes<V> semi_axes(const Axes<V>& e) noexcept {
  const V uu = e.ux * e.ux + e.uy * e.uy, area = (e.a * e.b) * uu, longer = max(e.a, e.b);
  return {e.a * e.ux, e.a * e.uy, -(e.b * e.uy), e.b * e.ux, area * area, (longer * longer) * uu};
}

/// The shapes that D connects: a point and an ellipse, or two ellipses.
template <class V>
struct OneEllipse {
  Axes<V> a;
  SemiAxes<V> sa;
};
template <class V>
struct TwoEllipses {
  Axes<V> a, b;
  SemiAxes<V> sa, sb;
};

template <class V>
VESICA_INLINE OneEllipse<V> one_ellipse(const Axes<V>& a) noexcept {
  return {a, semi_axes(a)};
}
template <class V>
VESICA_INLINE TwoEllipses<V> two_ellipses(const Axes<V>& a, const Axes<V>& b) noexcept {
  return {a, b, semi_axes(a), semi_axes(b)};
}

/// S n = x0 (x0.n) + x1 (x1.n), and n . S n = h^2.
template <class V>
struct Image {
  V x, y, square;
};
template <class V>
VESICA_INLINE Image<V> image(const SemiAxes<V>& e, const Direction<V>& n) noexcept {
  const V p = e.x0 * n.x + e.y0 * n.y, q = e.x1 * n.x + e.y1 * n.y;
  return {e.x0 * p + e.x1 * q, e.y0 * p + e.y1 * q, p * p + q * q};
}
/// adj(S) n, where the semi-axes change places.
template <class V>
VESICA_INLINE Direction<V> adjugate_image(const SemiAxes<V>& e, const Direction<V>& n) noexcept {
  const V p = e.x0 * n.y - e.y0 * n.x, q = e.x1 * n.y - e.y1 * n.x;
  return {-(e.y0 * p + e.y1 * q), e.x0 * p + e.x1 * q};
}

template <class V>
VESICA_INLINE V cross(const Direction<V>& a, const Direction<V>& b) noexcept {
  return a.x * b.y - a.y * b.x;
}
template <class V>
VESICA_INLINE V dot(const Direction<V>& a, const Direction<V>& b) noexcept {
  return a.x * b.x + a.y * b.y;
}
template <class V>
VESICA_INLINE Direction<V> choose(MaskOf<V> m, const Direction<V>& yes, const Direction<V>& no) noexcept {
  return {select(m, yes.x, no.x), select(m, yes.y, no.y)};
}
template <class V>
VESICA_INLINE Direction<V> unit(V x, V y) noexcept {
  const V scale = V(1.0) / sqrt(x * x + y * y);
  return {x * scale, y * scale};
}
template <class V>
VESICA_INLINE Direction<V> about_unit(V x, V y) noexcept {
  const V scale = V(1.0) / (abs(x) + abs(y));
  return {x * scale, y * scale};
}

/// At the maximum D = sum of x + d n = (sum of S / h + d) n, so n is the adjugate of that matrix applied to D; the
/// adjugate of a 2 x 2 matrix is linear in it. With h and d as n = D has them this gives a much better n, cheaply. It
/// is to that side of D to which phi' at D points (D x n is that slope), within a quarter turn of D: the maximum is
/// there too.
template <class V>
VESICA_INLINE Direction<V> first_direction(const OneEllipse<V>& s, const Direction<V>& d) noexcept {
  const V dd = dot(d, d), square = image(s.sa, d).square, h = sqrt(square);
  const Direction<V> a = adjugate_image(s.sa, d);
  const V k = dd * h, phi = positive_part(dd - h) * square;
  return about_unit(a.x * k + d.x * phi, a.y * k + d.y * phi);
}
template <class V>
VESICA_INLINE Direction<V> first_direction(const TwoEllipses<V>& s, const Direction<V>& d) noexcept {
  const V dd = dot(d, d), square_a = image(s.sa, d).square, square_b = image(s.sb, d).square;
  const Direction<V> a = adjugate_image(s.sa, d), b = adjugate_image(s.sb, d);
  const V ha = sqrt(square_a), hb = sqrt(square_b), ka = dd * (ha * square_b), kb = dd * (hb * square_a);
  const V phi = positive_part(dd - (ha + hb)) * (square_a * square_b);
  return about_unit((a.x * ka + b.x * kb) + d.x * phi, (a.y * ka + b.y * kb) + d.y * phi);
}

/// An ellipse's part in g, phi'' and phi''', all but g times |N|. rho = (a b u.u)^2 / h^3 for a unit normal; with c =
/// h' / h = (n x S n) / h^2 its derivatives are -3 rho c and 3 rho (1 - rho / h + 4 c^2).
template <class V>
struct Pull {
  V x, y, bend, third, fourth;
  V flatness;  ///< (longer half axis / h)^2, the greater of two
};

/// inverse: 1 / h^2, so that the division need not wait for the root.
template <class V>
VESICA_INLINE Pull<V> pull(const SemiAxes<V>& e, const Image<V>& i, const Direction<V>& n, V nn, V inverse) noexcept {
  const V one(1.0), three(3.0), four(4.0);
  const V k = sqrt(i.square) * inverse, c = (n.x * i.y - n.y * i.x) * inverse;
  const V rho = (e.area_squared * k) * ((nn * nn) * inverse), three_rho = three * rho;
  return {i.x * k,
          i.y * k,
          rho,
          three_rho * c,
          three_rho * ((one - rho * k) + four * (c * c)),
          e.longer_squared * (nn * inverse)};
}
template <class V>
VESICA_INLINE Pull<V> pull(const OneEllipse<V>& s, const Direction<V>& n, V nn) noexcept {
  const Image<V> a = image(s.sa, n);
  return pull(s.sa, a, n, nn, V(1.0) / a.square);
}
template <class V>
VESICA_INLINE Pull<V> pull(const TwoEllipses<V>& s, const Direction<V>& n, V nn) noexcept {
  const Image<V> a = image(s.sa, n), b = image(s.sb, n);
  const V inverse = V(1.0) / (a.square * b.square);
  const Pull<V> p = pull(s.sa, a, n, nn, inverse * b.square), q = pull(s.sb, b, n, nn, inverse * a.square);
  return {p.x + q.x, p.y + q.y, p.bend + q.bend, p.third + q.third, p.fourth + q.fourth, max(p.flatness, q.flatness)};
}

/// How far N is to be turned, in tangents; what is known of phi' and phi'' times |N|; how large the terms are that phi'
/// is summed from.
template <class V>
struct Turn {
  V slope, bend, tangent;
  MaskOf<V> sane, last;
  V terms;
};

/// A turn t is the last when the slope it will leave, at most about 8 t^4 (phi'''^2 / (4 phi'') + |phi''''| / 4), is
/// below this share of the shapes' size, or when it is beneath what a direction can resolve. The former is of turns of
/// at most a quarter of h / (longer half axis): so far off h has a zero, among complex directions.
inline constexpr double slope_left = 0x1p-54, last_tangent = 0x1p-50;

template <class V, class Shapes>
VESICA_INLINE Turn<V> turn_at(const Shapes& shapes, const Direction<V>& d, V size, const Direction<V>& n) noexcept {
  const V nn = dot(n, n);
  const Pull<V> p = pull(shapes, n, nn);
  const V gx = d.x - p.x, gy = d.y - p.y, slope = n.x * gy - n.y * gx;
  const V bend = (n.x * gx + n.y * gy) + p.bend, third = slope - p.third, fourth = bend - p.fourth;
  // Householder's method of the third order, for an angle; it is sane where its terms are not far from Newton's.
  const V squared = V(6.0) * (bend * bend), bent = slope * third;
  const V numerator = squared + V(3.0) * bent;
  const V denominator = bend * (squared + V(6.0) * bent) - (slope * slope) * fourth;
  const V angle = (slope * numerator) / denominator;
  const V tangent = angle + (angle * angle) * (angle * V(1.0 / 3));
  const auto sane = both(bend > V(0.0), both(numerator > V(0.25) * squared, denominator > V(0.25) * (bend * squared)));
  const V t = abs(tangent), left = ((t * t) * (t * t)) * (third * third + abs(bend * fourth));
  const auto holds = (t * t) * p.flatness <= V(0x1p-4);
  const auto last = either(both(holds, left <= V(slope_left) * (size * bend)), t <= V(last_tangent));
  const V terms = abs(n.x) * (abs(d.y) + abs(p.y)) + abs(n.y) * (abs(d.x) + abs(p.x));
  return {slope, bend, tangent, sane, both(sane, last), terms};
}

template <class V>
VESICA_INLINE Direction<V> turned(const Direction<V>& n, V tangent) noexcept {
  return {n.x - tangent * n.y, n.y + tangent * n.x};
}

/// Directions on either side of the maximum, less than a half turn apart, `low` clockwise of it.
template <class V>
struct Bracket {
  Direction<V> low, high;
  VESICA_INLINE MaskOf<V> holds(const Direction<V>& n) const noexcept {
    return both(cross(low, n) >= V(0.0), cross(n, high) >= V(0.0));
  }
};

template <class V>
VESICA_INLINE Direction<V> middle(const Bracket<V>& bracket) noexcept {
  const Direction<V> low = about_unit(bracket.low.x, bracket.low.y), high = about_unit(bracket.high.x, bracket.high.y);
  return about_unit(low.x + high.x, low.y + high.y);
}

/// A direction between the two of the bracket that halves it as an ellipse sees it: in the angle of the support point's
/// preimage on the unit circle. Thin ellipses turn nearly all of their outline's normal within a narrow range of
/// directions, and this finds it at once.
template <class V>
VESICA_INLINE Direction<V> middle_seen_by(const Axes<V>& e, const Bracket<V>& bracket) noexcept {
  const auto seen = [&](const Direction<V>& n) {
    return about_unit(e.a * (e.ux * n.x + e.uy * n.y), e.b * (e.ux * n.y - e.uy * n.x));
  };
  const Direction<V> low = seen(bracket.low), high = seen(bracket.high);
  const V s = e.b * (low.x + high.x), t = e.a * (low.y + high.y);
  return about_unit(s * e.ux - t * e.uy, s * e.uy + t * e.ux);
}

/// True if D leads right, or straight up. Choices that must not depend on the order of the arguments use this.
template <class V>
VESICA_INLINE MaskOf<V> in_order(V dx, V dy) noexcept {
  const V zero(0.0);
  return either(dx > zero, both(dx == zero, dy > zero));
}

/// By turns: half the angle, and halfway as each ellipse sees it.
template <class V>
VESICA_INLINE Direction<V> middle(const OneEllipse<V>& s, const Direction<V>&, const Bracket<V>& bracket,
                                  int step) noexcept {
  return step % 2 == 1 ? middle(bracket) : middle_seen_by(s.a, bracket);
}
template <class V>
VESICA_INLINE Direction<V> middle(const TwoEllipses<V>& s, const Direction<V>& d, const Bracket<V>& bracket,
                                  int step) noexcept {
  if (step % 3 == 2) return middle(bracket);
  const V sign(step % 3 == 0 ? 1.0 : -1.0);
  const auto a = in_order(sign * d.x, sign * d.y);
  return middle_seen_by(
      Axes<V>{select(a, s.a.ux, s.b.ux), select(a, s.a.uy, s.b.uy), select(a, s.a.a, s.b.a), select(a, s.a.b, s.b.b)},
      bracket);
}

/// D and a quarter turn from it to the side that n is on.
template <class V>
VESICA_INLINE Bracket<V> first_bracket(const Direction<V>& d, const Direction<V>& n) noexcept {
  const auto to_left = cross(d, n) > V(0.0);
  return {choose(to_left, d, {d.y, -d.x}), choose(to_left, {-d.y, d.x}, d)};
}

/// For ordinary numbers no search has taken more than 30 steps (tests/nearest fails at 48). At extreme
/// magnitudes some take 48, and some do not end before this.
inline constexpr int direction_step_limit = 64;

/// About a unit vector; the steps it took, of all lanes together.
template <class V>
struct FoundDirection {
  Direction<V> n;
  MaskOf<V> found;
  int steps;
};

/// The maximiser of phi between the two directions of a bracket, starting at n. A step that would leave the bracket, or
/// that goes back by more than half of the step before, is replaced by halving the bracket; so every search ends. Lanes
/// that are done keep their direction.
template <class V, class Shapes>
VESICA_INLINE FoundDirection<V> search_between(const Shapes& shapes, const Direction<V>& d, V size, Direction<V> n,
                                               Bracket<V> bracket, MaskOf<V> done, int step_limit) noexcept {
  const V zero(0.0), half(0.5), one(1.0);
  V slope_before = zero, tangent_before = zero;
  int step = 0;
  for (; step < step_limit && !all(done); ++step) {
    const Turn<V> turn = turn_at(shapes, d, size, n);
    const auto rising = turn.slope > zero;
    bracket.low = choose(rising, n, bracket.low);
    bracket.high = choose(rising, bracket.high, n);
    Direction<V> next = turned(n, turn.tangent);
    const auto calm = either(turn.slope * slope_before >= zero, abs(turn.tangent) <= half * abs(tangent_before));
    const auto accepted = either(turn.last, both(both(turn.sane, bracket.holds(next)), calm));
    if (!all(either(done, accepted))) [[unlikely]] {
      const Direction<V> newton = turned(n, turn.slope / select(turn.bend > zero, turn.bend, one));
      const auto usable = and_not(both(turn.bend > zero, both(bracket.holds(newton), calm)), turn.sane);
      next = choose(accepted, next, choose(usable, newton, middle(shapes, d, bracket, step)));
    }
    n = choose(done, n, next);
    slope_before = turn.slope;
    tangent_before = turn.tangent;
    done = either(done, turn.last);
  }
  return {n, done, step};
}

/// The maximiser of phi for disjoint shapes.
template <class V, class Shapes>
VESICA_INLINE FoundDirection<V> farthest_direction(const Shapes& shapes, const Direction<V>& d, V size,
                                                   int step_limit = direction_step_limit) noexcept {
  const Direction<V> n = first_direction(shapes, d);
  return search_between(shapes, d, size, n, first_bracket(d, n), V(0.0) > V(0.0), step_limit);
}

}  // namespace vesica::detail::nearest
