// SPDX-License-Identifier: Apache-2.0
/// The edges of a polygon or a polyline, in the order of its vertices.
#pragma once

#include <algorithm>
#include <cstring>
#include <limits>
#include <vesica/check.hpp>
#include <vesica/polygon.hpp>
#include <vesica/two_doubles.hpp>

namespace vesica::detail::polygon {

using Box = Aabb<double>;
using Edge = Segment<double>;

inline constexpr double infinite = std::numeric_limits<double>::infinity();
/// Holds nothing, and meets no box.
inline constexpr Box no_box{infinite, infinite, -infinite, -infinite};

/// -1, 0 or 1 as two numbers are in order, equal, or not.
template <class Number>
constexpr int compared(Number a, Number b) noexcept {
  return (a > b) - (a < b);
}

constexpr bool meet(const Box& a, const Box& b) noexcept {
  using lane::both;
  return both(both(a.min_x <= b.max_x, b.min_x <= a.max_x), both(a.min_y <= b.max_y, b.min_y <= a.max_y));
}

/// The box that two boxes share; it may be inverted.
constexpr Box shared(const Box& a, const Box& b) noexcept {
  return {greater(a.min_x, b.min_x), greater(a.min_y, b.min_y), lesser(a.max_x, b.max_x), lesser(a.max_y, b.max_y)};
}

constexpr void extend(Box& box, double x, double y) noexcept {
  box.min_x = lane::min(x, box.min_x);
  box.min_y = lane::min(y, box.min_y);
  box.max_x = lane::max(x, box.max_x);
  box.max_y = lane::max(y, box.max_y);
}

constexpr bool has_length(const Edge& e) noexcept { return e.x0 != e.x1 || e.y0 != e.y1; }
constexpr Box box_of(const Edge& e) noexcept {
  return {lesser(e.x0, e.x1), lesser(e.y0, e.y1), greater(e.x0, e.x1), greater(e.y0, e.y1)};
}

/// The square of the distance of two boxes, up to roundings.
constexpr double squared_gap(const Box& a, const Box& b) noexcept {
  const double x = lane::max(lane::max(a.min_x - b.max_x, b.min_x - a.max_x), 0.0);
  const double y = lane::max(lane::max(a.min_y - b.max_y, b.min_y - a.max_y), 0.0);
  return x * x + y * y;
}

/// Vertices first to last - 1, and the edges that begin there.
struct Range {
  std::int64_t first, last;
  constexpr std::int64_t length() const noexcept { return last - first; }
};

class KeptBoxes;

/// A view of the vertices of a polygon (closed) or a polyline. Edge i begins at vertex i. Of a chain of two or more
/// vertices no edge begins at the last; of one vertex, the edge is a point.
template <class T>
class Edges {
 public:
  Edges(const Polygon<T>& p) noexcept : Edges(p, true) {}    // NOLINT(google-explicit-constructor)
  Edges(const Polyline<T>& p) noexcept : Edges(p, false) {}  // NOLINT(google-explicit-constructor)

  /// With boxes that were made for them: the path is valid then. Null: without boxes.
  Edges(const Edges& edges, const KeptBoxes* boxes) noexcept : Edges(edges) { boxes_ = boxes; }
  const KeptBoxes* boxes() const noexcept { return boxes_; }

  bool closed() const noexcept { return closed_; }
  bool has_null() const noexcept { return x_ == nullptr || y_ == nullptr; }
  std::int64_t rings() const noexcept { return rings_ == nullptr ? 1 : count_; }
  /// Vertices of ring j.
  Range ring(std::int64_t j) const noexcept {
    if (rings_ == nullptr) return {0, count_};
    return {offset(j), offset(j + 1)};
  }
  /// The ring of a vertex.
  std::int64_t ring_of(std::int64_t i) const noexcept {
    std::int64_t low = 0, high = rings();
    while (high - low > 1) {  // the last ring that begins at or before it
      const std::int64_t middle = low + (high - low) / 2;
      (offset(middle) <= i ? low : high) = middle;
    }
    return low;
  }
  /// All vertices.
  Range all() const noexcept {
    if (rings_ == nullptr) return {0, count_};
    return {offset(0), offset(count_)};
  }

  Point<double> vertex(std::int64_t i) const noexcept {
    T x, y;
    std::memcpy(&x, x_ + i * stride_, sizeof x);
    std::memcpy(&y, y_ + i * stride_, sizeof y);
    return {static_cast<double>(x), static_cast<double>(y)};
  }

  /// 0, error_null, error_not_finite, or error_rings for no vertex or offsets that are negative or decrease. The box
  /// holds all vertices where it is 0.
  int check(Box& box) const noexcept {
    if (has_null()) return error_null;
    if (count_ < 1) return error_rings;
    if (rings_ != nullptr) {
      std::int32_t before = 0;
      for (std::int64_t j = 0; j <= count_; ++j) {
        if (offset(j) < before) return error_rings;
        before = offset(j);
      }
    }
    const Range vertices = all();
    if (vertices.length() == 0) return error_rings;
    return find_box(vertices, box) ? 0 : error_not_finite;
  }

