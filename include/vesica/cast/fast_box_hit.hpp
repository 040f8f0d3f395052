// SPDX-License-Identifier: Apache-2.0
/// The contact of a ray with a box or a segment, after early_out.hpp has decided that they meet. Points and normals are
/// computed by the operations of first_contact.hpp, in a scene that needs no scaling. The time is T(n) rounded down,
/// n being the normal of the face that is hit.
#pragma once

#include <vesica/arithmetic/side_by_side.hpp>
#include <vesica/cast/fast_round_hit.hpp>

namespace vesica::detail::cast {

/// The ray at a side: t becomes the time at which it is there, rounded down. `way` is exact, and so is its quotient's
/// remainder, which is 0 where the time is a double.
struct BoxSide {
  Twofold<double> way;
  double v, t, rest;
};
VESICA_INLINE BoxSide box_side(double from, double low, double high, double v) noexcept {
  // Along a side: between that and the one opposite all the time.
  if (v == 0) return {{-1, 0}, 1, 0, 0};
  return {nearest::exact_difference(lane::select(v > 0, low, high), from), v, 0, 0};
}
template <class Products>
VESICA_INLINE void set_rest(BoxSide& side) noexcept {
  const Twofold<double> product = Products::factor(side.t) * Products::factor(side.v);
  side.rest = ((side.way.high - product.high) - product.low) + side.way.low;
}

/// An AABB: the times of both sides are quotients of exact numbers, and the later one is the time of contact. The
/// floor of the later is the later floor, so that nothing need be selected before.
template <class Products>
VESICA_INLINE EarlyOut fast_hit(const Aabb<double>& a, const Point<double>& b, const Motion& v,
                                Impact<double>& out) noexcept {
  using arithmetic::Two;
  BoxSide x = box_side(b.x, a.min_x, a.max_x, v.vx), y = box_side(b.y, a.min_y, a.max_y, v.vy);
  const double width = a.max_x - a.min_x, height = a.max_y - a.min_y;
  const Two time = Two{x.way.high, y.way.high} / Two{x.v, y.v}, over = Two{1, 1} / Two{x.v, y.v};
  x.t = time.x;
  y.t = time.y;
  const form::Corners<double> from = form::corners(form::of(a).place);
  const Vector d = exact_offset(b, from);
  const double first = lane::max(x.t, y.t);
  const bool sure = first > 0x1p-40 && first <= 0x1p60 && abs(x.t - y.t) > 0x1p-48 * (abs(x.t) + abs(y.t));
  if (!(sure && is_plain(d, v) && is_plain_size(width) && is_plain_size(height))) return EarlyOut::open;
  set_rest<Products>(x);
  set_rest<Products>(y);
  const Floor<double> fx = floor_of_quotient(x.t, x.rest, over.x), fy = floor_of_quotient(y.t, y.rest, over.y);
  const double t = lane::max(fx.t, fy.t);
  const bool on_x = x.t > y.t;
  if (!(on_x ? fx.certain : fy.certain)) return EarlyOut::open;
  if (t > v.end) return EarlyOut::missed;
  if (t == v.end && (on_x ? x.rest : y.rest) != 0) return EarlyOut::open;
  const double half_x = width * 0.5, half_y = height * 0.5;
  // The place along the side that is hit.
  const double half = lane::select(on_x, half_y, half_x);
  const double at = lane::select(on_x, d.y.high, d.x.high) + t * lane::select(on_x, v.vy, v.vx);
  const double share = lane::min(lane::max(at * half / (half * half), -1.0), 1.0);
  const double side_x = lane::flip_sign(-1.0, v.vx), side_y = lane::flip_sign(-1.0, v.vy);
  out = {t, support_minimum::located_coordinate(from.x0, from.x1, lane::select(on_x, side_x, share) * half_x) + 0.0,
         support_minimum::located_coordinate(from.y0, from.y1, lane::select(on_x, share, side_y) * half_y) + 0.0,
         lane::select(on_x, side_x, 0.0), lane::select(on_x, 0.0, side_y)};
  return EarlyOut::hit;
}

/// As touching_point() has it, where a ray that is at an offset from the centre meets a face.
VESICA_INLINE Offset point_of_face(const Offset& middle, const Offset& half, const Offset& offset) noexcept {
  const double length = half.x * half.x + half.y * half.y;
  const double share = ((offset.x + 0.0 - middle.x) * half.x + (offset.y + 0.0 - middle.y) * half.y) / length;
  const double at = lane::min(lane::max(share, -1.0), 1.0);
  return {middle.x + at * half.x, middle.y + at * half.y};
}

/// A box about its centre with the axes u and perp(u), and a radius or 0. A segment is `flat`: hy is 0, and the axis
/// has lower parts.
template <bool flat_, bool inflated_>
struct RayBox {
  static constexpr bool flat = flat_, inflated = inflated_;
  Vector u;
  double hx, hy, radius;
  form::Corners<double> place;

