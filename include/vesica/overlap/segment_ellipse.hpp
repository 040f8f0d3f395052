// SPDX-License-Identifier: Apache-2.0
/// Segment against ellipse: do the edges that the ellipse can see miss it?
#pragma once

#include <vesica/exact/box_ellipse.hpp>
#include <vesica/filter/box_ellipse.hpp>

namespace vesica::detail::overlap {

template <class V>
VESICA_INLINE constexpr auto filter(const Segment<V>& segment, const Ellipse<V>& ellipse) noexcept {
  return filter::box_ellipse(filter::box(segment), ellipse,
                             filter::offset(filter::place(segment), filter::place(ellipse)));
}

constexpr int contact(const Segment<double>& segment, const Ellipse<double>& ellipse, Common common) noexcept {
  return exact::contact(exact::form(segment), exact::form(ellipse), common);
}

}  // namespace vesica::detail::overlap
