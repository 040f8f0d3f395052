// SPDX-License-Identifier: Apache-2.0
/// The rectangle of the least area, or of the least perimeter, that holds points. One of its sides lies along an edge
/// of their hull (Freeman and Shapira, "Determining the minimum-area encasing rectangle for an arbitrary closed curve",
/// 1975).
#pragma once

#include <vesica/arithmetic/spectrum.hpp>
#include <vesica/arithmetic/twofold.hpp>
#include <vesica/construct.hpp>
#include <vesica/polygon/hull.hpp>
#include <vesica/polygon/sense.hpp>

namespace vesica {

/// The measure by which a rectangle about points is the smallest.
enum class LeastRect { area, perimeter };

namespace detail::polygon {

/// 1 if the direction turns left from edge e to edge f, -1 if right, 0 if neither. Exact.
inline int turn(const Edge& e, const Edge& f) noexcept {
  const double left = (e.x1 - e.x0) * (f.y1 - f.y0), right = (e.y1 - e.y0) * (f.x1 - f.x0);
  const double cross = left - right, bound = (lane::abs(left) + lane::abs(right)) * 0x1p-49 + 0x1p-1000;
  return cross > bound ? 1 : cross < -bound ? -1 : exact_turn(e, f);
}

/// Corners of a convex path with area, counter-clockwise from the lowest of the leftmost. Corner size() is the first.
template <class T>
class ConvexCorners {
 public:
  ConvexCorners(const Edges<T>& edges, const Range& ring, bool clockwise) noexcept
      : edges_(edges), ring_(ring), clockwise_(clockwise) {
    for (std::int64_t i = ring.first + 1; i < ring.last; ++i) {
      if (is_left_of(edges.vertex(i), edges.vertex(ring.first + start_))) start_ = i - ring.first;
    }
  }
  std::int64_t size() const noexcept { return ring_.length(); }
  Point<double> operator[](std::int64_t i) const noexcept {
    const std::int64_t k = (clockwise_ ? start_ + size() - i % size() : start_ + i) % size();
    return edges_.vertex(ring_.first + k);
  }
  Edge edge(std::int64_t i) const noexcept {
    const Point<double> p = (*this)[i], q = (*this)[i + 1];
    return {p.x, p.y, q.x, q.y};
  }

 private:
  const Edges<T>& edges_;
  Range ring_;
  bool clockwise_;
  std::int64_t start_ = 0;
};

/// A vector times 2^exponent, as sums of two doubles.
struct ScaledVector {
  arithmetic::Vector<double> v;
  int exponent;

  /// From p to q. Coordinates are halved where their difference could overflow.
  ScaledVector(const Point<double>& p, const Point<double>& q) noexcept {
    const double most = greater(greater(lane::abs(p.x), lane::abs(q.x)), greater(lane::abs(p.y), lane::abs(q.y)));
    const double unit = most < 0x1p1022 ? 1 : 0.5;
    const auto difference = [&](double from, double to) {
      return arithmetic::exact_difference(to * unit, from * unit);
    };
    v = {difference(p.x, q.x), difference(p.y, q.y)};
    exponent = unit < 1 ? 1 : 0;
  }
  /// The exponent of the larger component.
  int size() const noexcept {
    return exponent + arithmetic::exponent_of(greater(lane::abs(v.x.high), lane::abs(v.y.high)));
  }
  /// In units of 2^unit.
  arithmetic::Vector<double> in(int unit) const noexcept {
    const auto scaled = [&](const arithmetic::Twofold<double>& n) {
      return arithmetic::Twofold<double>{arithmetic::scale_far(n.high, exponent - unit),
                                         arithmetic::scale_far(n.low, exponent - unit)};
    };
    return {scaled(v.x), scaled(v.y)};
  }
};

/// A rectangle with a side along an edge: its centre as seen from the edge's beginning, axis, width and height. Lengths
/// are in a unit of 2^exponent that all candidates of a call share.
struct SideRect {
  Point<double> start;
  double dx, dy, ux, uy, width, height;

