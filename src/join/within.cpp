// SPDX-License-Identifier: Apache-2.0
#include "join/within.hpp"

#include "index/boxes.hpp"
#include "index/frame.hpp"
#include "join/nearest.hpp"

namespace vesica::index {

namespace {

inline constexpr std::int64_t within_mark = 0x3179;

/// A part's run of places in A's order.
struct Run {
  std::int64_t begin, end;

  explicit Run(const JoinWithin& join) noexcept {
    const std::int64_t placed = View(join.index_a).header().placed;
    const std::int64_t share = placed / join.parts, rest = placed % join.parts;
    begin = share * join.part + (join.part < rest ? join.part : rest);
    end = begin + share + (join.part < rest ? 1 : 0);
  }
};

/// True if two shapes of this kind may be found near though they are farther apart (vesica/within.hpp).
bool is_approximate(std::int32_t kind) noexcept {
  return with_form(kind, []<template <class> class Shape>(Named<Shape>) {
           return detail::form::FormOf<Shape<double>>::outline == detail::form::Outline::round ? 1 : 0;
         }) == 1;
}

bool has_ellipses(const Sets& sets) noexcept {
  for (int i = 0; i < sets.count; ++i) {
    if (is_approximate(sets.set[i].kind)) return true;
  }
  return false;
}

/// Width and height together.
double extent(double min_x, double min_y, double max_x, double max_y) noexcept {
  return (max_x - min_x) + (max_y - min_y);
}

/// The greatest extent of a valid shape.
double greatest_extent(const Kernels& kernels, const Sets& sets) noexcept {
  Boxes boxes;
  double greatest = 0;
  for (int s = 0; s < sets.count; ++s) {
    const Set& set = sets.set[s];
    for (std::int64_t begin = 0; begin < set.count; begin += chunk) {
      const int n = static_cast<int>(set.count - begin < chunk ? set.count - begin : chunk);
      find_boxes(kernels, sets, set, begin, nullptr, n, boxes);
      for (int i = 0; i < n; ++i) {
        const double x = extent(boxes.min_x[i], boxes.min_y[i], boxes.max_x[i], boxes.max_y[i]);
        if (boxes.valid[i] == 1 && x > greatest) greatest = x;
      }
    }
  }
  return greatest;
}

/// Widens a shape's box to a window that holds all shapes within the distance. Two ellipses may be found near though
/// they are farther apart, by less than 9 u of the scale: the largest half length of both shapes, or offset of their
/// centres. The sum of the distance and both extents is at least that. Shapes within a negative distance overlap.
class Room {
 public:
  explicit Room(const JoinWithin& join) noexcept : join_(join), view_(join.index_b) {
    const bool widens = join.distance > 0 && has_ellipses(join.a) && has_ellipses(join.b);
    share_ = widens ? 0x1p-49 : 0;
    const auto& whole = view_.header().bounds;
    size_ = view_.header().placed == 0 ? 0 : extent(whole[0], whole[1], whole[2], whole[3]);
  }

  /// around: the extent of the shape's block, beside which the window should not grow much. The extent of all of B is
  /// known without a look at its shapes, and usually suffices. Otherwise the extent of B's greatest shape is found.
  void widen(double around, double (&box)[4]) noexcept {
    if (!is_of_shapes_ && share_ * size_ > 0x1p-10 * around) {
      size_ = greatest_extent(join_.kernels, join_.b);
      is_of_shapes_ = true;
    }
    const double sizes = share_ == 0 ? 0 : join_.distance + size_ + extent(box[0], box[1], box[2], box[3]);
    const double distance = join_.distance > 0 ? join_.distance : 0;
    const double room = distance * (1 + 0x1p-50) + share_ * sizes + 0x1p-1060;
    for (int side = 0; side < 4; ++side) {
      const double outward = room + 0x1p-51 * __builtin_fabs(box[side]);  // the sum is rounded too
      box[side] += side < 2 ? -outward : outward;
    }
  }

 private:
  const JoinWithin& join_;
  View view_;
  double share_, size_;
  bool is_of_shapes_ = false;
};

/// An item's numbers as doubles, or its polygon.
class Item {
 public:
  Item(const Sets& sets, std::uint32_t item) noexcept : is_float_(sets.is_float) {
    const Set& set = sets.set[sets.of(item)];
    kind = set.kind;
    if (is_row(kind)) {
      read_item(sets, item, number);
    } else if (is_float_) {
      narrow_path_ = path_at<float>(set.paths(), item - set.first);
    } else {
      path_ = path_at<double>(set.paths(), item - set.first);
    }
  }

  /// In its sets' scalar.
  Operand operand() noexcept {
    if (!is_row(kind)) return {kind, is_float_, is_float_ ? static_cast<const void*>(&narrow_path_) : &path_};
    for (int k = 0; k < field_count(kind); ++k) narrow_[k] = static_cast<float>(number[k]);
    return {kind, is_float_, is_float_ ? static_cast<const void*>(narrow_) : number};
  }

