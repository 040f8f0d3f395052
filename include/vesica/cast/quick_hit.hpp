// SPDX-License-Identifier: Apache-2.0
/// Casts of two shapes whose kinds are known: the quick way first, where there is one.
#pragma once

#include <vesica/cast/quick_box_hit.hpp>
#include <vesica/cast/quick_round_hit.hpp>

namespace vesica::detail::cast {

/// The products that a program without the library has.
#if defined(VESICA_HAS_FUSED)
using UsualProducts = FusedProducts;
#else
using UsualProducts = SplitProducts;
#endif

/// The answer about two shapes whose kinds are known: by hit(a, b), a quick_hit() for a motion that is sound, or by
/// rest() where that leaves it open.
template <class A, class B, class Hit, class Rest>
VESICA_INLINE std::int32_t cast_pair(const A& a, const B& b, const Motion& motion, const Hit& hit,
                                     const Rest& rest) noexcept {
  if constexpr (HasQuick<A, B>) {
    Quick quick = quick_filter(a, b, motion);
    if (quick == Quick::missed) return cast_miss;
    if (quick == Quick::hit) quick = hit(a, b);
    if (quick != Quick::open) return quick == Quick::hit ? cast_hit : cast_miss;
  }
  return rest();
}

}  // namespace vesica::detail::cast
