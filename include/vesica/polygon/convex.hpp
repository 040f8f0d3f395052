// SPDX-License-Identifier: Apache-2.0
/// Is a polygon convex? Exact, by the sides to which its outline turns.
#pragma once

#include <vesica/polygon/inside.hpp>

namespace vesica::detail::polygon {

/// A convex polygon with area is one ring that turns one way only and winds once; collinear vertices are allowed. A
/// path whose vertices are on one line is a segment or a point: `flat`, from one end of `span` to the other.
struct Convexity {
  bool convex, flat;
  bool clockwise;
  Range ring;
  Edge span;
};

/// The order from left to right, and upwards.
template <class P>
bool is_left_of(const P& p, const P& q) noexcept {
  return p.x < q.x || (p.x == q.x && p.y < q.y);
}

/// Follows a ring by its distinct vertices.
class Turns {
 public:
  void pass(const Point<double>& q) noexcept {
    if (count_ > 0 && q.x == to_.x && q.y == to_.y) return;
    if (count_ > 0) {
      const bool forward = is_left_of(to_, q);
      if (count_ > 1) turn(q, forward);
      forward_ = forward;
      from_ = to_;
    }
    to_ = q;
    if (++count_ == 2) second_ = q;
  }
  /// The ring is closed: its first turn comes last.
  void close(const Point<double>& first) noexcept {
    pass(first);
    if (count_ > 2) pass(second_);
  }

  bool flat() const noexcept { return !left_ && !right_; }
  bool clockwise() const noexcept { return right_; }
  /// A ring that winds once goes back once.
  bool convex() const noexcept { return left_ != right_ && !reversed_ && changes_ == 2; }

 private:
  void turn(const Point<double>& q, bool forward) noexcept {
    const int side = polygon::turn(from_, to_, q);
    left_ = left_ || side > 0;
    right_ = right_ || side < 0;
    reversed_ = reversed_ || (side == 0 && forward != forward_);
    changes_ += static_cast<int>(forward != forward_);
  }

  Point<double> from_{}, to_{}, second_{};
  std::int64_t count_ = 0, changes_ = 0;
  bool forward_ = false, left_ = false, right_ = false, reversed_ = false;
};

/// The path is valid.
template <class T>
Convexity convexity(const Edges<T>& edges) noexcept {
  Range ring{0, 0};
  for (std::int64_t j = 0; j < edges.rings(); ++j) {
    const Range r = edges.ring(j);
    if (r.length() == 0) continue;
    if (ring.length() > 0) return {};
    ring = r;
  }
  Turns turns;
  Point<double> least = edges.vertex(ring.first), most = least;
  for (std::int64_t i = ring.first; i < ring.last; ++i) {
    const Point<double> p = edges.vertex(i);
    turns.pass(p);
    if (is_left_of(p, least)) least = p;
    if (is_left_of(most, p)) most = p;
  }
  if (edges.closed()) turns.close(edges.vertex(ring.first));
  const bool flat = turns.flat();
  return {
      flat || (edges.closed() && turns.convex()), flat, turns.clockwise(), ring, {least.x, least.y, most.x, most.y}};
}

}  // namespace vesica::detail::polygon
