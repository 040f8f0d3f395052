// SPDX-License-Identifier: Apache-2.0
/// The least distance over the edges of a path, or over pairs of edges of two paths.
///
/// Bounds leave out only pairs that cannot be the least, however distances round. So the result is the least of what
/// all pairs give, and its error is one pair's.
#pragma once

#include <cmath>
#include <vesica/nearest.hpp>
#include <vesica/polygon/walk.hpp>

namespace vesica::detail::polygon {

using Points = ClosestPoints<double>;

/// The least distance found so far. Among equal ones it keeps the first edges', in whichever order they come.
class Least {
 public:
  /// `all` holds both shapes. A computed distance is within 4u of its size (nearest.hpp), a bound within 12u, and
  /// u = 2^-53.
  explicit Least(const Box& all) noexcept : slack_(greater(share(all.min_x, all.max_x), share(all.min_y, all.max_y))) {}

  /// May the pair be the least, if this is a lower bound on its distance?
  bool keeps(double bound) const noexcept { return !(bound > reach_); }
  /// The same for a bound's square.
  bool keeps_squared(double bound) const noexcept { return !(bound > squared_); }

  /// Some pair is at most that far apart.
  void lower(double distance) noexcept {
    if (!(distance + slack_ < reach_)) return;
    reach_ = distance + slack_;
    squared_ = squared_limit(reach_);
  }
  /// A lower bound on a pair's distance, from its value in plain arithmetic.
  double less(double distance) const noexcept { return lane::max(distance - slack_, 0.0); }
  /// A pair's distance, by its edges: those of the first path, and of the second.
  void offer(const Points& points, std::int64_t i, std::int64_t j = 0) noexcept {
    const bool earlier = i < i_ || (i == i_ && j < j_);
    if (found() && !(points.distance < points_.distance || (points.distance == points_.distance && earlier))) return;
    points_ = points;
    i_ = i;
    j_ = j;
    lower(points.distance);
  }
  /// A pair without a distance, since it is beyond the largest number.
  void refuse(std::int32_t error) noexcept { error_ = error; }

  bool found() const noexcept { return i_ >= 0; }
  std::int64_t edge() const noexcept { return i_; }
  /// 0, or the error of all pairs.
  std::int32_t result(Points& out) const noexcept {
    if (!found()) return error_;
    out = points_;
    return 0;
  }

 private:
  static double share(double low, double high) noexcept { return 0x1p-48 * high - 0x1p-48 * low; }

  double slack_, reach_ = infinite, squared_ = infinite;
  std::int64_t i_ = -1, j_ = -1;
  std::int32_t error_ = error_range;
  Points points_{};
};

/// Does no square of a distance in a box overflow?
inline bool squares_fit(const Box& all) noexcept {
  return all.max_x - all.min_x < 0x1p500 && all.max_y - all.min_y < 0x1p500;
}
/// The square of the distance of a point and an edge, up to roundings.
inline double squared_distance(double px, double py, const Edge& e) noexcept {
  const double vx = e.x1 - e.x0, vy = e.y1 - e.y0, wx = px - e.x0, wy = py - e.y0;
  const double dot = vx * wx + vy * wy, square = vx * vx + vy * vy;
  const double t = dot > 0 ? (dot < square ? dot / square : 1) : 0, dx = wx - t * vx, dy = wy - t * vy;
  return dx * dx + dy * dy;
}
/// The same of two disjoint edges: an end of one is closest.
inline double squared_distance(const Edge& e, const Edge& f) noexcept {
  return lesser(lesser(squared_distance(e.x0, e.y0, f), squared_distance(e.x1, e.y1, f)),
                lesser(squared_distance(f.x0, f.y0, e), squared_distance(f.x1, f.y1, e)));
}

/// The least over the edges of a path. ask(edge, points) returns 0 or an error; other holds the other shape. `point` is
/// null unless that is a point: then plain arithmetic leaves out most edges before they are asked.
template <class T, class Ask>
class LeastOfEdges {
 public:
  LeastOfEdges(const Edges<T>& edges, const Box& box, const Box& other, const Point<double>* point, Ask ask) noexcept
      : edges_(edges),
        other_(other),
        point_(squares_fit(together(box, other)) ? point : nullptr),
        ask_(ask),
        least_(together(box, other)) {}

