// SPDX-License-Identifier: Apache-2.0
/// Square roots to as many digits as a number has.
#pragma once

#include <vesica/arithmetic/wide.hpp>
#include <vesica/cast/exact.hpp>

namespace vesica::detail::cast {

using arithmetic::Wide;
using exact::Digits;

inline Wide wide(int sign, const exact::Limb* limb, int low, int limbs) noexcept {
  if (sign == 0) return {};
  const int top = limbs - 1;
  const double value = static_cast<double>(limb[top]) + 0x1p-64 * static_cast<double>(limb[top - 1]);
  return {sign * value, 64 * (low + top)};
}
template <int limbs>
Wide wide(const Leading<limbs>& x) noexcept {
  return wide(x.sign, x.limb, x.low, limbs);
}
inline Wide wide(const Digits& x) noexcept { return wide(x.sign, x.limb, x.low, x.limbs); }

inline Digits digits(const Wide& x, int limbs) noexcept { return {exact::from_double(x.value, x.exponent), limbs}; }
inline Digits digits(const Rough& x, int limbs) noexcept {
  return digits(Wide(x.value.high, x.exponent), limbs) + digits(Wide(x.value.low, x.exponent), limbs);
}

/// Of a > 0: Newton's method, which doubles the digits of x, and of r = 1 / (2 x), in as many limbs as they then have.
/// What is left of a in the end bounds the error: it is (a - x^2) / (x + root).
VESICA_CALLED inline Digits root(const Digits& a) noexcept {
  const Rough first = root(rough(a)), half = Rough(crossings::Real(0.5), 0, 0) / first;
  int limbs = 4;
  Digits x = digits(first, limbs), r = digits(half, limbs);
  for (int bits = 95;; bits *= 2) {
    x = x.with_limbs(limbs), r = r.with_limbs(limbs);
    x = (x + (a.with_limbs(limbs) - square(x)) * r).with_limbs(limbs);
    if (limbs == a.limbs) break;
    r = r + r * (Digits(exact::integer(1), limbs) - times(2, x * r));
    // Then x has twice these bits, and the next one four times. An even number of limbs.
    limbs = (bits / 16 + 3) / 2 * 2;
    if (limbs > a.limbs) limbs = a.limbs;
  }
  const Digits left = a - square(x);
  const std::int64_t most = left.top() > left.error ? left.top() : left.error;
  if (most != Digits::nothing) x.lose(most + 1 - (x.top() - 1));
  return x;
}

}  // namespace vesica::detail::cast
