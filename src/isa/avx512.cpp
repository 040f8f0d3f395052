// SPDX-License-Identifier: Apache-2.0
#include "lanes/avx512.hpp"

#include "kernels/block.hpp"
#include "kernels/flatten.hpp"
#include "kernels/query_table.hpp"

namespace vesica {

constinit const KernelTable kernels_avx512 = make_table("avx512", kernels_avx512_queries, kernels_avx512_ties);

}  // namespace vesica
