// SPDX-License-Identifier: Apache-2.0
#include <vesica/polygon/distances.hpp>

#include "compiled_once.hpp"
#include "polygon/answers.hpp"
#include "polygon/operand.hpp"

namespace vesica {

namespace detail::polygon {

template <Distance distance>
std::int32_t ask_distance(const Edge& e, const AnyShape& s, Points& out) noexcept {
  return ask_edge(distance == Distance::of_shapes ? queries::nearest : queries::boundary_distance, e, s, &out);
}

}  // namespace detail::polygon

namespace polygon {

using detail::polygon::Distance;

namespace {

template <Distance distance>
std::int32_t distance_of(const Operand& a, const Operand& b, void* out) noexcept {
  return with_edges(a, b, [&]<class T>(const Edges<T>& edges, const auto& other, bool reversed) {
    return detail::polygon::rounded_distance_or_error<distance>(edges, other, reversed,
                                                                *static_cast<ClosestPoints<T>*>(out));
  });
}

}  // namespace

std::int32_t nearest(const Operand& a, const Operand& b, void* out) noexcept {
  return distance_of<Distance::of_shapes>(a, b, out);
}
std::int32_t boundary_distance(const Operand& a, const Operand& b, void* out) noexcept {
  return distance_of<Distance::of_outlines>(a, b, out);
}

std::int32_t signed_distance(const Operand& a, const Operand& b, void* out) noexcept {
  return with_edges(a, b, [&]<class T>(const Edges<T>& edges, const auto& other, bool) {
    return detail::polygon::signed_distance_or_error(edges, other, *static_cast<T*>(out));
  });
}

}  // namespace polygon
}  // namespace vesica
