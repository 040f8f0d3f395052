// SPDX-License-Identifier: Apache-2.0
/// Early outs for rays, two discs and two ellipses: filters of these kinds that prove a miss or a hit. If anything
/// stays uncertain, the general path answers. Measured on random shapes of sizes about 1: a miss takes 9 to 19 ns, and
/// 48 by the filter for all kinds. A hit (fast_*_hit.hpp) takes 0.2 to 0.5 of the general path's time, two ellipses
/// 0.73. Both paths give the same bits: the decision and the time are certain, and points and normals are computed by
/// the same operations.
///
/// Bounds below have u = 2^-53. Differences of coordinates are off by u of themselves. Underflow adds less than 2^-400:
/// velocities are between 2^-40 and 2^40 or so, lengths below 2^200 as in filter.hpp.
///
/// The filters of rays and of two discs have a type V of numbers: double, or one that may fuse products with sums. No
/// bound needs a product to be rounded.
#pragma once

#include <vesica/cast/first_contact.hpp>

namespace vesica::detail::cast {

enum class EarlyOut {
  open,  // nothing is known
  missed,
  hit,  // from a filter: apart at the start, with a contact after it, at any time
};

inline constexpr double tiny_error = 0x1p-400;
/// Conditions that nearly always hold: processors foresee jumps, so that those of scalars need not be combined.
VESICA_INLINE bool all_hold(bool a, bool b, bool c) noexcept { return a && b && c; }
template <class Mask>
VESICA_INLINE Mask all_hold(Mask a, Mask b, Mask c) noexcept {
  return both(both(a, b), c);
}
template <class V>
VESICA_INLINE auto is_moderate_square(V square) noexcept {
  return both(square >= V(0x1p-80), square <= V(0x1p80));
}
/// True if a motion is in the range of early outs; vv is v.v. Earlier ends are excluded: positions there may have more
/// digits than exact numbers hold, and no early out checks that.
template <class V>
VESICA_INLINE auto in_early_range(const MotionOf<V>& v, V vv) noexcept {
  return all_hold(vv >= V(0x1p-80), vv <= V(0x1p80), v.end >= V(0x1p-300));
}

/// `miss` is above 0 only if a miss is certain, `hit` only if contact at some time is; early(), asked last, only if the
/// end certainly comes before that contact. A processor can predict `usable`, but not which of the two is above 0: so
/// only one branch depends on that.
template <class Mask, class V, class Early>
VESICA_INLINE EarlyOut decided(Mask usable, V miss, V hit, const Early& early) noexcept {
  const V zero(0.0);
  if (!usable) return EarlyOut::open;
  if (miss > zero) return EarlyOut::missed;
  if (!(hit > zero)) return EarlyOut::open;
  return early() > zero ? EarlyOut::missed : EarlyOut::hit;
}

/// Above 0 only if a point P that moves by W t certainly stays outside the circle |X| = R until the end: at the end it
/// is still outside, and moves inward. No root is taken, and no time computed. Given are f = f(0), q = P.W, W.W,
/// `sizes`, the sum of the terms of |P| and R, and `speed`, the sum of the terms of |W|.
///
/// Proved: the point was outside at every time before.
///
///   - f(t) = |P + W t|^2 - R^2 is convex. Where it still decreases at the end, it was greater before.
///   - f(0) is off by 12u sizes^2, q by 11u sizes speed, W.W by 10u speed^2. With `extent` = sizes + end speed, f(end)
///     is off by 12u extent^2, its own operations included by 20u extent^2, and half its slope there by 14u extent
///     speed.
///   - If the end is infinite, the result is not above 0.
template <class V>
VESICA_INLINE V ends_outside(V f, V q, V ww, V sizes, V speed, V end) noexcept {
  constexpr double u = 0x1p-53;
  const V at_end = q + end * ww, extent = sizes + end * speed;
  const V outside = (f + end * (q + at_end)) - (V(32 * u) * (extent * extent) + V(tiny_error));
  // min(NaN, x) is x.
  return min(outside, -at_end - (V(16 * u) * (extent * speed) + V(tiny_error)));
}

/// Filter for a disc of radius r about the origin and a point at (dx, dy), with w = v x D and q = D.v.
///
/// Proved: the errors that the code takes, 8u and 16u of sums of magnitudes, are above the true ones.
///
///   - w and q are off by 3u of the sums of their terms, which are at most |v| |D|. So w^2 is off by 7u v.v D.D.
///   - r^2 v.v has a relative error of 6u, since r may be a rounded sum.
///   - D.D - r^2 is off by 4u (D.D + r^2).
template <class V>
VESICA_INLINE EarlyOut filter_disc(V dx, V dy, V r, const MotionOf<V>& v) noexcept {
  constexpr double u = 0x1p-53;
  const V tiny(tiny_error), vv = v.vx * v.vx + v.vy * v.vy, dd = dx * dx + dy * dy, rr = r * r, sizes = dd + rr;
  const auto usable = all_hold(in_early_range(v, vv), r >= V(0.0), sizes <= V(most_usable * most_usable));
  const V w = v.vx * dy - v.vy * dx, q = v.vx * dx + v.vy * dy, f = dd - rr;
  const V inside = rr * vv - w * w, line_error = V(16 * u) * (vv * sizes) + tiny;
  const V speed = abs(v.vx) + abs(v.vy), distance = abs(dx) + abs(dy);
  const V apart = f - (V(8 * u) * sizes + tiny), q_error = V(8 * u) * (distance * speed) + tiny;
  return decided(usable, V(max(min(apart, q - q_error), -inside - line_error)),
                 V(min(min(apart, -q - q_error), inside - line_error)),
                 [&] { return ends_outside<V>(f, q, vv, distance + r, speed, v.end); });
}

template <class V>
VESICA_INLINE EarlyOut early_out(const Circle<V>& a, const Point<V>& b, const MotionOf<V>& v) noexcept {
  return filter_disc<V>(b.x - a.cx, b.y - a.cy, a.r, v);
}
template <class V>
VESICA_INLINE EarlyOut early_out(const Circle<V>& a, const Circle<V>& b, const MotionOf<V>& v) noexcept {
  const V r = select(both(a.r >= V(0.0), b.r >= V(0.0)), a.r + b.r, V(-1.0));
  return filter_disc<V>(b.cx - a.cx, b.cy - a.cy, r, v);
}

/// Filter for an ellipse and a point, in the ellipse's frame, times |u|. The ellipse is
/// f = (b X)^2 + (a Y)^2 - (a b u.u)^2 <= 0 with X = u.D and Y = u x D. Half the slope of f along v is
/// b^2 X c + a^2 Y k, with c = u.v and k = u x v. The line meets the ellipse where w^2 <= al = (a k)^2 + (b c)^2.
///
/// Proved: the errors that the code takes, 16u of sums of magnitudes, are above the true ones.
///
///   - X and Y are off by 4u A D, c and k by 3u A V, where A, D and V are sums of components.
///   - So al is off by 10u ((a + b) A V)^2, and a b u.u is at most (a + b) A max(a, b) A.
template <class V>
VESICA_INLINE EarlyOut early_out(const Ellipse<V>& e, const Point<V>& p, const MotionOf<V>& v) noexcept {
  constexpr double u = 0x1p-53;
  const V tiny(tiny_error), bound(16 * u), zero(0.0);
  const V dx = p.x - e.cx, dy = p.y - e.cy, vv = v.vx * v.vx + v.vy * v.vy, uu = e.ux * e.ux + e.uy * e.uy;
  const V distance = abs(dx) + abs(dy), sum = e.a + e.b;
  const auto sized = all_hold(e.a >= zero, e.b >= zero, sum + distance <= V(most_usable));
  const auto usable = all_hold(in_early_range(v, vv), is_moderate_square(uu), sized);
  const V x = e.b * (e.ux * dx + e.uy * dy), y = e.a * (e.ux * dy - e.uy * dx);
  const V c = e.b * (e.ux * v.vx + e.uy * v.vy), k = e.a * (e.ux * v.vy - e.uy * v.vx);
  const V w = v.vx * dy - v.vy * dx, al = k * k + c * c, area = e.a * e.b * uu, q = x * c + y * k;
  const V axis = sum * (abs(e.ux) + abs(e.uy)), speed = abs(v.vx) + abs(v.vy);
  const V across = axis * speed, away = axis * distance, width = speed * distance;
  const V line_error = bound * (across * across + width * width) + tiny, inside = al - w * w;
  const V f = (x * x + y * y) - area * area, q_error = bound * (across * away) + tiny;
  const V apart = f - (bound * (away * away + area * area) + tiny);
  return decided(usable, V(max(min(apart, q - q_error), -inside - line_error)),
                 V(min(min(apart, -q - q_error), inside - line_error)),
                 [&] { return ends_outside<V>(f, q, al, away + area, across, v.end); });
}

/// Filter for a box, whose sizes may be 0, with or without a radius, and a point, in the box's frame, times |u|. A box
/// is |X| <= hx u.u, |Y| <= hy u.u, and its reach across v is hx |k| + hy |c|. A radius r adds r |u| to each side and
/// r |v| to that reach.
///
/// Proved: every verdict is true of the exact numbers.
///
///   - The way of the ray, a segment, misses the box iff one of three lines divides them: the ray's own, or one along a
///     side. The ray starts beyond that side, and moves away from it or ends before it. If there is a radius, such a
///     line proves a miss, too; a miss beside a rounded corner may have none, and stays open.
///   - A ray that starts before a side, and whose line passes through the inside, meets the shape some time later.
///   - With A, D, V as above and H = hx + hy, offsets of the centre are off by 2u D + u H A, X and Y by 5u A (D + H A),
///     c and k by 5u A V where they are of differences, and the reach by twice that times H. Terms of a radius are off
///     by 5u of themselves. The code takes 16u.
///   - So the signs of c and k are not always known. The verdict that a ray moves away needs them, and fast_hit()
///     leaves open the hits where c or k is that small.
template <class V>
struct BoxFrame {
  V c, k, x, y;  // v and D
  V wide, high, reach;
  V sum, size, axis;  // H and the radius; H A and the radius; A
};
template <class V>
VESICA_INLINE BoxFrame<V> box_frame(V ux, V uy, V hx, V hy, V dx, V dy, const MotionOf<V>& v) noexcept {
  const V c = ux * v.vx + uy * v.vy, k = ux * v.vy - uy * v.vx, uu = ux * ux + uy * uy, axis = abs(ux) + abs(uy),
          sum = hx + hy;
  return {c,          k,   ux * dx + uy * dy, ux * dy - uy * dx, hx * uu, hy * uu, hx * abs(k) + hy * abs(c), sum,
          sum * axis, axis};
}
template <class V>
VESICA_INLINE EarlyOut filter_box(const BoxFrame<V>& f, V dx, V dy, const MotionOf<V>& v, MaskOf<V> sized) noexcept {
  constexpr double u = 0x1p-53;
  const V tiny(tiny_error), bound(16 * u);
  const V vv = v.vx * v.vx + v.vy * v.vy, speed = abs(v.vx) + abs(v.vy), distance = abs(dx) + abs(dy);
  const V whole = f.size + distance;
  const auto usable = all_hold(in_early_range(v, vv), sized, f.sum + distance <= V(most_usable));
  const V along_x = abs(f.c), along_y = abs(f.k), turning = bound * (f.axis * speed);
  const V w = v.vx * dy - v.vy * dx, inside = f.reach - abs(w);
  const V line_error = bound * (speed * whole) + tiny, error = bound * (f.axis * whole) + tiny;
  // As the ray comes: turned so that it moves forward.
  const V x = flip_sign(f.x, f.c), y = flip_sign(f.y, f.k);
  const V away = max(min((x - f.wide) - error, along_x - turning), min((y - f.high) - error, along_y - turning));
  const V before_x = (-x - f.wide) - error, before_y = (-y - f.high) - error;
  const auto early = [&]() -> V {
    // The factor is positive, so infinity times it is not NaN.
    return max(before_x - v.end * (along_x + turning), before_y - v.end * (along_y + turning));
  };
  return decided(usable, V(max(away, -inside - line_error)), V(min(max(before_x, before_y), inside - line_error)),
                 early);
}
/// The box of a shape, or its core, and the radius.
template <template <class> class Shape, class V>
VESICA_INLINE EarlyOut early_out_of_box(const Shape<V>& shape, const Point<V>& p, const MotionOf<V>& v) noexcept {
  constexpr form::AsStored<V> number;
  const auto [box, radius] = form::inflated(shape);
  const auto f = form::of(box);
  const form::Corners<V> from = form::corners(f.place);
  const V ux = number(f.ux), uy = number(f.uy), hx = number(f.hx), hy = number(f.hy), zero(0.0);
  const V dx = offset<V>(p.x, p.x, from.x0, from.x1), dy = offset<V>(p.y, p.y, from.y0, from.y1);
  BoxFrame<V> frame = box_frame(ux, uy, hx, hy, dx, dy, v);
  auto sized = all_hold(hx >= zero, hy >= zero, in_usable_range(frame.axis));
  if constexpr (form::Inflated<Shape<V>>) {
    const V beyond = radius * sqrt(V(ux * ux + uy * uy));
    frame.wide = frame.wide + beyond;
    frame.high = frame.high + beyond;
    frame.reach = frame.reach + radius * sqrt(V(v.vx * v.vx + v.vy * v.vy));
    frame.sum = frame.sum + radius;
    frame.size = frame.size + radius;
    sized = both(sized, radius >= zero);
  }
  return filter_box(frame, dx, dy, v, sized);
}
template <class V>
VESICA_INLINE EarlyOut early_out(const Aabb<V>& a, const Point<V>& p, const MotionOf<V>& v) noexcept {
  const V half(0.5), one(1.0), hx = half * (a.max_x - a.min_x), hy = half * (a.max_y - a.min_y), sum = hx + hy;
  const V dx = offset<V>(p.x, p.x, a.min_x, a.max_x), dy = offset<V>(p.y, p.y, a.min_y, a.max_y);
  // A half width may be 0 by underflow, even where min exceeds max.
  const MaskOf<V> sized = both(a.min_x <= a.max_x, a.min_y <= a.max_y);
  return filter_box<V>({v.vx, v.vy, dx, dy, hx, hy, hx * abs(v.vy) + hy * abs(v.vx), sum, sum, one}, dx, dy, v, sized);
}
#define VESICA_EARLY_OUT(Name)                                                                           \
  template <class V>                                                                                     \
  VESICA_INLINE EarlyOut early_out(const Name<V>& a, const Point<V>& b, const MotionOf<V>& v) noexcept { \
    return early_out_of_box(a, b, v);                                                                    \
  }
VESICA_EARLY_OUT(Rect)
VESICA_EARLY_OUT(Segment)
VESICA_EARLY_OUT(Capsule)
VESICA_EARLY_OUT(RoundRect)
#undef VESICA_EARLY_OUT

/// Two ellipses, by the filter for all kinds. It misses shapes that are beside each other at any end, even at none
/// that is valid.
VESICA_INLINE EarlyOut early_out(const Ellipse<double>& a, const Ellipse<double>& b, const Motion& v) noexcept {
  if (!(v.end >= 0)) return EarlyOut::open;
  const Filtered known = filter(sketch(a), sketch(b), v);
  if (known.verdict == Verdict::missed) return EarlyOut::missed;
  return lane::both(known.apart, known.verdict == Verdict::reached) ? EarlyOut::hit : EarlyOut::open;
}

template <class A, class B>
concept HasEarlyOut = requires(const A& a, const B& b, const Motion& v) {
  early_out(a, b, v);
};

}  // namespace vesica::detail::cast
