// SPDX-License-Identifier: Apache-2.0
/// How the parts of two paths meet. Exact, and no point is constructed but the middle between two stored ones.
///
/// The inside of a polygon is open and its outline is its edges. The outline of a polyline is the points where an odd
/// number of its chains end; its inside is the rest of it.
///
/// Edges that cross at a point inside both settle nearly everything, unless a path touches itself there. Otherwise
/// outlines meet at stored vertices alone. These cut an edge of one path into pieces, each of which is inside the other
/// path, along its edges, or outside. The middle of a piece says which. A ring that meets no edge lies where its first
/// vertex does.
///
/// Proved: for two polygons, this decides which of the sets "inside a and inside b", "inside a, outside b" and "outside
/// a, inside b" are empty. Take a point of such a set, and the connected part of a's inside (or outside) that it lies
/// in. If b's outline enters this part, a piece of b is inside (outside) a. If not, the part lies on one side of b, and
/// so do its own edges: each is a piece inside or outside b, or it is shared, and then both insides are on one side of
/// it or on opposite sides. Each of these is noted below.
#pragma once

#include <optional>
#include <vesica/polygon/parts.hpp>
#include <vesica/polygon/place.hpp>

namespace vesica::detail::polygon {

constexpr bool same(const Point<double>& p, const Point<double>& q) noexcept { return p.x == q.x && p.y == q.y; }
constexpr Point<double> start_of(const Edge& e) noexcept { return {e.x0, e.y0}; }
constexpr Point<double> end_of(const Edge& e) noexcept { return {e.x1, e.y1}; }
constexpr bool holds(const Box& box, const Point<double>& p) noexcept { return meet(box, {p.x, p.y, p.x, p.y}); }

/// Does p lie ahead of `from` in the direction of `to`? All are on one line, and from and to differ.
constexpr bool is_ahead(const Point<double>& from, const Point<double>& to, const Point<double>& p) noexcept {
  return from.x != to.x ? (p.x > from.x) == (to.x > from.x) && p.x != from.x
                        : (p.y > from.y) == (to.y > from.y) && p.y != from.y;
}

/// The ring of vertex i: the last one that begins at or before it.
template <class T>
Range ring_of(const Edges<T>& path, std::int64_t i) noexcept {
  std::int64_t low = 0, high = path.rings();
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (path.ring(middle).first <= i ? low : high) = middle;
  }
  return path.ring(low);
}

/// A path whose places are asked for. What that needs is made at the first question.
template <class T>
class Outline {
 public:
  Outline(const Edges<T>& path, const Box& bounds) noexcept : edges(path), box(bounds) {}

  const Edges<T>& edges;
  const Box& box;

  bool has_area() const noexcept { return edges.closed(); }

  template <class Place>
  int locate(const Place& place) noexcept {
    return locator().locate(place);
  }
  /// Is a place inside a polygon, if it is on no edge of a length?
  template <class Place>
  bool is_odd(const Place& place) noexcept {
    return locator().is_odd(place);
  }
  int locate(const Point<double>& p) noexcept { return holds(box, p) ? locate(Stored{p}) : -1; }

  /// The part of the path that its edges belong to.
  Part part_of_edges() const noexcept { return has_area() ? outline_part : inside_part; }
  /// The part that a point on an edge belongs to.
  Part part_at(const Point<double>& p) const noexcept {
    if (has_area()) return outline_part;
    bool odd = false;
    for (std::int64_t j = 0; j < edges.rings(); ++j) {
      const Range chain = edges.ring(j);
      if (chain.length() == 0) continue;
      odd ^= same(edges.vertex(chain.first), p) != same(edges.vertex(chain.last - 1), p);
    }
    return odd ? outline_part : inside_part;
  }

  /// 0 if the ring of vertex i is one place, 1 if it is a chain or a segment there and back, otherwise 2.
  int ring_dimension(std::int64_t i) noexcept {
    if (i < ring_.first || i >= ring_.last) find_ring(i);
    return ring_dimension_;
  }
  /// Is a ring of a polygon more than a point or a segment?
  bool has_inside() noexcept {
    for (std::int64_t j = 0; has_area() && j < edges.rings(); ++j) {
      if (edges.ring(j).length() > 0 && ring_dimension(edges.ring(j).first) == 2) return true;
    }
    return false;
  }
  /// The part of a polygon beside edge i, on its left or its right. All edges of a ring have the inside on the same
  /// side; those of a ring without area have the same on both sides.
  Part part_beside(std::int64_t i, bool left) noexcept {
    const int dimension = ring_dimension(i);
    if (!side_is_known_) {
      const Edge e = first_edge(ring_);
      left_is_inside_ = dimension == 0 ? is_odd(Stored{start_of(e)}) : locate(Beside(e)) > 0;
      side_is_known_ = true;
    }
    return (left || dimension < 2) == left_is_inside_ ? inside_part : outside_part;
  }

