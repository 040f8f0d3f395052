// SPDX-License-Identifier: Apache-2.0
/// Overlapping shapes of depth 0, exactly: is the offset of centres on the outline of their Minkowski sum?
#pragma once

#include <cstdint>
#include <vesica/exact/relation.hpp>

namespace vesica::detail::depth {

/// The direction of a box without area, along its length.
struct Line {
  exact::Length x, y;
};
inline Line line(const exact::Box& flat) noexcept {
  if (flat.hx.sign != 0) return {flat.ux, flat.uy};
  return {exact::integer(-1) * flat.uy, flat.ux};
}

inline bool has_no_length(const exact::Box& box) noexcept { return box.hx.sign == 0 && box.hy.sign == 0; }
inline bool has_no_area(const exact::Box& box) noexcept { return box.hx.sign == 0 || box.hy.sign == 0; }

/// True if the Minkowski sum of two boxes has no area: then all of it is outline. Degree 2.
inline bool sum_is_flat(const exact::Box& a, const exact::Box& b) noexcept {
  if (!has_no_area(a) || !has_no_area(b)) return false;
  if (has_no_length(a) || has_no_length(b)) return true;
  const Line m = line(a), n = line(b);
  return exact::cross(m.x, m.y, n.x, n.y).sign == 0;
}

/// Disjoint, overlapping, or overlapping with a depth known to be 0 or positive.
enum class Overlap : std::int32_t { none, some, some_without_depth, some_with_depth };

/// Both questions at once: they cost no more than the first. contact() asks for the sum's relative inside, which with
/// area is its inside.
inline Overlap overlap_and_depth(const exact::Box& a, const exact::Box& b) noexcept {
  const int gap = contact(a, b);
  if (gap > 0) return Overlap::none;
  return gap == 0 || sum_is_flat(a, b) ? Overlap::some_without_depth : Overlap::some_with_depth;
}
inline Overlap overlap_and_depth(const exact::Box& a, const exact::Ellipse& b) noexcept {
  if (degenerate(b)) return overlap_and_depth(a, as_box(b));
  const int gap = contact(a, b);
  return gap > 0 ? Overlap::none : gap == 0 ? Overlap::some_without_depth : Overlap::some_with_depth;
}

inline Overlap overlap_and_depth(const exact::Ellipse& a, const exact::Box& b) noexcept {
  return overlap_and_depth(b, a);
}

/// As exact::overlap and exact::relation decide it, neither degenerate. Never inlined: its numbers would stay on its
/// callers' stacks.
VESICA_CALLED inline Overlap overlap_and_depth_by_cubic(const exact::Ellipse& a, const exact::Ellipse& b) noexcept {
  const exact::Cubic p = exact::cubic(a, b);
  const int roots = p.c1.sign < 0 || p.c2.sign < 0 ? exact::discriminant_sign(p) : -1;
  return roots > 0 ? Overlap::none : roots == 0 ? Overlap::some_without_depth : Overlap::some_with_depth;
}
/// The same, either degenerate. Never inlined, for the boxes.
VESICA_CALLED inline Overlap overlap_and_depth_of_degenerate(const exact::Ellipse& a,
                                                             const exact::Ellipse& b) noexcept {
  return degenerate(a) ? overlap_and_depth(as_box(a), b) : overlap_and_depth(as_box(b), a);
}
inline Overlap overlap_and_depth(const exact::Ellipse& a, const exact::Ellipse& b) noexcept {
  return degenerate(a) || degenerate(b) ? overlap_and_depth_of_degenerate(a, b) : overlap_and_depth_by_cubic(a, b);
}

/// For shapes that overlap.
template <class A, class B>
bool has_no_depth(const A& a, const B& b) noexcept {
  return overlap_and_depth(a, b) == Overlap::some_without_depth;
}

}  // namespace vesica::detail::depth
