// SPDX-License-Identifier: Apache-2.0
/// Circle against circle: centres at most the sum of the radii apart.
#pragma once

#include <vesica/exact/disc.hpp>
#include <vesica/filter/disc.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Circle<V>& a, const Circle<V>& b) noexcept {
  return filter::disc_disc(filter::offset(filter::place(a), filter::place(b)), a.r, b.r);
}

constexpr int contact(const Circle<double>& a, const Circle<double>& b, Common) noexcept {
  const exact::Length dx = exact::from_double(b.cx) - exact::from_double(a.cx);
  const exact::Length dy = exact::from_double(b.cy) - exact::from_double(a.cy);
  return exact::contact(dx, dy, exact::from_double(a.r) + exact::from_double(b.r));
}

}  // namespace vesica::detail::overlap
