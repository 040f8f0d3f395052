// SPDX-License-Identifier: Apache-2.0
/// intersection() with polygons and polylines: a segment's pieces in any of them, and the region that a convex polygon
/// shares with another one, a box or a rectangle. Exact signs decide which vertices there are and their order; only
/// coordinates of crossings are rounded.
///
/// For two outlines whose insides meet, the pieces of one outline in the other shape follow one another, as in
/// intersection/polygons.hpp. Between two pieces the region's outline is the other shape's. Corners in the middle of a
/// straight line are left out. No memory is needed: many vertices are found twice, first to count them and to choose
/// the lowest, then to write them from that one on.
#pragma once

#include <vesica/intersection.hpp>
#include <vesica/polygon/convex.hpp>
#include <vesica/polygon/pieces.hpp>

namespace vesica {

namespace detail::polygon {

/// A convex ring with area, counter-clockwise. Edge k begins at vertex k; those without length are passed over.
template <class T>
class ConvexOutline {
 public:
  ConvexOutline(const Edges<T>& edges, const Convexity& c) noexcept
      : edges_(edges), ring_(c.ring), clockwise_(c.clockwise) {}

  const Edges<T>& edges() const noexcept { return edges_; }
  Edge edge(std::int64_t k) const noexcept {
    const Point<double> p = vertex(k), q = vertex(k + 1 == ring_.length() ? 0 : k + 1);
    return {p.x, p.y, q.x, q.y};
  }
  /// The next edge that has a length.
  std::int64_t next(std::int64_t k) const noexcept {
    do {
      k = k + 1 == ring_.length() ? 0 : k + 1;
    } while (!has_length(edge(k)));
    return k;
  }
  /// Does the outline turn at the end of an edge?
  bool turns_behind(std::int64_t k) const noexcept {
    const Edge e = edge(k);
    const Point<double> p = end_of(edge(next(k)));
    return side(p.x, p.y, e) != 0;
  }
  template <class Visit>
  void for_edges(const Visit& visit) const noexcept {
    Point<double> from = vertex(0);
    for (std::int64_t k = 0; k < ring_.length(); ++k) {
      const Point<double> to = vertex(k + 1 == ring_.length() ? 0 : k + 1);
      if (!same(from, to)) visit(Edge{from.x, from.y, to.x, to.y}, k);
      from = to;
    }
  }
  /// Calls visit(corner) for each end of an edge at which the outline turns.
  template <class Visit>
  void for_corners(const Visit& visit) const noexcept {
    for_edges([&](const Edge& e, std::int64_t k) {
      if (turns_behind(k)) visit(end_of(e));
    });
  }

 private:
  Point<double> vertex(std::int64_t k) const noexcept {
    return edges_.vertex(clockwise_ ? ring_.last - 1 - k : ring_.first + k);
  }

  const Edges<T>& edges_;
  Range ring_;
  bool clockwise_;
};

/// The piece of an edge that is in a convex shape, unless it is a single point or none. It starts and ends at the
/// edge's ends, or at places of the shape's outline.
template <class Place>
struct PieceIn {
  bool there = false, starts_at_corner = false, ends_at_corner = false;
  Place in{}, out{};
};

/// A place of a ring's outline: inside an edge, or at its end.
struct RingPlace {
  std::int64_t edge;
  bool corner;
};

/// A convex ring that edges of another one enter and leave.
template <class T>
class RingEntered {
 public:
  using Place = RingPlace;
  using Piece = PieceIn<Place>;

  RingEntered(const Edges<T>& edges, const Box& box, const Convexity& c) noexcept
      : ring_(edges, c), outline_(edges, box) {
    ring_.for_edges([&](const Edge&, std::int64_t k) { last_ = k; });
  }

