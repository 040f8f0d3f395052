// SPDX-License-Identifier: Apache-2.0
#include "join/nearest.hpp"

#include <algorithm>

#include "index/boxes.hpp"
#include "index/frame.hpp"
#include "join/entries.hpp"
#include "join/plain_distance.hpp"

namespace vesica::index {

namespace {

/// Items measured at once.
inline constexpr int measured_at_once = 16;

template <class T>
class Search {
 public:
  Search(const Nearest& query, const Sets& of, std::uint32_t item, const double (&box)[4], std::int64_t* out,
         T* distance) noexcept
      : query_(query), view_(query.index), out_(out), distance_(distance) {
    many_.begin();
    const Set& set = of.set[of.of(item)];
    kind_ = set.kind;
    gather_columns(of, kind_, &item, 1, 0, many_);
    one_.set(many_, kind_);
    if (has_core(kind_)) core_ = core_of<T>(set, item);
    constexpr bool narrow = sizeof(T) == sizeof(float);
    shape_ = {{box[0], box[1], box[2], box[3]},
              1 - (narrow ? 0x1p-22 : 0x1p-48),
              narrow ? 0x1p-140 : 0x1p-1070,
              is_box(kind_) && has_boxes_alone(query.sets),
              (box[2] - box[0]) + (box[3] - box[1])};
    for (auto& bounds : least_bound_) {
      for (std::int64_t i = 0; i <= bounded(); ++i) bounds[i] = i == 0 ? 0 : infinity;
    }
  }

  std::int64_t run() noexcept {
    if (view_.levels() != 0) look_into(place(in_node + view_.levels() - 1, 0));
    // If boxes decide which items are near, items are measured when no place is left.
    const bool waits = shape_.boxes_alone && bounded() > 0;
    for (;;) {
      const double next = places_.empty() ? infinity : bound_of(places_.least());
      const double nearest = waits ? infinity : bound_of(least_);
      if ((places_.empty() && (waits || count_ == 0)) || (next < nearest ? next : nearest) > limit()) break;
      if (!waits && count_ > 0 && nearest <= next) {
        make_ready(next);
        if (places_.empty() || found_ + ready_count_ >= query_.k) measure_ready();
      } else {
        look_into(places_.pop() & which_mask);
      }
    }
    if (waits) make_ready(infinity);
    measure_ready();
    sort();
    return found_;
  }

 private:
  static constexpr double infinity = __builtin_inf();
  /// Enough for a thousand items; if it is full, places are opened and items measured early.
  static constexpr int most_places = 512, most_items = 2048;
  /// Up to so many nearest, the farthest of them is bounded before any is measured.
  static constexpr int most_bounded = 32;

  /// A place: a leaf, a block, or a node by its level. Of equally near ones the lower level comes first, so that shapes
  /// on top of each other are reached one by one.
  static constexpr int in_leaf = 0, in_block = 1, in_node = 2, number_bits = 32;
  static_assert(in_node + max_levels <= 1 << (entry_bits - number_bits));
  static std::uint64_t place(int level, std::int64_t number) noexcept {
    return static_cast<std::uint64_t>(level) << number_bits | static_cast<std::uint64_t>(number);
  }

  static bool is_box(std::int32_t kind) noexcept { return Kind{kind} == Kind::point || Kind{kind} == Kind::aabb; }
  static bool has_boxes_alone(const Sets& sets) noexcept {
    bool all = true;
    for (int i = 0; i < sets.count; ++i) all &= is_box(sets.set[i].kind);
    return all;
  }

  /// How many of the least bounds are kept.
  std::int64_t bounded() const noexcept { return query_.k <= most_bounded ? query_.k : 0; }

  /// Nothing farther than this matters.
  double limit() const noexcept {
    const double least = upper_ < query_.within ? upper_ : query_.within;
    if (query_.k == 0 || found_ < query_.k) return least;
    const auto worst = static_cast<double>(distance_[0]);
    return worst < least ? worst : least;
  }

  static std::int64_t number_of(std::uint64_t which) noexcept {
    return static_cast<std::int64_t>(which & ((std::uint64_t{1} << number_bits) - 1));
  }

