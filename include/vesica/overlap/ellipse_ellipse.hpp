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

#if VESICA_HAS_TWO_DOUBLES
/// Two filters: the first decides most pairs.
VESICA_INLINE auto first_filter(const Ellipse<double>& a, const Ellipse<double>& b) noexcept {
  return filter::look_at_ellipses(a, b, filter::offset(filter::place(a), filter::place(b)));
}
VESICA_INLINE auto second_filter(const Ellipse<double>& a, const Ellipse<double>& b) noexcept {
  return filter::by_cubic(a, b);
}
VESICA_INLINE filter::DecidedVerdict<bool> filter(const Ellipse<double>& a, const Ellipse<double>& b) noexcept {
  const auto look = first_filter(a, b);
  return look.decided ? look : second_filter(a, b);
}
#endif

constexpr int contact(const Ellipse<double>& a, const Ellipse<double>& b, Common common) noexcept {
  return exact::contact(exact::form(a), exact::form(b), common);
}

}  // namespace vesica::detail::overlap
