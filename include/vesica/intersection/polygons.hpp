// SPDX-License-Identifier: Apache-2.0
/// The region that two straight shapes share, by exact signs: which corners and which crossings of edges are its
/// vertices, and in which order. Only their coordinates are rounded.
///
/// The line of an edge of a meets b in a chord. Where it enters and leaves b follows from the sides of that line on
/// which b's corners are, and where the ends of the edge are by the sides of b's edges. So no two places are ever
/// compared.
#pragma once

#include <vesica/de9im/segment.hpp>
#include <vesica/exact/box_box.hpp>

namespace vesica::detail::intersection {

using crossings::Polygon;
using crossings::Sides;

struct Vertex {
  double x, y;
};

/// A shared region has at most 8 vertices, as many as two quadrilaterals have edges. So the room suffices.
///
/// The region is convex, and each of its edges lies on the line of an edge of a or of b. A line that bounds a convex
/// region meets it in one segment at most, so each of the 8 lines has at most one edge of the region.
///
/// The functions below add no vertex twice. common_area() adds one where an edge of the region begins: its pieces of a
/// have a length, and b's outline between two of them has corners only strictly between its ends (walk()). A region
/// without area is a point or a segment, and common_corners() leaves out a corner that both shapes have.
struct Vertices {
  static constexpr int most = 8;

  Vertex at[most];
  int count = 0;

  void add(const Vertex& v) noexcept {
    if (count < most) at[count++] = v;
  }
};

/// A place of b's outline: inside edge `index`, or at its first corner.
struct Place {
  int index;
  bool corner;
};

/// The places where the line of an edge enters b and leaves it.
struct Chord {
  bool there;
  Place in, out;
};

constexpr int next(int k) noexcept { return (k + 1) & 3; }
constexpr int before(int k) noexcept { return (k + 3) & 3; }

/// From the sides of the line on which the corners of a quadrilateral are. Counter-clockwise, corners go from the left
/// to the right side where the line enters.
inline Chord chord(const int (&side)[4]) noexcept {
  Chord c{false, {0, false}, {0, false}};
  int left = 0, right = 0, on = -1, first_on = -1, both = 0;
  for (int k = 0; k < 4; ++k) {
    left += side[k] > 0;
    right += side[k] < 0;
    if (side[k] != 0) continue;
    ++both;
    on = k;
    if (side[next(k)] == 0) first_on = k;  // the edge from k on lies on the line
  }
  if (left == 0 || right == 0) {  // it touches
    c.there = both > 0;
    const bool forward = left > 0;
    const int from = first_on < 0 ? on : first_on, to = first_on < 0 ? on : next(first_on);
    c.in = {forward ? from : to, true};
    c.out = {forward ? to : from, true};
    return c;
  }
  c.there = true;
  for (int k = 0; k < 4; ++k) {
    if (side[k] > 0 && side[next(k)] < 0) c.in = {k, false};
    if (side[k] < 0 && side[next(k)] > 0) c.out = {k, false};
    if (side[k] == 0 && side[before(k)] > 0) c.in = {k, true};
    if (side[k] == 0 && side[before(k)] < 0) c.out = {k, true};
  }
  return c;
}

/// Both shapes, and the rounded coordinates of their corners.
struct Pair {
  Polygon a, b;
  crossings::CornerVectors from_a;
  Sides of_a, of_b;
  const Vertex *corner_a, *corner_b;

  Pair(const exact::Box& box_a, const exact::Box& box_b, const Vertex* of_first, const Vertex* of_second) noexcept
      : a(box_a),
        b(box_b),
        from_a(a, b),
        of_a(a, b, from_a),
        of_b(b, a, from_a.back()),
        corner_a(of_first),
        corner_b(of_second) {}

  /// For two quadrilaterals. Convex insides are apart iff the line of an edge of one shape has the other on its outer
  /// side.
  bool insides_meet() const noexcept { return !separates(of_a) && !separates(of_b); }
  Chord chord_of(int edge) const noexcept { return chord(of_a.sign[edge]); }

