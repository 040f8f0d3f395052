// SPDX-License-Identifier: Apache-2.0
/// How far the second of two boxes reaches beyond the faces of the first, for scalars and for lanes.
#pragma once

#include <vesica/shapes.hpp>
#include <vesica/support_minimum/double_double_vector.hpp>
#include <vesica/support_minimum/from_nearest.hpp>

namespace vesica::detail::support_minimum {

/// Two boxes by axis and half extents, and the offset from the first centre to the second.
template <class V>
struct BoxPair {
  Axes<V> first, second;
  DoubleDoubleVector<V> d;
};

template <class V>
VESICA_INLINE BoxPair<V> box_pair(const Rect<V>& a, const Rect<V>& b) noexcept {
  return {{a.ux, a.uy, a.hx, a.hy}, {b.ux, b.uy, b.hx, b.hy}, {sum(b.cx, -a.cx), sum(b.cy, -a.cy)}};
}

/// For a face's normal N = (x, y), an axis of its box and so of any length: h |N| + sign g |N| - |n.D| |N|,
/// h the box's own half extent `own` along N and g the other box's.
template <class V>
struct Face {
  V x, y, own;
};

/// That over |N|, rounded: for comparing faces. Off by at most 10u of the pair's scale.
template <class V>
VESICA_INLINE V rough_reach(const Face<V>& f, const Axes<V>& other, const DoubleDoubleVector<V>& d, V sign) noexcept {
  using namespace lane;
  const V nn = f.x * f.x + f.y * f.y;
  const V along = abs(f.x * other.ux + f.y * other.uy), across = abs(f.x * other.uy - f.y * other.ux);
  const V apart = abs(f.x * d.x.high + f.y * d.y.high);
  return ((f.own * nn + sign * (other.a * along + other.b * across)) - apart) / sqrt(nn);
}

/// Faces whose rough reaches differ by no more than this share of the sizes are as near, to rounding.
inline constexpr double rough_tie = 0x1p-48;

/// The same to twice the precision, and n.D |N|, whose sign says on which side of the first box the second lies.
template <class V>
struct Reach {
  FastDoubleDouble<V> value;
  V offset;
};

template <class V>
VESICA_INLINE Reach<V> reach(const Face<V>& f, const Axes<V>& other, const DoubleDoubleVector<V>& d, V sign) noexcept {
  using namespace lane;
  const FastDoubleDouble<V> nn = dot(f.x, f.y, f.x, f.y), apart = dot(f.x, f.y, d);
  const FastDoubleDouble<V> along = magnitude(dot(f.x, f.y, other.ux, other.uy)) * other.a;
  const FastDoubleDouble<V> across = magnitude(cross(f.x, f.y, other.ux, other.uy)) * other.b;
  const FastDoubleDouble<V> all = (nn * f.own + (along + across) * sign) - magnitude(apart);
  return {quotient_by_root(all, nn), rounded(apart)};
}

/// The same as a call, which is shorter.
VESICA_COLD inline Reach<double> called_reach(const Face<double>& f, const Axes<double>& other,
                                              const DoubleDoubleVector<double>& d, double sign) noexcept {
  return reach(f, other, d, sign);
}

inline bool nearer(const Reach<double>& x, const Reach<double>& y) noexcept { return rounded(x.value - y.value) < 0; }

template <class V>
VESICA_INLINE Face<V> along_face(const Axes<V>& box) noexcept {
  return {box.ux, box.uy, box.a};
}
template <class V>
VESICA_INLINE Face<V> across_face(const Axes<V>& box) noexcept {
  return {-box.uy, box.ux, box.b};
}

template <class V, class Mask>
VESICA_INLINE Face<V> choose(Mask m, const Face<V>& yes, const Face<V>& no) noexcept {
  using namespace lane;
  return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.own, no.own)};
}
template <class V, class Mask>
VESICA_INLINE Axes<V> choose(Mask m, const Axes<V>& yes, const Axes<V>& no) noexcept {
  using namespace lane;
  return {select(m, yes.ux, no.ux), select(m, yes.uy, no.uy), select(m, yes.a, no.a), select(m, yes.b, no.b)};
}

/// True if all numbers lie where nothing under- or overflows: axes within 2^+-60 of 1, sizes and offset below 2^200.
template <class V>
VESICA_INLINE auto in_range(const Axes<V>& s) noexcept {
  using namespace lane;
  const V u = max(abs(s.ux), abs(s.uy));
  return both(both(u >= V(0x1p-60), u <= V(0x1p60)), both(s.a <= V(0x1p200), s.b <= V(0x1p200)));
}
template <class V>
VESICA_INLINE auto in_range(const BoxPair<V>& p) noexcept {
  using namespace lane;
  const auto offset = abs(p.d.x.high) + abs(p.d.y.high) <= V(0x1p200);
  return both(both(in_range(p.first), in_range(p.second)), offset);
}

/// True if nothing underflows either: a product of the pair's numbers keeps its low digits.
template <class V>
VESICA_INLINE auto large_enough(V size) noexcept {
  return size >= V(0x1p-400);
}

/// All of a box's half extents and the offset, together: at least the scale that error bounds speak of.
template <class V>
VESICA_INLINE V size_of(const BoxPair<V>& p) noexcept {
  using namespace lane;
  const V first = (p.first.a + p.first.b) * (abs(p.first.ux) + abs(p.first.uy));
  const V second = (p.second.a + p.second.b) * (abs(p.second.ux) + abs(p.second.uy));
  return (first + second) + (abs(p.d.x.high) + abs(p.d.y.high));
}

}  // namespace vesica::detail::support_minimum
