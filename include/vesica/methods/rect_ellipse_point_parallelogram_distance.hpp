// SPDX-License-Identifier: Apache-2.0
/// Rectangle against ellipse as the distance of a point to a parallelogram.
///
/// Idea: stretched until the ellipse is a disc, the rectangle is a parallelogram, and its distance to the disc's centre
/// is compared with the radius. In the ellipse's own measure: minimise its level function Q(X) = |X - K|^2 - 1, in
/// units in which the ellipse's outline has |X - K| = 1, over the edges that the centre can see. Source: David Eberly,
/// "Intersection of Rectangle and Ellipse" (2015), section 4. The shapes overlap iff the least level c_min <= 0; the
/// point P that has it is then common to both.
/// Wrong in print: nothing, but the minimum within an edge, (q0 q2 - q1^2) / q2, cancels; here it is a squared cross
/// product (rect_ellipse_metric.hpp).
/// Cost: at most two edges, 5 divisions; about 50 ns. c_min may err by a few roundings of its terms, and so the answer
/// within the same of contact. For an ellipse of half length 0, or so small (about 2^-176 of the largest length, float
/// 2^-22) that squares underflow, the answer comes from the exact overlap(), and c_min is put on its side of 0.
#pragma once

#include <limits>
#include <vesica/methods/rect_corners.hpp>
#include <vesica/methods/rect_ellipse_metric.hpp>

