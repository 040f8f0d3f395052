// SPDX-License-Identifier: Apache-2.0
/// The place of a point in a polygon: inside, on an edge or outside. Exact, also for points that are not stored.
#pragma once

#include <vesica/polygon/inside.hpp>

namespace vesica::detail::polygon {

/// A stored point. order_x(x) is the sign of x - its x; side(e) is 1 if it lies left of an edge, 0 if on its line.
struct Stored {
  Point<double> at;

  int order_x(double x) const noexcept { return compared(x, at.x); }
  int order_y(double y) const noexcept { return compared(y, at.y); }
  int side(const Edge& e) const noexcept { return polygon::side(at.x, at.y, e); }
};

/// The point halfway between two points, exactly: (p + q + h u) / 2 in each coordinate, where p and q are stored.
class Middle {
 public:
  Middle() noexcept : Middle({}, {}) {}
  Middle(const Point<double>& p, const Point<double>& q) noexcept : Middle(p, q, 0, 0, 0) {}
  Middle(const Point<double>& p, const Point<double>& q, double h, double ux, double uy) noexcept
      : x_(p.x, q.x, h, ux), y_(p.y, q.y, h, uy) {}

  int order_x(double x) const noexcept { return x_.order(x); }
  int order_y(double y) const noexcept { return y_.order(y); }
  int side(const Edge& e) const noexcept {
    const double x0 = e.x0 - x_.value, y0 = e.y0 - y_.value, x1 = e.x1 - x_.value, y1 = e.y1 - y_.value;
    const double left = x0 * y1, right = y0 * x1, cross = left - right;
    // Each factor is right to u and the coordinate's error, so each product to 3u and what the errors add.
    const double added =
        x_.error * (lane::abs(y0) + lane::abs(y1) + y_.error) + y_.error * (lane::abs(x0) + lane::abs(x1));
    const double bound = (lane::abs(left) + lane::abs(right)) * 0x1p-49 + 2 * added + 0x1p-1000;
    if (cross > bound) return 1;
    if (cross < -bound) return -1;
    return exact_side(e);
  }

 private:
  struct Coordinate {
    double p, q, h, u;
    double value, error;  // |value - (p + q + h u) / 2| < error

    Coordinate(double first, double second, double size, double axis) noexcept : p(first), q(second), h(size), u(axis) {
      const double product = 0.5 * h * u;
      value = 0.5 * p + 0.5 * q + product;
      error = (lane::abs(p) + lane::abs(q) + lane::abs(product)) * 0x1p-50 + 0x1p-1060;
    }
    exact::Number<2> twice() const noexcept {
      using exact::from_double;
      return from_double(p) + from_double(q) + from_double(h) * from_double(u);
    }
    int order(double v) const noexcept {
      const double difference = v - value;
      if (difference > error) return 1;
      if (difference < -error) return -1;
      return exact_order(v);
    }
    VESICA_COLD int exact_order(double v) const noexcept { return (exact::from_double(v, 1) - twice()).sign; }
  };

  VESICA_COLD int exact_side(const Edge& e) const noexcept {
    using exact::from_double;
    const auto x = x_.twice(), y = y_.twice();
    return ((from_double(e.x0, 1) - x) * (from_double(e.y1, 1) - y) -
            (from_double(e.y0, 1) - y) * (from_double(e.x1, 1) - x))
        .sign;
  }

  Coordinate x_, y_;
};

/// A point left of an edge, closer to it than anything else is, also where other edges touch its middle m: at
/// m + s t + s^2 n, where t leads along the edge, n to its left, and s is as small as need be.
struct Beside {
  Middle at;
  Edge edge;

  explicit Beside(const Edge& e) noexcept : at({e.x0, e.y0}, {e.x1, e.y1}), edge(e) {}

