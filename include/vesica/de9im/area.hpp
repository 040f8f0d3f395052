// SPDX-License-Identifier: Apache-2.0
/// Two areas: their relation says all but whether their outlines share a stretch.
#pragma once

#include <cmath>
#include <vesica/de9im/segment.hpp>

namespace vesica::detail::de9im {

/// meeting: what the outlines share, where the relation does not say that this is nothing.
inline NineIntersections of_areas(Relation r, char meeting) noexcept {
  switch (r) {
    case Relation::disjoint:
      return {"FF2FF1212"};
    case Relation::touch:
      return {{'F', 'F', '2', 'F', meeting, '1', '2', '1', '2', 0}};
    case Relation::cross:
      return {{'2', '1', '2', '1', meeting, '1', '2', '1', '2', 0}};
    case Relation::inside:
      return {"2FF1FF212"};
    case Relation::inside_touch:
      return {{'2', 'F', 'F', '1', meeting, 'F', '2', '1', '2', 0}};
    case Relation::contains:
      return {"212FF1FF2"};
    case Relation::contains_touch:
      return {{'2', '1', '2', 'F', meeting, '1', 'F', 'F', '2', 0}};
    case Relation::equal:
      break;
  }
  return {"2FFF1FFF2"};
}

/// True if intervals have a length in common.
inline bool overlap_in_length(double p0, double p1, double q0, double q1) noexcept { return p0 < q1 && q0 < p1; }
inline bool share_a_side(double p0, double p1, double q0, double q1) noexcept {
  return p0 == q0 || p0 == q1 || p1 == q0 || p1 == q1;
}

inline bool outlines_share_stretch(const Aabb<double>& a, const Aabb<double>& b) noexcept {
  return (share_a_side(a.min_x, a.max_x, b.min_x, b.max_x) && overlap_in_length(a.min_y, a.max_y, b.min_y, b.max_y)) ||
         (share_a_side(a.min_y, a.max_y, b.min_y, b.max_y) && overlap_in_length(a.min_x, a.max_x, b.min_x, b.max_x));
}

VESICA_COLD inline bool outlines_share_stretch(const exact::Box& box_a, const exact::Box& box_b) noexcept {
  const Polygon a(box_a), b(box_b);
  const Sides of_a(a, b);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const bool on_line = of_a.sign[i][j] == 0 && of_a.sign[i][b.corners.next(j)] == 0;
      if (on_line && crossings::share_stretch(Edge(a.corners, i), Edge(b.corners, j))) return true;
    }
  }
  return false;
}

/// True if two axes are certainly neither parallel nor at right angles. With u = 2^-53, a sum of two rounded products
/// errs by 2u of their magnitudes and by what underflows; components that are rounded differences add 2u.
inline bool certainly_oblique(double ux, double uy, double wx, double wy) noexcept {
  const double bound = 0x1p-50 * (std::fabs(ux * wx) + std::fabs(uy * wy) + std::fabs(ux * wy) + std::fabs(uy * wx));
  const double dot = std::fabs(ux * wx + uy * wy), cross = std::fabs(ux * wy - uy * wx);
  return dot > bound && cross > bound && bound > 0x1p-900 && bound < 0x1p900;
}

/// For straight shapes with area.
template <class A, class B>
bool outlines_share_stretch(const A& a, const B& b) noexcept {
  constexpr form::AsStored<double> number;
  const auto f = form::of(a);
  const auto g = form::of(b);
  if (certainly_oblique(number(f.ux), number(f.uy), number(g.ux), number(g.uy))) return false;
  return outlines_share_stretch(exact::form(a), exact::form(b));
}

/// With a core and a radius. Arcs share a stretch only if their radii are equal.
template <class A, class B>
requires(form::Inflated<A> || form::Inflated<B>) bool outlines_share_stretch(const A& a, const B& b) noexcept {
  constexpr form::AsStored<double> number;
  const auto p = form::inflated(a);
  const auto q = form::inflated(b);
  const auto f = form::of(p.core);
  const auto g = form::of(q.core);
  const bool has_arcs = p.radius == q.radius;
  if (!has_arcs && certainly_oblique(number(f.ux), number(f.uy), number(g.ux), number(g.uy))) return false;
  return crossings::share_stretch(crossings::round_outline(a), crossings::round_outline(b));
}

/// An ellipse may be a circle, which holds an arc.
template <form::Inflated Shape>
VESICA_COLD bool outlines_share_stretch(const Shape& s, const Ellipse<double>& ellipse) noexcept {
  if (ellipse.a != ellipse.b) return false;
  const exact::Ellipse e = exact::form(ellipse);
  const crossings::RoundOutline o = crossings::round_outline(s);
  if (exact::compare(exact::square(e.a) * exact::dot(e.ux, e.uy, e.ux, e.uy), exact::square(o.radius)) != 0)
    return false;
  for (int i = 0; i < o.corners.count; ++i) {
    if (crossings::is_corner(o.corners, i, e.cx, e.cy)) return true;
  }
  return false;
}
template <form::Inflated Shape>
bool outlines_share_stretch(const Ellipse<double>& ellipse, const Shape& s) noexcept {
  return outlines_share_stretch(s, ellipse);
}

}  // namespace vesica::detail::de9im
