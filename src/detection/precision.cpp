// SPDX-License-Identifier: Apache-2.0
#include "detection/precision.hpp"

#include <algorithm>
#include <limits>

#include "join/ranked.hpp"

namespace vesica::detection {

namespace {

using index::Ranked;

constexpr std::int64_t ranked_bytes(std::int64_t n) noexcept {
  return 2 * n * static_cast<std::int64_t>(sizeof(Ranked));
}

/// Detections by score, the highest first, equal ones by number. Needs room for twice as many.
template <class T>
Ranked* by_score(const T* score, std::int64_t n, Ranked* room) noexcept {
  for (std::int64_t i = 0; i < n; ++i) {
    room[i] = {index::key_of(static_cast<double>(score[i])), static_cast<std::uint32_t>(i)};
  }
  return index::sort_ranked(room, room + n, n);
}

template <class T>
class Matcher {
 public:
  explicit Matcher(const Matching<T>& matching) noexcept : asked_(matching) {
    const Entries<T>& pairs = matching.pairs;
    auto* room = static_cast<Ranked*>(matching.scratch);
    order_ = by_score(matching.score, pairs.rows, room);
    room += 2 * pairs.rows;
    for (std::int64_t k = 0; k < pairs.count; ++k) {
      const auto row = static_cast<std::uint64_t>(pairs.row[k]), column = static_cast<std::uint64_t>(pairs.column[k]);
      room[k] = {row << 32 | column, static_cast<std::uint32_t>(k)};
    }
    pair_ = index::sort_ranked(room, room + pairs.count, pairs.count);
    room += 2 * pairs.count;
    begin_ = reinterpret_cast<std::uint32_t*>(room);
    std::int64_t place = 0;
    for (std::int64_t d = 0; d <= pairs.rows; ++d) {
      while (place < pairs.count && static_cast<std::int64_t>(pair_[place].key >> 32) < d) ++place;
      begin_[d] = static_cast<std::uint32_t>(place);
    }
    is_taken_ = reinterpret_cast<bool*>(begin_ + pairs.rows + 1);
  }

  void run(double threshold, Outcome* outcome, std::int64_t* taken) noexcept {
    const std::int64_t detections = asked_.pairs.rows;
    std::fill_n(is_taken_, asked_.pairs.columns, false);
    for (std::int64_t r = 0; r < detections; ++r) {
      const std::int64_t d = order_[r].place;
      const std::int64_t t = asked_.rule == MatchRule::voc ? best_of_voc(d, threshold) : best_of_coco(d, threshold);
      outcome[d] = t < 0 ? Outcome::miss : truth(t) == Truth::counts ? Outcome::hit : Outcome::ignored;
      if (t >= 0) is_taken_[t] = true;
      if (taken != nullptr) taken[d] = t;
    }
  }

 private:
  Truth truth(std::int64_t t) const noexcept { return asked_.truth == nullptr ? Truth::counts : asked_.truth[t]; }

  /// Calls visit(truth, value) for the pairs of a detection, truths ascending.
  template <class Visit>
  void each_truth(std::int64_t d, const Visit& visit) const noexcept {
    for (std::uint32_t i = begin_[d]; i < begin_[d + 1]; ++i) {
      const std::uint32_t k = pair_[i].place;
      visit(asked_.pairs.column[k], static_cast<double>(asked_.pairs.value[k]));
    }
  }

  /// The first of the truths with the highest value, whether taken or not. If it counts and is taken, there is none.
  std::int64_t best_of_voc(std::int64_t d, double threshold) const noexcept {
    std::int64_t best = -1;
    double highest = -std::numeric_limits<double>::infinity();
    each_truth(d, [&](std::int64_t t, double value) {
      if (value > highest || (best < 0 && value == highest)) {
        highest = value;
        best = t;
      }
    });
    if (best < 0 || highest < threshold) return -1;
    return truth(best) == Truth::counts && is_taken_[best] ? -1 : best;
  }

