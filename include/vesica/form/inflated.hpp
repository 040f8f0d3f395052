// SPDX-License-Identifier: Apache-2.0
/// Shapes as a core with a radius: the points at most the radius from a point, a segment, an AABB or a rectangle. They
/// overlap iff their cores are at most the sum of both radii apart. A shape without a radius is its own core.
#pragma once

#include <vesica/shapes.hpp>

namespace vesica::detail::form {

template <template <class> class Core, class V>
struct CoreAndRadius {
  Core<V> core;
  V radius;
};

template <template <class> class Shape, class V>
VESICA_INLINE constexpr CoreAndRadius<Shape, V> inflated(const Shape<V>& s) noexcept {
  return {s, V(0.0f)};
}
template <class V>
VESICA_INLINE constexpr CoreAndRadius<Point, V> inflated(const Circle<V>& s) noexcept {
  return {{s.cx, s.cy}, s.r};
}
template <class V>
VESICA_INLINE constexpr CoreAndRadius<Segment, V> inflated(const Capsule<V>& s) noexcept {
  return {{s.x0, s.y0, s.x1, s.y1}, s.r};
}
template <class V>
VESICA_INLINE constexpr CoreAndRadius<Rect, V> inflated(const RoundRect<V>& s) noexcept {
  return {{s.cx, s.cy, s.ux, s.uy, s.hx, s.hy}, s.r};
}

template <class Shape>
inline constexpr bool is_inflated = false;
#define VESICA_INFLATED(name, Name) \
  template <class V>                \
  inline constexpr bool is_inflated<Name<V>> = true;
VESICA_EACH_SHAPE_INFLATED(VESICA_INFLATED)
#undef VESICA_INFLATED

template <class Shape>
concept Inflated = is_inflated<Shape>;

}  // namespace vesica::detail::form
