// SPDX-License-Identifier: Apache-2.0
/// The library's exact stage alone: what its answers are when no filter decides.
#pragma once

#include <cstdint>

#include "stress/query.hpp"

namespace stress {

/// The answers for valid shapes, as the C functions return them.
std::int32_t exact_overlap(const Pair& pair);
std::int32_t exact_relation(const Pair& pair);

}  // namespace stress
