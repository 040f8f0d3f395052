// SPDX-License-Identifier: Apache-2.0
// Data that the steps of a build pass on, and its layout in the caller's scratch.
#pragma once

#include <cstdint>

#include "index/plan.hpp"

namespace vesica::index {

/// Shapes a cell is planned for: two thirds of that on average. Few shapes that fit no cell are spread over all of the
/// space: in large blocks everything would meet them.
inline constexpr std::int64_t full_cell = 768, small_cell = 64;
/// Samples a cell, and at least. Half of that threw 0.8% of uniform shapes out of their cells' grids.
inline constexpr std::int64_t samples_a_cell = 16, least_samples = 4096;
/// A cell with more shapes was missed by the sample, and is planned on its own.
inline constexpr std::int64_t crowded_cell = 4096;
inline constexpr int deepest_tier = 24;
/// Slices of the items, each with counts of its own, so that a slice's shapes have the same places whoever places them.
inline constexpr std::int64_t most_slices = 32, slice_items = 4096;
inline constexpr std::int64_t record_bytes = sizeof(Record) + 4;

constexpr int levels_for(std::int64_t items, std::int64_t cell) noexcept {
  int levels = 0;
  while ((cell << levels) < items) ++levels;
  return levels;
}
constexpr std::int64_t slices_for(std::int64_t items) noexcept {
  const std::int64_t slices = items / slice_items;
  return slices < 1 ? 1 : slices > most_slices ? most_slices : slices;
}

/// A run of items without places: those listed at [begin, begin + count).
struct Run {
  std::int64_t begin, count, within;  // `within` so many was the run it comes from
  std::int32_t depth;
  bool crowded;
};

/// Data that the steps of a build pass on.
struct State {
  char magic[8];
  std::int64_t items, slices, runs;
  std::int32_t levels, whole;  // `whole`: all in one frame
  std::int64_t used, blocks, placed, left_out;
  double bounds[4];
};
inline constexpr char state_magic[8] = {'V', 'E', 'S', 'B', 'U', 'I', 'L', 'D'};

/// The layout of the scratch.
struct Layout {
  std::int64_t cells, samples, state, done, node, cell, frame, counts, positions, runs, record, item_cell, list, bytes;

  /// A byte for each slice binned, each slice placed, each cell finished.
  static constexpr std::int64_t done_bytes(std::int64_t cells) noexcept { return 2 * most_slices + cells; }

  static constexpr Layout of(std::int64_t items) noexcept {
    Layout l{};
    l.cells = std::int64_t{1} << levels_for(items, full_cell);
    l.samples = samples_a_cell * l.cells < least_samples ? least_samples : samples_a_cell * l.cells;
    const std::int64_t tables = l.cells + 4096, rows = slices_for(items) * (l.cells + residues) + 4096;
    std::int64_t at = 0;
    const auto take = [&at](std::int64_t size) {
      const std::int64_t begin = at;
      at += round_up(size);
      return begin;
    };
    l.state = take(sizeof(State));
    l.done = take(done_bytes(l.cells));
    l.node = take(tables * 8);
    l.cell = take(tables * static_cast<std::int64_t>(sizeof(Cell)));
    l.frame = take(tables * static_cast<std::int64_t>(sizeof(Frame)));
    l.counts = take(rows * 4);
    l.positions = take(rows * 8);
    l.runs = take((items / crowded_cell + 4 * deepest_tier) * static_cast<std::int64_t>(sizeof(Run)));
    // Samples, and as many to part them with, lie where records will.
    const std::int64_t sample_bytes =
        2 * (l.samples < items ? l.samples : items) * static_cast<std::int64_t>(sizeof(Sample));
    l.record = take(items * 8 > sample_bytes ? items * 8 : sample_bytes);
    l.item_cell = take(items * 4);
    l.list = take(items * 4);
    l.bytes = at;
    return l;
  }
};

}  // namespace vesica::index
