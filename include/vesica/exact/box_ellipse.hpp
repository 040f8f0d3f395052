// SPDX-License-Identifier: Apache-2.0
/// Box against ellipse, exactly.
#pragma once

#include <vesica/exact/box_box.hpp>

namespace vesica::exact {

namespace detail {

/// A segment at distance x from the ellipse's centre along the first axis of the frame, centred at distance y across
/// it and of half length e, against the ellipse { z : z . P^-1 z <= 1 }: 1 when it misses, 0 when it only touches, -1
/// when it meets the inside. The line cuts the ellipse in the chord with centre p01 x / p00 and half length
/// sqrt(det (p00 - x^2)) / p00.
template <int P, int X, int Y, int E, int D>
int segment_gap(const Number<P>& p00, const Number<P>& p01, const Number<D>& det, const Number<X>& x,
                const Number<Y>& y, const Number<E>& e) noexcept {
  const auto gap = abs(p00 * y - p01 * x) - p00 * e;
  const auto room = p00 - square(x);
  if (room.sign < 0) return 1;
  if (gap.sign <= 0) return -room.sign;
  return -compare_product_with_square(det, room, gap);
}

/// A box and an ellipse in the frame of the box, in units of |u|, folded so that the ellipse's centre k lies in the
/// first quadrant. The edges visible from there are those towards +x and +y. Testing these two suffices: a common point
/// of both shapes, seen from the centre, lies behind a visible edge, so the ellipse meets that edge too. If the centre
/// lies beside the box along an axis (x or y is then 0), the tested segment runs inside the box instead, through the
/// centre's foot, so meeting it also proves overlap. The same holds for the inside of the ellipse. Degree 18. The
/// regions are those of D. Eberly, "Intersection of Rectangle and Ellipse" (Geometric Tools).
struct VisibleEdges {
  Number<6> p00, p01, p11;
  Number<12> det;
  Number<3> x, y, kx, ky, ex, ey;
  bool centre_inside;  ///< the ellipse's centre is in the box, and nothing but ex, ey, kx, ky is set

  VisibleEdges(const Box& box, const Ellipse& ellipse) noexcept {
    const Length dx = ellipse.cx - box.cx, dy = ellipse.cy - box.cy;
    const auto uu = dot(box.ux, box.uy, box.ux, box.uy);
    kx = dot(box.ux, box.uy, dx, dy);
    ky = cross(box.ux, box.uy, dx, dy);
    const int fold = kx.sign * ky.sign < 0 ? -1 : 1;
    kx.sign *= kx.sign;
    ky.sign *= ky.sign;
    ex = box.hx * uu;
    ey = box.hy * uu;
    x = kx - ex;
    y = ky - ey;
    centre_inside = x.sign <= 0 && y.sign <= 0;
    if (centre_inside) return;
    if (x.sign < 0) x = {};
    if (y.sign < 0) y = {};

    const auto c = dot(box.ux, box.uy, ellipse.ux, ellipse.uy);
    const auto s = cross(box.ux, box.uy, ellipse.ux, ellipse.uy);
    const auto aa = square(ellipse.a), bb = square(ellipse.b);
    const auto cc = square(c), ss = square(s);
    p00 = aa * cc + bb * ss;
    p11 = aa * ss + bb * cc;
    p01 = (aa - bb) * (c * s);
    p01.sign *= fold;
    det = square((ellipse.a * ellipse.b) * (cc + ss));
  }
  int gap_x() const noexcept { return segment_gap(p00, p01, det, x, ky, ey); }
  int gap_y() const noexcept { return segment_gap(p11, p01, det, y, kx, ex); }
};

}  // namespace detail

/// Whether a box and an ellipse share a point.
inline bool overlap(const Box& box, const Ellipse& ellipse) noexcept {
  if (degenerate(ellipse)) return overlap(box, as_box(ellipse));
  const detail::VisibleEdges edges(box, ellipse);
  return edges.centre_inside || edges.gap_x() <= 0 || edges.gap_y() <= 0;
}

/// -1 when the inside of an ellipse that is not degenerate meets the box, 0 when only its outline does, 1 when they are
/// disjoint. The inside of the ellipse is open, so if it meets the box, it also meets the box's relative inside.
inline int contact(const Box& box, const Ellipse& ellipse) noexcept {
  const detail::VisibleEdges edges(box, ellipse);
  if (edges.centre_inside) return -1;
  const int gap_x = edges.gap_x();
  if (gap_x < 0) return -1;
  const int gap_y = edges.gap_y();
  return gap_x < gap_y ? gap_x : gap_y;
}

/// How far a box stays within an ellipse that is not degenerate: 1 clear of the outline, 0 up to it, -1 not within.
/// With m, g and h the offset of centres and the half edges in the frame in which the ellipse is the disc of radius a b
/// V about the origin, the corners are m +- (g + h) and m +- (g - h). Degree 8.
inline int clearance(const Box& box, const Ellipse& ellipse) noexcept {
  const Length dx = box.cx - ellipse.cx, dy = box.cy - ellipse.cy;
  const auto& [cx, cy, vx, vy, a, b] = ellipse;
  const auto m0 = b * dot(vx, vy, dx, dy), m1 = a * cross(vx, vy, dx, dy);
  const auto c = dot(vx, vy, box.ux, box.uy), s = cross(vx, vy, box.ux, box.uy);
  const auto g0 = b * (box.hx * c), g1 = a * (box.hx * s), h0 = b * (box.hy * s), h1 = a * (box.hy * c);
  const auto radius = square(a * b * dot(vx, vy, vx, vy));
  int least = 1;
  for (int side = -1; side <= 1; side += 2) {
    // The further of m + e and m - e is at |m|^2 + 2 |m . e| + |e|^2.
    const auto e0 = side > 0 ? g0 - h0 : g0 + h0, e1 = side > 0 ? g1 + h1 : g1 - h1;
    const auto reach = square(m0) + square(m1) + integer(2) * abs(m0 * e0 + m1 * e1) + square(e0) + square(e1);
    const int sign = compare(radius, reach);
    if (sign < least) least = sign;
  }
  return least;
}

/// How far an ellipse that is not degenerate stays within a box. Its half extent along an axis is a square root:
/// squared once. Degree 6.
inline int clearance(const Ellipse& ellipse, const Box& box) noexcept {
  const Length dx = ellipse.cx - box.cx, dy = ellipse.cy - box.cy;
  const auto uu = dot(box.ux, box.uy, box.ux, box.uy);
  const auto room_x = box.hx * uu - abs(dot(box.ux, box.uy, dx, dy));
  const auto room_y = box.hy * uu - abs(cross(box.ux, box.uy, dx, dy));
  if (room_x.sign <= 0 || room_y.sign <= 0) return -1;
  const auto c = dot(box.ux, box.uy, ellipse.ux, ellipse.uy);
  const auto s = cross(box.ux, box.uy, ellipse.ux, ellipse.uy);
  const int along = compare(square(room_x), square(ellipse.a * c) + square(ellipse.b * s));
  if (along < 0) return -1;
  const int across = compare(square(room_y), square(ellipse.a * s) + square(ellipse.b * c));
  return along < across ? along : across;
}

}  // namespace vesica::exact