  std::int32_t kind;
  double number[max_fields];

 private:
  bool is_float_;
  float narrow_[max_fields];
  Polygon<double> path_;
  Polygon<float> narrow_path_;
};

class Walk {
 public:
  explicit Walk(const JoinWithin& join) noexcept
      : join_(join), a_(join.index_a), b_(join.index_b), self_(join.index_a == join.index_b), room_(join) {}

  /// Calls found(place, block of B, item of A, item of B) for each pair from place `begin`, block `from` on, in order,
  /// as long as it returns true.
  template <class Found>
  void pairs(std::int64_t begin, std::int64_t end, std::int64_t from, const Found& found) noexcept {
    std::int64_t first = 0;  // place of the block's first item
    for (std::int64_t number = 0; number < a_.blocks() && first < end; ++number) {
      const Block& block = a_.block(number);
      const std::int64_t after = first + block.count;
      double around[4];
      a_.box_of(number, around);
      around_ = extent(around[0], around[1], around[2], around[3]);
      for (std::int64_t place = begin > first ? begin : first; place < after && place < end; ++place) {
        if (!pairs_of(place, item_at(block, static_cast<std::int32_t>(place - first)), from, found)) return;
        from = 0;
      }
      first = after;
    }
  }

 private:
  static constexpr std::int32_t block_list = 32;

  template <class Found>
  bool pairs_of(std::int64_t place, std::uint32_t item, std::int64_t from, const Found& found) noexcept {
    double box[4];
    bounds_of_item(join_.kernels, join_.a, item, box);
    room_.widen(around_, box);
    Item shape(join_.a, item);
    std::int64_t list[block_list];
    for (std::int32_t listed = block_list; listed == block_list;) {
      listed = join_.kernels.meeting_blocks(b_, box, from, block_list, list);
      for (std::int32_t i = 0; i < listed; ++i) {
        if (!pairs_in_block(place, item, shape, list[i], box, found)) return false;
        from = list[i] + 1;
      }
    }
    return true;
  }

  template <class Found>
  bool pairs_in_block(std::int64_t place, std::uint32_t item, Item& shape, std::int64_t number, const double (&box)[4],
                      const Found& found) noexcept {
    const Block& block = b_.block(number);
    const std::int32_t n = join_.kernels.in_window(block, to_columns(block.frame, box), candidate_);
    for (std::int32_t i = 0; i < n; ++i) {
      if (self_ && candidate_[i] <= item) continue;
      Item other(join_.b, candidate_[i]);
      const bool rows = is_row(shape.kind) && is_row(other.kind);
      const std::int32_t answer = rows ? join_.near(shape.kind, other.kind)(shape.number, other.number, join_.distance)
                                       : join_.near_path(shape.operand(), other.operand(), join_.distance);
      if (answer <= 0) continue;
      if (!found(place, number, item, candidate_[i])) return false;
    }
    return true;
  }

  const JoinWithin& join_;
  View a_, b_;
  bool self_;
  Room room_;
  double around_ = 0;  // the extent of the block of A
  std::uint32_t candidate_[block_items + leaf_items];
};

}  // namespace

bool within_state_is_sound(const JoinWithin& join, const std::int64_t* state) noexcept {
  if (is_at_beginning(state) || is_at_end(state)) return true;
  const Run run(join);
  return state[0] >= run.begin && state[0] < run.end && state[1] >= 0 && state[1] < View(join.index_b).blocks() &&
         state[2] >= 0 && state[3] == within_mark;
}

std::int64_t count_within(const JoinWithin& join) noexcept {
  const Run run(join);
  std::int64_t pairs = 0;
  Walk(join).pairs(run.begin, run.end, 0, [&](std::int64_t, std::int64_t, std::uint32_t, std::uint32_t) {
    ++pairs;
    return true;
  });
  return pairs;
}

std::int64_t write_within(const JoinWithin& join, std::int64_t* out_a, std::int64_t* out_b, std::int64_t capacity,
                          std::int64_t* state) noexcept {
  if (is_at_end(state)) return 0;
  const Run run(join);
  const bool goes_on = state[3] == within_mark;
  const std::int64_t begin = goes_on ? state[0] : run.begin, from = goes_on ? state[1] : 0;
  std::int64_t skip = goes_on ? state[2] : 0, written = 0;
  std::int64_t place = begin, block = from, in_block = 0;
  bool full = false;
  Walk(join).pairs(begin, run.end, from, [&](std::int64_t at, std::int64_t of_b, std::uint32_t a, std::uint32_t b) {
    if (at != place || of_b != block) {
      place = at;
      block = of_b;
      in_block = skip = 0;
    }
    if (skip > in_block) {
      ++in_block;
      return true;
    }
    full = written == capacity;
    if (full) return false;
    out_a[written] = a;
    out_b[written++] = b;
    ++in_block;
    return true;
  });
  if (full) {
    put_state(state, place, block, in_block, within_mark);
  } else {
    put_end(state);
  }
  return written;
}

}  // namespace vesica::index
