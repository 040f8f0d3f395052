// SPDX-License-Identifier: Apache-2.0
/// Two disjoint boxes: a vertex of one against the other, in closed form.
///
/// Four candidates suffice: for each of the four axes, the vertex of the other box that reaches farthest towards the
/// box whose axis it is. To see this, let n be the normal along which the boxes are farthest apart. Either n is a
/// face's normal; then the other box's farthest vertex lies above that face. Or the shortest connection leads from
/// vertex to vertex; then n lies between two neighbouring face normals of the eight, and for both the
/// farthest vertex of the other box is one of the two vertices.
#pragma once

#include <vesica/nearest/direction.hpp>
#include <vesica/nearest/point_box.hpp>

namespace vesica::detail::nearest {

/// A vertex (signs i, j of its box's half extents) and how far, squared, it is from the other box.
template <class V>
struct VertexCandidate {
  V i, j, squared;
};

/// One of the two axes of a box, and the vertex of another, which lies at k in its frame: hx, hy its half sizes, c and
/// s the dot and cross product of the box's axis with the other's. `across`: the axis is perp(u). A vertex is chosen by
/// exact signs; where an edge is parallel to the face, the end nearer the box's middle.
template <class V>
VESICA_INLINE VertexCandidate<V> farthest_vertex(V kx, V ky, V c, V s, V hx, V hy, V ex, V ey, bool across) noexcept {
  const V zero(0.0), one(1.0);
  // The vertex is k + i hx (c, s) + j hy (-s, c); towards the face means against k's sign along the axis.
  const V along = across ? ky : kx, beside = across ? kx : ky;
  const V first = across ? s : c, first_beside = across ? c : s;
  const V second = across ? c : -s, second_beside = across ? -s : c;
  const auto pick = [&](V step, V step_beside) {
    const V towards = flip_sign(flip_sign(-one, along), step),
            inwards = flip_sign(flip_sign(-one, beside), step_beside);
    return select(step == zero, inwards, towards);
  };
  const V i = pick(first, first_beside), j = pick(second, second_beside);
  const V x = positive_part(abs((kx + i * (hx * c)) - j * (hy * s)) - ex);
  const V y = positive_part(abs((ky + i * (hx * s)) + j * (hy * c)) - ey);
  return {i, j, x * x + y * y};
}

template <class V>
VESICA_INLINE VertexCandidate<V> nearer(const VertexCandidate<V>& a, const VertexCandidate<V>& b) noexcept {
  const auto first = a.squared <= b.squared;
  return {select(first, a.i, b.i), select(first, a.j, b.j), select(first, a.squared, b.squared)};
}

template <class V>
VESICA_INLINE Box<V> choose(MaskOf<V> m, const Box<V>& yes, const Box<V>& no) noexcept {
  return {{choose(m, yes.u.x, no.u.x), choose(m, yes.u.y, no.u.y)}, choose(m, yes.hx, no.hx), choose(m, yes.hy, no.hy)};
}

/// i hx u + j hy perp(u), i and j being 1 or -1.
template <class V>
VESICA_INLINE Vector<V> vertex(const Box<V>& box, V i, V j) noexcept {
  const auto u = factor(box.u);
  const auto s = factor(flipped(box.hx, i)), t = factor(flipped(box.hy, j));
  return {s * u.x - t * u.y, s * u.y + t * u.x};
}

/// From a box to a point outside, as a vector of any length.
template <class V>
VESICA_INLINE Direction<V> out_of(const Box<V>& box, const PointBox<V>& p) noexcept {
  const V x = flip_sign(p.nx, p.spot.s), y = flip_sign(p.ny, p.spot.t), ux = box.u.x.high, uy = box.u.y.high;
  return {x * ux - y * uy, x * uy + y * ux};
}

/// The result for two disjoint boxes: the distance, the closest points by their places, and a vector from a to b of any
/// length.
template <class V>
struct BoxBox {
  Twofold<V> distance;
  Spot<V> a, b;
  V nx, ny;
  MaskOf<V> settled;
};

template <class V>
VESICA_INLINE BoxBox<V> choose(MaskOf<V> m, const BoxBox<V>& yes, const BoxBox<V>& no, MaskOf<V> settled) noexcept {
  return {choose(m, yes.distance, no.distance),
          {select(m, yes.a.s, no.a.s), select(m, yes.a.t, no.a.t)},
          {select(m, yes.b.s, no.b.s), select(m, yes.b.t, no.b.t)},
          select(m, yes.nx, no.nx),
          select(m, yes.ny, no.ny),
          settled};
}

template <class V>
VESICA_INLINE Vector<V> flipped(const Vector<V>& d, V sign) noexcept {
  return {flipped(d.x, sign), flipped(d.y, sign)};
}

/// The distance between two disjoint boxes, d from a's centre to b's.
///
/// The best candidate by plain arithmetic is evaluated in twice the precision, and then checked. If its vertex lies
/// above a face, exact signs chose it as the farthest along that face's normal. If it faces a vertex, no edge at either
/// vertex may lead towards the other box. Ties within rounding may fail this check; then the answer is not settled.
template <class V>
VESICA_INLINE BoxBox<V> box_box(const Box<V>& a, const Box<V>& b, const Vector<V>& d) noexcept {
  const V zero(0.0), one(1.0);
  const auto ordered = in_order(d.x.high, d.y.high);
  const Box<V> first = choose(ordered, a, b), second = choose(ordered, b, a);
  // Zeros lose their sign: signs choose between vertices below.
  const Vector<V> turned_offset = flipped(d, select(ordered, one, -one));
  const Vector<V> offset{turned_offset.x + Twofold<V>{zero, zero}, turned_offset.y + Twofold<V>{zero, zero}};

  const auto u = factor(first.u), w = factor(second.u);
  const V c = rounded(dot(u, w)), s = rounded(cross(u, w));
  const V ux = first.u.x.high, uy = first.u.y.high, wx = second.u.x.high, wy = second.u.y.high;
  const V uu = ux * ux + uy * uy, ww = wx * wx + wy * wy, dx = offset.x.high, dy = offset.y.high;
  const V hx = first.hx.high, hy = first.hy.high, gx = second.hx.high, gy = second.hy.high;
  const V kx = ux * dx + uy * dy, ky = ux * dy - uy * dx, lx = -(wx * dx + wy * dy), ly = wy * dx - wx * dy;
  const auto of_second = nearer(farthest_vertex(kx, ky, c, s, gx, gy, hx * uu, hy * uu, false),
                                farthest_vertex(kx, ky, c, s, gx, gy, hx * uu, hy * uu, true));
  const auto of_first = nearer(farthest_vertex(lx, ly, c, -s, hx, hy, gx * ww, gy * ww, false),
                               farthest_vertex(lx, ly, c, -s, hx, hy, gx * ww, gy * ww, true));

  const auto faces_first = of_second.squared * ww <= of_first.squared * uu;
  const V i = select(faces_first, of_second.i, of_first.i), j = select(faces_first, of_second.j, of_first.j);
  const Box<V> face = choose(faces_first, first, second), corner = choose(faces_first, second, first);
  const Vector<V> p = flipped(offset, select(faces_first, one, -one)) + vertex(corner, i, j);
  const PointBox<V> found = point_box(face, p);

  // From the face's box to the vertex, in the face's frame; then along the edges that leave the vertex.
  const V nx = flip_sign(found.nx, found.spot.s), ny = flip_sign(found.ny, found.spot.t);
  const V turn = select(faces_first, s, -s);
  const V back_x = i * (nx * c + ny * turn), back_y = j * (ny * c - nx * turn);
  const auto proved =
      both(either(back_x <= zero, corner.hx.high == zero), either(back_y <= zero, corner.hy.high == zero));
  const Spot<V> place{i * corner.hx.high, j * corner.hy.high};
  const auto face_is_a = either(both(faces_first, ordered), negated<V>(either(faces_first, ordered)));
  const Direction<V> out = out_of(face, found);
  const BoxBox<V> as_a{found.distance, found.spot, place, out.x, out.y, found.settled};
  const BoxBox<V> as_b{found.distance, place, found.spot, -out.x, -out.y, found.settled};
  return choose(face_is_a, as_a, as_b, both(found.settled, proved));
}

}  // namespace vesica::detail::nearest
