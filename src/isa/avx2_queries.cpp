// SPDX-License-Identifier: Apache-2.0
// clang-format off
#include "kernels/flatten.hpp"
#include "lanes/avx2.hpp"
// clang-format on
#include "kernels/query_loop.hpp"

namespace vesica {

constinit const QueryTable kernels_avx2_queries = make_query_table();

}  // namespace vesica
