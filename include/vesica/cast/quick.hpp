// SPDX-License-Identifier: Apache-2.0
/// The quick path for rays, two discs and two ellipses: ordinary cases are decided and computed by formulas for these
/// kinds alone. If anything stays uncertain, the general path answers. Both give the same bits: whether there is
/// contact and the time are certain, and points and normals are computed by the same operations.
///
/// Bounds below have u = 2^-53. Differences of coordinates are off by u of themselves. Underflow adds less than 2^-400:
/// velocities are between 2^-40 and 2^40 or so, lengths below 2^200 as in filter.hpp.
#pragma once

#include <vesica/cast/first_contact.hpp>

namespace vesica::detail::cast {

enum class Quick {
  open,  // nothing is known
  missed,
  hit,  // of a filter: apart at the start, with a contact after it, at any time
};

inline constexpr double quick_tiny = 0x1p-400;
VESICA_INLINE bool in_quick_range(double square) noexcept { return lane::both(square >= 0x1p-80, square <= 0x1p80); }
/// Of a motion, by v.v. Places at an earlier end may have more digits than exact numbers hold, which is not told here.
VESICA_INLINE bool is_quick(const Motion& v, double vv) noexcept {
  return lane::both(in_quick_range(vv), v.end >= 0x1p-300);
}

/// What is certain of a line, of the start and of the end, each a number of which the sign counts and its error.
struct Signed {
  double value, error;

