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

/// action(shape), by the kind of fewest numbers that has the same points: without a radius its core, without a size a
/// circle.
template <class Shape, class Action>
VESICA_INLINE constexpr auto with_simplest(const Shape& s, const Action& action) noexcept {
  return action(s);
}
template <class V, class Action>
VESICA_INLINE constexpr auto with_simplest(const Capsule<V>& s, const Action& action) noexcept {
  if (s.r == 0) return action(inflated(s).core);
  return s.x0 == s.x1 && s.y0 == s.y1 ? action(Circle<V>{s.x0, s.y0, s.r}) : action(s);
}
template <class V, class Action>
VESICA_INLINE constexpr auto with_simplest(const RoundRect<V>& s, const Action& action) noexcept {
  if (s.r == 0) return action(inflated(s).core);
  return s.hx == 0 && s.hy == 0 ? action(Circle<V>{s.cx, s.cy, s.r}) : action(s);
}

}  // namespace vesica::detail::form
