// SPDX-License-Identifier: Apache-2.0
#include <vesica/polygon/ratio.hpp>

#include "polygon/areas.hpp"
#include "polygon/operand.hpp"

namespace vesica::polygon {

std::int32_t area(const Operand& a, const Operand& b, void* out) noexcept {
  detail::polygon::PathShares found;
  const std::int32_t error = with_edges(a, b, [&](const auto& edges, const auto& other, bool) -> std::int32_t {
    return detail::polygon::shares(edges, other, found);
  });
  if (error != 0) return error;
  return a.is_float ? detail::area::store(found.shared, *static_cast<float*>(out))
                    : detail::area::store(found.shared, *static_cast<double*>(out));
}

std::int32_t ratio_of_paths(Ratio which, const Operand& a, const Operand& b, double& out) noexcept {
  return with_edges(a, b, [&](const auto& edges, const auto& other, bool reversed) {
    return detail::polygon::ratio_or_error(which, edges, other, reversed, out);
  });
}

}  // namespace vesica::polygon
