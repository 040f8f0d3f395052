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

#if VESICA_HAS_TWO_DOUBLES
/// Two filters: the first decides most pairs.
VESICA_INLINE auto first_filter(const Circle<double>& circle, const Ellipse<double>& ellipse) noexcept {
  return filter::look_at_ellipses(circle, ellipse, filter::offset(filter::place(circle), filter::place(ellipse)));
}
VESICA_INLINE auto second_filter(const Circle<double>& circle, const Ellipse<double>& ellipse) noexcept {
  return filter::by_cubic(circle, ellipse);
}
VESICA_INLINE filter::DecidedVerdict<bool> filter(const Circle<double>& circle,
                                                  const Ellipse<double>& ellipse) noexcept {
  const auto look = first_filter(circle, ellipse);
  return look.decided ? look : second_filter(circle, ellipse);
}
#endif

constexpr int contact(const Circle<double>& circle, const Ellipse<double>& ellipse, Common common) noexcept {
  return exact::contact(exact::form(circle), exact::form(ellipse), common);
}

}  // namespace vesica::detail::overlap
