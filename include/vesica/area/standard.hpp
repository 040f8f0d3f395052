// SPDX-License-Identifier: Apache-2.0
/// A pair of shapes of any magnitude in standard units: axes whose longer part is in [1/2, 1), the greatest size in
/// [1/2, 1). Only powers of two are taken out, so that the same pair at another scale is the same in these units.
#pragma once

#include <vesica/area/box_ellipse.hpp>

namespace vesica::detail::area {

/// An axis and two sizes, each size times a power of two of its own.
struct Lengths {
  double ux, uy;
  DoubleDouble size_0, size_1;
  int exponent_0, exponent_1;
};

/// By which powers of two coordinates are lifted before differences are taken: sums of the greatest numbers would
/// overflow, halves of the smallest be rounded.
struct Lift {
  int x, y;
};

inline int lift_for(double most) noexcept { return most > 0x1p1000 ? -16 : most < 0x1p-900 ? 64 : 0; }

inline double reach_x(const filter::Centre<double>& p) noexcept { return std::fabs(p.x); }
inline double reach_y(const filter::Centre<double>& p) noexcept { return std::fabs(p.y); }
inline double reach_x(const filter::Corners<double>& p) noexcept { return std::fmax(std::fabs(p.x0), std::fabs(p.x1)); }
inline double reach_y(const filter::Corners<double>& p) noexcept { return std::fmax(std::fabs(p.y0), std::fabs(p.y1)); }

template <class V>
filter::Centre<V> lifted(const filter::Centre<double>& p, const Lift& lift) noexcept {
  using vesica::detail::scale;
  return {V(scale(p.x, lift.x)), V(scale(p.y, lift.y))};
}
template <class V>
filter::Corners<V> lifted(const filter::Corners<double>& p, const Lift& lift) noexcept {
  using vesica::detail::scale;
  return {V(scale(p.x0, lift.x)), V(scale(p.y0, lift.y)), V(scale(p.x1, lift.x)), V(scale(p.y1, lift.y))};
}

inline Lengths lengths(const Rect<double>& s, const Lift&) noexcept { return {s.ux, s.uy, s.hx, s.hy, 0, 0}; }
inline Lengths lengths(const Circle<double>& s, const Lift&) noexcept { return {1, 0, s.r, s.r, 0, 0}; }
inline Lengths lengths(const Ellipse<double>& s, const Lift&) noexcept { return {s.ux, s.uy, s.a, s.b, 0, 0}; }
inline Lengths lengths(const Aabb<double>& s, const Lift& lift) noexcept {
  const auto p = lifted<DoubleDouble>(filter::place(s), lift);
  return {0.5, 0, p.x1 - p.x0, p.y1 - p.y0, -lift.x, -lift.y};
}

/// Moves the axis's power of two into the sizes.
inline void standardise_axis(Lengths& s) noexcept {
  const int axis = axis_exponent(s.ux, s.uy);
  s.ux = vesica::detail::scale(s.ux, -axis);
  s.uy = vesica::detail::scale(s.uy, -axis);
  s.exponent_0 += axis;
  s.exponent_1 += axis;
}

inline int top_exponent(const Lengths& s) noexcept {
  const int e0 = s.exponent_0 + vesica::detail::exponent_of(s.size_0.high);
  const int e1 = s.exponent_1 + vesica::detail::exponent_of(s.size_1.high);
  return e0 > e1 ? e0 : e1;
}

inline double scaled_to(double x, int exponent) noexcept { return vesica::detail::scale(x, exponent); }
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

template <class V, class A, class B>
StandardPair<V> standard_pair(const A& a, const B& b) noexcept {
  const auto place_a = filter::place(a);
  const auto place_b = filter::place(b);
  const Lift lift{lift_for(std::fmax(reach_x(place_a), reach_x(place_b))),
                  lift_for(std::fmax(reach_y(place_a), reach_y(place_b)))};
  Lengths s = lengths(a, lift), t = lengths(b, lift);
  standardise_axis(s);
  standardise_axis(t);
  const int unit = top_exponent(s) > top_exponent(t) ? top_exponent(s) : top_exponent(t);
  const filter::Centre<V> d = filter::offset(lifted<V>(place_a, lift), lifted<V>(place_b, lift));
  return {in_units<V>(s, unit),
          in_units<V>(t, unit),
          {scaled_to(d.x, -lift.x - unit), scaled_to(d.y, -lift.y - unit)},
          unit};
}

template <class V>
Oval<V> oval(const filter::Box<V>& s) noexcept {
  return {s.ux, s.uy, s.hx, s.hy};
}

}  // namespace vesica::detail::area
