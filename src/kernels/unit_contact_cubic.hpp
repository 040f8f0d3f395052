// SPDX-License-Identifier: Apache-2.0
// Two ellipses, or a circle and an ellipse, of unit axes up to rounding and not thin: errors are then small beside
// the polynomial's own two parts, and no sums of magnitudes are formed to bound them.
#pragma once

#include <vesica/filter/box.hpp>

#include "kernels/guard.hpp"
#include "kernels/unit_axes.hpp"

namespace vesica::filter {

/// The contact cubic of filter/contact_cubic.hpp in its two parts: overlap iff
/// p(x) = (g + x)(d1 + mu x + d2 x^2) - x (al + be x) >= 0 for all x > 0. All coefficients are positive.
///
/// Proved: each has a relative error of at most 37u, but al and be of 62u. So decide() can bound the error of p by p's
/// own two parts, without sums of magnitudes. By the guard, ratios k of half lengths are below 17, axes' squares V, W
/// within 14u of 1, their cosine and sine c, s off by 2u, and coordinates x0, x1 along them by 3u |v||D|. Then errors
/// are:
///
///   d1 = (a b V)^2:                31u
///   mu = c^2 P + s^2 R:            11u of itself, and 4u |c s|(P + R): in all 36u, as |c s| <= mu / (2 sqrt(P R)) and
///                                  (P + R) / 2 <= 6.1 sqrt(P R), R / P being from 2 / k^2 to (k^4 + 1) / (2 k^2)
///   al = (b x0)^2 + (a x1)^2:      10u of itself, and 6u (a^2 + b^2)|x0 x1| <= 3u (k + 1 / k) al: in all 62u
template <class V, class Usable>
struct UnitCubic {
  using Lanes = V;
  V g, d1, mu, d2, al, be;
  Usable usable;
};

/// -p(t) at a t >= 0 that nearly minimises q, a lower estimate of p.
///
/// Proved: beyond 512u of p's first part (`above`) the sign of the value answers. If it is positive, p(t) < 0, so
/// shapes are disjoint; if it is negative, q > 0 everywhere, so they overlap. Let h = (g + t)(d1 + mu t + d2 t^2) + t
/// (al + be t).
///
///   - q(x) = (g + x)(d1 + mu x + d2 x^2) - (1 + r) x (al + be x), with 112u <= r <= 225u. Its coefficients are off by
///     2u of their parts, and p >= (1 - 40u) q.
///   - t minimises q but for an error that enters squared, as filter/contact_cubic.hpp shows: 7u h.
///   - Evaluation errs by 8u h.
///   - So p(t) is at most 70u h above what was computed, and q nowhere more than (225 + 2 + 7 + 8)u h below it.
///   - Overlap: the first part is the greater one, so h <= 2 above, and 242u h <= 484u above.
///   - Disjoint: 70u h <= 512u above as long as h <= 7 above. Beyond that the value is more than half of h.
template <class V, class Usable>
VESICA_INLINE auto decide(const UnitCubic<V, Usable>& p) noexcept {
  const V zero(0.0f), three_d2 = V(3.0f) * p.d2;
  const V l1 = (p.d1 + p.g * p.mu) - raised<112>(p.al), l2 = (p.mu + p.g * p.d2) - raised<112>(p.be);
  const V sum = abs(l2) + rough_sqrt(max(zero, l2 * l2 - three_d2 * l1));
  const auto rising = l2 > zero;
  const V t = max(zero, rough_quotient(select(rising, zero - l1, sum), select(rising, sum, three_d2)));
  const V pencil = (p.d2 * t + p.mu) * t + p.d1, above = pencil * t + p.g * pencil, rate = p.be * t + p.al;
  return decided_by_gap<9>(p.usable, rate * t - above, above);
}

/// Half lengths from 2^-6 to 2^10 (double: the 8th powers) and the other of each ellipse within 17 times. Then d1, d2
/// are from 2^-41 to 2^49, mu is below 2^58, and what underflows is far below d1. Where an offset or t is so large that
/// anything overflows, t or the gap is infinite or NaN, which max(zero, x) keeps, and decides nothing.
template <class V>
VESICA_INLINE void require_moderate(Guard<V>& guard, const Ellipse<V>& e) noexcept {
  using T = typename Element<V>::Type;
  guard.within(guard_power<T, -6>(), guard_power<T, 10>(), e.a).near_in_size(e.a, e.b);
}

template <class V>
VESICA_INLINE auto unit_contact_cubic(const Ellipse<V>& e, const Ellipse<V>& f) noexcept {
  const V dx = f.cx - e.cx, dy = f.cy - e.cy;
  const V c = e.ux * f.ux + e.uy * f.uy, s = e.ux * f.uy - e.uy * f.ux;
  const V x0 = e.ux * dx + e.uy * dy, x1 = e.ux * dy - e.uy * dx;
  const V y0 = f.ux * dx + f.uy * dy, y1 = f.ux * dy - f.uy * dx;
  const V e_aa = e.a * e.a, e_bb = e.b * e.b, f_aa = f.a * f.a, f_bb = f.b * f.b;
  const V mu = (c * c) * (e_aa * f_bb + e_bb * f_aa) + (s * s) * (e_aa * f_aa + e_bb * f_bb);
  const V al = e_bb * (x0 * x0) + e_aa * (x1 * x1), be = f_bb * (y0 * y0) + f_aa * (y1 * y1);
  Guard<V> guard;
  require_unit_axes(guard, e, f);
  require_moderate(guard, e);
  require_moderate(guard, f);
  return UnitCubic<V, decltype(guard.holds())>{V(1.0f), e_aa * e_bb, mu, f_aa * f_bb, al, be, guard.holds()};
}

/// With x = t / r^2, times r^2: g = r^2, d1 = P Q, mu = P + Q, d2 = 1, be = |D|^2. Radii from 2^-6 to 2^10.
template <class V>
VESICA_INLINE auto unit_contact_cubic(const Circle<V>& disc, const Ellipse<V>& e) noexcept {
  using T = typename Element<V>::Type;
  const Centre<V> d = offset(place(disc), place(e));
  const V x0 = e.ux * d.x + e.uy * d.y, x1 = e.ux * d.y - e.uy * d.x;
  const V p = e.a * e.a, q = e.b * e.b;
  const V al = q * (x0 * x0) + p * (x1 * x1), be = d.x * d.x + d.y * d.y;
  Guard<V> guard;
  require_unit_axes(guard, e);
  require_moderate(guard, e);
  guard.within(guard_power<T, -6>(), guard_power<T, 10>(), disc.r);
  return UnitCubic<V, decltype(guard.holds())>{disc.r * disc.r, p * q, p + q, V(1.0f), al, be, guard.holds()};
}

}  // namespace vesica::filter
