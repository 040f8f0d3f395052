// SPDX-License-Identifier: Apache-2.0
/// Point against circle: at most a radius away.
#pragma once

#include <vesica/exact/disc.hpp>
#include <vesica/filter/disc.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Point<V>& point, const Circle<V>& circle) noexcept {
  return filter::point_disc(filter::offset(filter::place(point), filter::place(circle)), circle.r);
}

constexpr int contact(const Point<double>& point, const Circle<double>& circle, Common) noexcept {
  const exact::Length dx = exact::from_double(circle.cx) - exact::from_double(point.x);
  const exact::Length dy = exact::from_double(circle.cy) - exact::from_double(point.y);
  return exact::contact(dx, dy, exact::from_double(circle.r));
}

}  // namespace vesica::detail::overlap
