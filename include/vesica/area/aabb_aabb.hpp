// SPDX-License-Identifier: Apache-2.0
/// The area that two AABBs share. What they share is an AABB of stored numbers, so its area can be rounded once. One
/// formula serves a double and lanes of doubles.
#pragma once

#include <type_traits>
#include <vesica/area/box_box.hpp>
#include <vesica/arithmetic/error_free.hpp>
#include <vesica/shapes.hpp>

namespace vesica::detail::area {

/// The AABB that two AABBs share; its sizes are negative or 0 if their insides do not meet.
template <class V>
VESICA_INLINE Aabb<V> common(const Aabb<V>& a, const Aabb<V>& b) noexcept {
  return {max(a.min_x, b.min_x), max(a.min_y, b.min_y), min(a.max_x, b.max_x), min(a.max_y, b.max_y)};
}

/// Is the AABB valid, and are its sizes, and their product, far from the ends of the format?
template <class V>
VESICA_INLINE auto has_usual_sizes(const Aabb<V>& s) noexcept {
  const V w = s.max_x - s.min_x, h = s.max_y - s.min_y;
  return both(filter::in_range(w, V(0x1p-200), V(0x1p200)), filter::in_range(h, V(0x1p-200), V(0x1p200)));
}

/// The nearest double to the area of an AABB of usual sizes; settled if it is certain which one that is.
///
/// With sizes W + w and H + h, |w| <= u W, the product is W H + (W h + w H) + w h. The last term is left out, at most
/// u^2 of it, and the second is rounded, by at most 6 u^2.
template <class V>
VESICA_INLINE auto rounded_area(const Aabb<V>& s) noexcept {
  const auto w = arithmetic::two_difference(s.max_x, s.min_x), h = arithmetic::two_difference(s.max_y, s.min_y);
  const auto whole = arithmetic::two_product_uncontracted(w.high, h.high);
  const V rest = whole.low + (w.high * h.low + w.low * h.high), error = whole.high * V(0x1p-100);
  const auto area = arithmetic::fast_two_sum(whole.high, rest);
  const auto certain = both(area.high + (area.low + error) == area.high, area.high + (area.low - error) == area.high);
  return Settled<V, std::remove_const_t<decltype(certain)>>{area.high, certain};
}

/// The shared area, shape_area() of what is shared; settled for AABBs of usual sizes.
template <class V>
VESICA_INLINE auto quick_area(const Aabb<V>& a, const Aabb<V>& b) noexcept {
  const Aabb<V> shared = common(a, b);
  const auto usual = both(has_usual_sizes(a), has_usual_sizes(b));
  const auto none = either(shared.max_x <= shared.min_x, shared.max_y <= shared.min_y);
  const auto area = rounded_area(shared);
  const auto settled = both(usual, either(none, both(area.settled, has_usual_sizes(shared))));
  return Settled<V, std::remove_const_t<decltype(settled)>>{select(none, V(0.0), area.area), settled};
}

}  // namespace vesica::detail::area