  /// The point of e nearest to v, between v and `to`, that is a vertex here; `to` if there is none.
  Point<double> next_cut(const Edge& e, const Point<double>& v, Point<double> to) noexcept {
    locator().for_edges_near(box_of({v.x, v.y, to.x, to.y}), [&](const Edge& f, std::int64_t) {
      for (const Point<double>& w : {start_of(f), end_of(f)}) {
        if (holds(box_of({v.x, v.y, to.x, to.y}), w) && !same(w, v) && side(w.x, w.y, e) == 0) to = w;
      }
    });
    return to;
  }

  template <class Visit>
  void for_edges_near(const Box& about, Visit visit) noexcept {
    locator().for_edges_near(about, visit);
  }

  /// From a ring's first vertex to the next one elsewhere.
  Edge first_edge(const Range& ring) const noexcept {
    const Point<double> v = edges.vertex(ring.first);
    Point<double> w = v;
    for (std::int64_t k = ring.first + 1; k < ring.last && same(v, w); ++k) w = edges.vertex(k);
    return {v.x, v.y, w.x, w.y};
  }
  /// The vertex before vertex i on its ring; i's own if there is none.
  Point<double> vertex_before(std::int64_t i) const noexcept {
    const Range ring = ring_of(edges, i);
    if (i > ring.first) return edges.vertex(i - 1);
    return edges.vertex(edges.closed() ? ring.last - 1 : i);
  }

 private:
  const Locator<T>& locator() noexcept {
    if (!locator_) locator_.emplace(edges);
    return *locator_;
  }

  void find_ring(std::int64_t i) noexcept {
    ring_ = ring_of(edges, i);
    side_is_known_ = false;
    const Point<double> first = edges.vertex(ring_.first);
    Point<double> second = first;
    ring_dimension_ = 0;
    for (std::int64_t k = ring_.first; k < ring_.last && ring_dimension_ < (has_area() ? 2 : 1); ++k) {
      const Point<double> p = edges.vertex(k);
      if (same(p, first) || same(p, second)) continue;
      second = p;
      ++ring_dimension_;
    }
  }

  std::optional<Locator<T>> locator_;
  Range ring_{0, 0};  // the last one asked for
  int ring_dimension_ = 0;
  bool side_is_known_ = false, left_is_inside_ = false;
};

/// Finds how the parts of two paths meet, from their edges.
template <class T>
class PathParts {
 public:
  PathParts(const Edges<T>& a, const Box& box_a, const Edges<T>& b, const Box& box_b, Asked asked) noexcept
      : a_(a, box_a), b_(b, box_b), asked_(asked) {}

  Parts find() noexcept {
    // A polygon has points that are on no line.
    if (!b_.has_area() && a_.has_inside()) parts_.note(inside_part, outside_part, 2);
    if (!a_.has_area() && b_.has_inside()) parts_.note(outside_part, inside_part, 2);
    if (!walk(a_.edges, a_.box, b_.edges, b_.box, Policy{*this})) {
      if (!ask_rings(a_, b_, false)) ask_rings(b_, a_, true);
    }
    if (asked_ == Asked::matrix) {
      ask_ends(a_, b_, false);
      ask_ends(b_, a_, true);
    }
    return parts_;
  }

 private:
  struct Policy {
    PathParts& parts;
    bool keeps(const Box& a, const Box& b) const noexcept { return meet(a, b); }
    bool visit(const Edge& e, std::int64_t i, const Edge& f, std::int64_t j) const noexcept {
      return parts.visit(e, i, f, j);
    }
  };

  /// Notes a part of p and one of q, which are a and b, or if `exchanged` b and a.
  void note(bool exchanged, Part p, Part q, int dimension) noexcept {
    exchanged ? parts_.note(q, p, dimension) : parts_.note(p, q, dimension);
  }
  /// Notes a piece of p's edge i that is inside q (1) or outside (-1).
  void note_piece(bool exchanged, Outline<T>& p, std::int64_t i, int place) noexcept {
    if (place == 0) return;
    const Part part = place > 0 ? inside_part : outside_part;
    const int dimension = p.ring_dimension(i);
    note(exchanged, p.part_of_edges(), part, dimension == 0 ? 0 : 1);
    if (!p.has_area()) return;
    if (dimension < 2) return note(exchanged, p.part_beside(i, true), part, 2);
    // Beside an edge are points inside and points outside.
    note(exchanged, inside_part, part, 2);
    if (place > 0) note(exchanged, outside_part, part, 2);
  }
  void note_point(const Point<double>& v) noexcept { parts_.note(a_.part_at(v), b_.part_at(v), 0); }

