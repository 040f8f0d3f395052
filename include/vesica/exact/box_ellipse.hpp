// SPDX-License-Identifier: Apache-2.0
/// Box against ellipse, exactly.
#pragma once

#include <vesica/exact/box_box.hpp>

namespace vesica::exact {

namespace detail {

/// A segment at distance x >= 0 from the ellipse's centre along the first axis of the frame, from `from` to `to` across
/// it: 1 when it misses the ellipse, 0 when it only touches, -1 when it meets the inside. The line cuts the ellipse in
/// a chord with centre p01 x / p00, if p00 >= x^2. Where that lies beyond an end, the end decides: inside(end, room,
/// gap) is the sign of det P room - gap^2.
template <class Inside>
constexpr int segment_gap(const Number<6>& p00, const Number<6>& p01, const Number<3>& x, const Number<3>& from,
                          const Number<3>& to, const Inside& inside) noexcept {
  const Number<6> room = p00 - square(x);
  if (room.sign < 0) return 1;
  {
    const Number<9> before = sum_of_products(p00, from, -1, p01, x);
    if (before.sign > 0) return -inside(from, room, before);
  }
  const Number<9> after = sum_of_products(p01, x, -1, p00, to);
  return after.sign > 0 ? -inside(to, room, after) : -room.sign;
}

/// A box and an ellipse in the frame of the box, in units of |u|, folded so that the ellipse's centre k lies in the
/// first quadrant. The edges visible from there are those towards +x and +y. Testing these two suffices: a common point
/// of both shapes, seen from the centre, lies behind a visible edge, so the ellipse meets that edge too. If the centre
/// lies beside the box along an axis (x or y is then 0), the tested segment runs inside the box instead, through the
/// centre's foot, so meeting it also proves overlap. The same holds for the inside of the ellipse. The regions are
/// those of D. Eberly, "Intersection of Rectangle and Ellipse" (Geometric Tools).
struct VisibleEdges {
  Number<2> c, s;
  Number<3> near_x, near_y, far_x, far_y;
  const Length &a, &b;
  int turn_x = 1, turn_y = 1;  ///< -1 where folding turned the frame's axis around
  bool centre_inside;          ///< the ellipse's centre is in the box

  constexpr VisibleEdges(const Box& box, const Ellipse& ellipse) noexcept
      : c(dot(box.ux, box.uy, ellipse.ux, ellipse.uy)),
        s(cross(box.ux, box.uy, ellipse.ux, ellipse.uy)),
        a(ellipse.a),
        b(ellipse.b) {
    const Length dx = ellipse.cx - box.cx, dy = ellipse.cy - box.cy;
    const auto uu = dot(box.ux, box.uy, box.ux, box.uy);
    auto kx = dot(box.ux, box.uy, dx, dy), ky = cross(box.ux, box.uy, dx, dy);
    s.sign *= kx.sign * ky.sign < 0 ? -1 : 1;
    // On an axis of the frame both are turned, as s keeps its sign.
    turn_x = kx.sign < 0 || (kx.sign == 0 && ky.sign < 0) ? -1 : 1;
    turn_y = ky.sign < 0 || (ky.sign == 0 && kx.sign < 0) ? -1 : 1;
    kx.sign *= kx.sign;
    ky.sign *= ky.sign;
    const auto ex = box.hx * uu, ey = box.hy * uu;
    near_x = kx - ex;
    near_y = ky - ey;
    far_x = kx + ex;
    far_y = ky + ey;
    centre_inside = near_x.sign <= 0 && near_y.sign <= 0;
  }

