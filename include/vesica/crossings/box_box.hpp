// SPDX-License-Identifier: Apache-2.0
/// The places where outlines of two boxes meet: which corners lie on the other outline, and which edges cross, by exact
/// signs.
#pragma once

#include <limits>
#include <vesica/crossings/estimate.hpp>

namespace vesica::detail::crossings {

/// The side of an edge that a point is on: positive to the left.
inline int side(const Edge& e, const Position& x, const Position& y) noexcept {
  return exact::compare_products(e.dx, y - e.y, e.dy, x - e.x);
}

inline bool is_corner(const Corners& a, int i, const Position& x, const Position& y) noexcept {
  return exact::compare(a.x[i], x) == 0 && exact::compare(a.y[i], y) == 0;
}

/// A place a part t along edge i: before the edge's end, and behind the outline's start, however t was rounded.
inline double on_edge(int i, double t) noexcept {
  return std::fmax(std::fmin(i + t, std::nextafter(i + 1.0, 0.0)), std::numeric_limits<double>::denorm_min());
}

/// An edge by one coordinate, that in which it is longer: points of its line are in the order of that.
struct Shadow {
  Position from, step, to;
  int up;
  bool of_x;
  explicit Shadow(const Edge& e) noexcept
      : of_x(e.dy.sign == 0 || (e.dx.sign != 0 && exact::detail::compare_magnitude(e.dx.span(), e.dy.span()) >= 0)) {
    from = of_x ? e.x : e.y;
    step = of_x ? e.dx : e.dy;
    to = from + step;
    up = step.sign;
  }
  const Position& of(const Position& x, const Position& y) const noexcept { return of_x ? x : y; }
  bool after_start(const Position& at) const noexcept { return up * exact::compare(at, from) > 0; }
  bool before_end(const Position& at) const noexcept { return up * exact::compare(at, to) < 0; }
};

/// How far along an edge a point of its line, not its start, is, from 0 to 1; -1 outside it, or at its end.
inline double part_of_edge(const Edge& e, const Position& x, const Position& y) noexcept {
  const Shadow shadow(e);
  const Position& at = shadow.of(x, y);
  if (!shadow.after_start(at) || !shadow.before_end(at)) return -1;
  return quotient(exact::rounded(at - shadow.from), exact::rounded(shadow.step));
}

/// An exact coordinate and its estimate.
struct Coordinate {
  const Position& exact_value;
  Estimate estimate;
  explicit Coordinate(const Position& x) noexcept : exact_value(x), estimate(x) {}
};
inline Estimate operator-(const Coordinate& a, const Coordinate& b) noexcept {
  const Estimate difference = a.estimate - b.estimate;
  return difference.sign_is_known() ? difference : Estimate(a.exact_value - b.exact_value);
}

/// An outline's corners and edges. Sides of the edges are worked out once.
struct Polygon {
  Corners corners;
  Coordinate x[4], y[4];
  Estimate dx[4], dy[4];

  explicit Polygon(const exact::Box& box) noexcept
      : corners(box),
        x{Coordinate(corners.x[0]), Coordinate(corners.x[1]), Coordinate(corners.x[2]), Coordinate(corners.x[3])},
        y{Coordinate(corners.y[0]), Coordinate(corners.y[1]), Coordinate(corners.y[2]), Coordinate(corners.y[3])} {
    for (int i = 0; i < corners.edges; ++i) {
      dx[i] = x[corners.next(i)] - x[i];
      dy[i] = y[corners.next(i)] - y[i];
    }
  }
};

/// The vectors from each corner of p to each of q, for the Sides of both outlines.
struct CornerVectors {
  Estimate x[4][4], y[4][4];

  CornerVectors(const Polygon& p, const Polygon& q) noexcept {
    for (int i = 0; i < p.corners.count; ++i) {
      for (int j = 0; j < q.corners.count; ++j) {
        x[i][j] = q.x[j] - p.x[i];
        y[i][j] = q.y[j] - p.y[i];
      }
    }
  }
  /// From q to p.
  CornerVectors back() const noexcept {
    CornerVectors all = *this;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        all.x[j][i] = -x[i][j];
        all.y[j][i] = -y[i][j];
      }
    }
    return all;
  }
};

/// The side of each edge of one outline on which each corner of another is.
struct Sides {
  Estimate size[4][4];
  int sign[4][4];

  Sides(const Polygon& p, const Polygon& q) noexcept : Sides(p, q, CornerVectors(p, q)) {}
  Sides(const Polygon& p, const Polygon& q, const CornerVectors& from_p) noexcept {
    for (int i = 0; i < p.corners.edges; ++i) {
      for (int j = 0; j < q.corners.count; ++j) {
        size[i][j] = p.dx[i] * from_p.y[i][j] - p.dy[i] * from_p.x[i][j];
        sign[i][j] =
            size[i][j].sign_is_known() ? size[i][j].sign() : side(Edge(p.corners, i), q.corners.x[j], q.corners.y[j]);
      }
    }
  }
  /// From one corner to the next of q, which are on different sides of edge i: how far off the edge's line is.
  double crossing(const Polygon& p, int i, const Polygon& q, int j) const noexcept {
    const int end = q.corners.next(j);
    const Estimate &part = size[i][j], whole = part - size[i][end];
    const Corners &a = p.corners, &b = q.corners;
    return quotient(part.is_precise() ? part.scaled() : exact_size(a, i, b, j, a.x[i], a.y[i]),
                    whole.is_precise() ? whole.scaled() : exact_size(a, i, b, j, b.x[end], b.y[end]));
  }