  /// A polygon always has points outside a polyline, so its pieces are of interest for a matrix alone.
  bool asks_pieces(const Outline<T>& p, const Outline<T>& q) const noexcept {
    return asked_ == Asked::matrix || !p.has_area() || q.has_area();
  }

  bool visit(const Edge& e, std::int64_t i, const Edge& f, std::int64_t j) noexcept {
    if (!has_length(e) || !has_length(f)) return false;
    const int s0 = side(f.x0, f.y0, e), s1 = side(f.x1, f.y1, e);
    if (s0 * s1 > 0) return false;
    const int t0 = side(e.x0, e.y0, f), t1 = side(e.x1, e.y1, f);
    if (t0 * t1 > 0) return false;
    const bool on_one_line = s0 == 0 && s1 == 0;
    const Box box_e = box_of(e), box_f = box_of(f), common = shared(box_e, box_f);
    if (on_one_line && (common.min_x < common.max_x || common.min_y < common.max_y)) {
      note_stretch(e, i, f, j);
    } else if (s0 * s1 < 0 && t0 * t1 < 0) {
      note_crossing(e, i, f, j, common);
      return parts_.settled(asked_);
    } else {
      note_point(s0 == 0 && holds(box_e, start_of(f))   ? start_of(f)
                 : s1 == 0 && holds(box_e, end_of(f))   ? end_of(f)
                 : t0 == 0 && holds(box_f, start_of(e)) ? start_of(e)
                                                        : end_of(e));
    }
    if (parts_.settled(asked_)) return true;
    if (asks_pieces(a_, b_)) ask_pieces(false, a_, e, i, b_, f, j, s0, s1, t0, t1);
    if (asks_pieces(b_, a_)) ask_pieces(true, b_, f, j, a_, e, i, t0, t1, s0, s1);
    return parts_.settled(asked_);
  }

  void note_crossing(const Edge& e, std::int64_t i, const Edge& f, std::int64_t j, const Box& common) noexcept {
    parts_.note(a_.part_of_edges(), b_.part_of_edges(), 0);
    if (is_alone(f, b_, e, common)) note_both_pieces(false, a_, i, b_, j);
    if (is_alone(e, a_, f, common)) note_both_pieces(true, b_, j, a_, i);
  }
  /// The pieces of p's edge i on both sides of q's edge j.
  void note_both_pieces(bool exchanged, Outline<T>& p, std::int64_t i, Outline<T>& q, std::int64_t j) noexcept {
    const bool differ = q.has_area() && q.ring_dimension(j) == 2;
    const bool enters = differ || (q.has_area() && q.part_beside(j, true) == inside_part);
    if (enters) note_piece(exchanged, p, i, 1);
    if (differ || !enters) note_piece(exchanged, p, i, -1);
  }
  /// Does edge f alone decide where e's points beside their crossing lie in q? Not if q has a vertex there, which other
  /// pairs of edges ask for, or another edge that lies along e.
  bool is_alone(const Edge& f, Outline<T>& q, const Edge& e, const Box& common) noexcept {
    bool alone = true;
    q.for_edges_near(common, [&](const Edge& g, std::int64_t) {
      const int s0 = side(g.x0, g.y0, e), s1 = side(g.x1, g.y1, e);
      if (s0 != 0 && s1 != 0) return;
      const int t0 = side(g.x0, g.y0, f), t1 = side(g.x1, g.y1, f);
      if ((s0 == 0 && t0 == 0) || (s1 == 0 && t1 == 0) || (s0 == 0 && s1 == 0 && t0 * t1 < 0)) alone = false;
    });
    return alone;
  }

  /// The ends of two edges on one line, where an end of a polyline may be.
  void note_ends(const Edge& e, const Edge& f) noexcept {
    const Box common = shared(box_of(e), box_of(f));
    for (const Point<double>& v : {start_of(e), end_of(e), start_of(f), end_of(f)}) {
      if (holds(common, v)) note_point(v);
    }
  }

