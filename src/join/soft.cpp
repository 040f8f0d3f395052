// SPDX-License-Identifier: Apache-2.0
#include "join/soft.hpp"

#include <vesica/arithmetic/exponential.hpp>

namespace vesica::index {

namespace {

/// The lowered score, by the ratio with a better shape. A ratio that is NaN lowers nothing.
double factor(const SoftSuppression& s, double ratio) noexcept {
  namespace arithmetic = detail::arithmetic;
  if (!s.gaussian) return ratio > s.parameter ? 1 - ratio : 1;
  if (!(ratio > 0)) return 1;
  const auto square = arithmetic::two_product_fused(ratio, ratio);
  const double quotient = square.high / s.parameter;
  if (!(quotient < 1000)) return 0;
  const auto back = arithmetic::two_product_fused(quotient, s.parameter);
  return arithmetic::exp_of_minus(quotient, ((square.high - back.high) - back.low + square.low) / s.parameter);
}

/// The most numbers of a shape that suppression takes.
constexpr int most_numbers = [] {
  int most = 0;
  for (std::int32_t kind = 0; kind < kind_count; ++kind) {
    if (has_area(kind) && fields_of_kind[kind] > most) most = fields_of_kind[kind];
  }
  return most;
}();

/// The shapes that are left, in columns, in the order of their numbers.
class Left {
 public:
  explicit Left(const SoftSuppression& suppression) noexcept
      : asked_(suppression), kind_(suppression.sets.set[0].kind), items_(suppression.sets.items) {
    auto* const column = static_cast<double*>(suppression.scratch);
    score_ = column;
    for (int k = 0; k < most_numbers; ++k) number_[k] = column + (k + 1) * items_;
    item_ = reinterpret_cast<std::int64_t*>(column + (most_numbers + 1) * items_);
  }

  template <class T>
  void take(const T* score, bool& left_out) noexcept {
    Fields fields;
    for (std::int64_t i = 0; i < items_; ++i) {
      double numbers[max_fields];
      if (is_row(kind_)) {
        load(asked_.sets, asked_.sets.set[0], i, 1, fields);
        for (int k = 0; k < field_count(kind_); ++k) numbers[k] = number_[k][count_] = fields.column[k][0];
      } else {
        copy_path(i, numbers);
      }
      const auto s = static_cast<double>(score[i]);
      const bool usable = s == s && asked_.valid(kind_, numbers);
      left_out |= !usable;
      score_[count_] = s;
      item_[count_] = i;
      count_ += usable && s >= asked_.least_score;
    }
  }

  bool any() const noexcept { return count_ > 0; }
  std::int64_t best() const noexcept {
    std::int64_t best = 0;
    for (std::int64_t i = 1; i < count_; ++i) best = score_[i] > score_[best] ? i : best;
    return best;
  }
  std::int64_t item(std::int64_t i) const noexcept { return item_[i]; }
  double score(std::int64_t i) const noexcept { return score_[i]; }

  /// Takes one away, lowers the scores of its like, and drops those that fall below the least.
  void settle(std::int64_t best) noexcept {
    double one[max_fields];
    const double* columns[max_fields];
    for (int k = 0; k < max_fields; ++k) columns[k] = &(one[k] = number_[k < field_count(kind_) ? k : 0][best]);
    const std::int64_t item = item_[best];
    if (!is_row(kind_)) copy_path(item, one);
    remove(best);
    for (std::int64_t begin = 0; begin < count_;) begin = lower(columns, item, begin);
    drop_the_low();
  }

 private:
  /// The struct of a polygon, in place of numbers.
  void copy_path(std::int64_t item, double* out) const noexcept {
    static_assert(max_fields * sizeof(double) >= sizeof(Polygon<double>) &&
                  sizeof(Polygon<double>) == sizeof(Polygon<float>));
    const PathArray paths = asked_.sets.set[0].paths();
    if (asked_.sets.is_float) {
      const auto path = path_at<float>(paths, item);
      std::memcpy(out, &path, sizeof path);
    } else {
      const auto path = path_at<double>(paths, item);
      std::memcpy(out, &path, sizeof path);
    }
  }

  /// Up to `chunk` shapes of one label with the item, from `begin` on; returns where they end.
  std::int64_t lower(const double* const* one, std::int64_t item, std::int64_t begin) noexcept {
    Fields like;
    std::int64_t place[chunk];
    int n = 0;
    std::int64_t i = begin;
    for (; i < count_ && n < chunk; ++i) {
      if (asked_.label != nullptr && asked_.label[item_[i]] != asked_.label[item]) continue;
      place[n] = i;
      for (int k = 0; k < field_count(kind_); ++k) like.column[k][n] = number_[k][i];
      if (!is_row(kind_)) copy_path(item_[i], like.column[0] + n * max_fields);
      ++n;
    }
    if (n == 0) return i;
    const double* columns[max_fields];
    for (int k = 0; k < max_fields; ++k) columns[k] = like.column[k];
    double ratio[chunk];
    asked_.ratios(asked_.ratio, kind_, one, columns, n, ratio);
    for (int k = 0; k < n; ++k) {
      const double left = factor(asked_, ratio[k]);
      // An infinite score times 0 would be NaN.
      score_[place[k]] = left == 0 ? 0 : score_[place[k]] * left;
    }
    return i;
  }

  void move(std::int64_t from, std::int64_t to) noexcept {
    score_[to] = score_[from];
    item_[to] = item_[from];
    for (int k = 0; k < field_count(kind_); ++k) number_[k][to] = number_[k][from];
  }
  void remove(std::int64_t place) noexcept {
    for (std::int64_t i = place + 1; i < count_; ++i) move(i, i - 1);
    --count_;
  }
  void drop_the_low() noexcept {
    std::int64_t n = 0;
    for (std::int64_t i = 0; i < count_; ++i) {
      if (n != i) move(i, n);
      n += score_[i] >= asked_.least_score;
    }
    count_ = n;
  }

  const SoftSuppression& asked_;
  std::int32_t kind_;
  std::int64_t items_, count_ = 0;
  double *score_, *number_[max_fields];
  std::int64_t* item_;
};

}  // namespace

std::int64_t soft_bytes(std::int64_t items) noexcept { return items * 8 * (most_numbers + 2); }

template <class T>
std::int64_t suppress_softly(const SoftSuppression& suppression, const T* score, std::int64_t* keep, T* decayed,
                             bool& left_out) noexcept {
  Left left(suppression);
  left.take(score, left_out);
  std::int64_t kept = 0;
  while (left.any() && kept < suppression.most) {
    const std::int64_t best = left.best();
    keep[kept] = left.item(best);
    decayed[kept++] = static_cast<T>(left.score(best));
    left.settle(best);
  }
  return kept;
}
template std::int64_t suppress_softly(const SoftSuppression&, const double*, std::int64_t*, double*, bool&) noexcept;
template std::int64_t suppress_softly(const SoftSuppression&, const float*, std::int64_t*, float*, bool&) noexcept;

}  // namespace vesica::index
