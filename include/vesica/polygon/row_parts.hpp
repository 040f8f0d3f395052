// SPDX-License-Identifier: Apache-2.0
/// How the parts of a path and of a shape that is a row of numbers meet. Exact, by the relations of edges to the shape.
///
/// All such shapes are convex. If no edge of a polygon enters a shape with area, the shape's inside is inside the
/// polygon or outside, as its centre is. The polygon is within the shape if all edges are. A shape without area is cut
/// at the path's vertices on it, and the middle of each piece is asked for, as in topology.hpp.
#pragma once

#include <vesica/de9im.hpp>
#include <vesica/polygon/other.hpp>
#include <vesica/polygon/topology.hpp>

namespace vesica::detail::polygon {

/// A point c + h u. Stored points have no h.
struct End {
  Point<double> c;
  double h, ux, uy;
};

/// A shape of dimension 1: its ends, and the signs of the direction from one to the other.
struct Thin {
  End end[2];
  int x, y;

  /// Does q lie after p, both on the shape?
  bool is_after(const Point<double>& p, const Point<double>& q) const noexcept {
    return x != 0 ? x * compared(q.x, p.x) > 0 : y * compared(q.y, p.y) > 0;
  }
};

inline Thin between(const Point<double>& p, const Point<double>& q) noexcept {
  return {{{p, 0, 0, 0}, {q, 0, 0, 0}}, compared(q.x, p.x), compared(q.y, p.y)};
}
inline Thin about_centre(const Point<double>& c, double h, double ux, double uy) noexcept {
  return {{{c, -h, ux, uy}, {c, h, ux, uy}}, compared(ux, 0.0), compared(uy, 0.0)};
}

/// 0, 1 or 2, the two ends if it is 1, and a point inside.
inline int dimension(const Capsule<double>& s) noexcept {
  return s.r > 0 ? 2 : de9im::dimension(Segment<double>{s.x0, s.y0, s.x1, s.y1});
}
inline int dimension(const RoundRect<double>& s) noexcept {
  return s.r > 0 ? 2 : de9im::dimension(Rect<double>{s.cx, s.cy, s.ux, s.uy, s.hx, s.hy});
}
template <class Shape>
requires form::HasForm<Shape>
int dimension(const Shape& s) noexcept { return de9im::dimension(s); }

inline Thin thin(const Segment<double>& s) noexcept { return between({s.x0, s.y0}, {s.x1, s.y1}); }
inline Thin thin(const Capsule<double>& s) noexcept { return between({s.x0, s.y0}, {s.x1, s.y1}); }
inline Thin thin(const Aabb<double>& s) noexcept { return between({s.min_x, s.min_y}, {s.max_x, s.max_y}); }
inline Thin thin(const Point<double>& s) noexcept { return between(s, s); }
inline Thin thin(const Circle<double>& s) noexcept { return between({s.cx, s.cy}, {s.cx, s.cy}); }
inline Thin thin(const Rect<double>& s) noexcept {
  return s.hx > 0 ? about_centre({s.cx, s.cy}, s.hx, s.ux, s.uy) : about_centre({s.cx, s.cy}, s.hy, -s.uy, s.ux);
}
inline Thin thin(const Ellipse<double>& s) noexcept { return thin(Rect<double>{s.cx, s.cy, s.ux, s.uy, s.a, s.b}); }
inline Thin thin(const RoundRect<double>& s) noexcept { return thin(Rect<double>{s.cx, s.cy, s.ux, s.uy, s.hx, s.hy}); }

template <template <class> class Shape>
Middle centre(const Shape<double>& s) noexcept {
  const Point<double> p = stored_point(s);
  return {p, p};
}
inline Middle centre(const Segment<double>& s) noexcept { return {{s.x0, s.y0}, {s.x1, s.y1}}; }
inline Middle centre(const Capsule<double>& s) noexcept { return {{s.x0, s.y0}, {s.x1, s.y1}}; }
inline Middle centre(const Aabb<double>& s) noexcept { return {{s.min_x, s.min_y}, {s.max_x, s.max_y}}; }

/// The relation of an edge to a valid shape, and whether the two insides meet.
template <template <class> class Shape>
Relation edge_relation(const Edge& e, const Shape<double>& s) noexcept {
  return vesica::relation(e, s);
}
template <template <class> class Shape>
bool edge_insides_meet(const Edge& e, const Shape<double>& s) noexcept {
  return vesica::interiors_overlap(e, s);
}

/// The path is a, the shape is b.
template <class T, class Row>
class RowParts {
 public:
  RowParts(const Edges<T>& a, const Box& box, const Row& b, Asked asked) noexcept
      : a_(a, box), b_(b), about_(box_about(b)), asked_(asked) {}

