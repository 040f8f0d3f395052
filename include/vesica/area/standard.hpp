// SPDX-License-Identifier: Apache-2.0
/// A pair of shapes of any magnitude in standard units: the longer component of each axis in [1/2, 1), and the greatest
/// size in [1/2, 1). Only powers of two are taken out, so the same pair at another scale has the same numbers in these
/// units.
#pragma once

#include <vesica/area/box_ellipse.hpp>

namespace vesica::detail::area {

/// An axis and two sizes, each size times a power of two of its own.
struct Lengths {
  double ux, uy;
  DoubleDouble size_0, size_1;
  int exponent_0, exponent_1;
};

/// By which powers of two coordinates are lifted before differences are taken: four of the greatest numbers together
/// would overflow, and halves of subnormal ones be rounded, whatever else is beside them.
struct Lift {
  int x, y;
};

inline int lift_for(double most) noexcept { return most > 0x1p1000 ? -3 : 16; }

inline double reach_x(const filter::Centre<double>& p) noexcept { return std::fabs(p.x); }
inline double reach_y(const filter::Centre<double>& p) noexcept { return std::fabs(p.y); }
inline double reach_x(const filter::Corners<double>& p) noexcept { return std::fmax(std::fabs(p.x0), std::fabs(p.x1)); }
inline double reach_y(const filter::Corners<double>& p) noexcept { return std::fmax(std::fabs(p.y0), std::fabs(p.y1)); }

template <class V>
filter::Centre<V> lifted(const filter::Centre<double>& p, const Lift& lift) noexcept {
  using arithmetic::scale;
  return {V(scale(p.x, lift.x)), V(scale(p.y, lift.y))};
}
template <class V>
filter::Corners<V> lifted(const filter::Corners<double>& p, const Lift& lift) noexcept {
  using arithmetic::scale;
  return {V(scale(p.x0, lift.x)), V(scale(p.y0, lift.y)), V(scale(p.x1, lift.x)), V(scale(p.y1, lift.y))};
}

/// A size as a double-double, and the exponent of its unit: differences are of lifted coordinates.
struct Size {
  DoubleDouble value;
  int exponent;
};
inline Size size(const form::Length<double>& l, int) noexcept { return {l.x, 0}; }
inline Size size(const form::Ratio<double>& r, int) noexcept { return {r.x, 0}; }
inline Size size(const form::HalfWidth<double>& w, int lift) noexcept {
  using arithmetic::scale;
  return {arithmetic::difference<DoubleDouble>(scale(w.to, lift), scale(w.from, lift)), -lift};
}

template <class Shape>
VESICA_CALLED Lengths lengths(const Shape& s, const Lift& lift) noexcept {
  constexpr form::AsStored<double> number;
  const auto f = form::of(s);
  const Size x = size(f.hx, lift.x), y = size(f.hy, lift.y);
  return {number(f.ux), number(f.uy), x.value, y.value, x.exponent, y.exponent};
}

/// Moves the axis's power of two into the sizes.
inline void standardise_axis(Lengths& s) noexcept {
  const int axis = axis_exponent(s.ux, s.uy);
  s.ux = arithmetic::scale(s.ux, -axis);
  s.uy = arithmetic::scale(s.uy, -axis);
  s.exponent_0 += axis;
  s.exponent_1 += axis;
}

inline int top_exponent(const Lengths& s) noexcept {
  const int e0 = s.exponent_0 + arithmetic::exponent_of(s.size_0.high);
  const int e1 = s.exponent_1 + arithmetic::exponent_of(s.size_1.high);
  return e0 > e1 ? e0 : e1;
}

inline double scaled_to(double x, int exponent) noexcept { return arithmetic::scale(x, exponent); }
inline DoubleDouble scaled_to(const DoubleDouble& x, int exponent) noexcept {
  return {scaled_to(x.high, exponent), scaled_to(x.low, exponent)};
}
template <class V>
V number(const DoubleDouble& x) noexcept;
template <>
inline double number<double>(const DoubleDouble& x) noexcept {
  return x.high;
}
template <>
inline DoubleDouble number<DoubleDouble>(const DoubleDouble& x) noexcept {
  return x;
}

template <class V>
filter::Box<V> in_units(const Lengths& s, int unit) noexcept {
  return {V(s.ux), V(s.uy), scaled_to(number<V>(s.size_0), s.exponent_0 - unit),
          scaled_to(number<V>(s.size_1), s.exponent_1 - unit)};
}

/// One length is 2^exponent. offset: from a's centre to b's. Sizes of an ellipse are its half lengths.
template <class V>
struct StandardPair {
  filter::Box<V> a, b;
  filter::Centre<V> offset;
  int exponent;
};

template <class V, class PlaceA, class PlaceB>
VESICA_CALLED StandardPair<V> standard_pair(const PlaceA& place_a, Lengths s, const PlaceB& place_b, Lengths t,
                                            const Lift& lift) noexcept {
  standardise_axis(s);
  standardise_axis(t);
  const int unit = top_exponent(s) > top_exponent(t) ? top_exponent(s) : top_exponent(t);
  const filter::Centre<V> d = filter::offset(lifted<V>(place_a, lift), lifted<V>(place_b, lift));
  return {in_units<V>(s, unit),
          in_units<V>(t, unit),
          {scaled_to(d.x, -lift.x - unit), scaled_to(d.y, -lift.y - unit)},
          unit};
}

template <class V, class A, class B>
StandardPair<V> standard_pair(const A& a, const B& b) noexcept {
  const auto place_a = filter::place(a);
  const auto place_b = filter::place(b);
  const Lift lift{lift_for(std::fmax(reach_x(place_a), reach_x(place_b))),
                  lift_for(std::fmax(reach_y(place_a), reach_y(place_b)))};
  return standard_pair<V>(place_a, lengths(a, lift), place_b, lengths(b, lift), lift);
}

template <class V>
Oval<V> oval(const filter::Box<V>& s) noexcept {
  return {s.ux, s.uy, s.hx, s.hy};
}

}  // namespace vesica::detail::area
