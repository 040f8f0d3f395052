// SPDX-License-Identifier: Apache-2.0
/// AABB against ellipse: do the edges that the ellipse can see miss it?
#pragma once

#include <vesica/exact/box_ellipse.hpp>
#include <vesica/filter/box_ellipse.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Aabb<V>& aabb, const Ellipse<V>& ellipse) noexcept {
  return filter::box_ellipse(filter::box(aabb), ellipse, filter::offset(filter::place(aabb), filter::place(ellipse)));
}

constexpr int contact(const Aabb<double>& aabb, const Ellipse<double>& ellipse, Common common) noexcept {
  return exact::contact(exact::form(aabb), exact::form(ellipse), common);
}

}  // namespace vesica::detail::overlap
