// SPDX-License-Identifier: Apache-2.0
/// Rectangle against ellipse: do the edges that the ellipse can see miss it?
#pragma once

#include <vesica/exact/box_ellipse.hpp>
#include <vesica/filter/box_ellipse.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Rect<V>& rect, const Ellipse<V>& ellipse) noexcept {
  return filter::box_ellipse(filter::box(rect), ellipse, filter::offset(filter::place(rect), filter::place(ellipse)));
}

constexpr bool exact(const Rect<double>& rect, const Ellipse<double>& ellipse) noexcept {
  return exact::overlap(exact::form(rect), exact::form(ellipse));
}

}  // namespace vesica::detail::overlap
