// SPDX-License-Identifier: Apache-2.0
// Queries about how the parts of two shapes meet. They have no batches.
#pragma once

#include "query.hpp"

namespace vesica::queries {

extern const Query de9im, intersection;

}  // namespace vesica::queries

namespace vesica::polygon {

std::int32_t de9im(const Operand& a, const Operand& b, void* out) noexcept;

}  // namespace vesica::polygon
