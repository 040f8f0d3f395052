// SPDX-License-Identifier: Apache-2.0
/// The contact of a box with an ellipse, either of which moves, after a filter has decided that they meet: which vertex
/// or face of the box is met and along which normal, by the operations of direction.hpp, so that bits are the same. The
/// time is T(n), as in bound.hpp, rounded down.
#pragma once

#include <vesica/cast/quick_round_hit.hpp>

namespace vesica::detail::cast {

/// The floor of the time and the normal, against v and of any length, which is (p, q) in the ellipse's frame. `face`:
/// whether a side of the box is met, if so along its axis (`lengthwise`) or across it.
template <class V>
struct BoxRoundMeeting {
  Floor<V> floor;
  arithmetic::Vector<V> normal;
  OffsetOf<V> in_frame;
  MaskOf<V> face, lengthwise;
};

/// What a box adds to T(n): its support function, perp(v).x, and whether n is far enough from the normals of its sides
/// for a step of `off` in s. As of SideSupport.
template <class V>
struct BoxSupport {
  Twofold<V> h;
  V beside, edge;
  arithmetic::Vector<V> n;  // u.n and u x n
};
template <class Products, class V, class Normal>
VESICA_INLINE BoxSupport<V> box_support(const nearest::Box<V>& box, const Twofold<V>& c, const Twofold<V>& k,
                                        const Normal& n) noexcept {
  const V zero(0.0);
  const auto u = Products::factor(box.u);
  const Twofold<V> p = arithmetic::renormalised(dot(u, n)), q = arithmetic::renormalised(cross(u, n));
  const V hk = -(box.hx.high * k.high), hc = box.hy.high * c.high;
  const auto along = p.high == zero, across = q.high == zero;
  return {magnitude(Products::factor(box.hx) * Products::factor(p)) +
              magnitude(Products::factor(box.hy) * Products::factor(q)),
          select(along, zero, flip_sign(hk, p.high)) + select(across, zero, flip_sign(hc, q.high)),
          select(along, abs(hk), zero) + select(across, abs(hc), zero),
          {p, q}};
}

/// d: from the first's centre to the second's, v: the second's velocity; which of them is the box does not count.
///
/// Proved: what is certain is the time, and the normal is that of the general path, bit for bit.
///
///   - Feature and s are made by its operations. It takes a face's normal as it is, and the direction of s where the
///     gain is below 2^-70 t and certain (polished()): here below 2^-74 t, of a slope whose error counts 2^-48 of all
///     terms, where there it is 2^-96, and with 64 for its 8 and 3.
///   - T(n) is off by less than `lost`: lower_bound(). Of a face that the line passes by 2^-30 of its length at
///     least, T(n) is the time.
///
/// What is nearly across v is left open.
template <class Products, class V>
VESICA_INLINE BoxRoundMeeting<V> box_round_meeting(const nearest::Box<V>& box, const QuickEllipse<V>& round,
                                                   const arithmetic::Vector<V>& d, const OffsetOf<V>& v) noexcept {
  const V zero(0.0), one(1.0);
  const auto along = plain_factor<Products>(v.x, v.y);
  const auto to = Products::factor(d), u = Products::factor(box.u);
  const Twofold<V> w = cross(along, to), c = dot(u, along), k = cross(u, along);
  const CurveOf<V> curve = round.curve(v);
  const Feature<V> met = feature<Products>(box, c, k, w, curve);
  // Of a face.
  const V fx = select(met.lengthwise, box.u.x.high, -box.u.y.high), fy = select(met.lengthwise, box.u.y.high, box.u.x.high);
  const V forward = fx * v.x + fy * v.y, speed = abs(v.x) + abs(v.y);
  const auto normal_of_face = [&]() -> arithmetic::Vector<V> {
    return {flipped(choose(met.lengthwise, box.u.x, -box.u.y), -forward),
            flipped(choose(met.lengthwise, box.u.y, box.u.x), -forward)};
  };
  // Of a vertex.
  const auto normal_of_vertex = [&] {
    const Twofold<V> beside = arithmetic::renormalised(met.w);
    return normal_of<Products>(maximum_of_one(curve, beside.high, gap_of(round.template reach<Products>(v), beside)), v);
  };
  const arithmetic::Vector<V> n = foreseen(met.face, normal_of_face, normal_of_vertex);

  const auto nf = Products::factor(n);
  const QuickSupport<V> e = quick_support<Products>(round, n, v);
  const BoxSupport<V> b = box_support<Products>(box, c, k, nf);
  const Twofold<V> room = arithmetic::renormalised(dot(nf, to) - (e.h + b.h));
  const Twofold<V> approach = arithmetic::renormalised(-dot(nf, along));
  const V start = room.high / approach.high;
  const Twofold<V> rest = room - Products::factor(start) * Products::factor(approach);
  const V step = arithmetic::rounded(rest) / approach.high;
  const V n_size = abs(n.x.high) + abs(n.y.high), box_size = (box.hx.high + box.hy.high) * (abs(box.u.x.high) + abs(box.u.y.high));
  const V error = e.error + V(0x1p-48) * (box_size * speed);
  const V sizes = (abs(d.x.high) + abs(d.y.high)) + speed * abs(start) + V(0x1p48) * error / speed;
  const V slope = abs(arithmetic::rounded(w) - (e.beside + b.beside)) + error, off = slope / e.bend;
  const V vv = v.x * v.x + v.y * v.y, gain = V(2.0) * slope * (off / vv);
  const V lost = V(0x1p-94) * n_size * sizes / approach.high + V(0x1p-100) * abs(start);
  const V turn = V(64.0) * off;
  const auto within_face = both(slope < V(1 - 0x1p-30) * b.edge, abs(forward) > V(0x1p-40) * (n_size * speed));
  const auto beside_x = either(box.hx.high == zero, turn * abs(k.high) < abs(b.n.x.high));
  const auto beside_y = either(box.hy.high == zero, turn * abs(c.high) < abs(b.n.y.high));
  const auto at_vertex = both(both(gain <= V(0x1p-74) * start, turn * e.steepness < one), both(beside_x, beside_y));
  Floor<V> floor = floor_of(Twofold<V>{start, step}, lost + select(met.face, zero, gain));
  const auto known = either(both(met.face, within_face), and_not(at_vertex, met.face));
  floor.certain = both(both(floor.certain, known), sizes * (V(0x1p-40) * n_size) < e.h.high);
  return {floor, n, e.in_frame, met.face, met.lengthwise};
}

}  // namespace vesica::detail::cast