  /// The last of the free truths that count with the highest value; if there is none, of the others.
  std::int64_t best_of_coco(std::int64_t d, double threshold) const noexcept {
    for (const bool counts : {true, false}) {
      std::int64_t best = -1;
      double highest = std::min(threshold, 1 - 1e-10);
      each_truth(d, [&](std::int64_t t, double value) {
        const bool is_free = !is_taken_[t] || truth(t) == Truth::crowd;
        if ((truth(t) == Truth::counts) == counts && is_free && value >= highest) {
          highest = value;
          best = t;
        }
      });
      if (best >= 0) return best;
    }
    return -1;
  }

  const Matching<T>& asked_;
  const Ranked *order_, *pair_;  // detections by score; pairs by detection and truth
  std::uint32_t* begin_;         // of each detection's pairs
  bool* is_taken_;
};

/// Point i of those at which precision is looked up: as the challenges compute it, in double.
struct Points {
  int count;
  double step;
  double at(int i) const noexcept { return i == count - 1 ? 1 : i * step; }
};

}  // namespace

std::int64_t matching_bytes(std::int64_t pairs, std::int64_t detections, std::int64_t truths) noexcept {
  return ranked_bytes(pairs) + ranked_bytes(detections) + 4 * (detections + 1) + truths;
}

template <class T>
void match(const Matching<T>& matching, const T* threshold, std::int64_t n, Outcome* outcome,
           std::int64_t* taken) noexcept {
  Matcher<T> matcher(matching);
  for (std::int64_t i = 0; i < n; ++i) {
    matcher.run(static_cast<double>(threshold[i]), outcome, taken);
    outcome += matching.pairs.rows;
    if (taken != nullptr) taken += matching.pairs.rows;
  }
}
template void match(const Matching<double>&, const double*, std::int64_t, Outcome*, std::int64_t*) noexcept;
template void match(const Matching<float>&, const float*, std::int64_t, Outcome*, std::int64_t*) noexcept;

std::int64_t precision_bytes(std::int64_t detections) noexcept { return ranked_bytes(detections); }

template <class T>
double average_precision(PrecisionRule rule, const T* score, const Outcome* outcome, std::int64_t detections,
                         std::int64_t truths, void* scratch) noexcept {
  if (truths == 0) return std::numeric_limits<double>::quiet_NaN();
  const Ranked* const order = by_score(score, detections, static_cast<Ranked*>(scratch));
  std::int64_t hits = 0, counted = 0;
  for (std::int64_t i = 0; i < detections; ++i) {
    hits += outcome[i] == Outcome::hit;
    counted += outcome[i] != Outcome::ignored;
  }
  const auto all = static_cast<double>(truths);
  const Points points = rule == PrecisionRule::voc_2007 ? Points{11, 0.1} : Points{101, 0.01};
  const auto recall = [&](std::int64_t n) { return static_cast<double>(n) / all; };
  int point = points.count - 1;
  while (point >= 0 && points.at(point) > recall(hits)) --point;
  // From the last hit back: `best` is the highest precision from there on. At misses precision is lower than before.
  double best = 0, sum = 0;
  for (std::int64_t r = detections; r-- > 0;) {
    const Outcome o = outcome[order[r].place];
    if (o == Outcome::hit) {
      best = std::max(best, static_cast<double>(hits) / static_cast<double>(counted));
      --hits;
      if (rule == PrecisionRule::voc_2010) {
        sum += best;
      } else {
        // Points above the recall before this hit, which reaches them; point 0 is the first hit's.
        for (; point >= 0 && (points.at(point) > recall(hits) || hits == 0); --point) sum += best;
      }
    }
    counted -= o != Outcome::ignored;
  }
  return sum / (rule == PrecisionRule::voc_2010 ? all : points.count);
}
template double average_precision(PrecisionRule, const double*, const Outcome*, std::int64_t, std::int64_t,
                                  void*) noexcept;
template double average_precision(PrecisionRule, const float*, const Outcome*, std::int64_t, std::int64_t,
                                  void*) noexcept;

}  // namespace vesica::detection
