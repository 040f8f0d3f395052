// SPDX-License-Identifier: Apache-2.0
/// The places where outlines of cores with a radius meet (form/inflated.hpp). Circles and straight shapes are such too.
///
/// An outline is edges, moved out by the radius, and arcs about the core's corners. Edges are open and arcs closed, so
/// that each point of an outline is of one piece, and each place of one pair of pieces. Without a radius an arc is its
/// corner.
///
/// Proved: the number of places is exact. Where pieces meet, coordinates along an edge or from a corner are sums of
/// rational numbers and of roots. The sign of a + b is that of a^2 - b^2 if they have opposite signs, which takes one
/// root away. So every sign below is a rational number's in the end, of degree 20 at most.
///
/// Proved: outlines that share no stretch meet in at most 8 places.
///
///   - They cross as often as h_a - h_b changes its sign, h being support functions. Between two crossings the farthest
///     point of one outline from the other has a normal along which its h is greater; these normals are in order.
///   - A touch is a common point with a common normal.
///   - So neither changes in number if the lesser radius is taken from both. A rectangle is left, each of whose sides
///     meets a convex outline twice at most.
///
/// With shared stretches no more were found in 100,000 pairs of few digits.
#pragma once

#include <limits>
#include <vesica/crossings/box_box.hpp>
#include <vesica/form/inflated.hpp>

namespace vesica::detail::crossings {

/// The root of a positive number.
struct Root {
  exact::Number<2> square;
  Estimate estimate;

  explicit Root(const exact::Number<2>& x) noexcept : square(x), estimate(root(Estimate(x))) {}
};

/// a + b sqrt(s), precise, or exactly 0. A sum that cancels is (a^2 - b^2 s) / (a - b sqrt(s)). Long numbers are made
/// in functions of their own, since a call has little stack.
template <int A, int B>
VESICA_COLD Estimate cancelling_sum(const exact::Number<A>& a, const exact::Number<B>& b, const Root& s,
                                    const Estimate& difference) noexcept {
  return Estimate(exact::detail::sum_of_products(a, a, -1, b, b * s.square)) / difference;
}
template <int A, int B>
Estimate root_sum(const exact::Number<A>& a, const exact::Number<B>& b, const Root& s) noexcept {
  const Estimate first(a), second = Estimate(b) * s.estimate, sum = first + second;
  return sum.is_precise() ? sum : cancelling_sum(a, b, s, first - second);
}

/// a^2 + b^2 s - c^2 t.
template <int A, int B, int C>
VESICA_COLD auto sum_of_squares(const exact::Number<A>& a, const exact::Number<B>& b, const Root& s,
                                const exact::Number<C>& c, const Root& t) noexcept {
  return exact::detail::sum_of_products(a, a, 1, b, b * s.square) - c * (c * t.square);
}
template <int A, int B>
VESICA_COLD exact::Number<A + B> twice_product(const exact::Number<A>& a, const exact::Number<B>& b) noexcept {
  return exact::integer(2) * (a * b);
}
/// a + b sqrt(s) + c sqrt(t), likewise.
template <int A, int B, int C>
VESICA_COLD Estimate cancelling_sum(const exact::Number<A>& a, const exact::Number<B>& b, const Root& s,
                                    const exact::Number<C>& c, const Root& t, const Estimate& difference) noexcept {
  return root_sum(sum_of_squares(a, b, s, c, t), twice_product(a, b), s) / difference;
}
template <int A, int B, int C>
Estimate root_sum(const exact::Number<A>& a, const exact::Number<B>& b, const Root& s, const exact::Number<C>& c,
                  const Root& t) noexcept {
  const Estimate first = root_sum(a, b, s), second = Estimate(c) * t.estimate, sum = first + second;
  return sum.is_precise() ? sum : cancelling_sum(a, b, s, c, t, first - second);
}

/// A direction of a core's sides.
struct Side {
  exact::Length x, y;

