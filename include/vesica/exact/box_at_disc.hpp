// SPDX-License-Identifier: Apache-2.0
/// Box against ellipse, exactly, where exponents are so unlike that numbers have many limbs.
///
/// The ellipse has the centre K, the axis V and the half lengths a and b. In a frame in which K + z is at (b V.z, a V x
/// z) it is a disc about the origin, of radius a b V.V. Where the box's corners and edges are there is formed exactly,
/// by few products of short numbers, and that is all that cancels unless outlines all but touch. So leading digits tell
/// nearly all signs that are asked for, of degree 8 at most.
#pragma once

#include <vesica/exact/box_box.hpp>

namespace vesica::exact::detail {

class BoxAtDisc {
 public:
  constexpr BoxAtDisc(const Box& box, const Ellipse& ellipse) noexcept : box_(box) {
    const auto& [cx, cy, vx, vy, a, b] = ellipse;
    const Length dx = box.cx - cx, dy = box.cy - cy;
    const auto c = dot(vx, vy, box.ux, box.uy), s = cross(vx, vy, box.ux, box.uy);
    radius_ = a * b * dot(vx, vy, vx, vy);
    centre_ = {b * dot(vx, vy, dx, dy), a * cross(vx, vy, dx, dy)};
    along_ = {b * c, a * s};
    across_ = {integer(-1) * (b * s), a * c};
    half_along_ = {box.hx * along_.x, box.hx * along_.y};
    half_across_ = {box.hy * across_.x, box.hy * across_.y};
    side_x_ = dot(box.ux, box.uy, dx, dy).sign > 0 ? -1 : 1;
    side_y_ = cross(box.ux, box.uy, dx, dy).sign > 0 ? -1 : 1;
  }

  /// The lesser gap of the edges that K lies beyond, by near_x along the box's axis and near_y across it, in units of
  /// |u|, one of them above 0: 1 where all miss the disc, 0 where one only touches, -1 where one meets the inside. What
  /// the box has in common with the disc, or its inside, K sees behind such an edge; so the edge has it too.
  constexpr int gap(const Number<3>& near_x, const Number<3>& near_y) const noexcept {
    const Corner corner = at(side_x_, side_y_);
    const int gap_y = near_y.sign > 0 ? edge_gap(corner, at(-side_x_, side_y_), along_, -side_x_, near_y) : 1;
    // The edge across a flat box is an end of the one along it.
    const bool is_known = gap_y < 0 || near_x.sign <= 0 || (near_y.sign > 0 && box_.hy.sign == 0);
    if (is_known) return gap_y;
    const int gap_x = edge_gap(corner, at(side_x_, -side_y_), across_, -side_y_, near_x);
    return gap_x < gap_y ? gap_x : gap_y;
  }

  /// The least room of a corner.
  constexpr int clearance() const noexcept {
    int least = 1;
    for (int x = box_.hx.sign == 0 ? 1 : -1; x <= 1; x += 2) {
      for (int y = box_.hy.sign == 0 ? 1 : -1; y <= 1; y += 2) {
        const int corner = room(at(x, y));
        if (corner < 0) return -1;
        least = corner < least ? corner : least;
      }
    }
    return least;
  }

 private:
  template <int Degree>
  struct Place {
    Number<Degree> x, y;
  };
  using Corner = Place<4>;

  /// Where the corner on these sides is, 1 or -1 each.
  constexpr Corner at(int side_x, int side_y) const noexcept {
    return {add(add(centre_.x, half_along_.x, side_x), half_across_.x, side_y),
            add(add(centre_.y, half_along_.y, side_x), half_across_.y, side_y)};
  }

  /// 1 inside the disc, 0 on its outline, -1 outside.
  constexpr int room(const Corner& p) const noexcept { return side_of_rim(p.x, p.y, radius_); }

  /// Of the edge from one corner to another, in the direction `way` times `sign`. Its line is r beyond / |way| from the
  /// origin.
  constexpr int edge_gap(const Corner& from, const Corner& to, const Place<3>& way, int sign,
                         const Number<3>& beyond) const noexcept {
    const auto room_beside = [](const auto& x, const auto& y, const auto& distance) {
      return square(x) + square(y) - square(distance);
    };
    const auto going_on = [](const auto& x, const auto& y, const auto& way_x, const auto& way_y) {
      return x * way_x + y * way_y;
    };
    const int beside = sign_of(room_beside, way.x, way.y, beyond);
    if (beside < 0) return 1;
    if (sign * sign_of(going_on, from.x, from.y, way.x, way.y) >= 0) return -room(from);
    if (sign * sign_of(going_on, to.x, to.y, way.x, way.y) <= 0) return -room(to);
    return -beside;
  }

  const Box& box_;
  Number<4> radius_;
  Place<3> centre_, along_, across_;  ///< across: the axis turned by a quarter
  Place<4> half_along_, half_across_;
  int side_x_, side_y_;  ///< on which sides of the box K lies, 1 or -1
};

}  // namespace vesica::exact::detail
