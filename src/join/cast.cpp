// SPDX-License-Identifier: Apache-2.0
#include "join/cast.hpp"

#include <limits>
#include <vesica/arithmetic/rounding.hpp>
#include <vesica/cast/before.hpp>
#include <vesica/shapes.hpp>

#include "index/frame.hpp"

namespace vesica::index {

namespace {

inline constexpr std::int64_t cast_mark = 0xca57;
inline constexpr double never = std::numeric_limits<double>::infinity(), largest = std::numeric_limits<double>::max();

/// When a moving box meets boxes that are at rest. Entry times are rounded down, and below the library's own times,
/// which are rounded once: 2^-50 of each number is more than the rounding of three operations.
class SweptBox {
 public:
  SweptBox(const double (&box)[4], double vx, double vy, double end) noexcept
      : x_(box[0], box[2], vx), y_(box[1], box[3], vy), end_(end) {}

  /// Sides of boxes, in rows: row[i] is a number of box i.
  template <class Row>
  struct Sides {
    Row min_x, min_y, max_x, max_y;
  };

  /// time[i] is no later than any contact with what box i holds; `never` where there is none by `limit`.
  template <class Row>
  void entries(const Sides<Row>& sides, int n, double limit, double* time) const noexcept {
    const Row near_x = x_.forward ? sides.min_x : sides.max_x, far_x = x_.forward ? sides.max_x : sides.min_x;
    const Row near_y = y_.forward ? sides.min_y : sides.max_y, far_y = y_.forward ? sides.max_y : sides.min_y;
    const double last = limit < end_ ? limit : end_;
    for (int i = 0; i < n; ++i) {
      double in = 0, out = last;
      x_.cut(near_x[i], far_x[i], in, out);
      y_.cut(near_y[i], far_y[i], in, out);
      time[i] = in <= out ? in : never;
    }
  }

 private:
  static constexpr double slack = 0x1p-50;

  /// The side of the moving box that meets others first, and the side that leaves them last. Without a velocity the
  /// inverse is infinite: then boxes are hit always or never, and a product that is NaN says nothing. Nor does that
  /// with an inverse that is not usable.
  struct Axis {
    bool forward;
    double front, back, inverse, greatest;

    Axis(double low, double high, double v) noexcept
        : forward(v >= 0),
          front(v >= 0 ? high : low),
          back(v >= 0 ? low : high),
          inverse(v == 0 ? never : usable_inverse(v)),
          greatest(v == 0 ? never : largest) {}

    static double usable_inverse(double v) noexcept {
      const double speed = v < 0 ? -v : v;
      return speed >= 0x1p-1000 && speed <= 0x1p1000 ? 1 / v : std::numeric_limits<double>::quiet_NaN();
    }

    /// (to - from) / v, also where the difference is beyond doubles.
    double time(double from, double to) const noexcept {
      const double way = to - from;
      return __builtin_fabs(way) <= largest ? way * inverse : (0.5 * to - 0.5 * from) * inverse * 2;
    }

    void cut(double near, double far, double& in, double& out) const noexcept {
      double from = time(front, near);
      from = from > greatest ? greatest : from;
      from = from * (1 - slack) - 0x1p-1070;
      const double to = time(back, far) * (1 + slack) + 0x1p-1070;
      in = from > in ? from : in;
      out = to < out ? to : out;
    }
  };

  Axis x_, y_;
  double end_;
};

/// A row of columns of a grid as exact doubles; `by` is 1 for the far sides of columns, as k is below 2^50.
struct GridRow {
  const std::uint16_t* column;
  double by, scale;

  double operator[](int i) const noexcept { return (static_cast<double>(column[i]) + by) * scale; }
};

SweptBox::Sides<GridRow> grid_sides(const Frame& f, const std::uint16_t* min_x, const std::uint16_t* min_y,
                                    const std::uint16_t* max_x, const std::uint16_t* max_y) noexcept {
  const double x = power_of_two(f.p[0]), y = power_of_two(f.p[1]);
  const auto kx = static_cast<double>(f.k[0]), ky = static_cast<double>(f.k[1]);
  return {{min_x, kx, x}, {min_y, ky, y}, {max_x, kx + 1, x}, {max_y, ky + 1, y}};
}
SweptBox::Sides<GridRow> leaf_sides(const Block& block) noexcept {
  return grid_sides(block.frame, leaf_boxes(block, 0), leaf_boxes(block, 1), leaf_boxes(block, 2),
                    leaf_boxes(block, 3));
}
SweptBox::Sides<GridRow> item_sides(const Frame& frame, const Leaf& leaf) noexcept {
  return grid_sides(frame, leaf.min_x, leaf.min_y, leaf.max_x, leaf.max_y);
}
SweptBox::Sides<const double*> child_sides(const Node& node) noexcept {
  return {node.min_x, node.min_y, node.max_x, node.max_y};
}
/// True if there is such a node, or on the lowest level such a block.
bool is_there(const Node& node, int child) noexcept { return node.min_x[child] <= node.max_x[child]; }

/// Numbers in the order of their times.
template <int Most>
struct ByTime {
  double time[Most];
  std::uint32_t value[Most];
  int count = 0;

