// SPDX-License-Identifier: Apache-2.0
#include "index/lanes/portable.hpp"

#include "index/kernel.hpp"

namespace vesica::index {

constinit const Kernels kernels_portable = make_kernels();

}  // namespace vesica::index
