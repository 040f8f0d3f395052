// SPDX-License-Identifier: Apache-2.0
// Tests define VESICA_PORTABLE_ONLY, to run on x86-64 what other processors run.
#include <cstring>

#include "index/kernels.hpp"

namespace vesica::index {

const Kernels& kernels_named(const char* isa) noexcept {
#if defined(__wasm_simd128__)
  static_cast<void>(isa);
  return kernels_simd128;
#elif defined(__x86_64__) && !defined(VESICA_PORTABLE_ONLY)
  if (std::strcmp(isa, kernels_avx512.name) == 0) return kernels_avx512;
  if (std::strcmp(isa, kernels_avx2.name) == 0) return kernels_avx2;
  return kernels_sse2;
#else
#if defined(__aarch64__)
  if (std::strcmp(isa, kernels_neon.name) == 0) return kernels_neon;
#endif
  static_cast<void>(isa);
  return kernels_portable;
#endif
}

}  // namespace vesica::index
