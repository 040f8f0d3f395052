// SPDX-License-Identifier: Apache-2.0
/// Any two shapes, brought to one form, one place and one scale.
///
/// A shape is a box or an ellipse about a centre; a circle is a point that reaches r farther. Of stored coordinates
/// only differences are formed, as exactly as two doubles hold them, so that moving both shapes by the same exact
/// amount changes nothing. Lengths come in a power of two near the largest of them: what is smaller by more than the
/// range of double is lost, and nothing that the accuracy speaks of.
#pragma once

#include <vesica/nearest/box_box.hpp>
#include <vesica/shapes.hpp>
#include <vesica/spectrum.hpp>

namespace vesica::detail::nearest {

/// A shape before it is placed. Its centre is the mean of two stored points. Lengths are k times what is stored, k a
/// power of two.
struct Form {
  double from_x, from_y, to_x, to_y;
  Box<double> box;  // of an ellipse: its half lengths
  double radius;
  bool curved;
};

inline Box<double> plain_box(double ux, double uy, double hx, double hy) noexcept {
  return {{{ux, 0}, {uy, 0}}, {hx, 0}, {hy, 0}};
}

inline Form form(const Point<double>& s, double k) noexcept {
  return {k * s.x, k * s.y, k * s.x, k * s.y, plain_box(1, 0, 0, 0), 0, false};
}
inline Form form(const Segment<double>& s, double k) noexcept {
  const double x0 = k * s.x0, y0 = k * s.y0, x1 = k * s.x1, y1 = k * s.y1;
  if (x0 == x1 && y0 == y1) return {x0, y0, x1, y1, plain_box(1, 0, 0, 0), 0, false};
  return {x0, y0, x1, y1, {{exact_difference(x1, x0), exact_difference(y1, y0)}, {0.5, 0}, {0, 0}}, 0, false};
}
inline Form form(const Aabb<double>& s, double k) noexcept {
  const double x0 = k * s.min_x, y0 = k * s.min_y, x1 = k * s.max_x, y1 = k * s.max_y;
  // With an axis of length 1/2 the half extents are the widths, and nothing is halved.
  return {x0, y0, x1, y1, {{{0.5, 0}, {0, 0}}, exact_difference(x1, x0), exact_difference(y1, y0)}, 0, false};
}
inline Form form(const Rect<double>& s, double k) noexcept {
  return {k * s.cx, k * s.cy, k * s.cx, k * s.cy, plain_box(k * s.ux, k * s.uy, s.hx, s.hy), 0, false};
}
inline Form form(const Circle<double>& s, double k) noexcept {
  return {k * s.cx, k * s.cy, k * s.cx, k * s.cy, plain_box(1, 0, 0, 0), k * s.r, false};
}
inline Form form(const Ellipse<double>& s, double k) noexcept {
  const Rect<double> numbers{s.cx, s.cy, s.ux, s.uy, s.a, s.b};
  Form f = form(numbers, k);
  f.curved = s.a > 0 && s.b > 0;
  return f;
}

/// A shape at the common scale.
struct Placed {
  Box<double> box;
  double radius;
  bool curved;

