// SPDX-License-Identifier: Apache-2.0
#include "batch/pools.hpp"
#include "batch/run.hpp"

namespace vesica::bench {

/// Pairs bisected to contact in double and rounded to T, beside mixed pairs through the same call.
template <class T>
Result run_near(const Spec& spec) {
  constexpr std::size_t n = batch_length<T>;
  const PoolColumns<T> near_pool(spec.kind_a, spec.kind_b, spec.workload);
  const PoolColumns<T> mixed_pool(spec.kind_a, spec.kind_b, Workload::mixed);
  Batch<T> near(spec.kind_a, spec.kind_b, n), mixed(spec.kind_a, spec.kind_b, n);
  const Memory<std::uint8_t> out = allocate<std::uint8_t>(n);
  std::int64_t hits = 0, rounds = 0;
  const auto answer = [&](const Batch<T>& batch) {
    return batch::many<T>(*spec.isa->kernels, batch.a.shapes(n), batch.b.shapes(n), n, out.get()).overlaps;
  };
  const Pass near_pass = [&] {
    const std::int64_t found = answer(near);
    hits += found;
    ++rounds;
    return found;
  };
  const auto draw = [&](std::uint64_t round) {
    near.draw(near_pool, round, n, n);
    mixed.draw(mixed_pool, round, n, n);
  };
  const auto times = contest(draw, {near_pass, [&] { return answer(mixed); }}, {.seconds = 0.2, .rounds = 31});
  Result result = summary(times[0], n);
  result.hits = static_cast<double>(hits) / static_cast<double>(rounds * static_cast<std::int64_t>(n));
  result.reference = compare(times[0], times[1], n, n);
  return result;
}

template Result run_near<float>(const Spec&);
template Result run_near<double>(const Spec&);

}  // namespace vesica::bench
