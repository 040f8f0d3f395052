// SPDX-License-Identifier: Apache-2.0
// A block of up to 1024 items, in leaves with their boxes.
#pragma once

#include "index/frame.hpp"
#include "index/kernels.hpp"

namespace vesica::index {
namespace {  // an instantiation of its own in each object

inline void close_leaf(Leaf& leaf, int n) noexcept {
  for (int i = n; i < leaf_items; ++i) {
    leaf.min_x[i] = leaf.min_y[i] = above_all;
    leaf.max_x[i] = leaf.max_y[i] = below_all;
    leaf.item[i] = 0;
  }
}

template <bool Highest>
inline std::uint16_t extreme(const std::uint16_t* column) noexcept {
  std::uint16_t x = column[0];
  for (int i = 1; i < leaf_items; ++i) x = Highest ? (column[i] > x ? column[i] : x) : (column[i] < x ? column[i] : x);
  return x;
}

inline GridBox leaf_box(const Leaf& leaf) noexcept {
  return {extreme<false>(leaf.min_x), extreme<false>(leaf.min_y), extreme<true>(leaf.max_x), extreme<true>(leaf.max_y)};
}

inline std::uint16_t lesser(std::uint16_t a, std::uint16_t b) noexcept { return a < b ? a : b; }
inline std::uint16_t greater(std::uint16_t a, std::uint16_t b) noexcept { return a > b ? a : b; }

inline void finish(const Frame& frame, const Record* record, const std::uint32_t* item, std::int32_t n,
                   Block& out) noexcept {
  const std::int32_t leaves = (n + leaf_items - 1) / leaf_items, row = leaf_row(leaves);
  out = {frame, n, leaves, {above_all, above_all, below_all, below_all}, {}};
  auto* boxes = reinterpret_cast<std::uint16_t*>(&out + 1);
  auto* leaf = reinterpret_cast<Leaf*>(boxes + 4 * row);
  for (std::int32_t l = 0; l < row; ++l) {
    GridBox box{above_all, above_all, below_all, below_all};
    if (l < leaves) {
      const std::int32_t begin = l * leaf_items, count = n - begin < leaf_items ? n - begin : leaf_items;
      for (std::int32_t i = 0; i < count; ++i) {
        const Record& r = record[begin + i];
        leaf[l].min_x[i] = r.side[0];
        leaf[l].min_y[i] = r.side[1];
        leaf[l].max_x[i] = r.side[2];
        leaf[l].max_y[i] = r.side[3];
        leaf[l].item[i] = item[begin + i];
      }
      close_leaf(leaf[l], count);
      box = leaf_box(leaf[l]);
    }
    boxes[l] = box.min_x;
    boxes[row + l] = box.min_y;
    boxes[2 * row + l] = box.max_x;
    boxes[3 * row + l] = box.max_y;
    out.box = {lesser(out.box.min_x, box.min_x), lesser(out.box.min_y, box.min_y), greater(out.box.max_x, box.max_x),
               greater(out.box.max_y, box.max_y)};
  }
}

}  // namespace
}  // namespace vesica::index
