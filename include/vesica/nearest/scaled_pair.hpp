// SPDX-License-Identifier: Apache-2.0
/// Any two shapes, brought to one form, one place and one scale (form/placement.hpp).
///
/// A shape is a box or an ellipse about a centre; a circle is a point that reaches r farther, and so are
/// other shapes with a radius (form/inflated.hpp). Lengths are measured in a
/// power of two near the largest of them. A number smaller than that by more than the range of double underflows to 0;
/// this is far below the error bound.
#pragma once

#include <vesica/form/inflated.hpp>
#include <vesica/form/placement.hpp>
#include <vesica/nearest/box_box.hpp>

namespace vesica::detail::nearest {

/// A shape before it is scaled. Its lengths are k times what is stored, k a power of two.
struct UnscaledShape {
  form::Corners<double> place;
  Box<double> box;  // of an ellipse: its half lengths
  double radius;
  bool curved;
};

/// The parts of a form as twofolds, lengths times k. Differences are exact.
struct LengthsTimes {
  double k;
  Twofold<double> operator()(const form::Length<double>& l) const noexcept { return {k * l.x, 0}; }
  Twofold<double> operator()(const form::Ratio<double>& r) const noexcept { return {r.x, 0}; }
  Twofold<double> operator()(const form::Difference<double>& d) const noexcept {
    return exact_difference(k * d.to, k * d.from);
  }
  Twofold<double> operator()(const form::HalfWidth<double>& w) const noexcept {
    return exact_difference(k * w.to, k * w.from);
  }
  Twofold<double> operator()(form::Constant c) const noexcept { return {static_cast<double>(c.x), 0}; }
  Twofold<double> operator()(form::WidthAxis) const noexcept { return {0.5, 0}; }
};

/// The box of a point.
inline constexpr Box<double> no_box{{{1, 0}, {0, 0}}, {0, 0}, {0, 0}};

template <class Shape>
UnscaledShape form_times(const Shape& s, double k) noexcept {
  const auto f = form::of(s);
  const LengthsTimes number{k};
  const form::Corners<double> stored = form::corners(f.place);
  const form::Corners<double> place{k * stored.x0, k * stored.y0, k * stored.x1, k * stored.y1};
  if constexpr (f.outline == form::Outline::disc) {
    return {place, no_box, number(f.hx).high, false};
  } else {
    Box<double> box{{number(f.ux), number(f.uy)}, number(f.hx), number(f.hy)};
    if (box.u.x.high == 0 && box.u.y.high == 0) {
      if constexpr (f.axis_may_vanish) {
        return {place, no_box, 0, false};
      } else {
        // The least axes underflow at an eighth. Their sizes at an eighth give the same shape.
        const LengthsTimes stored_axis{1};
        box = {{stored_axis(f.ux), stored_axis(f.uy)}, {k * box.hx.high, 0}, {k * box.hy.high, 0}};
      }
    }
    const bool round = f.outline == form::Outline::round;
    return {place, box, 0, round && box.hx.high > 0 && box.hy.high > 0};
  }
}

/// The core's form, with a radius as a circle has it.
template <form::Inflated Shape>
UnscaledShape form_times(const Shape& s, double k) noexcept {
  const auto inflated = form::inflated(s);
  UnscaledShape f = form_times(inflated.core, k);
  f.radius = k * inflated.radius;
  return f;
}

/// A shape at the common scale.
struct ScaledShape {
  Box<double> box;
  double radius;
  bool curved;

