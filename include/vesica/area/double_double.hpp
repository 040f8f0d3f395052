// SPDX-License-Identifier: Apache-2.0
/// Unevaluated sums of two doubles: about 104 bits, with the operators of a double, so that a formula written once as a
/// template runs in either. For numbers of moderate magnitude (2^-400 to 2^400); callers scale.
/// T. J. Dekker, Numer. Math. 18 (1971) 224; Y. Hida, X. S. Li and D. H. Bailey, ARITH-15 (2001) 155.
#pragma once

#include <cmath>
#include <vesica/directed.hpp>

namespace vesica::detail::area {

using lane::abs;
using lane::sqrt;

/// pi as an unevaluated sum.
inline constexpr double pi_high = 0x1.921fb54442d18p+1, pi_low = 0x1.1a62633145c07p-53;

struct DoubleDouble {
  double high, low;
  constexpr DoubleDouble() noexcept : high(0), low(0) {}
  constexpr DoubleDouble(double x) noexcept : high(x), low(0) {}
  constexpr DoubleDouble(double h, double l) noexcept : high(h), low(l) {}
};

/// high + low as a normalised pair, for |high| >= |low|.
inline DoubleDouble renormalised(double high, double low) noexcept {
  const double total = high + low;
  return {total, low - (total - high)};
}

inline DoubleDouble operator-(const DoubleDouble& a) noexcept { return {-a.high, -a.low}; }
inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const directed::Pair s = directed::sum(a.high, b.high), t = directed::sum(a.low, b.low);
  const DoubleDouble upper = renormalised(s.high, s.low + t.high);
  return renormalised(upper.high, upper.low + t.low);
}
inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) noexcept { return a + -b; }
inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const directed::Pair p = directed::product(a.high, b.high);
  return renormalised(p.high, p.low + (a.high * b.low + a.low * b.high));
}
/// The quotient's double, and what it leaves over divided once more, twice.
inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const double first = a.high / b.high;
  const DoubleDouble rest = a - b * DoubleDouble(first);
  const double second = rest.high / b.high;
  const double third = (rest - b * DoubleDouble(second)).high / b.high;
  return renormalised(first, second) + DoubleDouble(third);
}
/// A rounded root and one Newton step.
inline DoubleDouble sqrt(const DoubleDouble& a) noexcept {
  if (!(a.high > 0)) return {};
  const double root = std::sqrt(a.high);
  const directed::Pair square = directed::product(root, root);
  const DoubleDouble rest = a - DoubleDouble(square.high, square.low);
  return renormalised(root, rest.high / (2 * root));
}
inline bool operator<(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}
inline bool operator>(const DoubleDouble& a, const DoubleDouble& b) noexcept { return b < a; }
inline DoubleDouble abs(const DoubleDouble& a) noexcept { return a.high < 0 ? -a : a; }

/// The nearest double.
inline double rounded(const DoubleDouble& a) noexcept { return a.high; }
constexpr double rounded(double a) noexcept { return a; }

/// a - b for doubles, without rounding where V allows that.
template <class V>
V difference(double a, double b) noexcept;
template <>
inline double difference<double>(double a, double b) noexcept {
  return a - b;
}
template <>
inline DoubleDouble difference<DoubleDouble>(double a, double b) noexcept {
  const directed::Pair d = directed::sum(a, -b);
  return {d.high, d.low};
}

}  // namespace vesica::detail::area