  Side back() const noexcept { return {-x, -y}; }
  /// Out of the core, to the right of an edge.
  Side normal() const noexcept { return {y, -x}; }
};
inline exact::Number<2> dot(const Side& a, const Side& b) noexcept { return exact::dot(a.x, a.y, b.x, b.y); }
inline exact::Number<2> cross(const Side& a, const Side& b) noexcept { return exact::cross(a.x, a.y, b.x, b.y); }

/// A vector between corners.
struct Offset {
  Position x, y;
};
inline exact::Number<3> dot(const Side& a, const Offset& b) noexcept { return exact::dot(a.x, a.y, b.x, b.y); }
inline exact::Number<3> cross(const Side& a, const Offset& b) noexcept { return exact::cross(a.x, a.y, b.x, b.y); }

/// A vector in double.
struct Plain {
  double x, y;
};
inline double dot(const Plain& a, const Plain& b) noexcept { return a.x * b.x + a.y * b.y; }
inline Plain sum(const Plain& a, double k, const Plain& b) noexcept { return {a.x + k * b.x, a.y + k * b.y}; }

/// An edge or an arc in double, which decides that most pairs of pieces do not meet. Coordinates and sizes are at most
/// 2^44 `error`. With u = 2^-53 each number below is right to 32u of that, so sums that differ by `error` differ.
struct PlainPiece {
  Plain begin, end, centre, out;  ///< out: a unit vector, an edge's normal or to the middle of an arc
  Plain arriving, leaving;        ///< unit vectors along the edges before and after an arc
  double radius, error;
  bool is_arc, is_circle;

  /// The piece along a unit vector is between these.
  struct Shadow {
    double low, high;
    bool misses(const Shadow& other, double room) const noexcept {
      return high + room < other.low || other.high + room < low;
    }
  };
  Shadow along(const Plain& d) const noexcept {
    const double p = dot(begin, d), q = dot(end, d);
    Shadow s{std::fmin(p, q), std::fmax(p, q)};
    if (!is_arc) return s;
    const double middle = dot(centre, d), into = dot(arriving, d), from = dot(leaving, d);
    if (is_circle || (into > -0x1p-30 && from < 0x1p-30)) s.high = std::fmax(s.high, middle + radius);
    if (is_circle || (into < 0x1p-30 && from > -0x1p-30)) s.low = std::fmin(s.low, middle - radius);
    return s;
  }
  /// True if an arc's circle certainly holds another piece inside, or is inside the circle of that.
  bool surrounds(const PlainPiece& other, double room) const noexcept {
    const auto square = [this](const Plain& p) {
      const Plain d = sum(p, -1, centre);
      return dot(d, d);
    };
    const double reach = radius - room;
    if (!is_arc || !(reach > 0)) return false;
    const bool holds_circle = is_within(square(other.centre), reach - other.radius);
    if (other.is_circle) return holds_circle;
    return square(other.begin) < reach * reach && square(other.end) < reach * reach && (!other.is_arc || holds_circle);
  }
  /// True if the pieces certainly share no point.
  bool misses(const PlainPiece& other) const noexcept {
    const double room = error + other.error;
    if (!(room > 0x1p-400 && room < 0x1p400)) return false;
    if (along(out).misses(other.along(out), room) || along(other.out).misses(other.along(other.out), room)) return true;
    if (is_arc && other.is_arc) {
      const Plain d = sum(other.centre, -1, centre);
      const double reach = radius + other.radius + room;
      if (dot(d, d) > reach * reach) return true;
    }
    return surrounds(other, room) || other.surrounds(*this, room);
  }

 private:
  static bool is_within(double square, double reach) noexcept { return reach > 0 && square < reach * reach; }
};

/// The outline of a core with a radius. Edge i runs from corner i, moved out, to the next; with a radius a segment has
/// two. Arc i is about corner i, from the edge before it to edge i.
struct RoundOutline {
  Corners corners;
  exact::Length radius;
  Root unit;  ///< the length of all sides
  int edges;
  PlainPiece edge[4], arc[4];

  RoundOutline(const exact::Box& core, const exact::Length& r) noexcept
      : corners(core), radius(r), unit(exact::dot(core.ux, core.uy, core.ux, core.uy)) {
    edges = corners.count == 2 && radius.sign > 0 ? 2 : corners.edges;
    set_pieces();
  }
  /// Along edge i; of a circle along the axes.
  Side side(int i) const noexcept {
    const exact::Length &x = corners.box.ux, &y = corners.box.uy;
    const bool is_segment = corners.count == 2, is_across = is_segment ? !corners.wide : i % 2 != 0;
    const Side forward = is_across ? Side{-y, x} : Side{x, y};
    return (is_segment ? i == 1 : i >= 2) ? forward.back() : forward;
  }
  int next(int i) const noexcept { return corners.next(i); }
  int before(int i) const noexcept { return i > 0 ? i - 1 : corners.count - 1; }
  bool is_circle() const noexcept { return corners.count == 1; }

