// SPDX-License-Identifier: Apache-2.0
// First contacts of boxes: points, segments, AABBs and rectangles (detail::cast::latest_axis(), in lanes).
#pragma once

#include "kernels/cast_scene.hpp"

namespace vesica {
namespace {

using detail::arithmetic::renormalised;

/// As stored.
using BoxLanes = detail::nearest::Box<Doubles>;
VESICA_INLINE TwofoldLanes load_exactly(const ColumnDifference& d, std::int32_t i) noexcept {
  return exact_difference(load(d.to, i), load(d.from, i));
}
VESICA_INLINE BoxLanes box_lanes(const SideColumns& side, std::int32_t i) noexcept {
  return {{load_exactly(side.ux, i), load_exactly(side.uy, i)}, load_exactly(side.hx, i), load_exactly(side.hy, i)};
}
VESICA_INLINE Doubles length_of(const VectorLanes& u) noexcept { return abs(u.x.high) + abs(u.y.high); }
VESICA_INLINE Doubles reach_of(const BoxLanes& s) noexcept { return (s.hx.high + s.hy.high) * length_of(s.u); }
VESICA_INLINE CastMask is_plain_box(const BoxLanes& s) noexcept {
  const CastMask axis = both(both(is_plain(s.u.x.high), is_plain(s.u.y.high)), is_plain_size(length_of(s.u)));
  return both(axis, both(is_plain(s.hx.high), is_plain(s.hy.high)));
}
VESICA_INLINE CastMask has_no_size(const BoxLanes& s) noexcept {
  return both(s.hx.high == Doubles(0.0), s.hy.high == Doubles(0.0));
}
VESICA_INLINE CastMask same_vector(const VectorLanes& u, const VectorLanes& w) noexcept {
  return both(both(u.x.high == w.x.high, u.x.low == w.x.low), both(u.y.high == w.y.high, u.y.low == w.y.low));
}
VESICA_INLINE VectorLanes perpendicular(const VectorLanes& u) noexcept { return {-u.y, u.x}; }

/// Two boxes, the way of the second, and the length that errors are relative to. ray: the second is a point.
struct BoxesLanes {
  BoxLanes a, b;
  WayLanes way;
  Doubles speed, size;
  bool ray;
};

/// An axis of a box as a normal, and between which times it stops to separate; both are -1 where it cannot be the last.
struct AxisLanes {
  VectorLanes normal;
  Doubles least, most;
};

/// Errors are four times those of detail::cast::axis(): of two intervals that are apart the times are far from equal.
/// doubtful: whether it may be across v, though no product decides it.
VESICA_INLINE AxisLanes axis_lanes(const BoxesLanes& s, const VectorLanes& normal, Doubles height, CastMask excluded,
                                   CastMask& doubtful) noexcept {
  const OffsetLanes& v = s.way.v;
  const Doubles nx = normal.x.high, ny = normal.y.high, zero(0.0), never(-1.0), n_size = abs(nx) + abs(ny);
  const Doubles forward = nx * v.x + ny * v.y, approach = abs(forward);
  const CastMask across = both(either(nx == zero, v.x == zero), either(ny == zero, v.y == zero));
  const CastMask out = either(excluded, across);
  doubtful = either(doubtful, and_not(negated<Doubles>(approach > Doubles(0x1p-40) * (n_size * s.speed)), out));
  const Doubles distance = flip_sign(nx * s.way.d.x.high + ny * s.way.d.y.high, -forward);
  const Doubles inverse = Doubles(1.0) / approach, t = (distance - height) * inverse;
  const Doubles error = Doubles(0x1p-47) * n_size * (s.size + s.speed * abs(t)) * inverse;
  return {normal, select(out, never, t - error), select(out, never, t + error)};
}

struct LastAxis {
  VectorLanes normal;   // against v
  CastMask of_a, of_b;  // whose axis it is
  CastMask across;      // whether it is perp(u)
  CastMask settled;
};

/// The one axis that separates longest; not settled where double cannot decide.
VESICA_INLINE LastAxis last_axis(const BoxesLanes& s) noexcept {
  const Doubles zero(0.0);
  const CastMask none = zero < zero;
  const VectorLanes &u = s.a.u, &w = s.b.u;
  const CastMask no_a = has_no_size(s.a), no_b = has_no_size(s.b), same = same_vector(u, w);
  const Doubles ux = u.x.high, uy = u.y.high, wx = w.x.high, wy = w.y.high, uu = ux * ux + uy * uy;
  CastMask doubtful = none;
  LastAxis out;
  const CastMask only_a = either(same, and_not(no_b, no_a)), only_b = and_not(and_not(no_a, no_b), same);
  const Doubles ax = s.a.hx.high, ay = s.a.hy.high, bx = s.b.hx.high, by = s.b.hy.high;
  const Doubles c = abs(ux * wx + uy * wy), k = abs(ux * wy - uy * wx);
  AxisLanes axes[4] = {axis_lanes(s, u, ax * uu + (bx * c + by * k), only_b, doubtful),
                       axis_lanes(s, perpendicular(u), ay * uu + (bx * k + by * c), only_b, doubtful)};
  axes[2] = axes[3] = {w, Doubles(-1.0), Doubles(-1.0)};
  if (!s.ray) {
    const Doubles ww = wx * wx + wy * wy;
    axes[2] = axis_lanes(s, w, bx * ww + (ax * c + ay * k), only_a, doubtful);
    axes[3] = axis_lanes(s, perpendicular(w), by * ww + (ax * k + ay * c), only_a, doubtful);
  }
  Doubles least = axes[0].least;
  for (int i = 1; i < 4; ++i) least = max(least, axes[i].least);
  CastMask some = none, several = none, of_b = none;
  out.across = none;
  out.normal = axes[0].normal;
  for (int i = 0; i < 4; ++i) {
    const CastMask left = axes[i].most >= least;
    several = either(several, both(some, left));
    some = either(some, left);
    if (i == 0) continue;
    out.normal = {choose(left, axes[i].normal.x, out.normal.x), choose(left, axes[i].normal.y, out.normal.y)};
    if (i % 2 == 1) out.across = either(out.across, left);
    if (i >= 2) of_b = either(of_b, left);
  }
  out.of_b = either(of_b, same);
  out.of_a = either(negated<Doubles>(of_b), same);
  out.settled = and_not(and_not(both(some, least > zero), several), doubtful);
  const Doubles back = -(out.normal.x.high * s.way.v.x + out.normal.y.high * s.way.v.y);
  out.normal = {flipped(out.normal.x, back), flipped(out.normal.y, back)};
  return out;
}

template <class Factor>
VESICA_INLINE TwofoldLanes height_lanes(const BoxLanes& s, const Factor& n) noexcept {
  using P = LaneProducts;
  const auto u = P::factor(s.u);
  const TwofoldLanes p = P::factor(s.hx) * P::factor(renormalised(dot(u, n))),
                     q = P::factor(s.hy) * P::factor(renormalised(cross(u, n)));
  return flipped(p, p.high) + flipped(q, q.high);
}

/// T(n), as detail::cast::lower_bound() has it.
VESICA_INLINE FloorLanes floor_lanes(const BoxesLanes& s, const VectorLanes& normal) noexcept {
  using P = LaneProducts;
  const auto n = P::factor(normal);
  TwofoldLanes height = height_lanes(s.a, n);
  if (!s.ray) height = height + height_lanes(s.b, n);
  const TwofoldLanes room = renormalised(dot(n, P::factor(s.way.d)) - height);
  const TwofoldLanes approach = renormalised(-dot(n, detail::cast::plain_factor<P>(s.way.v.x, s.way.v.y)));
  const Doubles first = room.high / approach.high;
  const TwofoldLanes rest = room - P::factor(first) * P::factor(approach);
  const Doubles step = detail::arithmetic::rounded(rest) / approach.high;
  const Doubles error = Doubles(0x1p-95) * length_of(normal) * (s.size + s.speed * abs(first)) / approach.high +
                        Doubles(0x1p-99) * abs(first);
  return detail::cast::floor_of(TwofoldLanes{first, step}, error);
}

/// detail::cast::Foremost, where known: not of a box that is about parallel to n, unless n is its own axis.
struct ForemostLanes {
  OffsetLanes middle, half;
  CastMask known;
};
VESICA_INLINE ForemostLanes foremost_lanes(const BoxLanes& s, Doubles nx, Doubles ny, CastMask own,
                                           CastMask across) noexcept {
  const Doubles ux = s.u.x.high, uy = s.u.y.high, a = s.hx.high, b = s.hy.high, zero(0.0);
  const Doubles p = ux * nx + uy * ny, q = ux * ny - uy * nx;
  const Doubles doubt = Doubles(detail::cast::beside_face) * ((abs(ux) + abs(uy)) * (abs(nx) + abs(ny)));
  const CastMask p_is_zero = both(own, across), q_is_zero = and_not(own, across);
  const CastMask clear = both(abs(p) > doubt, abs(q) > doubt);
  const OffsetLanes first = flip_sign(a, p) * OffsetLanes{ux, uy}, second = flip_sign(b, q) * OffsetLanes{-uy, ux};
  const auto part = [&](Doubles x, Doubles y, Doubles& middle, Doubles& half) {
    middle = select(p_is_zero, y, select(q_is_zero, x, x + y));
    half = select(p_is_zero, x, select(q_is_zero, y, zero));
  };
  ForemostLanes out;
  part(first.x, second.x, out.middle.x, out.half.x);
  part(first.y, second.y, out.middle.y, out.half.y);
  out.known = either(either(clear, own), has_no_size(s));
  return out;
}

/// detail::cast::touching_point(), for an edge of a.
VESICA_INLINE OffsetLanes point_on_edge(const ForemostLanes& a, const ForemostLanes& b, Doubles x, Doubles y) noexcept {
  const Doubles length = a.half.x * a.half.x + a.half.y * a.half.y, one(1.0);
  const auto share = [&](Doubles px, Doubles py) { return (px * a.half.x + py * a.half.y) / length; };
  const Doubles middle = share(x + b.middle.x - a.middle.x, y + b.middle.y - a.middle.y);
  const Doubles half = abs(share(b.half.x, b.half.y));
  const auto within = [&](Doubles s) { return max(min(s, one), -one); };
  const Doubles at = Doubles(0.5) * (within(middle - half) + within(middle + half));
  return {a.middle.x + at * a.half.x, a.middle.y + at * a.half.y};
}

VESICA_KERNEL void cast_boxes(const CastColumns& columns, std::int32_t n, double* const* results) noexcept {
  const Doubles zero(0.0);
  const ForemostLanes point{{zero, zero}, {zero, zero}, zero <= zero};
  for (std::int32_t i = 0; i < n; i += Doubles::width) {
    BoxesLanes s{box_lanes(columns.a, i), box_lanes(columns.b, i), way_lanes(columns, i), zero, zero,
                 columns.b.is_point};
    const OffsetLanes& v = s.way.v;
    s.speed = abs(v.x) + abs(v.y);
    s.size = Doubles(2.0) * length_of(s.way.d) + (reach_of(s.a) + reach_of(s.b));
    const LastAxis last = last_axis(s);
    const FloorLanes floor = floor_lanes(s, last.normal);
    const Doubles nx = last.normal.x.high, ny = last.normal.y.high;
    const ForemostLanes of_a = foremost_lanes(s.a, nx, ny, last.of_a, last.across);
    ForemostLanes of_b = point;
    if (!s.ray) of_b = foremost_lanes(s.b, -nx, -ny, last.of_b, last.across);
    const CastMask is_edge = either(abs(of_a.half.x) > zero, abs(of_a.half.y) > zero);
    const OffsetLanes on_edge =
        point_on_edge(of_a, of_b, s.way.d.x.high + floor.t * v.x, s.way.d.y.high + floor.t * v.y);
    const OffsetLanes at{select(is_edge, on_edge.x, of_a.middle.x), select(is_edge, on_edge.y, of_a.middle.y)};
    const CastMask known = both(of_a.known, either(of_b.known, negated<Doubles>(is_edge)));
    const CastMask plain = both(s.way.plain, both(is_plain_box(s.a), is_plain_box(s.b)));
    store_impacts(columns, i, floor.t, at, nx, ny, both(both(plain, known), both(last.settled, floor.certain)),
                  results);
  }
}

}  // namespace
}  // namespace vesica
