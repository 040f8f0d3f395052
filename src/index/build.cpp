// SPDX-License-Identifier: Apache-2.0
#include "index/build.hpp"

#include <cstring>

#include "index/boxes.hpp"
#include "index/directory.hpp"
#include "index/frame.hpp"
#include "index/plan.hpp"
#include "index/scratch.hpp"

namespace vesica::index {

namespace {

class Builder {
 public:
  Builder(const Kernels& kernels, const Sets& sets, void* index, void* scratch) noexcept
      : kernels_(kernels),
        sets_(sets),
        index_(static_cast<unsigned char*>(index)),
        scratch_(static_cast<unsigned char*>(scratch)),
        layout_(Layout::of(sets.items)) {}

  State& state() const noexcept { return at<State>(layout_.state); }

  void begin() noexcept {
    state() = {{}, sets_.items, slices_for(sets_.items), 0, 0, 0, sizeof(Header), 0, 0, 0, {}};
    std::memcpy(state().magic, state_magic, sizeof state_magic);
    std::memset(done(1), 0, static_cast<std::size_t>(Layout::done_bytes(layout_.cells)));
    plan(nullptr, sets_.items, full_cell);
  }

  bool begun() const noexcept {
    return std::memcmp(state().magic, state_magic, sizeof state_magic) == 0 && state().items == sets_.items;
  }

  /// One part of a step. Returns false where the step before is not complete, or some of this part is done already.
  bool run(int step, std::int64_t part, std::int64_t parts) noexcept {
    if (step > 1 && count_done(step - 1, {0, units(step - 1)}) != units(step - 1)) return false;
    if (step == build_steps - 1) {
      conclude();
      return true;
    }
    const Share share = share_of(units(step), part, parts);
    if (count_done(step, share) != 0) return false;
    if (share.first == share.last) return true;
    if (step == 1) bin_slices(share);
    if (step == 2) place_slices(share);
    if (step == 3) finish_cells(share.first, share.last, state().slices, state().items, sizeof(Header));
    std::memset(done(step) + share.first, 1, static_cast<std::size_t>(share.last - share.first));
    return true;
  }

 private:
  struct Share {
    std::int64_t first, last;
  };
  static Share share_of(std::int64_t n, std::int64_t part, std::int64_t parts) noexcept {
    if (parts <= n) return {n * part / parts, n * (part + 1) / parts};
    return part < n ? Share{part, part + 1} : Share{n, n};
  }

  /// Steps 1 and 2 are divided by slices of the items, step 3 by cells.
  std::int64_t units(int step) const noexcept { return step == 3 ? std::int64_t{1} << state().levels : state().slices; }
  unsigned char* done(int step) const noexcept { return &at<unsigned char>(layout_.done, (step - 1) * most_slices); }
  std::int64_t count_done(int step, const Share& share) const noexcept {
    std::int64_t n = 0;
    for (std::int64_t i = share.first; i < share.last; ++i) n += done(step)[i];
    return n;
  }

  void bin_slices(const Share& share) noexcept {
    for (std::int64_t s = share.first; s < share.last; ++s) bin(nullptr, s, state().slices);
  }
  void place_slices(const Share& share) noexcept {
    set_positions(share.first, share.last, state().slices, state().items, sizeof(Header), 0);
    for (std::int64_t s = share.first; s < share.last; ++s) place(nullptr, s, state().slices);
  }

  void conclude() noexcept {
    State& s = state();
    account(s.slices, s.items, 0, 0);
    while (s.runs > 0) {
      const Run run = at<Run>(layout_.runs, --s.runs);
      build_run(run);
    }
    write_directory(index_, {s.items, s.placed, s.blocks, s.used});
    s.magic[0] = 0;  // another step needs another beginning
  }

