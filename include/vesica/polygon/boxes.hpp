// SPDX-License-Identifier: Apache-2.0
/// Boxes about a path's edges that are kept for many questions: about runs of edges in their order, about 16 of these
/// boxes, and so on. They lie in memory of the caller, one after the other, without pointers.
#pragma once

#include <cstring>
#include <vesica/arithmetic/rounding.hpp>
#include <vesica/polygon/edges.hpp>

namespace vesica::detail::polygon {

/// A box in float, rounded outward.
struct KeptBox {
  float min_x, min_y, max_x, max_y;

  constexpr operator Box() const noexcept {
    return {min_x, min_y, max_x, max_y};
  }  // NOLINT(google-explicit-constructor)
};

/// A number above v, infinity included.
inline float float_above(double v) noexcept {
  const auto rounded = static_cast<float>(v);
  return rounded < std::numeric_limits<float>::infinity() ? arithmetic::next_above(rounded) : rounded;
}
inline KeptBox rounded_outward(const Box& b) noexcept {
  return {-float_above(-b.min_x), -float_above(-b.min_y), float_above(b.max_x), float_above(b.max_y)};
}

/// The boxes of one path. Numbers in memory other than boxes are compared with what the path needs, and never followed.
class KeptBoxes {
 public:
  static constexpr std::int64_t fan = 16;

  /// Boxes about runs of `run` edges, for a path of this many vertices.
  constexpr KeptBoxes(std::int64_t first, std::int64_t vertices, std::int64_t run) noexcept
      : all_{first, first + vertices}, run_(run) {
    std::int64_t n = vertices;
    std::int64_t group = run;
    do {
      n = (n + group - 1) / group;
      begin_[levels_] = boxes_;
      count_[levels_++] = n;
      boxes_ += n;
      group = fan;
    } while (n > fan);
  }

  constexpr std::int64_t boxes() const noexcept { return boxes_; }
  const Box& whole() const noexcept { return whole_; }

  /// Makes the boxes of a valid path in room for boxes() of them. `box` holds the path.
  template <class T>
  void make(const Edges<T>& edges, const Box& box, KeptBox* room) noexcept {
    for (std::int64_t i = 0; i < count_[0]; ++i) room[i] = rounded_outward(edges.box_of_range(range(0, i)));
    for (int level = 1; level < levels_; ++level) {
      for (std::int64_t i = 0; i < count_[level]; ++i) {
        const std::int64_t from = i * fan, to = std::min(from + fan, count_[level - 1]);
        KeptBox all = room[begin_[level - 1] + from];
        for (std::int64_t k = from + 1; k < to; ++k) {
          const KeptBox& b = room[begin_[level - 1] + k];
          all = {std::min(all.min_x, b.min_x), std::min(all.min_y, b.min_y), std::max(all.max_x, b.max_x),
                 std::max(all.max_y, b.max_y)};
        }
        room[begin_[level] + i] = all;
      }
    }
    use(room, box);
  }
  /// Boxes that were made before.
  void use(const KeptBox* boxes, const Box& whole) noexcept {
    box_ = boxes;
    whole_ = whole;
  }

  /// Visits runs, and boxes of runs on the way to them: enter(range, box) says whether to go on to the parts of a box.
  /// It calls visit(range, box) for the runs that it enters, until that returns true; returns whether it did.
  template <class Enter, class Visit>
  bool for_runs(const Enter& enter, const Visit& visit) const noexcept {
    return for_parts(levels_ - 1, 0, count_[levels_ - 1], enter, visit);
  }

  /// A run whose box is little farther than the closest: by the closest box of each level.
  Range close_run(const Box& other) const noexcept {
    std::int64_t from = 0, to = count_[levels_ - 1];
    for (int level = levels_ - 1;; --level) {
      std::int64_t closest = from;
      double least = infinite;
      for (std::int64_t i = from; i < to; ++i) {
        const double gap = squared_gap(box_[begin_[level] + i], other);
        if (gap < least) {
          least = gap;
          closest = i;
        }
      }
      if (level == 0) return range(0, closest);
      from = closest * fan;
      to = std::min(from + fan, count_[level - 1]);
    }
  }

 private:
  /// The edges below a box.
  constexpr Range range(int level, std::int64_t i) const noexcept {
    const std::int64_t edges = run_ << (4 * level), from = all_.first + i * edges;
    return {from, std::min(from + edges, all_.last)};
  }

  template <class Enter, class Visit>
  bool for_parts(int level, std::int64_t from, std::int64_t to, const Enter& enter, const Visit& visit) const noexcept {
    for (std::int64_t i = from; i < to; ++i) {
      const Box box = box_[begin_[level] + i];
      const Range edges = range(level, i);
      if (!enter(edges, box)) continue;
      if (level == 0 ? visit(edges, box)
                     : for_parts(level - 1, i * fan, std::min((i + 1) * fan, count_[level - 1]), enter, visit)) {
        return true;
      }
    }
    return false;
  }

  static constexpr int most_levels = 16;
  Range all_;
  std::int64_t run_, boxes_ = 0;
  int levels_ = 0;
  std::int64_t begin_[most_levels]{}, count_[most_levels]{};
  const KeptBox* box_ = nullptr;
  Box whole_ = no_box;
};
static_assert(KeptBoxes::fan == 16, "range() multiplies by it");

/// Calls visit(edge, i) for edges whose box satisfies keeps(box), until it returns true.
template <class T, class Keeps, class Visit>
bool any_edge(const Edges<T>& edges, const Keeps& keeps, const Visit& visit) noexcept {
  const auto visit_kept = [&](const Edge& e, std::int64_t i) { return keeps(box_of(e)) && visit(e, i); };
  if (edges.boxes() == nullptr) return edges.for_edges(visit_kept);
  return edges.boxes()->for_runs([&](const Range&, const Box& box) { return keeps(box); },
                                 [&](const Range& run, const Box&) { return edges.for_edges(run, visit_kept); });
}

}  // namespace vesica::detail::polygon
