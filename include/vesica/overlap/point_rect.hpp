// SPDX-License-Identifier: Apache-2.0
/// Point against rectangle.
#pragma once

#include <vesica/exact/box_box.hpp>
#include <vesica/filter/box_box.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Point<V>& point, const Rect<V>& rect) noexcept {
  return filter::point_box(filter::box(rect), filter::offset(filter::place(rect), filter::place(point)));
}

constexpr int contact(const Point<double>& point, const Rect<double>& rect, Common) noexcept {
  return exact::contact(exact::form(point), exact::form(rect));
}

}  // namespace vesica::detail::overlap
