// SPDX-License-Identifier: Apache-2.0
/// The point at which two shapes touch, given the normal.
#pragma once

#include <vesica/cast/bound.hpp>
#include <vesica/support_minimum/placed_pair.hpp>

namespace vesica::detail::cast {

template <class V>
using OffsetOf = support_minimum::PlaneVectorOf<V>;
using Offset = OffsetOf<double>;

/// The part of a shape farthest along a normal: a point, or an edge by its middle and half of it.
struct Foremost {
  Offset middle, half;

  bool is_edge() const noexcept { return half.x != 0 || half.y != 0; }
};

/// At this angle to a face's normal and below, the times at which its ends are hit have errors that move the point by
/// 2^-54 of the scene along the face.
inline constexpr double beside_face = 0x1p-40;

/// A normal seen from a box in double: u.n and u x n, and how great they are beside a face. Above that signs are known.
struct Slopes {
  double p, q, doubt;

  bool nearly_across() const noexcept { return !(abs(p) > doubt); }
  bool nearly_along() const noexcept { return !(abs(q) > doubt); }
};
inline Slopes slopes_of(const Side& box, const Vector& normal) noexcept {
  const double ux = box.u.x.high, uy = box.u.y.high, nx = normal.x.high, ny = normal.y.high;
  return {ux * nx + uy * ny, ux * ny - uy * nx, beside_face * ((abs(ux) + abs(uy)) * (abs(nx) + abs(ny)))};
}

/// If a box is hit next to a face, use that face's normal. Both ends of the face are then hit at nearly the same time.
/// The other shape's place along the face decides which end is hit, if either.
inline Vector settled(const Side& s, const Vector& normal) noexcept {
  if (s.round || has_no_size(s)) return normal;
  const Slopes slopes = slopes_of(s, normal);
  if (slopes.nearly_across()) return slopes.q < 0 ? opposite(perpendicular(s.u)) : perpendicular(s.u);
  if (slopes.nearly_along()) return slopes.p < 0 ? opposite(s.u) : s.u;
  return normal;
}

/// From the shape's own centre.
template <class Products>
Foremost foremost(const Side& s, const Vector& normal) noexcept {
  const Offset along{s.u.x.high, s.u.y.high}, across{-s.u.y.high, s.u.x.high};
  const double a = s.hx.high, b = s.hy.high;
  if (a == 0 && b == 0) return {{0, 0}, {0, 0}};
  if (!s.round) {
    // For a box only signs matter, and double usually decides them.
    const Slopes slopes = slopes_of(s, normal);
    if (!slopes.nearly_across() && !slopes.nearly_along()) {
      return {lane::flip_sign(a, slopes.p) * along + lane::flip_sign(b, slopes.q) * across, {0, 0}};
    }
  }
  const auto u = Products::factor(s.u), n = Products::factor(normal);
  const Twofold<double> p = arithmetic::renormalised(dot(u, n)), q = arithmetic::renormalised(cross(u, n));
  if (s.round) {
    const double h = sqrt((a * p.high) * (a * p.high) + (b * q.high) * (b * q.high));
    return {(a * (a * p.high / h)) * along + (b * (b * q.high / h)) * across, {0, 0}};
  }
  Foremost out{{0, 0}, {0, 0}};
  (is_zero(p) ? out.half : out.middle) = lane::flip_sign(a, p.high) * along;
  const Offset second = lane::flip_sign(b, q.high) * across;
  Offset& to = is_zero(q) ? out.half : out.middle;
  to = {to.x + second.x, to.y + second.y};
  return out;
}

/// The point of the first shape where the second, at an offset, touches it: its vertex or the point of its round
/// outline; on an edge of it the other's vertex, or the middle of the stretch that two edges share. b counts there
/// alone.
inline Offset touching_point(const Foremost& a, const Foremost& b, const Offset& offset) noexcept {
  if (!a.is_edge()) return a.middle;
  const double length = a.half.x * a.half.x + a.half.y * a.half.y;
  if (length == 0) return a.middle;  // so short that its square underflows
  const auto share = [&](double x, double y) { return (x * a.half.x + y * a.half.y) / length; };
  const double middle = share(offset.x + b.middle.x - a.middle.x, offset.y + b.middle.y - a.middle.y);
  const double half = abs(share(b.half.x, b.half.y));
  const auto within = [](double s) { return s < -1 ? -1.0 : s > 1 ? 1.0 : s; };
  const double at = 0.5 * (within(middle - half) + within(middle + half));
  return {a.middle.x + at * a.half.x, a.middle.y + at * a.half.y};
}

/// x * 2^exponent. The unit mostly is 1.
inline double in_units(double x, int exponent) noexcept {
  return exponent == 0 ? x : arithmetic::scale_far(x, exponent);
}

/// The point at an offset, in units of 2^exponent, from a body's centre.
inline Offset located(const Body& body, const Offset& offset, int exponent) noexcept {
  return with_shape(body, [&](const auto& s) {
    const auto p = form::corners(form::of(s).place);
    return Offset{support_minimum::located_coordinate(p.x0, p.x1, in_units(offset.x, exponent)) + 0.0,
                  support_minimum::located_coordinate(p.y0, p.y1, in_units(offset.y, exponent)) + 0.0};
  });
}

}  // namespace vesica::detail::cast
