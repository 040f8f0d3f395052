// SPDX-License-Identifier: Apache-2.0
/// Error-free transformations: sums and products of two numbers as an unevaluated pair high + low that is exact. All
/// arithmetic beyond one double in the library is built from these.
///
/// There are two products. Lanes, and scalars that must give the same bits as lanes, split their factors into halves,
/// by multiplications and additions that every instruction set has. Scalars without lanes use a fused multiply-add,
/// whose range is wider. Where only signs of exact values count, two_product_uncontracted() takes the quicker of the
/// two.
///
/// Variables of the type V, or of several numbers, are not const here, nor in twofold.hpp and products.hpp: g++ 12
/// keeps const structures in memory, and lanes are structures: with AVX2 circle and ellipse took a third longer.
#pragma once

#include <cmath>
#include <vesica/scalar.hpp>

namespace vesica::detail::arithmetic {

using namespace lane;
using lane::abs;
using lane::sqrt;

/// The number high + low, where high is the nearest to it.
template <class V>
struct Pair {
  V high, low;
};

/// a + b, exact unless it overflows (D. E. Knuth's TwoSum).
template <class V>
VESICA_INLINE constexpr Pair<V> two_sum(V a, V b) noexcept {
  V high = a + b, part = high - a;
  return {high, (a - (high - part)) + (b - part)};
}

/// a - b, likewise: lanes need not change a sign.
template <class V>
VESICA_INLINE constexpr Pair<V> two_difference(V a, V b) noexcept {
  V high = a - b, part = high - a;
  return {high, (a - (high - part)) - (b + part)};
}

/// a + b, exact where a is 0 or has at least the exponent of b (T. J. Dekker's FastTwoSum).
template <class V>
VESICA_INLINE constexpr Pair<V> fast_two_sum(V a, V b) noexcept {
  V high = a + b;
  return {high, b - (high - a)};
}

/// a * b rounded, also where a compiler contracts: a plain product that only sums use may become part of each of them,
/// and two of them would then see two numbers. Lanes whose bits are results are compiled without contraction.
template <class V>
VESICA_INLINE constexpr V rounded_product(V a, V b) noexcept {
#if defined(VESICA_HAS_FUSED)
  if constexpr (std::is_same_v<V, double>) {
    if (!std::is_constant_evaluated()) return fused_difference(a, b, 0.0);
  }
#endif
  return a * b;
}

/// A number as a factor: with its upper and lower 26 bits apart (G. W. Veltkamp's splitting). |high| < 2^990.
template <class V>
struct Factor {
  V high, upper, lower;
};

template <class V>
VESICA_INLINE constexpr Factor<V> factor(V x) noexcept {
  V spread = rounded_product(V(0x1p27 + 1), x), upper = spread - (spread - x);
  return {x, upper, x - upper};
}

/// a.high * b.high (T. J. Dekker), exact unless it underflows: then the loss is below 2^-1020.
template <class V, class A, class B>
VESICA_INLINE constexpr Pair<V> two_product(const A& a, const B& b) noexcept {
  V high = rounded_product<V>(a.high, b.high);
  return {high, (((a.upper * b.upper - high) + a.upper * b.lower) + a.lower * b.upper) + a.lower * b.lower};
}

/// The same for a square.
template <class V, class A>
VESICA_INLINE constexpr Pair<V> two_square(const A& a) noexcept {
  V high = rounded_product<V>(a.high, a.high), middle = a.upper * a.lower;
  return {high, ((a.upper * a.upper - high) + (middle + middle)) + a.lower * a.lower};
}

/// a * b by a fused multiply-add, exact when 2^-960 <= |a b| <= 2^1000, or a or b is 0.
inline Pair<double> two_product_fused(double a, double b) noexcept {
#if defined(FP_FAST_FMA)
  // A fused operation cannot be fused again: should a compiler contract, this product stays rounded.
  const double high = std::fma(a, b, 0.0);
#else
  const double high = a * b;
#endif
  return {high, std::fma(a, b, -high)};
}

/// True for scalars and lanes whose hardware has a * b - c, rounded once.
template <class V>
concept HasFused = requires(V x) {
  fused_difference(x, x, x);
};

/// a * b by the quicker of the two, exact within the limits of both. A compiler that contracts cannot contract this, as
/// where it could, the product is a fused operation already: high is the same number to all who use it.
template <class V>
VESICA_INLINE constexpr Pair<V> two_product_uncontracted(V a, V b) noexcept {
  if constexpr (HasFused<V>) {
    V high = fused_difference(a, b, V(-0.0));
    return {high, fused_difference(a, b, high)};
  } else {
    return two_product<V>(factor(a), factor(b));
  }
}

}  // namespace vesica::detail::arithmetic