  Axes<double> axes() const noexcept { return {box.u.x.high, box.u.y.high, box.hx.high, box.hy.high}; }
};

/// The offset d leads from the first centre to the second. Lengths are in units of 2^exponent; the largest is about 1,
/// and so is the longer component of each axis.
struct PlacedPair {
  Placed a, b;
  Vector<double> d;
  double size;  // at least the largest length, at most some six times that
  int exponent;
};

using detail::exponent_of;

/// x * 2^exponent, of lengths that may themselves be beyond the range of double.
inline double scale(double x, int exponent) noexcept {
  return detail::scale(detail::scale(x, exponent / 2), exponent - exponent / 2);
}

inline Twofold<double> scaled(const Twofold<double>& x, int exponent) noexcept {
  return {scale(x.high, exponent), scale(x.low, exponent)};
}

/// Exponent of a length; very small for 0.
inline int length_exponent(double size, int unit = 0) noexcept { return size == 0 ? -9999 : exponent_of(size) + unit; }

inline int axis_exponent(const Form& f) noexcept { return exponent_of(max(abs(f.box.u.x.high), abs(f.box.u.y.high))); }

inline int largest_exponent(const Form& f) noexcept {
  const int k = axis_exponent(f), x = length_exponent(f.box.hx.high, k), y = length_exponent(f.box.hy.high, k);
  const int r = length_exponent(f.radius), longer = x > y ? x : y;
  return longer > r ? longer : r;
}

/// Ellipses thinner than this are segments to all that can be told of them, those smaller points.
inline constexpr double thinnest = 0x1p-52, smallest = 0x1p-120;

inline Placed placed(const Form& f, int unit) noexcept {
  const int k = axis_exponent(f);
  Placed p{{{scaled(f.box.u.x, -k), scaled(f.box.u.y, -k)}, scaled(f.box.hx, k - unit), scaled(f.box.hy, k - unit)},
           scale(f.radius, -unit),
           f.curved};
  if (!p.curved) return p;
  double &a = p.box.hx.high, &b = p.box.hy.high;
  const double longer = max(a, b), least = longer < smallest ? 1 : thinnest * longer;
  if (a < least) a = 0;
  if (b < least) b = 0;
  p.curved = a > 0 && b > 0;
  return p;
}

inline double reach(const Placed& p) noexcept { return p.radius + (p.box.hx.high + p.box.hy.high); }

inline PlacedPair placed(const Form& a, const Form& b) noexcept {
  const auto twice = [](double to0, double to1, double from0, double from1) {
    return renormalised(exact_difference(to0, from0) + exact_difference(to1, from1));
  };
  const Vector<double> d{twice(b.from_x, b.to_x, a.from_x, a.to_x), twice(b.from_y, b.to_y, a.from_y, a.to_y)};
  const int exponents[4] = {largest_exponent(a), largest_exponent(b), length_exponent(d.x.high, -1),
                            length_exponent(d.y.high, -1)};
  int unit = -9999;
  for (const int e : exponents) unit = e > unit ? e : unit;
  if (unit == -9999) unit = 0;
  PlacedPair p{placed(a, unit), placed(b, unit), {scaled(d.x, -1 - unit), scaled(d.y, -1 - unit)}, 0, unit};
  p.size = (reach(p.a) + reach(p.b)) + (abs(p.d.x.high) + abs(p.d.y.high));
  return p;
}

/// Whether any sum or difference of the pair's coordinates overflowed.
inline bool overflowed(const Form& a, const Form& b) noexcept {
  const double x = ((b.from_x - a.from_x) + (b.to_x - a.to_x)) + (a.box.u.x.high + b.box.u.x.high);
  const double y = ((b.from_y - a.from_y) + (b.to_y - a.to_y)) + (a.box.u.y.high + b.box.u.y.high);
  const double sizes = (a.box.hx.high - a.box.hx.high) + (b.box.hx.high - b.box.hx.high);
  const double others = (a.box.hy.high - a.box.hy.high) + (b.box.hy.high - b.box.hy.high);
  return !((x - x) + (y - y) + (sizes + others) == 0);
}

template <class A, class B>
PlacedPair placed_pair(const A& a, const B& b) noexcept {
  Form fa = form(a, 1), fb = form(b, 1);
  int eighths = 0;
  if (overflowed(fa, fb)) {
    fa = form(a, 0.125), fb = form(b, 0.125);
    eighths = 3;
  }
  PlacedPair p = placed(fa, fb);
  p.exponent += eighths;
  return p;
}

/// Where on a placed shape: a place in a box; an offset from the centre, of a circle or an ellipse the only one.
struct Contact {
  Spot<double> spot;
  double x, y;
};

struct Located {
  double x, y;
};

/// From a centre that is stored.
inline Located located(double cx, double cy, const Contact& c, int exponent) noexcept {
  return {cx + scale(c.x, exponent), cy + scale(c.y, exponent)};
}
inline Located located(const Point<double>& s, const Placed&, const Contact&, int) noexcept { return {s.x, s.y}; }
inline Located located(const Circle<double>& s, const Placed&, const Contact& c, int exponent) noexcept {
  return located(s.cx, s.cy, c, exponent);
}
inline Located located(const Rect<double>& s, const Placed&, const Contact& c, int exponent) noexcept {
  return located(s.cx, s.cy, c, exponent);
}
inline Located located(const Ellipse<double>& s, const Placed&, const Contact& c, int exponent) noexcept {
  return located(s.cx, s.cy, c, exponent);
}

/// The number at share f of the way between two, from the middle (0) to either (-1, 1), which are met exactly.
inline double between(double low, double high, double f) noexcept {
  const double nearer = f < 0 ? low : high, farther = f < 0 ? high : low, share = 0.5 * (1 - abs(f));
  const double whole = farther - nearer;
  return abs(whole) <= 0x1p1023 ? nearer + share * whole : nearer + (2 * share) * (0.5 * farther - 0.5 * nearer);
}
inline double share_of(double s, double h) noexcept { return h == 0 ? -1 : s / h; }

inline Located located(const Segment<double>& s, const Placed& p, const Contact& c, int) noexcept {
  const double f = share_of(c.spot.s, p.box.hx.high);
  return {between(s.x0, s.x1, f), between(s.y0, s.y1, f)};
}
inline Located located(const Aabb<double>& s, const Placed& p, const Contact& c, int) noexcept {
  return {between(s.min_x, s.max_x, share_of(c.spot.s, p.box.hx.high)),
          between(s.min_y, s.max_y, share_of(c.spot.t, p.box.hy.high))};
}

/// The point of a shape that was found, given that of the other. Beside an AABB's face the coordinate along it is the
/// other point's own.
template <class Shape>
Located located_beside(const Shape&, const Placed&, const Contact&, const Located& own, const Located&) noexcept {
  return own;
}
inline double coordinate_beside(double s, double h, double own, double other, double low, double high) noexcept {
  return abs(s) == h ? own : other < low ? low : other > high ? high : other;
}
inline Located located_beside(const Aabb<double>& s, const Placed& p, const Contact& c, const Located& own,
                              const Located& other) noexcept {
  return {coordinate_beside(c.spot.s, p.box.hx.high, own.x, other.x, s.min_x, s.max_x),
          coordinate_beside(c.spot.t, p.box.hy.high, own.y, other.y, s.min_y, s.max_y)};
}

}  // namespace vesica::detail::nearest