  Parts find() noexcept {
    const int dimension_b = dimension(b_);
    if (dimension_b == 2) {
      find_area();
    } else if (dimension_b == 1) {
      find_thin();
      if (asked_ == Asked::matrix) ask_ends_of_thin();
    } else {
      find_point();
    }
    return parts_;
  }

 protected:
  bool may_meet(const Edge& e) const noexcept { return polygon::meet(box_of(e), about_); }

  /// Notes a piece of a's edge i that is inside b (1) or outside (-1).
  void note_piece(std::int64_t i, int place) noexcept {
    const Part part = place > 0 ? inside_part : outside_part;
    const int dimension = a_.ring_dimension(i);
    parts_.note(a_.part_of_edges(), part, dimension == 0 ? 0 : 1);
    if (!a_.has_area()) return;
    if (dimension < 2) return parts_.note(a_.part_beside(i, true), part, 2);
    parts_.note(inside_part, part, 2);
    if (place > 0) parts_.note(outside_part, part, 2);
  }

  void find_area() noexcept {
    if (!a_.has_area()) parts_.note(outside_part, inside_part, 2);
    const bool settled = a_.edges.for_edges([&](const Edge& e, std::int64_t i) {
      ask_edge_of_area(e, i);
      return parts_.settled(asked_);
    });
    if (settled || !a_.has_area() || parts_.meet(outline_part, inside_part)) return;
    const int place = a_.locate(centre(b_));
    if (place != 0) parts_.note(place > 0 ? inside_part : outside_part, inside_part, 2);
  }

  void ask_edge_of_area(const Edge& e, std::int64_t i) noexcept {
    const Relation r = may_meet(e) ? edge_relation(e, b_) : Relation::disjoint;
    const bool within = r == Relation::inside || r == Relation::inside_touch;
    if (!within) note_piece(i, -1);
    if (r == Relation::disjoint) return;
    if (r != Relation::inside) parts_.note(a_.part_of_edges(), outline_part, 0);
    if (r == Relation::cross || r == Relation::inside || (r == Relation::inside_touch && edge_insides_meet(e, b_))) {
      note_piece(i, 1);
    }
  }

  /// b is a line. A piece of b is inside a (1) or outside (-1).
  void note_piece_of_b(int place) noexcept {
    if (place != 0) parts_.note(place > 0 ? inside_part : outside_part, inside_part, 1);
  }

  void find_thin() noexcept {
    const bool settled = a_.edges.for_edges([&](const Edge& e, std::int64_t i) {
      ask_edge_of_thin(e, i);
      return parts_.settled(asked_);
    });
    if (!settled) ask_pieces_of_thin();
  }

  /// A point of a on b: 0 elsewhere, 1 in b's inside, 2 at an end.
  int place_on_thin(const Point<double>& v) const noexcept {
    if (!holds(about_, v)) return 0;
    const Relation r = edge_relation({v.x, v.y, v.x, v.y}, b_);
    return r == Relation::inside ? 1 : r == Relation::inside_touch ? 2 : 0;
  }

  /// As in topology.hpp, for an edge that b crosses.
  bool is_alone(const Edge& e) noexcept {
    bool alone = true;
    a_.for_edges_near(shared(box_of(e), about_), [&](const Edge& g, std::int64_t) {
      const int place0 = place_on_thin(start_of(g)), place1 = place_on_thin(end_of(g));
      const int t0 = side(g.x0, g.y0, e), t1 = side(g.x1, g.y1, e);
      const bool along = t0 * t1 < 0 && is_stretch(edge_relation(g, b_), place0 != 0 || place1 != 0);
      if ((place0 != 0 && t0 == 0) || (place1 != 0 && t1 == 0) || along) alone = false;
    });
    return alone;
  }
  /// Does an edge of this relation to b share more than a point with it?
  static bool is_stretch(Relation r, bool vertex_met) noexcept {
    return r == Relation::cross ? vertex_met : r != Relation::disjoint && r != Relation::touch;
  }

