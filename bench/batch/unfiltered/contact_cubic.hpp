// SPDX-License-Identifier: Apache-2.0
/// Two ellipses by the sign of their contact cubic at its minimum, for axes taken to be of unit length; no error bound.
#pragma once

#include <vesica/shapes.hpp>

namespace vesica::unfiltered {

/// True if d1 + c1 t + c2 t^2 + d2 t^3 >= 0 for all t > 0, d1 and d2 positive: its value at the greater root of its
/// derivative, in the form that adds like signs; one square root and one division.
template <class V>
VESICA_INLINE auto stays_positive(V d1, V c1, V c2, V d2) noexcept {
  const V zero(0.0f), three_d2 = V(3.0f) * d2;
  const V sum = abs(c2) + rough_sqrt(max(c2 * c2 - three_d2 * c1, zero));
  const auto rising = c2 > zero;
  const V t = max(rough_quotient(select(rising, zero - c1, sum), select(rising, sum, three_d2)), zero);
  return ((d2 * t + c2) * t + c1) * t + d1 >= zero;
}

template <class V>
VESICA_INLINE auto overlap(const Ellipse<V>& e, const Ellipse<V>& f) noexcept {
  const V dx = f.cx - e.cx, dy = f.cy - e.cy;
  const V c = e.ux * f.ux + e.uy * f.uy, s = e.ux * f.uy - e.uy * f.ux;
  const V a0 = e.a * e.a, a1 = e.b * e.b, b0 = f.a * f.a, b1 = f.b * f.b;
  const V x0 = e.ux * dx + e.uy * dy, x1 = e.ux * dy - e.uy * dx;
  const V y0 = f.ux * dx + f.uy * dy, y1 = f.ux * dy - f.uy * dx;
  const V mu = (c * c) * (a0 * b1 + a1 * b0) + (s * s) * (a0 * b0 + a1 * b1);
  const V d1 = a0 * a1, d2 = b0 * b1;
  const V c1 = (d1 + mu) - a1 * (x0 * x0) - a0 * (x1 * x1);
  const V c2 = (d2 + mu) - b1 * (y0 * y0) - b0 * (y1 * y1);
  return stays_positive(d1, c1, c2, d2);
}

/// With x = t / r^2, times r^2, the cubic is (r^2 + t)(P + t)(Q + t) - t (al + |D|^2 t).
template <class V>
VESICA_INLINE auto overlap(const Circle<V>& disc, const Ellipse<V>& e) noexcept {
  const V dx = e.cx - disc.cx, dy = e.cy - disc.cy;
  const V x0 = e.ux * dx + e.uy * dy, x1 = e.ux * dy - e.uy * dx;
  const V p = e.a * e.a, q = e.b * e.b, rr = disc.r * disc.r;
  const V pq = p * q, sum = p + q, xx = x0 * x0, yy = x1 * x1;
  const V c1 = (pq + rr * sum) - q * xx - p * yy;
  const V c2 = (rr + sum) - (xx + yy);
  return stays_positive(rr * pq, c1, c2, V(1.0f));
}

}  // namespace vesica::unfiltered
