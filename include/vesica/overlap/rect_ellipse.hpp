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

constexpr int contact(const Rect<double>& rect, const Ellipse<double>& ellipse, Common common) noexcept {
  return exact::contact(exact::form(rect), exact::form(ellipse), common);
}

}  // namespace vesica::detail::overlap
