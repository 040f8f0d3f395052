// SPDX-License-Identifier: Apache-2.0
/// The contact of a ray with a box or a segment, after quick.hpp has decided that they meet. Points and normals are
/// computed by the operations of first_contact.hpp, in a scene that needs no scaling. The time is T(n) rounded down,
/// n being the normal of the face that is met.
#pragma once

#include <vesica/cast/quick_numbers.hpp>

namespace vesica::detail::cast {

/// Where a ray meets the face at height `height` along n, which is against v, after the time t: `half` is half of the
/// face.
struct QuickFace {
  Offset normal, middle, half;
};
VESICA_INLINE Impact<double> impact_on(const QuickFace& face, const form::Corners<double>& place, const Vector& d,
                                       const Motion& v, double t) noexcept {
  const Offset offset{d.x.high + t * v.vx, d.y.high + t * v.vy};
  const Offset at = touching_point({face.middle, face.half}, {{0, 0}, {0, 0}}, offset);
  return {t, support_minimum::located_coordinate(place.x0, place.x1, at.x) + 0.0,
          support_minimum::located_coordinate(place.y0, place.y1, at.y) + 0.0, face.normal.x + 0.0,
          face.normal.y + 0.0};
}

/// The point's coordinate, the box's on the side from which the ray comes, and the time at which they agree.
struct QuickSide {
  Twofold<double> way;
  double t;
};
VESICA_INLINE QuickSide quick_side(double from, double low, double high, double v) noexcept {
  const Twofold<double> way = nearest::exact_difference(lane::select(v > 0, low, high), from);
  return {way, way.high / v};
}

/// Of an AABB: the times are quotients of exact numbers, of which that is met is the later one. Its remainder is exact, so
/// that a time which is a double shows.
template <class Products>
VESICA_INLINE Quick quick_hit(const Aabb<double>& a, const Point<double>& b, const Motion& v,
                              Impact<double>& out) noexcept {
  const QuickSide x = quick_side(b.x, a.min_x, a.max_x, v.vx), y = quick_side(b.y, a.min_y, a.max_y, v.vy);
  const double width = a.max_x - a.min_x, height = a.max_y - a.min_y;
  // A ray along a side is between those sides all the time.
  const double tx = lane::select(v.vx == 0, -1.0, x.t), ty = lane::select(v.vy == 0, -1.0, y.t);
  const bool on_x = tx > ty;
  const double first = lane::max(tx, ty), speed = lane::select(on_x, v.vx, v.vy);
  const Twofold<double> way{lane::select(on_x, x.way.high, y.way.high), lane::select(on_x, x.way.low, y.way.low)};
  const form::Corners<double> from = form::corners(form::of(a).place);
  const Vector d = exact_offset(b, from);
  const bool plain = lane::both(is_plain(d, v), lane::both(is_plain_size(width), is_plain_size(height)));
  const bool sure = lane::both(first > 0x1p-40, abs(tx - ty) > 0x1p-48 * (abs(tx) + abs(ty)));
  if (!lane::both(lane::both(plain, sure), lane::both(is_plain(speed), first <= 0x1p60))) return Quick::open;
  const Twofold<double> product = Products::factor(first) * Products::factor(speed);
  const double rest = ((way.high - product.high) - product.low) + way.low, step = rest / speed;
  double t = first;
  const Quick quick =
      rest == 0 ? first <= v.end ? Quick::hit : Quick::missed : floor_of({first, step}, 0x1p-50 * abs(step), v.end, t);
  if (quick != Quick::hit) return quick;
  const double side = lane::select(speed > 0, -1.0, 1.0);
  const QuickFace face{{lane::select(on_x, side, 0.0), lane::select(on_x, 0.0, side)},
                       {lane::select(on_x, side * (width * 0.5), 0.0), lane::select(on_x, 0.0, side * (height * 0.5))},
                       {lane::select(on_x, 0.0, width * 0.5), lane::select(on_x, height * 0.5, 0.0)}};
  out = impact_on(face, from, d, v, t);
  return Quick::hit;
}

/// Of a box about its centre with the axes u and perp(u): the ray enters both slabs, |x.n| <= h u.u, at times that double
/// tells, but for 16u of the sum of terms over |n.v|, where n.v is known to be above its own rounding. The later is told
/// in twofolds. A slab along the ray holds it all the time, as the filter has told.
template <class Products>
VESICA_INLINE Quick box_hit(const Vector& u, double hx, double hy, const form::Corners<double>& place, const Vector& d,
                            const Motion& v, Impact<double>& out) noexcept {
  const double ux = u.x.high, uy = u.y.high, uu = ux * ux + uy * uy, speed = abs(v.vx) + abs(v.vy);
  const double c = ux * v.vx + uy * v.vy, k = ux * v.vy - uy * v.vx;
  const double x = ux * d.x.high + uy * d.y.high, y = ux * d.y.high - uy * d.x.high;
  const bool along_x = lane::both(lane::either(ux == 0, v.vx == 0), lane::either(uy == 0, v.vy == 0));
  const bool along_y = lane::both(lane::either(ux == 0, v.vy == 0), lane::either(uy == 0, v.vx == 0));
  const double tx = lane::select(along_x, -1.0, (-x - lane::flip_sign(hx * uu, c)) / c);
  const double ty = lane::select(along_y, -1.0, (-y - lane::flip_sign(hy * uu, k)) / k);
  const double axis = abs(ux) + abs(uy), size = axis * (abs(d.x.high) + abs(d.y.high)) + (hx + hy) * (axis * axis);
  const auto error = [&](double t, double approach) {
    return 0x1p-48 * (size + axis * (speed * abs(t))) / abs(approach);
  };
  const double x_error = lane::select(along_x, 0.0, error(tx, c)), y_error = lane::select(along_y, 0.0, error(ty, k));
  const double least = 0x1p-40 * (axis * speed);
  const bool crosses = lane::both(lane::either(along_x, abs(c) > least), lane::either(along_y, abs(k) > least));
  const bool on_x = tx > ty;
  const double half = lane::select(on_x, hy, hx), h = lane::select(on_x, hx, hy);
  const bool plain =
      lane::both(lane::both(is_plain(d, v), is_plain_size(axis)),
                 lane::both(lane::both(is_plain(ux), is_plain(uy)), lane::both(is_plain(h), is_plain_size(half))));
  if (!lane::both(lane::both(plain, crosses), abs(tx - ty) > x_error + y_error)) return Quick::open;
  const double turn = lane::select(lane::select(on_x, c, k) > 0, -1.0, 1.0);
  const auto across = [&](double along, double beside) { return turn * lane::select(on_x, along, beside); };
  const Vector n{{across(ux, -uy), across(u.x.low, -u.y.low)}, {across(uy, ux), across(u.y.low, u.x.low)}};
  const auto nf = Products::factor(n);
  const Twofold<double> reach = Products::factor(h) * Products::factor(arithmetic::renormalised(dot(nf, nf)));
  const Twofold<double> room = arithmetic::renormalised(dot(nf, Products::factor(d)) - reach);
  const Twofold<double> approach = arithmetic::renormalised(-dot(nf, Products::factor(Vector{{v.vx, 0}, {v.vy, 0}})));
  const double first = room.high / approach.high;
  const Twofold<double> rest = room - Products::factor(first) * Products::factor(approach);
  const double step = arithmetic::rounded(rest) / approach.high;
  const double off = 0x1p-96 * (size + axis * (speed * abs(first))) / approach.high + 0x1p-100 * abs(first);
  double t;
  const Quick quick = floor_of({first, step}, off, v.end, t);
  if (quick != Quick::hit) return quick;
  const double nx = n.x.high, ny = n.y.high, length = sqrt(nx * nx + ny * ny);
  out = impact_on({{nx / length, ny / length}, {h * nx, h * ny}, {half * -ny, half * nx}}, place, d, v, t);
  return Quick::hit;
}

template <class Products>
VESICA_INLINE Quick quick_hit(const Rect<double>& a, const Point<double>& b, const Motion& v,
                              Impact<double>& out) noexcept {
  return box_hit<Products>(Vector{{a.ux, 0}, {a.uy, 0}}, a.hx, a.hy, form::corners(form::of(a).place),
                           exact_offset(b.x, b.y, a.cx, a.cy), v, out);
}
template <class Products>
VESICA_INLINE Quick quick_hit(const Segment<double>& a, const Point<double>& b, const Motion& v,
                              Impact<double>& out) noexcept {
  const form::Corners<double> place = form::corners(form::of(a).place);
  return box_hit<Products>(exact_offset(a.x1, a.y1, a.x0, a.y0), 0.5, 0, place, exact_offset(b, place), v, out);
}

}  // namespace vesica::detail::cast
