// SPDX-License-Identifier: Apache-2.0
/// How deep two boxes overlap, in closed form, for scalars and for lanes: the least depth along the four normals of
/// their faces. The Minkowski sum of two boxes, flat ones included, has no other face normals.
#pragma once

#include <vesica/support_minimum/box_faces.hpp>

namespace vesica::detail::depth {

using namespace support_minimum;

/// How far the second box has to move and along which unit vector. Where not settled, search.hpp answers.
template <class V>
struct BoxDepth {
  using Mask = decltype(V() < V());
  FastDoubleDouble<V> depth;
  V x, y;
  Mask settled;
};

/// A computed depth below this share of the sizes may stand for 0. Exact arithmetic decides.
inline constexpr double least_settled_depth = 0x1p-46;

/// True if the pair is to be exchanged, so that (a, b) and (b, a) do the same work. Boxes are ordered by their numbers,
/// and equal boxes by the sign of their offset.
template <class V>
VESICA_INLINE auto out_of_order(const BoxPair<V>& p) noexcept {
  using namespace lane;
  const V first[6] = {p.first.ux, p.first.uy, p.first.a, p.first.b, -p.d.x.high, -p.d.y.high};
  const V second[6] = {p.second.ux, p.second.uy, p.second.a, p.second.b, V(0.0), V(0.0)};
  auto greater = first[5] > second[5];
  for (int i = 4; i >= 0; --i) {
    greater = either(first[i] > second[i], and_not(greater, first[i] < second[i]));
  }
  return greater;
}

/// The depth along a face's normal. `told`: true if no other face is as near.
template <class V, class Mask>
VESICA_INLINE BoxDepth<V> depth_along(const Face<V>& face, const Reach<V>& best, const BoxPair<V>& given, Mask exchange,
                                      Mask told) noexcept {
  using namespace lane;
  const V one(1.0), zero(0.0), length = sqrt(face.x * face.x + face.y * face.y);
  // Towards the second box; where the centres lie level, the first in order counts as below the other.
  const V level = select(exchange, -one, one), side = select(best.offset == zero, level, best.offset);
  const V size = size_of(given);
  const auto clear = both(best.value.high > V(least_settled_depth) * size, large_enough(size));
  return {best.value, zero + flip_sign(face.x / length, side), zero + flip_sign(face.y / length, side),
          both(both(in_range(given), told), clear)};
}

/// For boxes that overlap. Finds the face in rounded arithmetic, then its depth to twice the precision. The normals of
/// parallel boxes are asked once.
template <class V>
VESICA_INLINE BoxDepth<V> box_box_depth(const BoxPair<V>& given) noexcept {
  using namespace lane;
  const V one(1.0), zero(0.0), huge(0x1p1000);
  const auto exchange = out_of_order(given);
  const Axes<V> a = choose(exchange, given.second, given.first), b = choose(exchange, given.first, given.second);
  const V cosine = a.ux * b.ux + a.uy * b.uy, sine = a.ux * b.uy - a.uy * b.ux;
  const auto parallel = either(cosine == zero, sine == zero);
  const Face<V> faces[4] = {along_face(a), across_face(a), along_face(b), across_face(b)};
  Face<V> face = faces[0];
  V least = rough_reach(face, b, given.d, one), next = huge;
  auto of_b = zero > zero;
  for (int i = 1; i < 4; ++i) {
    const V rough = rough_reach(faces[i], i < 2 ? b : a, given.d, one);
    const V depth = i < 2 ? rough : select(parallel, huge, rough);
    const auto less = depth < least;
    face = choose(less, faces[i], face);
    next = select(less, least, min(next, depth));
    least = select(less, depth, least);
    of_b = i < 2 ? of_b : either(of_b, less);
  }
  const auto told = next - least > V(rough_tie) * size_of(given);
  return depth_along(face, reach(face, choose(of_b, a, b), given.d, one), given, exchange, told);
}

/// The same where faces are as near, to rounding: all to twice the precision. exchange: as out_of_order() has it.
inline BoxDepth<double> box_box_depth_of_ties(const BoxPair<double>& given, bool exchange) noexcept {
  const Axes<double>&a = exchange ? given.second : given.first, &b = exchange ? given.first : given.second;
  const Face<double> faces[4] = {along_face(a), across_face(a), along_face(b), across_face(b)};
  int best = 0;
  Reach<double> least = called_reach(faces[0], b, given.d, 1.0);
  for (int i = 1; i < 4; ++i) {
    const Reach<double> found = called_reach(faces[i], i < 2 ? b : a, given.d, 1.0);
    if (!nearer(found, least)) continue;
    least = found;
    best = i;
  }
  return depth_along(faces[best], least, given, exchange, true);
}

}  // namespace vesica::detail::depth
