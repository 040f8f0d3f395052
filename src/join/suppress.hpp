// SPDX-License-Identifier: Apache-2.0
// Greedy non-maximum suppression: shapes in the order of their scores, each kept unless its ratio of areas with one kept
// before exceeds a threshold.
//
// What a kept shape suppresses is marked at once, so that of many equal shapes the first alone is ever compared. A window
// of the index finds whom to compare it with. Shapes are taken block by block of the index, not by score: a shape waits
// for better ones that may suppress it, which lie near. So memory is read nearly in order, and the result is the same, as
// whether a shape is kept depends on better ones alone.
#pragma once

#include <cstdint>

#include "index/kernels.hpp"

namespace vesica::index {

/// Whether one shape's ratio with each of n others, all in columns and of one kind, exceeds the threshold: out[i] = 1 or 0.
using Exceeds = void (*)(std::int32_t kind, const void* const* one, const void* const* others, std::int64_t n,
                         double threshold, std::uint8_t* out);

struct Suppression {
  const Kernels& kernels;
  const Sets& sets;  // one of 1 to most_items shapes
  Exceeds exceeds;
  double threshold;
  void* scratch;  // of suppression_bytes
};

std::int64_t suppression_bytes(std::int64_t items) noexcept;

/// Writes the items that are kept in the order of scores, equal ones by number; returns how many. An invalid shape and
/// one whose score is NaN are left out and set `left_out`.
template <class T>
std::int64_t suppress(const Suppression& suppression, const T* score, std::int64_t* keep, bool& left_out) noexcept;

}  // namespace vesica::index
