// SPDX-License-Identifier: Apache-2.0
// All pairs of two indexes, or of one, that are within a distance. For every item of the first, a window query of the
// second with its bounds grown by the distance if that is positive. (The kernels of joins cannot: they compare columns
// of grids.)
#pragma once

#include <cstdint>

#include "index/kernels.hpp"
#include "polygon/answers.hpp"

namespace vesica::index {

/// Decides if two valid shapes are within a distance: above 0 if they are, or may be. Numbers are doubles.
using Near = std::int32_t (*)(const double* a, const double* b, double distance);

struct JoinWithin {
  const Kernels& kernels;
  const void *index_a, *index_b;
  const Sets &a, &b;
  double distance;
  Near (*near)(std::int32_t kind_a, std::int32_t kind_b);
  /// The same with a polygon or a polyline.
  std::int32_t (*near_path)(const Operand& a, const Operand& b, double distance);
  std::int64_t part, parts;
};

/// True if a state is one that such a join returns: the place of an item of A in its order, the block of B, the pairs
/// of both that were written, and a mark.
bool within_state_is_sound(const JoinWithin& join, const std::int64_t* state) noexcept;

/// Pairs of the whole part.
std::int64_t count_within(const JoinWithin& join) noexcept;

/// Writes up to `capacity` > 0 pairs; returns how many, and moves the state on.
std::int64_t write_within(const JoinWithin& join, std::int64_t* out_a, std::int64_t* out_b, std::int64_t capacity,
                          std::int64_t* state) noexcept;

}  // namespace vesica::index
