// SPDX-License-Identifier: Apache-2.0
// The parts of an index before and after its blocks: the header, the blocks' places and the tree over them.
#pragma once

#include <cstdint>

#include "index/layout.hpp"

namespace vesica::index {

/// Blocks that lie one behind the other after the header.
struct WrittenBlocks {
  std::int64_t items, placed, blocks;
  std::int64_t end;  // of the last block, in bytes from the header's first
};

/// Completes an index whose blocks are written.
void write_directory(void* index, const WrittenBlocks& written) noexcept;

/// The checksum of header, blocks' fields, places and tree, with 0 for the checksum itself.
std::uint64_t checksum(const View& view) noexcept;

}  // namespace vesica::index
