// SPDX-License-Identifier: Apache-2.0
/// shape_area(s): the area of one shape, correctly rounded. So a shape inside another never has the greater area, and
/// shapes that are the same set of points have the same, whatever numbers describe them.
#pragma once

#include <algorithm>
#include <limits>
#include <vesica/area/measure.hpp>
#include <vesica/check.hpp>
#include <vesica/exact/form.hpp>
#include <vesica/exact/rounded.hpp>

namespace vesica {

namespace detail::area {

/// Two sizes and an axis with area = factor * size_0 * size_1 * (ux^2 + uy^2), the factor being 4 or pi. The sizes of
/// an AABB are its half widths, not rounded: the halves are in the axis.
struct Sizes {
  DoubleDouble size_0, size_1;
  double ux, uy;
  bool round;
};

struct SizeNumbers {
  DoubleDouble operator()(const form::Length<double>& l) const noexcept { return l.x; }
  DoubleDouble operator()(const form::Ratio<double>& r) const noexcept { return r.x; }
  DoubleDouble operator()(const form::HalfWidth<double>& w) const noexcept {
    return arithmetic::difference<DoubleDouble>(w.to, w.from);
  }
};

template <class Shape>
Sizes sizes(const Shape& s) noexcept {
  constexpr form::AsStored<double> axis;
  const auto f = form::of(s);
  return {SizeNumbers{}(f.hx), SizeNumbers{}(f.hy), axis(f.ux), axis(f.uy), f.outline != form::Outline::straight};
}

inline bool is_flat(const Sizes& s) noexcept { return s.size_0.high == 0 || s.size_1.high == 0; }

/// True if a valid shape has no area.
template <class Shape>
bool is_flat(const Shape& s) noexcept {
  return is_flat(sizes(s));
}

/// The area with a relative error of at most 2^-98, for numbers in the range of in_area_range().
inline DoubleDouble area_estimate(const Sizes& s) noexcept {
  const arithmetic::Pair<double> xx = arithmetic::two_product_fused(s.ux, s.ux),
                                 yy = arithmetic::two_product_fused(s.uy, s.uy);
  const DoubleDouble squared_axis = DoubleDouble(xx.high, xx.low) + DoubleDouble(yy.high, yy.low);
  const DoubleDouble factor = s.round ? DoubleDouble(pi_high, pi_low) : DoubleDouble(4);
  return s.size_0 * s.size_1 * squared_axis * factor;
}

/// True if every number within 2^-98 |e.high| of the estimate rounds to the estimate's first double.
inline bool rounds_one_way(const DoubleDouble& e) noexcept {
  const double error = std::fabs(e.high) * 0x1p-98;
  return e.high + (e.low + error) == e.high && e.high + (e.low - error) == e.high;
}

/// A number and the halves of an axis within which products keep all their digits.
inline bool in_area_range(const Sizes& s) noexcept {
  const double axis = std::fmax(std::fabs(s.ux), std::fabs(s.uy));
  const double least = std::fmin(s.size_0.high, s.size_1.high), most = std::fmax(s.size_0.high, s.size_1.high);
  return axis >= 0x1p-100 && axis <= 0x1p100 && least >= 0x1p-200 && most <= 0x1p200;
}

/// pi by its first 4 limbs, as a number of a stored number's size.
inline exact::Number<1> exact_pi() noexcept {
  exact::Number<1> n;
  n.sign = 1;
  n.low = -3;
  n.size = 4;
  n.limb[0] = 0xa4093822299f31d0u;
  n.limb[1] = 0x13198a2e03707344u;
  n.limb[2] = 0x243f6a8885a308d3u;
  n.limb[3] = 3;
  return n;
}

template <int Degree>
Measure measure(const exact::Number<Degree>& x) noexcept {
  const auto [high, low] = exact::rounded_twice(x);
  return {high.value, high.exponent, low};
}

/// A function of the exact product of sizes and squared axis that never decreases: whatever numbers describe a shape,
/// the result is the same. Degree 5.
inline Measure exact_area(const exact::Box& s) noexcept {
  return measure(exact::integer(4) * (s.hx * s.hy * exact::dot(s.ux, s.uy, s.ux, s.uy)));
}
inline Measure exact_area(const exact::Ellipse& s) noexcept {
  return measure(exact_pi() * (s.a * s.b * exact::dot(s.ux, s.uy, s.ux, s.uy)));
}

/// x * 2^-exponent for the exponents of doubles.
inline DoubleDouble scaled_down(const DoubleDouble& x, int exponent) noexcept {
  return {arithmetic::scale(x.high, -exponent), arithmetic::scale(x.low, -exponent)};
}

/// The same shape with sizes and the longer part of its axis in [1/2, 1), and the exponent this took.
inline int standardise(Sizes& s) noexcept {
  using arithmetic::exponent_of;
  using arithmetic::scale;
  const int e0 = exponent_of(s.size_0.high), e1 = exponent_of(s.size_1.high);
  const int axis = exponent_of(std::fmax(std::fabs(s.ux), std::fabs(s.uy)));
  s.size_0 = scaled_down(s.size_0, e0);
  s.size_1 = scaled_down(s.size_1, e1);
  s.ux = scale(s.ux, -axis);
  s.uy = scale(s.uy, -axis);
  return e0 + e1 + 2 * axis;
}

/// The area of a valid shape.
template <class Shape>
Measure shape_measure(const Shape& shape) noexcept {
  Sizes s = sizes(shape);
  if (is_flat(s)) return {0, 0};
  // Differences of the greatest numbers may be infinite; exact ones are not.
  if (!(s.size_0.high <= 0x1p1020 && s.size_1.high <= 0x1p1020)) return exact_area(exact::form(shape));
  const int exponent = in_area_range(s) ? 0 : standardise(s);
  const DoubleDouble estimate = area_estimate(s);
  const bool may_be_subnormal = exponent < -1017;  // the estimate is then from 2^-4 to 2^4
  if (rounds_one_way(estimate) && !may_be_subnormal) [[likely]]
    return {estimate.high, exponent};
  return exact_area(exact::form(shape));
}
inline Measure shape_measure(const Point<double>&) noexcept { return {0, 0}; }
inline Measure shape_measure(const Segment<double>&) noexcept { return {0, 0}; }

/// A box { s u + t perp(u) : |s| <= hx, |t| <= hy } with a radius: 4 hx hy u.u + 4 r (hx + hy) |u| + pi r^2, with a
/// relative error of at most 2^-96. Lengths are measured in a power of two near the greatest of them.
inline Measure inflated_measure(DoubleDouble ux, DoubleDouble uy, double hx, double hy, double r) noexcept {
  using arithmetic::exponent_of;
  const int axis = exponent_of(std::fmax(std::fabs(ux.high), std::fabs(uy.high)));
  const int side = exponent_of(std::fmax(hx, hy)) + axis, unit = std::max(side, exponent_of(r));
  ux = scaled_down(ux, axis);
  uy = scaled_down(uy, axis);
  const DoubleDouble along = arithmetic::scale_far(hx, axis - unit), across = arithmetic::scale_far(hy, axis - unit);
  const DoubleDouble radius = arithmetic::scale_far(r, -unit), squared_axis = ux * ux + uy * uy;
  const DoubleDouble area = DoubleDouble(4) * (along * across * squared_axis) +
                            DoubleDouble(4) * (radius * (along + across) * sqrt(squared_axis)) +
                            DoubleDouble(pi_high, pi_low) * (radius * radius);
  return {area.high, 2 * unit, area.low};
}

/// Without a radius it is the core, and without a size a circle.
inline Measure shape_measure(const Capsule<double>& s) noexcept {
  const bool is_circle = s.x0 == s.x1 && s.y0 == s.y1;
  if (is_circle || s.r == 0) return shape_measure(Circle<double>{s.x0, s.y0, s.r});
  // Halves, as differences of the greatest numbers may be infinite; less than half the least number is lost.
  return inflated_measure(arithmetic::difference<DoubleDouble>(s.x1 / 2, s.x0 / 2),
                          arithmetic::difference<DoubleDouble>(s.y1 / 2, s.y0 / 2), 1, 0, s.r);
}
inline Measure shape_measure(const RoundRect<double>& s) noexcept {
  if (s.r == 0) return shape_measure(Rect<double>{s.cx, s.cy, s.ux, s.uy, s.hx, s.hy});
  if (s.hx == 0 && s.hy == 0) return shape_measure(Circle<double>{s.cx, s.cy, s.r});
  return inflated_measure(DoubleDouble(s.ux), DoubleDouble(s.uy), s.hx, s.hy, s.r);
}

/// Stores what a measure is in the caller's type. A float is the double rounded once more.
template <class T>
std::int32_t store(const Measure& m, T& out) noexcept {
  const T x = static_cast<T>(to_double(m));
  if (!vesica::detail::all_finite(x)) return error_range;
  out = x;
  return 0;
}

}  // namespace detail::area

/// The checked form: writes the area of a shape, 4 hx hy u.u of a rectangle, pi a b u.u of an ellipse, 0 of a point or
/// a segment; the nearest double to the true area (a float: that double rounded), also among the subnormal ones. A
/// radius r adds r times the perimeter and pi r^2: rarely the sum is the double beside the nearest.
/// Returns 0, error_shape, or error_range when the area would be beyond the finite numbers; on error `out` is
/// untouched.
template <template <class> class Shape, class T>
std::int32_t shape_area_or_error(const Shape<T>& s, T& out) noexcept {
  if (check(s) != 0) return error_shape;
  return detail::area::store(detail::area::shape_measure(widen(s)), out);
}

/// The area of a shape. For valid shapes: it is 0 for an invalid one, and the greatest finite number for an area beyond
/// it. shape_area_or_error() is the checked form.
template <template <class> class Shape, class T>
T shape_area(const Shape<T>& s) noexcept {
  T area = 0;
  return shape_area_or_error(s, area) == error_range ? std::numeric_limits<T>::max() : area;
}

}  // namespace vesica