namespace vesica::methods {

/// The rectangle's point of least level of an ellipse, and the level: -1 the ellipse's centre, 0 its outline, and
/// (1 + d / r)^2 - 1 at distance d from a disc of radius r.
template <class T>
struct MetricClosest {
  T x, y, c_min;
};

namespace detail {

/// -1, 0 or 1: is k below, within or above [-e, e]?
template <class T>
VESICA_INLINE T side(T k, T e) noexcept {
  return k < -e ? T{-1} : k > e ? T{1} : T{0};
}

template <class T>
VESICA_INLINE T clamp(T x, T h) noexcept {
  return x < -h ? -h : x > h ? h : x;
}

/// The better of what `nearest(middle, direction, half length)` finds on the edges that the sides sx and sy name. It
/// gives the place along the edge as t; s and t then are those of the rectangle's frame.
template <class T, class Nearest, class Better>
VESICA_INLINE auto best_on_visible_edges(const Metric<T>& m, T sx, T sy, Nearest nearest, Better better) noexcept {
  auto side_edge = nearest(vertex(m, sx, T{0}), m.f1, m.hy), long_edge = nearest(vertex(m, T{0}, sy), m.f0, m.hx);
  side_edge.s = sx * m.hx;
  long_edge.s = long_edge.t;
  long_edge.t = sy * m.hy;
  return sy == 0 || (sx != 0 && better(side_edge, long_edge)) ? side_edge : long_edge;
}

/// A point s along and t across the rectangle's axis, at a squared distance square / per from the disc's centre.
template <class T>
struct Foot {
  T s, t, square, per;
};

/// The point p + t f nearest to the origin, |t| <= h.
template <class T>
VESICA_INLINE Foot<T> nearest_to_origin(const Vector<T>& p, const Vector<T>& f, T h) noexcept {
  const T ff = dot(f, f), foot = -dot(f, p) / ff, t = clamp(foot, h), distance = cross(f, p);
  if (t == foot) return {0, t, distance * distance, ff};
  const Vector<T> end = along(p, t, f);
  return {0, t, dot(end, end), 1};
}

template <class T>
VESICA_INLINE Foot<T> nearest_of_disc(const Metric<T>& m, T sx, T sy, T& level) noexcept {
  const auto nearer = [](const Foot<T>& p, const Foot<T>& q) { return p.square / p.per <= q.square / q.per; };
  const Foot<T> best = best_on_visible_edges(m, sx, sy, nearest_to_origin<T>, nearer);
  if (m.usable) {
    const T outline = m.r * m.r * best.per;
    level = (best.square - outline) / outline;
  } else {
    const T d = best.square == 0 ? T{0} : std::sqrt(best.square / best.per) / m.r;
    level = (d - 1) * (d + 1);
  }
  return best;
}

/// A point s along and t across the rectangle's axis, and where it lies from the ellipse's centre, its longer axis on
/// x.
template <class T>
struct Place {
  T s, t;
  Vector<T> at;
};

/// The point p + t f of least |y|, and of least |x| where that leaves a choice.
template <class T>
Place<T> nearest_to_x_axis(const Vector<T>& p, const Vector<T>& f, T h) noexcept {
  const T wanted = f.y != 0 ? -p.y / f.y : -p.x / f.x, t = clamp(wanted, h);
  Vector<T> at = along(p, t, f);
  if (f.y != 0 && t == wanted) at.y = 0;
  return {0, t, at};
}

template <class T>
T ratio(T x, T length) noexcept {
  return x == 0 ? 0 : x / length;
}

/// For a segment, and an ellipse so thin that it may as well be one: distance to the longer axis decides before
/// distance along it, the limit of ever thinner ellipses. What is beside a segment's line has an infinite level.
template <class T>
Place<T> nearest_of_needle(const RescaledPair<T>& p, T sx, T sy, T& level) noexcept {
  Metric<T> m = metric(p, Stretch<T>{1, 1, 1});
  T longer = p.g0, shorter = p.g1;
  if (longer < shorter) {
    m.centre = {m.centre.y, m.centre.x};
    m.f0 = {m.f0.y, m.f0.x};
    m.f1 = {m.f1.y, m.f1.x};
    longer = p.g1;
    shorter = p.g0;
  }
  const auto nearer = [](const Place<T>& p0, const Place<T>& p1) {
    const T y0 = std::fabs(p0.at.y), y1 = std::fabs(p1.at.y);
    return y0 < y1 || (y0 == y1 && std::fabs(p0.at.x) <= std::fabs(p1.at.x));
  };
  const Place<T> best = best_on_visible_edges(m, sx, sy, nearest_to_x_axis<T>, nearer);
  const T ww = p.wx * p.wx + p.wy * p.wy;
  const T x = ratio(best.at.x, longer * ww), y = ratio(best.at.y, shorter * ww);
  level = (x - 1) * (x + 1) + y * y;
  return best;
}

/// True if the shorter half length, beside the longer, is too small for squares.
template <class T>
bool is_needle(const Stretch<T>& s) noexcept {
  constexpr T least = ScalarTraits<T>::power(-22 * ScalarTraits<T>::range);
  return s.a < least * s.b || s.b < least * s.a;
}

/// A coordinate in the rectangle's frame in its stored unit; a half extent comes back as it was stored.
template <class T>
T stored(T rescaled, int exponent, T half) noexcept {
  const auto apart = vesica::detail::take_apart(static_cast<double>(rescaled));
  return clamp(static_cast<T>(vesica::detail::arithmetic::scale(apart.value, apart.exponent + exponent)), half);
}

/// The level on the side of 0 that the answer demands: rounding may have put it on the other one.
template <class T>
T agreeing(T level, std::int32_t overlap) noexcept {
  if (overlap == 1) return level > 0 ? 0 : level;
  return level > 0 ? level : std::numeric_limits<T>::denorm_min();
}

}  // namespace detail

/// 1 when they overlap (out.c_min <= 0), 0 when not.
///
/// With the ellipse's centre in the rectangle P is that centre and c_min -1. A segment (a or b = 0) has a finite level
/// on its own line only: c_min may be infinite, and P is then the limit of ever thinner ellipses. Errors, which leave
/// `out` untouched: error_shape, error_range (a coordinate of P is beyond the finite numbers).
template <class T>
std::int32_t point_parallelogram_distance(const Rect<T>& rect, const Ellipse<T>& ellipse,
                                          MetricClosest<T>& out) noexcept {
  if (check(rect) != 0 || check(ellipse) != 0) return error_shape;
  const auto pair = detail::rescaled_pair(rect, detail::box_of(ellipse));
  const auto by = detail::stretch(pair, ellipse);
  const auto m = detail::metric(pair, by);
  const T sx = detail::side(m.k0, m.e0), sy = detail::side(m.k1, m.e1);
  Point<T> p{ellipse.cx, ellipse.cy};
  T level = -1;
  if (sx != 0 || sy != 0) {
    const auto at = [&](const auto& best) {
      return detail::point_of(rect, detail::stored(best.s, pair.exponent, rect.hx),
                              detail::stored(best.t, pair.exponent, rect.hy));
    };
    p = detail::is_needle(by) ? at(detail::nearest_of_needle(pair, sx, sy, level))
                              : at(detail::nearest_of_disc(m, sx, sy, level));
    if (check(p) != 0) return error_range;
  }
  if (!m.usable) level = detail::agreeing(level, overlap_or_error(rect, ellipse));
  out = {p.x, p.y, level};
  return level <= 0 ? 1 : 0;
}

}  // namespace vesica::methods
