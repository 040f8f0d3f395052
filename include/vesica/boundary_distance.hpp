// SPDX-License-Identifier: Apache-2.0
/// boundary_distance(a, b): how far apart are two outlines, and where do they come closest?
///
/// The outline of a shape with area is the curve around it. The outline of a point, a segment, or any shape with a zero
/// size is the whole shape. Outlines that share a point have distance 0, and both closest points are one such point.
/// Disjoint shapes give what nearest() gives. If one shape lies strictly inside the other, the answer is the least
/// distance over the whole outline, never a local minimum only. If several pairs of points are equally close, the
/// answer is one of them. relation() decides exactly which case it is.
///
/// Accuracy, u = 2^-53 and scale the largest coordinate of the offset of centres or half length: the distance is right
/// to 4u scale at aspect ratios up to 1e6, and never rounded to 0 where outlines are apart. Before coordinates are
/// rounded, points are within 12u scale of their outlines at any aspect ratio, a common point of both (6.8u is the most
/// that a search for large errors found); at aspects up to 1e6 they are as far apart as the distance to 16u scale (it
/// found 10.6u).
///
/// Laws, each tested: boundary_distance(b, a) has the same bits with the points exchanged; the distance is unchanged
/// when both shapes are moved alike without rounding; it is at least nearest(), and equals it for disjoint shapes.
#pragma once

#include <limits>
#include <vesica/boundary_distance/box_box.hpp>
#include <vesica/boundary_distance/common_point.hpp>
#include <vesica/boundary_distance/inflated.hpp>
#include <vesica/boundary_distance/inflated_ellipse.hpp>
#include <vesica/boundary_distance/lane_pairs.hpp>
#include <vesica/boundary_distance/nested.hpp>
#include <vesica/nearest.hpp>
#include <vesica/relation.hpp>
#include <vesica/support_minimum/stored_extents.hpp>

