// SPDX-License-Identifier: Apache-2.0
/// Circle against AABB: is the disc's centre at most a radius from the box?
#pragma once

#include <vesica/exact/disc.hpp>
#include <vesica/filter/disc.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Circle<V>& circle, const Aabb<V>& aabb) noexcept {
  return filter::disc_aabb(circle, aabb);
}

constexpr int contact(const Circle<double>& circle, const Aabb<double>& aabb, Common) noexcept {
  return exact::contact_of_any(exact::form(aabb), circle);
}

}  // namespace vesica::detail::overlap
