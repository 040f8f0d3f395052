// SPDX-License-Identifier: Apache-2.0
/// How far a direction separates the shapes at a time, and whether it does so all the while between two times.
///
/// Let n be a unit vector that is kept, and S(t) = n.(D + t v) - h_a(n; t) - h_b(n; t), h being support functions about
/// the own centres. Where S(t) > 0 there is no contact at t. S is the least of functions whose second derivative is at
/// most K, the scene's curve: so between two times, L apart, with S = s0 and s1, no such function gets lower than
///
///     (1 - x) s0 + x s1 - K L^2 x (1 - x) / 2,   x from 0 to 1
///
/// which stays above 0 if K L^2 / 2 < (sqrt(s0) + sqrt(s1))^2. Nothing is asked about what S does in between.
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
    return {lane::abs(p) + lane::abs(q), change_p - change_q};
  }
  const double h = lane::sqrt(p * p + q * q);
  return {h, h > 0 ? (s.hx * across) * (p / h) - (s.hy * along) * (q / h) : 0};
}

/// S less its error bound, so S is at least that; and the rate of S, about.
struct Separation {
  double least, rate;
};
inline Separation separation(const Scene& s, const Pose& at, const PlaneVector& n) noexcept {
  const Support a = support(s.a, at.axis_a, n), b = support(s.b, at.axis_b, n);
  return {((dot(n, at.offset) - a.h) - b.h) - s.error, (dot(n, s.v) - s.a.spin * a.rate) - s.b.spin * b.rate};
}

/// For two times L apart.
inline bool is_clear_between(const Scene& s, double s0, double s1, double length) noexcept {
  if (!(s0 > 0 && s1 > 0)) return false;
  const double dip = 0.5 * s.curve * (length * length), room = (s0 + s1) + 2 * lane::sqrt(s0 * s1);
  return dip <= (1 - 0x1p-40) * room;
}

/// n and how far it separates the shapes.
struct Direction {
  PlaneVector n;
  Separation by;
};

/// Keeps the better of two.
inline void try_direction(const Scene& s, const Pose& at, const PlaneVector& n, Direction& best) noexcept {
  const PlaneVector out = dot(n, at.offset) < 0 ? -n : n;
  const Separation by = separation(s, at, out);
  if (by.least > best.by.least) best = {out, by};
}

/// The best face of either box. Boxes are apart iff one of these separates them; and the best one does so by at least
/// 0.7 of the distance: where vertices are closest, the direction between them lies between two neighbouring normals,
/// at most 45 degrees from one of them.
inline void try_faces(const Scene& s, const Pose& at, Direction& best) noexcept {
  if (!s.a.round) {
    try_direction(s, at, at.axis_a, best);
    try_direction(s, at, perp(at.axis_a), best);
  }
  if (!s.b.round) {
    try_direction(s, at, at.axis_b, best);
    try_direction(s, at, perp(at.axis_b), best);
  }
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
