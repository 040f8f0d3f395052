// SPDX-License-Identifier: Apache-2.0
// Rectangles whose axes are near unit length, as those made from angles are: a bound of two operations.
#pragma once

#include <vesica/filter/box_box.hpp>

namespace vesica::filter {

/// The separating axes of filter/box_box.hpp, decided for squared axes in [1/2, 2] by a bound made of sizes alone.
///
/// Let H be the sum of the four half extents. No r_i exceeds 2H. Whichever answer were wrong, both projections p_i
/// would be within their r_i, computed or true, so |u||D| <= sqrt(8) H. With stored axes p errs by 3u |u||D| <= 8.5u H,
/// and r with the subtraction by 6u (hx U + (gx + gy) |u||w|) <= 12u H: 20.5u H; 26u H leaves room for second order. A
/// centre beyond all bounds would not show in H, so only finite gaps count.
template <class V>
VESICA_INLINE auto unit_box_box(const Box<V>& a, const Box<V>& b, const Centre<V>& d) noexcept {
  const V uu = a.ux * a.ux + a.uy * a.uy, ww = b.ux * b.ux + b.uy * b.uy;
  const V c = abs(a.ux * b.ux + a.uy * b.uy), s = abs(a.ux * b.uy - a.uy * b.ux);
  const V p0 = abs(a.ux * d.x + a.uy * d.y) - a.hx * uu, p1 = abs(a.ux * d.y - a.uy * d.x) - a.hy * uu;
  const V q0 = abs(b.ux * d.x + b.uy * d.y) - b.hx * ww, q1 = abs(b.ux * d.y - b.uy * d.x) - b.hy * ww;
  const V gap_a = max((p0 - b.hx * c) - b.hy * s, (p1 - b.hx * s) - b.hy * c);
  const V gap_b = max((q0 - a.hx * c) - a.hy * s, (q1 - a.hx * s) - a.hy * c);
  const V sizes = (a.hx + a.hy) + (b.hx + b.hy);
  const Estimate<V> gap{max(gap_a, gap_b), roundoffs<V>(26) * sizes + underflow_allowance<V>()};
  const V half(0.5f), two(2.0f), bound = guard_power<V, 100>();
  const auto axes = both(in_range(uu, half, two), in_range(ww, half, two));
  const auto valid = at_least(V(0.0f), a.hx, a.hy, b.hx, b.hy);
  return guarded(both(both(axes, valid), both(gap.error <= bound, abs(gap.value) <= bound)), gap);
}

}  // namespace vesica::filter
