// SPDX-License-Identifier: Apache-2.0
/// A common point of two scaled shapes that are known to overlap. If rounding leaves no point that is in both, it is
/// one that is in both to rounding.
///
/// The centre of one shape will do if it lies in the other. So will the centre of a shape that is small beyond
/// rounding. If neither centre lies in the other shape, neither shape contains the other, and their outlines meet.
#pragma once

#include <vesica/nearest/disjoint.hpp>
#include <vesica/nearest/near_outline.hpp>

namespace vesica::detail::nearest {

/// True if a shape holds the point at d from its centre.
inline bool holds(const ScaledShape& s, const Vector<double>& d) noexcept {
  const double x = d.x.high, y = d.y.high;
  if (s.radius > 0) return x * x + y * y <= s.radius * s.radius;
  const double ux = s.box.u.x.high, uy = s.box.u.y.high, uu = ux * ux + uy * uy;
  const double along = (ux * x + uy * y) / uu, across = (ux * y - uy * x) / uu;
  const double hx = s.box.hx.high, hy = s.box.hy.high;
  if (!s.curved) return abs(along) <= hx && abs(across) <= hy;
  return (along / hx) * (along / hx) + (across / hy) * (across / hy) <= 1;
}

/// A point of the first or of the second shape.
struct Common {
  bool of_a;
  Contact contact;
};

inline constexpr Contact middle_of_shape{{0, 0}, 0, 0};

/// On a segment from (x, y) along (dx, dy): the place 0 <= t <= 1 deepest inside |x| <= hx, |y| <= hy, and how far it
/// is outside (negative inside). The depth is the largest of four straight functions of t, so it is least at an end or
/// where two of them meet.
struct Deepest {
  double t, outside;
};

inline double outside(double x, double y, double hx, double hy) noexcept { return max(abs(x) - hx, abs(y) - hy); }

inline Deepest deepest(double x, double y, double dx, double dy, double hx, double hy) noexcept {
  // k + t m: x - hx, -x - hx, y - hy, -y - hy.
  const double k[4] = {x - hx, -x - hx, y - hy, -y - hy}, m[4] = {dx, -dx, dy, -dy};
  Deepest best{0, outside(x, y, hx, hy)};
  const auto consider = [&](double t) {
    if (!(t >= 0 && t <= 1)) return;
    const double o = outside(x + t * dx, y + t * dy, hx, hy);
    if (o < best.outside) best = {t, o};
  };
  consider(1);
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) consider((k[j] - k[i]) / (m[i] - m[j]));
  }
  return best;
}

/// A corner of a box by number, in turn round it.
inline Spot<double> corner(const Box<double>& box, int number) noexcept {
  const double i = number == 0 || number == 3 ? 1 : -1, j = number == 0 || number == 1 ? 1 : -1;
  return {i * box.hx.high, j * box.hy.high};
}

/// An edge of a box in the frame of an axis, in its units: one end, and the way to the other. Rounded last: next to
/// parallel needles the plain differences would be all error.
struct Edge {
  double x, y, dx, dy;
};

inline Edge edge(const Box<double>& box, int number, const Vector<double>& d, const Vector<double>& axis) noexcept {
  const auto u = factor(axis);
  const Twofold<double> scale = inverse(square(u.x) + square(u.y));
  const auto seen = [&](int k) {
    const Spot<double> p = corner(box, k);
    const auto v = factor(vertex(box, std::copysign(1.0, p.s), std::copysign(1.0, p.t)) - d);
    return Vector<double>{factor(dot(u, v)) * factor(scale), factor(cross(u, v)) * factor(scale)};
  };
  const Vector<double> from = seen(number), way = seen((number + 1) % 4) - from;
  return {rounded(from.x), rounded(from.y), rounded(way.x), rounded(way.y)};
}

inline Spot<double> on_edge(const Box<double>& box, int number, double t) noexcept {
  const Spot<double> p = corner(box, number), q = corner(box, (number + 1) % 4);
  return {p.s + t * (q.s - p.s), p.t + t * (q.t - p.t)};
}

