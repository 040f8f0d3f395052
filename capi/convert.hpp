// SPDX-License-Identifier: Apache-2.0
// Between the C structs and the core's: the same numbers in the same order.
#pragma once

#include <bit>
#include <cstring>

#include <vesica/shapes.hpp>

#include "vesica.h"

namespace vesica::capi {

/// X(shape, Shape): every shape by its C and its C++ name, in the order of shapes.
#define VESICA_EACH_SHAPE(X) \
  X(point, Point) X(segment, Segment) X(circle, Circle) X(aabb, Aabb) X(rect, Rect) X(ellipse, Ellipse)

/// One shape from its flat numbers, which need no alignment.
template <class Shape>
Shape load(const void* numbers) noexcept {
  Shape shape;
  static_assert(sizeof(Shape) == ShapeTraits<Shape>::fields * sizeof(typename ShapeTraits<Shape>::Scalar));
  std::memcpy(&shape, numbers, sizeof shape);
  return shape;
}

inline bool is_kind(std::int32_t kind) noexcept { return kind >= 0 && kind < kind_count; }

/// Calls action with the shape that the kind and its numbers make.
template <class T, class Action>
std::int32_t with_shape(std::int32_t kind, const T* numbers, Action action) noexcept {
  if (numbers == nullptr) return VESICA_E_NULL;
  switch (kind) {
#define VESICA_CASE(name, Name) \
  case static_cast<std::int32_t>(Kind::name): return action(load<Name<T>>(numbers));
    VESICA_EACH_SHAPE(VESICA_CASE)
#undef VESICA_CASE
    default: return VESICA_E_KIND;
  }
}

}  // namespace vesica::capi
