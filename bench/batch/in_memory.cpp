// SPDX-License-Identifier: Apache-2.0
#include "batch/pools.hpp"
#include "batch/run.hpp"

namespace vesica::bench {
namespace {

/// Bytes of input a pass reads: several times the last-level cache of one socket's share.
constexpr std::size_t bytes_a_pass = std::size_t{192} << 20;

template <class T>
class InMemory {
 public:
  explicit InMemory(const Spec& spec)
      : spec_(spec),
        yardstick_(spec.isa->unfiltered->of(T{})[spec.kind_a][spec.kind_b]),
        pool_(spec.kind_a, spec.kind_b, spec.workload),
        one_(spec.kind_a, 1),
        a_(spec.kind_a, in_step() ? tests() : 1),
        b_(spec.kind_b, tests()),
        out_(allocate<std::uint8_t>(tests())) {
    if (in_step()) fill(a_, pool_.a);
    fill(b_, pool_.b);
    std::fill_n(out_.get(), tests(), std::uint8_t{0});
  }

  bool in_step() const { return spec_.layout == Layout::memory_in_step; }
  /// Bytes of input a test reads.
  std::size_t bytes() const {
    const int fields = field_count(spec_.kind_b) + (in_step() ? field_count(spec_.kind_a) : 0);
    return static_cast<std::size_t>(fields) * sizeof(T);
  }
  std::size_t tests() const { return bytes_a_pass / bytes() / 4096 * 4096; }

  void draw(std::uint64_t round) { one_.copy(pool_.a, stretch_of_round(round, pool_.a.capacity(), 1).a, 1); }
  std::int64_t library() {
    const batch::Shapes<T> first = in_step() ? a_.shapes(tests()) : one_.shapes(1);
    return batch::many<T>(*spec_.isa->kernels, first, b_.shapes(tests()), count(), out_.get()).overlaps;
  }
  std::int64_t yardstick() {
    if (in_step()) return yardstick_.in_step(a_.columns(), b_.columns(), count(), out_.get());
    return yardstick_.one_against_many(one_.columns(), b_.columns(), count(), out_.get());
  }
  /// Reads the same memory, and only that.
  std::int64_t read() const {
    T sum = sum_of(b_);
    if (in_step()) sum += sum_of(a_);
    return static_cast<std::int64_t>(sum);
  }

 private:
  std::int64_t count() const { return static_cast<std::int64_t>(tests()); }

  T sum_of(const Columns<T>& columns) const {
    T sum = 0;
    for (int k = 0; k < columns.fields(); ++k) sum += spec_.isa->unfiltered->sum(columns.columns()[k], tests());
    return sum;
  }

  static void fill(Columns<T>& to, const Columns<T>& pool) {
    for (std::size_t i = 0; i < to.capacity(); i += pool.capacity()) {
      to.copy(pool, 0, std::min(pool.capacity(), to.capacity() - i), i);
    }
  }

  const Spec& spec_;
  const unfiltered::PairKernels<T> yardstick_;
  const PoolColumns<T> pool_;
  Columns<T> one_, a_, b_;
  Memory<std::uint8_t> out_;
};

}  // namespace

template <class T>
Result run_in_memory(const Spec& spec) {
  InMemory<T> passes(spec);
  const auto tests = static_cast<double>(passes.tests());
  std::int64_t hits = 0, rounds = 0;
  const Pass library = [&] {
    ++rounds;
    const std::int64_t found = passes.library();
    hits += found;
    return found;
  };
  const auto times = contest([&](std::uint64_t round) { passes.draw(round); },
                             {library, [&] { return passes.yardstick(); }, [&] { return passes.read(); }},
                             {.seconds = 0.4, .rounds = 9, .long_passes = true});
  Result result = summary(times[0], tests);
  result.hits = static_cast<double>(hits) / (static_cast<double>(rounds) * tests);
  result.reference = compare(times[0], times[1], tests, tests);
  result.bandwidth = tests * static_cast<double>(passes.bytes()) / median(times[2]) * 1e9;
  result.bandwidth_share = median(ratios(times[2], times[0]));
  return result;
}

template Result run_in_memory<float>(const Spec&);
template Result run_in_memory<double>(const Spec&);

}  // namespace vesica::bench
