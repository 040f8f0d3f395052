// SPDX-License-Identifier: Apache-2.0
// 32 columns of a grid against one box in vectors of 8.
#pragma once

#include <arm_neon.h>

#include <cstdint>

#include "index/layout.hpp"

namespace vesica::index {
namespace {  // a type of its own in each object

struct BoxLanes {
  uint16x8_t min_x, min_y, max_x, max_y;
  explicit BoxLanes(const GridBox& b) noexcept
      : min_x(vdupq_n_u16(b.min_x)),
        min_y(vdupq_n_u16(b.min_y)),
        max_x(vdupq_n_u16(b.max_x)),
        max_y(vdupq_n_u16(b.max_y)) {}
};

/// A bit for each of 32 boxes that meets the window.
inline std::uint32_t meeting(const std::uint16_t* min_x, const std::uint16_t* min_y, const std::uint16_t* max_x,
                             const std::uint16_t* max_y, const BoxLanes& w) noexcept {
  const uint16x8_t bit = {1, 2, 4, 8, 16, 32, 64, 128};
  std::uint32_t mask = 0;
  for (int i = 0; i < leaf_items; i += 8) {
    const uint16x8_t x = vandq_u16(vcleq_u16(vld1q_u16(min_x + i), w.max_x), vcgeq_u16(vld1q_u16(max_x + i), w.min_x));
    const uint16x8_t y = vandq_u16(vcleq_u16(vld1q_u16(min_y + i), w.max_y), vcgeq_u16(vld1q_u16(max_y + i), w.min_y));
    mask |= static_cast<std::uint32_t>(vaddvq_u16(vandq_u16(vandq_u16(x, y), bit))) << i;
  }
  return mask;
}

inline std::uint32_t meeting_children(const Node& node, const double (&box)[4]) noexcept {
  std::uint32_t mask = 0;
  for (int i = 0; i < node_children; i += 2) {
    const uint64x2_t x = vandq_u64(vcleq_f64(vld1q_f64(node.min_x + i), vdupq_n_f64(box[2])),
                                   vcgeq_f64(vld1q_f64(node.max_x + i), vdupq_n_f64(box[0])));
    const uint64x2_t y = vandq_u64(vcleq_f64(vld1q_f64(node.min_y + i), vdupq_n_f64(box[3])),
                                   vcgeq_f64(vld1q_f64(node.max_y + i), vdupq_n_f64(box[1])));
    const uint64x2_t both = vandq_u64(x, y);
    mask |= static_cast<std::uint32_t>((vgetq_lane_u64(both, 0) & 1) | (vgetq_lane_u64(both, 1) & 2)) << i;
  }
  return mask;
}

}  // namespace
}  // namespace vesica::index

#include "index/lanes/bits.hpp"
