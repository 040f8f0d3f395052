// SPDX-License-Identifier: Apache-2.0
#include "queries.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
#include <vesica/relation_code.hpp>

#include "by_kind.hpp"
#include "number_columns.hpp"
#include "polygon/area_blocks.hpp"
#include "stored.hpp"

namespace vesica::batch {

namespace {

struct Pairs {
  NumberColumns a, b;
  std::int32_t n;

  bool reversed() const noexcept { return a.kind() > b.kind(); }
  NumberColumns& first() noexcept { return reversed() ? b : a; }
  NumberColumns& second() noexcept { return reversed() ? a : b; }
  void find_areas(const Query& query) noexcept {
    a.find_areas(query);
    b.find_areas(query);
  }
};

/// Kernel results of (second, first) as those of (first, second). Points were exchanged as the kernel wrote them.
void reverse_columns(Reversal reversal, std::int32_t n, Results& results) noexcept {
  if (reversal == Reversal::direction) {
    for (std::int32_t i = 0; i < n; ++i) {
      results[1][i] = 0 - results[1][i];  // no -0
      results[2][i] = 0 - results[2][i];
    }
  }
  if (reversal == Reversal::converse) {
    for (std::int32_t i = 0; i < n; ++i) {
      if (std::isnan(results[0][i])) continue;
      results[0][i] = static_cast<double>(converse(static_cast<Relation>(static_cast<int>(results[0][i]))));
    }
  }
}

class Engine {
 public:
  Engine(const Query& query, const KernelTable& kernels) noexcept : query_(query), kernels_(kernels) {}

  /// Results of all pairs as Out; for an error NaN, or code 0.
  template <class Out>
  void answer(Pairs& pairs, Stored<Out>& out) noexcept {
    Results results;
    answer(query_, pairs, results);
    note(store(query_, pairs.n, results, out));
  }

  std::int32_t error() const noexcept { return error_; }

 private:
  const Query& query_;
  const KernelTable& kernels_;
  std::int32_t error_ = 0;
  NumberColumns first_near_, second_near_;

  void answer(const Query& query, Pairs& pairs, Results& results) noexcept {
    if (query.derive != nullptr) return derive(query, pairs, results);
    if (query.from_code != nullptr) {
      answer(*query.asked_instead, pairs, results);
      for (std::int32_t i = 0; i < pairs.n; ++i) results[0][i] = query.from_code(results[0][i]);
      return;
    }
    const QueryKernel kernel = kernel_of(query, pairs.first().kind(), pairs.second().kind());
    if (kernel != nullptr && ask_kernel(kernel, query, pairs, results)) return;
    ask_scalar(query, pairs, kernel == nullptr, results);
  }

  /// A pair that is an error of the other query is answered by this query's scalar function.
  void derive(const Query& query, Pairs& pairs, Results& results) noexcept {
    const std::int32_t error = error_;
    answer(*query.asked_instead, pairs, results);
    error_ = error;
    pairs.find_areas(query);
    for (std::int32_t i = 0; i < pairs.n; ++i) {
      double a[max_fields], b[max_fields], number = std::numeric_limits<double>::quiet_NaN();
      note(query.derive(results[0][i], pairs.a.shape(i, a), pairs.b.shape(i, b), number));
      results[0][i] = number;
    }
  }

  QueryKernel kernel_of(const Query& query, std::int32_t first, std::int32_t second) const noexcept {
    return (kernels_.queries->*query.kernels)[first][second];
  }

  /// Returns whether that answered all pairs.
  bool ask_kernel(QueryKernel kernel, const Query& query, Pairs& pairs, Results& results) noexcept {
    double known[query_block];
    const QueryColumns asked{pairs.first().operand(), pairs.second().operand(), known};
    tell(query, pairs, asked, known);
    if (query.known == Known::radius && pairs.first().has_radii()) {
      std::int32_t near[query_block];
      const std::int32_t count = find_near(asked, pairs.n, near);
      if (2 * count <= pairs.n) return ask_kernel_of(near, count, kernel, query, pairs, results);
    }
    pairs.find_areas(query);
    double* columns[max_results] = {results[0], results[1], results[2], results[3], results[4]};
    if (pairs.reversed() && query.reversal == Reversal::points) {
      std::swap(columns[1], columns[3]);
      std::swap(columns[2], columns[4]);
    }
    const bool all_settled = kernel(asked, whole_vectors(pairs.n), columns);
    if (pairs.reversed()) reverse_columns(query.reversal, pairs.n, results);
    return all_settled;
  }

  /// The pairs whose circles are not certainly apart.
  std::int32_t find_near(const QueryColumns& asked, std::int32_t n, std::int32_t (&near)[query_block]) noexcept {
    std::uint8_t apart[query_block];
    kernels_.queries->apart(asked, whole_vectors(n), apart);
    std::int32_t count = 0;
    for (std::int32_t i = 0; i < n; ++i) {
      near[count] = i;
      count += 1 - apart[i];
    }
    return count;
  }

  /// Answers only the listed pairs, copied side by side; the others are apart and share nothing: 0.
  bool ask_kernel_of(const std::int32_t* list, std::int32_t count, QueryKernel kernel, const Query& query, Pairs& pairs,
                     Results& results) noexcept {
    for (std::int32_t i = 0; i < pairs.n; ++i) results[0][i] = 0;
    if (count == 0) return true;
    double known[query_block];
    const QueryColumns asked{gathered(pairs.first(), list, count, query, first_near_),
                             gathered(pairs.second(), list, count, query, second_near_), known};
    double found[query_block];
    double* columns[max_results] = {found};
    const bool all_settled = kernel(asked, whole_vectors(count), columns);
    for (std::int32_t i = 0; i < count; ++i) results[0][list[i]] = found[i];
    return all_settled;
  }

