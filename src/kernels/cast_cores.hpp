// SPDX-License-Identifier: Apache-2.0
// First contacts of capsules and rounded rectangles with each other, boxes, circles and points; either may move. Each
// shape is a core, which is a box or a point, with a radius. The sum M is that of both cores and the disc of both
// radii. The face or vertex and the normal are found by the operations of detail::cast::latest_with_radius(): so their
// bits are those of single casts. The time is T(n) of bound.hpp, whose bounds are computed in double.
#pragma once

#include "kernels/cast_boxes_rounds.hpp"

namespace vesica {
namespace {

/// A shape as a core and a radius. `sized`: its kind's core is no point; `flat`: it is a segment, whose hy is 0.
struct CoreLanes {
  BoxLanes box;
  Doubles radius;
  bool sized, flat;

  VESICA_INLINE Doubles reach() const noexcept { return sized ? reach_of(box) : Doubles(0.0); }
};
VESICA_INLINE CoreLanes core_lanes(const SideColumns& side, std::int32_t i) noexcept {
  const Doubles none(0.0), radius = side.has_radius ? load(side.radius, i) : side.disc ? load(side.hx.to, i) : none;
  CoreLanes out{{}, radius, !side.is_point && !side.disc, side.is_flat};
  if (out.sized) out.box = box_lanes(side, i);
  return out;
}

/// True where the single cast has the same core: a shape without a radius or a size is of another kind there.
VESICA_INLINE CastMask is_plain_core(const CoreLanes& core, const SideColumns& side) noexcept {
  const Doubles zero(0.0);
  CastMask out = zero <= zero;
  if (core.sized) out = is_plain_box(core.box);
  if (side.has_radius) out = both(out, both(is_plain_size(core.radius), negated<Doubles>(has_no_size(core.box))));
  return out;
}

/// detail::cast::Kink. `face`: the number of the face, two for each box. A face without a length comes last.
struct KinkLanes {
  Doubles s;
  TwofoldLanes slope;
  Doubles face;
};
/// The kinks of two boxes by s; those of equal s keep their order.
struct KinksLanes {
  KinkLanes kink[4];
  int count = 0;

  VESICA_INLINE void add(const TwofoldLanes& slope, Doubles along, Doubles across, int face) noexcept {
    const Doubles zero(0.0);
    const CastMask none = either(detail::cast::is_zero(slope), across == zero);
    const TwofoldLanes nothing{zero, zero};
    kink[count] = {select(none, Doubles(0x1p600), along / across),
                   choose(none, nothing, detail::cast::magnitude(slope)), Doubles(1.0 * face)};
    for (int at = count++; at > 0; --at) {
      KinkLanes &first = kink[at - 1], &second = kink[at];
      const CastMask swap = first.s > second.s;
      const KinkLanes former = first;
      first = chosen(swap, second, former);
      second = chosen(swap, former, second);
    }
  }
  /// w without the slopes, so many of them taken away and the others added.
  VESICA_INLINE TwofoldLanes left_over(const TwofoldLanes& w, int passed) const noexcept {
    TwofoldLanes sum = w;
    for (int i = 0; i < count; ++i) sum = i < passed ? sum - kink[i].slope : sum + kink[i].slope;
    return renormalised(sum);
  }

