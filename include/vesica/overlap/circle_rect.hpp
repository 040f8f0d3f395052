// SPDX-License-Identifier: Apache-2.0
/// Circle against rectangle: is the disc's centre at most a radius from the rectangle?
#pragma once

#include <vesica/exact/disc.hpp>
#include <vesica/filter/disc.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Circle<V>& circle, const Rect<V>& rect) noexcept {
  return filter::disc_box(filter::box(rect), filter::offset(filter::place(rect), filter::place(circle)), circle.r);
}

constexpr int contact(const Circle<double>& circle, const Rect<double>& rect, Common) noexcept {
  return exact::contact_of_any(exact::form(rect), circle);
}

}  // namespace vesica::detail::overlap
