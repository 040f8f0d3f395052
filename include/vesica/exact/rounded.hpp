// SPDX-License-Identifier: Apache-2.0
/// From exact numbers back to floating point.
#pragma once

#include <vesica/arithmetic/scaled.hpp>
#include <vesica/exact/number.hpp>

namespace vesica::exact {

/// The nearest value * 2^exponent with a value of 53 bits, half of it or more below 1 and ties to even; 0 for 0. The
/// exponent may be far beyond those of double.
template <int Degree>
vesica::detail::arithmetic::Scaled rounded(const Number<Degree>& x) noexcept {
  if (x.sign == 0) return {0, 0};
  const auto at = [&](int i) { return i < 0 ? Limb{0} : x.limb[i]; };
  const int last = x.size - 1, shift = std::countl_zero(x.limb[last]);
  const Limb top = shift == 0 ? at(last) : at(last) << shift | at(last - 1) >> (64 - shift);
  // The bits below the top 64 only say whether there are any.
  const bool rest = (shift == 0 ? at(last - 1) : at(last - 1) << shift) != 0 || last >= 2;
  const Limb kept = top >> 11, cut = top & 0x7ff, half = 0x400;
  const bool up = cut > half || (cut == half && (rest || (kept & 1) != 0));
  const double value = static_cast<double>(kept + (up ? 1 : 0)) * 0x1p-53;
  return {x.sign < 0 ? -value : value, 64 * (x.low + x.size) - shift};
}

/// The same, and what it leaves: (high.value + low) * 2^high.exponent, low rounded as high is.
struct RoundedTwice {
  vesica::detail::arithmetic::Scaled high;
  double low;
};
template <int Degree>
RoundedTwice rounded_twice(const Number<Degree>& x) noexcept {
  const auto high = rounded(x), low = rounded(x - from_double(high.value, high.exponent));
  return {high, vesica::detail::arithmetic::scale_far(low.value, low.exponent - high.exponent)};
}

}  // namespace vesica::exact
