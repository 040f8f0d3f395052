// SPDX-License-Identifier: Apache-2.0
/// The support function of an ellipse: how far it reaches along a direction, and where. And the distance between two
/// shapes along a direction, from their support functions.
#pragma once

#include <vesica/arithmetic/twofold.hpp>

namespace vesica::detail::nearest {

using namespace arithmetic;

/// True if a loop over lanes may end; the lanes of a vector bring their own.
constexpr bool all(bool mask) noexcept { return mask; }

template <class V>
using MaskOf = decltype(V() < V());

template <class V>
VESICA_INLINE MaskOf<V> negated(MaskOf<V> mask) noexcept {
  return and_not(V(0.0) == V(0.0), mask);
}

/// A rectangle's or an ellipse's numbers but its place: an axis (direction and unit of length) and half sizes along
/// and across it.
template <class V>
struct Axes {
  V ux, uy, a, b;
};

template <class V>
struct Direction {
  V x, y;
};

/// A normal N of any length; its length and the unit vector, both rounded.
template <class V, class F>
struct Normal {
  VectorFactor<F> vector;
  Twofold<V> inverse_length;
  V length;
  Direction<V> unit;
};

template <class F>
VESICA_INLINE auto normal(const VectorFactor<F>& vector) noexcept {
  using V = decltype(vector.x.high);
  const Root<V> length = root(square(vector.x) + square(vector.y));
  const V scale = rounded_inverse(length);
  return Normal<V, F>{vector, inverse(length), rounded(length.value), {vector.x.high * scale, vector.y.high * scale}};
}

/// Along a normal N from the ellipse's centre: the height |N| h, h for the unit normal; the farthest point; the radius
/// of curvature there; 1 / h^2.
template <class V>
struct Support {
  Twofold<V> height;
  V x, y, curvature, inverse_square;
};

/// With p = u.N, q = u x N: |N| h = sqrt((a p)^2 + (b q)^2), x = (a^2 p u + b^2 q perp(u)) / (|N| h),
/// curvature = (a b u.u)^2 |N|^3 / (|N| h)^3. The height is right to some 2^-104 of a |u| |N|; the point lies within
/// 3u a |u| of the outline.
template <class V, class F>
VESICA_INLINE Support<V> support(const Axes<V>& e, const Normal<V, F>& n) noexcept {
  const VectorFactor<Factor<V>> u = factor(e.ux, e.uy);
  const Twofold<V> p = factor(e.a) * factor(dot(u, n.vector)), q = factor(e.b) * factor(cross(u, n.vector));
  const Root<V> height = root(square(factor(p)) + square(factor(q)));
  const V scale = rounded_inverse(height);
  const V s = e.a * (rounded(p) * scale), t = e.b * (rounded(q) * scale);
  const V ratio = n.length * scale, squared = ratio * ratio, area = (e.a * e.b) * (e.ux * e.ux + e.uy * e.uy);
  return {height.value, s * e.ux - t * e.uy, s * e.uy + t * e.ux, ((area * area) * ratio) * squared, squared};
}

/// A point: no extent.
template <class V>
VESICA_INLINE Support<V> no_support() noexcept {
  const V zero(0.0);
  return {{zero, zero}, zero, zero, zero, zero};
}

/// The result for two disjoint shapes: the distance, the closest points as offsets from the shapes' own centres, and
/// the unit vector from a to b. `settled` is true if the search converged; if not, the rest means nothing. For shapes
/// that are nearly in contact the distance may be 0 or below, by less than some 2^-100 of their size. For disjoint
/// shapes a distance of at least `doubt` is right to a relative 2u. Points and unit vector were turned by `turn`
/// from where a search ended.
template <class V>
struct ClosestOffsets {
  Twofold<V> distance;
  V ax, ay, bx, by, nx, ny;
  MaskOf<V> settled;
  V doubt = V(0.0), turn = V(0.0);
};

/// A slope that is off by e changes what the last step gains by (|slope| + e / 2) e / bend. Where that is more than u
/// of the distance, that is not right to a relative 2u: this many u of the size of its terms are allowed for as e.
inline constexpr double slope_rounding = 8;

/// A search has converged where the slope left is below this share of the size of its terms.
inline constexpr double settled_slope = 0x1p-46;

/// The distance between two shapes along a normal N that points from a to b and that is, nearly, the one along which
/// they are farthest apart: phi(n) = n.D - h_a(n) - h_b(n) never exceeds the distance and is stationary there, so it is
/// evaluated in twice the precision at N as it stands. One step of Newton's method then takes out N's error:
/// phi' = n x g with g = D - x_a - x_b, phi'' = -(phi + curvatures). It moves the points along their outlines.
/// d: from a's centre to b's. size: about the shapes' and d's. smooth: 1, or 0 where a is a vertex of the face
/// whose normal N is: then N is exact, and the point of a is for the caller to find.
template <class V, class F>
VESICA_INLINE ClosestOffsets<V> separation(const Vector<V>& d, const Normal<V, F>& n, const Support<V>& a,
                                           const Support<V>& b, V size, V smooth = V(1.0)) noexcept {
  const V zero(0.0), one(1.0);
  const V gx = d.x.high - (a.x + b.x), gy = d.y.high - (a.y + b.y);
  const V slope = smooth * (n.unit.x * gy - n.unit.y * gx), curvature = a.curvature + b.curvature;
  const V bend = (n.unit.x * gx + n.unit.y * gy) + curvature;
  // A turn of more than 1 would be of rounding errors alone.
  const V steepest = max(bend, abs(slope)), divisor = select(steepest > zero, steepest, one), turn = slope / divisor;
  const Twofold<V> phi = factor(dot(n.vector, factor(d)) - (a.height + b.height)) * factor(n.inverse_length);
  const V doubted = (abs(slope) + smooth * (V(slope_rounding * 0x1p-54) * size)) / divisor;
  const V move_a = a.curvature * turn, move_b = b.curvature * turn;
  const auto converged = either(smooth == zero, both(bend > zero, abs(slope) <= V(settled_slope) * (size + curvature)));
  const Twofold<V> distance{phi.high, phi.low + V(0.5) * (slope * turn)};
  return {distance,
          a.x - move_a * n.unit.y,
          a.y + move_a * n.unit.x,
          move_b * n.unit.y - b.x,
          -(b.y + move_b * n.unit.x),
          n.unit.x - turn * n.unit.y,
          n.unit.y + turn * n.unit.x,
          converged,
          V(slope_rounding) * (size * doubted),
          turn};
}

}  // namespace vesica::detail::nearest
