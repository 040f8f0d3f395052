// SPDX-License-Identifier: Apache-2.0
// Axes of unit length but for rounding, as angles give them.
#pragma once

#include "kernels/guard.hpp"

namespace vesica::filter {

/// Computed squares of axes from 1 - 10u to 1 + 12u, true ones within 14u of 1: a rounded cosine and sine have theirs
/// within 4u, a vector divided by its rounded length within 8u.
template <class V, class... Shape>
VESICA_INLINE Guard<V>& require_unit_axes(Guard<V>& guard, const Shape&... shape) noexcept {
  using T = typename Element<V>::Type;
  constexpr T u = ScalarTraits<T>::roundoff;
  return guard.within(T(1 - 10 * u), T(1 + 12 * u), (shape.ux * shape.ux + shape.uy * shape.uy)...);
}

}  // namespace vesica::filter
