// SPDX-License-Identifier: Apache-2.0
/// The terms of a ratio from each shape: its area, and how far it reaches along the axes. Lengths of usual
/// magnitudes are plain doubles. Others are taken in units of a power of two, and so overflow no more than ratios do.
#pragma once

#include <algorithm>
#include <vesica/form/inflated.hpp>
#include <vesica/form/placement.hpp>
#include <vesica/shape_area.hpp>

namespace vesica::detail::ratio {

/// A shape of any kind: { C + s u + t perp(u) } with half sizes along u and across it, and a radius.
struct Facts {
  area::Measure area;
  form::Corners<double> place;
  double ux, uy, along, across;
  bool round;
  double radius;
};

/// True if products and squares of such lengths, or quotients of such areas, are normal numbers.
inline bool is_moderate(double x) noexcept { return x >= 0x1p-400 && x <= 0x1p400; }

/// The parts of a form as doubles. Of coordinates so large that a difference may overflow they are halved before, and
/// the axis, or the size, beside them is twice as large; others are not halved, for half of the least number is 0.
struct Parts {
  double scale;  // 1 or 0.5

  explicit Parts(const form::Corners<double>& place) noexcept
      : scale(is_usual(place.x0) && is_usual(place.y0) && is_usual(place.x1) && is_usual(place.y1) ? 1 : 0.5) {}
  static bool is_usual(double x) noexcept { return std::fabs(x) <= 0x1p1000; }

  double operator()(const form::Length<double>& l) const noexcept { return l.x; }
  double operator()(const form::Ratio<double>& r) const noexcept { return r.x; }
  double operator()(form::Constant c) const noexcept { return static_cast<double>(c.x); }
  double operator()(form::WidthAxis) const noexcept { return 0.5 / scale; }
  double operator()(const form::Difference<double>& d) const noexcept { return scale * d.to - scale * d.from; }
  double operator()(const form::HalfWidth<double>& w) const noexcept { return scale * w.to - scale * w.from; }
};

/// Facts of a valid shape with this area as a double, which suffices if it is of usual magnitude.
template <class Shape>
VESICA_INLINE Facts facts(const Shape& shape, double area) noexcept {
  const auto [core, radius] = form::inflated(shape);
  const auto f = form::of(core);
  const form::Corners<double> place = form::corners(f.place);
  const Parts number(place);
  const double size = decltype(f)::axis_may_vanish ? 1 / number.scale : 1;
  return {is_moderate(area) ? area::Measure{area, 0} : area::shape_measure(shape),
          place,
          number(f.ux),
          number(f.uy),
          size * number(f.hx),
          size * number(f.hy),
          f.outline != form::Outline::straight,
          radius};
}

/// The smallest box along the coordinate axes about two shapes, and from centre to centre. Width and dx are in
/// units of 2^unit_x, height and dy of 2^unit_y: a box may be 2^2000 times as long as it is high.
struct Hull {
  double width, height, dx, dy;
  int unit_x, unit_y;
};

/// |x y|
inline double product(double x, double y, int unit) noexcept {
  if (unit == 0) return std::fabs(x * y);
  const int ex = arithmetic::exponent_of(x), ey = arithmetic::exponent_of(y);
  return std::fabs(
      arithmetic::scale_far(arithmetic::scale_far(x, -ex) * arithmetic::scale_far(y, -ey), ex + ey - unit));
}

/// How far a shape reaches from its centre along a coordinate, where p and q are the coordinates of its axis and of the
/// perpendicular.
inline double reach(const Facts& s, double p, double q, int unit) noexcept {
  const double along = product(p, s.along, unit), across = product(q, s.across, unit);
  const double core = s.round ? std::sqrt(along * along + across * across) : along + across;
  return s.radius == 0 ? core : core + arithmetic::scale_far(s.radius, -unit);
}

/// From the one end to the other of two spans about their centres, which are d apart. NaN where d overflowed to it.
inline double span(double reach_a, double reach_b, double d) noexcept {
  const double within = 2 * std::fmax(reach_a, reach_b), apart = (reach_a + reach_b) + std::fabs(d);
  return within > apart ? within : apart;
}

/// Coordinates are lifted by 2^lift first.
inline Hull hull(const Facts& a, const Facts& b, int unit_x, int unit_y, int lift) noexcept {
  const double k = arithmetic::power_of_two(lift);
  const auto half = [&](double twice, int unit) {
    return 0.5 * (unit == 0 ? twice : arithmetic::scale_far(twice, -lift - unit));
  };
  const double dx = half(form::twice_offset_x(a.place, b.place, k).high, unit_x);
  const double dy = half(form::twice_offset_y(a.place, b.place, k).high, unit_y);
  return {span(reach(a, a.ux, a.uy, unit_x), reach(b, b.ux, b.uy, unit_x), dx),
          span(reach(a, a.uy, a.ux, unit_y), reach(b, b.uy, b.ux, unit_y), dy),
          dx,
          dy,
          unit_x,
          unit_y};
}

/// An exponent of how far a shape reaches along a coordinate, given as for reach().
inline int reach_exponent(const Facts& s, double p, double q) noexcept {
  const auto of_product = [](double x, double y) {
    return x == 0 || y == 0 ? form::no_exponent : arithmetic::exponent_of(x) + arithmetic::exponent_of(y);
  };
  return std::max({of_product(p, s.along), of_product(q, s.across), form::length_exponent(s.radius)});
}

/// In units that the lengths and the offset suggest, along each coordinate.
VESICA_COLD inline Hull hull_of_odd(const Facts& a, const Facts& b) noexcept {
  const form::Corners<double>&p = a.place, &q = b.place;
  double most = 0;
  for (const double x : {p.x0, p.y0, p.x1, p.y1, q.x0, q.y0, q.x1, q.y1}) most = std::fmax(most, std::fabs(x));
  const int lift = most > 0x1p1000 ? -30 : most < 0x1p-900 ? 120 : 0;
  const double k = arithmetic::power_of_two(lift);
  const auto unit = [&](int reach_a, int reach_b, double offset) {
    const int longest = std::max({reach_a, reach_b, form::length_exponent(offset, -lift)});
    return longest == 0 ? 1 : longest;
  };
  return hull(
      a, b, unit(reach_exponent(a, a.ux, a.uy), reach_exponent(b, b.ux, b.uy), form::twice_offset_x(p, q, k).high),
      unit(reach_exponent(a, a.uy, a.ux), reach_exponent(b, b.uy, b.ux), form::twice_offset_y(p, q, k).high), lift);
}

inline Hull hull(const Facts& a, const Facts& b) noexcept {
  const Hull usual = hull(a, b, 0, 0, 0);
  return is_moderate(usual.width) && is_moderate(usual.height) ? usual : hull_of_odd(a, b);
}

}  // namespace vesica::detail::ratio
