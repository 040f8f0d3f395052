// SPDX-License-Identifier: Apache-2.0
// The file that smoke_test.py mutates.
#pragma once

#include <array>
#include <utility>

namespace small {

// Nothing to mutate: the compiler evaluates these, or they come of a macro.
constexpr int sides = 2 + 2;
inline std::array<int, 2> corners{};
static_assert(sides > 3);
inline constinit int turns = sides + 1;
#define SMALL_HALF(x) ((x) / 2)
template <class T>
inline constexpr bool is_wide = false;
template <>
inline constexpr bool is_wide<double> = true;
template <class T>
constexpr decltype(T() + 1) wide() {
  if constexpr (is_wide<T> && sizeof(T) > 4) return T();
}
static_assert(wide<double>() < 1);
template <class T>
constexpr auto places() {
  return std::make_integer_sequence<int, sizeof(T) - 1>{};
}

enum class Verdict { apart, touching, crossing };

template <class T>
constexpr T positive(T x) {
  return x > T() ? x : T();
}

inline Verdict verdict(double gap) {
  if (positive(gap) == gap) return gap == SMALL_HALF(gap) ? Verdict::touching : Verdict::apart;
  corners[0] = sides;
  return Verdict::crossing;
}

/// Changes its argument: no call of it may be tried beside another.
inline int taken(int& left) { return left--; }

inline int after(int left) {
  constexpr int one = 2 - 1, five = one + 4;
  static_assert(five == 5);
  if (taken(left) == 2) return left;
  return 5;
}

}  // namespace small
