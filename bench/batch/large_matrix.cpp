// SPDX-License-Identifier: Apache-2.0
#include <vesica_index.hpp>

#include "batch/pools.hpp"
#include "batch/run.hpp"

namespace vesica::bench {
namespace {

constexpr std::size_t rows = 1024, columns = 4096;

/// In the order that an index has them in.
template <class T>
void sort(Columns<T>& shapes) {
  using Shapes = typename Index<T>::Shapes;
  Shapes set{};
  const auto view = shapes.shapes(shapes.capacity());
  set.kind = view.kind;
  set.count = view.count;
  set.stride = view.stride;
  std::copy_n(shapes.columns(), shapes.fields(), set.field);
  const std::vector<std::int64_t> order = Index<T>{set}.order();
  Columns<T> sorted(view.kind, shapes.capacity());
  for (std::size_t i = 0; i < order.size(); ++i) sorted.copy_one(shapes, static_cast<std::size_t>(order[i]), i);
  shapes.copy(sorted, 0, order.size());
}

}  // namespace

template <class T>
Result run_large_matrix(const Spec& spec) {
  const PoolColumns<T> pool(spec.kind_a, spec.kind_b, spec.workload);
  Columns<T> a(spec.kind_a, rows), b(spec.kind_b, columns);
  const Memory<std::uint8_t> out = allocate<std::uint8_t>(rows * columns);
  const auto yardstick = spec.isa->unfiltered->of(T{})[spec.kind_a][spec.kind_b].one_against_many;
  std::int64_t hits = 0, passes = 0;
  const Pass ours = [&] {
    const auto found = batch::matrix<T>(*spec.isa->kernels, a.shapes(rows), b.shapes(columns), out.get(), columns);
    hits += found.overlaps;
    ++passes;
    return found.overlaps;
  };
  const Pass unfiltered = [&] { return unfiltered_matrix(yardstick, a, rows, b, columns, out.get()); };
  const auto draw = [&](std::uint64_t round) {
    const Stretch from = stretch_of_round(round, pool.a.capacity(), columns);
    a.copy(pool.a, from.a, rows);
    b.copy(pool.b, from.b, columns);
    if (spec.layout == Layout::large_matrix) return;
    sort(a);
    sort(b);
  };
  const auto times = contest(draw, {ours, unfiltered}, {.seconds = 0.3, .rounds = 15, .long_passes = true});
  constexpr double tests = rows * columns;
  Result result = summary(times[0], tests);
  result.hits = static_cast<double>(hits) / (static_cast<double>(passes) * tests);
  result.reference = compare(times[0], times[1], tests, tests);
  return result;
}

template Result run_large_matrix<float>(const Spec&);
template Result run_large_matrix<double>(const Spec&);

}  // namespace vesica::bench