/// The edges of a against all of b.
inline Common common_of_boxes(const Box<double>& a, const Box<double>& b, const Vector<double>& d) noexcept {
  double least = 0x1p1000;
  Spot<double> at{0, 0};
  for (int k = 0; k < 4; ++k) {
    const Edge e = edge(a, k, d, b.u);
    const Deepest found = deepest(e.x, e.y, e.dx, e.dy, b.hx.high, b.hy.high);
    if (found.outside >= least) continue;
    least = found.outside;
    at = on_edge(a, k, found.t);
  }
  return {true, on_box(a, at)};
}

/// The point of the box's edges that is closest to the ellipse's centre in the ellipse's own metric.
inline Common common_of_box_and_ellipse(const Box<double>& box, const ScaledShape& ellipse,
                                        const Vector<double>& d) noexcept {
  const Axes<double> s = ellipse.axes();
  double least = 0x1p1000;
  Spot<double> at{0, 0};
  for (int k = 0; k < 4; ++k) {
    const Edge e = edge(box, k, d, ellipse.box.u);
    const double x = e.x / s.a, y = e.y / s.b, mx = e.dx / s.a, my = e.dy / s.b, mm = mx * mx + my * my;
    const double t = mm > 0 ? max(0.0, min(1.0, -(x * mx + y * my) / mm)) : 0.0;
    const double wx = x + t * mx, wy = y + t * my, w = wx * wx + wy * wy;
    if (w >= least) continue;
    least = w;
    at = on_edge(box, k, t);
  }
  return {true, on_box(box, at)};
}

/// Shrunk about their centres by one factor s < 1, two overlapping ellipses touch in one point. s is the greatest value
/// of n.D / (h1(n) + h2(n)) over all n, has no other maximum, and is stationary where D = s (x1(n) + x2(n)).
inline Direction<double> common_normal(const TwoEllipses<double>& e, const Direction<double>& d, double size) noexcept {
  const auto same = [](const Direction<double>& p, const Direction<double>& q) { return p.x == q.x && p.y == q.y; };
  Direction<double> n = unit(d.x, d.y);
  Bracket<double> bracket{{d.y, -d.x}, {-d.y, d.x}};
  double slope_before = 0, tangent_before = 0;
  for (int step = 0; step < 200; ++step) {
    const Image<double> ia = image(e.sa, n), ib = image(e.sb, n);
    const double ha = sqrt(ia.square), hb = sqrt(ib.square), s = dot(n, d) / (ha + hb);
    const Direction<double> g{d.x - s * (ia.x / ha + ib.x / hb), d.y - s * (ia.y / ha + ib.y / hb)};
    const double slope = cross(n, g);
    const double bend = s * (e.sa.area_squared / (ha * ia.square) + e.sb.area_squared / (hb * ib.square));
    const double tangent = slope / bend;
    if (abs(slope) <= 0x1p-52 * size || abs(tangent) <= 0x1p-53) break;
    // The first sign decides on which side of D the maximum is: a quarter turn holds it then.
    (slope > 0 ? bracket.low : bracket.high) = n;
    const bool calm = slope * slope_before >= 0 || abs(tangent) <= 0.5 * abs(tangent_before);
    const Direction<double> next = turned(n, tangent);
    n = calm && bracket.holds(next) && step % 8 != 7 ? next : middle(e, d, bracket, step);
    n = unit(n.x, n.y);
    if (same(n, bracket.low) || same(n, bracket.high)) break;  // nothing is between
    slope_before = slope, tangent_before = tangent;
  }
  return n;
}

inline Common common_of_ellipses(const Axes<double>& a, const Axes<double>& b, const Vector<double>& d,
                                 double size) noexcept {
  const Direction<double> best = common_normal(two_ellipses(a, b), {d.x.high, d.y.high}, size);
  const auto n = normal(factor(best.x, best.y));
  const Support<double> sa = support(a, n), sb = support(b, n);
  const double s = min(1.0, rounded(dot(n.vector, factor(d))) / rounded(sa.height + sb.height));
  const double gx = d.x.high - s * (sa.x + sb.x), gy = d.y.high - s * (sa.y + sb.y);
  const double turn = (n.unit.x * gy - n.unit.y * gx) / (sa.curvature + sb.curvature), move = sa.curvature * turn;
  return {true, on_ellipse(s * sa.x - move * n.unit.y, s * sa.y + move * n.unit.x)};
}

