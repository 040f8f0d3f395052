// SPDX-License-Identifier: Apache-2.0
/// crossings() of polygons and polylines: the places on each edge, in order along the path, each place once.
///
/// A place is a stored vertex on the other outline, or a point inside two edges that cross. Signs decide which, and
/// their order along an edge, exactly. Both outlines may share a stretch: its ends are places, and vertices within it
/// are not, unless an outline turns there.
#pragma once

#include <vesica/crossings.hpp>
#include <vesica/polygon/relation.hpp>

namespace vesica {

namespace detail::polygon {

/// The caller's room for places, as points of doubles or floats. The first `capacity` are written, and all counted.
struct Room {
  void* out;
  bool is_float;
  std::int64_t capacity, count = 0;
  bool shared = false;
  std::int32_t error = 0;

  void add(const Point<double>& p) noexcept { is_float ? store<float>(p) : store<double>(p); }
  std::int64_t result() const noexcept { return error != 0 ? error : count; }

 private:
  template <class T>
  void store(const Point<double>& p) noexcept {
    const Point<T> at{static_cast<T>(p.x), static_cast<T>(p.y)};
    if (!all_finite(at.x, at.y)) error = error_range;
    if (count < capacity) static_cast<Point<T>*>(out)[count] = at;
    ++count;
  }
};

/// -1 if p comes before q along an edge, 1 if after. Both are on its line.
inline int order_along(const Edge& e, const Point<double>& p, const Point<double>& q) noexcept {
  const int x = compared(e.x1, e.x0);
  return x != 0 ? x * compared(p.x, q.x) : compared(e.y1, e.y0) * compared(p.y, q.y);
}
inline bool is_on(const Point<double>& p, const Edge& e) noexcept {
  return holds(box_of(e), p) && side(p.x, p.y, e) == 0;
}

/// The same edge in one direction, so that a place has the same bits whichever way a path goes.
inline Edge upward(const Edge& e) noexcept {
  const bool is_up = e.x0 != e.x1 ? e.x0 < e.x1 : e.y0 < e.y1;
  return is_up ? e : Edge{e.x1, e.y1, e.x0, e.y0};
}

/// A place on an edge: a stored point, or where another edge crosses.
struct OnEdge {
  std::optional<Point<double>> stored;
  Edge across{};
};

/// How far along e an edge crosses, from 0 to 1, and a bound on the error.
struct Fraction {
  double value, error;

  Fraction(const Edge& e, const Edge& f) noexcept : value(0), error(infinite) {
    double bound = 0;
    const auto cross = [&](double x, double y) {
      const double left = (f.x0 - x) * (f.y1 - y), right = (f.y0 - y) * (f.x1 - x);
      bound += (lane::abs(left) + lane::abs(right)) * 0x1p-49 + 0x1p-1000;
      return left - right;
    };
    const double start = cross(e.x0, e.y0), whole = start - cross(e.x1, e.y1), rest = lane::abs(whole) - bound;
    if (!(rest > bound)) return;
    value = start / whole;
    error = 4 * (bound / rest) + 0x1p-50;
  }
};

VESICA_COLD inline int exact_order_of_crossings(const Edge& e, const Edge& f, const Edge& g) noexcept {
  const auto start_f = exact_cross(e.x0, e.y0, f), start_g = exact_cross(e.x0, e.y0, g);
  const auto whole_f = start_f - exact_cross(e.x1, e.y1, f), whole_g = start_g - exact_cross(e.x1, e.y1, g);
  return exact::compare_products(exact::abs(start_f), exact::abs(whole_g), exact::abs(start_g), exact::abs(whole_f));
}

/// The order of two places on e. Exact.
inline int order_along(const Edge& e, const OnEdge& p, const OnEdge& q) noexcept {
  if (p.stored && q.stored) return order_along(e, *p.stored, *q.stored);
  if (q.stored) return -order_along(e, q, p);
  if (p.stored) return -side(p.stored->x, p.stored->y, q.across) * side(e.x0, e.y0, q.across);
  const Fraction f(e, p.across), g(e, q.across);
  if (f.value - g.value > f.error + g.error) return 1;
  if (g.value - f.value > f.error + g.error) return -1;
  return exact_order_of_crossings(e, p.across, q.across);
}

/// The edges of the path along which places are searched.
template <class T>
class PlacesAlong {
 public:
  PlacesAlong(const Edges<T>& path, const Box& box, Room& room) noexcept : path_(path, box), room_(room) {}

