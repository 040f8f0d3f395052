// SPDX-License-Identifier: Apache-2.0
/// Box against ellipse, exactly.
#pragma once

#include <vesica/exact/box_box.hpp>

namespace vesica::exact {

namespace detail {

/// Whether the segment at distance x from the ellipse's centre along the first axis of the frame, centred at distance
/// y across it and of half length e, misses the ellipse { z : z . P^-1 z <= 1 }. The line cuts the ellipse in the
/// chord with centre p01 x / p00 and half length sqrt(det (p00 - x^2)) / p00.
template <int P, int X, int Y, int E, int D>
bool segment_misses(const Number<P>& p00, const Number<P>& p01, const Number<D>& det, const Number<X>& x,
                    const Number<Y>& y, const Number<E>& e) noexcept {
  const auto gap = abs(p00 * y - p01 * x) - p00 * e;
  const auto room = p00 - square(x);
  if (room.sign < 0) return true;
  if (gap.sign <= 0) return false;
  return compare_product_with_square(det, room, gap) < 0;
}

}  // namespace detail

/// Whether a box and an ellipse share a point. The frame of the box, in units of |u|, folded so that the ellipse's
/// centre k lies in the first quadrant; the visible edges then are those towards +x and +y. Where the centre lies
/// beside the box along an axis (x or y zero) the tested segment runs inside the box instead, through the centre's
/// foot, so that meeting it proves overlap: a point of both shapes seen from the centre lies behind a visible edge, so
/// no case is left out. Degree 18. The regions are those of D. Eberly, "Intersection of Rectangle and Ellipse"
/// (Geometric Tools).
inline bool overlap(const Box& box, const Ellipse& ellipse) noexcept {
  if (degenerate(ellipse)) return overlap(box, as_box(ellipse));
  const Length dx = ellipse.cx - box.cx, dy = ellipse.cy - box.cy;
  const auto uu = dot(box.ux, box.uy, box.ux, box.uy);
  const auto kx = dot(box.ux, box.uy, dx, dy), ky = cross(box.ux, box.uy, dx, dy);
  const auto ex = box.hx * uu, ey = box.hy * uu;
  auto x = abs(kx) - ex, y = abs(ky) - ey;
  if (x.sign <= 0 && y.sign <= 0) return true;
  if (x.sign < 0) x = {};
  if (y.sign < 0) y = {};

  const auto c = dot(box.ux, box.uy, ellipse.ux, ellipse.uy);
  const auto s = cross(box.ux, box.uy, ellipse.ux, ellipse.uy);
  const auto aa = square(ellipse.a), bb = square(ellipse.b);
  const auto cc = square(c), ss = square(s);
  const auto p00 = aa * cc + bb * ss, p11 = aa * ss + bb * cc;
  auto p01 = (aa - bb) * (c * s);
  p01.sign *= kx.sign * ky.sign < 0 ? -1 : 1;
  const auto det = square((ellipse.a * ellipse.b) * (cc + ss));
  return !(detail::segment_misses(p00, p01, det, x, abs(ky), ey) &&
           detail::segment_misses(p11, p01, det, y, abs(kx), ex));
}

}  // namespace vesica::exact
