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

/// The sign of the turn from the direction of e to that of f, exact.
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

/// A rectangle with a side along an edge. Lengths carry a power of two that all candidates of a call share.
struct SideRect {
  double cx, cy;
  double ux, uy;
  double width, height;

  double measure(LeastRect least) const noexcept { return least == LeastRect::area ? width * height : width + height; }
};

/// The rectangle on an edge that reaches to the corners `ahead` and `behind` along it, and to `top` across it.
inline SideRect side_rect(const Edge& edge, const Point<double>& ahead, const Point<double>& behind,
                          const Point<double>& top, int exponent) noexcept {
  using arithmetic::exact_difference, arithmetic::factor, arithmetic::rounded, arithmetic::Vector;
  const auto scaled = [&](double v, int by) { return arithmetic::scale_far(v, by); };
  // From the edge's beginning, divided by a power of two before the difference, which may overflow otherwise.
  const auto from_start = [&](double x, double y) {
    return Vector<double>{exact_difference(scaled(x, -exponent), scaled(edge.x0, -exponent)),
                          exact_difference(scaled(y, -exponent), scaled(edge.y0, -exponent))};
  };
  Vector<double> d = from_start(edge.x1, edge.y1);
  const int own = arithmetic::exponent_of(greater(lane::abs(d.x.high), lane::abs(d.y.high)));
  for (double* v : {&d.x.high, &d.x.low, &d.y.high, &d.y.low}) *v = scaled(*v, -own);
  const auto along = factor(d);
  const double length = std::sqrt(rounded(dot(along, along)));
  const auto far_end = factor(from_start(ahead.x, ahead.y)), near_end = factor(from_start(behind.x, behind.y));
  const double most = rounded(dot(along, far_end)) / length, least = rounded(dot(along, near_end)) / length;
  const double height = rounded(cross(along, factor(from_start(top.x, top.y)))) / length;
  const auto u = arithmetic::unit_and_length(rounded(d.x), rounded(d.y));
  const double middle = (most + least) / 2, up = height / 2;
  return {scaled(edge.x0, -exponent) + std::fma(u.x, middle, -u.y * up),
          scaled(edge.y0, -exponent) + std::fma(u.y, middle, u.x * up),
          u.x,
          u.y,
          most - least,
          height};
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
  const auto scaled = [&](double v) { return arithmetic::scale_far(v, -exponent); };
  const double x0 = scaled(span.x0), y0 = scaled(span.y0), x1 = scaled(span.x1), y1 = scaled(span.y1);
  const auto u = arithmetic::unit_and_length(x1 - x0, y1 - y0);
  return {x0 + (x1 - x0) / 2, y0 + (y1 - y0) / 2, u.x, u.y, arithmetic::scale(u.length.value, u.length.exponent), 0};
}

/// The exponent of a box's larger extent.
inline int exponent_of_extent(const Box& box) noexcept {
  return 1 + arithmetic::exponent_of(greater(box.max_x / 2 - box.min_x / 2, box.max_y / 2 - box.min_y / 2));
}

/// Corners of a hull that are found within a call.
inline constexpr std::int64_t most_hull_corners = 512;

/// The hull of points that come one by one. Whenever the room is full, those inside the hull so far are dropped.
template <class T>
class GrowingHull {
 public:
  /// False if the hull has more corners than most_hull_corners.
  bool add(const Edges<T>& edges) noexcept {
    const Range all = edges.all();
    for (std::int64_t i = all.first; i < all.last; ++i) {
      const Point<double> v = edges.vertex(i);
      points_[count_++] = {static_cast<T>(v.x), static_cast<T>(v.y)};
      if (count_ == room && !reduce()) return false;
    }
    return reduce();
  }
  std::int64_t count() const noexcept { return count_; }
  Polygon<T> path() const noexcept { return {&points_[0].x, &points_[0].y, sizeof(Point<T>), nullptr, count_}; }

 private:
  bool reduce() noexcept {
    count_ = hull_in_place(points_, count_);
    return count_ <= most_hull_corners;
  }

  static constexpr std::int64_t room = 2 * most_hull_corners;
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
/// error_null, error_rings, error_not_finite, error_range (a half length overflows), or error_not_convex: the hull has
/// more than 512 corners, and the vertices are no convex ring.
template <class T>
int smallest_rect(const Polygon<T>& points, LeastRect least, Rect<T>& out) noexcept {
  using namespace detail::polygon;
  const Edges<T> edges(points);
  Box box;
  if (const int error = edges.check(box); error != 0) return error;
  const int exponent = exponent_of_extent(box);
  SideRect r;
  if (const int error = rect_about_points(edges, least, exponent, r); error != 0) return error;
  const auto number = [&](double v) { return static_cast<T>(detail::arithmetic::scale_far(v, exponent)); };
  return detail::store(Rect<T>{number(r.cx), number(r.cy), static_cast<T>(r.ux), static_cast<T>(r.uy),
                               number(r.width / 2), number(r.height / 2)},
                       out);
}

}  // namespace vesica