 private:
  VESICA_INLINE static KinkLanes chosen(CastMask mask, const KinkLanes& yes, const KinkLanes& no) noexcept {
    return {select(mask, yes.s, no.s), choose(mask, yes.slope, no.slope), select(mask, yes.face, no.face)};
  }
};

/// A core's u.v and u x v.
struct TurnedLanes {
  TwofoldLanes c, k;
};

/// The disc's terms of detail::cast::FastSupport.
struct DiscSupportLanes {
  TwofoldLanes h;
  Doubles beside, bend, steepness;
};
VESICA_INLINE DiscSupportLanes support_lanes(const TwofoldLanes& radius, const VectorLanes& n,
                                             const OffsetLanes& v) noexcept {
  using P = LaneProducts;
  const auto length = P::root(square(P::factor(n.x)) + square(P::factor(n.y)));
  const Doubles vv = v.x * v.x + v.y * v.y, over = length.inverse, by = vv * over;
  return {P::factor(radius) * P::factor(renormalised(length.value)),
          radius.high * (n.y.high * v.x - n.x.high * v.y) * over, radius.high * (by * by * over), sqrt(vv) * over};
}

/// The time and the normal, as in BoxRoundMeeting. If a face is met, it is one of a, of b, or of both where they are
/// parallel; its normal is the axis u, or perp(u) if `across`.
struct CoresMeeting {
  TwofoldLanes time;
  Doubles error;
  CastMask certain;
  VectorLanes normal;
  CastMask of_a, of_b, across;
};

/// d: from the first's centre to the second's; v: the second's velocity. All numbers that are multiplied are 0 or
/// moderate (is_plain()). Certain for the reasons that box_round_meeting() proves: two boxes take fewer than 32
/// roundings, which leave the slope off by less than 2^-48 of the reaches across v, too.
VESICA_INLINE CoresMeeting cores_meeting(const CoreLanes& a, const CoreLanes& b, const VectorLanes& d,
                                         const OffsetLanes& v) noexcept {
  using namespace detail::cast;
  using P = LaneProducts;
  const Doubles zero(0.0), vv = v.x * v.x + v.y * v.y;
  const CastMask none = zero < zero;
  const auto along = plain_factor<P>(v.x, v.y);
  const auto to = P::factor(d);
  const TwofoldLanes w = renormalised(cross(along, to)), radius = exact_sum(a.radius, b.radius);
  KinksLanes kinks;
  TurnedLanes of_v[2];
  for (int i = 0; i < 2; ++i) {
    const CoreLanes& core = i == 0 ? a : b;
    if (!core.sized) continue;
    const auto u = P::factor(core.box.u);
    const TwofoldLanes c = renormalised(dot(u, along)), k = renormalised(cross(u, along));
    of_v[i] = {c, k};
    kinks.add(P::factor(core.box.hx) * P::factor(k), -c.high, k.high, 2 * i);
    if (!core.flat) kinks.add(P::factor(core.box.hy) * P::factor(c), k.high, c.high, 2 * i + 1);
  }

  const Doubles r = radius.high, al = (r * v.y) * (r * v.y) + (r * v.x) * (r * v.x), area = r * r * vv;
  const CurveOf<Doubles> disc{zero, al, area * area / al, sqrt(al)};
  TwofoldLanes rest = kinks.left_over(w, 0);
  CastMask on_face = none, done = none;
  Doubles face = zero;
  for (int i = 0; i < kinks.count; ++i) {
    const KinkLanes& kink = kinks.kink[i];
    const Doubles slope = disc.slope(kink.s);
    const TwofoldLanes next = kinks.left_over(w, i + 1);
    done = either(done, rest.high < slope);
    const CastMask here = and_not(and_not(next.high <= slope, detail::cast::is_zero(kink.slope)), done);
    on_face = either(on_face, here);
    done = either(done, here);
    face = select(here, kink.face, face);
    rest = choose(done, rest, next);
  }
  const TwofoldLanes reach =
      detail::cast::reach_of<P>(P::factor(radius) * P::factor(v.y), P::factor(radius) * P::factor(v.x));
  VectorLanes n = normal_of<P>(maximum_of_one(disc, rest.high, gap_of(reach, rest)), v);
  CoresMeeting out;
  const CastMask second = face >= Doubles(2.0);
  out.across = both(on_face, either(face == zero, face == Doubles(2.0)));
  const VectorLanes &ua = a.sized ? a.box.u : b.box.u, &ub = b.sized ? b.box.u : a.box.u;
  const VectorLanes axis{choose(second, ub.x, ua.x), choose(second, ub.y, ua.y)};
  const VectorLanes of_face{choose(out.across, -axis.y, axis.x), choose(out.across, axis.x, axis.y)};
  const Doubles forward = of_face.x.high * v.x + of_face.y.high * v.y;
  n = {choose(on_face, flipped(of_face.x, -forward), n.x), choose(on_face, flipped(of_face.y, -forward), n.y)};
  const CastMask parallel = same_vector(ua, ub);
  out.of_a = both(on_face, either(parallel, negated<Doubles>(second)));
  out.of_b = both(on_face, either(parallel, second));

  const auto nf = P::factor(n);
  const DiscSupportLanes of_disc = support_lanes(radius, n, v);
  const BoxSupportLanes nothing{{zero, zero}, zero, zero, zero, zero};
  const BoxSupportLanes of_box[2] = {a.sized ? support_lanes(a.box, of_v[0].c, of_v[0].k, nf) : nothing,
                                     b.sized ? support_lanes(b.box, of_v[1].c, of_v[1].k, nf) : nothing};
  const TwofoldLanes height = of_disc.h + of_box[0].h + of_box[1].h;
  const TwofoldLanes room = renormalised(dot(nf, to) - height), approach = renormalised(-dot(nf, along));
  const Doubles start = room.high / approach.high;
  const TwofoldLanes left = room - P::factor(start) * P::factor(approach);
  const Doubles step = detail::arithmetic::rounded(left) / approach.high;

  const Doubles speed = abs(v.x) + abs(v.y), n_size = length_of(n), sum = a.reach() + b.reach() + Doubles(2.0) * r;
  const Doubles error = Doubles(0x1p-48) * (sum * speed), edge = of_box[0].edge + of_box[1].edge;
  const Doubles sizes = length_of(d) + speed * abs(start) + sum;
  const Doubles beside = of_disc.beside + (of_box[0].beside + of_box[1].beside);
  const Doubles slope = abs(detail::arithmetic::rounded(w) - beside) + error;
  const Doubles off = slope / of_disc.bend, gain = Doubles(2.0) * slope * (off / vv), far_off = Doubles(64.0) * off;
  const Doubles lost = Doubles(0x1p-94) * n_size * sizes / approach.high + Doubles(0x1p-100) * abs(start);
  const CastMask at_face = both(slope<Doubles(1 - 0x1p-30) * edge, abs(forward)> Doubles(0x1p-40) * (n_size * speed));
  CastMask at_vertex = both(gain <= Doubles(0x1p-74) * start, far_off * of_disc.steepness < Doubles(1.0));
  for (int i = 0; i < 2; ++i) {
    const CoreLanes& core = i == 0 ? a : b;
    if (!core.sized) continue;
    const BoxSupportLanes& s = of_box[i];
    at_vertex = both(at_vertex, either(core.box.hx.high == zero, far_off * abs(of_v[i].k.high) < abs(s.p)));
    at_vertex = both(at_vertex, either(core.box.hy.high == zero, far_off * abs(of_v[i].c.high) < abs(s.q)));
  }
  out.time = {start, step};
  out.error = lost + select(on_face, zero, gain);
  out.certain = both(either(both(on_face, at_face), and_not(at_vertex, on_face)),
                     sizes * (Doubles(0x1p-40) * n_size) < of_disc.h.high);
  out.normal = n;
  return out;
}

VESICA_KERNEL void cast_cores(const CastColumns& columns, std::int32_t n, double* const* results) noexcept {
  const Doubles zero(0.0);
  const ForemostLanes point{{zero, zero}, {zero, zero}, zero <= zero};
  for (std::int32_t i = 0; i < n; i += Doubles::width) {
    const WayLanes way = way_lanes(columns, i);
    const CoreLanes a = core_lanes(columns.a, i), b = core_lanes(columns.b, i);
    const CoresMeeting met = cores_meeting(a, b, way.d, way.v);
    const FloorLanes floor = detail::cast::floor_of(met.time, met.error);
    const Doubles nx = met.normal.x.high, ny = met.normal.y.high, length = sqrt(nx * nx + ny * ny);
    const ForemostLanes of_a = a.sized ? foremost_lanes(a.box, nx, ny, met.of_a, met.across) : point;
    const ForemostLanes of_b = b.sized ? foremost_lanes(b.box, -nx, -ny, met.of_b, met.across) : point;
    const CastMask is_edge = either(abs(of_a.half.x) > zero, abs(of_a.half.y) > zero);
    const OffsetLanes on_edge =
        point_on_edge(of_a, of_b, way.d.x.high + floor.t * way.v.x, way.d.y.high + floor.t * way.v.y);
    const OffsetLanes at{select(is_edge, on_edge.x, of_a.middle.x) + a.radius * (nx / length),
                         select(is_edge, on_edge.y, of_a.middle.y) + a.radius * (ny / length)};
    const CastMask known = both(of_a.known, either(of_b.known, negated<Doubles>(is_edge)));
    const CastMask plain = both(way.plain, both(is_plain_core(a, columns.a), is_plain_core(b, columns.b)));
    store_impacts(columns, i, floor.t, at, nx, ny, both(both(plain, known), both(met.certain, floor.certain)), results);
  }
}

}  // namespace
}  // namespace vesica
