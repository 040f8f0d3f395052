// SPDX-License-Identifier: Apache-2.0
/// AABB against AABB: intervals that meet in both coordinates. Comparisons alone are exact.
#pragma once

#include <vesica/contact.hpp>
#include <vesica/filter/comparison.hpp>

namespace vesica::detail::overlap {

using namespace lane;

template <class V>
VESICA_INLINE constexpr auto filter(const Aabb<V>& a, const Aabb<V>& b) noexcept {
  const auto in_x = both(a.min_x <= b.max_x, b.min_x <= a.max_x);
  const auto in_y = both(a.min_y <= b.max_y, b.min_y <= a.max_y);
  return filter::compared(both(filter::valid_aabb(a), filter::valid_aabb(b)), both(in_x, in_y));
}

#if VESICA_HAS_TWO_DOUBLES
VESICA_INLINE auto filter(const Aabb<double>& a, const Aabb<double>& b) noexcept {
  const TwoDoubles min_a(a.min_x, a.min_y), max_a(a.max_x, a.max_y), min_b(b.min_x, b.min_y), max_b(b.max_x, b.max_y);
  const auto valid =
      both(min_a <= max_a, filter::finite_and_ordered(min_b, max_b, min(min_a, min_b), max(max_a, max_b)));
  return filter::DecidedVerdict<bool>{in_both(both(min_a <= max_b, min_b <= max_a)), in_both(valid)};
}
#endif

/// The inside of an interval of one point is that point.
template <class V>
VESICA_INLINE constexpr auto insides_of_intervals_meet(V a_min, V a_max, V b_min, V b_max) noexcept {
  return either(both(a_min < b_max, b_min < a_max), both(a_min == b_max, b_min == a_max));
}

template <class V>
VESICA_INLINE constexpr auto insides_filter(const Aabb<V>& a, const Aabb<V>& b) noexcept {
  const auto in_x = insides_of_intervals_meet(a.min_x, a.max_x, b.min_x, b.max_x);
  const auto in_y = insides_of_intervals_meet(a.min_y, a.max_y, b.min_y, b.max_y);
  return filter::compared(both(filter::valid_aabb(a), filter::valid_aabb(b)), both(in_x, in_y));
}

#if VESICA_HAS_TWO_DOUBLES
VESICA_INLINE auto insides_filter(const Aabb<double>& a, const Aabb<double>& b) noexcept {
  const TwoDoubles min_a(a.min_x, a.min_y), max_a(a.max_x, a.max_y), min_b(b.min_x, b.min_y), max_b(b.max_x, b.max_y);
  const auto valid =
      both(min_a <= max_a, filter::finite_and_ordered(min_b, max_b, min(min_a, min_b), max(max_a, max_b)));
  const auto meet = insides_of_intervals_meet(min_a, max_a, min_b, max_b);
  return filter::DecidedVerdict<bool>{in_both(meet), in_both(valid)};
}
#endif

constexpr int contact(const Aabb<double>& a, const Aabb<double>& b, Common) noexcept {
  return insides_filter<double>(a, b).overlap ? -1 : filter<double>(a, b).overlap ? 0 : 1;
}

}  // namespace vesica::detail::overlap
