// SPDX-License-Identifier: Apache-2.0
/// Rectangle against rectangle: separating axes.
#pragma once

#include <vesica/exact/box_box.hpp>
#include <vesica/filter/box_box.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Rect<V>& a, const Rect<V>& b) noexcept {
  return filter::box_box(filter::box(a), filter::box(b), filter::offset(filter::place(a), filter::place(b)));
}

constexpr int contact(const Rect<double>& a, const Rect<double>& b, Common) noexcept {
  return exact::contact(exact::form(a), exact::form(b));
}

}  // namespace vesica::detail::overlap
