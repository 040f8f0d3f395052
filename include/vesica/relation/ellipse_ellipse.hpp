// SPDX-License-Identifier: Apache-2.0
/// Ellipses against ellipses and circles: the pencil of two conics.
#pragma once

#include <vesica/exact/relation.hpp>
#include <vesica/filter/nesting.hpp>

namespace vesica::pair {

template <class V>
VESICA_INLINE auto standing(const Circle<V>& circle, const Ellipse<V>& ellipse) noexcept {
  return filter::circle_ellipse_standing(circle, ellipse);
}

template <class V>
VESICA_INLINE auto standing(const Ellipse<V>& a, const Ellipse<V>& b) noexcept {
  return filter::ellipse_ellipse_standing(a, b);
}

}  // namespace vesica::pair
