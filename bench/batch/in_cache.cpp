// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "batch/pools.hpp"
#include "batch/run.hpp"

namespace vesica::bench {
namespace {

constexpr std::size_t matrix_rows = 32;

/// The passes of one row: the library's and the yardstick's, over the same columns.
template <class T>
class InCache {
 public:
  explicit InCache(const Spec& spec)
      : spec_(spec),
        yardstick_(spec.isa->unfiltered->of(T{})[spec.kind_a][spec.kind_b]),
        pool_(spec.kind_a, spec.kind_b, spec.workload),
        batch_(spec.kind_a, spec.kind_b, n),
        records_a_(spec.kind_a, n),
        records_b_(spec.kind_b, n),
        out_(allocate<std::uint8_t>(tests())) {}

  /// The shapes of the first operand.
  std::size_t rows() const {
    if (spec_.layout == Layout::matrix) return matrix_rows;
    return spec_.layout == Layout::in_step || spec_.layout == Layout::records ? n : 1;
  }
  std::size_t tests() const { return spec_.layout == Layout::matrix ? matrix_rows * n : n; }
  bool has_yardstick() const { return yardstick_.in_step != nullptr; }
  const std::uint8_t* out() const { return out_.get(); }

  void draw(std::uint64_t round) {
    batch_.draw(pool_, round, rows(), n);
    if (spec_.layout == Layout::records || spec_.layout == Layout::one_records) {
      records_a_.copy(batch_.a, 0, rows());
      records_b_.copy(batch_.b, 0, n);
    }
  }

  std::int64_t library() {
    const KernelTable& kernels = *spec_.isa->kernels;
    switch (spec_.layout) {
      case Layout::matrix:
        return batch::matrix<T>(kernels, batch_.a.shapes(rows()), batch_.b.shapes(n), out_.get(), n).overlaps;
      case Layout::records:
      case Layout::one_records:
        return batch::many<T>(kernels, records_a_.shapes(rows()), records_b_.shapes(n), n, out_.get()).overlaps;
      default:
        return batch::many<T>(kernels, batch_.a.shapes(rows()), batch_.b.shapes(n), n, out_.get()).overlaps;
    }
  }

  std::int64_t yardstick() {
    if (spec_.layout == Layout::matrix) {
      return unfiltered_matrix(yardstick_.one_against_many, batch_.a, matrix_rows, batch_.b, n, out_.get());
    }
    const auto kernel = rows() == 1 ? yardstick_.one_against_many : yardstick_.in_step;
    return kernel(batch_.a.columns(), batch_.b.columns(), n, out_.get());
  }

 private:
  static constexpr std::int64_t n = batch_length<T>;

  const Spec& spec_;
  const unfiltered::PairKernels<T> yardstick_;
  const PoolColumns<T> pool_;
  Batch<T> batch_;
  Records<T> records_a_, records_b_;
  Memory<std::uint8_t> out_;
};

/// On how many of some batches the yardstick and the library differ.
template <class T>
std::int64_t count_unlike(InCache<T>& passes, int batches) {
  std::int64_t unlike = 0;
  std::vector<std::uint8_t> answers;
  for (int round = 0; round < batches; ++round) {
    passes.draw(static_cast<std::uint64_t>(round));
    passes.library();
    answers.assign(passes.out(), passes.out() + passes.tests());
    passes.yardstick();
    for (std::size_t i = 0; i < answers.size(); ++i) unlike += answers[i] != passes.out()[i];
  }
  return unlike;
}

}  // namespace

template <class T>
Result run_in_cache(const Spec& spec) {
  constexpr int checked_batches = 16;
  InCache<T> passes(spec);
  const auto tests = static_cast<double>(passes.tests());
  std::int64_t hits = 0, rounds = 0;
  std::vector<Pass> entrants{[&] {
    ++rounds;
    const std::int64_t found = passes.library();
    hits += found;
    return found;
  }};
  if (passes.has_yardstick()) entrants.push_back([&] { return passes.yardstick(); });
  const Budget budget{.seconds = passes.has_yardstick() ? 0.2 : 0.08, .rounds = 31};
  const auto times = contest([&](std::uint64_t round) { passes.draw(round); }, entrants, budget);
  Result result = summary(times[0], tests);
  result.hits = static_cast<double>(hits) / (static_cast<double>(rounds) * tests);
  if (!passes.has_yardstick()) return result;
  result.reference = compare(times[0], times[1], tests, tests);
  result.reference->unlike = count_unlike(passes, checked_batches);
  result.reference->asked = checked_batches * static_cast<std::int64_t>(passes.tests());
  return result;
}

template Result run_in_cache<float>(const Spec&);
template Result run_in_cache<double>(const Spec&);

}  // namespace vesica::bench
