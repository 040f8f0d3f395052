// SPDX-License-Identifier: Apache-2.0
/// within() of polygons and polylines: is an edge within the distance, or one shape inside the other? As exact as
/// within() of segments.
#pragma once

#include <vesica/polygon/overlap.hpp>
#include <vesica/polygon/overlap_depth.hpp>
#include <vesica/within.hpp>

namespace vesica {

namespace detail::polygon {

/// A Within as a number, or an error.
template <template <class> class Shape>
std::int32_t edge_within(const Edge& e, const Shape<double>& s, double distance) noexcept {
  return vesica::within_or_error(e, s, distance);
}

/// Keeps pairs of edges that may be within the distance.
struct AnyWithin {
  explicit AnyWithin(double d) noexcept : distance(d), limit(squared_limit(d)) {}
  bool keeps(const Box& a, const Box& b) const noexcept { return squared_gap(a, b) <= limit; }
  bool visit(const Edge& e, std::int64_t, const Edge& f, std::int64_t) const noexcept {
    return vesica::within_or_error(e, f, distance) == static_cast<std::int32_t>(Within::yes);
  }
  double distance, limit;
};

/// Valid shapes, for a distance >= 0. The answer of the edges: yes if it is of one, else nearly if it is of one.
template <class T, class Other>
std::int32_t edges_within(const Edges<T>& a, const Box&, const Other& b, const Box& about, double distance) noexcept {
  const double limit = squared_limit(distance);
  std::int32_t answer = 0;
  const auto keeps = [&](const Box& box) { return squared_gap(box, about) <= limit; };
  any_edge(a, keeps, [&](const Edge& e, std::int64_t) {
    const std::int32_t code = edge_within(e, b, distance);
    const bool decided = code < 0 || code == static_cast<std::int32_t>(Within::yes);
    if (decided || code == static_cast<std::int32_t>(Within::nearly)) answer = code;
    return decided;
  });
  return answer;
}
template <class T>
std::int32_t edges_within(const Edges<T>& a, const Box& box_a, const Edges<T>& b, const Box& box_b,
                          double distance) noexcept {
  return any_pair(a, box_a, b, box_b, AnyWithin(distance)) ? 1 : 0;
}

template <class T, class Other>
std::int32_t within_or_error(const Edges<T>& a, const Other& b, double distance) noexcept {
  Box box_a, box_b;
  if (distance != distance) return error_argument;
  if (!is_valid(a, box_a) || !is_valid(b, box_b)) return error_shape;
  if (distance < 0) {
    if (!overlap_valid(a, box_a, b, box_b)) return 0;
    double depth;
    const std::int32_t error = overlap_depth(a, b, depth);
    if (error != 0) return error;
    return depth >= -distance ? 1 : 0;
  }
  if (!AnyWithin(distance).keeps(box_a, box_b)) return 0;
  Point<double> common;
  if (point_inside(a, box_a, b, box_b, common)) return 1;
  return edges_within(a, box_a, b, box_b, distance);
}

}  // namespace detail::polygon

/// The checked forms with a polygon or a polyline, in either order; also error_not_convex for a negative
/// distance of shapes that overlap. That is compared with the depth as depth() rounds it.
template <template <class> class A, template <class> class B>
std::int32_t within_or_error(const A<double>& a, const B<double>& b,
                             double distance) noexcept requires AnyPath<A<double>, B<double>> {
  return detail::polygon::with_edges(a, b, [&](const auto& edges, const auto& other, bool) {
    return detail::polygon::within_or_error(edges, other, distance);
  });
}
template <template <class> class A, template <class> class B>
std::int32_t within_or_error(const A<float>& a, const B<float>& b,
                             float distance) noexcept requires AnyPath<A<float>, B<float>> {
  return detail::polygon::with_edges(a, b, [&](const auto& edges, const auto& other, bool) {
    return detail::polygon::within_or_error(edges, other, static_cast<double>(distance));
  });
}

}  // namespace vesica
