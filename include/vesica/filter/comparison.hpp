// SPDX-License-Identifier: Apache-2.0
/// Pairs that comparisons of stored numbers decide: nothing is rounded, so every valid input is decided here.
#pragma once

#include <vesica/filter/estimate.hpp>

namespace vesica::filter {

/// All numbers finite: x - x is 0 for a finite x and NaN for any other, and NaN survives the sum.
template <class V, class... W>
VESICA_INLINE auto finite(V first, W... rest) noexcept {
  return ((first - first) + ... + (rest - rest)) == V(0.0f);
}

template <class V>
VESICA_INLINE auto valid_aabb(const Aabb<V>& s) noexcept {
  return both(finite(s.min_x, s.min_y, s.max_x, s.max_y), both(s.min_x <= s.max_x, s.min_y <= s.max_y));
}

template <class Mask>
VESICA_INLINE Verdict<Mask> compared(Mask valid, Mask overlap) noexcept {
  return {both(valid, overlap), and_not(valid, overlap)};
}

}  // namespace vesica::filter
