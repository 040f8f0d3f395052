// SPDX-License-Identifier: Apache-2.0
// clang-format off
#include "kernels/flatten.hpp"
#include "lanes/avx2.hpp"
// clang-format on
#include "index/tables.hpp"
#include "kernels/block.hpp"
#include "kernels/query_table.hpp"

namespace vesica {

constinit const KernelTable kernels_avx2 = make_table("avx2", kernels_avx2_queries, index::kernels_avx2);

}  // namespace vesica
