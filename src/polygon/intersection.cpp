// SPDX-License-Identifier: Apache-2.0
#include <vesica/polygon/intersection.hpp>

#include "polygon/operand.hpp"
#include "queries/topology.hpp"

namespace vesica {

namespace detail::polygon {

template <class T>
std::int64_t shared_or_error(const Edges<T>& a, const AnyShape& b, RegionRoom& room) noexcept {
  return with_shape(b, [&](const auto& shape) -> std::int64_t {
    if constexpr (has_shared<Polygon<double>, std::remove_cvref_t<decltype(shape)>>) {
      return shared_or_error(a, shape, room);
    } else {
      return error_kind;
    }
  });
}

}  // namespace detail::polygon

namespace polygon {

bool has_intersection(std::int32_t kind_a, std::int32_t kind_b) noexcept {
  if (!has_vertices(kind_a)) return has_intersection(kind_b, kind_a);
  if (kind_a == polyline_kind && has_vertices(kind_b)) return false;
  if (has_vertices(kind_b)) return kind_b == polygon_kind;
  return with_name(kind_b, [kind_a]<template <class> class Shape>(Named<Shape>) -> std::int32_t {
           using detail::polygon::has_shared;
           const bool takes = kind_a == polygon_kind ? has_shared<Polygon<double>, Shape<double>>
                                                     : has_shared<Polyline<double>, Shape<double>>;
           return takes ? 1 : 0;
         }) == 1;
}

std::int32_t intersection(const Operand& a, const Operand& b, void* room) noexcept {
  return with_edges(a, b, [&](const auto& edges, const auto& other, bool) {
    const std::int64_t count =
        detail::polygon::shared_or_error(edges, other, *static_cast<detail::polygon::RegionRoom*>(room));
    return static_cast<std::int32_t>(std::min<std::int64_t>(count, std::numeric_limits<std::int32_t>::max()));
  });
}

}  // namespace polygon
}  // namespace vesica