  Piece piece(const Edge& e) noexcept {
    Piece piece;
    if (!meet(box_of(e), outline_.box)) return piece;
    const int start = same(start_of(e), located_) ? place_ : locate(start_of(e)), end = locate(end_of(e));
    located_ = end_of(e);
    place_ = end;
    if (start < 0 && end < 0 && !is_any_near(box_of(e))) return piece;
    piece.starts_at_corner = start >= 0;
    piece.ends_at_corner = end >= 0;
    piece.there = start > 0 && end > 0;
    if (piece.there || !find_chord(e, piece.in, piece.out)) return piece;
    piece.there = (start >= 0 || is_beyond(start_of(e), piece.in)) && (end >= 0 || is_beyond(end_of(e), piece.out)) &&
                  !(start >= 0 && is_at(start_of(e), piece.out)) && !(end >= 0 && is_at(end_of(e), piece.in));
    return piece;
  }
  /// The place of a point on the outline.
  Place place_of(const Point<double>& p) const noexcept {
    Place place{0, false};
    ring_.for_edges([&](const Edge& f, std::int64_t k) {
      if (is_on(p, f) && !same(p, start_of(f))) place = {k, same(p, end_of(f))};
    });
    return place;
  }
  Point<double> vertex(const Edge& e, const Place& p) const noexcept {
    const Edge f = ring_.edge(p.edge);
    return p.corner ? end_of(f) : crossing_of(e, f);
  }
  /// Corners from one place to another, neither of them among these.
  template <class Visit>
  void walk(const Place& from, const Place& to, const Visit& visit) const noexcept {
    for (std::int64_t k = from.corner ? ring_.next(from.edge) : from.edge; k != to.edge; k = ring_.next(k)) {
      if (ring_.turns_behind(k)) visit(end_of(ring_.edge(k)));
    }
  }
  template <class Visit>
  void for_corners(const Visit& visit) const noexcept {
    ring_.for_corners(visit);
  }

 private:
  int locate(const Point<double>& p) noexcept { return outline_.locate(p); }
  bool is_any_near(const Box& box) noexcept {
    bool found = false;
    outline_.for_edges_near(box, [&](const Edge&, std::int64_t) { found = true; });
    return found;
  }
  /// The places at which the line of an edge enters the ring and leaves it. Returns false if it passes no inside and no
  /// edge that has the inside on the same side, or touches in one corner.
  bool find_chord(const Edge& e, Place& in, Place& out) const noexcept {
    bool enters = false;
    std::int64_t before = last_;
    ring_.for_edges([&](const Edge& f, std::int64_t k) {
      const int s0 = side(f.x0, f.y0, e), s1 = side(f.x1, f.y1, e);
      if (s0 > 0 && s1 <= 0) {
        in = {k, s1 == 0};
        enters = true;
      }
      if (s0 <= 0 && s1 > 0) out = s0 < 0 ? Place{k, false} : Place{before, true};
      before = k;
    });
    return enters && !(in.corner && out.corner && in.edge == out.edge);
  }
  bool is_at(const Point<double>& p, const Place& place) const noexcept {
    const Edge f = ring_.edge(place.edge);
    return place.corner ? same(p, end_of(f)) : side(p.x, p.y, f) == 0;
  }
  /// Is a point of a chord's line outside of the edge, or of one of two, at that place?
  bool is_beyond(const Point<double>& p, const Place& place) const noexcept {
    return side(p.x, p.y, ring_.edge(place.edge)) < 0 ||
           (place.corner && side(p.x, p.y, ring_.edge(ring_.next(place.edge))) < 0);
  }

  ConvexOutline<T> ring_;
  std::int64_t last_ = 0;  // the last edge
  Outline<T> outline_;
  Point<double> located_{infinite, infinite};  // the last point that was located, and its place
  int place_ = -1;
};

/// A rectangle, entered by the edges of a convex ring. Its corners are no stored points.
class RectEntered {
 public:
  using Place = intersection::Place;
  using Piece = PieceIn<Place>;

  explicit RectEntered(const Rect<double>& r) noexcept : form_(exact::form(r)), box_(box_about(r)) {
    intersection::corners(r, corner_);
  }

  Piece piece(const Edge& e) const noexcept {
    if (!meet(box_of(e), box_)) return {};
    const Meeting m(e, *this);
    const intersection::Piece found = intersection::piece(m.pair, 0);
    if (!found.there) return {};  // the rest may not be set
    return {found.there, found.starts_at_corner, found.ends_at_corner, found.in, found.out};
  }
  Place place_of(const Point<double>& p) const noexcept { return intersection::place_of(Meeting(p, *this).pair, 0); }
  Point<double> vertex(const Edge& e, const Place& p) const noexcept { return vertex(Meeting(upward(e), *this), p); }
  template <class Visit>
  void walk(const Place& from, const Place& to, const Visit& visit) const noexcept {
    const int last = to.corner ? intersection::before(to.index) : to.index;
    for (int k = from.index; k != last; k = intersection::next(k)) visit(corner(intersection::next(k)));
  }
  template <class Visit>
  void for_corners(const Visit& visit) const noexcept {
    for (int k = 0; k < 4; ++k) visit(corner(k));
  }

