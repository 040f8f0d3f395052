// SPDX-License-Identifier: Apache-2.0
/// A box and an ellipse at most a distance apart, exactly. This is overlap of an ellipse and a core with a radius: a
/// disc, a capsule or a rounded rectangle.
///
/// Proved: let box B and ellipse E be disjoint, c the centre of E in the first quadrant of B's frame (VisibleEdges).
/// Then their distance is that of E and one of B's visible edges, which have c.x > hx or c.y > hy in the frame's units.
/// In each of these one part counts, the side or an end: the predicates below look at no other.
///
///   - Let y of B and z of E be closest, and n = z - y. E lies beyond z and B behind y, so that n.c > n.y, which is
///     hx |n.x| + hy |n.y|. So c.x n.x > hx |n.x|, or the same holds across. Then n.x > 0 and c.x > hx: the edge
///     towards +x is visible. It has y, because n.y is greatest in B.
///   - The distance of E from a point that moves along an edge's line is convex. If it is least on the edge, that is
///     the edge's distance; otherwise the end on that side has it.
///   - If the line misses E, it is closest at the foot of E's support point, p01 / sqrt(p00) across. P is the matrix of
///     E, and x the line's distance from c. If the edge has the foot, E is beyond the line and B behind it, and their
///     distance is x - sqrt(p00). It is at most R = reach |u| iff m = x^2 - p00 - R^2 <= 2 R sqrt(p00). So m <= 0 or
///     m^2 <= 4 R^2 p00. Degree 12.
///   - If the line meets E, it does so in a chord beyond one end of the edge. Its centre p01 x / p00 says which.
///   - E is at most `reach` from an end iff the disc of that radius about the end meets E. The contact cubic of
///     ellipses decides that. Degree 32 at most.
#pragma once

#include <vesica/exact/ellipse_ellipse.hpp>
#include <vesica/exact/within.hpp>

namespace vesica::exact {

namespace detail {

/// The corner i hx u + j hy perp(u) from a box's centre, i and j being 1 or -1.
struct Corner {
  int i, j;
};

/// The contact, or the corners that have it.
struct ClosestParts {
  int contact;
  int count;  ///< of corners; 0 if the contact is known
  Corner corner[2];
};

enum class EdgePart { near_end, far_end, side };

/// The part of an edge that is closest to an ellipse, which does not meet it. As for segment_gap(), x > 0.
VESICA_CALLED constexpr EdgePart closest_part(const Number<6>& p00, const Number<6>& p01, const Number<3>& x,
                                              const Number<3>& from, const Number<3>& to) noexcept {
  if (compare(square(x), p00) <= 0) {
    return compare(p01 * x, p00 * from) < 0 ? EdgePart::near_end : EdgePart::far_end;
  }
  if (sign_with_root(p01, -from, p00) < 0) return EdgePart::near_end;
  return sign_with_root(p01, -to, p00) > 0 ? EdgePart::far_end : EdgePart::side;
}

/// The sign of x - sqrt(p00) - R for the square of R > 0.
VESICA_CALLED constexpr int side_contact(const Number<6>& p00, const Number<3>& x, const Number<4>& squared) noexcept {
  const Number<6> m = square(x) - p00 - squared;
  return m.sign <= 0 ? -1 : -compare_product_with_square(integer(4) * squared, p00, m);
}

/// Not inlined: corners do not need this stack.
VESICA_CALLED constexpr ClosestParts closest_parts(const Box& box, const Ellipse& ellipse,
                                                   const Length& reach) noexcept {
  const VisibleEdges edges(box, ellipse);
  if (edges.centre_inside || edges.gap(0) <= 0) return {-1, 0, {}};
  const auto& [c, s, near_x, near_y, far_x, far_y, a, b, turn_x, turn_y, inside] = edges;
  const Number<6> p01 = (square(a) - square(b)) * (c * s);
  const Number<4> squared = square(reach) * dot(box.ux, box.uy, box.ux, box.uy);
  ClosestParts parts{1, 0, {}};
  // The edges of a segment are it and its end: then it alone is looked at.
  const bool sees_y = near_y.sign > 0 && !(box.hx.sign == 0 && near_x.sign > 0);
  const bool sees_x = near_x.sign > 0 && !(box.hy.sign == 0 && sees_y);
  bool has_near_corner = false;
  if (sees_x) {
    const Number<6> p00 = square(a * c) + square(b * s);
    const EdgePart part = closest_part(p00, p01, near_x, near_y, far_y);
    if (part == EdgePart::side) return {side_contact(p00, near_x, squared), 0, {}};
    has_near_corner = part == EdgePart::near_end;
    parts.corner[parts.count++] = {turn_x, has_near_corner ? turn_y : -turn_y};
  }
  if (sees_y) {
    const Number<6> p11 = square(a * s) + square(b * c);
    const EdgePart part = closest_part(p11, p01, near_y, near_x, far_x);
    if (part == EdgePart::side) return {side_contact(p11, near_y, squared), 0, {}};
    const bool is_near = part == EdgePart::near_end;
    if (!(is_near && has_near_corner)) parts.corner[parts.count++] = {is_near ? turn_x : -turn_x, turn_y};
  }
  return parts;
}

/// Leads from an ellipse's centre to a corner.
struct CornerOffset {
  Number<2> x, y;

