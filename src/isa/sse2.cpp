// SPDX-License-Identifier: Apache-2.0
#include "lanes/sse2.hpp"

#include "kernels/block.hpp"

namespace vesica {

constinit const KernelTable kernels_sse2 = make_table("sse2");

}  // namespace vesica
