// SPDX-License-Identifier: Apache-2.0
/// A shape whose kind is known only at run time. The code for moving shapes is long and depends on the form alone, so
/// it exists once for all kinds.
#pragma once

#include <utility>
#include <vesica/check.hpp>
#include <vesica/each_shape.hpp>
#include <vesica/form/inflated.hpp>

namespace vesica::detail::cast {

// For scalars; lanes of a vector bring the same names by argument-dependent lookup.
using namespace lane;
using lane::abs;
using lane::sqrt;

/// A shape's kind, and as many numbers as it has. With a radius it is the core of a shape (form/inflated.hpp).
struct Body {
  Kind kind;
  double number[max_fields];
  double radius = 0;
};

template <class Shape>
VESICA_INLINE Body body(const Shape& s) noexcept {
  return with_numbers(s, [](auto... numbers) {
    return Body{ShapeTraits<Shape>::kind, {static_cast<double>(numbers)...}, 0};
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

/// action(shape) for the shape that the body is, which has a form.
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

constexpr bool is_inflated(Kind kind) noexcept {
#define VESICA_CASE(name, Name) \
  if (kind == Kind::name) return true;
  VESICA_EACH_SHAPE_INFLATED(VESICA_CASE)
#undef VESICA_CASE
  return false;
}

/// A core with its radius, but a circle or a core alone where the shape is no more.
template <class Shape>
Body core_of(const Shape& s) noexcept {
  if (check(s) != 0) return body(Circle<double>{0, 0, -1});
  Body out{};
  form::with_simplest(s, [&out](const auto& simplest) {
    const auto [core, radius] = form::inflated(simplest);
    if constexpr (form::Inflated<std::remove_cvref_t<decltype(simplest)>>) {
      out = body(core);
      out.radius = radius;
    } else {
      out = body(simplest);
    }
  });
  return out;
}
inline Body core_of(const Body& b) noexcept {
#define VESICA_CASE(name, Name) \
  if (b.kind == Kind::name) return core_of(shape<Name>(b));
  VESICA_EACH_SHAPE_INFLATED(VESICA_CASE)
#undef VESICA_CASE
  return b;
}

/// A pair as the functions of casts take it: kinds with a form, and circles as points with a radius where the pair has
/// a radius at all. An invalid shape with a radius becomes an invalid circle.
struct Cores {
  Body a, b;

  Cores(const Body& first, const Body& second) noexcept : a(core_of(first)), b(core_of(second)) {
    if (!(a.radius > 0 || b.radius > 0)) return;
    for (Body* body : {&a, &b}) {
      if (body->kind == Kind::circle) *body = {Kind::point, {body->number[0], body->number[1]}, body->number[2]};
    }
  }
};

/// The second body moves by v t while t runs from 0 to `end`, which may be infinite.
template <class V>
struct MotionOf {
  V vx, vy, end;

  bool is_still() const noexcept { return vx == 0 && vy == 0; }
};
using Motion = MotionOf<double>;

}  // namespace vesica::detail::cast
