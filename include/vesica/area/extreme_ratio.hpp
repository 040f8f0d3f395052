// SPDX-License-Identifier: Apache-2.0
/// A small shape that crosses the outline of an extremely larger one. Double-doubles then cannot place the outline,
/// or it is straight in their precision. So the outline's place is computed exactly and rounded once.
#pragma once

#include <vesica/area/ellipse_ellipse.hpp>
#include <vesica/area/standard.hpp>

namespace vesica::detail::area {

/// A half plane w.X <= distance for X from the smaller shape's centre, in its units; the longer part of w is 1.
struct HalfPlane {
  double wx, wy, distance;
};

/// True if an ellipse's least radius of curvature is 2^54 times a length or more, all in the same units.
inline bool is_straight(const filter::Box<double>& ellipse, double length) noexcept {
  const double least = ellipse.hx < ellipse.hy ? ellipse.hx : ellipse.hy;
  const double most = ellipse.hx < ellipse.hy ? ellipse.hy : ellipse.hx;
  return least * (least / most) >= 0x1p54 * length;
}

/// The exponent of the number with the greater one.
inline int later(const exact::Length& x, const exact::Length& y) noexcept {
  if (x.sign == 0) return exact::rounded(y).exponent;
  if (y.sign == 0) return exact::rounded(x).exponent;
  const int s = exact::rounded(x).exponent, t = exact::rounded(y).exponent;
  return s > t ? s : t;
}

/// The larger ellipse's outline near the point c = (cx, cy), as a straight line. Let F be the quadratic form that is 1
/// on the outline; then F(c + X) = F(c) + gradient . X + terms of X^2, which are negligible for a straight outline. The
/// line is where this is 1. F(c) - 1 cancels, so it is computed exactly.
inline HalfPlane tangent_half_plane(const exact::Ellipse& e, const exact::Length& cx, const exact::Length& cy,
                                    int unit) noexcept {
  const exact::Length dx = cx - e.cx, dy = cy - e.cy;
  const auto p = e.b * exact::dot(e.ux, e.uy, dx, dy), q = e.a * exact::cross(e.ux, e.uy, dx, dy);
  const auto radius = e.a * e.b * exact::dot(e.ux, e.uy, e.ux, e.uy);
  using arithmetic::Scaled;
  const Scaled value = exact::rounded(exact::square(p) + exact::square(q) - exact::square(radius));
  const Scaled r = exact::rounded(radius), k0 = exact::rounded(p), k1 = exact::rounded(q);
  const int axis = later(e.ux, e.uy), length = later(e.a, e.b);
  const auto part = [](const exact::Length& x, int exponent) {
    const Scaled m = exact::rounded(x);
    return arithmetic::scale(m.value, m.exponent - exponent);
  };
  const double vx = part(e.ux, axis), vy = part(e.uy, axis), a = part(e.a, length), b = part(e.b, length);
  const double x = arithmetic::scale(k0.value / r.value, k0.exponent - r.exponent);
  const double y = arithmetic::scale(k1.value / r.value, k1.exponent - r.exponent);
  const double vv = vx * vx + vy * vy, n0 = x / (a * vv), n1 = y / (b * vv);
  const double wx = n0 * vx - n1 * vy, wy = n0 * vy + n1 * vx, longer = std::fmax(std::fabs(wx), std::fabs(wy));
  const Scaled distance{-0.5 * value.value / (r.value * r.value * longer), value.exponent - 2 * r.exponent};
  return {wx / longer, wy / longer, bounded(distance, unit - axis - length, out_of_sight)};
}

/// The part of a box in a half plane, in units of the box as standard_pair() gives it.
inline double area_in_half_plane(const filter::Box<double>& box, const HalfPlane& h) noexcept {
  const double c = box.ux * h.wx + box.uy * h.wy, s = box.ux * h.wy - box.uy * h.wx;
  const double uu = box.ux * box.ux + box.uy * box.uy, ww = h.wx * h.wx + h.wy * h.wy;
  const Extents<double> e{box.hx * uu * ww, box.hy * uu * ww};
  return clipped_area(e, Strips<double>{c, s, -out_of_sight, h.distance, -out_of_sight, out_of_sight}) / (uu * ww * ww);
}

/// The part of the unit disc in y . n <= distance, n of any length.
inline double area_in_half_plane(const Oval<double>& e, const HalfPlane& h) noexcept {
  const double nx = e.a * (e.ux * h.wx + e.uy * h.wy), ny = e.b * (e.ux * h.wy - e.uy * h.wx);
  const double d = h.distance / std::sqrt(nx * nx + ny * ny);
  if (!(d > -1 && d < 1)) return d > 0 ? pi_high : 0;
  const double cap = segment_area((1 - d) * (1 + d), d * d);
  return d > 0 ? pi_high - cap : cap;
}

/// A box's edges in the frame in which a smaller ellipse is the unit disc, from exact distances. unit: the exponent of
/// the ellipse's units, axis the exponent of the box's axis in its own.
inline Lines exact_lines(const exact::Box& box, const exact::Ellipse& e, const filter::Box<double>& box_in_units,
                         const Oval<double>& e_in_units, int unit) noexcept {
  const exact::Length dx = box.cx - e.cx, dy = box.cy - e.cy;
  const auto uu = exact::dot(box.ux, box.uy, box.ux, box.uy);
  const auto reach_0 = box.hx * uu, reach_1 = box.hy * uu;
  const auto along = exact::dot(box.ux, box.uy, dx, dy), across = exact::cross(box.ux, box.uy, dx, dy);
  const int scale = unit + later(box.ux, box.uy);
  const auto place = [&](const exact::Number<3>& x) { return bounded(exact::rounded(x), scale, 0x1p900); };
  Lines l = lines(box_in_units, e_in_units);
  l.low_0 = place(along - reach_0);
  l.high_0 = place(along + reach_0);
  l.low_1 = place(across - reach_1);
  l.high_1 = place(across + reach_1);
  return l;
}

}  // namespace vesica::detail::area
