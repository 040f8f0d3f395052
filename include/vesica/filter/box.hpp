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

#if VESICA_HAS_TWO_DOUBLES
/// (u.d, u x d). For an AABB the compiler knows that uy is 0.
VESICA_INLINE TwoDoubles turned(const Box<double>& box, TwoDoubles d) noexcept {
  const TwoDoubles u(box.ux, box.uy), along = firsts(u, u) * d;
  if (__builtin_constant_p(box.uy) && box.uy == 0) return along;
  return along + flip_sign(seconds(u, u), TwoDoubles(0.0, -0.0)) * exchanged(d);
}
#endif

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
VESICA_INLINE constexpr V offset_of_ends(V a0, V a1, V b0, V b1) noexcept {
  return V(0.5f) * ((b0 - a0) + (b1 - a1));
}
template <class V>
VESICA_INLINE constexpr Centre<V> offset(const Corners<V>& a, const Corners<V>& b) noexcept {
  return {offset_of_ends<V>(a.x0, a.x1, b.x0, b.x1), offset_of_ends<V>(a.y0, a.y1, b.y0, b.y1)};
}
#if VESICA_HAS_TWO_DOUBLES
VESICA_INLINE Centre<double> offset(const Corners<double>& a, const Corners<double>& b) noexcept {
  const TwoDoubles d = offset_of_ends<TwoDoubles>({a.x0, a.y0}, {a.x1, a.y1}, {b.x0, b.y0}, {b.x1, b.y1});
  return {d.first(), d.second()};
}
#endif
template <class V>
VESICA_INLINE constexpr Centre<V> offset(const Corners<V>& a, const Centre<V>& b) noexcept {
  return offset(a, detail::form::corners(b));
}
template <class V>
VESICA_INLINE constexpr Centre<V> offset(const Centre<V>& a, const Corners<V>& b) noexcept {
  return offset(detail::form::corners(a), b);
}

}  // namespace vesica::filter
