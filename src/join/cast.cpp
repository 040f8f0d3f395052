// SPDX-License-Identifier: Apache-2.0
#include "join/cast.hpp"

#include <limits>

#include "index/frame.hpp"

namespace vesica::index {

namespace {

inline constexpr std::int64_t cast_mark = 0xca57;
inline constexpr double never = std::numeric_limits<double>::infinity(), largest = std::numeric_limits<double>::max();

/// When a moving box meets boxes that are at rest. Entry times are rounded down, and below the library's own times, which
/// are rounded once: 2^-50 of each number is more than the rounding of three operations.
class SweptBox {
 public:
  SweptBox(const double (&box)[4], double vx, double vy, double end) noexcept
      : x_{box[0], box[2], vx, inverse(vx)}, y_{box[1], box[3], vy, inverse(vy)}, end_(end) {}

  /// No later than any contact with what the box holds; `never` where there is none by `limit`.
  double entry(double min_x, double min_y, double max_x, double max_y, double limit) const noexcept {
    double in = 0, out = limit < end_ ? limit : end_;
    x_.cut(min_x, max_x, in, out);
    y_.cut(min_y, max_y, in, out);
    return in <= out ? in : never;
  }

 private:
  static constexpr double slack = 0x1p-50;

  /// NaN where it is not usable: then the axis excludes nothing.
  static double inverse(double v) noexcept {
    const double speed = v < 0 ? -v : v;
    return speed >= 0x1p-1000 && speed <= 0x1p1000 ? 1 / v : std::numeric_limits<double>::quiet_NaN();
  }

  struct Axis {
    double low, high, v, inverse;

    void cut(double min, double max, double& in, double& out) const noexcept {
      // How far the moving interval may go until it meets the other, and until it leaves it.
      const double first = v >= 0 ? min - high : max - low, last = v >= 0 ? max - low : min - high;
      if (v == 0) {
        if (first > 0 || last < 0) out = -1;
        return;
      }
      double from = first * inverse, to = last * inverse;
      from = from > largest ? largest : from;
      from -= slack * (from < 0 ? -from : from) + 0x1p-1070;
      to += slack * (to < 0 ? -to : to) + 0x1p-1070;
      in = from > in ? from : in;
      out = to < out ? to : out;
    }
  };

  Axis x_, y_;
  double end_;
};

/// Sides of a grid's columns, as exact doubles.
class GridSides {
 public:
  explicit GridSides(const Frame& f) noexcept
      : x_(power_of_two(f.p[0])), y_(power_of_two(f.p[1])), k_{f.k[0], f.k[1]} {}

  double entry(const SweptBox& swept, std::uint16_t min_x, std::uint16_t min_y, std::uint16_t max_x,
               std::uint16_t max_y, double limit) const noexcept {
    return swept.entry(static_cast<double>(min_x + k_[0]) * x_, static_cast<double>(min_y + k_[1]) * y_,
                       static_cast<double>(max_x + 1 + k_[0]) * x_, static_cast<double>(max_y + 1 + k_[1]) * y_, limit);
  }

 private:
  double x_, y_;
  std::int64_t k_[2];
};

/// Numbers in the order of their times.
template <int Most>
struct ByTime {
  double time[Most];
  std::uint32_t value[Most];
  int count = 0;

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
      : cast_(cast), view_(cast.index), swept_(cast.box, cast.vx, cast.vy, cast.end), limit_(cast.end), best_{view_.items(), cast.end, 0} {}

  FirstItem run() noexcept {
    if (view_.levels() != 0) visit(view_.levels() - 1, 0);
    return best_;
  }

 private:
  void visit(int level, std::int64_t number) noexcept {
    const Node& node = view_.node(level, number);
    ByTime<node_children> order;
    for (int i = 0; i < node_children; ++i) {
      if (!(node.min_x[i] <= node.max_x[i])) continue;
      const double t = swept_.entry(node.min_x[i], node.min_y[i], node.max_x[i], node.max_y[i], limit_);
      if (t < never) order.insert(t, static_cast<std::uint32_t>(i));
    }
    for (int i = 0; i < order.count && order.time[i] <= limit_; ++i) {
      const std::int64_t child = number * node_children + order.value[i];
      if (level > 0) {
        visit(level - 1, child);
      } else if (child < view_.blocks()) {
        visit_block(view_.block(child));
      }
    }
  }

  void visit_block(const Block& block) noexcept {
    const GridSides sides(block.frame);
    const std::uint16_t *min_x = leaf_boxes(block, 0), *min_y = leaf_boxes(block, 1), *max_x = leaf_boxes(block, 2),
                        *max_y = leaf_boxes(block, 3);
    ByTime<block_leaves> order;
    for (int l = 0; l < block.leaves; ++l) {
      const double t = sides.entry(swept_, min_x[l], min_y[l], max_x[l], max_y[l], limit_);
      if (t < never) order.insert(t, static_cast<std::uint32_t>(l));
    }
    for (int i = 0; i < order.count && order.time[i] <= limit_; ++i) {
      const auto leaf = static_cast<std::int32_t>(order.value[i]);
      visit_leaf(sides, leaves_of(block)[leaf], items_of_leaf(block, leaf));
    }
  }

