// SPDX-License-Identifier: Apache-2.0
/// Shared by the rectangle-ellipse methods: the plane stretched until the ellipse is a disc, the rectangle with it.
///
/// Eberly's level function Q(X) = (X - K) . M (X - K) - 1 ("Intersection of Rectangle and Ellipse", 2015, section 2) is
/// |p|^2 / r^2 - 1 for the image p of X. In print M = diag(1 / a^2, 1 / b^2) turned, and an edge is hit if
/// q1^2 - q0 q2 >= 0. Here X goes to p = (b v.X, a v x X) and r = a b v.v: no division, and axes of any length. By
/// Lagrange's identity q1^2 - q0 q2 = r^2 |f|^2 - (f x p)^2, which does not cancel where an edge is long.
#pragma once

#include <vesica/methods/rescaled_pair.hpp>
#include <vesica/overlap.hpp>

namespace vesica::methods::detail {

template <class T>
struct Vector {
  T x, y;
};

template <class T>
VESICA_INLINE T dot(const Vector<T>& p, const Vector<T>& q) noexcept {
  return p.x * q.x + p.y * q.y;
}
template <class T>
VESICA_INLINE T cross(const Vector<T>& p, const Vector<T>& q) noexcept {
  return p.x * q.y - p.y * q.x;
}
/// p + s f.
template <class T>
VESICA_INLINE Vector<T> along(const Vector<T>& p, T s, const Vector<T>& f) noexcept {
  return {p.x + s * f.x, p.y + s * f.y};
}

/// Stretched, about the ellipse's centre: the disc of radius r, and the parallelogram
/// { centre + s f0 + t f1 : |s| <= hx, |t| <= hy }. One unit of its plane is `unit` times the stored one in length.
template <class T>
struct Metric {
  Vector<T> centre, f0, f1;
  T hx, hy, r, unit;
  /// The ellipse's centre in the rectangle's frame, and half extents e0, e1 in the same unit.
  T k0, k1, e0, e1;
  /// False when an ellipse is a segment, a point or so nearly one that squares underflow: it has no usable metric.
  bool usable;
};

/// The factors of p = (b v.X, a v x X), by a power of two of the half lengths, so that the larger is about 1; and what
/// one unit of that plane stands for. A point gets the plain Euclidean plane.
template <class T>
struct Stretch {
  T a, b, unit;
};

template <class T>
VESICA_INLINE Stretch<T> stretch(const RescaledPair<T>& p, const Ellipse<T>& ellipse) noexcept {
  const T longer = larger(p.g0, p.g1);
  if (longer >= ScalarTraits<T>::power(-10 * ScalarTraits<T>::range)) return {p.g0, p.g1, 1};
  // From the stored numbers: rescaling may have lost those of a tiny ellipse.
  const double a = static_cast<double>(ellipse.a), b = static_cast<double>(ellipse.b);
  if (a == 0 && b == 0) return {1, 1, 1};
  const int own = vesica::detail::arithmetic::exponent_of(larger(a, b)),
            seen = vesica::detail::arithmetic::exponent_of(double(longer));
  return {in_unit<T>({a, 0}, own), in_unit<T>({b, 0}, own), static_cast<T>(vesica::detail::arithmetic::scale(1, seen))};
}

template <class T>
VESICA_INLINE Metric<T> metric(const RescaledPair<T>& p, const Stretch<T>& by) noexcept {
  using Traits = ScalarTraits<T>;
  const T c = p.wx * p.ux + p.wy * p.uy, s = p.wx * p.uy - p.wy * p.ux;
  const T uu = p.ux * p.ux + p.uy * p.uy, ww = p.wx * p.wx + p.wy * p.wy;
  Metric<T> m;
  m.centre = {-by.b * (p.wx * p.dx + p.wy * p.dy), -by.a * (p.wx * p.dy - p.wy * p.dx)};
  m.f0 = {by.b * c, by.a * s};
  m.f1 = {-by.b * s, by.a * c};
  m.hx = p.h0;
  m.hy = p.h1;
  m.r = by.a * p.g1 * ww;
  m.unit = by.unit;
  m.k0 = p.ux * p.dx + p.uy * p.dy;
  m.k1 = p.ux * p.dy - p.uy * p.dx;
  m.e0 = p.h0 * uu;
  m.e1 = p.h1 * uu;
  // The smallest number formed, r^2 |f|^2, is at least 2^-36 (2^-288) times the fourth power of the smaller half
  // length.
  m.usable = p.g0 >= Traits::power(-22 * Traits::range) && p.g1 >= Traits::power(-22 * Traits::range);
  return m;
}

/// An ellipse's numbers as a rectangle's.
template <class T>
VESICA_INLINE Rect<T> box_of(const Ellipse<T>& e) noexcept {
  return {e.cx, e.cy, e.ux, e.uy, e.a, e.b};
}

/// The shapes must be valid.
template <class T>
VESICA_INLINE Metric<T> metric(const Rect<T>& rect, const Ellipse<T>& ellipse) noexcept {
  const auto pair = rescaled_pair(rect, box_of(ellipse));
  return metric(pair, stretch(pair, ellipse));
}

/// The image of a vertex, sx and sy (1 or -1) its signs; with one of them 0, the middle of an edge.
template <class T>
VESICA_INLINE Vector<T> vertex(const Metric<T>& m, T sx, T sy) noexcept {
  return along(along(m.centre, sx * m.hx, m.f0), sy * m.hy, m.f1);
}

template <class T>
VESICA_INLINE bool vertex_in_disc(const Metric<T>& m, T sx, T sy) noexcept {
  const Vector<T> p = vertex(m, sx, sy);
  return dot(p, p) <= m.r * m.r;
}

/// True if the disc reaches an edge { p + t f : |t| <= h } at the foot of its centre. With both end points outside,
/// there is no other way to reach it.
template <class T>
VESICA_INLINE bool foot_in_disc(const Vector<T>& p, const Vector<T>& f, T h, T r) noexcept {
  const T ff = dot(f, f), distance = cross(f, p);
  return lane::both(std::fabs(dot(f, p)) <= h * ff, distance * distance <= (r * r) * ff);
}

/// The edge across the rectangle's first axis, on its side s.
template <class T>
VESICA_INLINE bool side_edge_meets(const Metric<T>& m, T s) noexcept {
  return foot_in_disc(vertex(m, s, T{0}), m.f1, m.hy, m.r);
}
/// The edge along the rectangle's first axis, on side s of it.
template <class T>
VESICA_INLINE bool long_edge_meets(const Metric<T>& m, T s) noexcept {
  return foot_in_disc(vertex(m, T{0}, s), m.f0, m.hx, m.r);
}

}  // namespace vesica::methods::detail
