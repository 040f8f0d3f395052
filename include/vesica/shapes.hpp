// SPDX-License-Identifier: Apache-2.0
/// The shapes, their order, and the flat numbers they are made of.
#pragma once

#include <cstdint>
#include <vesica/each_shape.hpp>
#include <vesica/scalar.hpp>

namespace vesica {

/// All shapes are closed and solid: their outline and what it encloses belong to them. A shape is exactly what its
/// stored numbers say. An axis (ux, uy) is a direction and a unit of length, never renormalised;
/// perp(u) = (-uy, ux). Members stand in the order of the C structs, which these equal byte for byte.

/// A location.
template <class T>
struct Point {
  T x, y;
};

/// All points between two end points. Equal end points make it a point.
template <class T>
struct Segment {
  T x0, y0, x1, y1;
};

/// A disc: centre and radius r >= 0.
template <class T>
struct Circle {
  T cx, cy, r;
};

/// A box along the coordinate axes: min_x <= max_x, min_y <= max_y.
template <class T>
struct Aabb {
  T min_x, min_y, max_x, max_y;
};

/// { C + s u + t perp(u) : |s| <= hx, |t| <= hy }; hx, hy >= 0, u != 0.
template <class T>
struct Rect {
  T cx, cy, ux, uy, hx, hy;
};

/// { C + s u + t perp(u) : (s/a)^2 + (t/b)^2 <= 1 }; a, b >= 0, u != 0. With a or b zero it is a segment or a point.
template <class T>
struct Ellipse {
  T cx, cy, ux, uy, a, b;
};

/// The points at most r >= 0 from a segment. Equal end points make it a circle.
template <class T>
struct Capsule {
  T x0, y0, x1, y1, r;
};

/// The points at most r >= 0 from a rectangle: one with round corners. hx and hy are in units of the axis, as in Rect,
/// and do not include the radius, which is a length as those of coordinates are.
template <class T>
struct RoundRect {
  T cx, cy, ux, uy, hx, hy, r;
};

/// Kinds in the order of the list, from 0. A pair function exists once, with its shapes in this order.
#define VESICA_KIND(name, Name) name,
enum class Kind : std::int32_t { VESICA_EACH_SHAPE(VESICA_KIND) };
#undef VESICA_KIND

#define VESICA_KIND(name, Name) +1
inline constexpr int kind_count = VESICA_EACH_SHAPE(VESICA_KIND);
#undef VESICA_KIND

/// Result codes, as the C interface returns them.
enum Error : std::int32_t {
  error_null = -1,
  error_shape = -2,
  error_kind = -3,
  error_argument = -4,
  error_not_finite = -5,
  error_negative_size = -6,
  error_zero_axis = -7,
  error_inverted = -8,
  error_range = -9,
  error_rings = -11,  // -10 is of an index
  error_not_convex = -13,
};

/// The kind of a shape template.
template <template <class> class Shape>
inline constexpr Kind kind_of = Kind{-1};
#define VESICA_SET_KIND(name, Name) \
  template <>                       \
  inline constexpr Kind kind_of<Name> = Kind::name;
VESICA_EACH_SHAPE(VESICA_SET_KIND)
#undef VESICA_SET_KIND

/// Properties of a shape type: its kind, its scalar, how many numbers it has.
template <class Shape>
struct ShapeTraits;
template <template <class> class Shape, class T>
struct ShapeTraits<Shape<T>> {
  using Scalar = T;
  static constexpr Kind kind = kind_of<Shape>;
  static constexpr int fields = sizeof(Shape<T>) / sizeof(T);
};

/// How many numbers a shape of each kind has, and the most.
#define VESICA_FIELDS(name, Name) ShapeTraits<Name<double>>::fields,
inline constexpr int fields_of_kind[] = {VESICA_EACH_SHAPE(VESICA_FIELDS)};
#undef VESICA_FIELDS
inline constexpr int max_fields = [] {
  int most = 0;
  for (const int fields : fields_of_kind) most = fields > most ? fields : most;
  return most;
}();

namespace detail {

/// Calls action with a shape's numbers in their order.
template <class Shape, class Action>
VESICA_INLINE constexpr auto with_numbers(const Shape& s, Action action) noexcept {
  constexpr int fields = ShapeTraits<Shape>::fields;
  if constexpr (fields == 2) {
    const auto& [p, q] = s;
    return action(p, q);
  } else if constexpr (fields == 3) {
    const auto& [p, q, r] = s;
    return action(p, q, r);
  } else if constexpr (fields == 4) {
    const auto& [p, q, r, t] = s;
    return action(p, q, r, t);
  } else if constexpr (fields == 5) {
    const auto& [p, q, r, t, u] = s;
    return action(p, q, r, t, u);
  } else if constexpr (fields == 6) {
    const auto& [p, q, r, t, u, v] = s;
    return action(p, q, r, t, u, v);
  } else {
    const auto& [p, q, r, t, u, v, w] = s;
    return action(p, q, r, t, u, v, w);
  }
}

}  // namespace detail

/// The same shape in double. A float is a double exactly, so scalar queries on float shapes are answered on these.
constexpr double widen(float x) noexcept { return static_cast<double>(x); }
template <template <class> class Shape>
constexpr const Shape<double>& widen(const Shape<double>& s) noexcept {
  return s;
}
template <template <class> class Shape>
VESICA_INLINE constexpr Shape<double> widen(const Shape<float>& s) noexcept {
  return detail::with_numbers(s, [](auto... numbers) { return Shape<double>{widen(numbers)...}; });
}

}  // namespace vesica