  /// The numbers i < n whose time is before `never`, each as value_of(i). Which these are cannot be foreseen, so there
  /// is no branch on it.
  template <class Value>
  void take(const double* times, int n, const Value& value_of) noexcept {
    int met[Most];
    int meetings = 0;
    for (int i = 0; i < n; ++i) {
      met[meetings] = i;
      meetings += static_cast<int>(times[i] < never);
    }
    for (int i = 0; i < meetings; ++i) insert(times[met[i]], value_of(met[i]));
  }

 private:
  void insert(double t, std::uint32_t v) noexcept {
    int i = count++;
    for (; i > 0 && time[i - 1] > t; --i) {
      time[i] = time[i - 1];
      value[i] = value[i - 1];
    }
    time[i] = t;
    value[i] = v;
  }
};

int items_of_leaf(const Block& block, std::int32_t leaf) noexcept {
  const std::int32_t rest = block.count - leaf * leaf_items;
  return rest < leaf_items ? rest : leaf_items;
}

class First {
 public:
  explicit First(const Cast& cast) noexcept
      : cast_(cast),
        view_(cast.index),
        swept_(cast.box, cast.vx, cast.vy, cast.end),
        limit_(cast.end),
        best_{view_.items(), cast.end, 0} {}

  FirstItem run() noexcept {
    search();
    // An item that was undecided before the earliest hit was found may come after it.
    if (best_.error != 0 && some()) {
      best_.error = 0;
      search();
    }
    return best_;
  }

 private:
  bool some() const noexcept { return best_.item != view_.items(); }
  void search() noexcept {
    if (view_.levels() != 0) visit(view_.levels() - 1, 0);
  }

  void visit(int level, std::int64_t number) noexcept {
    const Node& node = view_.node(level, number);
    double time[node_children];
    swept_.entries(child_sides(node), node_children, limit_, time);
    ByTime<node_children> order;
    for (int i = 0; i < node_children; ++i) time[i] = is_there(node, i) ? time[i] : never;
    order.take(time, node_children, [](int i) { return static_cast<std::uint32_t>(i); });
    const std::int64_t first = number * node_children;
    const auto prefetch_child = [&](int i) {
      if (level == 0 && i < order.count) {
        prefetch_bytes(&view_.block(first + order.value[i]), sizeof(Block) + sizeof(std::uint16_t) * 4 * block_leaves);
      }
    };
    prefetch_child(0);
    for (int i = 0; i < order.count && order.time[i] <= limit_; ++i) {
      prefetch_child(i + 1);
      const std::int64_t child = first + order.value[i];
      if (level > 0) {
        visit(level - 1, child);
      } else {
        visit_block(view_.block(child));
      }
    }
  }

  void visit_block(const Block& block) noexcept {
    double time[block_leaves];
    swept_.entries(leaf_sides(block), block.leaves, limit_, time);
    ByTime<block_leaves> order;
    order.take(time, block.leaves, [](int l) { return static_cast<std::uint32_t>(l); });
    if (order.count > 0) prefetch_bytes(leaves_of(block) + order.value[0], sizeof(Leaf));
    for (int i = 0; i < order.count && order.time[i] <= limit_; ++i) {
      if (i + 1 < order.count) prefetch_bytes(leaves_of(block) + order.value[i + 1], sizeof(Leaf));
      const auto leaf = static_cast<std::int32_t>(order.value[i]);
      visit_leaf(block.frame, leaves_of(block)[leaf], items_of_leaf(block, leaf));
    }
  }

  void visit_leaf(const Frame& frame, const Leaf& leaf, int n) noexcept {
    double time[leaf_items];
    swept_.entries(item_sides(frame, leaf), n, limit_, time);
    ByTime<leaf_items> order;
    order.take(time, n, [&](int i) { return leaf.item[i]; });
    for (int i = 0; i < order.count; ++i) cast_.targets.prefetch(cast_.targets.context, order.value[i]);
    for (int i = 0; i < order.count && order.time[i] <= limit_; ++i) ask(order.value[i]);
  }

  void ask(std::uint32_t item) noexcept {
    double t;
    const std::int32_t code = detail::cast::cast_before(
        limit_, cast_.end, [&](double until) { return cast_.targets.ask(cast_.targets.context, item, until, t); });
    if (code < 0) best_.error = code;
    if (code <= 0 || (some() && (t > best_.t || (t == best_.t && item > best_.item)))) return;
    best_.item = item;
    best_.t = t;
    cast_.targets.keep(cast_.targets.context);
    const double after = next(t);
    if (after < limit_) limit_ = after;
  }

