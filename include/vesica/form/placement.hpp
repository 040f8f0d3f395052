// SPDX-License-Identifier: Apache-2.0
/// Common parts of the placements of a pair in double: the offset of centres, and the power of two that is the unit of
/// length.
///
/// Stored coordinates enter only by their differences, as exactly as two doubles hold them. So moving both shapes alike
/// without rounding changes nothing.
#pragma once

#include <cstddef>
#include <vesica/arithmetic/error_free.hpp>
#include <vesica/arithmetic/scaled.hpp>
#include <vesica/form/form.hpp>

namespace vesica::detail::form {

/// Twice the offset of two centres along one coordinate: the sum of the differences of their stored points, k times.
/// Twice, since half of it might not be a double.
inline arithmetic::Pair<double> twice_offset(double to0, double to1, double from0, double from1, double k) noexcept {
  const arithmetic::Pair<double> first = arithmetic::two_sum(k * to0, -(k * from0));
  const arithmetic::Pair<double> second = arithmetic::two_sum(k * to1, -(k * from1));
  const arithmetic::Pair<double> sum = arithmetic::two_sum(first.high, second.high);
  return arithmetic::two_sum(sum.high, sum.low + (first.low + second.low));
}
inline arithmetic::Pair<double> twice_offset_x(const Corners<double>& a, const Corners<double>& b, double k) noexcept {
  return twice_offset(b.x0, b.x1, a.x0, a.x1, k);
}
inline arithmetic::Pair<double> twice_offset_y(const Corners<double>& a, const Corners<double>& b, double k) noexcept {
  return twice_offset(b.y0, b.y1, a.y0, a.y1, k);
}

/// The exponent that stands for a length of 0.
inline constexpr int no_exponent = -9999;

/// Exponent of a size in units of 2^unit.
inline int length_exponent(double size, int unit = 0) noexcept {
  return size == 0 ? no_exponent : arithmetic::exponent_of(size) + unit;
}

/// Exponent of an axis, by its longer component.
inline int axis_exponent(double ux, double uy) noexcept {
  return arithmetic::exponent_of(lane::max(lane::abs(ux), lane::abs(uy)));
}

/// The greatest of the exponents of a pair's lengths; 0 where all lengths are 0.
template <std::size_t count>
int common_exponent(const int (&exponents)[count]) noexcept {
  int unit = no_exponent;
  for (const int e : exponents) unit = e > unit ? e : unit;
  return unit == no_exponent ? 0 : unit;
}

}  // namespace vesica::detail::form
