// SPDX-License-Identifier: Apache-2.0
/// A shape whose kind is known only at run time. The code for moving shapes is long and depends on the form alone, so
/// it exists once for all kinds.
#pragma once

#include <vesica/each_shape.hpp>
#include <vesica/shapes.hpp>

namespace vesica::detail::cast {

// For scalars; lanes of a vector bring the same names by argument-dependent lookup.
using namespace lane;
using lane::abs;
using lane::sqrt;

/// A kind and as many numbers as it has.
struct Body {
  Kind kind;
  double number[6];
};

template <class Shape>
VESICA_INLINE Body body(const Shape& s) noexcept {
  return with_numbers(s, [](auto... numbers) {
    return Body{ShapeTraits<Shape>::kind, {static_cast<double>(numbers)...}};
  });
}

template <template <class> class Shape>
VESICA_INLINE Shape<double> shape(const Body& body) noexcept {
  const double* const n = body.number;
  constexpr int fields = ShapeTraits<Shape<double>>::fields;
  if constexpr (fields == 2) {
    return {n[0], n[1]};
  } else if constexpr (fields == 3) {
    return {n[0], n[1], n[2]};
  } else if constexpr (fields == 4) {
    return {n[0], n[1], n[2], n[3]};
  } else {
    return {n[0], n[1], n[2], n[3], n[4], n[5]};
  }
}

/// The shape with its numbers in double, itself where they are.
template <template <class> class Shape, class T>
VESICA_INLINE decltype(auto) in_double(const Shape<T>& s) noexcept {
  if constexpr (std::is_same_v<T, double>) {
    return (s);
  } else {
    return shape<Shape>(body(s));
  }
}

/// action(shape) for the shape that the body is.
template <class Action>
VESICA_INLINE auto with_shape(const Body& body, const Action& action) noexcept {
  switch (body.kind) {
#define VESICA_CASE(name, Name) \
  case Kind::name:              \
    return action(shape<Name>(body));
    VESICA_EACH_SHAPE(VESICA_CASE)
#undef VESICA_CASE
  }
  return action(shape<Point>(body));
}

/// The second body moves by v t while t runs from 0 to `end`, which may be infinite.
template <class V>
struct MotionOf {
  V vx, vy, end;

  bool is_still() const noexcept { return vx == 0 && vy == 0; }
};
using Motion = MotionOf<double>;

}  // namespace vesica::detail::cast
