// SPDX-License-Identifier: Apache-2.0
/// How far a direction separates the shapes at a time, and whether it does so all the while between two times.
///
/// Let n be a unit vector that turns at a rate r, S(t) = n.(D + t v) - h_a - h_b, with h the support functions along n
/// about the own centres. Where S(t) > 0 there is no contact at t. S is the least of functions f whose second
/// derivative is at most some K: so between two times, L apart, with S = s0 and s1, no f gets lower than
///
///     (1 - x) s0 + x s1 - K L^2 x (1 - x) / 2,   x from 0 to 1
///
/// which stays above 0 if K L^2 / 2 < (sqrt(s0) + sqrt(s1))^2. Nothing is asked about what S does in between.
///
/// K: a shape that turns by w adds (w - r)^2 bend (scene.hpp). The second derivative of n.(D + t v) is 2 r perp(n).v -
/// r^2 n.(D + t v): at most 2 |r v|, and r^2 times how far n.(D + t v) can get below 0 within L, which it hardly does.
/// r is 0, or the radius of the shape that has n as a face's normal.
#pragma once

#include <vesica/impact_time/scene.hpp>

namespace vesica::detail::impact_time {

/// Half the width along n, and how fast it changes as the shape turns by one radian a unit of time.
struct Support {
  double h, rate;
};
inline Support support(const Turning& s, const PlaneVector& axis, const PlaneVector& n) noexcept {
  const double along = dot(axis, n), across = cross(axis, n), p = s.hx * along, q = s.hy * across;
  if (!s.round) {
    const double change_p = lane::flip_sign(s.hx * across, along), change_q = lane::flip_sign(s.hy * along, across);
    return {lane::abs(p) + lane::abs(q) + s.radius, change_p - change_q};
  }
  const double h = lane::sqrt(p * p + q * q);
  return {h, h > 0 ? (s.hx * across) * (p / h) - (s.hy * along) * (q / h) : 0};
}

/// The shape with which a direction turns.
enum class Kept { still, with_a, with_b };

/// A unit vector; of one that turns with a shape also how it lies in that one's frame.
struct Heading {
  PlaneVector n;
  Kept kept;
  PlaneVector in_frame;
};
inline PlaneVector at_pose(const Heading& h, const Pose& at) noexcept {
  if (h.kept == Kept::still) return h.n;
  return support_minimum::out_of_frame(h.kept == Kept::with_a ? at.axis_a : at.axis_b, h.in_frame);
}
inline double rate_of(const Scene& s, Kept kept) noexcept {
  return kept == Kept::still ? 0 : kept == Kept::with_a ? s.a.spin : s.b.spin;
}

/// S less its error bound, so S is at least that; the rate of S, about; and n.(D + t v).
struct Separation {
  double least, rate, along;
};
inline Separation separation(const Scene& s, const Pose& at, const PlaneVector& n, Kept kept) noexcept {
  const Support a = support(s.a, at.axis_a, n), b = support(s.b, at.axis_b, n);
  const double rate = rate_of(s, kept), along = dot(n, at.offset);
  const double change =
      (dot(n, s.v) + rate * cross(n, at.offset)) - (s.a.spin - rate) * a.rate - (s.b.spin - rate) * b.rate;
  return {((along - a.h) - b.h) - s.error, change, along};
}

/// K for two times at most `length` apart, from what the first was.
inline double curve(const Scene& s, Kept kept, double along, double length) noexcept {
  const double r = rate_of(s, kept), a = s.a.spin - r, b = s.b.spin - r;
  const double of_shapes = a * a * s.a.bend + b * b * s.b.bend;
  if (r == 0) return of_shapes * (1 + 0x1p-40);
  const double below = lane::max(length * (lane::abs(r) * s.farthest + s.speed) - along, 0);
  return (of_shapes + 2 * lane::abs(r) * s.speed + r * r * below) * (1 + 0x1p-40);
}

/// For two times `length` apart, with S at least s0.least and s1 there.
inline bool is_clear_between(const Scene& s, Kept kept, const Separation& s0, double s1, double length) noexcept {
  if (!(s0.least > 0 && s1 > 0)) return false;
  const double dip = 0.5 * curve(s, kept, s0.along - s.error, length) * (length * length);
  return dip <= (1 - 0x1p-40) * ((s0.least + s1) + 2 * lane::sqrt(s0.least * s1));
}

/// A direction and how far it separates the shapes.
struct Direction {
  Heading heading;
  Separation by;
};

/// Keeps the better of two.
inline void try_direction(const Scene& s, const Pose& at, const PlaneVector& n, Direction& best) noexcept {
  const PlaneVector out = dot(n, at.offset) < 0 ? -n : n;
  const Separation by = separation(s, at, out, Kept::still);
  if (by.least > best.by.least) best = {{out, Kept::still, {}}, by};
}

inline void try_face(const Scene& s, const Pose& at, Kept kept, const PlaneVector& in_frame, Direction& best) noexcept {
  const PlaneVector n = at_pose({{}, kept, in_frame}, at);
  const bool back = dot(n, at.offset) < 0;
  const PlaneVector out = back ? -n : n;
  const Separation by = separation(s, at, out, kept);
  if (by.least > best.by.least) best = {{out, kept, back ? -in_frame : in_frame}, by};
}

/// The best face of either box. Boxes are apart iff the normal of a face separates them.
///
/// The best one does so by at least 0.7 of the distance: where vertices are closest, the direction between them lies
/// between two neighbouring normals, at most 45 degrees from one of them.
inline void try_faces(const Scene& s, const Pose& at, Direction& best) noexcept {
  for (const Kept kept : {Kept::with_a, Kept::with_b}) {
    if ((kept == Kept::with_a ? s.a : s.b).round) continue;
    try_face(s, at, kept, {1, 0}, best);
    try_face(s, at, kept, {0, 1}, best);
  }
}

/// The best face of two boxes at once.
inline Direction best_face(const Scene& s, const Pose& at) noexcept {
  const double c = lane::abs(dot(at.axis_a, at.axis_b)), k = lane::abs(cross(at.axis_a, at.axis_b));
  const PlaneVector in_a = support_minimum::into_frame(at.axis_a, at.offset);
  const PlaneVector in_b = support_minimum::into_frame(at.axis_b, at.offset);
  const double by[] = {
      lane::abs(in_a.x) - s.a.hx - (s.b.hx * c + s.b.hy * k), lane::abs(in_a.y) - s.a.hy - (s.b.hx * k + s.b.hy * c),
      lane::abs(in_b.x) - s.b.hx - (s.a.hx * c + s.a.hy * k), lane::abs(in_b.y) - s.b.hy - (s.a.hx * k + s.a.hy * c)};
  const bool second_a = by[1] > by[0], second_b = by[3] > by[2];
  const bool of_b = lane::max(by[2], by[3]) > lane::max(by[0], by[1]), second = of_b ? second_b : second_a;
  const PlaneVector& in_frame = of_b ? in_b : in_a;
  const double sign = lane::flip_sign(1, second ? in_frame.y : in_frame.x);
  const Kept kept = of_b ? Kept::with_b : Kept::with_a;
  const PlaneVector normal = second ? PlaneVector{0, sign} : PlaneVector{sign, 0};
  const PlaneVector n = at_pose({{}, kept, normal}, at);
  return {{n, kept, normal}, separation(s, at, n, kept)};
}

/// The normal of a round outline beside a point, which is given from its centre.
inline void try_outline(const Scene& s, const Pose& at, const Turning& shape, const PlaneVector& axis,
                        const PlaneVector& point, Direction& best) noexcept {
  if (!shape.round) return;
  const double x = dot(axis, point) / shape.hx, y = cross(axis, point) / shape.hy;
  const double gx = x * shape.hy, gy = y * shape.hx, length = lane::sqrt(gx * gx + gy * gy);
  if (!(length > 0)) return;
  try_direction(s, at, support_minimum::out_of_frame(axis, {gx / length, gy / length}), best);
}

}  // namespace vesica::detail::impact_time
