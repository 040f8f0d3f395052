// SPDX-License-Identifier: Apache-2.0
/// The pools batches are drawn from, and how.
#pragma once

#include <cstddef>
#include <cstdint>

#include "batch/arrays.hpp"
#include "batch/unfiltered/table.hpp"
#include "workloads.hpp"

namespace vesica::bench {

/// Pools of the last pair that was asked for are kept.
const Pool& pool_of(std::int32_t kind_a, std::int32_t kind_b, Workload workload);

/// The start of a batch in the two pools. The shapes of a pool are independent, so a stretch of it is as random as a
/// draw of each, and two stretches from two pools are pairs that never came before.
struct Stretch {
  std::size_t a, b;
};
Stretch stretch_of_round(std::uint64_t round, std::size_t pool_size, std::size_t length);

/// A pool in columns.
template <class T>
struct PoolColumns {
  Columns<T> a, b;
  bool matched;

  PoolColumns(std::int32_t kind_a, std::int32_t kind_b, Workload workload)
      : PoolColumns(kind_a, kind_b, pool_of(kind_a, kind_b, workload)) {}
  PoolColumns(std::int32_t kind_a, std::int32_t kind_b, const Pool& pool)
      : a(kind_a, pool.a), b(kind_b, pool.b), matched(pool.matched) {}
};

/// A batch of `count` pairs in hot buffers; of the first operand also fewer.
template <class T>
struct Batch {
  Columns<T> a, b;

  Batch(std::int32_t kind_a, std::int32_t kind_b, std::size_t count) : a(kind_a, count), b(kind_b, count) {}

  void draw(const PoolColumns<T>& pool, std::uint64_t round, std::size_t count_a, std::size_t count_b) {
    if (pool.matched) return draw_matched(pool, round, count_a, count_b);
    const Stretch from = stretch_of_round(round, pool.a.capacity(), b.capacity());
    a.copy(pool.a, from.a, count_a);
    b.copy(pool.b, from.b, count_b);
  }

 private:
  /// These pools are small, and their pairs must stay together: each is drawn by itself.
  void draw_matched(const PoolColumns<T>& pool, std::uint64_t round, std::size_t count_a, std::size_t count_b) {
    Random random(seed_of_run() + round);
    for (std::size_t i = 0; i < count_b; ++i) {
      const std::size_t index = random.index(pool.a.capacity());
      if (i < count_a) a.copy_one(pool.a, index, i);
      b.copy_one(pool.b, index, i);
    }
  }
};

/// Every row with every column by the unfiltered kernel, columns in 4 KiB pieces, which stay in the first-level cache
/// while all rows pass over them.
template <class T>
std::int64_t unfiltered_matrix(unfiltered::Kernel<T> kernel, const Columns<T>& a, std::size_t rows, const Columns<T>& b,
                               std::size_t columns, std::uint8_t* out) {
  constexpr std::size_t piece = 4096 / sizeof(T);
  std::int64_t overlaps = 0;
  for (std::size_t begin = 0; begin < columns; begin += piece) {
    for (std::size_t i = 0; i < rows; ++i) {
      const T *row[max_fields], *many[max_fields];
      for (int k = 0; k < a.fields(); ++k) row[k] = a.columns()[k] + i;
      for (int k = 0; k < b.fields(); ++k) many[k] = b.columns()[k] + begin;
      overlaps += kernel(row, many, piece, out + i * columns + begin);
    }
  }
  return overlaps;
}

}  // namespace vesica::bench
