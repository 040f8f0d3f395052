// SPDX-License-Identifier: Apache-2.0
#include "join/suppress.hpp"

#include <algorithm>
#include <utility>

#include "index/boxes.hpp"
#include "index/build.hpp"
#include "join/decide.hpp"
#include "join/ranked.hpp"
#include "join/ratio_bound.hpp"
#include "join/window.hpp"

namespace vesica::index {

namespace {

/// The index first, then what its build needs. Once it is built, that room is for the order: its two halves are sorted
/// to and fro, and the free one has other uses before and after. Behind it, columns by place.
struct Parts {
  std::int64_t order, spare, item, rank, extent, bytes;

  explicit Parts(std::int64_t items) noexcept {
    const std::int64_t ranked = round_up(items * static_cast<std::int64_t>(sizeof(Ranked)));
    const std::int64_t build = scratch_bound(items), column = round_up(items * 4);
    order = size_bound(items);
    spare = order + ranked;
    item = order + (2 * ranked < build ? build : 2 * ranked);
    rank = item + column;
    extent = rank + column;
    bytes = extent + round_up(items * static_cast<std::int64_t>(sizeof(Extent))) + alignment;
  }
};

double area_of(std::int32_t kind, const Fields& f, int i) noexcept {
  double numbers[max_fields], area = __builtin_nan("");
  for (int k = 0; k < field_count(kind); ++k) numbers[k] = f.column[k][i];
  with_name(kind, [&]<template <class> class Shape>(Named<Shape>) {
    if constexpr (requires(const Shape<double>& shape) { moderate_area(shape); })
      area = moderate_area(vesica::load<Shape<double>>(numbers));
    return 0;
  });
  return area;
}

// ---- Suppression. ----

/// Shapes are renumbered by their places in the index, so that near shapes are together in memory.
class Suppressor {
 public:
  Suppressor(const Suppression& suppression, unsigned char* scratch) noexcept
      : asked_(suppression),
        kind_(suppression.sets.set[0].kind),
        parts_(suppression.sets.items),
        ratio_bound_(suppression.measured),
        scratch_(scratch),
        item_(column(parts_.item)),
        rank_(column(parts_.rank)),
        extent_(reinterpret_cast<Extent*>(scratch + parts_.extent)) {
    others_.begin();
  }

  /// Numbers the shapes of the index, and finds their bounds and areas.
  void number() noexcept {
    number_by_place();
    for (std::int64_t begin = 0; begin < placed_; begin += chunk) {
      set_extents(begin, static_cast<int>(std::min<std::int64_t>(placed_ - begin, chunk)));
    }
  }

  /// Ranks what may be kept. Sets left_out where a shape is invalid or its score NaN.
  template <class T>
  void order(const T* score, bool& left_out) noexcept {
    auto* const ranked = reinterpret_cast<Ranked*>(scratch_ + parts_.order);
    auto* const spare = reinterpret_cast<Ranked*>(scratch_ + parts_.spare);
    std::uint32_t* const place_of = column(parts_.spare);
    std::fill_n(place_of, asked_.sets.items, closed);
    std::fill_n(rank_, placed_, closed);
    for (std::int64_t place = 0; place < placed_; ++place) place_of[item_[place]] = static_cast<std::uint32_t>(place);
    for (std::int64_t i = 0; i < asked_.sets.items; ++i) {
      const auto s = static_cast<double>(score[i]);
      const bool usable = place_of[i] != closed && s == s;
      left_out |= !usable;
      ranked[count_] = {key_of(s), place_of[i]};
      count_ += usable && s >= asked_.least_score;
    }
    ranked_ = sort_ranked(ranked, spare, count_);
    waiting_ = column(ranked_ == ranked ? parts_.spare : parts_.order);
    for (std::int64_t r = 0; r < count_; ++r) rank_[ranked_[r].place] = static_cast<std::uint32_t>(r);
  }

  std::int64_t keep(std::int64_t* out) noexcept {
    const View view(scratch_);
    for (std::int64_t i = 0; i < view.blocks(); ++i) settle_block(view, i);
    std::int64_t kept = 0;
    for (std::int64_t r = 0; r < count_ && kept < asked_.most; ++r) {
      if (rank_[ranked_[r].place] == is_kept) out[kept++] = item_[ranked_[r].place];
    }
    return kept;
  }

 private:
  static constexpr std::uint32_t closed = UINT32_MAX, is_kept = UINT32_MAX - 1;  // above every rank
  static constexpr std::int32_t block_list = 32, most_listed = 512;

