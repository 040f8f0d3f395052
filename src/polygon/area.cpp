// SPDX-License-Identifier: Apache-2.0
#include <vesica/polygon/ratio.hpp>

#include "polygon/areas.hpp"
#include "polygon/operand.hpp"

namespace vesica::polygon {

namespace {

/// Stores a number in the caller's type.
std::int32_t store(const Operand& a, const detail::area::Measure& x, void* out) noexcept {
  return a.is_float ? detail::area::store(x, *static_cast<float*>(out))
                    : detail::area::store(x, *static_cast<double*>(out));
}

}  // namespace

std::int32_t area(const Operand& a, const Operand& b, void* out) noexcept {
  detail::polygon::PathShares found;
  const std::int32_t error = with_edges(a, b, [&](const auto& edges, const auto& other, bool) -> std::int32_t {
    return detail::polygon::shares(edges, other, found);
  });
  return error != 0 ? error : store(a, found.shared, out);
}

std::int32_t ratio(Ratio which, const Operand& a, const Operand& b, void* out) noexcept {
  double result;
  const std::int32_t error = with_edges(a, b, [&](const auto& edges, const auto& other, bool reversed) {
    return detail::polygon::ratio_or_error(which, edges, other, reversed, result);
  });
  return error != 0 ? error : store(a, {result, 0}, out);
}

}  // namespace vesica::polygon
