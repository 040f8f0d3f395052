// SPDX-License-Identifier: Apache-2.0
// clang-format off
#include "kernels/flatten.hpp"
#include "lanes/avx2.hpp"
// clang-format on
#include "kernels/ties.hpp"

namespace vesica {

constinit const TieKernels kernels_avx2_ties = make_tie_kernels();

}  // namespace vesica
