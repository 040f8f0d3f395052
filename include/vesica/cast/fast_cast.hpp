// SPDX-License-Identifier: Apache-2.0
/// Casts of two shapes of known kinds: the early out and the fast hit, for kinds that have them.
#pragma once

#include <vesica/cast/fast_box_hit.hpp>
#include <vesica/cast/fast_round_hit.hpp>

namespace vesica::detail::cast {

/// The products of a program that does not use the library.
#if defined(VESICA_HAS_FUSED)
using UsualProducts = FusedProducts;
#else
using UsualProducts = SplitProducts;
#endif

/// The early out and the hit as one function, so that common terms are computed once. Unless the result is `open`, the
/// shapes are valid and the motion is sound: the caller checks nothing before. Only hits are written.
template <class Products, class A, class B>
VESICA_INLINE EarlyOut fast_cast(const A& a, const B& b, const Motion& motion, Impact<double>& out) noexcept {
  const EarlyOut early = early_out(a, b, motion);
  return early == EarlyOut::hit ? fast_hit<Products>(a, b, motion, out) : early;
}

}  // namespace vesica::detail::cast