  template <class T>
  T& at(std::int64_t offset, std::int64_t i = 0) const noexcept {
    return reinterpret_cast<T*>(scratch_ + offset)[i];
  }
  std::uint32_t& count(std::int64_t slice, std::int64_t cell) const noexcept {
    return at<std::uint32_t>(layout_.counts, slice * row() + cell);
  }
  std::int64_t& position(std::int64_t slice, std::int64_t cell) const noexcept {
    return at<std::int64_t>(layout_.positions, slice * row() + cell);
  }
  std::int64_t row() const noexcept { return (std::int64_t{1} << state().levels) + residues; }
  Plan plan_view() const noexcept { return {state().levels, &at<double>(layout_.node), &at<Cell>(layout_.cell)}; }

  /// Calls done(first, n, boxes) for boxes of the items begin to end, or of those the list names there.
  template <class Done>
  void each_boxes(const std::uint32_t* list, std::int64_t begin, std::int64_t end, Done done) noexcept {
    Boxes boxes;
    for (std::int64_t i = begin; i < end;) {
      const Set& set = sets_.set[sets_.of(list == nullptr ? i : list[i])];
      const std::int64_t behind = set.first + set.count;
      std::int64_t n = end - i < chunk ? end - i : chunk;
      if (list == nullptr) {
        if (behind - i < n) n = behind - i;
      } else {
        // Lists are ascending: a set's items are together.
        std::int64_t same = 1;
        while (same < n && list[i + same] < behind) ++same;
        n = same;
      }
      find_boxes(kernels_, sets_, set, i - set.first, list == nullptr ? nullptr : list + i, static_cast<int>(n), boxes);
      done(i, static_cast<int>(n), boxes);
      i += n;
    }
  }

  /// Plans cells for the listed items, or all.
  void plan(const std::uint32_t* list, std::int64_t items, std::int64_t cell) noexcept {
    const int levels = levels_for(items, cell);
    state().levels = levels;
    std::int64_t samples = samples_a_cell << levels;
    if (samples < least_samples) samples = least_samples;
    if (samples > items) samples = items;
    Sample* sample = &at<Sample>(layout_.record);
    std::uint32_t some[chunk];
    std::int64_t n = 0;
    for (std::int64_t i = 0; i < samples; i += chunk) {
      const std::int64_t m = samples - i < chunk ? samples - i : chunk;
      for (std::int64_t j = 0; j < m; ++j) {
        const std::int64_t which = (i + j) * items / samples;
        some[j] = list == nullptr ? static_cast<std::uint32_t>(which) : list[which];
      }
      each_boxes(some, 0, m, [&](std::int64_t, int length, const Boxes& b) {
        for (int j = 0; j < length; ++j) n += take_sample(b, j, sample[n]);
      });
    }
    make_plan(sample, sample + samples, n,
              {levels, &at<double>(layout_.node), &at<Cell>(layout_.cell), &at<Frame>(layout_.frame)});
  }

  /// True if the shape can be a sample: valid, with finite bounds.
  static bool take_sample(const Boxes& b, int i, Sample& out) noexcept {
    const double wide = b.max_x[i] - b.min_x[i], tall = b.max_y[i] - b.min_y[i];
    const double x = b.min_x[i] * 0.5 + b.max_x[i] * 0.5, y = b.min_y[i] * 0.5 + b.max_y[i] * 0.5;
    const double finite = wide * 0 + tall * 0 + x * 0 + y * 0;
    if (b.valid[i] != 1 || finite != 0) return false;
    out = {{x, y}, {wide, tall}};
    return true;
  }

  /// Cells and records of a slice of a run of items, and how many of them are in each.
  void bin(const Run* run, std::int64_t slice, std::int64_t slices) noexcept {
    const std::uint32_t* list = run == nullptr ? nullptr : &at<std::uint32_t>(layout_.list, run->begin);
    const std::int64_t items = run == nullptr ? state().items : run->count;
    std::uint32_t* const counts = &count(slice, 0);
    std::memset(counts, 0, static_cast<std::size_t>(row()) * 4);
    const Plan view = plan_view();
    each_boxes(list, items * slice / slices, items * (slice + 1) / slices, [&](std::int64_t i, int n, const Boxes& b) {
      std::uint32_t* const cell = &at<std::uint32_t>(layout_.item_cell, i);
      Record* const record = &at<Record>(layout_.record, i);
      kernels_.assign(view, b, n, cell, record);
      if (state().whole != 0) take_all(view, n, cell, record);
      for (int j = 0; j < n; ++j) ++counts[cell[j]];
    });
  }

