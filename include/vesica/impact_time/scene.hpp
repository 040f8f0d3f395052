// SPDX-License-Identifier: Apache-2.0
/// Two shapes that move and turn, in double at a common scale, and bounds on what rounding does to them.
///
/// At a time t from 0 to 1 a shape's centre has moved by t v, and its axis has turned by t times an angle about it.
/// Only the offset of the centres counts.
#pragma once

#include <vesica/arithmetic/rotation.hpp>
#include <vesica/cast/bound.hpp>
#include <vesica/support_minimum/plane_vector.hpp>

namespace vesica {

/// How a shape moves while t runs from 0 to 1; members as in the C struct.
template <class T>
struct Turn {
  T vx, vy;  ///< by how much its centre moves
  T angle;   ///< by how much it turns about its centre: radians, counter-clockwise where y points up
};

namespace detail::impact_time {

using cast::Body;
using support_minimum::cross;
using support_minimum::dot;
using support_minimum::perp;
using support_minimum::PlaneVector;

/// A shape at t = 0: a unit axis, half lengths along it and across. `reach`: no point is farther from the centre.
///
/// `bend`: let h be the support function along a direction that is kept, in the angle by which the shape turns. Of a
/// box h is the greatest of cosines times at most its reach, and -h'' of each is at most that. Of an ellipse h + h'' is
/// the radius of its curvature, a^2 b^2 / h^3, and -h'' is greatest where h = a, the longer half.
struct Turning {
  PlaneVector axis;
  double hx, hy, reach, bend, spin;
  bool round;
  double radius = 0;  // how much farther than these it reaches

  bool turns() const noexcept { return spin != 0; }
};

/// Lengths are in units of 2^exponent; the largest is about 1. d leads from the first centre to the second at t = 0, v
/// is what it changes by: it is never longer than `farthest`. `error` bounds what rounding does to separation().
struct Scene {
  Turning a, b;
  PlaneVector d, v;
  double error, speed, farthest;
  int exponent;
  bool still;  // they do not move relative to each other; scaled numbers may have vanished

