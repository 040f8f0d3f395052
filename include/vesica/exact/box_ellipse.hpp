// SPDX-License-Identifier: Apache-2.0
/// Box against ellipse, exactly.
#pragma once

#include <type_traits>
#include <vesica/exact/box_box.hpp>

namespace vesica::exact {

namespace detail {

/// A segment at distance x from the ellipse's centre along the first axis of the frame, from `from` to `to` across it,
/// against the ellipse { z : z . P^-1 z <= 1 }: 1 when it misses, 0 when it only touches, -1 when it meets the inside.
/// The line cuts the ellipse in the chord with centre p01 x / p00 and half length sqrt(det (p00 - x^2)) / p00. The gap
/// is how far the chord's centre lies beyond the nearer end.
template <class P, class D, class X, class Y>
int segment_gap(const P& p00, const P& p01, const D& det, const X& x, const Y& from, const Y& to, Signs& sign) noexcept {
  const auto room = p00 - square(x);
  const int room_sign = sign.of(room);
  if (room_sign < 0) return 1;
  const auto centre = p01 * x;
  auto gap = p00 * from - centre;
  if (sign.of(gap) <= 0) gap = centre - p00 * to;
  if (sign.of(gap) <= 0) return -room_sign;
  return -sign.of_product_less_square(det, room, gap);
}

/// A box and an ellipse in the frame of the box, in units of |u|, folded so that the ellipse's centre k lies in the
/// first quadrant. The edges visible from there are those towards +x and +y. Testing these two suffices: a common point
/// of both shapes, seen from the centre, lies behind a visible edge, so the ellipse meets that edge too. If the centre
/// lies beside the box along an axis (x or y is then 0), the tested segment runs inside the box instead, through the
/// centre's foot, so meeting it also proves overlap. The same holds for the inside of the ellipse. Degree 18. The
/// regions are those of D. Eberly, "Intersection of Rectangle and Ellipse" (Geometric Tools).
struct VisibleEdges {
  Number<2> c, s;
  Number<3> near_x, near_y, far_x, far_y;
  const Length &a, &b;
  int fold;
  bool centre_inside;  ///< the ellipse's centre is in the box

  VisibleEdges(const Box& box, const Ellipse& ellipse) noexcept
      : c(dot(box.ux, box.uy, ellipse.ux, ellipse.uy)),
        s(cross(box.ux, box.uy, ellipse.ux, ellipse.uy)),
        a(ellipse.a),
        b(ellipse.b) {
    const Length dx = ellipse.cx - box.cx, dy = ellipse.cy - box.cy;
    const auto uu = dot(box.ux, box.uy, box.ux, box.uy);
    auto kx = dot(box.ux, box.uy, dx, dy), ky = cross(box.ux, box.uy, dx, dy);
    fold = kx.sign * ky.sign < 0 ? -1 : 1;
    kx.sign *= kx.sign;
    ky.sign *= ky.sign;
    const auto ex = box.hx * uu, ey = box.hy * uu;
    near_x = kx - ex;
    near_y = ky - ey;
    far_x = kx + ex;
    far_y = ky + ey;
    centre_inside = near_x.sign <= 0 && near_y.sign <= 0;
  }
  /// The lesser gap of the two edges; that of the first if it is at most `enough`. Sizes are a and b.
  int gap(int enough) const noexcept {
    const auto least_gap = [this, enough](Signs& sign, const auto& cosine, const auto& sine, const auto& size_0,
                                          const auto& size_1, const auto& x0, const auto& x1, const auto& y0,
                                          const auto& y1) {
      using Place = std::decay_t<decltype(x0)>;
      const auto aa = square(size_0), bb = square(size_1), cc = square(cosine), ss = square(sine);
      const auto p00 = aa * cc + bb * ss, p11 = aa * ss + bb * cc;
      auto p01 = (aa - bb) * (cosine * sine);
      p01.sign *= fold;
      const auto det = square((size_0 * size_1) * (cc + ss));
      const int gap_x = segment_gap(p00, p01, det, x0.sign < 0 ? Place() : x0, y0, y1, sign);
      if (gap_x <= enough) return gap_x;
      const int gap_y = segment_gap(p11, p01, det, y0.sign < 0 ? Place() : y0, x0, x1, sign);
      return gap_x < gap_y ? gap_x : gap_y;
    };
    return decide(least_gap, c, s, a, b, near_x, far_x, near_y, far_y);
  }
};

}  // namespace detail

/// Whether a box and an ellipse share a point.
inline bool overlap(const Box& box, const Ellipse& ellipse) noexcept {
  if (degenerate(ellipse)) return overlap(box, as_box(ellipse));
  const detail::VisibleEdges edges(box, ellipse);
  return edges.centre_inside || edges.gap(0) <= 0;
}

/// -1 when the inside of an ellipse that is not degenerate meets the box, 0 when only its outline does, 1 when they are
/// disjoint. The inside of the ellipse is open, so if it meets the box, it also meets the box's relative inside.
inline int contact(const Box& box, const Ellipse& ellipse) noexcept {
  const detail::VisibleEdges edges(box, ellipse);
  return edges.centre_inside ? -1 : edges.gap(-1);
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