  /// In the one frame for all, what is infinite is as far out as the grid goes, and no finite number is.
  static void take_all(const Plan& plan, int n, std::uint32_t* cell, Record* record) noexcept {
    for (int i = 0; i < n; ++i) {
      if (cell[i] == plan.cells() + left_out) continue;
      cell[i] = 0;
      for (std::uint16_t& q : record[i].side) q = q < column_low ? column_low : q > column_high ? column_high : q;
    }
  }

  std::int64_t total(std::int64_t slices, std::int64_t cell) const noexcept {
    std::int64_t n = 0;
    for (std::int64_t s = 0; s < slices; ++s) n += count(s, cell);
    return n;
  }

  /// True if a cell is to be planned on its own: not if that would hardly make it smaller.
  bool is_crowded(std::int64_t in_cell, std::int64_t items) const noexcept {
    return state().whole == 0 && in_cell > crowded_cell && in_cell * 2 < items;
  }

  /// The destination of the shapes of some slices, cell by cell: index bytes, or for those without a place -1 minus
  /// a place in the list.
  void set_positions(std::int64_t first, std::int64_t last, std::int64_t slices, std::int64_t items,
                     std::int64_t offset, std::int64_t list) noexcept {
    const std::int64_t cells = std::int64_t{1} << state().levels;
    for (std::int64_t c = 0; c < cells + left_out; ++c) {
      const std::int64_t all = total(slices, c);
      const bool listed = c >= cells || is_crowded(all, items);
      std::int64_t before = 0;
      for (std::int64_t s = 0; s < last; ++s) {
        if (s >= first) position(s, c) = listed ? -1 - (list + before) : offset + before * record_bytes;
        before += count(s, c);
      }
      if (listed) {
        list += all;
      } else {
        offset += cell_bytes(all);
      }
    }
  }

  /// Writes a slice's records to their cells. In the first run what is left is listed at once.
  void place(const Run* run, std::int64_t slice, std::int64_t slices) noexcept {
    const std::int64_t items = run == nullptr ? state().items : run->count;
    const std::int64_t left = row() - 1;
    std::int64_t* const to = &position(slice, 0);
    const std::uint32_t* const cell = &at<std::uint32_t>(layout_.item_cell);
    const Record* const record = &at<Record>(layout_.record);
    std::uint32_t* const list = &at<std::uint32_t>(layout_.list);
    for (std::int64_t i = items * slice / slices; i < items * (slice + 1) / slices; ++i) {
      if (cell[i] == left) continue;
      std::int64_t& p = to[cell[i]];
      const std::uint32_t item = run == nullptr ? static_cast<std::uint32_t>(i) : list[run->begin + i];
      if (p >= 0) {
        std::memcpy(index_ + p, &record[i], sizeof(Record));
        std::memcpy(index_ + p + sizeof(Record), &item, 4);
        p += record_bytes;
        __builtin_prefetch(index_ + p + alignment, 1);
      } else if (run == nullptr) {
        list[-1 - p--] = item;
      }
    }
  }

  /// Lists again what a later run leaves, in its own stretch of the list, by way of the records, which are placed.
  void list_again(const Run& run) noexcept {
    const std::int64_t left = row() - 1;
    std::int64_t* const to = &position(0, 0);
    const std::uint32_t* const cell = &at<std::uint32_t>(layout_.item_cell);
    std::uint32_t* const list = &at<std::uint32_t>(layout_.list, run.begin);
    std::uint32_t* const spare = &at<std::uint32_t>(layout_.record);
    std::int64_t n = 0;
    for (std::int64_t i = 0; i < run.count; ++i) {
      if (cell[i] == left || to[cell[i]] >= 0) continue;
      spare[-1 - to[cell[i]]-- - run.begin] = list[i];
      ++n;
    }
    std::memcpy(list, spare, static_cast<std::size_t>(n) * 4);
  }

