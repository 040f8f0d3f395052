// SPDX-License-Identifier: Apache-2.0
// The kernels of vesica/cuda.cuh, compiled as plain C++ through host/cuda_runtime.h, give the library's answers: for
// the hosts' vectors, the corpus, every workload and near ties, in every form of a batch and in two orders of threads.
#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "compiled_once.hpp"
#include "cuda/cases.hpp"
// after it: the library's own exact stage
#include <vesica/cuda.cuh>

namespace {

using cases::answer;
using properties::Pair;
using properties::Scalar;

static_assert(sizeof(vesica::cuda::Shapes<double>) == sizeof(vesica_shapes_f64));
static_assert(offsetof(vesica::cuda::Shapes<float>, count) == offsetof(vesica_shapes_f32, count));
static_assert(offsetof(vesica::cuda::Shapes<float>, stride) == offsetof(vesica_shapes_f32, stride));
static_assert(offsetof(vesica::cuda::Shapes<double>, field) == offsetof(vesica_shapes_f64, field));

constexpr std::size_t fields = std::tuple_size_v<properties::Numbers>;

/// Shapes of one kind, in records as long as the longest kind's; as records or as columns.
template <class T>
struct Array {
  int kind;
  std::vector<properties::NumbersOf<T>> records;
  std::vector<T> columns;

  std::int64_t count() const { return static_cast<std::int64_t>(records.size()); }
  vesica::cuda::Shapes<T> as_records() const {
    vesica::cuda::Shapes<T> s{kind, 0, count(), sizeof(properties::NumbersOf<T>), {}};
    for (std::size_t k = 0; k < fields; ++k) s.field[k] = records[0].data() + k;
    return s;
  }
  vesica::cuda::Shapes<T> as_columns() {
    columns.clear();
    for (std::size_t k = 0; k < fields; ++k) {
      for (const auto& record : records) columns.push_back(record[k]);
    }
    vesica::cuda::Shapes<T> s{kind, 0, count(), sizeof(T), {}};
    for (std::size_t k = 0; k < fields; ++k) s.field[k] = columns.data() + k * records.size();
    return s;
  }
};

/// Memory of exactly the size that a batch asks for: sanitizers see what lies beyond.
struct Memory {
  std::vector<std::uint32_t> words;
  vesica::cuda::Work of(std::int64_t pairs) {
    words.assign(vesica::cuda::work_bytes(pairs) / 4, 0xa5a5a5a5);
    return {words.data(), words.size() * 4};
  }
  std::uint32_t invalid() const { return words[0]; }
};

constexpr std::int64_t rows = 24, columns = 37;

template <template <class> class A, template <class> class B, class T>
struct Batch {
  Array<T> a, b;
  Memory memory;

  std::int32_t expected(std::int64_t i, std::int64_t j) const {
    return answer(a.kind, a.records[static_cast<std::size_t>(i)].data(), b.kind,
                  b.records[static_cast<std::size_t>(j)].data());
  }

  void expect_many() {
    const std::int64_t n = a.count();
    std::vector<std::uint8_t> out(static_cast<std::size_t>(n), 9), swapped = out;
    ASSERT_EQ((vesica::cuda::overlap_many<A, B>(a.as_columns(), b.as_records(), out.data(), memory.of(n))),
              cudaSuccess);
    const std::uint32_t invalid = memory.invalid();
    ASSERT_EQ((vesica::cuda::overlap_many<B, A>(b.as_columns(), a.as_records(), swapped.data(), memory.of(n))),
              cudaSuccess);
    std::uint32_t errors = 0;
    for (std::int64_t i = 0; i < n; ++i) {
      const std::int32_t code = expected(i, i);
      errors += code < 0;
      EXPECT_EQ(out[static_cast<std::size_t>(i)], code == 1) << describe(i, i);
      EXPECT_EQ(swapped[static_cast<std::size_t>(i)], code == 1) << describe(i, i);
    }
    EXPECT_EQ(invalid, errors);
    EXPECT_EQ(memory.invalid(), errors);
  }

