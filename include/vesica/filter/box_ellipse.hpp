// SPDX-License-Identifier: Apache-2.0
/// Box against ellipse without cases, square roots or divisions, with an error bound.
#pragma once

#include <vesica/filter/box.hpp>

namespace vesica::filter {

/// How far two segments, one along each axis of the box's frame, miss the ellipse: positive where they do. The shapes
/// are disjoint iff both do, that is iff the lesser value is positive. exact/box_ellipse.hpp says which segments, and why
/// two suffice. One error bounds both.
template <class V>
struct BoxEllipse {
  V misses_x, misses_y, error;
  V uu, vv;
};

/// A segment at distance x from the centre, centred at y and of half length e, misses the ellipse by
/// m^2 - det (p00 - x^2), m = max(|p00 y - p01 x| - p00 e, 0) being this gap.
///
/// With U = u.u, V = v.v, Q = p00 + p11 = (a^2 + b^2) U V, T = |kx| + |ky| + (hx + hy) U, and components of u off by u
/// (a segment's direction), to first order:
///   k: 6u T, h U: 6u h U, x: 10u T            (filter/box_box.hpp)
///   c, s: 4u |u||v|; p00, p11: 12u Q; p01: 10u Q, |p01| <= Q / 2
///   m: 12u Q y + 6u Q T + 10u Q x + 5u Q T + 18u Q e + 3u (Q y + Q x / 2 + Q e) <= 32u Q T =: error_m
///   det = (a b U V)^2: 19u; p00 - x^2: 13u Q + 22u x T
/// so m^2 is off by error_m (2m + error_m) + u m^2, the product by det (33u Q + 42u x T) and the difference by u of
/// each. Summed over both segments this bounds either.
template <class V>
VESICA_INLINE V gap_along_segment(V p00, V p01, V x, V y, V e) noexcept {
  return positive_part(abs(p00 * y - p01 * x) - p00 * e);
}

/// d: from the box's centre to the ellipse's.
template <class V>
VESICA_INLINE BoxEllipse<V> visible_edges(const Box<V>& box, const Ellipse<V>& ellipse, const Centre<V>& d) noexcept {
  const V uu = box.ux * box.ux + box.uy * box.uy, vv = ellipse.ux * ellipse.ux + ellipse.uy * ellipse.uy;
  const V kx = box.ux * d.x + box.uy * d.y, ky = box.ux * d.y - box.uy * d.x;
  const V c = box.ux * ellipse.ux + box.uy * ellipse.uy, s = box.ux * ellipse.uy - box.uy * ellipse.ux;
  const V ac = ellipse.a * c, as = ellipse.a * s, bc = ellipse.b * c, bs = ellipse.b * s;
  const V p00 = ac * ac + bs * bs, p11 = as * as + bc * bc;
  // Folding the centre into the first quadrant flips the sign of p01 with that of kx ky, which must not underflow.
  const V p01 = flip_sign(flip_sign(ac * as - bc * bs, kx), ky);
  const V root = (ellipse.a * ellipse.b) * (uu * vv), det = root * root;
  const V ex = box.hx * uu, ey = box.hy * uu;
  const V x = positive_part(abs(kx) - ex), y = positive_part(abs(ky) - ey);
  const V q = p00 + p11, t = (abs(kx) + abs(ky)) + (ex + ey);
  const V m = gap_along_segment(p00, p01, x, abs(ky), ey), n = gap_along_segment(p11, p01, y, abs(kx), ex);
  const V error_m = roundoffs<V>(34) * (q * t), gaps = m + n;
  return {m * m - det * (p00 - x * x), n * n - det * (p11 - y * y),
          error_m * ((gaps + gaps) + error_m) + roundoffs<V>(48) * (det * (q + (x + y) * t)), uu, vv};
}

/// Guard: half lengths at least 2^-10, squared axes 2^-5 to 2^15 (double: the 8th powers), sizes not negative, errors
/// below 2^100. Then det Q >= 2^-90 stays normal, no product of either side overflows while its bound does not, and
/// what underflows in k or T is far below the part of the bound that det Q carries.
template <class V>
VESICA_INLINE auto box_ellipse(const Box<V>& box, const Ellipse<V>& ellipse, const Centre<V>& d) noexcept {
  const BoxEllipse<V> edges = visible_edges(box, ellipse, d);
  const V low = guard_power<V, -5>(), high = guard_power<V, 15>();
  const auto axes = both(in_range(edges.uu, low, high), in_range(edges.vv, low, high));
  const auto sizes = both(at_least(guard_power<V, -10>(), ellipse.a, ellipse.b), at_least(V(0.0f), box.hx, box.hy));
  const Estimate<V> least{min(edges.misses_x, edges.misses_y), edges.error};
  return guarded(both(both(axes, sizes), least.error <= guard_power<V, 100>()), least);
}

}  // namespace vesica::filter
