// SPDX-License-Identifier: Apache-2.0
#include "kernels/table.hpp"

namespace vesica {

// The scalar functions decide exact contacts as one lane would.
constinit const TieKernels kernels_portable_ties{};

}  // namespace vesica
