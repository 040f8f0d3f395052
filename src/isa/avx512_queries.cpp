// SPDX-License-Identifier: Apache-2.0
#include "kernels/query_loop.hpp"
#include "lanes/avx512.hpp"

namespace vesica {

constinit const QueryTable kernels_avx512_queries = make_query_table();

}  // namespace vesica