  Axes<double> axes() const noexcept { return {box.u.x.high, box.u.y.high, box.hx.high, box.hy.high}; }
};

/// The offset d leads from the first centre to the second. Lengths are in units of 2^exponent; the largest is about 1,
/// and so is the longer component of each axis.
struct ScaledPair {
  ScaledShape a, b;
  Vector<double> d;
  double size;  // at least the largest length, at most some ten times that
  int exponent;
};

inline Twofold<double> scaled(const Twofold<double>& x, int exponent) noexcept {
  return {scale_far(x.high, exponent), scale_far(x.low, exponent)};
}

inline int axis_exponent(const UnscaledShape& f) noexcept {
  return form::axis_exponent(f.box.u.x.high, f.box.u.y.high);
}

inline int largest_exponent(const UnscaledShape& f) noexcept {
  const int k = axis_exponent(f), x = form::length_exponent(f.box.hx.high, k);
  const int y = form::length_exponent(f.box.hy.high, k), r = form::length_exponent(f.radius), longer = x > y ? x : y;
  return longer > r ? longer : r;
}

/// An ellipse thinner than this share of its length is taken for a segment, one smaller than this share of the pair for
/// a point: the difference is below the error bound.
inline constexpr double thinnest = 0x1p-52, smallest = 0x1p-120;

inline ScaledShape scaled_shape(const UnscaledShape& f, int unit) noexcept {
  const int k = axis_exponent(f);
  ScaledShape p{
      {{scaled(f.box.u.x, -k), scaled(f.box.u.y, -k)}, scaled(f.box.hx, k - unit), scaled(f.box.hy, k - unit)},
      scale_far(f.radius, -unit),
      f.curved};
  if (!p.curved) return p;
  double &a = p.box.hx.high, &b = p.box.hy.high;
  const double longer = max(a, b), least = longer < smallest ? 1 : thinnest * longer;
  if (a < least) a = 0;
  if (b < least) b = 0;
  p.curved = a > 0 && b > 0;
  return p;
}

/// At least how far the shape reaches. Its digits are those of a circle, a rectangle or an ellipse as stored.
inline double reach(const ScaledShape& p) noexcept {
  return p.radius + extent(p.box.u.x.high, p.box.u.y.high, p.box.hx.high, p.box.hy.high);
}

/// A coordinate of the offset in units of 2^exponent. It keeps its sign, by which closest points are chosen where
/// several are equally close.
inline Twofold<double> scaled_offset(const arithmetic::Pair<double>& x, int exponent) noexcept {
  const Twofold<double> s = scaled({x.high, x.low}, exponent);
  const bool vanished = s.high == 0 && x.high != 0;
  return vanished ? Twofold<double>{std::copysign(0x1p-1074, x.high), 0} : s;
}

inline ScaledPair scaled_pair(const UnscaledShape& a, const UnscaledShape& b) noexcept {
  const arithmetic::Pair<double> x = form::twice_offset_x(a.place, b.place, 1);
  const arithmetic::Pair<double> y = form::twice_offset_y(a.place, b.place, 1);
  const int unit = form::common_exponent(
      {largest_exponent(a), largest_exponent(b), form::length_exponent(x.high, -1), form::length_exponent(y.high, -1)});
  const Vector<double> d{scaled_offset(x, -1 - unit), scaled_offset(y, -1 - unit)};
  ScaledPair p{scaled_shape(a, unit), scaled_shape(b, unit), d, 0, unit};
  p.size = (reach(p.a) + reach(p.b)) + (abs(p.d.x.high) + abs(p.d.y.high));
  return p;
}

/// True if any sum or difference of the pair's coordinates overflowed. Then all lengths are taken at an eighth.
inline bool overflowed(const UnscaledShape& a, const UnscaledShape& b) noexcept {
  const double x = ((b.place.x0 - a.place.x0) + (b.place.x1 - a.place.x1)) + (a.box.u.x.high + b.box.u.x.high);
  const double y = ((b.place.y0 - a.place.y0) + (b.place.y1 - a.place.y1)) + (a.box.u.y.high + b.box.u.y.high);
  const double sizes = (a.box.hx.high - a.box.hx.high) + (b.box.hx.high - b.box.hx.high);
  const double others = (a.box.hy.high - a.box.hy.high) + (b.box.hy.high - b.box.hy.high);
  return !((x - x) + (y - y) + (sizes + others) == 0);
}

template <class A, class B>
ScaledPair scaled_pair(const A& a, const B& b) noexcept {
  UnscaledShape fa = form_times(a, 1), fb = form_times(b, 1);
  int eighths = 0;
  if (overflowed(fa, fb)) {
    fa = form_times(a, 0.125), fb = form_times(b, 0.125);
    eighths = 3;
  }
  ScaledPair p = scaled_pair(fa, fb);
  p.exponent += eighths;
  return p;
}

/// A point of a scaled shape: its coordinates in a box's frame, and its offset from the centre.
struct Contact {
  Spot<double> spot;
  double x, y;
};

struct Located {
  double x, y;
};

/// From a centre that is stored.
template <class Shape>
Located located(const Shape& s, const ScaledShape&, const Contact& c, int exponent) noexcept {
  const form::Centre<double> centre = form::of(s).place;
  // A sum of zeros loses its sign, which would show the order of the shapes.
  return {0.0 + (centre.x + scale_far(c.x, exponent)), 0.0 + (centre.y + scale_far(c.y, exponent))};
}
/// Without a sum, which would lose the sign of a zero.
inline Located located(const Point<double>& s, const ScaledShape&, const Contact&, int) noexcept { return {s.x, s.y}; }

/// The number at share f of the way between two, from the middle (0) to either (-1, 1), which are exact.
inline double between(double low, double high, double f) noexcept {
  const double nearer = f < 0 ? low : high, farther = f < 0 ? high : low, share = 0.5 * (1 - abs(f));
  const double whole = farther - nearer;
  return abs(whole) <= 0x1p1023 ? nearer + share * whole : nearer + (2 * share) * (0.5 * farther - 0.5 * nearer);
}
inline double share_of(double s, double h) noexcept { return h == 0 ? -1 : s / h; }

inline Located located(const Segment<double>& s, const ScaledShape& p, const Contact& c, int) noexcept {
  const double f = share_of(c.spot.s, p.box.hx.high);
  return {between(s.x0, s.x1, f), between(s.y0, s.y1, f)};
}
inline Located located(const Aabb<double>& s, const ScaledShape& p, const Contact& c, int) noexcept {
  return {between(s.min_x, s.max_x, share_of(c.spot.s, p.box.hx.high)),
          between(s.min_y, s.max_y, share_of(c.spot.t, p.box.hy.high))};
}

/// The point of a shape that was found, given the other's. Beside an AABB's face the coordinate along it is the
/// other point's own.
template <class Shape>
Located located_beside(const Shape&, const ScaledShape&, const Contact&, const Located& own, const Located&) noexcept {
  return own;
}
inline double coordinate_beside(double s, double h, double own, double other, double low, double high) noexcept {
  return abs(s) == h ? own : other < low ? low : other > high ? high : other;
}
inline Located located_beside(const Aabb<double>& s, const ScaledShape& p, const Contact& c, const Located& own,
                              const Located& other) noexcept {
  return {coordinate_beside(c.spot.s, p.box.hx.high, own.x, other.x, s.min_x, s.max_x),
          coordinate_beside(c.spot.t, p.box.hy.high, own.y, other.y, s.min_y, s.max_y)};
}

}  // namespace vesica::detail::nearest
