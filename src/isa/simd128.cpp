// SPDX-License-Identifier: Apache-2.0
// clang-format off
#include "kernels/flatten.hpp"
#include "lanes/simd128.hpp"
// clang-format on
#include "index/tables.hpp"
#include "kernels/block.hpp"
#include "kernels/query_table.hpp"

namespace vesica {

constinit const KernelTable kernels_simd128 = make_table("simd128", kernels_simd128_queries, index::kernels_simd128);

}  // namespace vesica
