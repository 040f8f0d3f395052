// SPDX-License-Identifier: Apache-2.0
/// Segment against rectangle: separating axes.
#pragma once

#include <vesica/exact/box_box.hpp>
#include <vesica/filter/box_box.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Segment<V>& segment, const Rect<V>& rect) noexcept {
  return filter::box_box(filter::box(segment), filter::box(rect),
                         filter::offset(filter::place(segment), filter::place(rect)));
}

constexpr int contact(const Segment<double>& segment, const Rect<double>& rect, Common) noexcept {
  return exact::contact(exact::form(segment), exact::form(rect));
}

}  // namespace vesica::detail::overlap
