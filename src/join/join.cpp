// SPDX-License-Identifier: Apache-2.0
#include "join/join.hpp"

#include <cstring>
#include <vesica/exact/limbs.hpp>

#include "index/layout.hpp"

namespace vesica::index {

namespace {

inline constexpr int batch = 4096, wanted_at_most = batch - 2 * leaf_items, most_segments = 2048, block_list = 256,
                     weighed = 4096;

/// The fewest candidates for which fetched records are kept.
inline constexpr int worth_keeping = 1024;

/// Candidates of one pair of blocks begin here in the batch, with this entry of its meetings.
struct Segment {
  std::int64_t block_a, block_b;
  std::int32_t begin, entry;
};

struct Scratch {
  Meetings meetings;
  std::uint32_t a[batch + 64], b[batch + 64];
  std::uint32_t sorted_a[batch], sorted_b[batch];
  std::uint16_t order[batch];
  std::uint8_t key[batch], sorted[batch], verdict[batch + 64];
  double value[batch], sorted_value[batch];
  Columns columns_a, columns_b;
  Recent recent;
  Segment segment[most_segments];
  std::int64_t blocks[block_list];
  std::int64_t weight[weighed];
};

/// The join that a state belongs to, so that another join's is refused: 15 bits of a mix.
std::int64_t mark_of(const Join& join) noexcept {
  std::uint64_t h = join.query + 1;
  const std::int64_t of[] = {join.part, join.parts, View(join.a.index).blocks(), View(join.b.index).blocks()};
  for (const std::int64_t x : of) {
    h = (h ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
  }
  return static_cast<std::int64_t>(h & 0x7fff) | 1;
}

class Runner {
 public:
  explicit Runner(const Join& join) noexcept
      : join_(join),
        a_(join.a.index),
        b_(join.b.index),
        self_(join.a.index == join.b.index),
        scratch_(*static_cast<Scratch*>(join.scratch)) {
    scratch_.columns_a.begin();
    scratch_.columns_b.begin();
  }

  /// Is weight / all at least part / parts?
  bool is_share(std::int64_t weight, std::int64_t all, std::int64_t part) const noexcept {
    const auto product = [](std::int64_t a, std::int64_t b) {
      return exact::detail::multiply_add(static_cast<exact::Limb>(a), static_cast<exact::Limb>(b), 0, 0);
    };
    const exact::detail::LimbPair share = product(weight, join_.parts), least = product(all, part);
    return share.high != least.high ? share.high > least.high : share.low >= least.low;
  }

  /// The part's run of A's blocks, cut by weight: a block's items times the blocks they meet. Of many blocks every few
  /// are weighed.
  void find_range() noexcept {
    first_ = 0;
    last_ = a_.blocks();
    if (join_.parts == 1 || last_ == 0) return;
    const std::int64_t group = (last_ + weighed - 1) / weighed, groups = (last_ + group - 1) / group;
    std::int64_t all = 0;
    for (std::int64_t g = 0; g < groups; ++g) all += scratch_.weight[g] = weight_of(g * group);
    std::int64_t before = 0, first = groups, last = groups;
    for (std::int64_t g = groups; g-- > 0;) {
      before += scratch_.weight[g];
      if (is_share(all - before, all, join_.part)) first = g;
      if (is_share(all - before, all, join_.part + 1)) last = g;
    }
    first_ = first * group < last_ ? first * group : last_;
    last_ = last * group < last_ ? last * group : last_;
  }

  void set_range(std::int64_t first, std::int64_t last) noexcept {
    first_ = first;
    last_ = last;
  }
  std::int64_t first() const noexcept { return first_; }
  std::int64_t last() const noexcept { return last_; }

  /// Begins at an entry of block_a with block_b. (Of a made-up state, whose blocks do not meet, at what follows.)
  void begin_at(std::int64_t block_a, std::int64_t block_b, std::int32_t entry) noexcept {
    block_a_ = block_a;
    next_b_ = block_b;
    first_entry_ = entry;
  }

  /// The next candidates, about `wanted` and at most 32 more: returns how many, 0 at the end.
  std::int32_t gather(std::int32_t wanted) noexcept {
    Scratch& s = scratch_;
    std::int32_t n = 0;
    segments_ = 0;
    while (n < wanted && segments_ < most_segments) {
      if (!open_ && !next_pair()) break;
      s.segment[segments_++] = {block_a_, block_b_, n, s.meetings.next};
      const Block &first = a_.block(block_a_), &second = b_.block(block_b_);
      const std::int32_t found =
          join_.kernels.candidates(first, second, s.meetings, wanted - n + leaf_items, s.a + n, s.b + n);
      if (self_) put_in_order(n, found);
      n += found;
      open_ = s.meetings.next < s.meetings.entries;
      if (!open_ && found == 0) --segments_;
      if (open_) break;  // enough
    }
    return n;
  }

  void decide(std::int32_t n) noexcept {
    Scratch& s = scratch_;
    keep_recent(n);
    if (join_.decide == nullptr && join_.ratio.decide == nullptr) {
      std::memset(s.verdict, 1, static_cast<std::size_t>(n));
    } else if (join_.a.sets->count == 1 && join_.b.sets->count == 1) {
      decide_run(join_.a.sets->set[0].kind, join_.b.sets->set[0].kind, s.a, s.b, n, s.verdict, s.value);
    } else {
      decide_mixed(n);
    }
  }

  const Segment& segment(int i) const noexcept { return scratch_.segment[i]; }
  int segments() const noexcept { return segments_; }
  const Scratch& scratch() const noexcept { return scratch_; }

 private:
  std::int64_t weight_of(std::int64_t block) noexcept {
    double box[4];
    a_.box_of(block, box);
    std::int64_t met = 1;
    for (std::int64_t from = self_ ? block : 0;;) {
      const std::int32_t n = join_.kernels.meeting_blocks(b_, box, from, block_list, scratch_.blocks);
      met += n;
      if (n < block_list) break;
      from = scratch_.blocks[n - 1] + 1;
    }
    return met * a_.block(block).count;
  }

  /// The next pair of blocks whose boxes meet, and the beginning of its candidates.
  bool next_pair() noexcept {
    while (listed_ == listed_end_) {
      if (whole_list_) {
        if (block_a_ + 1 >= last_) return false;
        ++block_a_;
        next_b_ = 0;
        whole_list_ = false;
      }
      double box[4];
      a_.box_of(block_a_, box);
      const std::int64_t from = self_ && next_b_ < block_a_ ? block_a_ : next_b_;
      listed_ = 0;
      listed_end_ = join_.kernels.meeting_blocks(b_, box, from, block_list, scratch_.blocks);
      whole_list_ = listed_end_ < block_list;
      if (listed_end_ > 0) next_b_ = scratch_.blocks[listed_end_ - 1] + 1;
    }
    block_b_ = scratch_.blocks[listed_++];
    Meetings& m = scratch_.meetings;
    join_.kernels.meet(a_.block(block_a_), b_.block(block_b_), self_ && block_a_ == block_b_, m);
    m.next = first_entry_ < m.entries ? first_entry_ : m.entries;
    first_entry_ = 0;
    return true;
  }

  /// Pairs of one set have the lower item first.
  void put_in_order(std::int32_t begin, std::int32_t n) noexcept {
    std::uint32_t *a = scratch_.a + begin, *b = scratch_.b + begin;
    for (std::int32_t i = 0; i < n; ++i) {
      const std::uint32_t low = a[i] < b[i] ? a[i] : b[i], high = a[i] < b[i] ? b[i] : a[i];
      a[i] = low;
      b[i] = high;
    }
  }

  /// Records are kept where there are many candidates and their items lie anywhere: of arrays in spatial order, the
  /// processor's own caches do as well.
  void keep_recent(std::int32_t n) noexcept {
    const std::uint32_t* b = scratch_.b;
    std::int32_t far_apart = 0;
    for (std::int32_t i = 1; i < n; ++i) {
      constexpr std::uint32_t near = 1 << 12;
      far_apart += static_cast<std::int32_t>(b[i] - b[i - 1] + near > 2 * near);
    }
    recent_ = nullptr;
    if (n < worth_keeping || far_apart * 4 < n) return;
    recent_ = &scratch_.recent;
    if (!recent_begun_) recent_->begin();
    recent_begun_ = true;
  }

  /// Pairs of one pair of kinds.
  void decide_run(std::int32_t kind_a, std::int32_t kind_b, const std::uint32_t* a, const std::uint32_t* b,
                  std::int32_t n, std::uint8_t* out, double* value) noexcept {
    Scratch& s = scratch_;
    constexpr int most = decided_at_once;
    const auto length = [n](std::int32_t i) { return n - i < most ? n - i : most; };
    for (std::int32_t i = 0; i < n; i += most) {
      const int m = length(i);
      gather_columns(*join_.a.sets, kind_a, a + i, m, n - i - m, s.columns_a, recent_, 0);
      gather_columns(*join_.b.sets, kind_b, b + i, m, n - i - m, s.columns_b, recent_, Recent::of_second);
      if (join_.ratio.decide != nullptr) {
        join_.ratio.decide(join_.ratio, kind_a, s.columns_a, kind_b, s.columns_b, m, out + i, value + i);
      } else if (join_.reversed) {
        join_.decide(kind_b, s.columns_b.field, m, kind_a, s.columns_a.field, m, out + i);
      } else {
        join_.decide(kind_a, s.columns_a.field, m, kind_b, s.columns_b.field, m, out + i);
      }
    }
  }

  /// Sorts by pair of kinds, decides each run, and puts the verdicts back in the candidates' places.
  void decide_mixed(std::int32_t n) noexcept {
    Scratch& s = scratch_;
    std::int32_t begin[all_kinds * all_kinds + 1] = {};
    for (std::int32_t i = 0; i < n; ++i) {
      const std::int32_t kind_a = join_.a.sets->set[join_.a.sets->of(s.a[i])].kind;
      const std::int32_t kind_b = join_.b.sets->set[join_.b.sets->of(s.b[i])].kind;
      s.key[i] = static_cast<std::uint8_t>(kind_a * all_kinds + kind_b);
      ++begin[s.key[i] + 1];
    }
    for (int k = 0; k < all_kinds * all_kinds; ++k) begin[k + 1] += begin[k];
    std::int32_t place[all_kinds * all_kinds];
    std::memcpy(place, begin, sizeof place);
    for (std::int32_t i = 0; i < n; ++i) {
      const std::int32_t to = place[s.key[i]]++;
      s.order[to] = static_cast<std::uint16_t>(i);
      s.sorted_a[to] = s.a[i];
      s.sorted_b[to] = s.b[i];
    }
    for (int k = 0; k < all_kinds * all_kinds; ++k) {
      const std::int32_t from = begin[k], length = begin[k + 1] - from;
      if (length == 0) continue;
      decide_run(k / all_kinds, k % all_kinds, s.sorted_a + from, s.sorted_b + from, length, s.sorted + from,
                 s.sorted_value + from);
    }
    for (std::int32_t i = 0; i < n; ++i) s.verdict[s.order[i]] = s.sorted[i];
    if (join_.ratio.decide == nullptr) return;
    for (std::int32_t i = 0; i < n; ++i) s.value[s.order[i]] = s.sorted_value[i];
  }

  const Join& join_;
  View a_, b_;
  bool self_;
  Scratch& scratch_;
  std::int64_t first_ = 0, last_ = 0, block_a_ = 0, block_b_ = 0, next_b_ = 0;
  std::int32_t listed_ = 0, listed_end_ = 0, first_entry_ = 0;
  bool whole_list_ = false, open_ = false;
  int segments_ = 0;
  Recent* recent_ = nullptr;  // where it is worth the while
  bool recent_begun_ = false;
};

}  // namespace

std::int64_t join_scratch_bytes() noexcept { return round_up(sizeof(Scratch)); }

std::int64_t count_pairs(const Join& join) noexcept {
  Runner runner(join);
  runner.find_range();
  runner.begin_at(runner.first(), 0, 0);
  std::int64_t pairs = 0;
  while (const std::int32_t n = runner.first() < runner.last() ? runner.gather(wanted_at_most) : 0) {
    runner.decide(n);
    const std::uint8_t* verdict = runner.scratch().verdict;
    for (std::int32_t i = 0; i < n; ++i) pairs += verdict[i];
  }
  return pairs;
}

// A state: block of A, block of B, a place among their candidates, and the end of the part's run of blocks above the
// mark. A place is 2^32 times an entry of their meetings, plus the candidates from there on that were decided. All 0 is
// the beginning; the first number is -1 at the end.

inline constexpr int entry_bit = 32;
inline constexpr std::int64_t most_entries = std::int64_t{block_items} * block_leaves;

bool state_is_sound(const Join& join, const std::int64_t* state) noexcept {
  if (is_at_beginning(state) || is_at_end(state)) return true;
  const std::int64_t blocks_a = View(join.a.index).blocks(), blocks_b = View(join.b.index).blocks();
  if (state[0] < 0 || state[1] < 0 || state[1] >= blocks_b || state[2] < 0) return false;
  if (state[2] >> entry_bit > most_entries || (state[2] & 0xffffffff) > batch) return false;
  return (state[3] & 0x7fff) == mark_of(join) && state[0] < state[3] >> 15 && state[3] >> 15 <= blocks_a;
}

namespace {

/// Candidates that are pairs, where there is room for all of them. Without branches, which would be mispredicted.
std::int64_t write_decided(const Scratch& s, std::int32_t begin, std::int32_t end, std::int64_t* out_a,
                           std::int64_t* out_b) noexcept {
  std::int64_t n = 0;
  for (std::int32_t i = begin; i < end; ++i) {
    out_a[n] = s.a[i];
    out_b[n] = s.b[i];
    n += s.verdict[i];
  }
  return n;
}

/// The numbers of the same pairs.
template <class T>
void write_values(const Scratch& s, std::int32_t begin, std::int32_t end, T* out) noexcept {
  for (std::int32_t i = begin; i < end; ++i) {
    if (s.verdict[i] != 0) *out++ = static_cast<T>(s.value[i]);
  }
}

}  // namespace

std::int64_t write_pairs(const Join& join, std::int64_t* out_a, std::int64_t* out_b, void* values,
                         std::int64_t capacity, std::int64_t* state) noexcept {
  if (is_at_end(state)) return 0;
  const auto put_values = [&](const Scratch& s, std::int32_t begin, std::int32_t end, std::int64_t at) {
    if (values == nullptr) return;
    if (join.a.sets->is_float) {
      write_values(s, begin, end, static_cast<float*>(values) + at);
    } else {
      write_values(s, begin, end, static_cast<double*>(values) + at);
    }
  };
  Runner runner(join);
  const std::int64_t mark = mark_of(join);
  std::int64_t skip = state[2] & 0xffffffff;
  if (state[3] == 0) {
    runner.find_range();
  } else {
    runner.set_range(state[0], state[3] >> 15);
  }
  runner.begin_at(runner.first(), state[3] == 0 ? 0 : state[1], static_cast<std::int32_t>(state[2] >> entry_bit));
  std::int64_t written = 0;
  while (runner.first() < runner.last()) {
    // Few candidates if little room is left: the next call finds those again that had no room.
    const std::int64_t room = capacity - written;
    const std::int64_t wanted = room < wanted_at_most ? 2 * room + skip + 32 : wanted_at_most;
    const std::int32_t n = runner.gather(wanted < wanted_at_most ? static_cast<std::int32_t>(wanted) : wanted_at_most);
    if (n == 0) break;
    runner.decide(n);
    const Scratch& s = runner.scratch();
    for (int k = 0; k < runner.segments(); ++k) {
      const Segment& segment = runner.segment(k);
      const std::int32_t end = k + 1 < runner.segments() ? runner.segment(k + 1).begin : n;
      const std::int32_t begin = segment.begin + static_cast<std::int32_t>(skip);
      skip = 0;
      if (capacity - written >= end - begin) {
        put_values(s, begin, end, written);
        written += write_decided(s, begin, end, out_a + written, out_b + written);
        continue;
      }
      for (std::int32_t i = begin; i < end; ++i) {
        if (s.verdict[i] == 0) continue;
        if (written == capacity) {
          put_state(state, segment.block_a, segment.block_b,
                    std::int64_t{segment.entry} << entry_bit | (i - segment.begin), runner.last() << 15 | mark);
          return written;
        }
        put_values(s, i, i + 1, written);
        out_a[written] = s.a[i];
        out_b[written++] = s.b[i];
      }
    }
  }
  put_end(state);
  return written;
}

}  // namespace vesica::index
