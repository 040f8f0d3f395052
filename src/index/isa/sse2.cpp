// SPDX-License-Identifier: Apache-2.0
#include "index/lanes/sse2.hpp"

#include "index/kernel.hpp"

namespace vesica::index {

constinit const Kernels kernels_sse2 = make_kernels();

}  // namespace vesica::index
