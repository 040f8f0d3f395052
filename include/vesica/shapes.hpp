// SPDX-License-Identifier: Apache-2.0
/// The six shapes, their order, and the flat numbers they are made of.
#pragma once

#include <cstdint>
#include <vesica/scalar.hpp>

namespace vesica {

/// All shapes are closed and solid: they own their outline and what it encloses. A shape is exactly what its
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

/// Kinds in the order of shapes: a pair function exists once, with its shapes in this order.
enum class Kind : std::int32_t { point = 0, segment = 1, circle = 2, aabb = 3, rect = 4, ellipse = 5 };

inline constexpr int kind_count = 6;

/// Result codes, as the C face returns them.
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
};

/// What a shape type is: its kind, its scalar, how many numbers it has.
template <class Shape>
struct ShapeTraits;

template <class T>
struct ShapeTraits<Point<T>> {
  using Scalar = T;
  static constexpr Kind kind = Kind::point;
  static constexpr int fields = 2;
};
template <class T>
struct ShapeTraits<Segment<T>> {
  using Scalar = T;
  static constexpr Kind kind = Kind::segment;
  static constexpr int fields = 4;
};
template <class T>
struct ShapeTraits<Circle<T>> {
  using Scalar = T;
  static constexpr Kind kind = Kind::circle;
  static constexpr int fields = 3;
};
template <class T>
struct ShapeTraits<Aabb<T>> {
  using Scalar = T;
  static constexpr Kind kind = Kind::aabb;
  static constexpr int fields = 4;
};
template <class T>
struct ShapeTraits<Rect<T>> {
  using Scalar = T;
  static constexpr Kind kind = Kind::rect;
  static constexpr int fields = 6;
};
template <class T>
struct ShapeTraits<Ellipse<T>> {
  using Scalar = T;
  static constexpr Kind kind = Kind::ellipse;
  static constexpr int fields = 6;
};

// A float is a double exactly, so scalar queries on float shapes are answered on these.
constexpr double widen(float x) noexcept { return static_cast<double>(x); }
template <template <class> class Shape>
constexpr const Shape<double>& widen(const Shape<double>& s) noexcept {
  return s;
}
constexpr Point<double> widen(const Point<float>& s) noexcept { return {widen(s.x), widen(s.y)}; }
constexpr Segment<double> widen(const Segment<float>& s) noexcept {
  return {widen(s.x0), widen(s.y0), widen(s.x1), widen(s.y1)};
}
constexpr Circle<double> widen(const Circle<float>& s) noexcept { return {widen(s.cx), widen(s.cy), widen(s.r)}; }
constexpr Aabb<double> widen(const Aabb<float>& s) noexcept {
  return {widen(s.min_x), widen(s.min_y), widen(s.max_x), widen(s.max_y)};
}
constexpr Rect<double> widen(const Rect<float>& s) noexcept {
  return {widen(s.cx), widen(s.cy), widen(s.ux), widen(s.uy), widen(s.hx), widen(s.hy)};
}
constexpr Ellipse<double> widen(const Ellipse<float>& s) noexcept {
  return {widen(s.cx), widen(s.cy), widen(s.ux), widen(s.uy), widen(s.a), widen(s.b)};
}

}  // namespace vesica