  bool above() const noexcept { return value > error; }
  bool below() const noexcept { return value < -error; }
};

/// line: positive where it meets the sum; apart: positive where they are, at the start; forward: positive where b moves
/// away from a centre, or of a round shape along its gradient; early: positive where the end comes before contact.
VESICA_INLINE Quick decided(bool usable, const Signed& line, const Signed& apart, const Signed& forward,
                            const Signed& early) noexcept {
  // One of these holds of most misses, and which cannot be foreseen.
  const bool missed =
      lane::either(lane::either(line.below(), early.above()), lane::both(apart.above(), forward.above()));
  if (lane::both(usable, missed)) return Quick::missed;
  const bool hit = lane::both(lane::both(usable, line.above()), lane::both(apart.above(), forward.below()));
  return hit ? Quick::hit : Quick::open;
}

/// Of a disc of radius r about the origin, and a point at (dx, dy), with w = v x D and q = D.v.
///
/// Proved: the errors that the code takes, 8u and 16u of sums of magnitudes, are above the true ones.
///
///   - w and q are off by 3u of the sums of their terms, which are at most |v| |D|. So w^2 is off by 7u v.v D.D.
///   - r^2 v.v is off by 6u of itself, as r may be a sum that was rounded.
///   - D.D - r^2 is off by 4u (D.D + r^2).
VESICA_INLINE Quick filter_disc(double dx, double dy, double r, const Motion& v) noexcept {
  constexpr double u = 0x1p-53;
  const double vv = v.vx * v.vx + v.vy * v.vy, dd = dx * dx + dy * dy, rr = r * r;
  const double w = v.vx * dy - v.vy * dx, x = v.vx * dx, y = v.vy * dy, q = x + y, reach = sqrt(rr * vv);
  const double sizes = dd + rr, terms = abs(x) + abs(y), whole = v.end * vv;
  return decided(lane::both(lane::both(is_quick(v, vv), r >= 0), sizes <= most_usable * most_usable),
                 {rr * vv - w * w, 16 * u * (vv * sizes) + quick_tiny}, {dd - rr, 8 * u * sizes + quick_tiny},
                 {q, 8 * u * terms + quick_tiny}, {-q - reach - whole, 8 * u * (terms + reach + whole) + quick_tiny});
}

VESICA_INLINE Quick quick_filter(const Circle<double>& a, const Point<double>& b, const Motion& v) noexcept {
  return filter_disc(b.x - a.cx, b.y - a.cy, a.r, v);
}
VESICA_INLINE Quick quick_filter(const Circle<double>& a, const Circle<double>& b, const Motion& v) noexcept {
  return filter_disc(b.cx - a.cx, b.cy - a.cy, lane::select(lane::both(a.r >= 0, b.r >= 0), a.r + b.r, -1.0), v);
}

/// In the ellipse's frame, times |u|: X = u.D, Y = u x D are off by 4u A D, c = u.v and k = u x v by 3u A V, where A, D
/// and V are sums of components. It is f = (b X)^2 + (a Y)^2 - (a b u.u)^2 <= 0, and half its slope along v is
/// b^2 X c + a^2 Y k. The line meets it where w^2 <= al = (a k)^2 + (b c)^2, which is off by 10u ((a + b) A V)^2.
VESICA_INLINE Quick quick_filter(const Ellipse<double>& e, const Point<double>& p, const Motion& v) noexcept {
  constexpr double u = 0x1p-53;
  const double dx = p.x - e.cx, dy = p.y - e.cy, vv = v.vx * v.vx + v.vy * v.vy, uu = e.ux * e.ux + e.uy * e.uy;
  const double x = e.b * (e.ux * dx + e.uy * dy), y = e.a * (e.ux * dy - e.uy * dx);
  const double c = e.b * (e.ux * v.vx + e.uy * v.vy), k = e.a * (e.ux * v.vy - e.uy * v.vx);
  const double w = v.vx * dy - v.vy * dx, al = k * k + c * c, area = e.a * e.b * uu, q = x * c + y * k;
  const double axis = (e.a + e.b) * (abs(e.ux) + abs(e.uy)), speed = abs(v.vx) + abs(v.vy), far = abs(dx) + abs(dy);
  const double across = axis * speed, away = axis * far, width = speed * far;
  const double line_error = 16 * u * (across * across + width * width) + quick_tiny, whole = v.end * al;
  const double whole_error = v.end * line_error, forward_error = 16 * u * (across * away) + quick_tiny;
  const double reach = area * sqrt(al + line_error);
  const bool usable = lane::both(lane::both(is_quick(v, vv), in_quick_range(uu)),
                                 lane::both(lane::both(e.a >= 0, e.b >= 0), e.a + e.b + far <= most_usable));
  return decided(usable, {al - w * w, line_error},
                 {x * x + y * y - area * area, 16 * u * (away * away + area * area) + quick_tiny}, {q, forward_error},
                 {-q - reach - whole, forward_error + 8 * u * (reach + whole) + whole_error});
}

/// Of a box, whose sizes may be 0. c and k are off by 3u A V, or 5u where they are of differences, and the reach by twice
/// that times hx + hy. Contact comes when the ray has entered both slabs, at the later of two times, which the caller
/// compares; here is told only whether it lies before the box along v.
template <class Box>
VESICA_INLINE Quick filter_box(const Box& box, const Point<double>& p, const Motion& v) noexcept {
  constexpr double u = 0x1p-53;
  constexpr form::AsStored<double> number;
  const auto f = form::of(box);
  const form::Corners<double> from = form::corners(f.place);
  const double ux = number(f.ux), uy = number(f.uy), hx = number(f.hx), hy = number(f.hy);
  const double vv = v.vx * v.vx + v.vy * v.vy, speed = abs(v.vx) + abs(v.vy), axis = abs(ux) + abs(uy);
  const double dx = offset(p.x, p.x, from.x0, from.x1), dy = offset(p.y, p.y, from.y0, from.y1);
  const double c = ux * v.vx + uy * v.vy, k = ux * v.vy - uy * v.vx;
  const double w = v.vx * dy - v.vy * dx, q = v.vx * dx + v.vy * dy;
  const double along = hx * abs(c) + hy * abs(k), across = hx * abs(k) + hy * abs(c), whole = v.end * vv;
  const double size = (hx + hy) * (axis * speed), far = abs(dx) + abs(dy);
  const double error = 16 * u * (size + far * speed) + quick_tiny;
  const bool sized = lane::both(hx >= 0, hy >= 0);
  const bool usable =
      lane::both(lane::both(is_quick(v, vv), sized), lane::both(in_usable_range(axis), hx + hy + far <= most_usable));
  return decided(usable, {across - abs(w), error}, {0, -1}, {q - along, error},
                 {-q - along - whole, error + 8 * u * whole});
}
VESICA_INLINE Quick quick_filter(const Aabb<double>& a, const Point<double>& b, const Motion& v) noexcept {
  return filter_box(a, b, v);
}
VESICA_INLINE Quick quick_filter(const Rect<double>& a, const Point<double>& b, const Motion& v) noexcept {
  return filter_box(a, b, v);
}
VESICA_INLINE Quick quick_filter(const Segment<double>& a, const Point<double>& b, const Motion& v) noexcept {
  return filter_box(a, b, v);
}

/// Of two ellipses, by the filter for all kinds.
VESICA_INLINE Quick quick_filter(const Ellipse<double>& a, const Ellipse<double>& b, const Motion& v) noexcept {
  const Filtered known = filter(sketch(a), sketch(b), v);
  if (known.verdict == Verdict::missed) return Quick::missed;
  return lane::both(known.apart, known.verdict == Verdict::reached) ? Quick::hit : Quick::open;
}

template <class A, class B>
concept HasQuick = requires(const A& a, const B& b, const Motion& v) {
  quick_filter(a, b, v);
};

}  // namespace vesica::detail::cast
