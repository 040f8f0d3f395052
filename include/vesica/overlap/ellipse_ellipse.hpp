// SPDX-License-Identifier: Apache-2.0
/// Ellipse against ellipse: the sign of the contact cubic's minimum.
#pragma once

#include <vesica/exact/ellipse_ellipse.hpp>
#include <vesica/filter/contact_cubic.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Ellipse<V>& a, const Ellipse<V>& b) noexcept {
  return filter::ellipse_ellipse(a, b);
}

constexpr bool exact(const Ellipse<double>& a, const Ellipse<double>& b) noexcept {
  return exact::overlap(exact::form(a), exact::form(b));
}

}  // namespace vesica::detail::overlap
