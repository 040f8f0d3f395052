// SPDX-License-Identifier: Apache-2.0
/// Rectangle and ellipse without square roots or divisions, for axes taken to be of unit length; no error bound.
#pragma once

#include <vesica/shapes.hpp>

namespace vesica::unfiltered {

/// In the rectangle's frame the ellipse has the matrix P and the centre (kx, ky). The segment through the rectangle at
/// its point nearest to the ellipse's centre along x is missed iff m^2 > det (p00 - x^2); likewise along y. The shapes
/// are disjoint iff both segments are missed. x and y keep the signs of kx and ky, which folding into one quadrant
/// would have to move into p01.
template <class V>
VESICA_INLINE auto overlap(const Rect<V>& rect, const Ellipse<V>& ellipse) noexcept {
  const V zero(0.0f);
  const V dx = ellipse.cx - rect.cx, dy = ellipse.cy - rect.cy;
  const V kx = rect.ux * dx + rect.uy * dy, ky = rect.ux * dy - rect.uy * dx;
  const V c = rect.ux * ellipse.ux + rect.uy * ellipse.uy, s = rect.ux * ellipse.uy - rect.uy * ellipse.ux;
  const V ac = ellipse.a * c, as = ellipse.a * s, bc = ellipse.b * c, bs = ellipse.b * s;
  const V p00 = ac * ac + bs * bs, p01 = ac * as - bc * bs, p11 = as * as + bc * bc;
  const V root = ellipse.a * ellipse.b, det = root * root;
  const V x = kx - max(min(kx, rect.hx), zero - rect.hx), y = ky - max(min(ky, rect.hy), zero - rect.hy);
  const V m = max(abs(p00 * ky - p01 * x) - p00 * rect.hy, zero);
  const V n = max(abs(p11 * kx - p01 * y) - p11 * rect.hx, zero);
  return either(m * m <= det * (p00 - x * x), n * n <= det * (p11 - y * y));
}

}  // namespace vesica::unfiltered
