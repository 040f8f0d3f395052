// SPDX-License-Identifier: Apache-2.0
/// A shape whose kind is known only at run time. The code for moving shapes is long and depends on the form alone, so
/// it exists once for all kinds.
#pragma once

#include <utility>
#include <vesica/each_shape.hpp>
#include <vesica/shapes.hpp>

namespace vesica::detail::cast {

// For scalars; lanes of a vector bring the same names by argument-dependent lookup.
using namespace lane;
using lane::abs;
using lane::sqrt;

/// The kind of a shape with a form, and as many numbers as it has.
struct Body {
  Kind kind;
  double number[max_fields];
};

template <class Shape>
VESICA_INLINE Body body(const Shape& s) noexcept {
  return with_numbers(s, [](auto... numbers) {
    return Body{ShapeTraits<Shape>::kind, {static_cast<double>(numbers)...}};
  });
}

template <template <class> class Shape>
VESICA_INLINE Shape<double> shape(const Body& body) noexcept {
  return [&]<std::size_t... field>(std::index_sequence<field...>) { return Shape<double>{body.number[field]...}; }
  (std::make_index_sequence<ShapeTraits<Shape<double>>::fields>{});
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
    VESICA_EACH_SHAPE_WITH_FORM(VESICA_CASE)
#undef VESICA_CASE
#define VESICA_CASE(name, Name) case Kind::name:
    VESICA_EACH_SHAPE_INFLATED(VESICA_CASE)
    VESICA_EACH_SHAPE_WITHOUT_FORM(VESICA_CASE)
#undef VESICA_CASE
    break;
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
