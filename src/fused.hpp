// SPDX-License-Identifier: Apache-2.0
// Functions that are compiled twice, for processors that fuse products with sums and for any; they give the same bits.
// Not for Windows, whose stack g++ takes to be aligned for wide vectors (src/CMakeLists.txt).
#pragma once

#include <vesica/scalar.hpp>

#include "kernels/table.hpp"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(_WIN32) && !defined(VESICA_HAS_FUSED)
#define VESICA_CHOOSES_FUSED 1

namespace vesica {

/// Kernels of four lanes and more are for processors that fuse.
inline bool has_fused() noexcept { return kernels().width_f64 >= 4; }

}  // namespace vesica
#else
#define VESICA_CHOOSES_FUSED 0
#endif
