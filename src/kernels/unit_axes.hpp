// SPDX-License-Identifier: Apache-2.0
// Axes of unit length up to rounding, as angles give them.
#pragma once

#include "kernels/guard.hpp"

namespace vesica::filter {

/// Requires that the computed squares of axes are from 1 - 10u to 1 + 12u. The filters for unit axes build on what
/// follows: the true squares are within 14u of 1, since computing one adds two roundings at most.
///
/// Axes as users make them pass: the square of a rounded cosine and sine is within 4u of 1, that of a vector divided by
/// its rounded length within 8u.
template <class V, class... Shape>
VESICA_INLINE Guard<V>& require_unit_axes(Guard<V>& guard, const Shape&... shape) noexcept {
  using T = typename Element<V>::Type;
  constexpr T u = ScalarTraits<T>::roundoff;
  return guard.within(T(1 - 10 * u), T(1 + 12 * u), (shape.ux * shape.ux + shape.uy * shape.uy)...);
}

}  // namespace vesica::filter
