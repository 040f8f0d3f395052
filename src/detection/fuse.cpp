// SPDX-License-Identifier: Apache-2.0
#include "detection/fuse.hpp"

#include <algorithm>
#include <cmath>
#include <vesica/check.hpp>
#include <vesica/construct.hpp>

#include "by_kind.hpp"
#include "index/build.hpp"
#include "join/ranked.hpp"
#include "join/window.hpp"

namespace vesica::detection {

namespace {

namespace arithmetic = detail::arithmetic;
using index::Ranked;

constexpr auto aabb = static_cast<std::int32_t>(Kind::aabb), rect = static_cast<std::int32_t>(Kind::rect);
constexpr int linear = 4;

/// The largest coordinate and half length: no difference or mean of such numbers overflows.
constexpr double largest = 0x1p1020;
/// The largest score and weight: products and sums of 2^31 of them do not overflow.
constexpr double largest_score = 0x1p480;

/// A box by numbers that are averaged one by one: its corners; or centre and half lengths, with a unit direction.
struct Spread {
  double number[linear];
  double x, y;
};

/// Returns false for an invalid shape, and for numbers beyond the largest.
bool spread(std::int32_t kind, const double* numbers, Spread& out) noexcept {
  if (kind == aabb) {
    if (check(load<Aabb<double>>(numbers)) != 0) return false;
    out = {{numbers[0], numbers[1], numbers[2], numbers[3]}, 1, 0};
  } else {
    const auto s = load<Rect<double>>(numbers);
    if (check(s) != 0) return false;
    const auto unit = arithmetic::unit_and_length(s.ux, s.uy);
    const auto along = [&](double h) { return detail::multiply<double>(detail::take_apart(h), unit.length); };
    out = {{s.cx, s.cy, along(s.hx), along(s.hy)}, unit.x, unit.y};
  }
  for (const double x : out.number) {
    if (!(std::fabs(x) <= largest)) return false;
  }
  return true;
}

/// Turns a rectangle by quarters so that its corners are nearest to those of another, by the sum of squared distances:
/// that is least where sum(a a' + b b') d d' is largest, over its half lengths a, b and direction d.
void turn_towards(const Spread& to, Spread& s) noexcept {
  const double a = s.number[2], b = s.number[3], size = std::fmax(a, b);
  const double to_a = to.number[2], to_b = to.number[3], to_size = std::fmax(to_a, to_b);
  const double p = a / size, q = b / size, to_p = to_a / to_size, to_q = to_b / to_size;
  const double cosine = s.x * to.x + s.y * to.y, sine = s.x * to.y - s.y * to.x;
  if (std::fabs(sine) * (q * to_p + p * to_q) > std::fabs(cosine) * (p * to_p + q * to_q)) {
    std::swap(s.number[2], s.number[3]);
    const double x = s.x;
    s.x = sine > 0 ? -s.y : s.y;
    s.y = sine > 0 ? x : -x;
  } else if (cosine < 0) {
    s.x = -s.x;
    s.y = -s.y;
  }
}

struct Cluster {
  double box[4];  // about the mean
  std::int32_t label;
  std::uint32_t item;  // the first
  bool wanders;
  Spread first;
  double offset[linear];          // the mean less the first
  double x, y;                    // the sum of directions
  double mean[max_fields];        // the shape's own numbers
  double first_strength;          // score times weight, by which boxes count; 0: the first alone
  double strength;                // in all, in units of the first
  double score, weight, highest;  // weighted mean; sum of weights; highest score
};

enum class Rounded { outward, inward };

/// A box about a shape, or within its own.
void bounds_of(std::int32_t kind, const Spread& s, Rounded rounded, double (&out)[4]) noexcept {
  if (kind == aabb) {
    std::copy_n(s.number, 4, out);
    return;
  }
  const double a = s.number[2], b = s.number[3], x = std::fabs(s.x), y = std::fabs(s.y);
  for (int k = 0; k < 2; ++k) {
    const double half = k == 0 ? a * x + b * y : a * y + b * x;
    const double error = 0x1p-40 * (half + std::fabs(s.number[k])) + 0x1p-1060;
    const double reach = rounded == Rounded::outward ? half + error : half - error;
    out[k] = s.number[k] - reach;
    out[k + 2] = s.number[k] + reach;
  }
}

bool meet(const double (&a)[4], const double (&b)[4]) noexcept {
  return (a[0] <= b[2]) & (a[1] <= b[3]) & (a[2] >= b[0]) & (a[3] >= b[1]);
}

/// The index of all boxes, then room for its build and later for sorting; then the clusters.
struct Parts {
  std::int64_t ranked, cluster, cluster_of, wanderer, bytes;

