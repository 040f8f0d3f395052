// SPDX-License-Identifier: Apache-2.0
/// Where the outlines of two boxes meet: which corners lie on the other outline, and which edges cross, by exact signs.
#pragma once

#include <vesica/crossings/points.hpp>

namespace vesica::detail::crossings {

/// Twice the area of an edge and a point, positive to the left.
inline exact::Number<4> side(const Edge& e, const Position& x, const Position& y) noexcept {
  return e.dx * (y - e.y) - e.dy * (x - e.x);
}

/// How far along an edge a point of its line is, times the edge's squared length.
inline exact::Number<4> along(const Edge& e, const Position& x, const Position& y) noexcept {
  return e.dx * (x - e.x) + e.dy * (y - e.y);
}
inline exact::Number<4> squared_length(const Edge& e) noexcept { return e.dx * e.dx + e.dy * e.dy; }

inline bool is_corner(const Corners& a, int i, const Position& x, const Position& y) noexcept {
  return exact::compare(a.x[i], x) == 0 && exact::compare(a.y[i], y) == 0;
}

/// A place a part t along edge i: before the edge's end, however t was rounded.
inline double on_edge(int i, double t) noexcept { return std::fmin(i + t, std::nextafter(i + 1.0, 0.0)); }

/// Where a point lies along an outline, from 0 to 4, or -1 where it does not lie on it.
inline double place_along(const Corners& outline, const Position& x, const Position& y) noexcept {
  for (int i = 0; i < outline.count; ++i) {
    if (is_corner(outline, i, x, y)) return i;
  }
  for (int i = 0; i < outline.edges; ++i) {
    const Edge e(outline, i);
    if (side(e, x, y).sign != 0) continue;
    const auto t = along(e, x, y), whole = squared_length(e);
    if (t.sign > 0 && exact::compare(t, whole) < 0) return on_edge(i, quotient(exact::rounded(t), exact::rounded(whole)));
  }
  return -1;
}

/// An edge of each: at most one place inside both, or a common stretch.
inline void cross_edges(const Edge& e, int i, const Edge& f, int j, const Corners& a, const Corners& b,
                        Found& found) noexcept {
  const auto f0 = side(e, f.x, f.y), f1 = side(e, b.x[b.next(j)], b.y[b.next(j)]);
  if (f0.sign == 0 && f1.sign == 0) {
    const auto t0 = along(e, f.x, f.y), t1 = along(e, b.x[b.next(j)], b.y[b.next(j)]), whole = squared_length(e);
    const bool before_end = exact::compare(t0, whole) < 0 || exact::compare(t1, whole) < 0;
    if (before_end && (t0.sign > 0 || t1.sign > 0)) found.shared = true;
    return;
  }
  if (f0.sign * f1.sign >= 0) return;
  const auto e0 = side(f, e.x, e.y), e1 = side(f, a.x[a.next(i)], a.y[a.next(i)]);
  if (e0.sign * e1.sign >= 0) return;
  const double t = quotient(exact::rounded(e0), exact::rounded(e0 - e1));
  const double s = quotient(exact::rounded(f0), exact::rounded(f0 - f1));
  // The shorter edge tells the place better. Of equal ones, either order of the boxes takes the same.
  const double ex = e.at_x(t), ey = e.at_y(t), fx = f.at_x(s), fy = f.at_y(s), longer = e.length() - f.length();
  const bool along_e = longer < 0 || (longer == 0 && (ex < fx || (ex == fx && ey < fy)));
  found.add({along_e ? ex : fx, along_e ? ey : fy, on_edge(i, t), on_edge(j, s)});
}

inline Found crossings(const exact::Box& box_a, const exact::Box& box_b) noexcept {
  const Corners a(box_a), b(box_b);
  Found found;
  for (int i = 0; i < a.count; ++i) {
    const double at = place_along(b, a.x[i], a.y[i]);
    if (at >= 0) found.add({nearest(a.x[i]), nearest(a.y[i]), static_cast<double>(i), at});
  }
  for (int j = 0; j < b.count; ++j) {
    bool common = false;  // found already, as one of a's
    for (int i = 0; i < a.count; ++i) common = common || is_corner(a, i, b.x[j], b.y[j]);
    const double at = common ? -1 : place_along(a, b.x[j], b.y[j]);
    if (at >= 0) found.add({nearest(b.x[j]), nearest(b.y[j]), at, static_cast<double>(j)});
  }
  for (int i = 0; i < a.edges; ++i) {
    const Edge e(a, i);
    for (int j = 0; j < b.edges; ++j) cross_edges(e, i, Edge(b, j), j, a, b, found);
  }
  return found;
}

}  // namespace vesica::detail::crossings
