// SPDX-License-Identifier: Apache-2.0
/// A shape of the header-only core from its numbers.
#pragma once

#include <cstddef>
#include <utility>
#include <vesica/shapes.hpp>

#include "properties/pair.hpp"

namespace properties {

template <class Shape, class T>
Shape shape_of(const Numbers& n) {
  return [&]<std::size_t... k>(std::index_sequence<k...>) { return Shape{static_cast<T>(n[k])...}; }
  (std::make_index_sequence<vesica::ShapeTraits<Shape>::fields>{});
}

}  // namespace properties