  /// Positions along the outline count the pieces: edge i is from 2 i to 2 i + 1, and arc i ends at 2 i.
  double arc_begins(int i) const noexcept { return 2 * (i > 0 ? i : corners.count) - 1; }
  static double arc_ends(int i) noexcept { return 2 * i; }
  static Real on_edge(int i, double part) noexcept { return Real(2 * i) + Real(crossings::on_edge(0, part)); }

 private:
  void set_pieces() noexcept {
    Plain corner[4], along[4];
    const double r = nearest(radius);
    double size = r;
    for (int i = 0; i < 4; ++i) {
      const Scaled x = exact::rounded(side(i).x), y = exact::rounded(side(i).y), length = unit.estimate.scaled();
      along[i] = {quotient(x, length), quotient(y, length)};
      if (i >= corners.count) continue;
      corner[i] = {nearest(corners.x[i]), nearest(corners.y[i])};
      size = std::fmax(size, std::fmax(std::fabs(corner[i].x), std::fabs(corner[i].y)));
    }
    const double error = 0x1p-44 * size;
    const auto normal = [&along](int i) { return Plain{along[i].y, -along[i].x}; };
    for (int i = 0; i < corners.count; ++i) {
      const int last = before(i);
      const Plain middle = sum(normal(last), 1, normal(i));
      const double shorter = std::sqrt(0.5);
      arc[i] = {sum(corner[i], r, normal(last)),
                sum(corner[i], r, normal(i)),
                corner[i],
                corners.count == 4 ? Plain{shorter * middle.x, shorter * middle.y} : along[last],
                along[last],
                along[i],
                r,
                error,
                true,
                is_circle()};
    }
    for (int i = 0; i < edges; ++i) {
      edge[i] = {arc[i].end, arc[next(i)].begin, {}, normal(i), {}, {}, 0, error, false, false};
    }
  }
};

inline double to_double(const Estimate& e) noexcept { return to_double(e.scaled()); }

/// turn() of two estimates.
inline Real turn_of(const Estimate& x, const Estimate& y) noexcept {
  const int unit = x.sign() == 0 || (y.sign() != 0 && y.exponent > x.exponent) ? y.exponent : x.exponent;
  const auto scaled = [unit](const Estimate& e) {
    const double factor = e.sign() == 0 ? 0 : arithmetic::scale(1, e.exponent - unit);
    return Real{e.value.high * factor, e.value.low * factor};
  };
  return turn(scaled(x), scaled(y));
}

/// The position of a point of arc i's circle along the outline; negative if it is not on the arc. component(side): the
/// vector from the corner to the point times a side, over anything positive.
template <class Component>
Real along_arc(const RoundOutline& o, int i, const Component& component) noexcept {
  if (o.is_circle()) {
    const Estimate y = component(o.side(1)), x = component(o.side(0));
    return y.sign() == 0 && x.sign() >= 0 ? Real() : turn_of(x, y) + Real(std::numeric_limits<double>::min());
  }
  const Side& arriving = o.side(o.before(i));
  const Estimate forward = component(arriving), onward = component(o.side(i));
  if (forward.sign() < 0 || onward.sign() > 0) return Real(-1.0);
  const Estimate out = component(arriving.normal());
  if (onward.sign() == 0 && out.sign() <= 0) return Real(RoundOutline::arc_ends(i));
  const Real begins(o.arc_begins(i)), part = turn_of(out, forward) * (o.corners.count == 2 ? 0.5 : 1.0);
  return forward.sign() == 0 ? begins : begins + (part < Real(1.0) ? part : Real(std::nextafter(1.0, 0.0)));
}

/// Places of the two outlines, or of the second and the first.
struct Places {
  Found& found;
  bool exchanged;

