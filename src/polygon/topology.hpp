// SPDX-License-Identifier: Apache-2.0
// Queries with a polygon or a polyline about how the parts of the two shapes meet.
#pragma once

#include <vesica/contact.hpp>

#include "polygon/answers.hpp"

namespace vesica::polygon {

std::int32_t interiors_overlap(const Operand& a, const Operand& b, void* out) noexcept;
std::int32_t relation(const Operand& a, const Operand& b, void* out) noexcept;
std::int32_t contains(const Operand& a, const Operand& b, void* out) noexcept;

/// Do they have a common point that counts? By the edges.
inline std::int32_t overlap_by_edges(Common common, const Operand& a, const Operand& b) noexcept {
  return common == Common::any ? overlap(a, b, nullptr) : interiors_overlap(a, b, nullptr);
}
inline std::int32_t overlap_of(Common common, const Operand& a, const Operand& b) noexcept {
  const std::int32_t overlap = convex_overlap(a, b);
  return overlap >= 0 ? overlap : overlap_by_edges(common, a, b);
}

}  // namespace vesica::polygon
