// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace vesica::textbook {

/// The area two turned rectangles share, as rotated non-maximum suppression usually has it: the points in which edges
/// cross and the corners that lie in the other rectangle, sorted by angle about their mean, then the shoelace formula.
/// Axes are taken to be of unit length. No error bound: points found twice, or missed, make the area what they will.
template <class Rect>
class RotatedArea {
 public:
  using T = decltype(Rect::cx);

  static T shared(const Rect& a, const Rect& b) {
    RotatedArea both;
    Point p[4], q[4];
    corners(a, p);
    corners(b, q);
    both.add_crossings(p, q);
    both.add_corners_inside(p, q);
    both.add_corners_inside(q, p);
    return both.hull_area();
  }

  static T area(const Rect& r) { return 4 * r.hx * r.hy; }

  static T iou(const Rect& a, const Rect& b) {
    const T both = shared(a, b);
    return both / (area(a) + area(b) - both);
  }

 private:
  struct Point {
    T x, y;
  };
  static constexpr T slack = static_cast<T>(1e-6);

  static Point minus(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }
  static T cross(const Point& p, const Point& q) { return p.x * q.y - p.y * q.x; }
  static T dot(const Point& p, const Point& q) { return p.x * q.x + p.y * q.y; }

  static void corners(const Rect& r, Point (&p)[4]) {
    const T ax = r.hx * r.ux, ay = r.hx * r.uy, bx = -r.hy * r.uy, by = r.hy * r.ux;
    p[0] = {r.cx - ax - bx, r.cy - ay - by};
    p[1] = {r.cx + ax - bx, r.cy + ay - by};
    p[2] = {r.cx + ax + bx, r.cy + ay + by};
    p[3] = {r.cx - ax + bx, r.cy - ay + by};
  }

  void add_crossings(const Point (&p)[4], const Point (&q)[4]) {
    for (int i = 0; i < 4; ++i) {
      const Point d = minus(p[(i + 1) % 4], p[i]);
      for (int j = 0; j < 4; ++j) {
        const Point e = minus(q[(j + 1) % 4], q[j]);
        const T turn = cross(d, e);
        if (std::fabs(turn) <= static_cast<T>(1e-14)) continue;
        const Point off = minus(q[j], p[i]);
        const T t = cross(off, e) / turn, s = cross(off, d) / turn;
        if (t >= 0 && t <= 1 && s >= 0 && s <= 1) points_[count_++] = {p[i].x + t * d.x, p[i].y + t * d.y};
      }
    }
  }

  void add_corners_inside(const Point (&p)[4], const Point (&q)[4]) {
    const Point along = minus(q[1], q[0]), across = minus(q[3], q[0]);
    const T length = dot(along, along), width = dot(across, across);
    for (const Point& corner : p) {
      const Point off = minus(corner, q[0]);
      const T i = dot(off, along), j = dot(off, across);
      if (i >= -slack && j >= -slack && i <= length + slack && j <= width + slack) points_[count_++] = corner;
    }
  }

  T hull_area() {
    if (count_ < 3) return 0;
    Point mean{0, 0};
    for (int i = 0; i < count_; ++i) mean = {mean.x + points_[i].x, mean.y + points_[i].y};
    mean = {mean.x / static_cast<T>(count_), mean.y / static_cast<T>(count_)};
    std::sort(points_, points_ + count_, [&](const Point& p, const Point& q) {
      return std::atan2(p.y - mean.y, p.x - mean.x) < std::atan2(q.y - mean.y, q.x - mean.x);
    });
    T twice = 0;
    for (int i = 1; i + 1 < count_; ++i)
      twice += cross(minus(points_[i], points_[0]), minus(points_[i + 1], points_[0]));
    return std::fabs(twice) / 2;
  }

  Point points_[24];
  int count_ = 0;
};

}  // namespace vesica::textbook
