// SPDX-License-Identifier: Apache-2.0
/// signed_distance(a, b): how far apart are two shapes or, below 0, how deep do they overlap?
///
/// The distance of nearest() for disjoint shapes, else minus the depth of depth(): 0 where shapes only touch. Both
/// numbers are theirs bit for bit, and so are their accuracy and their laws.
#pragma once

#include <limits>
#include <vesica/depth.hpp>
#include <vesica/nearest.hpp>

namespace vesica {

namespace detail {

/// The source of the number, for shapes in either order: points where they are disjoint, else the depth.
struct Separation {
  bool disjoint;
  ClosestPoints<double> points;
  Penetration<double> depth;
};

/// A call, for shapes of float and of double. Whether they overlap is asked once.
template <class A, class B>
VESICA_CALLED std::int32_t separation(const A& a, const B& b, Separation& out) noexcept {
  if constexpr (!in_order<A, B>) {
    return separation(b, a, out);
  } else {
    const std::int32_t overlapping = depth::overlap_in_order(a, b);
    if (overlapping < 0) return overlapping;
    out.disjoint = overlapping == 0;
    return out.disjoint ? nearest::nearest_in_order(a, b, 0, out.points)
                        : depth::depth_in_order(a, b, overlapping, out.depth);
  }
}

inline std::int32_t signed_distance_of(const Separation& s, double& out) noexcept {
  out = s.disjoint ? s.points.distance : 0 - s.depth.depth;  // no -0
  return 0;
}
/// As nearest() and depth() round their results.
inline std::int32_t signed_distance_of(const Separation& s, float& out) noexcept {
  ClosestPoints<float> points;
  Penetration<float> depth;
  const bool in_range = s.disjoint ? nearest::rounded_to(s.points, false, points) : depth::rounded_to(s.depth, depth);
  if (!in_range) return error_range;
  out = s.disjoint ? points.distance : 0 - depth.depth;
  return 0;
}

}  // namespace detail

/// The checked form, for shapes of any kinds, in either order. Returns 0, error_shape when either is invalid, or
/// error_range when nearest_or_error() or depth_or_error() does; on error `out` is untouched.
template <template <class> class A, template <class> class B, class T>
std::int32_t signed_distance_or_error(const A<T>& a, const B<T>& b, T& out) noexcept {
  detail::Separation found;
  const std::int32_t error = detail::separation(widen(a), widen(b), found);
  return error != 0 ? error : detail::signed_distance_of(found, out);
}

/// For valid shapes: NaN where signed_distance_or_error(), the checked form, returns an error.
template <template <class> class A, template <class> class B, class T>
T signed_distance(const A<T>& a, const B<T>& b) noexcept {
  T out = std::numeric_limits<T>::quiet_NaN();
  signed_distance_or_error(a, b, out);
  return out;
}

}  // namespace vesica
