// SPDX-License-Identifier: Apache-2.0
/// Box against ellipse without cases, square roots or divisions, with an error bound.
#pragma once

#include <vesica/filter/box.hpp>
#include <vesica/filter/certain_facts.hpp>

namespace vesica::filter {

/// How far two segments, one along each axis of the box's frame, miss the ellipse: positive for a segment that misses.
/// The shapes are disjoint iff both miss, that is iff the lesser value is positive. exact/box_ellipse.hpp says which
/// segments these are and why two suffice. One error bounds both values.
template <class V>
struct BoxEllipse {
  V misses_x, misses_y, error;
  V uu, vv;
};

/// A segment at distance x from the centre, centred at y and of half length e, misses the ellipse by
/// m^2 - det (p00 - x^2), m = max(|p00 y - p01 x| - p00 e, 0) being this gap.
///
/// Proved: what is computed is off by at most error_m (2m + error_m) + u m^2 + det (33u Q + 42u x T) + u of either
/// term, with error_m = 32u Q T. visible_edges() forms this bound from numbers that it has anyway. Here U = u.u, V =
/// v.v, Q = p00 + p11 = (a^2 + b^2) U V, T = |kx| + |ky| + (hx + hy) U, and components of u are off by u of themselves
/// (a segment's direction). To first order errors are:
///
///   k; h U; x:            6u T; 6u h U; 10u T            (filter/box_box.hpp)
///   c, s:                 4u |u||v|
///   p00, p11; p01:        12u Q; 10u Q, with |p01| <= Q / 2
///   m:                    12u Q y + 6u Q T + 10u Q x + 5u Q T + 18u Q e + 3u (Q y + Q x / 2 + Q e) <= 32u Q T
///   m^2:                  error_m (2m + error_m) + u m^2
///   det = (a b U V)^2:    19u of itself
///   p00 - x^2:            13u Q + 22u x T
///   det (p00 - x^2):      det (33u Q + 42u x T)
///
/// The bound is summed over both segments, so that one serves either.
template <class V>
VESICA_INLINE constexpr V gap_along_segment(V p00, V p01, V x, V y, V e) noexcept {
  return positive_part(abs(p00 * y - p01 * x) - p00 * e);
}

/// A box and an ellipse in the frame of the box, in units of |u|: the offset k of centres, half extents e of the box,
/// the ellipse's axis (c, s) and half lengths times it, and its squared half extents p00, p11.
template <class V>
struct BoxFrame {
  V uu, vv, kx, ky, ex, ey, c, s, ac, as, bc, bs, p00, p11;
};

/// d: from the box's centre to the ellipse's.
template <class V>
VESICA_INLINE constexpr BoxFrame<V> box_frame(const Box<V>& box, const Ellipse<V>& ellipse,
                                              const Centre<V>& d) noexcept {
  const V uu = box.ux * box.ux + box.uy * box.uy, vv = ellipse.ux * ellipse.ux + ellipse.uy * ellipse.uy;
  const V kx = box.ux * d.x + box.uy * d.y, ky = box.ux * d.y - box.uy * d.x;
  const V c = box.ux * ellipse.ux + box.uy * ellipse.uy, s = box.ux * ellipse.uy - box.uy * ellipse.ux;
  const V ac = ellipse.a * c, as = ellipse.a * s, bc = ellipse.b * c, bs = ellipse.b * s;
  return {uu, vv, kx, ky, box.hx * uu, box.hy * uu, c, s, ac, as, bc, bs, ac * ac + bs * bs, as * as + bc * bc};
}

template <class V>
VESICA_INLINE constexpr BoxEllipse<V> visible_edges(const BoxFrame<V>& f, const Ellipse<V>& ellipse) noexcept {
  // Folding the centre into the first quadrant flips the sign of p01 with that of kx ky, which must not underflow.
  const V p01 = flip_sign(flip_sign(f.ac * f.as - f.bc * f.bs, f.kx), f.ky);
  const V root = (ellipse.a * ellipse.b) * (f.uu * f.vv), det = root * root;
  const V x = positive_part(abs(f.kx) - f.ex), y = positive_part(abs(f.ky) - f.ey);
  const V q = f.p00 + f.p11, t = (abs(f.kx) + abs(f.ky)) + (f.ex + f.ey);
  const V m = gap_along_segment(f.p00, p01, x, abs(f.ky), f.ey), n = gap_along_segment(f.p11, p01, y, abs(f.kx), f.ex);
  const V error_m = roundoffs<V>(34) * (q * t), gaps = m + n;
  return {m * m - det * (f.p00 - x * x), n * n - det * (f.p11 - y * y),
          error_m * ((gaps + gaps) + error_m) + roundoffs<V>(48) * (det * (q + (x + y) * t)), f.uu, f.vv};
}

/// d: from the box's centre to the ellipse's.
template <class V>
VESICA_INLINE constexpr BoxEllipse<V> visible_edges(const Box<V>& box, const Ellipse<V>& ellipse,
                                                    const Centre<V>& d) noexcept {
  return visible_edges(box_frame(box, ellipse, d), ellipse);
}

#if VESICA_HAS_TWO_DOUBLES
/// The same for one pair, both segments at once.
VESICA_INLINE BoxEllipse<double> visible_edges(const Box<double>& box, const Ellipse<double>& ellipse,
                                               const Centre<double>& d) noexcept {
  using V = TwoDoubles;
  const V u(box.ux, box.uy), v(ellipse.ux, ellipse.uy), lengths(ellipse.a, ellipse.b);
  const V k = turned(box, V(d.x, d.y)), cs = turned(box, v), ux = firsts(u, v), uy = seconds(u, v);
  const V squares = ux * ux + uy * uy, e = V(box.hx, box.hy) * V(squares.first());
  const V ac = firsts(lengths, lengths) * cs, bc = seconds(lengths, lengths) * cs, bs = exchanged(bc);
  const V p = ac * ac + bs * bs, p01 = ac * exchanged(ac) - bc * bs;
  const double root = (ellipse.a * ellipse.b) * (squares.first() * squares.second()), det = root * root;
  const V along = abs(k), x = positive_part(along - e);
  // Two reflections in place of p01's sign: a gap is the same for a segment and its mirror image.
  const V m = positive_part(abs(p * exchanged(k) - p01 * flip_sign(x, k)) - p * exchanged(e));
  const V misses = m * m - V(det) * (p - x * x), q_and_t = sums(p, along + e), gaps_and_x = sums(m, x);
  const double q = q_and_t.first(), t = q_and_t.second(), gaps = gaps_and_x.first();
  const double error_m = roundoffs<double>(34) * (q * t);
  return {misses.first(), misses.second(),
          error_m * ((gaps + gaps) + error_m) + roundoffs<double>(48) * (det * (q + gaps_and_x.second() * t)),
          squares.first(), squares.second()};
}
#endif

/// How far the ellipse reaches out of the box: its squared half extent along an axis of the box less the square of the
/// room that the box leaves there, the greater of two. Where there is no room, it reaches out.
///
/// Proved: it is off by at most e (2 room + e) + 14u Q, with e = 12u T and T, Q as for gap_along_segment(). The room
/// errs by 10u T, its square so by e (2 room + e) and a rounding, p by 12u Q, the difference by u of either.
template <class V>
VESICA_INLINE constexpr Estimate<V> ellipse_out_of_box(const BoxFrame<V>& f) noexcept {
  const V kx = abs(f.kx), ky = abs(f.ky);
  const V x = positive_part(f.ex - kx), y = positive_part(f.ey - ky);
  const V e = roundoffs<V>(12) * ((kx + ky) + (f.ex + f.ey));
  return {max(f.p00 - x * x, f.p11 - y * y), (e + e) * ((x + y) + e) + roundoffs<V>(14) * (f.p00 + f.p11)};
}

/// How far the farthest corner of the box lies outside the ellipse, squared: in the frame in which the ellipse is the
/// disc of radius a b V about the origin, m the box's centre, g and h its half edges, the corners are m +- (g + h) and
/// m +- (g - h), and of two opposite ones the farther is at |m|^2 + |e|^2 + 2 |m . e|.
///
/// Proved: it is off by at most 32u L (b X0 + a X1 + 32u L (a^2 + b^2)) + 12u (a b V)^2, X0 and X1 being the greatest
/// coordinates of a corner, and L = |x0| + |x1| + (hx + hy) (|c| + |s|), which is at least |v| (|D| + (hx + hy) |u|).
///
///   - x0, x1 err by 4u L, and m by 5u b L and 5u a L along the two axes.
///   - g + h and g - h err by 7u b L and 7u a L, so corners by 12u b L and 12u a L.
///   - As |X0| <= b L, the squared distance errs by 24u (b X0 + a X1) L + 144u^2 (a^2 + b^2) L^2, and by seven
///     roundings of X0^2 + X1^2.
///   - (a b V)^2 errs by 9u, and the difference is one rounding more.
template <class V>
VESICA_INLINE constexpr Estimate<V> box_out_of_ellipse(const BoxFrame<V>& f, const Box<V>& box,
                                                       const Ellipse<V>& ellipse, const Centre<V>& d) noexcept {
  const V x0 = ellipse.ux * d.x + ellipse.uy * d.y, x1 = ellipse.ux * d.y - ellipse.uy * d.x;
  const V m0 = ellipse.b * x0, m1 = ellipse.a * x1;
  const V g0 = box.hx * f.bc, g1 = box.hx * f.as, h0 = box.hy * f.bs, h1 = box.hy * f.ac;
  const V s0 = g0 + h0, s1 = h1 - g1, t0 = g0 - h0, t1 = g1 + h1;
  const V along_s = abs(m0 * s0 + m1 * s1), along_t = abs(m0 * t0 - m1 * t1);
  const V farthest = max((s0 * s0 + s1 * s1) + (along_s + along_s), (t0 * t0 + t1 * t1) + (along_t + along_t));
  const V root = (ellipse.a * ellipse.b) * f.vv, det = root * root;
  const V e = roundoffs<V>(32) * ((abs(x0) + abs(x1)) + (box.hx + box.hy) * (abs(f.c) + abs(f.s)));
  const V reach0 = abs(m0) + (abs(g0) + abs(h0)), reach1 = abs(m1) + (abs(g1) + abs(h1));
  const V reach = ellipse.b * reach0 + ellipse.a * reach1;
  return {((m0 * m0 + m1 * m1) + farthest) - det,
          e * (reach + e * (ellipse.a * ellipse.a + ellipse.b * ellipse.b)) + roundoffs<V>(12) * det};
}

/// The guard, where neither underflow nor overflow breaks the bound: half lengths at least 2^-10, squared axes 2^-5 to
/// 2^15 (double: the 8th powers), sizes not negative, errors below 2^100. Then det Q >= 2^-90 stays normal, no product
/// of either side overflows while its bound does not, and what underflows in k or T is far below the part of the bound
/// that det Q carries.
template <class V>
VESICA_INLINE constexpr auto box_ellipse_usable(const BoxEllipse<V>& edges, const Box<V>& box,
                                                const Ellipse<V>& ellipse) noexcept {
  const V low = guard_power<V, -5>(), high = guard_power<V, 15>();
  const auto axes = both(in_range(edges.uu, low, high), in_range(edges.vv, low, high));
  const auto sizes = both(at_least(guard_power<V, -10>(), ellipse.a, ellipse.b), at_least(V(0.0f), box.hx, box.hy));
  return both(both(axes, sizes), edges.error <= guard_power<V, 100>());
}

#if VESICA_HAS_TWO_DOUBLES
VESICA_INLINE bool box_ellipse_usable(const BoxEllipse<double>& edges, const Box<double>& box,
                                      const Ellipse<double>& ellipse) noexcept {
  using V = TwoDoubles;
  const V squares(edges.uu, edges.vv), shortest(guard_power<double, -10>());
  const auto axes = in_range(squares, V(guard_power<double, -5>()), V(guard_power<double, 15>()));
  const auto sizes = both(shortest <= V(ellipse.a, ellipse.b), V(0.0) <= V(box.hx, box.hy));
  return both(in_both(both(axes, sizes)), edges.error <= guard_power<double, 100>());
}
#endif

template <class V>
VESICA_INLINE constexpr auto box_ellipse(const Box<V>& box, const Ellipse<V>& ellipse, const Centre<V>& d) noexcept {
  const BoxEllipse<V> edges = visible_edges(box, ellipse, d);
  const Estimate<V> least{min(edges.misses_x, edges.misses_y), edges.error};
  return guarded(box_ellipse_usable(edges, box, ellipse), least);
}

/// The same guard, and errors of the same limit. Then (a b V)^2 >= 2^-50 and p00 + p11 >= 2^-30 are normal in every
/// bound, and X0^2, X1^2 and the squared room are below 2^20 times bounds that are finite.
template <class V>
VESICA_INLINE constexpr auto box_ellipse_certain_facts(const Box<V>& box, const Ellipse<V>& ellipse,
                                                       const Centre<V>& d) noexcept {
  const BoxFrame<V> frame = box_frame(box, ellipse, d);
  const BoxEllipse<V> edges = visible_edges(frame, ellipse);
  const Estimate<V> least{min(edges.misses_x, edges.misses_y), edges.error};
  const Estimate<V> box_out = box_out_of_ellipse(frame, box, ellipse, d), ellipse_out = ellipse_out_of_box(frame);
  const auto finite = both(box_out.error <= guard_power<V, 100>(), ellipse_out.error <= guard_power<V, 100>());
  return guarded(both(box_ellipse_usable(edges, box, ellipse), finite), certain_facts(least, box_out, ellipse_out));
}

}  // namespace vesica::filter
