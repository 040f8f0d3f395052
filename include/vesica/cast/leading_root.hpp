// SPDX-License-Identifier: Apache-2.0
/// Square roots to as many digits as a number has.
#pragma once

#include <vesica/arithmetic/wide.hpp>
#include <vesica/exact/leading.hpp>

namespace vesica::detail::cast {

using arithmetic::Wide;
using exact::Leading;

template <int limbs>
Wide wide(const Leading<limbs>& x) noexcept {
  constexpr int top = limbs - 1;
  if (x.sign == 0) return {};
  const double value = static_cast<double>(x.limb[top]) + 0x1p-64 * static_cast<double>(x.limb[top - 1]);
  return {x.sign * value, 64 * (x.low + top)};
}
template <int limbs>
Leading<limbs> leading(const Wide& x) noexcept {
  return Leading<limbs>(exact::from_double(x.value, x.exponent));
}

/// Of a > 0: Newton's method, which doubles the digits of x, and of r = 1 / (2 x). What is left of a in the end bounds
/// the error: it is (a - x^2) / (x + root).
template <int limbs>
Leading<limbs> root(const Leading<limbs>& a) noexcept {
  constexpr auto nothing = Leading<limbs>::nothing;
  const Wide first = arithmetic::root(wide(a));
  const Leading<limbs> one(exact::integer(1));
  Leading<limbs> x = leading<limbs>(first), r = leading<limbs>(Wide(0.5, 0) / first);
  for (int bits = 50; bits < 64 * limbs; bits *= 2) {
    x = x + (a - square(x)) * r;
    x.error = nothing;
    r = r + r * (one - times(2, x * r));
    r.error = nothing;
  }
  const Leading<limbs> left = a - square(x);
  const std::int64_t most = left.top() > left.error ? left.top() : left.error;
  if (most != nothing) x.lose(most + 1 - (x.top() - 1));
  return x;
}

}  // namespace vesica::detail::cast
