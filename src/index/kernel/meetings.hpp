// SPDX-License-Identifier: Apache-2.0
// Which blocks, leaves and items meet a window or another block.
#pragma once

#include <limits>

#include "index/frame.hpp"
#include "index/kernels.hpp"

namespace vesica::index {
namespace {  // an instantiation of its own in each object

/// If a node has no child, its sides are infinite and the wrong way round. A box may have infinite sides too, and
/// must not meet that. The sides of a child that is there leave no side of a finite number out.
struct FiniteBox {
  double side[4];
  explicit FiniteBox(const double (&box)[4]) noexcept {
    constexpr double most = std::numeric_limits<double>::max();
    for (int i = 0; i < 4; ++i) side[i] = box[i] > most ? most : box[i] < -most ? -most : box[i];
  }
};

inline std::int32_t meeting_blocks(const View& view, const double (&any_box)[4], std::int64_t from, std::int32_t room,
                                   std::int64_t* out) noexcept {
  const FiniteBox finite(any_box);
  const double(&box)[4] = finite.side;
  struct Step {
    std::int64_t node;
    std::uint32_t children;
  };
  Step stack[max_levels];
  std::int32_t n = 0;
  if (view.levels() == 0) return 0;
  const int top = view.levels() - 1;
  int level = top;
  stack[top] = {0, meeting_children(view.node(top, 0), box)};
  for (;;) {
    Step& step = stack[level];
    if (step.children == 0) {
      if (++level > top) return n;
      continue;
    }
    const std::int64_t child = step.node * node_children + __builtin_ctz(step.children);
    step.children &= step.children - 1;
    if (level == 0) {
      if (child < from) continue;
      out[n++] = child;
      if (n == room) return n;
      continue;
    }
    // The last block below the child; at most 3 * max_levels bits are shifted.
    if ((((child + 1) << (3 * level)) - 1) < from) continue;
    --level;
    stack[level] = {child, meeting_children(view.node(level, child), box)};
  }
}

/// Bits of the leaves that a block has.
inline std::uint32_t leaves_mask(std::int32_t leaves) noexcept {
  return leaves >= block_leaves ? ~0u : (1u << leaves) - 1;
}

/// The second block's box in the first's columns.
inline GridBox box_in(const Frame& to, const Block& block) noexcept {
  const Change x(block.frame, to, 0), y(block.frame, to, 1);
  return {x.low(block.box.min_x), y.low(block.box.min_y), x.high(block.box.max_x), y.high(block.box.max_y)};
}

inline bool same_frame(const Frame& a, const Frame& b) noexcept {
  return (a.k[0] == b.k[0]) & (a.k[1] == b.k[1]) & (a.p[0] == b.p[0]) & (a.p[1] == b.p[1]);
}

/// Columns of selected items into another grid: quick where sums stay within 32 bits, one by one else.
template <bool High>
inline void change_columns(const Change& c, std::int32_t n, std::int32_t* q) noexcept {
  constexpr std::int32_t low = High ? below_all : column_low, high = High ? column_high : above_all;
  constexpr std::int64_t far = 1 << 30;
  if (c.shift >= 0 && c.shift <= 14) {
    const std::int64_t exact = c.k * (std::int64_t{1} << c.shift) - c.other_k + (High ? (1 << c.shift) - 1 : 0);
    const std::int32_t add = static_cast<std::int32_t>(exact > far ? far : exact < -far ? -far : exact);
    const int shift = c.shift;
    for (std::int32_t i = 0; i < n; ++i) {
      const std::int32_t t = (q[i] << shift) + add;
      q[i] = t < low ? low : t > high ? high : t;
    }
  } else if (c.shift < 0 && c.shift >= -28) {
    const int shift = -c.shift;
    const std::int32_t rest = static_cast<std::int32_t>(c.k & ((1 << shift) - 1));
    const std::int64_t exact = (c.k >> shift) - c.other_k;
    const std::int32_t add = static_cast<std::int32_t>(exact > far ? far : exact < -far ? -far : exact);
    for (std::int32_t i = 0; i < n; ++i) {
      const std::int32_t t = ((q[i] + rest) >> shift) + add;
      q[i] = t < low ? low : t > high ? high : t;
    }
  } else {
    for (std::int32_t i = 0; i < n; ++i) q[i] = High ? c.high(q[i]) : c.low(q[i]);
  }
}

inline GridBox selected_box(const Meetings& m, std::int32_t i) noexcept {
  return {static_cast<std::uint16_t>(m.side[0][i]), static_cast<std::uint16_t>(m.side[1][i]),
          static_cast<std::uint16_t>(m.side[2][i]), static_cast<std::uint16_t>(m.side[3][i])};
}

/// Adds the items of a leaf for which there is a bit to those selected.
inline void select_of_leaf(const Leaf& leaf, int number, std::uint32_t items, Meetings& out) noexcept {
  const std::int32_t n = out.selected;
  write_columns(items, leaf.min_x, out.side[0] + n);
  write_columns(items, leaf.min_y, out.side[1] + n);
  write_columns(items, leaf.max_x, out.side[2] + n);
  write_columns(items, leaf.max_y, out.side[3] + n);
  out.selected += write_lanes(items, static_cast<std::uint32_t>(number * leaf_items), out.lane + n);
}

inline std::uint32_t leaves_meeting(const Block& block, const BoxLanes& window) noexcept {
  return meeting(leaf_boxes(block, 0), leaf_boxes(block, 1), leaf_boxes(block, 2), leaf_boxes(block, 3), window) &
         leaves_mask(block.leaves);
}
inline std::uint32_t items_meeting(const Leaf& leaf, const BoxLanes& window) noexcept {
  return meeting(leaf.min_x, leaf.min_y, leaf.max_x, leaf.max_y, window);
}

/// Items of the first block that meet the second's box.
inline void select_items(const Block& first, const Block& second, Meetings& out) noexcept {
  const BoxLanes window(box_in(first.frame, second));
  const Leaf* leaf = leaves_of(first);
  out.selected = 0;
  for (std::uint32_t met = leaves_meeting(first, window); met != 0; met &= met - 1) {
    const int l = __builtin_ctz(met);
    const std::uint32_t items = items_meeting(leaf[l], window);
    if (items != 0) select_of_leaf(leaf[l], l, items, out);
  }
}

/// The selected items' columns, from one grid into another.
inline void change_grid(const Frame& from, const Frame& to, Meetings& out) noexcept {
  if (same_frame(from, to)) return;
  for (int axis = 0; axis < 2; ++axis) {
    const Change change(from, to, axis);
    change_columns<false>(change, out.selected, out.side[axis]);
    change_columns<true>(change, out.selected, out.side[axis + 2]);
  }
}

/// Items of the first block that meet any of those selected of the second, which are few. Whether two items meet does
/// not depend on whose grid they are compared on: q 2^r <= c holds where q <= floor(c / 2^r) does.
inline void select_by_few(const Block& first, const Block& second, Meetings& out) noexcept {
  change_grid(second.frame, first.frame, out);
  const Leaf* leaf = leaves_of(first);
  std::uint32_t items[block_leaves] = {};
  for (std::int32_t i = 0; i < out.selected; ++i) {
    const BoxLanes window(selected_box(out, i));
    for (std::uint32_t met = leaves_meeting(first, window); met != 0; met &= met - 1) {
      const int l = __builtin_ctz(met);
      items[l] |= items_meeting(leaf[l], window);
    }
  }
  out.selected = 0;
  for (int l = 0; l < first.leaves; ++l) {
    if (items[l] != 0) select_of_leaf(leaf[l], l, items[l], out);
  }
}

/// Items of the first block that may meet one of the second. A block of few, far apart, has a large box, which all
/// items of the first lie in, and perhaps not one item that comes near these.
inline void select_candidates(const Block& first, const Block& second, Meetings& out) noexcept {
  constexpr int few_leaves = 2, few_items = 24;
  const int leaves = __builtin_popcount(leaves_meeting(second, BoxLanes(box_in(second.frame, first))));
  out.selected = 0;
  if (leaves == 0) return;
  if (leaves <= few_leaves) {
    select_items(second, first, out);
    if (out.selected == 0) return;
    if (out.selected <= few_items) return select_by_few(first, second, out);
  }
  select_items(first, second, out);
}

inline void meet(const Block& first, const Block& second, bool same, Meetings& out) noexcept {
  out.entries = out.next = 0;
  out.diagonal = same;
  select_candidates(first, second, out);
  change_grid(first.frame, second.frame, out);
  const std::uint16_t *min_x = leaf_boxes(second, 0), *min_y = leaf_boxes(second, 1);
  const std::uint16_t *max_x = leaf_boxes(second, 2), *max_y = leaf_boxes(second, 3);
  const std::uint32_t all = leaves_mask(second.leaves);
  std::int32_t n = 0;
  for (std::int32_t i = 0; i < out.selected; ++i) {
    std::uint32_t leaves = meeting(min_x, min_y, max_x, max_y, BoxLanes(selected_box(out, i))) & all;
    // For one block with itself, pairs of a lane and a later one.
    if (same) leaves &= ~0u << (out.lane[i] / leaf_items);
    n += write_lanes(leaves, static_cast<std::uint32_t>(i) << 16, out.entry + n);
  }
  out.entries = n;
}

inline std::int32_t candidates(const Block& first, const Block& second, Meetings& m, std::int32_t room,
                               std::uint32_t* out_first, std::uint32_t* out_second) noexcept {
  const Leaf* leaf = leaves_of(second);
  std::int32_t n = 0, next = m.next;
  for (; next < m.entries && n + leaf_items <= room; ++next) {
    const std::int32_t i = static_cast<std::int32_t>(m.entry[next] >> 16);
    const std::uint32_t l = m.entry[next] & 0xffff, lane = m.lane[i];
    std::uint32_t items =
        meeting(leaf[l].min_x, leaf[l].min_y, leaf[l].max_x, leaf[l].max_y, BoxLanes(selected_box(m, i)));
    if (m.diagonal && lane / leaf_items == l) items &= ~1u << (lane % leaf_items);
    n += write_pairs(items, item_at(first, static_cast<std::int32_t>(lane)), leaf[l].item, out_first + n,
                     out_second + n);
  }
  m.next = next;
  return n;
}

inline std::int32_t in_window(const Block& block, const GridBox& box, std::uint32_t* out) noexcept {
  const BoxLanes window(box);
  const Leaf* leaf = leaves_of(block);
  const std::uint32_t all = leaves_meeting(block, window);
  constexpr int few = 2;
  if (__builtin_popcount(all) > few) {
    // To the second cache: the first takes few lines at a time.
    for (std::uint32_t met = all; met != 0; met &= met - 1) prefetch_bytes<2>(leaf + __builtin_ctz(met), sizeof(Leaf));
  }
  std::int32_t n = 0;
  for (std::uint32_t met = all; met != 0; met &= met - 1) {
    const Leaf& l = leaf[__builtin_ctz(met)];
    n += write_items(items_meeting(l, window), l.item, out + n);
  }
  return n;
}

}  // namespace
}  // namespace vesica::index
