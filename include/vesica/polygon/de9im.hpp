// SPDX-License-Identifier: Apache-2.0
/// de9im() of polygons and polylines. Exact, by the matrices of edges.
///
/// A shape that is a row of numbers and has an area is convex. What its outline shares with a polygon's inside is known
/// beside each place where the outlines meet: an edge that crosses there has inside on one side and outside on the
/// other. At a vertex on the outline, edges that enter the shape divide the directions between the outline's two ways
/// on; their number says which of these are inside.
#pragma once

#include <vesica/polygon/depth.hpp>

namespace vesica {

namespace detail::polygon {

/// The point v + s u + s^2 n: u leads from a stored point v to another one, n to the left of u, and s is as small as
/// need be.
struct Ahead {
  Point<double> v;
  const Middle& to;

  int order_x(double x) const noexcept { return first_of(compared(x, v.x), -to_x(), to_y()); }
  int order_y(double y) const noexcept { return first_of(compared(y, v.y), -to_y(), -to_x()); }
  int side(const Edge& e) const noexcept {
    const int along_x = compared(e.x1, e.x0) * to_x(), along_y = compared(e.y1, e.y0) * to_y();
    const int s = polygon::side(v.x, v.y, e);
    return s != 0 ? s : first_of(to.side(e), along_x, along_y);
  }

 private:
  static int first_of(int a, int b, int c) noexcept { return a != 0 ? a : b != 0 ? b : c; }
  int to_x() const noexcept { return -to.order_x(v.x); }
  int to_y() const noexcept { return -to.order_y(v.y); }
};

/// The matrix of an edge and a valid shape.
template <template <class> class Shape>
NineIntersections edge_matrix(const Edge& e, const Shape<double>& s) noexcept {
  NineIntersections m;
  vesica::de9im_or_error(e, s, m);
  return m;
}

/// A path, and a shape with area.
template <class T, class Row>
class RowMatrix : RowParts<T, Row> {
  using Base = RowParts<T, Row>;
  using Base::a_;
  using Base::b_;
  using Base::parts_;

 public:
  RowMatrix(const Edges<T>& a, const Box& box, const Row& b) noexcept
      : Base(a, box, b, Asked::matrix), centre_(centre(b)), from_outline_(centre_) {}

  Parts find() noexcept {
    if (!a_.has_area()) {
      // Straight edges do not cover the outline: a box whose corners are stored is asked as a polygon.
      parts_.note(outside_part, inside_part, 2);
      parts_.note(outside_part, outline_part, 1);
      this->ask_ends([&](const Point<double>& v) { return place(v); });
    }
    a_.edges.for_edges([&](const Edge& e, std::int64_t i) {
      ask_edge(e, i);
      return false;
    });
    if (!a_.has_area()) return parts_;
    if (!outlines_meet_) note_outline(from_outline_.odd());
    if (!parts_.meet(outline_part, inside_part)) {
      parts_.note(a_.locate(centre_) > 0 ? inside_part : outside_part, inside_part, 2);
    }
    return parts_;
  }

 private:
  Part place(const Point<double>& v) const noexcept {
    const Relation r = holds(this->about_, v) ? edge_relation({v.x, v.y, v.x, v.y}, b_) : Relation::disjoint;
    return r == Relation::inside ? inside_part : r == Relation::inside_touch ? outline_part : outside_part;
  }
  /// A piece of b's outline is inside the polygon, or outside.
  void note_outline(bool inside) noexcept { parts_.note(inside ? inside_part : outside_part, outline_part, 1); }

  void ask_edge(const Edge& e, std::int64_t i) noexcept {
    const NineIntersections m =
        this->may_meet(e) ? edge_matrix(e, b_) : NineIntersections{{'F', 'F', '1', 'F', 'F', '0', '2', '1', '2', 0}};
    if (m.at[0] != 'F') this->note_piece(i, 1);
    if (m.at[2] != 'F') this->note_piece(i, -1);
    if (m.at[1] == 'F' && m.at[4] == 'F') {
      if (m.at[0] == 'F') from_outline_.add(e);  // no edge inside b is between its centre and its outline
      return;
    }
    outlines_meet_ = true;
    if (!a_.has_area()) {
      if (m.at[1] != 'F')
        parts_.note(has_length(e) ? inside_part : a_.part_at(start_of(e)), outline_part, m.at[1] - '0');
      for (const Point<double>& v : {start_of(e), end_of(e)}) {
        if (m.at[4] != 'F' && place(v) == outline_part) parts_.note(a_.part_at(v), outline_part, 0);
      }
      return;
    }
    parts_.note(outline_part, outline_part, m.at[1] == '1' ? 1 : 0);
    if (place(start_of(e)) == outline_part) ask_vertex(start_of(e));
    if (has_length(e) && m.at[1] != 'F') ask_inside_edge(e, i, m);
  }

