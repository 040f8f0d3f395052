// SPDX-License-Identifier: Apache-2.0
/// Circles against everything but ellipses: distances compared with radii.
#pragma once

#include <vesica/exact/relation.hpp>
#include <vesica/filter/disc.hpp>

namespace vesica::detail::relation {

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Point<V>& point, const Circle<V>& circle) noexcept {
  return filter::of_point(filter::point_disc(filter::offset(filter::place(point), filter::place(circle)), circle.r));
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Segment<V>& segment, const Circle<V>& circle) noexcept {
  return filter::disc_box_certain_facts(filter::box(segment),
                                        filter::offset(filter::place(segment), filter::place(circle)), circle.r)
      .exchanged();
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Circle<V>& a, const Circle<V>& b) noexcept {
  return filter::disc_disc_certain_facts(filter::offset(filter::place(a), filter::place(b)), a.r, b.r);
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Circle<V>& circle, const Aabb<V>& aabb) noexcept {
  return filter::disc_aabb_certain_facts(circle, aabb);
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Circle<V>& circle, const Rect<V>& rect) noexcept {
  return filter::disc_box_certain_facts(filter::box(rect), filter::offset(filter::place(rect), filter::place(circle)),
                                        circle.r);
}

}  // namespace vesica::detail::relation