  void visit_leaf(const GridSides& sides, const Leaf& leaf, int n) noexcept {
    ByTime<leaf_items> order;
    for (int i = 0; i < n; ++i) {
      const double t = sides.entry(swept_, leaf.min_x[i], leaf.min_y[i], leaf.max_x[i], leaf.max_y[i], limit_);
      if (t < never) order.insert(t, leaf.item[i]);
    }
    for (int i = 0; i < order.count && order.time[i] <= limit_; ++i) ask(order.value[i]);
  }

  void ask(std::uint32_t item) noexcept {
    const bool some = best_.item != view_.items();
    double t;
    const std::int32_t code = cast_.targets.ask(cast_.targets.context, item, limit_, t);
    if (code < 0) best_.error = code;
    if (code <= 0 || (some && (t > best_.t || (t == best_.t && item > best_.item)))) return;
    best_.item = item;
    best_.t = t;
    const double after = next(t);
    if (after < limit_) limit_ = after;
  }

  /// Contact before this is rounded down to t, or earlier.
  double next(double t) const noexcept {
    if (!cast_.is_float) return __builtin_nextafter(t, never);
    return static_cast<double>(__builtin_nextafterf(static_cast<float>(t), std::numeric_limits<float>::infinity()));
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
    if (capacity_ > 0 && !full_) put_state(-1, 0, 0);
    return found_;
  }

 private:
  bool is_over() const noexcept { return full_ || error_ != 0; }

  void put_state(std::int64_t block, std::int64_t written, std::int64_t mark) noexcept {
    state_[0] = block;
    state_[1] = written;
    state_[2] = 0;
    state_[3] = mark;
  }

  void visit(int level, std::int64_t number) noexcept {
    const Node& node = view_.node(level, number);
    std::int64_t blocks = 1;
    for (int i = 0; i < level; ++i) blocks *= node_children;
    for (int i = 0; i < node_children && !is_over(); ++i) {
      const std::int64_t child = number * node_children + i;
      if (!(node.min_x[i] <= node.max_x[i]) || (child + 1) * blocks <= from_) continue;
      if (!(swept_.entry(node.min_x[i], node.min_y[i], node.max_x[i], node.max_y[i], never) < never)) continue;
      if (level > 0) {
        visit(level - 1, child);
      } else if (child < view_.blocks()) {
        visit_block(child);
      }
    }
  }

  void visit_block(std::int64_t number) noexcept {
    const Block& block = view_.block(number);
    const GridSides sides(block.frame);
    const std::int64_t skip = number == from_ ? skip_ : 0;
    std::int64_t in_block = 0;
    for (std::int32_t l = 0; l < block.leaves; ++l) {
      if (!(sides.entry(swept_, leaf_boxes(block, 0)[l], leaf_boxes(block, 1)[l], leaf_boxes(block, 2)[l],
                        leaf_boxes(block, 3)[l], never) < never)) {
        continue;
      }
      const Leaf& leaf = leaves_of(block)[l];
      for (int i = 0; i < items_of_leaf(block, l); ++i) {
        if (!(sides.entry(swept_, leaf.min_x[i], leaf.min_y[i], leaf.max_x[i], leaf.max_y[i], never) < never)) continue;
        if (!is_hit(leaf.item[i])) {
          if (error_ != 0) return;
          continue;
        }
        if (in_block++ < skip) continue;
        if (capacity_ > 0 && found_ == capacity_) {
          full_ = true;
          return put_state(number, in_block - 1, cast_mark);
        }
        if (capacity_ > 0) out_[found_] = leaf.item[i];
        ++found_;
      }
    }
  }

  bool is_hit(std::uint32_t item) noexcept {
    double t;
    const std::int32_t code = cast_.targets.ask(cast_.targets.context, item, cast_.end, t);
    if (code < 0) error_ = code;
    return code > 0;
  }

  const Cast& cast_;
  View view_;
  SweptBox swept_;
  std::int64_t* out_;
  std::int64_t capacity_;
  std::int64_t* state_;
  std::int64_t from_, skip_, found_ = 0;
  std::int32_t error_ = 0;
  bool full_ = false;
};

}  // namespace

FirstItem find_first_hit(const Cast& cast) noexcept { return First(cast).run(); }

// A state: a block, how many of its items are already written, 0 and a mark.

bool cast_state_is_sound(const Cast& cast, const std::int64_t* state) noexcept {
  if (state[0] == 0 && state[1] == 0 && state[2] == 0 && state[3] == 0) return true;
  if (state[0] == -1) return true;
  return state[0] >= 0 && state[0] < View(cast.index).blocks() && state[1] >= 0 && state[2] == 0 &&
         state[3] == cast_mark;
}

std::int64_t write_hits(const Cast& cast, std::int64_t* out, std::int64_t capacity, std::int64_t* state) noexcept {
  if (capacity > 0 && state[0] == -1) return 0;
  return All(cast, out, capacity, state).run();
}

}  // namespace vesica::index
