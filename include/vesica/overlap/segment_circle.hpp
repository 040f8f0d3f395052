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

constexpr int contact(const Segment<double>& segment, const Circle<double>& circle, Common) noexcept {
  return exact::contact_of_any(exact::form(segment), circle);
}

}  // namespace vesica::detail::overlap