  std::int32_t find(Points& out) noexcept {
    if (edges_.boxes() != nullptr) {
      by_boxes(*edges_.boxes());
    } else if (!found_by_samples()) {
      pass();
    }
    settle();
    return least_.result(out);
  }

 private:
  static constexpr std::int64_t samples = 16;
  static constexpr int room = 16;
  struct Waiting {
    Edge e;
    std::int64_t i;
    double squared;  // a bound
  };

  /// No more than the distance of an edge. It is 0 if the edge cannot be the least.
  double visit(const Edge& e, std::int64_t i) noexcept {
    if (!least_.keeps_squared(squared_gap(box_of(e), other_))) return 0;
    if (point_ != nullptr) return visit_by_bound(e, i);
    return ask(e, i);
  }
  double ask(const Edge& e, std::int64_t i) noexcept {
    Points points;
    const std::int32_t error = ask_(e, points);
    if (error != 0) {
      least_.refuse(error);
      return 0;
    }
    least_.offer(points, i);
    return points.distance;
  }
  /// The edge waits, since most are found to be farther than another.
  double visit_by_bound(const Edge& e, std::int64_t i) noexcept {
    const double squared = squared_distance(point_->x, point_->y, e);
    if (!(squared > 0x1p-900)) return ask(e, i);  // it may underflow in one of its terms
    const double distance = std::sqrt(squared);
    if (least_.keeps_squared(squared)) {
      least_.lower(distance);
      if (count_ == room) settle();
      waiting_[count_++] = {e, i, squared};
    }
    // Less than the distance by more than the bound may be off: pass() goes on from it.
    return least_.less(distance);
  }
  void settle() noexcept {
    for (int k = 0; k < count_; ++k) {
      if (least_.keeps_squared(waiting_[k].squared)) ask(waiting_[k].e, waiting_[k].i);
    }
    count_ = 0;
  }

  /// Asks a close run first.
  void by_boxes(const KeptBoxes& boxes) noexcept {
    const auto ask_run = [&](const Range& run, const Box&) {
      return edges_.for_edges(run, [&](const Edge& e, std::int64_t i) {
        visit(e, i);
        return false;
      });
    };
    ask_run(boxes.close_run(other_), other_);
    boxes.for_runs([&](const Range&, const Box& box) { return least_.keeps_squared(squared_gap(box, other_)); },
                   ask_run);
  }

  /// Asks a few edges, then a few about the nearest of them, and so on. True if these were all edges.
  bool found_by_samples() noexcept {
    const Range all = edges_.all();
    Range range = all;
    while (true) {
      const std::int64_t step = (range.length() + samples - 1) / samples;
      for (std::int64_t i = range.first; i < range.last; i += step) {
        edges_.for_edges({i, i + 1}, [&](const Edge& e, std::int64_t k) {
          visit(e, k);
          return false;
        });
      }
      settle();
      if (step == 1) return range.length() == all.length();
      const std::int64_t middle = least_.found() ? least_.edge() : range.first;
      range = {std::max(all.first, middle - step), std::min(all.last, middle + step)};
    }
  }

  /// Asks the edges in their order. Along an edge the distance decreases by at most its length, so that those after a
  /// distant edge are skipped.
  void pass() noexcept {
    double at_end = 0;  // no more than the distance of the last edge's end
    Point<double> end{infinite, infinite};
    edges_.for_edges([&](const Edge& e, std::int64_t i) {
      const double length = lane::abs(e.x1 - e.x0) + lane::abs(e.y1 - e.y0);
      const bool goes_on = e.x0 == end.x && e.y0 == end.y;
      // The factor makes good what rounds.
      const double bound = goes_on ? (at_end - length) * (1 - 0x1p-50) : 0;
      at_end = bound > 0 && !least_.keeps(bound) ? bound : visit(e, i);
      end = {e.x1, e.y1};
      return false;
    });
  }

