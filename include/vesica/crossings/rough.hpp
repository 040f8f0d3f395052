// SPDX-License-Identifier: Apache-2.0
/// Estimates from leading digits, for casts.
#pragma once

#include <vesica/crossings/estimate.hpp>
#include <vesica/exact/discriminant.hpp>

namespace vesica::exact {

/// The leading digits of the discriminant.
VESICA_CALLED constexpr Leading<few_limbs> leading_discriminant(const ContactCubic& p) noexcept {
  using detail::sum_of_products;
  const Number<16> lower = sum_of_products(1, p.c1, p.c1, -4, p.d1, p.c2);
  const Number<16> upper = sum_of_products(1, p.c2, p.c2, -4, p.c1, p.d2);
  const Number<16> ends = p.d1 * p.d2, less = sum_of_products(27, p.d1, p.d2, -2, p.c1, p.c2);
  return Leading<few_limbs>(lower * upper - ends * less);
}

}  // namespace vesica::exact

namespace vesica::detail::crossings {

using Rough = Estimate;

/// The estimate of a number by its leading digits.
template <int limbs>
Rough rough(const exact::Leading<limbs>& x) noexcept {
  const auto kept = exact::detail::digits_of(x);
  Rough out(kept);
  if (x.error == x.nothing) return out;
  const int place = static_cast<int>(x.error);
  // If all digits are beyond what is known, only the error matters.
  if (kept.sign == 0 || place > out.exponent + 60) return {{}, 2, place};
  return {out.value, out.error + arithmetic::scale(1.01, place - out.exponent), out.exponent};
}

}  // namespace vesica::detail::crossings
