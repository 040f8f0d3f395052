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

/// Fills what a column holds beyond its first n numbers.
void repeat_first(double (&column)[query_block], std::int32_t n) noexcept {
  for (std::int32_t i = n; i < query_block; ++i) column[i] = column[0];
}

/// A block of shapes of one kind, all numbers as doubles, filled up with the first element.
struct Operand {
  std::int32_t kind;
  double number[max_fields][query_block];
  double area[query_block] = {};

  /// Elements [begin, begin + n), or one shape repeated.
  template <class T>
  void set(const Shapes<T>& shapes, std::int64_t begin, std::int32_t n, ShapeArea shape_area) noexcept {
    kind = shapes.kind;
    if (shapes.stride == 0) n = 1;
    for (int k = 0; k < field_count(kind); ++k) {
      const T* from = advance(shapes.field[k], begin * shapes.stride);
      for (std::int32_t i = 0; i < n; ++i) {
        T x;
        std::memcpy(&x, advance(from, i * shapes.stride), sizeof x);
        number[k][i] = x;
      }
      repeat_first(number[k], n);
    }
    if (shape_area == nullptr) return;
    for (std::int32_t i = 0; i < n; ++i) {
      double numbers[max_fields];
      element(i, numbers);
      area[i] = shape_area(kind, numbers);
    }
    repeat_first(area, n);
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
      results[1][i] = 0 - results[1][i];  // no -0
      results[2][i] = 0 - results[2][i];
    }
  }
}

/// Results as the caller's type has them. Codes hold 0 for errors.
template <class Out>
using Stored = Out[max_results][query_block];

/// Rounds n results once, as the scalar functions do. A float beyond the range is an error.
std::int32_t store(const Query& query, std::int32_t n, const Results& results, Stored<float>& out) noexcept {
  std::int32_t error = 0;
  for (std::int32_t i = 0; i < n; ++i) {
    bool in_range = true;
    for (int k = 0; k < query.results; ++k) {
      out[k][i] = static_cast<float>(results[k][i]);
      in_range = in_range && !std::isinf(out[k][i]);
    }
    const bool lost = query.is_length && out[0][i] == 0 && results[0][i] > 0;
    if (lost) out[0][i] = std::numeric_limits<float>::denorm_min();
    if (in_range) continue;
    error = error_range;
    for (int k = 0; k < query.results; ++k) out[k][i] = std::numeric_limits<float>::quiet_NaN();
  }
  return error;
}
std::int32_t store(const Query& query, std::int32_t n, const Results& results, Stored<double>& out) noexcept {
  for (int k = 0; k < query.results; ++k) std::memcpy(out[k], results[k], static_cast<std::size_t>(n) * sizeof(double));
  return 0;
}
std::int32_t store(const Query&, std::int32_t n, const Results& results, Stored<std::uint8_t>& out) noexcept {
  for (std::int32_t i = 0; i < n; ++i) {
    out[0][i] = std::isnan(results[0][i]) ? std::uint8_t{0} : static_cast<std::uint8_t>(results[0][i]);
  }
  return 0;
}

class Engine {
 public:
  Engine(const Query& query, const KernelTable& kernels) noexcept : query_(query), kernels_(kernels) {}

  /// Results of all pairs as Out; NaN, or code 0, where there is an error.
  template <class Out>
  void answer(const Pairs& pairs, Stored<Out>& out) noexcept {
    Results results;
    answer(query_, pairs, results);
    note(store(query_, pairs.n, results, out));
  }

  std::int32_t error() const noexcept { return error_; }

 private:
  const Query& query_;
  const KernelTable& kernels_;
  std::int32_t error_ = 0;

  void answer(const Query& query, const Pairs& pairs, Results& results) noexcept {
    if (query.from_relation != nullptr) {
      answer(*query.relation, pairs, results);
      for (std::int32_t i = 0; i < pairs.n; ++i) results[0][i] = query.from_relation(results[0][i]);
      return;
    }
    const QueryKernel kernel = (kernels_.queries->*query.kernels)[pairs.first().kind][pairs.second().kind];
    if (kernel != nullptr) ask_kernel(kernel, query, pairs, results);
    for (std::int32_t i = 0; i < pairs.n; ++i) {
      if (kernel == nullptr || std::isnan(results[0][i])) ask_scalar(query, pairs, i, results);
    }
  }

