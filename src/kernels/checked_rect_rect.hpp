// SPDX-License-Identifier: Apache-2.0
// Rectangles with axes of unit length up to rounding, in blocks that were checked as a whole: one bound serves
// a row of them.
#pragma once

#include <vesica/filter/estimate.hpp>

#include "kernels/guard.hpp"

namespace vesica::filter {

/// The separating axes of unit_rect_rect.hpp, with squared axes taken to be 1.
///
/// Proved: a gap beyond 32u H has the right sign, H being the sum of the four half extents. The bound grows with H and
/// has no offset in it, so that of the largest box of a block serves the whole row, and is computed once.
///
/// In units of u, and to first order:
///
///   - No r_i exceeds H. On the axis that gives a wrong answer p and r are within H, and so is the other projection:
///     |D| <= sqrt(2) H.
///   - p errs by 3 |D| <= 4.3 H.
///   - hx U errs by 14 hx, as U is within 14u of 1 (unit_axes.hpp); (gx c) and (gy s) by 3 (gx + gy).
///   - Three subtractions of what is within H add 3 H. In all 21.3 H; the rest is room for second order.
///
/// Sizes and coordinates below 2^32 (double: 2^256) let nothing overflow. What underflows is far below the 2^-100
/// added.
template <class V>
class CheckedBoxBox {
 public:
  /// reach: the greatest sum of half extents among the boxes that `one` is asked with.
  VESICA_INLINE CheckedBoxBox(const Rect<V>& one, V reach) noexcept
      : bound_(nearest_roundoffs<V>(32) * ((one.hx + one.hy) + reach) + guard_power<V, -100>()) {}

  VESICA_INLINE auto filter(const Rect<V>& a, const Rect<V>& b) const noexcept {
    const V dx = b.cx - a.cx, dy = b.cy - a.cy;
    const V c = abs(a.ux * b.ux + a.uy * b.uy), s = abs(a.ux * b.uy - a.uy * b.ux);
    const V p0 = abs(a.ux * dx + a.uy * dy) - a.hx, p1 = abs(a.ux * dy - a.uy * dx) - a.hy;
    const V q0 = abs(b.ux * dx + b.uy * dy) - b.hx, q1 = abs(b.ux * dy - b.uy * dx) - b.hy;
    const V gap_a = max((p0 - b.hx * c) - b.hy * s, (p1 - b.hx * s) - b.hy * c);
    const V gap_b = max((q0 - a.hx * c) - a.hy * s, (q1 - a.hx * s) - a.hy * c);
    const V gap = max(gap_a, gap_b);
    return Verdict<decltype(gap > bound_)>{gap<V(0.0f) - bound_, gap> bound_};
  }

 private:
  V bound_;
};

}  // namespace vesica::filter
