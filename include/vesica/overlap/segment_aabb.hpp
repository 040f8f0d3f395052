// SPDX-License-Identifier: Apache-2.0
/// Segment against AABB: separating axes.
#pragma once

#include <vesica/exact/box_box.hpp>
#include <vesica/filter/box_box.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Segment<V>& segment, const Aabb<V>& aabb) noexcept {
  return filter::box_box(filter::box(segment), filter::box(aabb),
                         filter::offset(filter::place(segment), filter::place(aabb)));
}

constexpr int contact(const Segment<double>& segment, const Aabb<double>& aabb, Common) noexcept {
  return exact::contact(exact::form(segment), exact::form(aabb));
}

}  // namespace vesica::detail::overlap