  /// The places of b's outline inside edge i, except those at other vertices of the polygon.
  void ask_inside_edge(const Edge& e, std::int64_t i, const NineIntersections& m) noexcept {
    const Part from = place(start_of(e)), to = place(end_of(e));
    const bool stretch = m.at[1] == '1', enters = m.at[0] != 'F';
    int places = stretch  ? (from != outline_part ? 1 : 0) + (to != outline_part ? 1 : 0)
                 : enters ? (from == outside_part ? 1 : 0) + (to == outside_part ? 1 : 0)
                          : 1;
    std::optional<Point<double>> known;
    a_.for_edges_near(box_of(e), [&](const Edge& g, std::int64_t) {
      const Point<double> v = start_of(g);
      if (same(v, start_of(e)) || same(v, end_of(e)) || (known && same(v, *known))) return;
      if (side(v.x, v.y, e) != 0 || !holds(box_of(e), v) || place(v) != outline_part) return;
      known = v;
      --places;
    });
    if (places <= 0) return;
    if (a_.ring_dimension(i) == 2 && enters) {
      note_outline(true);
      note_outline(false);
    } else {
      note_outline(a_.part_beside(i, centre_.side(e) > 0) == inside_part);
    }
  }

  /// A vertex on b's outline, which leads on to the left and to the right, seen towards b's centre.
  void ask_vertex(const Point<double>& v) noexcept {
    bool inside_left = a_.is_odd(Ahead{v, centre_}), inside_right = inside_left, along_left = false,
         along_right = false;
    a_.for_edges_near({v.x, v.y, v.x, v.y}, [&](const Edge& g, std::int64_t) {
      if (side(v.x, v.y, g) != 0) return;
      for (const Point<double>& w : {start_of(g), end_of(g)}) {
        if (same(v, w)) continue;
        const Edge e{v.x, v.y, w.x, w.y};
        const NineIntersections m = edge_matrix(e, b_);
        const int to_centre = centre_.side(e);
        if (m.at[1] == '1') (to_centre < 0 ? along_left : along_right) = true;
        if (m.at[0] == 'F') continue;
        (to_centre < 0 ? inside_left : inside_right) ^= true;
      }
    });
    if (!along_left) note_outline(inside_left);
    if (!along_right) note_outline(inside_right);
  }

  Middle centre_;
  Ray<Middle> from_outline_;
  bool outlines_meet_ = false;
};

/// The corners of a box with area, if they are numbers of type T; nothing for other shapes.
template <class T>
struct StoredCorners {
  T x[4], y[4];
  bool found = false;

  template <class Row>
  explicit StoredCorners(const Row& b) noexcept {
    const CoreForm core = core_form(b);
    if (core.radius > 0 || core.form.curved || dimension(b) != 2) return;
    const crossings::Corners corners(exact_core(b));
    found = true;
    for (int i = 0; i < 4; ++i) {
      found = found && is_stored(corners.x[i], x[i]) && is_stored(corners.y[i], y[i]);
    }
  }

 private:
  static bool is_stored(const crossings::Position& p, T& out) noexcept {
    out = static_cast<T>(crossings::nearest(p));
    return all_finite(out) && exact::compare(crossings::Position(exact::from_double(static_cast<double>(out))), p) == 0;
  }
};

/// For valid shapes.
template <class T>
NineIntersections matrix_valid(const Edges<T>& a, const Box& box_a, const Edges<T>& b, const Box& box_b) noexcept;

template <class T, class Row>
NineIntersections matrix_valid(const Edges<T>& a, const Box& box, const Row& b) noexcept {
  if (const auto segment = flat(a)) return edge_matrix(*segment, b);
  const StoredCorners<T> corners(b);
  if (corners.found) {
    const Polygon<T> polygon{corners.x, corners.y, sizeof(T), nullptr, 4};
    return matrix_valid(a, box, Edges<T>(polygon), box_about(b));
  }
  if (dimension(b) == 2) return RowMatrix<T, Row>(a, box, b).find().matrix();
  return RowParts<T, Row>(a, box, b, Asked::matrix).find().matrix();
}
template <class T>
NineIntersections matrix_valid(const Edges<T>& a, const Box& box_a, const Edges<T>& b, const Box& box_b) noexcept {
  if (const auto segment = flat(b)) return matrix_valid(a, box_a, *segment);
  if (const auto segment = flat(a)) return de9im::transposed(matrix_valid(b, box_b, *segment));
  return PathParts<T>(a, box_a, b, box_b, Asked::matrix).find().matrix();
}

template <class T, class Other>
std::int32_t de9im_or_error(const Edges<T>& a, const Other& b, bool reversed, NineIntersections& out) noexcept {
  return if_valid(a, b, [&](const auto&... s) {
    const NineIntersections m = matrix_valid(s...);
    out = reversed ? de9im::transposed(m) : m;
    return 0;
  });
}

}  // namespace detail::polygon

/// The checked form with a polygon or a polyline, in either order: 0 or error_shape. Polygons must be simple.
template <template <class> class A, template <class> class B, class T>
std::int32_t de9im_or_error(const A<T>& a, const B<T>& b,
                            NineIntersections& out) noexcept requires AnyPath<A<T>, B<T>> {
  return detail::polygon::with_edges(a, b, [&](const auto& edges, const auto& other, bool reversed) {
    return detail::polygon::de9im_or_error(edges, other, reversed, out);
  });
}

}  // namespace vesica
