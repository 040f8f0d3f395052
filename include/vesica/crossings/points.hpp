// SPDX-License-Identifier: Apache-2.0
/// The result of crossings(), and corners and edges of boxes.
#pragma once

#include <cstdint>
#include <vesica/arithmetic/double_double.hpp>
#include <vesica/exact/form.hpp>
#include <vesica/exact/rounded.hpp>

namespace vesica {

/// The places where two outlines meet: x[0] y[0] ... in order along the first shape's outline, the rest 0; and whether
/// the outlines have a stretch in common. An ellipse and a rounded rectangle can meet in 12 places, others in 8.
template <class T>
struct CrossingPoints {
  std::int32_t count, shared;
  T x[12], y[12];
};

namespace detail::crossings {

using Scaled = arithmetic::Scaled;
using Real = arithmetic::AccurateDoubleDouble;

inline double to_double(const Scaled& s) noexcept { return arithmetic::scale(s.value, s.exponent); }

/// a / b for exact numbers' nearest doubles, whatever their exponents.
inline double quotient(const Scaled& a, const Scaled& b) noexcept {
  return arithmetic::scale(a.value / b.value, a.exponent - b.exponent);
}

/// a + b for numbers that are not negative.
inline Scaled sum(const Scaled& a, const Scaled& b) noexcept {
  if (b.value == 0) return a;
  if (a.value == 0 || a.exponent < b.exponent) return a.value == 0 ? b : sum(b, a);
  return {a.value + arithmetic::scale(b.value, b.exponent - a.exponent), a.exponent};
}
inline Scaled root(const Scaled& a) noexcept {
  const bool odd = (a.exponent & 1) != 0;
  return {std::sqrt(odd ? 2 * a.value : a.value), (a.exponent - (odd ? 1 : 0)) / 2};
}

template <int Degree>
double nearest(const exact::Number<Degree>& x) noexcept {
  return to_double(exact::rounded(x));
}

/// An exact number over 2^exponent, to two doubles.
template <int Degree>
Real two_doubles(const exact::Number<Degree>& x, int exponent) noexcept {
  const auto [high, low] = exact::rounded_twice(x);
  const int shift = high.exponent - exponent;
  return {arithmetic::scale(high.value, shift), arithmetic::scale(low, shift)};
}

/// Grows with the angle of (x, y) from the positive x axis, from 0 up to 4; 0 for the origin.
inline Real turn(const Real& x, const Real& y) noexcept {
  const Real sum = abs(x) + abs(y);
  if (!(rounded(sum) > 0)) return {};
  const Real part = y / sum;
  return rounded(x) < 0 ? Real(2.0) - part : rounded(y) < 0 ? Real(4.0) + part : part;
}

/// A place where the outlines meet, with where it is along either: only the order counts.
struct Place {
  double x, y;
  Real along_a, along_b;

  /// Exactly where the second outline begins: before what is so near that it rounds to there.
  void begins_b() noexcept { along_b = Real(-1.0); }
};

struct Found {
  Place place[12];
  int count = 0;
  bool shared = false;

  void add(const Place& p) noexcept {
    if (count < 12) place[count++] = p;
  }
  /// True if a place may be the one where the second outline begins: all are known to far less than this.
  bool is_near_start_of_b() const noexcept {
    const Real margin(0x1p-30);
    for (int i = 0; i < count; ++i) {
      const Real at = place[i].along_b, off = rounded(at) > 2 ? Real(4.0) - at : at;
      if (off < margin) return true;
    }
    return false;
  }
  /// Sorts along the first shape, or along the second.
  CrossingPoints<double> in_order(bool along_b) noexcept {
    const auto key = [along_b](const Place& p) { return along_b ? p.along_b : p.along_a; };
    for (int i = 1; i < count; ++i) {
      const Place p = place[i];
      int k = i;
      for (; k > 0 && key(p) < key(place[k - 1]); --k) place[k] = place[k - 1];
      place[k] = p;
    }
    CrossingPoints<double> out{count, shared ? 1 : 0, {}, {}};
    for (int i = 0; i < count; ++i) {
      out.x[i] = place[i].x;
      out.y[i] = place[i].y;
    }
    return out;
  }
};

using Position = exact::Number<2>;

/// A box's corners in order, counter-clockwise: 4, 2 of one without width or height, 1 of a point. Edge i runs from
/// corner i to the next; 2 corners have one edge.
struct Corners {
  Position x[4], y[4];
  exact::Box box;
  Position ax, ay, bx, by;  ///< halves of the edges along the axis and across it
  int count, edges;
  bool wide, high;

  explicit Corners(const exact::Box& b) noexcept
      : box(b),
        ax(b.hx * b.ux),
        ay(b.hx * b.uy),
        bx(exact::integer(-1) * (b.hy * b.uy)),
        by(b.hy * b.ux),
        wide(b.hx.sign != 0),
        high(b.hy.sign != 0) {
    count = (wide ? 2 : 1) * (high ? 2 : 1);
    edges = count == 2 ? 1 : count == 4 ? 4 : 0;
    set(x, b.cx, ax, bx);
    set(y, b.cy, ay, by);
  }
  bool is_right(int i) const noexcept { return wide && (i == 1 || i == 2); }
  bool is_top(int i) const noexcept { return high && (count == 2 ? i == 1 : i >= 2); }
  int next(int i) const noexcept { return i + 1 == count ? 0 : i + 1; }
  /// Edge i is twice this half, backwards where is_backward().
  bool is_along_axis(int i) const noexcept { return edges == 1 ? wide : i % 2 == 0; }
  bool is_backward(int i) const noexcept { return i >= 2; }

 private:
  void set(Position* at, const exact::Length& centre, const Position& a, const Position& b) const noexcept {
    const Position left = centre - a, right = centre + a;
    for (int i = 0; i < count; ++i) {
      const Position& middle = is_right(i) ? right : left;
      at[i] = is_top(i) ? middle + b : middle - b;
    }
  }
};

/// An edge as a place and a step.
struct Edge {
  Position x, y, dx, dy;
  Edge(const Corners& c, int i) noexcept
      : x(c.x[i]), y(c.y[i]), dx(c.x[c.next(i)] - c.x[i]), dy(c.y[c.next(i)] - c.y[i]) {}
};

/// An edge's ends and step, each rounded once.
class RoundedEdge {
 public:
  RoundedEdge(const Corners& c, int i) noexcept
      : x_{nearest(c.x[i]), nearest(c.x[c.next(i)]), step(c, i, c.is_along_axis(i) ? c.ax : c.bx)},
        y_{nearest(c.y[i]), nearest(c.y[c.next(i)]), step(c, i, c.is_along_axis(i) ? c.ay : c.by)} {}
  /// From the nearer end.
  double at_x(double t) const noexcept { return x_.at(t); }
  double at_y(double t) const noexcept { return y_.at(t); }
  double length() const noexcept { return std::fabs(x_.step) + std::fabs(y_.step); }

 private:
  struct Way {
    double from, to, step;
    double at(double t) const noexcept { return t <= 0.5 ? from + t * step : to - (1 - t) * step; }
  };
  Way x_, y_;

  static double step(const Corners& c, int i, const Position& half) noexcept {
    const Scaled s = exact::rounded(half);
    return to_double({c.is_backward(i) ? -s.value : s.value, s.exponent + 1});
  }
};

}  // namespace detail::crossings
}  // namespace vesica