  std::uint32_t* column(std::int64_t at) const noexcept { return reinterpret_cast<std::uint32_t*>(scratch_ + at); }

  void number_by_place() noexcept {
    const View view(scratch_);
    std::uint32_t place = 0;
    for (std::int64_t i = 0; i < view.blocks(); ++i) {
      auto* const leaf = const_cast<Leaf*>(leaves_of(view.block(i)));
      for (std::int32_t lane = 0; lane < view.block(i).count; ++lane, ++place) {
        item_[place] = std::exchange(leaf[lane / leaf_items].item[lane % leaf_items], place);
      }
    }
    placed_ = place;
  }

  [[gnu::noinline]] void set_extents(std::int64_t begin, int n) noexcept {
    Boxes boxes;
    if (!is_row(kind_)) {
      find_boxes(asked_.kernels, asked_.sets, asked_.sets.set[0], 0, item_ + begin, n, boxes);
      for (int i = 0; i < n; ++i) extent_[begin + i] = extent(boxes, i, __builtin_nan(""));
      return;
    }
    Fields fields;
    for (std::int64_t ahead = begin + chunk; ahead < std::min(begin + 2 * chunk, placed_); ++ahead) {
      prefetch(asked_.sets.set[0], item_[ahead]);
    }
    gather(asked_.sets, asked_.sets.set[0], item_ + begin, n, fields);
    asked_.kernels.bounds(kind_, fields, n, boxes);
    for (int i = 0; i < n; ++i) extent_[begin + i] = extent(boxes, i, area_of(kind_, fields, i));
  }
  static Extent extent(const Boxes& boxes, int i, double area) noexcept {
    return {{boxes.min_x[i], boxes.min_y[i], boxes.max_x[i], boxes.max_y[i]}, area};
  }

  /// Settles a block's shapes, the best first: few then wait for one in another block.
  void settle_block(const View& view, std::int64_t number) noexcept {
    const Block& block = view.block(number);
    first_of_block_ = item_at(block, 0);
    end_of_block_ = first_of_block_ + static_cast<std::uint32_t>(block.count);
    list_neighbours(view, number);
    std::uint64_t open[block_items];
    std::int32_t n = 0;
    for (std::int32_t lane = 0; lane < block.count; ++lane) {
      const std::uint32_t place = item_at(block, lane);
      open[n] = std::uint64_t{rank_[place]} << 32 | place;
      n += rank_[place] < is_kept;
    }
    std::sort(open, open + n);
    for (std::int32_t i = 0; i < n; ++i) settle(view, static_cast<std::uint32_t>(open[i]));
  }

  /// Settles a shape, and before it any better one that may suppress it. Each that waits is better than the one before:
  /// no more wait than there are.
  void settle(const View& view, std::uint32_t place) noexcept {
    std::int64_t depth = 0;
    waiting_[depth++] = place;
    while (depth > 0) {
      const std::uint32_t last = waiting_[depth - 1];
      if (rank_[last] >= is_kept) {
        --depth;
        continue;
      }
      find_open(view, last);
      if (best_ < rank_[last]) {
        waiting_[depth++] = ranked_[best_].place;
      } else {
        rank_[last] = is_kept;
        close_near(view, last);
        --depth;
      }
    }
  }

  /// The blocks that any shape of a block may meet, with their boxes.
  void list_neighbours(const View& view, std::int64_t number) noexcept {
    double box[4];
    view.box_of(number, box);
    neighbours_ = asked_.kernels.meeting_blocks(view, box, 0, block_list, neighbour_);
    for (std::int32_t i = 0; i < neighbours_; ++i) view.box_of(neighbour_[i], neighbour_box_[i]);
  }

  static bool meets(const double (&a)[4], const double (&b)[4]) noexcept {
    return (a[0] <= b[2]) & (a[1] <= b[3]) & (a[2] >= b[0]) & (a[3] >= b[1]);
  }

  /// Calls visit(places, n) with those of each block that meet the bounds of the shape at a place.
  template <class Visit>
  void each_block_near(const View& view, std::uint32_t at, const Visit& visit) const noexcept {
    const Extent& extent = extent_[at];
    // Shapes of this block; if the list is full, there may be more.
    if (at < first_of_block_ || at >= end_of_block_ || neighbours_ == block_list) {
      return each_in_window(asked_.kernels, view, extent.box, visit);
    }
    std::uint32_t place[block_items + 64];
    for (std::int32_t i = 0; i < neighbours_; ++i) {
      if (!meets(neighbour_box_[i], extent.box)) continue;
      const Block& b = view.block(neighbour_[i]);
      visit(place, asked_.kernels.in_window(b, to_columns(b.frame, extent.box), place));
    }
  }

