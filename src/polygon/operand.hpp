// SPDX-License-Identifier: Apache-2.0
// Shapes of any kind as the questions of polygons take them: a polygon's edges, or a row of numbers with its kind.
#pragma once

#include <cstring>
#include <vesica/polygon/depth.hpp>
#include <vesica/polygon/ratio.hpp>
#include <vesica/polygon/row_parts.hpp>

#include "queries/overlap.hpp"
#include "query.hpp"

namespace vesica {

namespace detail::polygon {

/// A shape of any kind but polygon and polyline. So the code of a question exists once for all of them.
struct AnyShape {
  std::int32_t kind;
  double number[max_fields];
};

/// action(shape) by its kind.
template <class Action>
auto with_shape(const AnyShape& s, Action action) noexcept {
  decltype(action(Point<double>{})) result{};
  with_name(s.kind, [&]<template <class> class Shape>(Named<Shape>) -> std::int32_t {
    if constexpr (HasCore<Shape<double>>) result = action(load<Shape<double>>(s.number));
    return 0;
  });
  return result;
}

inline Box box_about(const AnyShape& s) noexcept {
  return with_shape(s, [](const auto& shape) { return polygon::box_about(shape); });
}
inline Point<double> stored_point(const AnyShape& s) noexcept { return {s.number[0], s.number[1]}; }
inline bool is_point(const AnyShape& s) noexcept { return s.kind == static_cast<std::int32_t>(Kind::point); }
inline int check_other(const AnyShape& s) noexcept {
  return with_shape(s, [](const auto& shape) { return vesica::check(shape); });
}

inline RowArea row_area(const AnyShape& s, double reach) noexcept {
  return with_shape(s, [&](const auto& shape) { return polygon::row_area(shape, reach); });
}
inline ratio::Facts other_facts(const AnyShape& s, const PathShares& shares) noexcept {
  return with_shape(s, [&](const auto& shape) { return polygon::other_facts(shape, shares); });
}

/// A query's code for an edge and a valid shape.
inline std::int32_t ask_edge(const Query& query, const Edge& e, const AnyShape& s, void* out) noexcept {
  return query.doubles.of[static_cast<int>(Kind::segment)][s.kind](&e, s.number, out);
}
inline bool edge_meets(const Edge& e, const AnyShape& s) noexcept {
  return ask_edge(queries::overlap, e, s, nullptr) == 1;
}
inline Relation edge_relation(const Edge& e, const AnyShape& s) noexcept {
  return static_cast<Relation>(ask_edge(queries::relation, e, s, nullptr));
}
inline bool edge_insides_meet(const Edge& e, const AnyShape& s) noexcept {
  constexpr auto segment = static_cast<std::int32_t>(Kind::segment);
  const auto& overlap = queries::overlap_in_order.of;
  return (s.kind < segment ? overlap[s.kind][segment](s.number, &e, Common::insides)
                           : overlap[segment][s.kind](&e, s.number, Common::insides)) == 1;
}
inline int dimension(const AnyShape& s) noexcept {
  return with_shape(s, [](const auto& shape) { return polygon::dimension(shape); });
}
inline Thin thin(const AnyShape& s) noexcept {
  return with_shape(s, [](const auto& shape) { return polygon::thin(shape); });
}
inline Middle centre(const AnyShape& s) noexcept {
  return with_shape(s, [](const auto& shape) { return polygon::centre(shape); });
}

inline CoreForm core_form(const AnyShape& s) noexcept {
  return with_shape(s, [](const auto& shape) { return polygon::core_form(shape); });
}
VESICA_COLD inline exact::Box exact_core(const AnyShape& s) noexcept {
  return with_shape(s, [](const auto& shape) { return polygon::exact_core(shape); });
}
/// A core's numbers are the first ones of the shape.
inline bool core_meets(const Edge& e, const AnyShape& s) noexcept {
  AnyShape core = s;
  if (s.kind == static_cast<std::int32_t>(Kind::circle)) core.kind = static_cast<std::int32_t>(Kind::point);
  if (s.kind == static_cast<std::int32_t>(Kind::capsule)) core.kind = static_cast<std::int32_t>(Kind::segment);
  if (s.kind == static_cast<std::int32_t>(Kind::round_rect)) core.kind = static_cast<std::int32_t>(Kind::rect);
  return edge_meets(e, core);
}
inline std::int32_t edge_depth(const Edge& e, const AnyShape& s, Penetration<double>& out) noexcept {
  return ask_edge(queries::depth, e, s, &out);
}

}  // namespace detail::polygon

namespace polygon {

using detail::polygon::AnyShape;
using detail::polygon::Edges;

/// The row of a shape of scalar T.
template <class T>
AnyShape any_shape(const Operand& s) noexcept {
  AnyShape shape{s.kind, {}};
  for (int k = 0; k < field_count(s.kind); ++k)
    shape.number[k] = static_cast<double>(static_cast<const T*>(s.shape)[k]);
  return shape;
}

template <class T>
Edges<T> edges(const Operand& s) noexcept {
  Polyline<T> path;  // laid out as a polygon
  std::memcpy(&path, s.shape, sizeof path);
  const Edges<T> edges = s.kind == polygon_kind
                             ? Edges<T>(Polygon<T>{path.x, path.y, path.stride, path.rings, path.count})
                             : Edges<T>(path);
  return {edges, s.boxes};
}

/// action(edges, other, reversed), where the first operand that is a path comes first; other is an AnyShape or edges.
template <class T, class Action>
std::int32_t with_edges_of(const Operand& a, const Operand& b, const Action& action) noexcept {
  if (is_row(b.kind)) return action(edges<T>(a), any_shape<T>(b), false);
  if (is_row(a.kind)) return action(edges<T>(b), any_shape<T>(a), true);
  return action(edges<T>(a), edges<T>(b), false);
}
template <class Action>
std::int32_t with_edges(const Operand& a, const Operand& b, const Action& action) noexcept {
  return a.is_float ? with_edges_of<float>(a, b, action) : with_edges_of<double>(a, b, action);
}

}  // namespace polygon
}  // namespace vesica
