// SPDX-License-Identifier: Apache-2.0
// First contacts of a box with a circle or an ellipse; one of them moves. The filter has decided that they meet. The
// vertex or face of the box and the normal are found by the operations of direction.hpp: so their bits are those of
// single casts. The time is T(n) of bound.hpp, whose bounds are computed in double.
#pragma once

#include "kernels/cast_boxes.hpp"
#include "kernels/cast_rounds.hpp"

namespace vesica {
namespace {

/// A box's support as in SideSupport. Only h is a twofold, the other numbers are double; p = u.n, q = u x n.
struct BoxSupportLanes {
  TwofoldLanes h;
  Doubles beside, edge, p, q;
};
/// c = u.v, k = u x v.
template <class Normal>
VESICA_INLINE BoxSupportLanes support_lanes(const BoxLanes& box, const TwofoldLanes& c, const TwofoldLanes& k,
                                            const Normal& n) noexcept {
  using namespace detail::cast;
  using Products = LaneProducts;
  const Doubles zero(0.0), hk = -(box.hx.high * k.high), hc = box.hy.high * c.high;
  const auto u = Products::factor(box.u);
  const TwofoldLanes p = detail::arithmetic::renormalised(dot(u, n)), q = detail::arithmetic::renormalised(cross(u, n));
  const TwofoldLanes hp = Products::factor(box.hx) * Products::factor(p),
                     hq = Products::factor(box.hy) * Products::factor(q);
  const CastMask no_p = p.high == zero, no_q = q.high == zero;
  return {magnitude(hp) + magnitude(hq),
          select(no_p, zero, flip_sign(hk, p.high)) + select(no_q, zero, flip_sign(hc, q.high)),
          select(no_p, abs(hk), zero) + select(no_q, abs(hc), zero), p.high, q.high};
}

/// The time, how far it may be off, and whether that and the normal are certain. The normal is against v and of any
/// length; in the round shape's frame it is (p, q). `face`: it is the normal of a face of the box, along its axis
/// (`lengthwise`) or across that.
struct BoxRoundMeeting {
  TwofoldLanes time;
  Doubles error;
  CastMask certain;
  VectorLanes normal;
  OffsetLanes in_frame;
  CastMask face, lengthwise;
};

/// d: from the first's centre to the second's; v: the second's velocity. Which of them is the box does not count. All
/// numbers that are multiplied are 0 or moderate (is_plain()), and the round shape is_usual().
///
/// Proved: where it is certain, the time is off by less than `error`, and the normal has the bits of the general path.
///
///   - T(n) is off by `lost`, eight times the error in lower_bound().
///   - The slope that is left is off by less than 2^-48 of the reaches across v. There are fewer than 16 roundings,
///     and of a line that meets the sum of both |w| is no greater than these.
///   - The normal of a face is exact. If the line passes its ends by 2^-30 of it at least, T(n) is the time.
///   - At a vertex `gain` is what bound.hpp allows for, and its conditions hold with 64 for its 8 and 3.
///   - So polished() stops where it begins: by its own, smaller errors the gain is below 2^-70 t, too. They are smaller
///     where all lengths are below 2^40 of the round shape's reach along n.
///
/// Lanes with a direction nearly across v are left open.
VESICA_INLINE BoxRoundMeeting box_round_meeting(const BoxLanes& box, const EllipseLanes& round, const VectorLanes& d,
                                                const OffsetLanes& v) noexcept {
  using namespace detail::cast;
  using Products = LaneProducts;
  const Doubles zero(0.0);
  const auto along = plain_factor<Products>(v.x, v.y);
  const auto to = Products::factor(d), u = Products::factor(box.u);
  const TwofoldLanes w = cross(along, to), c = dot(u, along), k = cross(u, along);
  const Feature<Doubles> met = feature<Products>(box, c, k, w, round.curve(v));
  const VectorLanes of_face{choose(met.lengthwise, box.u.x, -box.u.y), choose(met.lengthwise, box.u.y, box.u.x)};
  const Doubles forward = of_face.x.high * v.x + of_face.y.high * v.y;
  const auto normal_of_face = [&]() -> VectorLanes {
    return {flipped(of_face.x, -forward), flipped(of_face.y, -forward)};
  };
  const auto normal_of_vertex = [&] {
    const TwofoldLanes at = detail::arithmetic::renormalised(met.w);
    return normal_of<Products>(maximum_of_one(round.curve(v), at.high, gap_of(round.reach<Products>(v), at)), v);
  };
  const VectorLanes n = foreseen(met.face, normal_of_face, normal_of_vertex);

  const auto nf = Products::factor(n);
  const FastSupport<Doubles> of_round = fast_support<Products>(round, n, v);
  const BoxSupportLanes of_box = support_lanes(box, c, k, nf);
  const TwofoldLanes room = detail::arithmetic::renormalised(dot(nf, to) - (of_round.h + of_box.h));
  const TwofoldLanes approach = detail::arithmetic::renormalised(-dot(nf, along));
  const Doubles start = room.high / approach.high;
  const TwofoldLanes rest = room - Products::factor(start) * Products::factor(approach);
  const Doubles step = detail::arithmetic::rounded(rest) / approach.high;

  const Doubles vv = v.x * v.x + v.y * v.y, speed = abs(v.x) + abs(v.y), n_size = abs(n.x.high) + abs(n.y.high);
  const Doubles box_size = (box.hx.high + box.hy.high) * (abs(box.u.x.high) + abs(box.u.y.high));
  const Doubles error = of_round.error + Doubles(0x1p-48) * (box_size * speed);
  const Doubles sizes = (abs(d.x.high) + abs(d.y.high)) + speed * abs(start) + Doubles(0x1p48) * error / speed;
  const Doubles slope = abs(detail::arithmetic::rounded(w) - (of_round.beside + of_box.beside)) + error;
  const Doubles off = slope / of_round.bend, gain = Doubles(2.0) * slope * (off / vv), far_off = Doubles(64.0) * off;
  const Doubles lost = Doubles(0x1p-94) * n_size * sizes / approach.high + Doubles(0x1p-100) * abs(start);
  const CastMask at_face =
      both(slope<Doubles(1 - 0x1p-30) * of_box.edge, abs(forward)> Doubles(0x1p-40) * (n_size * speed));
  const CastMask on_x = either(box.hx.high == zero, far_off * abs(k.high) < abs(of_box.p));
  const CastMask on_y = either(box.hy.high == zero, far_off * abs(c.high) < abs(of_box.q));
  const CastMask at_vertex =
      both(both(gain <= Doubles(0x1p-74) * start, far_off * of_round.steepness < Doubles(1.0)), both(on_x, on_y));
  const CastMask known = either(both(met.face, at_face), and_not(at_vertex, met.face));
  return {{start, step},
          lost + select(met.face, zero, gain),
          both(known, sizes * (Doubles(0x1p-40) * n_size) < of_round.h.high),
          n,
          of_round.in_frame,
          met.face,
          met.lengthwise};
}

VESICA_KERNEL void cast_boxes_rounds(const CastColumns& columns, std::int32_t n, double* const* results) noexcept {
  const bool box_first = columns.b.round;
  const SideColumns &boxes = box_first ? columns.a : columns.b, &rounds = box_first ? columns.b : columns.a;
  for (std::int32_t i = 0; i < n; i += Doubles::width) {
    const WayLanes way = way_lanes(columns, i);
    const BoxLanes box = box_lanes(boxes, i);
    const EllipseLanes round = ellipse_lanes(rounds, i);
    const auto met = box_round_meeting(box, round, way.d, way.v);
    const Doubles nx = met.normal.x.high, ny = met.normal.y.high, zero(0.0);
    const FloorLanes floor = detail::cast::floor_of(met.time, met.error);
    CastMask settled =
        both(both(way.plain, both(met.certain, floor.certain)), both(is_plain_box(box), round.is_usual()));
    OffsetLanes at = round.out_of_frame(detail::cast::foremost_of(round.a, round.b, met.in_frame.x, met.in_frame.y));
    if (box_first) {
      const ForemostLanes of_box = foremost_lanes(box, nx, ny, met.face, negated<Doubles>(met.lengthwise));
      const OffsetLanes on_face = point_on_edge(of_box, {{-at.x, -at.y}, {zero, zero}, met.face},
                                                way.d.x.high + floor.t * way.v.x, way.d.y.high + floor.t * way.v.y);
      at = {select(met.face, on_face.x, of_box.middle.x), select(met.face, on_face.y, of_box.middle.y)};
      settled = both(settled, of_box.known);
    }
    store_impacts(columns, i, floor.t, at, nx, ny, settled, results);
  }
}

}  // namespace
}  // namespace vesica
