// SPDX-License-Identifier: Apache-2.0
#include <vesica/polygon/overlap.hpp>

#include "polygon/answers.hpp"
#include "polygon/operand.hpp"

namespace vesica::polygon {

std::int32_t overlap(const Operand& a, const Operand& b, void*) noexcept {
  return with_edges(
      a, b, [](const auto& edges, const auto& other, bool) { return detail::polygon::overlap_or_error(edges, other); });
}

}  // namespace vesica::polygon
