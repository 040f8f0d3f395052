// SPDX-License-Identifier: Apache-2.0
/// The library's exact stage alone: what its answers are when no filter decides.
#pragma once

#include <cstdint>

#include "stress/query.hpp"

namespace stress {

/// The answers for valid shapes, as the C functions return them.
std::int32_t exact_overlap(const Pair& pair);
/// Where the relation is refused, VESICA_CROSS stands for any whose insides meet. Of an ellipse and a shape with a core
/// and a radius, the library's answer.
std::int32_t exact_relation(const Pair& pair);

}  // namespace stress
