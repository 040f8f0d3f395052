// SPDX-License-Identifier: Apache-2.0
/// Point against AABB: between min and max in both coordinates. Comparisons alone are exact.
#pragma once

#include <vesica/contact.hpp>
#include <vesica/filter/comparison.hpp>

namespace vesica::detail::overlap {

using namespace lane;

template <class V>
VESICA_INLINE constexpr auto filter(const Point<V>& point, const Aabb<V>& aabb) noexcept {
  const auto in_x = both(aabb.min_x <= point.x, point.x <= aabb.max_x);
  const auto in_y = both(aabb.min_y <= point.y, point.y <= aabb.max_y);
  return filter::compared(both(filter::valid_aabb(aabb), filter::all_finite(point.x, point.y)), both(in_x, in_y));
}

#if VESICA_HAS_TWO_DOUBLES
VESICA_INLINE auto filter(const Point<double>& point, const Aabb<double>& aabb) noexcept {
  const TwoDoubles p(point.x, point.y), min(aabb.min_x, aabb.min_y), max(aabb.max_x, aabb.max_y);
  // The second of these minima and maxima is NaN if p is.
  const auto valid = filter::finite_and_ordered(min, max, lane::min(min, p), lane::max(max, p));
  return filter::DecidedVerdict<bool>{in_both(both(min <= p, p <= max)), in_both(valid)};
}
#endif

/// The inside of an interval of one point is that point.
template <class V>
VESICA_INLINE constexpr auto inside_of_interval(V x, V min, V max) noexcept {
  return either(both(min < x, x < max), both(min == x, x == max));
}

template <class V>
VESICA_INLINE constexpr auto insides_filter(const Point<V>& point, const Aabb<V>& aabb) noexcept {
  const auto in_x = inside_of_interval(point.x, aabb.min_x, aabb.max_x);
  const auto in_y = inside_of_interval(point.y, aabb.min_y, aabb.max_y);
  return filter::compared(both(filter::valid_aabb(aabb), filter::all_finite(point.x, point.y)), both(in_x, in_y));
}

#if VESICA_HAS_TWO_DOUBLES
VESICA_INLINE auto insides_filter(const Point<double>& point, const Aabb<double>& aabb) noexcept {
  const TwoDoubles p(point.x, point.y), min(aabb.min_x, aabb.min_y), max(aabb.max_x, aabb.max_y);
  const auto valid = filter::finite_and_ordered(min, max, lane::min(min, p), lane::max(max, p));
  return filter::DecidedVerdict<bool>{in_both(inside_of_interval(p, min, max)), in_both(valid)};
}
#endif

constexpr int contact(const Point<double>& point, const Aabb<double>& aabb, Common) noexcept {
  return insides_filter<double>(point, aabb).overlap ? -1 : filter<double>(point, aabb).overlap ? 0 : 1;
}

}  // namespace vesica::detail::overlap