  void finish_cells(std::int64_t first, std::int64_t last, std::int64_t slices, std::int64_t items,
                    std::int64_t offset) noexcept {
    std::int64_t before = 0;
    for (std::int64_t c = 0; c < last; ++c) {
      const std::int64_t all = total(slices, c);
      if (is_crowded(all, items)) continue;
      if (c >= first) finish_cell(c, all, offset, before);
      offset += cell_bytes(all);
      before += all;
    }
  }

  /// Orders a cell's records along one axis and cuts them into blocks. `before` items are in cells before.
  void finish_cell(std::int64_t cell, std::int64_t n, std::int64_t offset, std::int64_t before) noexcept {
    if (n == 0) return;
    Record some_records[crowded_cell];
    std::uint32_t some_items[crowded_cell];
    const bool few = n <= crowded_cell;
    Record* const record = few ? some_records : &at<Record>(layout_.record, before);
    std::uint32_t* const item = few ? some_items : &at<std::uint32_t>(layout_.item_cell, before);
    order(index_ + offset, n, record, item);
    const Frame& frame = at<Frame>(layout_.frame, cell);
    for (std::int64_t begin = 0; begin < n;) {
      const std::int64_t m = first_cut(n - begin);
      kernels_.finish(frame, record + begin, item + begin, static_cast<std::int32_t>(m),
                      *reinterpret_cast<Block*>(index_ + offset));
      offset += block_bytes(m);
      begin += m;
    }
  }

  static Record record_at(const unsigned char* placed, std::int64_t i) noexcept {
    Record r;
    std::memcpy(&r, placed + i * record_bytes, sizeof r);
    return r;
  }

  /// By the low sides along the axis that parts the shapes better, its range over their mean extent; x unless y is 1.5
  /// times better. 1024 steps will do: the order only makes leaves tight.
  static void order(const unsigned char* placed, std::int64_t n, Record* record, std::uint32_t* item) noexcept {
    constexpr int steps = 1024;
    std::int32_t lowest[2] = {65535, 65535}, highest[2] = {0, 0};
    std::int64_t extent[2] = {0, 0};
    for (std::int64_t i = 0; i < n; ++i) {
      const Record r = record_at(placed, i);
      for (int a = 0; a < 2; ++a) {
        const std::int32_t q = r.side[a];
        lowest[a] = q < lowest[a] ? q : lowest[a];
        highest[a] = q > highest[a] ? q : highest[a];
        extent[a] += r.side[a + 2] - q;
      }
    }
    double worth[2];
    for (int a = 0; a < 2; ++a) {
      worth[a] = (highest[a] - lowest[a]) / (static_cast<double>(extent[a]) / static_cast<double>(n) + 1);
    }
    const int axis = worth[1] > 1.5 * worth[0];
    int shift = 0;
    while ((highest[axis] - lowest[axis]) >> shift >= steps) ++shift;
    std::uint32_t place[steps + 1] = {};
    for (std::int64_t i = 0; i < n; ++i) ++place[((record_at(placed, i).side[axis] - lowest[axis]) >> shift) + 1];
    for (int i = 0; i < steps; ++i) place[i + 1] += place[i];
    for (std::int64_t i = 0; i < n; ++i) {
      const Record r = record_at(placed, i);
      const std::uint32_t to = place[(r.side[axis] - lowest[axis]) >> shift]++;
      record[to] = r;
      std::memcpy(&item[to], placed + i * record_bytes + sizeof(Record), 4);
    }
  }

  /// Counts a finished tier and notes the runs it left, the last to be taken up first.
  void account(std::int64_t slices, std::int64_t items, std::int64_t list, int depth) noexcept {
    State& s = state();
    const std::int64_t cells = std::int64_t{1} << s.levels;
    for (std::int64_t c = 0; c < cells; ++c) {
      const std::int64_t all = total(slices, c);
      if (is_crowded(all, items)) {
        note_run({list, all, items, depth + 1, true});
        list += all;
      } else {
        s.used += cell_bytes(all);
        s.blocks += cell_blocks(all);
        s.placed += all;
      }
    }
    for (int r = residue_wide; r <= static_cast<int>(residue_tall); ++r) {
      const std::int64_t all = total(slices, cells + r);
      if (all != 0) note_run({list, all, items, depth + 1, false});
      list += all;
    }
    s.left_out += total(slices, cells + left_out);
  }
  void note_run(const Run& run) noexcept { at<Run>(layout_.runs, state().runs++) = run; }

