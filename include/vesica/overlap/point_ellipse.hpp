// SPDX-License-Identifier: Apache-2.0
/// Point against ellipse.
#pragma once

#include <vesica/exact/box_ellipse.hpp>
#include <vesica/filter/point_ellipse.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Point<V>& point, const Ellipse<V>& ellipse) noexcept {
  return filter::point_ellipse(ellipse, filter::offset(filter::place(ellipse), filter::place(point)));
}

constexpr int contact(const Point<double>& point, const Ellipse<double>& ellipse, Common) noexcept {
  const exact::Ellipse e = exact::form(ellipse);
  if (exact::degenerate(e)) return exact::contact(exact::form(point), exact::as_box(e));
  const exact::Length dx = exact::from_double(point.x) - e.cx, dy = exact::from_double(point.y) - e.cy;
  const auto along = square(e.b * exact::dot(e.ux, e.uy, dx, dy)),
             across = square(e.a * exact::cross(e.ux, e.uy, dx, dy));
  return compare(along + across, square(e.a * e.b * exact::dot(e.ux, e.uy, e.ux, e.uy)));
}

}  // namespace vesica::detail::overlap
