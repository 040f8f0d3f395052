// SPDX-License-Identifier: Apache-2.0
// Are shapes within a distance? For two shapes by kind and flat numbers, and for arrays. Not a Query, because a Query's
// functions have no parameter for the distance.
#pragma once

#include "batch.hpp"

namespace vesica::queries {

/// The answer for two shapes of the given kinds, or error_shape.
using WithinOfPair = std::int32_t (*)(const double* a, const double* b, double distance) noexcept;
WithinOfPair within(std::int32_t kind_a, std::int32_t kind_b) noexcept;

}  // namespace vesica::queries

namespace vesica::batch {

struct WithinTally {
  std::int64_t count = 0;  // of answers above 0
  std::int32_t error = 0;  // error_shape before any other
};

/// out[i] = the answer for a[i] and b[i], i < n; 0 where a shape is invalid.
template <class T>
WithinTally within_many(const Shapes<T>& a, const Shapes<T>& b, std::int64_t n, double distance,
                        std::uint8_t* out) noexcept;

/// out[i * row_stride + j] = that for a[i] and b[j].
template <class T>
WithinTally within_matrix(const Shapes<T>& a, const Shapes<T>& b, double distance, std::uint8_t* out,
                          std::ptrdiff_t row_stride) noexcept;

}  // namespace vesica::batch