  template <class Products>
  VESICA_INLINE auto factor(const Vector& n) const noexcept {
    if constexpr (flat) {
      return Products::factor(n);
    } else {
      return plain_factor<Products>(n.x.high, n.y.high);
    }
  }
  VESICA_INLINE Impact<double> impact(double t, const Offset& at, double nx, double ny) const noexcept {
    return {t, support_minimum::located_coordinate(place.x0, place.x1, at.x) + 0.0,
            support_minimum::located_coordinate(place.y0, place.y1, at.y) + 0.0, nx + 0.0, ny + 0.0};
  }
};

/// The arc about the vertex x u + y perp(u) of a box with a radius; x and y are the half sizes with the vertex's signs.
///
/// Proved: if the normal n is between those of the faces beside the vertex, the arc's contact is that of the shape. The
/// general path then finds this vertex, too: n is 2^-24 from either face, and w without the terms of the faces has the
/// bits of latest_with_radius(), since it is made by the same sums in the order of the faces.
template <class Products, class Shape>
VESICA_INLINE EarlyOut arc_hit(const Shape& box, double x, double y, const Vector& d, const Motion& v,
                               Impact<double>& out) noexcept {
  const auto fu = box.template factor<Products>(box.u);
  const auto fv = plain_factor<Products>(v.vx, v.vy);
  const auto fx = Products::factor(x), fy = Products::factor(y);
  const Twofold<double> c = arithmetic::renormalised(dot(fu, fv)), k = arithmetic::renormalised(cross(fu, fv));
  Twofold<double> w = arithmetic::renormalised(cross(fv, Products::factor(d))), of_x = fx * Products::factor(k);
  Vector from{d.x - fx * fu.x, d.y - fx * fu.y};
  if constexpr (!Shape::flat) {
    const Twofold<double> of_y = -(fy * Products::factor(c));
    const bool x_first = (c.high > 0) == (k.high > 0);
    w = w + choose(x_first, of_x, of_y);
    of_x = choose(x_first, of_y, of_x);
    from = {from.x + fy * fu.y, from.y - fy * fu.x};
  }
  w = arithmetic::renormalised(w + of_x);
  from = {arithmetic::renormalised(from.x), arithmetic::renormalised(from.y)};
  const double ux = box.u.x.high, uy = box.u.y.high, axis = abs(ux) + abs(uy), r = box.radius;
  const double others = abs(d.x.high) + abs(d.y.high) + (abs(x) + abs(y)) * axis;
  double t;
  Vector n;
  const EarlyOut early = disc_hit<Products>(from, w, r, v, fv, others, t, n);
  // A miss of this arc alone is none of the shape.
  if (early != EarlyOut::hit) return EarlyOut::open;
  const double nx = n.x.high, ny = n.y.high, length = sqrt(nx * nx + ny * ny);
  const double doubt = 0x1p-24 * (axis * (abs(nx) + abs(ny))), p = ux * nx + uy * ny, q = ux * ny - uy * nx;
  const bool in_x = abs(p) > doubt && (x == 0 || (p > 0) == (x > 0)),
             in_y = abs(q) > doubt && (y == 0 || (q > 0) == (y > 0));
  if (!(in_x && in_y)) return EarlyOut::open;
  const arithmetic::Two unit = arithmetic::Two{nx, ny} / arithmetic::Two{length, length};
  const Offset at = x * Offset{ux, uy} + y * Offset{-uy, ux};
  out = box.impact(t, at + Offset{r * unit.x, r * unit.y}, unit.x, unit.y);
  return EarlyOut::hit;
}

/// The times at which the ray enters both slabs, |x.n| <= h u.u + r |u|, are computed in double, with errors of 32u of
/// the sum of terms over |n.v|, for n.v above its own rounding. The later one is computed again in twofolds. The filter
/// has decided that a slab along the ray always holds it. If there is a radius, a face is met between its ends, by
/// 2^-30 of all lengths, or else an arc.
template <class Products, class Shape>
VESICA_INLINE EarlyOut box_hit(const Shape& box, const Vector& d, const Motion& v, Impact<double>& out) noexcept {
  using arithmetic::Two;
  const Vector& u = box.u;
  const double hx = box.hx, hy = box.hy, r = box.radius;
  const double ux = u.x.high, uy = u.y.high, uu = ux * ux + uy * uy, speed = abs(v.vx) + abs(v.vy);
  const double c = ux * v.vx + uy * v.vy, k = ux * v.vy - uy * v.vx;
  const double x = ux * d.x.high + uy * d.y.high, y = ux * d.y.high - uy * d.x.high;
  const bool along_x = lane::both(lane::either(ux == 0, v.vx == 0), lane::either(uy == 0, v.vy == 0));
  const bool along_y = lane::both(lane::either(ux == 0, v.vy == 0), lane::either(uy == 0, v.vx == 0));
  const Two over = Two{1, 1} / Two{c, k};
  double wide = hx * uu, high = hy * uu;
  if constexpr (Shape::inflated) {
    const double beyond = r * sqrt(uu);
    wide += beyond;
    high += beyond;
  }
  double tx = (-x - lane::flip_sign(wide, c)) * over.x, ty = (-y - lane::flip_sign(high, k)) * over.y;
  const double axis = abs(ux) + abs(uy);
  double size = axis * (abs(d.x.high) + abs(d.y.high)) + (hx + hy) * (axis * axis);
  if constexpr (Shape::inflated) size += r * axis;
  double x_error = (size + axis * (speed * abs(tx))) * abs(over.x),
         y_error = (size + axis * (speed * abs(ty))) * abs(over.y);
  if (along_x) tx = -1, x_error = 0;
  if (along_y) ty = -1, y_error = 0;
  const double least = (Shape::inflated ? 0x1p-20 : 0x1p-40) * (axis * speed);
  const bool crosses = (along_x || abs(c) > least) && (along_y || abs(k) > least);
  const bool on_x = tx > ty;
  const double half = lane::select(on_x, hy, hx), h = lane::select(on_x, hx, hy);
  const bool usual = is_plain(d, v) && is_plain_size(axis) && is_plain(ux) && is_plain(uy) && is_plain(h);
  if constexpr (Shape::inflated) {
    if (!(usual && crosses && is_plain(half) && (h > 0 || half > 0) && is_plain_size(r))) return EarlyOut::open;
    const double first = lane::max(tx, ty), place = lane::select(on_x, y + k * first, x + c * first);
    if (!(abs(place) < half * uu - 0x1p-30 * (size + axis * (speed * first)))) {
      return arc_hit<Products>(box, on_x ? lane::flip_sign(-hx, c) : lane::flip_sign(hx, place),
                               on_x ? lane::flip_sign(hy, place) : lane::flip_sign(-hy, k), d, v, out);
    }
  } else {
    const bool apart = abs(tx - ty) > 0x1p-48 * (x_error + y_error);
    if (!(usual && crosses && is_plain_size(half) && apart)) return EarlyOut::open;
  }
  const double turn = lane::flip_sign(-1.0, lane::select(on_x, c, k));
  const auto across = [&](double along, double beside) { return turn * lane::select(on_x, along, beside); };
  const double nx = across(ux, -uy), ny = across(uy, ux);
  const auto nf =
      box.template factor<Products>(Vector{{nx, across(u.x.low, -u.y.low)}, {ny, across(u.y.low, u.x.low)}});
  const Twofold<double> nn = arithmetic::renormalised(dot(nf, nf));
  Twofold<double> reach = Products::factor(h) * Products::factor(nn);
  if constexpr (Shape::inflated) {
    reach = reach + Products::factor(r) * Products::factor(arithmetic::renormalised(Products::root(nn).value));
  }
  const Twofold<double> room = arithmetic::renormalised(dot(nf, Products::factor(d)) - reach);
  const Twofold<double> approach = arithmetic::renormalised(-dot(nf, plain_factor<Products>(v.vx, v.vy)));
  const double length = sqrt(nx * nx + ny * ny);
  const Two time = Two{room.high, 1} / Two{approach.high, approach.high}, unit = Two{nx, ny} / Two{length, length};
  const Twofold<double> rest = room - Products::factor(time.x) * Products::factor(approach);
  const double step = arithmetic::rounded(rest) * time.y;
  const double off = 0x1p-96 * (size + axis * (speed * abs(time.x))) * time.y + 0x1p-100 * abs(time.x);
  double t;
  const EarlyOut early = floor_of({time.x, step}, off, v.end, t);
  if (early != EarlyOut::hit) return early;
  Offset at = point_of_face({h * nx, h * ny}, {half * -ny, half * nx}, {d.x.high + t * v.vx, d.y.high + t * v.vy});
  if constexpr (Shape::inflated) at = at + Offset{r * unit.x, r * unit.y};
  out = box.impact(t, at, unit.x, unit.y);
  return EarlyOut::hit;
}

template <class Products>
VESICA_INLINE EarlyOut fast_hit(const Rect<double>& a, const Point<double>& b, const Motion& v,
                                Impact<double>& out) noexcept {
  const RayBox<false, false> box{{{a.ux, 0}, {a.uy, 0}}, a.hx, a.hy, 0, {a.cx, a.cy, a.cx, a.cy}};
  return box_hit<Products>(box, exact_offset(b.x, b.y, a.cx, a.cy), v, out);
}
template <class Products>
VESICA_INLINE EarlyOut fast_hit(const RoundRect<double>& a, const Point<double>& b, const Motion& v,
                                Impact<double>& out) noexcept {
  const RayBox<false, true> box{{{a.ux, 0}, {a.uy, 0}}, a.hx, a.hy, a.r, {a.cx, a.cy, a.cx, a.cy}};
  return box_hit<Products>(box, exact_offset(b.x, b.y, a.cx, a.cy), v, out);
}
template <class Products>
VESICA_INLINE EarlyOut fast_hit(const Segment<double>& a, const Point<double>& b, const Motion& v,
                                Impact<double>& out) noexcept {
  const RayBox<true, false> box{exact_offset(a.x1, a.y1, a.x0, a.y0), 0.5, 0, 0, {a.x0, a.y0, a.x1, a.y1}};
  return box_hit<Products>(box, exact_offset(b, box.place), v, out);
}
template <class Products>
VESICA_INLINE EarlyOut fast_hit(const Capsule<double>& a, const Point<double>& b, const Motion& v,
                                Impact<double>& out) noexcept {
  const RayBox<true, true> box{exact_offset(a.x1, a.y1, a.x0, a.y0), 0.5, 0, a.r, {a.x0, a.y0, a.x1, a.y1}};
  return box_hit<Products>(box, exact_offset(b, box.place), v, out);
}

}  // namespace vesica::detail::cast
