// SPDX-License-Identifier: Apache-2.0
/// The distance between the outlines of two shapes of any form, one strictly inside the other.
#pragma once

#include <vesica/support_minimum/frame.hpp>

namespace vesica::detail::boundary_distance {

using namespace support_minimum;

/// In units of 2^exponent: the distance, and the closest points as seen from the centres of their shapes.
struct Nested {
  FastDoubleDouble<double> distance;
  PlaneVector outer, inner;
  int exponent;
};

/// The point of a box's outline closest to a point inside, given the face's normal; in the box's frame.
inline PlaneVector foot_on_face(const CentredShape& box, const PlaneVector& n, const PlaneVector& p) noexcept {
  const double x = lane::min(lane::max(p.x, -box.a), box.a), y = lane::min(lane::max(p.y, -box.b), box.b);
  if (lane::abs(n.x) > lane::abs(n.y)) return {n.x < 0 ? -box.a : box.a, y};
  return {x, n.y < 0 ? -box.b : box.b};
}

/// The angle of the last Newton step at a minimum. A direction has a limited number of digits, and where an outline is
/// nearly straight a change of the last digit moves the furthest point far; this angle moves the point without rounding
/// the direction. It is 0 where a point moved so far along its tangent would leave its outline by more than rounding,
/// and at a box's face, where the slope jumps.
inline double last_turn(const Objective& objective, const Sample& at) noexcept {
  const double k = at.radius1 - at.radius2 - at.value;
  if (!objective.first.curved || !(k > 0)) return 0;
  const double turn = -at.slope / k, radius = lane::max(at.radius1, at.radius2);
  return radius * (turn * turn) < 0x1p-54 && radius * lane::abs(turn) < 0x1p-20 ? turn : 0;
}

/// The least over all n of h_outer(n) - h_inner(n) - n.D: how far the inner shape stays behind the outer one. At the
/// minimum F' = 0, so the furthest points of both shapes along n lie on one line along n. Where n is the normal of a
/// box's face, the outer point is the foot of the inner one on that face.
inline Nested nested_distance(const Form& outer, const Form& inner) noexcept {
  const PlacedPair pair = place(outer, inner);
  const Frame frame(pair);
  const Objective objective = frame.objective(-1);
  const Minimum least = minimise(objective);
  const Sample& at = least.at;
  const double turn = last_turn(objective, at);
  const PlaneVector along = turn * perp(at.n);
  // In a box any corner of a side along the face will do.
  const bool tied = objective.first.curved && !objective.second.curved;
  const PlaneVector q = furthest(objective.second, tied ? least.towards : at.n) + at.radius2 * along;
  const PlaneVector p = objective.first.curved ? furthest(objective.first, at.n) + at.radius1 * along
                                               : foot_on_face(objective.first, at.n, frame.offset() + q);
  const FastDoubleDouble<double> distance = frame.value(at.n, -1) + FastDoubleDouble<double>(0.5 * at.slope * turn);
  return {distance, frame.world(p), frame.world(q), pair.exponent};
}

}  // namespace vesica::detail::boundary_distance