  void note_stretch(const Edge& e, std::int64_t i, const Edge& f, std::int64_t j) noexcept {
    parts_.note(a_.part_of_edges(), b_.part_of_edges(), 1);
    if (!a_.has_area() || !b_.has_area()) return note_ends(e, f);
    const bool one_way = e.x0 != e.x1 ? (e.x0 < e.x1) == (f.x0 < f.x1) : (e.y0 < e.y1) == (f.y0 < f.y1);
    for (const bool left : {true, false}) {
      parts_.note(a_.part_beside(i, left), b_.part_beside(j, left == one_way), 2);
    }
  }

  /// Asks where the pieces of p's edge e lie that end where e meets q's edge f. A vertex of q is asked for at the edge
  /// that begins there.
  void ask_pieces(bool exchanged, Outline<T>& p, const Edge& e, std::int64_t i, Outline<T>& q, const Edge& f,
                  std::int64_t j, int s0, int s1, int t0, int t1) noexcept {
    const Box box = box_of(e);
    if (s0 == 0 && holds(box, start_of(f))) {
      ask_both_ways(exchanged, p, e, i, q, start_of(f), end_of(f), q.vertex_before(j));
    }
    if (s1 == 0 && !q.edges.closed() && holds(box, end_of(f))) {
      ask_both_ways(exchanged, p, e, i, q, end_of(f), start_of(f), start_of(f));
    }
    if (s0 == 0 || s1 == 0) return;
    if (t0 == 0) ask_piece(exchanged, p, e, i, q, start_of(e), end_of(e));
    if (t1 == 0) ask_piece(exchanged, p, e, i, q, end_of(e), start_of(e));
  }

  /// Does an edge from v to w lie along e towards `to`?
  static bool lies_along(const Edge& e, const Point<double>& v, const Point<double>& to,
                         const Point<double>& w) noexcept {
    return is_ahead(v, to, w) && side(w.x, w.y, e) == 0;
  }

  /// The pieces at v, where q's edges lead to two neighbours: pieces along these are no news.
  void ask_both_ways(bool exchanged, Outline<T>& p, const Edge& e, std::int64_t i, Outline<T>& q,
                     const Point<double>& v, const Point<double>& next, const Point<double>& before) noexcept {
    for (const Point<double>& to : {start_of(e), end_of(e)}) {
      if (same(v, to) || lies_along(e, v, to, next) || lies_along(e, v, to, before)) continue;
      ask_piece(exchanged, p, e, i, q, v, to);
    }
  }

  void ask_piece(bool exchanged, Outline<T>& p, const Edge& e, std::int64_t i, Outline<T>& q, const Point<double>& v,
                 const Point<double>& to) noexcept {
    note_piece(exchanged, p, i, q.locate(Middle(v, q.next_cut(e, v, to))));
  }

  /// Returns true once all is known. No edge meets a ring of one place, so it is always asked for.
  bool ask_rings(Outline<T>& p, Outline<T>& q, bool exchanged) noexcept {
    const bool all = asks_pieces(p, q);
    for (std::int64_t j = 0; j < p.edges.rings(); ++j) {
      const Range ring = p.edges.ring(j);
      if (ring.length() == 0 || !(all || p.ring_dimension(ring.first) == 0)) continue;
      const Point<double> v = p.edges.vertex(ring.first);
      const int place = q.locate(v);
      if (place == 0) {
        note_point(v);
        // No edge passes through a point: the piece behind it is asked for here.
        const Edge e = p.first_edge(ring);
        if (has_length(e)) ask_piece(exchanged, p, e, ring.first, q, v, end_of(e));
      } else {
        note_piece(exchanged, p, ring.first, place);
      }
      if (parts_.settled(asked_)) return true;
    }
    return false;
  }

  /// The ends of a polyline.
  void ask_ends(const Outline<T>& p, Outline<T>& q, bool exchanged) noexcept {
    if (p.has_area()) return;
    for (std::int64_t j = 0; j < p.edges.rings(); ++j) {
      const Range chain = p.edges.ring(j);
      for (const std::int64_t i : {chain.first, chain.last - 1}) {
        if (chain.length() == 0 || p.part_at(p.edges.vertex(i)) != outline_part) continue;
        const Point<double> v = p.edges.vertex(i);
        const int place = q.locate(v);
        note(exchanged, outline_part, place > 0 ? inside_part : place < 0 ? outside_part : q.part_at(v), 0);
      }
    }
  }

  Outline<T> a_, b_;
  Asked asked_;
  Parts parts_;
};

}  // namespace vesica::detail::polygon
