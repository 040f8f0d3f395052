// SPDX-License-Identifier: Apache-2.0
/// Two shapes with an axis and two sizes each, brought to a scale at which a method's formulas neither overflow nor
/// underflow. Print knows no such step: it writes for numbers about 1.
#pragma once

#include <climits>
#include <cmath>
#include <vesica/construct.hpp>
#include <vesica/shapes.hpp>

namespace vesica::methods::detail {

/// Both shapes seen from the first one's centre: offset d of the second, axes u and w, sizes h0 h1 and g0 g1, in a
/// common unit of length. A size of the first shape is 2^exponent times what stands here.
template <class T>
struct RescaledPair {
  T dx, dy, ux, uy, h0, h1, wx, wy, g0, g1;
  int exponent;
};

template <class T>
VESICA_INLINE T larger(T x, T y) noexcept {
  return x > y ? x : y;
}

/// True if the numbers are near enough to 1 as they are: axes within 2^+-2 and the largest length within 2^+-10
/// (double: the 8th powers).
template <class T>
VESICA_INLINE bool is_moderate(const RescaledPair<T>& p) noexcept {
  using Traits = ScalarTraits<T>;
  constexpr T low_axis = Traits::power(-2 * Traits::range), high_axis = Traits::power(2 * Traits::range);
  constexpr T low = Traits::power(-10 * Traits::range), high = Traits::power(10 * Traits::range);
  const T u = larger(std::fabs(p.ux), std::fabs(p.uy)), w = larger(std::fabs(p.wx), std::fabs(p.wy));
  const T length = larger(larger(std::fabs(p.dx), std::fabs(p.dy)), larger(larger(p.h0, p.h1), larger(p.g0, p.g1)));
  const bool axes = u >= low_axis && u <= high_axis && w >= low_axis && w <= high_axis;
  return axes && length >= low && length <= high;
}

/// to - from, which may exceed the largest number.
inline vesica::detail::arithmetic::Scaled difference(double to, double from) noexcept {
  const double whole = to - from;
  if (std::isfinite(whole)) return vesica::detail::take_apart(whole);
  const auto half = vesica::detail::take_apart(to / 2 - from / 2);
  return {half.value, half.exponent + 1};
}

/// A size whose axis had 2^axis_exponent taken out.
inline vesica::detail::arithmetic::Scaled size_of(double size, int axis_exponent) noexcept {
  const auto apart = vesica::detail::take_apart(size);
  return {apart.value, apart.exponent + axis_exponent};
}

inline int larger_exponent(const vesica::detail::arithmetic::Scaled& x, int exponent) noexcept {
  return x.value != 0 && x.exponent > exponent ? x.exponent : exponent;
}

template <class T>
T in_unit(const vesica::detail::arithmetic::Scaled& x, int unit) noexcept {
  return static_cast<T>(vesica::detail::arithmetic::scale(x.value, x.exponent - unit));
}

/// Any magnitudes: the larger component of each axis and the largest length come to lie in [1/2, 1). What is smaller
/// than them by more than the range of T is lost, and with it nothing that the method's own rounding would have kept.
template <class T>
RescaledPair<T> rescale(const Rect<double>& a, const Rect<double>& b) noexcept {
  using vesica::detail::arithmetic::exponent_of;
  using vesica::detail::arithmetic::Scaled;
  const int u = exponent_of(larger(std::fabs(a.ux), std::fabs(a.uy)));
  const int w = exponent_of(larger(std::fabs(b.ux), std::fabs(b.uy)));
  const Scaled lengths[6] = {difference(b.cx, a.cx), difference(b.cy, a.cy), size_of(a.hx, u),
                             size_of(a.hy, u),       size_of(b.hx, w),       size_of(b.hy, w)};
  int unit = INT_MIN;
  for (const Scaled& length : lengths) unit = larger_exponent(length, unit);
  if (unit == INT_MIN) unit = 0;
  return {in_unit<T>(lengths[0], unit),
          in_unit<T>(lengths[1], unit),
          in_unit<T>({a.ux, 0}, u),
          in_unit<T>({a.uy, 0}, u),
          in_unit<T>(lengths[2], unit),
          in_unit<T>(lengths[3], unit),
          in_unit<T>({b.ux, 0}, w),
          in_unit<T>({b.uy, 0}, w),
          in_unit<T>(lengths[4], unit),
          in_unit<T>(lengths[5], unit),
          unit - u};
}

/// The pair at a fit scale. An ellipse comes as the rectangle that has its numbers. Both must be valid.
template <class T>
VESICA_INLINE RescaledPair<T> rescaled_pair(const Rect<T>& a, const Rect<T>& b) noexcept {
  const RescaledPair<T> p{b.cx - a.cx, b.cy - a.cy, a.ux, a.uy, a.hx, a.hy, b.ux, b.uy, b.hx, b.hy, 0};
  return is_moderate(p) ? p : rescale<T>(widen(a), widen(b));
}

}  // namespace vesica::methods::detail