namespace vesica {

namespace detail::boundary_distance {

/// In the unit in which the pair's lengths are moderate: no product of boxes underflows there.
inline Nested nested_in_unit(const Form& outer, const Form& inner) noexcept {
  if (!outer.curved && !inner.curved) {
    const PlacedPair pair = place(outer, inner);
    const auto boxes = nested_boxes_of_ties(box_pair(pair));
    if (boxes.settled) {
      return {boxes.distance, {boxes.outer_x, boxes.outer_y}, {boxes.inner_x, boxes.inner_y}, pair.exponent};
    }
  }
  return nested_distance(outer, inner);
}

/// Two outlines, one strictly inside the other.
inline ClosestPoints<double> nested_outlines(const Form& outer, const Form& inner) noexcept {
  if (!outer.curved && !inner.curved) {
    const auto boxes = nested_boxes(box_pair(outer, inner));
    if (boxes.settled) {
      const PlaneVector p = located(outer, {boxes.outer_x, boxes.outer_y}, 0);
      const PlaneVector q = located(inner, {boxes.inner_x, boxes.inner_y}, 0);
      return {rounded(boxes.distance), p.x, p.y, q.x, q.y};
    }
  }
  const Nested n = nested_in_unit(outer, inner);
  const PlaneVector p = located(outer, n.outer, n.exponent);
  const PlaneVector q = located(inner, n.inner, n.exponent);
  const double distance = std::fmax(arithmetic::scale_rounded(n.distance.high, n.distance.low, n.exponent),
                                    std::numeric_limits<double>::denorm_min());
  return {distance, p.x, p.y, q.x, q.y};
}

inline ClosestPoints<double> points_exchanged(const ClosestPoints<double>& c) noexcept {
  return {c.distance, c.bx, c.by, c.ax, c.ay};
}

/// No -0, whichever shape is called the first.
inline ClosestPoints<double> at_one_point(double x, double y) noexcept {
  return {0, x + 0.0, y + 0.0, x + 0.0, y + 0.0};
}

/// Returns false where a common point was found, but is not certain.
inline bool closest_points_of_forms(Relation relation, const Form& a, const Form& b,
                                    ClosestPoints<double>& out) noexcept {
  if (relation == Relation::inside && !flat(b)) {
    out = points_exchanged(nested_outlines(b, a));
  } else if (relation == Relation::contains && !flat(a)) {
    out = nested_outlines(a, b);
  } else {
    const CommonPoint common = common_outline_point(a, b);
    out = at_one_point(common.at.x, common.at.y);
    return common.certain;
  }
  return true;
}

/// For nested pairs that batches answer in vector lanes: the same core, so that the bits are the same. Returns false if
/// that core does not reach its accuracy; then the general search must answer.
template <class A, class B>
bool settled_outlines(const A&, const B&, Relation, ClosestPoints<double>&) noexcept {
  return false;
}
template <class A>
VESICA_CALLED bool settled_outlines(const A& a, const Ellipse<double>& b, Relation relation,
                                    ClosestPoints<double>& out) noexcept {
  if constexpr (nearest::has_lanes<A, Ellipse<double>>) {
    const bool inside = relation == Relation::inside;
    if ((!inside && relation != Relation::contains) || !moderate_pair(a, b)) return false;
    const auto lanes = lane_nested(a, b, inside, false);
    if (lanes.settled) out = {lanes.distance, lanes.ax, lanes.ay, lanes.bx, lanes.by};
    return lanes.settled;
  } else {
    return false;
  }
}

inline bool settled_outlines(const Circle<double>& a, const Ellipse<double>& b, Relation relation,
                             ClosestPoints<double>& out) noexcept {
  return settled_outlines(as_ellipse(a), b, relation, out);
}

/// The least number of places at which outlines meet, by the relation; at a touch where curves are equal;
/// then any point will do.
inline crossings::Census places_told_by(Relation relation) noexcept {
  return relation == Relation::cross ? crossings::Census{2, 0, false} : crossings::Census{0, 1, false};
}

template <class A, class B>
ClosestPoints<double> closest_outline_points(Relation relation, const A& a, const B& b) noexcept {
  const Form f = support_minimum::form(a), g = support_minimum::form(b);
  ClosestPoints<double> found;
  const bool certain = closest_points_of_forms(relation, f, g, found);
  if constexpr (stores_extents<A> && stores_extents<B>) {
    if (found.distance > 0)
      found.distance = relation == Relation::inside ? distance_from_sides(g, f) : distance_from_sides(f, g);
  }
  if (certain) return found;
  double x = found.ax, y = found.ay;
  crossings::one_place(a, b, x, y, places_told_by(relation));
  return at_one_point(x, y);
}

}  // namespace detail::boundary_distance

template <template <class> class A, template <class> class B>
std::int32_t boundary_distance_or_error(const A<double>& a, const B<double>& b, ClosestPoints<double>& out) noexcept;

namespace detail::boundary_distance {

/// Shapes of which one is a core with a radius, valid and overlapping. Kinds that need no radius are asked instead.
template <class A, class B>
std::int32_t inflated_outlines(Relation relation, const A& a, const B& b, ClosestPoints<double>& out) noexcept {
  if constexpr (ShapeTraits<A>::kind == Kind::ellipse) {
    if (a.a == 0 || a.b == 0) return boundary_distance_or_error(Rect<double>{a.cx, a.cy, a.ux, a.uy, a.a, a.b}, b, out);
  }
  return form::with_simplest(a, [&](const auto& p) {
    return form::with_simplest(b, [&](const auto& q) -> std::int32_t {
      if constexpr (std::is_same_v<decltype(p), const A&> && std::is_same_v<decltype(q), const B&>) {
        const ClosestPoints<double> found = closest_outlines(relation, a, b);
        return nearest::rounded_to(found, found.distance == 0, out) ? 0 : error_range;
      } else {
        return boundary_distance_or_error(p, q, out);
      }
    });
  });
}

}  // namespace detail::boundary_distance

/// The checked form: writes the distance of the outlines of two shapes of any kinds, in either order, and their closest
/// points. Returns 0, error_shape when either is invalid, or error_range when a number would exceed the largest finite
/// one; on error `out` is untouched.
template <template <class> class A, template <class> class B>
VESICA_CALLED std::int32_t boundary_distance_or_error(const A<double>& a, const B<double>& b,
                                                      ClosestPoints<double>& out) noexcept {
  if constexpr (!detail::in_order<A<double>, B<double>>) {
    ClosestPoints<double> found;
    const std::int32_t error = boundary_distance_or_error(b, a, found);
    if (error == 0) out = detail::boundary_distance::points_exchanged(found);
    return error;
  } else {
    const std::int32_t relation = detail::called_relation(a, b);
    if (relation < 0) return relation;
    if (relation == static_cast<std::int32_t>(Relation::disjoint))
      return detail::nearest::nearest_in_order(a, b, 0, out);
    if constexpr (detail::form::Inflated<B<double>>) {
      return detail::boundary_distance::inflated_outlines(static_cast<Relation>(relation), a, b, out);
    } else {
      ClosestPoints<double> found;
      if (!detail::boundary_distance::settled_outlines(a, b, static_cast<Relation>(relation), found)) {
        found = detail::boundary_distance::closest_outline_points(static_cast<Relation>(relation), a, b);
      }
      return detail::nearest::rounded_to(found, found.distance == 0, out) ? 0 : error_range;
    }
  }
}

template <template <class> class A, template <class> class B>
std::int32_t boundary_distance_or_error(const A<float>& a, const B<float>& b, ClosestPoints<float>& out) noexcept {
  ClosestPoints<double> wide;
  const std::int32_t error = boundary_distance_or_error(widen(a), widen(b), wide);
  if (error != 0) return error;
  return detail::nearest::rounded_to(wide, wide.distance == 0, out) ? 0 : error_range;
}

/// The distance of the outlines of two shapes and their closest points. For valid shapes: all numbers are NaN where
/// boundary_distance_or_error(), the checked form, returns an error.
template <template <class> class A, template <class> class B, class T>
ClosestPoints<T> boundary_distance(const A<T>& a, const B<T>& b) noexcept {
  constexpr T none = std::numeric_limits<T>::quiet_NaN();
  ClosestPoints<T> found{none, none, none, none, none};
  boundary_distance_or_error(a, b, found);
  return found;
}

}  // namespace vesica
