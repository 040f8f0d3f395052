// SPDX-License-Identifier: Apache-2.0
/// Points, segments, AABBs and rectangles against ellipses: visible edges, corners, and half extents.
#pragma once

#include <vesica/exact/relation.hpp>
#include <vesica/filter/box_ellipse.hpp>
#include <vesica/filter/point_ellipse.hpp>

namespace vesica::detail::relation {

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Point<V>& point, const Ellipse<V>& ellipse) noexcept {
  return filter::of_point(filter::point_ellipse(ellipse, filter::offset(filter::place(ellipse), filter::place(point))));
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Segment<V>& segment, const Ellipse<V>& ellipse) noexcept {
  return filter::box_ellipse_certain_facts(filter::box(segment), ellipse,
                                           filter::offset(filter::place(segment), filter::place(ellipse)));
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Aabb<V>& aabb, const Ellipse<V>& ellipse) noexcept {
  return filter::box_ellipse_certain_facts(filter::box(aabb), ellipse,
                                           filter::offset(filter::place(aabb), filter::place(ellipse)));
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Rect<V>& rect, const Ellipse<V>& ellipse) noexcept {
  return filter::box_ellipse_certain_facts(filter::box(rect), ellipse,
                                           filter::offset(filter::place(rect), filter::place(ellipse)));
}

}  // namespace vesica::detail::relation
