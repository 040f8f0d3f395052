// SPDX-License-Identifier: Apache-2.0
// Soft suppression: keeps the best shape, lowers the scores of those it covers, and repeats.
#pragma once

#include <cstdint>

#include "index/shapes.hpp"

namespace vesica::index {

/// Ratios of one shape with n others, all in columns of doubles and of one kind; NaN where there is none. A polygon is
/// its struct, in the room of max_fields doubles from the first column on.
using Ratios = void (*)(std::int32_t ratio, std::int32_t kind, const double* const* one, const double* const* others,
                        std::int64_t n, double* out);
/// True if a shape is valid, given by its numbers or its struct.
using Valid = bool (*)(std::int32_t kind, const double* numbers);

struct SoftSuppression {
  const Sets& sets;  // one, or none
  Ratios ratios;
  Valid valid;
  std::int32_t ratio;
  bool gaussian;
  double parameter, least_score;
  std::int64_t most;
  const std::int32_t* label;  // null: all are alike
  void* scratch;              // of soft_bytes, aligned to 8
};

std::int64_t soft_bytes(std::int64_t items) noexcept;

/// Writes the items that are kept and the scores they then had; returns how many. An invalid shape, and one whose score
/// is NaN, is left out and sets `left_out`.
template <class T>
std::int64_t suppress_softly(const SoftSuppression& suppression, const T* score, std::int64_t* keep, T* decayed,
                             bool& left_out) noexcept;

}  // namespace vesica::index
