// SPDX-License-Identifier: Apache-2.0
/// The library's answers for a pair, in either scalar type, by both the C and the C++ `overlap`.
#pragma once

#include <cstdint>

#include "properties/pair.hpp"

namespace properties {

/// vesica_overlap_f64 or, the numbers narrowed, vesica_overlap_f32.
std::int32_t overlap_by_kind(Scalar scalar, const Pair& pair);

/// The typed function of the pair's kinds; kind_a <= kind_b.
std::int32_t overlap_typed(Scalar scalar, const Pair& pair);

}  // namespace properties
