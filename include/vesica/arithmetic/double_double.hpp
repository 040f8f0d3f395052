// SPDX-License-Identifier: Apache-2.0
/// Double-double arithmetic: a number as an unevaluated sum of two, about 104 bits. It is renormalised after each
/// operation: high is the nearest double of the whole. So a result can be compared, divided or cancelled further, which
/// a Twofold (twofold.hpp) does not allow.
///
/// Two sets of rules share it. FastRules are for scalars and lanes: plain operations only, and a sum whose error is
/// relative to its larger operand. AccurateRules are for scalars: fused products, and a sum whose error is relative to
/// the sum itself, for formulas in which nearly equal numbers are subtracted more than once.
///
/// T. J. Dekker, Numer. Math. 18 (1971) 224; Y. Hida, X. S. Li and D. H. Bailey, ARITH-15 (2001) 155. For magnitudes of
/// 2^-400 to 2^400; callers scale. With FastRules a product below 2^-900 loses less than 2^-1000.
#pragma once

#include <vesica/arithmetic/error_free.hpp>

namespace vesica::detail::arithmetic {

template <class V, class Rules>
struct DoubleDouble {
  V high, low;
  constexpr DoubleDouble() noexcept : high(0.0), low(0.0) {}
  constexpr DoubleDouble(V x) noexcept : high(x), low(0.0) {}
  constexpr DoubleDouble(V h, V l) noexcept : high(h), low(l) {}

  /// high + low, renormalised; for |high| >= |low|.
  VESICA_INLINE static DoubleDouble renormalised(V high, V low) noexcept {
    Pair<V> sum = fast_two_sum(high, low);
    return {sum.high, sum.low};
  }

  VESICA_INLINE friend DoubleDouble operator-(const DoubleDouble& a) noexcept { return {-a.high, -a.low}; }
  VESICA_INLINE friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) noexcept {
    return Rules::sum(a, b);
  }
  VESICA_INLINE friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) noexcept { return a + -b; }
  VESICA_INLINE friend DoubleDouble operator*(const DoubleDouble& a, V b) noexcept { return Rules::product(a, b); }
  VESICA_INLINE friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) noexcept {
    return Rules::product(a, b);
  }
};

struct FastRules {
  template <class V>
  using Number = DoubleDouble<V, FastRules>;

  template <class V>
  VESICA_INLINE static Pair<V> exact_product(V a, V b) noexcept {
    return two_product<V>(factor(a), factor(b));
  }
  template <class V>
  VESICA_INLINE static Number<V> product(const Number<V>& a, V b) noexcept {
    const Pair<V> top = exact_product(a.high, b);
    return Number<V>::renormalised(top.high, top.low + a.low * b);
  }
  template <class V>
  VESICA_INLINE static Number<V> product(const Number<V>& a, const Number<V>& b) noexcept {
    const Pair<V> top = exact_product(a.high, b.high);
    return Number<V>::renormalised(top.high, top.low + (a.high * b.low + a.low * b.high));
  }
  template <class V>
  VESICA_INLINE static Number<V> sum(const Number<V>& a, const Number<V>& b) noexcept {
    const Pair<V> top = two_sum(a.high, b.high);
    return Number<V>::renormalised(top.high, top.low + (a.low + b.low));
  }
};

template <class V>
using FastDoubleDouble = DoubleDouble<V, FastRules>;

/// a + b and a * b, exactly.
template <class V>
VESICA_INLINE FastDoubleDouble<V> sum(V a, V b) noexcept {
  Pair<V> p = two_sum(a, b);
  return {p.high, p.low};
}
template <class V>
VESICA_INLINE FastDoubleDouble<V> product(V a, V b) noexcept {
  Pair<V> p = FastRules::exact_product(a, b);
  return {p.high, p.low};
}

template <class V>
VESICA_INLINE V rounded(const FastDoubleDouble<V>& a) noexcept {
  return a.high + a.low;
}

template <class V>
VESICA_INLINE FastDoubleDouble<V> magnitude(const FastDoubleDouble<V>& a) noexcept {
  return {flip_sign(a.high, a.high), flip_sign(a.low, a.high)};
}

/// The square root of a number >= 0: a rounded root and one Newton step.
template <class V>
VESICA_INLINE FastDoubleDouble<V> root(const FastDoubleDouble<V>& a) noexcept {
  const V guess = sqrt(a.high);
  const Pair<V> square = FastRules::exact_product(guess, guess);
  const V rest = ((a.high - square.high) - square.low) + a.low;
  // The root of 0 has nothing to divide by.
  return FastDoubleDouble<V>::renormalised(guess, rest / ((guess + guess) + V(0x1p-1000)));
}