  explicit Parts(std::int64_t items) noexcept {
    const std::int64_t build = index::scratch_bound(items), sorting = items * (2 * std::int64_t{sizeof(Ranked)});
    ranked = index::size_bound(items);
    cluster = index::round_up(ranked + std::max(build, sorting));
    cluster_of = cluster + items * std::int64_t{sizeof(Cluster)};
    wanderer = cluster_of + items * 4;
    bytes = wanderer + items * 4 + index::alignment;
  }
};

/// Most means stay within `reach_` of the first box of their cluster, which the index finds. All others wander, and are
/// compared one by one.
class Fuser {
 public:
  Fuser(const Fusion& fusion, unsigned char* scratch) noexcept
      : asked_(fusion), kind_(fusion.sets.set[0].kind), items_(fusion.sets.items), index_(scratch) {
    const Parts parts(items_);
    ranked_ = reinterpret_cast<Ranked*>(scratch + parts.ranked);
    cluster_ = reinterpret_cast<Cluster*>(scratch + parts.cluster);
    cluster_of_ = reinterpret_cast<std::int32_t*>(scratch + parts.cluster_of);
    wanderer_ = reinterpret_cast<std::int32_t*>(scratch + parts.wanderer);
  }

  /// Sorts what can be used by strength.
  template <class T>
  void rank(const T* score, const T* weight, std::int64_t* cluster, bool& left_out) noexcept {
    for (std::int64_t i = 0; i < items_; ++i) {
      const Strength s = strength_of(score, weight, i);
      Spread shape;
      const bool usable = s.fits() && read(i, shape);
      cluster_of_[i] = -1;
      cluster[i] = -1;
      left_out |= !usable;
      ranked_[count_] = {index::key_of(s.score * s.weight), static_cast<std::uint32_t>(i)};
      if (!usable) continue;
      ++count_;
      double box[4];
      bounds_of(kind_, shape, Rounded::outward, box);
      const double size = 0.5 * (box[2] - box[0]) + 0.5 * (box[3] - box[1]);
      reach_ += (0.25 * size - reach_) / static_cast<double>(count_);
    }
    ranked_ = index::sort_ranked(ranked_, ranked_ + items_, count_);
  }

  template <class T>
  void fuse(const T* score, const T* weight, std::int64_t* cluster) noexcept {
    for (std::int64_t r = 0; r < count_; ++r) {
      const std::int64_t i = ranked_[r].place;
      Spread s;
      read(i, s);
      const std::int64_t best = best_for(s, label_of(i));
      if (best < 0) {
        begin(s, strength_of(score, weight, i), i);
      } else {
        join(s, strength_of(score, weight, i), best);
      }
      cluster[i] = best < 0 ? clusters_ - 1 : best;
    }
  }

  template <class T>
  std::int64_t write(T* shapes, T* scores) const noexcept {
    for (std::int64_t c = 0; c < clusters_; ++c) {
      for (int k = 0; k < field_count(kind_); ++k) *shapes++ = static_cast<T>(cluster_[c].mean[k]);
      scores[c] = static_cast<T>(asked_.highest ? cluster_[c].highest : cluster_[c].score);
    }
    return clusters_;
  }

 private:
  struct Strength {
    double score, weight;
    bool fits() const noexcept {
      return score >= 0 && score <= largest_score && weight >= 0 && weight <= largest_score;
    }
  };

  template <class T>
  static Strength strength_of(const T* score, const T* weight, std::int64_t i) noexcept {
    return {static_cast<double>(score[i]), weight == nullptr ? 1.0 : static_cast<double>(weight[i])};
  }

  std::int32_t label_of(std::int64_t i) const noexcept { return asked_.label == nullptr ? 0 : asked_.label[i]; }

  bool read(std::int64_t i, Spread& out) noexcept {
    index::read_item(asked_.sets, static_cast<std::uint32_t>(i), numbers_);
    return spread(kind_, numbers_, out);
  }

  struct Best {
    std::int64_t cluster = -1;
    double iou;
  };

  /// Compares the box last read with a cluster's mean. Of equal IoUs the first cluster is better.
  void compare(const double (&box)[4], std::int32_t label, std::int64_t c, Best& best) const noexcept {
    const Cluster& cluster = cluster_[c];
    if (!meet(cluster.box, box) || cluster.label != label) return;
    const double iou = asked_.iou(kind_, cluster.mean, numbers_);
    if (iou > best.iou || (iou == best.iou && c < best.cluster)) best = {c, iou};
  }

  /// The cluster that a box, the one last read, joins: the first of those with the highest IoU; -1 for none.
  std::int64_t best_for(const Spread& s, std::int32_t label) const noexcept {
    double box[4], window[4];
    bounds_of(kind_, s, Rounded::outward, box);
    for (int side = 0; side < 4; ++side) {
      const double room = reach_ + 0x1p-48 * (std::fabs(box[side]) + reach_) + 0x1p-1060;
      window[side] = box[side] + (side < 2 ? -room : room);
    }
    Best best{.iou = asked_.threshold};
    index::each_in_window(asked_.kernels, index_, window, [&](const std::uint32_t* item, std::int32_t n) {
      for (std::int32_t i = 0; i < n; ++i) {
        if (cluster_of_[item[i]] >= 0) compare(box, label, cluster_of_[item[i]], best);
      }
    });
    for (std::int64_t i = 0; i < wanderers_; ++i) compare(box, label, wanderer_[i], best);
    return best.cluster;
  }