 protected:
  /// Are places searched on edge i? Of a point, or of a segment there and back, on its first edge.
  bool has_places(const Edge& e, std::int64_t i) noexcept {
    const int dimension = path_.ring_dimension(i);
    if (dimension == 2 || (dimension == 1 && !path_.edges.closed())) return has_length(e);
    if (dimension == 1 && !has_length(e)) return false;
    std::int64_t k = ring_of(path_.edges, i).first;
    const Point<double> first = path_.edges.vertex(k);
    while (dimension == 1 && k < i && same(path_.edges.vertex(k), first)) ++k;
    return k == i && same(first, start_of(e));
  }
  /// Does the edge hold its end? The last one of a chain does, and those that are all of a ring.
  bool holds_end(const Edge& e, std::int64_t i) noexcept {
    if (path_.edges.closed()) return path_.ring_dimension(i) < 2;
    if (!has_length(e)) return true;
    const Range chain = ring_of(path_.edges, i);
    std::int64_t k = i + 1;
    while (k < chain.last && same(path_.edges.vertex(k), end_of(e))) ++k;
    return k == chain.last;
  }
  /// Is p a place of another edge than i? A vertex is one of the first edge that begins there, or holds it as its end;
  /// another point is one of the first edge that passes through it.
  bool is_elsewhere(const Point<double>& p, std::int64_t i) noexcept {
    std::int64_t vertex = -1, passing = -1;
    path_.for_edges_near({p.x, p.y, p.x, p.y}, [&](const Edge& g, std::int64_t k) {
      if (!is_on(p, g) || !has_places(g, k)) return;
      const bool begins = same(p, start_of(g)), ends = same(p, end_of(g));
      std::int64_t& first = begins || ends ? vertex : passing;
      if ((begins || !ends || holds_end(g, k)) && (first < 0 || k < first)) first = k;
    });
    return (vertex >= 0 ? vertex : passing) != i;
  }
  /// Does a path go straight on at p, along e's line, and nothing else?
  static bool goes_straight(Outline<T>& path, const Point<double>& p, const Edge& e) noexcept {
    bool ahead = false, behind = false, elsewhere = false;
    path.for_edges_near({p.x, p.y, p.x, p.y}, [&](const Edge& g, std::int64_t) {
      if (!is_on(p, g)) return;
      for (const Point<double>& w : {start_of(g), end_of(g)}) {
        if (same(w, p)) continue;
        if (side(w.x, w.y, e) != 0) elsewhere = true;
        (order_along(e, p, w) < 0 ? ahead : behind) = true;
      }
    });
    return ahead && behind && !elsewhere;
  }

  Outline<T> path_;
  Room& room_;
};

/// Two paths, along the first.
template <class T>
class PathCrossings : PlacesAlong<T> {
  using Base = PlacesAlong<T>;

 public:
  PathCrossings(const Edges<T>& a, const Box& box_a, const Edges<T>& b, const Box& box_b, Room& room) noexcept
      : Base(a, box_a, room), b_(b, box_b) {}

  void find() noexcept {
    this->path_.edges.for_edges([&](const Edge& e, std::int64_t i) {
      if (meet(box_of(e), b_.box) && this->has_places(e, i)) visit(e, i);
      return false;
    });
  }

 private:
  /// Some places at a time, in order: those behind the last one found.
  void visit(const Edge& e, std::int64_t i) noexcept {
    const bool with_end = this->holds_end(e, i);
    constexpr int most = 32;
    OnEdge found[most];
    std::optional<OnEdge> last;
    int count = 0;
    do {
      count = 0;
      b_.for_edges_near(box_of(e), [&](const Edge& f, std::int64_t) {
        for_places(e, with_end, f, [&](const OnEdge& p) {
          if (last && order_along(e, p, *last) <= 0) return;
          int k = count;
          for (; k > 0; --k) {
            const int order = order_along(e, p, found[k - 1]);
            if (order == 0) return;
            if (order > 0) break;
          }
          if (k == most) return;
          count = std::min(count + 1, most);
          for (int n = count - 1; n > k; --n) found[n] = found[n - 1];
          found[k] = p;
        });
      });
      for (int k = 0; k < count; ++k) add(e, i, found[k]);
      if (count > 0) last = found[count - 1];
    } while (count == most);
  }