  /// A place that will be opened soon.
  VESICA_INLINE void prefetch_place(std::uint64_t which) const noexcept {
    const int level = static_cast<int>(which >> number_bits);
    const std::int64_t number = number_of(which);
    if (level == in_leaf) {
      prefetch_bytes(leaves_of(view_.block(number / block_leaves)) + number % block_leaves, sizeof(Leaf));
    } else if (level == in_block) {
      prefetch_bytes(&view_.block(number), sizeof(Block) + 4 * block_leaves * sizeof(std::uint16_t));
    }
  }

  /// Opens a place, then the nearest of its children, and so on to a leaf; the other children wait.
  void look_into(std::uint64_t which) noexcept {
    constexpr int most_children = (max_levels - 1) * node_children + block_leaves;
    Entry waiting[most_children + leaf_items];
    constexpr Entry none = ~Entry{0};
    Entry first = places_.empty() ? none : places_.least();  // of those that wait
    int count = 0;
    for (;;) {
      const int level = static_cast<int>(which >> number_bits);
      if (level == in_leaf) {
        open_leaf(number_of(which));
        break;
      }
      double bound[leaf_items];
      const int n = bound_children(level, number_of(which), bound);
      const std::uint64_t child = level >= in_node ? place(level - 1, number_of(which) * node_children)
                                                   : place(in_leaf, number_of(which) * block_leaves);
      const double limit = this->limit();
      const int before = count;
      int at = 0;  // the nearest
      Entry nearest = none, second = none;
      for (int i = 0; i < n; ++i) {
        const bool near = bound[i] <= limit;
        const Entry e = near ? entry(bound[i], child + static_cast<std::uint64_t>(i)) : none;
        waiting[count] = e;
        at = e < nearest ? count : at;
        count += near;
        second = std::min(second, std::max(nearest, e));
        nearest = std::min(nearest, e);
      }
      if (count == before || first < nearest) break;
      which = nearest & which_mask;
      prefetch_place(which);
      if (level == in_block && second != none) prefetch_place(second & which_mask);
      first = std::min(first, second);
      waiting[at] = waiting[--count];
    }
    for (int i = 0; i < count; ++i) note_place(waiting[i]);
  }

  /// Bounds of a node's children or a block's leaves; returns how many.
  int bound_children(int level, std::int64_t number, double* bound) noexcept {
    if (level >= in_node) {
      query_.kernels.child_distances(view_.node(level - in_node, number), shape_, bound);
      return node_children;
    }
    const Block& block = view_.block(number);
    query_.kernels.leaf_distances(block, shape_, bound);
    return block.leaves;
  }

  void note_place(Entry e) noexcept {
    if (bound_of(e) > limit()) return;
    if (places_.full()) return look_into(e & which_mask);
    places_.push(e);
    prefetch_place(e & which_mask);
  }

  void open_leaf(std::int64_t number) noexcept {
    const Block& block = view_.block(number / block_leaves);
    const auto l = static_cast<std::int32_t>(number % block_leaves);
    const Leaf& leaf = leaves_of(block)[l];
    const std::int32_t rest = block.count - l * leaf_items, n = rest < leaf_items ? rest : leaf_items;
    double bound[leaf_items];
    const double excess = query_.kernels.item_distances(block, leaf, shape_, bound);
    if (bounded() > 0) bound_farthest(bound, n, excess);
    note_items(bound, leaf.item, n);
  }

  /// Inserts a bound into the k least. By vectors, as branches would be mispredicted.
  void insert_bound(double bound, int k) noexcept {
    const double* const from = least_bound_[turn_];
    turn_ = 1 - turn_;
    double* const to = least_bound_[turn_];
    for (int i = 1; i <= k; ++i) {
      const double lesser = from[i] < bound ? from[i] : bound;
      to[i] = lesser > from[i - 1] ? lesser : from[i - 1];
    }
  }

  /// Lowers the limit if k items are near, as all are by at most `excess` farther than their bounds say.
  void bound_farthest(const double* bound, int n, double excess) noexcept {
    excess_ = excess > excess_ ? excess : excess_;
    const int k = static_cast<int>(bounded());
    for (int i = 0; i < n; ++i) {
      if (bound[i] < least_bound_[turn_][k]) insert_bound(bound[i], k);
    }
    // Beyond the finite numbers it limits nothing, and what lies there is not found.
    upper_ = least_bound_[turn_][k] * (5 - 4 * shape_.factor) + excess_;
  }

