// SPDX-License-Identifier: Apache-2.0
/// nearest(), boundary_distance() and signed_distance() of polygons and polylines: the least over edges. A polygon's
/// outline is its edges, a polyline is its own outline.
#pragma once

#include <type_traits>
#include <vesica/boundary_distance.hpp>
#include <vesica/polygon/least.hpp>
#include <vesica/polygon/overlap.hpp>
#include <vesica/polygon/overlap_depth.hpp>
#include <vesica/signed_distance.hpp>

namespace vesica {

namespace detail::polygon {

enum class Distance { of_shapes, of_outlines };

/// A distance and its points for an edge and a valid shape: 0 or an error.
template <Distance distance, template <class> class Shape>
std::int32_t ask_distance(const Edge& e, const Shape<double>& s, Points& out) noexcept {
  return distance == Distance::of_shapes ? nearest_or_error(e, s, out) : boundary_distance_or_error(e, s, out);
}

inline Points exchanged(const Points& c) noexcept { return {c.distance, c.bx, c.by, c.ax, c.ay}; }

/// No -0, whichever shape is the first.
inline Points at_one_point(const Point<double>& p) noexcept { return {0, p.x + 0.0, p.y + 0.0, p.x + 0.0, p.y + 0.0}; }

/// The least over edges; both shapes are valid.
template <Distance distance, class T, class Other>
std::int32_t least_distance(const Edges<T>& a, const Box& box_a, const Other& b, const Box& box_b,
                            Points& out) noexcept {
  const auto ask = [&](const Edge& e, Points& points) { return ask_distance<distance>(e, b, points); };
  const Point<double> stored = stored_point(b);
  return LeastOfEdges(a, box_a, box_b, is_point(b) ? &stored : nullptr, ask).find(out);
}
template <Distance, class T>
std::int32_t least_distance(const Edges<T>& a, const Box& box_a, const Edges<T>& b, const Box& box_b,
                            Points& out) noexcept {
  LeastOfPairs least(together(box_a, box_b));
  least.sample(a, b);
  walk(a, box_a, b, box_b, least);
  return least.result(out);
}

/// Both shapes are valid. If no edges meet, one may be inside the other.
template <Distance distance, class T, class Other>
std::int32_t distance_of_valid(const Edges<T>& a, const Box& box_a, const Other& b, const Box& box_b,
                               Points& out) noexcept {
  Point<double> common;
  if (distance == Distance::of_shapes && point_inside(a, box_a, b, box_b, common)) {
    out = at_one_point(common);
    return 0;
  }
  return least_distance<distance>(a, box_a, b, box_b, out);
}

/// The checked form in double. Two paths are asked in an order of their own, so that exchanging them changes no bit.
template <Distance distance, class T, class Other>
std::int32_t distance_or_error(const Edges<T>& a, const Other& b, Points& out) noexcept {
  Box box_a, box_b;
  if (!is_valid(a, box_a) || !is_valid(b, box_b)) return error_shape;
  if constexpr (std::is_same_v<Other, Edges<T>>) {
    if (compared(a, b) > 0) {
      const std::int32_t error = distance_of_valid<distance>(b, box_b, a, box_a, out);
      if (error == 0) out = exchanged(out);
      return error;
    }
  }
  return distance_of_valid<distance>(a, box_a, b, box_b, out);
}

/// The checked form for operands in either order, rounded once.
template <Distance distance, class T, class Other>
std::int32_t rounded_distance_or_error(const Edges<T>& a, const Other& b, bool reversed,
                                       ClosestPoints<T>& out) noexcept {
  Points found;
  const std::int32_t error = distance_or_error<distance>(a, b, found);
  if (error != 0) return error;
  if (reversed) found = exchanged(found);
  return nearest::rounded_to(found, found.distance == 0, out) ? 0 : error_range;
}

/// The checked form in double: the number is rounded to float as nearest() rounds it.
template <class T, class Other>
std::int32_t signed_distance_or_error(const Edges<T>& a, const Other& b, T& out) noexcept {
  Points found;
  std::int32_t error = distance_or_error<Distance::of_shapes>(a, b, found);
  if (error != 0) return error;
  Separation separation{found.distance > 0, found, {}};
  if (!separation.disjoint) error = overlap_depth(a, b, separation.depth.depth);
  return error != 0 ? error : signed_distance_of(separation, out);
}

template <Distance distance, class A, class B, class T>
std::int32_t rounded_distance_or_error(const A& a, const B& b, ClosestPoints<T>& out) noexcept {
  return with_edges(a, b, [&](const auto& edges, const auto& other, bool reversed) {
    return rounded_distance_or_error<distance>(edges, other, reversed, out);
  });
}

}  // namespace detail::polygon

// The checked forms with a polygon or a polyline, in either order. Their plain forms are those of other shapes.

template <template <class> class A, template <class> class B>
std::int32_t nearest_or_error(const A<double>& a, const B<double>& b,
                              ClosestPoints<double>& out) noexcept requires AnyPath<A<double>, B<double>> {
  return detail::polygon::rounded_distance_or_error<detail::polygon::Distance::of_shapes>(a, b, out);
}
template <template <class> class A, template <class> class B>
std::int32_t nearest_or_error(const A<float>& a, const B<float>& b,
                              ClosestPoints<float>& out) noexcept requires AnyPath<A<float>, B<float>> {
  return detail::polygon::rounded_distance_or_error<detail::polygon::Distance::of_shapes>(a, b, out);
}

template <template <class> class A, template <class> class B>
std::int32_t boundary_distance_or_error(const A<double>& a, const B<double>& b,
                                        ClosestPoints<double>& out) noexcept requires AnyPath<A<double>, B<double>> {
  return detail::polygon::rounded_distance_or_error<detail::polygon::Distance::of_outlines>(a, b, out);
}
template <template <class> class A, template <class> class B>
std::int32_t boundary_distance_or_error(const A<float>& a, const B<float>& b,
                                        ClosestPoints<float>& out) noexcept requires AnyPath<A<float>, B<float>> {
  return detail::polygon::rounded_distance_or_error<detail::polygon::Distance::of_outlines>(a, b, out);
}

template <template <class> class A, template <class> class B, class T>
std::int32_t signed_distance_or_error(const A<T>& a, const B<T>& b, T& out) noexcept requires AnyPath<A<T>, B<T>> {
  return detail::polygon::with_edges(a, b, [&](const auto& edges, const auto& other, bool) {
    return detail::polygon::signed_distance_or_error(edges, other, out);
  });
}

}  // namespace vesica
