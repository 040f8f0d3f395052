// SPDX-License-Identifier: Apache-2.0
/// Shared by the lane_pairs.hpp of depth and boundary_distance: the sizes of a pair that batches run in lanes.
#pragma once

#include <vesica/support_minimum/box_ellipse.hpp>

namespace vesica::detail::support_minimum {

/// Below this share of the sizes a depth or a distance may be 0, or its direction is of few digits.
inline constexpr double least_settled = 0x1p-46;

/// A circle is answered as an ellipse, one by one and in lanes.
VESICA_INLINE Ellipse<double> as_ellipse(const Circle<double>& c) noexcept { return {c.cx, c.cy, 1, 0, c.r, c.r}; }

template <class V>
VESICA_INLINE Ellipse<V> choose(MaskOf<V> m, const Ellipse<V>& yes, const Ellipse<V>& no) noexcept {
  return {select(m, yes.cx, no.cx), select(m, yes.cy, no.cy), select(m, yes.ux, no.ux),
          select(m, yes.uy, no.uy), select(m, yes.a, no.a),   select(m, yes.b, no.b)};
}

}  // namespace vesica::detail::support_minimum
