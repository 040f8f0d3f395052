// SPDX-License-Identifier: Apache-2.0
/// Segment against segment: separating axes.
#pragma once

#include <vesica/exact/box_box.hpp>
#include <vesica/filter/box_box.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Segment<V>& a, const Segment<V>& b) noexcept {
  return filter::box_box(filter::box(a), filter::box(b), filter::offset(filter::place(a), filter::place(b)));
}

constexpr int contact(const Segment<double>& a, const Segment<double>& b, Common) noexcept {
  return exact::contact(exact::form(a), exact::form(b));
}

}  // namespace vesica::detail::overlap
