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
  return vv >= 0x1p-80 && vv <= 0x1p80 && v.end >= 0x1p-300;
}

/// `miss` is above 0 only if a miss is certain, `hit` only if contact at some time is; early(), asked last, only if the
/// end certainly comes before that contact. A processor can predict `usable`, but not which of the two is above 0: so
/// only one branch depends on that.
template <class Early>
VESICA_INLINE Quick decided(bool usable, double miss, double hit, const Early& early) noexcept {
  if (!usable) return Quick::open;
  if (miss > 0) return Quick::missed;
  if (!(hit > 0)) return Quick::open;
  return early() > 0 ? Quick::missed : Quick::hit;
}

/// Above 0 only if a point P that moves by W t certainly stays outside the circle |X| = R until the end: at the end it
/// is still outside, and moves inward. No root is taken, and no time computed. Given are f = f(0), q = P.W, W.W,
/// `sizes`, the sum of the terms of |P| and R, and `speed`, that of |W|.
///
/// Proved: the point was outside at every time before.
///
///   - f(t) = |P + W t|^2 - R^2 is convex. Where it still decreases at the end, it was greater before.
///   - f(0) is off by 12u sizes^2, q by 11u sizes speed, W.W by 10u speed^2. With `far` = sizes + end speed, f(end) is
///     off by 12u far^2, its own operations included by 20u far^2, and half its slope there by 14u far speed.
///   - If the end is infinite, the result is not above 0.
VESICA_INLINE double ends_outside(double f, double q, double ww, double sizes, double speed, double end) noexcept {
  constexpr double u = 0x1p-53;
  const double at_end = q + end * ww, far = sizes + end * speed;
  const double outside = (f + end * (q + at_end)) - (32 * u * (far * far) + quick_tiny);
  // Of two of which the first is NaN the second is the lesser.
  return lane::min(outside, -at_end - (16 * u * (far * speed) + quick_tiny));
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
  const double vv = v.vx * v.vx + v.vy * v.vy, dd = dx * dx + dy * dy, rr = r * r, sizes = dd + rr;
  const bool usable = is_quick(v, vv) && r >= 0 && sizes <= most_usable * most_usable;
  const double w = v.vx * dy - v.vy * dx, x = v.vx * dx, y = v.vy * dy, q = x + y, f = dd - rr;
  const double inside = rr * vv - w * w, line_error = 16 * u * (vv * sizes) + quick_tiny;
  const double speed = abs(v.vx) + abs(v.vy), far = abs(dx) + abs(dy);
  const double apart = f - (8 * u * sizes + quick_tiny), q_error = 8 * u * (far * speed) + quick_tiny;
  return decided(usable, lane::max(lane::min(apart, q - q_error), -inside - line_error),
                 lane::min(lane::min(apart, -q - q_error), inside - line_error),
                 [&] { return ends_outside(f, q, vv, far + r, speed, v.end); });
}

VESICA_INLINE Quick quick_filter(const Circle<double>& a, const Point<double>& b, const Motion& v) noexcept {
  return filter_disc(b.x - a.cx, b.y - a.cy, a.r, v);
}
VESICA_INLINE Quick quick_filter(const Circle<double>& a, const Circle<double>& b, const Motion& v) noexcept {
  return filter_disc(b.cx - a.cx, b.cy - a.cy, lane::select(lane::both(a.r >= 0, b.r >= 0), a.r + b.r, -1.0), v);
}

/// Of an ellipse and a point, in the ellipse's frame, times |u|. The ellipse is f = (b X)^2 + (a Y)^2 - (a b u.u)^2 <=
/// 0 with X = u.D and Y = u x D, and half the slope of f along v is b^2 X c + a^2 Y k, with c = u.v and k = u x v. The
/// line meets it where w^2 <= al = (a k)^2 + (b c)^2.
///
/// Proved: the errors that the code takes, 16u of sums of magnitudes, are above the true ones.
///
///   - X and Y are off by 4u A D, c and k by 3u A V, where A, D and V are sums of components.
///   - So al is off by 10u ((a + b) A V)^2, and a b u.u is at most (a + b) A max(a, b) A.
VESICA_INLINE Quick quick_filter(const Ellipse<double>& e, const Point<double>& p, const Motion& v) noexcept {
  constexpr double u = 0x1p-53;
  const double dx = p.x - e.cx, dy = p.y - e.cy, vv = v.vx * v.vx + v.vy * v.vy, uu = e.ux * e.ux + e.uy * e.uy;
  const double far = abs(dx) + abs(dy), sum = e.a + e.b;
  const bool usable = is_quick(v, vv) && in_quick_range(uu) && e.a >= 0 && e.b >= 0 && sum + far <= most_usable;
  const double x = e.b * (e.ux * dx + e.uy * dy), y = e.a * (e.ux * dy - e.uy * dx);
  const double c = e.b * (e.ux * v.vx + e.uy * v.vy), k = e.a * (e.ux * v.vy - e.uy * v.vx);
  const double w = v.vx * dy - v.vy * dx, al = k * k + c * c, area = e.a * e.b * uu, q = x * c + y * k;
  const double axis = sum * (abs(e.ux) + abs(e.uy)), speed = abs(v.vx) + abs(v.vy);
  const double across = axis * speed, away = axis * far, width = speed * far;
  const double line_error = 16 * u * (across * across + width * width) + quick_tiny, inside = al - w * w;
  const double f = (x * x + y * y) - area * area, q_error = 16 * u * (across * away) + quick_tiny;
  const double apart = f - (16 * u * (away * away + area * area) + quick_tiny);
  return decided(usable, lane::max(lane::min(apart, q - q_error), -inside - line_error),
                 lane::min(lane::min(apart, -q - q_error), inside - line_error),
                 [&] { return ends_outside(f, q, al, away + area, across, v.end); });
}

