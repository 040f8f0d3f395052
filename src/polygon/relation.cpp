// SPDX-License-Identifier: Apache-2.0
#include <vesica/polygon/relation.hpp>

#include "polygon/operand.hpp"
#include "polygon/topology.hpp"

namespace vesica::polygon {

std::int32_t relation(const Operand& a, const Operand& b, void*) noexcept {
  return with_edges(a, b, [](const auto& edges, const auto& other, bool reversed) {
    const std::int32_t code = detail::polygon::relation_or_error(edges, other);
    return code >= 0 && reversed ? static_cast<std::int32_t>(converse(static_cast<Relation>(code))) : code;
  });
}

std::int32_t contains(const Operand& a, const Operand& b, void*) noexcept {
  const std::int32_t code = relation(a, b, nullptr);
  return code < 0 ? code : code >= static_cast<std::int32_t>(Relation::contains);
}

std::int32_t interiors_overlap(const Operand& a, const Operand& b, void*) noexcept {
  return with_edges(a, b, [](const auto& edges, const auto& other, bool) {
    return detail::polygon::interiors_overlap_or_error(edges, other);
  });
}

}  // namespace vesica::polygon