  /// The ends of what a ring and a rectangle share that has no area.
  template <class T, class Visit>
  void for_ends(const ConvexOutline<T>& ring, const Visit& visit) const noexcept {
    bool beyond[4] = {}, known[4] = {};
    int count = 0;
    ring.for_edges([&](const Edge& e, std::int64_t k) {
      const Meeting m(e, *this);
      const auto& own = m.pair.b.corners;
      count = own.count;
      for (int j = 0; j < count; ++j) beyond[j] = beyond[j] || m.pair.of_a.sign[0][j] < 0;
      const bool across = own.edges == 1 && m.pair.of_b.sign[0][0] != 0;
      if (m.pair.is_in_b(1) && (ring.turns_behind(k) || across)) {
        visit(end_of(e));
        const auto& ends = m.pair.a.corners;
        for (int j = 0; j < count; ++j) known[j] = known[j] || crossings::is_corner(own, j, ends.x[1], ends.y[1]);
      }
      if (own.edges == 1 && m.crosses()) visit(vertex(Meeting(upward(e), *this), {0, false}));
    });
    for (int j = 0; j < count; ++j) {
      if (!beyond[j] && !known[j]) visit(corner(j));
    }
  }

 private:
  /// An edge or a point, and the rectangle.
  struct Meeting {
    intersection::Vertex ends[2]{};
    intersection::Pair pair;

    template <class Shape>
    Meeting(const Shape& s, const RectEntered& r) noexcept : pair(exact::form(s), r.form_, ends, r.corner_) {}
    /// Do two segments cross inside both?
    bool crosses() const noexcept {
      const auto &a = pair.of_a.sign[0], &b = pair.of_b.sign[0];
      return a[0] * a[1] < 0 && b[0] * b[1] < 0;
    }
  };

  Point<double> corner(int k) const noexcept { return {corner_[k].x, corner_[k].y}; }
  static Point<double> vertex(const Meeting& m, const Place& p) noexcept {
    const intersection::Vertex v = m.pair.vertex(0, p);
    return {v.x, v.y};
  }

