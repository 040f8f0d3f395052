// SPDX-License-Identifier: Apache-2.0
// clang-format off
#include "kernels/flatten.hpp"
#include "lanes/portable.hpp"
// clang-format on
#include "index/tables.hpp"
#include "kernels/block.hpp"
#include "kernels/query_table.hpp"

namespace vesica {

constinit const KernelTable kernels_portable =
    make_table("portable", kernels_portable_queries, index::kernels_portable);

}  // namespace vesica
