// SPDX-License-Identifier: Apache-2.0
/// The exact value that each filter estimates, from the stored numbers: the definitions in the comments of
/// include/vesica/filter, without a rounding.
#pragma once

#include <array>
#include <vesica/shapes.hpp>

#include "filter/dyadic.hpp"

namespace truth {

struct Vector {
  Dyadic x, y;
};
inline Dyadic dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
inline Dyadic cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }

template <class V>
Vector between(V x0, V y0, V x1, V y1) {
  return {Dyadic(x1) - Dyadic(x0), Dyadic(y1) - Dyadic(y0)};
}
inline Vector midpoint(double x0, double y0, double x1, double y1) {
  const Dyadic half(0.5);
  return {half * (Dyadic(x0) + Dyadic(x1)), half * (Dyadic(y0) + Dyadic(y1))};
}

template <class V>
Vector centre(const vesica::Point<V>& s) {
  return {s.x, s.y};
}
template <class V>
Vector centre(const vesica::Segment<V>& s) {
  return midpoint(s.x0, s.y0, s.x1, s.y1);
}
template <class V>
Vector centre(const vesica::Aabb<V>& s) {
  return midpoint(s.min_x, s.min_y, s.max_x, s.max_y);
}
template <class V, template <class> class Shape>
Vector centre(const Shape<V>& s) {
  return {s.cx, s.cy};
}

/// In the filters' units: an AABB has an axis of length 1/2 and a segment's is the segment.
struct Box {
  Vector u;
  Dyadic hx, hy;
};
template <class V>
Box box(const vesica::Rect<V>& s) {
  return {{s.ux, s.uy}, s.hx, s.hy};
}
template <class V>
Box box(const vesica::Aabb<V>& s) {
  const Vector size = between(s.min_x, s.min_y, s.max_x, s.max_y);
  return {{0.5, 0.0}, size.x, size.y};
}
template <class V>
Box box(const vesica::Segment<V>& s) {
  return {between(s.x0, s.y0, s.x1, s.y1), 0.5, 0.0};
}

/// Widest gap between projections on the axes of `a`, times |u|.
inline Dyadic widest_gap(const Box& a, const Box& b, const Vector& d) {
  const Dyadic c = abs(dot(a.u, b.u)), s = abs(cross(a.u, b.u)), uu = dot(a.u, a.u);
  return max(abs(dot(a.u, d)) - (a.hx * uu + b.hx * c + b.hy * s),
             abs(cross(a.u, d)) - (a.hy * uu + b.hx * s + b.hy * c));
}

/// |D|^2 - R^2
inline Dyadic beyond_reach(const Vector& d, const Dyadic& reach) { return dot(d, d) - square(reach); }

/// (distance from a disc's centre, at d from the box's, to the box)^2 - r^2, times |u|^2.
inline Dyadic disc_beyond_box(const Box& b, const Vector& d, const Dyadic& radius) {
  const Dyadic uu = dot(b.u, b.u);
  const Dyadic x = max(abs(dot(b.u, d)) - b.hx * uu, 0), y = max(abs(cross(b.u, d)) - b.hy * uu, 0);
  return square(x) + square(y) - square(radius) * uu;
}

struct Ellipse {
  Vector v;
  Dyadic a, b;
};
template <class V>
Ellipse ellipse(const vesica::Ellipse<V>& s) {
  return {{s.ux, s.uy}, s.a, s.b};
}

/// (b v.X)^2 + (a v x X)^2
inline Dyadic adjugate(const Ellipse& e, const Vector& x) {
  return square(e.b * dot(e.v, x)) + square(e.a * cross(e.v, x));
}
inline Dyadic determinant(const Ellipse& e) { return square(e.a * e.b * dot(e.v, e.v)); }

inline Dyadic outside_ellipse(const Ellipse& e, const Vector& x) { return adjugate(e, x) - determinant(e); }

/// How far the two segments, one along each axis of the box's frame, miss the ellipse.
inline std::array<Dyadic, 2> visible_edges(const Box& b, const Ellipse& e, const Vector& d) {
  const Dyadic uu = dot(b.u, b.u), kx = dot(b.u, d), ky = cross(b.u, d);
  const Dyadic ex = b.hx * uu, ey = b.hy * uu;
  const Dyadic x = max(abs(kx) - ex, 0), y = max(abs(ky) - ey, 0);
  const Dyadic c = dot(b.u, e.v), s = cross(b.u, e.v), aa = square(e.a), bb = square(e.b);
  const Dyadic p00 = aa * square(c) + bb * square(s), p11 = aa * square(s) + bb * square(c);
  Dyadic p01 = (aa - bb) * (c * s);
  if (kx.sign() * ky.sign() < 0) p01 = -p01;
  const Dyadic det = square(e.a * e.b * (square(c) + square(s)));
  const auto misses = [&](const Dyadic& p, const Dyadic& at, const Dyadic& along, const Dyadic& half) {
    return square(max(abs(p * along - p01 * at) - p * half, 0)) - det * (p - square(at));
  };
  return {misses(p00, x, abs(ky), ey), misses(p11, y, abs(kx), ex)};
}

/// d1 + c1 x + c2 x^2 + d2 x^3
struct Cubic {
  Dyadic d1, c1, c2, d2;
};

inline Cubic contact_cubic(const Ellipse& e, const Ellipse& f, const Vector& d) {
  const Dyadic a0 = square(e.a), a1 = square(e.b), b0 = square(f.a), b1 = square(f.b);
  const Dyadic mu = square(dot(e.v, f.v)) * (a0 * b1 + a1 * b0) + square(cross(e.v, f.v)) * (a0 * b0 + a1 * b1);
  const Dyadic d1 = determinant(e), d2 = determinant(f);
  return {d1, d1 + mu - adjugate(e, d), d2 + mu - adjugate(f, d), d2};
}

/// (r^2 + t)(P + t)(Q + t) - t (al + |D|^2 t)
inline Cubic contact_cubic(const Dyadic& radius, const Ellipse& e, const Vector& d) {
  const Dyadic vv = dot(e.v, e.v), rr = square(radius), p = square(e.a) * vv, q = square(e.b) * vv;
  return {rr * p * q, p * q + rr * (p + q) - adjugate(e, d), rr + p + q - dot(d, d), 1};
}

/// Is the cubic non-negative on all x > 0? d1, d2 > 0: by Descartes it has no positive root when neither inner
/// coefficient is negative, else two or none, and a positive discriminant means three real roots.
inline bool nonnegative(const Cubic& p) {
  if (p.c1.sign() >= 0 && p.c2.sign() >= 0) return true;
  const Dyadic discriminant = 18 * p.d1 * p.c1 * p.c2 * p.d2 - 4 * square(p.c2) * p.c2 * p.d1 +
                              square(p.c1) * square(p.c2) - 4 * p.d2 * square(p.c1) * p.c1 -
                              27 * square(p.d1) * square(p.d2);
  return discriminant.sign() <= 0;
}

}  // namespace truth
