// SPDX-License-Identifier: Apache-2.0
// The tables of index kernels, one for each instruction set.
#pragma once

namespace vesica::index {

struct Kernels;

extern const Kernels kernels_portable;
#if defined(__x86_64__)
extern const Kernels kernels_sse2, kernels_avx2, kernels_avx512;
#elif defined(__aarch64__)
extern const Kernels kernels_neon;
#elif defined(__wasm_simd128__)
extern const Kernels kernels_simd128;
#endif

}  // namespace vesica::index