  void begin(const Spread& s, const Strength& strength, std::int64_t item) noexcept {
    Cluster& c = cluster_[clusters_];
    c = {.box = {},
         .label = label_of(item),
         .item = static_cast<std::uint32_t>(item),
         .wanders = false,
         .first = s,
         .offset = {},
         .x = s.x,
         .y = s.y,
         .mean = {},
         .first_strength = strength.score * strength.weight,
         .strength = 1,
         .score = strength.score,
         .weight = strength.weight,
         .highest = strength.score};
    std::copy_n(numbers_, field_count(kind_), c.mean);
    bounds_of(kind_, s, Rounded::outward, c.box);
    cluster_of_[item] = static_cast<std::int32_t>(clusters_++);
  }

  void join(Spread s, const Strength& strength, std::int64_t to) noexcept {
    Cluster& c = cluster_[to];
    c.highest = std::fmax(c.highest, strength.score);
    if (strength.weight > 0) {
      c.weight += strength.weight;
      c.score += (strength.score - c.score) * (strength.weight / c.weight);
    }
    const double own = strength.score * strength.weight;
    if (own == 0) return;
    if (kind_ == rect) turn_towards(c.first, s);
    const double relative = own / c.first_strength;
    c.strength += relative;
    for (int k = 0; k < linear; ++k) {
      c.offset[k] += ((s.number[k] - c.first.number[k]) - c.offset[k]) * (relative / c.strength);
    }
    c.x += relative * s.x;
    c.y += relative * s.y;
    bounds_of(kind_, set_mean(c), Rounded::outward, c.box);
    if (!c.wanders && !is_near_first(c)) {
      c.wanders = true;
      cluster_of_[c.item] = -1;
      wanderer_[wanderers_++] = static_cast<std::int32_t>(to);
    }
  }

  bool is_near_first(const Cluster& c) const noexcept {
    double first[4];
    bounds_of(kind_, c.first, Rounded::inward, first);
    return c.box[0] >= first[0] - reach_ && c.box[1] >= first[1] - reach_ && c.box[2] <= first[2] + reach_ &&
           c.box[3] <= first[3] + reach_;
  }

  /// The mean's own numbers, from the offsets and the sum of directions.
  Spread set_mean(Cluster& c) const noexcept {
    Spread s = c.first;
    for (int k = 0; k < linear; ++k) s.number[k] += c.offset[k];
    if (kind_ == aabb) {
      // Rounding may let the sides of a thin box pass one another.
      for (int k = 0; k < 2; ++k) s.number[k + 2] = std::fmax(s.number[k], s.number[k + 2]);
      std::copy_n(s.number, 4, c.mean);
      return s;
    }
    const auto unit = arithmetic::unit_and_length(c.x, c.y);
    s.x = unit.x;
    s.y = unit.y;
    const double mean[] = {s.number[0], s.number[1], s.x, s.y, s.number[2], s.number[3]};
    std::copy_n(mean, 6, c.mean);
    return s;
  }

  const Fusion& asked_;
  std::int32_t kind_;
  std::int64_t items_, count_ = 0, clusters_ = 0, wanderers_ = 0;
  index::View index_;
  double reach_ = 0;  // an eighth of the mean of widths and heights
  Ranked* ranked_;
  Cluster* cluster_;
  std::int32_t *cluster_of_, *wanderer_;  // by item, that began it; and those that wander
  double numbers_[max_fields];            // of the box last read
};

}  // namespace

bool can_be_fused(std::int32_t kind) noexcept { return kind == aabb || kind == rect; }

std::int64_t fusion_bytes(std::int64_t items) noexcept { return Parts(items).bytes; }

template <class T>
std::int64_t fuse(const Fusion& fusion, const T* score, const T* weight, T* shapes, T* scores, std::int64_t* cluster,
                  bool& left_out) noexcept {
  unsigned char* const scratch = index::build_in(fusion.kernels, fusion.sets, fusion.scratch);
  Fuser fuser(fusion, scratch);
  fuser.rank(score, weight, cluster, left_out);
  fuser.fuse(score, weight, cluster);
  return fuser.write(shapes, scores);
}
template std::int64_t fuse(const Fusion&, const double*, const double*, double*, double*, std::int64_t*,
                           bool&) noexcept;
template std::int64_t fuse(const Fusion&, const float*, const float*, float*, float*, std::int64_t*, bool&) noexcept;

}  // namespace vesica::detection
