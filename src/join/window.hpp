// SPDX-License-Identifier: Apache-2.0
// The items of an index whose bounds meet a box.
#pragma once

#include <cstdint>

#include "index/frame.hpp"
#include "index/kernels.hpp"

namespace vesica::index {

/// Calls visit(items, n) with those of each block, in order; it may overwrite them.
template <class Visit>
void each_in_window(const Kernels& kernels, const View& view, const double (&box)[4], const Visit& visit) noexcept {
  constexpr std::int32_t block_list = 32;
  std::int64_t block[block_list];
  std::uint32_t item[block_items + 64];
  for (std::int64_t from = 0;;) {
    const std::int32_t n = kernels.meeting_blocks(view, box, from, block_list, block);
    for (std::int32_t i = 0; i < n; ++i) {
      const Block& b = view.block(block[i]);
      visit(item, kernels.in_window(b, to_columns(b.frame, box), item));
    }
    if (n < block_list) return;
    from = block[n - 1] + 1;
  }
}

}  // namespace vesica::index
