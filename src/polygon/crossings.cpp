// SPDX-License-Identifier: Apache-2.0
#include <vesica/polygon/crossings.hpp>

#include "polygon/answers.hpp"
#include "polygon/operand.hpp"

namespace vesica {

namespace detail::polygon {

inline std::int32_t edge_crossings(const Edge& e, const AnyShape& s, CrossingPoints<double>& out) noexcept {
  return ask_edge(queries::crossings, e, s, &out);
}

}  // namespace detail::polygon

namespace polygon {

std::int32_t crossings(const Operand& a, const Operand& b, void* room) noexcept {
  return with_edges(a, b, [&](const auto& edges, const auto& other, bool) {
    auto& places = *static_cast<detail::polygon::Room*>(room);
    return static_cast<std::int32_t>(std::min<std::int64_t>(detail::polygon::crossings_or_error(edges, other, places),
                                                            std::numeric_limits<std::int32_t>::max()));
  });
}

}  // namespace polygon
}  // namespace vesica
