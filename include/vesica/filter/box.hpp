// SPDX-License-Identifier: Apache-2.0
/// Shapes as the filters see them, by the mapping of form/form.hpp, and the offset between centres.
#pragma once

#include <vesica/filter/estimate.hpp>
#include <vesica/form/form.hpp>

namespace vesica::filter {

/// { s u + t perp(u) : |s| <= hx, |t| <= hy } about a centre that offset() knows.
/// Each number has a relative error of at most u.
template <class V>
struct Box {
  V ux, uy, hx, hy;
};

/// Any shape's axis and half sizes; those of a round shape are its half lengths.
template <template <class> class Shape, class V>
VESICA_INLINE constexpr Box<V> box(const Shape<V>& s) noexcept {
  constexpr detail::form::AsStored<V> number;
  const auto f = detail::form::of(s);
  return {number(f.ux), number(f.uy), number(f.hx), number(f.hy)};
}

using detail::form::Centre;
using detail::form::Corners;

/// The two end points of a segment or two corners of an AABB; a shape with a centre has it once.
template <class Shape>
VESICA_INLINE constexpr auto place(const Shape& s) noexcept {
  return detail::form::of(s).place;
}

/// Centre of b minus centre of a. Between two centres each coordinate has a relative error of u. With corners the
/// midpoint is never formed: differences of stored points come first, and |p0| + |p1| = max(|p0 + p1|, |p0 - p1|)
/// bounds the error of a coordinate by u (2 |d| + e), e the sum of the corner shapes' half extents along it.
template <class V>
VESICA_INLINE constexpr Centre<V> offset(const Centre<V>& a, const Centre<V>& b) noexcept {
  return {b.x - a.x, b.y - a.y};
}
template <class V>
VESICA_INLINE constexpr Centre<V> offset(const Corners<V>& a, const Centre<V>& b) noexcept {
  return {V(0.5f) * ((b.x - a.x0) + (b.x - a.x1)), V(0.5f) * ((b.y - a.y0) + (b.y - a.y1))};
}
template <class V>
VESICA_INLINE constexpr Centre<V> offset(const Centre<V>& a, const Corners<V>& b) noexcept {
  return {V(0.5f) * ((b.x0 - a.x) + (b.x1 - a.x)), V(0.5f) * ((b.y0 - a.y) + (b.y1 - a.y))};
}
template <class V>
VESICA_INLINE constexpr Centre<V> offset(const Corners<V>& a, const Corners<V>& b) noexcept {
  return {V(0.5f) * ((b.x0 - a.x0) + (b.x1 - a.x1)), V(0.5f) * ((b.y0 - a.y0) + (b.y1 - a.y1))};
}

}  // namespace vesica::filter
