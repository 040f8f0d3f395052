// SPDX-License-Identifier: Apache-2.0
#include "join/select.hpp"

#include <cstring>

#include "index/frame.hpp"

namespace vesica::index {

namespace {

inline constexpr std::int64_t selection_mark = 0x5e1ec7;
inline constexpr std::int32_t wanted = 256, most_segments = 64;

/// Candidates of some blocks, decided together.
class Selector {
 public:
  Selector(const Selection& selection, const double (&box)[4]) noexcept
      : selection_(selection), view_(selection.index), box_(box) {
    gather_first();
  }

  void seek(std::int64_t block) noexcept { from_ = block; }

  /// True if there is more: the next items, though of some blocks none may be left.
  bool next() noexcept {
    count_ = segments_ = 0;
    while (count_ < wanted && segments_ < most_segments) {
      if (listed_ == listed_end_) {
        if (whole_list_) break;
        list_blocks();
        continue;
      }
      const std::int64_t number = blocks_[listed_++];
      const Block& block = view_.block(number);
      const std::int32_t n = selection_.kernels.in_window(block, to_columns(block.frame, box_), item_ + count_);
      if (n == 0) continue;
      segment_block_[segments_] = number;
      segment_begin_[segments_++] = count_;
      count_ += n;
    }
    if (count_ == 0) return false;
    if (selection_.decide != nullptr) {
      decide();
      keep();
    }
    return true;
  }

  std::int32_t count() const noexcept { return count_; }
  int segments() const noexcept { return segments_; }
  std::int64_t segment_block(int k) const noexcept { return segment_block_[k]; }
  const std::uint32_t* segment_items(int k) const noexcept { return item_ + segment_begin_[k]; }
  std::int32_t segment_count(int k) const noexcept {
    return (k + 1 < segments_ ? segment_begin_[k + 1] : count_) - segment_begin_[k];
  }

 private:
  static constexpr std::int32_t block_list = 32;

  void gather_first() noexcept {
    if (selection_.decide == nullptr) return;
    many_.begin();
    const std::uint32_t zero = 0;
    const std::int32_t kind = selection_.one.set[0].kind;
    gather_columns(selection_.one, kind, &zero, 1, 0, many_);
    one_.set(many_, kind);
  }

  void list_blocks() noexcept {
    listed_ = 0;
    listed_end_ = selection_.kernels.meeting_blocks(view_, box_, from_, block_list, blocks_);
    whole_list_ = listed_end_ < block_list;
    if (listed_end_ > 0) from_ = blocks_[listed_end_ - 1] + 1;
    for (std::int32_t i = 0; i < listed_end_; ++i) {
      prefetch_bytes(&view_.block(blocks_[i]), 4 * alignment);
    }
  }

  /// Runs of one kind as they come: items of a block are in no order of kinds, but sets of one kind are usual.
  void decide() noexcept {
    if (selection_.sets->count == 1) return decide_run(selection_.sets->set[0].kind, item_, count_, verdict_);
    std::uint32_t some[room];
    std::uint16_t place[room];
    std::uint8_t verdict[room];
    for (std::int32_t kind = 0; kind < all_kinds; ++kind) {
      std::int32_t n = 0;
      for (std::int32_t i = 0; i < count_; ++i) {
        if (selection_.sets->set[selection_.sets->of(item_[i])].kind != kind) continue;
        place[n] = static_cast<std::uint16_t>(i);
        some[n++] = item_[i];
      }
      if (n == 0) continue;
      decide_run(kind, some, n, verdict);
      for (std::int32_t i = 0; i < n; ++i) verdict_[place[i]] = verdict[i];
    }
  }

  void decide_run(std::int32_t kind, const std::uint32_t* item, std::int32_t n, std::uint8_t* out) noexcept {
    for (std::int32_t i = 0; i < n; i += decided_at_once) {
      const int m = n - i < decided_at_once ? n - i : decided_at_once;
      gather_columns(*selection_.sets, kind, item + i, m, n - i - m, many_);
      selection_.decide(selection_.one.set[0].kind, one_.field, 1, kind, many_.field, m, out + i);
    }
  }

  /// Leaves out the items that the query does not hold for.
  void keep() noexcept {
    std::int32_t n = 0;
    for (int k = 0; k < segments_; ++k) {
      const std::int32_t begin = segment_begin_[k], end = begin + segment_count(k);
      segment_begin_[k] = n;
      for (std::int32_t i = begin; i < end; ++i) {
        item_[n] = item_[i];
        n += verdict_[i];
      }
    }
    count_ = n;
  }

  static constexpr std::int32_t room = wanted + block_items + 64;

  const Selection& selection_;
  View view_;
  const double (&box_)[4];
  std::int64_t from_ = 0, blocks_[block_list], segment_block_[most_segments];
  std::int32_t listed_ = 0, listed_end_ = 0, count_ = 0, segment_begin_[most_segments];
  bool whole_list_ = false;
  int segments_ = 0;
  std::uint32_t item_[room];
  std::uint8_t verdict_[room];
  OneShape one_;
  Columns many_;
};

}  // namespace

std::int64_t count_selected(const Selection& selection, const double (&box)[4]) noexcept {
  Selector selector(selection, box);
  std::int64_t found = 0;
  while (selector.next()) found += selector.count();
  return found;
}

// A state: a block, how many of its items are already written, 0 and a mark.

bool selection_state_is_sound(const Selection& selection, const std::int64_t* state) noexcept {
  if (is_at_beginning(state) || is_at_end(state)) return true;
  return state[0] >= 0 && state[0] < View(selection.index).blocks() && state[1] >= 0 && state[2] == 0 &&
         state[3] == selection_mark;
}

std::int64_t write_selected(const Selection& selection, const double (&box)[4], std::int64_t* out,
                            std::int64_t capacity, std::int64_t* state) noexcept {
  if (is_at_end(state)) return 0;
  Selector selector(selection, box);
  selector.seek(state[0]);
  std::int64_t written = 0;
  while (selector.next()) {
    for (int k = 0; k < selector.segments(); ++k) {
      // A block's items are in one segment.
      const std::int64_t n = selector.segment_count(k), before = selector.segment_block(k) == state[0] ? state[1] : 0;
      const std::int64_t skip = before < n ? before : n, room = capacity - written;
      const std::int64_t taken = n - skip < room ? n - skip : room;
      const std::uint32_t* const item = selector.segment_items(k) + skip;
      for (std::int64_t i = 0; i < taken; ++i) out[written + i] = item[i];
      written += taken;
      if (skip + taken == n) continue;
      put_state(state, selector.segment_block(k), skip + taken, 0, selection_mark);
      return written;
    }
  }
  put_end(state);
  return written;
}

}  // namespace vesica::index
