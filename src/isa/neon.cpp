// SPDX-License-Identifier: Apache-2.0
#include "lanes/neon.hpp"

#include "kernels/block.hpp"

namespace vesica {

constinit const KernelTable kernels_neon = make_table("neon");

}  // namespace vesica
