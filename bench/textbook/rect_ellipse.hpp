// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace vesica::textbook {

/// A point relative to the ellipse's centre.
template <class T>
struct Offset {
  T x, y;
};

/// The solid ellipse { X : X . M X <= 1 }.
template <class T>
struct Conic {
  T xx, xy, yy;

  T dot(Offset<T> p, Offset<T> q) const { return p.x * (xx * q.x + xy * q.y) + p.y * (xy * q.x + yy * q.y); }

  bool contains(Offset<T> p) const { return dot(p, p) <= 1; }

  /// Does the segment between two points outside meet it? The quadratic along it, q0 + 2 q1 t + q2 t^2, must have its
  /// minimum between them and real roots.
  bool meets_edge(Offset<T> p, Offset<T> q) const {
    const Offset<T> along{q.x - p.x, q.y - p.y};
    const T q0 = dot(p, p) - 1, q1 = dot(along, p), q2 = dot(along, along);
    return q1 < 0 && -q1 < q2 && q1 * q1 >= q0 * q2;
  }
};

template <class Ellipse>
inline auto conic_of(const Ellipse& e) {
  const auto p = 1 / (e.a * e.a), q = 1 / (e.b * e.b);
  return Conic{p * e.ux * e.ux + q * e.uy * e.uy, (p - q) * e.ux * e.uy, p * e.uy * e.uy + q * e.ux * e.ux};
}

/// Closest features (Eberly, "Intersection of Rectangle and Ellipse", 2015, section 3), for axes taken to be of unit
/// length: which of nine regions holds the ellipse's centre leaves nothing to test, or one edge and its two vertices,
/// or two edges and their three. No error bound, no validity check.
template <class Rect, class Ellipse>
inline bool rect_ellipse(const Rect& r, const Ellipse& e) {
  const auto kx = e.cx - r.cx, ky = e.cy - r.cy;
  const auto x = r.ux * kx + r.uy * ky, y = r.ux * ky - r.uy * kx;
  const int column = x < -r.hx ? -1 : (x > r.hx ? 1 : 0);
  const int row = y < -r.hy ? -1 : (y > r.hy ? 1 : 0);
  if (column == 0 && row == 0) return true;

  const auto conic = conic_of(e);
  const auto vertex = [&](int i, int j) {
    const auto s = r.hx * static_cast<decltype(r.hx)>(i), t = r.hy * static_cast<decltype(r.hy)>(j);
    return Offset{s * r.ux - t * r.uy - kx, s * r.uy + t * r.ux - ky};
  };
  if (column == 0 || row == 0) {
    const auto p = row == 0 ? vertex(column, -1) : vertex(-1, row);
    const auto q = row == 0 ? vertex(column, 1) : vertex(1, row);
    return conic.contains(p) || conic.contains(q) || conic.meets_edge(p, q);
  }
  const auto corner = vertex(column, row), p = vertex(-column, row), q = vertex(column, -row);
  return conic.contains(corner) || conic.contains(p) || conic.contains(q) || conic.meets_edge(corner, p) ||
         conic.meets_edge(corner, q);
}

}  // namespace vesica::textbook
