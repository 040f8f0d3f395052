// SPDX-License-Identifier: Apache-2.0
/// The exact products of twofold arithmetic, for code that is compiled for processors with fused multiply-adds and for
/// those without, scalars or lanes: by splitting, as in twofold.hpp, or fused. Both are exact, so that all bits are the
/// same, where products are 0 or between 2^-960 and 2^1000.
#pragma once

#include <vesica/arithmetic/twofold.hpp>

namespace vesica::detail::arithmetic {

template <class V>
struct FusedFactor {
  V high;
};
template <class V>
struct FusedTwofoldFactor {
  V high, low;
};

/// a b, its zeros with the sign of a product. A fused operation cannot be fused again: where a compiler contracts, the
/// product stays rounded. Lanes are compiled without contraction.
VESICA_INLINE Twofold<double> operator*(const FusedFactor<double>& a, const FusedFactor<double>& b) noexcept {
  const double high = std::fma(a.high, b.high, -0.0);
  return {high, std::fma(a.high, b.high, -high)};
}
template <HasFused V>
VESICA_INLINE Twofold<V> operator*(const FusedFactor<V>& a, const FusedFactor<V>& b) noexcept {
  V high = a.high * b.high;
  return {high, fused_difference(a.high, b.high, high)};
}
template <class V>
VESICA_INLINE Twofold<V> operator*(const FusedFactor<V>& a, const FusedTwofoldFactor<V>& b) noexcept {
  Twofold<V> p = a * FusedFactor<V>{b.high};
  return {p.high, p.low + a.high * b.low};
}
template <class V>
VESICA_INLINE Twofold<V> operator*(const FusedTwofoldFactor<V>& a, const FusedFactor<V>& b) noexcept {
  return b * a;
}
template <class V>
VESICA_INLINE Twofold<V> operator*(const FusedTwofoldFactor<V>& a, const FusedTwofoldFactor<V>& b) noexcept {
  Twofold<V> p = FusedFactor<V>{a.high} * FusedFactor<V>{b.high};
  return {p.high, p.low + ((a.high * b.low + a.low * b.high) + a.low * b.low)};
}

template <class V>
VESICA_INLINE Twofold<V> square(const FusedFactor<V>& a) noexcept {
  return a * a;
}
template <class V>
VESICA_INLINE Twofold<V> square(const FusedTwofoldFactor<V>& a) noexcept {
  Twofold<V> p = FusedFactor<V>{a.high} * FusedFactor<V>{a.high};
  const V cross = a.high * a.low;
  return {p.high, p.low + ((cross + cross) + a.low * a.low)};
}

struct SplitProducts {
  template <class X>
  VESICA_INLINE static auto factor(const X& x) noexcept {
    return arithmetic::factor(x);
  }
  /// True if a number that was not stored may be a factor.
  static constexpr bool holds(double) noexcept { return true; }
  template <class V>
  VESICA_INLINE static Root<V> root(const Twofold<V>& x) noexcept {
    return arithmetic::root(x);
  }
  VESICA_INLINE static Twofold<double> inverse(const Twofold<double>& x) noexcept { return arithmetic::inverse(x); }
};
struct FusedProducts {
  template <class V>
  VESICA_INLINE static FusedFactor<V> factor(V x) noexcept {
    return {x};
  }
  template <class V>
  VESICA_INLINE static FusedTwofoldFactor<V> factor(const Twofold<V>& x) noexcept {
    return {x.high, x.low};
  }
  template <class V>
  VESICA_INLINE static VectorFactor<FusedTwofoldFactor<V>> factor(const Vector<V>& v) noexcept {
    return {factor(v.x), factor(v.y)};
  }
  /// As those of twofold.hpp.
  template <class V>
  VESICA_INLINE static Root<V> root(const Twofold<V>& x) noexcept {
    V high = sqrt(x.high), inverse = V(1.0) / high;
    Twofold<V> s = square(factor(high));
    return {{high, ((x.high - s.high) + (x.low - s.low)) * (V(0.5) * inverse)}, inverse};
  }
  VESICA_INLINE static Twofold<double> inverse(const Twofold<double>& x) noexcept {
    const double high = 1.0 / x.high;
    Twofold<double> p = factor(high) * factor(x.high);
    return {high, ((1.0 - p.high) - (p.low + high * x.low)) * high};
  }
  VESICA_INLINE static bool holds(double x) noexcept { return x == 0 || (abs(x) >= 0x1p-50 && abs(x) <= 0x1p50); }
};

}  // namespace vesica::detail::arithmetic
