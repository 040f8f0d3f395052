// SPDX-License-Identifier: Apache-2.0
/// Circle against ellipse: the contact cubic of two ellipses, simplified for a disc.
#pragma once

#include <vesica/exact/ellipse_ellipse.hpp>
#include <vesica/filter/contact_cubic.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Circle<V>& circle, const Ellipse<V>& ellipse) noexcept {
  return filter::circle_ellipse(circle, ellipse);
}

constexpr bool exact(const Circle<double>& circle, const Ellipse<double>& ellipse) noexcept {
  return exact::overlap(exact::form(circle), exact::form(ellipse));
}

}  // namespace vesica::detail::overlap
