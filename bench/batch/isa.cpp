// SPDX-License-Identifier: Apache-2.0
#include "batch/isa.hpp"

namespace vesica::bench {
namespace {

std::vector<Isa> usable_sets() {
  std::vector<Isa> sets;
#if defined(__x86_64__)
  __builtin_cpu_init();
  sets.push_back({"sse2", &kernels_sse2, &unfiltered::sse2});
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  if (avx2) sets.push_back({"avx2", &kernels_avx2, &unfiltered::avx2});
  if (avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq")) {
    sets.push_back({"avx512", &kernels_avx512, &unfiltered::avx512});
  }
#elif defined(__aarch64__)
  sets.push_back({"neon", &kernels_neon, &unfiltered::neon});
#endif
  return sets;
}

}  // namespace

const std::vector<Isa>& instruction_sets() {
  static const std::vector<Isa> sets = usable_sets();
  return sets;
}

}  // namespace vesica::bench
