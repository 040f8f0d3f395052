// SPDX-License-Identifier: Apache-2.0
/// Segment against circle: is the disc's centre at most a radius from the segment?
#pragma once

#include <vesica/exact/disc.hpp>
#include <vesica/filter/disc.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Segment<V>& segment, const Circle<V>& circle) noexcept {
  return filter::disc_box(filter::box(segment), filter::offset(filter::place(segment), filter::place(circle)),
                          circle.r);
}

constexpr bool exact(const Segment<double>& segment, const Circle<double>& circle) noexcept {
  return exact::overlap(exact::form(segment), circle);
}

}  // namespace vesica::detail::overlap