  template <class Visit>
  void for_places(const Edge& e, bool with_end, const Edge& f, Visit visit) noexcept {
    const int s0 = side(f.x0, f.y0, e), s1 = side(f.x1, f.y1, e);
    if (s0 * s1 > 0) return;
    const int t0 = side(e.x0, e.y0, f), t1 = side(e.x1, e.y1, f);
    if (t0 * t1 > 0) return;
    if (s0 * s1 < 0 && t0 * t1 < 0) {
      visit(OnEdge{{}, f});
      return;
    }
    const Box box_e = box_of(e), box_f = box_of(f), common = shared(box_e, box_f);
    if (s0 == 0 && s1 == 0 && t0 == 0 && (common.min_x < common.max_x || common.min_y < common.max_y)) {
      this->room_.shared = true;
    }
    const auto stored = [&](const Point<double>& p, int s, const Box& other) {
      if (s == 0 && holds(other, p) && (with_end || !same(p, end_of(e)))) visit(OnEdge{p, {}});
    };
    stored(start_of(f), s0, box_e);
    stored(end_of(f), s1, box_e);
    stored(start_of(e), t0, box_f);
    stored(end_of(e), t1, box_f);
  }

  void add(const Edge& e, std::int64_t i, const OnEdge& place) noexcept {
    if (!place.stored) {
      if (is_vertex(e, place.across)) return;
      const CrossingPoints<double> met = vesica::crossings(upward(e), upward(place.across));
      this->room_.add({met.x[0], met.y[0]});
      return;
    }
    const Point<double>& p = *place.stored;
    if (this->is_elsewhere(p, i)) return;
    Edge along = e;
    if (!has_length(e)) {
      // A point on another edge of the path.
      this->path_.for_edges_near(
          {p.x, p.y, p.x, p.y}, [&](const Edge& g, std::int64_t) { along = has_length(g) && is_on(p, g) ? g : along; });
    }
    if (has_length(along) && this->goes_straight(this->path_, p, along) && this->goes_straight(b_, p, along)) return;
    this->room_.add(p);
  }
  /// Do two edges cross at another vertex of the path? It is a place there.
  bool is_vertex(const Edge& e, const Edge& f) noexcept {
    bool found = false;
    this->path_.for_edges_near(shared(box_of(e), box_of(f)), [&](const Edge& g, std::int64_t) {
      for (const Point<double>& v : {start_of(g), end_of(g)}) found = found || (is_on(v, e) && is_on(v, f));
    });
    return found;
  }

  Outline<T> b_;
};

/// The places of an edge and a valid shape, in order along the edge. Returns how many, or an error.
template <template <class> class Shape>
std::int32_t edge_crossings(const Edge& e, const Shape<double>& s, CrossingPoints<double>& out) noexcept {
  return vesica::crossings_or_error(e, s, out);
}

/// A path and a shape that is a row of numbers.
template <class T, class Row>
class RowCrossings : PlacesAlong<T> {
  using Base = PlacesAlong<T>;

 public:
  RowCrossings(const Edges<T>& a, const Box& box, const Row& b, const Box& about, Room& room) noexcept
      : Base(a, box, room), b_(b), about_(about), has_area_(dimension(b) == 2) {}

  void find() noexcept {
    this->path_.edges.for_edges([&](const Edge& e, std::int64_t i) {
      if (meet(box_of(e), about_) && this->has_places(e, i)) visit(e, i);
      return false;
    });
  }

 private:
  bool is_on_outline(const Point<double>& p) const noexcept {
    if (!holds(about_, p)) return false;
    const Relation r = edge_relation({p.x, p.y, p.x, p.y}, b_);
    return has_area_ ? r == Relation::inside_touch : r != Relation::disjoint;
  }

  void visit(const Edge& e, std::int64_t i) noexcept {
    CrossingPoints<double> met;
    const std::int32_t code = edge_crossings(e, b_, met);
    if (code < 0) this->room_.error = code;
    if (code <= 0) return;
    if (met.shared != 0) this->room_.shared = true;
    int first = 0, last = met.count;
    if (has_length(e) && is_on_outline(end_of(e)) && (!this->holds_end(e, i) || this->is_elsewhere(end_of(e), i))) {
      --last;
    }
    if (first < last && is_on_outline(start_of(e))) {
      ++first;
      if (!this->is_elsewhere(start_of(e), i) && !is_within_stretch(e, met)) this->room_.add(start_of(e));
    }
    bool known[8] = {};
    if (first < last) drop_known(e, met, first, last, known);
    for (int k = first; k < last; ++k) {
      if (!known[k]) this->room_.add({met.x[k], met.y[k]});
    }
  }