  /// The lesser gap of the two edges, or the gap of the first if it is at most `enough`. In the frame the ellipse is
  /// { z : z . P^-1 z <= 1 } with P = a^2 (c, s)(c, s)^T + b^2 (-s, c) (-s, c)^T.
  VESICA_CALLED constexpr int gap(int enough) const noexcept {
    const auto aa = square(a), bb = square(b);
    const auto cc = square(c), ss = square(s);
    const Number<12> det = square(a * b * (cc + ss));
    const Number<6> p01 = (aa - bb) * (c * s);
    const Number<3> none;
    const Number<3>&x = near_x.sign < 0 ? none : near_x, &y = near_y.sign < 0 ? none : near_y;
    // Both edges have the near corner: its sign is computed once.
    constexpr int unknown = 2;
    const bool has_near_corner = near_x.sign >= 0 && near_y.sign >= 0;
    int near_corner = unknown;
    const auto at_x = [&](const Number<3>& end, const Number<6>& room, const Number<9>& beside) {
      const int inside = compare_product_with_square(det, room, beside);
      if (has_near_corner && &end == &near_y) near_corner = inside;
      return inside;
    };
    const int gap_x = segment_gap(sum_of_products(aa, cc, 1, bb, ss), p01, x, near_y, far_y, at_x);
    if (gap_x <= enough) return gap_x;
    const auto at_y = [&](const Number<3>& end, const Number<6>& room, const Number<9>& beside) {
      if (&end == &near_x && near_corner != unknown) return near_corner;
      return compare_product_with_square(det, room, beside);
    };
    const int gap_y = segment_gap(sum_of_products(aa, ss, 1, bb, cc), p01, y, near_x, far_x, at_y);
    return gap_x < gap_y ? gap_x : gap_y;
  }
};

/// contact(), or a contact that counts already.
VESICA_CALLED constexpr int contact(const Box& box, const Ellipse& ellipse, Common common) noexcept {
  const VisibleEdges edges(box, ellipse);
  return edges.centre_inside ? -1 : edges.gap(static_cast<int>(common));
}

}  // namespace detail

/// -1 when the inside of an ellipse that is not degenerate meets the box, 0 when only its outline does, 1 when they are
/// disjoint. The inside of the ellipse is open, so if it meets the box, it also meets the box's relative inside.
constexpr int contact(const Box& box, const Ellipse& ellipse) noexcept {
  return detail::contact(box, ellipse, Common::insides);
}

/// contact() of a box and any ellipse, or a contact that counts already.
VESICA_CALLED constexpr int contact(const Box& box, const Ellipse& ellipse, Common common) noexcept {
  return degenerate(ellipse) ? contact(box, as_box(ellipse)) : detail::contact(box, ellipse, common);
}

/// True if a box and an ellipse share a point.
constexpr bool overlap(const Box& box, const Ellipse& ellipse) noexcept {
  return contact(box, ellipse, Common::any) <= 0;
}

/// How far a box stays within an ellipse that is not degenerate: 1 clear of the outline, 0 up to it, -1 not within.
/// Seen from the ellipse's centre in a frame in which the ellipse is a disc, all corners must be inside. Degree 8.
constexpr int clearance(const Box& box, const Ellipse& ellipse) noexcept {
  const auto& [cx, cy, vx, vy, a, b] = ellipse;
  const Length dx = box.cx - cx, dy = box.cy - cy;
  const auto c = dot(vx, vy, box.ux, box.uy), s = cross(vx, vy, box.ux, box.uy);
  const Number<4> radius = a * b * dot(vx, vy, vx, vy);
  const Number<3> centre_x = b * dot(vx, vy, dx, dy), centre_y = a * cross(vx, vy, dx, dy);
  const Number<4> along_x = box.hx * (b * c), along_y = box.hx * (a * s);
  const Number<4> across_x = -(box.hy * (b * s)), across_y = box.hy * (a * c);
  int least = 1;
  for (int i = box.hx.sign == 0 ? 1 : -1; i <= 1; i += 2) {
    for (int j = box.hy.sign == 0 ? 1 : -1; j <= 1; j += 2) {
      const Number<4> x = detail::add(detail::add(centre_x, along_x, i), across_x, j);
      const Number<4> y = detail::add(detail::add(centre_y, along_y, i), across_y, j);
      const int corner = side_of_rim(x, y, radius);
      if (corner < 0) return -1;
      least = corner < least ? corner : least;
    }
  }
  return least;
}

/// How far an ellipse that is not degenerate stays within a box. Its half extent along an axis is a square root:
/// squared once. Degree 6.
constexpr int clearance(const Ellipse& ellipse, const Box& box) noexcept {
  if (box.hx.sign == 0 || box.hy.sign == 0) return -1;
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
