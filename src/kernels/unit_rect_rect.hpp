// SPDX-License-Identifier: Apache-2.0
// Rectangles whose axes are near unit length, as those made from angles are: a bound of two operations.
#pragma once

#include <vesica/filter/box_box.hpp>

#include "kernels/guard.hpp"

namespace vesica::filter {

/// True if numbers are in the range of the next filter.
template <class V>
VESICA_INLINE auto unit_box_box_usable(const Box<V>& a, const Box<V>& b) noexcept {
  using T = typename Element<V>::Type;
  const V uu = a.ux * a.ux + a.uy * a.uy, ww = b.ux * b.ux + b.uy * b.uy;
  Guard<V> guard;
  return guard.within(T(0.5f), T(2.0f), uu, ww).not_negative(a.hx, a.hy, b.hx, b.hy).holds();
}

/// The separating axes of filter/box_box.hpp, for squared axes in [1/2, 2).
///
/// Proved: a gap beyond 32u H has the right sign, H being the sum of the four half extents. So the bound is made of
/// sizes alone, and costs two operations. (u: the unit roundoff. p_i: a projection of the offset D on an axis; r_i: how
/// far both boxes reach along it; a gap is p_i - r_i.)
///
///   - No r_i exceeds 2H.
///   - Suppose the sign of a gap were wrong. Then both p_i would be within their r_i, computed or true: |u||D| <=
///     sqrt(8) H.
///   - So p errs by 3u |u||D| <= 8.5u H, as axes are stored and not computed.
///   - r, with the subtraction, errs by 6u (hx U + (gx + gy) |u||w|) <= 12u H.
///   - That is 20.5u H. 32u H leaves room for terms of second order, and is a power of two.
///
/// Proved too: no NaN and no overflow is lost in a maximum, so that an invalid box stays undecided. The bound is formed
/// as 8H, which overflows where an r could, and a gap counts up to 2^106 (double: 2^973).
///
///   - A centre that is not finite, or too far away, leaves no p finite.
///   - Of finite numbers at most one product u_i D_j overflows, as |u|^2 < 2, and its infinity stays.
///   - An axis that is not finite is out of the range that the guard asks for.
template <class V>
VESICA_INLINE auto unit_box_box(const Box<V>& a, const Box<V>& b, const Centre<V>& d) noexcept {
  const V uu = a.ux * a.ux + a.uy * a.uy, ww = b.ux * b.ux + b.uy * b.uy;
  const V c = abs(a.ux * b.ux + a.uy * b.uy), s = abs(a.ux * b.uy - a.uy * b.ux);
  const V p0 = abs(a.ux * d.x + a.uy * d.y) - a.hx * uu, p1 = abs(a.ux * d.y - a.uy * d.x) - a.hy * uu;
  const V q0 = abs(b.ux * d.x + b.uy * d.y) - b.hx * ww, q1 = abs(b.ux * d.y - b.uy * d.x) - b.hy * ww;
  const V gap_a = max((p0 - b.hx * c) - b.hy * s, (p1 - b.hx * s) - b.hy * c);
  const V gap_b = max((q0 - a.hx * c) - a.hy * s, (q1 - a.hx * s) - a.hy * c);
  const V gap = max(gap_a, gap_b);
  const V eight(8.0f), bound = eight * (b.hx + b.hy) + (eight * (a.hx + a.hy) + guard_power<V, -57>());
  return decided_by_gap<2>(unit_box_box_usable(a, b), gap, bound);
}

}  // namespace vesica::filter
