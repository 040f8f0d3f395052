// SPDX-License-Identifier: Apache-2.0
// Rectangle and ellipse of unit axes but for rounding, in blocks that were checked as a whole.
#pragma once

#include <vesica/filter/box_ellipse.hpp>

#include "kernels/checked_shapes.hpp"

namespace vesica::filter {

/// The two segments of filter/box_ellipse.hpp, in units of r = a b: a segment at distance x from the centre is missed iff
/// m^2 > r p00 - x^2, m being the gap along it by the matrix p / r, whose determinant is 1. Signs are kept, where folding
/// into a quadrant would flip that of p01.
///
/// Let H = hx + hy, Q = p00 + p11 >= 2, w^2 = r Q = a^2 + b^2, T = |kx| + |ky| + H, all squared axes within 14u of 1 and
/// ratios k of half lengths below 17. In units of u and to first order,
///   k: 3T; hx U: 14h; x: 15T
///   p00, p11: mean by 28 for U V and 4, swing by 15, the sum by 1, each of at most Q / 2 or Q: 25Q; p01: 8Q
///   m: p00 y: 26Q y + 3Q T; p01 x, |p01| <= Q / 2: 8.5Q x + 7.5Q T; p00 h U: 40Q h; two differences: 2Q (y + x/2 + h);
///     in all 52.5Q T
///   m^2: 105 m Q T + m^2, and 52.5^2 u Q^2 T^2;  r p00 - x^2 with (U V)^2: r Q (56 + 25 + 3) + 30 x T
///   the difference: two of what is within r Q
/// Of a segment that gives a wrong answer m <= w and x <= w, computed or true: 120 Q w (T + 0.4w). The ellipse then meets
/// the segment, or the computed p00 >= 1/17 lets |ky| exceed hy by at most a + sqrt(r / p00) <= 2 max(a, b), so that
/// T <= 2H + 3w. With 2H w <= H^2 + w^2 that is 120u Q (H^2 + 4.4 Q r), which is u mean (240 H^2 + 2112 r mean), mean
/// being Q / 2; 320 and 2816 leave room for the second order of float while H <= 2^12 (a + b), so that T <= 11,600 w.
template <class V>
VESICA_INLINE auto checked_box_ellipse(const Rect<V>& box, const PreparedEllipse<V>& e) noexcept {
  const V dx = e.cx - box.cx, dy = e.cy - box.cy, zero(0.0f);
  const V kx = box.ux * dx + box.uy * dy, ky = box.ux * dy - box.uy * dx;
  const V cos = box.ux * box.ux - box.uy * box.uy, sin = (box.ux + box.ux) * box.uy;
  const V swing = cos * e.swing_cos + sin * e.swing_sin, p01 = cos * e.swing_sin - sin * e.swing_cos;
  const V p00 = e.mean + swing, p11 = e.mean - swing, h = box.hx + box.hy;
  const V x = kx - max(min(kx, box.hx), zero - box.hx), y = ky - max(min(ky, box.hy), zero - box.hy);
  const V m = gap_along_segment(p00, p01, x, ky, box.hy), n = gap_along_segment(p11, p01, y, kx, box.hx);
  const V gap = min(m * m + (x * x - e.r * p00), n * n + (y * y - e.r * p11));
  const V bound = e.mean * ((roundoffs<V>(320) * h) * h + (roundoffs<V>(2816) * e.r) * e.mean);
  const auto known = abs(gap) > bound;
  return DecidedVerdict<decltype(gap > zero)>{greater_where(known, zero, gap), known};
}

}  // namespace vesica::filter