  void add(const Estimate& x, const Estimate& y, const Real& along_a, const Real& along_b) const noexcept {
    found.add({to_double(x), to_double(y), exchanged ? along_b : along_a, exchanged ? along_a : along_b});
  }
};

/// From corner k of b to corner i of a.
inline Offset offset(const RoundOutline& a, int i, const RoundOutline& b, int k) noexcept {
  return {a.corners.x[i] - b.corners.x[k], a.corners.y[i] - b.corners.y[k]};
}

/// True if parallel edges share a stretch: they are on one line, and their ends are in the order of such.
VESICA_COLD inline bool share_stretch(const RoundOutline& a, int i, const RoundOutline& b, int k) noexcept {
  const Side &d = a.side(i), n = d.normal();
  const Offset from_a = offset(b, k, a, i);
  const bool alike = dot(d, b.side(k)).sign > 0;
  // n.(Q - P) + (+-s - r) |n| is how far b's line is beyond a's.
  const exact::Length apart = alike ? b.radius - a.radius : -(b.radius + a.radius);
  if (root_sum(dot(n, from_a), apart, a.unit).sign() != 0) return false;
  const auto start = dot(d, from_a), end = dot(d, offset(b, b.next(k), a, i));
  const auto length = dot(d, offset(a, a.next(i), a, i));
  const auto &low = alike ? start : end, &high = alike ? end : start;
  return high.sign > 0 && exact::compare(low, length) < 0;
}

/// Two edges. With P and Q their first corners, the place is P + (x d + r |d| n) / |d|^2, with d x f = k and
///   x k = |d|^2 (s |f| - (P - Q).o) - r |d| (d.f),
/// o being the normal of b's edge. From the end of a's edge on, x is less by its length: P is the end then.
inline Estimate along_edge(const RoundOutline& a, int i, int corner, const RoundOutline& b, int k) noexcept {
  const Side &d = a.side(i), &f = b.side(k);
  const auto off = dot(f.normal(), offset(a, corner, b, k));
  return root_sum(-(a.unit.square * off), -(a.radius * dot(d, f)), a.unit, a.unit.square * b.radius, b.unit);
}
inline void cross_edges(const RoundOutline& a, int i, const RoundOutline& b, int k, const Places& places) noexcept {
  const Side &d = a.side(i), n = d.normal();
  const auto turned = cross(d, b.side(k));
  if (turned.sign == 0) {
    if (!places.found.shared) places.found.shared = share_stretch(a, i, b, k);
    return;
  }
  const int way = turned.sign;
  const Estimate start = along_edge(a, i, i, b, k), end = along_edge(a, i, a.next(i), b, k);
  if (way * start.sign() <= 0 || way * end.sign() >= 0) return;
  const Estimate start_b = along_edge(b, k, k, a, i), end_b = along_edge(b, k, b.next(k), a, i);
  if (way * start_b.sign() >= 0 || way * end_b.sign() <= 0) return;
  const Estimate square(a.unit.square), x = start / Estimate(turned) / square;
  const Estimate out = Estimate(a.radius) / a.unit.estimate;
  places.add(Estimate(a.corners.x[i]) + (x * Estimate(d.x) + out * Estimate(n.x)),
             Estimate(a.corners.y[i]) + (x * Estimate(d.y) + out * Estimate(n.y)),
             RoundOutline::on_edge(i, to_double(start / (start - end))),
             RoundOutline::on_edge(k, to_double(start_b / (start_b - end_b))));
}

/// An edge and a circle about a corner Q. With w = P - Q, places are Q + (x d + y n) / |d|^2, where
///   y = w.n + r |d|,  x^2 = (s |d| - y) (s |d| + y).
class LineAndCircle {
 public:
  LineAndCircle(const RoundOutline& a, int i, const RoundOutline& b, int k) noexcept
      : a_(a), b_(b), d_(a.side(i)), n_(d_.normal()) {
    const Offset w = offset(a, i, b, k);
    off_ = dot(n_, w);
    start_ = dot(d_, w);
    end_ = dot(d_, offset(a, a.next(i), b, k));
    const Estimate above = root_sum(-off_, b.radius - a.radius, a.unit);
    const Estimate below = root_sum(off_, b.radius + a.radius, a.unit);
    if (above.sign() < 0 || below.sign() < 0) return;
    roots_ = above.sign() == 0 || below.sign() == 0 ? 1 : 2;
    if (roots_ == 2) half_ = root(above * below);
    y_ = root_sum(off_, a.radius, a.unit);
  }
  /// How many places the line and the circle have in common.
  int roots() const noexcept { return roots_; }
  void choose(int root) noexcept {
    sign_ = roots_ == 1 ? 0 : root == 0 ? -1 : 1;
    x_ = sign_ < 0 ? -half_ : half_;
  }
  bool is_on_edge() const noexcept { return beyond(start_) > 0 && beyond(end_) < 0; }
  /// From 0 to 1.
  double part_of_edge() const noexcept { return to_double((x_ - Estimate(start_)) / Estimate(end_ - start_)); }

