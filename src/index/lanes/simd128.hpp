// SPDX-License-Identifier: Apache-2.0
// 32 columns of a grid against one box in vectors of 8.
#pragma once

#include <wasm_simd128.h>

#include <cstdint>

#include "index/layout.hpp"

namespace vesica::index {
namespace {  // a type of its own in each object

struct BoxLanes {
  v128_t min_x, min_y, max_x, max_y;
  explicit BoxLanes(const GridBox& b) noexcept
      : min_x(wasm_u16x8_splat(b.min_x)),
        min_y(wasm_u16x8_splat(b.min_y)),
        max_x(wasm_u16x8_splat(b.max_x)),
        max_y(wasm_u16x8_splat(b.max_y)) {}
};

/// A bit for each of 32 boxes that meets the window.
inline std::uint32_t meeting(const std::uint16_t* min_x, const std::uint16_t* min_y, const std::uint16_t* max_x,
                             const std::uint16_t* max_y, const BoxLanes& w) noexcept {
  std::uint32_t mask = 0;
  for (int i = 0; i < 32; i += 8) {
    const v128_t x = wasm_v128_and(wasm_u16x8_le(wasm_v128_load(min_x + i), w.max_x),
                                   wasm_u16x8_ge(wasm_v128_load(max_x + i), w.min_x));
    const v128_t y = wasm_v128_and(wasm_u16x8_le(wasm_v128_load(min_y + i), w.max_y),
                                   wasm_u16x8_ge(wasm_v128_load(max_y + i), w.min_y));
    mask |= static_cast<std::uint32_t>(wasm_i16x8_bitmask(wasm_v128_and(x, y))) << i;
  }
  return mask;
}

inline std::uint32_t meeting_children(const Node& node, const double (&box)[4]) noexcept {
  std::uint32_t mask = 0;
  const v128_t min_x = wasm_f64x2_splat(box[0]), min_y = wasm_f64x2_splat(box[1]);
  const v128_t max_x = wasm_f64x2_splat(box[2]), max_y = wasm_f64x2_splat(box[3]);
  for (int i = 0; i < node_children; i += 2) {
    const v128_t x = wasm_v128_and(wasm_f64x2_le(wasm_v128_load(node.min_x + i), max_x),
                                   wasm_f64x2_ge(wasm_v128_load(node.max_x + i), min_x));
    const v128_t y = wasm_v128_and(wasm_f64x2_le(wasm_v128_load(node.min_y + i), max_y),
                                   wasm_f64x2_ge(wasm_v128_load(node.max_y + i), min_y));
    mask |= static_cast<std::uint32_t>(wasm_i64x2_bitmask(wasm_v128_and(x, y))) << i;
  }
  return mask;
}

}  // namespace
}  // namespace vesica::index

#include "index/lanes/bits.hpp"
