// SPDX-License-Identifier: Apache-2.0
#include "lanes/portable.hpp"

#include "kernels/block.hpp"

namespace vesica {

constinit const KernelTable kernels_portable = make_table("portable");

}  // namespace vesica