  /// From Q to the place, times a side of b, times |d|^2. The difference of the terms' squares is
  ///   |d|^2 (s^2 (d.g)^2 - |g|^2 y^2).
  Estimate component(const Side& g) const noexcept {
    const auto along = dot(d_, g), across = dot(n_, g);
    const Estimate first = x_ * Estimate(along), second = y_ * Estimate(across), sum = first + second;
    return sum.is_precise() ? sum : cancelling_component(along, first - second);
  }
  Estimate from_corner(const exact::Length& along, const exact::Length& across) const noexcept {
    return (x_ * Estimate(along) + y_ * Estimate(across)) / Estimate(a_.unit.square);
  }
  const Side& along() const noexcept { return d_; }
  const Side& across() const noexcept { return n_; }

 private:
  /// The sign of x - m.
  int beyond(const exact::Number<3>& m) const noexcept {
    const Estimate difference = x_ - Estimate(m);
    return difference.sign_is_known() ? difference.sign() : sign_ * compare_squares(m);
  }
  /// x^2 and m^2.
  VESICA_COLD int compare_squares(const exact::Number<3>& m) const noexcept {
    const auto squares = exact::square(b_.radius) * a_.unit.square - exact::square(a_.radius) * a_.unit.square -
                         exact::square(off_) - exact::square(m);
    return root_sum(squares, exact::integer(-2) * (a_.radius * off_), a_.unit).sign();
  }
  VESICA_COLD Estimate cancelling_component(const exact::Number<2>& along, const Estimate& difference) const noexcept {
    return Estimate(a_.unit.square) * root_sum(squares(b_.radius * along), mixed(), a_.unit) / difference;
  }
  /// x^2 - |g|^2 y^2 for an x, without the root's part of y^2; and that.
  VESICA_COLD exact::Number<8> squares(const exact::Number<3>& x) const noexcept {
    const auto square = exact::detail::sum_of_products(off_, off_, 1, a_.radius, a_.radius * a_.unit.square);
    return exact::detail::sum_of_products(x, x, -1, b_.unit.square, square);
  }
  VESICA_COLD exact::Number<6> mixed() const noexcept {
    return exact::integer(-2) * (b_.unit.square * (a_.radius * off_));
  }

  const RoundOutline &a_, &b_;
  Side d_, n_;
  exact::Number<3> off_, start_, end_;
  Estimate half_, x_, y_;
  int roots_ = 0, sign_ = 0;
};

inline void cross_edge_and_arc(const RoundOutline& a, int i, const RoundOutline& b, int k,
                               const Places& places) noexcept {
  LineAndCircle met(a, i, b, k);
  for (int root = 0; root < met.roots(); ++root) {
    met.choose(root);
    if (!met.is_on_edge()) continue;
    const Real along = along_arc(b, k, [&](const Side& g) { return met.component(g); });
    if (rounded(along) < 0) continue;
    places.add(Estimate(b.corners.x[k]) + met.from_corner(met.along().x, met.across().x),
               Estimate(b.corners.y[k]) + met.from_corner(met.along().y, met.across().y),
               RoundOutline::on_edge(i, met.part_of_edge()), along);
  }
}

/// Circles about different corners P and Q. With v = Q - P, places are P + (y v + x perp(v)) / (2 v.v), where
///   y = v.v + r^2 - s^2,  x^2 = ((r + s)^2 - v.v) (v.v - (r - s)^2).
class TwoCircles {
 public:
  TwoCircles(const RoundOutline& a, const RoundOutline& b, const Offset& v, const exact::Number<4>& square) noexcept
      : a_(a), b_(b), v_(v), square_(square) {
    const auto sum = a.radius + b.radius, difference = a.radius - b.radius;
    const auto inside_sum = exact::square(sum) - square, outside_difference = square - exact::square(difference);
    if (inside_sum.sign < 0 || outside_difference.sign < 0) return;
    roots_ = inside_sum.sign == 0 || outside_difference.sign == 0 ? 1 : 2;
    if (roots_ == 2) half_ = root(Estimate(inside_sum) * Estimate(outside_difference));
    from_a_ = square + sum * difference;
    from_b_ = from_a_ - exact::integer(2) * square;
  }
  int roots() const noexcept { return roots_; }
  void choose(int root) noexcept { x_ = root == 0 ? -half_ : half_; }

