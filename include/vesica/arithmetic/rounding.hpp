// SPDX-License-Identifier: Apache-2.0
/// Outward rounding without changing the rounding mode. A real number is known as an unevaluated sum of two doubles and
/// a bound on the error of that sum; this almost always decides the smallest double at or above the number.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vesica/arithmetic/error_free.hpp>

namespace vesica::detail::arithmetic {

/// The numbers within `error` of high + low. An infinite or NaN error says that nothing is known.
template <class V>
struct Estimate {
  V high, low, error;
};

/// The position of a number among the numbers of its type in ascending order; both zeros share one.
template <class T>
constexpr auto rank(T x) noexcept {
  using Integer = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
  constexpr Integer zero = Integer{1} << (8 * sizeof(T) - 1);
  const auto bits = std::bit_cast<Integer>(x);
  return bits < zero ? zero + bits : zero - (bits - zero);
}

/// The number at a position.
template <class T, class Integer>
constexpr T at_rank(Integer position) noexcept {
  constexpr Integer zero = Integer{1} << (8 * sizeof(T) - 1);
  return position < zero ? -std::bit_cast<T>(zero - position) : std::bit_cast<T>(position - zero);
}

/// The next number above a finite one. Unlike std::nextafter it leaves errno alone.
template <class T>
constexpr T next_above(T x) noexcept {
  return at_rank<T>(rank(x) + 1);
}

/// c + e.
template <class V>
VESICA_INLINE Estimate<V> add(V c, const Estimate<V>& e) noexcept {
  const Pair<V> top = two_sum(c, e.high), rest = two_sum(top.low, e.low);
  return {top.high, rest.high, (abs(rest.low) + e.error) * V(1 + 0x1p-50)};
}

/// The next double above x where `up`, else x; not for the negative double next to 0. By arithmetic, since a jump on a
/// digit's rest could not be predicted.
inline double above_if(bool up, double x) noexcept {
  const auto bits = std::bit_cast<std::int64_t>(x), step = bits >> 63 | 1;
  return std::bit_cast<double>(bits + (step & -static_cast<std::int64_t>(up)));
}

/// The smallest double at or above the number e stands for; false when e leaves that open.
template <class V>
VESICA_INLINE auto round_up(const Estimate<V>& e, V& out) noexcept {
  // The number is q and an error above `nearest`, and |q| is at most half the way to the next double on q's side.
  // So an error below |q| leaves it strictly between `nearest` and that next double.
  const auto [nearest, q] = two_sum(e.high, e.low);
  // Next to 0 nothing is half way: q is 0.
  out = above_if(q > V(0.0), nearest);
  return either(e.error < abs(q), e.error == V(0.0));
}

/// The nearest number of magnitude at most `largest`; -largest for NaN.
constexpr double clamped(double x, double largest) noexcept {
  if (std::is_constant_evaluated()) return x > -largest ? lane::min(x, largest) : -largest;
  return std::fmin(std::fmax(x, -largest), largest);
}

/// The smallest finite double for which `reaches` holds, false when there is none. `reaches` must be monotone: false
/// below some number, true from there on. It is asked about twice the logarithm of how far `start` is off.
template <class Predicate>
constexpr bool search_up(double start, const Predicate& reaches, double& out) noexcept {
  constexpr double infinity = std::numeric_limits<double>::infinity(), largest = std::numeric_limits<double>::max();
  const std::uint64_t none = rank(infinity);
  std::uint64_t no = rank(-infinity), yes = none, at = rank(clamped(start, largest)), step = 1;
  while (yes - no > 1) {
    const bool reached = reaches(at_rank<double>(at));
    (reached ? yes : no) = at;
    const bool bracketed = yes != none && no != rank(-infinity);
    if (bracketed || yes - no <= step) {
      at = no + (yes - no) / 2;
    } else {
      at = reached ? yes - step : no + step;
      step *= 2;
    }
  }
  if (yes == none) return false;
  out = at_rank<double>(yes);
  return true;
}

/// The smallest T at or above x, false when there is none.
template <class T>
constexpr bool round_up_to(double x, T& out) noexcept {
  constexpr T largest = std::numeric_limits<T>::max();
  if (x > static_cast<double>(largest)) return false;
  if (std::is_constant_evaluated() && x < -static_cast<double>(largest)) {  // a constant must not overflow
    out = -largest;
    return true;
  }
  const T nearest = static_cast<T>(x);
  out = static_cast<double>(nearest) < x ? at_rank<T>(rank(nearest) + 1) : nearest;
  return true;
}

}  // namespace vesica::detail::arithmetic
