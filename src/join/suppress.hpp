// SPDX-License-Identifier: Apache-2.0
// Greedy non-maximum suppression: shapes in the order of their scores, each kept unless its ratio of areas with one
// kept before, of its own label, exceeds a threshold.
//
// Shapes that a kept shape suppresses are marked at once, so that only the first of many equal shapes is ever compared.
// A window query of the index finds them. Shapes are processed block by block of the index, not by score: a shape waits
// for better shapes that may suppress it, which are near it. So memory is read nearly in order. The result is the same,
// since whether a shape is kept depends on better ones alone.
#pragma once

#include <cstdint>

#include "index/kernels.hpp"
#include "join/ratio_bound.hpp"

namespace vesica::index {

/// Compares one shape's ratio with each of n others, all in columns and of one kind, to the threshold: out[i] = 1
/// or 0.
using Exceeds = void (*)(std::int32_t kind, const void* const* one, const void* const* others, std::int64_t n,
                         const Measured& measured, std::uint8_t* out);

struct Suppression {
  const Kernels& kernels;
  const Sets& sets;  // one of 1 to most_items shapes
  Exceeds exceeds;
  Measured measured;
  void* scratch;  // of suppression_bytes
  const std::int32_t* label = nullptr;
  double least_score = -__builtin_inf();
  std::int64_t most = INT64_MAX;  // as many are kept
};

std::int64_t suppression_bytes(std::int64_t items) noexcept;

/// Writes the items that are kept in the order of scores, equal ones by number; returns how many. Shapes below the
/// least score are left out. So are an invalid shape and one whose score is NaN, and these set `left_out`.
template <class T>
std::int64_t suppress(const Suppression& suppression, const T* score, std::int64_t* keep, bool& left_out) noexcept;

}  // namespace vesica::index