  /// A tile in a greater matrix, its counts, and its first row as one shape against many.
  void expect_tile(std::int64_t row, std::int64_t column) {
    const auto tile_a = vesica::cuda::part(a.as_columns(), row, rows);
    const auto tile_b = vesica::cuda::part(b.as_records(), column, columns);
    constexpr std::int64_t size = columns + 3;
    std::vector<std::uint8_t> out(static_cast<std::size_t>(rows * size), 9), one(static_cast<std::size_t>(columns), 9);
    std::vector<std::uint32_t> counts(static_cast<std::size_t>(columns), 7);
    ASSERT_EQ((vesica::cuda::overlap_matrix<A, B>(tile_a, tile_b, out.data(), size, memory.of(rows * columns))),
              cudaSuccess);
    ASSERT_EQ((vesica::cuda::overlap_counts<A, B>(tile_a, tile_b, counts.data(), memory.of(rows * columns))),
              cudaSuccess);
    A<T> first;
    std::memcpy(&first, a.records[static_cast<std::size_t>(row)].data(), sizeof first);
    ASSERT_EQ((vesica::cuda::overlap_one<A, B>(first, tile_b, one.data(), memory.of(columns))), cudaSuccess);
    for (std::int64_t j = 0; j < columns; ++j) {
      std::uint32_t count = 7;
      for (std::int64_t i = 0; i < rows; ++i) {
        const bool overlap = expected(row + i, column + j) == 1;
        count += overlap;
        EXPECT_EQ(out[static_cast<std::size_t>(i * size + j)], overlap) << describe(row + i, column + j);
      }
      EXPECT_EQ(counts[static_cast<std::size_t>(j)], count);
      EXPECT_EQ(one[static_cast<std::size_t>(j)], out[static_cast<std::size_t>(j)]);
    }
    for (std::int64_t i = 0; i < rows; ++i) EXPECT_EQ(out[static_cast<std::size_t>(i * size + columns)], 9);
  }

