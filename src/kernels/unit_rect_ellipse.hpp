// SPDX-License-Identifier: Apache-2.0
// Rectangle and ellipse whose axes are of unit length but for rounding: none of their squares is multiplied by.
#pragma once

#include <vesica/filter/box_ellipse.hpp>

#include "kernels/guard.hpp"
#include "kernels/unit_axes.hpp"

namespace vesica::filter {

/// The two segments of filter/box_ellipse.hpp in the box's frame, with the axes u, v taken to be of length 1: their
/// squares U, V are within 14u of 1. `bound` is for the error of the gap along either.
///
/// Proved: a gap beyond 128u Q R (a b (a + b) + 16u Q R) has the right sign. The bound has no term for each product, as
/// filter/box_ellipse.hpp needs for axes of any length; so it costs few operations. Here Q = p00 + p11,
/// T = |kx| + |ky| + hx + hy, R = T + a + b, and m >= 0 is the gap along a segment at distance x from the centre.
///
/// Suppose the sign were wrong. Then m^2 <= det (p00 - x^2) for one of the segments, computed or true, so that
/// m <= a b sqrt(Q) <= a b (a + b) and x^2 <= p00. In units of u, and to first order, what is computed errs by:
///
///   k:                    3T
///   x:                    15T, for h U and the difference
///   c, s:                 2
///   p00, p11; p01:        8Q; 5Q
///   p00 y:                8Q y + 3Q T + Q y
///   p01 x:                5.5Q x + 7.5Q T, as |p01| <= Q / 2
///   p00 h U:              23Q h
///   two differences:      2Q (y + x/2 + h)
///   m, by these four:     11Q y + 3Q (|kx| + |ky|) + 6.5Q x + 7.5Q T + 25Q h <= 33Q T
///   m^2:                  66 m Q T, and 33^2 u Q^2 T^2
///   det = (a b U V)^2:    59 of itself
///   det (p00 - x^2):      det (59Q + 8Q + 30 sqrt(Q) T + 4Q)
///   the difference:       det Q
///
/// As a b <= (a + b)^2 / 4, what has det is at most 18 a b Q (a + b)^2 + 15 a b Q (a + b) T. All together is below
/// 84u a b (a + b) Q R + 1089u^2 Q^2 R^2. The bound leaves room for second order.
///
/// The guard keeps underflow and overflow from mattering. With a, b in [2^-16, 2^16) (double: the 8th powers) the bound
/// is at least 2^-111, all that underflows far below it, and Q at least 2^-32. If a product of the gap overflows, so
/// does the square of the gap's error, or the square of the gap or of x alone; these are far from contact, and infinity
/// has the right sign. NaN and infinity reach T.
template <class V, class Usable>
struct UnitBoxEllipse {
  using Lanes = V;
  V abs_kx, abs_ky, hx, hy, p00, p01, p11, det, bound;
  Usable usable;
};

template <class V>
VESICA_INLINE void require_sizes(Guard<V>& guard, const Box<V>& box) noexcept {
  guard.not_negative(box.hx, box.hy);
}
template <class V>
VESICA_INLINE void require_sizes(Guard<V>& guard, const Ellipse<V>& e) noexcept {
  using T = typename Element<V>::Type;
  guard.within(guard_power<T, -16>(), guard_power<T, 16>(), e.a, e.b);
}

/// The terms of a box and an ellipse that both pass require_sizes() and require_unit_axes().
template <class V, class Usable>
VESICA_INLINE UnitBoxEllipse<V, Usable> unit_box_ellipse(const Box<V>& box, const Ellipse<V>& ellipse,
                                                         const Centre<V>& d, Usable usable) noexcept {
  const V kx = box.ux * d.x + box.uy * d.y, ky = box.ux * d.y - box.uy * d.x;
  const V c = box.ux * ellipse.ux + box.uy * ellipse.uy, s = box.ux * ellipse.uy - box.uy * ellipse.ux;
  const V ac = ellipse.a * c, as = ellipse.a * s, bc = ellipse.b * c, bs = ellipse.b * s;
  const V p00 = ac * ac + bs * bs, p11 = as * as + bc * bc, p01 = flip_sign(flip_sign(ac * as - bc * bs, kx), ky);
  const V root = ellipse.a * ellipse.b, sum = ellipse.a + ellipse.b;
  const V reach = (abs(kx) + abs(ky)) + ((box.hx + box.hy) + sum), qr = (p00 + p11) * reach;
  return {
      abs(kx), abs(ky), box.hx, box.hy, p00, p01, p11, root * root, qr * (root * sum + nearest_roundoffs<V>(16) * qr),
      usable};
}
template <class V>
VESICA_INLINE auto unit_box_ellipse(const Box<V>& box, const Ellipse<V>& ellipse, const Centre<V>& d) noexcept {
  Guard<V> guard;
  require_sizes(guard, ellipse);
  require_sizes(guard, box);
  require_unit_axes(guard, box, ellipse);
  return unit_box_ellipse(box, ellipse, d, guard.holds());
}

template <class V, class Usable>
VESICA_INLINE auto decide(const UnitBoxEllipse<V, Usable>& f) noexcept {
  const V x = positive_part(f.abs_kx - f.hx), y = positive_part(f.abs_ky - f.hy);
  const V m = gap_along_segment(f.p00, f.p01, x, f.abs_ky, f.hy);
  const V n = gap_along_segment(f.p11, f.p01, y, f.abs_kx, f.hx);
  const V gap = min(m * m - f.det * (f.p00 - x * x), n * n - f.det * (f.p11 - y * y));
  return decided_by_gap<7>(f.usable, gap, f.bound);
}

}  // namespace vesica::filter