  constexpr CornerOffset(const Box& box, const Corner& corner, const Ellipse& ellipse) noexcept {
    const auto [i, j] = corner;
    const Length dx = box.cx - ellipse.cx, dy = box.cy - ellipse.cy;
    x = add(add(Number<2>(dx), box.hx * box.ux, i), box.hy * box.uy, -j);
    y = add(add(Number<2>(dy), box.hx * box.uy, i), box.hy * box.ux, j);
  }
};

/// The cubic of the disc of radius r > 0 about a corner and an ellipse. Not inlined, as above.
VESICA_CALLED constexpr Cubic corner_cubic(const Box& box, const Corner& corner, const Ellipse& ellipse,
                                           const Length& r) noexcept {
  const CornerOffset at(box, corner, ellipse);
  return disc_cubic(r, at.x, at.y, ellipse);
}

/// The contact of that disc and the ellipse.
VESICA_CALLED constexpr int corner_contact(const Box& box, const Corner& corner, const Ellipse& ellipse,
                                           const Length& reach) noexcept {
  const Cubic p = corner_cubic(box, corner, ellipse, reach);
  return contact(p);
}

}  // namespace detail

/// The contact of a box and an ellipse if one reaches `reach` >= 0 farther each way, or one that counts already. Not
/// inlined: a depth does not need this stack.
VESICA_CALLED constexpr int contact(const Box& box, const Ellipse& ellipse, const Length& reach,
                                    Common common) noexcept {
  if (degenerate(ellipse)) return contact(box, as_box(ellipse), reach, common);
  if (reach.sign == 0) return contact(box, ellipse, common);
  if (box.hx.sign == 0 && box.hy.sign == 0) return detail::corner_contact(box, {1, 1}, ellipse, reach);
  const detail::ClosestParts parts = detail::closest_parts(box, ellipse, reach);
  int least = parts.contact;
  for (int k = 0; k < parts.count && !counts(least, common); ++k) {
    const int of_corner = detail::corner_contact(box, parts.corner[k], ellipse, reach);
    least = of_corner < least ? of_corner : least;
  }
  return least;
}

namespace detail {

/// For an ellipse without an area. Not inlined, as above.
VESICA_CALLED constexpr bool within_flat(const Box& box, const Ellipse& ellipse, const Length& reach) noexcept {
  return within(box, as_box(ellipse), reach);
}

/// The cubic of an ellipse and a disc about a point. Not inlined, as above.
VESICA_CALLED constexpr ContactCubic cubic_of_disc(const Ellipse& ellipse, const Box& point,
                                                   const Length& radius) noexcept {
  return contact_cubic(ellipse, {point.cx, point.cy, from_double(1), {}, radius, radius});
}

}  // namespace detail

/// True if a box and an ellipse are at most `reach` apart; with reach < 0, if they overlap at least -reach deep. That
/// is answered for a point, where the ellipse contains the disc of that radius, and for an ellipse without an area.
constexpr bool within(const Box& box, const Ellipse& ellipse, const Length& reach) noexcept {
  if (reach.sign < 0) {
    if (degenerate(ellipse)) return detail::within_flat(box, ellipse, reach);
    ContactCubic p = detail::cubic_of_disc(ellipse, box, -reach);
    return relation(p) >= Relation::contains;
  }
  return contact(box, ellipse, reach, Common::any) <= 0;
}

}  // namespace vesica::exact
