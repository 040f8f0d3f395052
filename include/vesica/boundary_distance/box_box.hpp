// SPDX-License-Identifier: Apache-2.0
/// The outlines of two boxes, one strictly inside the other, for scalars and for lanes.
#pragma once

#include <vesica/support_minimum/box_faces.hpp>

namespace vesica::detail::boundary_distance {

using namespace support_minimum;

/// The distance, and the closest points as offsets from the centres of their boxes. Where not settled, nested.hpp
/// answers.
template <class V>
struct NestedBoxes {
  using Mask = decltype(V() < V());
  FastDoubleDouble<V> distance;
  V outer_x, outer_y, inner_x, inner_y;
  Mask settled;
};

/// x limited to [-size, size], size >= 0.
template <class V>
VESICA_INLINE V limited(V x, V size) noexcept {
  using namespace lane;
  return max(min(x, size), -size);
}

/// From the face across the first box's axis, or the one along it. `told`: true if the other is farther.
template <class V, class Mask>
VESICA_INLINE NestedBoxes<V> nested_at(const BoxPair<V>& p, Mask take_across, const Reach<V>& found,
                                       Mask told) noexcept {
  using namespace lane;
  const V zero(0.0);
  const Axes<V>&outer = p.first, &inner = p.second;
  const Face<V> along = along_face(outer), across = across_face(outer), face = choose(take_across, across, along);
  const V nx = flip_sign(face.x, found.offset), ny = flip_sign(face.y, found.offset);
  const V s = flip_sign(inner.a, nx * inner.ux + ny * inner.uy), t = flip_sign(inner.b, ny * inner.ux - nx * inner.uy);
  const V x = s * inner.ux - t * inner.uy, y = s * inner.uy + t * inner.ux;
  // Its foot on the face, by the place along the face in units of the axis.
  const V level = (nx * (p.d.y.high + y) - ny * (p.d.x.high + x)) / (nx * nx + ny * ny);
  const V place = limited(level, select(take_across, along.own, across.own));
  const V size = size_of(p);
  const auto clear = both(found.value.high > V(0x1p-46) * size, large_enough(size));
  return {found.value, zero + (face.own * nx - place * ny), zero + (face.own * ny + place * nx), zero + x,
          zero + y,    both(both(in_range(p), told), clear)};
}

/// The second box lies strictly inside the first. The answer is its least distance from the first's faces:
/// only the two on the side of its centre count. The face is chosen in rounded arithmetic; its distance is then
/// computed in double-doubles.
template <class V>
VESICA_INLINE NestedBoxes<V> nested_boxes(const BoxPair<V>& p) noexcept {
  using namespace lane;
  const V minus(-1.0);
  const Face<V> along = along_face(p.first), across = across_face(p.first);
  const V of_along = rough_reach(along, p.second, p.d, minus), of_across = rough_reach(across, p.second, p.d, minus);
  const auto take_across = of_across < of_along;
  const Reach<V> found = reach(choose(take_across, across, along), p.second, p.d, minus);
  return nested_at(p, take_across, found, abs(of_across - of_along) > V(rough_tie) * size_of(p));
}

/// The same where two faces are as near, to rounding: both in double-doubles.
inline NestedBoxes<double> nested_boxes_of_ties(const BoxPair<double>& p) noexcept {
  const Reach<double> of_along = called_reach(along_face(p.first), p.second, p.d, -1.0);
  const Reach<double> of_across = called_reach(across_face(p.first), p.second, p.d, -1.0);
  const bool take_across = nearer(of_across, of_along);
  return nested_at(p, take_across, take_across ? of_across : of_along, true);
}

}  // namespace vesica::detail::boundary_distance