  void ask_kernel(QueryKernel kernel, const Query& query, const Pairs& pairs, Results& results) noexcept {
    double known[query_block];
    QueryColumns asked{};
    pairs.first().columns(asked.first);
    pairs.second().columns(asked.second);
    asked.known = known;
    asked.first_area = pairs.first().area;
    asked.second_area = pairs.second().area;
    tell(query, pairs, asked, known);
    double* columns[max_results] = {results[0], results[1], results[2], results[3], results[4]};
    if (pairs.reversed() && query.reversal == Reversal::points) {
      std::swap(columns[1], columns[3]);
      std::swap(columns[2], columns[4]);
    }
    kernel(asked, whole_vectors(pairs.n), columns);
    if (pairs.reversed()) reverse(query.reversal, pairs.n, results);
  }

  /// Whether they overlap. Errors show again when the scalar function is asked.
  void tell(const Query& query, const Pairs& pairs, const QueryColumns& asked, double (&known)[query_block]) noexcept {
    if (query.known == Known::overlap) {
      std::uint8_t bytes[query_block];
      const std::int32_t n = whole_vectors(pairs.n);
      overlap_block(kernels_, pairs.first().kind, asked.first, pairs.second().kind, asked.second, n, bytes);
      for (std::int32_t i = 0; i < n; ++i) known[i] = bytes[i];
    }
  }

  void note(std::int32_t error) noexcept {
    if (error < 0 && error_ != error_shape) error_ = error;
  }

  void ask_scalar(const Query& query, const Pairs& pairs, std::int32_t i, Results& results) noexcept {
    double a[max_fields], b[max_fields], numbers[max_results];
    pairs.a.element(i, a);
    pairs.b.element(i, b);
    const std::int32_t error = query.answer(pairs.a.kind, a, pairs.b.kind, b, numbers);
    note(error);
    for (int k = 0; k < query.results; ++k) {
      results[k][i] = error < 0 ? std::numeric_limits<double>::quiet_NaN() : numbers[k];
    }
  }
};

template <class Out>
std::int64_t count(const Query& query, const Out* numbers, std::int32_t n) noexcept {
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
  Stored<Out> results;
  std::int64_t counted = 0;
  for (std::int64_t begin = 0; begin < n; begin += query_block) {
    pairs.n = block_length(n - begin);
    if (begin == 0 || a.stride != 0) pairs.a.set(a, begin, pairs.n, query.shape_area);
    if (begin == 0 || b.stride != 0) pairs.b.set(b, begin, pairs.n, query.shape_area);
    engine.answer<Out>(pairs, results);
    counted += count(query, results[0], pairs.n);
    for (int k = 0; k < query.results; ++k) {
      if (columns[k] == nullptr) continue;
      std::memcpy(columns[k] + begin, results[k], static_cast<std::size_t>(pairs.n) * sizeof(Out));
    }
  }
  return {counted, engine.error()};
}

template <class T, class Out>
QueryTally query_matrix(const Query& query, const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b,
                        Out* out, std::ptrdiff_t row_stride) noexcept {
  Engine engine(query, kernels);
  Pairs pairs;
  Stored<Out> results;
  std::int64_t counted = 0;
  for (std::int64_t begin = 0; begin < b.count; begin += query_block) {
    pairs.n = block_length(b.count - begin);
    pairs.b.set(b, begin, pairs.n, query.shape_area);
    for (std::int64_t row = 0; row < a.count; ++row) {
      Shapes<T> one = a;
      one.stride = 0;
      for (int k = 0; k < field_count(a.kind); ++k) one.field[k] = advance(a.field[k], row * a.stride);
      pairs.a.set(one, 0, pairs.n, query.shape_area);
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
