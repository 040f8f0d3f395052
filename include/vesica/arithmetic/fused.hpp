// SPDX-License-Identifier: Apache-2.0
/// Products of twofold.hpp by fused multiply-adds, for scalars whose bits must not depend on whether a processor has
/// these: exact as those by splitting, so the same to the bit, where products are 0 or between 2^-960 and 2^1000.
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

/// The same names as SplitProducts has.
struct FusedProducts {
  VESICA_INLINE static FusedFactor factor(double x) noexcept { return {x}; }
  VESICA_INLINE static FusedTwofoldFactor factor(const Twofold<double>& x) noexcept { return {x.high, x.low}; }
  VESICA_INLINE static VectorFactor<FusedTwofoldFactor> factor(const Vector<double>& v) noexcept {
    return {factor(v.x), factor(v.y)};
  }
  VESICA_INLINE static bool holds(double x) noexcept { return x == 0 || (abs(x) >= 0x1p-50 && abs(x) <= 0x1p50); }
};

}  // namespace vesica::detail::arithmetic
