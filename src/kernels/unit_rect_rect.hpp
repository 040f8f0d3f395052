// SPDX-License-Identifier: Apache-2.0
// Rectangles whose axes are near unit length, as those made from angles are: a bound of two operations.
#pragma once

#include <vesica/filter/box_box.hpp>

namespace vesica {
namespace {

using namespace lane;

// Steps that instruction sets may have better ways for, in src/lanes.

/// Where both squared lengths are in [1/2, 2), no size is negative, and |gap| is below 2^100 (f64: 2^800). Another way
/// may refuse -0 too.
template <class V>
VESICA_INLINE auto near_unit_boxes(V uu, V ww, V a_hx, V a_hy, V b_hx, V b_hy, V abs_gap) noexcept {
  const V half(0.5f), two(2.0f);
  const auto axes = both(both(uu >= half, uu < two), both(ww >= half, ww < two));
  return both(axes, both(filter::at_least(V(0.0f), a_hx, a_hy, b_hx, b_hy), abs_gap < filter::guard_power<V, 100>()));
}

template <class Mask, class V>
VESICA_INLINE Mask greater_where(Mask mask, V a, V b) noexcept {
  return both(mask, a > b);
}

/// x / 2^e, for x / 2^e a normal number.
template <int e, class V>
VESICA_INLINE V divide_by_power(V x) noexcept {
  return x * V(ScalarTraits<typename filter::Element<V>::Type>::power(-e));
}

}  // namespace

namespace filter {

/// A filter's answer: overlap is false where it is not decided.
template <class Mask>
struct DecidedVerdict {
  Mask overlap;
  Mask decided;
};

/// The separating axes of filter/box_box.hpp, decided for squared axes in [1/2, 2) by a bound made of sizes alone.
///
/// Let H be the sum of the four half extents. No r_i exceeds 2H. Whichever answer were wrong, both projections p_i
/// would be within their r_i, computed or true, so |u||D| <= sqrt(8) H. With stored axes p errs by 3u |u||D| <= 8.5u H,
/// and r with the subtraction by 6u (hx U + (gx + gy) |u||w|) <= 12u H: 20.5u H; 32u H leaves room for second order, and
/// is a power of two.
///
/// Only gaps below 2^100 (f64: 2^800) count. Then no NaN or overflow can have been lost in a maximum: a centre that is
/// not finite, or too far, leaves no p finite; of finite numbers at most one product u_i D_j overflows, as |u|^2 < 2, and
/// its infinity stays; an axis that is not finite is out of range; and a size that is NaN, or so large that an r
/// overflows, makes the bound exceed 2^100.
template <class V>
VESICA_INLINE auto unit_box_box(const Box<V>& a, const Box<V>& b, const Centre<V>& d) noexcept {
  constexpr int roundoff_exponent = sizeof(typename Element<V>::Type) == 4 ? 24 : 53;
  const V uu = a.ux * a.ux + a.uy * a.uy, ww = b.ux * b.ux + b.uy * b.uy;
  const V c = abs(a.ux * b.ux + a.uy * b.uy), s = abs(a.ux * b.uy - a.uy * b.ux);
  const V p0 = abs(a.ux * d.x + a.uy * d.y) - a.hx * uu, p1 = abs(a.ux * d.y - a.uy * d.x) - a.hy * uu;
  const V q0 = abs(b.ux * d.x + b.uy * d.y) - b.hx * ww, q1 = abs(b.ux * d.y - b.uy * d.x) - b.hy * ww;
  const V gap_a = max((p0 - b.hx * c) - b.hy * s, (p1 - b.hx * s) - b.hy * c);
  const V gap_b = max((q0 - a.hx * c) - a.hy * s, (q1 - a.hx * s) - a.hy * c);
  const V gap = max(gap_a, gap_b);
  const V sizes = (b.hx + b.hy) + ((a.hx + a.hy) + guard_power<V, -60>());
  const V error = divide_by_power<roundoff_exponent - 5>(sizes);
  const auto usable = near_unit_boxes(uu, ww, a.hx, a.hy, b.hx, b.hy, abs(gap));
  const auto decided = greater_where(usable, abs(gap), error);
  return DecidedVerdict<decltype(decided)>{greater_where(decided, V(0.0f), gap), decided};
}

}  // namespace filter
}  // namespace vesica