/// a / sqrt(square) for square > 0, to twice the precision: the rounded quotient, and what it leaves over. With one
/// root and one division it costs little more than the rounded quotient alone.
template <class V>
VESICA_INLINE FastDoubleDouble<V> quotient_by_root(const FastDoubleDouble<V>& a,
                                                   const FastDoubleDouble<V>& square) noexcept {
  const V length = sqrt(square.high), inverse = V(1.0) / length, quotient = a.high * inverse;
  const Pair<V> squared = FastRules::exact_product(length, length), back = FastRules::exact_product(quotient, length);
  const V missing = ((square.high - squared.high) + (square.low - squared.low)) * (V(0.5) * inverse);
  const V rest = ((a.high - back.high) - back.low) + (a.low - quotient * missing);
  return FastDoubleDouble<V>::renormalised(quotient, rest * inverse);
}

/// Its functions are not forced inline: the formulas that use them are long and run once a call.
struct AccurateRules {
  using Number = DoubleDouble<double, AccurateRules>;

  static Number product(const Number& a, const Number& b) noexcept {
    const Pair<double> top = two_product_fused(a.high, b.high);
    return Number::renormalised(top.high, top.low + (a.high * b.low + a.low * b.high));
  }
  static Number sum(const Number& a, const Number& b) noexcept {
    const Pair<double> s = two_sum(a.high, b.high), t = two_sum(a.low, b.low);
    const Pair<double> upper = fast_two_sum(s.high, s.low + t.high);
    return Number::renormalised(upper.high, upper.low + t.low);
  }
};

using AccurateDoubleDouble = DoubleDouble<double, AccurateRules>;

/// The same sum where one number is a double: what it has no low part for is left out, and no bit differs.
inline AccurateDoubleDouble operator+(const AccurateDoubleDouble& a, double b) noexcept {
  const Pair<double> s = two_sum(a.high, b), upper = fast_two_sum(s.high, s.low + a.low);
  return {upper.high, upper.low};
}
inline AccurateDoubleDouble operator-(const AccurateDoubleDouble& a, double b) noexcept { return a + -b; }
inline AccurateDoubleDouble operator-(double a, const AccurateDoubleDouble& b) noexcept { return -b + a; }

/// The quotient's double, and what it leaves over divided once more, twice.
inline AccurateDoubleDouble operator/(const AccurateDoubleDouble& a, const AccurateDoubleDouble& b) noexcept {
  const double first = a.high / b.high;
  const AccurateDoubleDouble rest = a - b * AccurateDoubleDouble(first);
  const double second = rest.high / b.high;
  const double third = (rest - b * AccurateDoubleDouble(second)).high / b.high;
  return AccurateDoubleDouble::renormalised(first, second) + AccurateDoubleDouble(third);
}
/// A rounded root and one Newton step. The root's square has the number's own high part up to a few last places:
/// their difference is exact.
inline AccurateDoubleDouble sqrt(const AccurateDoubleDouble& a) noexcept {
  if (!(a.high > 0)) return {};
  const double root = std::sqrt(a.high);
  const Pair<double> square = two_product_fused(root, root);
  const Pair<double> low = two_difference(a.low, square.low);
  const Pair<double> rest = fast_two_sum(a.high - square.high, low.high);
  return AccurateDoubleDouble::renormalised(root, (rest.high + (rest.low + low.low)) / (2 * root));
}
inline bool operator<(const AccurateDoubleDouble& a, const AccurateDoubleDouble& b) noexcept {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}
inline bool operator>(const AccurateDoubleDouble& a, const AccurateDoubleDouble& b) noexcept { return b < a; }
inline AccurateDoubleDouble abs(const AccurateDoubleDouble& a) noexcept { return a.high < 0 ? -a : a; }

/// The nearest double.
inline double rounded(const AccurateDoubleDouble& a) noexcept { return a.high; }
constexpr double rounded(double a) noexcept { return a; }

/// a - b for doubles, without rounding where V allows that.
template <class V>
V difference(double a, double b) noexcept;
template <>
inline double difference<double>(double a, double b) noexcept {
  return a - b;
}
template <>
inline AccurateDoubleDouble difference<AccurateDoubleDouble>(double a, double b) noexcept {
  const Pair<double> d = two_sum(a, -b);
  return {d.high, d.low};
}

}  // namespace vesica::detail::arithmetic
