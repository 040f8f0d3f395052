// SPDX-License-Identifier: Apache-2.0
// The bytes of an index: header | blocks | places of blocks | tree over blocks. Offsets only, nothing points.
//
// A block holds up to 1024 shapes on a grid of its own: a coordinate v lies in column floor(v 2^-p) - k of the grid,
// kept in 16 bits. Items have columns 1 to 65534, so that 0 and 65535 mean outside. 32 items are a leaf, whose four
// sides and item numbers lie together; the boxes of a block's leaves follow the block's own fields.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vesica/scalar.hpp>

namespace vesica::index {

inline constexpr std::int32_t leaf_items = 32, block_leaves = 32, block_items = leaf_items * block_leaves;
inline constexpr std::int32_t node_children = 8, max_levels = 12;
inline constexpr std::int64_t alignment = 64;

/// Lanes of columns of grids: lowest 1, highest 65534.
inline constexpr std::uint16_t column_low = 1, column_high = 65534, above_all = 65535, below_all = 0;

/// A grid's exponents and offsets, an axis each.
struct Frame {
  std::int64_t k[2];
  std::int32_t p[2];
};
/// Limits of frames. Every finite double lies on the grid of p = 1010, k = -32768; below 2^-1000 nothing is gained.
/// With |k| at most 2^50 every column is an exact double, and far from where grid_floor limits.
inline constexpr std::int32_t least_p = -1000, greatest_p = 1010, universal_k = -32768;
inline constexpr std::int64_t greatest_k = std::int64_t{1} << 50;

/// Four sides in the columns of a grid.
struct GridBox {
  std::uint16_t min_x, min_y, max_x, max_y;
};

struct Leaf {
  std::uint16_t min_x[leaf_items], min_y[leaf_items], max_x[leaf_items], max_y[leaf_items];
  std::uint32_t item[leaf_items];
};
static_assert(sizeof(Leaf) == 384);

/// Followed by four rows of leaf_row(leaves) numbers, the sides of the leaves' boxes, and by the leaves.
struct Block {
  Frame frame;
  std::int32_t count, leaves;
  GridBox box;
  std::uint32_t reserved[6];
};
static_assert(sizeof(Block) == 64);

/// Boxes of eight children, exact: (column + k) 2^p. A child that is not there meets nothing.
struct Node {
  double min_x[node_children], min_y[node_children], max_x[node_children], max_y[node_children];
};
static_assert(sizeof(Node) == 256);

struct Header {
  char magic[8];
  std::uint32_t byte_order, version;
  std::int64_t size;          // bytes of the whole index
  std::int64_t items;         // shapes it was built from, invalid ones included
  std::int64_t placed;        // those that are in a block
  std::int64_t blocks;        //
  std::int64_t places, tree;  // offsets; blocks begin behind the header
  double bounds[4];           // of everything; min above max where nothing is placed
  std::uint64_t checksum;     // of header, blocks' fields, places and tree; that of the header with 0 here
  std::uint64_t reserved[19];
};
static_assert(sizeof(Header) == 256);

inline constexpr char magic[8] = {'V', 'E', 'S', 'I', 'C', 'A', 'I', 'X'};
inline constexpr std::uint32_t byte_order_mark = 0x01020304, format_version = 1;

/// Each row of leaf boxes ends at a multiple of 16 bytes. Kernels read 64 bytes from a row's begin: behind the last row
/// lies a leaf, so what they read too much lies in the block.
constexpr std::int32_t leaf_row(std::int32_t leaves) noexcept { return (leaves + 7) / 8 * 8; }

constexpr std::int64_t block_bytes(std::int64_t items) noexcept {
  const std::int64_t leaves = (items + leaf_items - 1) / leaf_items;
  return static_cast<std::int64_t>(sizeof(Block)) + (leaves + 7) / 8 * 64 +
         leaves * static_cast<std::int64_t>(sizeof(Leaf));
}

/// The items of the next block if `rest` are left in a cell: halves rather than a full block and a small rest.
constexpr std::int64_t first_cut(std::int64_t rest) noexcept {
  if (rest <= block_items) return rest;
  if (rest >= 2 * block_items) return block_items;
  return (rest + 2 * leaf_items - 1) / (2 * leaf_items) * leaf_items;
}

/// Bytes and blocks of a cell with `items` items.
constexpr std::int64_t cell_bytes(std::int64_t items) noexcept {
  std::int64_t bytes = 0;
  for (std::int64_t rest = items; rest > 0; rest -= first_cut(rest)) bytes += block_bytes(first_cut(rest));
  return bytes;
}
constexpr std::int64_t cell_blocks(std::int64_t items) noexcept {
  std::int64_t blocks = 0;
  for (std::int64_t rest = items; rest > 0; rest -= first_cut(rest)) ++blocks;
  return blocks;
}

/// Nodes of the level above `children` nodes.
constexpr std::int64_t nodes_above(std::int64_t children) noexcept {
  return (children + node_children - 1) / node_children;
}
constexpr std::int64_t tree_nodes(std::int64_t blocks) noexcept {
  std::int64_t nodes = 0;
  for (std::int64_t children = blocks; children > 0;) {
    children = nodes_above(children);
    nodes += children;
    if (children == 1) break;
  }
  return nodes;
}
constexpr std::int64_t round_up(std::int64_t bytes, std::int64_t to = alignment) noexcept {
  return (bytes + to - 1) / to * to;
}

/// Bytes of the blocks' places and the tree.
constexpr std::int64_t directory_bytes(std::int64_t blocks) noexcept {
  return round_up(blocks * 4) + tree_nodes(blocks) * static_cast<std::int64_t>(sizeof(Node));
}

/// Prefetches the cache lines of `bytes` bytes: locality 3 to the first cache, 2 to the second.
template <int locality = 3>
VESICA_INLINE void prefetch_bytes(const void* begin, std::size_t bytes) noexcept {
  const auto* at = static_cast<const unsigned char*>(begin);
  for (std::size_t i = 0; i < bytes; i += 64) __builtin_prefetch(at + i, 0, locality);
}

/// A state is four numbers that a call hands to the next one: all 0 at the beginning, -1 first at the end.
VESICA_INLINE bool is_at_beginning(const std::int64_t* state) noexcept {
  return state[0] == 0 && state[1] == 0 && state[2] == 0 && state[3] == 0;
}
VESICA_INLINE bool is_at_end(const std::int64_t* state) noexcept { return state[0] == -1; }
VESICA_INLINE void put_state(std::int64_t* state, std::int64_t a, std::int64_t b, std::int64_t c,
                             std::int64_t d) noexcept {
  state[0] = a;
  state[1] = b;
  state[2] = c;
  state[3] = d;
}
VESICA_INLINE void put_end(std::int64_t* state) noexcept { put_state(state, -1, 0, 0, 0); }

/// An index as queries read it.
class View {
 public:
  VESICA_INLINE explicit View(const void* index) noexcept
      : base_(static_cast<const unsigned char*>(index)),
        places_(reinterpret_cast<const std::uint32_t*>(base_ + header().places)),
        nodes_(reinterpret_cast<const Node*>(base_ + header().tree)) {
    std::int64_t first = 0;
    for (std::int64_t children = blocks(); children > 0 && levels_ < max_levels;) {
      children = nodes_above(children);
      level_[levels_++] = first;
      first += children;
      if (children == 1) break;
    }
  }
  VESICA_INLINE const Header& header() const noexcept { return *reinterpret_cast<const Header*>(base_); }
  VESICA_INLINE std::int64_t items() const noexcept { return header().items; }
  VESICA_INLINE std::int64_t blocks() const noexcept { return header().blocks; }
  VESICA_INLINE const Block& block(std::int64_t i) const noexcept {
    return *reinterpret_cast<const Block*>(base_ + static_cast<std::int64_t>(places_[i]) * alignment);
  }
  VESICA_INLINE void box_of(std::int64_t block, double (&box)[4]) const noexcept {
    const Node& above = node(0, block / node_children);
    const std::int64_t child = block % node_children;
    box[0] = above.min_x[child];
    box[1] = above.min_y[child];
    box[2] = above.max_x[child];
    box[3] = above.max_y[child];
  }
  VESICA_INLINE int levels() const noexcept { return levels_; }
  VESICA_INLINE const Node& node(int level, std::int64_t i) const noexcept { return nodes_[level_[level] + i]; }

 private:
  const unsigned char* base_;
  const std::uint32_t* places_;
  const Node* nodes_;
  std::int64_t level_[max_levels] = {};
  int levels_ = 0;
};

/// Sides of the boxes of a block's leaves: rows 0 to 3 are min_x, min_y, max_x, max_y.
VESICA_INLINE const std::uint16_t* leaf_boxes(const Block& block, int side) noexcept {
  return reinterpret_cast<const std::uint16_t*>(&block + 1) + side * leaf_row(block.leaves);
}
VESICA_INLINE const Leaf* leaves_of(const Block& block) noexcept {
  const auto* rows = reinterpret_cast<const unsigned char*>(&block + 1);
  return reinterpret_cast<const Leaf*>(rows + leaf_row(block.leaves) * 8);
}

/// The block's item at a lane, 0 to 1023.
VESICA_INLINE std::uint32_t item_at(const Block& block, std::int32_t lane) noexcept {
  return leaves_of(block)[lane / leaf_items].item[lane % leaf_items];
}

}  // namespace vesica::index
