// SPDX-License-Identifier: Apache-2.0
/// Point against segment: a point overlaps when it lies on the segment, end points included.
#pragma once

#include <vesica/exact/box_box.hpp>
#include <vesica/filter/box_box.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Point<V>& point, const Segment<V>& segment) noexcept {
  // Only "off the segment" can be certain: a filter cannot know that a cross product is exactly zero.
  return filter::point_box(filter::box(segment), filter::offset(filter::place(segment), filter::place(point)));
}

constexpr int contact(const Point<double>& point, const Segment<double>& segment, Common) noexcept {
  return exact::contact(exact::form(point), exact::form(segment));
}

}  // namespace vesica::detail::overlap
