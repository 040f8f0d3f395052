// SPDX-License-Identifier: Apache-2.0
/// From exact numbers back to floating point.
#pragma once

#include <cstddef>
#include <vesica/arithmetic/scaled.hpp>
#include <vesica/exact/number.hpp>

namespace vesica::exact {

namespace detail {

/// The upper 53 bits of a limb whose uppermost is set, to nearest and ties to even; `rest`: whether anything is below.
constexpr Limb upper_bits(Limb top, bool rest) noexcept {
  constexpr Limb half = 0x400;
  const Limb kept = top >> 11, cut = top & (2 * half - 1);
  return kept + (cut > half || (cut == half && (rest || (kept & 1) != 0)) ? 1 : 0);
}

/// The leading limbs of a number that is not 0: `bits`, the uppermost bit set, from 2^(exponent - 1) down.
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

/// rounded(), and the remainder rounded once more: (high.value + low) * 2^high.exponent, low rounded as high is.
struct RoundedTwice {
  vesica::detail::arithmetic::Scaled high;
  double low;
};

namespace detail {

/// Rounds a nonzero number twice from its first three limbs. Returns false if lower limbs decide the remainder.
VESICA_CALLED constexpr bool limbs_rounded_twice(int sign, const Span& x, RoundedTwice& out) noexcept {
  using vesica::detail::arithmetic::power_of_two;
  const Beginning<3> begins(x);
  const Limb kept = begins.rounded();
  out = {{sign * (static_cast<double>(kept) * 0x1p-53), begins.exponent}, 0};
  // The remainder, in two limbs and 11 bits above them; the missing part if the number was rounded up.
  const bool was_rounded_up = kept != begins.bits[0] >> 11;
  Limb left[] = {begins.bits[0] & 0x7ff, begins.bits[1], begins.bits[2]};
  if (was_rounded_up) {
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
  out.low = (was_rounded_up ? -sign : sign) * low;
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
