// SPDX-License-Identifier: Apache-2.0
/// Shapes as workloads make them (a kind and its numbers in double) and as a benchmark's buffers hold them.
#pragma once

#include <vesica.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vesica/each_shape.hpp>
#include <vesica/shapes.hpp>

namespace vesica::bench {

/// The numbers of one shape in the shape's order; those beyond its field count are 0.
using Numbers = std::array<double, 7>;

/// The kind and scalar type of a typed C struct.
template <class Scalar_, std::int32_t kind_>
struct Description {
  using Scalar = Scalar_;
  static constexpr std::int32_t kind = kind_;
};

template <class Shape>
struct Described;

#define VESICA_DESCRIBED(name, Name)                                                                               \
  template <>                                                                                                      \
  struct Described<vesica_##name##_f64> : Description<double, static_cast<std::int32_t>(::vesica::Kind::name)> {}; \
  template <>                                                                                                      \
  struct Described<vesica_##name##_f32> : Description<float, static_cast<std::int32_t>(::vesica::Kind::name)> {};
VESICA_EACH_SHAPE(VESICA_DESCRIBED)
#undef VESICA_DESCRIBED

template <class Shape>
constexpr std::int32_t kind_of = Described<Shape>::kind;

template <class Shape>
constexpr const char* scalar_name = std::is_same_v<typename Described<Shape>::Scalar, double> ? "f64" : "f32";

/// The numbers as a typed struct, rounded to its scalar.
template <class Shape>
Shape to_shape(const Numbers& numbers) {
  using Scalar = typename Described<Shape>::Scalar;
  constexpr std::size_t fields = sizeof(Shape) / sizeof(Scalar);
  std::array<Scalar, fields> rounded{};
  for (std::size_t i = 0; i < fields; ++i) rounded[i] = static_cast<Scalar>(numbers[i]);
  Shape shape;
  std::memcpy(&shape, rounded.data(), sizeof shape);
  return shape;
}

/// A shape about (x, y) with the axis (c, s) and half sizes a and b, of which its kind takes what it has. A radius
/// beside a core is half of b.
inline Numbers shape_about(std::int32_t kind, double x, double y, double c, double s, double a, double b) {
  switch (kind) {
    case VESICA_POINT:
      return {x, y};
    case VESICA_SEGMENT:
      return {x - a * c, y - a * s, x + a * c, y + a * s};
    case VESICA_CIRCLE:
      return {x, y, a};
    case VESICA_AABB:
      return {x - a, y - b, x + a, y + b};
    case VESICA_CAPSULE:
      return {x - a * c, y - a * s, x + a * c, y + a * s, b / 2};
    case VESICA_ROUND_RECT:
      return {x, y, c, s, a, b, b / 2};
    default:
      return {x, y, c, s, a, b};
  }
}

}  // namespace vesica::bench
