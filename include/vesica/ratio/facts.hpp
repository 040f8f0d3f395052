// SPDX-License-Identifier: Apache-2.0
/// What a ratio must know of each shape: its area, and how far it reaches along the coordinate axes. Numbers of any
/// magnitude, so that nothing overflows and only what does not matter underflows.
#pragma once

#include <algorithm>
#include <vesica/form/placement.hpp>
#include <vesica/shape_area.hpp>

namespace vesica::detail::ratio {

using arithmetic::Scaled;

/// A shape of any kind: its area, centre, half lengths along its own axis and across it, and that axis, the longer
/// component of which is in [1/2, 1).
struct Facts {
  area::Measure area;
  form::Corners<double> place;
  double ux, uy;
  Scaled along, across;
  bool round;
};

/// value * 2^exponent with the value in [1/2, 1), or 0.
inline Scaled standard(double value, int exponent) noexcept {
  const int own = arithmetic::exponent_of(value);
  return {arithmetic::scale_far(value, -own), value == 0 ? form::no_exponent : own + exponent};
}

/// The parts of a form as numbers that cannot overflow.
struct AsScaled {
  Scaled operator()(const form::Length<double>& l) const noexcept { return standard(l.x, 0); }
  Scaled operator()(const form::Ratio<double>& r) const noexcept { return standard(r.x, 0); }
  Scaled operator()(form::Constant c) const noexcept { return standard(static_cast<double>(c.x), 0); }
  Scaled operator()(form::WidthAxis) const noexcept { return standard(0.5, 0); }
  Scaled operator()(const form::Difference<double>& d) const noexcept { return between(d.from, d.to); }
  Scaled operator()(const form::HalfWidth<double>& w) const noexcept { return between(w.from, w.to); }

 private:
  static Scaled between(double from, double to) noexcept {
    const double width = to - from;
    return std::isfinite(width) ? standard(width, 0) : standard(0.5 * to - 0.5 * from, 1);
  }
};

/// Of a valid shape.
template <class Shape>
Facts facts(const Shape& shape) noexcept {
  constexpr AsScaled number;
  const auto f = form::of(shape);
  const Scaled ux = number(f.ux), uy = number(f.uy);
  const int longer = std::max(ux.exponent, uy.exponent);  // no_exponent for a segment without length
  const auto stretched = [longer](Scaled size) {
    return size.value == 0 || longer == form::no_exponent ? Scaled{0, form::no_exponent}
                                                          : Scaled{size.value, size.exponent + longer};
  };
  return {area::shape_measure(shape),
          form::corners(f.place),
          arithmetic::scale_far(ux.value, ux.exponent - longer),
          arithmetic::scale_far(uy.value, uy.exponent - longer),
          stretched(number(f.hx)),
          stretched(number(f.hy)),
          f.outline != form::Outline::straight};
}

/// The smallest box along the coordinate axes about two shapes, and where their centres are in it. In units of 2^unit,
/// in which the greatest of the numbers is about 1.
struct Hull {
  double width, height, dx, dy;
  int unit;
};

/// How far a shape reaches from its centre along a coordinate, where p and q are that of its axis and of the
/// perpendicular.
inline double reach(const Facts& s, double p, double q, int unit) noexcept {
  const double along = std::fabs(p) * arithmetic::scale_far(s.along.value, s.along.exponent - unit);
  const double across = std::fabs(q) * arithmetic::scale_far(s.across.value, s.across.exponent - unit);
  return s.round ? std::sqrt(along * along + across * across) : along + across;
}

/// From the one end to the other of two spans about their centres, which are d apart.
inline double span(double reach_a, double reach_b, double d) noexcept {
  return std::fmax(2 * std::fmax(reach_a, reach_b), (reach_a + reach_b) + std::fabs(d));
}

inline Hull hull(const Facts& a, const Facts& b) noexcept {
  const form::Corners<double>&p = a.place, &q = b.place;
  double most = 0;
  for (const double x : {p.x0, p.y0, p.x1, p.y1, q.x0, q.y0, q.x1, q.y1}) most = std::fmax(most, std::fabs(x));
  const int lift = most > 0x1p1000 ? -30 : most < 0x1p-900 ? 120 : 0;
  const double k = arithmetic::power_of_two(lift);
  const arithmetic::Pair<double> x = form::twice_offset_x(p, q, k), y = form::twice_offset_y(p, q, k);
  const double offset = std::fmax(std::fabs(x.high), std::fabs(y.high));
  const int unit = std::max({a.along.exponent, a.across.exponent, b.along.exponent, b.across.exponent,
                             form::length_exponent(offset, -lift), form::no_exponent + 1});
  const auto half = [&](double twice) { return 0.5 * arithmetic::scale_far(twice, -lift - unit); };
  const double dx = half(x.high), dy = half(y.high);
  return {span(reach(a, a.ux, a.uy, unit), reach(b, b.ux, b.uy, unit), dx),
          span(reach(a, a.uy, a.ux, unit), reach(b, b.uy, b.ux, unit), dy), dx, dy, unit};
}

}  // namespace vesica::detail::ratio
