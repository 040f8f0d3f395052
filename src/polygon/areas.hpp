// SPDX-License-Identifier: Apache-2.0
// Areas and ratios with a polygon or a polyline, as answers.hpp has the other queries. Apart from it, since few need
// these.
#pragma once

#include <vesica/ratio.hpp>

#include "polygon/answers.hpp"

namespace vesica::polygon {

std::int32_t area(const Operand& a, const Operand& b, void* out) noexcept;
std::int32_t ratio(Ratio which, const Operand& a, const Operand& b, void* out) noexcept;
template <Ratio which>
std::int32_t ratio(const Operand& a, const Operand& b, void* out) noexcept {
  return ratio(which, a, b, out);
}

}  // namespace vesica::polygon