  bool same_label(std::uint32_t p, std::uint32_t q) const noexcept {
    return asked_.label == nullptr || asked_.label[item_[p]] == asked_.label[item_[q]];
  }

  /// Calls found(other) for the open ones of n that may suppress a shape, or it them.
  template <class Found>
  void each_open(std::uint32_t place, const std::uint32_t* other, std::int32_t n, const Found& found) const noexcept {
    for (std::int32_t i = 0; i < n; ++i) {
      const bool open = rank_[other[i]] < is_kept;
      if ((open & ratio_bound_.may_exceed(extent_[place], extent_[other[i]])) && same_label(place, other[i]))
        found(other[i]);
    }
  }

  /// Lists what is open near a shape, and finds the best of it.
  void find_open(const View& view, std::uint32_t place) noexcept {
    const std::uint32_t own = std::exchange(rank_[place], closed);
    best_ = closed;
    open_count_ = 0;
    each_block_near(view, place, [&](const std::uint32_t* near, std::int32_t n) {
      each_open(place, near, n, [&](std::uint32_t other) {
        best_ = std::min(best_, rank_[other]);
        if (open_count_ < most_listed) open_[open_count_] = other;
        ++open_count_;
      });
    });
    rank_[place] = own;
  }

  /// Closes what a kept shape suppresses: of the list, or where that is not all, once more by windows.
  void close_near(const View& view, std::uint32_t place) noexcept {
    if (open_count_ == 0) return;
    const std::uint32_t item = item_[place];
    gather_columns(asked_.sets, kind_, &item, 1, 0, others_);
    one_.set(others_, kind_);
    if (open_count_ <= most_listed) return close_some(open_, open_count_);
    each_block_near(view, place, [&](std::uint32_t* near, std::int32_t n) {
      std::int32_t open = 0;
      each_open(place, near, n, [&](std::uint32_t other) { near[open++] = other; });
      close_some(near, open);
    });
  }

  void close_some(const std::uint32_t* place, std::int32_t n) noexcept {
    for (std::int32_t i = 0; i < n; i += decided_at_once) {
      const int m = std::min(n - i, decided_at_once);
      std::uint32_t item[decided_at_once];
      std::uint8_t exceeds[decided_at_once];
      for (int k = 0; k < m; ++k) item[k] = item_[place[i + k]];
      gather_columns(asked_.sets, kind_, item, m, 0, others_);
      asked_.exceeds(kind_, one_.field, others_.field, m, asked_.measured, exceeds);
      for (int k = 0; k < m; ++k) {
        if (exceeds[k] != 0) rank_[place[i + k]] = closed;
      }
    }
  }

  const Suppression& asked_;
  const std::int32_t kind_;
  const Parts parts_;
  const RatioBound ratio_bound_;
  unsigned char* const scratch_;
  std::uint32_t *const item_, *const rank_;  // by place; a rank is the place in the order, closed or is_kept
  Extent* const extent_;
  std::int64_t placed_ = 0, count_ = 0;
  const Ranked* ranked_ = nullptr;
  std::uint32_t* waiting_ = nullptr;
  std::uint32_t best_ = closed, open_[most_listed];  // near the shape looked at
  std::int32_t open_count_ = 0;
  std::uint32_t first_of_block_ = 0, end_of_block_ = 0;  // places of the block looked at
  std::int32_t neighbours_ = 0;
  std::int64_t neighbour_[block_list];
  double neighbour_box_[block_list][4];
  OneShape one_;
  Columns others_;
};

template <class T>
[[gnu::noinline]] std::int64_t keep_best(const Suppression& suppression, const T* score, unsigned char* scratch,
                                         std::int64_t* keep, bool& left_out) noexcept {
  Suppressor suppressor(suppression, scratch);
  suppressor.number();
  left_out = false;
  suppressor.order(score, left_out);
  return suppressor.keep(keep);
}

}  // namespace

std::int64_t suppression_bytes(std::int64_t items) noexcept { return Parts(items).bytes; }

template <class T>
std::int64_t suppress(const Suppression& suppression, const T* score, std::int64_t* keep, bool& left_out) noexcept {
  unsigned char* const scratch = build_in(suppression.kernels, suppression.sets, suppression.scratch);
  return keep_best(suppression, score, scratch, keep, left_out);
}

template std::int64_t suppress(const Suppression&, const float*, std::int64_t*, bool&) noexcept;
template std::int64_t suppress(const Suppression&, const double*, std::int64_t*, bool&) noexcept;

}  // namespace vesica::index
