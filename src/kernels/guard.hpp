// SPDX-License-Identifier: Apache-2.0
// Guards: are the numbers of a pair in the range for which a filter's error bound is proved?
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vesica/filter/estimate.hpp>

namespace vesica {
namespace {

using namespace lane;

/// n units of roundoff to nearest, half of what other filters reckon with: kernels run in the default environment.
template <class V>
VESICA_INLINE V nearest_roundoffs(int n) noexcept {
  using T = typename filter::Element<V>::Type;
  return V(static_cast<T>(n) * ScalarTraits<T>::roundoff);
}

/// Lanes whose bits can be had as integers: what can be checked in them leaves the multipliers alone.
template <class V>
concept HasBits = requires(V x) {
  to_bits(x);
};

/// Checks, all of which must hold. NaN fails each; -0 may fail the last.
template <class V>
class Guard {
  using T = typename filter::Element<V>::Type;

 public:
  /// Each x in [low, high). Both positive, and so that 2^k numbers lie between.
  template <class... X>
  VESICA_INLINE Guard& within(T low, T high, X... x) noexcept {
    ((holds_ = both(holds_, both(x >= V(low), x < V(high)))), ...);
    return *this;
  }
  /// a / b in [1/16, 16), a being positive.
  VESICA_INLINE Guard& near_in_size(V a, V b) noexcept {
    holds_ = both(holds_, both(a < V(16.0f) * b, b <= V(16.0f) * a));
    return *this;
  }
  template <class... X>
  VESICA_INLINE Guard& not_negative(X... x) noexcept {
    holds_ = both(holds_, filter::at_least(V(0.0f), x...));
    return *this;
  }
  VESICA_INLINE auto holds() const noexcept { return holds_; }

 private:
  decltype(V() < V()) holds_ = V(0.0f) <= V(0.0f);
};

/// In bits, each check finds those that should be clear. A number's exponent and fraction in one are nearly its
/// logarithm: in units of the exponent's last place, too little by up to 0.087.
template <HasBits V>
class Guard<V> {
  using T = typename V::Element;

 public:
  using Integer = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;

  template <class... X>
  VESICA_INLINE Guard& within(T low, T high, X... x) noexcept {
    const auto first = std::bit_cast<Integer>(low), last = std::bit_cast<Integer>(high) - 1;
    return expect_clear(first - last - 1, (... | (to_bits(x) - in_all_lanes(first))));
  }
  VESICA_INLINE Guard& near_in_size(V a, V b) noexcept {
    constexpr Integer most = Integer{4} << fraction_bits;
    return expect_clear(-2 * most, to_bits(a) - (to_bits(b) - in_all_lanes(most)));
  }
  template <class... X>
  VESICA_INLINE Guard& not_negative(X... x) noexcept {
    return expect_clear(sign, (... | to_bits(x)));
  }
  VESICA_INLINE auto holds() const noexcept { return is_zero(wrong_); }

 private:
  using Bits = decltype(to_bits(V()));
  static constexpr int fraction_bits = std::numeric_limits<T>::digits - 1;
  static constexpr Integer sign = std::numeric_limits<Integer>::min();

  VESICA_INLINE Guard& expect_clear(Integer mask, Bits bits) noexcept {
    wrong_ = wrong_ | (bits & in_all_lanes(mask));
    return *this;
  }
  Bits wrong_ = in_all_lanes(Integer{0});
};

/// x with n added to its bits.
template <HasBits V>
VESICA_INLINE V with_bits_added(V x, typename Guard<V>::Integer n) noexcept {
  return from_bits(to_bits(x) - in_all_lanes(static_cast<typename Guard<V>::Integer>(-n)));
}

/// x 2^e for x >= 0 and e > 0, for comparison with a bound of 2^-100 (double: 2^-800) or more: not above it where x is
/// subnormal, beyond the range when multiplied, infinite or NaN. In bits what is beyond wraps to below zero or to NaN.
template <int e, class V>
VESICA_INLINE V times_power(V x) noexcept {
  using T = typename filter::Element<V>::Type;
  if constexpr (HasBits<V>) {
    return with_bits_added(x, typename Guard<V>::Integer{e} << (std::numeric_limits<T>::digits - 1));
  } else {
    const V product = x * V(ScalarTraits<T>::power(e));
    return select(product <= V(std::numeric_limits<T>::max()), product, V(0.0f));
  }
}

/// x times 1 + n u to 1 + 2n u, for x >= 0.
template <int n, class V>
VESICA_INLINE V raised(V x) noexcept {
  if constexpr (HasBits<V>) {
    return with_bits_added(x, n);
  } else {
    return x * (V(1.0f) + nearest_roundoffs<V>(n + 2));  // the product rounds
  }
}

/// a > b where the mask is set.
template <class Mask, class V>
VESICA_INLINE Mask greater_where(Mask mask, V a, V b) noexcept {
  return both(mask, a > b);
}

}  // namespace

namespace filter {

/// Where `usable` is set, a gap beyond `bound` times 2^n roundoffs decides, and its sign says how: negative is overlap.
/// The bound is 2^-100 (double: 2^-800) or more, or NaN. A gap too large to be multiplied by 2^(24 - n) (double:
/// 2^(53 - n)) decides nothing.
template <int n, class Usable, class V>
VESICA_INLINE auto decided_by_gap(Usable usable, V gap, V bound) noexcept {
  constexpr int roundoff_exponent = std::numeric_limits<typename Element<V>::Type>::digits;
  const auto decided = greater_where(usable, times_power<roundoff_exponent - n>(abs(gap)), bound);
  return DecidedVerdict<decltype(V() < V())>{greater_where(decided, V(0.0f), gap), decided};
}

}  // namespace filter
}  // namespace vesica
