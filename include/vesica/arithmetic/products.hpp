// SPDX-License-Identifier: Apache-2.0
/// The exact products of twofold arithmetic, for scalar code that is compiled for processors with fused multiply-adds
/// and for those without: by splitting, as in twofold.hpp, or fused. Both are exact, so that all bits are the same,
/// where products are 0 or between 2^-960 and 2^1000.
#pragma once

#include <vesica/arithmetic/twofold.hpp>

namespace vesica::detail::arithmetic {

struct FusedFactor {
  double high;
};
struct FusedTwofoldFactor {
  double high, low;
};

/// a b, its zeros with the sign of a product. A fused operation cannot be fused again: where a compiler contracts, the
/// product stays rounded.
VESICA_INLINE Twofold<double> operator*(const FusedFactor& a, const FusedFactor& b) noexcept {
  const double high = std::fma(a.high, b.high, -0.0);
  return {high, std::fma(a.high, b.high, -high)};
}
VESICA_INLINE Twofold<double> operator*(const FusedFactor& a, const FusedTwofoldFactor& b) noexcept {
  const Twofold<double> p = FusedFactor{a.high} * FusedFactor{b.high};
  return {p.high, p.low + a.high * b.low};
}
VESICA_INLINE Twofold<double> operator*(const FusedTwofoldFactor& a, const FusedFactor& b) noexcept { return b * a; }
VESICA_INLINE Twofold<double> operator*(const FusedTwofoldFactor& a, const FusedTwofoldFactor& b) noexcept {
  const Twofold<double> p = FusedFactor{a.high} * FusedFactor{b.high};
  return {p.high, p.low + ((a.high * b.low + a.low * b.high) + a.low * b.low)};
}

VESICA_INLINE Twofold<double> square(const FusedFactor& a) noexcept { return a * a; }
VESICA_INLINE Twofold<double> square(const FusedTwofoldFactor& a) noexcept {
  const Twofold<double> p = FusedFactor{a.high} * FusedFactor{a.high};
  const double cross = a.high * a.low;
  return {p.high, p.low + ((cross + cross) + a.low * a.low)};
}

struct SplitProducts {
  template <class X>
  VESICA_INLINE static auto factor(const X& x) noexcept {
    return arithmetic::factor(x);
  }
  /// Whether a number that was not stored may be a factor.
  static constexpr bool holds(double) noexcept { return true; }
  VESICA_INLINE static Root<double> root(const Twofold<double>& x) noexcept { return arithmetic::root(x); }
  VESICA_INLINE static Twofold<double> inverse(const Twofold<double>& x) noexcept { return arithmetic::inverse(x); }
};
struct FusedProducts {
  VESICA_INLINE static FusedFactor factor(double x) noexcept { return {x}; }
  VESICA_INLINE static FusedTwofoldFactor factor(const Twofold<double>& x) noexcept { return {x.high, x.low}; }
  VESICA_INLINE static VectorFactor<FusedTwofoldFactor> factor(const Vector<double>& v) noexcept {
    return {factor(v.x), factor(v.y)};
  }
  /// As those of twofold.hpp.
  VESICA_INLINE static Root<double> root(const Twofold<double>& x) noexcept {
    const double high = sqrt(x.high), inverse = 1.0 / high;
    const Twofold<double> s = square(factor(high));
    return {{high, ((x.high - s.high) + (x.low - s.low)) * (0.5 * inverse)}, inverse};
  }
  VESICA_INLINE static Twofold<double> inverse(const Twofold<double>& x) noexcept {
    const double high = 1.0 / x.high;
    const Twofold<double> p = factor(high) * factor(x.high);
    return {high, ((1.0 - p.high) - (p.low + high * x.low)) * high};
  }
  VESICA_INLINE static bool holds(double x) noexcept { return x == 0 || (abs(x) >= 0x1p-50 && abs(x) <= 0x1p50); }
};

}  // namespace vesica::detail::arithmetic
