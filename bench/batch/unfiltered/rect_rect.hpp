// SPDX-License-Identifier: Apache-2.0
/// Rectangles by separating axes, for axes taken to be of unit length: 28 operations and 4 comparisons, no error bound.
#pragma once

#include <vesica/shapes.hpp>

namespace vesica::unfiltered {

/// The centre difference comes first: projecting the centres and subtracting would lose the answer far from the
/// origin. The two axes' |cosine| and |sine| serve all four tests.
template <class V>
VESICA_INLINE auto overlap(const Rect<V>& a, const Rect<V>& b) noexcept {
  const V dx = b.cx - a.cx, dy = b.cy - a.cy;
  const V c = abs(a.ux * b.ux + a.uy * b.uy), s = abs(a.ux * b.uy - a.uy * b.ux);
  const auto along_a = both(abs(a.ux * dx + a.uy * dy) <= a.hx + b.hx * c + b.hy * s,
                            abs(a.ux * dy - a.uy * dx) <= a.hy + b.hx * s + b.hy * c);
  const auto along_b = both(abs(b.ux * dx + b.uy * dy) <= b.hx + a.hx * c + a.hy * s,
                            abs(b.ux * dy - b.uy * dx) <= b.hy + a.hx * s + a.hy * c);
  return both(along_a, along_b);
}

}  // namespace vesica::unfiltered
