// SPDX-License-Identifier: Apache-2.0
/// A shape of the header-only core from its numbers.
#pragma once

#include <vesica/shapes.hpp>

#include "properties/pair.hpp"

namespace properties {

template <class Shape, class T>
Shape shape_of(const Numbers& n) {
  constexpr int fields = vesica::ShapeTraits<Shape>::fields;
  if constexpr (fields == 2) {
    return {static_cast<T>(n[0]), static_cast<T>(n[1])};
  } else if constexpr (fields == 3) {
    return {static_cast<T>(n[0]), static_cast<T>(n[1]), static_cast<T>(n[2])};
  } else if constexpr (fields == 4) {
    return {static_cast<T>(n[0]), static_cast<T>(n[1]), static_cast<T>(n[2]), static_cast<T>(n[3])};
  } else {
    return {static_cast<T>(n[0]), static_cast<T>(n[1]), static_cast<T>(n[2]),
            static_cast<T>(n[3]), static_cast<T>(n[4]), static_cast<T>(n[5])};
  }
}

}  // namespace properties
