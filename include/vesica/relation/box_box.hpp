// SPDX-License-Identifier: Apache-2.0
/// Points, segments, AABBs and rectangles against each other, by separating axes. Pairs that comparisons decide are in
/// comparison.hpp.
#pragma once

#include <vesica/exact/relation.hpp>
#include <vesica/filter/box_box.hpp>
#include <vesica/filter/certain_facts.hpp>

namespace vesica::detail::relation {

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Point<V>& point, const Segment<V>& segment) noexcept {
  return filter::of_point(
      filter::point_box(filter::box(segment), filter::offset(filter::place(segment), filter::place(point))));
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Point<V>& point, const Rect<V>& rect) noexcept {
  return filter::of_point(
      filter::point_box(filter::box(rect), filter::offset(filter::place(rect), filter::place(point))));
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Segment<V>& a, const Segment<V>& b) noexcept {
  return filter::box_box_certain_facts(filter::box(a), filter::box(b),
                                       filter::offset(filter::place(a), filter::place(b)));
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Segment<V>& segment, const Aabb<V>& aabb) noexcept {
  return filter::box_box_certain_facts(filter::box(segment), filter::box(aabb),
                                       filter::offset(filter::place(segment), filter::place(aabb)));
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Segment<V>& segment, const Rect<V>& rect) noexcept {
  return filter::box_box_certain_facts(filter::box(segment), filter::box(rect),
                                       filter::offset(filter::place(segment), filter::place(rect)));
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Aabb<V>& aabb, const Rect<V>& rect) noexcept {
  return filter::box_box_certain_facts(filter::box(aabb), filter::box(rect),
                                       filter::offset(filter::place(aabb), filter::place(rect)));
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Rect<V>& a, const Rect<V>& b) noexcept {
  return filter::box_box_certain_facts(filter::box(a), filter::box(b),
                                       filter::offset(filter::place(a), filter::place(b)));
}

}  // namespace vesica::detail::relation
