// SPDX-License-Identifier: Apache-2.0
/// Is a polygon simple? Its edges neither cross nor overlap along a stretch; they may touch. Exact.
///
/// Edges that pass one another at a vertex cross too. A ring of two places is a segment there and back, which is
/// allowed.
#pragma once

#include <vesica/polygon/topology.hpp>

namespace vesica {

/// The code of check_simple() and vesica_check_f64 for edges that cross or overlap.
inline constexpr int error_not_simple = -12;

namespace detail::polygon {

/// Searches for two edges that cross or overlap. Boxes about runs of edges keep the work near-linear.
template <class T>
class SelfCrossing {
 public:
  std::int64_t first = -1, second = -1;  // the edges, by the vertices that they begin at; -1 if there are none

  SelfCrossing(const Edges<T>& path, const Box& box) noexcept : path_(path) {
    walk(path, box, path, box, Policy{*this});
  }

 private:
  struct Policy {
    SelfCrossing& search;
    bool keeps(const Box& a, const Box& b) const noexcept { return meet(a, b); }
    bool visit(const Edge& e, std::int64_t i, const Edge& f, std::int64_t j) const noexcept {
      if (i >= j || !search.conflict(e, i, f, j)) return false;
      search.first = i;
      search.second = j;
      return true;
    }
  };

  bool conflict(const Edge& e, std::int64_t i, const Edge& f, std::int64_t j) const noexcept {
    if (!has_length(e) || !has_length(f)) return false;
    const int s0 = side(f.x0, f.y0, e), s1 = side(f.x1, f.y1, e), t0 = side(e.x0, e.y0, f), t1 = side(e.x1, e.y1, f);
    if (s0 * s1 > 0 || t0 * t1 > 0) return false;
    const Box common = shared(box_of(e), box_of(f));
    if (s0 == 0 && s1 == 0 && (common.min_x < common.max_x || common.min_y < common.max_y)) {
      return !is_there_and_back(e, i, f, j);
    }
    if (s0 * s1 < 0 && t0 * t1 < 0) return true;
    // They share a point. Each place of the path is asked for at the edge that begins there.
    const Point<double> start_e = start_of(e), start_f = start_of(f);
    if (same(start_e, start_f)) {
      const Point<double> before_e = before(i, start_e), before_f = before(j, start_f);
      return is_between(start_e, end_of(e), before_e, before_f) != is_between(start_e, end_of(e), before_e, end_of(f));
    }
    if (s0 == 0 && t0 * t1 < 0) return turn(start_of(e), end_of(e), before(j, start_f)) * s1 < 0;
    if (t0 == 0 && s0 * s1 < 0) return turn(start_f, end_of(f), before(i, start_e)) * t1 < 0;
    return false;
  }

  /// Does d lie in the sector from a counter-clockwise to b, seen from v? It is on neither ray.
  static bool is_between(const Point<double>& v, const Point<double>& a, const Point<double>& b,
                         const Point<double>& d) noexcept {
    const int sector = turn(v, a, b);
    if (sector > 0) return turn(v, a, d) > 0 && turn(v, d, b) > 0;
    if (sector < 0) return !(turn(v, b, d) > 0 && turn(v, d, a) > 0);
    return !same(a, b) && turn(v, a, d) > 0;  // opposite directions, or those of a segment there and back
  }

  Range ring_of(std::int64_t i) const noexcept { return polygon::ring_of(path_, i); }

  /// The last vertex before vertex i on its ring that is elsewhere.
  Point<double> before(std::int64_t i, const Point<double>& v) const noexcept {
    const Range ring = ring_of(i);
    std::int64_t k = i;
    Point<double> p = v;
    do {
      k = k == ring.first ? ring.last - 1 : k - 1;
      p = path_.vertex(k);
    } while (same(p, v) && k != i);
    return p;
  }

  /// Are these the only two edges of a ring?
  bool is_there_and_back(const Edge& e, std::int64_t i, const Edge& f, std::int64_t j) const noexcept {
    if (!same(start_of(e), end_of(f)) || !same(end_of(e), start_of(f))) return false;
    const Range ring = ring_of(i);
    if (j >= ring.last) return false;
    int edges = 0;
    path_.for_edges(ring, [&](const Edge& g, std::int64_t) {
      edges += has_length(g) ? 1 : 0;
      return edges > 2;
    });
    return edges == 2;
  }

  const Edges<T>& path_;
};

}  // namespace detail::polygon

/// check(), and error_not_simple for a polygon whose edges cross or overlap. Polylines may.
template <Path Shape>
int check_simple(const Shape& s) noexcept {
  const detail::polygon::Edges edges(s);
  detail::polygon::Box box;
  const int error = edges.check(box);
  if (error != 0 || !edges.closed()) return error;
  return detail::polygon::SelfCrossing(edges, box).first < 0 ? 0 : error_not_simple;
}

}  // namespace vesica
