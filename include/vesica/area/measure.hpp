// SPDX-License-Identifier: Apache-2.0
/// Areas of any magnitude: a double and a power of two kept apart from it.
#pragma once

#include <vesica/arithmetic/double_double.hpp>
#include <vesica/arithmetic/scaled.hpp>

namespace vesica::detail::area {

using arithmetic::rounded;

using DoubleDouble = arithmetic::AccurateDoubleDouble;

/// pi as an unevaluated sum.
inline constexpr double pi_high = 0x1.921fb54442d18p+1, pi_low = 0x1.1a62633145c07p-53;

/// value * 2^exponent. The value is 0 or in a range whose squares and quotients are normal numbers. Where the area of a
/// shape is subnormal, `low` is the value's error: it is rounded at another place there.
struct Measure {
  double value;
  int exponent;
  double low = 0;
};

/// The value with a magnitude of [1/2, 1).
inline Measure standard(const Measure& m) noexcept {
  if (m.value == 0) return {0, 0};
  const int own = arithmetic::exponent_of(m.value);
  return {arithmetic::scale(m.value, -own), m.exponent + own, m.low == 0 ? 0 : arithmetic::scale(m.low, -own)};
}

/// The nearest double, infinite where there is none.
inline double to_double(const Measure& m) noexcept {
  if (m.exponent == 0) return m.value;
  const Measure s = standard(m);
  return arithmetic::scale_rounded(s.value, s.low, s.exponent);
}

/// In units of 2^exponent; what is too small for that is 0.
inline double in_units(const Measure& m, int exponent) noexcept {
  if (m.exponent == exponent) return m.value;
  const Measure s = standard(m);
  return arithmetic::scale(s.value, s.exponent - exponent);
}

inline bool less(const Measure& a, const Measure& b) noexcept {
  if (a.exponent == b.exponent) return a.value < b.value;
  const Measure s = standard(a), t = standard(b);
  if (s.value == 0 || t.value == 0) return s.value < t.value;
  return s.exponent != t.exponent ? s.exponent < t.exponent : s.value < t.value;
}

/// The lesser of two measures that are not negative, the second where they are equal.
inline Measure least(const Measure& a, const Measure& b) noexcept { return less(a, b) ? a : b; }

}  // namespace vesica::detail::area