  PlaneVector offset(double t) const noexcept { return d + t * v; }
  bool has_boxes() const noexcept { return !a.round && !b.round && a.radius == 0 && b.radius == 0; }
};

/// Half lengths are right to 6u, u = 2^-53, each component of the axis to 4u.
inline Turning turning(const nearest::ScaledShape& p, int shift, double spin) noexcept {
  Turning s{{1, 0}, 0, 0, 0, 0, spin, true};
  const bool has_core = p.box.hx.high > 0 || p.box.hy.high > 0;
  if (p.radius > 0 && !has_core) {
    s.hx = s.hy = arithmetic::scale_far(p.radius, shift);
  } else {
    const PlaneVector u{p.box.u.x.high, p.box.u.y.high};
    const double length = lane::sqrt(dot(u, u));
    s.axis = {u.x / length, u.y / length};
    s.hx = arithmetic::scale_far(p.box.hx.high * length, shift);
    s.hy = arithmetic::scale_far(p.box.hy.high * length, shift);
    s.round = p.curved;
    s.radius = arithmetic::scale_far(p.radius, shift);
  }
  s.reach = s.round ? lane::max(s.hx, s.hy) : lane::sqrt(s.hx * s.hx + s.hy * s.hy);
  const double a = lane::max(s.hx, s.hy), b = lane::min(s.hx, s.hy);
  s.bend = s.round && a > 0 ? (a - b) * ((a + b) / a) : s.reach;
  // Turning changes neither a disc nor a point.
  if (s.reach == 0 || (s.round && a == b)) s.spin = 0;
  s.reach += s.radius;
  return s;
}

inline Turning turning(const nearest::UnscaledShape& f, double spin) noexcept {
  return turning(nearest::ScaledShape{f.box, f.radius, f.curved}, 0, spin);
}

/// True if the square of the axis is as it should be.
inline bool is_moderate(const nearest::UnscaledShape& f) noexcept {
  const double size = lane::abs(f.box.u.x.high) + lane::abs(f.box.u.y.high);
  return size >= 0x1p-60 && size <= 0x1p60;
}
/// Numbers that need no other unit. What is computed in one is the same in another, times powers of two.
inline bool is_moderate(const Turning& s) noexcept {
  const double shorter = lane::min(s.hx, s.hy), longer = lane::max(s.hx, s.hy);
  return longer <= 0x1p60 && (longer == 0 || longer >= 0x1p-60) && (shorter == 0 || shorter >= 0x1p-60) &&
         s.radius <= 0x1p60 && (s.radius == 0 || s.radius >= 0x1p-60) &&
         (!s.round || shorter > nearest::thinnest * longer);
}

/// A pair that moves relative to each other by v.
inline Scene moderate_scene(const nearest::UnscaledShape& a, const nearest::UnscaledShape& b, const PlaneVector& v,
                            double spin_a, double spin_b) noexcept {
  const auto x = form::twice_offset_x(a.place, b.place, 1), y = form::twice_offset_y(a.place, b.place, 1);
  return {turning(a, spin_a), turning(b, spin_b), {0.5 * x.high, 0.5 * y.high}, v, 0, 0, 0, 0, false};
}
inline bool is_moderate(const Scene& s) noexcept {
  const auto within = [](double x) { return x == 0 || (lane::abs(x) >= 0x1p-60 && lane::abs(x) <= 0x1p60); };
  return is_moderate(s.a) && is_moderate(s.b) && within(s.d.x) && within(s.d.y) && within(s.v.x) && within(s.v.y);
}

/// The same at any exponents, times k where sums of numbers as they are would overflow.
inline Scene scaled_scene(const nearest::UnscaledShape& a, const nearest::UnscaledShape& b, const PlaneVector& v,
                          int eighths, double spin_a, double spin_b) noexcept {
  const nearest::ScaledPair p = nearest::scaled_pair(a, b);
  const int of_v = form::length_exponent(lane::max(lane::abs(v.x), lane::abs(v.y)));
  const int exponent = of_v > p.exponent ? of_v : p.exponent, shift = p.exponent - exponent;
  Scene s{turning(p.a, shift, spin_a), turning(p.b, shift, spin_b), {}, {}, 0, 0, 0, exponent + eighths, false};
  s.d = {arithmetic::scale_far(p.d.x.high, shift), arithmetic::scale_far(p.d.y.high, shift)};
  s.v = {arithmetic::scale_far(v.x, -exponent), arithmetic::scale_far(v.y, -exponent)};
  return s;
}

inline void measure(Scene& s) noexcept {
  // In units of u and of all lengths: the offset at t, 3; an axis at t, 15 and its spin, for the angle's rounding; n,
  // if it is such an axis, as much; half lengths, 6; products, sums or a root, 12. With room for n being a unit to 3
  // alone.
  const double lengths = lane::abs(s.d.x) + lane::abs(s.d.y) + lane::abs(s.v.x) + lane::abs(s.v.y) + (s.a.hx + s.a.hy) +
                         (s.b.hx + s.b.hy) + (s.a.radius + s.b.radius);
  s.error = 0x1p-53 * lengths * (56 + 2 * (lane::abs(s.a.spin) + lane::abs(s.b.spin))) + 0x1p-1000;
  s.speed = lane::sqrt(dot(s.v, s.v));
  s.farthest = lane::sqrt(dot(s.d, s.d)) + s.speed;
}

inline Scene scene(const Body& a, const Turn<double>& turn_a, const Body& b, const Turn<double>& turn_b) noexcept {
  const auto way = [&](double k) { return PlaneVector{k * turn_b.vx - k * turn_a.vx, k * turn_b.vy - k * turn_a.vy}; };
  nearest::UnscaledShape fa = cast::form_times(a, 1), fb = cast::form_times(b, 1);
  Scene s = moderate_scene(fa, fb, way(1), turn_a.angle, turn_b.angle);
  if (!is_moderate(fa) || !is_moderate(fb) || !is_moderate(s)) [[unlikely]] {
    const bool large = nearest::overflowed(fa, fb) || !all_finite(s.v.x, s.v.y);
    if (large) fa = cast::form_times(a, 0.125), fb = cast::form_times(b, 0.125);
    s = scaled_scene(fa, fb, way(large ? 0.125 : 1), large ? 3 : 0, turn_a.angle, turn_b.angle);
  }
  measure(s);
  const auto rests = [](const nearest::UnscaledShape& f, double angle) {
    return angle == 0 || (f.box.hx.high == 0 && f.box.hy.high == 0);  // a disc has no box
  };
  s.still = turn_a.vx == turn_b.vx && turn_a.vy == turn_b.vy && rests(fa, turn_a.angle) && rests(fb, turn_b.angle);
  return s;
}

/// Both shapes at a time.
struct Pose {
  PlaneVector offset, axis_a, axis_b;
};
inline PlaneVector axis_at(const Turning& s, double t) noexcept {
  if (!s.turns()) return s.axis;
  const arithmetic::Rotation r = arithmetic::rotation(s.spin * t);
  return {r.cosine * s.axis.x - r.sine * s.axis.y, r.cosine * s.axis.y + r.sine * s.axis.x};
}
inline Pose pose(const Scene& s, double t) noexcept { return {s.offset(t), axis_at(s.a, t), axis_at(s.b, t)}; }

/// A shape in its pose, about a centre, for other questions.
inline Body body_of(const Turning& s, const PlaneVector& axis, const PlaneVector& centre) noexcept {
  const Kind kind = s.round ? Kind::ellipse : s.radius > 0 ? Kind::round_rect : Kind::rect;
  return {kind, {centre.x, centre.y, axis.x, axis.y, s.hx, s.hy, s.radius}};
}

}  // namespace detail::impact_time
}  // namespace vesica
