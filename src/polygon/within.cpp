// SPDX-License-Identifier: Apache-2.0
#include "queries/within.hpp"

#include <vesica/polygon/within.hpp>

#include "compiled_once.hpp"
#include "polygon/answers.hpp"
#include "polygon/operand.hpp"

namespace vesica {

namespace detail::polygon {

inline std::int32_t edge_within(const Edge& e, const AnyShape& s, double distance) noexcept {
  const queries::WithinOfPair within = queries::within(static_cast<std::int32_t>(Kind::segment), s.kind);
  return within(&e.x0, s.number, distance);
}

}  // namespace detail::polygon

namespace polygon {

std::int32_t within(const Operand& a, const Operand& b, double distance) noexcept {
  return with_edges(a, b, [&](const auto& edges, const auto& other, bool) {
    return detail::polygon::within_or_error(edges, other, distance);
  });
}

}  // namespace polygon
}  // namespace vesica
