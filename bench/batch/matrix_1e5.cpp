// SPDX-License-Identifier: Apache-2.0
#include "batch/pools.hpp"
#include "batch/run.hpp"

namespace vesica::bench {
namespace {

constexpr std::size_t columns_of_matrix = 100'000;
constexpr std::size_t rows_of_slice = 250;
/// The slices of a window of rows are answered into one after the other; by the time one is written again, its lines
/// have left the cache, as lines of a matrix of 10 GB would be written for the first time.
constexpr std::size_t rows_of_window = 2500;

constexpr std::size_t rows_in_cache = 64;

/// Fills columns with a pool, over and over, from some element on.
template <class T>
void fill(Columns<T>& to, const Columns<T>& pool, std::size_t from) {
  for (std::size_t i = 0; i < to.capacity(); ++i) to.copy_one(pool, (from + i) % pool.capacity(), i);
}

}  // namespace

template <class T>
Result run_matrix_1e5(const Spec& spec) {
  const PoolColumns<T> pool(spec.kind_a, spec.kind_b, spec.workload);
  Columns<T> a(spec.kind_a, rows_of_slice), b(spec.kind_b, columns_of_matrix);
  fill(b, pool.b, 0);
  const std::size_t bytes = rows_of_window * columns_of_matrix;
  const Memory<std::uint8_t> out = allocate<std::uint8_t>(bytes);
  std::fill_n(out.get(), bytes, std::uint8_t{0});
  Batch<T> few(spec.kind_a, spec.kind_b, batch_length<T>);
  const Memory<std::uint8_t> out_in_cache = allocate<std::uint8_t>(rows_in_cache * batch_length<T>);

  std::size_t slice = 0;
  std::int64_t hits = 0, slices = 0;
  const Pass in_slices = [&] {
    std::uint8_t* const rows = out.get() + slice * rows_of_slice * columns_of_matrix;
    const auto found = batch::matrix<T>(*spec.isa->kernels, a.shapes(rows_of_slice), b.shapes(columns_of_matrix), rows,
                                        columns_of_matrix);
    hits += found.overlaps;
    ++slices;
    slice = (slice + 1) % (rows_of_window / rows_of_slice);
    return found.overlaps;
  };
  const Pass in_cache = [&] {
    return batch::matrix<T>(*spec.isa->kernels, few.a.shapes(rows_in_cache), few.b.shapes(batch_length<T>),
                            out_in_cache.get(), batch_length<T>)
        .overlaps;
  };
  const auto draw = [&](std::uint64_t round) {
    fill(a, pool.a, stretch_of_round(round, pool.a.capacity(), 1).a);
    few.draw(pool, round, rows_in_cache, batch_length<T>);
  };
  const auto times = contest(draw, {in_slices, in_cache}, {.seconds = 0.5, .rounds = 15, .long_passes = true});

  constexpr double tests = rows_of_slice * columns_of_matrix;
  Result result = summary(times[0], tests);
  result.hits = static_cast<double>(hits) / (static_cast<double>(slices) * tests);
  result.reference = compare(times[0], times[1], tests, rows_in_cache * batch_length<T>);
  return result;
}

template Result run_matrix_1e5<float>(const Spec&);
template Result run_matrix_1e5<double>(const Spec&);

}  // namespace vesica::bench