inline Common exchanged(const Common& c) noexcept { return {!c.of_a, c.contact}; }

/// For a circle and another shape that does not hold its centre: the other's closest point to that centre; for two
/// circles a point of the line between the centres.
inline Common common_with_circle(const ScaledPair& p) noexcept {
  const double dx = p.d.x.high, dy = p.d.y.high;
  if (p.b.radius > 0) {
    const double share = p.a.radius / (p.a.radius + p.b.radius);
    return {true, on_ellipse(share * dx, share * dy)};
  }
  const Vector<double> to_centre = flipped(p.d, -1.0);
  if (!p.b.curved) return {false, on_box(p.b.box, point_box(p.b.box, to_centre).spot)};
  const OneEllipse<double> ellipse = one_ellipse(p.b.axes());
  const ClosestOffsets<double> found = offsets_along(ellipse, p.d, farthest_normal(ellipse, p.d, p.size), p.size);
  return {false, on_ellipse(found.bx, found.by)};
}

inline Common common_of_outlines(const ScaledPair& p) noexcept {
  if (p.a.radius > 0) return common_with_circle(p);
  if (!p.a.curved && !p.b.curved) return common_of_boxes(p.a.box, p.b.box, p.d);
  if (!p.a.curved) return common_of_box_and_ellipse(p.a.box, p.b, p.d);
  return common_of_ellipses(p.a.axes(), p.b.axes(), p.d, p.size);
}

inline ScaledPair exchanged(const ScaledPair& p) noexcept { return {p.b, p.a, flipped(p.d, -1.0), p.size, p.exponent}; }

/// In an order that does not depend on which shape is called a: circles, boxes, ellipses; of one form by place.
inline bool in_order(const ScaledPair& p) noexcept {
  const int a = p.a.radius > 0 ? 0 : p.a.curved ? 2 : 1, b = p.b.radius > 0 ? 0 : p.b.curved ? 2 : 1;
  return a != b ? a < b : in_order(p.d.x.high, p.d.y.high);
}

/// A common point if neither shape holds the other's centre.
inline Common common_point(const ScaledPair& p) noexcept {
  return in_order(p) ? common_of_outlines(p) : exchanged(common_of_outlines(exchanged(p)));
}

/// A point for shapes whose distance is at most a rounding error.
inline Common closest_point(const ScaledPair& p) noexcept {
  int steps = 0;
  return in_order(p) ? Common{true, closest(p, steps).a} : exchanged(Common{true, closest(exchanged(p), steps).a});
}

/// Smaller than this share of the pair a shape is all one place, to rounding.
inline constexpr double small_share = 0x1p-56;

/// How far outside of a shape the point at (x, y) from its centre is, at least; 0 inside.
inline double beyond(const ScaledShape& s, double x, double y) noexcept {
  if (s.radius > 0) return positive_part(sqrt(x * x + y * y) - s.radius);
  const double ux = s.box.u.x.high, uy = s.box.u.y.high, length = sqrt(ux * ux + uy * uy);
  const double along = (ux * x + uy * y) / length, across = (ux * y - uy * x) / length;
  const double a = s.box.hx.high * length, b = s.box.hy.high * length;
  if (!s.curved) return positive_part(outside(along, across, a, b));
  const bool inside = (along / a) * (along / a) + (across / b) * (across / b) <= 1;
  return inside ? 0 : off_ellipse(a, b, along, across);
}

/// True if both shapes hold the point, to rounding.
inline bool is_certain(const Common& c, const ScaledPair& p) noexcept {
  const ScaledShape &own = c.of_a ? p.a : p.b, &other = c.of_a ? p.b : p.a;
  const Vector<double> d = flipped(p.d, c.of_a ? -1.0 : 1.0);
  const double x = c.contact.x, y = c.contact.y;
  return beyond(own, x, y) <= least_certain && beyond(other, x + d.x.high, y + d.y.high) <= least_certain;
}

inline bool holds_other(const ScaledShape& a, const ScaledShape& b, const Vector<double>& d, double size) noexcept {
  return reach(b) < small_share * size || holds(a, d);
}

}  // namespace vesica::detail::nearest