  /// Calls visit(edge, i) for each edge that begins in a range, until it returns true; returns whether it did. Edges
  /// without length are left out except the first of a ring, so that equal vertices take no time.
  template <class Visit>
  bool for_edges(const Range& range, Visit visit) const noexcept {
    return for_rings(range, [&](const Range& vertices, std::int64_t first, std::int64_t last) {
      return for_edges_of_ring(vertices, first, last, visit);
    });
  }
  /// For all edges.
  template <class Visit>
  bool for_edges(Visit visit) const noexcept {
    return for_edges(all(), visit);
  }

  /// The box of the edges of a range.
  Box box_of_range(const Range& range) const noexcept {
    Box box = no_box;
    for_rings(range, [&](const Range& vertices, std::int64_t first, std::int64_t last) {
      Box part;
      find_box({first, std::min(last + 1, vertices.last)}, part);
      const Point<double> start = vertex(last == vertices.last && closed_ ? vertices.first : first);
      extend(part, start.x, start.y);
      // Equal vertices have no edges, except the first of a ring.
      if (part.min_x == part.max_x && part.min_y == part.max_y && first != vertices.first) return false;
      extend(box, part.min_x, part.min_y);
      extend(box, part.max_x, part.max_y);
      return false;
    });
    return box;
  }

 private:
  template <class Shape>
  Edges(const Shape& p, bool closed) noexcept
      : x_(reinterpret_cast<const unsigned char*>(p.x)),
        y_(reinterpret_cast<const unsigned char*>(p.y)),
        stride_(p.stride),
        rings_(p.rings),
        count_(p.count),
        closed_(closed) {}

  std::int32_t offset(std::int64_t j) const noexcept { return rings_[j]; }

  /// Calls visit(ring, first, last) for the part of each ring within a range, until it returns true.
  template <class Visit>
  bool for_rings(const Range& range, Visit visit) const noexcept {
    if (range.first >= range.last) return false;
    if (rings_ == nullptr) return visit(Range{0, count_}, range.first, range.last);
    for (std::int64_t j = ring_of(range.first); j < count_; ++j) {
      const Range vertices = ring(j);
      if (vertices.first >= range.last) break;
      const std::int64_t first = std::max(vertices.first, range.first), last = std::min(vertices.last, range.last);
      if (first < last && visit(vertices, first, last)) return true;
    }
    return false;
  }

  /// The box of vertices. Returns false if a number is not finite.
  bool find_box(const Range& range, Box& box) const noexcept {
#ifdef VESICA_HAS_TWO_DOUBLES
    // Both coordinates in one register, and two vertices at a time, so that no operation waits for the one before.
    using lane::TwoDoubles;
    TwoDoubles low[2]{TwoDoubles(infinite), TwoDoubles(infinite)},
        high[2]{TwoDoubles(-infinite), TwoDoubles(-infinite)};
    TwoDoubles zero[2]{TwoDoubles(0.0), TwoDoubles(0.0)};  // NaN if a number is not finite
    const auto take = [&](std::int64_t i, int k) {
      const Point<double> v = vertex(i);
      const TwoDoubles p(v.x, v.y);
      low[k] = min(p, low[k]);
      high[k] = max(p, high[k]);
      zero[k] = zero[k] + (p - p);
    };
    std::int64_t i = range.first;
    for (; i + 2 <= range.last; i += 2) {
      take(i, 0);
      take(i + 1, 1);
    }
    if (i < range.last) take(i, 0);
    const TwoDoubles least = min(low[0], low[1]), most = max(high[0], high[1]), sum = zero[0] + zero[1];
    box = {least.first(), least.second(), most.first(), most.second()};
    return sum.first() == 0 && sum.second() == 0;
#else
    box = no_box;
    double zero = 0;
    for (std::int64_t i = range.first; i < range.last; ++i) {
      const Point<double> v = vertex(i);
      extend(box, v.x, v.y);
      zero += (v.x - v.x) + (v.y - v.y);
    }
    return zero == 0;
#endif
  }

  /// The same for one ring.
  template <class Visit>
  bool for_edges_of_ring(const Range& vertices, std::int64_t first, std::int64_t last, Visit& visit) const noexcept {
    Point<double> from = vertex(first);
    const std::int64_t inner = std::min(last, vertices.last - 1);
    const auto counts = [&](const Point<double>& to, std::int64_t i) {
      return from.x != to.x || from.y != to.y || i == vertices.first;
    };
    for (std::int64_t i = first; i < inner; ++i) {
      const Point<double> to = vertex(i + 1);
      if (counts(to, i) && visit(Edge{from.x, from.y, to.x, to.y}, i)) return true;
      from = to;
    }
    if (last < vertices.last) return false;
    if (!closed_ && vertices.length() > 1) return false;
    const Point<double> to = vertex(vertices.first);
    return counts(to, last - 1) && visit(Edge{from.x, from.y, to.x, to.y}, last - 1);
  }

  const unsigned char *x_, *y_;
  std::ptrdiff_t stride_;
  const std::int32_t* rings_;
  std::int64_t count_;
  bool closed_;
  const KeptBoxes* boxes_ = nullptr;
};

template <class T>
Edges(const Polygon<T>&) -> Edges<T>;
template <class T>
Edges(const Polyline<T>&) -> Edges<T>;

}  // namespace vesica::detail::polygon

namespace vesica {

/// 0 when valid, else error_null, error_rings or error_not_finite. Whether edges cross is another question.
template <Path Shape>
int check(const Shape& s) noexcept {
  detail::polygon::Box box;
  return detail::polygon::Edges(s).check(box);
}

}  // namespace vesica
