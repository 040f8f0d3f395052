// SPDX-License-Identifier: Apache-2.0
#include "batch/instruction_sets.hpp"

#include <array>

namespace batch_tests {

std::span<const InstructionSet> instruction_sets() {
#if defined(__x86_64__)
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2") &&
                    __builtin_cpu_supports("popcnt");
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq");
  static const std::array sets{InstructionSet{"sse2", &vesica::kernels_sse2, true, 4, 2},
                               InstructionSet{"avx2", &vesica::kernels_avx2, avx2, 8, 4},
                               InstructionSet{"avx512", &vesica::kernels_avx512, avx512, 16, 8}};
#elif defined(__aarch64__)
  static const std::array sets{InstructionSet{"portable", &vesica::kernels_portable, true, 1, 1},
                               InstructionSet{"neon", &vesica::kernels_neon, true, 4, 2}};
#else
  static const std::array sets{InstructionSet{"portable", &vesica::kernels_portable, true, 1, 1}};
#endif
  return sets;
}

namespace {

/// The library's sets, and the portable set in programs that link it.
std::vector<const InstructionSet*> tested_sets() {
  std::vector<const InstructionSet*> sets;
#ifdef VESICA_TEST_PORTABLE
  static const InstructionSet portable{"portable", &vesica::kernels_portable, true, 1, 1};
  sets.push_back(&portable);
#endif
  for (const InstructionSet& set : instruction_sets()) sets.push_back(&set);
  return sets;
}

}  // namespace

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const InstructionSet* set : tested_sets()) {
    for (const properties::Scalar scalar : {properties::Scalar::f32, properties::Scalar::f64}) {
      for (int a = 0; a < properties::kinds; ++a) {
        for (int b = 0; b < properties::kinds; ++b) cases.push_back({set, scalar, a, b});
      }
    }
  }
  return cases;
}

std::string to_string(const Case& c) {
  return std::string(c.set->name) + '_' + name(c.scalar) + '_' + properties::kind_name(c.kind_a) + '_' +
         properties::kind_name(c.kind_b);
}

}  // namespace batch_tests