 private:
  /// Edge i of a times the way to corner j of b from a place.
  VESICA_COLD static Scaled exact_size(const Corners& a, int i, const Corners& b, int j, const Position& x,
                                       const Position& y) noexcept {
    const Edge e(a, i);
    return exact::rounded(exact::cross(e.dx, e.dy, b.x[j] - x, b.y[j] - y));
  }
};

/// The place of corner j of q along p, from 0 to 4; -1 if it is not on p.
inline double place_along(const Polygon& p, const Sides& sides, const Polygon& q, int j) noexcept {
  const Position &x = q.corners.x[j], &y = q.corners.y[j];
  for (int i = 0; i < p.corners.count; ++i) {
    if (is_corner(p.corners, i, x, y)) return i;
  }
  for (int i = 0; i < p.corners.edges; ++i) {
    if (sides.sign[i][j] != 0) continue;
    const double t = part_of_edge(Edge(p.corners, i), x, y);
    if (t >= 0) return on_edge(i, t);
  }
  return -1;
}

/// True if edges of one line have a stretch in common.
inline bool share_stretch(const Edge& e, const Edge& f) noexcept {
  const Shadow shadow(e);
  const Position &p = shadow.of(f.x, f.y), q = p + (shadow.of_x ? f.dx : f.dy);
  return (shadow.before_end(p) || shadow.before_end(q)) && (shadow.after_start(p) || shadow.after_start(q));
}

/// The place where two edges cross, rounded, and how far along either edge it is.
struct EdgeCrossing {
  double x, y, along_a, along_b;
};
inline EdgeCrossing edge_crossing(const Polygon& a, const Sides& of_a, int i, const Polygon& b, const Sides& of_b,
                                  int j) noexcept {
  const double t = of_b.crossing(b, j, a, i), s = of_a.crossing(a, i, b, j);
  const RoundedEdge e(a.corners, i), f(b.corners, j);
  // The shorter edge gives the place more precisely. If both are equal, either order of the boxes takes the same one.
  const double ex = e.at_x(t), ey = e.at_y(t), fx = f.at_x(s), fy = f.at_y(s);
  const double length_e = e.length(), length_f = f.length();
  const bool along_e = length_e < length_f || (length_e == length_f && (ex < fx || (ex == fx && ey < fy)));
  return {along_e ? ex : fx, along_e ? ey : fy, t, s};
}

/// An edge of each: at most one place inside both, or a common stretch.
inline void cross_edges(const Polygon& a, const Sides& of_a, int i, const Polygon& b, const Sides& of_b, int j,
                        Found& found) noexcept {
  const int f0 = of_a.sign[i][j], f1 = of_a.sign[i][b.corners.next(j)];
  if (f0 == 0 && f1 == 0) {
    if (!found.shared) found.shared = share_stretch(Edge(a.corners, i), Edge(b.corners, j));
    return;
  }
  if (f0 * f1 >= 0 || of_b.sign[j][i] * of_b.sign[j][a.corners.next(i)] >= 0) return;
  const EdgeCrossing c = edge_crossing(a, of_a, i, b, of_b, j);
  found.add({c.x, c.y, on_edge(i, c.along_a), on_edge(j, c.along_b)});
}

inline Found crossings(const exact::Box& box_a, const exact::Box& box_b) noexcept {
  const Polygon a(box_a), b(box_b);
  const CornerVectors from_a(a, b);
  const Sides of_a(a, b, from_a), of_b(b, a, from_a.back());
  Found found;
  for (int i = 0; i < a.corners.count; ++i) {
    const double at = place_along(b, of_b, a, i);
    if (at >= 0) found.add({nearest(a.corners.x[i]), nearest(a.corners.y[i]), static_cast<double>(i), at});
  }
  for (int j = 0; j < b.corners.count; ++j) {
    const Position &x = b.corners.x[j], &y = b.corners.y[j];
    bool common = false;  // found already, as one of a's
    for (int i = 0; i < a.corners.count; ++i) common = common || is_corner(a.corners, i, x, y);
    const double at = common ? -1 : place_along(a, of_a, b, j);
    if (at >= 0) found.add({nearest(x), nearest(y), at, static_cast<double>(j)});
  }
  for (int i = 0; i < a.corners.edges; ++i) {
    for (int j = 0; j < b.corners.edges; ++j) cross_edges(a, of_a, i, b, of_b, j, found);
  }
  return found;
}

}  // namespace vesica::detail::crossings
