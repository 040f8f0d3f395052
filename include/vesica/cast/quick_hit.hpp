// SPDX-License-Identifier: Apache-2.0
/// Casts of two shapes whose kinds are known: the quick way first, where there is one.
#pragma once

#include <vesica/cast/quick_box_hit.hpp>
#include <vesica/cast/quick_box_round_hit.hpp>
#include <vesica/cast/quick_round_hit.hpp>

namespace vesica::detail::cast {

/// The products that a program without the library has.
#if defined(VESICA_HAS_FUSED)
using UsualProducts = FusedProducts;
#else
using UsualProducts = SplitProducts;
#endif

/// The filter and the hit as one function, so that what both compute is computed once. What is not open is decided, of
/// valid shapes and a sound motion; nothing need be checked before. Writes hits alone.
template <class Products, class A, class B>
VESICA_INLINE Quick quick_cast(const A& a, const B& b, const Motion& motion, Impact<double>& out) noexcept {
  const Quick quick = quick_filter(a, b, motion);
  return quick == Quick::hit ? quick_hit<Products>(a, b, motion, out) : quick;
}

}  // namespace vesica::detail::cast
