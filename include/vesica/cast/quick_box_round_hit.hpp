// SPDX-License-Identifier: Apache-2.0
/// The contact of a box with a round shape, either of which moves, after a filter has decided that they meet. Which
/// vertex or face of the box is met, and along which normal, is found by the operations of direction.hpp, so that the
/// bits are those of the general path. The time is T(n) of bound.hpp, whose bounds are computed in double.
///
/// Templates on V serve scalars and SIMD lanes: V is double or lanes of it.
#pragma once

#include <vesica/cast/quick_round_hit.hpp>

namespace vesica::detail::cast {

/// A box's support as in SideSupport. Only h is a twofold, the other numbers are double; p = u.n, q = u x n.
template <class V>
struct QuickBoxSupport {
  Twofold<V> h;
  V beside, edge, p, q;
};
/// c = u.v, k = u x v.
template <class Products, class V, class Normal>
VESICA_INLINE QuickBoxSupport<V> quick_support(const nearest::Box<V>& box, const Twofold<V>& c, const Twofold<V>& k,
                                               const Normal& n) noexcept {
  const V zero(0.0), hk = -(box.hx.high * k.high), hc = box.hy.high * c.high;
  const auto u = Products::factor(box.u);
  const Twofold<V> p = arithmetic::renormalised(dot(u, n)), q = arithmetic::renormalised(cross(u, n));
  const Twofold<V> hp = Products::factor(box.hx) * Products::factor(p),
                   hq = Products::factor(box.hy) * Products::factor(q);
  const MaskOf<V> no_p = p.high == zero, no_q = q.high == zero;
  return {magnitude(hp) + magnitude(hq),
          select(no_p, zero, flip_sign(hk, p.high)) + select(no_q, zero, flip_sign(hc, q.high)),
          select(no_p, abs(hk), zero) + select(no_q, abs(hc), zero), p.high, q.high};
}

/// The time, how far it may be off, and whether that and the normal are certain. The normal is against v and of any
/// length, in the round shape's frame it is (p, q). `face`: it is that of a face of the box, along its axis
/// (`lengthwise`) or across that.
template <class V>
struct BoxRoundMeeting {
  Twofold<V> time;
  V error;
  MaskOf<V> certain;
  arithmetic::Vector<V> normal;
  OffsetOf<V> in_frame;
  MaskOf<V> face, lengthwise;
};

/// d: from the first's centre to the second's; v: the second's velocity. Which of them is the box does not count. All
/// numbers that are multiplied are 0 or moderate (is_plain()), and the round shape is_usual().
///
/// Proved: where it is certain, the time is off by less than `error`, and the normal is that of the general path.
///
///   - T(n) is off by `lost`, as lower_bound() has it but for a factor of 8.
///   - The slope that is left is off by less than 2^-48 of the reaches across v. There are fewer than 16 roundings,
///     and of a line that meets the sum of both |w| is no greater than these.
///   - The normal of a face is exact. If the line passes its ends by 2^-30 of it at least, T(n) is the time.
///   - At a vertex `gain` is what bound.hpp allows for, and its conditions hold with 64 for its 8 and 3.
///   - So polished() stops where it begins: by its own, smaller errors the gain is below 2^-70 t, too. They are smaller
///     where all lengths are below 2^40 of the round shape's reach along n.
///
/// What is nearly across v is left open.
template <class Products, class V>
VESICA_INLINE BoxRoundMeeting<V> box_round_meeting(const nearest::Box<V>& box, const QuickEllipse<V>& round,
                                                   const arithmetic::Vector<V>& d, const OffsetOf<V>& v) noexcept {
  const V zero(0.0);
  const auto along = plain_factor<Products>(v.x, v.y);
  const auto to = Products::factor(d), u = Products::factor(box.u);
  const Twofold<V> w = cross(along, to), c = dot(u, along), k = cross(u, along);
  const Feature<V> met = feature<Products>(box, c, k, w, round.curve(v));
  const arithmetic::Vector<V> of_face{choose(met.lengthwise, box.u.x, -box.u.y),
                                      choose(met.lengthwise, box.u.y, box.u.x)};
  const V forward = of_face.x.high * v.x + of_face.y.high * v.y;
  const auto normal_of_face = [&]() -> arithmetic::Vector<V> {
    return {flipped(of_face.x, -forward), flipped(of_face.y, -forward)};
  };
  const auto normal_of_vertex = [&] {
    const Twofold<V> at = arithmetic::renormalised(met.w);
    return normal_of<Products>(maximum_of_one(round.curve(v), at.high, gap_of(round.template reach<Products>(v), at)),
                               v);
  };
  const arithmetic::Vector<V> n = foreseen(met.face, normal_of_face, normal_of_vertex);

  const auto nf = Products::factor(n);
  const QuickSupport<V> of_round = quick_support<Products>(round, n, v);
  const QuickBoxSupport<V> of_box = quick_support<Products>(box, c, k, nf);
  const Twofold<V> room = arithmetic::renormalised(dot(nf, to) - (of_round.h + of_box.h));
  const Twofold<V> approach = arithmetic::renormalised(-dot(nf, along));
  const V start = room.high / approach.high;
  const Twofold<V> rest = room - Products::factor(start) * Products::factor(approach);
  const V step = arithmetic::rounded(rest) / approach.high;

  const V vv = v.x * v.x + v.y * v.y, speed = abs(v.x) + abs(v.y), n_size = abs(n.x.high) + abs(n.y.high);
  const V box_size = (box.hx.high + box.hy.high) * (abs(box.u.x.high) + abs(box.u.y.high));
  const V error = of_round.error + V(0x1p-48) * (box_size * speed);
  const V sizes = (abs(d.x.high) + abs(d.y.high)) + speed * abs(start) + V(0x1p48) * error / speed;
  const V slope = abs(arithmetic::rounded(w) - (of_round.beside + of_box.beside)) + error;
  const V off = slope / of_round.bend, gain = V(2.0) * slope * (off / vv), far_off = V(64.0) * off;
  const V lost = V(0x1p-94) * n_size * sizes / approach.high + V(0x1p-100) * abs(start);
  const MaskOf<V> at_face = both(slope<V(1 - 0x1p-30) * of_box.edge, abs(forward)> V(0x1p-40) * (n_size * speed));
  const MaskOf<V> on_x = either(box.hx.high == zero, far_off * abs(k.high) < abs(of_box.p));
  const MaskOf<V> on_y = either(box.hy.high == zero, far_off * abs(c.high) < abs(of_box.q));
  const MaskOf<V> at_vertex =
      both(both(gain <= V(0x1p-74) * start, far_off * of_round.steepness < V(1.0)), both(on_x, on_y));
  const MaskOf<V> known = either(both(met.face, at_face), and_not(at_vertex, met.face));
  return {{start, step},
          lost + select(met.face, zero, gain),
          both(known, sizes * (V(0x1p-40) * n_size) < of_round.h.high),
          n,
          of_round.in_frame,
          met.face,
          met.lengthwise};
}

inline bool is_box_and_round(const Scene& scene) noexcept {
  return scene.a.round != scene.b.round && !has_no_size(scene.a) && !has_no_size(scene.b);
}
/// find_meeting() by the way above, in a scene that is_box_and_round() and has_fused_products(). False where that does
/// not tell.
template <class Products>
VESICA_INLINE bool quick_meeting(const Scene& scene, Meeting& out) noexcept {
  const Side &box = scene.a.round ? scene.b : scene.a, &e = scene.a.round ? scene.a : scene.b;
  const QuickEllipse<double> round{e.u.x.high, e.u.y.high, e.hx.high, e.hy.high};
  if (!round.is_usual()) return false;
  const auto met = box_round_meeting<Products>(nearest::Box<double>{box.u, box.hx, box.hy}, round, scene.d,
                                               Offset{scene.vx, scene.vy});
  if (!met.certain) return false;
  out.found = {met.normal, {met.time, met.error, 0, 0, true}};
  const Offset at = round.out_of_frame(foremost_of(round.a, round.b, met.in_frame.x, met.in_frame.y));
  if (scene.a.round) {
    out.of_a = {at, {0, 0}};
  } else {
    const Vector normal = settled(box, met.normal);
    out.of_a = foremost<Products>(box, normal);
    out.of_b = met.face ? Foremost{{-at.x, -at.y}, {0, 0}} : foremost<Products>(e, opposite(normal));
  }
  return true;
}

/// find_meeting() by fused products, quickly where it can be, or null where the processor has none.
#if defined(VESICA_HAS_FUSED)
VESICA_INLINE bool find_meeting_quickly(const Scene& scene, Meeting& out) noexcept {
  return (is_box_and_round(scene) && quick_meeting<FusedProducts>(scene, out)) ||
         find_meeting<FusedProducts>(scene, out);
}
inline constexpr FindMeeting fused_meeting = find_meeting_quickly;
#else
inline constexpr FindMeeting fused_meeting = nullptr;
#endif

}  // namespace vesica::detail::cast
