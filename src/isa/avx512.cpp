// SPDX-License-Identifier: Apache-2.0
// clang-format off
#include "kernels/flatten.hpp"
#include "lanes/avx512.hpp"
// clang-format on
#include "index/tables.hpp"
#include "kernels/block.hpp"
#include "kernels/query_table.hpp"

namespace vesica {

constinit const KernelTable kernels_avx512 = make_table("avx512", kernels_avx512_queries, index::kernels_avx512);

}  // namespace vesica