  const Edges<T>& edges_;
  Box other_;
  const Point<double>* point_;
  Ask ask_;
  Least least_;
  int count_ = 0;
  Waiting waiting_[room];
};

/// The policy of walk() for the least over pairs of edges.
class LeastOfPairs {
 public:
  static constexpr bool closest_first = true;

  explicit LeastOfPairs(const Box& all) noexcept : least_(all), overflows_(!squares_fit(all)) {}

  bool keeps(const Box& a, const Box& b) const noexcept { return least_.keeps_squared(squared_gap(a, b)); }

  /// True if the edges meet: nothing is closer. Other pairs wait, since most are found to be farther than another.
  bool visit(const Edge& e, std::int64_t i, const Edge& f, std::int64_t j) noexcept {
    if (meet(box_of(e), box_of(f)) && vesica::overlap(e, f)) {
      ask({e, f, i, j, 0});
      return true;
    }
    const double squared = squared_distance(e, f);
    const bool unknown = overflows_ || !(squared > 0x1p-900);  // perhaps one of its terms underflows
    if (!unknown && !least_.keeps_squared(squared)) return false;
    if (!unknown) least_.lower(std::sqrt(squared));
    if (count_ == room) settle();
    waiting_[count_++] = {e, f, i, j, unknown ? 0 : squared};
    return false;
  }

  /// A first bound, by a few vertices of each path.
  template <class T>
  void sample(const Edges<T>& a, const Edges<T>& b) noexcept {
    double squared = infinite;
    each_sample(a, [&](const Point<double>& p) {
      each_sample(b, [&](const Point<double>& q) {
        const double x = p.x - q.x, y = p.y - q.y;
        squared = lane::min(squared, x * x + y * y);
      });
    });
    least_.lower(std::sqrt(squared));
  }

  std::int32_t result(Points& out) noexcept {
    settle();
    return least_.result(out);
  }

 private:
  static constexpr int room = 16;
  struct Waiting {
    Edge e, f;
    std::int64_t i, j;
    double squared;  // a bound
  };

  void ask(const Waiting& pair) noexcept {
    Points points;
    const std::int32_t error = nearest_or_error(pair.e, pair.f, points);
    if (error != 0) return least_.refuse(error);
    least_.offer(points, pair.i, pair.j);
  }
  void settle() noexcept {
    for (int k = 0; k < count_; ++k) {
      if (least_.keeps_squared(waiting_[k].squared)) ask(waiting_[k]);
    }
    count_ = 0;
  }

  template <class T, class Visit>
  static void each_sample(const Edges<T>& edges, Visit visit) noexcept {
    const Range all = edges.all();
    const std::int64_t step = (all.length() + 15) / 16;
    for (std::int64_t i = all.first; i < all.last; i += step) visit(edges.vertex(i));
  }

  Least least_;
  bool overflows_;  // a square may
  int count_ = 0;
  Waiting waiting_[room];
};

/// An order of paths that does not depend on which is the first operand; 0 if they are the same.
template <class T>
int compared(const Edges<T>& a, const Edges<T>& b) noexcept {
  const Range in_a = a.all(), in_b = b.all();
  int order = compared(in_a.length(), in_b.length());
  for (std::int64_t i = 0; order == 0 && i < in_a.length(); ++i) {
    const auto p = a.vertex(in_a.first + i), q = b.vertex(in_b.first + i);
    order = p.x != q.x ? compared(p.x, q.x) : compared(p.y, q.y);
  }
  if (order == 0) order = compared(a.closed(), b.closed());
  if (order == 0) order = compared(a.rings(), b.rings());
  for (std::int64_t j = 0; order == 0 && j < a.rings(); ++j) order = compared(a.ring(j).length(), b.ring(j).length());
  return order;
}

}  // namespace vesica::detail::polygon
