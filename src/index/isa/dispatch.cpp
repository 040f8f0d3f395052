// SPDX-License-Identifier: Apache-2.0
#include <cstring>

#include "index/kernels.hpp"

namespace vesica::index {

const Kernels& kernels_named(const char* isa) noexcept {
#if defined(__x86_64__)
  if (std::strcmp(isa, kernels_avx512.name) == 0) return kernels_avx512;
  if (std::strcmp(isa, kernels_avx2.name) == 0) return kernels_avx2;
  if (std::strcmp(isa, kernels_sse2.name) == 0) return kernels_sse2;
#elif defined(__aarch64__)
  if (std::strcmp(isa, kernels_neon.name) == 0) return kernels_neon;
#endif
  static_cast<void>(isa);
  return kernels_portable;
}

}  // namespace vesica::index