  /// Corner i of a lies in b; corner j of b lies in a.
  bool is_in_b(int i) const noexcept { return least_side(of_b, b, i, a) >= 0; }
  bool is_in_a(int j) const noexcept { return least_side(of_a, a, j, b) >= 0; }
  bool is_on_edge(int i, int edge) const noexcept { return of_b.sign[edge][i] == 0; }
  /// If b is a quadrilateral: is corner i of a that place? It is on the line of the chord.
  bool is_at(int i, const Place& p) const noexcept {
    return is_on_edge(i, p.index) && (!p.corner || is_on_edge(i, before(p.index)));
  }
  /// True if corner i of a, on the line of a chord, is outside of b's edge, or of one of two, at that place.
  bool is_beyond(int i, const Place& p) const noexcept {
    return of_b.sign[p.index][i] < 0 || (p.corner && of_b.sign[before(p.index)][i] < 0);
  }
  Vertex vertex(int edge, const Place& p) const noexcept {
    if (p.corner) return corner_b[p.index];
    const auto c = crossings::edge_crossing(a, of_a, edge, b, of_b, p.index);
    return {c.x, c.y};
  }

 private:
  static bool separates(const Sides& of_p) noexcept {
    bool any = false;
    for (const auto& side : of_p.sign) {
      any = any || (side[0] <= 0 && side[1] <= 0 && side[2] <= 0 && side[3] <= 0);
    }
    return any;
  }
  static int least_side(const Sides& of_p, const Polygon& p, int i, const Polygon& q) noexcept {
    const auto &x = q.corners.x[i], &y = q.corners.y[i];
    if (p.corners.count == 1) return crossings::is_corner(p.corners, 0, x, y) ? 0 : -1;
    if (p.corners.count == 2) return de9im::place_on_segment(p.corners, of_p.sign[0][i], x, y);
    int least = 1;
    for (int k = 0; k < 4; ++k) least = of_p.sign[k][i] < least ? of_p.sign[k][i] : least;
    return least;
  }
};

/// A point, or a stretch of one line: its ends are corners.
inline Vertices common_corners(const Pair& p) noexcept {
  Vertices v;
  for (int i = 0; i < p.a.corners.count; ++i) {
    if (p.is_in_b(i)) v.add(p.corner_a[i]);
  }
  for (int j = 0; j < p.b.corners.count; ++j) {
    bool again = false;
    for (int i = 0; i < p.a.corners.count; ++i) {
      again = again || crossings::is_corner(p.a.corners, i, p.b.corners.x[j], p.b.corners.y[j]);
    }
    if (!again && p.is_in_a(j)) v.add(p.corner_b[j]);
  }
  return v;
}

/// Two segments that meet, on lines of their own.
inline Vertices crossing_of_segments(const Pair& p) noexcept {
  Vertices v = common_corners(p);
  if (v.count > 0) return v;
  const auto c = crossings::edge_crossing(p.a, p.of_a, 0, p.b, p.of_b, 0);
  v.add({c.x, c.y});
  return v;
}

/// A segment that meets a quadrilateral.
inline Vertices clipped(const Pair& p) noexcept {
  Vertices v;
  const Chord c = p.chord_of(0);
  const bool start_in = p.is_in_b(0), end_in = p.is_in_b(1);
  const bool point = c.in.corner && c.out.corner && c.in.index == c.out.index;
  if (start_in) {
    v.add(p.corner_a[0]);
  } else {
    v.add(p.vertex(0, c.in));
  }
  const bool one_in = start_in != end_in;
  const bool all = one_in ? (start_in ? p.is_at(0, c.out) : p.is_at(1, c.in)) : !start_in && point;
  if (all && end_in) v.at[0] = p.corner_a[1];
  if (all) return v;
  if (end_in) {
    v.add(p.corner_a[1]);
  } else {
    v.add(p.vertex(0, c.out));
  }
  return v;
}

/// The piece of edge i of a that lies in b: where it begins and ends, unless it is a single point or none.
struct Piece {
  bool there = false, starts_at_corner, ends_at_corner;
  Place in, out;
};

inline Piece piece(const Pair& p, int i) noexcept {
  Piece piece;
  const Chord c = p.chord_of(i);
  const int end = next(i);
  const bool start_in = p.is_in_b(i), end_in = p.is_in_b(end);
  const bool point = c.in.corner && c.out.corner && c.in.index == c.out.index;
  if (!c.there || point) return piece;
  piece.there = (start_in || p.is_beyond(i, c.in)) && (end_in || p.is_beyond(end, c.out)) &&
                !(start_in && p.is_at(i, c.out)) && !(end_in && p.is_at(end, c.in));
  piece.starts_at_corner = start_in;
  piece.ends_at_corner = end_in;
  piece.in = c.in;
  piece.out = c.out;
  return piece;
}

/// The place of corner i of a, which is on the outline of b: it is in b, and an edge of a that begins or ends there has
/// no piece in b. From the inside of b such an edge has one.
inline Place place_of(const Pair& p, int i) noexcept {
  for (int k = 0; k < 4; ++k) {
    if (p.is_on_edge(i, k) && p.is_on_edge(i, before(k))) return {k, true};
  }
  int edge = 0;
  while (edge < 3 && !p.is_on_edge(i, edge)) ++edge;  // if on none of three, on the fourth
  return {edge, false};
}

/// Corners of b from one place of its outline to another, counter-clockwise, neither of them among these.
inline void walk(const Pair& p, const Place& from, const Place& to, Vertices& v) noexcept {
  const int last = to.corner ? before(to.index) : to.index;
  for (int k = from.index; k != last; k = next(k)) v.add(p.corner_b[next(k)]);
}

/// Two quadrilaterals whose insides meet. Along a's outline the pieces in b follow one another; where one is not joined
/// to the next, the region's outline is b's.
inline Vertices common_area(const Pair& p) noexcept {
  Piece pieces[4];
  int some = -1;
  for (int i = 0; i < 4; ++i) {
    pieces[i] = piece(p, i);
    if (pieces[i].there) some = i;
  }
  Vertices v;
  if (some < 0) {
    for (int j = 0; j < 4; ++j) v.add(p.corner_b[j]);
    return v;
  }
  for (int n = 1; n <= 4; ++n) {
    const int i = (some + n) & 3;
    if (!pieces[i].there) continue;
    const Piece& now = pieces[i];
    v.add(now.starts_at_corner ? p.corner_a[i] : p.vertex(i, now.in));
    if (now.ends_at_corner && pieces[next(i)].there) continue;
    int then = next(i);
    while (!pieces[then].there) then = next(then);
    v.add(now.ends_at_corner ? p.corner_a[next(i)] : p.vertex(i, now.out));
    const Place from = now.ends_at_corner ? place_of(p, next(i)) : now.out;
    const Place to = pieces[then].starts_at_corner ? place_of(p, then) : pieces[then].in;
    walk(p, from, to, v);
  }
  return v;
}

inline bool is_segment(const exact::Box& s) noexcept { return (s.hx.sign == 0) != (s.hy.sign == 0); }
inline bool is_quadrilateral(const exact::Box& s) noexcept { return s.hx.sign != 0 && s.hy.sign != 0; }

/// The region of two shapes that overlap.
VESICA_COLD inline Vertices common_region(const exact::Box& a, const exact::Box& b, const Vertex* corner_a,
                                          const Vertex* corner_b) noexcept {
  if (is_quadrilateral(a) && is_segment(b)) return common_region(b, a, corner_b, corner_a);
  const Pair p(a, b, corner_a, corner_b);
  const int of_a = p.a.corners.count, of_b = p.b.corners.count;
  if (of_a == 1 || of_b == 1) return common_corners(p);
  if (of_a == 2 && of_b == 2) return crossing_of_segments(p);
  if (of_a == 2) return clipped(p);
  return p.insides_meet() ? common_area(p) : common_corners(p);
}

}  // namespace vesica::detail::intersection
