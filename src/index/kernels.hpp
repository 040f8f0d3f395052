// SPDX-License-Identifier: Apache-2.0
// The kernels of the index: one source, compiled to one object for each instruction set. All write the same bytes.
#pragma once

#include <cstdint>

#include "index/layout.hpp"
#include "index/shapes.hpp"
#include "index/tables.hpp"

namespace vesica::index {

/// Boxes that surely contain their shapes, and whether these are valid.
struct Boxes {
  alignas(64) double min_x[chunk], min_y[chunk], max_x[chunk], max_y[chunk];
  alignas(64) double valid[chunk];  // 1 or 0
};

/// A cell's grid as kernels apply it.
struct Cell {
  double scale[2], k[2];  // 2^-p and k
};

/// The planned cells: the inner nodes of a complete binary tree, and a grid for each leaf. A node's lowest
/// bit is its axis.
struct Plan {
  int levels;
  const double* node;
  const Cell* cell;
  std::uint32_t cells() const noexcept { return std::uint32_t{1} << levels; }
};
/// The pseudo-cells of shapes that do not fit their cell (the residue).
enum : std::uint32_t { residue_wide, residue_tall, left_out, residues };

/// A shape's place and box.
struct Record {
  std::uint16_t side[4];
};

/// A block's items that meet another block, in the other's columns, and what they may meet there: an entry is the place
/// of a selected item times 2^16, plus a leaf's number.
struct Meetings {
  std::int32_t selected, entries, next;
  bool diagonal;
  alignas(64) std::int32_t side[4][block_items + 64];
  alignas(64) std::uint32_t lane[block_items + 64];
  alignas(64) std::uint32_t entry[block_items * block_leaves + 64];
};

/// A shape whose distances to others are bounded from below by boxes alone: its own box; and what computed distances
/// are rounded by, a factor below 1 and a number.
struct Bounding {
  double box[4];
  double factor, least;
  bool boxes_alone;  // this shape and all others are their own boxes
  double sides;      // if not: the sum of the box's sides
};

struct Kernels {
  /// Boxes of n shapes of one kind.
  void (*bounds)(std::int32_t kind, const Fields& fields, int n, Boxes& out) noexcept;
  /// Cells and boxes in their columns; cells() + residue_... for a shape without a place.
  void (*assign)(const Plan& plan, const Boxes& boxes, int n, std::uint32_t* cell, Record* out) noexcept;
  /// Writes the block of n records and their items.
  void (*finish)(const Frame& frame, const Record* record, const std::uint32_t* item, std::int32_t n,
                 Block& out) noexcept;
  /// Numbers, from `from` on and ascending, of blocks whose boxes meet min_x, min_y, max_x, max_y: at most `room`.
  std::int32_t (*meeting_blocks)(const View& view, const double (&box)[4], std::int64_t from, std::int32_t room,
                                 std::int64_t* out) noexcept;
  /// Begins the candidates of two blocks; where they are the same one, its pairs of an item and a later one.
  void (*meet)(const Block& first, const Block& second, bool same, Meetings& out) noexcept;
  /// More of them, as items, at most `room`, which is at least 32: stops where less than 32 places are left.
  std::int32_t (*candidates)(const Block& first, const Block& second, Meetings& meetings, std::int32_t room,
                             std::uint32_t* out_first, std::uint32_t* out_second) noexcept;
  /// Items of a block that meet a box in its columns, in order: room for all of them and 32 more.
  std::int32_t (*in_window)(const Block& block, const GridBox& box, std::uint32_t* out) noexcept;
  /// No more than the distance, as the library computes it, to anything in each child of a node; NaN for no child.
  void (*child_distances)(const Node& node, const Bounding& shape, double* out) noexcept;
  /// The same for the leaves of a block, and for the items of a leaf; behind the last one anything.
  void (*leaf_distances)(const Block& block, const Bounding& shape, double* out) noexcept;
  /// For items also returns by how much their distances exceed these at most, besides a factor of 5 - 4 shape.factor.
  double (*item_distances)(const Block& block, const Leaf& leaf, const Bounding& shape, double* out) noexcept;
};

}  // namespace vesica::index