  static QueryOperand gathered(NumberColumns& from, const std::int32_t* list, std::int32_t count, const Query& query,
                               NumberColumns& room) noexcept {
    if (!from.repeated()) room.gather(from, list, count);
    NumberColumns& out = from.repeated() ? from : room;
    out.find_areas(query);
    return out.operand();
  }

  /// Decides overlap of the pairs. The scalar function finds errors again.
  void tell(const Query& query, Pairs& pairs, const QueryColumns& asked, double (&known)[query_block]) noexcept {
    if (query.known == Known::overlap) {
      std::uint8_t bytes[query_block];
      const std::int32_t n = whole_vectors(pairs.n);
      overlap_block(kernels_, pairs.first().kind(), asked.first.number, pairs.second().kind(), asked.second.number, n,
                    bytes);
      for (std::int32_t i = 0; i < n; ++i) known[i] = bytes[i];
    }
  }

  void note(std::int32_t error) noexcept {
    if (error < 0 && error_ != error_shape) error_ = error;
  }

  /// Calls the scalar function for all pairs, or only for those that a kernel left open by a NaN.
  void ask_scalar(const Query& query, const Pairs& pairs, bool all, Results& results) noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const PairFunction answer_pair = query.doubles.of[pairs.a.kind()][pairs.b.kind()];
    for (std::int32_t i = 0; i < pairs.n; ++i) {
      if (!all && !std::isnan(results[0][i])) continue;
      double a[max_fields], b[max_fields], numbers[max_results];
      pairs.a.element(i, a);
      pairs.b.element(i, b);
      const std::int32_t code = answer_pair(a, b, numbers);
      if (code < 0) {
        note(code);
        for (int k = 0; k < query.columns(); ++k) results[k][i] = nan;
      } else if (query.numbers == 0) {
        results[0][i] = code;
      } else {
        for (int k = 0; k < query.numbers; ++k) results[k][i] = numbers[k];
      }
    }
  }
};

template <class Out>
std::int64_t count(const Query& query, const Out* numbers, std::int32_t n) noexcept {
  std::int32_t count = 0;
  for (std::int32_t i = 0; i < n; ++i) count += query.counts_zero ? numbers[i] <= 0 : numbers[i] > 0;
  return count;
}

}  // namespace

template <class T, class Out>
QueryTally query_many(const Query& query, const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b,
                      std::int64_t n, Out* const* columns) noexcept {
  if constexpr (std::is_same_v<T, Out>) {
    if (asks_areas(query, *kernels.queries, a, b)) return areas_in_step(query, *kernels.queries, a, b, n, columns[0]);
  }
  if (has_path(a, b)) return query_paths(query, a, b, n, columns);
  Engine engine(query, kernels);
  Pairs pairs;
  Stored<Out> results;
  std::int64_t counted = 0;
  for (std::int64_t begin = 0; begin < n; begin += query_block) {
    pairs.n = block_length(n - begin, query_block);
    if (begin == 0 || a.stride != 0) pairs.a.set(a, begin, pairs.n, query, kernels);
    if (begin == 0 || b.stride != 0) pairs.b.set(b, begin, pairs.n, query, kernels);
    engine.answer<Out>(pairs, results);
    counted += count(query, results[0], pairs.n);
    for (int k = 0; k < query.columns(); ++k) {
      if (columns[k] == nullptr) continue;
      std::memcpy(columns[k] + begin, results[k], static_cast<std::size_t>(pairs.n) * sizeof(Out));
    }
  }
  return {counted, engine.error()};
}

template <class T, class Out>
QueryTally query_matrix(const Query& query, const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b,
                        Out* out, std::ptrdiff_t row_stride) noexcept {
  if constexpr (std::is_same_v<T, Out>) {
    if (asks_areas(query, *kernels.queries, a, b)) return area_matrix(query, *kernels.queries, a, b, out, row_stride);
  }
  if (has_path(a, b)) return query_paths_matrix(query, a, b, out, row_stride);
  Engine engine(query, kernels);
  Pairs pairs;
  Stored<Out> results;
  std::int64_t counted = 0;
  for (std::int64_t begin = 0; begin < b.count; begin += query_block) {
    pairs.n = block_length(b.count - begin, query_block);
    pairs.b.set(b, begin, pairs.n, query, kernels);
    if (a.count > 1) pairs.b.find_areas(query);  // once for all rows
    for (std::int64_t row = 0; row < a.count; ++row) {
      pairs.a.set(element(a, row), 0, pairs.n, query, kernels);
      engine.answer<Out>(pairs, results);
      counted += count(query, results[0], pairs.n);
      std::memcpy(out + row * row_stride + begin, results[0], static_cast<std::size_t>(pairs.n) * sizeof(Out));
    }
  }
  return {counted, engine.error()};
}

#define VESICA_QUERIES(T, Out)                                                                                       \
  template QueryTally query_many(const Query&, const KernelTable&, const Shapes<T>&, const Shapes<T>&, std::int64_t, \
                                 Out* const*) noexcept;                                                              \
  template QueryTally query_matrix(const Query&, const KernelTable&, const Shapes<T>&, const Shapes<T>&, Out*,       \
                                   std::ptrdiff_t) noexcept;
VESICA_QUERIES(float, float)
VESICA_QUERIES(double, double)
VESICA_QUERIES(float, std::uint8_t)
VESICA_QUERIES(double, std::uint8_t)
#undef VESICA_QUERIES

}  // namespace vesica::batch
