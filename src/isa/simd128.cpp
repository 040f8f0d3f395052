// SPDX-License-Identifier: Apache-2.0
#include "lanes/simd128.hpp"

#include "kernels/block.hpp"
#include "kernels/flatten.hpp"
#include "kernels/query_table.hpp"

namespace vesica {

constinit const KernelTable kernels_simd128 = make_table("simd128", kernels_simd128_queries, kernels_simd128_ties);

}  // namespace vesica
