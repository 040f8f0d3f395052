// SPDX-License-Identifier: Apache-2.0
#include <vesica/polygon/depth.hpp>

#include "polygon/operand.hpp"

namespace vesica::polygon {

std::int32_t depth(const Operand& a, const Operand& b, void* out) noexcept {
  Penetration<double> found{};
  const std::int32_t error = with_edges(a, b, [&](const auto& edges, const auto& other, bool reversed) {
    const std::int32_t code = detail::polygon::convex_depth(edges, other, found);
    if (reversed) found = detail::depth::turned_round(found);
    return code;
  });
  if (error != 0) return error;
  if (a.is_float) {
    return detail::depth::rounded_to(found, *static_cast<Penetration<float>*>(out))
               ? 0
               : static_cast<std::int32_t>(error_range);
  }
  *static_cast<Penetration<double>*>(out) = found;
  return 0;
}

}  // namespace vesica::polygon
