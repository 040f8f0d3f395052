// SPDX-License-Identifier: Apache-2.0
/// Pairs that comparisons of stored numbers decide: nothing is rounded, so every valid input is decided here.
#pragma once

#include <vesica/filter/certain_facts.hpp>

namespace vesica::filter {

using vesica::detail::all_finite;

template <class V>
VESICA_INLINE constexpr auto valid_aabb(const Aabb<V>& s) noexcept {
  return both(all_finite(s.min_x, s.min_y, s.max_x, s.max_y), both(s.min_x <= s.max_x, s.min_y <= s.max_y));
}

template <class Mask>
VESICA_INLINE constexpr Verdict<Mask> compared(Mask valid, Mask overlap) noexcept {
  return {both(valid, overlap), and_not(valid, overlap)};
}

#if VESICA_HAS_TWO_DOUBLES
/// The same for the least and the greatest corner, both coordinates at once. `low` and `high` have all that must be
/// finite.
VESICA_INLINE TwoDoubles::Mask finite_and_ordered(TwoDoubles min, TwoDoubles max, TwoDoubles low,
                                                  TwoDoubles high) noexcept {
  return both(min <= max, (low - low) + (high - high) == TwoDoubles(0.0));
}
#endif

template <class V>
VESICA_INLINE constexpr V least(V a, V b, V c, V d) noexcept {
  return min(min(a, b), min(c, d));
}
template <class V>
VESICA_INLINE constexpr V greatest(V a, V b, V c, V d) noexcept {
  return max(max(a, b), max(c, d));
}

/// By differences, none of which is rounded to 0. Where one that matters is 0, shapes touch in one way or another, or
/// have no width: left undecided.
template <class V>
VESICA_INLINE constexpr auto aabb_aabb_certain_facts(const Aabb<V>& a, const Aabb<V>& b) noexcept {
  const V zero = V(0.0f);
  const V gap = greatest(a.min_x - b.max_x, b.min_x - a.max_x, a.min_y - b.max_y, b.min_y - a.max_y);
  const V left = b.min_x - a.min_x, right = a.max_x - b.max_x, low = b.min_y - a.min_y, high = a.max_y - b.max_y;
  const V farthest_out = greatest(left, right, low, high), least_room = least(left, right, low, high);
  const auto neither = both(farthest_out > zero, least_room < zero);
  // Each number is in one of four differences, so these are finite only if all are.
  const auto ordered = both(both(a.min_x <= a.max_x, a.min_y <= a.max_y), both(b.min_x <= b.max_x, b.min_y <= b.max_y));
  return guarded(
      both(all_finite(left, right, low, high), ordered),
      CertainFacts<decltype(gap > zero)>{gap > zero, gap < zero, farthest_out<zero, least_room> zero, neither});
}

template <class V>
VESICA_INLINE constexpr auto point_aabb_certain_facts(const Point<V>& p, const Aabb<V>& box) noexcept {
  const V room = least(p.x - box.min_x, box.max_x - p.x, p.y - box.min_y, box.max_y - p.y), zero = V(0.0f);
  return of_point(guarded(both(valid_aabb(box), all_finite(p.x, p.y)), room > zero, room < zero));
}

}  // namespace vesica::filter
