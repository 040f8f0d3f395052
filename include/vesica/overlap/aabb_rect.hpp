// SPDX-License-Identifier: Apache-2.0
/// AABB against rectangle: separating axes.
#pragma once

#include <vesica/exact/box_box.hpp>
#include <vesica/filter/box_box.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Aabb<V>& aabb, const Rect<V>& rect) noexcept {
  return filter::box_box(filter::box(aabb), filter::box(rect),
                         filter::offset(filter::place(aabb), filter::place(rect)));
}

constexpr int contact(const Aabb<double>& aabb, const Rect<double>& rect, Common) noexcept {
  return exact::contact(exact::form(aabb), exact::form(rect));
}

}  // namespace vesica::detail::overlap
