// SPDX-License-Identifier: Apache-2.0
// Rectangle and ellipse with axes of unit length up to rounding, in blocks that were checked as a whole.
#pragma once

#include <vesica/filter/box_ellipse.hpp>

#include "kernels/checked_shapes.hpp"

namespace vesica::filter {

/// The two segments of filter/box_ellipse.hpp, in units of r = a b: a segment at distance x from the centre is missed
/// iff m^2 > r p00 - x^2, m being the gap along it by the matrix p / r, whose determinant is 1. Signs are kept, where
/// folding into a quadrant would flip that of p01.
///
/// Proved: a gap beyond u mean (320 H^2 + 2816 r mean) has the right sign, for H = hx + hy. The bound has no offset in
/// it, so most of it is computed once for each shape, and not for each pair. Here `mean` is Q / 2, Q = p00 + p11 >= 2,
/// w^2 = r Q = a^2 + b^2 and T = |kx| + |ky| + H. All squared axes are within 14u of 1, and ratios of half lengths
/// below 17.
///
/// First, in units of u and to first order, what is computed errs by:
///
///   k; hx U; x:           3T; 14h; 15T
///   p00, p11:             25Q: mean by 28 for U V and 4, swing by 15, the sum by 1, each of at most Q / 2 or Q
///   p01:                  8Q
///   p00 y:                26Q y + 3Q T
///   p01 x:                8.5Q x + 7.5Q T, as |p01| <= Q / 2
///   p00 h U:              40Q h
///   two differences:      2Q (y + x/2 + h)
///   m, by these four:     52.5Q T
///   m^2:                  105 m Q T + m^2, and 52.5^2 u Q^2 T^2
///   r p00 - x^2:          r Q (56 + 25 + 3) + 30 x T, with (U V)^2
///   the difference:       two of what is within r Q
///
/// Second, suppose that a segment gives a wrong answer. Then m <= w and x <= w, computed or true, and these errors are
/// 120 Q w (T + 0.4w). The ellipse meets the segment, or the computed p00 >= 1/17 lets |ky| exceed hy by at most
/// a + sqrt(r / p00) <= 2 max(a, b). So T <= 2H + 3w. With 2H w <= H^2 + w^2 that is 120u Q (H^2 + 4.4 Q r), which is
/// u mean (240 H^2 + 2112 r mean).
///
/// Third, 320 and 2816 leave room for the second order of float while H <= 2^12 (a + b), so that T <= 11,600 w: the
/// caller sees to that (is_usable() in checked.hpp).
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
  const V bound = e.mean * ((nearest_roundoffs<V>(320) * h) * h + (nearest_roundoffs<V>(2816) * e.r) * e.mean);
  const auto known = abs(gap) > bound;
  return DecidedVerdict<decltype(gap > zero)>{greater_where(known, zero, gap), known};
}

}  // namespace vesica::filter
