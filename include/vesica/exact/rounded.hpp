// SPDX-License-Identifier: Apache-2.0
/// From exact numbers back to floating point.
#pragma once

#include <cstddef>
#include <vesica/arithmetic/scaled.hpp>
#include <vesica/exact/leading.hpp>

namespace vesica::exact {

namespace detail {

/// The upper 53 bits of a limb whose uppermost is set, to nearest and ties to even; `rest`: whether anything is below.
constexpr Limb upper_bits(Limb top, bool rest) noexcept {
  constexpr Limb half = 0x400;
  const Limb kept = top >> 11, cut = top & (2 * half - 1);
  return kept + (cut > half || (cut == half && (rest || (kept & 1) != 0)) ? 1 : 0);
}

/// What a number, not 0, begins with: `bits` whose uppermost is set, from 2^(exponent - 1) down.
template <int limbs>
struct Beginning {
  Limb bits[std::size_t{limbs}];  ///< the uppermost first
  bool rest;                      ///< whether anything is below
  int exponent;

  constexpr explicit Beginning(const Span& x) noexcept : rest(x.size > limbs + 1) {
    const int last = x.size - 1, shift = std::countl_zero(x.limb[last]);
    const auto at = [&](int i) { return i <= last ? x.limb[last - i] : Limb{0}; };
    for (int i = 0; i < limbs; ++i) bits[i] = at(i) << shift | at(i + 1) >> 1 >> (63 - shift);
    rest = rest || at(limbs) << shift != 0;
    exponent = 64 * (x.low + x.size) - shift;
  }
  /// The upper 53 bits, to nearest and ties to even, in units of 2^(exponent - 53).
  constexpr Limb rounded() const noexcept { return upper_bits(bits[0], is_any_below_first()); }
  constexpr bool is_any_below_first() const noexcept {
    bool any = rest;
    for (int i = 1; i < limbs; ++i) any = any || bits[i] != 0;
    return any;
  }
};

/// rounded() of a magnitude that is not 0.
VESICA_CALLED constexpr vesica::detail::arithmetic::Scaled rounded_magnitude(const Span& x) noexcept {
  const Beginning<1> begins(x);
  return {static_cast<double>(begins.rounded()) * 0x1p-53, begins.exponent};
}

}  // namespace detail

/// The nearest value * 2^exponent with a value of 53 bits, half of it or more below 1 and ties to even; 0 for 0. The
/// exponent may be far beyond those of double.
template <int Degree>
constexpr vesica::detail::arithmetic::Scaled rounded(const Number<Degree>& x) noexcept {
  if (x.sign == 0) return {0, 0};
  const auto magnitude = detail::rounded_magnitude(x.span());
  return {x.sign * magnitude.value, magnitude.exponent};
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
template <int limbs>
constexpr bool rounds_surely(const Leading<limbs>& x, vesica::detail::arithmetic::Scaled& out) noexcept {
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
  if ((is_long(x) || ...) && detail::rounds_surely(value(Leading<few_limbs>(x)...), out)) return out;
  return rounded(value(x...));
}

/// The same as rounded(), and what it leaves: (high.value + low) * 2^high.exponent, low rounded as high is.
struct RoundedTwice {
  vesica::detail::arithmetic::Scaled high;
  double low;
};

namespace detail {

/// Of a sign and a magnitude that are not 0; false where three limbs do not tell what is left.
VESICA_CALLED constexpr bool limbs_rounded_twice(int sign, const Span& x, RoundedTwice& out) noexcept {
  using vesica::detail::arithmetic::power_of_two;
  const Beginning<3> begins(x);
  const Limb kept = begins.rounded();
  out = {{sign * (static_cast<double>(kept) * 0x1p-53), begins.exponent}, 0};
  // What is left in two limbs and 11 bits above them, or what lacks where it was rounded up.
  const bool lacks = kept != begins.bits[0] >> 11;
  Limb left[] = {begins.bits[0] & 0x7ff, begins.bits[1], begins.bits[2]};
  if (lacks) {
    const LimbPair low = subtract_limbs(0, left[2], begins.rest ? 1 : 0);
    const LimbPair middle = subtract_limbs(0, left[1], low.high);
    left[0] = 0x800 - left[0] - middle.high;
    left[1] = middle.low;
    left[2] = low.low;
  }
  const int skipped = left[0] != 0 ? 0 : 1;
  if (left[skipped] == 0) return !begins.is_any_below_first();
  const int shift = std::countl_zero(left[skipped]);
  const Limb next = left[skipped + 1], top = left[skipped] << shift | next >> 1 >> (63 - shift);
  const bool rest = next << shift != 0 || (skipped == 0 && left[2] != 0) || begins.rest;
  const double low = static_cast<double>(upper_bits(top, rest)) * power_of_two(-53 - 64 * skipped - shift);
  out.low = (lacks ? -sign : sign) * low;
  return true;
}

}  // namespace detail

template <int Degree>
constexpr RoundedTwice rounded_twice(const Number<Degree>& x) noexcept {
  if (x.sign == 0) return {{0, 0}, 0};
  RoundedTwice out{};
  if (detail::limbs_rounded_twice(x.sign, x.span(), out)) return out;
  const auto rest = rounded(x - from_double(out.high.value, out.high.exponent));
  return {out.high, vesica::detail::arithmetic::scale_far(rest.value, rest.exponent - out.high.exponent)};
}

}  // namespace vesica::exact