  /// Contact before this is rounded down to t, or earlier.
  double next(double t) const noexcept {
    if (cast_.is_float) return static_cast<double>(detail::arithmetic::next_above(static_cast<float>(t)));
    return detail::arithmetic::next_above(t);
  }

  const Cast& cast_;
  View view_;
  SweptBox swept_;
  double limit_;  // later contact is of no interest
  FirstItem best_;
};

/// All hits in the index's order, from a block on.
class All {
 public:
  All(const Cast& cast, std::int64_t* out, std::int64_t capacity, std::int64_t* state) noexcept
      : cast_(cast),
        view_(cast.index),
        swept_(cast.box, cast.vx, cast.vy, cast.end),
        out_(out),
        capacity_(capacity),
        state_(state),
        from_(capacity > 0 ? state[0] : 0),
        skip_(capacity > 0 ? state[1] : 0) {}

  std::int64_t run() noexcept {
    if (view_.levels() != 0) visit(view_.levels() - 1, 0);
    if (error_ != 0) return error_;
    if (capacity_ > 0 && !over_) put_end(state_);
    return found_;
  }

 private:
  void visit(int level, std::int64_t number) noexcept {
    const Node& node = view_.node(level, number);
    std::int64_t blocks = 1;
    for (int i = 0; i < level; ++i) blocks *= node_children;
    double time[node_children];
    swept_.entries(child_sides(node), node_children, never, time);
    for (int i = 0; i < node_children && !over_; ++i) {
      const std::int64_t child = number * node_children + i;
      if (!(time[i] < never) || !is_there(node, i) || (child + 1) * blocks <= from_) continue;
      if (level > 0) {
        visit(level - 1, child);
      } else {
        visit_block(child);
      }
    }
  }

  void visit_block(std::int64_t number) noexcept {
    const Block& block = view_.block(number);
    const std::int64_t skip = number == from_ ? skip_ : 0;
    std::int64_t in_block = 0;
    double time[block_leaves], of_item[leaf_items];
    swept_.entries(leaf_sides(block), block.leaves, never, time);
    for (std::int32_t l = 0; l < block.leaves; ++l) {
      if (!(time[l] < never)) continue;
      const Leaf& leaf = leaves_of(block)[l];
      const int n = items_of_leaf(block, l);
      swept_.entries(item_sides(block.frame, leaf), n, never, of_item);
      for (int i = 0; i < n; ++i) {
        if (of_item[i] < never) cast_.targets.prefetch(cast_.targets.context, leaf.item[i]);
      }
      for (int i = 0; i < n; ++i) {
        if (!(of_item[i] < never)) continue;
        const std::int32_t code = cast_.targets.meets(cast_.targets.context, leaf.item[i]);
        if (code == 0 || in_block++ < skip) continue;
        over_ = code < 0 || (capacity_ > 0 && found_ == capacity_);
        if (over_) return end_at(number, in_block, code);
        if (capacity_ > 0) out_[found_] = leaf.item[i];
        ++found_;
      }
    }
  }

  /// The page ends before an item of a block, or behind it, where an error is its only result.
  void end_at(std::int64_t block, std::int64_t in_block, std::int32_t code) noexcept {
    const bool tells_error = code < 0 && (found_ == 0 || capacity_ == 0);
    if (tells_error) error_ = code;
    if (capacity_ > 0) put_state(state_, block, tells_error ? in_block : in_block - 1, 0, cast_mark);
  }

  const Cast& cast_;
  View view_;
  SweptBox swept_;
  std::int64_t* out_;
  std::int64_t capacity_;
  std::int64_t* state_;
  std::int64_t from_, skip_, found_ = 0;
  std::int32_t error_ = 0;
  bool over_ = false;
};

}  // namespace

FirstItem find_first_hit(const Cast& cast) noexcept { return First(cast).run(); }

// A state: a block, how many of its items are already written or were an error, 0 and a mark.

bool cast_state_is_sound(const void* index, const std::int64_t* state) noexcept {
  if (is_at_beginning(state) || is_at_end(state)) return true;
  return state[0] >= 0 && state[0] < View(index).blocks() && state[1] >= 0 && state[2] == 0 && state[3] == cast_mark;
}

std::int64_t write_hits(const Cast& cast, std::int64_t* out, std::int64_t capacity, std::int64_t* state) noexcept {
  if (capacity > 0 && is_at_end(state)) return 0;
  return All(cast, out, capacity, state).run();
}

}  // namespace vesica::index
