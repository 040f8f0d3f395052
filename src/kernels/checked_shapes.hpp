// SPDX-License-Identifier: Apache-2.0
// The checks behind checked kernels: once for the columns of a block, and once a row for the shape that meets them.
// Pairs then need no validity check, and values that depend on one shape alone are computed once a block.
#pragma once

#include <vesica/filter/estimate.hpp>

#include "kernels/guard.hpp"
#include "kernels/unit_axes.hpp"
#include "kernels/unit_contact_cubic.hpp"

namespace vesica::filter {

/// An ellipse as rectangles are asked about it: half the trace of its matrix, and the rest of that matrix by the double
/// angle of its axis, all over r = a b. In a frame at angle t the squared half extents are r (mean + swing) and
/// r (mean - swing), swing being swing_cos cos 2t + swing_sin sin 2t.
template <class V>
struct PreparedEllipse {
  V cx, cy, mean, swing_cos, swing_sin, r;
};

/// Relative to r: mean errs by 4u, swing_cos by 10u, swing_sin by 8u.
template <class V>
VESICA_INLINE PreparedEllipse<V> prepared(const Ellipse<V>& e) noexcept {
  const V r = e.a * e.b, swing = ((e.a - e.b) * (e.a + e.b)) / r, half(0.5f);
  return {e.cx,
          e.cy,
          (half * (e.a * e.a + e.b * e.b)) / r,
          (half * swing) * ((e.ux - e.uy) * (e.ux + e.uy)),
          swing * (e.ux * e.uy),
          r};
}

/// Coordinates and sizes of which nothing that is computed overflows: at most the square of an offset times that of a
/// half length, which is below 2^10.
template <class V>
VESICA_INLINE auto below_2_32(V x) noexcept {
  return abs(x) < guard_power<V, 32>();
}
template <class V>
VESICA_INLINE auto in_size(V x) noexcept {
  return both(x >= V(0.0f), below_2_32(x));
}

template <class V>
VESICA_INLINE auto checked(const Rect<V>& r) noexcept {
  Guard<V> guard;
  require_unit_axes(guard, r);
  return both(guard.holds(), both(both(below_2_32(r.cx), below_2_32(r.cy)), both(in_size(r.hx), in_size(r.hy))));
}
template <class V>
VESICA_INLINE auto checked(const Ellipse<V>& e) noexcept {
  Guard<V> guard;
  require_unit_axes(guard, e);
  require_moderate(guard, e);
  return both(guard.holds(), both(below_2_32(e.cx), below_2_32(e.cy)));
}

/// What error bounds of a block depend on: for rectangles the greatest sum of half sizes, for ellipses the smallest sum
/// of half lengths.
template <class V>
VESICA_INLINE V extent(const Rect<V>& r) noexcept {
  return r.hx + r.hy;
}
template <class V>
VESICA_INLINE V extent(const Ellipse<V>& e) noexcept {
  return e.a + e.b;
}

}  // namespace vesica::filter
