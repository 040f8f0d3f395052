// SPDX-License-Identifier: Apache-2.0
#include "queries.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "by_kind.hpp"
#include "columns.hpp"

namespace vesica::batch {

namespace {

/// A block of shapes of one kind, all numbers as doubles; the last vector is filled up with the first element.
struct Operand {
  std::int32_t kind;
  double number[max_fields][query_block];

  template <class T>
  void set(const Shapes<T>& shapes, std::int64_t begin, std::int32_t n) noexcept {
    kind = shapes.kind;
    for (int k = 0; k < field_count(kind); ++k) {
      const T* from = advance(shapes.field[k], begin * shapes.stride);
      for (std::int32_t i = 0; i < query_block; ++i) {
        T x;
        std::memcpy(&x, advance(from, (i < n ? i : 0) * shapes.stride), sizeof x);
        number[k][i] = x;
      }
    }
  }

  void columns(const double* (&out)[max_fields]) const noexcept {
    for (int k = 0; k < max_fields; ++k) out[k] = number[k];
  }

  void element(std::int32_t i, double (&out)[max_fields]) const noexcept {
    for (int k = 0; k < field_count(kind); ++k) out[k] = number[k][i];
  }
};

struct Pairs {
  Operand a, b;
  std::int32_t n;

  bool reversed() const noexcept { return a.kind > b.kind; }
  const Operand& first() const noexcept { return reversed() ? b : a; }
  const Operand& second() const noexcept { return reversed() ? a : b; }
};

/// n rounded up to a multiple of the widest vector's doubles.
constexpr std::int32_t whole_vectors(std::int32_t n) noexcept { return (n + 7) / 8 * 8; }

using Results = double[max_results][query_block];

/// Relation codes seen from the other shape.
constexpr double converse[] = {0, 1, 2, 5, 6, 3, 4, 7};

/// Results of (second, first) as those of (first, second), but for exchanged points, which the kernel wrote in place.
void reverse(Reversal reversal, std::int32_t n, Results& results) noexcept {
  for (std::int32_t i = 0; i < n; ++i) {
    if (std::isnan(results[0][i])) continue;
    if (reversal == Reversal::converse) results[0][i] = converse[static_cast<int>(results[0][i])];
    if (reversal == Reversal::direction) {
      results[1][i] = -results[1][i];
      results[2][i] = -results[2][i];
    }
  }
}

class Engine {
 public:
  Engine(const Query& query, const KernelTable& kernels) noexcept : query_(query), kernels_(kernels) {}

  /// Results of all pairs; NaN where there is an error.
  void answer(const Pairs& pairs, Results& results) noexcept { answer(query_, pairs, results); }

  std::int32_t error() const noexcept { return error_; }

 private:
  const Query& query_;
  const KernelTable& kernels_;
  std::int32_t error_ = 0;

  void answer(const Query& query, const Pairs& pairs, Results& results) noexcept {
    const QueryKernel kernel = (kernels_.queries->*query.kernels)[pairs.first().kind][pairs.second().kind];
    if (kernel != nullptr) ask_kernel(kernel, query, pairs, results);
    for (std::int32_t i = 0; i < pairs.n; ++i) {
      if (kernel == nullptr || std::isnan(results[0][i])) ask_scalar(query, pairs, i, results);
    }
  }

  void ask_kernel(QueryKernel kernel, const Query& query, const Pairs& pairs, Results& results) noexcept {
    double known[query_block];
    const double *first[max_fields], *second[max_fields];
    pairs.first().columns(first);
    pairs.second().columns(second);
    tell(query, pairs, first, second, known);
    double* columns[max_results] = {results[0], results[1], results[2], results[3], results[4]};
    if (pairs.reversed() && query.reversal == Reversal::points) {
      std::swap(columns[1], columns[3]);
      std::swap(columns[2], columns[4]);
    }
    kernel(first, second, known, whole_vectors(pairs.n), columns);
    if (pairs.reversed()) reverse(query.reversal, pairs.n, results);
  }

