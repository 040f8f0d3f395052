// SPDX-License-Identifier: Apache-2.0
// Chooses the instruction set, once, when the library is loaded. Tests define VESICA_PORTABLE_ONLY, to run on x86-64
// what other processors run.
#include <cstdlib>
#include <cstring>

#include "kernels/table.hpp"

namespace vesica {

#if defined(__wasm__)

// WebAssembly: a module is built with or without vectors, and whoever loads it chooses, because engines without vectors
// refuse a module that has them. It has no environment to read, and nothing would call constructors.
#if defined(__wasm_simd128__)
const KernelTable& kernels() noexcept { return kernels_simd128; }
#else
const KernelTable& kernels() noexcept { return kernels_portable; }
#endif

#else

constinit const KernelTable* chosen_kernels = nullptr;

namespace {

struct Candidate {
  const KernelTable* table;
  bool usable;
};

/// VESICA_ISA in the environment selects a set by name; an unknown name is ignored, and so is a set that this processor
/// does not have. Otherwise the last usable one is the best.
template <std::size_t N>
const KernelTable* choose(const Candidate (&candidates)[N]) noexcept {
  const char* forced = std::getenv("VESICA_ISA");
  const KernelTable* best = candidates[0].table;
  for (const Candidate& candidate : candidates) {
    if (!candidate.usable) continue;
    best = candidate.table;
    if (forced != nullptr && std::strcmp(forced, best->name) == 0) return best;
  }
  return best;
}

const KernelTable* choose() noexcept {
#if defined(__x86_64__) && !defined(VESICA_PORTABLE_ONLY)
  __builtin_cpu_init();
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2") &&
                    __builtin_cpu_supports("popcnt");
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq");
  return choose({{&kernels_sse2, true}, {&kernels_avx2, avx2}, {&kernels_avx512, avx512}});
#elif defined(__aarch64__)
  return choose({{&kernels_portable, true}, {&kernels_neon, true}});
#else
  return choose({{&kernels_portable, true}});
#endif
}

// Every thread that finds the variable empty makes the same choice, so the order does not matter. Atomic by the
// compiler's own functions: <atomic> brings half of libstdc++ with it, which musl does not have.
const KernelTable& choose_once() noexcept {
  const KernelTable* const table = choose();
  __atomic_store_n(&chosen_kernels, table, __ATOMIC_RELAXED);
  return *table;
}

[[gnu::constructor]] void choose_at_load() noexcept { choose_once(); }

}  // namespace

const KernelTable& kernels() noexcept {
  const KernelTable* const table = __atomic_load_n(&chosen_kernels, __ATOMIC_RELAXED);
  return table != nullptr ? *table : choose_once();  // empty where another library's constructor calls, before ours
}

#endif

}  // namespace vesica