  /// From a corner to the place, times a side, times 2 v.v.
  Estimate from_a(const Side& g) const noexcept { return component(from_a_, a_.radius, g); }
  Estimate from_b(const Side& g) const noexcept { return component(from_b_, b_.radius, g); }
  Estimate x() const noexcept { return from_corner(v_.x, -v_.y); }
  Estimate y() const noexcept { return from_corner(v_.y, v_.x); }

 private:
  /// The difference of the terms' squares is v.v (y^2 |g|^2 - 4 r^2 (perp(v).g)^2).
  Estimate component(const exact::Number<4>& y, const exact::Length& radius, const Side& g) const noexcept {
    const auto along = dot(g, v_), across = -cross(g, v_);
    const Estimate first = Estimate(y) * Estimate(along), second = x_ * Estimate(across), sum = first + second;
    return sum.is_precise() ? sum : cancelling_component(y, radius, g, across, first - second);
  }
  VESICA_COLD Estimate cancelling_component(const exact::Number<4>& y, const exact::Length& radius, const Side& g,
                                            const exact::Number<3>& across, const Estimate& difference) const noexcept {
    const auto reach = exact::integer(2) * (radius * across);
    return Estimate(square_) * Estimate(exact::detail::sum_of_products(y, y * dot(g, g), -1, reach, reach)) /
           difference;
  }
  Estimate from_corner(const Position& along, const Position& across) const noexcept {
    return (Estimate(from_a_) * Estimate(along) + x_ * Estimate(across)) / (times(2, Estimate(square_)));
  }

  const RoundOutline &a_, &b_;
  const Offset& v_;
  const exact::Number<4>& square_;
  exact::Number<4> from_a_, from_b_;
  Estimate half_, x_;
  int roots_ = 0;
};

/// The directions from a corner to the ends of its arc, and one to its middle.
struct ArcDirections {
  Side begin, end, middle;

