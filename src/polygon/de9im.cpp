// SPDX-License-Identifier: Apache-2.0
#include <vesica/polygon/de9im.hpp>

#include "polygon/operand.hpp"
#include "queries/topology.hpp"

namespace vesica {

namespace detail::polygon {

inline NineIntersections edge_matrix(const Edge& e, const AnyShape& s) noexcept {
  NineIntersections m;
  ask_edge(queries::de9im, e, s, &m);
  return m;
}

}  // namespace detail::polygon

namespace polygon {

std::int32_t de9im(const Operand& a, const Operand& b, void* out) noexcept {
  return with_edges(a, b, [&](const auto& edges, const auto& other, bool reversed) {
    return detail::polygon::de9im_or_error(edges, other, reversed, *static_cast<NineIntersections*>(out));
  });
}

}  // namespace polygon
}  // namespace vesica
