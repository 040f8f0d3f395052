// SPDX-License-Identifier: Apache-2.0
/// Ellipses against ellipses and circles: the pencil of two conics.
#pragma once

#include <vesica/exact/relation.hpp>
#include <vesica/filter/nesting.hpp>

namespace vesica::detail::relation {

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Circle<V>& circle, const Ellipse<V>& ellipse) noexcept {
  return filter::circle_ellipse_certain_facts(circle, ellipse);
}

template <class V>
VESICA_INLINE constexpr auto certain_facts(const Ellipse<V>& a, const Ellipse<V>& b) noexcept {
  return filter::ellipse_ellipse_certain_facts(a, b);
}

}  // namespace vesica::detail::relation
