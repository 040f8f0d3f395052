// SPDX-License-Identifier: Apache-2.0
// The work of the index on vectors: one text for all instruction sets, included behind lanes/<set>.hpp. Loops over
// doubles are left to the compiler; they are compiled without contraction, so that every set writes the same bytes.
#pragma once

#include "index/frame.hpp"
#include "index/kernels.hpp"

namespace vesica::index {
namespace {  // an instantiation of its own in each object

// ---- Bounds. ----

/// c - room and c + room, where the extent is e up to three roundings and 2^-1073. With u = 2^-53: the room as computed
/// is at least e (1 + 13 u) + 3.9 u |c| + 2^-1071, which leaves more than u (|c| + room) for the last rounding.
inline void about(double c, double extent, double& low, double& high) noexcept {
  const double room = extent * (1 + 0x1p-49) + (__builtin_fabs(c) * 0x1p-51 + 0x1p-1070);
  low = c - room;
  high = c + room;
}

/// sqrt(x^2 + y^2) where squares of the greater neither overflow nor lose digits, else x + y, which is more.
inline double hypotenuse(double x, double y) noexcept {
  const double most = x > y ? x : y;
  const bool usable = (most >= 0x1p-480) & (most <= 0x1p480);
  const double sx = usable ? x : 1, sy = usable ? y : 1;
  const double root = __builtin_sqrt(sx * sx + sy * sy);
  return usable ? root : x + y;
}

/// 1 where a number is finite, else NaN.
inline double one_if_finite(double x) noexcept { return x * 0 + 1; }

inline void bounds_of_points(const Fields& f, int n, Boxes& out) noexcept {
  for (int i = 0; i < n; ++i) {
    const double x = f.column[0][i], y = f.column[1][i];
    out.min_x[i] = out.max_x[i] = x;
    out.min_y[i] = out.max_y[i] = y;
    out.valid[i] = one_if_finite(x) * one_if_finite(y) == 1;
  }
}

inline void bounds_of_segments(const Fields& f, int n, Boxes& out) noexcept {
  for (int i = 0; i < n; ++i) {
    const double x0 = f.column[0][i], y0 = f.column[1][i], x1 = f.column[2][i], y1 = f.column[3][i];
    out.min_x[i] = x0 < x1 ? x0 : x1;
    out.max_x[i] = x0 < x1 ? x1 : x0;
    out.min_y[i] = y0 < y1 ? y0 : y1;
    out.max_y[i] = y0 < y1 ? y1 : y0;
    out.valid[i] = one_if_finite(x0) * one_if_finite(y0) * one_if_finite(x1) * one_if_finite(y1) == 1;
  }
}

inline void bounds_of_circles(const Fields& f, int n, Boxes& out) noexcept {
  for (int i = 0; i < n; ++i) {
    const double x = f.column[0][i], y = f.column[1][i], r = f.column[2][i];
    about(x, r, out.min_x[i], out.max_x[i]);
    about(y, r, out.min_y[i], out.max_y[i]);
    out.valid[i] = (one_if_finite(x) * one_if_finite(y) * one_if_finite(r) == 1) & (r >= 0);
  }
}

inline void bounds_of_aabbs(const Fields& f, int n, Boxes& out) noexcept {
  for (int i = 0; i < n; ++i) {
    const double x0 = f.column[0][i], y0 = f.column[1][i], x1 = f.column[2][i], y1 = f.column[3][i];
    out.min_x[i] = x0;
    out.min_y[i] = y0;
    out.max_x[i] = x1;
    out.max_y[i] = y1;
    const bool finite = one_if_finite(x0) * one_if_finite(y0) * one_if_finite(x1) * one_if_finite(y1) == 1;
    out.valid[i] = finite & (x0 <= x1) & (y0 <= y1);
  }
}

template <bool Ellipse>
inline void bounds_of_oblique(const Fields& f, int n, Boxes& out) noexcept {
  for (int i = 0; i < n; ++i) {
    const double cx = f.column[0][i], cy = f.column[1][i], ux = f.column[2][i], uy = f.column[3][i];
    const double h0 = f.column[4][i], h1 = f.column[5][i];
    const double x = __builtin_fabs(ux), y = __builtin_fabs(uy);
    about(cx, Ellipse ? hypotenuse(x * h0, y * h1) : x * h0 + y * h1, out.min_x[i], out.max_x[i]);
    about(cy, Ellipse ? hypotenuse(y * h0, x * h1) : y * h0 + x * h1, out.min_y[i], out.max_y[i]);
    const double finite = one_if_finite(cx) * one_if_finite(cy) * one_if_finite(ux) * one_if_finite(uy) *
                          one_if_finite(h0) * one_if_finite(h1);
    out.valid[i] = (finite == 1) & (h0 >= 0) & (h1 >= 0) & ((x > 0) | (y > 0));
  }
}

inline void bounds(std::int32_t kind, const Fields& fields, int n, Boxes& out) noexcept {
  switch (kind) {
    case kind_point:
      return bounds_of_points(fields, n, out);
    case kind_segment:
      return bounds_of_segments(fields, n, out);
    case kind_circle:
      return bounds_of_circles(fields, n, out);
    case kind_aabb:
      return bounds_of_aabbs(fields, n, out);
    case kind_rect:
      return bounds_of_oblique<false>(fields, n, out);
    default:
      return bounds_of_oblique<true>(fields, n, out);
  }
}

// ---- Cells. ----

/// A box's middle; NaN where it has none, which falls into some cell and does not fit there.
inline double middle(double low, double high) noexcept { return low * 0.5 + high * 0.5; }

/// Level by level, so that no item waits for its last step. By single loads, as compilers that make vectors of this take
/// them apart again for each load; and without branches, which nobody could foresee.
inline void descend(const Plan& plan, const double* x, const double* y, int n, std::uint32_t* cell) noexcept {
  const double* const along[2] = {x, y};
  for (int level = descend_first_levels(plan, x, y, n, cell); level < plan.levels; ++level) {
    for (int i = 0; i < n; ++i) {
      std::uint32_t node = cell[i];
      asm("" : "+r"(node));
      const double cut = plan.node[node];
      const bool upper = along[__builtin_bit_cast(std::uint64_t, cut) & 1][i] >= cut;
      cell[i] = 2 * node + 1 + upper;
    }
  }
  const std::uint32_t inner = plan.cells() - 1;
  for (int i = 0; i < n; ++i) cell[i] -= inner;
}

/// A record of four columns below 2^16.
inline Record record_of(std::uint32_t min_x, std::uint32_t min_y, std::uint32_t max_x, std::uint32_t max_y) noexcept {
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
  const std::uint64_t low = min_x | min_y << 16, high = max_x | max_y << 16;
  return __builtin_bit_cast(Record, low | high << 32);
#else
  return {{static_cast<std::uint16_t>(min_x), static_cast<std::uint16_t>(min_y), static_cast<std::uint16_t>(max_x),
           static_cast<std::uint16_t>(max_y)}};
#endif
}

/// The columns of one side; what lies outside of 0 to 65535 is limited to it, and does not fit.
inline void quantise(const double* v, const double* scale, const double* k, int n, std::uint32_t* out) noexcept {
  for (int i = 0; i < n; ++i) {
    constexpr double low = below_all, high = above_all;
    double q = grid_floor(v[i], scale[i]) - k[i];
    q = q < high ? q : high;
    q = q > low ? q : low;
    out[i] = static_cast<std::uint32_t>(static_cast<std::int32_t>(q));
  }
}

inline void assign(const Plan& plan, const Boxes& b, int n, std::uint32_t* cell, Record* out) noexcept {
  alignas(64) double x[chunk], y[chunk], scale[2][chunk], k[2][chunk];
  alignas(64) std::uint32_t side[4][chunk], place[chunk];
  for (int i = 0; i < n; ++i) {
    x[i] = middle(b.min_x[i], b.max_x[i]);
    y[i] = middle(b.min_y[i], b.max_y[i]);
  }
  descend(plan, x, y, n, place);
  for (int i = 0; i < n; ++i) {
    const Cell& c = plan.cell[place[i]];
    scale[0][i] = c.scale[0];
    scale[1][i] = c.scale[1];
    k[0][i] = c.k[0];
    k[1][i] = c.k[1];
  }
  quantise(b.min_x, scale[0], k[0], n, side[0]);
  quantise(b.min_y, scale[1], k[1], n, side[1]);
  quantise(b.max_x, scale[0], k[0], n, side[2]);
  quantise(b.max_y, scale[1], k[1], n, side[3]);
  const std::uint32_t cells = plan.cells();
  for (int i = 0; i < n; ++i) {
    const std::uint32_t outside =
        (side[0][i] < column_low) | (side[1][i] < column_low) | (side[2][i] > column_high) | (side[3][i] > column_high);
    const std::uint32_t wide = b.max_x[i] - b.min_x[i] > b.max_y[i] - b.min_y[i];
    const std::uint32_t misfit = cells + (wide != 0 ? residue_wide : residue_tall);
    const std::uint32_t to = outside != 0 ? misfit : place[i];
    cell[i] = b.valid[i] == 1 ? to : cells + left_out;
  }
  for (int i = 0; i < n; ++i) out[i] = record_of(side[0][i], side[1][i], side[2][i], side[3][i]);
}

// ---- Blocks. ----

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

// ---- Queries. ----

inline std::int32_t meeting_blocks(const View& view, const double (&box)[4], std::int64_t from, std::int32_t room,
                                   std::int64_t* out) noexcept {
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

inline std::uint32_t leaves_meeting(const Block& block, const Window& window) noexcept {
  return meeting(leaf_boxes(block, 0), leaf_boxes(block, 1), leaf_boxes(block, 2), leaf_boxes(block, 3), window) &
         leaves_mask(block.leaves);
}
inline std::uint32_t items_meeting(const Leaf& leaf, const Window& window) noexcept {
  return meeting(leaf.min_x, leaf.min_y, leaf.max_x, leaf.max_y, window);
}

/// Items of the first block that meet the second's box.
inline void select_items(const Block& first, const Block& second, Meetings& out) noexcept {
  const Window window(box_in(first.frame, second));
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
    const Window window(selected_box(out, i));
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

/// Items of the first block that may meet one of the second. A block of few, far apart, has a large box, which all items
/// of the first lie in, and perhaps not one item that comes near these.
inline void select_candidates(const Block& first, const Block& second, Meetings& out) noexcept {
  constexpr int few_leaves = 2, few_items = 24;
  const int leaves = __builtin_popcount(leaves_meeting(second, Window(box_in(second.frame, first))));
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
    std::uint32_t leaves = meeting(min_x, min_y, max_x, max_y, Window(selected_box(out, i))) & all;
    // Of one block with itself, pairs of a lane and a later one.
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
        meeting(leaf[l].min_x, leaf[l].min_y, leaf[l].max_x, leaf[l].max_y, Window(selected_box(m, i)));
    if (m.diagonal && lane / leaf_items == l) items &= ~1u << (lane % leaf_items);
    n += write_pairs(items, item_at(first, static_cast<std::int32_t>(lane)), leaf[l].item, out_first + n,
                     out_second + n);
  }
  m.next = next;
  return n;
}

/// Asks for what lies in so many bytes, to the second cache: the first takes few lines at a time.
inline void ask_for_bytes(const void* begin, std::size_t bytes) noexcept {
  const auto* at = static_cast<const unsigned char*>(begin);
  for (std::size_t i = 0; i < bytes; i += 64) __builtin_prefetch(at + i, 0, 2);
}

inline std::int32_t in_window(const Block& block, const GridBox& box, std::uint32_t* out) noexcept {
  const Window window(box);
  const Leaf* leaf = leaves_of(block);
  const std::uint32_t all = leaves_meeting(block, window);
  constexpr int few = 2;
  if (__builtin_popcount(all) > few) {
    for (std::uint32_t met = all; met != 0; met &= met - 1) ask_for_bytes(leaf + __builtin_ctz(met), sizeof(Leaf));
  }
  std::int32_t n = 0;
  for (std::uint32_t met = all; met != 0; met &= met - 1) {
    const Leaf& l = leaf[__builtin_ctz(met)];
    n += write_items(items_meeting(l, window), l.item, out + n);
  }
  return n;
}

// ---- Distances from below. ----

inline double greater_of(double a, double b) noexcept { return a > b ? a : b; }
inline double lesser_of(double a, double b) noexcept { return a < b ? a : b; }

/// The library's distance errs by less than 4 u of the largest offset or half length, so of both shapes' common extent.
inline constexpr double error_of_extent = 0x1p-48;

inline void child_distances(const Node& node, const Bounding& shape, double* out) noexcept {
  const double(&box)[4] = shape.box;
  for (int i = 0; i < node_children; ++i) {
    const double min_x = node.min_x[i], min_y = node.min_y[i], max_x = node.max_x[i], max_y = node.max_y[i];
    const double x = greater_of(greater_of(min_x - box[2], box[0] - max_x), 0);
    const double y = greater_of(greater_of(min_y - box[3], box[1] - max_y), 0);
    const double extent = greater_of(greater_of(max_x, box[2]) - lesser_of(min_x, box[0]),
                                     greater_of(max_y, box[3]) - lesser_of(min_y, box[1]));
    const double most = greater_of(x, y);
    const bool usable = (most >= 0x1p-480) & (most <= 0x1p480);
    const double sx = usable ? x : 0, sy = usable ? y : 0;
    const double root = __builtin_sqrt(sx * sx + sy * sy), distance = usable ? root : most;
    const double bound = greater_of(distance * shape.factor - (extent * error_of_extent + shape.least), 0);
    out[i] = min_x <= max_x ? bound : __builtin_nan("");
  }
}

/// A shape's box on a block's grid, all lengths times 2^-e, at which nothing that matters over- or underflows.
struct Ruler {
  double unit[2], low[2], high[2];  // along an axis: a column, the shape's ends from the grid's column 0
  double factor, least;             // from such a length to a bound

  Ruler(const Block& block, const Bounding& shape) noexcept {
    const std::int32_t column[4] = {block.box.min_x, block.box.min_y, block.box.max_x + 1, block.box.max_y + 1};
    const Frame& frame = block.frame;
    double extent = 0;
    for (int a = 0; a < 2; ++a) {
      const double size = power_of_two(frame.p[a]);
      const double first = lesser_of(static_cast<double>(frame.k[a] + column[a]) * size, shape.box[a]);
      const double last = greater_of(static_cast<double>(frame.k[a] + column[a + 2]) * size, shape.box[a + 2]);
      extent = greater_of(extent, last - first);
    }
    constexpr int most = 900;
    const int exponent = static_cast<int>(__builtin_bit_cast(std::uint64_t, extent) >> 52) - 1022;
    const int e = exponent > most ? most : exponent < -most ? -most : exponent;
    for (int a = 0; a < 2; ++a) {
      const int p = frame.p[a] - e;
      unit[a] = p < -1022 ? 0 : power_of_two(p);
      low[a] = shape.box[a] * power_of_two(-e);
      high[a] = shape.box[a + 2] * power_of_two(-e);
    }
    factor = shape.factor * power_of_two(e);
    least = extent * error_of_extent + shape.least;
  }
};

/// `boxes` many, in the columns of a block's grid. (column + k) is exact, and so is its product with the unit: at least
/// half of the last place of a sum of such is left by the factor.
inline void column_distances(const Frame& frame, const Ruler& ruler, const std::uint16_t* min_x,
                             const std::uint16_t* min_y, const std::uint16_t* max_x, const std::uint16_t* max_y,
                             int boxes, double* out) noexcept {
  const double kx = static_cast<double>(frame.k[0]), ky = static_cast<double>(frame.k[1]);
  const double unit_x = ruler.unit[0], unit_y = ruler.unit[1], low_x = ruler.low[0], low_y = ruler.low[1];
  const double high_x = ruler.high[0], high_y = ruler.high[1], factor = ruler.factor, least = ruler.least;
  for (int i = 0; i < boxes; ++i) {
    const double x = greater_of((min_x[i] + kx) * unit_x - high_x, low_x - (max_x[i] + (kx + 1)) * unit_x);
    const double y = greater_of((min_y[i] + ky) * unit_y - high_y, low_y - (max_y[i] + (ky + 1)) * unit_y);
    const double apart_x = greater_of(x, 0), apart_y = greater_of(y, 0);
    const double length = __builtin_sqrt(apart_x * apart_x + apart_y * apart_y);
    out[i] = greater_of(length * factor - least, 0);
  }
}

inline void leaf_distances(const Block& block, const Bounding& shape, double* out) noexcept {
  column_distances(block.frame, Ruler(block, shape), leaf_boxes(block, 0), leaf_boxes(block, 1), leaf_boxes(block, 2),
                   leaf_boxes(block, 3), leaf_row(block.leaves), out);
}

inline void item_distances(const Block& block, const Leaf& leaf, const Bounding& shape, double* out) noexcept {
  column_distances(block.frame, Ruler(block, shape), leaf.min_x, leaf.min_y, leaf.max_x, leaf.max_y, leaf_items, out);
}

constexpr Kernels make_kernels(const char* name) noexcept {
  return {name,       bounds,    assign,          finish,         meeting_blocks, meet,
          candidates, in_window, child_distances, leaf_distances, item_distances};
}

}  // namespace
}  // namespace vesica::index
