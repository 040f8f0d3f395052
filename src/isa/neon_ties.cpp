// SPDX-License-Identifier: Apache-2.0
// clang-format off
#include "kernels/flatten.hpp"
#include "lanes/neon.hpp"
// clang-format on
#include "kernels/ties.hpp"

namespace vesica {

constinit const TieKernels kernels_neon_ties = make_tie_kernels();

}  // namespace vesica
