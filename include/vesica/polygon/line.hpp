// SPDX-License-Identifier: Apache-2.0
/// The term that two edges add to the area that two polygons share; area.hpp has the sum. V is double, or lanes.
#pragma once

#include <vesica/scalar.hpp>
#include <vesica/shapes.hpp>

namespace vesica::detail::polygon {

/// An edge as a function of x, y = y0 + slope (x - x0). The sign is 1 if the edge goes to the right, or -1.
template <class V>
struct Line {
  V x0, x1, y0, slope, sign;
};

/// The part of two edges, and the width over which they add it.
template <class V>
struct Term {
  V area, width;
};

/// The integral of min(d, 0) over 0 to 1, for a linear d from p to q, is -n^2 / (2 (|p| + |q|)), n the sum of what is
/// negative of p and q. So this is -2 / e.sign times the area.
template <class V>
VESICA_INLINE Term<V> term(const Line<V>& e, const Line<V>& f) noexcept {
  using lane::abs;
  using lane::max;
  using lane::min;
  const V zero(0.0), from = max(e.x0, f.x0), to = min(e.x1, f.x1), width = max(to - from, zero);
  const V p = (e.y0 + e.slope * (from - e.x0)) - (f.y0 + f.slope * (from - f.x0));
  const V q = p + (e.slope - f.slope) * width;
  const V n = min(p, zero) + min(q, zero), all = (abs(p) + abs(q)) + V(0x1p-1000);
  return {(f.sign * width) * (n * (n / all)), width};
}

}  // namespace vesica::detail::polygon
