// SPDX-License-Identifier: Apache-2.0
/// A point outside a box: the distance, and where on the box it is reached.
#pragma once

#include <vesica/nearest/support.hpp>

namespace vesica::detail::nearest {

/// { s u + t perp(u) : |s| <= hx, |t| <= hy } about a centre. A segment's axis and an AABB's half extents are
/// differences of stored numbers, which need two doubles.
template <class V>
struct Box {
  Vector<V> u;
  Twofold<V> hx, hy;
};

/// At least how far a box or an ellipse reaches from its centre.
template <class V>
VESICA_INLINE V extent(V ux, V uy, V a, V b) noexcept {
  return (abs(ux) + abs(uy)) * (a + b);
}

/// A place in a box, by coordinates along and across the axis; exactly +-hx or +-hy where on a face.
template <class V>
struct Spot {
  V s, t;
};

/// The result for a box and a point outside it: the distance, the place in the box, and the direction from there to the
/// point in the box's frame (folded into the first quadrant; of any length).
template <class V>
struct PointBox {
  Twofold<V> distance;
  Spot<V> spot;
  V nx, ny;
  MaskOf<V> settled;
};

/// |k| - h if positive, else zero.
template <class V>
VESICA_INLINE Twofold<V> excess(const Twofold<V>& k, const Twofold<V>& h) noexcept {
  const Twofold<V> folded = flipped(k, k.high), beyond = renormalised(folded - h);
  const V zero(0.0);
  return choose(beyond.high > zero, beyond, Twofold<V>{zero, zero});
}

/// The length of (x, y), both at least zero. Powers of two keep tiny squares from underflow.
template <class V>
VESICA_INLINE Twofold<V> length(const Twofold<V>& x, const Twofold<V>& y) noexcept {
  const V zero(0.0), one(1.0);
  const auto tiny = max(x.high, y.high) < V(0x1p-300);
  const V up = select(tiny, V(0x1p500), one), down = select(tiny, V(0x1p-500), one);
  const auto scaled = [&](const Twofold<V>& v) { return factor(Twofold<V>{v.high * up, v.low * up}); };
  const Twofold<V> squared = square(scaled(x)) + square(scaled(y));
  const auto some = squared.high > zero;
  const Twofold<V> both_sides = root(choose(some, squared, Twofold<V>{one, zero})).value;
  return {select(some, both_sides.high * down, zero), select(some, both_sides.low * down, zero)};
}

/// p: from the box's centre to the point. In the box's frame, in units of |u|.
template <class V>
VESICA_INLINE PointBox<V> point_box(const Box<V>& box, const Vector<V>& p) noexcept {
  const V zero(0.0);
  const auto u = factor(box.u), vp = factor(p);
  const Twofold<V> uu = square(u.x) + square(u.y);
  const Twofold<V> kx = renormalised(dot(u, vp)), ky = renormalised(cross(u, vp));
  const auto unit = factor(uu);
  const Twofold<V> x = excess(kx, factor(box.hx) * unit), y = excess(ky, factor(box.hy) * unit);
  const Twofold<V> distance = factor(length(x, y)) * factor(inverse(root(uu)));
  const V scale = V(1.0) / rounded(uu), hx = rounded(box.hx), hy = rounded(box.hy);
  const V s = select(x.high > zero, hx, min(abs(kx.high) * scale, hx));
  const V t = select(y.high > zero, hy, min(abs(ky.high) * scale, hy));
  return {distance, {flip_sign(s, kx.high), flip_sign(t, ky.high)}, x.high, y.high, rounded(distance) > zero};
}

}  // namespace vesica::detail::nearest
