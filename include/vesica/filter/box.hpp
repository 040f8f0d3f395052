// SPDX-License-Identifier: Apache-2.0
/// Rectangles, AABBs and segments as one form for the filters, and the offset between centres.
#pragma once

#include <vesica/filter/estimate.hpp>

namespace vesica::filter {

/// { s u + t perp(u) : |s| <= hx, |t| <= hy } about a centre that offset() knows.
/// Each number has a relative error of at most u.
template <class V>
struct Box {
  V ux, uy, hx, hy;
};

template <class V>
VESICA_INLINE Box<V> box(const Rect<V>& s) noexcept {
  return {s.ux, s.uy, s.hx, s.hy};
}

/// With an axis of length 1/2 the half extents are the widths, and nothing is halved: min > max shows as a negative
/// size even among subnormals.
template <class V>
VESICA_INLINE Box<V> box(const Aabb<V>& s) noexcept {
  return {V(0.5f), V(0.0f), s.max_x - s.min_x, s.max_y - s.min_y};
}

template <class V>
VESICA_INLINE Box<V> box(const Segment<V>& s) noexcept {
  return {s.x1 - s.x0, s.y1 - s.y0, V(0.5f), V(0.0f)};
}

/// The two end points of a segment or two corners of an AABB; a shape with a centre has it once.
template <class V>
struct Corners {
  V x0, y0, x1, y1;
};
template <class V>
struct Centre {
  V x, y;
};

template <class V>
VESICA_INLINE Corners<V> place(const Segment<V>& s) noexcept {
  return {s.x0, s.y0, s.x1, s.y1};
}
template <class V>
VESICA_INLINE Corners<V> place(const Aabb<V>& s) noexcept {
  return {s.min_x, s.min_y, s.max_x, s.max_y};
}
template <class V>
VESICA_INLINE Centre<V> place(const Point<V>& s) noexcept {
  return {s.x, s.y};
}
template <class V>
VESICA_INLINE Centre<V> place(const Circle<V>& s) noexcept {
  return {s.cx, s.cy};
}
template <class V>
VESICA_INLINE Centre<V> place(const Rect<V>& s) noexcept {
  return {s.cx, s.cy};
}
template <class V>
VESICA_INLINE Centre<V> place(const Ellipse<V>& s) noexcept {
  return {s.cx, s.cy};
}

/// Centre of b minus centre of a. Between two centres each coordinate has a relative error of u. With corners the
/// midpoint is never formed: differences of stored points come first, and |p0| + |p1| = max(|p0 + p1|, |p0 - p1|)
/// bounds the error of a coordinate by u (2 |d| + e), e the sum of the corner shapes' half extents along it.
template <class V>
VESICA_INLINE Centre<V> offset(const Centre<V>& a, const Centre<V>& b) noexcept {
  return {b.x - a.x, b.y - a.y};
}
template <class V>
VESICA_INLINE Centre<V> offset(const Corners<V>& a, const Centre<V>& b) noexcept {
  return {V(0.5f) * ((b.x - a.x0) + (b.x - a.x1)), V(0.5f) * ((b.y - a.y0) + (b.y - a.y1))};
}
template <class V>
VESICA_INLINE Centre<V> offset(const Centre<V>& a, const Corners<V>& b) noexcept {
  return {V(0.5f) * ((b.x0 - a.x) + (b.x1 - a.x)), V(0.5f) * ((b.y0 - a.y) + (b.y1 - a.y))};
}
template <class V>
VESICA_INLINE Centre<V> offset(const Corners<V>& a, const Corners<V>& b) noexcept {
  return {V(0.5f) * ((b.x0 - a.x0) + (b.x1 - a.x1)), V(0.5f) * ((b.y0 - a.y0) + (b.y1 - a.y1))};
}

}  // namespace vesica::filter
