// SPDX-License-Identifier: Apache-2.0
#include "batch/scalar_calls.hpp"

#include <map>
#include <tuple>
#include <vesica/each_shape.hpp>

#include "batch/contest.hpp"
#include "batch/pools.hpp"
#include "pair.hpp"

namespace vesica::bench {
namespace {

struct ScalarCall {
  std::int32_t kind_a, kind_b;
  bool single;
  double (*time)(const Pool& pool);
};

/// The passes of the scalar benchmark, in this one's contest.
template <auto call>
double time_of_call(const Pool& pool) {
  TypedPasses<call, nullptr> passes;
  passes.load(pool);
  const auto prepare = [&](std::uint64_t round) {
    Random random(seed_of_run() + round);
    passes.draw(random, pairs_per_pass);
  };
  const auto times = contest(prepare, {[&] { return passes.library_hits(); }}, {.seconds = 0.03, .rounds = 101});
  return median(times[0]) / static_cast<double>(pairs_per_pass);
}

template <auto call>
ScalarCall scalar_call() {
  using Call = Arguments<decltype(call)>;
  return {kind_of<typename Call::A>, kind_of<typename Call::B>,
          std::is_same_v<typename Described<typename Call::A>::Scalar, float>, time_of_call<call>};
}

#define VESICA_CALLS(a, A, b, B) \
  scalar_call<vesica_overlap_##a##_##b##_f64>(), scalar_call<vesica_overlap_##a##_##b##_f32>(),
#define VESICA_CALLS_BY_KIND(a, A, b, B)                              \
  scalar_call<overlap_by_kind<vesica_##a##_f64, vesica_##b##_f64>>(), \
      scalar_call<overlap_by_kind<vesica_##a##_f32, vesica_##b##_f32>>(),
const ScalarCall calls[] = {VESICA_EACH_PAIR_OF_FORMS(VESICA_CALLS) VESICA_EACH_PAIR_INFLATED(VESICA_CALLS_BY_KIND)};
#undef VESICA_CALLS
#undef VESICA_CALLS_BY_KIND

double measured(const Spec& spec) {
  for (const ScalarCall& call : calls) {
    if (call.single == spec.single && call.kind_a == spec.kind_a && call.kind_b == spec.kind_b) {
      return call.time(pool_of(spec.kind_a, spec.kind_b, Workload::mixed));
    }
  }
  return 0;
}

}  // namespace

double scalar_time(const Spec& spec) {
  static std::map<std::tuple<std::int32_t, std::int32_t, bool>, double> known;
  double& time = known[{spec.kind_a, spec.kind_b, spec.single}];
  if (time == 0) time = measured(spec);
  return time;
}

}  // namespace vesica::bench