/// Of a box, whose sizes may be 0, and a point, in the box's frame, times |u|. The box is |X| <= hx u.u, |Y| <= hy u.u,
/// and its reach across v is hx |k| + hy |c|.
///
/// Proved: what is told is true of the exact numbers.
///
///   - The way of the ray, a segment, misses the box iff one of three lines divides them: the ray's own, or one along a
///     side. The ray starts beyond that side, and moves away from it or ends before it.
///   - A ray that starts before a side, and whose line passes through the inside, meets the box some time later.
///   - With A, D, V as above and H = hx + hy, offsets of the centre are off by 2u D + u H A, X and Y by 5u A (D + H A),
///     c and k by 5u A V where they are of differences, and the reach by twice that times H. The code takes 16u.
///   - So the signs of c and k are not always known. A ray is told to move away only where they are, and quick_hit()
///     leaves open the hits where c or k is that small.
struct BoxFrame {
  double c, k, x, y;  // v and D
  double hx, hy, uu, axis;
};
VESICA_INLINE Quick filter_box(const BoxFrame& f, double dx, double dy, const Motion& v, bool sized) noexcept {
  constexpr double u = 0x1p-53;
  const double vv = v.vx * v.vx + v.vy * v.vy, speed = abs(v.vx) + abs(v.vy), far = abs(dx) + abs(dy);
  const double sum = f.hx + f.hy, whole = sum * f.axis + far;
  const bool usable = is_quick(v, vv) && sized && sum + far <= most_usable;
  const double along_x = abs(f.c), along_y = abs(f.k), turning = 16 * u * (f.axis * speed);
  const double w = v.vx * dy - v.vy * dx, inside = (f.hx * along_y + f.hy * along_x) - abs(w);
  const double line_error = 16 * u * (speed * whole) + quick_tiny, error = 16 * u * (f.axis * whole) + quick_tiny;
  // As the ray comes: turned so that it moves forward.
  const double x = lane::flip_sign(f.x, f.c), y = lane::flip_sign(f.y, f.k), wide = f.hx * f.uu, high = f.hy * f.uu;
  const double away =
      lane::max(lane::min((x - wide) - error, along_x - turning), lane::min((y - high) - error, along_y - turning));
  const double before_x = (-x - wide) - error, before_y = (-y - high) - error;
  const auto early = [&] {
    // What an infinite end is multiplied by is above 0.
    return lane::max(before_x - v.end * (along_x + turning), before_y - v.end * (along_y + turning));
  };
  return decided(usable, lane::max(away, -inside - line_error),
                 lane::min(lane::max(before_x, before_y), inside - line_error), early);
}
template <class Box>
VESICA_INLINE Quick quick_filter_of_box(const Box& box, const Point<double>& p, const Motion& v) noexcept {
  constexpr form::AsStored<double> number;
  const auto f = form::of(box);
  const form::Corners<double> from = form::corners(f.place);
  const double ux = number(f.ux), uy = number(f.uy), hx = number(f.hx), hy = number(f.hy), axis = abs(ux) + abs(uy);
  const double dx = offset(p.x, p.x, from.x0, from.x1), dy = offset(p.y, p.y, from.y0, from.y1);
  const BoxFrame frame{ux * v.vx + uy * v.vy,
                       ux * v.vy - uy * v.vx,
                       ux * dx + uy * dy,
                       ux * dy - uy * dx,
                       hx,
                       hy,
                       ux * ux + uy * uy,
                       axis};
  return filter_box(frame, dx, dy, v, hx >= 0 && hy >= 0 && in_usable_range(axis));
}
VESICA_INLINE Quick quick_filter(const Aabb<double>& a, const Point<double>& p, const Motion& v) noexcept {
  const double hx = 0.5 * (a.max_x - a.min_x), hy = 0.5 * (a.max_y - a.min_y);
  const double dx = offset(p.x, p.x, a.min_x, a.max_x), dy = offset(p.y, p.y, a.min_y, a.max_y);
  // A half width may be 0 by underflow, even where min exceeds max.
  const bool sized = a.min_x <= a.max_x && a.min_y <= a.max_y;
  return filter_box({v.vx, v.vy, dx, dy, hx, hy, 1, 1}, dx, dy, v, sized);
}
VESICA_INLINE Quick quick_filter(const Rect<double>& a, const Point<double>& b, const Motion& v) noexcept {
  return quick_filter_of_box(a, b, v);
}
VESICA_INLINE Quick quick_filter(const Segment<double>& a, const Point<double>& b, const Motion& v) noexcept {
  return quick_filter_of_box(a, b, v);
}

/// Of two ellipses, by the filter for all kinds. It misses shapes that are beside each other at any end, even at none
/// that is valid.
VESICA_INLINE Quick quick_filter(const Ellipse<double>& a, const Ellipse<double>& b, const Motion& v) noexcept {
  if (!(v.end >= 0)) return Quick::open;
  const Filtered known = filter(sketch(a), sketch(b), v);
  if (known.verdict == Verdict::missed) return Quick::missed;
  return lane::both(known.apart, known.verdict == Verdict::reached) ? Quick::hit : Quick::open;
}

template <class A, class B>
concept HasQuick = requires(const A& a, const B& b, const Motion& v) {
  quick_filter(a, b, v);
};

}  // namespace vesica::detail::cast
