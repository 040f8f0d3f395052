// SPDX-License-Identifier: Apache-2.0
#include "index/lanes/simd128.hpp"

#include "index/kernel.hpp"

namespace vesica::index {

constinit const Kernels kernels_simd128 = make_kernels();

}  // namespace vesica::index