  void note_items(const double* bound, const std::uint32_t* item, int n) noexcept {
    if (count_ > most_items - leaf_items) make_room();
    const double limit = this->limit();
    int count = count_;
    for (int i = 0; i < n; ++i) {
      const Entry e = entry(bound[i], item[i]);
      const bool near = bound[i] <= limit;
      item_[count] = e;
      count += near;
      const Entry from_here = near ? e : nothing;
      least_ = from_here < least_ ? from_here : least_;
    }
    count_ = count;
  }

  /// Measures the nearer half of the items.
  void make_room() noexcept {
    std::nth_element(item_, item_ + count_ / 2, item_ + count_);
    make_ready(bound_of(item_[count_ / 2]));
    measure_ready();
  }

  VESICA_INLINE void prefetch_item(Entry e) const noexcept {
    const auto item = static_cast<std::uint32_t>(e);
    prefetch(query_.sets.set[query_.sets.of(item)], item);
  }

  /// Prefetches items that are no farther than `next` and the limit, unless they are the last. They are measured when
  /// there are enough of them to lower the limit. Items beyond the limit are dropped.
  void make_ready(double next) noexcept {
    if (ready_count_ + count_ > most_items) measure_ready();
    const double limit = this->limit();
    const Entry last = entry(next < limit ? next : limit, which_mask), farthest = entry(limit, which_mask);
    int n = ready_count_, rest = 0;
    least_ = nothing;
    for (int i = 0; i < count_; ++i) {
      const Entry e = item_[i];
      ready_[n] = e;
      n += e <= last;
      const bool waits = e > last && e <= farthest;
      item_[rest] = e;
      rest += waits;
      least_ = waits && e < least_ ? e : least_;
    }
    count_ = rest;
    for (int i = ready_count_; i < n && next < infinity; ++i) prefetch_item(ready_[i]);
    ready_count_ = n;
  }

  /// Nearest first, while they are within the limit.
  void measure_ready() noexcept {
    const int n = ready_count_;
    ready_count_ = 0;
    if (query_.k != 0 && n > query_.k - found_) std::sort(ready_, ready_ + n);
    for (int i = 0; i < n && !(bound_of(ready_[i]) > limit());) {
      const std::int64_t lacking = query_.k - found_;
      const int wanted = lacking > 0 && lacking < measured_at_once ? static_cast<int>(lacking) : measured_at_once;
      const int end = n - i < wanted ? n : i + wanted;
      int m = 0;
      Entry entries[measured_at_once];
      for (; i < end; ++i) {
        entries[m] = ready_[i];
        if (!may_be_taken(ready_[i])) continue;
        prefetch_item(ready_[i]);
        ++m;
      }
      measure(entries, m);
    }
  }

  /// True if an item could be among the results: not if k are found that are as near as its bound and have lower
  /// numbers. So of many shapes that overlap the one asked about, few are measured.
  bool may_be_taken(Entry e) const noexcept {
    if (query_.k == 0 || found_ < query_.k) return true;
    return bound_of(e) < static_cast<double>(distance_[0]) || static_cast<std::uint32_t>(e) < out_[0];
  }

  /// Measures items: first those that have a plain distance (plain_distance.hpp), then the others, kind by kind.
  void measure(const Entry* entries, int n) noexcept {
    std::uint32_t item[measured_at_once];
    bool done[measured_at_once] = {};
    for (int i = 0; i < n; ++i) item[i] = static_cast<std::uint32_t>(entries[i]);
    for (int i = 0; i < n && has_core(kind_); ++i) {
      const Set& set = query_.sets.set[query_.sets.of(item[i])];
      T distance;
      done[i] = has_core(set.kind) && plain_distance(core_, core_of<T>(set, item[i]), distance);
      if (done[i]) take(distance, item[i]);
    }
    for (int first = 0; first < n; ++first) {
      if (done[first]) continue;
      std::uint32_t same[measured_at_once];
      const std::int32_t kind = kind_of(item[first]);
      int m = 0;
      for (int i = first; i < n; ++i) {
        if (done[i] || kind_of(item[i]) != kind) continue;
        done[i] = true;
        same[m++] = item[i];
      }
      T distance[measured_at_once];
      gather_columns(query_.sets, kind, same, m, 0, many_);
      query_.measure(kind_, one_.field, kind, many_.field, m, distance);
      for (int i = 0; i < m; ++i) take(distance[i], same[i]);
    }
  }
  std::int32_t kind_of(std::uint32_t item) const noexcept { return query_.sets.set[query_.sets.of(item)].kind; }