  /// True if the index surely has room for these cells, and for one frame for each run if nothing finds a place in
  /// them. 12.25 bytes an item, 520 a block and 48 in the directory at most.
  bool has_room(std::int64_t cells) const noexcept {
    const State& s = state();
    const std::int64_t rest = s.items - s.placed - s.left_out, blocks = cells + rest / 512 + s.runs + 3;
    return s.used + s.blocks * 48 + rest * 49 / 4 + blocks * 570 + alignment <= size_bound(s.items);
  }

  /// A tier of its own for shapes that fit no cell of another, or for one crowded cell. Where that hardly helped, one
  /// frame for all of them ends it.
  void build_run(const Run& run) noexcept {
    State& s = state();
    const std::int64_t cell = run.crowded || run.count * 16 > s.items ? full_cell : small_cell;
    const int levels = levels_for(run.count, cell);
    const bool hopeless = !run.crowded && run.count * 8 > run.within * 7;
    s.whole = hopeless || run.depth >= deepest_tier || !has_room(std::int64_t{1} << levels);
    if (s.whole != 0) {
      plan_whole(run);
    } else {
      plan(&at<std::uint32_t>(layout_.list, run.begin), run.count, cell);
    }
    bin(&run, 0, 1);
    set_positions(0, 1, 1, run.count, s.used, run.begin);
    place(&run, 0, 1);
    list_again(run);
    finish_cells(0, std::int64_t{1} << s.levels, 1, run.count, s.used);
    account(1, run.count, run.begin, run.depth);
  }

  void plan_whole(const Run& run) noexcept {
    constexpr double infinity = __builtin_inf();
    double box[4] = {infinity, infinity, -infinity, -infinity};
    each_boxes(&at<std::uint32_t>(layout_.list, run.begin), 0, run.count, [&](std::int64_t, int n, const Boxes& b) {
      for (int i = 0; i < n; ++i) {
        box[0] = b.min_x[i] < box[0] ? b.min_x[i] : box[0];
        box[1] = b.min_y[i] < box[1] ? b.min_y[i] : box[1];
        box[2] = b.max_x[i] > box[2] ? b.max_x[i] : box[2];
        box[3] = b.max_y[i] > box[3] ? b.max_y[i] : box[3];
      }
    });
    state().levels = 0;
    at<Frame>(layout_.frame) = frame_around(box);
    at<Cell>(layout_.cell) = cell_of(at<Frame>(layout_.frame));
  }

  const Kernels& kernels_;
  const Sets& sets_;
  unsigned char* index_;
  unsigned char* scratch_;
  Layout layout_;
};

}  // namespace

std::int64_t size_bound(std::int64_t items) noexcept { return round_up(17 * items + 65536); }
std::int64_t scratch_bound(std::int64_t items) noexcept { return Layout::of(items).bytes; }

bool build_step(const Kernels& kernels, const Sets& sets, int step, std::int64_t part, std::int64_t parts, void* index,
                void* scratch) noexcept {
  Builder builder(kernels, sets, index, scratch);
  if (step == 0) {
    builder.begin();
    return true;
  }
  return builder.begun() && builder.run(step, part, parts);
}

unsigned char* build_in(const Kernels& kernels, const Sets& sets, void* scratch) noexcept {
  const auto misplaced = static_cast<std::int64_t>(reinterpret_cast<std::uintptr_t>(scratch) % alignment);
  unsigned char* const index = static_cast<unsigned char*>(scratch) + (alignment - misplaced) % alignment;
  for (int step = 0; step < build_steps; ++step) {
    build_step(kernels, sets, step, 0, 1, index, index + size_bound(sets.items));
  }
  return index;
}

}  // namespace vesica::index
