// SPDX-License-Identifier: Apache-2.0
// 32 columns of a grid against one box, by loops that any compiler turns to the vectors it has.
#pragma once

#include <cstdint>

#include "index/layout.hpp"

namespace vesica::index {
namespace {  // a type of its own in each object

struct BoxLanes {
  GridBox box;
  explicit BoxLanes(const GridBox& b) noexcept : box(b) {}
};

/// A bit for each of 32 boxes that meets the window.
inline std::uint32_t meeting(const std::uint16_t* min_x, const std::uint16_t* min_y, const std::uint16_t* max_x,
                             const std::uint16_t* max_y, const BoxLanes& w) noexcept {
  std::uint32_t mask = 0;
  for (int i = 0; i < leaf_items; ++i) {
    const bool meets =
        (min_x[i] <= w.box.max_x) & (min_y[i] <= w.box.max_y) & (max_x[i] >= w.box.min_x) & (max_y[i] >= w.box.min_y);
    mask |= static_cast<std::uint32_t>(meets) << i;
  }
  return mask;
}

inline std::uint32_t meeting_children(const Node& node, const double (&box)[4]) noexcept {
  std::uint32_t mask = 0;
  for (int i = 0; i < node_children; ++i) {
    const bool meets =
        (node.min_x[i] <= box[2]) & (node.min_y[i] <= box[3]) & (node.max_x[i] >= box[0]) & (node.max_y[i] >= box[1]);
    mask |= static_cast<std::uint32_t>(meets) << i;
  }
  return mask;
}

}  // namespace
}  // namespace vesica::index

#include "index/lanes/bits.hpp"