  ArcDirections(const RoundOutline& o, int i) noexcept
      : begin(o.side(o.before(i)).normal()), end(o.side(i).normal()), middle(o.side(o.before(i))) {
    if (o.corners.count == 4) middle = {begin.x + end.x, begin.y + end.y};
  }
};

/// True if a direction leads from corner i between the ends of its arc.
inline bool is_between_ends(const RoundOutline& o, int i, const Side& direction) noexcept {
  return o.is_circle() || (dot(o.side(o.before(i)), direction).sign > 0 && dot(o.side(i), direction).sign < 0);
}

/// True if arcs of one circle share a stretch: an end or the middle of one is between the ends of the other.
inline bool share_stretch_of_circle(const RoundOutline& a, int i, const RoundOutline& b, int k) noexcept {
  if (a.is_circle() || b.is_circle()) return true;
  const ArcDirections of_a(a, i), of_b(b, k);
  for (const Side* s : {&of_a.begin, &of_a.end, &of_a.middle}) {
    if (is_between_ends(b, k, *s)) return true;
  }
  for (const Side* s : {&of_b.begin, &of_b.end, &of_b.middle}) {
    if (is_between_ends(a, i, *s)) return true;
  }
  return false;
}

/// The ends of a's arc that are on b's arc of the same circle, but those of `known`.
inline void add_ends(const RoundOutline& a, int i, const RoundOutline& b, int k, const ArcDirections* known,
                     const Places& places) noexcept {
  if (a.is_circle()) return;
  const ArcDirections ends(a, i);
  for (const bool last : {false, true}) {
    const Side& end = last ? ends.end : ends.begin;
    const auto is_end = [&](const Side& other) { return cross(end, other).sign == 0 && dot(end, other).sign > 0; };
    if (known != nullptr && (is_end(known->begin) || is_end(known->end))) continue;
    const Real along = along_arc(b, k, [&](const Side& g) { return Estimate(dot(g, end)); });
    if (rounded(along) < 0) continue;
    const Estimate out = Estimate(a.radius) / a.unit.estimate;
    places.add(Estimate(a.corners.x[i]) + out * Estimate(end.x), Estimate(a.corners.y[i]) + out * Estimate(end.y),
               Real(last ? RoundOutline::arc_ends(i) : a.arc_begins(i)), along);
  }
}

/// True if corners with arcs of equal radii are one point.
inline bool is_same_circle(const RoundOutline& a, int i, const RoundOutline& b, int k) noexcept {
  return is_corner(a.corners, i, b.corners.x[k], b.corners.y[k]) && exact::compare(a.radius, b.radius) == 0;
}

inline void cross_arcs(const RoundOutline& a, int i, const RoundOutline& b, int k, const Places& places) noexcept {
  const Offset v = offset(b, k, a, i);
  const auto square = exact::dot(v.x, v.y, v.x, v.y);
  if (square.sign == 0) {
    if (exact::compare(a.radius, b.radius) != 0) return;
    const ArcDirections of_a(a, i);
    places.found.shared = places.found.shared || share_stretch_of_circle(a, i, b, k);
    add_ends(a, i, b, k, nullptr, places);
    add_ends(b, k, a, i, a.is_circle() ? nullptr : &of_a, {places.found, !places.exchanged});
    return;
  }
  TwoCircles met(a, b, v, square);
  for (int root = 0; root < met.roots(); ++root) {
    met.choose(root);
    const Real along_a = along_arc(a, i, [&](const Side& g) { return met.from_a(g); });
    if (rounded(along_a) < 0) continue;
    const Real along_b = along_arc(b, k, [&](const Side& g) { return met.from_b(g); });
    if (rounded(along_b) < 0) continue;
    places.add(Estimate(a.corners.x[i]) + met.x(), Estimate(a.corners.y[i]) + met.y(), along_a, along_b);
  }
}

/// Calls f(i, k) for pieces that may meet.
template <class Function>
void each_pair(const PlainPiece* a, int count_a, const PlainPiece* b, int count_b, const Function& f) noexcept {
  for (int i = 0; i < count_a; ++i) {
    for (int k = 0; k < count_b; ++k) {
      if (!a[i].misses(b[k])) f(i, k);
    }
  }
}

inline Found crossings(const RoundOutline& a, const RoundOutline& b) noexcept {
  Found found;
  const Places in_order{found, false}, exchanged{found, true};
  const int arcs_a = a.corners.count, arcs_b = b.corners.count;
  each_pair(a.arc, arcs_a, b.arc, arcs_b, [&](int i, int k) { cross_arcs(a, i, b, k, in_order); });
  each_pair(a.edge, a.edges, b.arc, arcs_b, [&](int i, int k) { cross_edge_and_arc(a, i, b, k, in_order); });
  each_pair(b.edge, b.edges, a.arc, arcs_a, [&](int i, int k) { cross_edge_and_arc(b, i, a, k, exchanged); });
  each_pair(a.edge, a.edges, b.edge, b.edges, [&](int i, int k) { cross_edges(a, i, b, k, in_order); });
  return found;
}

/// True if the outlines share a stretch.
VESICA_COLD inline bool share_stretch(const RoundOutline& a, const RoundOutline& b) noexcept {
  bool any = false;
  each_pair(a.edge, a.edges, b.edge, b.edges,
            [&](int i, int k) { any = any || (cross(a.side(i), b.side(k)).sign == 0 && share_stretch(a, i, b, k)); });
  each_pair(a.arc, a.corners.count, b.arc, b.corners.count,
            [&](int i, int k) { any = any || (is_same_circle(a, i, b, k) && share_stretch_of_circle(a, i, b, k)); });
  return any;
}

/// The outline of a valid shape.
template <class Shape>
RoundOutline round_outline(const Shape& s) noexcept {
  const auto f = form::inflated(s);
  return {exact::form(f.core), exact::from_double(f.radius)};
}

}  // namespace vesica::detail::crossings
