// SPDX-License-Identifier: Apache-2.0
/// From exact numbers back to floating point.
#pragma once

#include <initializer_list>
#include <vesica/arithmetic/scaled.hpp>
#include <vesica/exact/digits.hpp>

namespace vesica::exact {

/// The nearest value * 2^exponent with a value of 53 bits, half of it or more below 1 and ties to even; 0 for 0. The
/// exponent may be far beyond those of double.
template <int Degree>
constexpr vesica::detail::arithmetic::Scaled rounded(const Number<Degree>& x) noexcept {
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

namespace detail {

/// The digits that are kept, as a number of a degree that has room for them.
template <int limbs>
constexpr auto digits_of(const Leading<limbs>& x) noexcept {
  Number<(limbs + 31) / 32 + 1> kept;
  static_assert(limbs <= kept.capacity);
  kept.sign = x.sign;
  kept.low = x.low;
  kept.size = x.sign == 0 ? 0 : limbs;
  for (int i = 0; i < kept.size; ++i) kept.limb[i] = x.limb[i];
  kept.strip();
  return kept;
}

/// rounded() of leading digits, if the missing digits cannot change the result.
template <class Kept>
constexpr bool rounds_surely(const Kept& x, vesica::detail::arithmetic::Scaled& out) noexcept {
  if (!x.sign_is_certain()) return false;
  auto kept = digits_of(x);
  out = rounded(kept);
  if (x.error == x.nothing) return true;
  if (x.error < std::int64_t{64} * x.low) return false;  // beyond the digits kept
  decltype(kept) missing;
  const int place = static_cast<int>(x.error - std::int64_t{64} * x.low);
  missing.sign = 1;
  missing.low = x.low + place / 64;
  missing.size = 1;
  missing.limb[0] = Limb{1} << place % 64;
  const auto most = rounded(kept + missing), least = rounded(kept - missing);
  return most.value == out.value && most.exponent == out.exponent && least.value == out.value &&
         least.exponent == out.exponent;
}

}  // namespace detail

/// rounded() of a polynomial in these numbers, from the leading digits of long ones if these suffice.
template <class Polynomial, int... Degree>
constexpr vesica::detail::arithmetic::Scaled rounded_value(const Polynomial& value,
                                                           const Number<Degree>&... x) noexcept {
  vesica::detail::arithmetic::Scaled out{0, 0};
  if ((is_long(x) || ...)) {
    if (detail::rounds_surely(value(Leading<few_limbs>(x)...), out)) return out;
    for (const int limbs : {more_limbs, most_limbs}) {
      if (((x.size > 2 * limbs) || ...) && detail::rounds_surely(value(Digits(x, limbs)...), out)) return out;
    }
  }
  return rounded(value(x...));
}

/// The same as rounded(), and what it leaves: (high.value + low) * 2^high.exponent, low rounded as high is.
struct RoundedTwice {
  vesica::detail::arithmetic::Scaled high;
  double low;
};
template <int Degree>
constexpr RoundedTwice rounded_twice(const Number<Degree>& x) noexcept {
  using vesica::detail::arithmetic::Scaled, vesica::detail::arithmetic::scale_far;
  const auto with_low = [](const Scaled& high, const Scaled& low) {
    return RoundedTwice{high, scale_far(low.value, low.exponent - high.exponent)};
  };
  const Scaled high = rounded(x);
  const auto less = from_double(high.value, high.exponent);
  // What is below the leading limbs only says that there is more, where 128 bits or more are left above it.
  constexpr int kept = 6;
  if (x.size > kept) {
    Number<1> leading;
    leading.sign = x.sign;
    leading.size = kept;
    leading.low = x.low + x.size - kept;
    detail::move_limbs(x.limb + x.size - kept, kept, leading.limb);
    leading.limb[0] |= 1;
    const Number<1> rest = leading - less;
    if (rest.low + rest.size - leading.low >= 3) return with_low(high, rounded(rest));
  }
  return with_low(high, rounded(x - less));
}

}  // namespace vesica::exact