  std::string describe(std::int64_t i, std::int64_t j) const {
    Pair pair{a.kind, b.kind, {}, {}};
    for (std::size_t k = 0; k < fields; ++k) {
      pair.a[k] = static_cast<double>(a.records[static_cast<std::size_t>(i)][k]);
      pair.b[k] = static_cast<double>(b.records[static_cast<std::size_t>(j)][k]);
    }
    return properties::describe(pair);
  }
};

template <template <class> class A, template <class> class B, class T>
void expect_answers(const std::vector<Pair>& pairs) {
  Batch<A, B, T> batch;
  batch.a.kind = pairs[0].kind_a;
  batch.b.kind = pairs[0].kind_b;
  for (const Pair& pair : pairs) {
    properties::NumbersOf<T> a, b;
    for (std::size_t k = 0; k < fields; ++k) {
      a[k] = static_cast<T>(pair.a[k]);
      b[k] = static_cast<T>(pair.b[k]);
    }
    batch.a.records.push_back(a);
    batch.b.records.push_back(b);
  }
  batch.expect_many();
  if (batch.a.count() < rows + columns) return;
  batch.expect_tile(0, 0);
  batch.expect_tile(batch.a.count() - rows, batch.a.count() - columns);
}

/// Asks pairs of two kinds in order, in one scalar type.
void ask(Scalar scalar, const std::vector<Pair>& pairs) {
  const bool f32 = scalar == Scalar::f32;
  const int kind_a = pairs[0].kind_a, kind_b = pairs[0].kind_b;
#define VESICA_ASK(a, A, b, B)                                                                      \
  if (kind_a == static_cast<int>(vesica::Kind::a) && kind_b == static_cast<int>(vesica::Kind::b)) { \
    return f32 ? expect_answers<vesica::A, vesica::B, float>(pairs)                                 \
               : expect_answers<vesica::A, vesica::B, double>(pairs);                               \
  }
  VESICA_EACH_PAIR(VESICA_ASK)
#undef VESICA_ASK
  FAIL() << "no pair of kinds " << kind_a << " and " << kind_b;
}

TEST(CudaKernels, EveryWorkloadAndInvalidShapes) {
  for (const bool order : {false, true}) {
    last_thread_first = order;
    cases::ask_workloads(ask);
  }
  last_thread_first = false;
}

TEST(CudaKernels, NearTies) {
  const int count = 2000 * properties::repeat();
  EXPECT_EQ(cases::ask_near_ties(count, ask), 72 * std::int64_t{count});
}

TEST(CudaKernels, Corpus) { EXPECT_GE(cases::ask_corpus(ask), 119U); }

TEST(CudaKernels, Vectors) { EXPECT_GE(cases::ask_vectors(VESICA_VECTORS, ask), 150); }

TEST(CudaKernels, Arguments) {
  using vesica::Circle, vesica::Point;
  namespace cuda = vesica::cuda;
  Array<double> points{VESICA_POINT, {}, {}}, discs{VESICA_CIRCLE, {{0, 0, 5, 0, 0, 0}}, {}};
  for (int i = 0; i < 8; ++i) points.records.push_back({1.0 * i, 0, 0, 0, 0, 0});
  const auto a = points.as_records(), b = discs.as_records();
  std::vector<std::uint8_t> out(64, 9);
  Memory memory;
  // A count of 1 repeats, whatever its stride.
  EXPECT_EQ((cuda::overlap_many<Point, Circle>(a, b, out.data(), memory.of(8))), cudaSuccess);
  EXPECT_EQ(std::vector<std::uint8_t>(out.begin(), out.begin() + 9),
            (std::vector<std::uint8_t>{1, 1, 1, 1, 1, 1, 0, 0, 9}));
  // Nothing at all is a batch too.
  EXPECT_EQ((cuda::overlap_matrix<Point, Circle>(cuda::part(a, 0, 0), b, out.data(), 1, memory.of(0))), cudaSuccess);
  EXPECT_EQ(memory.invalid(), 0U);
  // Another kind, other counts, too little memory, a row too short, too many pairs.
  EXPECT_EQ((cuda::overlap_many<Circle, Point>(a, b, out.data(), memory.of(8))), cudaErrorInvalidValue);
  EXPECT_EQ((cuda::overlap_many<Point, Point>(a, cuda::part(a, 0, 7), out.data(), memory.of(8))),
            cudaErrorInvalidValue);
  EXPECT_EQ((cuda::overlap_many<Point, Circle>(a, b, out.data(), memory.of(7))), cudaErrorInvalidValue);
  EXPECT_EQ((cuda::overlap_one<Circle, Circle>(Circle<double>{0, 0, 1}, a, out.data(), memory.of(8))),
            cudaErrorInvalidValue);
  EXPECT_EQ((cuda::overlap_matrix<Point, Point>(a, a, out.data(), 7, memory.of(64))), cudaErrorInvalidValue);
  std::uint32_t count = 0;
  auto many = a;
  many.count = cuda::most_pairs / 7;
  EXPECT_EQ((cuda::overlap_counts<Point, Point>(many, a, &count, memory.of(8))), cudaErrorInvalidValue);
  many.count = -1;
  EXPECT_EQ((cuda::overlap_many<Point, Circle>(many, b, out.data(), memory.of(8))), cudaErrorInvalidValue);
  many.count = cuda::most_pairs + 1;
  EXPECT_EQ((cuda::overlap_many<Point, Circle>(many, b, out.data(), memory.of(8))), cudaErrorInvalidValue);
}

// Checks of counts and kinds, one at a time.
TEST(CudaKernels, EachArgumentAlone) {
  using vesica::Point;
  namespace cuda = vesica::cuda;
  Array<double> points{VESICA_POINT, {}, {}}, discs{VESICA_CIRCLE, {{0, 0, 5, 0, 0, 0}}, {}};
  for (int i = 0; i < 8; ++i) points.records.push_back({1.0 * i, 0, 0, 0, 0, 0});
  const auto all = points.as_records(), one = cuda::part(all, 3, 1), seven = cuda::part(all, 0, 7),
             none = cuda::part(all, 0, 0), other = discs.as_records();
  std::vector<std::uint8_t> out(64, 9);
  const auto first = [&](std::size_t n) { return std::vector<std::uint8_t>(out.begin(), out.begin() + n); };
  Memory memory;
  const auto many = [&](const auto& a, const auto& b) {
    return cuda::overlap_many<Point, Point>(a, b, out.data(), memory.of(8));
  };
  EXPECT_EQ(many(all, all), cudaSuccess);
  EXPECT_EQ(first(8), std::vector<std::uint8_t>(8, 1));
  EXPECT_EQ(many(one, all), cudaSuccess);
  EXPECT_EQ(first(8), (std::vector<std::uint8_t>{0, 0, 0, 1, 0, 0, 0, 0}));
  EXPECT_EQ(many(all, one), cudaSuccess);
  EXPECT_EQ(first(8), (std::vector<std::uint8_t>{0, 0, 0, 1, 0, 0, 0, 0}));
  EXPECT_EQ(many(all, seven), cudaErrorInvalidValue);
  EXPECT_EQ(many(other, all), cudaErrorInvalidValue);
  EXPECT_EQ(many(all, other), cudaErrorInvalidValue);

  const auto matrix = [&](const auto& a, const auto& b, std::int64_t row_size) {
    return cuda::overlap_matrix<Point, Point>(a, b, out.data(), row_size, memory.of(64));
  };
  EXPECT_EQ(matrix(seven, all, 8), cudaSuccess);
  for (std::size_t i = 0; i < 56; ++i) EXPECT_EQ(out[i], i / 8 == i % 8) << i;
  EXPECT_EQ(matrix(seven, all, 7), cudaErrorInvalidValue);
  EXPECT_EQ(matrix(other, all, 8), cudaErrorInvalidValue);
  EXPECT_EQ(matrix(all, other, 8), cudaErrorInvalidValue);
  // Without columns there may be any number of rows.
  auto tall = all;
  tall.count = cuda::most_pairs;
  EXPECT_EQ(matrix(tall, none, 0), cudaSuccess);
  EXPECT_EQ(matrix(tall, all, 8), cudaErrorInvalidValue);
}

TEST(CudaKernels, PartOfRecords) {
  // A point has two numbers; the other four columns are null, and stay so.
  const std::vector<vesica::Point<float>> points{{0, 0}, {1, 0}, {2, 0}};
  const auto all = vesica::cuda::records(points.data(), 3), part = vesica::cuda::part(all, 1, 2);
  EXPECT_EQ(part.count, 2);
  EXPECT_EQ(part.field[0], &points[1].x);
  EXPECT_EQ(part.field[1], &points[1].y);
  for (std::size_t k = 2; k < 6; ++k) EXPECT_EQ(part.field[k], nullptr);
}

// A batch queues four things: zeros, and three kernels. An error of any is returned, and nothing is queued after it.
TEST(CudaKernels, ErrorsOfEachLaunch) {
  using vesica::Circle, vesica::Point;
  namespace cuda = vesica::cuda;
  const std::vector<Point<double>> points{{0, 0}, {3, 0}};
  const auto a = cuda::records(points.data(), 2);
  const Circle<double> circle{0, 0, 1};
  Memory memory;
  for (int at = 1; at <= 5; ++at) {
    std::vector<std::uint8_t> out(2, 9);
    queued = 0;
    queued_until_failure = at;
    EXPECT_EQ((cuda::overlap_one<Circle, Point>(circle, a, out.data(), memory.of(2))),
              at <= 4 ? cudaErrorLaunchFailure : cudaSuccess);
    EXPECT_EQ(queued, at - 1);
    EXPECT_EQ(out, at > 2 ? (std::vector<std::uint8_t>{1, 0}) : (std::vector<std::uint8_t>{9, 9})) << at;
  }
  // Without pairs, only the zeros are queued.
  for (const int at : {1, 0}) {
    queued = 0;
    queued_until_failure = at;
    std::uint8_t none = 9;
    EXPECT_EQ((cuda::overlap_one<Circle, Point>(circle, cuda::part(a, 0, 0), &none, memory.of(0))),
              at == 1 ? cudaErrorLaunchFailure : cudaSuccess);
    EXPECT_EQ(queued, 1 - at);
    EXPECT_EQ(none, 9);
  }
}

// More pairs than the first kernel has threads, and than the second one: each thread takes several.
TEST(CudaKernels, MorePairsThanThreads) {
  constexpr std::int64_t n = 2100, m = 2000;
  static_assert(n * m > std::int64_t{vesica::cuda::detail::most_blocks} * vesica::cuda::detail::block);
  std::vector<vesica::Point<double>> points;
  for (std::int64_t i = 0; i < n; ++i) points.push_back({static_cast<double>(i), 0});
  const auto all = vesica::cuda::records(points.data(), n);
  std::vector<std::uint8_t> out(static_cast<std::size_t>(n * m), 9);
  Memory memory;
  ASSERT_EQ((vesica::cuda::overlap_matrix<vesica::Point, vesica::Point>(all, vesica::cuda::part(all, 0, m), out.data(),
                                                                        m, memory.of(n * m))),
            cudaSuccess);
  std::int64_t wrong = 0;
  for (std::int64_t k = 0; k < n * m; ++k) wrong += out[static_cast<std::size_t>(k)] != (k / m == k % m);
  EXPECT_EQ(wrong, 0);
}

}  // namespace