  int order_x(double x) const noexcept { return at.order_x(x); }
  int order_y(double y) const noexcept {
    const int order = at.order_y(y);
    if (order != 0) return order;
    const int along = compared(edge.y0, edge.y1);
    return along != 0 ? along : compared(edge.x0, edge.x1);  // n's y is t's x
  }
  int side(const Edge& e) const noexcept {
    const int s = at.side(e);
    return s != 0 ? s : side_of_step(e);
  }

 private:
  VESICA_COLD int side_of_step(const Edge& e) const noexcept {
    using exact::from_double;
    const auto tx = from_double(edge.x1) - from_double(edge.x0), ty = from_double(edge.y1) - from_double(edge.y0);
    const auto gx = from_double(e.x1) - from_double(e.x0), gy = from_double(e.y1) - from_double(e.y0);
    const int along = (gx * ty - gy * tx).sign;
    return along != 0 ? along : (gx * tx + gy * ty).sign;
  }
};

/// The ray to the right of a point: the parity of the edges that it crosses, and whether the point is on an edge.
template <class Place>
class Ray {
 public:
  explicit Ray(const Place& place) noexcept : place_(place) {}

  void add(const Edge& e) noexcept {
    const int y0 = place_.order_y(e.y0), y1 = place_.order_y(e.y1);
    if (y0 * y1 > 0) return;
    const int x0 = place_.order_x(e.x0), x1 = place_.order_x(e.x1);
    if (x0 < 0 && x1 < 0) return;
    // The edge holds its lower end and not its upper one, so that a vertex on the ray counts once.
    const bool crosses = (y0 > 0) != (y1 > 0);
    if (x0 > 0 && x1 > 0) {
      odd_ ^= crosses;
      return;
    }
    if (y0 == 0 && y1 == 0) {
      on_edge_ = on_edge_ || x0 * x1 <= 0;
      return;
    }
    const int s = place_.side(e);
    if (s == 0) on_edge_ = true;
    odd_ ^= crosses && (y1 > 0 ? s > 0 : s < 0);
  }

  bool odd() const noexcept { return odd_; }
  bool on_edge() const noexcept { return on_edge_; }

 private:
  const Place& place_;
  bool odd_ = false, on_edge_ = false;
};

/// Places of many points in a path.
template <class T>
class Locator {
 public:
  explicit Locator(const Edges<T>& edges) noexcept
      : edges_(edges), blocks_(edges, edges.all(), [](const Box&) { return true; }) {}

  /// 1 inside, 0 on an edge, -1 outside.
  template <class Place>
  int locate(const Place& place) const noexcept {
    const Ray<Place> ray = ray_from(place);
    if (ray.on_edge()) return 0;
    return ray.odd() && edges_.closed() ? 1 : -1;
  }
  /// Is a place inside a polygon, if it is on no edge but one without length?
  template <class Place>
  bool is_odd(const Place& place) const noexcept {
    return ray_from(place).odd();
  }
  /// Calls visit(edge, i) for the edges whose box meets a box.
  template <class Visit>
  void for_edges_near(const Box& about, Visit visit) const noexcept {
    for (int i = 0; i < blocks_.count; ++i) {
      if (!meet(blocks_.box[i], about)) continue;
      edges_.for_edges(blocks_.range(i), [&](const Edge& e, std::int64_t k) {
        if (meet(box_of(e), about)) visit(e, k);
        return false;
      });
    }
  }

 private:
  template <class Place>
  Ray<Place> ray_from(const Place& place) const noexcept {
    Ray<Place> ray(place);
    for (int i = 0; i < blocks_.count; ++i) {
      const Box& box = blocks_.box[i];
      if (place.order_y(box.max_y) < 0 || place.order_y(box.min_y) > 0 || place.order_x(box.max_x) < 0) continue;
      edges_.for_edges(blocks_.range(i), [&](const Edge& e, std::int64_t) {
        ray.add(e);
        return false;
      });
    }
    return ray;
  }

  const Edges<T>& edges_;
  Blocks blocks_;
};

}  // namespace vesica::detail::polygon
