// SPDX-License-Identifier: Apache-2.0
// clang-format off
#include "kernels/flatten.hpp"
#include "lanes/avx512.hpp"
// clang-format on
#include "kernels/query_loop.hpp"

namespace vesica {

constinit const QueryTable kernels_avx512_queries = make_query_table();

}  // namespace vesica
