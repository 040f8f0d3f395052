// SPDX-License-Identifier: Apache-2.0
/// The rounding modes in which filters are measured: float is for lanes alone, which run in the default one.
#pragma once

#include <cfenv>
#include <span>

#include "filter/inputs.hpp"

namespace rounding {

struct Mode {
  int mode;
  const char* name;
};
inline constexpr Mode modes[] = {
    {FE_TONEAREST, ""}, {FE_DOWNWARD, ", downward"}, {FE_UPWARD, ", upward"}, {FE_TOWARDZERO, ", to zero"}};
template <class V>
inline constexpr std::span<const Mode> modes_of(modes, sizeof(V) == 8 ? 4 : 1);

/// ratio(n) in a rounding mode. The truth that it compares with is computed in integers. Barriers keep the operations
/// within the mode.
template <class V, class Ratio>
[[gnu::noinline]] double in(const Mode& mode, const inputs::Numbers<V>& n, const Ratio& ratio) {
  const inputs::Numbers<V>* numbers = &n;
  std::fesetround(mode.mode);
  asm volatile("" : "+r"(numbers) : : "memory");
  double result = ratio(*numbers);
  asm volatile("" : "+m"(result) : : "memory");
  std::fesetround(FE_TONEAREST);
  return result;
}

}  // namespace rounding
