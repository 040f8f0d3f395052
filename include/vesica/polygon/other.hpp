// SPDX-License-Identifier: Apache-2.0
/// Facts that a polygon's questions need of the other shape, if that is a row of numbers. src/polygon/ has the same
/// functions for a shape whose kind is known at run time only.
#pragma once

#include <type_traits>
#include <vesica/form/inflated.hpp>
#include <vesica/overlap.hpp>
#include <vesica/polygon/boxes.hpp>
#include <vesica/polygon/edges.hpp>

namespace vesica {

/// Pairs with a polygon or a polyline.
template <class A, class B>
concept AnyPath = Path<A> || Path<B>;

namespace detail::polygon {

/// c - extent and c + extent, where the extent is right to four roundings, or less than 2^-1060 off.
VESICA_INLINE Box around(double cx, double cy, double extent_x, double extent_y) noexcept {
  const double x = extent_x * (1 + 0x1p-49) + (lane::abs(cx) * 0x1p-51 + 0x1p-1060);
  const double y = extent_y * (1 + 0x1p-49) + (lane::abs(cy) * 0x1p-51 + 0x1p-1060);
  return {cx - x, cy - y, cx + x, cy + y};
}

/// A box that holds a valid shape, and is little larger than its bounds; an ellipse has its rectangle's.
VESICA_INLINE Box box_about(const Point<double>& s) noexcept { return {s.x, s.y, s.x, s.y}; }
VESICA_INLINE Box box_about(const Segment<double>& s) noexcept { return box_of(s); }
VESICA_INLINE Box box_about(const Circle<double>& s) noexcept { return around(s.cx, s.cy, s.r, s.r); }
VESICA_INLINE Box box_about(const Aabb<double>& s) noexcept { return s; }
VESICA_INLINE Box box_about(const Rect<double>& s) noexcept {
  const double ux = lane::abs(s.ux), uy = lane::abs(s.uy);
  return around(s.cx, s.cy, ux * s.hx + uy * s.hy, uy * s.hx + ux * s.hy);
}
VESICA_INLINE Box box_about(const Ellipse<double>& s) noexcept {
  return box_about(Rect<double>{s.cx, s.cy, s.ux, s.uy, s.a, s.b});
}
VESICA_INLINE Box box_about(const Capsule<double>& s) noexcept {
  const Box from = around(s.x0, s.y0, s.r, s.r), to = around(s.x1, s.y1, s.r, s.r);
  return {lesser(from.min_x, to.min_x), lesser(from.min_y, to.min_y), greater(from.max_x, to.max_x),
          greater(from.max_y, to.max_y)};
}
VESICA_INLINE Box box_about(const RoundRect<double>& s) noexcept {
  const double ux = lane::abs(s.ux), uy = lane::abs(s.uy);
  return around(s.cx, s.cy, ux * s.hx + uy * s.hy + s.r, uy * s.hx + ux * s.hy + s.r);
}

/// A stored point of a shape: its first two numbers.
template <template <class> class Shape>
VESICA_INLINE constexpr Point<double> stored_point(const Shape<double>& s) noexcept {
  return with_numbers(s, [](double x, double y, auto...) { return Point<double>{x, y}; });
}

template <template <class> class Shape>
constexpr bool is_point(const Shape<double>&) noexcept {
  return std::is_same_v<Shape<double>, Point<double>>;
}

template <template <class> class Shape>
VESICA_INLINE int check_other(const Shape<double>& s) noexcept {
  return vesica::check(s);
}

/// Is a shape valid? Then the box holds it.
template <class T>
bool is_valid(const Edges<T>& s, Box& box) noexcept {
  if (s.boxes() == nullptr) return s.check(box) == 0;
  box = s.boxes()->whole();
  return true;
}
template <class Other>
bool is_valid(const Other& s, Box& box) noexcept {
  if (check_other(s) != 0) return false;
  box = box_about(s);
  return true;
}

/// action(edges, other, reversed): the first path comes first, the other is edges or a shape of doubles.
template <class A, class B, class Action>
auto with_edges(const A& a, const B& b, Action action) noexcept {
  if constexpr (!Path<A>) {
    return action(Edges(b), widen(a), true);
  } else if constexpr (Path<B>) {
    return action(Edges(a), Edges(b), false);
  } else {
    return action(Edges(a), widen(b), false);
  }
}

/// Does an edge meet a valid shape?
template <template <class> class Shape>
VESICA_INLINE bool edge_meets(const Edge& e, const Shape<double>& s) noexcept {
  return vesica::overlap(e, s);
}

}  // namespace detail::polygon

}  // namespace vesica