  /// What the kernel must know, of (first, second). Errors show again when the scalar function is asked.
  void tell(const Query& query, const Pairs& pairs, const double* const* first, const double* const* second,
            double (&known)[query_block]) noexcept {
    if (query.known == Known::overlap) {
      std::uint8_t bytes[query_block];
      const std::int32_t n = whole_vectors(pairs.n);
      overlap_block(kernels_, pairs.first().kind, first, pairs.second().kind, second, n, bytes);
      for (std::int32_t i = 0; i < n; ++i) known[i] = bytes[i];
    } else if (query.known == Known::relation) {
      Results codes;
      answer(*query.relation, pairs, codes);
      if (pairs.reversed()) reverse(Reversal::converse, pairs.n, codes);
      for (std::int32_t i = 0; i < query_block; ++i) known[i] = codes[0][i];
    }
  }

  void ask_scalar(const Query& query, const Pairs& pairs, std::int32_t i, Results& results) noexcept {
    double a[max_fields], b[max_fields], numbers[max_results];
    pairs.a.element(i, a);
    pairs.b.element(i, b);
    const std::int32_t error = query.answer(pairs.a.kind, a, pairs.b.kind, b, numbers);
    if (error < 0 && error_ != error_shape) error_ = error;
    for (int k = 0; k < query.results; ++k) {
      results[k][i] = error < 0 ? std::numeric_limits<double>::quiet_NaN() : numbers[k];
    }
  }
};

/// A result as T: rounded once, but positive numbers stay positive. Columns of codes hold 0 for errors.
template <class Out>
Out stored(double x) noexcept {
  if constexpr (sizeof(Out) == 1) {
    return std::isnan(x) ? Out{0} : static_cast<Out>(x);
  } else {
    const Out rounded = static_cast<Out>(x);
    return rounded == 0 && x > 0 ? std::numeric_limits<Out>::denorm_min() : rounded;
  }
}

std::int64_t count(const Query& query, const double* numbers, std::int32_t n) noexcept {
  std::int64_t count = 0;
  for (std::int32_t i = 0; i < n; ++i) count += query.counts_zero ? numbers[i] == 0 : numbers[i] > 0;
  return count;
}

std::int32_t block_length(std::int64_t rest) noexcept {
  return static_cast<std::int32_t>(rest < query_block ? rest : query_block);
}

}  // namespace

template <class T, class Out>
QueryTally query_many(const Query& query, const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b,
                      std::int64_t n, Out* const* columns) noexcept {
  Engine engine(query, kernels);
  Pairs pairs;
  Results results;
  std::int64_t counted = 0;
  for (std::int64_t begin = 0; begin < n; begin += query_block) {
    pairs.n = block_length(n - begin);
    if (begin == 0 || a.stride != 0) pairs.a.set(a, begin, pairs.n);
    if (begin == 0 || b.stride != 0) pairs.b.set(b, begin, pairs.n);
    engine.answer(pairs, results);
    counted += count(query, results[0], pairs.n);
    for (int k = 0; k < query.results; ++k) {
      if (columns[k] == nullptr) continue;
      for (std::int32_t i = 0; i < pairs.n; ++i) columns[k][begin + i] = stored<Out>(results[k][i]);
    }
  }
  return {counted, engine.error()};
}

template <class T, class Out>
QueryTally query_matrix(const Query& query, const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b,
                        Out* out, std::ptrdiff_t row_stride) noexcept {
  Engine engine(query, kernels);
  Pairs pairs;
  Results results;
  std::int64_t counted = 0;
  for (std::int64_t begin = 0; begin < b.count; begin += query_block) {
    pairs.n = block_length(b.count - begin);
    pairs.b.set(b, begin, pairs.n);
    for (std::int64_t row = 0; row < a.count; ++row) {
      Shapes<T> one = a;
      one.stride = 0;
      for (int k = 0; k < field_count(a.kind); ++k) one.field[k] = advance(a.field[k], row * a.stride);
      pairs.a.set(one, 0, pairs.n);
      engine.answer(pairs, results);
      counted += count(query, results[0], pairs.n);
      Out* to = out + row * row_stride + begin;
      for (std::int32_t i = 0; i < pairs.n; ++i) to[i] = stored<Out>(results[0][i]);
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