  // The results are a heap with the farthest first, of equally far ones the highest number.

  static bool farther(T d, std::int64_t item, T than, std::int64_t than_item) noexcept {
    return d > than || (d == than && item > than_item);
  }

  void take(T d, std::int64_t item) noexcept {
    if (!(static_cast<double>(d) <= query_.within)) return;
    if (query_.k == 0) {
      ++found_;
    } else if (found_ < query_.k) {
      rise(found_++, d, item);
    } else if (farther(distance_[0], out_[0], d, item)) {
      sink(0, found_, d, item);
    }
  }

  void put(std::int64_t at, T d, std::int64_t item) noexcept {
    distance_[at] = d;
    out_[at] = item;
  }

  void rise(std::int64_t hole, T d, std::int64_t item) noexcept {
    while (hole > 0) {
      const std::int64_t above = (hole - 1) / 2;
      if (!farther(d, item, distance_[above], out_[above])) break;
      put(hole, distance_[above], out_[above]);
      hole = above;
    }
    put(hole, d, item);
  }

  void sink(std::int64_t hole, std::int64_t end, T d, std::int64_t item) noexcept {
    for (std::int64_t child = 2 * hole + 1; child < end; child = 2 * hole + 1) {
      if (child + 1 < end && farther(distance_[child + 1], out_[child + 1], distance_[child], out_[child])) ++child;
      if (!farther(distance_[child], out_[child], d, item)) break;
      put(hole, distance_[child], out_[child]);
      hole = child;
    }
    put(hole, d, item);
  }

  void sort() noexcept {
    if (query_.k == 0) return;
    for (std::int64_t end = found_; end-- > 1;) {
      const T d = distance_[end];
      const std::int64_t item = out_[end];
      put(end, distance_[0], out_[0]);
      sink(0, end, d, item);
    }
  }

  const Nearest& query_;
  View view_;
  Bounding shape_;
  std::int64_t* out_;
  T* distance_;
  std::int64_t found_ = 0;
  std::int32_t kind_;
  Core core_{};
  OneShape one_;
  Columns many_;
  Heap<most_places> places_;
  /// 0 and the least bounds of items, ascending, in one of two rows; how much a distance may exceed its bound; and the
  /// most that the k-th distance can be.
  double least_bound_[2][most_bounded + 1], excess_ = 0, upper_ = infinity;
  int turn_ = 0;
  /// Items that are not ready to be measured, the nearest of them, and those that are.
  static constexpr Entry nothing = __builtin_bit_cast(Entry, infinity);
  Entry least_ = nothing;
  int count_ = 0, ready_count_ = 0;
  Entry item_[most_items], ready_[most_items];
};

}  // namespace

bool bounds_of_item(const Kernels& kernels, const Sets& sets, std::uint32_t item, double (&box)[4]) noexcept {
  Boxes boxes;
  const Set& set = sets.set[sets.of(item)];
  find_boxes(kernels, sets, set, item - set.first, nullptr, 1, boxes);
  box[0] = boxes.min_x[0];
  box[1] = boxes.min_y[0];
  box[2] = boxes.max_x[0];
  box[3] = boxes.max_y[0];
  return boxes.valid[0] == 1;
}

template <class T>
std::int64_t find_nearest(const Nearest& query, const Sets& of, std::uint32_t item, const double (&box)[4],
                          std::int64_t* out, T* distance) noexcept {
  return Search<T>(query, of, item, box, out, distance).run();
}
template std::int64_t find_nearest(const Nearest&, const Sets&, std::uint32_t, const double (&)[4], std::int64_t*,
                                   float*) noexcept;
template std::int64_t find_nearest(const Nearest&, const Sets&, std::uint32_t, const double (&)[4], std::int64_t*,
                                   double*) noexcept;

}  // namespace vesica::index
