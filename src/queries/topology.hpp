// SPDX-License-Identifier: Apache-2.0
// Queries about how the parts of two shapes meet. They have no batches.
#pragma once

#include "query.hpp"

namespace vesica::queries {

extern const Query de9im, intersection;

}  // namespace vesica::queries

namespace vesica::polygon {

std::int32_t de9im(const Operand& a, const Operand& b, void* out) noexcept;
/// out: a detail::polygon::RegionRoom, whose count is the answer. For kinds that it takes together.
std::int32_t intersection(const Operand& a, const Operand& b, void* out) noexcept;
bool has_intersection(std::int32_t kind_a, std::int32_t kind_b) noexcept;

}  // namespace vesica::polygon
