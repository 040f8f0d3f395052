// SPDX-License-Identifier: Apache-2.0
// clang-format off
#include "kernels/flatten.hpp"
#include "lanes/sse2.hpp"
// clang-format on
#include "index/tables.hpp"
#include "kernels/block.hpp"
#include "kernels/query_table.hpp"

namespace vesica {

constinit const KernelTable kernels_sse2 = make_table("sse2", kernels_sse2_queries, index::kernels_sse2);

}  // namespace vesica