  exact::Box form_;
  Box box_;
  intersection::Rounded corner_{};
};

/// Calls visit(vertex) for the region that a convex ring and another shape with area share, counter-clockwise. Their
/// insides meet.
template <class T, class Entered, class Visit>
void for_area(const ConvexOutline<T>& ring, Entered& b, const Visit& visit) noexcept {
  struct Passed {
    Edge e;
    typename Entered::Piece piece;
  };
  const auto join = [&](const Passed& last, const Passed& now) {
    const bool from_corner = last.piece.ends_at_corner, to_corner = now.piece.starts_at_corner;
    const Point<double> end = end_of(last.e), start = start_of(now.e);
    if (from_corner && to_corner && same(end, start)) {
      if (side(now.e.x1, now.e.y1, last.e) != 0) visit(end);
      return;
    }
    visit(from_corner ? end : b.vertex(last.e, last.piece.out));
    b.walk(from_corner ? b.place_of(end) : last.piece.out, to_corner ? b.place_of(start) : now.piece.in, visit);
    visit(to_corner ? start : b.vertex(now.e, now.piece.in));
  };
  std::optional<Passed> first, last;
  ring.for_edges([&](const Edge& e, std::int64_t) {
    const Passed now{e, b.piece(e)};
    if (!now.piece.there) return;
    if (last) join(*last, now);
    if (!first) first = now;
    last = now;
  });
  if (first) {
    join(*last, *first);
  } else {
    b.for_corners(visit);
  }
}

/// The ends of what two rings share whose insides do not meet: corners of one in the other, those of both once.
template <class T, class Visit>
void for_ends(const ConvexOutline<T>& a, Outline<T>& in_a, const ConvexOutline<T>& b, Outline<T>& in_b,
              const Visit& visit) noexcept {
  a.for_corners([&](const Point<double>& p) {
    if (in_b.locate(p) >= 0) visit(p);
  });
  b.for_corners([&](const Point<double>& p) {
    if (in_a.locate(p) < 0) return;
    bool known = false;
    a.for_corners([&](const Point<double>& q) { known = known || same(p, q); });
    if (!known) visit(p);
  });
}

/// Writes a ring from its lowest vertex on, the left one of two, by the numbers written. for_vertices(visit) calls
/// visit(vertex) for all vertices, counter-clockwise.
template <class ForVertices>
std::int64_t write_region(const ForVertices& for_vertices, RegionRoom& room) noexcept {
  constexpr std::int64_t most = 64;  // kept, so that few vertices are found once
  Point<double> kept[most];
  std::int64_t first = 0;
  Point<double> least{}, before{};
  for_vertices([&](const Point<double>& vertex) {
    const Point<double> p = room.rounded(vertex);
    if (room.count < most) kept[room.count] = p;
    const bool is_less = p.y < least.y || (p.y == least.y && p.x < least.x);
    if (room.count == 0 || is_less || (same(p, least) && !same(p, before))) {
      least = p;
      first = room.count;
    }
    before = p;
    ++room.count;
  });
  if (room.error != 0 || room.capacity == 0) return room.result();
  std::int64_t k = 0;
  const auto write = [&](const Point<double>& p) {
    room.write(k < first ? k - first + room.count : k - first, p);
    ++k;
  };
  if (room.count > most) {
    for_vertices([&](const Point<double>& vertex) { write(room.rounded(vertex)); });
  } else {
    while (k < room.count) write(kept[k]);
  }
  return room.count;
}

/// A valid path that is convex or a segment, and a segment.
template <class T>
std::int64_t thin_region(const Edges<T>& path, const Box& box, const Edge& segment, RegionRoom& room) noexcept {
  Point<double> end[2];
  int count = 0;
  find_pieces(path, box, segment, [&](const Point<double>& from, const Point<double>& to, bool is_point) {
    end[0] = from;
    end[1] = to;
    count = is_point ? 1 : 2;
  });
  return write_region(
      [&](const auto& visit) {
        for (int k = 0; k < count; ++k) visit(end[k]);
      },
      room);
}

/// The vertices of a region that two convex polygons share.
template <class T>
std::int64_t region_or_error(const Edges<T>& a, const Edges<T>& b, RegionRoom& room) noexcept {
  Box box_a, box_b;
  if (!is_valid(a, box_a) || !is_valid(b, box_b)) return error_shape;
  const Convexity shape_a = convexity(a), shape_b = convexity(b);
  if (!shape_a.convex || !shape_b.convex) return error_not_convex;
  if (!meet(box_a, box_b)) return 0;
  if (shape_a.flat && shape_b.flat) {
    const Edge& s = shape_b.span;
    const T x[] = {static_cast<T>(s.x0), static_cast<T>(s.x1)}, y[] = {static_cast<T>(s.y0), static_cast<T>(s.y1)};
    return thin_region(Edges<T>(Polyline<T>{x, y, sizeof(T), nullptr, 2}), box_b, shape_a.span, room);
  }
  if (shape_a.flat) return thin_region(b, box_b, shape_a.span, room);
  if (shape_b.flat) return thin_region(a, box_a, shape_b.span, room);
  const ConvexOutline<T> ring_a(a, shape_a), ring_b(b, shape_b);
  if (insides_meet_valid(a, box_a, b, box_b)) {
    RingEntered<T> entered(b, box_b, shape_b);
    return write_region([&](const auto& visit) { for_area(ring_a, entered, visit); }, room);
  }
  Outline<T> in_a(a, box_a), in_b(b, box_b);
  return write_region([&](const auto& visit) { for_ends(ring_a, in_a, ring_b, in_b, visit); }, room);
}

template <class T>
std::int64_t region_or_error(const Edges<T>& a, const Aabb<double>& b, RegionRoom& room) noexcept {
  if (check_other(b) != 0) return error_shape;
  const T left = static_cast<T>(b.min_x), low = static_cast<T>(b.min_y), right = static_cast<T>(b.max_x),
          high = static_cast<T>(b.max_y);
  const T x[] = {left, right, right, left}, y[] = {low, low, high, high};
  return region_or_error(a, Edges<T>(Polygon<T>{x, y, sizeof(T), nullptr, 4}), room);
}

template <class T>
std::int64_t region_or_error(const Edges<T>& a, const Rect<double>& b, RegionRoom& room) noexcept {
  Box box, about;
  if (!is_valid(a, box) || !is_valid(b, about)) return error_shape;
  const Convexity shape = convexity(a);
  if (!shape.convex) return error_not_convex;
  if (!meet(box, about)) return 0;
  if (shape.flat) {
    if (!vesica::overlap(shape.span, b)) return 0;
    const intersection::Vertices found = intersection::region(shape.span, b);
    return write_region(
        [&](const auto& visit) {
          for (int k = 0; k < found.count; ++k) visit(Point<double>{found.at[k].x, found.at[k].y});
        },
        room);
  }
  const ConvexOutline<T> ring(a, shape);
  RectEntered entered(b);
  if (b.hx > 0 && b.hy > 0 && insides_meet_valid(a, box, b)) {
    return write_region([&](const auto& visit) { for_area(ring, entered, visit); }, room);
  }
  return write_region([&](const auto& visit) { entered.for_ends(ring, visit); }, room);
}

/// A path and a segment or a point: pieces, of two vertices each; a single vertex for a point.
template <class T>
std::int64_t pieces_or_error(const Edges<T>& a, const Edge& segment, RegionRoom& room) noexcept {
  Box box, about;
  if (!is_valid(a, box) || !is_valid(segment, about)) return error_shape;
  const auto find = [&](RegionRoom& to) {
    find_pieces(a, box, segment, [&](const Point<double>& start, const Point<double>& end, bool) {
      to.add(start);
      to.add(end);
    });
  };
  // Only a length that overflows makes a crossing that is out of range. Nothing is written then.
  const Box all = together(box, about);
  if (!all_finite(all.max_x - all.min_x, all.max_y - all.min_y)) {
    RegionRoom trial{nullptr, room.is_float, 0};
    find(trial);
    if (trial.error != 0) return trial.error;
  }
  find(room);
  return room.result();
}
template <class T>
std::int64_t pieces_or_error(const Edges<T>& a, const Point<double>& p, RegionRoom& room) noexcept {
  Box box, about;
  if (!is_valid(a, box) || !is_valid(p, about)) return error_shape;
  if (overlap_valid(a, box, p, about)) room.add(p);
  return room.result();
}

/// Does intersection() take a path and another shape? A point or a segment and any path; two polygons, or a polygon and
/// a box or a rectangle.
template <class A, class B>
inline constexpr bool has_shared = false;
template <Path A, class T>
inline constexpr bool has_shared<A, Point<T>> = true;
template <Path A, class T>
inline constexpr bool has_shared<A, Segment<T>> = true;
template <class T>
inline constexpr bool has_shared<Polygon<T>, Aabb<T>> = true;
template <class T>
inline constexpr bool has_shared<Polygon<T>, Rect<T>> = true;
template <class T>
inline constexpr bool has_shared<Polygon<T>, Polygon<T>> = true;

/// For a pair that it takes.
template <class T, class Other>
std::int64_t shared_or_error(const Edges<T>& a, const Other& b, RegionRoom& room) noexcept {
  if constexpr (std::is_same_v<Other, Point<double>> || std::is_same_v<Other, Edge>) {
    return pieces_or_error(a, b, room);
  } else {
    return region_or_error(a, b, room);
  }
}

}  // namespace detail::polygon

/// The number of vertices, or error_shape, error_not_convex or error_range; the first `capacity` are written. Of a
/// segment and a path, two vertices for each piece, in order along the segment; equal ones for a single point. Of
/// others as SharedRegion has them, and as many as both have together at most.
template <template <class> class A, template <class> class B, class T>
std::int64_t intersection_or_error(const A<T>& a, const B<T>& b, Point<T>* out, std::int64_t capacity) noexcept
    requires(detail::polygon::has_shared<A<T>, B<T>> || detail::polygon::has_shared<B<T>, A<T>>) {
  detail::polygon::RegionRoom room{out, std::is_same_v<T, float>, capacity};
  return detail::polygon::with_edges(a, b, [&](const auto& edges, const auto& other, bool) {
    return detail::polygon::shared_or_error(edges, other, room);
  });
}

}  // namespace vesica