  double measure(LeastRect least) const noexcept { return least == LeastRect::area ? width * height : width + height; }
};

/// The rectangle on an edge that reaches to the corners `ahead` and `behind` along it, and to `top` across it.
inline SideRect side_rect(const Edge& edge, const Point<double>& ahead, const Point<double>& behind,
                          const Point<double>& top, int exponent) noexcept {
  using arithmetic::factor, arithmetic::rounded;
  const Point<double> start{edge.x0, edge.y0};
  const ScaledVector direction(start, {edge.x1, edge.y1});
  const arithmetic::Vector<double> d = direction.in(direction.size());
  const auto along = factor(d);
  const double length = std::sqrt(rounded(dot(along, along)));
  const auto to = [&](const Point<double>& p) { return factor(ScaledVector(start, p).in(exponent)); };
  const double most = rounded(dot(along, to(ahead))) / length, least = rounded(dot(along, to(behind))) / length;
  const double height = rounded(cross(along, to(top))) / length;
  const auto u = arithmetic::unit_and_length(rounded(d.x), rounded(d.y));
  const double middle = (most + least) / 2, up = height / 2;
  return {start, std::fma(u.x, middle, -u.y * up), std::fma(u.y, middle, u.x * up), u.x, u.y, most - least, height};
}

/// Walks round the corners with the ones that are farthest ahead of each edge, above it and behind it.
template <class T>
SideRect smallest_rect(const ConvexCorners<T>& corners, LeastRect least, int exponent) noexcept {
  SideRect best{};
  double best_measure = infinite;
  std::int64_t ahead = 1, top = 1, behind = 1;
  for (std::int64_t i = 0; i < corners.size(); ++i) {
    const Edge e = corners.edge(i), normal{-e.y0, e.x0, -e.y1, e.x1};
    if (!has_length(e)) continue;
    const auto pass = [&](std::int64_t& corner, std::int64_t from, const auto& goes_on) {
      corner = std::max(corner, from);
      for (Edge next = corners.edge(corner); !has_length(next) || goes_on(next); next = corners.edge(corner)) ++corner;
    };
    pass(ahead, i + 1, [&](const Edge& next) { return turn(normal, next) < 0; });
    pass(top, ahead, [&](const Edge& next) { return turn(e, next) > 0; });
    pass(behind, top, [&](const Edge& next) { return turn(normal, next) > 0; });
    const SideRect rect = side_rect(e, corners[ahead], corners[behind], corners[top], exponent);
    const double measure = rect.measure(least);
    if (measure < best_measure) {
      best = rect;
      best_measure = measure;
    }
  }
  return best;
}

/// The rectangle without height about a segment.
inline SideRect flat_rect(const Edge& span, int exponent) noexcept {
  const Point<double> start{span.x0, span.y0};
  const ScaledVector whole(start, {span.x1, span.y1});
  const arithmetic::Vector<double> v = whole.in(whole.size());
  const auto u = arithmetic::unit_and_length(arithmetic::rounded(v.x), arithmetic::rounded(v.y));
  const double length = arithmetic::scale_far(u.length.value, u.length.exponent + whole.size() - exponent);
  return {start, u.x * length / 2, u.y * length / 2, u.x, u.y, length, 0};
}

/// The exponent of a box's larger extent.
inline int exponent_of_extent(const Box& box) noexcept {
  return ScaledVector({box.min_x, box.min_y}, {box.max_x, box.max_y}).size();
}

/// Corners of a hull that is found within a call, of all points or of the first ones.
inline constexpr std::int64_t most_hull_corners = 768;

/// The hull of points that come one by one. Whenever the room is full, those inside the hull so far are dropped.
template <class T>
class GrowingHull {
 public:
  /// False if a hull has more corners than most_hull_corners.
  bool add(const Edges<T>& edges) noexcept {
    const Range all = edges.all();
    for (std::int64_t i = all.first; i < all.last; ++i) {
      const Point<double> v = edges.vertex(i);
      points_[count_++] = {static_cast<T>(v.x), static_cast<T>(v.y)};
      if (count_ == room && !reduce()) return false;
    }
    count_ = hull_in_place(points_, count_);
    return true;
  }
  Polygon<T> path() const noexcept { return {&points_[0].x, &points_[0].y, sizeof(Point<T>), nullptr, count_}; }

 private:
  bool reduce() noexcept {
    count_ = hull_in_place(points_, count_);
    return count_ <= most_hull_corners;
  }

  static constexpr std::int64_t room = 1024;
  Point<T> points_[room];
  std::int64_t count_ = 0;
};

/// The smallest rectangle about the corners of a convex path.
template <class T>
SideRect rect_about(const Edges<T>& edges, const Convexity& c, LeastRect least, int exponent) noexcept {
  return c.flat ? flat_rect(c.span, exponent)
                : smallest_rect(ConvexCorners<T>(edges, c.ring, c.clockwise), least, exponent);
}

/// The same about any points. Where their hull has too many corners to be found here, they must be in its order.
template <class T>
int rect_about_points(const Edges<T>& edges, LeastRect least, int exponent, SideRect& out) noexcept {
  GrowingHull<T> hull;
  const bool found = hull.add(edges);
  const Polygon<T> path = hull.path();
  const Edges<T> corners = found ? Edges<T>(path) : edges;
  const Convexity c = convexity(corners);
  if (!c.convex) return error_not_convex;
  out = rect_about(corners, c, least, exponent);
  return 0;
}

}  // namespace detail::polygon

/// The rectangle of the least area or perimeter that holds a path's vertices.
///
/// It lies along an edge of their hull; its axis is that edge's direction, counter-clockwise round the hull where y
/// points up. Of equal ones, as they are computed, it is the first from the lowest of the leftmost points on.
/// error_null, error_rings, error_not_finite, error_range (a half length overflows), or error_not_convex: the
/// vertices are no convex ring, and the hull of all or of the first ones has more than 768 corners.
template <class T>
int smallest_rect(const Polygon<T>& points, LeastRect least, Rect<T>& out) noexcept {
  using namespace detail::polygon;
  const Edges<T> edges(points);
  Box box;
  if (const int error = edges.check(box); error != 0) return error;
  const int exponent = exponent_of_extent(box);
  SideRect r;
  if (const int error = rect_about_points(edges, least, exponent, r); error != 0) return error;
  const auto length = [&](double v) { return static_cast<T>(detail::arithmetic::scale_far(v, exponent)); };
  // Halves, where the step to the centre may overflow.
  const int lift = exponent > 1000 ? 1 : 0;
  const auto place = [&](double start, double step) {
    const double half = lift > 0 ? start / 2 : start;
    return static_cast<T>((half + detail::arithmetic::scale_far(step, exponent - lift)) * (1 + lift));
  };
  return detail::store(Rect<T>{place(r.start.x, r.dx), place(r.start.y, r.dy), static_cast<T>(r.ux),
                               static_cast<T>(r.uy), length(r.width / 2), length(r.height / 2)},
                       out);
}

}  // namespace vesica
