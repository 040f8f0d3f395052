// SPDX-License-Identifier: Apache-2.0
// Masks of lanes to lists, bit by bit: masks are sparse.
#pragma once

#include <cstdint>

#include "index/kernels.hpp"
#include "index/layout.hpp"

namespace vesica::index {
namespace {  // a type of its own in each object

/// The nodes of a plan that items have come to after some levels; returns how many. Here the root, after none.
inline int descend_first_levels(const Plan&, const double*, const double*, int n, std::uint32_t* node) noexcept {
  for (int i = 0; i < n; ++i) node[i] = 0;
  return 0;
}

/// Writes base + i for each bit i; may write up to 32 numbers. Returns how many bits there are.
inline std::int32_t write_lanes(std::uint32_t mask, std::uint32_t base, std::uint32_t* out) noexcept {
  std::int32_t n = 0;
  for (; mask != 0; mask &= mask - 1) out[n++] = base + static_cast<std::uint32_t>(__builtin_ctz(mask));
  return n;
}

/// Writes item[i] for each bit i.
inline std::int32_t write_items(std::uint32_t mask, const std::uint32_t* item, std::uint32_t* out) noexcept {
  std::int32_t n = 0;
  for (; mask != 0; mask &= mask - 1) out[n++] = item[__builtin_ctz(mask)];
  return n;
}

/// Writes item[i] for each bit i, and beside it `first`.
inline std::int32_t write_pairs(std::uint32_t mask, std::uint32_t first, const std::uint32_t* item,
                                std::uint32_t* out_first, std::uint32_t* out_second) noexcept {
  std::int32_t n = 0;
  for (; mask != 0; mask &= mask - 1) {
    out_first[n] = first;
    out_second[n++] = item[__builtin_ctz(mask)];
  }
  return n;
}

/// Writes column[i] for each bit i.
inline void write_columns(std::uint32_t mask, const std::uint16_t* column, std::int32_t* out) noexcept {
  for (; mask != 0; mask &= mask - 1) *out++ = column[__builtin_ctz(mask)];
}

}  // namespace
}  // namespace vesica::index
