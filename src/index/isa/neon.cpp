// SPDX-License-Identifier: Apache-2.0
#include "index/lanes/neon.hpp"

#include "index/kernel.hpp"

namespace vesica::index {

constinit const Kernels kernels_neon = make_kernels();

}  // namespace vesica::index
