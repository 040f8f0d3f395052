// SPDX-License-Identifier: Apache-2.0
/// Pairs of edges of two paths, except those whose boxes settle the question. Consecutive edges are neighbours, so
/// boxes about runs of them, in their order, need no sorting and are made within the call.
#pragma once

#include <vesica/polygon/boxes.hpp>
#include <vesica/polygon/edges.hpp>

namespace vesica::detail::polygon {

/// The box that holds two boxes.
constexpr Box together(const Box& a, const Box& b) noexcept {
  return {lesser(a.min_x, b.min_x), lesser(a.min_y, b.min_y), greater(a.max_x, b.max_x), greater(a.max_y, b.max_y)};
}

/// No less than squared_gap() of boxes, or another square right to 8u, if they are at most that far apart.
constexpr double squared_limit(double distance) noexcept { return distance * distance * (1 + 0x1p-50) + 0x1p-1070; }

/// Ranges of at most this many edges are compared edge by edge.
inline constexpr std::int64_t few_edges = 16;

/// A range cut into blocks of equal length, with the box of each.
struct Blocks {
  static constexpr int most = 128;

  Range range(int i) const noexcept {
    const std::int64_t first = all.first + index[i] * length;
    return {first, std::min(first + length, all.last)};
  }

  /// The blocks of a range whose boxes satisfy keeps(box).
  template <class T, class Keeps>
  Blocks(const Edges<T>& edges, const Range& range, Keeps keeps) noexcept
      : all(range), length(std::max(std::min(range.length(), few_edges), (range.length() + most - 1) / most)) {
    const std::int64_t n = (range.length() + length - 1) / length;
    for (std::int64_t i = 0; i < n; ++i) {
      const std::int64_t first = range.first + i * length;
      const Box b = edges.box_of_range({first, std::min(first + length, range.last)});
      if (!keeps(b)) continue;
      box[count] = b;
      index[count++] = static_cast<std::int32_t>(i);
    }
  }

  Range all;
  std::int64_t length;
  int count = 0;
  std::int32_t index[most];
  Box box[most];
};

/// Calls policy.visit(e, i, f, j) for pairs of edges in two ranges, except pairs whose boxes, or the boxes of whose
/// blocks, policy.keeps(box, box) does not keep. Ends once visit returns true, and returns whether it did. box_b holds
/// the second range. A policy may keep less and less; if it has closest_first, the closest blocks are walked first.
template <class T, class Policy>
bool walk_few(const Edges<T>& a, const Range& range_a, const Edges<T>& b, const Range& range_b, const Box& box_b,
              Policy& policy) noexcept {
  return a.for_edges(range_a, [&](const Edge& e, std::int64_t i) {
    const Box box = box_of(e);
    if (!policy.keeps(box, box_b)) return false;
    return b.for_edges(range_b, [&](const Edge& f, std::int64_t j) {
      return policy.keeps(box, box_of(f)) && policy.visit(e, i, f, j);
    });
  });
}

/// Two blocks, or -1 and -1.
struct BlockPair {
  int i = -1, j = -1;
};
/// The first of the closest blocks.
inline BlockPair closest_pair(const Blocks& a, const Blocks& b) noexcept {
  BlockPair closest;
  double least = 0;
  for (int i = 0; i < a.count; ++i) {
    for (int j = 0; j < b.count; ++j) {
      const double gap = squared_gap(a.box[i], b.box[j]);
      if (closest.i >= 0 && !(gap < least)) continue;
      least = gap;
      closest = {i, j};
    }
  }
  return closest;
}

/// The same for ranges of any length. A policy that has visit_few() takes all pairs of short ranges at once. box_a and
/// box_b hold the ranges.
template <class T, class Policy>
bool walk(const Edges<T>& a, const Range& range_a, const Box& box_a, const Edges<T>& b, const Range& range_b,
          const Box& box_b, Policy& policy) noexcept {
  if (range_a.length() <= few_edges && range_b.length() <= few_edges) {
    if constexpr (requires { policy.visit_few(a, range_a, b, range_b, box_b); }) {
      return policy.visit_few(a, range_a, b, range_b, box_b);
    } else {
      return walk_few(a, range_a, b, range_b, box_b, policy);
    }
  }
  const Blocks blocks_a(a, range_a, [&](const Box& box) { return policy.keeps(box, box_b); });
  const Blocks blocks_b(b, range_b, [&](const Box& box) { return policy.keeps(box_a, box); });
  const auto walk_pair = [&](int i, int j) {
    return policy.keeps(blocks_a.box[i], blocks_b.box[j]) &&
           walk(a, blocks_a.range(i), blocks_a.box[i], b, blocks_b.range(j), blocks_b.box[j], policy);
  };
  BlockPair first;
  if constexpr (requires { Policy::closest_first; }) {
    first = closest_pair(blocks_a, blocks_b);
    if (first.i >= 0 && walk_pair(first.i, first.j)) return true;
  }
  for (int i = 0; i < blocks_a.count; ++i) {
    if (!policy.keeps(blocks_a.box[i], box_b)) continue;
    for (int j = 0; j < blocks_b.count; ++j) {
      if (!(i == first.i && j == first.j) && walk_pair(i, j)) return true;
    }
  }
  return false;
}

/// All pairs of edges.
template <class T, class Policy>
bool walk(const Edges<T>& a, const Box& box_a, const Edges<T>& b, const Box& box_b, Policy&& policy) noexcept {
  return walk(a, a.all(), box_a, b, b.all(), box_b, policy);
}

/// The same, in another order where boxes are kept: does visit() return true for any pair?
template <class T, class Policy>
bool any_pair(const Edges<T>& a, const Box& box_a, const Edges<T>& b, const Box& box_b, Policy policy) noexcept {
  if (a.boxes() == nullptr && b.boxes() == nullptr) return walk(a, box_a, b, box_b, policy);
  if (a.boxes() == nullptr) {
    return b.boxes()->for_runs(
        [&](const Range&, const Box& box) { return policy.keeps(box_a, box); },
        [&](const Range& run, const Box& box) { return walk(a, a.all(), box_a, b, run, box, policy); });
  }
  return a.boxes()->for_runs(
      [&](const Range&, const Box& box) { return policy.keeps(box, box_b); },
      [&](const Range& run, const Box& box) { return walk(a, run, box, b, b.all(), box_b, policy); });
}

}  // namespace vesica::detail::polygon
