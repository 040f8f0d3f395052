// SPDX-License-Identifier: Apache-2.0
/// Overlapping shapes of depth 0, exactly: is the offset of centres on the outline of their Minkowski sum?
#pragma once

#include <vesica/exact/relation.hpp>

namespace vesica::exact {

namespace detail {

/// Of a box without area, along its length.
struct Line {
  Length x, y;
};
inline Line line(const Box& flat) noexcept {
  if (flat.hx.sign != 0) return {flat.ux, flat.uy};
  return {integer(-1) * flat.uy, flat.ux};
}

inline bool has_no_length(const Box& box) noexcept { return box.hx.sign == 0 && box.hy.sign == 0; }
inline bool has_no_area(const Box& box) noexcept { return box.hx.sign == 0 || box.hy.sign == 0; }

/// Whether the Minkowski sum of two boxes has no area: then all of it is outline. Degree 2.
inline bool sum_is_flat(const Box& a, const Box& b) noexcept {
  if (!has_no_area(a) || !has_no_area(b)) return false;
  if (has_no_length(a) || has_no_length(b)) return true;
  const Line m = line(a), n = line(b);
  return cross(m.x, m.y, n.x, n.y).sign == 0;
}

}  // namespace detail

/// For shapes that overlap. contact() asks for the sum's relative inside, which with area is its inside.
inline bool has_no_depth(const Box& a, const Box& b) noexcept {
  return detail::sum_is_flat(a, b) || contact(a, b) == 0;
}
inline bool has_no_depth(const Box& a, const Ellipse& b) noexcept {
  return degenerate(b) ? has_no_depth(a, as_box(b)) : contact(a, b) == 0;
}
inline bool has_no_depth(const Ellipse& a, const Box& b) noexcept { return has_no_depth(b, a); }
inline bool has_no_depth(const Ellipse& a, const Ellipse& b) noexcept {
  if (degenerate(a)) return has_no_depth(as_box(a), b);
  if (degenerate(b)) return has_no_depth(a, as_box(b));
  return relation(a, b) == Relation::touch;
}

}  // namespace vesica::exact