  void ask_edge_of_thin(const Edge& e, std::int64_t i) noexcept {
    const Relation r = may_meet(e) ? edge_relation(e, b_) : Relation::disjoint;
    const bool within = r == Relation::inside || r == Relation::inside_touch || r == Relation::equal;
    if (!within) note_piece(i, -1);
    if (r == Relation::disjoint) return;
    bool vertex_met = false;
    for (const Point<double>& v : {start_of(e), end_of(e)}) {
      const int place = place_on_thin(v);
      vertex_met = vertex_met || place != 0;
      if (place != 0) parts_.note(a_.part_at(v), place == 1 ? inside_part : outline_part, 0);
    }
    if (!has_length(e)) return;
    if (r == Relation::cross && !vertex_met) {
      parts_.note(a_.part_of_edges(), inside_part, 0);
      if (a_.has_area() && a_.ring_dimension(i) < 2) {
        note_piece_of_b(a_.part_beside(i, true) == inside_part ? 1 : -1);
      } else if (is_alone(e)) {
        if (a_.has_area()) note_piece_of_b(1);
        note_piece_of_b(-1);
      }
    } else if (r == Relation::touch) {
      if (!vertex_met) parts_.note(a_.part_of_edges(), outline_part, 0);
    } else {
      parts_.note(a_.part_of_edges(), inside_part, 1);
      // One of b's ends is on the edge, and is no vertex.
      const bool holds_end = r == Relation::cross || r == Relation::contains || r == Relation::contains_touch;
      if (holds_end) parts_.note(a_.part_of_edges(), outline_part, 0);
    }
  }

  /// The pieces between a's vertices on b, from one of b's ends to the other.
  void ask_pieces_of_thin() noexcept {
    const Thin line = thin(b_);
    std::optional<Point<double>> from;
    while (true) {
      std::optional<Point<double>> next;
      a_.for_edges_near(about_, [&](const Edge& e, std::int64_t) {
        for (const Point<double>& v : {start_of(e), end_of(e)}) {
          if ((from && !line.is_after(*from, v)) || (next && !line.is_after(v, *next))) continue;
          if (place_on_thin(v) == 1) next = v;
        }
      });
      if (!from && !next) {
        note_piece_of_b(a_.locate(centre(b_)));
        return;
      }
      const End& end = line.end[from ? 1 : 0];
      note_piece_of_b(
          a_.locate(from && next ? Middle(*from, *next) : Middle(from ? *from : *next, end.c, end.h, end.ux, end.uy)));
      if (!next || parts_.settled(asked_)) return;
      from = next;
    }
  }

  /// The ends of a polyline; find(v) is the part of b at v.
  template <class Find>
  void ask_ends(const Find& find) noexcept {
    if (a_.has_area()) return;
    for (std::int64_t j = 0; j < a_.edges.rings(); ++j) {
      const Range chain = a_.edges.ring(j);
      for (const std::int64_t i : {chain.first, chain.last - 1}) {
        if (chain.length() == 0) continue;
        const Point<double> v = a_.edges.vertex(i);
        if (a_.part_at(v) == outline_part) parts_.note(outline_part, find(v), 0);
      }
    }
  }
  /// The ends of both that are not on the other shape.
  void ask_ends_of_thin() noexcept {
    ask_ends([&](const Point<double>& v) {
      const int place = place_on_thin(v);
      return place == 0 ? outside_part : place == 1 ? inside_part : outline_part;
    });
    for (const End& end : thin(b_).end) {
      // A middle halves h u.
      const double up = lane::abs(end.h) < 1 ? 2 : 1;
      const int place = a_.locate(Middle(end.c, end.c, end.h * up, end.ux * (2 / up), end.uy * (2 / up)));
      if (place != 0) parts_.note(place > 0 ? inside_part : outside_part, outline_part, 0);
    }
  }

  void find_point() noexcept {
    const Point<double> p = stored_point(b_);
    const int place = a_.locate(p);
    const Part part = place > 0 ? inside_part : place < 0 ? outside_part : a_.part_at(p);
    parts_.note(part, inside_part, 0);
    a_.edges.for_edges([&](const Edge& e, std::int64_t i) {
      if (has_length(e) || !same(p, start_of(e))) note_piece(i, -1);
      return parts_.settled(asked_);
    });
    ask_ends([&](const Point<double>& v) { return same(p, v) ? inside_part : outside_part; });
  }

  Outline<T> a_;
  const Row& b_;
  Box about_;
  Asked asked_;
  Parts parts_;
};

}  // namespace vesica::detail::polygon
