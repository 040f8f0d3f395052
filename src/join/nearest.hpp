// SPDX-License-Identifier: Apache-2.0
// The items of an index nearest to a shape, by the library's own distances; equal ones by number.
#pragma once

#include <cstdint>

#include "index/kernels.hpp"
#include "join/decide.hpp"

namespace vesica::index {

/// Writes the distances of one shape, in columns, to n others.
using Measure = void (*)(std::int32_t kind_a, const void* const* a, std::int32_t kind_b, const void* const* b,
                         std::int64_t n, void* distance);

struct Nearest {
  const Kernels& kernels;
  const void* index;
  const Sets& sets;
  Measure measure;
  std::int64_t k;  // at most so many
  double within;   // at most so far
};

/// Writes the nearest items to a valid item of other sets, whose bounds are `box`, nearest first; returns how many.
/// With k = 0 nothing is written, and all within the distance are counted.
template <class T>
std::int64_t find_nearest(const Nearest& query, const Sets& of, std::uint32_t item, const double (&box)[4],
                          std::int64_t* out, T* distance) noexcept;

/// The bounds of an item of sets, and whether it is valid.
bool bounds_of_item(const Kernels& kernels, const Sets& sets, std::uint32_t item, double (&box)[4]) noexcept;

}  // namespace vesica::index
