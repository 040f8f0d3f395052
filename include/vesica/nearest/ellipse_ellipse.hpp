// SPDX-License-Identifier: Apache-2.0
/// Two disjoint ellipses: the normal along which they are farthest apart, and the distance along it.
///
/// phi(n) = n.D - h1(n) - h2(n), with h the support functions, is the width of the gap seen along the unit vector n. It
/// is concave wherever it is positive, and its maximum is the distance. With g = D - x1(n) - x2(n), x the support
/// points: phi' = n x g, phi'' = -(phi + rho1 + rho2), rho the radii of curvature. Within a quarter turn of the maximum
/// phi' points to it also where phi is negative: the support points' difference lies beyond the line that is d away.
#pragma once

#include <vesica/nearest/support.hpp>

namespace vesica::closest {

/// An ellipse as the search sees it: semi-axis vectors (rounded, for here only) and (a b u.u)^2.
template <class V>
struct SemiAxes {
  V x0, y0, x1, y1, area_squared;
};

template <class V>
VESICA_INLINE SemiAxes<V> semi_axes(const Axes<V>& e) noexcept {
  const V area = (e.a * e.b) * (e.ux * e.ux + e.uy * e.uy);
  return {e.a * e.ux, e.a * e.uy, -(e.b * e.uy), e.b * e.ux, area * area};
}

/// S n = x0 (x0.n) + x1 (x1.n), where h = sqrt(n . S n); and adj(S) n, where the semi-axes change places.
template <class V>
struct Image {
  V x, y, square;
};
template <class V>
VESICA_INLINE Image<V> image(const SemiAxes<V>& e, const Direction<V>& n) noexcept {
  const V p = e.x0 * n.x + e.y0 * n.y, q = e.x1 * n.x + e.y1 * n.y;
  return {e.x0 * p + e.x1 * q, e.y0 * p + e.y1 * q, p * p + q * q};
}
template <class V>
VESICA_INLINE Direction<V> adjugate_image(const SemiAxes<V>& e, V dx, V dy) noexcept {
  const V p = e.x0 * dy - e.y0 * dx, q = e.x1 * dy - e.y1 * dx;
  return {-(e.y0 * p + e.y1 * q), e.x0 * p + e.x1 * q};
}

template <class V>
VESICA_INLINE V cross(const Direction<V>& a, const Direction<V>& b) noexcept {
  return a.x * b.y - a.y * b.x;
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

/// At the maximum D = x1 + x2 + d n = (S1 / h1 + S2 / h2 + d) n, so n is the adjugate of that matrix applied to D; the
/// adjugate of a 2 x 2 matrix is linear in it. With h1, h2 and d as n has them this gives a much better n, cheaply.
/// Of n = D it makes an n to that side of D to which phi' at D points (D x n is that slope), within a quarter turn of D:
/// the maximum is there too.
template <class V>
VESICA_INLINE Direction<V> improved(const SemiAxes<V>& a, const SemiAxes<V>& b, V dx, V dy, const Direction<V>& ad,
                                    const Direction<V>& bd, const Direction<V>& n) noexcept {
  const V p0 = a.x0 * n.x + a.y0 * n.y, p1 = a.x1 * n.x + a.y1 * n.y;
  const V q0 = b.x0 * n.x + b.y0 * n.y, q1 = b.x1 * n.x + b.y1 * n.y;
  const V sa = p0 * p0 + p1 * p1, sb = q0 * q0 + q1 * q1, nn = n.x * n.x + n.y * n.y;
  const V ha = sqrt(sa), hb = sqrt(sb), scale = nn / (sa * sb);
  const V ka = ha * (sb * scale), kb = hb * (sa * scale);
  const V phi = positive_part((n.x * dx + n.y * dy) - (ha + hb));
  return {(ad.x * ka + bd.x * kb) + dx * phi, (ad.y * ka + bd.y * kb) + dy * phi};
}

/// How far N is to be turned, in tangents; what is known of phi' and phi'' times |N|.
template <class V>
struct Turn {
  V slope, bend, tangent;
  MaskOf<V> sane, last;
};

/// A turn t is the last when the slope it will leave, at most about 8 t^4 (phi'''^2 / (4 phi'') + |phi''''| / 4), is below
/// this share of the shapes' size, or when it is beneath what a direction can resolve.
inline constexpr double slope_left = 0x1p-54, last_tangent = 0x1p-50;

template <class V>
VESICA_INLINE Turn<V> turn_at(const SemiAxes<V>& a, const SemiAxes<V>& b, V dx, V dy, V size,
                              const Direction<V>& n) noexcept {
  const V one(1.0), four(4.0);
  const Image<V> ia = image(a, n), ib = image(b, n);
  // 1 / h by way of 1 / h^2: the division need not wait for the roots.
  const V both_squares = V(1.0) / (ia.square * ib.square), nn = n.x * n.x + n.y * n.y;
  const V ka2 = both_squares * ib.square, kb2 = both_squares * ia.square;
  const V ka = sqrt(ia.square) * ka2, kb = sqrt(ib.square) * kb2;
  const V ax = ia.x * ka, ay = ia.y * ka, bx = ib.x * kb, by = ib.y * kb;
  const V gx = dx - (ax + bx), gy = dy - (ay + by), slope = n.x * gy - n.y * gx;
  // rho = (a b u.u)^2 / h^3 for a unit normal; with c = h' / h = (n x S n) / h^2 its derivatives are -3 rho c and
  // 3 rho (1 - rho / h + 4 c^2). Here they come times |N|.
  const V ra = (a.area_squared * ka) * ((nn * nn) * ka2), rb = (b.area_squared * kb) * ((nn * nn) * kb2);
  const V ca = (n.x * ia.y - n.y * ia.x) * ka2, cb = (n.x * ib.y - n.y * ib.x) * kb2;
  const V bend = (n.x * gx + n.y * gy) + (ra + rb), third = slope - V(3.0) * (ra * ca + rb * cb);
  const V change = ra * ((one - ra * ka) + four * (ca * ca)) + rb * ((one - rb * kb) + four * (cb * cb));
  const V fourth = bend - V(3.0) * change;
  // Householder's method of the third order, for an angle; and Halley's denominator, whose sign tells whether it is sane.
  const V squared = V(6.0) * (bend * bend), bent = slope * third;
  const V denominator = bend * (squared + V(6.0) * bent) - (slope * slope) * fourth;
  const V angle = (slope * (squared + V(3.0) * bent)) / denominator;
  const V tangent = angle + (angle * angle) * (angle * V(1.0 / 3));
  const auto sane =
      both(bend > V(0.0), both(squared + V(3.0) * bent > V(0.25) * squared, denominator > V(0.25) * (bend * squared)));
  const V t = abs(tangent), left = ((t * t) * (t * t)) * (third * third + abs(bend * fourth));
  const auto last = either(both(t <= V(0.25), left <= V(slope_left) * (size * bend)), t <= V(last_tangent));
  return {slope, bend, tangent, sane, both(sane, last)};
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

/// A direction between the two of the bracket that halves it as an ellipse sees it: in the angle of the support point's
/// preimage on the unit circle. Thin ellipses turn nearly all of their outline's normal within a narrow range of
/// directions, and this finds it at once.
template <class V>
VESICA_INLINE Direction<V> middle_seen_by(const Axes<V>& e, const Bracket<V>& bracket) noexcept {
  const auto seen = [&](const Direction<V>& n) {
    return unit(e.a * (e.ux * n.x + e.uy * n.y), e.b * (e.ux * n.y - e.uy * n.x));
  };
  const Direction<V> low = seen(bracket.low), high = seen(bracket.high);
  const V s = e.b * (low.x + high.x), t = e.a * (low.y + high.y);
  return unit(s * e.ux - t * e.uy, s * e.uy + t * e.ux);
}

/// Plainly, and as either ellipse sees it, in turn. Which of them goes first does not depend on which is called a.
template <class V>
VESICA_INLINE Direction<V> middle(const Axes<V>& a, const Axes<V>& b, V dx, V dy, const Bracket<V>& bracket,
                                  int step) noexcept {
  if (step % 3 == 2) {
    const Direction<V> low = unit(bracket.low.x, bracket.low.y), high = unit(bracket.high.x, bracket.high.y);
    return unit(low.x + high.x, low.y + high.y);
  }
  const V sign = V(step % 3 == 0 ? 1.0 : -1.0), x = sign * dx, y = sign * dy, zero(0.0);
  const auto first = either(x > zero, both(x == zero, y > zero));
  return middle_seen_by(
      Axes<V>{select(first, a.ux, b.ux), select(first, a.uy, b.uy), select(first, a.a, b.a), select(first, a.b, b.b)},
      bracket);
}

/// No search has been seen to take more than 30 steps (tests/nearest fails at 48).
inline constexpr int direction_step_limit = 64;

template <class V>
struct FoundDirection {
  Direction<V> n;
  MaskOf<V> found;
  int steps;
};

/// The maximiser of phi. A turn that would leave the bracket, or that turns back by more than half of what the one
/// before turned, gives way to halving the bracket; that ends every search. Lanes that are done stand still.
template <class V>
VESICA_INLINE FoundDirection<V> farthest_direction(const Axes<V>& a, const Axes<V>& b, V dx, V dy, V size) noexcept {
  const V zero(0.0), half(0.5);
  const SemiAxes<V> sa = semi_axes(a), sb = semi_axes(b);
  const Direction<V> ad = adjugate_image(sa, dx, dy), bd = adjugate_image(sb, dx, dy);
  Direction<V> n = improved(sa, sb, dx, dy, ad, bd, {dx, dy});
  const V scale = V(1.0) / (abs(n.x) + abs(n.y));
  n = {n.x * scale, n.y * scale};
  const Direction<V> d{dx, dy}, right{dy, -dx}, left{-dy, dx};
  const auto to_left = cross(d, n) > zero;
  Bracket<V> bracket{choose(to_left, d, right), choose(to_left, left, d)};
  V slope_before = zero, tangent_before = zero;
  auto done = zero > zero;
  int step = 0;
  for (; step < direction_step_limit && !all(done); ++step) {
    const Turn<V> turn = turn_at(sa, sb, dx, dy, size, n);
    const auto rising = turn.slope > zero;
    bracket.low = choose(rising, n, bracket.low);
    bracket.high = choose(rising, bracket.high, n);
    Direction<V> next = turned(n, turn.tangent);
    const auto calm = either(turn.slope * slope_before >= zero, abs(turn.tangent) <= half * abs(tangent_before));
    const auto accepted = either(turn.last, both(both(turn.sane, bracket.holds(next)), calm));
    if (!all(either(done, accepted))) [[unlikely]] {
      const Direction<V> newton = turned(n, turn.slope / select(turn.bend > zero, turn.bend, V(1.0)));
      const auto usable = and_not(both(turn.bend > zero, both(bracket.holds(newton), calm)), turn.sane);
      next = choose(accepted, next, choose(usable, newton, middle(a, b, dx, dy, bracket, step)));
    }
    n = choose(done, n, next);
    slope_before = turn.slope;
    tangent_before = turn.tangent;
    done = either(done, turn.last);
  }
  return {n, done, step};
}

/// The distance between two disjoint ellipses, d from a's centre to b's. Half lengths must be positive.
/// steps: how many the search took, which tests look at.
template <class V>
VESICA_INLINE ClosestOffsets<V> ellipse_ellipse(const Axes<V>& a, const Axes<V>& b, const Vector<V>& d, V size,
                                                int& steps) noexcept {
  const FoundDirection<V> direction = farthest_direction(a, b, d.x.high, d.y.high, size);
  const auto n = normal(factor(direction.n.x, direction.n.y));
  steps = direction.steps;
  ClosestOffsets<V> result = separation(d, n, support(a, n), support(b, n), size);
  result.settled = both(result.settled, direction.found);
  return result;
}

}  // namespace vesica::closest