  /// The start of e, from which a stretch leads both ways.
  bool is_within_stretch(const Edge& e, const CrossingPoints<double>& met) noexcept {
    const Point<double> p = start_of(e);
    if (met.shared == 0 || !this->goes_straight(this->path_, p, e)) return false;
    bool behind = false;
    this->path_.for_edges_near({p.x, p.y, p.x, p.y}, [&](const Edge& g, std::int64_t) {
      if (same(end_of(g), p) && has_length(g) && shares_stretch(start_of(g), p)) behind = true;
    });
    return behind;
  }

  bool shares_stretch(const Point<double>& from, const Point<double>& to) const noexcept {
    CrossingPoints<double> met{};
    return edge_crossings({from.x, from.y, to.x, to.y}, b_, met) > 0 && met.shared != 0;
  }
  /// Places inside e that are vertices of the path: the nearest to each. Within a stretch there are none.
  void drop_known(const Edge& e, const CrossingPoints<double>& met, int first, int last, bool* known) noexcept {
    this->path_.for_edges_near(box_of(e), [&](const Edge& g, std::int64_t) {
      for (const Point<double>& v : {start_of(g), end_of(g)}) {
        if (same(v, start_of(e)) || same(v, end_of(e)) || !is_on(v, e) || !is_on_outline(v)) continue;
        if (met.shared != 0 && shares_stretch(v, start_of(e)) && shares_stretch(v, end_of(e))) continue;
        int nearest = first;
        const auto off = [&](int j) { return lane::abs(met.x[j] - v.x) + lane::abs(met.y[j] - v.y); };
        for (int j = first; j < last; ++j) nearest = off(j) < off(nearest) ? j : nearest;
        known[nearest] = true;
      }
    });
  }

  const Row& b_;
  Box about_;
  bool has_area_;
};

template <class T>
void find_crossings(const Edges<T>& a, const Box& box_a, const Edges<T>& b, const Box& box_b, Room& room) noexcept {
  PathCrossings<T>(a, box_a, b, box_b, room).find();
}
template <class T, class Row>
void find_crossings(const Edges<T>& a, const Box& box, const Row& b, const Box& about, Room& room) noexcept {
  RowCrossings<T, Row>(a, box, b, about, room).find();
}

template <class T, class Other>
std::int64_t crossings_or_error(const Edges<T>& a, const Other& b, Room& room) noexcept {
  Box box_a, box_b;
  if (!is_valid(a, box_a) || !is_valid(b, box_b)) return error_shape;
  if (!meet(box_a, box_b)) return 0;
  if (const auto segment = flat(a); segment && a.closed()) {
    const T x[] = {static_cast<T>(segment->x0), static_cast<T>(segment->x1)};
    const T y[] = {static_cast<T>(segment->y0), static_cast<T>(segment->y1)};
    find_crossings(Edges<T>(Polyline<T>{x, y, sizeof(T), nullptr, 2}), box_a, b, box_b, room);
  } else {
    find_crossings(a, box_a, b, box_b, room);
  }
  return room.result();
}

}  // namespace detail::polygon

/// The number of places where outlines meet, or error_shape or error_range; the first `capacity` are written. In order
/// along the path, or along the first of two, from its first vertex on. Where a path crosses itself on the other
/// outline, it has a place for each of its edges.
template <template <class> class A, template <class> class B, class T>
std::int64_t crossings_or_error(const A<T>& a, const B<T>& b, Point<T>* out, std::int64_t capacity,
                                bool& shared) noexcept requires AnyPath<A<T>, B<T>> {
  detail::polygon::Room room{out, std::is_same_v<T, float>, capacity};
  const std::int64_t count = detail::polygon::with_edges(a, b, [&](const auto& edges, const auto& other, bool) {
    return detail::polygon::crossings_or_error(edges, other, room);
  });
  if (count >= 0) shared = room.shared;
  return count;
}

}  // namespace vesica
