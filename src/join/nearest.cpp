// SPDX-License-Identifier: Apache-2.0
#include "join/nearest.hpp"

#include "index/frame.hpp"

namespace vesica::index {

namespace {

/// Items measured at once: few, as the first ones tell how far to look.
inline constexpr int measured_at_once = 8;

/// No more than the distance, as the library computes it, of any shape in one box to any in the other. The library's
/// error is below 4 u of the largest offset or half length, so of the boxes' common extent; then it is rounded to T.
template <class T>
double distance_bound(const double (&a)[4], double min_x, double min_y, double max_x, double max_y) noexcept {
  const auto gap = [](double low_a, double high_a, double low_b, double high_b) {
    const double after = low_b - high_a, before = low_a - high_b, more = after > before ? after : before;
    return more > 0 ? more : 0;
  };
  const auto extent = [](double low_a, double high_a, double low_b, double high_b) {
    return (high_a > high_b ? high_a : high_b) - (low_a < low_b ? low_a : low_b);
  };
  const double x = gap(a[0], a[2], min_x, max_x), y = gap(a[1], a[3], min_y, max_y);
  const double greater = x > y ? x : y;
  const bool usable = greater >= 0x1p-480 && greater <= 0x1p480;
  const double d = usable ? __builtin_sqrt(x * x + y * y) : greater;
  const double e_x = extent(a[0], a[2], min_x, max_x), e_y = extent(a[1], a[3], min_y, max_y);
  constexpr double rounding = sizeof(T) == sizeof(float) ? 0x1p-22 : 0x1p-48;
  constexpr double least = sizeof(T) == sizeof(float) ? 0x1p-140 : 0x1p-1070;
  return d * (1 - rounding) - ((e_x > e_y ? e_x : e_y) * 0x1p-48 + least);
}

/// Numbers in the order of their keys, equal ones as they are.
template <int Most>
struct Ordered {
  double key[Most];
  std::uint32_t value[Most];
  int count = 0;

  void insert(double k, std::uint32_t v) noexcept {
    int i = count++;
    for (; i > 0 && key[i - 1] > k; --i) {
      key[i] = key[i - 1];
      value[i] = value[i - 1];
    }
    key[i] = k;
    value[i] = v;
  }
};

template <class T>
class Search {
 public:
  Search(const Nearest& query, const Sets& of, std::uint32_t item, const double (&box)[4], std::int64_t* out,
         T* distance) noexcept
      : query_(query), view_(query.index), box_(box), out_(out), distance_(distance) {
    one_.begin();
    many_.begin();
    kind_ = of.set[of.of(item)].kind;
    gather_columns(of, kind_, &item, 1, 0, one_);
  }

  std::int64_t run() noexcept {
    if (view_.levels() != 0) visit(view_.levels() - 1, 0);
    sort();
    return found_;
  }

 private:
  /// Nothing farther than this is looked at.
  double limit() const noexcept {
    if (query_.k == 0 || found_ < query_.k) return query_.within;
    const auto worst = static_cast<double>(distance_[0]);
    return worst < query_.within ? worst : query_.within;
  }

  void visit(int level, std::int64_t number) noexcept {
    const Node& node = view_.node(level, number);
    Ordered<node_children> order;
    for (int i = 0; i < node_children; ++i) {
      if (!(node.min_x[i] <= node.max_x[i])) continue;
      const double bound = distance_bound<T>(box_, node.min_x[i], node.min_y[i], node.max_x[i], node.max_y[i]);
      if (!(bound > limit())) order.insert(bound, static_cast<std::uint32_t>(i));
    }
    for (int i = 0; i < order.count; ++i) {
      if (order.key[i] > limit()) break;
      const std::int64_t child = number * node_children + order.value[i];
      if (level > 0) {
        visit(level - 1, child);
      } else if (child < view_.blocks()) {
        visit_block(view_.block(child));
      }
    }
  }

  double column_bound(const Frame& f, std::uint16_t min_x, std::uint16_t min_y, std::uint16_t max_x,
                      std::uint16_t max_y) const noexcept {
    const double x = power_of_two(f.p[0]), y = power_of_two(f.p[1]);
    return distance_bound<T>(box_, static_cast<double>(min_x + f.k[0]) * x, static_cast<double>(min_y + f.k[1]) * y,
                             static_cast<double>(max_x + 1 + f.k[0]) * x, static_cast<double>(max_y + 1 + f.k[1]) * y);
  }

  void visit_block(const Block& block) noexcept {
    Ordered<block_leaves> order;
    for (int l = 0; l < block.leaves; ++l) {
      const double bound = column_bound(block.frame, leaf_boxes(block, 0)[l], leaf_boxes(block, 1)[l],
                                        leaf_boxes(block, 2)[l], leaf_boxes(block, 3)[l]);
      if (!(bound > limit())) order.insert(bound, static_cast<std::uint32_t>(l));
    }
    for (int i = 0; i < order.count && !(order.key[i] > limit()); ++i) {
      const auto l = static_cast<std::int32_t>(order.value[i]);
      const std::int32_t rest = block.count - l * leaf_items;
      visit_leaf(block.frame, leaves_of(block)[l], rest < leaf_items ? rest : leaf_items);
    }
  }

  void visit_leaf(const Frame& frame, const Leaf& leaf, int n) noexcept {
    Ordered<leaf_items> order;
    for (int i = 0; i < n; ++i) {
      const double bound = column_bound(frame, leaf.min_x[i], leaf.min_y[i], leaf.max_x[i], leaf.max_y[i]);
      if (!(bound > limit())) order.insert(bound, leaf.item[i]);
    }
    for (int i = 0; i < order.count && !(order.key[i] > limit()); i += measured_at_once) {
      const int m = order.count - i < measured_at_once ? order.count - i : measured_at_once;
      measure(order.value + i, m);
    }
  }

  /// Measures items, those of each kind together.
  void measure(const std::uint32_t* item, int n) noexcept {
    bool done[measured_at_once] = {};
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

  // What is found is a heap whose first is the farthest, of equal ones that of the highest number.

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
  const double (&box_)[4];
  std::int64_t* out_;
  T* distance_;
  std::int64_t found_ = 0;
  std::int32_t kind_;
  Columns one_, many_;
};

}  // namespace

bool bounds_of_item(const Kernels& kernels, const Sets& sets, std::uint32_t item, double (&box)[4]) noexcept {
  Fields fields;
  Boxes boxes;
  const Set& set = sets.set[sets.of(item)];
  load(sets, set, item - set.first, 1, fields);
  kernels.bounds(set.kind, fields, 1, boxes);
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
