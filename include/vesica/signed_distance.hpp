// SPDX-License-Identifier: Apache-2.0
/// signed_distance(a, b): how far apart are two shapes or, below 0, how deep do they overlap?
///
/// The distance of nearest() for disjoint shapes, else minus that of depth(): 0 where shapes only touch. Both numbers are
/// theirs bit for bit, and so are their accuracy and their laws.
#pragma once

#include <limits>
#include <vesica/depth.hpp>
#include <vesica/nearest.hpp>

namespace vesica {

/// The checked form, for shapes of any kinds, in either order. Returns 0, error_shape when either is invalid, or
/// error_range when nearest_or_error() or depth_or_error() does; on error `out` is untouched.
template <template <class> class A, template <class> class B, class T>
std::int32_t signed_distance_or_error(const A<T>& a, const B<T>& b, T& out) noexcept {
  const std::int32_t overlapping = overlap_or_error(a, b);
  if (overlapping < 0) return overlapping;
  if (overlapping == 0) {
    ClosestPoints<T> found;
    const std::int32_t error = nearest_or_error(a, b, found);
    if (error == 0) out = found.distance;
    return error;
  }
  Penetration<T> found;
  const std::int32_t error = depth_or_error(a, b, found);
  if (error == 0) out = 0 - found.depth;  // no -0
  return error;
}

/// For valid shapes: NaN where signed_distance_or_error(), the checked form, returns an error.
template <template <class> class A, template <class> class B, class T>
T signed_distance(const A<T>& a, const B<T>& b) noexcept {
  T out = std::numeric_limits<T>::quiet_NaN();
  signed_distance_or_error(a, b, out);
  return out;
}

}  // namespace vesica
